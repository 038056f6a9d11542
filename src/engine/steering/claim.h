// The claim of a character on the ground ahead of it: its rank among others, and whether it gets on.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Greatest number of turns by 20 degrees with which a character overtakes.
inline constexpr std::int8_t kOvertakingTurns = 3;

/// The claim of one character.
struct Claim {
    Vec2 spot;  ///< Position of its place when the character came to rest there [m].
    /// Its recent speed along its direction, as a share of CrowdBodies::crowdedSpeed().
    float progress = 1.0f;
    float stuck = 0.0f;  ///< Time without getting on [s].
    float lends = 0.0f;  ///< Time for which it still lends its way [s].
    float last = 0.0f;   ///< Time for which others still go before it [s].
    /// Step from which its turn counts: of its order, or in which it gave up its turn.
    std::uint32_t since = 0;
    bool rests = false;    ///< True after it has come to its place, until it has another path.
    bool settled = false;  ///< True if it rests beside its place, because it came no nearer.
    bool follows = false;  ///< True if its group follows another group or a character.
    bool stays = false;    ///< True before it sets out: its premovement time is not over.
    bool asks = false;     ///< True if it asked others for their way in the last step.
    bool queues = false;   ///< True if it kept behind an agent that goes the same way in the last step.
    /// Turn to overtake, in units of 20 degrees, to the left where positive.
    std::int8_t turn = 0;

    /// Lets an archive read or write the claim.
    template <class Archive>
    void visit(Archive& archive) {
        archive(spot, progress, stuck, lends, last, since, rests, settled, follows, stays, asks, queues,
                turn);
    }
};

/// True for an agent that gets on: recently at more than 0.3 of the speed of a crowd, which is its top speed
/// where all go in step.
inline bool getsOn(const Claim& claim) {
    return claim.progress > 0.3f;
}

}  // namespace muster
