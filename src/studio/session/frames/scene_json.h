// The static facts of a world as JSON, for the page.
#pragma once

#include <string>

#include "muster/world.h"
#include "studio/session/history/place.h"

namespace muster {

/// What a Scene message tells of.
struct SceneSource {
    const std::string& name;        ///< The scenario's file name.
    const WorldDef& def;            ///< Gives title, description and credit.
    const World& world;             ///< Gives everything that may have changed.
    const Place& place;             ///< Tells how groups start.
    std::uint32_t worldNumber = 0;  ///< Rises with each world that begins.
    bool demonstration = false;     ///< The scenario carries touches that can be watched.
};

/// The JSON of a Scene message (docs/protocol.md).
std::string buildSceneJson(const SceneSource& source);
/// A hash of the scene; it differs where the scene has to be sent again.
std::uint64_t sceneSignature(const World& world);

}  // namespace muster
