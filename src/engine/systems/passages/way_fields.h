// Walks to all known passages.
#pragma once

#include <array>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/passages/walk_field.h"
#include "engine/passages/way_number.h"

namespace muster {

/// One walk field per passage. They follow from the passages and the static ground. All passages are closed
/// in each, so that the two sides of a passage are rooms.
class WayFields {
public:
    /// Takes the fields of these passages on this ground, which must outlive the next update. Solves at once
    /// the fields that are neither known nor prepared.
    void update(const StaticGround& ground, const std::vector<Passage>& passages);
    /// Solves the fields of further passages for a later update(), up to `cells` cells, from which it
    /// subtracts the cells used. Adds them to `done`, the count of cells for these fields. True when all are
    /// ready.
    bool prepare(const StaticGround& ground, const std::vector<Passage>& passages, std::int64_t& done,
                 std::int64_t& cells);
    /// Makes the next prepare() repeat what was done: after loading.
    void forget() { preparing_ = false; }

    const StaticGround& ground() const { return *ground_; }  ///< The ground of the last update.
    /// The passages of the last update.
    const std::vector<Passage>& passages() const { return present_.passages; }
    /// Locates a point for walks to all passages, of which there must be some.
    WalkSpot spot(Vec2 p) const { return present_.fields.front().spot(p); }
    /// The walk from a spot to a passage.
    Walk walk(std::size_t passage, const WalkSpot& spot) const {
        return present_.fields[passage].atSpot(spot);
    }
    /// The walk from `p` to a passage.
    Walk walk(std::size_t passage, Vec2 p) const { return present_.fields[passage].at(p); }
    /// The first `most` cells of the walk from `p` to a passage, as points [m].
    void trace(std::size_t passage, Vec2 p, std::size_t most, std::vector<Vec2>& path) const {
        present_.fields[passage].trace(p, most, path);
    }
    /// The point itself, or, if it is beside the line of a passage, one clearly on the same side: cells on
    /// the line belong to one side as a whole.
    Vec2 inRoom(Vec2 p) const;
    /// True for a point past the line of the passage of a way; never where `way` is -1.
    bool isInside(std::int32_t way, Vec2 p) const;
    /// True for a point before the passage of a way; never where `way` is -1.
    bool isBefore(std::int32_t way, Vec2 p) const {
        return way >= 0 && walk(passageOf(way), p).side == sideBefore(way);
    }

private:
    /// The fields of some passages on one ground.
    struct Set {
        std::vector<Passage> passages;
        std::uint32_t ground = 0;
        std::vector<WalkField> fields;  // At least one per passage.
        std::size_t solved = 0;         // Number of complete fields.

        bool holds(const StaticGround& now, const std::vector<Passage>& wanted) const;
    };

    void begin(const StaticGround& ground, const std::vector<Passage>& passages);
    bool solve(const StaticGround& ground, std::int64_t& cells);

    const StaticGround* ground_ = nullptr;
    Set present_, other_;  // The set in use, and the one that was in use before or is prepared.
    bool preparing_ = false;
    WalkEdges edges_;
    WalkSolver solver_;
};

/// True where two points are on different sides of the passage to which they walk.
bool onOppositeSides(const Walk& one, const Walk& other);

}  // namespace muster
