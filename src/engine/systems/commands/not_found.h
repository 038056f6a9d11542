// Answers to commands that name what there is not.
#pragma once

#include <string>

#include "muster/id.h"
#include "muster/status.h"

namespace muster {

/// The answer to a command that names a group that there is not.
inline Status noGroup(GroupId id) {
    return {StatusCode::NotFound, "no group has the id " + std::to_string(id.value)};
}

/// The answer to a command that names a character that there is not.
inline Status noCharacter(std::uint32_t id) {
    return {StatusCode::NotFound, "no character has the id " + std::to_string(id)};
}

}  // namespace muster
