#include "lab/reproduce/experiments/experiment_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/assignment/planning/plan.h"
#include "engine/world/inspect.h"
#include "muster/parameter_table.h"
#include "muster/scenario.h"

namespace muster {
namespace {

constexpr double kTrailPeriod = 0.2;       // Time between two samples of a trail [s].
constexpr std::size_t kTrailLength = 20;   // Number of samples of a trail in pictures.
constexpr std::int32_t kFrameWidth = 440;  // Width of a picture of a film [px].

double orNothing(double value) {
    return value < 0.0 ? std::numeric_limits<double>::quiet_NaN() : value;
}

}  // namespace

Result<ExperimentTrial> ExperimentTrial::open(const RunRequest& request, const ExperimentTrialDef& def) {
    const std::string path = request.folder + "/" + def.scenario + ".json";
    auto loaded = loadScenario(path);
    if (!loaded.ok()) return loaded.status();
    ExperimentTrial trial;
    trial.def_ = std::move(loaded).value();
    Parameters& parameters = trial.def_.parameters;
    if (Status s = usePreset(parameters, request.arm.preset); !s.ok()) return s.within(path);
    for (const auto* settings : {&request.settings, &def.settings})
        for (const auto& [name, value] : *settings)
            if (Status s = setParameter(parameters, name, value); !s.ok()) return s.within(path);
    trial.def_.seed = request.seed;
    for (GroupDef& group : trial.def_.groups) group.jitter = def.jitter;
    if (def.gestures) {
        auto gestures = loadScenarioGestures(path, trial.def_);
        if (!gestures.ok()) return gestures.status();
        trial.commands_ = std::move(gestures).value();
    }
    trial.film_ = request.film;
    trial.picture_.width = kFrameWidth;
    return trial;
}

void ExperimentTrial::shift(Vec2 by) {
    for (GroupDef& group : def_.groups) group.position += by;
    for (Command& command : commands_) {
        if (auto* down = touchOf(command.body, TouchPhase::Down)) down->position += by;
        if (auto* move = touchOf(command.body, TouchPhase::Move)) move->position += by;
    }
}

Status ExperimentTrial::start() {
    auto world = World::create(def_);
    if (!world.ok()) return world.status();
    world_.emplace(std::move(world).value());
    for (const Command& command : commands_) {
        if (Status s = world_->submit(command); !s.ok()) return s;
        gesturesEnd_ = std::max(gesturesEnd_, (command.step + 1) * def_.parameters.stepTime);
    }
    metrics_.emplace(*world_);
    follow();
    return {};
}

// Past positions of characters, for pictures.
void ExperimentTrial::follow() {
    if (!film_) return;
    const auto every = static_cast<std::uint32_t>(
        std::max(1.0, std::floor(kTrailPeriod / def_.parameters.stepTime)));
    if (world_->stepCount() % every != 0) return;
    const CharactersView characters = world_->characters();
    if (picture_.trails.size() != characters.size()) picture_.trails.assign(characters.size(), {});
    for (std::size_t i = 0; i < characters.size(); ++i) {
        std::vector<Vec2>& trail = picture_.trails[i];
        if (trail.size() >= kTrailLength) trail.erase(trail.begin());
        trail.push_back(characters.position[i]);
    }
}

void ExperimentTrial::step() {
    world_->step();
    metrics_->observe(*world_);
    follow();
}

void ExperimentTrial::runUntil(double seconds, const std::function<void()>& watch) {
    while (time() < seconds - 1e-9) {
        step();
        if (watch) watch();
    }
}

bool ExperimentTrial::runUntilSettled(double longest, const std::function<void()>& watch) {
    const auto half = static_cast<std::uint32_t>(std::max(1.0, std::floor(0.5 / def_.parameters.stepTime)));
    const double end = gesturesEnd_ + longest;
    while (time() < end) {
        step();
        if (watch) watch();
        const bool due = time() > gesturesEnd_ + 1.0 && world_->stepCount() % half == 0;
        if (due && metrics_->settled(*world_)) return true;
    }
    return metrics_->settled(*world_);
}

void ExperimentTrial::shoot(const std::string& caption) {
    if (!film_) return;
    // An invalid view is a mistake in an experiment; the strip then shows the caption only.
    auto svg = svgPicture(*world_, picture_);
    MUSTER_ASSERT(svg.ok());
    frames_.push_back({time(), caption, svg.ok() ? std::move(svg).value() : std::string()});
}

void ExperimentTrial::report(RunSample& sample) {
    const RunFigures figures = metrics_->figures(*world_, false);
    sample.figures["arrived95"] = orNothing(figures.arrived95);
    sample.figures["arrived100"] = orNothing(figures.arrived100);
    sample.figures["stuck"] = figures.stuck;
    sample.figures["unmatched"] = figures.unmatched;
    sample.figures["swaps"] = figures.swapsPerCharacterPerSecond;
    sample.figures["overlaps"] = figures.overlapPairsMax;
    sample.figures["penetration"] = 100.0 * figures.worstPenetration;
    if (world_->groupCount() > 0) sample.plan = inspect::plan(*world_, 0).name();
    sample.hash = figures.hash;
    for (FilmFrame& frame : frames_) sample.film.push_back(std::move(frame));
    frames_.clear();
}

}  // namespace muster
