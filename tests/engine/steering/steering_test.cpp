#include "engine/steering/steering.h"

#include <doctest.h>

#include <limits>

using namespace muster;

namespace {

constexpr double kSteerStep = 1.0 / 60.0;

Environment ground(double patchSpeed) {
    Environment environment = Environment::create({.box = {{-30, -30}, {30, 30}}}).value();
    PatchDef patch{
        .name = "Mud", .polygon = {{5, -5}, {15, -5}, {15, 5}, {5, 5}}, .motion = 1, .speed = patchSpeed};
    REQUIRE(environment.addPatch(patch).ok());
    environment.setTime(0.0);
    return environment;
}

void add(Characters& c, Vec2 position, Vec2 direction) {
    c.id.push_back(static_cast<std::uint32_t>(c.size()) + 1);
    c.group.push_back(0);
    c.position.push_back(position);
    c.velocity.push_back({});
    c.heading.push_back({1, 0});
    c.place.push_back(static_cast<std::int32_t>(c.place.size()));
    c.direction.push_back(direction);
    c.cost.push_back(0);
    c.motion.push_back(0);
    c.phase.push_back(MotionPhase::Steady);
    c.motionTime.push_back(0);
    c.patch.push_back(0);
    c.lastSingle.push_back(0);
    c.claim.emplace_back();
}

// Runs towards fixed places, straight, without contacts.
void walk(Characters& c, const std::vector<Vec2>& places, const Environment& environment, int steps) {
    Steering steering;
    const CrowdBodies bodies;
    std::vector<Vec2> still(c.size());
    std::vector<Vec2> facing(c.size(), Vec2{0, 1});
    std::vector<Vec2> velocity(c.size());
    std::vector<Vec2> heading(c.size());
    for (int s = 0; s < steps; ++s) {
        for (std::size_t i = 0; i < c.size(); ++i) c.direction[i] = normalized(places[i] - c.position[i]);
        steering.run(bodies, c, {places, still, facing}, environment, kSteerStep, velocity, heading);
        c.velocity = velocity;
        c.heading = heading;
        for (std::size_t i = 0; i < c.size(); ++i) c.position[i] += velocity[i] * kSteerStep;
    }
}

}  // namespace

