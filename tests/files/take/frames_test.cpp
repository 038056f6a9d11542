// Stored frames: what a take shows where its simulation gives other bits.
#include "files/take/take_frames.h"

#include <doctest.h>

#include <algorithm>
#include <map>

#include "base/random.h"
#include "base/text_file.h"
#include "muster/scenario.h"
#include "temporary_folder.h"
#include "test_folders.h"

using namespace muster;

namespace {

std::vector<TakeFrame> randomFrames(Random& random, int count) {
    std::vector<TakeFrame> frames;
    std::uint32_t step = random.below(100);
    for (int k = 0; k < count; ++k) {
        TakeFrame frame = frames.empty() || random.below(5) == 0 ? TakeFrame{} : frames.back();
        frame.step = step;
        step += 1 + random.below(30);
        if (frame.ids.empty())
            for (std::uint32_t id = 1; id < 40; ++id)
                if (random.below(3) > 0) frame.ids.push_back(id * (1 + random.below(2) * 1000));
        std::sort(frame.ids.begin(), frame.ids.end());
        frame.ids.erase(std::unique(frame.ids.begin(), frame.ids.end()), frame.ids.end());
        frame.positions.resize(frame.ids.size());
        for (Vec2& p : frame.positions) p += Vec2{random.uniform(-30, 30), random.uniform(-0.1, 0.1)};
        frames.push_back(std::move(frame));
    }
    return frames;
}

/// A take of a scenario with its gestures, and where everybody was after each step.
struct Recorded {
    Take take;
    std::vector<std::uint8_t> bytes;
    std::map<std::uint32_t, std::vector<Vec2>> positions;
};

Recorded record(const std::string& scenario, std::uint32_t steps) {
    const std::string path = sourceFolder() + "/scenarios/" + scenario;
    const testing::TemporaryFolder folder("frames");
    const std::string file = folder / "made.take";
    const WorldDef def = loadScenario(path).value();
    World world = World::create(def).value();
    auto writer = TakeWriter::create(file, def);
    REQUIRE(writer.ok());
    const std::vector<Command> touches = loadScenarioGestures(path, def).value();
    Recorded made;
    for (const Command& command : touches) {
        REQUIRE(world.submit(command).ok());
        REQUIRE(writer->command(command).ok());
    }
    while (world.stepCount() < steps) {
        world.step();
        REQUIRE(writer->observe(world).ok());
        const auto at = world.characters().position;
        made.positions[world.stepCount()] = {at.begin(), at.end()};
    }
    REQUIRE(writer->finish(world).ok());
    const std::string text = readTextFile(file, 1u << 28).value();
    made.bytes.assign(text.begin(), text.end());
    made.take = parseTake(made.bytes, "T").value();
    return made;
}

/// How far anybody is from where the recording had them, in a replay from the frames of a changed take [m].
double farthestOff(const Take& take, const Recorded& made) {
    double worst = 0.0;
    const auto report = replayTake(
        take, 1,
        [&](const World& world) {
            const auto at = world.characters().position;
            const auto& then = made.positions.at(world.stepCount());
            if (world.stepCount() >= 3 && at.size() == then.size())
                for (std::size_t i = 0; i < at.size(); ++i) worst = std::max(worst, distance(at[i], then[i]));
            return true;
        },
        ReplayFrom::Frames);
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->steps == made.take.steps());
    return worst;
}

}  // namespace

TEST_CASE("frames come back to the grain, whatever they hold") {
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        const std::vector<TakeFrame> frames = randomFrames(random, static_cast<int>(random.below(12)));
        std::vector<TakeFrame> read;
        REQUIRE(unpackFrames(packFrames(frames), read).ok());
        REQUIRE(read.size() == frames.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
            CHECK(read[k].step == frames[k].step);
            CHECK(read[k].ids == frames[k].ids);
            for (std::size_t i = 0; i < frames[k].positions.size(); ++i)
                CHECK(distance(read[k].positions[i], frames[k].positions[i]) < 0.71 * kFrameGrain);
        }
    }
}

TEST_CASE("bytes that are no frames are refused, and nothing is added") {
    Random random(5);
    const std::vector<TakeFrame> frames = randomFrames(random, 6);
    const std::vector<std::uint8_t> good = packFrames(frames);
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::uint8_t> bad = good;
        if (random.below(2) == 0)
            bad.resize(random.below(static_cast<std::uint32_t>(good.size())));
        else
            bad[random.below(static_cast<std::uint32_t>(bad.size()))] ^= static_cast<std::uint8_t>(
                1 + random.below(255));
        std::vector<TakeFrame> read;
        const Status status = unpackFrames(bad, read);
        refused += status.ok() ? 0 : 1;
        if (!status.ok()) CHECK(read.empty());
    }
    CHECK(refused > 1000);
    std::vector<TakeFrame> read;
    REQUIRE(unpackFrames(good, read).ok());
    // Earlier frames than those that are there.
    CHECK(unpackFrames(good, read).code() == StatusCode::Corrupt);
    CHECK(read.size() == frames.size());
}

TEST_CASE("larger crowds are stored less often, and always with each mark") {
    CHECK(storedFrameSpacing(1) == 3);
    CHECK(storedFrameSpacing(510) == 3);
    CHECK(storedFrameSpacing(511) == 4);
    CHECK(storedFrameSpacing(1000000) == 30);
    for (std::size_t count = 1; count < 20000; count += 97)
        CHECK(kTakeMarkSpacing % storedFrameSpacing(count) == 0);
}

TEST_CASE("a take whose simulation differs shows the stored frames") {
    const Recorded made = record("paper/x06-course.json", 2400);
    CHECK(simulatesAlike(made.take));
    CHECK(made.take.frames.size() > 700);
    // A minute of a hundred people.
    std::size_t stored = 0;
    for (std::size_t k = 0; k + 20 < made.take.frames.size(); k += 20)
        stored += packFrames(std::span(made.take.frames).subspan(k, 20)).size();
    CHECK(stored * 60.0 / 40.0 < 500000.0);

    Take other = made.take;
    other.def.parameters.character.maxSpeed = 1.2;
    other.def.clips[3].speed = 0.35;
    CHECK(!simulatesAlike(other));
    CHECK(replayTake(other).status().code() == StatusCode::Corrupt);
    CHECK(farthestOff(other, made) < 0.02);
}

TEST_CASE("people who come, go and change groups are where the frames say") {
    Recorded made = record("battle.json", 900);
    Take other = made.take;
    other.def.parameters.character.maxSpeed *= 0.7;
    for (HashMark& mark : other.marks) mark.hash ^= 1;
    CHECK(farthestOff(other, made) < 0.05);
}

TEST_CASE("a take without frames says so") {
    Take take = record("open.json", 120).take;
    take.frames.clear();
    const auto report = replayTake(take, 1, {}, ReplayFrom::Frames);
    CHECK(report.status().code() == StatusCode::Unsupported);
    CHECK(report.status().message() == "the take holds no stored frames");
}

TEST_CASE("frames change no hash, and damage in them is named") {
    const Recorded made = record("open.json", 200);
    const auto report = replayTake(made.take);
    REQUIRE(report.ok());
    CHECK(report->compared == 4);
    Random random(8);
    for (int round = 0; round < 60; ++round) {
        std::vector<std::uint8_t> bad = made.bytes;
        const std::size_t at = made.bytes.size() - 1 -
                               random.below(static_cast<std::uint32_t>(made.bytes.size() / 2));
        bad[at] ^= 32;
        const auto take = parseTake(bad, "T");
        if (!take.ok()) CHECK(take.status().message().find("offset") != std::string::npos);
    }
}
