// Formations that keep clear of moving obstacles and of each other (Conduct::avoids).
#include <doctest.h>

#include "base/maths.h"
#include "engine/geometry/polygon.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

GroupDef formation(Vec2 position, double angle, Vec2 target, bool avoids = true, std::int32_t files = 10) {
    return {.count = 60,
            .formation = {.files = files},
            .position = position,
            .angle = angle,
            .conduct = {.avoids = avoids},
            .orders = {Order::move(target)}};
}

/// The outline of a group's final mesh: its triangles.
bool meshesOverlap(const GroupView& a, const GroupView& b) {
    const auto separated = [](const std::array<Vec2, 3>& p, const std::array<Vec2, 3>& q) {
        for (int i = 0; i < 3; ++i) {
            const Vec2 edge = p[(i + 1) % 3] - p[i];
            bool outside = true;
            for (const Vec2 x : q) outside = outside && cross(edge, x - p[i]) <= 0.0;
            if (outside) return true;
        }
        return false;
    };
    const auto corners = [](const GroupView& view, const Triangle& t) {
        return std::array<Vec2, 3>{view.finalMesh[t[0]], view.finalMesh[t[1]], view.finalMesh[t[2]]};
    };
    for (const Triangle& s : a.triangles)
        for (const Triangle& t : b.triangles) {
            const auto p = corners(a, s), q = corners(b, t);
            if (!separated(p, q) && !separated(q, p)) return true;
        }
    return false;
}

struct Outcome {
    double seconds = 1e9;        ///< Until all orders are done.
    double nearestPlace = 1e9;   ///< To a moving obstacle [m].
    double nearestPerson = 1e9;  ///< From the surface of a body to a moving obstacle [m].
    bool meshesMet = false;
};

