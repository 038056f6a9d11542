#include "lab/study/models/seen_ground.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();
constexpr double kNarrowShare = 0.3;   // Share of a front's width below which a way is narrow for it.
constexpr double kSampleLength = 0.5;  // Distance between two samples of a front [m].
// Length by which blocks are grown less, so that a line along a margin is clear [m].
constexpr double kMarginSlack = 0.01;

// Whether the segment from a to b meets the inside of the box (Liang and Barsky 1984).
bool meets(const Box& box, Vec2 a, Vec2 b) {
    double from = 0.0;
    double to = 1.0;
    const auto clip = [&](double origin, double delta, double low, double high) {
        if (delta == 0.0) return origin > low && origin < high;
        double near = (low - origin) / delta;
        double far = (high - origin) / delta;
        if (near > far) std::swap(near, far);
        from = std::max(from, near);
        to = std::min(to, far);
        return from < to;
    };
    return clip(a.x, b.x - a.x, box.min.x, box.max.x) && clip(a.y, b.y - a.y, box.min.y, box.max.y);
}

bool inside(const Box& box, Vec2 p) {
    return p.x > box.min.x && p.x < box.max.x && p.y > box.min.y && p.y < box.max.y;
}

}  // namespace

SeenGround::SeenGround(std::span<const Box> blocks, const Box& border, double margin) : border_(border) {
    for (const Box& block : blocks) blocks_.push_back(block.grown(margin - kMarginSlack));
    for (const Box& block : blocks) {
        const Box grown = block.grown(margin);
        for (const Vec2 corner :
             {grown.min, Vec2{grown.max.x, grown.min.y}, grown.max, Vec2{grown.min.x, grown.max.y}}) {
            const bool covered = std::any_of(blocks_.begin(), blocks_.end(),
                                             [&](const Box& other) { return inside(other, corner); });
            if (border.contains(corner) && !covered) corners_.push_back(corner);
        }
    }
    joinCorners();
}

SeenGround::Narrow SeenGround::narrowest(Vec2 a, Vec2 b, double width) const {
    const double length = muster::distance(a, b);
    if (length < 1e-9) return {width, 0.0};
    const Vec2 along = (b - a) / length;
    const Vec2 across = perpendicular(along);
    Narrow narrow{width, 0.0};
    for (double s = 0.0; s <= length; s += kSampleLength) {
        double free = 0.0;
        double most = 0.0;
        for (double t = -0.5 * width; t <= 0.5 * width; t += kSampleLength) {
            const Vec2 p = a + along * s + across * t;
            const bool barred = std::any_of(blocks_.begin(), blocks_.end(),
                                            [&](const Box& block) { return inside(block, p); });
            if (!border_.contains(p)) continue;
            most += kSampleLength;
            free += barred ? 0.0 : kSampleLength;
        }
        if (most == 0.0) continue;
        const double here = width * free / most;
        narrow.least = std::min(narrow.least, here);
        if (here < kNarrowShare * width) narrow.end = s + kSampleLength;
    }
    return narrow;
}

// Lengths of all shortest ways between corners, by Floyd and Warshall.
void SeenGround::joinCorners() {
    const std::size_t n = corners_.size();
    lengths_.assign(n * n, kNoWay);
    next_.assign(n * n, -1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            if (!clear(corners_[i], corners_[j])) continue;
            lengths_[i * n + j] = muster::distance(corners_[i], corners_[j]);
            next_[i * n + j] = static_cast<std::ptrdiff_t>(j);
        }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const double through = lengths_[i * n + k] + lengths_[k * n + j];
                if (through >= lengths_[i * n + j]) continue;
                lengths_[i * n + j] = through;
                next_[i * n + j] = next_[i * n + k];
            }
}

bool SeenGround::clear(Vec2 a, Vec2 b) const {
    for (const Box& block : blocks_) {
        // A way from a point within a margin walks out of the margin first.
        if (inside(block, a) || inside(block, b)) {
            const Vec2 middle = (block.min + block.max) * 0.5;
            const Box core{lerp(middle, block.min, 0.7), lerp(middle, block.max, 0.7)};
            if (meets(core, a, b)) return false;
        } else if (meets(block, a, b)) {
            return false;
        }
    }
    return true;
}

SeenGround::Best SeenGround::best(Vec2 a, Vec2 b) const {
    if (clear(a, b)) return {muster::distance(a, b), -1, -1};
    const std::size_t n = corners_.size();
    Best best{kNoWay, -1, -1};
    for (std::size_t j = 0; j < n; ++j) {
        if (!clear(corners_[j], b)) continue;
        const double after = muster::distance(corners_[j], b);
        for (std::size_t i = 0; i < n; ++i) {
            const double length = muster::distance(a, corners_[i]) + lengths_[i * n + j] + after;
            if (length >= best.length || !clear(a, corners_[i])) continue;
            best = {length, static_cast<std::ptrdiff_t>(i), static_cast<std::ptrdiff_t>(j)};
        }
    }
    // The straight line is tried where nothing is seen to lead there.
    return best.first < 0 ? Best{2.0 * muster::distance(a, b), -1, -1} : best;
}

double SeenGround::distance(Vec2 a, Vec2 b) const {
    return best(a, b).length;
}

void SeenGround::appendWay(Vec2 a, Vec2 b, std::vector<Vec2>& way) const {
    const Best found = best(a, b);
    const auto n = static_cast<std::ptrdiff_t>(corners_.size());
    for (std::ptrdiff_t at = found.first; at >= 0; at = next_[at * n + found.last]) {
        way.push_back(corners_[at]);
        if (at == found.last) break;
    }
    way.push_back(b);
}

}  // namespace muster
