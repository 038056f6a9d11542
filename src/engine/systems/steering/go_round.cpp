#include "engine/systems/steering/go_round.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/infinite_cost.h"
#include "engine/state/held_ground.h"
#include "engine/systems/steering/own_routes.h"

namespace muster {
namespace {

constexpr double kClusterReach = 8.0;  // Distance ahead up to which clusters are gone round [m].

// True where the stretch from `from` along the unit vector `way` meets the box.
bool meets(const Box& box, Vec2 from, Vec2 way, double far) {
    double enter = 0.0, leave = far;
    const auto clip = [&](double at, double step, double low, double high) {
        if (step == 0.0) {
            if (at < low || at > high) leave = -1.0;
            return;
        }
        const double a = (low - at) / step, b = (high - at) / step;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    };
    clip(from.x, way.x, box.min.x, box.max.x);
    clip(from.y, way.y, box.min.y, box.max.y);
    return enter <= leave;
}

}  // namespace

void GoRound::findHolders(const WorldState& state) {
    holders_.clear();
    positions_.clear();
    for (const Group& group : state.groups) {
        if (!holdsGround(group)) continue;
        for (const std::int32_t i : group.members) {
            holders_.push_back(i);
            positions_.push_back(state.characters.position[i]);
        }
    }
}

std::int32_t GoRound::rootOf(std::int32_t k) {
    while (root_[k] != k) k = root_[k] = root_[root_[k]];
    return k;
}

// Joins holders to clusters: two belong together where no agent of the usual size fits between them.
void GoRound::findClusters(const CrowdBodies& bodies) {
    const double passage = 2.0 * (bodies.usual().radius + kHeldMargin);
    pairs_.build(positions_, 2.0 * bodies.largestRadius() + passage);
    root_.resize(holders_.size());
    order_.resize(holders_.size());
    for (std::size_t k = 0; k < holders_.size(); ++k) root_[k] = order_[k] = static_cast<std::int32_t>(k);
    for (const NeighbourPair pair : pairs_.pairs()) {
        const std::int32_t a = holders_[pair.low], b = holders_[pair.high];
        const double reach = bodies.touching(a, b) + passage;
        if (lengthSquared(positions_[pair.low] - positions_[pair.high]) < reach * reach) {
            const std::int32_t x = rootOf(pair.low), y = rootOf(pair.high);
            root_[std::max(x, y)] = std::min(x, y);
        }
    }
    for (std::size_t k = 0; k < holders_.size(); ++k) root_[k] = rootOf(static_cast<std::int32_t>(k));
    std::sort(order_.begin(), order_.end(),
              [&](std::int32_t a, std::int32_t b) { return std::tie(root_[a], a) < std::tie(root_[b], b); });
    clusters_.clear();
    members_.clear();
    memberPositions_.clear();
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const std::int32_t i = holders_[order_[k]];
        const Vec2 p = positions_[order_[k]];
        if (k == 0 || root_[order_[k]] != root_[order_[k - 1]])
            clusters_.push_back({k, k, {p, p}, bodies.radius(i)});
        Cluster& cluster = clusters_.back();
        cluster.end = k + 1;
        cluster.box.min = {std::min(cluster.box.min.x, p.x), std::min(cluster.box.min.y, p.y)};
        cluster.box.max = {std::max(cluster.box.max.x, p.x), std::max(cluster.box.max.y, p.y)};
        cluster.largest = std::max(cluster.largest, bodies.radius(i));
        members_.push_back(i);
        memberPositions_.push_back(p);
    }
}

bool GoRound::hasOwn(const Characters& c, const Cluster& cluster, std::uint32_t group) const {
    return std::any_of(members_.begin() + static_cast<std::ptrdiff_t>(cluster.first),
                       members_.begin() + static_cast<std::ptrdiff_t>(cluster.end),
                       [&](std::int32_t i) { return c.group[i] == group; });
}

