#include <doctest.h>

#include <bit>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base/hash.h"
#include "muster/take.h"

using namespace muster;

namespace {

/// Writes the layout of docs/take-format.md byte by byte, as version 1 had it.
class OldBytes {
public:
    OldBytes& byte(unsigned value) {
        bytes.push_back(static_cast<std::uint8_t>(value));
        return *this;
    }
    OldBytes& word(std::uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8) byte(value >> shift & 0xff);
        return *this;
    }
    OldBytes& real(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        return word(static_cast<std::uint32_t>(bits)).word(static_cast<std::uint32_t>(bits >> 32));
    }
    OldBytes& text(const std::string& value) {
        word(static_cast<std::uint32_t>(value.size()));
        bytes.insert(bytes.end(), value.begin(), value.end());
        return *this;
    }
    /// Step, client, sequence and kind of a command.
    OldBytes& head(std::uint32_t step, std::uint32_t sequence, unsigned kind) {
        return word(step).word(1).word(sequence).byte(kind);
    }
    /// Kind, spacing, opening, no outline, no holes and no points.
    OldBytes& formation(FormationKind kind, double spacing) {
        return byte(static_cast<unsigned>(kind)).real(spacing).real(1.2).word(0).word(0).word(0);
    }
    void record(unsigned kind, const std::vector<std::uint8_t>& payload) {
        const std::size_t start = bytes.size();
        word(static_cast<std::uint32_t>(payload.size())).byte(kind);
        word(crc32(std::span(bytes).subspan(start, 5)));
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        word(crc32(payload));
    }

    std::vector<std::uint8_t> bytes;
};

const std::string kScenario = R"({"format":"muster-scenario","version":1,"name":"Old",
    "box":[[-8,-8],[8,8]],"groups":[{"count":4,"formation":{"kind":"square","spacing":1.0}}]})";

/// A take of that version with a formation and a new group.
std::vector<std::uint8_t> takeOf(std::uint32_t version) {
    OldBytes file;
    for (const char c : std::string("MUSTAKE\n")) file.byte(static_cast<unsigned char>(c));
    file.word(version);
    file.record(1, {kScenario.begin(), kScenario.end()});
    const auto files = [&](OldBytes& bytes) {
        if (version >= 2) bytes.word(0);
    };
    OldBytes set;
    set.head(0, 0, 8).word(1).formation(FormationKind::Wedge, 1.5);
    files(set);
    OldBytes add;
    add.head(2, 1, 11).text("Later").word(3).formation(FormationKind::Line, 1.25);
    files(add);
    add.real(3.0).real(-2.0).real(0.5).word(0).real(0.25);
    // Bodies, roles, demands, conduct, orders and patrols.
    if (version >= 2) add.word(0).word(0).word(0).byte(0).real(0.0).real(1.0).byte(0).word(0).byte(0);
    if (version >= 5) add.byte(1).word(0x05536D);   // A colour.
    if (version >= 6) add.byte(0).byte(1).byte(1);  // No build, a motion set.
    if (version >= 7) add.word(0);                  // No sorts of persons.
    file.record(2, set.bytes);
    file.record(2, add.bytes);
    return file.bytes;
}

}  // namespace

TEST_CASE("takes of version 1 are read: what came later has its defaults") {
    const auto take = parseTake(takeOf(1), "T");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->def.name == "Old");
    REQUIRE(take->commands.size() == 2);
    const auto& change = std::get<ChangeGroup>(take->commands[0].body);
    CHECK(change.group == GroupId{1});
    REQUIRE(change.formation);
    CHECK(change.formation->kind == FormationKind::Wedge);
    CHECK(change.formation->spacing == 1.5);
    CHECK(change.formation->files == 0);
    CHECK_FALSE(change.count);
    const GroupDef& group = std::get<AddGroup>(take->commands[1].body).group;
    CHECK(group.name == "Later");
    CHECK(group.count == 3);
    CHECK(group.formation.spacing == 1.25);
    CHECK(group.position == Vec2{3, -2});
    CHECK(group.angle == 0.5);
    CHECK(group.jitter == 0.25);
    CHECK(group.bodies.empty());
    CHECK(group.orders.empty());
    CHECK(group.conduct == Conduct{});
    CHECK(!group.patrols);
}

TEST_CASE("a take of version 1 replays as the same take of version 2 does") {
    const auto old = parseTake(takeOf(1), "T");
    const auto now = parseTake(takeOf(2), "T");
    REQUIRE(old.ok());
    REQUIRE_MESSAGE(now.ok(), now.status().message());
    const auto first = replayTake(*old);
    const auto second = replayTake(*now);
    REQUIRE_MESSAGE(first.ok(), first.status().message());
    REQUIRE(second.ok());
    CHECK(first->steps == 3);
    CHECK(first->hash == second->hash);
}

TEST_CASE("groups of version 5 have a colour, those of version 4 none") {
    for (const std::uint32_t version : {4u, 5u}) {
        const auto take = parseTake(takeOf(version), "T");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        const auto& colour = std::get<AddGroup>(take->commands[1].body).group.colour;
        CHECK(colour == (version == 4 ? std::nullopt : std::optional<std::uint32_t>(0x05536D)));
    }
}

