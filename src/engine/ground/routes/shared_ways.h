// Ways that several places of a group take: a way found for one serves all that go from near its start to
// near its end.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_search.h"

namespace muster {

/// The ways that were found last.
class SharedWays {
public:
    /// Forgets all.
    void clear() {
        ways_.clear();
        clear_.clear();
    }
    /// Makes ways older, and drops old ones. Once in a step, before join().
    void age();
    /// Keeps a way, both ends included [m]; short ones are not worth it.
    void add(const std::vector<Vec2>& path);
    /// Keeps the ways of others, too, as many as there is room for.
    void add(const SharedWays& others);
    /// Allocates memory for all ways.
    void reserve();
    /// Joins `from` and `to` to one of the ways, the last one first, if what that makes is nearly as short as
    /// the shortest can be. Writes the path, both ends included. Counts operations in `work`.
    bool join(const RouteGround& ground, Vec2 from, Vec2 to, std::vector<Vec2>& path, std::int64_t& work);

    /// Length of the shortest path over a way that passes within `reach` [m] of both points; infinite where
    /// none does. Straight lines join the points to it, whatever lies there.
    double lengthAlong(Vec2 from, Vec2 to, double reach) const;

    /// Lets an archive read or write the state.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ways_);
        if constexpr (Archive::kReading) clear_.assign(ways_.size(), -1);
    }
    /// True where no coordinate is so large that steps would not stay finite.
    bool sane() const;

private:
    struct Way {
        std::vector<Vec2> path;  // [m]
        std::uint32_t age = 0;   // Steps.
        Box box;                 // Round the path; follows from it.

        void findBox();
        bool isNear(Vec2 p, double reach) const;
        template <class Archive>
        void visit(Archive& archive) {
            archive(path, age);
            if constexpr (Archive::kReading) findBox();
        }
    };
    // The point of a way that is nearest to another point.
    struct Foot {
        std::size_t segment = 0;  // Index of the segment's first corner.
        Vec2 point;
        double distance = 0.0;  // To the other point [m].
    };

    static Foot nearestFoot(const std::vector<Vec2>& path, Vec2 p);
    void followGround(const RouteGround& ground);
    bool isClear(const RouteGround& ground, std::size_t index);

    std::vector<Way> ways_;  // The last one at the end.
    // Of each way, 1 where its course is known to be clear for discs of this radius on the ground of these
    // versions, 0 where it is not, -1 where that is unknown. A cache.
    std::vector<std::int8_t> clear_;
    std::uint64_t instance_ = 0, version_ = 0;
    double radius_ = 0.0;                   // [m]
    std::vector<std::vector<Vec2>> spare_;  // Memory of ways that were dropped.
};

}  // namespace muster
