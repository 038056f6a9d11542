// Checks of single fields of commands. Each fails with InvalidArgument or LimitExceeded, naming the field.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/command.h"

namespace muster {

/// Whether the world knows a motion shows when the command is applied.
inline constexpr std::int32_t kAnyMotion = 1000;

/// A position in the world.
Status place(const char* field, Vec2 p);
/// So many positions, `least` to `most`.
Status places(const char* field, const std::vector<Vec2>& points, std::size_t least, std::size_t most);
/// Ids of characters: at least one, none of them twice.
Status eachOnce(const std::vector<std::uint32_t>& ids);
/// A number from `low` to `high`, both as they are written.
Status numberIn(const char* field, double value, double low, double high, const char* range);
/// The same for a whole number.
Status countIn(const char* field, std::int32_t value, std::int32_t low, std::int32_t high);
}  // namespace muster