TEST_CASE("a character reaches top speed, arrives without overshoot and faces with its formation") {
    const Environment environment = ground(0.5);
    Characters c;
    add(c, {-10, 0}, {1, 0});
    walk(c, {{-2, 0}}, environment, 120);
    CHECK(length(c.velocity[0]) == doctest::Approx(2.0).epsilon(1e-6));
    CHECK(c.heading[0].x == doctest::Approx(1.0).epsilon(1e-3));
    double furthest = -10.0;
    for (int s = 0; s < 400; ++s) {
        walk(c, {{-2, 0}}, environment, 1);
        furthest = std::max(furthest, c.position[0].x);
    }
    CHECK(distance(c.position[0], {-2, 0}) < 1e-3);
    CHECK(furthest < -2.0 + 0.02);
    CHECK(c.heading[0].y == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("the ground's travel speed scales the top speed") {
    const Environment environment = ground(0.35);
    Characters c;
    add(c, {6, 0}, {1, 0});
    walk(c, {{14, 0}}, environment, 120);
    CHECK(length(c.velocity[0]) == doctest::Approx(0.7).epsilon(1e-6));
}

TEST_CASE("two who meet head on pass each other, each to its right") {
    const Environment environment = ground(0.5);
    Characters c;
    add(c, {-5, 10}, {1, 0});
    add(c, {0, 10}, {-1, 0});
    std::vector<Vec2> places{{0, 10}, {-5, 10}};
    double nearest = std::numeric_limits<double>::infinity();
    for (int s = 0; s < 600; ++s) {
        walk(c, places, environment, 1);
        nearest = std::min(nearest, distance(c.position[0], c.position[1]));
    }
    CHECK(distance(c.position[0], places[0]) < 0.1);
    CHECK(distance(c.position[1], places[1]) < 0.1);
    CHECK(nearest > 0.0);
}

TEST_CASE("characters that walk together do not slow each other, those that meet step aside alike") {
    const Environment environment = ground(1.0);
    const auto velocitiesAfter = [&](Vec2 ahead, Vec2 direction) {
        Characters c;
        add(c, {0, 0}, {1, 0});
        add(c, ahead, direction);
        c.velocity = {{2, 0}, direction * 2.0};
        walk(c, {{20, 0}, ahead + direction * 20.0}, environment, 1);
        return c.velocity;
    };
    // One a finger's breadth ahead, one beside, one who comes towards.
    CHECK(velocitiesAfter({0.55, 0.0}, {1, 0})[0].x == doctest::Approx(2.0));
    CHECK(velocitiesAfter({0.0, 0.55}, {1, 0})[0].x == doctest::Approx(2.0));
    const std::vector<Vec2> met = velocitiesAfter({0.55, 0.0}, {-1, 0});
    CHECK(met[0].y < -0.1);
    CHECK(met[1].x == doctest::Approx(-met[0].x));
    CHECK(met[1].y == doctest::Approx(-met[0].y));
}

TEST_CASE("the unmatched stand still") {
    const Environment environment = ground(0.5);
    Characters c;
    add(c, {0, 0}, {});
    c.place[0] = -1;
    Steering steering;
    std::vector<Vec2> own{{0, 0}};
    std::vector<Vec2> still(1);
    std::vector<Vec2> facing(1, Vec2{1, 0});
    std::vector<Vec2> velocity(1);
    std::vector<Vec2> heading(1);
    steering.run({}, c, {own, still, facing}, environment, kSteerStep, velocity, heading);
    CHECK(velocity[0] == Vec2{});
}

TEST_CASE("within a single-step motion the direction deviates by at most 20 degrees") {
    const Environment environment = ground(0.5);
    Characters c;
    add(c, {0, 0}, {-1, 0});
    c.phase[0] = MotionPhase::Locked;
    c.velocity[0] = {2, 0};
    Steering steering;
    std::vector<Vec2> place{{-9, 0}};
    std::vector<Vec2> still(1);
    std::vector<Vec2> facing(1, Vec2{1, 0});
    std::vector<Vec2> velocity(1);
    std::vector<Vec2> heading(1);
    for (int s = 0; s < 60; ++s) {
        steering.run({}, c, {place, still, facing}, environment, kSteerStep, velocity, heading);
        c.velocity = velocity;
    }
    CHECK(dot(normalized(velocity[0]), Vec2{1, 0}) > 0.93);
    CHECK(heading[0] == Vec2{1, 0});
}

TEST_CASE("steering gives the same bits with any number of threads") {
    const Environment environment = ground(0.4);
    Characters c;
    std::vector<Vec2> places, drift;
    for (int k = 0; k < 1100; ++k) {
        add(c, {k % 40 * 0.6 - 12.0, k / 40 * 0.6 - 8.0}, normalized(Vec2{1.0, 0.01 * (k % 17 - 8)}));
        places.push_back(c.position.back() + Vec2{0.1 * (k % 31), 0.05 * (k % 7)});
        drift.push_back({0.5, 0.0});
    }
    const std::vector<Vec2> facing(c.size(), Vec2{0, 1});
    const SteeringInput input{places, drift, facing};
    Steering steering;
    std::vector<Vec2> velocity(c.size()), heading(c.size()), velocities(c.size()), headings(c.size());
    steering.run({}, c, input, environment, kSteerStep, velocity, heading);
    for (const std::int32_t threads : {1, 2, 5}) {
        ThreadPool pool(threads);
        velocities.assign(c.size(), {9, 9});
        headings.assign(c.size(), {9, 9});
        steering.run({}, c, input, environment, kSteerStep, velocities, headings, &pool);
        CHECK(velocities == velocity);
        CHECK(headings == heading);
    }
    CHECK(length(velocity[500]) > 0.01);
}

TEST_CASE("of two who go the same way the one behind keeps its headway, and nobody else is slowed") {
    const Environment environment = ground(1.0);
    Characters c;
    add(c, {-8, 0}, {1, 0});
    add(c, {-8.6, 0.0}, {1, 0});
    const std::vector<Vec2> places{{0, 0}, {0, 0}}, still(2), facing(2, Vec2{1, 0});
    c.velocity = {{0.2, 0.0}, {1.9, 0.0}};
    std::vector<Vec2> velocity(2), heading(2);
    Steering steering;
    steering.run({}, c, {places, still, facing}, environment, kSteerStep, velocity, heading);
    CHECK(velocity[0].x > 0.3);
    // A gap of 0.1 m and 0.2 s of headway.
    CHECK(velocity[1].x <= velocity[0].x + 0.1 / 0.2 + 1e-9);
    CHECK(velocity[1].x > 0.5);
}

TEST_CASE("where two meet and the elder does not get on, the one whose order is younger is backed out") {
    const Environment environment = ground(1.0);
    const std::vector<GroupClaim> groups{{1, false}, {2, false}};
    for (const bool swapped : {false, true}) {
        Characters c;
        add(c, {-8.0, 0}, {1, 0});
        add(c, {-7.45, 0}, {-1, 0});
        c.group = swapped ? std::vector<std::uint32_t>{1, 0} : std::vector<std::uint32_t>{0, 1};
        c.claim[0].since = swapped ? 2 : 1;
        c.claim[1].since = swapped ? 1 : 2;
        c.claim[0].progress = c.claim[1].progress = 0.0f;
        c.velocity = {{0.2, 0}, {-0.2, 0}};
        const std::vector<Vec2> places{{9, 0}, {-20, 0}}, still(2), facing(2, Vec2{1, 0});
        std::vector<Vec2> velocity(2), heading(2);
        Steering steering;
        steering.run({}, c, {places, still, facing, groups}, environment, kSteerStep, velocity, heading);
        CHECK((velocity[0].x > 0.0) == !swapped);
        CHECK((velocity[1].x > 0.0) == !swapped);
    }
}
