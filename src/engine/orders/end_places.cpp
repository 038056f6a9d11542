#include "engine/orders/end_places.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kPoseStep = 0.5;     // Distance between poses that are tried [m]...
constexpr double kPoseGrowth = 0.02;  // ... or the same as a share of their distance, where that is more.
// Greatest distance of a pose from the target, in reaches of the formation.
constexpr double kMostPoseReach = 1.0;
// Tangents of the angles to its own route at which a formation may stand beside others.
constexpr double kSlopes[] = {0.0, -0.2, 0.2, -0.4, 0.4, -0.6, 0.6, -0.8,
                              0.8, -1.0, 1.0, -1.3, 1.3, -1.6, 1.6};
// Distance up to which places with a clear line between them are joined [spacings].
constexpr double kJoinedSpacings = 2.5;
constexpr double kTighterSpacing = 0.85;  // Factor of the spacing where there is too little room.
constexpr double kMostInWalls = 0.25;     // Share of places that may have to leave the formation.

// Sixteen directions; exact unit vectors are not needed.
constexpr Vec2 kAround[16] = {{1, 0},  {.924, .383},   {.707, .707},   {.383, .924},
                              {0, 1},  {-.383, .924},  {-.707, .707},  {-.924, .383},
                              {-1, 0}, {-.924, -.383}, {-.707, -.707}, {-.383, -.924},
                              {0, -1}, {.383, -.924},  {.707, -.707},  {.924, -.383}};

}  // namespace

// True for a point where another agent stands or will stand.
bool EndPlaces::isTaken(Vec2 p) const {
    const auto isNear = [&](std::int32_t k) { return lengthSquared(takenAt_[k] - p) < apart_ * apart_; };
    return !takenAt_.empty() && taken_.anyBeside(p, isNear);
}

// True where every place of the formation is free at a point; `beside`: points taken by others count.
bool EndPlaces::fits(const EndDef& def, const FreeSpace& space, Vec2 at, bool beside) const {
    const Pose pose{at, def.pose.rotation};
    return std::all_of(def.offsets.begin(), def.offsets.end(), [&](Vec2 offset) {
        const Vec2 p = pose.apply(offset);
        return space.contains(p) && !(beside && isTaken(p));
    });
}

// Finds the nearest pose at which every place is free, seen from the target.
bool EndPlaces::findFit(const EndDef& def, const FreeSpace& space, double farthest, bool beside,
                        Vec2& at) const {
    const Environment& environment = space.routes().environment();
    const Vec2 target = def.pose.position;
    const Vec2 from = space.nearest(target);
    for (double far = 0.0; far <= farthest; far += kPoseStep)
        for (const Vec2 direction : kAround) {
            const Vec2 centre = target + direction * far;
            if (space.contains(centre) && environment.clearStaticLine(from, centre, 0.0) &&
                fits(def, space, centre, beside)) {
                at = centre;
                return true;
            }
            if (far == 0.0) break;
        }
    return false;
}

// True where only people stand between two poses: each place has a clear line to its position in the other.
bool EndPlaces::isBeside(const EndDef& def, const FreeSpace& space, Vec2 a, Vec2 b) {
    return std::all_of(def.offsets.begin(), def.offsets.end(), [&](Vec2 offset) {
        const Vec2 arm = def.pose.rotation.apply(offset);
        return space.routes().environment().clearStaticLine(a + arm, b + arm, 0.0);
    });
}

// True where all places are joined by clear lines between neighbours.
bool EndPlaces::isJoined(const FreeSpace& space, double spacing, std::span<const Vec2> ends, Vec2 middle) {
    const Environment& environment = space.routes().environment();
    const std::size_t n = ends.size();
    const double reach = kJoinedSpacings * spacing;
    std::size_t first = 0;
    for (std::size_t i = 1; i < n; ++i)
        if (lengthSquared(ends[i] - middle) < lengthSquared(ends[first] - middle)) first = i;
    met_.assign(n, 0);
    queue_.assign(1, static_cast<std::int32_t>(first));
    met_[first] = 1;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const Vec2 here = ends[queue_[head]];
        for (std::size_t i = 0; i < n; ++i) {
            if (met_[i] || lengthSquared(ends[i] - here) > reach * reach ||
                !environment.clearStaticLine(here, ends[i], 0.0))
                continue;
            met_[i] = 1;
            queue_.push_back(static_cast<std::int32_t>(i));
        }
    }
    return queue_.size() == n;
}

// True where no agent stands on the line from where the formation comes to a point.
bool EndPlaces::isOpenTo(const EndDef& def, Vec2 at) const {
    const Vec2 back = normalized(def.from - at);
    const double whole = distance(at, def.from);
    for (double s = 0.0; s < whole; s += apart_)
        if (isTaken(at + back * s)) return false;
    return true;
}

