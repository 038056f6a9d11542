// All characters of a world, as a structure of arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/characters.h"

namespace muster {

/// One entry per character in each array; the order is that of ids and never changes but by removal.
struct Characters {
    std::vector<std::uint32_t> id;     ///< Never used again.
    std::vector<std::uint32_t> group;  ///< Index into the world's groups.
    std::vector<Vec2> position;        ///< [m]
    std::vector<Vec2> velocity;        ///< [m/s]
    std::vector<Vec2> heading;         ///< Unit vector it faces.
    std::vector<std::int32_t> place;   ///< In its group; -1 for the unmatched.
    std::vector<Vec2> direction;       ///< Unit vector of the way by the plan; zero for none.
    std::vector<double> cost;          ///< Left to its place; infinite for the unmatched.
    std::vector<std::int32_t> motion;  ///< Motion id.
    std::vector<MotionPhase> phase;    ///< Within the motion.
    std::vector<double> motionTime;    ///< Since the phase began [s].
    std::vector<std::uint32_t> patch;  ///< Patch it is in, 0 for none.
    /// Single-step patch just done: not done again until left; 0 for none.
    std::vector<std::uint32_t> lastSingle;

    std::size_t size() const { return id.size(); }  ///< Number of characters.
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
