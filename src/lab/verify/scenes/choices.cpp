// Exits that are assigned, chosen or shut, groups that keep together, slow persons.
#include <algorithm>
#include <set>

#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

// Twelve rooms on both sides of a corridor (FDS+Evac, CompTest10): their left and right sides, and their
// doors.
struct CabinRoom {
    double left, right, door;
};
constexpr CabinRoom kUpperRooms[] = {{0.0, 2.95, 1.0},    {3.05, 5.9, 4.0},     {7.3, 8.95, 7.7},
                                     {9.05, 11.95, 10.0}, {12.05, 14.95, 13.0}, {15.05, 18.0, 16.0}};
constexpr CabinRoom kLowerRooms[] = {{0.0, 2.95, 1.0},    {3.05, 5.95, 4.0},    {6.05, 8.95, 7.0},
                                     {9.05, 11.95, 10.0}, {12.05, 14.95, 13.0}, {15.05, 18.0, 16.0}};

struct Cabins {
    std::vector<Box> rooms{boxOf(0, 5, 19.5, 6), boxOf(6, 6, 7.2, 12.5)};
    std::vector<Vec2> toMain, toSecond;

    Cabins() {
        for (int i = 0; i < 6; ++i) {
            add(kUpperRooms[i], true, i == 2, i != 4 && i != 5);
            add(kLowerRooms[i], false, false, i != 4 && i != 5);
        }
    }
    void add(const CabinRoom& room, bool upper, bool single, bool main) {
        rooms.push_back(upper ? boxOf(room.left, 6.1, room.right, 11) : boxOf(room.left, 0, room.right, 4.9));
        rooms.push_back(boxOf(room.door, upper ? 6.0 : 4.9, room.door + 0.9, upper ? 6.1 : 5.0));
        std::vector<Vec2>& all = main ? toMain : toSecond;
        const double x = 0.5 * (room.left + room.right), y = upper ? 8.8 : 2.2;
        all.push_back({single ? x : x - 0.5, y});
        if (!single) all.push_back({x + 0.5, y});
    }
};