// Finds a pose beside agents that have taken the target: on the formation's own side of them, so that it need
// not cross them, with no wall between. Poses are tried along circles through the target whose diameters lie
// on the formation's route: the farther aside a pose is, the nearer it must be.
bool EndPlaces::findBeside(const EndDef& def, const FreeSpace& space, Vec2 there, Vec2& at) const {
    const Vec2 back = normalized(def.from - there), side = perpendicular(back);
    const double whole = distance(there, def.from);
    for (double diameter = kPoseStep; diameter < whole;
         diameter += std::max(kPoseStep, kPoseGrowth * diameter))
        for (const double slope : kSlopes) {
            at = there + (back + side * slope) * (diameter / (1.0 + slope * slope));
            if (space.contains(at) && fits(def, space, at, true) && isOpenTo(def, at) &&
                isBeside(def, space, there, at))
                return true;
        }
    return false;
}

// True where one of the last points is nearer than `distance`: the flood comes to neighbouring points at
// about the same time.
bool EndPlaces::isNearLast(Vec2 p, double distance) const {
    const std::size_t n = points_.size();
    const auto last = static_cast<std::size_t>(8.0 * std::sqrt(static_cast<double>(n))) + 64;
    for (std::size_t k = n > last ? n - last : 0; k < n; ++k)
        if (lengthSquared(points_[k] - p) < distance * distance) return true;
    return false;
}

// Lays the places on the free points nearest to the target by the ground's own distance; the sides of the
// formation stay together.
bool EndPlaces::layOut(const EndDef& def, const FreeSpace& space, double apart, std::vector<Vec2>& ends) {
    const std::size_t n = def.offsets.size();
    const Vec2 from = space.nearest(def.pose.position);
    const double least = kSiteSpacing * apart / kTighterSpacing;
    for (double spacing = std::max(def.spacing, least);;
         spacing = std::max(least, kTighterSpacing * spacing)) {
        points_.clear();
        flood_.begin(space.routes(), space.region(), spacing);
        for (std::size_t i = 0; i < n; ++i) flood_.add(static_cast<std::int32_t>(i), from);
        flood_.run(1, [&](std::int32_t, Vec2 p) {
            if (!space.contains(p) || isTaken(p) || isNearLast(p, kTighterSpacing * spacing)) return false;
            points_.push_back(p);
            return true;
        });
        if (points_.size() == n) break;
        if (spacing <= least) return false;
    }
    asked_.clear();
    for (const Vec2 offset : def.offsets) asked_.push_back(def.pose.apply(offset));
    const auto to = pairing_.pair(asked_, points_);
    for (std::size_t i = 0; i < n; ++i) ends[i] = points_[to[i]];
    return true;
}

void EndPlaces::find(const EndDef& def, const FreeSpace& space, double apart, std::vector<Vec2>& ends,
                     Pose& pose) {
    pose = def.pose;
    const std::size_t n = def.offsets.size();
    ends.resize(n);
    takenAt_ = def.taken;
    apart_ = std::max(apart, kTighterSpacing * def.spacing);
    if (!takenAt_.empty()) taken_.sort(takenAt_, apart_);
    const double near = kMostPoseReach * def.reach + kPoseStep;
    bool fits = def.moves && findFit(def, space, near, true, pose.position);
    // The formation goes round other agents, but not round walls.
    const bool crowded = def.moves && !fits && !takenAt_.empty() &&
                         findFit(def, space, near, false, pose.position);
    EndDef beside = def;
    if (crowded) {
        const Vec2 there = pose.position;
        fits = findBeside(def, space, there, pose.position);
        // Otherwise the formation gathers round them.
        if (!fits) beside.pose.position = pose.position = there;
    }
    std::size_t inWalls = 0;
    for (std::size_t i = 0; i < n; ++i) {
        ends[i] = pose.apply(def.offsets[i]);
        if (!fits && !space.contains(ends[i])) ++inWalls;
    }
    if (fits) return;
    if (!crowded && static_cast<double>(inWalls) <= kMostInWalls * static_cast<double>(n)) {
        separateTargets(space, apart, ends, fit_, separation_);
        if (isJoined(space, def.spacing, ends, space.nearest(pose.position))) return;
    }
    if (layOut(beside, space, apart, ends)) return;
    for (std::size_t i = 0; i < n; ++i) ends[i] = pose.apply(def.offsets[i]);
    separateTargets(space, apart, ends, fit_, separation_);
}

}  // namespace muster
