// Made by schema/generate.mjs from schema/former.txt: change these, not this file.
// Any command by a name that it had, and what takes call it.
#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "muster/generated/former_commands.h"

namespace muster {

/// Any of them.
using FormerKinds = std::variant<
    AddObstacle, ChangeObstacle, RemoveObstacle, AddPatch, ChangePatch, RemovePatch, AddItem, ChangeItem,
    RemoveItem, AddCheckpoint, ChangeCheckpoint, RemoveCheckpoint, PutArea, RemoveArea>;

/// What takes call each of them, in their order.
inline constexpr std::array<std::uint8_t, 14> kFormerNumbers{
    13, 14, 15, 16, 17, 18, 33, 34, 35, 36, 37, 38, 43, 44};

}  // namespace muster
