#include "engine/systems/steering/steering_stage.h"

#include <limits>

#include "engine/state/held_ground.h"

namespace muster {
namespace {

// Distance ahead of the point for which a character heads that goes to a passage [m].
constexpr double kPassageAhead = 100.0;
// Distance to the nearest place at which unmatched characters stop [m].
constexpr double kUnmatchedDistance = 2.0;

}  // namespace

// Unmatched characters go to the nearest usable place, and wait near it where the line to it is clear.
void SteeringStage::directUnmatched(const WorldState& state, const Group& group,
                                    const MemberArrays& members) {
    const std::span<const Vec2> positions = members.positions();
    towards_.assign(members.places().begin(), members.places().end());
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (towards_[k] >= 0) continue;
        const std::int32_t place = group.plan->waitingPlace(static_cast<std::int32_t>(k));
        if (place < 0) continue;
        const Vec2 target = group.places.positions()[place];
        const bool arrived = distance(positions[k], target) < kUnmatchedDistance &&
                             state.environment.clearLine(positions[k], target, 0.0);
        if (!arrived) towards_[k] = place;
    }
}

void SteeringStage::resolveBodies(const WorldState& state) {
    const std::size_t count = state.characters.size();
    for (auto* array :
         {&placePosition_, &placeVelocity_, &facing_, &next_.position, &next_.velocity, &next_.heading})
        array->resize(count);
    firmness_.clear();
    for (const Group& group : state.groups) {
        const Stance stance = group.def.conduct.stance;
        firmness_.push_back(holdsGround(group) ? 2 : stance != Stance::Yield ? 1 : 0);
    }
    bodies_.resolve(state.parameters.character, state.characters, firmness_,
                    state.environment.def().joined());
}

void SteeringStage::descendFields(WorldState& state, PlanCosts& costs, ThreadPool& pool) {
    continuum_.begin(state, costs);
    goals_.run(state, costs, placePosition_, pool);
    for (const Group& group : state.groups) {
        Gathering* const gathering = state.continuum.find(group.id);
        if (gathering == nullptr || group.members.empty()) continue;
        if (!gathering->isBare()) continuum_.guide(state, group, *gathering);
        const Vec2 facing = group.orders.march.front(group.mesh.pose());
        for (const std::int32_t i : group.members) {
            facing_[i] = gathering->isBare() ? state.characters.heading[i] : facing;
            placeVelocity_[i] = {};
            if (gathering->isBare()) continue;
            placePosition_[i] = state.characters.direction[i] == Vec2{} ? state.characters.position[i]
                                                                        : gathering->target;
        }
    }
}

void SteeringStage::guide(WorldState& state, PlanCosts& costs, const GroupMembers& members,
                          ThreadPool& pool) {
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        Group& group = state.groups[g];
        const std::size_t count = group.members.size();
        if (count == 0 || state.continuum.find(group.id) != nullptr) continue;
        directions_.resize(count);
        costs_.resize(count);
        directUnmatched(state, group, members.of(g));
        const GuidanceInput input{members.of(g).positions(), towards_, group.places.positions(),
                                  &costs.ofClass(group.groundClass), state.parameters.character.directReach};
        group.plan->guide(input, pool, directions_, costs_);
        const Vec2 facing = group.orders.march.front(group.mesh.pose());
        Characters& characters = state.characters;
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t i = group.members[k];
            const std::int32_t place = characters.place[i];
            characters.direction[i] = directions_[k];
            facing_[i] = facing;
            characters.cost[i] = place >= 0 ? costs_[k] : std::numeric_limits<double>::infinity();
            placePosition_[i] = place >= 0 ? group.places.positions()[place] : characters.position[i];
            placeVelocity_[i] = place >= 0 ? group.places.velocities()[place] : Vec2{};
        }
    }
}

void SteeringStage::guideToPassages(WorldState& state, const WayStage& ways) {
    Characters& characters = state.characters;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& group = state.groups[g];
        if (ways.waysOf(g).way.empty() || state.continuum.find(group.id) != nullptr) continue;
        for (std::size_t k = 0; k < group.members.size(); ++k) {
            const std::int32_t i = group.members[k];
            if (!ways.guide(state, g, k, characters.place[i], characters.direction[i], characters.cost[i]))
                continue;
            // The place is behind the passage, however near it is in a straight line.
            placePosition_[i] = characters.position[i] + characters.direction[i] * kPassageAhead;
            placeVelocity_[i] = {};
        }
    }
}

void SteeringStage::setPaces(const WorldState& state) {
    pace_.clear();
    for (const Group& group : state.groups) {
        if (group.def.conduct.cohesion == 0.0) continue;
        pace_.resize(state.characters.size(), 1.0);
        cohesion_.setPaces(group.def.conduct.cohesion, bodies_, state.characters, group.members, pace_);
    }
}

void SteeringStage::steer(WorldState& state, double dt, ThreadPool& pool) {
    Characters& characters = state.characters;
    claims_.clear();
    for (const Group& group : state.groups) {
        const bool ordered = !group.orders.orders.empty() && group.orders.begun;
        const OrderKind kind = ordered ? group.orders.orders.front().order.kind : OrderKind::Move;
        claims_.push_back(
            {ordered ? group.orders.begunAt : 0, kind == OrderKind::Follow || kind == OrderKind::Guard});
    }
    const SteeringInput input{placePosition_,  placeVelocity_, facing_,         claims_,
                              state.stepCount, pace_,          shared_.rooms(), goals_.standing()};
    steering_.run(bodies_, characters, input, state.environment, dt, next_.velocity, next_.heading, &pool);
    characters.wanted.assign(steering_.preferred().begin(), steering_.preferred().end());
    for (std::size_t i = 0; i < characters.size(); ++i) {
        next_.position[i] = characters.position[i];
        if (!bodies_.isFixed(i)) next_.position[i] += next_.velocity[i] * dt;
    }
}

}  // namespace muster
