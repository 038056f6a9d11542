// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// What the studio has to know of each kind of command.
#pragma once

#include <array>

#include "muster/command.h"

namespace muster {

/// What is true of a command.
struct CommandTraits {
    const char* label;  ///< What undo and redo call it; empty where that depends on more.
    bool undoable;      ///< It can be taken back.
    bool directs;       ///< It directs a group: a director may send it.
    bool edits;         ///< It edits the place.
    bool slides;        ///< A slider sends many of them, which count as one.
    bool queues;        ///< It changes the queue of its group in a way that only the world knows.
};

/// Those of each kind.
inline constexpr std::array<CommandTraits, std::variant_size_v<CommandKinds>> kCommandTraits{{
    {"", false, false, false, false, false},               // Touch
    {"", false, true, false, false, false},                // AddControl
    {"Pin", true, true, false, false, false},              // EditControl
    {"", false, false, false, false, false},               // ReleaseClient
    {"Change group", true, false, false, false, false},    // ChangeGroup
    {"Place group", true, true, false, false, false},      // SetPose
    {"Add group", true, true, true, false, false},         // AddGroup
    {"Remove group", true, false, true, false, false},     // RemoveGroup
    {"", true, false, true, false, false},                 // PutThing
    {"", true, false, true, false, false},                 // RemoveThing
    {"Setting", true, true, true, true, false},            // SetParameter
    {"", true, true, false, false, false},                 // GiveOrder
    {"", true, true, false, false, false},                 // EditQueue
    {"Add people", true, true, false, false, false},       // AddCharacters
    {"Transfer people", true, true, false, false, false},  // TransferCharacters
    {"Split", true, true, false, false, false},            // SplitGroup
    {"Merge", true, true, false, false, false},            // MergeGroups
    {"", true, false, false, false, false},                // ChangeCharacters
    {"", true, false, false, false, false},                // WriteMotion
    {"Reverse orders", true, true, false, false, true},    // ReverseQueue
}};

// What undo and redo call commands that hold such a value.
inline constexpr std::array kOrderKindLabels{"Move", "Turn", "Follow", "Guard", "Leave", "Wait", "Walk on"};
inline constexpr std::array kControlEditLabels{"Pin", "Release pin", "Remove control"};
inline constexpr std::array kQueueEditLabels{"Cancel order", "Hold", "Go on", "Patrol", "End patrol", "Stop"};

/// The traits of a command: those of its kind or, where it gives fields that have their own, those that all
/// of these have.
inline CommandTraits traitsOf(const CommandBody& body) {
    CommandTraits traits = kCommandTraits[body.index()];
    auto give = [&, first = true](bool given, const CommandTraits& of) mutable {
        if (!given) return;
        if (first && *of.label != '\0') traits.label = of.label;
        traits.directs = of.directs && (first || traits.directs);
        traits.edits = of.edits && (first || traits.edits);
        traits.slides = of.slides && (first || traits.slides);
        first = false;
    };
    if (const auto* c = std::get_if<ChangeGroup>(&body)) {
        give(c->formation.has_value(), {"Change shape", true, true, true, false, false});
        give(c->count.has_value(), {"People", true, true, true, true, false});
        give(c->people.has_value(), {"", true, false, true, false, false});
        give(c->conduct.has_value(), {"Conduct", true, true, true, true, false});
        give(c->roles.has_value(), {"Roles", true, true, true, false, false});
        give(c->demands.has_value(), {"Demands", true, true, true, true, false});
        give(c->name.has_value(), {"", true, false, true, false, false});
        give(c->colour.has_value(), {"", true, false, true, false, false});
        give(c->look.has_value(), {"", true, false, true, false, false});
    }
    if (const auto* c = std::get_if<SetPose>(&body)) {
        give(c->characters, {"", true, false, true, false, false});
    }
    if (const auto* c = std::get_if<ChangeCharacters>(&body)) {
        give(c->bodies.has_value(), {"Bodies", true, true, true, false, false});
        give(c->driver.has_value(), {"", true, false, false, false, false});
    }
    return traits;
}

}  // namespace muster
