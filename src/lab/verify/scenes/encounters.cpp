// Two crowds that meet, and the everyday scenes of Jain et al. 2025.
#include <algorithm>
#include <cmath>
#include <set>

#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

/// Separation of lanes: mean over strips of 0.5 m of ((east - west) / (east + west))^2, of the people between
/// x = 15 and 25; 1 where every strip has one direction.
double laneOrder(const CharactersView& all) {
    constexpr std::size_t kStrips = 10;
    double east[kStrips] = {}, west[kStrips] = {};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec2 p = all.position[i];
        if (p.x < 15.0 || p.x > 25.0) continue;
        const auto strip = static_cast<std::size_t>(std::clamp(p.y / 0.5, 0.0, kStrips - 0.5));
        (all.group[i] == 0 ? east : west)[strip] += 1.0;
    }
    double sum = 0.0, used = 0.0;
    for (std::size_t k = 0; k < kStrips; ++k) {
        if (east[k] + west[k] < 2.0) continue;
        const double order = (east[k] - west[k]) / (east[k] + west[k]);
        sum += order * order;
        used += 1.0;
    }
    return used < 3.0 ? 0.0 : sum / used;
}

/// Variant: people per square metre in each of two blocks of 8 x 5 m that meet in a corridor of 40 x 5 m.
Result<VerifySample> runLanes(const SceneRun& run) {
    const auto count = static_cast<std::int32_t>(std::lround(numberIn(run.variant) * 40.0));
    Hall hall({boxOf(0, 0, 40, 5)});
    const AreaId west = hall.exit(boxOf(0, 0, 1.5, 5), "West"),
                 east = hall.exit(boxOf(38.5, 0, 40, 5), "East");
    hall.crowd({.name = "To the east",
                .starts = scattered(boxOf(2, 0, 10, 5), count, run.seed, 0.25),
                .people = {adults()},
                .order = Order::leave({east})});
    hall.crowd({.name = "To the west",
                .starts = scattered(boxOf(30, 0, 38, 5), count, run.seed + 1000, 0.25),
                .people = {adults()},
                .order = Order::leave({west})});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    double order = 0.0;
    walk->runUntil(240.0, [&] {
        if (walk->world().stepCount() % 60 == 0)
            order = std::max(order, laneOrder(walk->world().characters()));
    });
    VerifySample sample;
    sample.figures["left"] = static_cast<double>(walk->leavings().size()) / (2.0 * count);
    sample.figures["time"] = walk->lastLeaving();
    sample.figures["order"] = order;
    sample.curves["N-t"] = walk->evacuation();
    walk->report(sample, run);
    return sample;
}

/// The figures of one person in the everyday scenes.
struct Everyday {
    bool arrived = false;
    double length = 0.0, straight = 0.0, time = 0.0, turned = 0.0, reversals = 0.0, deviation = 0.0;
};

/// The figures of a path from its positions at 20 a second and the speed that the person wants.
Everyday everydayOf(const std::vector<Vec2>& path, double wanted) {
    Everyday found;
    if (path.size() < 4) return found;
    found.arrived = true;
    found.straight = distance(path.front(), path.back());
    found.time = static_cast<double>(path.size() - 1) / kSightingRate;
    double before = 0.0, slower = 0.0;
    Vec2 heading;
    // A step lasts a quarter of a second: shorter ones are noise.
    for (std::size_t k = 5; k < path.size(); k += 5) {
        const Vec2 moved = path[k] - path[k - 5];
        found.length += length(moved);
        slower += std::abs(length(moved) * kSightingRate / 5.0 - wanted);
        if (length(moved) < 0.02) continue;
        const Vec2 now = normalized(moved);
        if (heading == Vec2{}) {
            heading = now;
            continue;
        }
        const double turn = std::atan2(cross(heading, now), dot(heading, now));
        found.turned += std::abs(turn);
        // A swing to and fro by more than three degrees.
        if (std::abs(turn) > 0.05 && before * turn < 0.0) found.reversals += 1.0;
        if (std::abs(turn) > 0.05) before = turn;
        heading = now;
    }
    found.deviation = slower / (static_cast<double>(path.size()) / 5.0) / wanted;
    return found;
}

struct EverydayScene {
    Hall hall;
    double speed = 1.3;
};

