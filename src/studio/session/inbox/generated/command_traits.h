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
    bool queues;        ///< It changes the queue of its group in a way that only the world knows.
};

inline constexpr std::array<CommandTraits, std::variant_size_v<CommandKinds>> kCommandTraits{{
    {"", false, false, false, false, false},               // TouchDown
    {"", false, false, false, false, false},               // TouchMove
    {"", false, false, false, false, false},               // TouchUp
    {"", false, false, false, false, false},               // TouchCancel
    {"", false, true, false, false, false},                // AddControl
    {"Pin", true, true, false, false, false},              // PinControl
    {"", false, true, false, false, false},                // RemoveControl
    {"", false, false, false, false, false},               // ReleaseClient
    {"Change shape", true, true, true, false, false},      // SetFormation
    {"People", true, true, true, true, false},             // SetCount
    {"Place group", true, true, false, false, false},      // SetPose
    {"Add group", true, true, true, false, false},         // AddGroup
    {"Remove group", true, false, true, false, false},     // RemoveGroup
    {"", true, false, true, false, false},                 // PutThing
    {"", true, false, true, false, false},                 // RemoveThing
    {"Setting", true, true, true, true, false},            // SetParameter
    {"", true, true, false, false, false},                 // GiveOrder
    {"", true, true, false, false, false},                 // EditQueue
    {"", true, true, true, true, false},                   // SetConduct
    {"Add people", true, true, false, false, false},       // AddCharacters
    {"Remove people", true, true, false, false, false},    // RemoveCharacters
    {"Transfer people", true, true, false, false, false},  // TransferCharacters
    {"Split", true, true, false, false, false},            // SplitGroup
    {"Merge", true, true, false, false, false},            // MergeGroups
    {"Bodies", true, true, true, false, false},            // SetBodies
    {"Roles", true, true, true, false, false},             // SetRoles
    {"Demands", true, true, true, true, false},            // SetDemands
    {"", true, false, false, false, false},                // SetDriver
    {"", true, false, false, false, false},                // WriteMotion
    {"", true, false, true, false, false},                 // PlaceGroup
    {"", true, false, true, false, false},                 // NameGroup
    {"", true, false, true, false, false},                 // ColourGroup
    {"", true, false, true, false, false},                 // SetAppearance
    {"", true, false, true, false, false},                 // SetPeople
    {"Reverse orders", true, true, false, false, true},    // ReverseQueue
}};

/// The traits of a command.
inline const CommandTraits& traitsOf(const CommandBody& body) {
    return kCommandTraits[body.index()];
}

}  // namespace muster
