#include "engine/systems/commands/picked_group.h"

namespace muster {

const Group* pickedGroup(const WorldState& state, Vec2 p) {
    const Group* best = nullptr;
    double nearest = state.parameters.input.reach;
    for (const Group& group : state.groups) {
        if (group.members.empty()) continue;
        const auto& triangles = group.mesh.formation().mesh.triangles;
        const MeshPoint point = locate(triangles, group.mesh.finalMesh(), p);
        const double d = distance(point.position(triangles, group.mesh.finalMesh()), p);
        if (d < nearest || (best == nullptr && d <= nearest)) {
            nearest = d;
            best = &group;
        }
    }
    return best;
}

}  // namespace muster
