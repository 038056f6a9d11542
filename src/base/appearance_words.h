// The words of appearances in files and messages, by their values.
#pragma once

#include <array>

#include "muster/appearance.h"

namespace muster {

inline constexpr std::array kBuildWords{"broad", "narrow"};
inline constexpr std::array<const char*, kMotionSetCount> kMotionSetWords{"march", "weary"};

}  // namespace muster
