// Tests by ranks.
#pragma once

#include <span>
#include <vector>

#include "lab/study/statistics/describe.h"

namespace muster::statistics {

/// Wilcoxon's signed-rank test of paired differences.
struct SignedRank {
    int pairs = 0;              ///< Number of differences that are not zero.
    double positive = 0.0;      ///< Sum of the ranks of positive differences.
    double negative = 0.0;      ///< Sum of the ranks of negative differences.
    double p = 1.0;             ///< Two-sided p.
    bool exact = false;         ///< Whether p is by the exact distribution, not by the normal approximation.
    double rankBiserial = 0.0;  ///< Matched-pairs r = (positive - negative) / total (Kerby 2014), -1 to 1.
};

/// Zeros are left out (Wilcoxon 1945), ties get mean ranks. Exact given the ranks up to 50 pairs, with ties
/// too: the sum of ranks over all 2^n signs, by convolution of doubled ranks. Beyond, the normal
/// approximation with correction for ties and continuity (Hollander, Wolfe & Chicken 2014, section 3.1).
SignedRank signedRank(std::span<const double> differences);

/// The median of all means of two differences (Hodges & Lehmann 1963), with the interval of Walsh averages
/// that covers it with at least 95 % by the exact distribution up to 50 differences (Bauer 1972), beyond by
/// the normal approximation. NaN for none; the range of all where there are too few for an interval. Infinite
/// differences are allowed, as those of censored trials.
Estimate hodgesLehmann(std::span<const double> differences);

/// Mean ranks from 1; ties share theirs.
std::vector<double> meanRanks(std::span<const double> values);

}  // namespace muster::statistics
