// Files of players, read back by a reader of the tests' own.
#include <doctest.h>
#include <rapidcheck.h>

#include "base/maths.h"
#include "base/text_file.h"
#include "files/export/formats.h"
#include "files/export/player/player_format.h"
#include "files/export/player/range_encoder.h"
#include "files/export/player_reader.h"
#include "files/export/pretend_take.h"
#include "json/json.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Records which clips are played, too.
class ClipRecorder : public Recorder {
public:
    bool wantsClips() const override { return true; }
};

std::string exported(const Take& take, const ExportDef& def, const char* name) {
    const std::string path = (exportFolder() / name).string();
    REQUIRE(exportTake(take, ownClips(), "player", path, def).ok());
    return *readTextFile(path);
}

/// Durations of the clips in a file, from the part that holds their poses, of which the numbers are skipped.
std::vector<PlayedDuration> durationsOf(const std::string& part, std::size_t clips) {
    PlayerNumbers numbers(part);
    PlayerNumbers::Number head, hips;
    std::array<PlayerNumbers::Number, 63> parts;
    PlayerNumbers::Bit other;
    std::vector<PlayedDuration> durations;
    for (std::size_t c = 0; c < clips; ++c) {
        PlayedDuration one{.duration = numbers.natural(head), .cyclic = numbers.natural(head) == 1};
        const std::uint32_t poses = numbers.natural(head);
        for (std::uint32_t k = 0; k < poses; ++k) {
            for (int axis = 0; axis < 3; ++axis) numbers.whole(hips);
            for (std::size_t j = 0; j < 21; ++j) {
                if (numbers.bit(other)) numbers.plain(2);
                for (std::size_t axis = 0; axis < 3; ++axis) numbers.whole(parts[3 * j + axis]);
            }
        }
        durations.push_back(one);
    }
    return durations;
}

double turnsApart(double a, double b) {
    const double by = a - b;
    return std::abs(by - std::round(by));
}

}  // namespace

TEST_CASE("a range coder gives back what went in") {
    rc::check([](const std::vector<std::int32_t>& values) {
        RangeEncoder coder;
        NumberModel model;
        BitModel bit;
        for (const std::int32_t value : values) {
            const std::int32_t small = value == INT32_MIN ? 0 : value;
            coder.whole(model, small);
            coder.bit(bit, small % 3 == 0);
            coder.plain(static_cast<std::uint32_t>(small) & 0x7FFu, 11);
            coder.natural(model, static_cast<std::uint32_t>(small < 0 ? -small : small) * 2u);
        }
        const std::string bytes = coder.finish();
        PlayerNumbers reader(bytes);
        PlayerNumbers::Number readModel;
        PlayerNumbers::Bit readBit;
        for (const std::int32_t value : values) {
            const std::int32_t small = value == INT32_MIN ? 0 : value;
            RC_ASSERT(reader.whole(readModel) == small);
            RC_ASSERT(reader.bit(readBit) == (small % 3 == 0));
            RC_ASSERT(reader.plain(11) == (static_cast<std::uint32_t>(small) & 0x7FFu));
            RC_ASSERT(reader.natural(readModel) ==
                      static_cast<std::uint32_t>(small < 0 ? -small : small) * 2u);
        }
    });
}

TEST_CASE("a range coder carries over bytes of ones, and learns") {
    RangeEncoder coder;
    BitModel likely;
    // The least likely bits after many likely ones make long runs of 0xFF and carries.
    for (int k = 0; k < 20000; ++k) coder.bit(likely, k % 997 == 996);
    const std::string bytes = coder.finish();
    CHECK(bytes.size() < 200);
    PlayerNumbers reader(bytes);
    PlayerNumbers::Bit model;
    bool same = true;
    for (int k = 0; k < 20000; ++k) same = same && reader.bit(model) == (k % 997 == 996);
    CHECK(same);
}

TEST_CASE("a player's file has every character in every frame, to half a unit, and the clip it plays") {
    const Take take = shortTake();
    const ExportDef def{0.25, 1.9, 15.0, 1, {}};
    ClipRecorder recorder;
    REQUIRE(exportTake(take, ownClips(), def, recorder).ok());
    const auto parts = playerParts(exported(take, def, "whole.muster-player"));
    const auto head = parseJson(parts.at("head"), "head");
    REQUIRE(head.ok());
    CHECK(head->find("title")->text() == "Short");
    CHECK(head->find("fps")->number() == 15.0);
    REQUIRE(head->find("frames")->whole<std::size_t>() == recorder.frames.size());
    const auto clips = head->find("clips")->whole<std::size_t>();
    PlayerFrames frames(parts.at("crwd"), durationsOf(parts.at("clip"), clips), 0);
    std::map<std::uint32_t, std::uint16_t> library;  // Of the file's clips.
    double worst = 0.0, worstTurn = 0.0, worstTime = 0.0;
    std::size_t samples = 0;
    for (const auto& seen : recorder.frames) {
        const auto& characters = frames.next();
        REQUIRE(characters.size() == seen.characters.size());
        samples += characters.size();
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const PlayedCharacter& read = characters[i];
            const ExportCharacter& real = seen.characters[i];
            CHECK(read.id == real.id);
            worst = std::max({worst, std::abs(0.005 * static_cast<double>(read.x) - real.position.x),
                              std::abs(0.005 * static_cast<double>(read.y) - real.position.y)});
            worstTurn = std::max(worstTurn, turnsApart(static_cast<double>(read.yaw) / 512.0,
                                                       static_cast<double>(real.yaw) / (2.0 * kPi)));
            const auto known = library.try_emplace(read.clip, real.clip).first;
            CHECK(known->second == real.clip);
            const double seconds = ownClips().clips[real.clip].duration();
            worstTime = std::max(worstTime,
                                 seconds * turnsApart(static_cast<double>(read.time) / 256.0 / seconds,
                                                      static_cast<double>(real.clipTime) / seconds));
        }
    }
    CHECK(frames.exhausted());
    CHECK(worst <= 0.0025 + 1e-9);
    CHECK(worstTurn <= 0.5 / 512.0 + 1e-6);
    // Durations are rounded to 1/256 s, too.
    CHECK(worstTime <= 1.0 / 256.0);
    CHECK(library.size() == clips);
    CHECK(head->find("samples")->whole<std::size_t>() == samples);
}

