// Roles: which class stands where (SPEC B13).
#include <doctest.h>

#include <numeric>

#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// Classes dealt out at random: `archers` of class 1, `guards` of class 2, the others of none.
WorldDef mixedGroup(std::int32_t count, std::int32_t archers, std::int32_t guards, std::uint64_t seed) {
    WorldDef def = openFloor(count);
    Random random(seed);
    GroupDef& group = def.groups[0];
    group.bodies.resize(count);
    for (std::int32_t k = 0; k < archers + guards; ++k) group.bodies[k].unitClass = k < archers ? 1 : 2;
    for (std::uint32_t k = count; k > 1; --k) std::swap(group.bodies[k - 1], group.bodies[random.below(k)]);
    const double half = 0.5 * std::sqrt(count) + 1.0;
    for (std::int32_t k = 0; k < count; ++k)
        group.starts.push_back(group.position +
                               Vec2{random.uniform(-half, half), random.uniform(-half, half)});
    return def;
}

// Characters whose class is not that of their place.
int strangers(const World& world, std::size_t g = 0) {
    const GroupView group = world.group(g);
    const CharactersView c = world.characters();
    int count = 0;
    for (const std::int32_t i : group.members) {
        const std::vector<RoleDef> roles = world.groupDef(g).roles;
        const bool known = std::any_of(roles.begin(), roles.end(), [&](const RoleDef& role) {
            return role.unitClass == c.body[i].unitClass;
        });
        const int unitClass = known ? c.body[i].unitClass : 0;
        if (c.place[i] < 0 || group.placeClasses[c.place[i]] != unitClass) ++count;
    }
    return count;
}

// Rest positions of the places of a class, or of all others.
std::vector<Vec2> restPlaces(const World& world, int unitClass, bool others = false) {
    const GroupView group = world.group(0);
    std::vector<Vec2> places;
    for (std::size_t j = 0; j < group.meshPlaces.size(); ++j) {
        if ((group.placeClasses[j] == unitClass) == others) continue;
        const Triangle& t = group.triangles[group.meshPlaces[j].triangle];
        const auto& w = group.meshPlaces[j].weight;
        places.push_back(group.restMesh[t[0]] * w[0] + group.restMesh[t[1]] * w[1] +
                         group.restMesh[t[2]] * w[2]);
    }
    return places;
}

template <class Key>
double extreme(const std::vector<Vec2>& places, Key key, bool largest) {
    double best = key(places[0]);
    for (const Vec2 p : places) best = largest ? std::max(best, key(p)) : std::min(best, key(p));
    return best;
}

}  // namespace

TEST_CASE("each area takes its part of the rest shape") {
    struct Case {
        RoleArea area;
        double (*key)(Vec2);  // Largest for the places taken.
    };
    const Case cases[] = {{RoleArea::Front, [](Vec2 p) { return p.x; }},
                          {RoleArea::Rear, [](Vec2 p) { return -p.x; }},
                          {RoleArea::LeftFlank, [](Vec2 p) { return p.y; }},
                          {RoleArea::RightFlank, [](Vec2 p) { return -p.y; }},
                          {RoleArea::Flanks, [](Vec2 p) { return std::abs(p.y); }},
                          {RoleArea::Centre, [](Vec2 p) { return -length(p); }},
                          {RoleArea::Rim, [](Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)); }}};
    for (const Case& c : cases) {
        WorldDef def = mixedGroup(49, 12, 0, 3);
        def.groups[0].roles = {{c.area, 1}};
        World world = World::create(def).value();
        world.step();
        const auto taken = restPlaces(world, 1), left = restPlaces(world, 1, true);
        REQUIRE(taken.size() == 12);
        INFO("area " << static_cast<int>(c.area));
        CHECK(extreme(taken, c.key, false) >= extreme(left, c.key, true) - 1e-6);
    }
}

TEST_CASE("mixed classes at random starts end in their places, also while the formation moves") {
    for (const std::int32_t count : {36, 100, 225}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            WorldDef def = mixedGroup(count, count / 4, count / 3, seed);
            def.box = {{-30, -30}, {30, 30}};
            def.groups[0].roles = {{RoleArea::Front, 2}, {seed % 2 == 0 ? RoleArea::Rim : RoleArea::Rear, 1}};
            World world = World::create(def).value();
            for (int s = 0; s < 120; ++s) {
                if (s % 4 == 0)
                    REQUIRE(
                        give(world, SetPose{world.group(0).id, {-6 + 0.02 * s, 0.01 * s}, 0.004 * s}).ok());
                world.step();
                if (s > 2) REQUIRE(strangers(world) == 0);
            }
        }
    }
}

