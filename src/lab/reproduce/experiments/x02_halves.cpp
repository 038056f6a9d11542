// X2 (paper fig. 3): a line control at the left and an area control at the right of one mesh.
#include <map>

#include "base/random.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/distortion.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

// Number of touches of the gesture, the first ones, that make the line.
constexpr std::uint32_t kLineTouches = 2;

/// Draws the line's fingers 0.6 to 1.2 times as far as shipped, by the seed; the first seed keeps them.
void drawLine(std::uint64_t seed, std::vector<Command>& commands) {
    Random random(seed);
    const double factor = seed == 1 ? 1.0 : random.uniform(0.6, 1.2);
    std::map<std::uint32_t, Vec2> from;
    for (Command& command : commands) {
        if (const auto* down = touchOf(command.body, TouchPhase::Down)) from[down->touch] = down->position;
        auto* move = touchOf(command.body, TouchPhase::Move);
        if (move != nullptr && move->touch <= kLineTouches)
            move->position = from[move->touch] + (move->position - from[move->touch]) * factor;
    }
}

class HalvesExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {"X2",
                "A line and an area on one mesh",
                "Figure 3: a line control at the left of a square and an area control at its right. The left "
                "half bends, the "
                "right half keeps its shape.",
                "A square of 64 in the open. Two touches on the left edge begin together and make a line; "
                "four touches on the "
                "right half begin together later and make an area. The line is turned and drawn away while "
                "the area is "
                "turned the other way. Measured when all fingers have come to rest and still hold: the mean "
                "over each "
                "half of |F - R|, the distance of each triangle's deformation from a rotation. Seeds draw "
                "the line 0.6 to 1.2 times as far.",
                "x02-line-and-area",
                "The right half is not left wholly at rest: supplementary points are held softly, and where "
                "the bent half pulls at "
                "its edge it gives way a little. How little is a matter of control.softWeight: with 2, 6 and "
                "20 the "
                "ratio is 6, 11 and 29."};
    }
    std::vector<Arm> arms() const override { return {{"both", "Line and area"}}; }
    std::vector<FigureInfo> figures() const override {
        return {{"left", "mean distortion of the left half", "", 4},
                {"right", "mean distortion of the right half", "", 4},
                {"ratio", "left over right", "", 1},
                {"energy", "as-rigid-as-possible energy", "m²", 3}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        auto trial = ExperimentTrial::open(request, {.scenario = "x02-line-and-area"});
        if (!trial.ok()) return trial.status();
        drawLine(request.seed, trial->commands());
        if (Status s = trial->start(); !s.ok()) return s;
        trial->picture().view = Box{{-11.0, -8.0}, {9.0, 8.0}};
        trial->runUntil(1.0);
        trial->shoot("at rest");
        trial->runUntil(2.6);
        trial->shoot("line and area take hold");
        trial->runUntil(trial->gesturesEnd() - 0.5);
        trial->shoot("all fingers at rest");
        const FormationMesh& mesh = inspect::mesh(trial->world(), 0);
        RunSample sample;
        const double left = meanDistortion(mesh.formation().mesh, mesh.userMesh(), true);
        const double right = meanDistortion(mesh.formation().mesh, mesh.userMesh(), false);
        sample.figures = {{"left", left},
                          {"right", right},
                          {"ratio", left / right},
                          {"energy", arapEnergy(mesh.formation().mesh, mesh.userMesh())}};
        trial->runUntil(trial->gesturesEnd() + 4.0);
        trial->shoot("let go: relaxed to a square");
        trial->report(sample);
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        judge.require("mean distortion of the left half over that of the right half", "muster",
                      samples.values("both", "muster", "ratio"), Aggregate::Median, Comparison::AtLeast, 5.0);
    }
};

}  // namespace

std::unique_ptr<Experiment> makeHalvesExperiment() {
    return std::make_unique<HalvesExperiment>();
}

}  // namespace muster
