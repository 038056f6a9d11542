// X7 (paper fig. 8a): a net, open ground and a pool in three lanes; the crowd divides as its mesh lies.
#include <cmath>

#include "engine/formation/places/place_tracker.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/ground_watch.h"
#include "lab/reproduce/experiments/lane_watch.h"

namespace muster {
namespace {

// Position along x of the entrance line, 1 m before the lanes begin [m].
constexpr double kLanesEntrance = -6.0;
// Position along x of the middle of the lanes, at which each character has taken one [m].
constexpr double kLanesMiddle = 0.0;
constexpr double kLanesEnd = 5.0;     // Position along x of the end of the lanes [m].
constexpr double kLowerShift = -1.5;  // Shift of the lower gesture along y [m].
constexpr double kLanesJitter = 0.8;  // Greatest displacement of a start [m].
constexpr double kLanesHand = 0.4;    // Greatest shift of the hand [m].
// Distance to the spot on the mesh within which a character is in its place [m].
constexpr double kInPlaceReach = 0.5;
constexpr double kLanesLongest = 40.0;  // Longest time after the last gesture [s].
constexpr MotionId kLanesCrawl = 3;
constexpr MotionId kLanesSwim = 4;

enum Lane : std::int32_t { kPoolLane, kOpenLane, kNetLane };

std::vector<double> hedges() {
    return {-2.0, 2.0};
}

class ThreePathsExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X7",
            "Three paths",
            "Figure 8a: a net to crawl under, open ground and a pool to swim lie side by side. A basic "
            "multitouch gesture lays the mesh over them; the characters fit into the paths as the formation "
            "lies.",
            "A square of 36 is drawn over the three lanes by four fingers. Held places are looked at on the "
            "entrance line, 1 m before the lanes; the lanes taken at x = 0, in their middle. The same "
            "gesture "
            "is also made 1.5 m lower. Whole again means that everybody is within 0.5 m of the spot on the "
            "mesh "
            "where its place is bound for: the travelling place itself may lag behind. It counts from when "
            "the "
            "last has left the lanes. Seeds move starts by up to 0.8 m and the hand by up to 0.4 m.",
            "x07-three-paths",
            "The split is that of the mesh: drawn lower, one row moves from the net to the pool. Nobody "
            "leaves "
            "a slow lane for the open one, because its place lies beyond the hedge. The mesh waits for those "
            "who crawl."};
    }
    std::vector<Arm> arms() const override {
        return {{"middle", "Drawn along the middle"},
                {"middle", "Drawn along the middle", "paper"},
                {"lower", "Drawn 1.5 m lower"},
                {"lower", "Drawn 1.5 m lower", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"kept", "took the lane of the place held on the entrance line", "%", 1},
                {"net", "characters through the net", "", 0},
                {"open", "characters through the open lane", "", 0},
                {"pool", "characters through the pool", "", 0},
                {"motions", "lanes' motions wrong: crawled less through the net, swam less through the pool",
                 "", 0},
                {"lanes", "the last leaves the lanes", "s", 1},
                {"whole", "whole again after that", "s", 2},
                {"swaps", "changes of place per character and second", "1/s", 3}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;
};

/// The lane of each character's place when it reaches the entrance line, and the lane that it then takes.
class PathWatch {
public:
    explicit PathWatch(const World& world)
        : entrance_(kLanesEntrance, hedges(), world),
          middle_(kLanesMiddle, hedges(), world),
          end_(kLanesEnd, hedges(), world),
          held_(world.characters().size(), -1) {}

    void observe(const World& world) {
        entrance_.observe(world);
        middle_.observe(world);
        end_.observe(world);
        const CharactersView characters = world.characters();
        const PlaceTracker& places = inspect::places(world, 0);
        for (const std::size_t i : entrance_.crossedNow()) {
            const std::int32_t place = characters.place[i];
            held_[i] = place < 0 ? -1 : entrance_.laneAt(places.positions()[place].y);
        }
        // An earlier moment does not count if a character fell behind again.
        whole_ = !inPlace(world) ? -1.0 : whole_ < 0.0 ? world.time() : whole_;
    }
    double kept() const {
        std::int32_t same = 0;
        for (std::size_t i = 0; i < held_.size(); ++i)
            same += held_[i] >= 0 && held_[i] == middle_.lanes()[i] ? 1 : 0;
        return 100.0 * same / static_cast<double>(held_.size());
    }
    std::int32_t count(Lane lane) const { return middle_.count(lane); }
    double left() const { return end_.lastCrossing(); }
    double whole() const { return whole_ < 0.0 ? std::nan("") : std::max(0.0, whole_ - left()); }

private:
    static bool inPlace(const World& world) {
        const CharactersView characters = world.characters();
        const std::span<const Vec2> targets = world.group(0).placeTargets;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const std::int32_t place = characters.place[i];
            if (place < 0) return false;
            if (distance(characters.position[i], targets[place]) > kInPlaceReach) return false;
        }
        return true;
    }

    LaneWatch entrance_;
    LaneWatch middle_;
    LaneWatch end_;
    std::vector<std::int32_t> held_;
    double whole_ = -1.0;
};

