// X5 (paper fig. 7b): among moving cars and mice.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "lab/reproduce/experiments/car_watch.h"
#include "lab/reproduce/experiments/encounter_watch.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

constexpr MotionId kJump = 5;
// Distance of starts from their places, large enough to matter for more than a moment [m].
constexpr double kTrafficJitter = 1.0;
constexpr double kTrafficHand = 0.3;      // Greatest shift of the hand [m].
constexpr double kCarShift = 1.0;         // Greatest distance by which a car is ahead or behind [m].
constexpr double kTrafficLongest = 30.0;  // Longest time after the last gesture [s].
constexpr double kFarSide = 5.5;          // Height y beyond which a character has crossed the street [m].
constexpr double kUntouchedGap = 0.25;    // Least gap at which nobody counts as touched [m].

/// Arms of the sweep, with the strength of all cars' fields. The first is the scene as it is watched.
struct Strength {
    const char* arm;
    const char* title;
    double value;
};
constexpr std::array<Strength, 4> kStrengths{{{"traffic", "Field strength 4", 4.0},
                                              {"s2", "Field strength 2", 2.0},
                                              {"s1", "Field strength 1", 1.0},
                                              {"s0", "No field", 0.0}}};

/// Arm without the cars' fields and without their discomfort (SPEC A5), which leaves only contacts. Compared
/// with the arm without a field it shows the effect of discomfort alone.
constexpr const char* kNeither = "neither";

