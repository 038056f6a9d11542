// Own bodies: contacts by mass and radius, own speeds and accelerations, cohesion.
#include <doctest.h>

#include "base/random.h"
#include "engine/steering/cohesion.h"
#include "engine/steering/contacts.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/steering.h"

using namespace muster;

namespace {

Environment emptyWorld(double half) {
    Environment environment = Environment::create({.box = {{-half, -half}, {half, half}}}).value();
    environment.setTime(0.0);
    return environment;
}

// Characters of given bodies, which stand.
struct Crowd {
    Characters now;

    std::int32_t add(Vec2 position, const Body& body, std::uint32_t group = 0, Vec2 direction = {}) {
        now.id.push_back(static_cast<std::uint32_t>(now.size()) + 1);
        now.group.push_back(group);
        now.position.push_back(position);
        now.velocity.push_back({});
        now.heading.push_back({1, 0});
        now.place.push_back(static_cast<std::int32_t>(now.place.size()));
        now.direction.push_back(direction);
        now.cost.push_back(10.0);
        now.phase.push_back(MotionPhase::Steady);
        now.body.push_back(body);
        now.driver.push_back(Driver::Muster);
        now.claim.emplace_back();
        return static_cast<std::int32_t>(now.size()) - 1;
    }
    CrowdBodies bodies(std::vector<std::uint8_t> firmness = {}) const {
        CrowdBodies result;
        result.resolve({}, now, firmness);
        return result;
    }
};

Body bodyOf(double radius, double mass) {
    return {.radius = radius, .mass = mass};
}

}  // namespace

TEST_CASE("two who overlap part by as much as they overlap, in the inverse ratio of their masses") {
    const Environment environment = emptyWorld(10);
    for (const double mass : {0.01, 0.5, 1.0, 4.0, 1000.0}) {
        Crowd crowd;
        crowd.add({0, 0}, bodyOf(0.25, 1.0));
        crowd.add({0.6, 0}, bodyOf(0.6, mass));
        std::vector<Vec2> positions = crowd.now.position;
        const CrowdBodies bodies = crowd.bodies();
        const ContactReport report = Contacts().resolve({64}, {}, environment, positions, nullptr, nullptr,
                                                        {}, &bodies);
        const double first = -positions[0].x, second = positions[1].x - 0.6;
        CHECK(first + second == doctest::Approx(0.25).epsilon(1e-3));
        CHECK(first == doctest::Approx(mass * second).epsilon(1e-3));
        CHECK(positions[0].y == 0.0);
        CHECK(report.worstPenetration < 1e-3);
    }
}