TEST_CASE("a player's file tells who comes and goes, and where moving things are") {
    const std::string path = (exportFolder() / "coming.muster-player").string();
    {
        const auto exporter = makeExporter("player", path);
        REQUIRE(exporter.ok());
        const auto world = World::create(furnishedWorld());
        const ClipLibrary clips = ownClips();
        REQUIRE((*exporter)->begin({"Pretended", 30.0, 1.0, 80, &*world, &clips}).ok());
        for (std::size_t k = 0; k < 80; ++k) {
            const double time = 1.0 + static_cast<double>(k) / 30.0;
            const PretendFrame frame = pretendPeople(1, peopleIn(k), time);
            REQUIRE((*exporter)->frame({k, time, frame.characters, &*world}).ok());
        }
        REQUIRE((*exporter)->finish().ok());
    }
    const auto parts = playerParts(*readTextFile(path));
    const auto head = parseJson(parts.at("head"), "head");
    REQUIRE(head->find("things")->whole<int>() == 1);
    CHECK(head->find("most")->whole<int>() == 4);
    PlayerFrames frames(parts.at("crwd"), durationsOf(parts.at("clip"), 1), 1);
    const auto world = World::create(furnishedWorld());
    const TimedPath path2 = furnishedWorld().obstacles[2].path;
    for (std::size_t k = 0; k < 80; ++k) {
        const double time = 1.0 + static_cast<double>(k) / 30.0;
        const auto& characters = frames.next();
        const PretendFrame real = pretendPeople(1, peopleIn(k), time);
        REQUIRE(characters.size() == real.characters.size());
        for (std::size_t i = 0; i < characters.size(); ++i) {
            CHECK(characters[i].id == real.characters[i].id);
            CHECK(std::abs(0.005 * static_cast<double>(characters[i].x) - real.characters[i].position.x) <=
                  0.0026);
        }
        const Waypoint at = path2.at(time);
        // The car's middle is its pivot.
        CHECK(std::abs(0.005 * static_cast<double>(frames.thing(0)[0]) - (-14.0 + at.position.x)) <= 0.0026);
        CHECK(std::abs(0.005 * static_cast<double>(frames.thing(0)[1]) - (-7.1 + at.position.y)) <= 0.0026);
        CHECK(turnsApart(static_cast<double>(frames.thing(0)[2]) / 4096.0, at.angle / (2.0 * kPi)) <=
              0.51 / 4096.0);
    }
    CHECK(frames.exhausted());
}

TEST_CASE("the same take gives the same file, by any number of threads") {
    const Take take = shortTake();
    const std::string once = exported(take, {0.0, -1.0, 15.0, 1, {}}, "once.muster-player");
    CHECK(once == exported(take, {0.0, -1.0, 15.0, 2, {}}, "twice.muster-player"));
    // The checksum is that of all after the first 20 bytes.
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t at = 20; at < once.size(); ++at) {
        crc ^= static_cast<unsigned char>(once[at]);
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
    }
    crc = ~crc;
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(static_cast<unsigned char>(once[16 + k]) == (crc >> (8 * k) & 255u));
}

TEST_CASE("a file that no page could hold is refused, and leaves nothing") {
    const std::string path = (exportFolder() / "huge.muster-player").string();
    const auto world = World::create(furnishedWorld());
    const ClipLibrary clips = ownClips();
    const std::size_t before = thingsInFolder();
    {
        const auto exporter = makeExporter("player", path);
        const Status status = (*exporter)->begin({"Huge", 30.0, 0.0, 4'000'000, &*world, &clips});
        CHECK(status.code() == StatusCode::LimitExceeded);
        CHECK(status.message().find("16000000") != std::string::npos);
        CHECK(status.message().find("take a shorter part") != std::string::npos);
    }
    {
        const auto exporter = makeExporter("player", path);
        REQUIRE((*exporter)->begin({"Left", 30.0, 0.0, 10, &*world, &clips}).ok());
    }
    CHECK(thingsInFolder() == before);
    const auto bad = makeExporter("player", "/nowhere/at/all.muster-player");
    CHECK((*bad)->begin({"Nowhere", 30.0, 0.0, 10, &*world, &clips}).code() == StatusCode::IoError);
}
