// Right of way: of two agents that do not go the same way, one goes first and the other makes room; an agent
// that is blocked nevertheless asks others to lend their way (after priority inheritance with backtracking,
// Okumura et al. 2019).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/claim.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/near_rows.h"

namespace muster {

/// The order of a group, as far as others have to know.
struct GroupClaim {
    std::uint32_t since = 0;  ///< Step in which its order began.
    bool follows = false;     ///< True if it follows or guards a group or character, which goes first.
};

/// Inputs of claims, one entry per character where nothing else is said.
struct ClaimInput {
    const CrowdBodies& bodies;            ///< Body of each character.
    std::span<const double> topSpeed;     ///< Top speed on its ground [m/s].
    std::span<const Vec2> wanted;         ///< Velocity along its own path [m/s].
    std::span<const Vec2> place;          ///< Point for which it heads [m],
    std::span<const Vec2> placeVelocity;  ///< and the velocity of that point [m/s].
    std::span<const double> room;         ///< Room around a shared place [m]; empty where none is shared.
    std::span<const GroupClaim> groups;   ///< One entry per group; empty where no group has an order.
    std::uint32_t step = 0;               ///< Number of the step.
    double dt = 1.0 / 60.0;               ///< Length of the step [s].
};

/// Ranks characters, and lets blocked characters ask others for their way.
class RightOfWay {
public:
    /// Updates all claims from the progress of characters in the last step. Returns true where a character is
    /// blocked, or still lends its way.
    bool count(const ClaimInput& input, const Characters& characters, std::span<Claim> claims);
    /// Ranks all characters, and changes `wanted` [m/s] of those that lend their way. A character that leaves
    /// a lane of a moving obstacle (`leaving` is not null; empty for none) goes first; it neither asks nor is
    /// asked. The same holds for a character that stays until its premovement time is over.
    void run(const CrowdBodies& bodies, const Environment& environment, const NearRows& rows,
             std::span<const double> topSpeed, std::span<const Vec2> leaving, const Characters& characters,
             std::span<Claim> claims, std::span<Vec2> wanted);

    /// True where `a` has the right of way before `b`.
    bool precedes(std::int32_t a, std::int32_t b) const { return rank_[a] < rank_[b]; }

private:
    // The agent to which a character lends its way.
    struct Lender {
        std::int32_t to = -1;  // Index of that agent; -1 for none.
        double need = 0.0;     // Distance within which other agents are asked in turn [m].
    };

    void reserve(std::size_t count);
    void sort(const CrowdBodies& bodies, const Characters& now, std::span<const Vec2> leaving,
              std::span<const Claim> claims);
    void sortByAge(const CrowdBodies& bodies, std::span<const Claim> claims);
    void joinFiles(const Characters& now, const NearRows& rows, std::span<const Vec2> own);
    void askFrom(std::int32_t first, const CrowdBodies& bodies, const Environment& environment,
                 const NearRows& rows, std::span<const double> topSpeed, const Characters& characters,
                 std::span<Claim> claims, std::span<Vec2> wanted);
    void lend(std::int32_t asker, const Near& near, Vec2 along, const CrowdBodies& bodies,
              const Environment& environment, const NearRows& rows, double topSpeed,
              const Characters& characters, Vec2& wanted);

    std::vector<std::int32_t> byAge_, order_, files_, rank_, stack_;
    std::vector<std::uint8_t> class_, done_;
    std::vector<std::uint8_t> open_;  // Class of each agent that is in no file yet.
    std::vector<Vec2> own_;           // Directions along the own path, as shares of top speed.
    std::vector<Lender> lender_;
};

}  // namespace muster