Result<RunSample> ThreePathsExperiment::run(const RunRequest& request) const {
    auto trial = ExperimentTrial::open(request, {.scenario = "x07-three-paths", .jitter = kLanesJitter});
    if (!trial.ok()) return trial.status();
    if (request.arm.id == "lower") trial->shift({0.0, kLowerShift});
    jitterHand(trial->commands(), request.seed, kLanesHand);
    if (Status s = trial->start(); !s.ok()) return s;
    PathWatch paths(trial->world());
    GroundWatch ground(trial->world());
    const auto watch = [&] {
        paths.observe(trial->world());
        ground.observe(trial->world());
    };
    const auto shoot = [&](double x, const char* caption) {
        trial->picture().view = Box{{x - 11.0, -8.5}, {x + 11.0, 8.5}};
        trial->shoot(caption);
    };
    trial->runUntil(5.0, watch);
    shoot(-6.0, "the mesh comes to the lanes");
    trial->runUntil(12.0, watch);
    shoot(0.0, "parted: some crawl, some run, some swim");
    trial->runUntil(20.0, watch);
    shoot(4.0, "the mesh waits for the slow");
    trial->runUntilSettled(kLanesLongest, watch);
    shoot(10.0, "whole again");
    RunSample sample;
    trial->report(sample);
    const std::int32_t net = paths.count(kNetLane), pool = paths.count(kPoolLane);
    const std::int32_t wrong = std::abs(ground.visitors(kLanesCrawl) - net) +
                               std::abs(ground.visitors(kLanesSwim) - pool);
    sample.figures["kept"] = paths.kept();
    sample.figures["net"] = net;
    sample.figures["open"] = paths.count(kOpenLane);
    sample.figures["pool"] = pool;
    sample.figures["motions"] = wrong;
    sample.figures["lanes"] = paths.left();
    sample.figures["whole"] = paths.whole();
    return sample;
}

void ThreePathsExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const std::string preset : {"muster", "paper"}) {
        for (const std::string arm : {"middle", "lower"}) {
            const std::string drawn = arm == "middle" ? "drawn along the middle: " : "drawn lower: ";
            const auto values = [&](const char* figure) { return samples.values(arm, preset, figure); };
            judge.require(
                drawn + "characters that take the lane of the place held on the entrance line, in every seed",
                preset, values("kept"), Aggregate::Lowest, Comparison::AtLeast, 90.0, "%");
            judge.require(drawn + "whole again after the last has left the lanes, in every seed", preset,
                          values("whole"), Aggregate::Highest, Comparison::AtMost, 5.0, "s");
            judge.require(drawn + "all who go through net and pool, and nobody else, crawl and swim", preset,
                          values("motions"), Aggregate::Highest, Comparison::AtMost, 0.0);
        }
        std::vector<double> more = samples.values("lower", preset, "pool");
        const std::vector<double> before = samples.values("middle", preset, "pool");
        for (std::size_t k = 0; k < more.size() && k < before.size(); ++k) more[k] -= before[k];
        judge.require("drawn lower, so many more go through the pool, in every seed", preset, more,
                      Aggregate::Lowest, Comparison::AtLeast, 4.0);
    }
}

}  // namespace

std::unique_ptr<Experiment> makeThreePathsExperiment() {
    return std::make_unique<ThreePathsExperiment>();
}

}  // namespace muster
