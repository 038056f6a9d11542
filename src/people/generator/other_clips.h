// The clips beside gaits and crawling: standing, climbing, jumping, and the front crawl at the surface of a
// pool, whose water lies at z = -0.10 m and its rim at 0; and the manners of walking, which are motion sets.
#pragma once

#include <vector>

#include "muster/clip.h"
#include "people/generator/clip_maker.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

inline constexpr double kIdleCycle = 4.0;  ///< Duration of a cycle [s].

/// Trunk, head and arms of a body that stands, breathes and shifts its weight; phase 0 at time `start`.
ChannelValues idleBody(double time, double start = 0.0);
/// The step of a foot that stands for all time, with the character at `place`.
Step idleStep(std::size_t side, const Placement& place);
/// The clip "idle".
Clip idleClip();

/// The clip "climb": over a wall 1.3 m high and 0.4 m thick.
Clip climbClip();

/// Adds "jump" (a running jump with tucked feet) and "jump-over" (over a low obstacle, one leg leading).
void addJumps(std::vector<Clip>& clips);

inline constexpr double kWaterLevel = -0.10;             ///< Height of the water [m].
inline constexpr double kSwimCycle = 96.0 / kFrameRate;  ///< Duration of one stroke of each arm [s].
inline constexpr double kSwimSpeed = 0.78;               ///< Speed of swimming [m/s].

/// The figure at a time, in the travelling frame. At time `start` the phase is 0 (the left hand enters the
/// water).
Figure swimFigure(double time, double start = 0.0);
/// The clip "swim".
Clip swimClip();

/// Appends the gaits of all motion sets: "march-walk", "march-walk-left", "weary-jog"...
void addMotionSets(std::vector<Clip>& clips);

}  // namespace muster::generator
