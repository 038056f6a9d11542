#include "engine/steering/motion_state.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

namespace {

constexpr double kStep = 1.0 / 60.0;
constexpr MotionId kCrawling = 1;
constexpr MotionId kJump = 2;

Environment course() {
    Environment environment = Environment::create({.box = {{-5, -5}, {45, 5}},
                                                   .clips = {{"run", "", 1.0, 0, 0.8, true, 0.0},
                                                             {"crawl", "", 0.2, 0, 2.0, true, 0.5},
                                                             {"jump", "", 0.4, 1.0, 1.0, false, 0.0}}})
                                  .value();
    const auto add = [&](double x0, double x1, MotionId motion) {
        PatchDef patch{.polygon = {{x0, -2}, {x1, -2}, {x1, 2}, {x0, 2}}, .motion = motion};
        REQUIRE(environment.addPatch(patch).ok());
    };
    add(5, 8, kCrawling);
    add(7, 10, kCrawling);
    add(15, 16, kJump);
    environment.setTime(0.0);
    return environment;
}

Characters one() {
    return {.id = {1},
            .group = {0},
            .position = {{0, 0}},
            .velocity = {{}},
            .heading = {{1, 0}},
            .place = {0},
            .direction = {{1, 0}},
            .cost = {0},
            .motion = {0},
            .phase = {MotionPhase::Steady},
            .motionTime = {0},
            .patch = {0},
            .lastSingle = {0}};
}

struct Walker {
    Environment environment = course();
    Characters characters = one();
    std::vector<MotionEvent> events;

    void to(double x) {
        while (characters.position[0].x != x) {
            const double left = x - characters.position[0].x;
            characters.position[0].x = std::abs(left) < 0.03
                                           ? x
                                           : characters.position[0].x + (left > 0 ? 0.03 : -0.03);
            updateMotions(environment, kStep, characters, events);
        }
    }
    void wait(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kStep + 0.5); ++i)
            updateMotions(environment, kStep, characters, events);
    }
    int count(MotionChange change) const {
        int n = 0;
        for (const MotionEvent& event : events) n += event.change == change ? 1 : 0;
        return n;
    }
};

}  // namespace

TEST_CASE("two overlapping patches of one motion are entered and left once, with a transition each") {
    Walker w;
    w.to(5.5);
    CHECK(w.characters.motion[0] == kCrawling);
    CHECK(w.characters.phase[0] == MotionPhase::Entering);
    w.to(9.0);
    CHECK(w.characters.phase[0] == MotionPhase::Steady);
    w.to(10.5);
    CHECK(w.characters.phase[0] == MotionPhase::Leaving);
    CHECK(w.characters.motion[0] == kCrawling);
    w.wait(0.6);
    CHECK(w.characters.motion[0] == 0);
    CHECK(w.count(MotionChange::EnterPatch) == 1);
    CHECK(w.count(MotionChange::LeavePatch) == 1);
    CHECK(w.count(MotionChange::TransitionStart) == 2);
    CHECK(w.count(MotionChange::TransitionEnd) == 2);
    CHECK(w.count(MotionChange::SingleStep) == 0);
}

TEST_CASE("a jump happens once per crossing, also with steps to and fro at the edge") {
    Walker w;
    w.to(15.5);
    CHECK(w.characters.phase[0] == MotionPhase::Locked);
    CHECK(w.count(MotionChange::SingleStep) == 1);
    w.to(14.9);
    w.to(15.5);
    CHECK(w.count(MotionChange::SingleStep) == 1);
    w.to(17.0);
    CHECK(w.characters.motion[0] == 0);
    CHECK(w.characters.phase[0] == MotionPhase::Steady);
    w.wait(1.0);
    w.to(15.5);
    CHECK(w.count(MotionChange::SingleStep) == 2);
}

TEST_CASE("a character that comes back during a transition ends with the motion of the ground") {
    Walker w;
    w.to(5.1);
    w.to(4.8);
    CHECK(w.characters.phase[0] == MotionPhase::Leaving);
    w.to(5.2);
    CHECK(w.characters.phase[0] == MotionPhase::Entering);
    w.wait(1.0);
    CHECK(w.characters.motion[0] == kCrawling);
    CHECK(w.characters.phase[0] == MotionPhase::Steady);
}

namespace {

/// A floor with these patches, each from x0 to x1, and somebody who walks along it.
struct Strip {
    struct Piece {
        double x0, x1;
        MotionId motion;
    };