// The side of the cluster with the shorter route to the target, of the sides that are open; none where both
// are closed. Its ends are the outermost members as seen along the direction of the character.
GoRound::Side GoRound::sideOf(const WorldState& state, const CrowdBodies& bodies, const Cluster& cluster,
                              Vec2 target, std::int32_t character) const {
    const Characters& c = state.characters;
    const Vec2 here = c.position[character], way = c.direction[character];
    Vec2 left, right;  // The outermost members, moved sideways by the distance to keep.
    double mostLeft = -std::numeric_limits<double>::infinity(), mostRight = -mostLeft;
    for (std::size_t k = cluster.first; k < cluster.end; ++k) {
        const std::int32_t i = members_[k];
        const double keep = bodies.touching(character, i) + kHeldMargin;
        const double across = cross(way, c.position[i] - here);
        if (across + keep > mostLeft) {
            mostLeft = across + keep;
            left = c.position[i] + perpendicular(way) * keep;
        }
        if (across - keep < mostRight) {
            mostRight = across - keep;
            right = c.position[i] - perpendicular(way) * keep;
        }
    }
    // Past the end the route goes on for a body's length or two.
    const Vec2 past = way * (cluster.largest + bodies.radius(character) + kHeldMargin);
    const auto round = [&](Vec2 end) {
        return state.environment.clearStaticLine(end - past, end + past, bodies.radius(character)) &&
                       !isClosedByOthers(bodies, cluster, end, character)
                   ? distance(here, end) + distance(end, target)
                   : kInfiniteCost;
    };
    const double byLeft = round(left), byRight = round(right);
    if (byLeft == kInfiniteCost && byRight == kInfiniteCost) return Side::None;
    return byLeft < byRight ? Side::Left : Side::Right;
}

// True where a member of another cluster leaves no room at the end of this one.
bool GoRound::isClosedByOthers(const CrowdBodies& bodies, const Cluster& cluster, Vec2 end,
                               std::int32_t character) const {
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const double touching = bodies.touching(character, members_[k]);
        const bool other = k < cluster.first || k >= cluster.end;
        if (other && lengthSquared(memberPositions_[k] - end) < touching * touching) return true;
    }
    return false;
}

// Turns a direction that leads into the cluster to the outermost tangent of its members on the shorter side.
void GoRound::turn(WorldState& state, const CrowdBodies& bodies, const Cluster& cluster, Vec2 target,
                   std::int32_t character) {
    Characters& c = state.characters;
    const Vec2 here = c.position[character], way = c.direction[character];
    const double far = std::min(kClusterReach, distance(here, target));
    const auto members = std::span(members_).subspan(cluster.first, cluster.end - cluster.first);
    const bool barred = std::any_of(members.begin(), members.end(), [&](std::int32_t i) {
        const double keep = bodies.touching(character, i) + kHeldMargin;
        const Vec2 to = c.position[i] - here;
        const double along = dot(to, way);
        return along > 0.0 && along < far && std::fabs(cross(way, to)) < keep;
    });
    if (!barred) return;
    const Side shorter = sideOf(state, bodies, cluster, target, character);
    if (shorter == Side::None) barred_[character] = 1;
    if (shorter == Side::None) return;
    const double side = shorter == Side::Left ? 1.0 : -1.0;
    // The turn from the present direction to the side, as a growing measure of the angle.
    const auto turned = [&](Vec2 unit) {
        return std::copysign(1.0 - dot(way, unit), side * cross(way, unit));
    };
    Vec2 outermost = way;
    for (const std::int32_t i : members) {
        const double keep = bodies.touching(character, i) + kHeldMargin;
        const Vec2 to = c.position[i] - here;
        if (dot(to, way) < -keep) continue;
        const double away = std::max(length(to), 1e-9), sine = std::min(1.0, keep / away);
        const Rotation tangent{std::sqrt(1.0 - sine * sine), side * sine};
        const Vec2 unit = tangent.apply(to / away);
        if (turned(unit) > turned(outermost)) outermost = unit;
    }
    c.direction[character] = normalized(outermost, way);
}

void GoRound::run(WorldState& state, const CrowdBodies& bodies, std::span<const Vec2> targets) {
    findHolders(state);
    barred_.clear();
    if (holders_.empty()) return;
    findClusters(bodies);
    Characters& c = state.characters;
    barred_.assign(c.size(), 0);
    for (std::size_t i = 0; i < c.size(); ++i) {
        // A character's own route leads round holders already.
        if (c.direction[i] == Vec2{} || bodies.isFixed(i) || followedRoute(state, i) != nullptr) continue;
        const double far = std::min(kClusterReach, distance(c.position[i], targets[i]));
        for (const Cluster& cluster : clusters_) {
            const double keep = cluster.largest + bodies.radius(i) + kHeldMargin;
            if (!cluster.box.grown(keep + far).contains(c.position[i]) || hasOwn(c, cluster, c.group[i]))
                continue;
            if (!meets(cluster.box.grown(keep), c.position[i], c.direction[i], far) ||
                !bodies.isFirmer(members_[cluster.first], i))
                continue;
            turn(state, bodies, cluster, targets[i], static_cast<std::int32_t>(i));
        }
    }
}

}  // namespace muster
