// Paths of travelling places: a shared route where one leads there, else a route of its own; round moving
// obstacles.
#include <limits>

#include "engine/formation/places/place_tracker.h"

namespace muster {
namespace {

// Distance between samples of a path that are tested against moving obstacles [m].
constexpr double kSampleSpacing = 0.5;
constexpr std::int32_t kSamples = 30;     // Number of samples from the start on.
constexpr std::int32_t kSamplesPast = 2;  // Number of samples past an obstacle at which a path round it ends.
constexpr std::int64_t kDetourWork = 30000;  // Bound on the search round moving obstacles [operations].

// Writes points along a path, from its start on.
void samplePath(const std::vector<Vec2>& path, std::vector<Vec2>& samples) {
    samples.clear();
    double past = 0.0;  // Length past the last sample on the present segment.
    for (std::size_t k = 1; k < path.size() && samples.size() < kSamples; ++k) {
        const double whole = distance(path[k - 1], path[k]);
        for (; past < whole && samples.size() < kSamples; past += kSampleSpacing)
            samples.push_back(lerp(path[k - 1], path[k], past / whole));
        past -= whole;
    }
    if (samples.size() < kSamples) samples.push_back(path.back());
}

}  // namespace

// Finds a path for a place; returns the operations used.
std::int64_t PlaceTracker::findPath(RouteGraph& routes, Vec2 from, Vec2 to, std::vector<Vec2>& path) {
    std::int64_t work = 1;
    if (!ways_.join(routes.ground(), from, to, path, work)) {
        search_.start(routes, from, to);
        std::int64_t budget = std::numeric_limits<std::int64_t>::max();
        search_.advance(routes, budget);
        path = search_.path();
        work += search_.work();
        if (!path.empty()) ways_.add(path);
    }
    if (!path.empty() && !routes.environment().movingObstacleAreas().empty())
        work += passMovingObstacles(routes, path);
    return work;
}

// Replaces the first metres of a path where a moving obstacle lies on them now. Where there is no path past
// it the old path stays: the place waits.
std::int64_t PlaceTracker::passMovingObstacles(RouteGraph& routes, std::vector<Vec2>& path) {
    const Environment& environment = routes.environment();
    const double radius = routes.ground().radius();
    samplePath(path, samples_);
    const std::size_t n = samples_.size();
    std::size_t blocked = 1;
    while (blocked < n && environment.clearLine(samples_[blocked - 1], samples_[blocked], radius)) ++blocked;
    if (blocked >= n) return 0;
    std::size_t past = blocked;
    while (past < n && !environment.clearLine(samples_[past], samples_[past], radius)) ++past;
    past = std::min(past + kSamplesPast, n - 1);
    search_.start(routes, path.front(), samples_[past], {}, true);
    std::int64_t budget = kDetourWork;
    if (search_.advance(routes, budget) != RouteStatus::Found) return search_.work();
    // The corners that the samples up to there have passed are dropped.
    double left = static_cast<double>(past) * kSampleSpacing;
    std::size_t next = 1;
    for (; next < path.size() && distance(path[next - 1], path[next]) <= left; ++next)
        left -= distance(path[next - 1], path[next]);
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(next));
    path.insert(path.begin(), search_.path().begin(), search_.path().end());
    return search_.work();
}

}  // namespace muster
