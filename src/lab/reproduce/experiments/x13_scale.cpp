// X13 (paper section 7.6): the cost of a step by crowd size.
#include <algorithm>
#include <array>
#include <cmath>

#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

/// A crowd size and its numbers of measured steps, which are multiples of the plan's period.
struct Size {
    std::int32_t count = 0;
    std::int32_t warmUp = 0;
    std::int32_t steps = 0;
};

// Large crowds take fewer steps, so that a run takes seconds.
constexpr Size kSizes[] = {{36, 40, 120},  {100, 24, 80},  {160, 16, 48},  {250, 12, 24},
                           {400, 12, 16},  {630, 8, 12},   {1000, 48, 8},  {1600, 48, 8},
                           {2500, 48, 8},  {5000, 48, 8},  {7000, 48, 8},  {10000, 48, 8},
                           {14000, 48, 8}, {20000, 48, 8}, {28000, 48, 8}, {40000, 48, 8}};
// Number of seeds that run all sizes; the others end with kJudgedCrowd.
constexpr std::uint64_t kLongSeeds = 2;
// Number of characters of the largest crowd that a criterion is about.
constexpr std::int32_t kJudgedCrowd = 160;
constexpr double kLeastStepRate = 10.0;  // Rate of steps below which no larger crowds are tried [1/s].
// Least power of the size with which the cost of a step grows: with the exact plan the measured power is
// nearer to 2, with the fast plan to 1.
constexpr double kGrowthExact = 1.5, kGrowthFast = 0.9;
constexpr double kShippedCrowd = 100.0;  // Number of characters in the scenario as it ships.
constexpr Vec2 kCrowdCentre{-4.0, 0.0};  // Position of the crowd, in the middle of the trees [m].

/// Stages of a step as one part of the chart: all from the first to the last.
struct Part {
    const char* name;
    const char* title;
    std::string_view first, last;
};
constexpr Part kParts[] = {
    {"plan", "plan", "background", "plans"},
    {"density", "density and cost", "density", "unit cost"},
    {"mesh", "controls, meshes and places", "commands", "places"},
    {"crowd", "steering, contacts, patches, events", "bodies", "gates"},
};

/// Changes the scene to another number of people: it keeps the people per square metre of ground and the
/// fingers at the same corners of the formation.
void enlarge(ExperimentTrial& trial, std::int32_t count) {
    WorldDef& def = trial.def();
    GroupDef& group = def.groups[0];
    const double crowd = std::sqrt(count / kShippedCrowd), ground = std::max(1.0, crowd);
    const Box tile = def.box;
    const Vec2 start = group.position;
    def.box = {tile.min * ground, tile.max * ground};
    group.count = count;
    group.position = kCrowdCentre * ground;
    const std::vector<ObstacleDef> trees = std::move(def.obstacles);
    def.obstacles.clear();
    const auto reach = static_cast<std::int32_t>(std::ceil(0.5 * (ground - 1.0)));
    for (std::int32_t j = -reach; j <= reach; ++j) {
        for (std::int32_t i = -reach; i <= reach; ++i) {
            for (ObstacleDef tree : trees) {
                tree.centre += Vec2{i * tile.width(), j * tile.height()};
                if (def.box.grown(-1.0).contains(tree.centre)) def.obstacles.push_back(std::move(tree));
            }
        }
    }
    std::vector<std::pair<std::uint32_t, Vec2>> downs;
    for (Command& command : trial.commands()) {
        if (auto* down = touchOf(command.body, TouchPhase::Down)) {
            downs.emplace_back(down->touch, down->position - start);
            down->position = group.position + (down->position - start) * crowd;
        }
        auto* move = touchOf(command.body, TouchPhase::Move);
        if (move == nullptr) continue;
        for (const auto& [touch, corner] : downs)
            if (touch == move->touch) move->position += group.position + corner * crowd - (start + corner);
    }
}

/// Mean milliseconds of a step, by stage and in all.
struct StepCost {
    std::array<double, kStageCount> stage{};
    double total = 0.0;

    double of(const Part& part) const {
        double sum = 0.0;
        bool inside = false;
        for (std::size_t s = 0; s < stage.size(); ++s) {
            inside = inside || stepStages()[s].name == part.first;
            if (inside) sum += stage[s];
            inside = inside && stepStages()[s].name != part.last;
        }
        return sum;
    }
};

StepCost measure(ExperimentTrial& trial, const Size& size) {
    for (std::int32_t k = 0; k < size.warmUp; ++k) trial.step();
    StepCost cost;
    for (std::int32_t k = 0; k < size.steps; ++k) {
        trial.step();
        const StageTimes& times = trial.world().stageTimes();
        for (std::size_t s = 0; s < cost.stage.size(); ++s)
            cost.stage[s] += times.milliseconds[s] / size.steps;
        cost.total += times.total / size.steps;
    }
    return cost;
}

class ScaleExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X13",
            "Cost against crowd size",
            "Section 7.6: on one core of a Core i7 with 2.67 GHz the simulation runs at about 32 frames per "
            "second (its scenes have 36 and 100 characters); above 160 characters the rate falls to about 8 "
            "to 10.",
            "A square formation follows two fingers among trees. Sizes from 36 rise as long as 10 steps in a "
            "second "
            "are made, or can be expected of the next; only the first two seeds go beyond 160, to save time. "
            "Ground and trees grow with "
            "the crowd above 100, so that the density of both stays. One thread, nothing else runs "
            "meanwhile; the "
            "mean over a number of steps that is fixed for each size, after some that are not counted, among "
            "them "
            "those in which the first plan comes in. A step simulates 1/60 s.",
            "x13-scale",
            "The preset paper computes a cost field for each place and then an exact assignment, all in "
            "every "
            "step; the preset muster has fields of landmarks and repairs the matching of the step before. "
            "Our "
            "machine is not the paper's, so its points show the shape of the fall, not a race."};
    }
    std::vector<Arm> arms() const override {
        return {{"size", "Preset muster"}, {"size", "Preset paper", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        std::vector<FigureInfo> all;
        for (const Size& size : kSizes)
            all.push_back({rateName(size), std::to_string(size.count) + " characters", "steps/s", 1});
        for (const Part& part : kParts)
            all.push_back({part.name, std::string(part.title) + ", at 100", "ms", 3});
        all.push_back({"largest", "largest crowd at 10 steps per second or more", "", 0});
        return all;
    }
    bool timed() const override { return true; }
    Result<RunSample> run(const RunRequest& request) const override {
        RunSample sample;
        double rate = kLeastStepRate, count = 0.0;  // Rate and number of characters of the size before.
        const double growth = request.arm.preset == "paper" ? kGrowthExact : kGrowthFast;
        for (const Size& size : kSizes) {
            if (count > 0.0 && rate * std::pow(count / size.count, growth) < kLeastStepRate) break;
            auto trial = ExperimentTrial::open(request, {.scenario = "x13-scale"});
            if (!trial.ok()) return trial.status();
            enlarge(*trial, size.count);
            if (Status s = trial->start(); !s.ok()) return s;
            const StepCost cost = measure(*trial, size);
            note(size, cost, sample);
            film(*trial, size, sample);
            const bool quick = 1000.0 / cost.total >= kLeastStepRate;
            if (request.seed <= kLongSeeds && quick) sample.figures["largest"] = size.count;
            rate = 1000.0 / cost.total;
            count = size.count;
            if (!quick || (request.seed > kLongSeeds && size.count >= kJudgedCrowd)) break;
        }
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        for (const char* preset : {"muster", "paper"}) {
            const auto atLeast = [&](const char* criterion, const char* figure, double least) {
                judge.require(criterion, preset, samples.values("size", preset, figure), Aggregate::Median,
                              Comparison::AtLeast, least, "1/s");
            };
            atLeast("steps per second at 36 characters", "rate36", 32.0);
            atLeast("steps per second at 100 characters", "rate100", 32.0);
            atLeast("steps per second at 160 characters", "rate160", 10.0);
        }
    }
    std::vector<ChartDef> charts(const Samples& samples) const override {
        ChartDef rates{
            "Steps per second fall as the crowd grows.", "characters", "steps per second", true, true, {}};
        ChartDef parts{"What a step consists of, by the preset muster.",
                       "characters",
                       "milliseconds per step",
                       true,
                       true,
                       {}};
        for (const Arm& arm : arms())
            rates.series.push_back({arm.title, medians(samples, arm, "rate"), false});
        rates.series.push_back({"the paper's own figures", {{36, 32}, {100, 32}, {160, 8}, {160, 10}}, true});
        for (const Part& part : kParts)
            parts.series.push_back({part.title, medians(samples, arms()[0], part.name), false});
        return {rates, parts};
    }

private:
    static std::string rateName(const Size& size) { return "rate" + std::to_string(size.count); }
    static void note(const Size& size, const StepCost& cost, RunSample& sample) {
        const double rate = 1000.0 / cost.total;
        sample.figures[rateName(size)] = rate;
        sample.curves["rate"].push_back({static_cast<double>(size.count), rate});
        for (const Part& part : kParts) {
            sample.curves[part.name].push_back({static_cast<double>(size.count), cost.of(part)});
            if (size.count == 100) sample.figures[part.name] = cost.of(part);
        }
    }
    /// A picture of some sizes; the hash is that of a hundred.
    static void film(ExperimentTrial& trial, const Size& size, RunSample& sample) {
        const bool shown = size.count == 36 || size.count == 100 || size.count == 400 || size.count == 1000;
        if (shown) trial.shoot(std::to_string(size.count) + " characters");
        RunSample own;
        trial.report(own);
        for (FilmFrame& frame : own.film) sample.film.push_back(std::move(frame));
        if (size.count == 100) sample.hash = own.hash;
        if (sample.plan.empty()) sample.plan = own.plan;
    }
    /// The median at each size over the runs that reached it.
    static std::vector<Vec2> medians(const Samples& samples, const Arm& arm, const std::string& curve) {
        std::vector<Vec2> points;
        const auto& runs = samples.runs(arm.id, arm.preset);
        for (std::size_t k = 0; k < std::size(kSizes); ++k) {
            std::vector<double> values;
            for (const RunSample& run : runs) {
                const std::vector<Vec2>& found = run.curves.at(curve);
                if (k < found.size()) values.push_back(found[k].y);
            }
            const double value = median(values);
            if (value > 0.0) points.push_back({static_cast<double>(kSizes[k].count), value});
        }
        return points;
    }
};

}  // namespace

std::unique_ptr<Experiment> makeScaleExperiment() {
    return std::make_unique<ScaleExperiment>();
}

}  // namespace muster
