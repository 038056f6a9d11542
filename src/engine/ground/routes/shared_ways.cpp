#include "engine/ground/routes/shared_ways.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr std::size_t kMostWays = 12;
constexpr std::size_t kReservedWays = 32;  // Number of corners for which a route has memory from the first.
constexpr std::uint32_t kMostRouteAge = 600;  // Number of steps for which routes are kept.
constexpr double kLeastLength = 4.0;          // Length below which a route is not kept [m].
// Factor of the shortest possible length up to which a joined path serves,
constexpr double kLengthFactor = 1.08;
constexpr double kLengthSlack = 0.5;       // plus this length [m].
constexpr double kRounding = 1e-6;         // Length added to boxes round routes [m].
constexpr std::int64_t kJoinLineWork = 6;  // Number of operations counted for the test of a line.

}  // namespace

void SharedWays::age() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < ways_.size(); ++k) {
        if (++ways_[k].age > kMostRouteAge) {
            spare_.push_back(std::move(ways_[k].path));
        } else if (kept++ != k) {
            ways_[kept - 1] = std::move(ways_[k]);
            clear_[kept - 1] = clear_[k];
        }
    }
    ways_.resize(kept);
    clear_.resize(kept);
}

void SharedWays::reserve() {
    ways_.reserve(kMostWays);
    clear_.reserve(kMostWays);
    spare_.reserve(kMostWays);
    while (ways_.size() + spare_.size() < kMostWays) spare_.emplace_back().reserve(kReservedWays);
}

void SharedWays::add(const std::vector<Vec2>& path) {
    if (pathLength(path) < kLeastLength) return;
    reserve();
    if (ways_.size() >= kMostWays) {
        std::rotate(ways_.begin(), ways_.begin() + 1, ways_.end());
        std::rotate(clear_.begin(), clear_.begin() + 1, clear_.end());
    } else {
        ways_.emplace_back();
        clear_.push_back(-1);
        if (!spare_.empty()) {
            ways_.back().path.swap(spare_.back());
            spare_.pop_back();
        }
    }
    ways_.back().path.reserve(kReservedWays);
    ways_.back().path = path;
    ways_.back().age = 0;
    ways_.back().findBox();
    clear_.back() = -1;
}

void SharedWays::add(const SharedWays& others) {
    reserve();
    for (const Way& way : others.ways_)
        if (ways_.size() < kMostWays) ways_.push_back(way);
    clear_.assign(ways_.size(), -1);
}

void SharedWays::Way::findBox() {
    box = {{kInfiniteCost, kInfiniteCost}, {-kInfiniteCost, -kInfiniteCost}};
    for (const Vec2 p : path) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
}

// False where no point of the route is within reach.
bool SharedWays::Way::isNear(Vec2 p, double reach) const {
    const double margin = reach + kRounding;
    return p.x >= box.min.x - margin && p.x <= box.max.x + margin && p.y >= box.min.y - margin &&
           p.y <= box.max.y + margin;
}

SharedWays::Foot SharedWays::nearestFoot(const std::vector<Vec2>& path, Vec2 p) {
    Foot best;
    best.distance = distance(path[0], p);
    best.point = path[0];
    double least = lengthSquared(path[0] - p);
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        const Vec2 along = path[k + 1] - path[k];
        const double squared = lengthSquared(along);
        const double t = squared > 0.0 ? std::clamp(dot(p - path[k], along) / squared, 0.0, 1.0) : 0.0;
        const Vec2 point = path[k] + along * t;
        const double apart = lengthSquared(point - p);
        if (apart >= least) continue;
        least = apart;
        const double d = std::sqrt(apart);
        if (d < best.distance) best = {k, point, d};
    }
    return best;
}

// Forgets on another ground which routes are clear.
void SharedWays::followGround(const RouteGround& ground) {
    const std::uint64_t instance = ground.environment().instance();
    const std::uint64_t version = ground.environment().staticVersion();
    if (instance_ == instance && version_ == version && radius_ == ground.radius()) return;
    std::fill(clear_.begin(), clear_.end(), std::int8_t{-1});
    instance_ = instance;
    version_ = version;
    radius_ = ground.radius();
}

// True where the route is clear: obstacles may have been built on it. The result is remembered, so that it
// counts no operations.
bool SharedWays::isClear(const RouteGround& ground, std::size_t index) {
    if (clear_[index] >= 0) return clear_[index] == 1;
    const std::vector<Vec2>& path = ways_[index].path;
    clear_[index] = 1;
    for (std::size_t k = 1; k < path.size() && clear_[index] == 1; ++k)
        if (!ground.lineClear(path[k - 1], path[k])) clear_[index] = 0;
    return clear_[index] == 1;
}

bool SharedWays::join(const RouteGround& ground, Vec2 from, Vec2 to, std::vector<Vec2>& path,
                      std::int64_t& work) {
    followGround(ground);
    for (std::size_t index = ways_.size(); index-- > 0;) {
        const std::vector<Vec2>& way = ways_[index].path;
        work += static_cast<std::int64_t>(way.size());
        const Foot first = nearestFoot(way, from), last = nearestFoot(way, to);
        if (last.segment < first.segment) continue;
        path.assign({from, first.point});
        for (std::size_t k = first.segment + 1; k <= last.segment; ++k) path.push_back(way[k]);
        path.push_back(last.point);
        const double along = pathLength(std::span(path).subspan(1));
        path.push_back(to);
        // A shorter path would make the known one shorter, too.
        const double least = std::max(distance(from, to), along - first.distance - last.distance);
        work += 2 * kJoinLineWork;
        if (!ground.lineClear(from, first.point) || !ground.lineClear(last.point, to)) continue;
        if (!isClear(ground, index)) continue;
        skipCorners(ground, path);
        work += kJoinLineWork * static_cast<std::int64_t>(path.size());
        if (pathLength(path) <= kLengthFactor * least + kLengthSlack) return true;
    }
    path.clear();
    return false;
}

double SharedWays::lengthAlong(Vec2 from, Vec2 to, double reach) const {
    double least = kInfiniteCost;
    for (const Way& way : ways_) {
        if (!way.isNear(from, reach) || !way.isNear(to, reach)) continue;
        const Foot first = nearestFoot(way.path, from);
        if (first.distance > reach) continue;
        const Foot last = nearestFoot(way.path, to);
        if (last.distance > reach || last.segment < first.segment) continue;
        double sum = first.distance + last.distance;
        Vec2 at = first.point;
        for (std::size_t k = first.segment + 1; k <= last.segment; ++k) {
            sum += distance(at, way.path[k]);
            at = way.path[k];
        }
        least = std::min(least, sum + distance(at, last.point));
    }
    return least;
}

bool SharedWays::sane() const {
    const auto fits = [](Vec2 p) { return std::fabs(p.x) <= 1e10 && std::fabs(p.y) <= 1e10; };
    return ways_.size() <= kMostWays && std::all_of(ways_.begin(), ways_.end(), [&](const Way& way) {
               return !way.path.empty() && std::all_of(way.path.begin(), way.path.end(), fits);
           });
}

}  // namespace muster
