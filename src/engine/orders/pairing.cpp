#include "engine/orders/pairing.h"

#include <algorithm>
#include <cmath>

#include "base/bounds.h"

namespace muster {
namespace {

constexpr double kPairReach = 2.5;  // Distance up to which points are compared with each other [spacings]...
constexpr int kPairPasses = 12;     // ... and greatest number of passes.

// Rounds to whole millimetres about the mean, so that two sets that differ by a shift are split equally.
void centre(std::span<const Vec2> points, std::vector<Vec2>& centred) {
    const Vec2 mean = meanOf(points);
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

// Approximate distance between points that fill their box, or a line along it.
double meanSpacing(std::span<const Vec2> points) {
    const Box box = boundsOf(points);
    const auto n = static_cast<double>(points.size());
    const Vec2 size = box.max - box.min;
    return std::max({1.0, std::sqrt(size.x * size.y / n), std::max(size.x, size.y) / n});
}

}  // namespace

// Halves both sets along the longer side of their box, and so on: points on one side go to that side.
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

// Solves by least squares about the means: a shift of the whole changes no choice.
void Pairing::solve() {
    const auto n = static_cast<std::int32_t>(fromOrder_.size());
    cost_.clear();
    for (const std::int32_t i : fromOrder_)
        for (const std::int32_t j : toOrder_) cost_.push_back(lengthSquared(from_[i] - to_[j]));
    if (n > 0) solver_.solve(n, n, cost_.data());
    for (std::int32_t k = 0; k < n; ++k) result_[fromOrder_[k]] = toOrder_[solver_.columnOf()[k]];
}

// Exchanges the ends of two points near each other where they would cross. Each exchange lowers the sum.
void Pairing::improve() {
    const std::size_t n = fromOrder_.size();
    fromAt_.clear();
    toAt_.clear();
    goes_.clear();
    for (std::size_t k = 0; k < n; ++k) {
        fromAt_.push_back(from_[fromOrder_[k]]);
        toAt_.push_back(to_[toOrder_[k]]);
        goes_.push_back(static_cast<std::int32_t>(k));
    }
    comes_ = goes_;
    const double near = kPairReach * std::max(meanSpacing(fromAt_), meanSpacing(toAt_));
    fromCells_.sort(fromAt_, near);
    toCells_.sort(toAt_, near);
    bool changed = true;
    const auto compare = [&](std::int32_t a, std::int32_t b) {
        if (dot(fromAt_[b] - fromAt_[a], toAt_[goes_[b]] - toAt_[goes_[a]]) >= 0.0) return;
        std::swap(goes_[a], goes_[b]);
        std::swap(comes_[goes_[a]], comes_[goes_[b]]);
        changed = true;
    };
    for (int pass = 0; pass < kPairPasses && changed; ++pass) {
        changed = false;
        fromCells_.forPairs(near, compare);
        toCells_.forPairs(near, [&](std::int32_t a, std::int32_t b) { compare(comes_[a], comes_[b]); });
    }
    for (std::size_t k = 0; k < n; ++k) result_[fromOrder_[k]] = toOrder_[goes_[k]];
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
        if (count <= kMostExactPairs) {
            solve();
            continue;
        }
        split(0, count);
        improve();
    }
    return result_;
}

}  // namespace muster
