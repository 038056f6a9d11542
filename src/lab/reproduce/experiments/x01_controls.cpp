// X1 (paper fig. 2): one drag of four corners by points, lines and an area.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/maths.h"
#include "base/random.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/distortion.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"

namespace muster {
namespace {

/// The drag of four fingers that hold the corners of a square: they shift and rotate it, stretch it along
/// both sides, shear and taper it.
struct Drag {
    Vec2 shift;
    Rotation turn;
    double stretchX = 1.0, stretchY = 1.0;  ///< Factors of the lengths of the sides.
    double shear = 0.0;                     ///< Shift of x by y.
    double taper = 0.0;  ///< Share by which the right side becomes longer and the left side shorter.

    /// The point to which a corner of the square about the origin goes, whose half side is `half` [m].
    Vec2 apply(Vec2 corner, double half) const {
        const double width = 1.0 + taper * corner.x / half;
        return shift + turn.apply({stretchX * corner.x + shear * corner.y, stretchY * width * corner.y});
    }
};

/// A drag of fingers that pinch or spread the square while they rotate it. With `oneWay` they stretch it
/// along one axis and squeeze it along the other.
Drag dragOf(std::uint64_t seed, bool oneWay) {
    Random random(seed);
    const auto between = [&](double low, double high) { return random.uniform(low, high); };
    Drag drag{.shift = {.x = between(-1.0, 1.0), .y = between(-1.0, 1.0)}};
    const double angle = between(-0.6, 0.6);
    drag.turn = {cosine(angle), sine(angle)};
    const double size = random.below(2) == 0 ? between(0.65, 0.85) : between(1.15, 1.4);
    drag.stretchX = size * between(0.93, 1.07);
    drag.stretchY = (oneWay ? 1.0 / size : size) * between(0.93, 1.07);
    drag.shear = between(-0.1, 0.1);
    drag.taper = between(-0.1, 0.1);
    return drag;
}

/// Replaces the straight paths of the shipped drag by those of the seed and keeps their timing.
void drawDrag(std::uint64_t seed, bool oneWay, std::vector<Command>& commands) {
    const Drag drag = dragOf(seed, oneWay);
    std::map<std::uint32_t, Vec2> from, to;
    for (const Command& command : commands) {
        if (const auto* down = touchOf(command.body, TouchPhase::Down)) from[down->touch] = down->position;
        if (const auto* move = touchOf(command.body, TouchPhase::Move)) to[move->touch] = move->position;
    }
    for (Command& command : commands) {
        auto* move = touchOf(command.body, TouchPhase::Move);
        if (move == nullptr) continue;
        const Vec2 corner = from[move->touch], shipped = to[move->touch] - corner;
        const double share = dot(move->position - corner, shipped) / lengthSquared(shipped);
        move->position = corner + (drag.apply(corner, std::abs(corner.x)) - corner) * share;
    }
}

class ControlsExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {"X1",
                "Point, line and area control",
                "Figure 2: the four corners of a rectangular mesh are dragged alike under point, line and "
                "area control. The "
                "three meshes differ: the kinds of control give the mesh more and more rigidity.",
                "A square of 100 in the open. Four fingers drag its corners: they pinch it to 0.65 to 0.85 "
                "of its size or spread it to "
                "1.15 to 1.4, turn it by up to 34 degrees, and shear and taper it a little. As four points "
                "they come down 0.25 s "
                "apart; as two lines the pairs at the left and right edge begin together; as one area all "
                "four do. Each "
                "seed is another drag, the same for the three. Measured while all fingers hold at their "
                "ends: |F - R| of each "
                "triangle, the distance of its deformation from a rotation, and the as-rigid-as-possible "
                "energy, the sum "
                "of area x |F - R|^2.",
                "x01-area",
                "The energy rises from points to lines to area while the peak falls. Both must be so. With "
                "the corners alone "
                "held the mesh is free to seek the least energy; each further constraint takes freedom away, "
                "so the least "
                "can only grow. The free mesh keeps the size of its middle and pays at the corners, where "
                "single triangles tear; "
                "lines and areas spread the same drag over all triangles.\n"
                "It is not so for every drag: one that stretches the square one way and squeezes it the "
                "other (the columns "
                "\"one way\") is a smooth deformation already, without peaks at the corners. There two lines "
                "gain nothing over "
                "four points (the median peak is even higher), and only the area's is lower."};
    }
    std::vector<Arm> arms() const override {
        return {{"points", "Four points"},
                {"lines", "Two lines"},
                {"area", "One area"},
                {"points-oneway", "Four points, one way"},
                {"lines-oneway", "Two lines, one way"},
                {"area-oneway", "One area, one way"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"peak", "largest |F - R| of a triangle", "", 3},
                {"mean", "mean |F - R|", "", 3},
                {"energy", "as-rigid-as-possible energy", "m²", 3},
                {"controls", "controls on the mesh", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        const std::size_t dash = request.arm.id.find('-');
        auto trial = ExperimentTrial::open(request, {.scenario = "x01-" + request.arm.id.substr(0, dash)});
        if (!trial.ok()) return trial.status();
        drawDrag(request.seed, dash != std::string::npos, trial->commands());
        if (Status s = trial->start(); !s.ok()) return s;
        trial->picture().view = Box{{-11.5, -9.5}, {11.5, 9.5}};
        trial->runUntil(2.1);
        trial->shoot("the fingers are down");
        trial->runUntil(trial->gesturesEnd() - 0.1);
        trial->shoot("the corners are where they were dragged");
        RunSample sample;
        const FormationMesh& mesh = inspect::mesh(trial->world(), 0);
        const TriangleMesh& rest = mesh.formation().mesh;
        const std::vector<double> deviation = triangleDistortion(rest, mesh.userMesh());
        double sum = 0.0;
        for (const double value : deviation) sum += value;
        sample.figures = {{"peak", *std::max_element(deviation.begin(), deviation.end())},
                          {"mean", sum / static_cast<double>(deviation.size())},
                          {"energy", arapEnergy(rest, mesh.userMesh())},
                          {"controls", static_cast<double>(trial->world().group(0).controls.size())}};
        trial->report(sample);
        return sample;
    }
    void judge(const Samples& samples, Judge& judge) const override {
        const auto peak = [&](const char* arm) { return samples.values(arm, "muster", "peak"); };
        const auto energy = [&](const char* arm) { return samples.values(arm, "muster", "energy"); };
        const auto atMost = [&](const char* what, const std::vector<double>& values, double most) {
            judge.require(what, "muster", values, Aggregate::Median, Comparison::AtMost, most);
        };
        atMost("peak deviation under two lines over that under four points",
               ratios(peak("lines"), peak("points")), 0.8);
        atMost("peak deviation under one area over that under two lines", ratios(peak("area"), peak("lines")),
               0.8);
        judge.require("peak deviation falls from points to lines in every drag (ratio)", "muster",
                      ratios(peak("lines"), peak("points")), Aggregate::Highest, Comparison::AtMost, 1.0);
        judge.require("peak deviation falls from lines to area in every drag (ratio)", "muster",
                      ratios(peak("area"), peak("lines")), Aggregate::Highest, Comparison::AtMost, 1.0);
        judge.require("energy under one area over that under four points", "muster",
                      ratios(energy("area"), energy("points")), Aggregate::Lowest, Comparison::AtLeast, 1.0);
    }
};

}  // namespace

std::unique_ptr<Experiment> makeControlsExperiment() {
    return std::make_unique<ControlsExperiment>();
}

}  // namespace muster
