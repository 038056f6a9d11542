// X10 (paper fig. 9d): Pacman is carried along a path while two touches open and close his mouth.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/maths.h"
#include "base/random.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/mouth.h"

namespace muster {
namespace {

constexpr double kDegrees = 180.0 / kPi;
// Angles of the mouth's hysteresis [degrees]; at rest it is open by 69.
constexpr double kShutAngle = 60.0, kOpenAngle = 120.0;
constexpr std::uint32_t kJaws[] = {11, 12};  // Numbers of the touches that move the jaws, as in the gestures.
constexpr double kTremor = 0.1;              // Greatest displacement of a finger by the seed [m].

bool isJaw(std::uint32_t touch) {
    return std::find(std::begin(kJaws), std::end(kJaws), touch) != std::end(kJaws);
}

/// The touch that a command belongs to; 0 for others.
std::uint32_t fingerOf(const Command& command) {
    const auto* touch = std::get_if<Touch>(&command.body);
    return touch != nullptr && touch->phase != TouchPhase::Cancel ? touch->touch : 0;
}

/// Moves each finger a little, by the seed.
void vary(std::uint64_t seed, std::vector<Command>& commands) {
    if (seed == 1) return;
    Random random(seed);
    std::array<Vec2, 16> offset;
    for (Vec2& each : offset) {
        each.x = random.uniform(-kTremor, kTremor);
        each.y = random.uniform(-kTremor, kTremor);
    }
    for (Command& command : commands)
        if (auto* move = touchOf(command.body, TouchPhase::Move))
            move->position += offset[move->touch % offset.size()];
}

/// Measures mouth and body.
class PacmanWatch {
public:
    explicit PacmanWatch(const World& world) : mouth_(inspect::mesh(world, 0).formation().mesh) {}

