// X3 (paper fig. 5): geodesic against Euclidean costs in the assignment.
#include <cmath>

#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

// Time after which a character that is still on its way counts as not arrived [s].
constexpr double kMetricLongest = 60.0;

/// Length of the paths walked by all characters [m].
class Walked {
public:
    explicit Walked(const World& world)
        : last_(world.characters().position.begin(), world.characters().position.end()) {}
    void observe(const World& world) {
        for (std::size_t i = 0; i < last_.size(); ++i) {
            metres_ += distance(last_[i], world.characters().position[i]);
            last_[i] = world.characters().position[i];
        }
    }
    double metres() const { return metres_; }

private:
    std::vector<Vec2> last_;
    double metres_ = 0.0;
};

class MetricExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {"X3",
                "Geodesic against Euclidean costs",
                "Figure 5: a big block stands between the crowd and its goal. Costs as the crow flies "
                "overlook the way round it; "
                "costs along the shortest way give a better assignment.",
                "36 characters at two opposite corners of a house 24 m long are told, by one change of "
                "formation, to stand at the other "
                "two corners. As the crow flies the places across the house are nearest; on foot those on "
                "the own side are. "
                "Both arms have exponent 1 and the same threshold, and walk along the same cost fields; only "
                "the costs "
                "of the assignment differ. Measured from the command until all stand: length walked by all, "
                "and when the last is there. "
                "A second scene, a plain block between the crowd and its places, is run in the same way.",
                "x03-long-house",
                "Where it makes no difference: where all ways lead through the same gaps in the same order. "
                "Behind a plain "
                "block (last columns) each way is the sum of a part before and a part behind the corner that "
                "it turns, so with "
                "exponent 1 any exchange between two who turn the same corner costs the same, and who goes "
                "left and who right is "
                "the same for both metrics. The same holds for one door in a wide wall, and in the open, "
                "where the two metrics are one. "
                "It matters where places are near through a wall and far on foot, and others are the other "
                "way about: long "
                "houses, courtyards, fences, rivers."};
    }
    std::vector<Arm> arms() const override {
        std::vector<Arm> arms;
        for (const char* preset : {"muster", "paper"}) {
            arms.push_back({"geodesic", "Geodesic", preset});
            arms.push_back({"euclidean", "Euclidean", preset});
        }
        arms.push_back({"geodesic-plain", "Plain block, geodesic"});
        arms.push_back({"euclidean-plain", "Plain block, Euclidean"});
        return arms;
    }
    std::vector<FigureInfo> figures() const override {
        return {{"walked", "length walked by all", "m", 1},
                {"arrived100", "last one there", "s", 2},
                {"crossed", "who ended on the other side", "", 0},
                {"swaps", "exchanges per character and second", "1/s", 3},
                {"stuck", "stuck", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        const std::string& arm = request.arm.id;
        const bool plain = arm.ends_with("-plain");
        auto trial = ExperimentTrial::open(
            request, {.scenario = plain ? "x03-plain-block" : "x03-long-house",
                      .settings = {{"plan.exponent", 1.0},
                                   {"plan.geodesic", arm.starts_with("geodesic") ? 1.0 : 0.0}}});
        if (!trial.ok()) return trial.status();
        if (Status s = trial->start(); !s.ok()) return s;
        const std::span<const Vec2> now = trial->world().characters().position;
        const std::vector<Vec2> starts(now.begin(), now.end());
        trial->runUntil(1.0);
        trial->shoot("before the command");
        Walked walked(trial->world());
        const auto watch = [&] { walked.observe(trial->world()); };
        trial->runUntil(4.0, watch);
        trial->shoot("on the way");
        trial->runUntil(8.0, watch);
        trial->shoot("4 s later");
        trial->runUntilSettled(kMetricLongest, watch);
        trial->shoot("all stand");
        RunSample sample;
        trial->report(sample);
        sample.figures["walked"] = walked.metres();
        double crossed = 0.0;
        for (std::size_t i = 0; i < starts.size(); ++i)
            crossed += starts[i].x * trial->world().characters().position[i].x < 0.0 ? 1.0 : 0.0;
        sample.figures["crossed"] = crossed;
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        for (const char* preset : {"muster", "paper"}) {
            const auto share = [&](const char* figure) {
                return ratios(samples.values("geodesic", preset, figure),
                              samples.values("euclidean", preset, figure));
            };
            judge.require("total travel, geodesic over Euclidean", preset, share("walked"), Aggregate::Median,
                          Comparison::AtMost, 0.97);
            judge.require("last one there, geodesic over Euclidean", preset, share("arrived100"),
                          Aggregate::Median, Comparison::AtMost, 0.95);
            judge.require("stuck with geodesic costs", preset, samples.values("geodesic", preset, "stuck"),
                          Aggregate::Highest, Comparison::AtMost, 0.0);
        }
        std::vector<double> difference = ratios(samples.values("geodesic-plain", "muster", "walked"),
                                                samples.values("euclidean-plain", "muster", "walked"));
        for (double& value : difference) value = std::abs(value - 1.0);
        judge.require("total travel behind a plain block, difference between the metrics", "muster",
                      difference, Aggregate::Highest, Comparison::AtMost, 0.03);
    }
};

}  // namespace

std::unique_ptr<Experiment> makeMetricExperiment() {
    return std::make_unique<MetricExperiment>();
}

}  // namespace muster
