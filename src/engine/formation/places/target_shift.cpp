#include "engine/formation/places/target_shift.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/maths.h"

namespace muster {
namespace {

constexpr int kShiftDirections = 16;

struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
};

Extent extentAlong(std::span<const Vec2> points, Vec2 direction) {
    Extent extent;
    for (const Vec2 p : points) {
        const double along = dot(p, direction);
        extent.least = std::min(extent.least, along);
        extent.most = std::max(extent.most, along);
    }
    return extent;
}

}  // namespace

bool TargetShift::clashes(std::span<const Vec2> others, Vec2 shift, double distance) {
    for (const Vec2 axis : {Vec2{1, 0}, Vec2{0, 1}}) {
        const Extent own = extentAlong(points_, axis), theirs = extentAlong(others, axis);
        const double moved = dot(shift, axis);
        if (own.least + moved > theirs.most + distance || own.most + moved < theirs.least - distance)
            return false;
    }
    together_.clear();
    for (const Vec2 p : points_) together_.push_back(p + shift);
    together_.insert(together_.end(), others.begin(), others.end());
    cells_.sort(together_, distance);
    const auto count = static_cast<std::int32_t>(points_.size());
    bool found = false;
    cells_.forPairs(distance,
                    [&](std::int32_t i, std::int32_t j) { found = found || (i < count) != (j < count); });
    return found;
}

bool TargetShift::clashes(Vec2 shift, double distance) {
    return std::any_of(others_.begin(), others_.end(),
                       [&](std::span<const Vec2> others) { return clashes(others, shift, distance); });
}

// Goes past one group after the other, until no shifted point clashes: at most once past each.
double TargetShift::clearLength(Vec2 direction, double distance, double gap) {
    const Extent own = extentAlong(points_, direction);
    double length = 0.0;
    for (std::size_t round = 0; round < others_.size(); ++round) {
        double needed = length;
        for (const std::span<const Vec2> others : others_)
            if (clashes(others, direction * length, distance))
                needed = std::max(needed, extentAlong(others, direction).most + gap - own.least);
        if (needed == length) break;
        length = needed;
    }
    return length;
}

bool TargetShift::mostlyFree(Vec2 shift, const std::function<bool(Vec2)>& isFree) const {
    const auto free = std::count_if(points_.begin(), points_.end(),
                                    [&](Vec2 p) { return isFree(p + shift); });
    return 10 * free >= 9 * std::ssize(points_);
}

Vec2 TargetShift::find(double distance, double gap, const std::function<bool(Vec2)>& isFree) {
    std::array<Candidate, kShiftDirections> candidates;
    for (int k = 0; k < kShiftDirections; ++k) {
        const double angle = 2.0 * kPi * k / kShiftDirections;
        const Vec2 direction{cosine(angle), sine(angle)};
        const double length = clearLength(direction, distance, gap);
        candidates[k] = {direction * length, length, mostlyFree(direction * length, isFree)};
    }
    // Of directions that are equally good, as between two equal squares, the first.
    const auto better = [](const Candidate& a, const Candidate& b) {
        return a.free != b.free ? a.free : a.length < b.length - 1e-6;
    };
    return std::min_element(candidates.begin(), candidates.end(), better)->shift;
}

}  // namespace muster
