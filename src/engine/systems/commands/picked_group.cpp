#include "engine/systems/commands/picked_group.h"

namespace muster {

std::optional<std::size_t> pickedGroup(const WorldState& state, Vec2 p) {
    std::optional<std::size_t> best;
    double nearest = state.parameters.input.reach;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& group = state.groups[g];
        if (group.members.empty()) continue;
        const auto& triangles = group.mesh.formation().mesh.triangles;
        const MeshPoint point = locate(triangles, group.mesh.finalMesh(), p);
        const double d = distance(point.position(triangles, group.mesh.finalMesh()), p);
        if (d < nearest || (!best && d <= nearest)) {
            nearest = d;
            best = g;
        }
    }
    return best;
}

}  // namespace muster
