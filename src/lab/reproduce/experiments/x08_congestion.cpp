// X8 (paper fig. 8b): a narrow open path between two slow ones; crowding drives some characters to the slow
// ones.
#include <algorithm>
#include <cmath>

#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/lane_watch.h"

namespace muster {
namespace {

constexpr double kAlleyEntrance = -2.0;  // Position along x of the entrance of the alley [m].
// Position along x of the middle of the ways, at which each character has taken one [m].
constexpr double kAlleyMiddle = 0.0;
constexpr double kAlleyHalfWidth = 1.5;  // Half width of the alley about y = 0, the slow ways lie beyond [m].
// Length of the ground before the entrance on which the queue is counted [m].
constexpr double kQueueReach = 4.0;
constexpr double kQueueSpeed = 0.5;  // Speed below which a character in the queue waits [m/s].
// Time after the last gesture at which the run ends [s]. Characters still on their way count as arriving
// then.
constexpr double kAlleyLongest = 30.0;
constexpr double kCurvePeriod = 0.5;  // Time between two points of a curve [s].
constexpr std::int32_t kAlleyLane = 1;

class CongestionExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X8",
            "A crowded way",
            "Figure 8b: the user draws the whole crowd through a narrow open path. Two paths beside it are "
            "slow: one has to climb. When the open path is crowded, some choose the slow ones rather than "
            "wait.",
            "An alley 0.8 m wide and 4 m long between two ways of 2 m with a garden wall across. Four "
            "fingers "
            "press the square of 36 to a strip, draw it through the alley at once and open it again: the "
            "crowd "
            "arrives together and queues. Who takes which way is looked at in the middle of the ways. The "
            "same "
            "is run without density and waits in the cost. Last arrival counts from the last gesture; a run "
            "is cut 30 "
            "s "
            "after it and then counts as 30 s.",
            "x08-congestion",
            "The queue forms in a half circle before the alley. The alley lets three to four a second "
            "through, "
            "so the crowd must come at once to be worth a detour: the scene lets the mesh run ahead "
            "(opposing "
            "force 0.05 per metre, controls and places at up to 4 m/s). All else is the preset's: costs, "
            "densities, plan and the climb's speed. Who goes round is chosen from the waits that are "
            "foreseen (jams); density alone, by the defaults, sends nobody round.\nWithout "
            "density and waits all press at the alley. That everybody gets through at all, without "
            "friction and "
            "noise, is owed to a rule of ours: who is behind does not press on who is held up (movement)."};
    }
    std::vector<Arm> arms() const override {
        return {{"density", "Density and waits in the cost"},
                {"blind", "Without density and waits"},
                {"density", "Density and waits in the cost", "paper"},
                {"blind", "Without density and waits", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"side", "characters that take the slow ways", "%", 1},
                {"last", "last arrival after the last gesture (cut at 30 s)", "s", 1},
                {"through", "characters past the ways", "", 0},
                {"queue", "most that stand before the alley at once", "", 0},
                {"waited", "time that all together stand there", "s", 0},
                {"swaps", "changes of place per character and second", "1/s", 2},
                {"stuck", "stuck", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;
    std::vector<ChartDef> charts(const Samples& samples) const override;
};

/// Characters that stand in front of the alley.
struct Queue {
    std::int32_t most = 0;
    double waited = 0.0;

    void observe(const World& world) {
        const CharactersView characters = world.characters();
        std::int32_t standing = 0;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const double x = characters.position[i].x;
            const bool before = x > kAlleyEntrance - kQueueReach && x < kAlleyEntrance && world.time() > 2.0;
            standing += before && length(characters.velocity[i]) < kQueueSpeed ? 1 : 0;
        }
        most = std::max(most, standing);
        waited += standing * world.parameters().stepTime;
    }
};

Result<RunSample> CongestionExperiment::run(const RunRequest& request) const {
    ExperimentTrialDef def{.scenario = "x08-congestion"};
    if (request.arm.id == "blind") def.settings = {{"density.enabled", 0.0}, {"plan.waits", 0.0}};
    auto trial = ExperimentTrial::open(request, def);
    if (!trial.ok()) return trial.status();
    if (Status s = trial->start(); !s.ok()) return s;
    LaneWatch ways(kAlleyMiddle, {-kAlleyHalfWidth, kAlleyHalfWidth}, trial->world());
    Queue queue;
    RunSample sample;
    std::vector<Vec2>& curve = sample.curves["through"];
    const auto count = [&] { return static_cast<double>(ways.lanes().size()) - ways.count(-1); };
    const auto watch = [&] {
        ways.observe(trial->world());
        queue.observe(trial->world());
        const double due = static_cast<double>(curve.size()) * kCurvePeriod;
        if (trial->time() >= due) curve.push_back({trial->time(), count()});
    };
    trial->picture().view = Box{{-11.0, -6.0}, {11.0, 6.0}};
    trial->runUntil(2.0, watch);
    trial->shoot("the mesh is pressed to a strip");
    trial->runUntil(6.5, watch);
    trial->shoot("drawn through the alley: a queue forms");
    trial->runUntil(9.0, watch);
    trial->shoot(request.arm.id == "blind" ? "everybody waits for the alley"
                                           : "some turn to the garden walls");
    trial->runUntil(13.0, watch);
    trial->shoot("13 s: who is through");
    const bool settled = trial->runUntilSettled(kAlleyLongest, watch);
    trial->picture().view = Box{{-4.0, -6.0}, {18.0, 6.0}};
    trial->shoot(settled ? "all there" : "not all there after 30 s: cut");
    trial->report(sample);
    const double number = static_cast<double>(ways.lanes().size());
    const double arrived = sample.figures["arrived100"];
    sample.figures["side"] = 100.0 * (count() - ways.count(kAlleyLane)) / number;
    sample.figures["last"] = std::isnan(arrived) ? kAlleyLongest : arrived;
    sample.figures["through"] = count();
    sample.figures["queue"] = queue.most;
    sample.figures["waited"] = queue.waited;
    return sample;
}

void CongestionExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const std::string preset : {"muster", "paper"}) {
        judge.require("with density: characters that take the slow ways, in every seed", preset,
                      samples.values("density", preset, "side"), Aggregate::Lowest, Comparison::AtLeast, 10.0,
                      "%");
        judge.require("without density: characters that take the slow ways, in every seed", preset,
                      samples.values("blind", preset, "side"), Aggregate::Highest, Comparison::AtMost, 5.0,
                      "%");
        judge.require("with density all 36 pass in every seed", preset,
                      samples.values("density", preset, "through"), Aggregate::Lowest, Comparison::AtLeast,
                      36.0);
        // Compared are pairs of runs with the same seed. Single runs may end later: how a queue arches is
        // chance.
        judge.require(
            "last arrival with density over that without, median", preset,
            ratios(samples.values("density", preset, "last"), samples.values("blind", preset, "last")),
            Aggregate::Median, Comparison::AtMost, 0.95);
    }
}

std::vector<ChartDef> CongestionExperiment::charts(const Samples& samples) const {
    ChartDef chart{.title = "Characters past the middle of the ways (seed 1).",
                   .xTitle = "time [s]",
                   .yTitle = "characters"};
    for (const Arm& arm : arms()) {
        const std::vector<RunSample>& runs = samples.runs(arm.id, arm.preset);
        if (arm.preset != "muster" || runs.empty()) continue;
        const auto curve = runs.front().curves.find("through");
        if (curve != runs.front().curves.end()) chart.series.push_back({arm.title, curve->second, false});
    }
    if (chart.series.empty()) return {};
    return {chart};
}

}  // namespace

std::unique_ptr<Experiment> makeCongestionExperiment() {
    return std::make_unique<CongestionExperiment>();
}

}  // namespace muster