    explicit Strip(const std::vector<Piece>& pieces) {
        EnvironmentDef def{.box = {{-5, -5}, {45, 5}},
                           .clips = {{"run", "", 1.0, 0, 0.8, true, 0.0},
                                     {"crawl", "", 0.2, 0, 2.0, true, 0.5},
                                     {"jump", "", 0.4, 1.0, 1.0, false, 0.0},
                                     {"swim", "", 0.3, 0, 2.0, true, 0.4}}};
        walker.environment = Environment::create(def).value();
        for (const Piece& piece : pieces) {
            PatchDef patch{.polygon = {{piece.x0, -2}, {piece.x1, -2}, {piece.x1, 2}, {piece.x0, 2}},
                           .motion = piece.motion};
            REQUIRE(walker.environment.addPatch(patch).ok());
        }
        walker.environment.setTime(0.0);
    }

    Walker walker;
};

constexpr MotionId kSwim = 3;

/// Transitions that start and end, in order, as motion ids; ends negative.
std::vector<std::int32_t> transitionsOf(const Walker& w) {
    std::vector<std::int32_t> list;
    for (const MotionEvent& event : w.events) {
        if (event.change == MotionChange::TransitionStart)
            list.push_back(static_cast<std::int32_t>(event.value));
        if (event.change == MotionChange::TransitionEnd)
            list.push_back(-static_cast<std::int32_t>(event.value));
    }
    return list;
}

}  // namespace

TEST_CASE("overlapping patches of a jump are one jump, also with steps to and fro at the far edge") {
    Strip strip({{5, 7, kJump}, {6.5, 9, kJump}});
    Walker& w = strip.walker;
    w.to(9.02);
    CHECK(w.count(MotionChange::SingleStep) == 1);
    w.to(8.9);
    w.to(9.02);
    CHECK(w.count(MotionChange::SingleStep) == 1);
    w.to(6.0);  // Back over the whole: still the same encounter.
    w.to(4.9);
    w.to(5.1);
    CHECK(w.count(MotionChange::SingleStep) == 1);
    w.to(4.5);
    w.wait(1.0);
    w.to(5.5);
    CHECK(w.count(MotionChange::SingleStep) == 2);
}

TEST_CASE("two separate patches of a jump are two jumps") {
    Strip strip({{5, 6, kJump}, {6.2, 7, kJump}});
    strip.walker.to(8.0);
    CHECK(strip.walker.count(MotionChange::SingleStep) == 2);
}

TEST_CASE("leaving a patch before the entry has played ends the entry") {
    Strip strip({{5, 5.3, kCrawling}});
    strip.walker.to(8.0);
    strip.walker.wait(1.0);
    CHECK(transitionsOf(strip.walker) ==
          std::vector<std::int32_t>{kCrawling, -kCrawling, kCrawling, -kCrawling});
    CHECK(strip.walker.characters.motion[0] == 0);
}

TEST_CASE("from crawling straight into swimming both transitions play, one after the other") {
    Strip strip({{5, 8, kCrawling}, {8, 11, kSwim}});
    Walker& w = strip.walker;
    w.to(8.1);
    CHECK(w.characters.phase[0] == MotionPhase::Leaving);
    CHECK(w.characters.motion[0] == kCrawling);
    w.wait(0.6);
    CHECK(w.characters.phase[0] == MotionPhase::Entering);
    CHECK(w.characters.motion[0] == kSwim);
    w.to(14.0);
    w.wait(1.0);
    CHECK(transitionsOf(w) == std::vector<std::int32_t>{kCrawling, -kCrawling, kCrawling, -kCrawling, kSwim,
                                                        -kSwim, kSwim, -kSwim});
    CHECK(w.count(MotionChange::EnterPatch) == 2);
    CHECK(w.count(MotionChange::LeavePatch) == 2);
}

TEST_CASE("every transition that starts ends, on random walks too") {
    Strip strip({{5, 6, kCrawling}, {6, 7, kSwim}, {7, 7.5, kJump}, {7.5, 8, kCrawling}, {9, 9.1, kSwim}});
    Walker& w = strip.walker;
    Random random(4);
    for (int k = 0; k < 200; ++k) w.to(random.uniform(4, 10));
    w.to(12.0);
    w.wait(2.0);
    const std::vector<std::int32_t> list = transitionsOf(w);
    REQUIRE(list.size() > 100);
    CHECK(list.size() % 2 == 0);
    for (std::size_t k = 0; k + 1 < list.size(); k += 2) {
        REQUIRE(list[k] > 0);
        REQUIRE(list[k + 1] == -list[k]);
    }
}
