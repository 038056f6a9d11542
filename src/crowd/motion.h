// Motion ids: which clip the ground asks of each character (SPEC C1, C3, C4).
#pragma once

#include <cstdint>
#include <vector>

#include "crowd/characters.h"
#include "environment/environment.h"

namespace muster {

/// A change of a character's motion.
enum class MotionChange : std::uint8_t { EnterPatch, LeavePatch, TransitionStart, TransitionEnd, SingleStep };

/// What happened to whom.
struct MotionEvent {
    MotionChange change = MotionChange::EnterPatch;
    std::int32_t character = 0;  ///< Index into the arrays.
    std::uint32_t value = 0;     ///< Patch for entering and leaving, motion id else.
};

/// A single-step motion is not done again until its patch has been left for this long [s].
inline constexpr double kRearmTime = 0.5;

/// Brings motion, phase, motionTime, patch and lastSingle up to date with positions; appends to `events` in
/// ascending order of characters. Entering a patch: cyclic motions play their transition first, single-step
/// motions lock the character until it has left the patch. Leaving plays the transition out.
void updateMotions(const Environment& environment, double dt, Characters& characters,
                   std::vector<MotionEvent>& events);

}  // namespace muster
