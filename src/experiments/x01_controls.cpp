// X1 (paper fig. 2): one drag of four corners by points, lines and an area.
#include <algorithm>
#include <map>

#include "experiments/catalogue.h"
#include "experiments/distortion.h"
#include "muster/base/random.h"
#include "muster/experiments/trial.h"

namespace muster {
namespace {

constexpr double kFarthest = 2.2;  // A corner is drawn this far at most [m].

/// A way for a finger of a drag: the first seed keeps the shipped one, others draw theirs.
Vec2 wayOf(std::uint64_t seed, std::uint32_t touch, Vec2 shipped) {
    if (seed == 1) return shipped;
    Random random(seed * 64 + touch);
    for (;;) {
        const double x = random.uniform(-1.0, 1.0);
        const double y = random.uniform(-1.0, 1.0);
        if (x * x + y * y <= 1.0) return Vec2{x, y} * kFarthest;
    }
}

/// Bends the straight ways of the fingers to those of the seed, keeping their timing.
void drawDrag(std::uint64_t seed, std::vector<Command>& commands) {
    std::map<std::uint32_t, Vec2> from, to;
    for (const Command& command : commands) {
        if (const auto* down = std::get_if<TouchDown>(&command.body)) from[down->touch] = down->position;
        if (const auto* move = std::get_if<TouchMove>(&command.body)) to[move->touch] = move->position;
    }
    for (Command& command : commands) {
        auto* move = std::get_if<TouchMove>(&command.body);
        if (move == nullptr) continue;
        const Vec2 start = from[move->touch], shipped = to[move->touch] - start;
        const double share = dot(move->position - start, shipped) / lengthSquared(shipped);
        move->position = start + wayOf(seed, move->touch, shipped) * share;
    }
}

class ControlsExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {"X1", "Point, line and area control",
                "Figure 2: the four corners of a rectangular mesh are dragged alike under point, line and area control. The "
                "three meshes differ: the kinds of control give the mesh more and more rigidity.",
                "A square of 36 in the open. Four fingers drag its corners, each up to 2.2 m. As four points they come down 0.25 s "
                "apart; as two lines the pairs at the left and right edge begin together; as one area all four do. Each "
                "seed is another drag, the same for the three. Measured while all fingers hold at their ends: |F - R| of each "
                "triangle, the distance of its deformation from a rotation, and the as-rigid-as-possible energy, the sum "
                "of area x |F - R|^2.",
                "x01-area",
                "The energy rises from point to line to area while the peak falls. Both must be so: with the corners alone "
                "held the mesh is free to seek the least energy, and each further constraint takes freedom away, so the least "
                "can only grow. The free mesh keeps its middle and pays at the corners, where single triangles tear; lines and "
                "areas spread the same drag over all triangles."};
    }
    std::vector<Arm> arms() const override {
        return {{"points", "Four points"}, {"lines", "Two lines"}, {"area", "One area"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"peak", "largest |F - R| of a triangle", "", 3},
                {"mean", "mean |F - R|", "", 3},
                {"energy", "as-rigid-as-possible energy", "m²", 3},
                {"controls", "controls on the mesh", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        auto trial = Trial::open(request, {.scenario = "x01-" + request.arm.id});
        if (!trial.ok()) return trial.status();
        drawDrag(request.seed, trial->commands());
        if (Status s = trial->start(); !s.ok()) return s;
        trial->picture().view = Box{{-7.5, -6.0}, {7.5, 6.0}};
        trial->runUntil(2.1);
        trial->shoot("the fingers are down");
        trial->runUntil(trial->gesturesEnd() - 0.1);
        trial->shoot("the corners are where they were dragged");
        RunSample sample;
        const GroupView group = trial->world().group(0);
        const TriangleMesh& rest = group.mesh->formation().mesh;
        const std::vector<double> deviation = triangleDistortion(rest, group.mesh->userMesh());
        double sum = 0.0;
        for (const double value : deviation) sum += value;
        sample.figures = {{"peak", *std::max_element(deviation.begin(), deviation.end())},
                          {"mean", sum / static_cast<double>(deviation.size())},
                          {"energy", arapEnergy(rest, group.mesh->userMesh())},
                          {"controls", static_cast<double>(group.controls->controls().size())}};
        trial->report(sample);
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        const auto peak = [&](const char* arm) { return samples.values(arm, "muster", "peak"); };
        const auto energy = [&](const char* arm) { return samples.values(arm, "muster", "energy"); };
        const auto atMost = [&](const char* what, const std::vector<double>& values, double most) {
            judge.require(what, "muster", values, Aggregate::Median, Comparison::AtMost, most);
        };
        atMost("peak deviation under two lines over that under four points", ratios(peak("lines"), peak("points")), 0.8);
        atMost("peak deviation under one area over that under two lines", ratios(peak("area"), peak("lines")), 0.8);
        judge.require("peak deviation falls from points to lines in every drag (ratio)", "muster",
                      ratios(peak("lines"), peak("points")), Aggregate::Highest, Comparison::AtMost, 1.0);
        judge.require("peak deviation falls from lines to area in every drag (ratio)", "muster",
                      ratios(peak("area"), peak("lines")), Aggregate::Highest, Comparison::AtMost, 1.0);
        judge.require("energy under one area over that under four points", "muster",
                      ratios(energy("area"), energy("points")), Aggregate::Lowest, Comparison::AtLeast, 1.0);
    }
};

}  // namespace

std::unique_ptr<Experiment> makeControlsExperiment() { return std::make_unique<ControlsExperiment>(); }

}  // namespace muster