TEST_CASE("who is moved from outside is moved by nobody, and not by walls") {
    Environment environment = emptyWorld(10);
    REQUIRE(environment.addObstacle({.centre = {3, 0}, .radius = 1.0}).ok());
    environment.setTime(0.0);
    Crowd crowd;
    crowd.add({0, 0}, {});
    crowd.add({0.3, 0}, {});
    crowd.add({3, 0}, {});    // In the obstacle.
    crowd.add({3.1, 0}, {});  // Another one of these.
    for (const std::size_t i : {0, 2, 3}) crowd.now.driver[i] = Driver::Outside;
    std::vector<Vec2> positions = crowd.now.position;
    const CrowdBodies bodies = crowd.bodies();
    Contacts().resolve({8}, {}, environment, positions, nullptr, nullptr, {}, &bodies);
    for (const std::size_t i : {0, 2, 3}) CHECK(positions[i] == crowd.now.position[i]);
    CHECK(positions[1].x == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("who holds its ground gives way to other groups hardly, to its own as ever") {
    Crowd crowd;
    const std::int32_t holder = crowd.add({0, 0}, {}, 0), friendly = crowd.add({0.4, 0}, {}, 0),
                       stranger = crowd.add({0, 0.4}, {}, 1);
    const CrowdBodies bodies = crowd.bodies({2, 1});
    CHECK(bodies.share(holder, friendly) == 0.5);
    CHECK(bodies.share(holder, stranger) < 0.005);
    CHECK(bodies.share(holder, stranger) + bodies.share(stranger, holder) == doctest::Approx(1.0));
    CHECK(bodies.isFirmer(holder, stranger));
    CHECK(!bodies.isFirmer(stranger, holder));
    CHECK(crowd.bodies({1, 1}).alike());
}

TEST_CASE("a mixed crowd dropped at random ends without overlap and outside obstacles by its own radii") {
    Random random(16);
    Environment environment = emptyWorld(14);
    REQUIRE(environment.addObstacle({.polygon = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}).ok());
    environment.setTime(0.0);
    for (int scene = 0; scene < 12; ++scene) {
        Crowd crowd;
        for (int k = 0; k < 110; ++k)
            crowd.add({random.uniform(-10, 10), random.uniform(-10, 10)},
                      bodyOf(random.uniform(0.12, k % 20 == 0 ? 1.2 : 0.4), random.uniform(0.2, 9.0)));
        std::vector<Vec2> positions = crowd.now.position;
        const CrowdBodies bodies = crowd.bodies();
        Contacts contacts;
        ContactReport report;
        for (int step = 0; step < 60; ++step)
            report = contacts.resolve({16}, {}, environment, positions, nullptr, nullptr, {}, &bodies);
        double worst = 0.0;
        for (std::size_t a = 0; a < positions.size(); ++a) {
            const double radius = crowd.now.body[a].radius;
            CHECK(environment.distanceToObstacle(positions[a]) > radius - 1e-6);
            for (std::size_t b = 0; b < a; ++b) {
                const double touching = radius + crowd.now.body[b].radius;
                worst = std::max(worst, 1.0 - distance(positions[a], positions[b]) / touching);
            }
        }
        CHECK(worst < 0.1);
        CHECK(report.worstPenetration == doctest::Approx(std::max(0.0, worst)).epsilon(1e-9));
        CHECK(report.overlapPairs == 0);
    }
}

TEST_CASE("each comes to its own top speed, by no more than its own acceleration") {
    const Environment environment = emptyWorld(60);
    Crowd crowd;
    Body slow, fast, heavy;
    slow.maxSpeed = 0.7;
    slow.acceleration = 0.5;
    fast.maxSpeed = 6.0;
    fast.acceleration = 3.0;
    heavy.mass = 50.0;
    crowd.add({-50, 0}, slow, 0, {1, 0});
    crowd.add({-50, 9}, fast, 0, {1, 0});
    crowd.add({-50, -9}, heavy, 0, {1, 0});
    const double top[] = {0.7, 6.0, 2.0}, most[] = {0.5, 3.0, 10.0};
    const CrowdBodies bodies = crowd.bodies();
    Steering steering;
    const std::vector<Vec2> places{{50, 0}, {50, 9}, {50, -9}}, still(3), facing(3, {1, 0});
    std::vector<Vec2> velocity(3), heading(3);
    constexpr double kStep = 1.0 / 60.0;
    for (int step = 0; step < 240; ++step) {
        steering.run(bodies, crowd.now, {places, still, facing}, environment, kStep, velocity, heading);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(length(velocity[i] - crowd.now.velocity[i]) <= most[i] * kStep * (1 + 1e-12));
            crowd.now.position[i] += velocity[i] * kStep;
            crowd.now.velocity[i] = velocity[i];
            // From rest, as fast as the acceleration allows, less what the gain's approach takes.
            const double reached = std::min(top[i], most[i] * kStep * (step + 1));
            CHECK(length(velocity[i]) <= reached * (1 + 1e-12));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) CHECK(length(velocity[i]) == doctest::Approx(top[i]).epsilon(1e-3));
}

TEST_CASE("of a group that keeps together, those ahead walk slower, and nobody above its top speed") {
    Crowd crowd;
    Body slow{.maxSpeed = 1.0};
    for (int k = 0; k < 20; ++k) {
        crowd.add({0, 1.0 * k}, k == 0 ? slow : Body{});
        crowd.now.cost.back() = 40.0 - 0.5 * k;
    }
    crowd.now.place[19] = -1;  // The unmatched count for nothing.
    crowd.now.cost[19] = 1e300;
    std::vector<std::int32_t> members(20);
    for (int k = 0; k < 20; ++k) members[k] = k;
    const CrowdBodies bodies = crowd.bodies();
    std::vector<double> free(20, 1.0), half(20, 1.0), whole(20, 1.0);
    Cohesion().setPaces(1.0, bodies, crowd.now, members, whole);
    Cohesion().setPaces(0.5, bodies, crowd.now, members, half);
    CHECK(whole[0] == 1.0);
    CHECK(whole[19] == 1.0);
    // Of 19 ways the last tenth begins with that of 39 m; nobody that is faster exceeds the catch-up speed.
    for (int k = 1; k < 19; ++k) {
        const double ahead = 39.0 - crowd.now.cost[k];
        const double speed = std::clamp(1.15 - 0.14 * ahead, 0.45, 1.15);
        CHECK(2.0 * whole[k] == doctest::Approx(speed));
        CHECK(half[k] == doctest::Approx(0.5 + 0.25 * speed));
        CHECK(whole[k] <= whole[k - 1]);
    }
}