TEST_CASE("roles choose in their order, and of one class each takes its share") {
    WorldDef def = mixedGroup(40, 10, 8, 5);
    def.groups[0].roles = {{RoleArea::Front, 1}, {RoleArea::Front, 2}, {RoleArea::Rear, 1}};
    World world = World::create(def).value();
    world.step();
    const auto archers = restPlaces(world, 1), guards = restPlaces(world, 2);
    CHECK(archers.size() == 10);
    CHECK(guards.size() == 8);
    const double front = extreme(
        guards, [](Vec2 p) { return p.x; }, true);
    int before = 0, behind = 0;
    for (const Vec2 p : archers) {
        before += p.x >= front - 1e-6 ? 1 : 0;
        behind += p.x < -1.0 ? 1 : 0;
    }
    CHECK(before == 5);
    CHECK(behind == 5);
    CHECK(strangers(world) == 0);
}

TEST_CASE("roles and bodies may change, and go away") {
    World world = World::create(mixedGroup(36, 12, 0, 7)).value();
    const GroupId id = world.group(0).id;
    for (int s = 0; s < 30; ++s) world.step();
    CHECK(world.group(0).placeClasses.empty());
    REQUIRE(give(world, ChangeGroup{.group = id, .roles = std::vector<RoleDef>{{RoleArea::Rear, 1}}}).ok());
    for (int s = 0; s < 30; ++s) world.step();
    CHECK(strangers(world) == 0);
    CHECK(std::count(world.group(0).placeClasses.begin(), world.group(0).placeClasses.end(), 1) == 12);
    REQUIRE(give(world, ChangeGroup{.group = id, .roles = std::vector<RoleDef>{{RoleArea::Flanks, 1}}}).ok());
    FormationDef ring{.kind = FormationKind::Ring};
    REQUIRE(give(world, ChangeGroup{.group = id, .formation = ring}).ok());
    for (int s = 0; s < 30; ++s) world.step();
    CHECK(strangers(world) == 0);
    REQUIRE(give(world, ChangeGroup{.group = id, .roles = std::vector<RoleDef>{}}).ok());
    world.step();
    CHECK(world.group(0).placeClasses.empty());
    REQUIRE(give(world, ChangeGroup{.group = GroupId{77}, .roles = std::vector<RoleDef>{}}).ok());
    world.step();
    CHECK(world.rejections().size() == 1);
}

TEST_CASE("places that cannot be reached have no class, and the first roles keep theirs") {
    WorldDef def = mixedGroup(36, 12, 12, 9);
    def.groups[0].roles = {{RoleArea::Front, 1}, {RoleArea::Rear, 2}};
    // A block on the first two files of the formation.
    def.obstacles.push_back(block(-4.0, -6, -2, 6));
    World world = World::create(def).value();
    for (int s = 0; s < 60; ++s) world.step();
    const GroupView group = world.group(0);
    int archers = 0;
    for (std::size_t j = 0; j < group.placeClasses.size(); ++j) {
        if (group.placeUsable[j] == 0) CHECK(group.placeClasses[j] == 0);
        archers += group.placeClasses[j] == 1 ? 1 : 0;
    }
    CHECK(archers == 12);
    const CharactersView c = world.characters();
    for (const std::int32_t i : group.members)
        if (c.body[i].unitClass == 1) CHECK((c.place[i] >= 0 && group.placeClasses[c.place[i]] == 1));
}

TEST_CASE("the exact plan honours roles too") {
    WorldDef def = mixedGroup(25, 8, 5, 11);
    def.groups[0].roles = {{RoleArea::Centre, 1}, {RoleArea::Rear, 2}};
    def.parameters.plan.solver = PlanSolver::Exact;
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    CHECK(strangers(world) == 0);
}

TEST_CASE("a world with roles is restored bit for bit") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Random random(seed);
        WorldDef def = busyFloor(seed);
        for (GroupDef& group : def.groups) {
            group.bodies.resize(group.count);
            for (Body& body : group.bodies) body.unitClass = static_cast<std::uint8_t>(random.below(4));
            group.roles = {{RoleArea::Rim, 1}, {RoleArea::Front, 2}, {RoleArea::Rear, 1}};
        }
        World world = World::create(def).value();
        RandomDirector director(seed);
        const std::uint32_t cut = 20 + random.below(100);
        for (std::uint32_t s = 0; s < cut; ++s) {
            director.act(world);
            world.step();
        }
        checkGoesOn(world, 60, [=](World& each) mutable {
            director.act(each);
            if (each.stepCount() == cut + 30)
                REQUIRE(give(each, ChangeGroup{.group = each.group(1).id,
                                               .roles = std::vector<RoleDef>{{RoleArea::Flanks, 3}}})
                            .ok());
        });
    }
}
