#include "engine/systems/orders/mesh_avoidance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/bounds.h"
#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/state/ground_class.h"

namespace muster {
namespace {

constexpr double kManoeuvreInterval = 0.2;  // Time between two choices of a group [s].
constexpr double kGroupDistance = 0.8;      // Distance that a group keeps from others [m].
constexpr double kStraightTurn = 0.02;      // Turn of a leg up to which it counts as straight [rad].
constexpr std::size_t kMostLegs = 8;        // Greatest number of legs of a path within the horizon.
constexpr double kManoeuvreGain = 0.3;      // Time that another manoeuvre must gain [s].
constexpr double kCourseStep = 1.25;        // Distance between two courses that are tried [m].
constexpr int kMostCourses = 10;            // Number of courses that are tried to each side.
constexpr double kDelays[] = {1.0, 2.0, 3.0, 4.5, 6.0, 8.0, kCourseHorizon};  // Delays that are tried [s].
// Time of waiting for moving obstacles after which a group presses on [s].
constexpr double kMostWait = 60.0;
constexpr double kWaitRecovery = 6.0;  // Rate at which walking takes off that time.

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

/// The box that holds the places of a group.
MovingBox boxOf(const WorldState& state, const Group& group) {
    const Pose& pose = group.mesh.pose();
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    Bounds bounds;
    for (const Vec2 p : group.places.positions()) bounds.add(pose.applyInverse(p), radius);
    return bounds.box(pose);
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

/// True where the first order of a group is to stay with the other.
bool staysWith(const Group& group, GroupId other) {
    const auto& orders = group.orders.orders;
    if (orders.empty() ||
        (orders.front().order.kind != OrderKind::Follow && orders.front().order.kind != OrderKind::Guard))
        return false;
    return orders.front().order.group == other;
}

bool keepsClear(const Group& group) {
    return group.def.conduct.avoids && group.flow.phase == FlowPhase::Flowing && !group.avoidance.presses &&
           !group.orders.march.ahead().empty();
}

}  // namespace

CourseDef MeshAvoidance::courseDefOf(const WorldState& state, const Group& group, const MarchDef& def) const {
    CourseDef own;
    own.box = boxOf(state, group);
    own.middle = meanOf(group.places.positions());
    own.ahead = group.orders.march.ahead();
    own.side = group.avoidance.side;
    own.offCourse = dot(group.avoidance.offCourse, own.side);
    own.speed = group.flow.speed;
    own.cruise = def.speed;
    own.acceleration = def.acceleration;
    return own;
}

// Reads the courses of meshes: of a group that keeps clear from its chosen manoeuvre, of others from their
// velocity.
void MeshAvoidance::readMeshes(const WorldState& state) {
    meshes_.resize(state.groups.size());
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& group = state.groups[g];
        Neighbour& mesh = meshes_[g];
        mesh.course.clear();
        if (group.members.empty()) continue;
        if (keepsClear(group) && !(group.avoidance.side == Vec2{})) {
            MarchDef def;
            def.speed = std::max(group.flow.speed, def.speed);
            listCourse(courseDefOf(state, group, def), group.avoidance.chosen, kKnownAhead, mesh.course);
            continue;
        }
        MovingBox box = boxOf(state, group);
        box.velocity = meanVelocity(group);
        mesh.course.push_back(box);
    }
}

// Lists the times at which the legs of a path begin and end, up to the horizon, in `times_`.
void MeshAvoidance::readPath(const TimedPath& path, double now) {
    times_.assign(1, 0.0);
    const double first = path.waypoints.front().time, last = path.waypoints.back().time;
    const bool loops = path.loop && last > first;
    double shift = -now;
    if (loops && now >= first) shift += std::floor((now - first) / (last - first)) * (last - first);
    for (int round = 0; round < 2; ++round) {
        for (const Waypoint& waypoint : path.waypoints) {
            const double in = waypoint.time + shift;
            if (in > times_.back() + 1e-6 && in < kKnownAhead && times_.size() < kMostLegs)
                times_.push_back(in);
        }
        if (!loops) break;
        shift += last - first;
    }
    times_.push_back(kKnownAhead);
}

// Lists the legs of a path as boxes of even velocity; an obstacle that turns is a disc.
void MeshAvoidance::readMover(const WorldState& state, const ObstaclePiece& piece, Course& course) {
    const Environment& environment = state.environment;
    const double now = environment.time();
    const TimedPath& path = environment.obstacle(piece.obstacle)->path;
    const Waypoint here = path.at(now);
    const Vec2 centroid = environment.obstacleCentre(piece.obstacle);
    const MovingBox box = boxOf(piece);
    readPath(path, now);
    for (std::size_t k = 1; k < times_.size(); ++k) {
        // A leap takes less than a step and is no leg.
        if (times_[k] - times_[k - 1] < state.parameters.stepTime) continue;
        const double middle = 0.5 * (times_[k - 1] + times_[k]);
        const Waypoint there = path.at(now + middle);
        const double turning = path.angularVelocity(now + middle) * (times_[k] - times_[k - 1]);
        const Rotation turned = rotationBy(there.angle - here.angle);
        MovingBox leg = box;
        leg.velocity = path.velocity(now + middle);
        leg.from = times_[k - 1];
        leg.to = times_[k];
        leg.axis = turned.apply(box.axis);
        leg.centre = centroid + there.position - here.position - leg.velocity * middle;
        if (std::fabs(turning) > kStraightTurn) {
            leg.round = distance(box.centre, centroid) + box.reach();
            leg.half = {};
        } else {
            leg.centre += turned.apply(box.centre - centroid);
        }
        course.push_back(leg);
    }
}

void MeshAvoidance::readMovers(const WorldState& state) {
    std::size_t count = 0;
    for (const ObstaclePiece& piece : state.environment.pieces()) {
        if (!piece.moving) continue;
        if (count == movers_.size()) movers_.emplace_back();
        Neighbour& mover = movers_[count++];
        mover.moves = true;
        mover.course.clear();
        readMover(state, piece, mover.course);
    }
    movers_.resize(count);
}

// Lists the neighbours that the group could meet and does not touch yet.
void MeshAvoidance::listNear(const WorldState& state, const Group& group, const CourseDef& own) {
    near_.clear();
    for (const Neighbour& mover : movers_) near_.push_back(&mover);
    for (const Group& other : state.groups) {
        const Neighbour& mesh = meshes_[&other - state.groups.data()];
        const bool together = &other == &group || staysWith(group, other.id) || staysWith(other, group.id);
        if (!together && !mesh.course.empty()) near_.push_back(&mesh);
    }
    MovingBox still = own.box;
    std::erase_if(near_, [&](const Neighbour* other) {
        MovingBox wide = own.box;
        wide.round += own.cruise * kKnownAhead;
        still.to = state.parameters.stepTime;
        return firstContact({&wide, 1}, other->course, kGroupDistance) == kInfiniteCost ||
               firstContact({&still, 1}, other->course, 0.0) < kInfiniteCost;
    });
}

// True where a manoeuvre meets a neighbour; with `movers`, only moving obstacles count.
bool MeshAvoidance::meets(const CourseDef& own, const Manoeuvre& manoeuvre, bool movers) {
    listCourse(own, manoeuvre, manoeuvre.wait + kCourseHorizon, course_);
    return std::any_of(near_.begin(), near_.end(), [&](const Neighbour* other) {
        return (other->moves || !movers) &&
               firstContact(course_, other->course, kGroupDistance) < kInfiniteCost;
    });
}

// True where the ground beside a course has as much room as the formation needs, or as it has on its route.
bool MeshAvoidance::hasRoom(const WayGround& ground, double half, const CourseDef& own, double offCourse) {
    const Vec2 on = own.middle - own.side * own.offCourse;
    const Vec2 along = normalized(own.ahead.front() - on);
    const double whole = std::min(own.cruise * kCourseHorizon, distance(own.ahead.front(), on));
    const double step = std::max(1.0, 0.5 * half);
    for (double s = 0.0; s <= whole; s += step) {
        const double share = std::min(1.0,
                                      s * kSideShare / kOnwardShare / std::max(1e-9, std::fabs(offCourse)));
        const Vec2 p = on + along * s;
        if (ground.clearanceAt(p + own.side * (offCourse * share)) < std::min(half, ground.clearanceAt(p)))
            return false;
    }
    return true;
}

// Chooses the manoeuvre that loses least time and meets no neighbour; where there is none, the one that meets
// no moving obstacle, since people pass each other one by one.
void MeshAvoidance::choose(const WayGround& ground, double half, const CourseDef& own, Avoidance& avoidance) {
    for (const bool movers : {false, true}) {
        Manoeuvre best{kDelays[0], own.offCourse};
        double least = kInfiniteCost;
        const auto look = [&](const Manoeuvre& tried) {
            double cost = timeLost(own, tried);
            const bool same = tried.offCourse == avoidance.chosen.offCourse &&
                              (tried.wait > 0.0) == (avoidance.chosen.wait > 0.0);
            if (!same) cost += kManoeuvreGain;
            if (cost >= least) return;
            if (tried.offCourse != 0.0 && tried.offCourse != own.offCourse &&
                !hasRoom(ground, half, own, tried.offCourse))
                return;
            if (meets(own, tried, movers)) return;
            least = cost;
            best = tried;
        };
        look({});
        look({0.0, avoidance.chosen.offCourse});
        for (int k = 1; k <= kMostCourses; ++k) {
            look({0.0, -kCourseStep * k});
            look({0.0, kCourseStep * k});
        }
        for (const double wait : kDelays)
            for (const double offCourse : {0.0, avoidance.chosen.offCourse}) look({wait, offCourse});
        if (least < kInfiniteCost || movers) {
            avoidance.chosen = best;
            return;
        }
    }
}

void MeshAvoidance::decide(const WorldState& state, const WayGround& ground, const MarchDef& def,
                           Group& group) {
    Avoidance& avoidance = group.avoidance;
    if (!known_) {
        readMeshes(state);
        readMovers(state);
        known_ = true;
    }
    const Vec2 on = meanOf(group.places.positions()) - avoidance.offCourse;
    const Vec2 along = normalized(group.orders.march.ahead().front() - on);
    if (!(along == Vec2{})) avoidance.side = perpendicular(along);
    const CourseDef own = courseDefOf(state, group, def);
    listNear(state, group, own);
    const WayNeeds needs = needsOf(state, group, group.orders.orders.front().order);
    if (!near_.empty() && keepsClear(group))
        choose(ground, needs.half, own, avoidance);
    else
        avoidance.chosen = {};
    listCourse(own, avoidance.chosen, kKnownAhead, meshes_[&group - state.groups.data()].course);
}

Vec2 MeshAvoidance::advance(const WorldState& state, const WayGround& ground, MarchDef& def, Group& group) {
    Avoidance& avoidance = group.avoidance;
    const double dt = state.parameters.stepTime;
    const auto period = std::max<std::uint32_t>(
        1, static_cast<std::uint32_t>(std::floor(kManoeuvreInterval / dt + 0.5)));
    const bool fresh = avoidance.side == Vec2{};
    if (fresh || (state.stepCount + group.id.value) % period == 0) decide(state, ground, def, group);
    const bool waits = avoidance.chosen.wait > 0.0;
    avoidance.waited = std::max(0.0, avoidance.waited + (waits ? dt : -kWaitRecovery * dt));
    avoidance.presses = avoidance.presses ? avoidance.waited > 0.0 : avoidance.waited > kMostWait;
    if (waits) {
        def.speed = std::max(0.0, group.flow.speed - def.acceleration * dt);
        return avoidance.offCourse;
    }
    // By the end of the route it is back on its course.
    double left = 0.0;
    for (std::size_t k = 1; k < group.flow.way.size(); ++k)
        left += (1.0 - group.flow.q) * distance(group.flow.way[k - 1], group.flow.way[k]);
    const Vec2 wanted = clampLength(avoidance.side * avoidance.chosen.offCourse, left);
    const Vec2 step = clampLength(wanted - avoidance.offCourse, kSideShare * def.speed * dt);
    if (!(step == Vec2{})) def.speed *= kOnwardShare;
    return clampLength(avoidance.offCourse + step, left);
}

}  // namespace muster
