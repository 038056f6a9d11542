#include "lab/study/models/tour.h"

#include <algorithm>

namespace muster {
namespace {

constexpr double kTrustedShare = 0.85;    // Share of an item's reach that the operator counts on.
constexpr std::int32_t kMostRounds = 40;  // Number of rounds of improvement, at most.
constexpr std::int32_t kSpoilTries = 60;

}  // namespace

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double squared = lengthSquared(along);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return distance(p, a + along * t);
}

bool Sweep::collects(Vec2 a, Vec2 b, Vec2 item) const {
    return std::any_of(offsets.begin(), offsets.end(), [&](Vec2 offset) {
        return distanceToSegment(item, a + offset, b + offset) <= kTrustedShare * reach;
    });
}

TourFinder::TourFinder(const SeenGround& ground, std::span<const Vec2> items)
    : ground_(&ground), items_(items.begin(), items.end()), count_(items.size()), lengths_(count_ * count_) {
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < i; ++j)
            lengths_[i * count_ + j] = lengths_[j * count_ + i] = ground.distance(items_[i], items_[j]);
}

double TourFinder::length(Vec2 from, std::span<const std::int32_t> order) const {
    if (order.empty()) return 0.0;
    double sum = ground_->distance(from, items_[order[0]]);
    for (std::size_t i = 1; i < order.size(); ++i) sum += between(order[i - 1], order[i]);
    return sum;
}

// Reverses stretches and moves single items, while that shortens the tour (Croes 1958; Or 1976).
void TourFinder::improve(std::vector<std::int32_t>& order, std::span<const double> fromStart) const {
    const auto n = std::ssize(order);
    const auto link = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        if (j >= n) return 0.0;
        return i < 0 ? fromStart[order[j]] : between(order[i], order[j]);
    };
    for (std::int32_t round = 0; round < kMostRounds; ++round) {
        bool better = false;
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            for (std::ptrdiff_t j = i + 1; j < n; ++j) {
                const double now = link(i - 1, i) + link(j, j + 1);
                const double head = i == 0 ? fromStart[order[j]] : between(order[i - 1], order[j]);
                const double tail = j + 1 < n ? between(order[i], order[j + 1]) : 0.0;
                if (head + tail >= now - 1e-9) continue;
                std::reverse(order.begin() + i, order.begin() + j + 1);
                better = true;
            }
        }
        if (!better) return;
    }
}

std::vector<std::int32_t> TourFinder::tour(Vec2 from, std::span<const std::int32_t> open, double detour,
                                           Chance& chance) const {
    std::vector<double> fromStart(count_, 0.0);
    for (const std::int32_t i : open) fromStart[i] = ground_->distance(from, items_[i]);
    // The nearest item is next, then the order is improved.
    std::vector<std::int32_t> left(open.begin(), open.end());
    std::vector<std::int32_t> order;
    while (!left.empty()) {
        const auto cost = [&](std::int32_t i) {
            return order.empty() ? fromStart[i] : between(order.back(), i);
        };
        const auto nearest = std::min_element(left.begin(), left.end(), [&](std::int32_t a, std::int32_t b) {
            return cost(a) != cost(b) ? cost(a) < cost(b) : a < b;
        });
        order.push_back(*nearest);
        left.erase(nearest);
    }
    improve(order, fromStart);
    // Stretches are turned round at random while the tour stays within the detour.
    const double most = (1.0 + detour) * length(from, order);
    for (std::int32_t i = 0; i < kSpoilTries && order.size() > 2 && detour > 0.0; ++i) {
        const auto a = chance.below(static_cast<std::uint32_t>(order.size()));
        const auto b = chance.below(static_cast<std::uint32_t>(order.size()));
        const auto [first, last] = std::minmax(a, b);
        std::vector<std::int32_t> other = order;
        std::reverse(other.begin() + first, other.begin() + last + 1);
        if (length(from, other) <= most) order = std::move(other);
    }
    return order;
}

std::vector<std::int32_t> TourFinder::thinned(Vec2 from, std::span<const std::int32_t> order,
                                              const Sweep& sweep) const {
    std::vector<std::int32_t> kept(order.begin(), order.end());
    std::vector<std::int32_t> left;  // Items left out, which the crowd collects beside the way.
    const auto at = [&](std::ptrdiff_t i) { return i < 0 ? from : items_[kept[i]] - sweep.aim; };
    const auto covered = [&](std::int32_t item) {
        for (std::ptrdiff_t i = 0; i < std::ssize(kept); ++i)
            if (sweep.collects(at(i - 1), at(i), items_[item])) return true;
        return false;
    };
    for (std::size_t i = 0; i < kept.size();) {
        const std::int32_t item = kept[i];
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        left.push_back(item);
        if (std::all_of(left.begin(), left.end(), covered)) continue;
        left.pop_back();
        kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(i), item);
        ++i;
    }
    return kept;
}

}  // namespace muster
