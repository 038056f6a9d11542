#include "engine/state/keep_caches.h"

#include <utility>

namespace muster {

void keepCaches(WorldState& earlier, WorldState& later) {
    earlier.environment.keepCachesOf(later.environment);
    // Where the environment has become another the next update makes routes from scratch.
    earlier.routes = std::move(later.routes);
    earlier.classRoutes = std::move(later.classRoutes);
    for (Group& group : earlier.groups) {
        Group* const before = later.findGroup(group.id);
        if (before == nullptr) continue;
        group.mesh.keepCachesOf(before->mesh);
        // Fields of another class of ground are of other walls.
        if (group.groundClass == before->groundClass) group.plan->keepFieldsOf(*before->plan);
    }
}

}  // namespace muster
