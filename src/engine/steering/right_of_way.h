// Right of way: of two who do not go the same way, who goes first and who makes room; and who is asked to
// lend its way where that does not help (after priority inheritance with backtracking, Okumura et al. 2019).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/steering/characters.h"
#include "engine/steering/claim.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/near_rows.h"

namespace muster {

/// What a group does, as far as others have to know.
struct GroupClaim {
    std::uint32_t since = 0;  ///< Step in which its order began.
    bool follows = false;     ///< It follows or guards somebody, who goes first.
};

/// What claims are updated from, one entry per character where nothing else is said.
struct ClaimInput {
    const CrowdBodies& bodies;            ///< What each is.
    std::span<const double> topSpeed;     ///< On its ground [m/s].
    std::span<const Vec2> wanted;         ///< Velocity along the own way [m/s].
    std::span<const Vec2> place;          ///< Where each heads for [m],
    std::span<const Vec2> placeVelocity;  ///< and the velocity of that [m/s].
    std::span<const double> room;         ///< Around a shared place [m]; empty where none is shared.
    std::span<const GroupClaim> groups;   ///< One entry per group; empty where nobody has an order.
    std::uint32_t step = 0;               ///< Number of the step.
    double dt = 1.0 / 60.0;               ///< Length of the step [s].
};

/// Ranks characters, and lets those who are blocked ask others for their way.
class RightOfWay {
public:
    /// Updates all claims from how characters got on in the last step. Returns true where somebody is
    /// blocked, or lends its way yet.
    bool count(const ClaimInput& input, const Characters& characters, std::span<Claim> claims);
    /// Ranks all, and changes `wanted` [m/s] of those who lend their way. Who is leaving the way of something
    /// that moves (`leaving` is not null; empty for nobody) goes first; it neither asks nor is asked. The
    /// same holds for who stays until its premovement time is over.
    void run(const CrowdBodies& bodies, const Environment& environment, const NearRows& rows,
             std::span<const double> topSpeed, std::span<const Vec2> leaving, const Characters& characters,
             std::span<Claim> claims, std::span<Vec2> wanted);

    /// True where `a` has the right of way before `b`.
    bool precedes(std::int32_t a, std::int32_t b) const { return rank_[a] < rank_[b]; }

private:
    // Who lends its way to whom.
    struct Lender {
        std::int32_t to = -1;  // -1 for nobody.
        double need = 0.0;     // Others nearer than this are asked in turn [m].
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
    std::vector<std::uint8_t> open_;  // The class of who is in no file yet.
    std::vector<Vec2> own_;           // Directions along the own way, as shares of top speed.
    std::vector<Lender> lender_;
};

}  // namespace muster
