// Crowds on stairs: ground on which people are slow. Lengths of stairs are those that a person walks.

#include "base/maths.h"
#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

/// Mean over the frames in which the middle three fifths of people pass.
double meanBetween(const std::vector<double>& series, double from, double to) {
    double sum = 0.0, count = 0.0;
    for (std::size_t f = 0; f < series.size(); ++f) {
        const double time = static_cast<double>(f) / kSightingRate;
        if (time < from || time > to) continue;
        sum += series[f];
        count += 1.0;
    }
    return count > 0.0 ? sum / count : kUnmeasured;
}

/// Variant: the number of people. A room of 8 x 5 m, a corridor of 12 x 2 m, stairs of 3 x 2 m upwards, on
/// which everybody has half of their speed, a landing of 1 m.
Result<VerifySample> runStairJam(const SceneRun& run) {
    const auto count = static_cast<std::int32_t>(numberIn(run.variant));
    Hall hall({boxOf(0, 0, 8, 5), boxOf(8, 1.5, 26, 3.5)});
    hall.exit(boxOf(24, 1.5, 26, 3.5));
    hall.stairs(boxOf(20, 1.5, 23, 3.5), 0.0, 1.0, 1.0);
    PeopleDef people = menOfImo();
    people.upstairs = people.downstairs = 0.5;
    hall.crowd({.starts = scattered(boxOf(0, 0, 8, 5), count, run.seed, 0.25),
                .people = {people},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(400.0);
    const Trajectories all = walk->trajectories();
    const auto door = firstCrossings(crossings(all, uprightLine(8, 1.5, 3.5)), 1);
    const auto foot = firstCrossings(crossings(all, uprightLine(20, 1.5, 3.5)), 1);
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    if (door.size() == static_cast<std::size_t>(count) && foot.size() == door.size()) {
        sample.figures["flow door"] = flowBetween(door, door.size() / 5, door.size() * 4 / 5);
        sample.figures["flow foot"] = flowBetween(foot, foot.size() / 5, foot.size() * 4 / 5);
        // Measured is the time while the corridor is fed: from the first at the foot to the last fifth at the
        // door.
        const double from = foot.front().time, to = door[door.size() * 4 / 5].time;
        for (const auto& [name, left] : {std::pair{"door", 6.0}, {"middle", 12.5}, {"foot", 18.0}}) {
            const auto density = classicDensity(
                all, Region::create(cornersOf(boxOf(left, 1.5, left + 2, 3.5))).value());
            sample.figures[std::string("density ") + name] = meanBetween(density, from, to);
            sample.figures[std::string("early ") + name] = meanBetween(density, from, 0.5 * (from + to));
            sample.figures[std::string("late ") + name] = meanBetween(density, 0.5 * (from + to), to);
            for (std::size_t f = 0; f < density.size(); f += 20)
                sample.curves[std::string("density ") + name].push_back(
                    {static_cast<double>(f) / kSightingRate, density[f]});
        }
    }
    sample.curves["N-t door"] = curveOf(door);
    sample.curves["N-t foot"] = curveOf(foot);
    walk->report(sample, run);
    return sample;
}

/// Points, one per second: density on a box and the mean speed of the persons on it.
std::vector<Vec2> densityAndSpeed(const Trajectories& all, const Box& box) {
    const Region area = Region::create(cornersOf(box)).value();
    const auto speeds = personalSpeeds(all, {.frameStep = 10});
    const auto density = classicDensity(all, area), speed = meanSpeed(all, area, speeds);
    std::vector<Vec2> points;
    for (std::size_t f = 0; f < density.size(); f += 20)
        if (density[f] > 0.0) points.push_back({density[f], speed[f]});
    return points;
}

/// Variant "up" or "down": a room of 10 x 10 m, 2 m of approach, stairs of 5 x 2 m, 2 m of run-off.
Result<VerifySample> runStairDiagram(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 10, 10), boxOf(10, 4, 21, 6)});
    hall.exit(boxOf(19, 4, 21, 6));
    hall.stairs(boxOf(12, 4, 17, 6), run.variant == "up" ? 0.0 : kPi, 1.0, 1.0);
    // Fruin's speeds of persons between 30 and 50 on two stairs: up 0.50 and 0.58, down 0.65 and 0.78 m/s.
    PeopleDef people = adults();
    people.upstairs = 0.54 / 1.34;
    people.downstairs = 0.715 / 1.34;
    hall.crowd({.starts = scattered(boxOf(0, 0, 10, 10), 100, run.seed),
                .people = {people},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(300.0);
    VerifySample sample;
    sample.curves["points"] = densityAndSpeed(walk->trajectories(), boxOf(12, 4, 17, 6));
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

/// Variant: the width of stairs of 4.24 m behind a room of 10 x 8 m.
Result<VerifySample> runStairWidth(const SceneRun& run) {
    const double width = numberIn(run.variant), low = 4.0 - 0.5 * width, high = 4.0 + 0.5 * width;
    Hall hall({boxOf(0, 0, 10, 8), boxOf(10, low, 18, high)});
    hall.exit(boxOf(16.5, low, 18, high));
    hall.stairs(boxOf(11, low, 15.24, high), 0.0, 1.0, 1.0);
    PeopleDef people = menOfImo();
    people.upstairs = 0.5;
    hall.crowd({.starts = scattered(boxOf(0, 0, 10, 8), 100, run.seed),
                .people = {people},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(400.0);
    const auto crossed = firstCrossings(crossings(walk->trajectories(), uprightLine(15.24, low, high)), 1);
    VerifySample sample;
    sample.figures["flow"] = crossed.size() < 100
                                 ? kUnmeasured
                                 : flowBetween(crossed, crossed.size() / 5, crossed.size() * 4 / 5);
    sample.curves["N-t"] = curveOf(crossed);
    walk->report(sample, run);
    return sample;
}

/// A ring of corridors of 20 x 20 m, and a way across it with two stairs of 1.5 x 6 m, unfolded to one floor.
Result<VerifySample> runLayout(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 2, 20), boxOf(18, 0, 20, 20), boxOf(0, 0, 20, 2), boxOf(0, 18, 20, 20),
               boxOf(2, 9.25, 18, 10.75), boxOf(20, 9, 22, 11)});
    hall.exit(boxOf(20.2, 9, 22, 11));
    hall.stairs(boxOf(3, 9.25, 9, 10.75), 0.0, 1.0, 1.0);
    hall.stairs(boxOf(11, 9.25, 17, 10.75), kPi, 1.0, 1.0);
    PeopleDef people = adults();
    people.upstairs = people.downstairs = 0.5;
    hall.crowd(
        {.starts = scattered(boxOf(0, 6, 2, 14), 10, run.seed), .people = {people}, .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(180.0);
    VerifySample sample;
    sample.figures["short"] = static_cast<double>(
        firstCrossings(crossings(walk->trajectories(), uprightLine(10, 9.25, 10.75))).size());
    sample.figures["left"] = static_cast<double>(walk->leavings().size());
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> stairScenes() {
    return {{"stair jam", runStairJam, 4.0},
            {"stair diagram", runStairDiagram, 3.0},
            {"stair width", runStairWidth, 3.0},
            {"layout", runLayout, 0.4}};
}

}  // namespace muster
