// Kinds of commands.
#pragma once

#include "muster/command.h"

namespace muster {

/// True where the command is of one of these kinds.
template <class... Kinds>
bool isOneOf(const CommandBody& body) {
    return (std::holds_alternative<Kinds>(body) || ...);
}

}  // namespace muster