class TrafficExperiment final : public Experiment {
public:
    ExperimentText text() const override;
    std::vector<Arm> arms() const override {
        std::vector<Arm> arms;
        for (const Strength& strength : kStrengths) arms.push_back({strength.arm, strength.title});
        arms.push_back({kNeither, "No field, no discomfort"});
        arms.insert(arms.begin() + 1, {kStrengths[0].arm, kStrengths[0].title, "paper"});
        return arms;
    }
    std::vector<FigureInfo> figures() const override {
        return {{"gap", "smallest gap between anybody and a car", "m", 3},
                {"keeps", "each one's smallest gap to a car, mean over all", "m", 3},
                {"gives", "distance from the car at which a vertex of the mesh gives way, mean", "m", 3},
                {"near", "characters that a car came nearer to than 1 m", "", 0},
                {"across", "characters across the street", "", 0},
                {"met", "encounters with mice (positions)", "", 0},
                {"jumps", "jumps (events)", "", 0},
                {"mismatches", "encounters without exactly one jump, and jumps without an encounter", "", 0},
                {"stuck", "stuck", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;
    std::vector<ChartDef> charts(const Samples& samples) const override;
};

ExperimentText TrafficExperiment::text() const {
    return {
        "X5",
        "Cars and mice",
        "Figure 7b: cars of two sizes drive at the crowd, which avoids them by the user's control and the "
        "cars' potential field; the field's strength sets the distance from which characters give way. Mice "
        "are moving patches: characters jump when one runs between them.",
        "36 cross a street on two fingers: wait at the kerb, cross one lane, stand between a bus and a lorry "
        "that pass at both sides, cross the other lane. Drawn without regard to the cars, the outer ranks "
        "would stand in their way. Three mice run to and fro on each pavement. By the seed starts are moved "
        "by up to 1 m, the hand draws up to 0.3 m aside and each car comes up to 1 m earlier or later. Gaps "
        "are from disc to surface, in every step, to where the car stood when contacts were resolved and to "
        "where it stands after the step; a contact makes them 0 or less. Encounters are one stay each in a "
        "mouse's polygon, re-armed after 0.5 s, counted from positions and compared with the events step by "
        "step.",
        "x05-traffic",
        "The field does what the paper says: with each doubling of its strength the crowd keeps farther off "
        "and the mesh begins to give way earlier. Without it people leave the ground that a car is about to "
        "sweep by themselves, so that nobody is run into, but later and closer. It has a limit that the "
        "paper "
        "does not name: where a car drives through the middle of a mesh, vertices part to both sides but "
        "triangles between them span the car, and places in them lead people into its way; there the field "
        "does not help and giving way has to.\nDiscomfort alone (no field, with it and without it) changes "
        "the "
        "gaps by a few centimetres, to either side: it changes who goes where and which way, not where the "
        "places are that a mesh without a field leaves in a car's way."};
}

/// Moves each car a little along its street, by the seed.
void shiftCars(WorldDef& def, std::uint64_t seed) {
    Random random(seed + 1000);
    for (ObstacleDef& obstacle : def.obstacles) {
        if (obstacle.path.still()) continue;
        const double shift = random.uniform(-kCarShift, kCarShift);
        for (Waypoint& waypoint : obstacle.path.waypoints) waypoint.position.x += shift;
    }
}

double strengthOf(const std::string& arm) {
    for (const Strength& strength : kStrengths)
        if (arm == strength.arm) return strength.value;
    return 0.0;
}

Result<RunSample> TrafficExperiment::run(const RunRequest& request) const {
    auto trial = ExperimentTrial::open(request, {.scenario = "x05-traffic", .jitter = kTrafficJitter});
    if (!trial.ok()) return trial.status();
    shiftCars(trial->def(), request.seed);
    jitterHand(trial->commands(), request.seed, kTrafficHand);
    for (ObstacleDef& obstacle : trial->def().obstacles)
        if (!obstacle.path.still()) obstacle.strength = strengthOf(request.arm.id);
    if (request.arm.id == kNeither) trial->def().parameters.discomfort.enabled = false;
    if (Status s = trial->start(); !s.ok()) return s;
    EncounterWatch mice(trial->world(), kJump);
    CarWatch cars(trial->world());
    const auto observe = [&] {
        mice.observe(trial->world());
        cars.observe(trial->world());
    };
    const auto shoot = [&](double until, double y, const char* caption) {
        trial->runUntil(until, observe);
        trial->picture().view = Box{{-9.0, y - 6.5}, {9.0, y + 6.5}};
        trial->shoot(caption);
    };
    shoot(6.2, -5.5, "at the kerb: a taxi passes, mice at their feet");
    shoot(11.0, -3.0, "across the first lane");
    shoot(16.8, 0.0, "between bus and lorry");
    shoot(26.5, 7.0, "over the mice on the other pavement");
    trial->runUntilSettled(kTrafficLongest, observe);
    RunSample sample;
    trial->report(sample);
    const std::span<const Vec2> positions = trial->world().characters().position;
    sample.figures["gap"] = cars.smallest();
    sample.figures["keeps"] = cars.meanSmallest();
    sample.figures["gives"] = cars.givesWayFrom();
    sample.figures["near"] = cars.nearer(1.0);
    sample.figures["across"] = static_cast<double>(
        std::count_if(positions.begin(), positions.end(), [](Vec2 p) { return p.y > kFarSide; }));
    sample.figures["met"] = mice.encounters();
    sample.figures["jumps"] = mice.events();
    sample.figures["mismatches"] = mice.mismatches();
    return sample;
}

/// Smallest growth of a figure from one strength to the next, by seed.
std::vector<double> leastGrowth(const Samples& samples, const char* figure, std::size_t weakest) {
    std::vector<double> least;
    for (std::size_t k = 0; k < weakest; ++k) {
        const std::vector<double> strong = samples.values(kStrengths[k].arm, "muster", figure);
        const std::vector<double> weak = samples.values(kStrengths[k + 1].arm, "muster", figure);
        if (k == 0)
            least.assign(std::min(strong.size(), weak.size()), std::numeric_limits<double>::infinity());
        least.resize(std::min({least.size(), strong.size(), weak.size()}));
        for (std::size_t s = 0; s < least.size(); ++s) least[s] = std::min(least[s], strong[s] - weak[s]);
    }
    return least;
}

void TrafficExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const std::string preset : {"muster", "paper"}) {
        const auto values = [&](const char* figure) {
            return samples.values(kStrengths[0].arm, preset, figure);
        };
        judge.require("no car touches anyone: smallest gap between anybody and a car in every seed", preset,
                      values("gap"), Aggregate::Lowest, Comparison::AtLeast, kUntouchedGap, "m");
        judge.require("36 of 36 across the street in every seed", preset, values("across"), Aggregate::Lowest,
                      Comparison::AtLeast, 36.0);
        judge.require("each encounter with a mouse has exactly one jump, in every seed", preset,
                      values("mismatches"), Aggregate::Highest, Comparison::AtMost, 0.0);
        judge.require("encounters with mice in every seed", preset, values("met"), Aggregate::Lowest,
                      Comparison::AtLeast, 36.0);
        judge.require("cars come nearer than 1 m to so many in every seed", preset, values("near"),
                      Aggregate::Lowest, Comparison::AtLeast, 5.0);
    }
    const auto grows = [&](const char* criterion, const char* figure, std::size_t weakest, double least) {
        judge.require(criterion, "muster", leastGrowth(samples, figure, weakest), Aggregate::Lowest,
                      Comparison::AtLeast, least, "m");
    };
    grows("strengths 0, 1, 2, 4: each step makes the mean gap that people keep grow in every seed", "keeps",
          3, 0.01);
    grows("strengths 1, 2, 4: with each step the mesh gives way from farther off in every seed", "gives", 2,
          0.01);
    for (const char* arm : {"s0", kNeither})
        judge.require(arm == std::string("s0") ? "no car touches anyone without a field either, in every seed"
                                               : "nor without a field and without discomfort, in every seed",
                      "muster", samples.values(arm, "muster", "gap"), Aggregate::Lowest, Comparison::AtLeast,
                      0.0, "m");
}

std::vector<ChartDef> TrafficExperiment::charts(const Samples& samples) const {
    ChartDef chart;
    chart.title =
        "A stronger field makes the crowd keep away farther, and give way earlier (medians over the seeds)";
    chart.xTitle = "strength of the cars' field";
    chart.yTitle = "distance [m]";
    const auto add = [&](const char* title, const char* figure) {
        ChartSeries series{title, {}, false};
        for (std::size_t k = kStrengths.size(); k-- > 0;) {
            const double y = median(samples.values(kStrengths[k].arm, "muster", figure));
            if (std::isfinite(y)) series.points.push_back({kStrengths[k].value, y});
        }
        chart.series.push_back(std::move(series));
    };
    add("smallest gap of all", "gap");
    add("each one's smallest gap, mean", "keeps");
    add("where the mesh gives way, mean", "gives");
    return {chart};
}

}  // namespace

std::unique_ptr<Experiment> makeTrafficExperiment() {
    return std::make_unique<TrafficExperiment>();
}

}  // namespace muster
