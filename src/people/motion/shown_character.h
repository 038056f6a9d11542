// Who is shown otherwise than the simulation has them: elsewhere, by a chosen clip, or looking at something.
#pragma once

#include <cstdint>
#include <optional>

#include "muster/generated/enumerations.h"
#include "muster/vec2.h"
#include "muster/vec3.h"

namespace muster {

/// How one character is shown after a step.
struct ShownCharacter {
    std::uint32_t id = 0;  ///< Of the character.
    /// True where the place and the motion hold; else those of the simulation do.
    bool moved = false;
    Vec2 position;                            ///< [m]
    Vec2 velocity;                            ///< [m/s]
    Vec2 heading;                             ///< Unit vector that it faces.
    std::int32_t motion = 0;                  ///< Motion id of the ground there.
    MotionPhase phase = MotionPhase::Steady;  ///< Phase of that motion.
    double motionTime = 0.0;                  ///< Time since the phase began [s].
    std::uint32_t patch = 0;                  ///< Id of the patch there; 0 for none.
    std::uint32_t lastSingle = 0;             ///< As Characters::lastSingle.
    std::int32_t clip = -1;                   ///< Index of the clip that it is to play; -1 for none.
    std::optional<Vec3> look;                 ///< The point that it looks at [m].
};

}  // namespace muster
