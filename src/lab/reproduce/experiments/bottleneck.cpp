#include "lab/reproduce/experiments/change_watch.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace muster {
namespace {

/// Matches starts with places at most `reach` away, by augmenting paths (Kuhn).
class Matching {
public:
    Matching(std::span<const Vec2> starts, std::span<const Vec2> places, double reach)
        : starts_(starts), places_(places), reach_(reach), taker_(places.size(), -1) {}

    /// True if each start has a place.
    bool complete() {
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            seen_.assign(places_.size(), 0);
            if (!augment(i)) return false;
        }
        return true;
    }

private:
    // The depth of the recursion is at most the number of places.
    bool augment(std::size_t i) {
        for (std::size_t j = 0; j < places_.size(); ++j) {
            if (seen_[j] != 0 || distance(starts_[i], places_[j]) > reach_) continue;
            seen_[j] = 1;
            if (taker_[j] >= 0 && !augment(static_cast<std::size_t>(taker_[j]))) continue;
            taker_[j] = static_cast<std::int32_t>(i);
            return true;
        }
        return false;
    }

    std::span<const Vec2> starts_, places_;
    double reach_;
    std::vector<std::int32_t> taker_;  // By place: the start that it belongs to.
    std::vector<std::uint8_t> seen_;
};

}  // namespace

double bottleneckWalk(std::span<const Vec2> starts, std::span<const Vec2> places) {
    if (starts.empty()) return 0.0;
    if (places.size() < starts.size()) return -1.0;
    // The answer is one of the distances.
    std::vector<double> distances;
    for (const Vec2 a : starts)
        for (const Vec2 b : places) distances.push_back(distance(a, b));
    std::sort(distances.begin(), distances.end());
    const auto least = std::partition_point(distances.begin(), distances.end(), [&](double reach) {
        return !Matching(starts, places, reach).complete();
    });
    return *least;
}

}  // namespace muster
