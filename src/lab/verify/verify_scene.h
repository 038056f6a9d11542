// The scenes in which tests are run. Several tests may look at the same runs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/verify/sample.h"
#include "muster/status.h"

namespace muster {

/// One run that is asked for.
struct SceneRun {
    std::string variant;     ///< Name of one of the scene's variants.
    std::uint64_t seed = 1;  ///< Seed, from 1 on.
    bool picture = false;    ///< Whether a picture is wanted.
};

/// A scene: a simulation and its measurements.
struct SceneDef {
    std::string id;  ///< Id such as "corridor".
    /// Builds, runs and measures. Called by several threads at the same time.
    std::function<Result<VerifySample>(const SceneRun&)> run;
    double cost = 1.0;  ///< Time that a run takes in relation to others [s]: long ones begin first.
};

/// All scenes.
const std::vector<SceneDef>& verifyScenes();

// Parts of the list, one per file.
std::vector<SceneDef> freeWalkScenes();    ///< One person or some, each alone.
std::vector<SceneDef> roomScenes();        ///< Rooms with exits.
std::vector<SceneDef> choiceScenes();      ///< Exits that are assigned, chosen, shut; groups.
std::vector<SceneDef> bottleneckScenes();  ///< Doors and narrow corridors.
std::vector<SceneDef> stairScenes();       ///< Stairs, as ground on which people are slow.
std::vector<SceneDef> streamScenes();      ///< Rings, corridors, corners, junctions.
std::vector<SceneDef> encounterScenes();   ///< Two crowds that meet, and everyday scenes.

}  // namespace muster
