#include "engine/systems/places/place_stage.h"

#include <algorithm>

#include "base/bounds.h"
#include "engine/state/bare_groups.h"
#include "engine/state/ground_class.h"

namespace muster {
namespace {

constexpr double kRestMove = 1e-3;  // Greatest movement of the centre of a resting group in a step [m].

// True where fingers have drawn further.
bool isLed(const Group& group) {
    const auto isDrawn = [](const ControlPoint& point) { return !point.trajectory.empty(); };
    return std::any_of(group.controls.controls().begin(), group.controls.controls().end(),
                       [&](const Control& control) {
                           return std::any_of(control.points.begin(), control.points.end(), isDrawn);
                       });
}

}  // namespace

void refreshRoutes(WorldState& state) {
    state.refreshRoutes();
    for (const Group& group : state.groups) state.refreshRoutes(group.groundClass);
}

void PlaceStage::readTargets(const WorldState& state) {
    targets_.resize(state.groups.size());
    for (std::size_t g = 0; g < targets_.size(); ++g) {
        const Group& group = state.groups[g];
        targets_[g].clear();
        if (group.flow.leads())
            group.flow.select(group.flow.places, targets_[g]);
        else
            group.mesh.placePositions(targets_[g]);
    }
}

void PlaceStage::makeRoom(WorldState& state) {
    for (std::size_t g = 0; g < targets_.size(); ++g)
        if (!isBare(state.groups[g])) room_.run(state, state.groups[g], targets_[g]);
}

void PlaceStage::watchRest(WorldState& state) const {
    for (std::size_t g = 0; g < targets_.size(); ++g) {
        Group& group = state.groups[g];
        const Vec2 centre = meanOf(targets_[g]);
        const bool rests = distance(centre, group.settling.centre) < kRestMove && !isLed(group);
        group.settling.restSteps = rests ? group.settling.restSteps + 1 : 0;
        group.settling.centre = centre;
    }
}

void PlaceStage::findRegions(WorldState& state) {
    const auto isUsed = [](std::int32_t count) { return count > 0; };
    for (Group& group : state.groups) {
        group.region = -1;
        group.split = false;
        if (isBare(group)) continue;
        group.region = mainRegion(state, group, regionCounts_);
        group.split = std::count_if(regionCounts_.begin(), regionCounts_.end(), isUsed) > 1;
    }
}

void PlaceStage::advance(WorldState& state, ThreadPool& pool) {
    for (std::size_t g = 0; g < targets_.size(); ++g) {
        Group& group = state.groups[g];
        if (isBare(group)) continue;
        if (group.flow.moves()) {
            group.places.lead(targets_[g], state.parameters.stepTime);
            continue;
        }
        group.places.advance(placeDefOf(state, group), targets_[g], state.routesOf(group), group.region,
                             state.parameters.stepTime, &pool);
    }
}

}  // namespace muster
