// Keeps marching meshes clear of other meshes and of moving obstacles (SPEC B3).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/orders/avoidance.h"
#include "engine/state/world_state.h"
#include "engine/systems/orders/order_ways.h"

namespace muster {

/// Moves the meshes of groups that keep clear. Its memory is a cache.
class MeshAvoidance {
public:
    /// Begins a step.
    void begin() { known_ = false; }
    /// One step of the march of a group along its way: the next pose.
    Pose advance(const WorldState& state, const WayGround& ground, MarchDef def, Group& group);

private:
    /// What is known of a group's mesh.
    struct Body {
        MovingBox box;
        bool shares = false;  // It keeps clear of others, too.
    };

    void readBodies(const WorldState& state);
    void readMovers(const WorldState& state);
    void readPath(const TimedPath& path, double now);
    void listNeighbours(const WorldState& state, const Group& group);
    void decide(const WorldState& state, const WayGround& ground, const MarchDef& def, Group& group);

    bool known_ = false;        // Bodies and movers are those of this step.
    std::vector<Body> bodies_;  // Of each group.
    std::vector<Neighbour> movers_, neighbours_;
    std::vector<double> times_;  // Until the waypoints of one path [s].
    Avoider avoider_;
};

}  // namespace muster