    void observe(const World& world) {
        const FormationMesh& mesh = inspect::mesh(world, 0);
        angle_ = kDegrees * mouth_.angle(mesh.userMesh());
        counter_.observe(angle_);
        widest_ = std::max(widest_, angle_);
        narrowest_ = std::min(narrowest_, angle_);
        if (counter_.openings() > openings_ || openingAt_.empty()) openingAt_.push_back(mesh.pose().position);
        openings_ = counter_.openings();
        if (world.stepCount() % 6 == 0) curve_.push_back({world.time(), angle_});
    }
    void report(RunSample& sample) const {
        sample.figures["openings"] = openings_;
        sample.figures["widest"] = widest_;
        sample.figures["narrowest"] = narrowest_;
        sample.figures["way"] = distance(openingAt_.front(), openingAt_.back());
        sample.curves["angle"] = curve_;
    }
    double angle() const { return angle_; }
    std::int32_t openings() const { return openings_; }

private:
    Mouth mouth_;
    OpeningCounter counter_{kShutAngle, kOpenAngle};
    double angle_ = 0.0, widest_ = 0.0, narrowest_ = 360.0;
    std::int32_t openings_ = 0;
    std::vector<Vec2> openingAt_;  // Positions of the body at first, and at each opening [m].
    std::vector<Vec2> curve_;
};

class PacmanExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {"X10",
                "Pacman",
                "Figure 9d: the crowd takes the form of Pacman. Simple gestures carry him along while they "
                "open and "
                "close his mouth, so that he collects items.",
                "40 characters as Pacman. Three fingers that begin together carry his body along a winding "
                "path (an "
                "area control). Two more, begun apart from them and from each other, hold the tips of his "
                "lips (two "
                "points) and open and shut the mouth six times on the way. Five items lie on the path, "
                "twelve beside "
                "it where the body does not come. The opening is the angle at the mouth's hinge between the "
                "tips of "
                "the lips in the user mesh, counted with hysteresis: open above 120 degrees, having been "
                "below 60. "
                "Without the mouth: the same fingers without the two at the lips. Seeds move starts, and "
                "each finger "
                "by up to 0.1 m.",
                "x10-pacman",
                "One mesh obeys both hands at once: an area control carries the body stiffly, the points "
                "bend what "
                "is left. The mouth follows its fingers because control points are hard constraints; what "
                "limits it "
                "is the speed of control points, so that fingers must open and shut at a pace that people "
                "can walk. "
                "The preset paper gives nearly the same figures, because most of them come from the mesh."};
    }
    std::vector<Arm> arms() const override {
        return {{"mouth", "With the mouth"},
                {"still", "Without the mouth"},
                {"mouth", "With the mouth", "paper"},
                {"still", "Without the mouth", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"openings", "openings of the mouth", "", 0},
                {"widest", "widest opening", "degrees", 0},
                {"narrowest", "narrowest opening", "degrees", 0},
                {"way", "body's way from the start to the last opening, straight", "m", 1},
                {"collected", "items collected", "", 0},
                {"missed", "items left", "", 0},
                {"overlaps", "most overlapping pairs at once", "", 0},
                {"swaps", "swaps per character and second", "1/s", 3}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        auto trial = ExperimentTrial::open(request, {.scenario = "x10-pacman"});
        if (!trial.ok()) return trial.status();
        vary(request.seed, trial->commands());
        if (request.arm.id == "still")
            std::erase_if(trial->commands(), [](const Command& command) { return isJaw(fingerOf(command)); });
        if (Status s = trial->start(); !s.ok()) return s;
        PacmanWatch watch(trial->world());
        film(*trial, watch);
        RunSample sample;
        trial->report(sample);
        watch.report(sample);
        const auto collected = trial->world().collected();
        const auto got = std::count(collected.begin(), collected.end(), 1);
        sample.figures["collected"] = static_cast<double>(got);
        sample.figures["missed"] = static_cast<double>(static_cast<std::ptrdiff_t>(collected.size()) - got);
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        for (const char* const preset : {"muster", "paper"}) judgePreset(preset, samples, judge);
    }
    static void judgePreset(const char* preset, const Samples& samples, Judge& judge) {
        const auto mouth = [&](const char* figure) { return samples.values("mouth", preset, figure); };
        const auto still = [&](const char* figure) { return samples.values("still", preset, figure); };
        judge.require("openings of the mouth on the way", preset, mouth("openings"), Aggregate::Lowest,
                      Comparison::AtLeast, 5.0);
        judge.require("items left with the mouth", preset, mouth("missed"), Aggregate::Highest,
                      Comparison::AtMost, 0.0);
        judge.require("items collected without the mouth over those with it", preset,
                      ratios(still("collected"), mouth("collected")), Aggregate::Highest, Comparison::AtMost,
                      0.5);
        judge.require("openings without the touches at the lips", preset, still("openings"),
                      Aggregate::Highest, Comparison::AtMost, 0.0);
        judge.require("body's way until the last opening", preset, mouth("way"), Aggregate::Lowest,
                      Comparison::AtLeast, 10.0, "m");
    }
    std::vector<ChartDef> charts(const Samples& samples) const override {
        ChartDef chart{.title = "The mouth follows its two fingers, six times (seed 1).",
                       .xTitle = "time [s]",
                       .yTitle = "opening of the mouth [degrees]"};
        for (const Arm& arm : arms()) {
            const auto& runs = samples.runs(arm.id, arm.preset);
            if (!runs.empty() && arm.preset == "muster")
                chart.series.push_back({arm.title, runs.front().curves.at("angle"), false});
        }
        return {chart};
    }

private:
    /// Runs to the end and takes pictures of the mouth shut and open, alternating.
    static void film(ExperimentTrial& trial, PacmanWatch& watch) {
        trial.picture().view = Box{{-17.5, -6.6}, {11.5, 6.6}};
        const auto observe = [&] { watch.observe(trial.world()); };
        // First at rest, then shut and wide open, alternating.
        for (const double moment : {0.5, 4.0, 7.2, 9.8, 19.2, 27.8, 37.2}) {
            trial.runUntil(moment, observe);
            trial.shoot("mouth open by " + std::to_string(std::lround(watch.angle())) + " degrees");
        }
        trial.runUntil(trial.gesturesEnd() + 2.0, observe);
        trial.shoot("at the end");
    }
};

}  // namespace

std::unique_ptr<Experiment> makePacmanExperiment() {
    return std::make_unique<PacmanExperiment>();
}

}  // namespace muster
