#include "lab/study/statistics/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lab/study/statistics/numerics.h"

namespace muster::statistics {
namespace {

constexpr int kExactPairs = 50;

/// Share of all signs by the doubled sum of positive ranks.
std::vector<double> sumShares(const std::vector<double>& ranks) {
    std::vector<double> shares{1.0};
    for (const double rank : ranks) {
        const auto step = static_cast<std::size_t>(std::lround(2.0 * rank));
        std::vector<double> next(shares.size() + step, 0.0);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            next[i] += 0.5 * shares[i];
            next[i + step] += 0.5 * shares[i];
        }
        shares = std::move(next);
    }
    return shares;
}

double exactP(const std::vector<double>& ranks, double positive, double negative) {
    const std::vector<double> shares = sumShares(ranks);
    const auto least = static_cast<std::size_t>(std::lround(2.0 * std::min(positive, negative)));
    double tail = 0.0;
    for (std::size_t i = 0; i <= least && i < shares.size(); ++i) tail += shares[i];
    return std::min(1.0, 2.0 * tail);
}

double approximateP(const std::vector<double>& ranks, double positive) {
    double mean = 0.0, variance = 0.0;  // Squares of mean ranks hold the correction for ties.
    for (const double rank : ranks) {
        mean += 0.5 * rank;
        variance += 0.25 * rank * rank;
    }
    const double away = std::max(0.0, std::abs(positive - mean) - 0.5);
    return std::min(1.0, 2.0 * normalBelow(-away / std::sqrt(variance)));
}

/// Number of the smallest Walsh averages that lie below the interval.
std::size_t walshBelow(std::size_t n) {
    if (n > static_cast<std::size_t>(kExactPairs)) {
        const double count = static_cast<double>(n);
        const double mean = count * (count + 1.0) / 4.0;
        const double spread = std::sqrt(count * (count + 1.0) * (2.0 * count + 1.0) / 24.0);
        return static_cast<std::size_t>(
            std::max(0.0, std::floor(mean - normalQuantile(0.975) * spread - 0.5)));
    }
    std::vector<double> ranks(n);
    std::iota(ranks.begin(), ranks.end(), 1.0);
    const std::vector<double> shares = sumShares(ranks);
    double tail = 0.0;
    std::size_t sum = 0;
    while (2 * sum < shares.size() && tail + shares[2 * sum] <= 0.025) tail += shares[2 * sum++];
    return sum;  // Smaller sums have at most 2.5 % together.
}

}  // namespace

std::vector<double> meanRanks(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
    std::vector<double> ranks(values.size());
    for (std::size_t from = 0; from < order.size();) {
        std::size_t end = from;
        while (end < order.size() && values[order[end]] == values[order[from]]) ++end;
        for (std::size_t i = from; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(from + 1 + end);
        from = end;
    }
    return ranks;
}

SignedRank signedRank(std::span<const double> differences) {
    std::vector<double> sizes;
    std::vector<bool> up;
    for (const double difference : differences) {
        if (difference == 0.0 || std::isnan(difference)) continue;
        sizes.push_back(std::abs(difference));
        up.push_back(difference > 0.0);
    }
    SignedRank test{.pairs = static_cast<int>(sizes.size())};
    test.exact = test.pairs <= kExactPairs;
    if (sizes.empty()) return test;
    const std::vector<double> ranks = meanRanks(sizes);
    for (std::size_t i = 0; i < ranks.size(); ++i) (up[i] ? test.positive : test.negative) += ranks[i];
    test.rankBiserial = (test.positive - test.negative) / (test.positive + test.negative);
    test.p = test.exact ? exactP(ranks, test.positive, test.negative) : approximateP(ranks, test.positive);
    return test;
}

Estimate hodgesLehmann(std::span<const double> differences) {
    std::vector<double> walsh;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        for (std::size_t j = i; j < differences.size(); ++j) {
            const double mean = 0.5 * (differences[i] + differences[j]);
            // The mean of infinities of both signs counts as zero.
            walsh.push_back(std::isnan(mean) ? 0.0 : mean);
        }
    }
    if (walsh.empty()) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none};
    }
    std::sort(walsh.begin(), walsh.end());
    const std::size_t below = std::min(walshBelow(differences.size()), (walsh.size() - 1) / 2);
    const std::size_t skipped = below > 0 ? below - 1 : 0;
    const std::size_t n = walsh.size();
    const double low = walsh[(n - 1) / 2], high = walsh[n / 2];
    return {low == high ? low : 0.5 * (low + high), walsh[skipped], walsh[n - 1 - skipped]};
}

}  // namespace muster::statistics
