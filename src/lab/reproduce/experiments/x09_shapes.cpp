// X9 (paper fig. 9a-c): changes of formation, and an arrow in a corridor.
#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "lab/reproduce/experiments/change_watch.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/samples.h"

namespace muster {
namespace {

// Half length of the corridor along x, which reaches from -6 to 6 m as the scenario says [m].
constexpr double kCorridorHalfLength = 6.0;
// Distance from the ends of the corridor beyond which nothing bends the arrow [m].
constexpr double kFieldRange = 1.5;
// Depth within which vertices that wait at the face of a house are not inside [m].
constexpr double kFaceTolerance = 0.05;
constexpr double kViewWidth = 30.0;  // Width of a picture of the corridor [m].
const char* const kShapes[] = {"wedge", "line", "ring", "crescent", "square"};

/// Difference between seeds apart from the starts, which even out before the first change. The first seed is
/// the shipped scenario.
struct Variation {
    Vec2 shift;
    double turn = 0.0;

    Variation(std::uint64_t seed, Vec2 mostShift, double mostTurn) {
        if (seed == 1) return;
        Random random(seed);
        shift.x = random.uniform(-mostShift.x, mostShift.x);
        shift.y = random.uniform(-mostShift.y, mostShift.y);
        turn = random.uniform(-mostTurn, mostTurn);
    }
    void apply(ExperimentTrial& trial) const {
        trial.shift(shift);
        trial.def().groups[0].angle += turn;
    }
};

/// Gives the changes of formation another order, by the seed; the last stays the square.
void shuffleShapes(std::uint64_t seed, std::vector<Command>& commands) {
    if (seed == 1) return;
    std::vector<ChangeGroup*> changes;
    for (Command& command : commands)
        if (auto* change = std::get_if<ChangeGroup>(&command.body)) changes.push_back(change);
    Random random(seed + 500);
    for (std::size_t k = changes.size(); k-- > 2;)
        std::swap(changes[k - 1]->formation, changes[random.below(static_cast<std::uint32_t>(k))]->formation);
}

/// Figures of a change, by the name of its shape: the bottleneck walking time, and the times to arrive and to
/// stand within 0.1 m relative to it.
void reportChange(const FormationChangeRecord& change, double speed, RunSample& sample) {
    const std::string name(formationName(change.kind));
    sample.figures["ratio_" + name] = change.ratio(speed);
    sample.figures["strict_" + name] = change.strictRatio(speed);
    sample.figures["walk_" + name] = change.bottleneck / speed;
}

/// A change that was never complete (NaN) counts as the worst.
double worse(double a, double b) {
    return std::isnan(a) || std::isnan(b) ? kNothing : std::max(a, b);
}

/// Five changes of formation while the mesh stands still.
Result<RunSample> runOpen(const RunRequest& request) {
    auto trial = ExperimentTrial::open(request, {.scenario = "x09-shapes"});
    if (!trial.ok()) return trial.status();
    Variation(request.seed, {0.5, 0.5}, 0.35).apply(*trial);
    shuffleShapes(request.seed, trial->commands());
    if (Status s = trial->start(); !s.ok()) return s;
    ChangeWatch watch(trial->world());
    const auto observe = [&] { watch.observe(trial->world()); };
    trial->runUntil(1.5, observe);
    trial->shoot("a square");
    for (std::size_t k = 0; k < std::size(kShapes); ++k) {
        while (watch.changes().size() <= k) {
            trial->step();
            observe();
        }
        const double begun = trial->time();
        trial->runUntil(begun + 0.8, observe);
        if (k < 3) trial->shoot(std::string("on the way to the ") + (k == 0 ? "arrow" : kShapes[k]));
        trial->runUntil(begun + 5.5, observe);
        trial->shoot(std::string("the ") + (k == 0 ? "arrow" : kShapes[k]));
    }
    RunSample sample;
    double worst = 0.0, strict = 0.0;
    std::int32_t stuck = 0;
    const double speed = trial->world().parameters().character.maxSpeed;
    for (const FormationChangeRecord& change : watch.changes()) {
        reportChange(change, speed, sample);
        worst = worse(worst, change.ratio(speed));
        strict = worse(strict, change.strictRatio(speed));
        stuck += change.stuck;
    }
    trial->report(sample);
    sample.figures["worst"] = worst;
    sample.figures["strict"] = strict;
    sample.figures["stuck"] = stuck;
    return sample;
}

/// Widths of mesh and crowd across the corridor, which lies along x [m].
struct Extent {
    double width = 0.0;
    double front = -1e9, rear = 1e9;