/// Rooms 1 to 4 and 7 to 10 leave by the main exit, the others by the end of the corridor.
Result<VerifySample> runCabins(const SceneRun& run) {
    const Cabins cabins;
    Hall hall(cabins.rooms);
    const AreaId main = hall.exit(boxOf(6, 11, 7.2, 12.5), "Main"),
                 second = hall.exit(boxOf(18, 5, 19.5, 6), "Second");
    hall.crowd(
        {.name = "Main", .starts = cabins.toMain, .people = {menOfImo()}, .order = Order::leave({main})});
    hall.crowd({.name = "Second",
                .starts = cabins.toSecond,
                .people = {menOfImo()},
                .order = Order::leave({second})});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    std::set<std::uint32_t> forMain;
    const CharactersView persons = walk->world().characters();
    for (std::size_t i = 0; i < persons.size(); ++i)
        if (persons.group[i] == 0) forMain.insert(persons.id[i]);
    walk->runUntil(180.0);
    VerifySample sample;
    double right = 0.0;
    for (const Leaving& leaving : walk->leavings())
        if (forMain.contains(leaving.id) == (leaving.area == main)) right += 1.0;
    sample.figures["right"] = right;
    sample.figures["left"] = static_cast<double>(walk->leavings().size());
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

double shareBy(const std::vector<Leaving>& all, AreaId area) {
    const auto by = std::count_if(all.begin(), all.end(),
                                  [area](const Leaving& l) { return l.area == area; });
    return all.empty() ? kUnmeasured : static_cast<double>(by) / static_cast<double>(all.size());
}

/// 1000 people in the left part of a room, two exits in its upper wall, both right of them.
Result<VerifySample> runExitChoice(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 30, 20), boxOf(21, 20, 22, 21.5), boxOf(27, 20, 28, 21.5)});
    const AreaId near = hall.exit(boxOf(21, 20.2, 22, 21.5), "Near"),
                 far = hall.exit(boxOf(27, 20.2, 28, 21.5), "Far");
    hall.crowd({.starts = scattered(boxOf(2, 2, 15.5, 18), 1000, run.seed, 0.0),
                .people = {adults()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(700.0);
    VerifySample sample;
    const double left = static_cast<double>(walk->leavings().size());
    sample.figures["near"] = shareBy(walk->leavings(), near) * left;
    sample.figures["far"] = shareBy(walk->leavings(), far) * left;
    sample.figures["time"] = walk->lastLeaving();
    sample.curves["N-t"] = walk->evacuation();
    walk->report(sample, run);
    return sample;
}

// A room of 10 x 12 m with an exit in each of its far corners.
struct TwoExits {
    Hall hall{std::vector<Box>{boxOf(0, 0, 10, 12), boxOf(0, 12, 1.2, 13.5), boxOf(8.8, 12, 10, 13.5)}};
    AreaId left = hall.exit(boxOf(0, 12.2, 1.2, 13.5), "Exit 1");
    AreaId right = hall.exit(boxOf(8.8, 12.2, 10, 13.5), "Exit 2");
};

/// Variant "without" or "with": two persons who are free to choose, and a third who is bound to exit 2. Each
/// follows others by as many seconds as `herding` says.
Result<VerifySample> runSocial(const SceneRun& run) {
    TwoExits two;
    Order order = Order::leave();
    order.herding = 5.0;
    order.misjudgement = 2.0;
    two.hall.crowd(
        {.name = "Free", .starts = {{4.6, 1.5}, {5.4, 1.5}}, .people = {adults()}, .order = order});
    if (run.variant == "with")
        two.hall.crowd({.name = "Bound",
                        .starts = {{5.0, 2.4}},
                        .people = {adults()},
                        .order = Order::leave({two.right})});
    auto walk = HallRun::start(two.hall, run.seed);
    if (!walk.ok()) return walk.status();
    std::set<std::uint32_t> isFree;
    const CharactersView persons = walk->world().characters();
    for (std::size_t i = 0; i < persons.size(); ++i)
        if (persons.group[i] == 0) isFree.insert(persons.id[i]);
    walk->runUntil(60.0);
    double byRight = 0.0;
    for (const Leaving& leaving : walk->leavings())
        if (isFree.contains(leaving.id) && leaving.area == two.right) byRight += 0.5;
    VerifySample sample;
    sample.figures["share"] = walk->present() > 0 ? kUnmeasured : byRight;
    walk->report(sample, run);
    return sample;
}

/// Variant "none", "left" or "right": the exit that the person knows, by 5 s.
Result<VerifySample> runAffiliation(const SceneRun& run) {
    TwoExits two;
    Order order = Order::leave({two.left, two.right});
    order.misjudgement = 2.0;
    if (run.variant != "none")
        order.attractions = run.variant == "left" ? std::vector<double>{5.0, 0.0}
                                                  : std::vector<double>{0.0, 5.0};
    two.hall.crowd({.starts = {{5.0, 1.5}}, .people = {adults()}, .order = order});
    auto walk = HallRun::start(two.hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(60.0);
    VerifySample sample;
    sample.figures["right"] = shareBy(walk->leavings(), two.right);
    walk->report(sample, run);
    return sample;
}

/// The nearer exit is shut after one second.
Result<VerifySample> runDynamicExit(const SceneRun& run) {
    TwoExits two;
    two.hall.crowd({.starts = {{3.0, 1.5}}, .people = {adults()}, .order = Order::leave()});
    auto walk = HallRun::start(two.hall, run.seed);
    if (!walk.ok()) return walk.status();
    PutThing shut = putThing(two.hall.def.areas[0], two.left);
    shut.area->open = false;
    Command command{.step = 60, .body = shut};
    if (Status s = walk->world().submit(command); !s.ok()) return s;
    VerifySample sample;
    walk->runUntil(1.0);
    sample.figures["first"] = walk->present() > 0 ? walk->world().characters().goal[0] : kUnmeasured;
    walk->runUntil(60.0);
    sample.figures["exit"] = walk->leavings().empty() ? kUnmeasured : walk->leavings()[0].area.value;
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

/// Group 1: four persons of 1.25 m/s and one of 0.5 m/s, who keep together; group 2: ten of 0.2 m/s. Variant:
/// the speed of the second group.
Result<VerifySample> runGroups(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 10, 20), boxOf(4, 20, 6, 22)});
    hall.exit(boxOf(4, 20.2, 6, 22));
    CrowdDef first{.name = "Group 1",
                   .starts = {{4.0, 1.0}, {4.6, 1.0}, {5.2, 1.0}, {5.8, 1.0}, {5.0, 1.7}},
                   .order = Order::leave()};
    first.bodies.assign(5, Body{});
    for (std::size_t i = 0; i < 5; ++i) first.bodies[i].maxSpeed = i == 4 ? 0.5 : 1.25;
    first.conduct.cohesion = 1.0;
    hall.crowd(first);
    hall.crowd({.name = "Group 2",
                .starts = scattered(boxOf(0, 8, 10, 16), 10, run.seed),
                .people = {personsOf(Distribution::constant(numberIn(run.variant)))},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    const CharactersView persons = walk->world().characters();
    std::set<std::uint32_t> inFirst;
    for (std::size_t i = 0; i < persons.size(); ++i)
        if (persons.group[i] == 0) inFirst.insert(persons.id[i]);
    walk->runUntil(240.0);
    std::vector<double> times;
    for (const Leaving& leaving : walk->leavings())
        if (inFirst.contains(leaving.id)) times.push_back(leaving.time);
    VerifySample sample;
    sample.figures["spread"] = times.size() == 5 ? times.back() - times.front() : kUnmeasured;
    sample.figures["last"] = times.size() == 5 ? times.back() : kUnmeasured;
    walk->report(sample, run);
    return sample;
}

/// Variant "slow" or "equal": whether one of 25 persons is slower and larger. A corridor of 1.6 m behind a
/// room.
Result<VerifySample> runSlowOne(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 6, 6), boxOf(6, 2.2, 30, 3.8)});
    hall.exit(boxOf(28, 2.2, 30, 3.8));
    CrowdDef crowd{.starts = scattered(boxOf(0, 0, 5, 6), 25, run.seed, 0.5), .order = Order::leave()};
    // The slow person stands nearest to the corridor.
    std::sort(crowd.starts.begin(), crowd.starts.end(), [](Vec2 a, Vec2 b) {
        return distance(a, {6, 3}) < distance(b, {6, 3});
    });
    crowd.bodies.assign(25, Body{});
    for (Body& body : crowd.bodies) body.radius = 0.2, body.maxSpeed = 1.25;
    if (run.variant == "slow") crowd.bodies[0].radius = 0.4, crowd.bodies[0].maxSpeed = 0.8;
    hall.crowd(crowd);
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(180.0);
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> choiceScenes() {
    return {{"cabins", runCabins, 0.5},
            {"exit choice", runExitChoice, 40.0},
            {"social", runSocial, 0.1},
            {"affiliation", runAffiliation, 0.1},
            {"dynamic exit", runDynamicExit, 0.1},
            {"groups", runGroups, 0.3},
            {"slow one", runSlowOne, 0.3}};
}

}  // namespace muster
