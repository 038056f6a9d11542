// Doors and narrow corridors.
#include <algorithm>
#include <cmath>

#include "lab/measures/series.h"
#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

/// Flow between the first and the last fifth of the persons that cross [1/s]: the jam is there, and still
/// fed.
double middleFlow(const std::vector<Crossing>& crossed) {
    return flowBetween(crossed, crossed.size() / 5, crossed.size() - 1 - crossed.size() / 5);
}

double longestGap(const std::vector<Crossing>& crossed) {
    double longest = 0.0;
    for (std::size_t k = 1; k < crossed.size(); ++k)
        longest = std::max(longest, crossed[k].time - crossed[k - 1].time);
    return longest;
}

/// A run in which adults who are scattered over a box leave the hall; 300 s at most.
Result<HallRun> emptied(Hall& hall, const Box& box, std::int32_t count, std::uint64_t seed,
                        double margin = 0.3) {
    hall.crowd(
        {.starts = scattered(box, count, seed, margin), .people = {adults()}, .order = Order::leave()});
    Result<HallRun> walk = HallRun::start(hall, seed);
    if (walk.ok()) walk->runUntil(300.0);
    return walk;
}

/// Variant: the width of a door, 0.4 m deep, in the wall of a room of 12 m depth and width, from which people
/// flow off freely.
Result<VerifySample> runDoor(const SceneRun& run) {
    const double width = numberIn(run.variant), low = 6.0 - 0.5 * width, high = 6.0 + 0.5 * width;
    const auto count = static_cast<std::int32_t>(std::lround(80.0 + 60.0 * width));
    Hall hall({boxOf(0, 0, 12, 12), boxOf(12, low, 12.4, high), boxOf(12.4, 2, 17, 10)});
    hall.exit(boxOf(15, 2, 17, 10));
    // The jam is there from the beginning: 2.5 people on a square metre before the door.
    const double depth = count / 2.5 / 12.0;
    auto walk = emptied(hall, boxOf(11.5 - depth, 0, 11.5, 12), count, run.seed, 0.25);
    if (!walk.ok()) return walk.status();
    const auto crossed = firstCrossings(crossings(walk->trajectories(), uprightLine(12.2, low, high)), 1);
    VerifySample sample;
    sample.figures["flow"] = crossed.size() + 1 < static_cast<std::size_t>(count) ? kUnmeasured
                                                                                  : middleFlow(crossed);
    sample.figures["specific"] = sample.figures["flow"] / width;
    sample.figures["gap"] = longestGap(crossed);
    sample.curves["N-t"] = curveOf(crossed);
    walk->report(sample, run);
    return sample;
}

/// RiMEA 3.0, 12: 150 people in the left half of a room, a corridor of 5 x 1 m, a second room with an exit of
/// 1 m.
Result<VerifySample> runCorridorBetween(const SceneRun& run) {
    Hall hall(
        {boxOf(0, 0, 10, 10), boxOf(10, 4.5, 15, 5.5), boxOf(15, 0, 25, 10), boxOf(25, 4.5, 26.5, 5.5)});
    hall.exit(boxOf(25.2, 4.5, 26.5, 5.5));
    auto walk = emptied(hall, boxOf(0, 0, 5, 10), 150, run.seed);
    if (!walk.ok()) return walk.status();
    const Trajectories all = walk->trajectories();
    const auto corridor = firstCrossings(crossings(all, uprightLine(12.5, 4.5, 5.5)), 1);
    const auto exit = firstCrossings(crossings(all, uprightLine(25.1, 4.5, 5.5)), 1);
    // Half discs before both passages, as squares of 2 x 4 m.
    const auto peak = [&](const Box& box) {
        const auto density = classicDensity(all, Region::create(cornersOf(box)).value());
        return *std::max_element(density.begin(), density.end()) * box.width() * box.height();
    };
    VerifySample sample;
    sample.figures["corridor"] = middleFlow(corridor);
    sample.figures["exit"] = middleFlow(exit);
    sample.figures["before corridor"] = peak(boxOf(8, 3, 10, 7));
    sample.figures["before exit"] = peak(boxOf(23, 3, 25, 7));
    sample.figures["time"] = walk->lastLeaving();
    sample.curves["N-t corridor"] = curveOf(corridor);
    sample.curves["N-t exit"] = curveOf(exit);
    walk->report(sample, run);
    return sample;
}

/// Variant "distance length width": distance from a bottleneck of that length and width to the exit [m].
Result<VerifySample> runBottleneck(const SceneRun& run) {
    const double away = numberIn(wordIn(run.variant, 0)), length = numberIn(wordIn(run.variant, 1)),
                 width = numberIn(wordIn(run.variant, 2));
    const double low = 5.0 - 0.5 * width, high = 5.0 + 0.5 * width, end = 10.0 + length;
    Hall hall({boxOf(0, 0, 10, 10), boxOf(10, low, end, high), boxOf(end, 0, end + 12, 10)});
    hall.exit(away > 0.0 ? boxOf(end + away, 0, end + 12, 10) : boxOf(end, low, end + 1.0, high));
    auto walk = emptied(hall, boxOf(0, 0, 10, 10), 150, run.seed);
    if (!walk.ok()) return walk.status();
    const auto crossed = firstCrossings(crossings(walk->trajectories(), uprightLine(10.1, low, high)), 1);
    VerifySample sample;
    sample.figures["time"] = crossed.size() < 150 ? kUnmeasured : crossed.back().time;
    sample.figures["flow"] = middleFlow(crossed);
    sample.curves["N-t"] = curveOf(crossed);
    walk->report(sample, run);
    return sample;
}

/// RiMEA 4.1.1, 12c: three rooms, two equal bottlenecks.
Result<VerifySample> runTwoBottlenecks(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 10, 10), boxOf(10, 4.5, 10.2, 5.5), boxOf(10.2, 0, 20.2, 10),
               boxOf(20.2, 4.5, 20.4, 5.5), boxOf(20.4, 0, 25.4, 10)});
    hall.exit(boxOf(24.4, 0, 25.4, 10));
    auto walk = emptied(hall, boxOf(0, 0, 10, 10), 150, run.seed);
    if (!walk.ok()) return walk.status();
    const Trajectories all = walk->trajectories();
    const auto queue = [&](const Box& box) {
        const auto density = classicDensity(all, Region::create(cornersOf(box)).value());
        return smoothed(density, 41);
    };
    VerifySample sample;
    for (const auto& [name, box] : {std::pair{"1", boxOf(7, 2, 10, 8)}, {"2", boxOf(17.2, 2, 20.2, 8)}}) {
        const auto density = queue(box);
        sample.figures[std::string("queue ") + name] = *std::max_element(density.begin(), density.end()) *
                                                       18.0;
        for (std::size_t f = 0; f < density.size(); f += 20)
            sample.curves[std::string("people ") + name].push_back(
                {static_cast<double>(f) / kSightingRate, density[f] * 18.0});
    }
    sample.figures["flow 1"] = middleFlow(firstCrossings(crossings(all, uprightLine(10.1, 4.5, 5.5)), 1));
    sample.figures["flow 2"] = middleFlow(firstCrossings(crossings(all, uprightLine(20.3, 4.5, 5.5)), 1));
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> bottleneckScenes() {
    return {{"door", runDoor, 4.0},
            {"corridor between", runCorridorBetween, 4.0},
            {"bottleneck", runBottleneck, 4.0},
            {"two bottlenecks", runTwoBottlenecks, 5.0}};
}

}  // namespace muster
