// The default plan against the exact one under the same costs, in a running world: crowds among a standing
// crowd, cars and slow ground. Bounds stand a little above what is measured, so that a plan that overlooks
// one of these costs fails.
#include <doctest.h>

#include <algorithm>

#include "base/random.h"
#include "scale/fine_ground.h"
#include "scale/quality.h"

using namespace muster;
using namespace muster::scale;

namespace {

constexpr std::int32_t kCount = 160;
constexpr std::uint32_t kLookEvery = 30;  // Steps.

/// A floor with a group of 160 that starts a few metres beside its places.
WorldDef floorWithCrowd(std::uint64_t seed) {
    WorldDef def{.box = {{-20, -14}, {20, 14}}, .seed = seed};
    def.groups = {{.count = kCount, .formation = {.spacing = 1.1}, .position = {-3, 0}, .jitter = 0.3}};
    return def;
}

/// Strips of slow ground, 0.8 to 2 m wide.
void addSlowGround(WorldDef& def, Random& random) {
    for (double x = -12; x < 12; x += 4) {
        PatchDef patch;
        const double left = x + random.uniform(0, 1), y = random.uniform(-9, 1);
        const double right = left + random.uniform(0.8, 2.0);
        patch.polygon = {{left, y}, {right, y}, {right, y + 7}, {left, y + 7}};
        patch.speed = 0.12;
        def.patches.push_back(patch);
    }
}

/// Cars that cross the crowd.
void addCars(WorldDef& def, Random& random) {
    for (int k = 0; k < 5; ++k) {
        ObstacleDef car{.centre = {-10.0 + 4.5 * k, k % 2 == 0 ? -13.0 : 13.0}, .radius = 0.7};
        const double way = k % 2 == 0 ? 26.0 : -26.0;
        car.path.waypoints = {{0, {0, 0}, 0}, {random.uniform(8, 12), {0, way}, 0}};
        def.obstacles.push_back(car);
    }
}

/// A second group that stands in clusters of 2.6 per square metre among the places.
void addStandingCrowd(WorldDef& def) {
    GroupDef crowd{.name = "standing"};
    for (const Vec2 middle : {Vec2{-6, 3}, Vec2{-1, -3}, Vec2{3, 3}, Vec2{6, -2}})
        for (std::int32_t i = 0; i < 16; ++i)
            crowd.starts.push_back(middle + Vec2{0.62 * (i % 4), 0.62 * (i / 4)});
    crowd.count = static_cast<std::int32_t>(crowd.starts.size());
    crowd.formation.kind = FormationKind::Points;
    crowd.formation.points = crowd.starts;
    def.groups.push_back(crowd);
}

struct Gaps {
    double worst = 0.0;  ///< [%]
    double mean = 0.0;   ///< [%]
    int looks = 0;
};

/// Gaps of the first group's plan over four seconds, while its places are moved each second.
Gaps gapsOf(const WorldDef& def) {
    World world = World::create(def).value();
    FineGround ground = FineGround::create(world, 1.0).value();
    ThreadPool pool(1);
    Gaps gaps;
    std::uint32_t sequence = 0;
    constexpr Vec2 kStops[] = {{2, 1}, {-2, -2}, {3, -1}, {-3, 2}};
    while (world.stepCount() < 240) {
        const std::uint32_t step = world.stepCount();
        if (step % 60 == 20) {
            const SetPose pose{world.group(0).id, kStops[step / 60], 0.4 * (step / 60)};
            REQUIRE(world.submit({step, 1, sequence++, pose}).ok());
        }
        world.step();
        const UnitCost& cost = ground.update(world);
        if (world.stepCount() % kLookEvery != 0 || world.stepCount() < 60) continue;
        const Committed plan = committedBy(world);
        const double gap = 100.0 * judgeExactly(cost, plan, pool).value().gap(plan.exponent);
        gaps.worst = std::max(gaps.worst, gap);
        gaps.mean += gap;
        ++gaps.looks;
    }
    gaps.mean /= gaps.looks;
    return gaps;
}

void checkGaps(const char* name, const WorldDef& def, double worst, double mean) {
    const Gaps gaps = gapsOf(def);
    MESSAGE("measured: " << std::string(name) << ": gap at worst " << gaps.worst << " %, mean " << gaps.mean
                         << " % of " << gaps.looks << " looks");
    CHECK(gaps.worst <= worst);
    CHECK(gaps.mean <= mean);
}

}  // namespace

TEST_CASE("gap of the default plan on uniform ground") {
    checkGaps("uniform", floorWithCrowd(1), 0.01, 0.01);
}

// A change of places must pay; who was pushed onto slow ground counts with that. One scene says little of it.
TEST_CASE("gap of the default plan on slow ground") {
    constexpr int kScenes = 8;
    double worst = 0.0, mean = 0.0;
    for (int seed = 2; seed < 2 + kScenes; ++seed) {
        WorldDef def = floorWithCrowd(seed);
        Random random(seed);
        addSlowGround(def, random);
        const Gaps gaps = gapsOf(def);
        worst = std::max(worst, gaps.worst);
        mean += gaps.mean / kScenes;
    }
    MESSAGE("measured: slow ground: gap at worst " << worst << " %, mean " << mean << " % of " << kScenes
                                                   << " scenes");
    CHECK(worst <= 15.0);  // 13.3, and 1.01; 42.8 and 2.09 where what is left never grows for them.
    CHECK(mean <= 1.1);
}

TEST_CASE("gap of the default plan among cars") {
    WorldDef def = floorWithCrowd(3);
    Random random(3);
    addCars(def, random);
    checkGaps("cars", def, 3.3, 1.4);  // 1.7 and 0.68; 25 and 4.1 without discomfort.
}

TEST_CASE("gap of the default plan among a standing crowd") {
    WorldDef def = floorWithCrowd(4);
    addStandingCrowd(def);
    checkGaps("standing crowd", def, 5.0, 1.7);  // 0 and 0; 44 and 22 where density is overlooked.
}
