// Keeps marching formations clear of others and of moving obstacles (SPEC B3).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/orders/avoidance.h"
#include "engine/state/world_state.h"
#include "engine/systems/orders/order_ways.h"

namespace muster {

/// Chooses manoeuvres for groups that keep clear. Its memory is a cache.
class MeshAvoidance {
public:
    /// Begins a step.
    void begin() { known_ = false; }
    /// One step of a group on its march: sets its speed, and says how far off its course it is to be
    /// [m].
    Vec2 advance(const WorldState& state, const WayGround& ground, MarchDef& def, Group& group);

private:
    /// A group or obstacle to keep clear of.
    struct Neighbour {
        Course course;
        bool moves = false;  // True for a moving obstacle.
    };

    CourseDef courseDefOf(const WorldState& state, const Group& group, const MarchDef& def) const;
    void readMeshes(const WorldState& state);
    void readMovers(const WorldState& state);
    void readPath(const TimedPath& path, double now);
    void readMover(const WorldState& state, const ObstaclePiece& piece, Course& course);
    void listNear(const WorldState& state, const Group& group, const CourseDef& own);
    bool meets(const CourseDef& own, const Manoeuvre& manoeuvre, bool movers);
    static bool hasRoom(const WayGround& ground, double half, const CourseDef& own, double offCourse);
    void choose(const WayGround& ground, double half, const CourseDef& own, Avoidance& avoidance);
    void decide(const WorldState& state, const WayGround& ground, const MarchDef& def, Group& group);

    bool known_ = false;  // True once the courses of all neighbours are known in this step.
    std::vector<Neighbour> meshes_, movers_;
    std::vector<const Neighbour*> near_;
    std::vector<double> times_;
    Course course_;
};

}  // namespace muster
