#include "lab/study/statistics/describe.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/random.h"
#include "lab/study/statistics/numerics.h"

namespace muster::statistics {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double quantile(std::vector<double> values, double p) {
    if (values.empty()) return kNone;
    std::sort(values.begin(), values.end());
    const double at = p * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

double median(const std::vector<double>& values) {
    return quantile(values, 0.5);
}

BoxSummary boxSummary(const std::vector<double>& values) {
    BoxSummary box{
        .lower = quantile(values, 0.25), .middle = quantile(values, 0.5), .upper = quantile(values, 0.75)};
    const double reach = 1.5 * (box.upper - box.lower);
    box.low = box.lower;
    box.high = box.upper;
    for (const double value : values) {
        if (value < box.lower - reach || value > box.upper + reach)
            box.beyond.push_back(value);
        else {
            box.low = std::min(box.low, value);
            box.high = std::max(box.high, value);
        }
    }
    std::sort(box.beyond.begin(), box.beyond.end());
    return box;
}

Estimate ratioOfMedians(std::span<const double> a, std::span<const double> b, std::uint64_t seed,
                        int resamples) {
    const std::size_t n = std::min(a.size(), b.size());
    if (n == 0) return {kNone, kNone, kNone};
    std::vector<double> drawnA(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(n));
    std::vector<double> drawnB(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(n));
    const double ratio = median(drawnA) / median(drawnB);
    Random random(seed);
    std::vector<double> ratios;
    ratios.reserve(static_cast<std::size_t>(resamples));
    for (int k = 0; k < resamples; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t from = random.below(static_cast<std::uint32_t>(n));
            drawnA[i] = a[from];
            drawnB[i] = b[from];
        }
        ratios.push_back(median(drawnA) / median(drawnB));
    }
    return {ratio, quantile(ratios, 0.025), quantile(ratios, 0.975)};
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
    std::vector<double> adjusted(p.size());
    double least = 0.0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        least = std::max(least, std::min(1.0, static_cast<double>(order.size() - rank) * p[order[rank]]));
        adjusted[order[rank]] = least;
    }
    return adjusted;
}

}  // namespace muster::statistics
