// Bodies that lie keep a distance that follows their length.
#include "engine/steering/body_axes.h"

#include <doctest.h>

#include "base/random.h"
#include "engine/steering/contacts.h"
#include "engine/steering/steering.h"

using namespace muster;

namespace {

constexpr MotionId kCrawl = 3;

// A net over all of the world but its left margin.
Environment netWorld() {
    Environment environment = Environment::create({.box = {{-20, -20}, {20, 20}}}).value();
    PatchDef net{.polygon = {{-10, -20}, {20, -20}, {20, 20}, {-10, 20}}, .motion = kCrawl};
    REQUIRE(environment.addPatch(net).ok());
    environment.setTime(0.0);
    return environment;
}

struct TurnedCrowd {
    Characters now;
    std::vector<Vec2> place, still, facing;

    void add(Vec2 at, Vec2 heading, MotionId motion = kCrawl, MotionPhase phase = MotionPhase::Steady) {
        const auto id = static_cast<std::uint32_t>(now.size() + 1);
        now.id.push_back(id);
        now.group.push_back(0);
        now.position.push_back(at);
        now.velocity.push_back({});
        now.heading.push_back(heading);
        now.direction.push_back(heading);
        now.place.push_back(-1);
        now.cost.push_back(1.0);
        now.motion.push_back(motion);
        now.phase.push_back(phase);
        now.motionTime.push_back(0.0);
        now.patch.push_back(motion == 0 ? 0u : 1u);
        now.body.push_back({});
        now.driver.push_back(Driver::Muster);
        now.claim.emplace_back();
        place.push_back(at);
        still.push_back({});
        facing.push_back(heading);
    }

    // One step without contacts' bounds, positions only.
    void settle(const Environment& environment, int steps) {
        Contacts contacts;
        const CrowdBodies bodies;
        for (int k = 0; k < steps; ++k) {
            BodyAxes axes;
            axes.resolve(environment, now, place, still);
            contacts.resolve({16}, {}, environment, now.position, nullptr, nullptr, {}, &bodies, &axes);
        }
    }
};

double spacing(const TurnedCrowd& crowd) {
    return distance(crowd.now.position[0], crowd.now.position[1]);
}

}  // namespace

TEST_CASE("crawlers in file come apart by their length, and only the one behind gives way") {
    const Environment environment = netWorld();
    TurnedCrowd crowd;
    crowd.add({0, 0}, {1, 0});
    crowd.add({0.55, 0}, {1, 0});
    crowd.settle(environment, 4);
    // From the hips ahead to the head behind: 0.42 + 0.26 m, less 0.12 of ends, and 0.28 between them.
    CHECK(spacing(crowd) == doctest::Approx(0.84).epsilon(1e-3));
    CHECK(crowd.now.position[1] == Vec2{0.55, 0});
}

TEST_CASE("upright people, and crawlers side by side, stand as near as ever") {
    const Environment environment = netWorld();
    for (const auto& [apart, motion] :
         {std::pair{Vec2{0.0, 0.5}, kCrawl}, std::pair{Vec2{0.5, 0.0}, MotionId{0}}}) {
        TurnedCrowd crowd;
        crowd.add({0, 0}, {1, 0}, motion);
        crowd.add(apart, {1, 0}, motion);
        const std::vector<Vec2> before = crowd.now.position;
        crowd.settle(environment, 3);
        CHECK(crowd.now.position == before);
    }
}

TEST_CASE("crawlers face to face share the correction and come apart by two heads") {
    const Environment environment = netWorld();
    TurnedCrowd crowd;
    crowd.add({-0.3, 0}, {1, 0});
    crowd.add({0.3, 0}, {-1, 0});
    crowd.settle(environment, 60);
    CHECK(spacing(crowd) > 0.28);
    CHECK(length(crowd.now.position[0] + crowd.now.position[1]) < 1e-6);
}

TEST_CASE("lengths grow while people lie down and shrink while they stand up") {
    const Environment environment = netWorld();
    double before = 0.5;
    for (const double time : {0.0, 0.2, 0.4, 0.7, 1.0}) {
        TurnedCrowd crowd;
        crowd.add({0, 0}, {1, 0}, kCrawl, MotionPhase::Entering);
        crowd.add({0.5, 0}, {1, 0}, kCrawl);
        crowd.now.motionTime[0] = time;
        crowd.settle(environment, 4);
        CHECK(spacing(crowd) >= before - 1e-9);
        before = spacing(crowd);
        crowd.now.position[0] = {0, 0};
        crowd.now.phase[0] = MotionPhase::Leaving;
        crowd.now.motionTime[0] = 1.0 - time;
        crowd.settle(environment, 4);
        CHECK(spacing(crowd) == doctest::Approx(before).epsilon(1e-6));
    }
    CHECK(before == doctest::Approx(0.84).epsilon(1e-3));
}

TEST_CASE("who comes to a crawler waits behind its feet before lying down") {
    const Environment environment = netWorld();
    TurnedCrowd crowd;
    crowd.add({-10.4, 0}, {1, 0}, 0);
    crowd.add({-9.8, 0}, {1, 0});
    Steering steering;
    std::vector<Vec2> velocity(2), heading(2);
    const SteeringInput input{crowd.place, crowd.still, crowd.facing};
    steering.run(CrowdBodies(), crowd.now, input, environment, 1.0 / 60.0, velocity, heading);
    CHECK(!steering.axes().none());
    CHECK(dot(steering.preferred()[0], {1, 0}) < 1e-9);
    crowd.now.position[1] = {-8.0, 0};
    steering.run(CrowdBodies(), crowd.now, input, environment, 1.0 / 60.0, velocity, heading);
    CHECK(dot(steering.preferred()[0], {1, 0}) > 1.5);
}

TEST_CASE("crawlers dropped at random come apart, whatever their headings") {
    const Environment environment = netWorld();
    Random random(23);
    for (int scene = 0; scene < 10; ++scene) {
        TurnedCrowd crowd;
        for (int k = 0; k < 40; ++k) {
            const Vec2 heading = normalized({random.uniform(-1, 1), random.uniform(-1, 1)}, {1, 0});
            crowd.add({random.uniform(-6, 6), random.uniform(-6, 6)}, heading);
        }
        crowd.settle(environment, 80);
        BodyAxes axes;
        axes.resolve(environment, crowd.now, crowd.place, crowd.still);
        const double worst = axes.forOverlaps(crowd.now.position, [](auto...) {});
        CHECK(worst < 0.02);
    }
}

TEST_CASE("without patches nobody has an axis") {
    const Environment environment = Environment::create({.box = {{-5, -5}, {5, 5}}}).value();
    TurnedCrowd crowd;
    crowd.add({0, 0}, {1, 0}, kCrawl);
    BodyAxes axes;
    axes.resolve(environment, crowd.now, crowd.place, crowd.still);
    CHECK(axes.none());
}
