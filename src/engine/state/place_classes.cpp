#include "engine/state/place_classes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/bounds.h"
#include "engine/geometry/triangulation.h"

namespace muster {
namespace {

constexpr double kFarthest = 1e12;     // Squared [m^2].
constexpr double kKeysPerMetre = 1e6;  // Places whose keys differ by less are of equal rank.

// Distance to the nearest edge of the outline [m].
double distanceToOutline(const TriangleMesh& mesh, const std::vector<std::vector<std::int32_t>>& loops,
                         Vec2 p) {
    double nearest = kFarthest;
    for (const auto& loop : loops)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2 a = mesh.vertices[loop[k]];
            const Vec2 along = mesh.vertices[loop[(k + 1) % loop.size()]] - a;
            const double squared = lengthSquared(along);
            const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, lengthSquared(p - a - along * share));
        }
    return std::sqrt(nearest);
}

// What is least for the places that an area takes first [m].
double keyOf(RoleArea area, Vec2 p) {
    switch (area) {
        case RoleArea::Front:
            return -p.x;
        case RoleArea::Rear:
            return p.x;
        case RoleArea::LeftFlank:
            return -p.y;
        case RoleArea::RightFlank:
            return p.y;
        case RoleArea::Flanks:
            return -std::fabs(p.y);
        case RoleArea::Centre:
        case RoleArea::Rim:
            break;
    }
    return length(p);
}

}  // namespace

std::uint8_t roleClass(std::span<const RoleDef> roles, std::uint8_t unitClass) {
    const bool has = std::any_of(roles.begin(), roles.end(),
                                 [&](const RoleDef& role) { return role.unitClass == unitClass; });
    return has ? unitClass : 0;
}

void PlaceClasses::sortPlaces(const Formation& formation, std::span<const RoleDef> roles) {
    roles_.assign(roles.begin(), roles.end());
    rest_ = now_;
    const Box box = rest_.empty() ? Box{} : boundsOf(rest_);
    const Vec2 middle = (box.min + box.max) * 0.5;
    const auto loops = boundaryLoops(formation.mesh);
    order_.resize(roles_.size());
    key_.resize(rest_.size());
    for (std::size_t r = 0; r < roles_.size(); ++r) {
        for (std::size_t j = 0; j < rest_.size(); ++j) {
            const double key = roles_[r].area == RoleArea::Rim
                                   ? distanceToOutline(formation.mesh, loops, rest_[j])
                                   : keyOf(roles_[r].area, rest_[j] - middle);
            key_[j] = static_cast<std::int64_t>(std::floor(key * kKeysPerMetre + 0.5));
        }
        order_[r].resize(rest_.size());
        std::iota(order_[r].begin(), order_[r].end(), 0);
        std::sort(order_[r].begin(), order_[r].end(), [&](std::int32_t a, std::int32_t b) {
            return key_[a] != key_[b] ? key_[a] < key_[b] : a < b;
        });
    }
}

void PlaceClasses::find(const Formation& formation, std::span<const RoleDef> roles, const ClassCounts& counts,
                        std::span<const std::uint8_t> usable, std::vector<std::uint8_t>& classes) {
    classes.clear();
    if (roles.empty()) return;
    now_.clear();
    for (const MeshPoint& place : formation.places)
        now_.push_back(place.position(formation.mesh.triangles, formation.mesh.vertices));
    if (now_ != rest_ || !std::equal(roles.begin(), roles.end(), roles_.begin(), roles_.end()))
        sortPlaces(formation, roles);
    classes.assign(rest_.size(), 0);
    ClassCounts left = counts;
    ClassCounts rolesLeft{};
    for (const RoleDef& role : roles_) ++rolesLeft[role.unitClass];
    for (std::size_t r = 0; r < roles_.size(); ++r) {
        const std::uint8_t unitClass = roles_[r].unitClass;
        std::int32_t& others = rolesLeft[unitClass];
        std::int32_t wanted = (left[unitClass] + others - 1) / others;
        --others;
        for (const std::int32_t j : order_[r]) {
            if (wanted == 0) break;
            if (classes[j] != 0 || (!usable.empty() && usable[j] == 0)) continue;
            classes[j] = unitClass;
            --wanted;
            --left[unitClass];
        }
    }
}

}  // namespace muster
