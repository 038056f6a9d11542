// Measured data and curves that results are compared with, and tests of distributions.
#pragma once

#include <span>
#include <vector>

#include "lab/verify/row.h"
#include "muster/people.h"

namespace muster {

/// Speed at a density [1/m^2] after Weidmann 1993: 1.34 (1 - exp(-1.913 (1 / density - 1 / 5.4))) m/s, 0 from
/// 5.4 on.
double weidmannSpeed(double density);
/// Weidmann's curve from `from` to `to`.
std::vector<Vec2> weidmannCurve(double from = 0.1, double to = 5.4);
/// Speed in single file at a density [1/m] after Seyfried et al. 2005: (1 / density - 0.36) / 1.06 m/s.
double seyfriedSpeed(double density);

/// Values at rising x, linear between.
struct Band {
    std::vector<Vec2> low, high;
    bool covers(Vec2 p) const;    ///< True where x lies in the range of the band.
    bool contains(Vec2 p) const;  ///< True where the point lies in the band.
};
/// RiMEA 4.1.1, test 16: 10 and 90 % of single-file speeds by persons per metre.
const Band& rimeaFileBand();
/// RiMEA 4.1.1, test 13: speeds on stairs by density, read off its figure 16.
const Band& rimeaStairBand(bool up);

/// Mean and deviation of speeds in one bin of density.
struct SpeedBin {
    double low, high, mean, deviation;
};
/// Measured speeds of Juelich by bins of density: unidirectional corridors of 1.8 and 3.0 m, both directions
/// in 3.6 m, a corner of 2.4 m, a T-junction of 2.4 m, and single file (10 to 90 % as mean and deviation).
std::span<const SpeedBin> trackBins();
std::span<const SpeedBin> openCorridorBins();
std::span<const SpeedBin> twoWayBins();
std::span<const SpeedBin> cornerBins();
std::span<const SpeedBin> junctionBins();
std::span<const SpeedBin> fileBins();

/// Flow through bottlenecks [1/s] by width [m]: mean of Kretz 2006, Seyfried 2009 and the data set EG of
/// 2006, as far as each has the width.
std::span<const Vec2> bottleneckFlows();

/// Share of bins with at least `least` points whose mean lies within `deviations` deviations of the bin.
struct BinsJudged {
    std::size_t used = 0, good = 0;
    std::vector<Vec2> means;  ///< Middle of each used bin and the mean there.
};
BinsJudged judgeBins(std::span<const Vec2> points, std::span<const SpeedBin> bins, double deviations,
                     std::size_t least = 5);
/// Series and band of bins for a plot.
void showBins(VerifyPlot& plot, std::span<const SpeedBin> bins, double deviations);

/// Probability that values at this distance from a distribution are drawn from it (Kolmogorov and Smirnov).
double kolmogorovSmirnov(std::vector<double> values, const Distribution& distribution);

}  // namespace muster
