// The state of all characters of a world, as a structure of arrays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/steering/claim.h"
#include "engine/steering/walk_progress.h"
#include "muster/generated/characters.h"
#include "muster/generated/people_definitions.h"

namespace muster {

/// The passage that a character goes through, and its time.
struct ChosenWay {
    /// Number of the way (engine/passages/way_number.h); -1 for none.
    std::int32_t way = -1;
    std::uint32_t turns = 0;  ///< Changes of the passage since the last command.
    double passAt = 0.0;      ///< Time at which it is let through, by the plan [s].
    double share = 0.5;       ///< Position in the gap: 0 at one end, 1 at the other.

    /// Lets an archive read or write the way.
    template <class Archive>
    void visit(Archive& archive) {
        archive(way, turns, passAt, share);
    }
};

/// One entry per character in each array, in ascending order of ids.
struct Characters {
    std::vector<std::uint32_t> id;     ///< Unique; never used again.
    std::vector<std::uint32_t> group;  ///< Index into the world's groups.
    std::vector<Vec2> position;        ///< [m]
    std::vector<Vec2> velocity;        ///< [m/s]
    std::vector<Vec2> heading;         ///< Unit vector that the character faces.
    std::vector<std::int32_t> place;   ///< Index of its place in its group; -1 for unmatched characters.
    std::vector<Vec2> direction;       ///< Unit vector along the planned path; zero for none.
    std::vector<double> cost;          ///< Cost of the path to its place; infinite for unmatched characters.
    std::vector<std::int32_t> motion;  ///< Motion id, an index into the world's clips.
    std::vector<MotionPhase> phase;    ///< Phase of the motion.
    std::vector<double> motionTime;    ///< Time since the phase began [s].
    std::vector<std::uint32_t> patch;  ///< Id of the patch under the character; 0 for none.
    /// Id of the single-step patch crossed last, which is not repeated until the character has left it for a
    /// while; 0 for none.
    std::vector<std::uint32_t> lastSingle;
    std::vector<WalkProgress> walk;   ///< Progress of each character on its path.
    std::vector<Claim> claim;         ///< Rank of each character among others.
    std::vector<ChosenWay> chosen;    ///< Passage on the path to its place, where many share it.
    std::vector<Body> body;           ///< Body of each character.
    std::vector<Driver> driver;       ///< What moves the character: Muster, or the game from outside.
    std::vector<Vec2> wanted;         ///< Velocity that steering aimed at in the last step [m/s].
    std::vector<std::uint32_t> goal;  ///< Id of the exit or waiting area to which it goes; 0 for none.
    /// Step from which it walks, after its premovement time; 0 where it has had no order.
    std::vector<std::uint32_t> setsOutAt;

    /// False for a character whose premovement time is not over.
    bool hasSetOut(std::size_t i, std::uint32_t step) const {
        return i >= setsOutAt.size() || step >= setsOutAt[i];
    }
    /// Number of characters.
    std::size_t size() const { return id.size(); }
    /// Index of the character with an id; -1 for none.
    std::int32_t indexOf(std::uint32_t wantedId) const {
        const auto at = std::lower_bound(id.begin(), id.end(), wantedId);
        return at != id.end() && *at == wantedId ? static_cast<std::int32_t>(at - id.begin()) : -1;
    }
    /// The arrays for reading.
    CharactersView view() const {
        return {id,     group, position,   velocity, heading, place,  direction, cost,
                motion, phase, motionTime, patch,    body,    driver, wanted,    goal};
    }

    /// Lets an archive read or write all arrays.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, group, position, velocity, heading, place, direction, cost, motion, phase, motionTime,
                patch, lastSingle, walk, claim, chosen, body, driver, wanted, goal, setsOutAt);
    }
};

}  // namespace muster
