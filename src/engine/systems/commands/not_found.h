// Answers to commands that name a thing which does not exist.
#pragma once

#include <cstdint>
#include <string>

#include "muster/id.h"
#include "muster/status.h"

namespace muster {

/// The answer to a command that names a thing that does not exist; `what` is its kind, as "group".
inline Status notFound(const char* what, std::uint32_t id) {
    return {StatusCode::NotFound, std::string("no ") + what + " has the id " + std::to_string(id)};
}
/// The answer to a command that names a group that does not exist.
inline Status noGroup(GroupId id) {
    return notFound("group", id.value);
}
/// The answer to a command that names a character that does not exist.
inline Status noCharacter(std::uint32_t id) {
    return notFound("character", id);
}

}  // namespace muster
