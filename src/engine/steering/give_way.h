// Giving way: people leave the ground that a moving obstacle is about to sweep, or do not enter it (SPEC A5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/crowd_bodies.h"
#include "muster/generated/parameters.h"

namespace muster {

struct Characters;

/// Changes preferred velocities before moving obstacles. The ground that a piece of an obstacle sweeps is
/// taken as a lane along its velocity. A character in the lane leaves it by the quicker side, in time; one
/// beside it enters only if there is time to cross. Characters that touch one that leaves make room.
class GiveWay {
public:
    /// Overwrites `preferred` velocities [m/s] of characters that give way. `topSpeed` is that of each
    /// character [m/s]; `neighbours` lists all pairs that nearly touch.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, std::span<const double> topSpeed, std::span<Vec2> preferred);
    /// By character: the velocity at which it left a lane in the last run [m/s], null if it did not; empty
    /// where no character did.
    std::span<const Vec2> leaving() const { return leaving_; }

private:
    // The ground ahead of one piece, in axes along and across its velocity.
    struct Lane {
        Vec2 centre, along, across;
        double speed;
        double rear, front;  // Rear and front of the piece, from its centre along the lane [m].
        double right, left;  // Sides of the lane, for the centres of characters [m].
    };

    static Lane laneOf(const ObstaclePiece& piece, double radius);
    static Lane widened(Lane lane, double by);
    void giveWay(const Lane& lane, const Environment& environment, Vec2 position, double topSpeed,
                 double radius, std::size_t character, Vec2& preferred);
    static void follow(const Lane& lane, double along, double across, Vec2& preferred);
    void leave(const Lane& lane, const Environment& environment, Vec2 position, double topSpeed,
               double radius, std::size_t character, double timeLeft, Vec2 preferred);
    void passOn(const CrowdBodies& bodies, const Characters& now, const NeighbourList& neighbours);

    std::vector<Lane> lanes_;
    std::vector<Vec2> leaving_;  // By character: the velocity at which it leaves a lane; null for none.
    std::vector<std::uint8_t> leaves_;  // By character: 1 if it leaves a lane.
    std::vector<double> slack_;         // By character that leaves a lane: time left over [s].
};

}  // namespace muster
