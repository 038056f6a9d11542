// A scenario of the paper with its gestures, stepped and watched.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "muster/metrics.h"
#include "muster/status.h"
#include "muster/world.h"
#include "picture/picture.h"
#include "reproduce/experiments/experiment.h"

namespace muster {

/// How a trial begins.
struct TrialDef {
    std::string scenario;  ///< File under the paper's folder without ".json".
    double jitter = 0.15;  ///< Starts are moved by up to this, by the seed [m] >= 0.
    std::vector<std::pair<std::string, double>> settings = {};  ///< Parameters by name, set after the preset.
    bool gestures = true;  ///< With the touches that the scenario carries.
};

/// One run of a world: first to be changed at will, then started, stepped and filmed.
class Trial {
public:
    /// Reads scenario and gestures, takes the request's preset (what differs between presets; the scenario's
    /// own parameters stay) and seed. Fails as loadScenario does, or naming a setting.
    static Result<Trial> open(const RunRequest& request, const TrialDef& def);

    /// To be changed before start().
    WorldDef& def() { return def_; }
    /// To be changed before start(); in the order of (step, client, sequence).
    std::vector<Command>& commands() { return commands_; }
    /// Moves groups and touches aside, before start() [m].
    void shift(Vec2 by);
    /// Makes the world. Fails as World::create and World::submit do.
    Status start();

    World& world() { return *world_; }                       ///< After start().
    const World& world() const { return *world_; }           ///< After start().
    const RunMetrics& metrics() const { return *metrics_; }  ///< After start().
    double time() const { return world_->time(); }           ///< [s]
    /// When the last gesture is given [s].
    double gesturesEnd() const { return gesturesEnd_; }
    /// One step.
    void step();
    /// Steps until the world has been running for `seconds` [s], calling `watch` after each.
    void runUntil(double seconds, const std::function<void()>& watch = {});
    /// Steps until all gestures are given and everybody has arrived and stands, or `longest` [s] have passed
    /// since the last gesture; calls `watch` after each. True where it settled.
    bool runUntilSettled(double longest, const std::function<void()>& watch = {});

    /// What pictures show from now on [m], and how; the whole world, and all but the coloured grounds by
    /// default.
    PictureDef& picture() { return picture_; }
    /// Where film is wanted: adds a picture of this moment.
    void shoot(const std::string& caption);
    /// Figures of the run, the film and the hash, into a sample: arrived95, arrived100, stuck, unmatched,
    /// swaps, overlaps, penetration (names of FigureInfo), those not reached NaN.
    void report(RunSample& sample);

private:
    void follow();

    WorldDef def_;
    std::vector<Command> commands_;
    std::optional<World> world_;
    std::optional<RunMetrics> metrics_;
    double gesturesEnd_ = 0.0;
    bool film_ = false;
    PictureDef picture_;
    std::vector<FilmFrame> frames_;
};

}  // namespace muster
