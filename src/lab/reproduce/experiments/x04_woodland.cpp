// X4 (paper fig. 7a): through dense woodland, ducking under branches.
#include <cmath>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/ground_watch.h"

namespace muster {
namespace {

constexpr MotionId kRun = 0;
constexpr MotionId kDuck = 2;
constexpr double kWoodBegins = -10.7;  // Both ends of the wood along x, between which all branches hang [m].
constexpr double kWoodEnds = 11.7;
// Distance of starts from their places, large enough to matter for more than a moment [m].
constexpr double kWoodlandJitter = 1.5;
constexpr double kWoodlandHand = 0.5;      // Greatest shift of the hand [m].
constexpr double kWoodlandLongest = 60.0;  // Longest time after the last gesture [s].

class WoodlandExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X4",
            "Dense woodland",
            "Figure 7a: a crowd goes through woodland. Trees are small obstacles; their branches overlap and "
            "are patches of the ducking motion. The characters fit through the gaps and are slower there.",
            "74 trees at least 2 m apart, each under branches of 1.2 to 1.55 m radius, fill the world from "
            "edge to edge over 22 m. Four fingers draw a square of 36 through the wood, faster than one can "
            "duck. Speed is the way that all of them walked under branches over the time they were there, "
            "from positions, all waiting and walking round trunks included. By the seed starts are moved by "
            "up to 1.5 m, and the hand, which begins at once, draws up to 0.5 m aside. The same wood without "
            "branches is compared.",
            "x04-woodland",
            "Who ducks walks at the patch's speed nearly all the time: the mesh gets ahead, waits by the "
            "opposing force, and the crowd keeps moving. Few steps are lost at the trunks. Without branches "
            "the hand sets the pace, so the ratio of the crossing times is the least there can be. The paper "
            "gives no numbers here; the limits are ours."};
    }
    std::vector<Arm> arms() const override {
        return {{"branches", "With branches"},
                {"branches", "With branches", "paper"},
                {"bare", "Without branches"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"through", "characters through the wood", "", 0},
                {"duckers", "characters that ducked", "", 0},
                {"speed", "mean speed under branches", "m/s", 3},
                {"ratio", "mean speed under branches over the patches' speed", "", 3},
                {"openSpeed", "mean speed between branches, within the wood", "m/s", 3},
                {"notDucking", "time under branches without the motion id of ducking", "%", 2},
                {"crossing", "first one in to last one out", "s", 1},
                {"swaps", "changes of place per character and second", "1/s", 3},
                {"stuck", "stuck", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;
};

/// Times at which the first character entered the wood and the last left it [s].
struct Crossing {
    double begins = -1.0;
    double ends = -1.0;
    std::int32_t through = 0;

    void observe(const World& world) {
        const std::span<const Vec2> positions = world.characters().position;
        through = 0;
        for (const Vec2 p : positions) {
            if (begins < 0.0 && p.x > kWoodBegins) begins = world.time();
            through += p.x > kWoodEnds ? 1 : 0;
        }
        if (ends < 0.0 && through == static_cast<std::int32_t>(positions.size())) ends = world.time();
    }
};

/// Length [m] and time [s] of walking within the wood but not under branches.
struct Between {
    std::vector<Vec2> last;
    double metres = 0.0;
    double seconds = 0.0;

    void observe(const World& world) {
        const std::span<const Vec2> now = world.characters().position;
        for (std::size_t i = 0; i < last.size(); ++i) {
            const bool within = now[i].x > kWoodBegins && now[i].x < kWoodEnds;
            if (!within || inspect::environment(world).ground(now[i]).motion != kRun) continue;
            metres += distance(now[i], last[i]);
            seconds += world.parameters().stepTime;
        }
        last.assign(now.begin(), now.end());
    }
};

Result<RunSample> WoodlandExperiment::run(const RunRequest& request) const {
    auto trial = ExperimentTrial::open(request, {.scenario = "x04-woodland", .jitter = kWoodlandJitter});
    if (!trial.ok()) return trial.status();
    const bool bare = request.arm.id == "bare";
    if (bare) trial->def().patches.clear();
    jitterHand(trial->commands(), request.seed, kWoodlandHand);
    if (Status s = trial->start(); !s.ok()) return s;
    GroundWatch ground(trial->world());
    Crossing crossing;
    Between between;
    const auto shoot = [&](double x, const char* caption) {
        trial->picture().view = Box{{x - 9.0, -7.0}, {x + 9.0, 7.0}};
        trial->shoot(caption);
    };
    const auto watch = [&] {
        ground.observe(trial->world());
        crossing.observe(trial->world());
        between.observe(trial->world());
    };
    trial->runUntil(4.0, watch);
    shoot(-10.0, "the square comes to the wood");
    trial->runUntil(13.0, watch);
    shoot(-4.0, bare ? "among the trunks, upright" : "among the trunks, ducking; the mesh gets ahead");
    trial->runUntil(25.0, watch);
    shoot(7.0, bare ? "most are nearly through" : "the first are nearly through");
    trial->runUntilSettled(kWoodlandLongest, watch);
    shoot(12.5, "all through, a square again");
    RunSample sample;
    trial->report(sample);
    sample.figures["through"] = crossing.through;
    sample.figures["openSpeed"] = between.metres / between.seconds;
    sample.figures["crossing"] = crossing.ends < 0.0 ? std::nan("") : crossing.ends - crossing.begins;
    if (bare) return sample;
    const double limit = trial->def().clips[kDuck].speed * trial->world().parameters().character.maxSpeed;
    sample.figures["duckers"] = ground.visitors(kDuck);
    sample.figures["speed"] = ground.speed(kDuck);
    sample.figures["ratio"] = ground.speed(kDuck) / limit;
    sample.figures["notDucking"] = 100.0 * ground.wrongShare(kDuck);
    return sample;
}

void WoodlandExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const std::string preset : {"muster", "paper"}) {
        const auto values = [&](const char* figure) { return samples.values("branches", preset, figure); };
        judge.require("36 of 36 through the woodland in every seed", preset, values("through"),
                      Aggregate::Lowest, Comparison::AtLeast, 36.0);
        std::vector<double> off;
        for (const double ratio : values("ratio")) off.push_back(100.0 * std::fabs(ratio - 1.0));
        judge.require("mean speed under branches is within 10 % of the patches' travel speed in every seed",
                      preset, off, Aggregate::Highest, Comparison::AtMost, 10.0, "%");
        judge.require("mean speed under branches over that between them, within the wood, in every seed",
                      preset, ratios(values("speed"), values("openSpeed")), Aggregate::Highest,
                      Comparison::AtMost, 0.75);
        judge.require("all 36 duck in every seed", preset, values("duckers"), Aggregate::Lowest,
                      Comparison::AtLeast, 36.0);
        judge.require("under branches the motion id is ducking all the time in every seed", preset,
                      values("notDucking"), Aggregate::Highest, Comparison::AtMost, 0.0, "%");
        judge.require("nobody is stuck in any seed", preset, values("stuck"), Aggregate::Highest,
                      Comparison::AtMost, 0.0);
    }
    judge.require("crossing time with branches over that without", "muster",
                  ratios(samples.values("branches", "muster", "crossing"),
                         samples.values("bare", "muster", "crossing")),
                  Aggregate::Lowest, Comparison::AtLeast, 1.2);
}

}  // namespace

std::unique_ptr<Experiment> makeWoodlandExperiment() {
    return std::make_unique<WoodlandExperiment>();
}

}  // namespace muster
