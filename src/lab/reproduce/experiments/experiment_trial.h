// One run of a scenario of the paper with its gestures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/world/metrics.h"
#include "lab/picture/picture.h"
#include "lab/reproduce/experiments/experiment.h"
#include "muster/command.h"
#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// The begin of a trial.
struct ExperimentTrialDef {
    std::string scenario;  ///< Name of the file under the paper's folder without ".json".
    double jitter = 0.15;  ///< Greatest displacement of a start, drawn by the seed [m] >= 0.
    std::vector<std::pair<std::string, double>> settings = {};  ///< Parameters by name, set after the preset.
    bool gestures = true;  ///< Whether the touches of the scenario are given.
};

/// One run of a world: its definition may be changed first, then it is started, stepped and filmed.
class ExperimentTrial {
public:
    /// Reads scenario and gestures, takes the request's preset (what differs between presets; the scenario's
    /// own parameters stay) and seed. Fails as loadScenario does, or naming a setting.
    static Result<ExperimentTrial> open(const RunRequest& request, const ExperimentTrialDef& def);

    /// The world's definition, which may be changed before start().
    WorldDef& def() { return def_; }
    /// All commands, which may be changed before start(); in the order of (step, client, sequence).
    std::vector<Command>& commands() { return commands_; }
    /// Shifts all groups and touches, before start() [m].
    void shift(Vec2 by);
    /// Makes the world. Fails as World::create and World::submit do.
    Status start();

    World& world() { return *world_; }                       ///< The world, after start().
    const World& world() const { return *world_; }           ///< The world, after start().
    const RunMetrics& metrics() const { return *metrics_; }  ///< Its metrics, after start().
    double time() const { return world_->time(); }           ///< Time of the world [s].
    /// Time of the last gesture [s].
    double gesturesEnd() const { return gesturesEnd_; }
    /// Makes one step.
    void step();
    /// Steps until the world has been running for `seconds` [s], calling `watch` after each.
    void runUntil(double seconds, const std::function<void()>& watch = {});
    /// Steps until all gestures are given and everybody has arrived and stands, or `longest` [s] have passed
    /// since the last gesture; calls `watch` after each. True where it settled.
    bool runUntilSettled(double longest, const std::function<void()>& watch = {});

    /// Sets the box [m] and the layers that pictures show from now on. The default is the whole world with
    /// all layers but the coloured grounds.
    PictureDef& picture() { return picture_; }
    /// Adds a picture of this moment if the request wants film.
    void shoot(const std::string& caption);
    /// Writes figures of the run, the film and the hash to a sample: arrived95, arrived100, stuck, unmatched,
    /// swaps, overlaps, penetration (names of FigureInfo). Times that were not reached are NaN.
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

/// Shifts the drawing of all fingers by one vector that the seed chooses, each component up to `amount`
/// [m] >= 0. The shift grows over two seconds from the first touch, so that nothing jumps. The points where
/// fingers go down do not change.
void jitterHand(std::vector<Command>& commands, std::uint64_t seed, double amount);

}  // namespace muster
