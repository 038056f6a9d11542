// Rooms with exits, and two rooms whose people change places.
#include <algorithm>
#include <set>

#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

/// Variant "free" or "capped": whether the exit lets at most 1.33 persons through in a second. A room of
/// 8 x 5 m with an exit of 1 m.
Result<VerifySample> runExitFlow(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 8, 5), boxOf(8, 2, 10, 3)});
    hall.exit(boxOf(8.2, 2, 10, 3), "Exit", run.variant == "capped" ? 1.33 : 0.0);
    hall.crowd({.starts = scattered(boxOf(0, 0, 8, 5), 100, run.seed),
                .people = {menOfImo()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(300.0);
    VerifySample sample;
    const auto& all = walk->leavings();
    sample.figures["left"] = static_cast<double>(all.size());
    sample.figures["flow"] = all.size() < 100
                                 ? kUnmeasured
                                 : static_cast<double>(all.size() - 1) / (all.back().time - all.front().time);
    sample.curves["N-t"] = walk->evacuation();
    walk->report(sample, run);
    return sample;
}

/// Variant: number of persons that come the other way. Two rooms of 10 x 10 m joined by a corridor of 10 x 2
/// m.
Result<VerifySample> runCounterflow(const SceneRun& run) {
    const auto others = static_cast<std::int32_t>(numberIn(run.variant));
    Hall hall({boxOf(0, 0, 10, 10), boxOf(10, 4, 20, 6), boxOf(20, 0, 30, 10)});
    const AreaId left = hall.exit(boxOf(0, 0, 1, 10), "Left"),
                 right = hall.exit(boxOf(29, 0, 30, 10), "Right");
    hall.crowd({.name = "Left to right",
                .starts = scattered(boxOf(1, 0, 10, 10), 100, run.seed),
                .people = {menOfImo()},
                .order = Order::leave({right})});
    if (others > 0)
        hall.crowd({.name = "Right to left",
                    .starts = scattered(boxOf(20, 0, 29, 10), others, run.seed + 1000),
                    .people = {menOfImo()},
                    .order = Order::leave({left})});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    std::set<std::uint32_t> fromLeft;
    const CharactersView persons = walk->world().characters();
    for (std::size_t i = 0; i < persons.size(); ++i)
        if (persons.group[i] == 0) fromLeft.insert(persons.id[i]);
    walk->runUntil(420.0);
    auto entered = firstCrossings(crossings(walk->trajectories(), uprightLine(20, 4, 6)), 1);
    std::erase_if(entered, [&](const Crossing& c) { return !fromLeft.contains(c.id); });
    VerifySample sample;
    sample.figures["entered"] = static_cast<double>(entered.size());
    sample.figures["time"] = entered.size() < 100 ? kUnmeasured : entered.back().time;
    sample.curves["N-t"] = curveOf(entered);
    walk->report(sample, run);
    return sample;
}

/// Variant "4" or "2": number of open doors. 1000 people in a room of 30 x 20 m.
Result<VerifySample> runPublicRoom(const SceneRun& run) {
    std::vector<Box> rooms{boxOf(0, 0, 30, 20)};
    const std::vector<Box> doors{boxOf(4, -1.5, 5, 0), boxOf(25, -1.5, 26, 0), boxOf(4, 20, 5, 21.5),
                                 boxOf(25, 20, 26, 21.5)};
    const std::size_t first = run.variant == "2" ? 2 : 0;
    rooms.insert(rooms.end(), doors.begin() + static_cast<std::ptrdiff_t>(first), doors.end());
    Hall hall(rooms);
    for (std::size_t k = first; k < doors.size(); ++k)
        hall.exit(k < 2 ? boxOf(doors[k].min.x, -1.5, doors[k].max.x, -0.2)
                        : boxOf(doors[k].min.x, 20.2, doors[k].max.x, 21.5));
    hall.crowd({.starts = scattered(boxOf(2, 2, 28, 18), 1000, run.seed, 0.0),
                .people = {menOfImo()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(600.0);
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    sample.figures["left"] = static_cast<double>(walk->leavings().size());
    sample.curves["N-t"] = walk->evacuation();
    walk->report(sample, run);
    return sample;
}

/// Variant "44", "corner" or "75.4": length that 500 people walk straight on, or round a corner.
Result<VerifySample> runWideCorner(const SceneRun& run) {
    const bool corner = run.variant == "corner";
    // The start area is 6 m deep; lengths are counted from its front edge. The corner begins 34 m from there
    // and ends 10 m after its inner edge.
    const double length = corner ? 60.0 : 8.0 + numberIn(run.variant);
    std::vector<Box> rooms{boxOf(0, 0, length, 20)};
    if (corner) rooms.push_back(boxOf(40, -12, 60, 20));
    Hall hall(rooms);
    hall.exit(corner ? boxOf(40, -12, 60, -10) : boxOf(length - 2, 0, length, 20));
    hall.crowd({.starts = scattered(boxOf(0, 0, 6, 20), 500, run.seed, 0.25),
                .people = {adults()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(300.0);
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    sample.curves["N-t"] = walk->evacuation();
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> roomScenes() {
    return {{"exit flow", runExitFlow, 2.0},
            {"counterflow", runCounterflow, 5.0},
            {"public room", runPublicRoom, 30.0},
            {"wide corner", runWideCorner, 6.0}};
}

}  // namespace muster