Outcome run(const WorldDef& def, double most) {
    World world = World::create(def).value();
    Outcome outcome;
    std::size_t done = 0;
    while (world.time() < most && done < def.groups.size()) {
        world.step();
        for (const Event& event : world.events()) done += event.kind == EventKind::OrderDone ? 1 : 0;
        for (const ObstaclePiece& piece : inspect::environment(world).pieces()) {
            if (!piece.moving) continue;
            for (const Vec2 p : world.characters().position)
                outcome.nearestPerson = std::min(
                    outcome.nearestPerson, piece.signedDistance(p) - world.parameters().character.radius);
            for (std::size_t g = 0; g < world.groupCount(); ++g)
                for (const Vec2 p : world.group(g).placePositions)
                    outcome.nearestPlace = std::min(outcome.nearestPlace, piece.signedDistance(p));
        }
        if (world.stepCount() % 6 == 0)
            for (std::size_t a = 0; a < world.groupCount(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    outcome.meshesMet = outcome.meshesMet || meshesOverlap(world.group(a), world.group(b));
        for (const Vec2 p : world.characters().position) REQUIRE(isFinite(p));
    }
    if (done == def.groups.size()) outcome.seconds = world.time();
    return outcome;
}

constexpr double kLane = 1.75;   // Middle of each lane off that of the street [m].
constexpr double kLast = 900.0;  // Of a lane that is full of cars [m].

/// Cars of both lanes at time 0: their places along the street [m].
std::vector<double> lane(const std::vector<double>& gaps, std::size_t first) {
    std::vector<double> cars;
    double at = 70.0;
    for (std::size_t k = first; at > -kLast; ++k) {
        cars.push_back(at);
        at -= 4.5 + gaps[k % gaps.size()];
    }
    return cars;
}

/// A street along the x axis with cars in both lanes, one after the other with these gaps [m].
WorldDef street(bool avoids, double speed, const std::vector<double>& gaps) {
    WorldDef def{.box = {{-90, -30}, {90, 30}}, .cell = 0.5};
    for (const double side : {-1.0, 1.0})
        for (const double at : lane(gaps, side > 0 ? 0 : 3)) {
            ObstacleDef car = block(-2.25, -0.9, 2.25, 0.9);
            const Vec2 a{side * at, side * kLane}, b{side * 1000.0, side * kLane};
            car.path.waypoints = {{0.0, a, 0.0}, {(1000.0 - at) / speed, b, 0.0}};
            def.obstacles.push_back(car);
        }
    def.groups.push_back(formation({0, -16}, kPi / 2, {0, 16}, avoids));
    return def;
}

/// When a rigid box of the formation's size can be on the other side, if it waits at the kerb for the first
/// time at which it meets no car at full speed [s].
double firstCrossing(double speed, const std::vector<double>& gaps, double most) {
    const double v = 0.97 * 2.0, halfDepth = 2.75, halfWidth = 4.75;
    const double kerb = -(kLane + 0.9 + halfDepth);
    const std::vector<double> lanes[2] = {lane(gaps, 3), lane(gaps, 0)};
    for (double begun = (16.0 + kerb) / v; begun < most; begun += 0.05) {
        bool meets = false;
        for (int i = 0; i < 2 && !meets; ++i) {
            const double side = i == 0 ? -1.0 : 1.0;
            const double from = begun + (side * kLane - 0.9 - halfDepth - kerb) / v;
            const double to = begun + (side * kLane + 0.9 + halfDepth - kerb) / v;
            for (const double at : lanes[i])
                // The car passes the box between these two times.
                meets = meets ||
                        (at + speed * to > -halfWidth - 2.25 && at + speed * from < halfWidth + 2.25);
        }
        if (!meets) return begun + (16.0 - kerb) / v;
    }
    return 1e9;
}

}  // namespace

TEST_CASE("a formation of 60 crosses a street of cars in a gap and touches none") {
    for (const double speed : {10.0, 14.0})
        for (const std::vector<double>& gaps :
             {std::vector<double>{25, 25, 25, 150}, std::vector<double>{15, 40, 22, 140, 30, 12, 180, 170}}) {
            const double best = firstCrossing(speed, gaps, 60.0);
            const Outcome free = run(street(true, speed, gaps), 120.0);
            const Outcome plain = run(street(false, speed, gaps), 120.0);
            CAPTURE(speed);
            CAPTURE(gaps.size());
            MESSAGE("cars at " << speed << " m/s: " << free.seconds << " s, places " << free.nearestPlace
                               << " m, people " << free.nearestPerson << " m; best gap " << best
                               << " s; without " << plain.seconds << " s, places " << plain.nearestPlace
                               << " m, people " << plain.nearestPerson << " m");
            CHECK(free.nearestPlace > 0.25);
            CHECK(free.nearestPerson > 0.0);
            CHECK(free.seconds < best + 4.0);
            CHECK(plain.nearestPlace < 0.0);
        }
}

TEST_CASE("two formations that meet go round each other as wholes") {
    WorldDef def{.box = {{-60, -40}, {60, 40}}, .cell = 0.5};
    for (const double angle : {kPi, kPi / 2, 0.7 * kPi}) {
        const Vec2 way{cosine(angle), sine(angle)};
        def.groups = {formation({-30, 0}, 0.0, {30, 0}), formation(way * -30.0, angle, way * 30.0)};
        const Outcome both = run(def, 120.0);
        def.groups[1].conduct.avoids = false;
        const Outcome one = run(def, 120.0);
        def.groups[0].conduct.avoids = false;
        const Outcome none = run(def, 120.0);
        CAPTURE(angle);
        MESSAGE("at " << angle << " rad: both avoid " << both.seconds << " s, one " << one.seconds
                      << " s, none " << none.seconds << " s, met " << none.meshesMet);
        CHECK_FALSE(both.meshesMet);
        CHECK(both.seconds < 60.0);
        CHECK_FALSE(one.meshesMet);
        CHECK(one.seconds < 60.0);
        CHECK(none.meshesMet);
    }
}

TEST_CASE("four formations that cross at one point all arrive and their meshes do not meet") {
    WorldDef def{.box = {{-60, -60}, {60, 60}}, .cell = 0.5};
    for (int k = 0; k < 4; ++k) {
        const double angle = k * kPi / 2;
        const Vec2 way{cosine(angle), sine(angle)};
        def.groups.push_back(formation(way * -30.0, angle, way * 30.0));
    }
    const Outcome four = run(def, 150.0);
    MESSAGE("four: " << four.seconds << " s");
    CHECK_FALSE(four.meshesMet);
    CHECK(four.seconds < 90.0);
}

TEST_CASE("in a corridor without room both wait, then press on, and arrive") {
    WorldDef def{.box = {{-50, -20}, {50, 20}},
                 .cell = 0.5,
                 .obstacles = {block(-50, 7, 50, 20), block(-50, -20, 50, -7)},
                 .groups = {formation({-30, 0}, 0.0, {30, 0}), formation({30, 0}, kPi, {-30, 0})}};
    const Outcome narrow = run(def, 150.0);
    MESSAGE("corridor of 14 m: " << narrow.seconds << " s, met " << narrow.meshesMet);
    CHECK(narrow.seconds < 120.0);
}

TEST_CASE("between walls with room for both they pass, and no mesh is put into a wall") {
    World world = World::create(
                      {.box = {{-50, -20}, {50, 20}},
                       .cell = 0.5,
                       .obstacles = {block(-50, 14, 50, 20), block(-50, -20, 50, -14)},
                       .groups = {formation({-30, 0}, 0.0, {30, 0}), formation({30, 0}, kPi, {-30, 0})}})
                      .value();
    int done = 0;
    double nearest = 1e9;
    bool met = false;
    while (world.time() < 60.0 && done < 2) {
        world.step();
        for (const Event& event : world.events()) done += event.kind == EventKind::OrderDone ? 1 : 0;
        for (std::size_t g = 0; g < 2; ++g)
            for (const Vec2 p : world.group(g).userMesh) nearest = std::min(nearest, 14.0 - std::fabs(p.y));
        if (world.stepCount() % 6 == 0) met = met || meshesOverlap(world.group(0), world.group(1));
    }
    MESSAGE("street of 28 m: " << world.time() << " s, nearest to a wall " << nearest << " m");
    CHECK(done == 2);
    CHECK_FALSE(met);
    CHECK(nearest > 0.0);
}

TEST_CASE("saved, restored or rewound amid others it goes on bit for bit, and breaks no number") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Random random(seed);
        WorldDef def = street(true, 8.0, {20, 50, 35});
        def.groups.push_back(formation({0, 16}, -kPi / 2, {random.uniform(-9, 9), -16}));
        def.groups.push_back(
            formation({-20, random.uniform(-20, 20)}, 0.0, {30, random.uniform(-20, 20)}, seed != 2));
        for (int k = 0; k < 6; ++k)
            def.obstacles.push_back(
                tree({random.uniform(-40, 40), random.uniform(8, 25)}, random.uniform(0.3, 2)));
        World world = World::create(def).value();
        const std::uint32_t saved = 200 + 170 * static_cast<std::uint32_t>(seed);
        while (world.stepCount() < saved) world.step();
        checkGoesOn(world, 200);
        for (const Vec2 p : world.characters().position) CHECK(isFinite(p));
    }
}
