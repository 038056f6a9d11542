// Every mechanism can be switched off: that changes what it is for, and nothing where it has nothing to do.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/fields/cost/unit_cost.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Everything that moves in a run, number by number.
struct Track {
    std::vector<Vec2> characters, places, mesh;
    std::vector<std::int32_t> assigned;
    friend bool operator==(const Track&, const Track&) = default;
};

using Director = std::function<void(World&, int)>;

Track trackOf(WorldDef def, const char* parameter, double value, const Director& direct, int steps = 240) {
    REQUIRE(setParameter(def.parameters, parameter, value).ok());
    World world = World::create(def).value();
    Track track;
    for (int s = 0; s < steps; ++s) {
        direct(world, s);
        world.step();
        REQUIRE(world.rejections().empty());
        const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        add(track.characters, world.characters().position);
        add(track.assigned, world.characters().place);
        for (std::size_t g = 0; g < world.groupCount(); ++g) {
            add(track.places, world.group(g).placePositions);
            add(track.mesh, world.group(g).finalMesh);
        }
    }
    return track;
}

/// One finger draws the whole formation to the right and lifts.
Director drawing(Vec2 from, Vec2 travel, int steps = 120) {
    return [=](World& world, int s) {
        std::uint32_t sequence = static_cast<std::uint32_t>(s) * 2;
        if (s == 0) REQUIRE(give(world, Touch{TouchPhase::Down, 1, from, world.time(), {}}).ok());
        if (s > 0 && s <= steps)
            REQUIRE(
                give(world, Touch{TouchPhase::Move, 1, from + travel * (s * 1.0 / steps), world.time(), {}})
                    .ok());
        if (s == steps + 1) REQUIRE(give(world, Touch{TouchPhase::Up, 1, {}, world.time(), {}}).ok());
    };
}

const Director kNobody = [](World&, int) {};

ObstacleDef carFrom(Vec2 from, Vec2 to, double seconds) {
    ObstacleDef car = tree(from, 0.6);
    car.path.waypoints = {{0, {0, 0}, 0}, {seconds, to - from, 0}};
    return car;
}

/// How far Vf lies from Vu at its worst vertex.
double displacement(const World& world) {
    const auto from = world.group(0).userMesh;
    const auto to = world.group(0).finalMesh;
    double worst = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) worst = std::max(worst, distance(from[i], to[i]));
    return worst;
}

}  // namespace

TEST_CASE("field.enabled: off, the mesh is what the user made of it, even inside an obstacle") {
    for (const bool enabled : {false, true}) {
        WorldDef def = openFloor(25);
        def.obstacles.push_back(tree({-6, 2.2}, 0.8));
        def.parameters.field.enabled = enabled;
        World world = World::create(def).value();
        for (int s = 0; s < 120; ++s) world.step();
        CAPTURE(enabled);
        if (!enabled)
            CHECK(displacement(world) == 0.0);
        else
            CHECK(displacement(world) > 0.1);
        // Nobody stands in the tree in either case: places find free space, contacts see to the rest.
        for (const Vec2 p : world.characters().position) CHECK(distance(p, {-6, 2.2}) > 1.05 - 1e-6);
    }
}

TEST_CASE("field.enabled and field.* change nothing out of reach of obstacles") {
    WorldDef def = openFloor(25);
    def.obstacles.push_back(tree({-6, 9}, 0.8));
    const Director draw = drawing({-6, 0}, {8, 0});
    const Track plain = trackOf(def, "field.enabled", 1, draw);
    CHECK(plain == trackOf(def, "field.enabled", 0, draw));
    CHECK(plain == trackOf(def, "field.gain", 5, draw));
    CHECK(plain == trackOf(def, "field.strength", 5, draw));
}

TEST_CASE("opposing.enabled: off is the same as no gain, on a standing crowd as on") {
    const WorldDef def = openFloor(25);
    const Director draw = drawing({-6, 0}, {9, 2}, 60);  // Faster than they can run.
    const Track off = trackOf(def, "opposing.enabled", 0, draw);
    CHECK(off == trackOf(def, "opposing.gain", 0, draw));
    CHECK_FALSE(off == trackOf(def, "opposing.enabled", 1, draw));
    CHECK(trackOf(def, "opposing.enabled", 0, kNobody) == trackOf(def, "opposing.enabled", 1, kNobody));
}

TEST_CASE("opposing.enabled changes when the mesh arrives, not where") {
    const Director draw = drawing({-6, 0}, {9, 2}, 60);
    const Track on = trackOf(openFloor(25), "opposing.enabled", 1, draw, 900);
    const Track off = trackOf(openFloor(25), "opposing.enabled", 0, draw, 900);
    const std::size_t vertices = on.mesh.size() / 900;
    for (std::size_t i = on.mesh.size() - vertices; i < on.mesh.size(); ++i)
        CHECK(distance(on.mesh[i], off.mesh[i]) < 0.1);
}

