// Front crawl at the surface of a pool: the water lies at z = -0.10 m, the rim at 0.
#pragma once

#include "people/generator/clip_maker.h"

namespace muster::generator {

inline constexpr double kWaterLevel = -0.10;             ///< [m]
inline constexpr double kSwimCycle = 96.0 / kFrameRate;  ///< One stroke of each arm [s].
inline constexpr double kSwimSpeed = 0.78;               ///< [m/s]

/// The figure at a time, in the travelling frame. At time `start` the phase is 0 (the left hand enters the
/// water).
Figure swimFigure(double time, double start = 0.0);
/// The clip "swim".
Clip swimClip();

}  // namespace muster::generator
