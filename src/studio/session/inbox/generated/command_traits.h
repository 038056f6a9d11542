// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// What the studio has to know of each kind of command.
#pragma once

#include <array>

#include "muster/command.h"

namespace muster {

/// What is true of all commands of one kind.
struct CommandTraits {
    const char* label;  ///< What undo and redo call it; empty where that depends on more.
    bool undoable;      ///< It can be taken back.
    bool directs;       ///< It directs a group: a director may send it.
    bool edits;         ///< It edits the place.
    bool slides;        ///< A slider sends many of them, which count as one.
};

inline constexpr std::array<CommandTraits, std::variant_size_v<CommandKinds>> kCommandTraits{{
    {"", false, false, false, false},               // TouchDown
    {"", false, false, false, false},               // TouchMove
    {"", false, false, false, false},               // TouchUp
    {"", false, false, false, false},               // TouchCancel
    {"", false, false, false, false},               // AddControl
    {"Pin", true, false, false, false},             // PinControl
    {"", false, false, false, false},               // RemoveControl
    {"", false, false, false, false},               // ReleaseClient
    {"Change shape", true, true, true, false},      // SetFormation
    {"People", true, false, true, true},            // SetCount
    {"Place group", true, true, false, false},      // SetPose
    {"Add group", true, true, true, false},         // AddGroup
    {"Remove group", true, false, true, false},     // RemoveGroup
    {"", true, false, true, false},                 // AddObstacle
    {"", true, false, true, false},                 // ChangeObstacle
    {"", true, false, true, false},                 // RemoveObstacle
    {"", true, false, true, false},                 // AddPatch
    {"", true, false, true, false},                 // ChangePatch
    {"", true, false, true, false},                 // RemovePatch
    {"Setting", true, false, true, true},           // SetParameter
    {"", true, true, false, false},                 // GiveOrder
    {"", true, true, false, false},                 // EditQueue
    {"", true, true, true, true},                   // SetConduct
    {"Add people", true, true, false, false},       // AddCharacters
    {"Remove people", true, true, false, false},    // RemoveCharacters
    {"Transfer people", true, true, false, false},  // TransferCharacters
    {"Split", true, true, false, false},            // SplitGroup
    {"Merge", true, true, false, false},            // MergeGroups
    {"Bodies", true, true, true, false},            // SetBodies
    {"Roles", true, true, true, false},             // SetRoles
    {"Demands", true, true, true, true},            // SetDemands
    {"", true, false, false, false},                // SetDriver
    {"", true, false, false, false},                // WriteMotion
    {"", true, false, true, false},                 // AddItem
    {"", true, false, true, false},                 // ChangeItem
    {"", true, false, true, false},                 // RemoveItem
    {"", true, false, true, false},                 // AddCheckpoint
    {"", true, false, true, false},                 // ChangeCheckpoint
    {"", true, false, true, false},                 // RemoveCheckpoint
    {"", true, false, true, false},                 // PlaceGroup
    {"", true, false, true, false},                 // NameGroup
    {"", true, false, true, false},                 // ColourGroup
    {"", true, false, true, false},                 // SetAppearance
    {"", true, false, true, false},                 // PutArea
    {"", true, false, true, false},                 // RemoveArea
    {"", true, false, true, false},                 // SetPeople
    {"Reverse orders", true, true, false, false},   // ReverseQueue
}};

/// The traits of a command.
inline const CommandTraits& traitsOf(const CommandBody& body) {
    return kCommandTraits[body.index()];
}

}  // namespace muster
