// The default plan reads every cost that it should: scenes of two characters whose best places are known, and
// change when one mechanism is switched off.
#include <doctest.h>

#include <algorithm>

#include "base/maths.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

// Two characters A and B, and two places P and Q. In the open A goes to Q and B to P, which lies 3 m before
// it. Something in the strip between B and P, from the lower edge of the world to y = 0, makes that the
// longer way: round it are 7.9 m. Then B goes to Q and A to P.
constexpr Vec2 kA{-1.5, 2.0}, kB{1.5, -3.0}, kP{-1.5, -3.0}, kQ{2.0, 2.5};

WorldDef twoAndTwo() {
    WorldDef def{.box = {{-8, -6}, {8, 8}}};
    def.parameters.field.enabled = false;
    def.parameters.character.acceleration = 0.01;  // They hardly move while they are planned for.
    def.groups = {{.count = 2,
                   .formation = {.kind = FormationKind::Line, .spacing = distance(kP, kQ)},
                   .position = (kP + kQ) / 2.0,
                   .angle = atan2(kQ.y - kP.y, kQ.x - kP.x) - 0.5 * kPi,
                   .starts = {kA, kB}}};
    return def;
}

/// The character that is given the place nearest to P: 'A', 'B', or '-' for none.
char ownerOfP(const World& world) {
    const auto places = world.group(0).placePositions;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t place = world.characters().place[i];
        if (place >= 0 && distance(places[place], kP) < distance(places[place], kQ))
            return i == 0 ? 'A' : 'B';
    }
    return '-';
}

/// Who has P after half a second.
char planned(WorldDef def, std::initializer_list<std::pair<const char*, double>> settings = {}) {
    for (const auto& [name, value] : settings) REQUIRE(setParameter(def.parameters, name, value).ok());
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    return ownerOfP(world);
}

/// A crowd that fills the strip, shoulder to shoulder, and stands.
WorldDef withCrowd() {
    WorldDef def = twoAndTwo();
    def.parameters.character.radius = 0.2;
    GroupDef crowd{.formation = {.kind = FormationKind::Square}};
    for (double y = -5.75; y < 0.0; y += 0.41)
        for (std::int32_t k = -2; k <= 2; ++k) crowd.starts.push_back({0.41 * k, y});
    crowd.count = static_cast<std::int32_t>(crowd.starts.size());
    crowd.position = {0.0, -3.0};
    def.groups.push_back(crowd);
    return def;
}

/// A car that comes up the strip and will be between B and P.
WorldDef withCar() {
    WorldDef def = twoAndTwo();
    ObstacleDef car = tree({0, -5.2}, 0.6);
    car.path.waypoints = {{0, {0, 0}, 0}, {100, {0, 250}, 0}};
    def.obstacles = {car};
    return def;
}

}  // namespace

TEST_CASE("in the open both go the short ways") {
    const World world = World::create(twoAndTwo()).value();
    std::vector<double> off;
    for (const Vec2 p : world.group(0).placePositions)
        off.push_back(std::min(distance(p, kP), distance(p, kQ)));
    CHECK(*std::max_element(off.begin(), off.end()) < 0.05);
    CHECK(planned(twoAndTwo()) == 'B');
    CHECK(planned(twoAndTwo(), {{"plan.solver", 0}}) == 'B');
}

TEST_CASE("plan.geodesic: a wall counts with its way round, straight lines do not see it") {
    WorldDef def = twoAndTwo();
    def.obstacles = {block(-0.6, -6, 0.6, 0)};
    CHECK(planned(def) == 'A');
    CHECK(planned(def, {{"plan.geodesic", 0}}) == 'B');
    CHECK(planned(def, {{"plan.solver", 0}}) == 'A');
}

TEST_CASE("patches: slow ground counts by its travel speed") {
    WorldDef def = twoAndTwo();
    def.patches = {rectangle(-0.6, -6, 0.6, 0, 3)};
    def.patches[0].speed = 0.1;
    CHECK(planned(def) == 'A');
    CHECK(planned(def, {{"plan.solver", 0}}) == 'A');
    def.patches[0].speed = 0.9;
    CHECK(planned(def) == 'B');
}

TEST_CASE("density.enabled: a standing crowd counts; without cost.beta speed is no matter") {
    const WorldDef def = withCrowd();
    CHECK(planned(def) == 'A');
    CHECK(planned(def, {{"density.enabled", 0}}) == 'B');
    CHECK(planned(def, {{"density.max", 100}, {"density.min", 90}}) == 'B');
    CHECK(planned(def, {{"cost.beta", 0}}) == 'B');
    CHECK(planned(def, {{"cost.alpha", 0}}) == 'A');
    CHECK(planned(def, {{"plan.solver", 0}}) == 'A');
}

TEST_CASE("discomfort.enabled: a car that will be there counts, by cost.gamma") {
    const WorldDef def = withCar();
    CHECK(planned(def) == 'A');
    CHECK(planned(def, {{"discomfort.enabled", 0}}) == 'B');
    CHECK(planned(def, {{"cost.gamma", 0}}) == 'B');
    CHECK(planned(def, {{"discomfort.gain", 0}}) == 'B');
    CHECK(planned(def, {{"plan.solver", 0}}) == 'A');
}

namespace {

/// C stands on the first place, and D may take its place or walk past to the other: the sum is less where D
/// walks past (2.4 m and nothing against 1.41 and 1.72 m), the sum of squares and the longest are less where
/// both shift.
char whoShifts(std::initializer_list<std::pair<const char*, double>> settings) {
    constexpr Vec2 kC{1, 1}, kD{0, 0}, kSecond{2.4, 0};
    WorldDef def = twoAndTwo();
    def.groups[0].starts = {kC, kD};
    def.groups[0].position = (kC + kSecond) / 2.0;
    def.groups[0].angle = atan2(kSecond.y - kC.y, kSecond.x - kC.x) - 0.5 * kPi;
    def.groups[0].formation.spacing = distance(kC, kSecond);
    for (const auto& [name, value] : settings) REQUIRE(setParameter(def.parameters, name, value).ok());
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    const Vec2 place = world.group(0).placePositions[world.characters().place[0]];
    return distance(place, kC) < 0.3 ? 'D' : 'C';  // Who walks farther than C to its first place.
}

}  // namespace

TEST_CASE("plan.exponent and plan.objective: sum, squares and longest walk choose as the definition says") {
    CHECK(whoShifts({{"plan.exponent", 1}}) == 'D');
    CHECK(whoShifts({{"plan.exponent", 2}}) == 'C');
    CHECK(whoShifts({{"plan.exponent", 1}, {"plan.objective", 1}}) == 'C');
}

TEST_CASE("plan.threshold and plan.thresholdShare: exchanges that gain less are not made") {
    const auto afterTurn = [](std::initializer_list<std::pair<const char*, double>> settings) {
        WorldDef def = twoAndTwo();
        for (const auto& [name, value] : settings) REQUIRE(setParameter(def.parameters, name, value).ok());
        World world = World::create(def).value();
        for (int s = 0; s < 30; ++s) world.step();
        const auto before = copyOf(world.characters().place);
        REQUIRE(
            give(world, SetPose{world.group(0).id, def.groups[0].position, def.groups[0].angle + kPi}).ok());
        for (int s = 0; s < 400; ++s) world.step();
        return copyOf(world.characters().place) != before;
    };
    CHECK(afterTurn({}));
    CHECK_FALSE(afterTurn({{"plan.threshold", 1e6}}));
    CHECK_FALSE(afterTurn({{"plan.thresholdShare", 1.0}}));
}
