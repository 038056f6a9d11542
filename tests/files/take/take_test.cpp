#include "muster/take.h"

#include <doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/random.h"
#include "base/text_file.h"
#include "muster/scenario.h"

using namespace muster;

namespace {

/// Nine characters and a wall, small enough to simulate often.
WorldDef smallDef() {
    WorldDef def{.name = "Small", .box = {{-6, -5}, {6, 5}}, .cell = 0.5};
    def.obstacles = {{.polygon = {{0, -1}, {0.5, -1}, {0.5, 1}, {0, 1}}}};
    def.groups = {{.count = 9, .position = {-3.5, 0}}};
    return def;
}

std::vector<Command> drag() {
    std::vector<Command> commands;
    const auto add = [&](double time, CommandBody body) {
        const auto step = static_cast<std::uint32_t>(time * 60.0 + 1e-6);
        commands.push_back({step, 1, static_cast<std::uint32_t>(commands.size()), std::move(body)});
    };
    add(0.1, Touch{TouchPhase::Down, 1, {-3.5, 0}, 0.1, {}});
    for (int i = 1; i <= 20; ++i)
        add(0.1 + 0.1 * i, Touch{TouchPhase::Move, 1, {-3.5 + 0.3 * i, 0.05 * i}, 0.1 + 0.1 * i, {}});
    add(2.3, Touch{TouchPhase::Up, 1, {}, 2.3, {}});
    add(2.5,
        ChangeGroup{.group = GroupId{1}, .formation = FormationDef{FormationKind::Line, 1.0, 1.2, {}, {}}});
    return commands;
}

std::string temporary(const char* name) {
    return (std::filesystem::temp_directory_path() / name).string();
}

/// Records 200 steps of the drag; each command is recorded in the step before it applies, as in a live
/// session.
std::vector<std::uint8_t> recorded() {
    static const std::vector<std::uint8_t> bytes = [] {
        const std::string path = temporary("muster_take_test.take");
        const WorldDef def = smallDef();
        auto writer = TakeWriter::create(path, def);
        auto world = World::create(def);
        REQUIRE(writer.ok());
        REQUIRE(world.ok());
        const auto commands = drag();
        std::size_t next = 0;
        while (world->stepCount() < 200) {
            for (; next < commands.size() && commands[next].step == world->stepCount(); ++next) {
                REQUIRE(world->submit(commands[next]).ok());
                REQUIRE(writer->command(commands[next]).ok());
            }
            world->step();
            REQUIRE(writer->observe(*world).ok());
        }
        REQUIRE(writer->finish(*world).ok());
        const auto text = readTextFile(path);
        REQUIRE(text.ok());
        std::filesystem::remove(path);
        return std::vector<std::uint8_t>(text->begin(), text->end());
    }();
    return bytes;
}

/// Offsets of the records, then the size of the file.
std::vector<std::size_t> recordStarts(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::size_t> starts;
    std::size_t at = 12;
    while (at < bytes.size()) {
        starts.push_back(at);
        std::size_t length = 0;
        for (int k = 3; k >= 0; --k) length = length << 8 | bytes[at + static_cast<std::size_t>(k)];
        at += 9 + length + 4;
    }
    CHECK(at == bytes.size());
    starts.push_back(at);
    return starts;
}

}  // namespace

TEST_CASE("a take replays to the same hashes, on any number of threads") {
    const auto take = parseTake(recorded(), "T");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->finished);
    CHECK(take->tornBytes == 0);
    CHECK(take->def.name == "Small");
    CHECK(take->commands.size() == drag().size());
    REQUIRE(take->marks.size() == 4);
    CHECK(take->marks[2].step == 180);
    CHECK(take->marks[3].step == 200);
    CHECK(take->marks[0].hash != take->marks[1].hash);
    for (int threads : {1, 2, 4}) {
        const auto report = replayTake(*take, threads);
        REQUIRE_MESSAGE(report.ok(), report.status().message());
        CHECK(report->steps == 200);
        CHECK(report->compared == 4);
        CHECK(report->hash == take->marks[3].hash);
    }
}

TEST_CASE("a replay can be watched and stopped") {
    const auto take = parseTake(recorded(), "T");
    std::uint32_t seen = 0;
    const auto report = replayTake(*take, 1, [&](const World& world) {
        CHECK(world.stepCount() == ++seen);
        return seen < 70;
    });
    REQUIRE(report.ok());
    CHECK(report->steps == 70);
    CHECK(report->compared == 1);
}

TEST_CASE("commands after the last mark of an unfinished take are replayed but not compared") {
    const auto bytes = recorded();
    const auto starts = recordStarts(bytes);
    std::size_t cut = 0;  // After the last command, at step 150: the marks of 180 and 200 are lost.
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        if (bytes[starts[i] + 4] == 2) cut = starts[i + 1];
    }
    auto take = parseTake(std::span<const std::uint8_t>(bytes.data(), cut), "T");
    REQUIRE(take.ok());
    CHECK(!take->finished);
    CHECK(take->markedSteps() == 120);
    CHECK(take->steps() == 151);
    FormationKind last = FormationKind::Square;
    const auto report = replayTake(*take, 1, [&](const World& world) {
        last = world.group(0).formation;
        return true;
    });
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->steps == 151);
    CHECK(report->compared == 2);
    CHECK(report->unmarked == 31);
    CHECK(last == FormationKind::Line);

    // A process killed within the first second leaves no mark at all.
    take->marks.clear();
    CHECK(take->steps() == 151);
    const auto whole = replayTake(*take);
    REQUIRE(whole.ok());
    CHECK(whole->unmarked == 151);
    CHECK(whole->hash == report->hash);
    // A finished take ends at its last mark, even where commands wait.
    take->finished = true;
    CHECK(take->steps() == 0);
}

