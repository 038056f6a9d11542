#include "engine/systems/commands/ended_paths.h"

#include <algorithm>

#include "muster/assert.h"

namespace muster {
namespace {

// True where the path leads nowhere from the present time on.
bool leadsNowhere(const TimedPath& path, double time) {
    const Waypoint now = path.at(time);
    return std::all_of(path.waypoints.begin(), path.waypoints.end(), [&](const Waypoint& w) {
        const bool passed = !path.loop && w.time <= time;
        return passed || (w.position == now.position && w.angle == now.angle);
    });
}

// The obstacle where it stands now, without a path.
ObstacleDef standing(const Environment& environment, ObstacleId id) {
    ObstacleDef def = *environment.obstacle(id);
    if (def.polygon.empty())
        def.centre = environment.obstacleCentre(id);
    else
        def.polygon = environment.obstaclePolygon(id);
    def.path = {};
    return def;
}

}  // namespace

void settleEndedPaths(WorldState& state, ThreadPool& pool) {
    Environment& environment = state.environment;
    bool any = false;
    for (const ObstacleId id : environment.obstacleIds()) {
        const TimedPath& path = environment.obstacle(id)->path;
        if (path.still() || !leadsNowhere(path, environment.time())) continue;
        if (!any) pool.wait();  // Background work reads the ground.
        const Status changed = environment.changeObstacle(id, standing(environment, id));
        MUSTER_ASSERT(changed.ok());
        (void)changed;
        ++state.groundEdits;
        any = true;
    }
    if (any) environment.setTime(environment.time());
}

}  // namespace muster
