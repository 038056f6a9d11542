// Orders and changes of units as clients send them: events in the words of gesture files; and kinds of
// commands.
#pragma once

#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/session.h"

namespace muster {

/// Reads events; the session sets time, step and client. Only orders, changes of units, formations and poses
/// are allowed: fingers and edits of the place come in messages of their own. Fails with one sentence that
/// names the event.
Result<std::vector<CommandBody>> parseCommandText(std::string_view text, const SessionLimits& limits);
/// The same for edits of the place: what stands and lies in it, and its groups.
Result<std::vector<CommandBody>> parseEditText(std::string_view text, const SessionLimits& limits);

/// True where the command is of one of these kinds.
template <class... Kinds>
bool isOneOf(const CommandBody& body) {
    return (std::holds_alternative<Kinds>(body) || ...);
}

}  // namespace muster
