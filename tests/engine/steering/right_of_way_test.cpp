// Ordered headway and the right of way, without plans: everybody heads for a point behind a door.
#include "engine/steering/right_of_way.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/steering/contacts.h"
#include "engine/steering/headway.h"

using namespace muster;

namespace {

constexpr double kTick = 1.0 / 60.0;

/// A wall from x = 0 to `thick` with a door of `width` at y = 0.
Environment wallWithDoor(double width, double thick) {
    Environment environment = Environment::create({.box = {{-20, -10}, {20 + thick, 10}}}).value();
    for (const double side : {-1.0, 1.0}) {
        ObstacleDef wall;
        wall.name = "wall";
        const double near = side * width / 2, far = side * 10.0;
        wall.polygon = {{0, std::min(near, far)},
                        {thick, std::min(near, far)},
                        {thick, std::max(near, far)},
                        {0, std::max(near, far)}};
        REQUIRE(environment.addObstacle(wall).ok());
    }
    environment.setTime(0.0);
    return environment;
}

struct Walkers {
    Environment environment;
    double thick = 1.0, width = 0.8;
    Characters now;
    std::vector<Vec2> goal, still, wanted, velocity, next;
    std::vector<double> top;
    std::vector<GroupClaim> groups{{1, false}, {2, false}};
    std::vector<Claim> claims;
    RightOfWay right;
    Headway headway;
    NearRows rows;
    NeighbourList neighbours;
    Contacts contacts;
    CrowdBodies bodies;
    double deepest = 0.0;

    Walkers(double doorWidth, double wall)
        : environment(wallWithDoor(doorWidth, wall)), thick(wall), width(doorWidth) {}

    void add(Vec2 at, Vec2 to, std::uint32_t group) {
        now.id.push_back(static_cast<std::uint32_t>(now.size()) + 1);
        now.group.push_back(group);
        now.position.push_back(at);
        now.velocity.push_back({});
        now.place.push_back(static_cast<std::int32_t>(now.place.size()));
        now.direction.push_back({});
        now.cost.push_back(distance(at, to));
        goal.push_back(to);
        still.push_back({});
        top.push_back(2.0);
        claims.emplace_back();
        claims.back().since = groups[group].since;
    }
    /// Towards the goal, through the middle of the door where that lies between.
    Vec2 towards(Vec2 p, Vec2 to) const {
        const double inner = std::max(0.0, width / 2 - 0.27);
        const bool right = to.x > 0.0;
        if (right ? p.x > thick : p.x < 0.0) return to;
        const bool inDoor = p.x > -0.3 && p.x < thick + 0.3 && std::fabs(p.y) <= inner + 0.05;
        if (inDoor && to.x > 0.0 && to.x < thick) return to;
        if (inDoor) return {right ? thick + 0.4 : -0.4, std::clamp(p.y, -inner, inner)};
        return {right ? -0.2 : thick + 0.2, 0.0};
    }
    void step(std::uint32_t tick) {
        const std::size_t n = now.size();
        wanted.resize(n);
        velocity.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 aim = towards(now.position[i], goal[i]);
            const double left = distance(now.position[i], goal[i]);
            wanted[i] = normalized(aim - now.position[i]) * std::min(2.0, 3.0 * left);
            now.cost[i] = left;
        }
        const bool blocked = right.count({bodies, top, wanted, goal, still, {}, groups, tick, kTick}, now,
                                         claims);
        neighbours.build(now.position, 1.5);
        rows.build(bodies, now.position, neighbours.pairs());
        if (blocked) right.run(bodies, environment, rows, top, {}, now, claims, wanted);
        for (std::size_t i = 0; i < n; ++i)
            velocity[i] = now.velocity[i] + clampLength(wanted[i] - now.velocity[i], 10.0 * kTick);
        headway.run(bodies, now, environment, neighbours,
                    {wanted, wanted, top, claims, blocked ? &right : nullptr, kTick}, velocity);
        next = now.position;
        for (std::size_t i = 0; i < n; ++i) next[i] += velocity[i] * kTick;
        const std::vector<double> reach(n, 1.04 * 2.0 * kTick);
        const ContactReport report = contacts.resolve({}, {}, environment, next, nullptr, nullptr,
                                                      {now.position, reach}, &bodies);
        deepest = std::max(deepest, report.worstPenetration);
        for (std::size_t i = 0; i < n; ++i)
            now.velocity[i] = clampLength((next[i] - now.position[i]) / kTick, length(velocity[i]));
        now.position = next;
    }
    /// The time at which all are at their goals [s]; 1e9 for never.
    double arrival(double most) {
        for (std::uint32_t tick = 1; tick * kTick < most; ++tick) {
            step(tick);
            bool all = true;
            for (std::size_t i = 0; i < now.size(); ++i)
                all = all && distance(now.position[i], goal[i]) < 0.3;
            if (all) return tick * kTick;
        }
        return 1e9;
    }
};

}  // namespace

TEST_CASE("one against one in a door for one: the younger order backs out, in walls thin and thick") {
    for (const double width : {0.6, 0.8, 0.9})
        for (const double thick : {0.2, 1.0, 4.0}) {
            Walkers walkers(width, thick);
            walkers.add({-5, 0.1}, {5 + thick, 0}, 0);
            walkers.add({5 + thick, -0.1}, {-5, 0}, 1);
            const double seconds = walkers.arrival(60.0);
            CAPTURE(width);
            CAPTURE(thick);
            CHECK(seconds < 1.6 * (10.0 + thick) / 2.0 + 2.0 + thick);
            CHECK(walkers.deepest < 0.1);
        }
}

TEST_CASE("files of six that meet in a passage for one pass one after the other") {
    Walkers walkers(0.9, 6.0);
    for (int k = 0; k < 6; ++k) {
        walkers.add({-4.0 - k, 0.05 * k}, {16.0 - k, 0.0}, 0);
        walkers.add({10.0 + k, -0.05 * k}, {-10.0 + k, 0.0}, 1);
    }
    const double seconds = walkers.arrival(120.0);
    MESSAGE("twelve have changed sides after " << seconds << " s");
    CHECK(seconds < 40.0);
    CHECK(walkers.deepest < 0.1);
}

TEST_CASE("of those who go the same way the one behind keeps its headway") {
    Walkers walkers(4.0, 0.2);
    walkers.add({-8, 0}, {15, 0}, 0);
    walkers.add({-8.6, 0}, {15, 0}, 0);
    walkers.now.velocity = {{0.2, 0.0}, {1.9, 0.0}};
    walkers.step(1);
    CHECK(walkers.velocity[1].x <= walkers.velocity[0].x + 0.1 / 0.2 + 1e-9);
}

TEST_CASE("who rests lends its way to who walks, and comes back") {
    Walkers walkers(0.8, 1.0);
    walkers.add({-5, 0.0}, {6, 0}, 0);
    walkers.add({0.5, 0.0}, {0.5, 0.0}, 1);
    const double seconds = walkers.arrival(60.0);
    CHECK(seconds < 20.0);
}

TEST_CASE("the same crowd moves by the same bits again") {
    const auto play = [] {
        Walkers walkers(1.2, 1.0);
        for (int k = 0; k < 12; ++k) {
            walkers.add({-3.0 - k / 3, k % 3 - 1.0}, {8.0 - k / 3, k % 3 - 1.0}, 0);
            walkers.add({4.0 + k / 3, k % 3 - 1.0}, {-7.0 + k / 3, k % 3 - 1.0}, 1);
        }
        for (std::uint32_t tick = 1; tick < 600; ++tick) walkers.step(tick);
        return walkers.now.position;
    };
    CHECK(play() == play());
}
