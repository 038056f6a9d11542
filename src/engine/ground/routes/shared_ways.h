// Routes that several places of a group share: a route found for one serves all places that go from near its
// start to near its end.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_search.h"

namespace muster {

/// The routes that were found last.
class SharedWays {
public:
    /// Forgets all routes.
    void clear() {
        ways_.clear();
        clear_.clear();
    }
    /// Makes routes older, and drops old ones. Once in a step, before join().
    void age();
    /// Keeps a route, both ends included [m]; short routes are not worth it.
    void add(const std::vector<Vec2>& path);
    /// Keeps the routes of others, too, as many as there is room for.
    void add(const SharedWays& others);
    /// Allocates memory for all routes.
    void reserve();
    /// Joins `from` and `to` to one of the routes, the last one first, if the result is nearly as short as
    /// the shortest can be. Writes the path, both ends included. Counts operations in `work`.
    bool join(const RouteGround& ground, Vec2 from, Vec2 to, std::vector<Vec2>& path, std::int64_t& work);

    /// Length of the shortest path over a route that passes within `reach` [m] of both points; infinite where
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
        std::vector<Vec2> path;  // Corners of the route [m].
        std::uint32_t age = 0;   // Age [steps].
        Box box;                 // Box round the path, from which it follows.

        void findBox();
        bool isNear(Vec2 p, double reach) const;
        template <class Archive>
        void visit(Archive& archive) {
            archive(path, age);
            if constexpr (Archive::kReading) findBox();
        }
    };
    // The point of a route that is nearest to another point.
    struct Foot {
        std::size_t segment = 0;  // Index of the segment's first corner.
        Vec2 point;
        double distance = 0.0;  // Distance to the other point [m].
    };

    static Foot nearestFoot(const std::vector<Vec2>& path, Vec2 p);
    void followGround(const RouteGround& ground);
    bool isClear(const RouteGround& ground, std::size_t index);

    std::vector<Way> ways_;  // Routes; the last one at the end.
    // By route: 1 where it is known to be clear for discs of this radius on the ground of these versions, 0
    // where it is not, -1 where that is unknown. A cache.
    std::vector<std::int8_t> clear_;
    std::uint64_t instance_ = 0, version_ = 0;
    double radius_ = 0.0;                   // Radius of the discs [m].
    std::vector<std::vector<Vec2>> spare_;  // Memory of dropped routes.
};

}  // namespace muster
