// The axes of bodies that lean or lie, from hips to head, seen from above: who crawls or swims keeps a
// distance from those ahead that follows its length (SPEC A6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/characters.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// How far a body reaches along its heading.
struct BodyReach {
    double ahead = 0.0;   ///< From the character's position to its head [m].
    double behind = 0.0;  ///< From there back to its hips [m].
};

/// The axes of those characters that lean or lie, or are about to. Costs nothing where there are no patches.
class BodyAxes {
public:
    /// Reads who has an axis now. `place` and `placeVelocity` are those of each character's place [m, m/s].
    void resolve(const Environment& environment, const Characters& now, std::span<const Vec2> place,
                 std::span<const Vec2> placeVelocity);
    /// True where nobody has one.
    bool none() const { return members_.empty(); }

    /// Slows in `preferred` [m/s] who would come too near somebody ahead that goes the same way.
    void keepDistance(const CrowdBodies& bodies, const Characters& now, std::span<Vec2> preferred) const;
    /// Calls `correct(a, moveA, b, moveB)` for each pair of axes that are too near at `positions`, with what
    /// moves each of both away from the other [m]. Returns the largest depth [m].
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
    // One character with an axis.
    struct Member {
        std::int32_t character = 0;
        BodyReach reach;  // As it lies now.
        BodyReach lying;  // As it will lie.
        Vec2 heading;
        bool settled = false;  // True at its place, which stands.
        Vec2 onward;           // In a single-step motion its way, on which nobody is pushed back; else zero.
    };
    // How two axes overlap.
    struct Overlap {
        Vec2 away;           // Unit vector from the lower to the higher one.
        double depth = 0.0;  // [m]
        double share = 0.5;  // Of the lower one.
    };

    // What corrects an overlap.
    struct Correction {
        double depth = 0.0;      // Of the overlap [m].
        Vec2 moveLow, moveHigh;  // Of the lower and the higher one [m].
    };

    Correction correctionOf(NeighbourPair pair, std::span<const Vec2> positions) const;
    Overlap axesOverlap(const Member& a, const Member& b, std::span<const Vec2> positions) const;

    std::vector<Member> members_;
    std::vector<Vec2> positions_;  // Of members [m].
    NeighbourList pairs_;          // Indices into members_.
};

}  // namespace muster
