#include "engine/systems/orders/mesh_avoidance.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/maths.h"
#include "engine/state/ground_class.h"
#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kChoiceEvery = 0.2;  // Between two choices of a group [s].
constexpr double kMeshMargin = 0.5;   // Between two meshes [m].
constexpr double kMoverMargin = 0.8;  // Between a mesh and a moving obstacle [m].
constexpr double kStraggler = 2.0;    // Who is farther from their place does not count [m].
constexpr double kThere = 1.0;        // A mesh is where its places are, if these are so near [m].
constexpr double kStraight = 0.02;    // A smaller turn is none [rad].
constexpr std::size_t kMostLegs = 8;  // Of a path within the horizon.
constexpr double kOnWay = 0.1;        // Slower across its way it is on it [m/s].
constexpr double kOffWay = 0.5;       // Farther it is off it [m].
constexpr double kProgress = 1.0;     // Less way is none [m].
constexpr double
    kMeshPatience = 15.0;  // Without progress it presses on, whatever meshes are in the way [s]...
constexpr double kMoverPatience = 60.0;       // ... and moving obstacles [s].
constexpr double kPressed = 4.0;              // Beyond its own size, before it keeps clear again [m].
constexpr double kLooks[] = {1.0, 2.0, 3.0};  // When it must have room [s].
constexpr double kBack = 10.0;                // So far towards its way it must have room [m].

/// Bounds of points in the axes of a pose.
struct Bounds {
    Vec2 low{1e9, 1e9}, high{-1e9, -1e9};

    void add(Vec2 p, double radius = 0.0) {
        low = {std::min(low.x, p.x - radius), std::min(low.y, p.y - radius)};
        high = {std::max(high.x, p.x + radius), std::max(high.y, p.y + radius)};
    }
    MovingBox box(const Pose& pose) const {
        MovingBox box;
        box.axis = pose.rotation.apply({1.0, 0.0});
        box.centre = pose.apply((low + high) * 0.5);
        box.half = (high - low) * 0.5;
        return box;
    }
};

/// The box that holds places and those who are near them, and the mesh where it is there.
MovingBox boxOf(const WorldState& state, const Group& group) {
    const Characters& c = state.characters;
    const Pose& pose = group.mesh.pose();
    const Formation& formation = group.mesh.formation();
    const std::vector<Vec2>& places = group.places.positions();
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    Bounds bounds;
    Vec2 off;
    for (std::size_t k = 0; k < places.size(); ++k) {
        bounds.add(pose.applyInverse(places[k]), radius);
        off += formation.places[k].position(formation.mesh.triangles, group.mesh.finalMesh()) - places[k];
    }
    for (const std::int32_t i : group.members) {
        const std::int32_t place = c.place[i];
        if (place >= 0 && distance(c.position[i], places[place]) <= kStraggler)
            bounds.add(pose.applyInverse(c.position[i]), radius);
    }
    if (length(off) <= kThere * static_cast<double>(places.size()))
        for (const Vec2 p : group.mesh.finalMesh()) bounds.add(pose.applyInverse(p));
    return bounds.box(pose);
}

/// True where the first order of a group is to stay with the other.
bool staysWith(const Group& group, GroupId other) {
    const auto& orders = group.orders.orders;
    if (orders.empty() ||
        (orders.front().order.kind != OrderKind::Follow && orders.front().order.kind != OrderKind::Guard))
        return false;
    return orders.front().order.group == other;
}

/// The box of a piece about its longest edge.
MovingBox boxOf(const ObstaclePiece& piece) {
    MovingBox box;
    box.centre = piece.centre;
    if (piece.corners.empty()) {
        box.round = piece.radius;
        return box;
    }
    double longest = 0.0;
    for (std::size_t i = 0, j = piece.corners.size() - 1; i < piece.corners.size(); j = i++) {
        const Vec2 edge = piece.corners[i] - piece.corners[j];
        if (lengthSquared(edge) <= longest) continue;
        longest = lengthSquared(edge);
        box.axis = normalized(edge, {1.0, 0.0});
    }
    Bounds bounds;
    const Pose pose{piece.centre, {box.axis.x, box.axis.y}};
    for (const Vec2 p : piece.corners) bounds.add(pose.applyInverse(p));
    return bounds.box(pose);
}

Vec2 directionOf(const March& march, const Pose& pose) {
    return normalized(march.way[march.next] - pose.position, march.front(pose));
}

std::uint32_t periodOf(const WorldState& state) {
    return std::max(1u, stepsIn(state, kChoiceEvery));
}

