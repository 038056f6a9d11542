// Where groups stand when they go to a spot: beside what is in the way, and beside each other.
#pragma once

#include <optional>
#include <vector>

#include "studio/words/crews.h"

namespace muster::words {

/// Where a group is to stand.
struct Stand {
    Vec2 target;                    ///< [m]
    std::optional<double> facing;   ///< [rad]
    std::optional<double> spacing;  ///< Of a ring that has to be wider than its own [m].
};

/// How far a formation reaches from its centre [m].
struct Extent {
    double front = 0.5;
    double rear = 0.5;
    double side = 0.5;
    double inner = 0.0;  ///< Nobody stands nearer to the centre.

    double farthest() const { return std::max(std::max(front, rear), side); }
};
Extent extentOf(const FormationDef& formation, std::int32_t count);

/// The point that a spot names, as seen by somebody who stands there [m].
Vec2 pointOf(const Spot& spot, const World& world, const Crew& from);
/// Of several things of one name the nearest.
const ThingSpot& nearestOf(const std::vector<ThingSpot>& things, Vec2 from);
/// The unit vector of a heading; of a group's own headings by its front.
Vec2 directionOf(Heading heading, Rotation front);

/// Where each of these crews stands, in the formation that it will be in.
std::vector<Stand> standsAt(const Spot& spot, const World& world, const std::vector<Crew>& crews,
                            const std::vector<FormationDef>& formations);

}  // namespace muster::words
