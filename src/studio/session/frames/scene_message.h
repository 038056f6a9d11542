// The static facts of a world, for the page.
#pragma once

#include <string>

#include "muster/world.h"
#include "studio/session/history/place.h"
#include "studio/session/inbox/protocol.h"

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

/// The message of that revision.
protocol::Scene sceneMessage(const SceneSource& source, std::uint32_t revision);

}  // namespace muster
