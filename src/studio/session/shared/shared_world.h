// What directors have done with the world that all of them share, and the world before.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "muster/world.h"
#include "studio/session/history/place_editor.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/takes/take_log.h"

namespace muster {

/// Who paused, builds, and has replaced the world. Directors are ids of clients, which stay as long as they
/// do.
struct SharedWorld {
    std::uint32_t pausedBy = 0;        ///< 0 for nobody.
    std::set<std::uint32_t> builders;  ///< The world waits for them.
    bool goesOn = false;               ///< The world goes on when the last of them has done.
    protocol::WorldChange change = protocol::WorldChange::None;
    std::uint32_t changedBy = 0;
    std::string changer;         ///< Name of who changed it.
    std::uint32_t revision = 1;  ///< Rises with every change of these.

    void touch() { ++revision; }
};

/// A director is about to begin another world.
struct Leaving {
    bool recording = false;  ///< The world that is left is being recorded.
};

/// A world that was replaced, as it was.
struct ParkedWorld {
    std::string name;
    WorldDef def;
    bool playing = true;
    double speed = 1.0;

    // Of a take that was open.
    std::vector<std::uint8_t> takenBytes;  ///< Empty where none was.
    std::string takeName;
    TakeAbout takeAbout;
    bool takeLoops = false;
    std::uint32_t takeStep = 0;

    // Of any other world.
    std::optional<World> world;
    PlaceEditor editor;
    TakeLog log;
    std::vector<Command> layer;
    std::size_t nextOfLayer = 0;
    bool waitsForHand = false;
    bool recorded = false;
    bool recording = false;
    TakeAbout recordedAbout;
    std::size_t recordedCommands = 0;
    std::uint32_t demonstratedUntil = 0;
    std::map<std::uint32_t, std::uint32_t> sequences;  ///< Of the last commands, by number of client.
};

}  // namespace muster
