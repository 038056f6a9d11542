#include "engine/orders/pairing.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::size_t
    kWindow = 24;               // Pairs in the order of the splits are compared with so many that follow.
constexpr int kPairPasses = 6;  // And so often at most.

// Whole millimetres about the mean: so two sets that differ by a shift are split alike.
void centre(std::span<const Vec2> points, std::vector<Vec2>& centred) {
    Vec2 mean;
    for (const Vec2 p : points) mean += p;
    mean = mean / std::max(1.0, static_cast<double>(points.size()));
    centred.clear();
    for (const Vec2 p : points)
        centred.push_back(
            {std::floor((p.x - mean.x) * 1000.0 + 0.5), std::floor((p.y - mean.y) * 1000.0 + 0.5)});
}

void sortAlong(bool x, const std::vector<Vec2>& points, std::int32_t* begin, std::int32_t* middle,
               std::int32_t* end) {
    std::nth_element(begin, middle, end, [&](std::int32_t a, std::int32_t b) {
        const Vec2 p = points[a], q = points[b];
        const double first = x ? p.x - q.x : p.y - q.y, second = x ? p.y - q.y : p.x - q.x;
        if (first != 0.0) return first < 0.0;
        return second != 0.0 ? second < 0.0 : a < b;
    });
}

}  // namespace

// Halves both sets along the longer side of what they cover, and so on: who is on one side goes to that side.
void Pairing::split(std::size_t begin, std::size_t end) {
    if (end - begin < 2) return;
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
    const auto cover = [&](const std::vector<Vec2>& points, const std::vector<std::int32_t>& order) {
        for (std::size_t k = begin; k < end; ++k) {
            const Vec2 p = points[order[k]];
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    };
    cover(from_, fromOrder_);
    cover(to_, toOrder_);
    const bool x = high.x - low.x >= high.y - low.y;
    const std::size_t middle = begin + (end - begin) / 2;
    for (auto* const side : {&fromOrder_, &toOrder_})
        sortAlong(x, side == &fromOrder_ ? from_ : to_, side->data() + begin, side->data() + middle,
                  side->data() + end);
    split(begin, middle);
    split(middle, end);
}

// Least squares about the means: a shift of the whole changes no choice.
void Pairing::solve() {
    const auto n = static_cast<std::int32_t>(fromOrder_.size());
    cost_.clear();
    for (const std::int32_t i : fromOrder_)
        for (const std::int32_t j : toOrder_) cost_.push_back(lengthSquared(from_[i] - to_[j]));
    if (n > 0) solver_.solve(n, n, cost_.data());
    for (std::int32_t k = 0; k < n; ++k) result_[fromOrder_[k]] = toOrder_[solver_.columnOf()[k]];
}

// Exchanges where two would cross; what lies close together is close in the order of the splits.
void Pairing::improve(std::span<const Vec2> from, std::span<const Vec2> to) {
    const std::size_t n = fromOrder_.size();
    bool changed = true;
    for (int pass = 0; pass < kPairPasses && changed; ++pass) {
        changed = false;
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < std::min(n, a + kWindow); ++b) {
                const Vec2 here = from[fromOrder_[b]] - from[fromOrder_[a]];
                const Vec2 there = to[toOrder_[b]] - to[toOrder_[a]];
                if (dot(here, there) >= -1e-9) continue;
                std::swap(toOrder_[a], toOrder_[b]);
                changed = true;
            }
    }
}

std::span<const std::int32_t> Pairing::pair(std::span<const Vec2> from, std::span<const Vec2> to,
                                            std::span<const std::uint8_t> fromClass,
                                            std::span<const std::uint8_t> toClass) {
    const std::size_t n = std::min(from.size(), to.size());
    result_.assign(n, -1);
    centre(from, from_);
    centre(to, to_);
    std::int32_t most = 0;
    for (const std::uint8_t k : fromClass) most = std::max<std::int32_t>(most, k);
    for (std::int32_t k = 0; k <= most; ++k) {
        fromOrder_.clear();
        toOrder_.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const auto index = static_cast<std::int32_t>(i);
            if (fromClass.empty() || fromClass[i] == k) fromOrder_.push_back(index);
            if (toClass.empty() || toClass[i] == k) toOrder_.push_back(index);
        }
        const std::size_t count = std::min(fromOrder_.size(), toOrder_.size());
        fromOrder_.resize(count);
        toOrder_.resize(count);
        if (count <= kExact) {
            solve();
            continue;
        }
        split(0, count);
        improve(from, to);
        for (std::size_t j = 0; j < count; ++j) result_[fromOrder_[j]] = toOrder_[j];
    }
    return result_;
}

}  // namespace muster
