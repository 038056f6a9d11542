// The claim of a character on the ground ahead of it: what ranks it among others, and whether it gets on.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Most turns by 20 degrees with which a character overtakes.
inline constexpr std::int8_t kOvertakingTurns = 3;

/// The claim of one character.
struct Claim {
    Vec2 spot;              ///< Where its place was when it came to rest there [m].
    float progress = 1.0f;  ///< Its speed lately, along its direction, as a share of
                            ///< CrowdBodies::crowdedSpeed().
    float stuck = 0.0f;     ///< Time for which it has not got on [s].
    float lends = 0.0f;     ///< It lends its way for so long yet [s].
    float last = 0.0f;      ///< Others go before it for so long yet [s].
    std::uint32_t
        since = 0;       ///< Step from which its turn counts: of its order, or in which it gave up its turn.
    bool rests = false;  ///< It has come to its place, and has had no other way since.
    bool settled = false;  ///< It rests beside its place, because it came no nearer.
    bool follows = false;  ///< Its group follows somebody.
    bool stays = false;    ///< It has not set out yet: its premovement time is not over.
    bool asks = false;     ///< It asked others for their way in the last step.
    bool queues = false;   ///< In the last step it kept behind somebody who goes the same way.
    /// How it turns to overtake: by so many times 20 degrees, to the left where positive.
    std::int8_t turn = 0;

    /// Lets an archive read or write the claim.
    template <class Archive>
    void visit(Archive& archive) {
        archive(spot, progress, stuck, lends, last, since, rests, settled, follows, stays, asks, queues,
                turn);
    }
};

/// Whether a character gets on: lately at more than 0.3 of the speed of a crowd, which is its top speed where
/// all go in step.
inline bool getsOn(const Claim& claim) {
    return claim.progress > 0.3f;
}

}  // namespace muster
