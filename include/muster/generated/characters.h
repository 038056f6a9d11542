// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// Read access to the characters of a world, and to the contacts between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "muster/generated/enumerations.h"
#include "muster/generated/people_definitions.h"
#include "muster/ground.h"
#include "muster/vec2.h"

namespace muster {

/// All characters of a world: one entry per character in each array, in ascending order of ids. No copies are
/// made, and arrays are valid until the world steps or ends.
struct CharactersView {
    std::span<const std::uint32_t> id;     ///< Unique id; it is not reused after the character has left.
    std::span<const std::uint32_t> group;  ///< Index of its group.
    std::span<const Vec2> position;        ///< Position [m].
    std::span<const Vec2> velocity;        ///< Velocity [m/s].
    std::span<const Vec2> heading;         ///< Unit vector in which the body faces.
    std::span<const std::int32_t> place;   ///< Index of its place in its group; -1 for the unmatched.
    /// Unit vector along its planned path; zero where there is no path.
    std::span<const Vec2> direction;
    std::span<const double> cost;          ///< Cost of the path to its place; infinite for the unmatched.
    std::span<const MotionId> motion;      ///< Motion it performs: an index into the world's clips.
    std::span<const MotionPhase> phase;    ///< Phase of that motion.
    std::span<const double> motionTime;    ///< Time since the phase began [s].
    std::span<const std::uint32_t> patch;  ///< Id of the patch that it is in; 0 for none.
    std::span<const Body> body;            ///< What it is.
    std::span<const Driver> driver;        ///< Who moves it.
    /// Velocity that steering aims at on the ground it is on, before bounds and contacts [m/s]. Those that
    /// are moved from outside have it too.
    std::span<const Vec2> wantedVelocity;
    std::span<const std::uint32_t> goal;  ///< Exit or waiting area that it goes to; 0 for none.

    std::size_t size() const { return id.size(); }  ///< Number of entries.
};

/// Overlaps of bodies that remain after a step.
struct ContactReport {
    std::int32_t overlapPairs = 0;  ///< Pairs that overlap by more than 10 % of the sum of their radii.
    double worstPenetration = 0.0;  ///< Overlap of the deepest pair, as a share of that.
};

}  // namespace muster
