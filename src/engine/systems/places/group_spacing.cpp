#include "engine/systems/places/group_spacing.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "engine/formation/places/target_shift.h"
#include "engine/state/ground_class.h"

namespace muster {
namespace {

constexpr std::uint32_t kLookSteps = 30;  // Steps between two looks at where it rests.
constexpr double kRestMove = 1e-3;        // Most that its centre moves in a step meanwhile [m].
constexpr double kGap = 2.0;              // Between two groups, in diameters.

bool isLed(const Group& group) {
    for (const Control& control : group.controls.controls())
        for (const ControlPoint& point : control.points)
            if (!point.trajectory.empty()) return true;
    return false;
}

void watchRest(const Group& group, const std::vector<Vec2>& targets, Settling& settling) {
    Vec2 centre;
    for (const Vec2 p : targets) centre += p;
    centre = centre / std::max(1.0, static_cast<double>(targets.size()));
    const bool rests = distance(centre, settling.centre) < kRestMove && !isLed(group);
    settling.restSteps = rests ? settling.restSteps + 1 : 0;
    settling.centre = centre;
}

bool holds(const Group& group) {
    return group.def.conduct.stance == Stance::Hold;
}

/// True where the second group makes room for the first: for one that holds its ground, else for one whose
/// places were laid out beside those of others, else for an older one.
bool precedes(const WorldState& state, std::size_t first, std::size_t second) {
    const Group &a = state.groups[first], &b = state.groups[second];
    if (holds(a) != holds(b)) return holds(a);
    return a.flow.leads() != b.flow.leads() ? a.flow.leads() : first < second;
}

}  // namespace

Vec2 GroupSpacing::findShift(const WorldState& state, std::size_t index, const std::vector<Vec2>& targets) {
    double radius = 0.0;
    for (const Group& group : state.groups) radius = std::max(radius, meanRadius(state, group));
    shift_.begin(targets);
    for (std::size_t g = 0; g < state.groups.size(); ++g)
        if (precedes(state, g, index) && state.groups[g].settling.rests()) shift_.add(settled_[g]);
    if (!shift_.clashes({}, 2.0 * radius)) return {};
    // Where the present shift still does, nobody has to move again.
    const Vec2 present = state.groups[index].settling.shift;
    if (!(present == Vec2{}) && !shift_.clashes(present, 2.0 * radius)) return present;
    const Box inner = state.environment.def().box.grown(-radius);
    const auto isFree = [&](Vec2 p) {
        return inner.contains(p) && state.environment.distanceToObstacle(p, radius) >= radius;
    };
    return shift_.find(2.0 * radius, 2.0 * kGap * radius, std::cref(isFree));
}

void GroupSpacing::run(WorldState& state, std::vector<std::vector<Vec2>>& targets) {
    settled_.resize(state.groups.size());
    // Those come first that others make room for.
    order_.resize(targets.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return precedes(state, a, b); });
    for (const std::size_t g : order_) settle(state, g, targets[g]);
}

void GroupSpacing::settle(WorldState& state, std::size_t index, std::vector<Vec2>& targets) {
    Settling& settling = state.groups[index].settling;
    watchRest(state.groups[index], targets, settling);
    if (state.groups.size() == 1) return;
    if (state.groups[index].flow.leads()) {
        settling.shift = {};
        settled_[index].assign(targets.begin(), targets.end());
        return;
    }
    const bool looks = settling.rests() && (settling.restSteps - Settling::kRestSteps) % kLookSteps == 0;
    const bool leaves = settling.restSteps == 0 && !(settling.shift == Vec2{});
    if (looks) settling.shift = findShift(state, index, targets);
    // Led away, it keeps its shift until it has got clear of the others.
    if (leaves && findShift(state, index, targets) == Vec2{}) settling.shift = {};
    for (Vec2& p : targets) p += settling.shift;
    settled_[index].assign(targets.begin(), targets.end());
}

}  // namespace muster