TEST_CASE("the last record cut at every byte: the rest is read and the loss is reported") {
    const auto bytes = recorded();
    const auto starts = recordStarts(bytes);
    const std::size_t last = starts[starts.size() - 2];
    for (std::size_t size = last; size < bytes.size(); ++size) {
        const auto take = parseTake(std::span<const std::uint8_t>(bytes.data(), size), "T");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        CHECK(take->tornBytes == size - last);
        CHECK(!take->finished);
        CHECK(take->steps() == 180);
        CHECK(take->commands.size() == drag().size());
    }
}

TEST_CASE("a take cut anywhere is read up to there, or is reported to have no scenario") {
    const auto bytes = recorded();
    const auto starts = recordStarts(bytes);
    Random random(2);
    for (int round = 0; round < 300; ++round) {
        const std::size_t size = random.below(static_cast<std::uint32_t>(bytes.size()));
        const auto take = parseTake(std::span<const std::uint8_t>(bytes.data(), size), "T");
        CHECK(take.ok() == (size >= starts[1]));
        if (!take.ok()) CHECK(take.status().code() == StatusCode::ParseError);
    }
}

TEST_CASE("a flipped byte anywhere is refused, and its record is named") {
    const auto bytes = recorded();
    const auto starts = recordStarts(bytes);
    Random random(9);
    for (std::size_t i = 0; i < bytes.size(); i += i < 200 || i > starts[1] ? 1 : 97) {
        auto bad = bytes;
        bad[i] ^= static_cast<std::uint8_t>(1 + random.below(255));
        const auto take = parseTake(bad, "T");
        REQUIRE(!take.ok());
        if (i < 12) continue;
        CHECK(take.status().code() == StatusCode::Corrupt);
        const auto record = *(std::upper_bound(starts.begin(), starts.end(), i) - 1);
        CHECK(take.status().message().find("offset " + std::to_string(record)) != std::string::npos);
    }
}

TEST_CASE("other files are refused") {
    CHECK(parseTake({}, "T").status().code() == StatusCode::ParseError);
    const std::vector<std::uint8_t> json{'{', '}', ' ', ' ', ' ', ' ', ' ', ' ', ' ', ' ', ' ', ' ', ' '};
    CHECK(parseTake(json, "T").status().code() == StatusCode::ParseError);
    auto bytes = recorded();
    bytes[8] = 11;
    CHECK(parseTake(bytes, "T").status().code() == StatusCode::Unsupported);
    auto longer = recorded();
    const auto starts = recordStarts(longer);
    longer.insert(longer.end(), bytes.begin() + static_cast<std::ptrdiff_t>(starts[1]),
                  bytes.begin() + static_cast<std::ptrdiff_t>(starts[2]));
    CHECK(parseTake(longer, "T").status().message().find("after the end") != std::string::npos);
    CHECK(readTake("/nowhere/x.take").status().code() == StatusCode::IoError);
}

TEST_CASE("files are not overwritten unless requested, and folders must exist") {
    const std::string path = temporary("muster_take_exists.take");
    std::filesystem::remove(path);
    CHECK(TakeWriter::create(path, smallDef(), false).ok());
    CHECK(TakeWriter::create(path, smallDef(), false).status().code() == StatusCode::IoError);
    CHECK(TakeWriter::create(path, smallDef(), true).ok());
    std::filesystem::remove(path);
    CHECK(TakeWriter::create("/nowhere/x.take", smallDef()).status().code() == StatusCode::IoError);
}

TEST_CASE("a killed process loses at most the record it was writing") {
    const std::string path = temporary("muster_take_killed.take");
    std::filesystem::remove(path);
    int pipes[2];
    REQUIRE(pipe(pipes) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        // Writes commands endlessly and prints after each how many are flushed.
        auto writer = TakeWriter::create(path, smallDef());
        for (std::uint32_t n = 0; writer.ok(); ++n) {
            if (!writer->command({n, 1, n, Touch{TouchPhase::Move, 1, {0.5, 0.25}, n / 60.0, {}}}).ok())
                break;
            const std::uint32_t safe = n + 1;
            if (write(pipes[1], &safe, sizeof(safe)) != sizeof(safe)) break;
        }
        _exit(0);
    }
    close(pipes[1]);
    std::uint32_t safe = 0;
    for (int i = 0; i < 5000; ++i) REQUIRE(read(pipes[0], &safe, sizeof(safe)) == sizeof(safe));
    REQUIRE(kill(child, SIGKILL) == 0);
    int state = 0;
    REQUIRE(waitpid(child, &state, 0) == child);
    CHECK(WIFSIGNALED(state));
    std::uint32_t more = 0;
    while (read(pipes[0], &more, sizeof(more)) == sizeof(more)) safe = more;
    close(pipes[0]);
    const auto take = readTake(path);
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->commands.size() >= safe);
    CHECK(take->commands.size() <= safe + 1);
    CHECK(!take->finished);
    std::filesystem::remove(path);
}