TEST_CASE("groups of version 6 have an appearance, those of version 5 none") {
    for (const std::uint32_t version : {5u, 6u}) {
        const auto take = parseTake(takeOf(version), "T");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        const GroupDef& group = std::get<AddGroup>(take->commands[1].body).group;
        CHECK_FALSE(group.build);
        CHECK(group.motions == (version == 5 ? std::nullopt : std::optional(MotionSet::Weary)));
    }
}

TEST_CASE("bodies, orders and patches of version 6 have nothing of what version 7 added") {
    for (const std::uint32_t version : {6u, 7u}) {
        CAPTURE(version);
        const bool now = version >= 7;
        OldBytes bodies;  // SetBodies of one character.
        bodies.head(0, 0, 28).word(1).word(3).word(1);
        bodies.real(0.3).real(1.1).real(0.0).real(1.0).real(1.0).byte(2);
        if (now) bodies.real(0.5).real(30.0).real(0.6).real(0.7);
        OldBytes patch;  // A square with a motion.
        patch.head(0, 1, 16).text("Stairs").word(3).real(0).real(0).real(1).real(0).real(1).real(1);
        patch.word(0).byte(0).word(1).real(0.5);
        if (now) patch.byte(1).real(1.5).real(0.25);
        OldBytes face;
        face.head(0, 2, 20).word(1).byte(0).word(0).byte(1).real(0).real(0).byte(1).real(0.75).real(0);
        face.word(0).byte(0).byte(0).byte(3).real(0).real(0.95).word(0).word(0).real(0).real(0).real(0).real(
            0);
        face.word(0).byte(0);
        if (now) face.word(2).word(4).word(5).byte(1).word(0).real(1).real(2).word(6).real(9);
        OldBytes file;
        for (const char c : std::string("MUSTAKE\n")) file.byte(static_cast<unsigned char>(c));
        file.word(version);
        file.record(1, {kScenario.begin(), kScenario.end()});
        for (const OldBytes* record : {&bodies, &patch, &face}) file.record(2, record->bytes);
        const auto take = parseTake(file.bytes, "T");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        const Body body = std::get<ChangeCharacters>(take->commands[0].body).bodies->front();
        CHECK(body.unitClass == 2);
        CHECK(body.headway == (now ? 0.5 : 0.0));
        CHECK(body.downstairs == (now ? 0.7 : 0.0));
        const PatchDef& stairs = *std::get<PutThing>(take->commands[1].body).patch;
        CHECK(stairs.speed == 0.5);
        CHECK(stairs.ascent == (now ? std::optional(1.5) : std::nullopt));
        CHECK(stairs.speedDown == (now ? 0.25 : -1.0));
        const Order& order = std::get<GiveOrder>(take->commands[2].body).order;
        CHECK(order.facing == 0.75);
        CHECK(order.exits.size() == (now ? 2 : 0));
        CHECK(order.seconds == (now ? 9.0 : 0.0));
    }
}

TEST_CASE("a pose of version 9 is that of the mesh alone") {
    for (const std::uint32_t version : {9u, 10u}) {
        OldBytes pose;
        pose.head(0, 0, 10).word(1).real(2.0).real(3.0).real(0.5);
        if (version >= 10) pose.byte(1);
        OldBytes placed;
        placed.head(0, 1, 39).word(1).real(2.0).real(3.0).real(0.5);
        OldBytes file;
        for (const char c : std::string("MUSTAKE\n")) file.byte(static_cast<unsigned char>(c));
        file.word(version);
        file.record(1, {kScenario.begin(), kScenario.end()});
        for (const OldBytes* record : {&pose, &placed}) file.record(2, record->bytes);
        const auto take = parseTake(file.bytes, "T");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        CHECK(std::get<SetPose>(take->commands[0].body).characters == (version >= 10));
        CHECK(std::get<SetPose>(take->commands[1].body).characters);
        CHECK(std::get<SetPose>(take->commands[1].body).angle == 0.5);
    }
}

TEST_CASE("versions are not mixed up") {
    // The bytes of one version under the number of the other.
    auto older = takeOf(2);
    older[8] = 1;
    CHECK(parseTake(older, "T").status().code() == StatusCode::Corrupt);
    auto newer = takeOf(1);
    newer[8] = 2;
    CHECK(parseTake(newer, "T").status().code() == StatusCode::Corrupt);
    for (const unsigned version : {0u, 11u}) {
        auto other = takeOf(1);
        other[8] = static_cast<std::uint8_t>(version);
        const auto take = parseTake(other, "T");
        CHECK(take.status().code() == StatusCode::Unsupported);
        CHECK(take.status().message().find("expected version 1 to 10") != std::string::npos);
    }
}

TEST_CASE("writers write version 10") {
    WorldDef def;
    def.groups.resize(1);
    const std::string path = (std::filesystem::temp_directory_path() / "muster_take_version_test.take")
                                 .string();
    REQUIRE(TakeWriter::create(path, def).ok());
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    REQUIRE(file != nullptr);
    std::uint8_t head[12] = {};
    CHECK(std::fread(head, 1, sizeof head, file) == sizeof head);
    std::fclose(file);
    std::filesystem::remove(path);
    CHECK(head[8] == 10);
}
