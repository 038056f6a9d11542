// Motion ids: the clip that each character plays on its ground (paper sections 6.2.2 and 6.2.3, SPEC C1, C3,
// C4).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"

namespace muster {

/// Kinds of changes of a character's motion.
enum class MotionChange : std::uint8_t { EnterPatch, LeavePatch, TransitionStart, TransitionEnd, SingleStep };

/// One change.
struct MotionEvent {
    MotionChange change = MotionChange::EnterPatch;  ///< Its kind.
    std::int32_t character = 0;                      ///< Index of the character.
    std::uint32_t value = 0;  ///< Id of the patch for EnterPatch and LeavePatch, else the motion id.
};

/// A single-step motion is repeated only after its patch has been left for this long [s].
inline constexpr double kRearmTime = 0.5;

/// Updates motion, phase, motionTime, patch and lastSingle from positions and appends to `events` in
/// ascending order of characters. On entering a patch cyclic motions play their transition first; single-step
/// motions lock the character until it has left the patch. Leaving plays the transition out.
void updateMotions(const Environment& environment, double dt, Characters& characters,
                   std::vector<MotionEvent>& events);

}  // namespace muster