/// Corners that it has passed off its way are left out.
void skipPassed(const WayGround& ground, const WayNeeds& needs, March& march, Vec2 at) {
    while (march.next > 0 && march.next + 1 < march.way.size()) {
        const Vec2 from = march.way[march.next - 1], corner = march.way[march.next];
        const Vec2 along = normalized(corner - from);
        if (std::fabs(cross(along, at - from)) <= kOffWay || dot(corner - at, along) > 0.0) return;
        const Vec2 next = march.way[march.next + 1];
        const double through = stretchCost(ground, needs, at, corner) +
                               stretchCost(ground, needs, corner, next);
        if (!(stretchCost(ground, needs, at, next) <= 1.05 * through)) return;
        ++march.next;
    }
}

/// True where the ground permits to go off the way at a velocity: there is as much room as the mesh needs, or
/// has now, and from there the way goes on.
bool hasRoom(const WayGround& ground, const WayNeeds& needs, const March& march, const Pose& pose,
             Vec2 velocity) {
    const Vec2 at = pose.position, corner = march.way[march.next];
    const double half = needs.halfAcross(directionOf(march, pose));
    const double need = std::min(half, ground.clearanceAt(at));
    for (const double seconds : kLooks)
        if (ground.clearanceAt(at + velocity * seconds) < need) return false;
    const Vec2 there = at + velocity * kLooks[1];
    const double far = distance(there, corner);
    const Vec2 back = far > kBack ? lerp(there, corner, kBack / far) : corner;
    const double most = std::max(1.4 * distance(there, back), 1.1 * stretchCost(ground, needs, at, back));
    return ground.environment().clearStaticLine(at, there, needs.radius) &&
           stretchCost(ground, needs, there, back) < most;
}

/// Who gets on no more presses on, for as far as it takes to get past.
void press(const WorldState& state, double left, double size, Avoidance& avoidance) {
    if (left < avoidance.left - kProgress || !avoidance.hindered) {
        avoidance.left = std::min(avoidance.left, left);
        avoidance.got = state.stepCount;
    }
    if (avoidance.press > 0 && left <= avoidance.pressTo) avoidance.press = 0;
    const std::uint32_t quiet = state.stepCount - avoidance.got;
    const std::uint8_t wanted = quiet >= stepsIn(state, kMoverPatience)  ? 2
                                : quiet >= stepsIn(state, kMeshPatience) ? 1
                                                                         : 0;
    if (wanted <= avoidance.press) return;
    avoidance.press = wanted;
    avoidance.pressTo = std::max(0.0, left - size - kPressed);
}

}  // namespace

void MeshAvoidance::readBodies(const WorldState& state) {
    bodies_.resize(state.groups.size());
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& group = state.groups[g];
        Body& body = bodies_[g];
        body = {};
        if (group.members.empty()) continue;
        body.box = boxOf(state, group);
        body.box.velocity = group.avoidance.under ? group.avoidance.velocity : meanVelocity(group);
        body.shares = group.avoidance.under && group.avoidance.press == 0 &&
                      length(body.box.velocity) > kMeshStands;
    }
}

// When the legs of a path begin and end, as far as the horizon: `times_`.
void MeshAvoidance::readPath(const TimedPath& path, double now) {
    times_.assign(1, 0.0);
    const double first = path.waypoints.front().time, last = path.waypoints.back().time;
    const bool loops = path.loop && last > first;
    double shift = -now;
    if (loops && now >= first) shift += std::floor((now - first) / (last - first)) * (last - first);
    for (int round = 0; round < 2; ++round) {
        for (const Waypoint& waypoint : path.waypoints) {
            const double in = waypoint.time + shift;
            if (in > times_.back() + 1e-6 && in < kMoverHorizon && times_.size() < kMostLegs)
                times_.push_back(in);
        }
        if (!loops) break;
        shift += last - first;
    }
    times_.push_back(kMoverHorizon);
}

void MeshAvoidance::readMovers(const WorldState& state) {
    movers_.clear();
    const Environment& environment = state.environment;
    const double now = environment.time();
    for (const ObstaclePiece& piece : environment.pieces()) {
        if (!piece.moving) continue;
        const TimedPath& path = environment.obstacle(piece.obstacle)->path;
        const Waypoint here = path.at(now);
        const Vec2 centroid = environment.obstacleCentre(piece.obstacle);
        const MovingBox box = boxOf(piece);
        readPath(path, now);
        for (std::size_t k = 1; k < times_.size(); ++k) {
            // A leap is no leg.
            if (times_[k] - times_[k - 1] < state.parameters.stepTime) continue;
            const double middle = 0.5 * (times_[k - 1] + times_[k]);
            const Waypoint there = path.at(now + middle);
            const double turning = path.angularVelocity(now + middle) * (times_[k] - times_[k - 1]);
            const Rotation turned = rotationBy(there.angle - here.angle);
            const Vec2 centre = centroid + there.position - here.position;
            MovingBox leg = box;
            leg.velocity = path.velocity(now + middle);
            leg.from = times_[k - 1];
            leg.to = times_[k];
            leg.centre = centre + turned.apply(box.centre - centroid) - leg.velocity * middle;
            leg.axis = turned.apply(box.axis);
            if (std::fabs(turning) > kStraight) {
                leg.centre = centre - leg.velocity * middle;
                leg.round = distance(box.centre, centroid) + box.reach();
                leg.half = {};
            }
            movers_.push_back({leg, kMoverMargin, false, false});
        }
    }
}

