#include "files/export/exporter.h"

#include <doctest.h>

#include <cmath>

#include "base/maths.h"
#include "files/export/export_fixture.h"
#include "muster/motion.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Positions after each step, from the start on.
std::vector<std::vector<Vec2>> stepsOf(const Take& take) {
    std::vector<std::vector<Vec2>> steps;
    const auto add = [&](const World& world) {
        const std::span<const Vec2> now = world.characters().position;
        steps.emplace_back(now.begin(), now.end());
        return true;
    };
    add(*World::create(take.def));
    REQUIRE(replayTake(take, 1, add).ok());
    return steps;
}

}  // namespace

TEST_CASE("frames come at their times, with positions interpolated between steps") {
    const Take take = shortTake();
    const auto steps = stepsOf(take);
    REQUIRE(steps.size() == 121);
    for (const double fps : {24.0, 25.0, 30.0, 60.0, 7.3, 240.0}) {
        Recorder recorder;
        recorder.poses = false;
        REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, fps, 1}, recorder).ok());
        CHECK(recorder.finished == 1);
        CHECK(recorder.info.fps == fps);
        CHECK(recorder.info.name == "Short");
        CHECK(recorder.info.frames == static_cast<std::size_t>(2.0 * fps + 1e-6) + 1);
        REQUIRE(recorder.frames.size() == recorder.info.frames);
        for (std::size_t f = 0; f < recorder.frames.size(); ++f) {
            const auto& frame = recorder.frames[f];
            CHECK(frame.index == f);
            CHECK(frame.time == doctest::Approx(static_cast<double>(f) / fps));
            const double at = frame.time * 60.0;
            const auto below = std::min<std::size_t>(static_cast<std::size_t>(at + 1e-6), 119);
            const double share = std::clamp(at - static_cast<double>(below), 0.0, 1.0);
            for (std::size_t i = 0; i < 9; ++i) {
                const Vec2 expected = steps[below][i] + (steps[below + 1][i] - steps[below][i]) * share;
                REQUIRE(length(frame.characters[i].position - expected) < 1e-6);
                REQUIRE(frame.characters[i].pose == nullptr);
            }
        }
    }
}

TEST_CASE("a part of a take has the same frames as the whole") {
    const Take take = shortTake();
    Recorder whole, part;
    REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 30.0, 1}, whole).ok());
    REQUIRE(exportTake(take, ownClips(), {0.5, 1.5, 30.0, 1}, part).ok());
    REQUIRE(part.frames.size() == 31);
    for (std::size_t f = 0; f < 31; ++f) {
        const auto &a = whole.frames[f + 15], &b = part.frames[f];
        CHECK(a.time == doctest::Approx(b.time));
        REQUIRE(a.poses.size() == 9);
        for (std::size_t i = 0; i < 9; ++i) {
            CHECK(length(a.characters[i].position - b.characters[i].position) < 1e-5);
            CHECK(distance(a.poses[i].hips, b.poses[i].hips) < 1e-4f);
        }
    }
}

TEST_CASE("poses are those of the crowd's motion") {
    const Take take = shortTake();
    Recorder recorder;
    REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 60.0, 1}, recorder).ok());
    CrowdMotion motion(ownClips());
    const auto start = World::create(take.def);
    motion.update(*start);
    std::size_t frame = 1;
    REQUIRE(
        replayTake(take, 1, [&](const World& world) {
            motion.update(world);
            for (std::size_t k = 0; k < motion.near().size(); ++k) {
                const std::uint32_t i = motion.near()[k];
                CHECK(distance(recorder.frames[frame].poses[i].hips, motion.pose(k).hips) < 1e-6f);
                CHECK(recorder.frames[frame].characters[i].yaw == doctest::Approx(motion.states()[i].yaw));
                CHECK(recorder.frames[frame].characters[i].size == characterSize(world.characters().id[i]));
            }
            ++frame;
            return true;
        }).ok());
    CHECK(frame == recorder.frames.size());
}

TEST_CASE("parts outside the take and impossible rates are refused before the export begins") {
    const Take take = shortTake();
    const auto failure = [&](ExportDef def) {
        Recorder recorder;
        const Status status = exportTake(take, ownClips(), def, recorder);
        CHECK(recorder.info.frames == 0);
        return status.message();
    };
    CHECK(failure({1.5, 1.0, 30.0, 1}) ==
          "to: found 1, expected a time not before from; the take is 2 s long");
    CHECK(failure({-1.0, 1.0, 30.0, 1}).find("from: found -1") == 0);
    CHECK(failure({3.0, -1.0, 30.0, 1}).find("from: found 3") == 0);
    CHECK(failure({0.0, 2.5, 30.0, 1}).find("to: found 2.5") == 0);
    CHECK(failure({0.0, -1.0, 0.0, 1}).find("fps: found 0") == 0);
    CHECK(failure({0.0, -1.0, -24.0, 1}).find("fps: found -24") == 0);
    CHECK(failure({0.0, -1.0, std::nan(""), 1}).find("fps: ") == 0);
    CHECK(failure({std::nan(""), -1.0, 30.0, 1}).find("from: ") == 0);
    CHECK(failure({0.0, std::nan(""), 30.0, 1}).find("to: ") == 0);
}