EverydayScene everydayScene(const std::string& variant, std::uint64_t seed) {
    const double aside = 0.05 * static_cast<double>(seed % 7) - 0.15;
    if (variant == "obstacle") {
        EverydayScene scene{Hall({boxOf(0, 0, 12, 4)})};
        scene.hall.pillar({6.0, 2.0}, 0.25);
        scene.hall.exit(boxOf(11, 0, 12, 4));
        scene.hall.crowd({.starts = {{1.0, 2.0 + aside}},
                          .people = {personsOf(Distribution::constant(1.3))},
                          .order = Order::leave()});
        return scene;
    }
    if (variant == "swapping") {
        EverydayScene scene{Hall({boxOf(0, 0, 12, 4)})};
        const AreaId west = scene.hall.exit(boxOf(0, 1.5, 0.6, 2.5)),
                     east = scene.hall.exit(boxOf(11.4, 1.5, 12, 2.5));
        scene.hall.crowd({.name = "East",
                          .starts = {{1.0, 2.0 + aside}},
                          .people = {personsOf(Distribution::constant(1.3))},
                          .order = Order::leave({east})});
        scene.hall.crowd({.name = "West",
                          .starts = {{11.0, 2.0}},
                          .people = {personsOf(Distribution::constant(1.3))},
                          .order = Order::leave({west})});
        return scene;
    }
    if (variant == "overtaking") {
        EverydayScene scene{Hall({boxOf(0, 0, 16, 4)})};
        const AreaId goal = scene.hall.exit(boxOf(15, 1.5, 16, 2.5));
        scene.hall.crowd({.name = "Fast",
                          .starts = {{1.0, 2.0 + aside}},
                          .people = {personsOf(Distribution::constant(1.3))},
                          .order = Order::leave({goal})});
        scene.hall.crowd({.name = "Slow",
                          .starts = {{3.0, 2.0}},
                          .people = {personsOf(Distribution::constant(0.7))},
                          .order = Order::leave({goal})});
        return scene;
    }
    EverydayScene scene{Hall({boxOf(0, 0, 12, 8)})};
    for (const Vec2 p :
         {Vec2{3.0, 2.2}, {3.2, 5.4}, {5.4, 3.9}, {6.2, 1.4}, {6.4, 6.6}, {8.4, 2.9}, {8.8, 5.3}})
        scene.hall.pillar(p, 0.5);
    scene.hall.exit(boxOf(11, 3, 12, 5));
    scene.hall.crowd({.starts = {{1.0, 1.5}, {1.0, 4.0 + aside}, {1.0, 6.5}},
                      .people = {personsOf(Distribution::constant(1.3))},
                      .order = Order::leave()});
    return scene;
}

/// Variant "obstacle", "swapping", "overtaking" or "maze".
Result<VerifySample> runEveryday(const SceneRun& run) {
    const EverydayScene scene = everydayScene(run.variant, run.seed);
    auto walk = HallRun::start(scene.hall, run.seed);
    if (!walk.ok()) return walk.status();
    const std::size_t persons = walk->present();
    double overlaps = 0.0, steps = 0.0;
    walk->runUntil(60.0, [&] {
        overlaps += walk->world().contacts().overlapPairs > 0 ? 1.0 : 0.0;
        steps += 1.0;
    });
    VerifySample sample;
    const Trajectories all = walk->trajectories();
    std::set<std::uint32_t> gone;
    for (const Leaving& leaving : walk->leavings()) gone.insert(leaving.id);
    double arrived = 0.0, ratio = 0.0, time = 0.0, turned = 0.0, reversals = 0.0, deviation = 0.0,
           judged = 0.0;
    for (std::size_t who = 0; who < all.persons().size(); ++who) {
        if (!gone.contains(all.persons()[who])) continue;
        arrived += 1.0;
        std::vector<Vec2> path;
        for (const std::int32_t row : all.ofPerson(who)) path.push_back(all.all()[row].position);
        const bool slow = run.variant == "overtaking" && who == 1;
        if (slow) continue;
        const Everyday one = everydayOf(path, scene.speed);
        ratio += one.length / one.straight;
        time += one.time * scene.speed / one.straight;
        turned += one.turned / one.length;
        reversals += one.reversals / one.length;
        deviation += one.deviation;
        judged += 1.0;
    }
    sample.figures["arrived"] = arrived / static_cast<double>(persons);
    sample.figures["overlap"] = overlaps / std::max(steps, 1.0);
    sample.figures["ratio"] = ratio / judged;
    sample.figures["time"] = time / judged;
    sample.figures["turned"] = turned / judged;
    sample.figures["reversals"] = reversals / judged;
    sample.figures["deviation"] = deviation / judged;
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> encounterScenes() {
    return {{"lanes", runLanes, 3.0}, {"everyday", runEveryday, 0.1}};
}

}  // namespace muster