void MeshAvoidance::listNeighbours(const WorldState& state, const Group& group) {
    neighbours_.clear();
    if (group.avoidance.press < 2) neighbours_.assign(movers_.begin(), movers_.end());
    if (group.avoidance.press > 0) return;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& other = state.groups[g];
        const bool together = &other == &group || staysWith(group, other.id) || staysWith(other, group.id);
        if (together || other.members.empty()) continue;
        neighbours_.push_back({bodies_[g].box, kMeshMargin, true, bodies_[g].shares});
    }
}

void MeshAvoidance::decide(const WorldState& state, const WayGround& ground, const MarchDef& def,
                           Group& group) {
    March& march = group.orders.march;
    Avoidance& avoidance = group.avoidance;
    const Pose pose = group.mesh.pose();
    if (!known_) {
        readBodies(state);
        readMovers(state);
        known_ = true;
    }
    const WayNeeds needs = needsOf(state, group, group.orders.orders.front().order);
    skipPassed(ground, needs, march, pose.position);
    AvoidanceQuery query;
    query.own = bodies_[&group - state.groups.data()].box;
    query.own.velocity = avoidance.velocity;
    press(state, lengthAhead(march, pose.position), 2.0 * query.own.reach(), avoidance);
    listNeighbours(state, group);
    query.middle = pose.position;
    query.ahead = march.ahead();
    query.wheels = def.turn != Turn::Keep;
    query.preferred = wantedSpeed(def, march, pose);
    query.cruise = def.speed;
    query.top = std::max(0.0, def.top - std::fabs(march.spin) * def.reach);
    query.acceleration = def.acceleration;
    query.last = avoidance.chosen;
    query.last.seconds = std::max(0.0, query.last.seconds - periodOf(state) * state.parameters.stepTime);
    query.hindered = avoidance.hindered;
    const auto room = [&](Vec2 velocity) { return hasRoom(ground, needs, march, pose, velocity); };
    const AvoidanceChoice choice = avoider_.choose(query, neighbours_, std::cref(room));
    avoidance.chosen = choice.manoeuvre;
    avoidance.hindered = choice.hindered;
}

Pose MeshAvoidance::advance(const WorldState& state, const WayGround& ground, MarchDef def, Group& group) {
    March& march = group.orders.march;
    Avoidance& avoidance = group.avoidance;
    const Pose pose = group.mesh.pose();
    const double dt = state.parameters.stepTime;
    const bool fresh = !avoidance.under;
    if (fresh) {
        avoidance = {};
        avoidance.under = true;
        avoidance.left = lengthAhead(march, pose.position);
        avoidance.got = state.stepCount;
        avoidance.velocity = directionOf(march, pose) * march.speed;
    }
    if (fresh || (state.stepCount + group.id.value) % periodOf(state) == 0) decide(state, ground, def, group);
    const Manoeuvre& chosen = avoidance.chosen;
    if (avoidance.hindered) {
        def.limit = chosen.speed;
        if (chosen.speed > def.speed * def.pace) {
            def.speed = std::max(def.speed, chosen.speed);
            def.pace = 1.0;
        }
    }
    const Vec2 way = directionOf(march, pose);
    const bool along = !avoidance.hindered || chosen.angle == 0.0;
    if (along && std::fabs(cross(way, avoidance.velocity)) <= kOnWay) {
        march.speed = std::max(0.0, dot(way, avoidance.velocity));
        const Pose next = advanceMarch(def, march, pose, dt);
        avoidance.velocity = (next.position - pose.position) / dt;
        return next;
    }
    Vec2 wanted = way * std::min(wantedSpeed(def, march, pose), def.limit);
    if (!along) wanted = rotationBy(chosen.angle).apply(way) * chosen.speed;
    def.speed = std::max(def.speed, def.top);
    return advanceOffWay(def, march, pose, avoidance.velocity, wanted, dt);
}

}  // namespace muster
