#include "world/state/keep_caches.h"

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
        group.plan->keepFieldsOf(*before->plan);
    }
}

}  // namespace muster
