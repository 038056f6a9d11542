// The axes of bodies that lean or lie, from hips to head, seen from above: a character that crawls or swims
// keeps a distance from bodies ahead that follows their length (SPEC A6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// Reach of a body along its heading.
struct BodyReach {
    double ahead = 0.0;   ///< Distance from the character's position to its head [m].
    double behind = 0.0;  ///< Distance from the character's position back to its hips [m].
};

/// The axes of characters that lean or lie, or are about to. Costs nothing where there are no patches.
class BodyAxes {
public:
    /// Finds the characters that have an axis now. `place` and `placeVelocity` are those of each character's
    /// place [m, m/s].
    void resolve(const Environment& environment, const Characters& now, std::span<const Vec2> place,
                 std::span<const Vec2> placeVelocity);
    /// True where no character has an axis.
    bool none() const { return members_.empty(); }

    /// Slows characters in `preferred` [m/s] that would come too near a body ahead which goes the same way.
    void keepDistance(const CrowdBodies& bodies, const Characters& now, std::span<Vec2> preferred) const;
    /// Calls `correct(a, moveA, b, moveB)` for each pair of axes that are too near at `positions`, with the
    /// moves that take each away from the other [m]. Returns the largest depth [m].
    template <class Correct>
    double forOverlaps(std::span<const Vec2> positions, const Correct& correct) const {
        double worst = 0.0;
        for (const NeighbourPair pair : pairs_.pairs()) {
            const Correction correction = correctionOf(pair, positions);
            if (correction.depth <= 0.0) continue;
            worst = correction.depth > worst ? correction.depth : worst;
            correct(members_[pair.low].character, correction.moveLow, members_[pair.high].character,
                    correction.moveHigh);
        }
        return worst;
    }

private:
    // A character with an axis.
    struct Member {
        std::int32_t character = 0;
        BodyReach reach;  // Reach of the body as it lies now.
        BodyReach lying;  // Reach of the body once it lies.
        Vec2 heading;
        bool settled = false;  // True if it is at its place, and the place stands.
        Vec2 onward;  // Direction of a single-step motion, against which it is not pushed; else zero.
    };
    // Overlap of two axes.
    struct Overlap {
        Vec2 away;           // Unit vector from the lower to the higher member.
        double depth = 0.0;  // [m]
        double share = 0.5;  // Share of the lower member.
    };

    // Correction of an overlap.
    struct Correction {
        double depth = 0.0;      // Depth of the overlap [m].
        Vec2 moveLow, moveHigh;  // Moves of the lower and the higher member [m].
    };

    Correction correctionOf(NeighbourPair pair, std::span<const Vec2> positions) const;
    Overlap axesOverlap(const Member& a, const Member& b, std::span<const Vec2> positions) const;

    std::vector<Member> members_;
    std::vector<Vec2> positions_;  // Positions of members [m].
    NeighbourList pairs_;          // Indices into members_.
};

}  // namespace muster
