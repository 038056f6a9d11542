#include "engine/state/ground_class.h"

#include <algorithm>
#include <cmath>

#include "engine/state/group_edits.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

constexpr double kRoom = 1.2;      // Least distance of places where their formation allows it, in diameters.
constexpr double kClosest = 0.75;  // Least distance of the places of a formation, in its spacings.
constexpr double kFactor = 1.18920711500272106672;  // From class to class, the fourth root of 2.
constexpr double kRounding = 1e-9;                  // Radii that differ by this share are one.

}  // namespace

std::int32_t groundClassFor(double usual, double radius) {
    std::int32_t groundClass = 0;
    for (double r = usual; r < radius * (1.0 - kRounding); r *= kFactor) ++groundClass;
    for (double r = usual / kFactor; r > radius * (1.0 + kRounding); r /= kFactor) --groundClass;
    return groundClass;
}

double groundRadius(double usual, std::int32_t groundClass) {
    double radius = usual;
    for (std::int32_t k = 0; k < groundClass; ++k) radius *= kFactor;
    for (std::int32_t k = 0; k > groundClass; --k) radius /= kFactor;
    return radius;
}

std::int32_t groundClassFor(const WorldState& state, const Group& group) {
    const Parameters::Character& usual = state.parameters.character;
    double largest = 0.0;
    for (const std::int32_t i : group.members)
        largest = std::max(largest, radiusOf(usual, state.characters.body[i]));
    return largest > 0.0 ? groundClassFor(usual.radius, largest) : 0;
}

double meanRadius(const WorldState& state, const Group& group) {
    const Parameters::Character& usual = state.parameters.character;
    double sum = 0.0;
    bool alike = true;
    for (const std::int32_t i : group.members) {
        const double own = radiusOf(usual, state.characters.body[i]);
        alike = alike && own == usual.radius;
        sum += own;
    }
    return alike ? usual.radius : sum / static_cast<double>(group.members.size());
}

PlaceDef placeDefOf(const WorldState& state, const Group& group) {
    const Parameters& parameters = state.parameters;
    // Bodies that touch all round never come to rest on points that touch.
    const double touching = 2.0 * meanRadius(state, group);
    const double apart = std::max(touching,
                                  std::min(kRoom * touching, kClosest * group.def.formation.spacing));
    double fastest = parameters.place.speed;
    for (const std::int32_t i : group.members) fastest = std::max(fastest, state.characters.body[i].maxSpeed);
    return {groundRadius(parameters.character.radius, group.groundClass), parameters.place.clearance, fastest,
            apart};
}

void updateGroundClasses(WorldState& state, ThreadPool& pool) {
    for (Group& group : state.groups) {
        const std::int32_t now = groundClassFor(state, group);
        if (now == group.groundClass) continue;
        pool.wait();
        group.groundClass = now;
        group.plan = makePlan(state.parameters);
        group.planNow = true;
        for (const std::int32_t i : group.members) state.characters.chosen[i] = {};
    }
}

}  // namespace muster
