#include "engine/systems/commands/ended_paths.h"

#include <algorithm>
#include <vector>

#include "muster/assert.h"

namespace muster {
namespace {

// True for a path that moves nothing any more from `time` on.
bool leadsNowhere(const TimedPath& path, double time) {
    const Waypoint now = path.at(time);
    return std::all_of(path.waypoints.begin(), path.waypoints.end(), [&](const Waypoint& w) {
        const bool passed = !path.loop && w.time <= time;
        return passed || (w.position == now.position && w.angle == now.angle);
    });
}

// The definition of an obstacle where it stands now, without a path.
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
    std::vector<ObstacleId> ended;  // Ascending, as pieces are.
    for (const ObstaclePiece& piece : environment.pieces()) {
        if (!piece.moving || (!ended.empty() && ended.back() == piece.obstacle)) continue;
        if (leadsNowhere(environment.obstacle(piece.obstacle)->path, environment.time()))
            ended.push_back(piece.obstacle);
    }
    if (ended.empty()) return;
    pool.wait();  // Background work reads the ground.
    for (const ObstacleId id : ended) {
        const Status changed = environment.changeObstacle(id, standing(environment, id));
        MUSTER_ASSERT(changed.ok());
        (void)changed;
        ++state.groundEdits;
    }
    environment.setTime(environment.time());
}

}  // namespace muster
