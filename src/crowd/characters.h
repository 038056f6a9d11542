// The state of all characters of a world, as a structure of arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/characters.h"

namespace muster {

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

    /// Number of characters.
    std::size_t size() const { return id.size(); }
    /// The same for reading.
    CharactersView view() const {
        return {id,        group, position, velocity, heading,    place,
                direction, cost,  motion,   phase,    motionTime, patch};
    }

    /// Lets an archive read or write all arrays.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, group, position, velocity, heading, place, direction, cost, motion, phase, motionTime,
                patch, lastSingle);
    }
};

}  // namespace muster