TEST_CASE("one moment is one frame, also at both ends") {
    const Take take = shortTake();
    for (const double at : {0.0, 1.0, 2.0}) {
        Recorder recorder;
        REQUIRE(exportTake(take, ownClips(), {at, at, 30.0, 1}, recorder).ok());
        REQUIRE(recorder.frames.size() == 1);
        CHECK(recorder.frames[0].step == static_cast<std::uint32_t>(at * 60.0 + 0.5));
    }
}

TEST_CASE("a failing exporter ends the export with its own message") {
    const Take take = shortTake();
    Recorder recorder;
    recorder.failAt = 7;
    CHECK(exportTake(take, ownClips(), {}, recorder).message() == "the disk is full");
    CHECK(recorder.frames.size() == 7);
    CHECK(recorder.finished == 0);
}

TEST_CASE("a take that replays to other hashes is not exported to its end") {
    Take take = shortTake();
    take.marks.back().hash ^= 1;
    Recorder recorder;
    const Status status = exportTake(take, ownClips(), {0.0, 1.9, 30.0, 1}, recorder);
    // A part that ends before the last mark may succeed, because only that mark differs.
    CHECK((status.ok() || status.code() == StatusCode::Corrupt));
    take.marks.front().hash ^= 1;
    CHECK(exportTake(take, ownClips(), {}, recorder).code() == StatusCode::Corrupt);
}

TEST_CASE("frames lie closer together in the take where it is to play slower") {
    const Take take = shortTake();
    Recorder recorder;
    recorder.poses = false;
    ExportDef def{0.0, -1.0, 30.0, 1};
    def.speeds = {{0.5, 1.0, 0.5, 0.0}};
    REQUIRE(exportTake(take, ownClips(), def, recorder).ok());
    // Half a second lasts a whole one.
    CHECK(recorder.frames.size() == 76);
    CHECK(recorder.info.frames == 76);
    CHECK(recorder.frames[15].time == doctest::Approx(0.5));
    CHECK(recorder.frames[30].time == doctest::Approx(0.75));
    CHECK(recorder.frames[45].time == doctest::Approx(1.0));
    CHECK(recorder.frames.back().time == doctest::Approx(2.0));
    def.speeds = {{0.5, 0.4, 1.0, 0.0}};
    Recorder none;
    CHECK(exportTake(take, ownClips(), def, none).code() == StatusCode::InvalidArgument);
}

TEST_CASE("an export ends where its progress says so") {
    const Take take = shortTake();
    Recorder recorder;
    int calls = 0;
    const Status status = exportTake(take, ownClips(), {}, recorder, [&](double) { return ++calls < 10; });
    CHECK(status.message() == "the export was cancelled");
    CHECK(calls == 10);
    CHECK(recorder.finished == 0);
}

TEST_CASE("edited people are exported as they are shown, everybody else as recorded") {
    Take take = shortTake();
    for (const bool poses : {true, false}) {
        Recorder plain, edited;
        plain.poses = edited.poses = poses;
        take.about.edits.clear();
        REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 30.0, 1}, plain).ok());
        take.about.edits = {{{2}, {{1.0, {0.0, 1.5}, 0.8}}, {}, {}, {}},
                            {{4}, {}, {{0.2, 0.2}, {1.2, 0.8}}, {}, {}}};
        REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 30.0, 1}, edited).ok());
        REQUIRE(edited.frames.size() == plain.frames.size());
        for (std::size_t f = 0; f < plain.frames.size(); ++f)
            for (std::size_t i = 0; i < 9; ++i) {
                const Vec2 was = plain.frames[f].characters[i].position;
                const Vec2 is = edited.frames[f].characters[i].position;
                if (i != 1 && i != 3) REQUIRE(is == was);
            }
        const auto at = [](const Recorder& all, std::size_t f, std::size_t i) {
            return all.frames[f].characters[i].position;
        };
        CHECK(distance(at(edited, 30, 1), at(plain, 30, 1) + Vec2{0.0, 1.5}) < 1e-6);
        CHECK(at(edited, 57, 1) == at(plain, 57, 1));
        CHECK(distance(at(edited, 54, 3), at(plain, 42, 3)) < 1e-6);
    }
}