TEST_CASE("density.enabled: crowded ground costs more, a sparse crowd changes nothing") {
    WorldDef dense = openFloor(64);
    dense.groups[0].formation.spacing = 0.55;
    WorldDef sparse = openFloor(9);
    sparse.groups[0].formation.spacing = 2.5;
    const auto highestCost = [](WorldDef def, bool enabled) {
        def.parameters.density.enabled = enabled;
        World world = World::create(def).value();
        for (int s = 0; s < 8; ++s) world.step();
        REQUIRE(inspect::unitCost(world) != nullptr);
        float most = 0.0f;
        const Grid& grid = inspect::unitCost(world)->grid;
        for (std::int32_t i = 0; i < grid.count(); ++i) {
            // Beside the world's edge a cell's ways have other lengths than from centre to centre.
            if (!grid.box().grown(-1.5).contains(grid.centre(grid.at(i)))) continue;
            most = std::max(most, inspect::unitCost(world)->cells[i].east);
        }
        return most;
    };
    CHECK(highestCost(dense, true) > 1.2f);
    CHECK(highestCost(dense, false) == doctest::Approx(1.0));
    CHECK(highestCost(sparse, true) == doctest::Approx(1.0));
    const Director draw = drawing({-6, 0}, {8, 1});
    CHECK(trackOf(sparse, "density.enabled", 0, draw) == trackOf(sparse, "density.enabled", 1, draw));
}

TEST_CASE("discomfort.enabled: the ground ahead of a car costs more, that behind it does not") {
    for (const bool enabled : {false, true}) {
        WorldDef def = openFloor(9);
        def.obstacles.push_back(carFrom({0, -6}, {0, 6}, 12.0));  // Upwards at 1 m/s.
        def.parameters.discomfort.enabled = enabled;
        World world = World::create(def).value();
        for (int s = 0; s < 6 * 60 + 5; ++s) world.step();
        const UnitCost& cost = *inspect::unitCost(world);
        const auto at = [&](Vec2 p) { return cost.cells[cost.grid.index(cost.grid.cellOf(p))].east; };
        CAPTURE(enabled);
        if (enabled)
            CHECK(at({0.1, 1.2}) > 1.5f);
        else
            CHECK(at({0.1, 1.2}) == doctest::Approx(1.0));
        CHECK(at({0.1, -2.5}) == doctest::Approx(1.0));
        CHECK(at({5.1, 1.2}) == doctest::Approx(1.0));
    }
    WorldDef still = openFloor(16);
    still.obstacles.push_back(block(-1, -1, 1, 1));
    const Director draw = drawing({-6, 0}, {11, 0});
    CHECK(trackOf(still, "discomfort.enabled", 0, draw) == trackOf(still, "discomfort.enabled", 1, draw));
}

TEST_CASE("plan.geodesic: a wall between near things makes them far; straight lines do not see it") {
    // Two characters, left and right of a long wall; both places left of it, the second just behind the wall.
    for (const bool geodesic : {false, true}) {
        WorldDef def = openFloor(2);
        def.obstacles.push_back(block(-0.2, -11, 0.2, 9));
        def.groups[0].position = {-4.0, 0};
        def.groups[0].formation.spacing = 1.0;
        def.groups[0].starts = {{-8.0, 0}, {0.8, 0}};
        def.parameters.plan.geodesic = geodesic;
        World world = World::create(def).value();
        world.step();
        CAPTURE(geodesic);
        const CharactersView c = world.characters();
        REQUIRE(c.place[1] >= 0);
        // The cost left is that of the path round the wall, or of the straight line through it.
        const double straight = distance(c.position[1], world.group(0).placePositions[c.place[1]]);
        if (geodesic)
            CHECK(world.group(0).objective > 18.0 * 18.0);
        else
            CHECK(world.group(0).objective < 2.0 * (straight + 1.5) * (straight + 1.5) + 60.0);
        for (int s = 0; s < 25 * 60; ++s) world.step();  // Both get there in either case.
        for (std::size_t i = 0; i < 2; ++i) {
            const auto j = static_cast<std::size_t>(c.place[i]);
            CHECK(distance(c.position[i], world.group(0).placePositions[j]) < 0.25);
        }
    }
}

TEST_CASE("plan.mode after a change of formation: assigned again, or by number") {
    for (const PlanMode mode : {PlanMode::Transport, PlanMode::AssignedOnce, PlanMode::Fixed}) {
        WorldDef def = openFloor(16);
        def.parameters.plan.mode = mode;
        World world = World::create(def).value();
        world.step();
        FormationDef ring{.kind = FormationKind::Ring};
        REQUIRE(give(world, ChangeGroup{.group = world.group(0).id, .formation = ring}).ok());
        for (int s = 0; s < 10 * 60; ++s) world.step();
        const std::span place = world.characters().place;
        std::vector<std::int32_t> sorted(place.begin(), place.end());
        std::sort(sorted.begin(), sorted.end());
        bool counted = true;
        for (std::int32_t i = 0; i < 16; ++i) {
            CHECK(sorted[i] == i);  // Each place has one character in every mode.
            counted = counted && place[i] == i;
        }
        CAPTURE(mode);
        CHECK(counted == (mode == PlanMode::Fixed));
    }
}
