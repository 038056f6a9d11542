// Answers to commands that name what there is not.
#pragma once

#include <cstdint>
#include <string>

#include "muster/id.h"
#include "muster/status.h"

namespace muster {

/// The answer to a command that names a thing that there is not: "group".
inline Status notFound(const char* what, std::uint32_t id) {
    return {StatusCode::NotFound, std::string("no ") + what + " has the id " + std::to_string(id)};
}
/// The same for a group.
inline Status noGroup(GroupId id) {
    return notFound("group", id.value);
}
/// The same for a character.
inline Status noCharacter(std::uint32_t id) {
    return notFound("character", id);
}

}  // namespace muster
