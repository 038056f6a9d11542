#include "engine/systems/passages/goals.h"

#include <algorithm>

namespace muster {
namespace {

constexpr std::size_t kGoalSamples = 16;  // Number of goals whose mean stands for all.
constexpr double kForesight = 2.0;        // Time for which goals that move are expected to go on [s].

}  // namespace

Vec2 meanGoal(const Group& group) {
    const std::vector<Vec2>& goals = group.places.reachableTargets();
    const std::size_t stride = std::max<std::size_t>(1, goals.size() / kGoalSamples);
    Vec2 sum;
    double count = 0.0;
    for (std::size_t j = 0; j < goals.size(); j += stride, count += 1.0) sum += goals[j];
    return count > 0.0 ? sum / count : sum;
}

void foresee(const WorldState& state, Group& group) {
    const Vec2 now = meanGoal(group);
    const double time = (state.stepCount - state.waysLookedAt) * state.parameters.stepTime;
    const Vec2 drift = (now - group.waysFor) / std::max(time, state.parameters.stepTime);
    const bool steady = dot(drift, group.goalDrift) > 0.0;
    const double speed = steady ? std::min(length(drift), length(group.goalDrift)) : 0.0;
    group.foreseen = normalized(drift, {}) * (speed * kForesight);
    group.goalDrift = drift;
    group.waysFor = now;
}

}  // namespace muster
