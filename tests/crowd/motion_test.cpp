#include "muster/crowd/motion.h"

#include <doctest.h>

using namespace muster;

namespace {

constexpr double kStep = 1.0 / 60.0;
constexpr MotionId kCrawl = 1;
constexpr MotionId kJump = 2;

Environment course() {
    EnvironmentDef def;
    def.box = {{-5, -5}, {45, 5}};
    def.clips = {{"run", "", 1.0, 0, 0.8, true, 0.0}, {"crawl", "", 0.2, 0, 2.0, true, 0.5}, {"jump", "", 0.4, 1.0, 1.0, false, 0.0}};
    Environment environment = Environment::create(def).value();
    const auto add = [&](double x0, double x1, MotionId motion) {
        PatchDef patch;
        patch.polygon = {{x0, -2}, {x1, -2}, {x1, 2}, {x0, 2}};
        patch.motion = motion;
        REQUIRE(environment.addPatch(patch).ok());
    };
    add(5, 8, kCrawl);
    add(7, 10, kCrawl);
    add(15, 16, kJump);
    environment.setTime(0.0);
    return environment;
}

Characters one() {
    Characters c;
    c.id = {1};
    c.group = {0};
    c.position = {{0, 0}};
    c.velocity = {{}};
    c.heading = {{1, 0}};
    c.place = {0};
    c.direction = {{1, 0}};
    c.cost = {0};
    c.motion = {0};
    c.phase = {MotionPhase::Steady};
    c.motionTime = {0};
    c.patch = {0};
    c.lastSingle = {0};
    return c;
}

struct Walker {
    Environment environment = course();
    Characters characters = one();
    std::vector<MotionEvent> events;

    void to(double x) {
        while (characters.position[0].x != x) {
            const double left = x - characters.position[0].x;
            characters.position[0].x = std::abs(left) < 0.03 ? x : characters.position[0].x + (left > 0 ? 0.03 : -0.03);
            updateMotions(environment, kStep, characters, events);
        }
    }
    void wait(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kStep + 0.5); ++i) updateMotions(environment, kStep, characters, events);
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
    CHECK(w.characters.motion[0] == kCrawl);
    CHECK(w.characters.phase[0] == MotionPhase::Entering);
    w.to(9.0);
    CHECK(w.characters.phase[0] == MotionPhase::Steady);
    w.to(10.5);
    CHECK(w.characters.phase[0] == MotionPhase::Leaving);
    CHECK(w.characters.motion[0] == kCrawl);
    w.wait(0.6);
    CHECK(w.characters.motion[0] == 0);
    CHECK(w.count(MotionChange::EnterPatch) == 1);
    CHECK(w.count(MotionChange::LeavePatch) == 1);
    CHECK(w.count(MotionChange::TransitionStart) == 2);
    CHECK(w.count(MotionChange::TransitionEnd) == 2);
    CHECK(w.count(MotionChange::SingleStep) == 0);
}

TEST_CASE("a jump happens once per crossing, and stepping to and fro at the edge is still one") {
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

TEST_CASE("turning back during a transition ends where the ground says") {
    Walker w;
    w.to(5.1);
    w.to(4.8);
    CHECK(w.characters.phase[0] == MotionPhase::Leaving);
    w.to(5.2);
    CHECK(w.characters.phase[0] == MotionPhase::Entering);
    w.wait(1.0);
    CHECK(w.characters.motion[0] == kCrawl);
    CHECK(w.characters.phase[0] == MotionPhase::Steady);
}
