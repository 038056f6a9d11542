// The state of all characters of a world, as a structure of arrays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/steering/claim.h"
#include "engine/steering/walk_progress.h"
#include "muster/characters.h"
#include "muster/generated/people_definitions.h"

namespace muster {

/// Through which passage a character goes, and when.
struct ChosenWay {
    /// Its number (engine/passages/way_number.h); -1 for none.
    std::int32_t way = -1;
    std::uint32_t turns = 0;  ///< Changes of the passage since the last command.
    double passAt = 0.0;      ///< When it is let through, by the plan [s].
    double share = 0.5;       ///< Where it goes through: 0 at one end of the gap, 1 at the other.

    /// Lets an archive read or write it.
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
    std::vector<Vec2> heading;         ///< Unit vector that it faces.
    std::vector<std::int32_t> place;   ///< Index of its place in its group; -1 for the unmatched.
    std::vector<Vec2> direction;       ///< Unit vector along the planned path; zero for none.
    std::vector<double> cost;          ///< Cost of the path to its place; infinite for the unmatched.
    std::vector<std::int32_t> motion;  ///< Motion id, an index into the world's clips.
    std::vector<MotionPhase> phase;    ///< Phase of the motion.
    std::vector<double> motionTime;    ///< Time since the phase began [s].
    std::vector<std::uint32_t> patch;  ///< Id of the patch that it is in; 0 for none.
    /// Id of the single-step patch crossed last, which is not done again until it has been left for a while;
    /// 0 for none.
    std::vector<std::uint32_t> lastSingle;
    std::vector<WalkProgress> walk;   ///< How each gets on with its way.
    std::vector<Claim> claim;         ///< What ranks each among others.
    std::vector<ChosenWay> chosen;    ///< The way to the place, where many go.
    std::vector<Body> body;           ///< What each is.
    std::vector<Driver> driver;       ///< Who moves it.
    std::vector<Vec2> wanted;         ///< Velocity that steering aimed at in the last step [m/s].
    std::vector<std::uint32_t> goal;  ///< Id of the exit or waiting area that it goes to; 0 for none.
    /// Step from which it walks: it stands until its premovement time is over; 0 where it has had no order.
    std::vector<std::uint32_t> setsOutAt;

    /// False for who stands yet, since its premovement time is not over.
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
    /// The same for reading.
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
