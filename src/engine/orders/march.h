// A march: how far a group is with going where an order leads, and within which bounds it goes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/orders/way_needs.h"
#include "muster/order.h"

namespace muster {

/// What a group does about its order.
enum class MarchPhase : std::uint8_t {
    Idle,    ///< Nothing yet.
    Search,  ///< Its way is searched.
    Go,      ///< It goes along its way.
    Stand,   ///< Its places are where the order wants them.
};

/// A march, as a world's state holds it.
struct March {
    MarchPhase phase = MarchPhase::Idle;
    std::vector<Vec2> way;   ///< Corners of the way, where it began and its end included [m].
    std::uint32_t next = 0;  ///< Index of the corner that it heads for.
    std::vector<Vec2>
        legs;  ///< While it is searched: points that it leads through and that are still ahead [m].
    bool reversed = false;      ///< True: the rear of the formation is its front.
    Pose last;                  ///< Of the mesh, as it was last set.
    WayQuery query;             ///< Of the present search.
    std::int32_t searched = 0;  ///< Cells that the search has come to; 0 where it has not begun.
    std::uint32_t ground = 0;   ///< Version of the ground for which it began.

    /// Corners still ahead [m].
    std::span<const Vec2> ahead() const {
        return phase == MarchPhase::Go ? std::span<const Vec2>(way).subspan(next) : std::span<const Vec2>();
    }
    /// Direction of its front at a pose, of unit length.
    Vec2 front(const Pose& pose) const { return pose.rotation.apply({reversed ? -1.0 : 1.0, 0.0}); }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, way, next, legs, reversed, last, query, searched, ground);
    }
};

/// Bounds of a march.
struct MarchDef {
    Turn turn = Turn::Flow;     ///< How it takes its turns.
    double speed = 1.9;         ///< Top speed of every place [m/s], above 0.
    double acceleration = 3.0;  ///< Top acceleration of every place [m/s^2], above 0.
    double brakes = 3.0;        ///< Acceleration by which every place stops [m/s^2], above 0.
    double reach = 1.0;         ///< From the middle to the farthest place [m], above 0.
    double pace = 1.0;          ///< Share of its speed: less where somebody falls behind, [0, 1].
};

/// Time that a march along a way takes from standing to standing, about [s].
double marchTime(const MarchDef& def, std::span<const Vec2> way, Vec2 front, std::optional<double> facing);

}  // namespace muster
