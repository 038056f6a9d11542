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
    /// Takes the fields of these passages on this ground, which must outlive the next update. Solves those at
    /// once that are neither known nor prepared.
    void update(const StaticGround& ground, const std::vector<Passage>& passages);
    /// Solves the fields of further passages for a later update(), for `cells` cells, which it takes off.
    /// Adds them to `done`, which counts what was solved of these fields. True when all are ready.
    bool prepare(const StaticGround& ground, const std::vector<Passage>& passages, std::int64_t& done,
                 std::int64_t& cells);
    /// The next prepare() repeats what was done: after loading.
    void forget() { preparing_ = false; }

    const StaticGround& ground() const { return *ground_; }                     ///< Of the last update.
    const std::vector<Passage>& passages() const { return present_.passages; }  ///< Of the last update.
    /// Locates a point for walks to all passages, of which there must be some.
    WalkSpot spot(Vec2 p) const { return present_.fields.front().spot(p); }
    /// The walk from a spot to a passage.
    Walk walk(std::size_t passage, const WalkSpot& spot) const {
        return present_.fields[passage].atSpot(spot);
    }
    /// The walk from `p` to a passage.
    Walk walk(std::size_t passage, Vec2 p) const { return present_.fields[passage].at(p); }
    /// The first cells, at most so many, of the walk from `p` to a passage, as points [m].
    void trace(std::size_t passage, Vec2 p, std::size_t most, std::vector<Vec2>& path) const {
        present_.fields[passage].trace(p, most, path);
    }
    /// The point itself, or beside the line of a passage one that lies clearly on the same side: cells on the
    /// line belong to one side as a whole.
    Vec2 inRoom(Vec2 p) const;
    /// True for one at `p` on a way, who has come past the line of its passage; never where `way` is -1.
    bool isInside(std::int32_t way, Vec2 p) const;
    /// True for one at `p` who has not come to its passage yet; never where `way` is -1.
    bool isBefore(std::int32_t way, Vec2 p) const {
        return way >= 0 && walk(passageOf(way), p).side == sideBefore(way);
    }

private:
    /// The fields of some passages on one ground.
    struct Set {
        std::vector<Passage> passages;
        std::uint32_t ground = 0;
        std::vector<WalkField> fields;  // At least one per passage.
        std::size_t solved = 0;         // Fields that are whole.

        bool holds(const StaticGround& now, const std::vector<Passage>& wanted) const;
    };

    void begin(const StaticGround& ground, const std::vector<Passage>& passages);
    bool solve(const StaticGround& ground, std::int64_t& cells);

    const StaticGround* ground_ = nullptr;
    Set present_, other_;  // The other ones were in use before, or are prepared.
    bool preparing_ = false;
    WalkEdges edges_;
    WalkSolver solver_;
};

/// True where two points are on the two sides of the passage to which they walk.
bool onOppositeSides(const Walk& one, const Walk& other);

}  // namespace muster
