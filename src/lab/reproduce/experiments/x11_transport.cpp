// X11 (paper fig. 10): a dense square parts round an obstacle and merges: transport against fixed places.
#include <cmath>

#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

// Greatest displacement of a start, so that the first plan has something to assign [m].
constexpr double kTransportJitter = 0.5;
constexpr double kTransportHand = 0.3;  // Greatest shift of the hand [m].
// Time after the last gesture at which the run ends [s]. Characters still on their way count as arriving
// then.
constexpr double kTransportLongest = 30.0;

class TransportExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X11",
            "Transport against kept places",
            "Figure 10: a dense square passes round an obstacle and merges again. Some are caught behind the "
            "obstacle and come late. With fixed places those who came first stand in their way; with "
            "transport "
            "these shift inward and the late take places at the rear.",
            "A square of 36, places 0.6 m apart for characters 0.5 m wide, is drawn across a round well by "
            "four "
            "fingers. Nothing differs between the arms but the plan: made anew (transport), assigned once at "
            "the start, or character i keeps place i. Time counts from the last gesture until everybody is "
            "in "
            "place; a run is cut 30 s after it and then counts as 30 s. Seeds move starts by up to 0.5 m and "
            "the hand by up to 0.3 m.",
            "x11-transport",
            "Contacts are discs without friction, so that those in the way can be pushed aside; late ones "
            "with "
            "a kept place do arrive in most runs, but only after squeezing through the ranks. With transport "
            "the gap closes from behind."};
    }
    std::vector<Arm> arms() const override {
        return {{"transport", "Transport"},         {"fixed", "Fixed places"},
                {"once", "Assigned once"},          {"transport", "Transport", "paper"},
                {"fixed", "Fixed places", "paper"}, {"once", "Assigned once", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"time", "everybody in place after the last gesture (cut at 30 s)", "s", 2},
                {"arrived", "characters that arrived", "", 0},
                {"changed", "characters with another place than at first", "", 0},
                {"arrived95", "95 % in place", "s", 2},
                {"stuck", "stuck", "", 0},
                {"swaps", "changes of place per character and second", "1/s", 3},
                {"overlaps", "most overlapping pairs at once", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;
};

double planMode(const std::string& arm) {
    if (arm == "fixed") return static_cast<double>(PlanMode::Fixed);
    return static_cast<double>(arm == "once" ? PlanMode::AssignedOnce : PlanMode::Transport);
}

/// Number of characters within reach of their places at the end.
std::int32_t inPlace(const World& world) {
    const CharactersView characters = world.characters();
    const std::span<const Vec2> places = world.group(0).placePositions;
    std::int32_t count = 0;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const std::int32_t place = characters.place[i];
        count += place >= 0 && distance(characters.position[i], places[place]) <= 0.5 ? 1 : 0;
    }
    return count;
}

Result<RunSample> TransportExperiment::run(const RunRequest& request) const {
    const ExperimentTrialDef def{.scenario = "x11-transport",
                                 .jitter = kTransportJitter,
                                 .settings = {{"plan.mode", planMode(request.arm.id)}}};
    auto trial = ExperimentTrial::open(request, def);
    if (!trial.ok()) return trial.status();
    jitterHand(trial->commands(), request.seed, kTransportHand);
    if (Status s = trial->start(); !s.ok()) return s;
    const auto shoot = [&](double x, const std::string& caption) {
        trial->picture().view = Box{{x - 6.0, -4.0}, {x + 6.0, 4.0}};
        trial->shoot(caption);
    };
    // The first touch is at 0.5 s, when every character has a place.
    trial->runUntil(0.5);
    const std::span<const std::int32_t> now = trial->world().characters().place;
    const std::vector<std::int32_t> first(now.begin(), now.end());
    shoot(-6.0, "at first");
    trial->runUntil(7.0);
    shoot(0.0, "some are caught behind the well");
    trial->runUntil(10.0);
    shoot(3.0, "10 s: the late come to the others");
    trial->runUntil(trial->gesturesEnd() + 1.0);
    shoot(7.0, "1 s after the last gesture");
    const bool settled = trial->runUntilSettled(kTransportLongest);
    shoot(7.0, settled ? "all in place" : "cut: not all in place");
    RunSample sample;
    trial->report(sample);
    const std::span<const std::int32_t> last = trial->world().characters().place;
    std::int32_t changed = 0;
    for (std::size_t i = 0; i < first.size(); ++i) changed += first[i] != last[i] ? 1 : 0;
    const double time = sample.figures["arrived100"];
    sample.figures["time"] = std::isnan(time) ? kTransportLongest : time;
    sample.figures["arrived"] = inPlace(trial->world());
    sample.figures["changed"] = changed;
    return sample;
}

void TransportExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const std::string preset : {"muster", "paper"}) {
        const auto values = [&](const char* arm, const char* figure) {
            return samples.values(arm, preset, figure);
        };
        judge.require("transport: everybody arrives, in every seed", preset,
                      values("transport", "arrived100"), Aggregate::Highest, Comparison::AtMost,
                      kTransportLongest, "s");
        judge.require("time of transport over that of fixed places, in every seed", preset,
                      ratios(values("transport", "time"), values("fixed", "time")), Aggregate::Highest,
                      Comparison::AtMost, 0.6);
        judge.require("time of transport over that of places assigned once, in every seed", preset,
                      ratios(values("transport", "time"), values("once", "time")), Aggregate::Highest,
                      Comparison::AtMost, 0.6);
        judge.require("transport: characters whose last place is not the first, in every seed", preset,
                      values("transport", "changed"), Aggregate::Lowest, Comparison::AtLeast, 1.0);
    }
}

}  // namespace

std::unique_ptr<Experiment> makeTransportExperiment() {
    return std::make_unique<TransportExperiment>();
}

}  // namespace muster
