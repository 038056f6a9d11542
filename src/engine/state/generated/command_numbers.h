// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// What takes call each kind of command.
#pragma once

#include <array>
#include <cstdint>

namespace muster {

/// The numbers of kinds, in the order of CommandKinds.
// clang-format off
inline constexpr std::array<std::uint8_t, 20> kCommandNumbers{
    51, 4, 52, 7, 49, 10, 11, 12, 47, 48, 19, 20, 21, 23, 25, 26, 27, 50, 32, 46};
// clang-format on

/// The same of FormerKinds.
// clang-format off
inline constexpr std::array<std::uint8_t, 33> kFormerNumbers{
    13, 14, 15, 16, 17, 18, 33, 34, 35, 36, 37, 38, 43, 44, 8, 9, 22, 24, 28, 29, 30, 31, 39, 40, 41, 42, 45,
    0, 1, 2, 3, 5, 6};
// clang-format on

}  // namespace muster
