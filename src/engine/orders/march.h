// A march: the progress of a group to where its order leads, and the bounds of its movement.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/orders/way_needs.h"
#include "muster/order.h"

namespace muster {

/// Phase of a group's order.
enum class MarchPhase : std::uint8_t {
    Idle,    ///< Nothing has begun.
    Search,  ///< The route is searched.
    Go,      ///< The group goes along its route.
    Stand,   ///< Its places are at the end of the order.
};

/// A march, as a world's state holds it.
struct March {
    MarchPhase phase = MarchPhase::Idle;
    std::vector<Vec2> way;      ///< Corners of the route, its begin and end included [m].
    std::uint32_t next = 0;     ///< Index of the corner for which it heads.
    std::vector<Vec2> legs;     ///< While the route is searched: the points ahead through which it leads [m].
    bool reversed = false;      ///< True if the rear of the formation is its front.
    Pose last;                  ///< Pose of the mesh, as it was last set.
    WayQuery query;             ///< The present search.
    std::int32_t searched = 0;  ///< Cells that the search has visited; 0 before it begins.
    std::uint32_t ground = 0;   ///< Version of the ground for which the search began.

    /// Corners of the route that are still ahead [m].
    std::span<const Vec2> ahead() const {
        return phase == MarchPhase::Go ? std::span<const Vec2>(way).subspan(next) : std::span<const Vec2>();
    }
    /// Direction of its front at a pose, a unit vector.
    Vec2 front(const Pose& pose) const { return pose.rotation.apply({reversed ? -1.0 : 1.0, 0.0}); }

    /// Lets an archive read or write the march.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, way, next, legs, reversed, last, query, searched, ground);
    }
};

/// Bounds of a march.
struct MarchDef {
    Turn turn = Turn::Flow;     ///< Manner in which it turns.
    double speed = 1.9;         ///< Top speed of every place [m/s], above 0.
    double acceleration = 3.0;  ///< Top acceleration of every place [m/s^2], above 0.
    double brakes = 3.0;        ///< Acceleration by which every place stops [m/s^2], above 0.
    double reach = 1.0;         ///< Distance from the middle to the farthest place [m], above 0.
    double pace = 1.0;          ///< Share of its speed: less where members fall behind, [0, 1].
};

/// Approximate time that a march along a route takes from standing to standing [s].
double marchTime(const MarchDef& def, std::span<const Vec2> way, Vec2 front, std::optional<double> facing);

}  // namespace muster
