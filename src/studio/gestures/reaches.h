// How far hands reach on the display, and what counts as a click (docs/method/gestures.md).
#pragma once

#include "studio/gestures/input_event.h"

namespace muster {

inline constexpr double kFingertip = 7.0;     ///< A finger takes what is so near [mm].
inline constexpr double kMouseTip = 3.0;      ///< A mouse takes what is so near [mm].
inline constexpr double kTapTravel = 4.0;     ///< A tap moves less than this [mm].
inline constexpr double kClickTravel = 2.0;   ///< A click moves less than this [mm].
inline constexpr double kTapTime = 0.35;      ///< A tap or click is shorter than this [s].
inline constexpr double kDoubleTime = 0.4;    ///< Two taps or clicks within it count as double [s].
inline constexpr double kDoubleTravel = 8.0;  ///< Two taps of a finger are so near each other [mm].

/// What a pointer takes [mm].
constexpr double reachOf(PointerDevice device) {
    return device == PointerDevice::Mouse ? kMouseTip : kFingertip;
}
/// What a pointer may move and is still a click or tap [mm].
constexpr double travelOf(PointerDevice device) {
    return device == PointerDevice::Mouse ? kClickTravel : kTapTravel;
}

}  // namespace muster
