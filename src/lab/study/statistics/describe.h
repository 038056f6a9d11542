// Medians, quantiles and their ratios, and scores of published questionnaires.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster::statistics {

/// A value with an interval.
struct Estimate {
    double value = 0.0;  ///< Best value; NaN where there is none.
    double low = 0.0;    ///< Lower end of the interval.
    double high = 0.0;   ///< Upper end of the interval.
};

/// The p-quantile by linear interpolation at (n - 1) p (type 7 of Hyndman & Fan 1996, R's default); NaN for
/// no values.
double quantile(std::vector<double> values, double p);
/// The quantile of one half.
double median(const std::vector<double>& values);

/// The numbers of a box plot (Tukey 1977): whiskers end at the outermost values within 1.5 interquartile
/// ranges of the box.
struct BoxSummary {
    double low = 0.0, lower = 0.0, middle = 0.0, upper = 0.0,
           high = 0.0;           ///< Whisker, box, median, box, whisker.
    std::vector<double> beyond;  ///< Values beyond the whiskers.
};
/// The box plot of at least one value.
BoxSummary boxSummary(const std::vector<double>& values);

/// Ratio of the medians of a and b with the 95 % percentile interval of that many resamples of the pairs
/// (Efron & Tibshirani 1993, chapter 13). The same seed gives the same interval. NaN for no pairs.
Estimate ratioOfMedians(std::span<const double> a, std::span<const double> b, std::uint64_t seed = 1,
                        int resamples = 4000);

/// Adjusted p-values of several tests (Holm 1979), in the order given.
std::vector<double> holm(std::span<const double> p);

/// System Usability Scale (Brooke 1996): ten answers from 1 to 5, in its order; 0 to 100. NaN for others.
double susScore(std::span<const double> answers);
/// Raw NASA-TLX (Hart 2006): mean of six scales from 0 to 100. NaN for others.
double rawTlx(std::span<const double> answers);

/// Short User Experience Questionnaire (Schrepp, Hinderks & Thomaschewski 2017), from -3 to 3.
struct UeqShort {
    double pragmatic = 0.0;  ///< Mean of items 1 to 4.
    double hedonic = 0.0;    ///< Mean of items 5 to 8.
};
/// Eight answers from 1 to 7, in its order, coded as -3 to 3. NaN for others.
UeqShort ueqShort(std::span<const double> answers);

}  // namespace muster::statistics