    explicit Extent(std::span<const Vec2> points) {
        double low = 1e9, high = -1e9;
        for (const Vec2 p : points) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
            front = std::max(front, p.x);
            rear = std::min(rear, p.x);
        }
        width = high - low;
    }
};

/// Widths of the arrow along its path.
struct ArrowWatch {
    double before = kNothing;  // Last width before the corridor can bend the arrow [m].
    double inside = kNothing;  // Largest width while all of the arrow is inside [m].
    double after = kNothing;   // Last width as an arrow behind the corridor [m].
    double lag = 0.0;          // Largest mean distance to the places while somebody is inside [m].
    std::int32_t unmatched = 0;

    void observe(const World& world, std::span<const Vec2> points) {
        if (world.group(0).formation != FormationKind::Wedge) return;
        const Extent extent(points);
        if (extent.front < -kCorridorHalfLength - kFieldRange) before = extent.width;
        if (extent.rear > kCorridorHalfLength + kFieldRange) after = extent.width;
        const bool within = extent.rear > -kCorridorHalfLength + kFaceTolerance &&
                            extent.front < kCorridorHalfLength - kFaceTolerance;
        if (within && !(inside >= extent.width)) inside = extent.width;
        if (extent.front < -kCorridorHalfLength || extent.rear > kCorridorHalfLength) return;
        lag = std::max(lag, world.group(0).meanLag);
        const std::span place = world.characters().place;
        unmatched = std::max(unmatched,
                             static_cast<std::int32_t>(std::count(place.begin(), place.end(), -1)));
    }
};

Result<RunSample> runCorridor(const RunRequest& request) {
    auto trial = ExperimentTrial::open(request, {.scenario = "x09-corridor"});
    if (!trial.ok()) return trial.status();
    Variation(request.seed, {0.0, 0.5}, 0.0).apply(*trial);
    if (Status s = trial->start(); !s.ok()) return s;
    ChangeWatch watch(trial->world());
    ArrowWatch mesh, crowd;
    const auto observe = [&] {
        watch.observe(trial->world());
        mesh.observe(trial->world(), trial->world().group(0).finalMesh);
        crowd.observe(trial->world(), trial->world().characters().position);
    };
    const auto centre = [&] { return trial->world().group(0).pose.position.x; };
    const auto shoot = [&](const char* caption) {
        const Box all = trial->def().box;
        const double left = std::clamp(centre() - 0.5 * kViewWidth, all.min.x, all.max.x - kViewWidth);
        trial->picture().view = Box{{left, -8.2}, {left + kViewWidth, 8.2}};
        trial->shoot(caption);
    };
    const auto until = [&](auto reached, const char* caption) {
        while (!reached() && trial->time() < trial->gesturesEnd()) {
            trial->step();
            observe();
        }
        shoot(caption);
    };
    trial->runUntil(1.0, observe);
    shoot("a square, the first checkpoint ahead");
    until([&] { return centre() > -10.0; }, "an arrow behind it");
    until([&] { return centre() > -5.0; }, "its sides give way");
    until([&] { return centre() > 0.0; }, "all of it inside");
    until([&] { return centre() > 6.0; }, "the sides come back");
    until([&] { return centre() > 13.0; }, "the arrow again");
    until([&] { return watch.changes().size() >= 2; }, "at the second checkpoint");
    trial->runUntil(trial->time() + 5.5, observe);
    shoot("a crescent");
    RunSample sample;
    trial->report(sample);
    const auto changes = watch.changes();
    if (changes.size() == 2) {
        reportChange(changes[1], trial->world().parameters().character.maxSpeed, sample);
        sample.figures["stuck"] = changes[0].stuck + changes[1].stuck;
    }
    sample.figures["width_before"] = crowd.before;
    sample.figures["width_inside"] = crowd.inside;
    sample.figures["width_after"] = crowd.after;
    sample.figures["narrowed"] = crowd.inside / crowd.before;
    sample.figures["recovered"] = crowd.after / crowd.before;
    sample.figures["mesh_narrowed"] = mesh.inside / mesh.before;
    sample.figures["mesh_recovered"] = mesh.after / mesh.before;
    sample.figures["lag"] = crowd.lag;
    sample.figures["unmatched"] = crowd.unmatched;
    return sample;
}

class ShapesExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X9",
            "Changes of formation",
            "Figure 9a-c: a square turns into an arrow, which passes a narrow corridor, its sides "
            "deforming for "
            "the time being, and then into other shapes. Checkpoints in the environment switch the "
            "formation. "
            "Changes are quick, with minimal congestion.",
            "36 characters. In the open keys turn a square into an arrow, a line, a ring, a crescent and "
            "back, "
            "while nobody drags. Each change is timed until 95 % have arrived (within 0.5 m of the "
            "place, for 1 "
            "s) and divided by the bottleneck walking time: the least longest straight walk over all "
            "assignments "
            "of where people stand to the new places, at top speed. In the corridor scene one finger "
            "draws the "
            "crowd from hall to hall, through a passage 4 m wide and 12 m long. A checkpoint before it "
            "makes the "
            "square an arrow, one behind it makes the arrow a crescent, where the finger stops. The "
            "width is the "
            "crowd's extent across the corridor.",
            "x09-corridor",
            "By the preset muster each change takes less than the bottleneck walking time, because who "
            "is within "
            "half a metre has arrived; standing within a tenth of a metre takes up to 1.3 times that "
            "time, which "
            "is the time to gather speed and to stop.\nBy the preset paper the changes to the line and "
            "to the "
            "ring take half as long again as the bottleneck allows. The least sum of costs (exponent 1) "
            "does not "
            "mind one long walk among many short ones; the least sum of squares does.\nIn the corridor "
            "the arrow "
            "is half as wide as before, nobody loses the place, and the shape comes back by itself. "
            "Seeds turn "
            "and shift the formation in the open and give the shapes another order, so that each is come to "
            "from others, and shift crowd and finger sideways before the corridor."};
    }
    std::vector<Arm> arms() const override {
        return {{"open", "In the open"},
                {"corridor", "Through the corridor"},
                {"open", "In the open", "paper"},
                {"corridor", "Through the corridor", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {{"walk_wedge", "to the arrow: bottleneck walking time", "s"},
                {"ratio_wedge", "to the arrow: time over it", ""},
                {"strict_wedge", "to the arrow: time to stand within 0.1 m over it", ""},
                {"walk_line", "to the line: bottleneck walking time", "s"},
                {"ratio_line", "to the line: time over it", ""},
                {"strict_line", "to the line: time to stand within 0.1 m over it", ""},
                {"walk_ring", "to the ring: bottleneck walking time", "s"},
                {"ratio_ring", "to the ring: time over it", ""},
                {"strict_ring", "to the ring: time to stand within 0.1 m over it", ""},
                {"walk_crescent", "to the crescent: bottleneck walking time", "s"},
                {"ratio_crescent", "to the crescent: time over it", ""},
                {"strict_crescent", "to the crescent: time to stand within 0.1 m over it", ""},
                {"walk_square", "back to the square: bottleneck walking time", "s"},
                {"ratio_square", "back to the square: time over it", ""},
                {"strict_square", "back to the square: time to stand within 0.1 m over it", ""},
                {"width_before", "width of the arrow before the corridor", "m"},
                {"width_inside", "largest width inside", "m"},
                {"width_after", "width behind it", "m"},
                {"narrowed", "inside over before", ""},
                {"recovered", "behind over before", ""},
                {"mesh_narrowed", "mesh: inside over before", ""},
                {"mesh_recovered", "mesh: behind over before", ""},
                {"lag", "largest mean distance to the places in the corridor", "m"},
                {"unmatched", "most without a place in the corridor", "", 0},
                {"stuck", "stuck after a change", "", 0},
                {"overlaps", "most overlapping pairs at once", "", 0}};
    }
    Result<RunSample> run(const RunRequest& request) const override {
        return request.arm.id == "open" ? runOpen(request) : runCorridor(request);
    }
    void judge(const Samples& samples, Judge& judge) const override {
        for (const char* preset : {"muster", "paper"}) {
            const auto highest = [&](const char* criterion, const char* arm, const char* figure,
                                     double most) {
                judge.require(criterion, preset, samples.values(arm, preset, figure), Aggregate::Highest,
                              Comparison::AtMost, most);
            };
            highest("slowest of five changes in the open, over the bottleneck walking time", "open", "worst",
                    1.3);
            highest("stuck after any change in the open", "open", "stuck", 0.0);
            highest("crowd's width inside the corridor over that before it", "corridor", "narrowed", 0.6);
            judge.require("crowd's width behind the corridor over that before it", preset,
                          samples.values("corridor", preset, "recovered"), Aggregate::Lowest,
                          Comparison::AtLeast, 0.95);
            highest("change behind the corridor, over the bottleneck walking time", "corridor",
                    "ratio_crescent", 1.3);
            highest("stuck after any change about the corridor", "corridor", "stuck", 0.0);
        }
    }
};

}  // namespace

std::unique_ptr<Experiment> makeShapesExperiment() {
    return std::make_unique<ShapesExperiment>();
}

}  // namespace muster
