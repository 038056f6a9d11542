// One person or some, each alone: speeds, stairs, premovement, corners, demographics.
#include <algorithm>
#include <cmath>

#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

constexpr double kAscent = 0.0;  // Heading of stairs, which go up towards +x in all scenes [rad].

/// Time between two lines, for one person.
double timeBetween(const Trajectories& all, Line from, Line to) {
    const auto first = crossings(all, from), last = crossings(all, to);
    return first.empty() || last.empty() ? kUnmeasured : last.front().time - first.front().time;
}

/// Variant: the speed. A corridor of 2 m with 10 m before and behind the measured 40 m.
Result<VerifySample> runCorridor(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 60, 2)});
    hall.exit(boxOf(58, 0, 60, 2));
    hall.crowd({.starts = {{1.0, 1.0}},
                .people = {personsOf(Distribution::constant(numberIn(run.variant)))},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(120.0);
    VerifySample sample;
    const Trajectories all = walk->trajectories();
    sample.figures["time"] = timeBetween(all, uprightLine(11, 0, 2), uprightLine(51, 0, 2));
    const auto end = crossings(all, uprightLine(41, 0, 2));
    sample.figures["fromRest"] = end.empty() ? kUnmeasured : end.front().time;
    walk->report(sample, run);
    return sample;
}

/// Variant: "up 1.0 10 0.5": direction, speed on the flat, length of the stairs, share of it on them.
Result<VerifySample> runFreeStairs(const SceneRun& run) {
    const bool up = wordIn(run.variant, 0) == "up";
    const double speed = numberIn(wordIn(run.variant, 1)), length = numberIn(wordIn(run.variant, 2));
    const double share = numberIn(wordIn(run.variant, 3)), end = 20.0 + length;
    Hall hall({boxOf(0, 0, end, 2)});
    hall.exit(up ? boxOf(end - 2, 0, end, 2) : boxOf(0, 0, 2, 2));
    hall.stairs(boxOf(10, 0, 10 + length, 2), kAscent, 1.0, 1.0);
    PeopleDef person = personsOf(Distribution::constant(speed));
    person.upstairs = person.downstairs = share;
    hall.crowd({.starts = {{up ? 1.0 : end - 1.0, 1.0}}, .people = {person}, .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(60.0 + 1.5 * length / (speed * share));
    const Line foot = uprightLine(10, 0, 2), head = uprightLine(10 + length, 0, 2);
    VerifySample sample;
    sample.figures["time"] = timeBetween(walk->trajectories(), up ? foot : head, up ? head : foot);
    sample.figures["speed"] = length / sample.figures["time"];
    walk->report(sample, run);
    return sample;
}

Distribution spreadNamed(const std::string& name) {
    if (name == "gamma") return {Spread::Gamma, 1.291, 103.901, 0.0, 1e7};
    if (name == "lognormal") return {Spread::LogNormal, 4.586, 0.967, 0.0, 1e7};
    if (name == "weibull") return {Spread::Weibull, 139.285, 1.195, 0.0, 1e7};
    if (name == "normal") return Distribution::normal(60.0, 20.0, 0.0, 1e7);
    return Distribution::uniform(10.0, 100.0);
}

/// Times at which persons set out: a person sets out when it first walks at half of its own top speed, over a
/// quarter of a second. A person that is pushed from its spot by more than 5 cm before its time counts as
/// pushed.
class FirstMoves {
public:
    explicit FirstMoves(const World& world) {
        const CharactersView all = world.characters();
        for (std::size_t i = 0; i < all.size(); ++i)
            persons_.push_back({all.id[i], all.position[i], all.position[i], all.body[i].premovement,
                                0.5 * all.body[i].maxSpeed, kUnmeasured, false});
    }
    void observe(const World& world) {
        const bool due = world.stepCount() % kStride == 0;
        const double seconds = kStride * world.parameters().stepTime;
        const CharactersView all = world.characters();
        for (std::size_t i = 0; i < all.size(); ++i)
            for (Person& person : persons_) {
                if (person.id != all.id[i] || !std::isnan(person.moved)) continue;
                const Vec2 now = all.position[i];
                if (world.time() < person.assigned && distance(person.start, now) > 0.05)
                    person.pushed = true;
                if (!due) continue;
                if (distance(person.before, now) > person.enough * seconds)
                    person.moved = world.time() - seconds;
                person.before = now;
            }
    }
    bool all() const {
        return std::none_of(persons_.begin(), persons_.end(),
                            [](const Person& p) { return std::isnan(p.moved); });
    }
    /// Points of the assigned time and the time of setting out.
    std::vector<Vec2> curve() const {
        std::vector<Vec2> points;
        for (const Person& person : persons_) points.push_back({person.assigned, person.moved});
        return points;
    }
    double pushed() const {
        return static_cast<double>(
            std::count_if(persons_.begin(), persons_.end(), [](const Person& p) { return p.pushed; }));
    }

private:
    static constexpr std::uint32_t kStride = 15;  // Number of steps between two observations.
    struct Person {
        std::uint32_t id;
        Vec2 start, before;
        double assigned, enough, moved;
        bool pushed;
    };
    std::vector<Person> persons_;
};

/// Variant: the distribution of premovement times. A room of 8 x 5 m with one exit in the middle of a short
/// wall.
Result<VerifySample> runPremovement(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 8, 5), boxOf(8, 2, 9.5, 3)});
    hall.exit(boxOf(8.2, 2, 9.5, 3));
    PeopleDef people = menOfImo();
    people.premovement = spreadNamed(run.variant);
    hall.crowd({.starts = scattered(boxOf(0, 0, 8, 5), 10, run.seed, 0.6),
                .people = {people},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    FirstMoves moves(walk->world());
    while (!moves.all() && walk->time() < 2000.0)
        walk->runUntil(walk->time() + 1.0, [&] { moves.observe(walk->world()); });
    VerifySample sample;
    double early = 0.0, late = 0.0;
    for (const Vec2 p : moves.curve()) {
        early = std::max(early, p.x - p.y);
        late = std::max(late, std::isnan(p.y) ? 1e9 : p.y - p.x);
    }
    sample.figures["pushed"] = moves.pushed();
    sample.figures["early"] = early;
    sample.figures["late"] = late;
    sample.figures["worst"] = std::max(early, late);
    sample.curves["starts"] = moves.curve();
    walk->report(sample, run);
    return sample;
}

/// Twenty round a corner of 2 m; variant: the distribution of speeds.
Result<VerifySample> runCorner(const SceneRun& run) {
    Hall hall({boxOf(0, 0, 12, 2), boxOf(10, 0, 12, 12)});
    hall.exit(boxOf(10, 11, 12, 12));
    const bool equal = run.variant == "1.0";
    hall.crowd({.starts = scattered(boxOf(0, 0, 6, 2), 20, run.seed),
                .people = {equal ? personsOf(Distribution::constant(1.0)) : adults()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(120.0);
    VerifySample sample;
    sample.figures["left"] = static_cast<double>(walk->leavings().size());
    sample.figures["outside"] = walk->outside();
    sample.figures["time"] = walk->lastLeaving();
    walk->report(sample, run);
    return sample;
}

std::vector<PeopleDef> sortsNamed(const std::string& name) {
    if (name == "men") return {menOfImo()};
    if (name == "normal") return {personsOf(Distribution::normal(1.2, 0.2, 0.3, 2.2))};
    std::vector<PeopleDef> sorts;
    for (const auto& [age, share] :
         {std::pair{20.0, 10.0}, {30.0, 10.0}, {40.0, 10.0}, {50.0, 10.0}, {60.0, 5.0}, {70.0, 5.0}}) {
        sorts.push_back({.name = std::to_string(static_cast<int>(age)),
                         .share = share,
                         .age = Distribution::constant(age)});
    }
    return sorts;
}

/// Variant "ages", "men" or "normal": number and kind of persons. Each walks 50 m on a corridor of its own.
Result<VerifySample> runDemographics(const SceneRun& run) {
    const std::int32_t count = run.variant == "normal" ? 100 : 50;
    Hall hall({boxOf(0, 0, 70, count)});
    hall.exit(boxOf(68, 0, 70, count));
    CrowdDef crowd{.people = sortsNamed(run.variant), .order = Order::leave()};
    for (std::int32_t i = 0; i < count; ++i) crowd.starts.push_back({1.0, i + 0.5});
    hall.crowd(crowd);
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    VerifySample sample;
    const CharactersView persons = walk->world().characters();
    std::map<std::uint32_t, double> assigned;
    for (std::size_t i = 0; i < persons.size(); ++i) assigned[persons.id[i]] = persons.body[i].maxSpeed;
    walk->runUntil(300.0);
    const Trajectories all = walk->trajectories();
    const auto from = firstCrossings(crossings(all, uprightLine(10, 0, count)));
    const auto to = firstCrossings(crossings(all, uprightLine(60, 0, count)));
    for (const Crossing& start : from)
        for (const Crossing& end : to)
            if (start.id == end.id)
                sample.curves["speeds"].push_back(
                    {assigned[start.id], distance(start.point, end.point) / (end.time - start.time)});
    std::sort(sample.curves["speeds"].begin(), sample.curves["speeds"].end(),
              [](Vec2 a, Vec2 b) { return a.y < b.y; });
    sample.figures["measured"] = static_cast<double>(sample.curves["speeds"].size());
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> freeWalkScenes() {
    return {{"corridor", runCorridor, 0.1},
            {"free stairs", runFreeStairs, 0.1},
            {"premovement", runPremovement, 1.0},
            {"corner", runCorner, 0.3},
            {"demographics", runDemographics, 1.0}};
}

}  // namespace muster
