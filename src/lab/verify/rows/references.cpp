#include "lab/verify/rows/references.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace muster {
namespace {

double valueAt(const std::vector<Vec2>& curve, double x) {
    const auto after = std::lower_bound(curve.begin(), curve.end(), x,
                                        [](Vec2 p, double v) { return p.x < v; });
    if (after == curve.begin()) return curve.front().y;
    if (after == curve.end()) return curve.back().y;
    const Vec2 a = *(after - 1), b = *after;
    return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

// The bins of table 5.3 of the notes: persons per square metre, m/s.
constexpr std::array kTrackBins{
    SpeedBin{0.0, 0.5, 1.11, 0.08}, SpeedBin{0.5, 1.0, 0.94, 0.12}, SpeedBin{1.0, 1.5, 0.70, 0.12},
    SpeedBin{1.5, 2.0, 0.56, 0.08}, SpeedBin{2.0, 2.5, 0.42, 0.11}, SpeedBin{2.5, 3.0, 0.35, 0.06},
    SpeedBin{3.0, 3.5, 0.23, 0.04}, SpeedBin{3.5, 4.0, 0.17, 0.05}, SpeedBin{4.0, 4.5, 0.06, 0.04}};
constexpr std::array kOpenBins{SpeedBin{0.0, 0.5, 1.49, 0.15}, SpeedBin{0.5, 1.0, 1.42, 0.12},
                               SpeedBin{1.0, 1.5, 1.20, 0.07}, SpeedBin{1.5, 2.0, 1.04, 0.12},
                               SpeedBin{2.0, 2.5, 0.53, 0.15}, SpeedBin{2.5, 3.0, 0.39, 0.09},
                               SpeedBin{3.0, 3.5, 0.22, 0.06}, SpeedBin{3.5, 4.0, 0.16, 0.02}};
constexpr std::array kTwoWayBins{SpeedBin{0.0, 0.5, 1.50, 0.10}, SpeedBin{0.5, 1.0, 1.32, 0.14},
                                 SpeedBin{1.0, 1.5, 1.05, 0.15}, SpeedBin{1.5, 2.0, 0.78, 0.10},
                                 SpeedBin{2.0, 2.5, 0.58, 0.08}, SpeedBin{2.5, 3.0, 0.46, 0.05},
                                 SpeedBin{3.0, 3.5, 0.40, 0.03}};
constexpr std::array kCornerBins{SpeedBin{0.0, 0.5, 1.45, 0.14}, SpeedBin{0.5, 1.0, 1.27, 0.12},
                                 SpeedBin{1.0, 1.5, 1.03, 0.12}, SpeedBin{1.5, 2.0, 0.87, 0.10},
                                 SpeedBin{2.0, 2.5, 0.73, 0.06}};
constexpr std::array kJunctionBins{SpeedBin{0.0, 0.5, 1.24, 0.11}, SpeedBin{0.5, 1.0, 1.07, 0.18},
                                   SpeedBin{1.0, 1.5, 0.86, 0.21}, SpeedBin{1.5, 2.0, 0.76, 0.16},
                                   SpeedBin{2.0, 2.5, 0.55, 0.19}, SpeedBin{2.5, 3.0, 0.40, 0.13},
                                   SpeedBin{3.0, 3.5, 0.34, 0.08}};
// 10 and 90 % of single-file speeds, as their middle and half of their distance; persons per metre.
constexpr SpeedBin between(double low, double high, double ten, double ninety) {
    return {low, high, 0.5 * (ten + ninety), 0.5 * (ninety - ten)};
}
constexpr std::array kFileBins{
    between(0.2, 0.4, 0.90, 1.27), between(0.4, 0.6, 0.81, 1.20), between(0.6, 0.8, 0.77, 1.06),
    between(0.8, 1.0, 0.63, 0.96), between(1.0, 1.2, 0.45, 0.87), between(1.2, 1.4, 0.29, 0.52),
    between(1.4, 1.6, 0.18, 0.40), between(1.6, 1.8, 0.17, 0.27), between(1.8, 2.0, 0.09, 0.21),
    between(2.0, 2.2, 0.05, 0.14), between(2.2, 2.4, 0.00, 0.12), between(2.4, 2.6, 0.01, 0.10)};
// Means of the data sets that have the width, after their own means: Kretz, Seyfried, EG.
constexpr std::array kBottleneckFlows{Vec2{0.8, (1.423 + 1.29) / 2},
                                      Vec2{0.9, (1.58 + 1.67 + 1.59) / 3},
                                      Vec2{1.0, (1.855 + 1.90 + 1.83) / 3},
                                      Vec2{1.2, (2.143 + 2.36 + 2.31) / 3},
                                      Vec2{1.4, 2.71},
                                      Vec2{1.6, 2.84},
                                      Vec2{1.8, 3.55},
                                      Vec2{2.0, 3.55},
                                      Vec2{2.5, 5.12}};

}  // namespace

double weidmannSpeed(double density) {
    return density >= 5.4 ? 0.0 : 1.34 * (1.0 - std::exp(-1.913 * (1.0 / density - 1.0 / 5.4)));
}

std::vector<Vec2> weidmannCurve(double from, double to) {
    std::vector<Vec2> curve;
    for (int i = 0; i <= 60; ++i) {
        const double density = from + (to - from) * i / 60.0;
        curve.push_back({density, weidmannSpeed(density)});
    }
    return curve;
}

double seyfriedSpeed(double density) {
    return (1.0 / density - 0.36) / 1.06;
}

bool Band::covers(Vec2 p) const {
    return p.x >= low.front().x && p.x <= low.back().x;
}

bool Band::contains(Vec2 p) const {
    return p.y >= valueAt(low, p.x) && p.y <= valueAt(high, p.x);
}

const Band& rimeaFileBand() {
    static const Band band{{{0.10, 0.961},
                            {0.30, 0.840},
                            {0.50, 0.708},
                            {0.70, 0.598},
                            {0.90, 0.448},
                            {1.10, 0.316},
                            {1.30, 0.187},
                            {1.50, 0.112},
                            {1.70, 0.071},
                            {1.90, 0.048},
                            {2.10, 0.035},
                            {2.50, 0.022},
                            {3.10, 0.016},
                            {4.10, 0.011},
                            {5.10, 0.009},
                            {6.10, 0.009}},
                           {{0.10, 1.483},
                            {0.30, 1.473},
                            {0.50, 1.389},
                            {0.70, 1.305},
                            {0.90, 1.101},
                            {1.10, 0.840},
                            {1.30, 0.608},
                            {1.50, 0.485},
                            {1.70, 0.382},
                            {1.90, 0.314},
                            {2.10, 0.270},
                            {2.50, 0.220},
                            {3.10, 0.186},
                            {4.10, 0.172},
                            {5.10, 0.176},
                            {6.10, 0.184}}};
    return band;
}

const Band& rimeaStairBand(bool up) {
    static const Band down{{{0.6, 0.66}, {0.8, 0.60}, {1.0, 0.55}, {1.2, 0.50}, {1.4, 0.48}, {1.5, 0.48}},
                           {{0.6, 1.12}, {0.8, 1.00}, {1.0, 0.89}, {1.2, 0.81}, {1.4, 0.76}, {1.5, 0.73}}};
    static const Band upwards{{{0.6, 0.48}, {0.8, 0.46}, {1.0, 0.46}, {1.2, 0.46}, {1.4, 0.46}, {1.5, 0.46}},
                              {{0.6, 1.02}, {0.8, 0.93}, {1.0, 0.86}, {1.2, 0.80}, {1.4, 0.76}, {1.5, 0.74}}};
    return up ? upwards : down;
}

std::span<const SpeedBin> trackBins() {
    return kTrackBins;
}
std::span<const SpeedBin> openCorridorBins() {
    return kOpenBins;
}
std::span<const SpeedBin> twoWayBins() {
    return kTwoWayBins;
}
std::span<const SpeedBin> cornerBins() {
    return kCornerBins;
}
std::span<const SpeedBin> junctionBins() {
    return kJunctionBins;
}
std::span<const SpeedBin> fileBins() {
    return kFileBins;
}
std::span<const Vec2> bottleneckFlows() {
    return kBottleneckFlows;
}

BinsJudged judgeBins(std::span<const Vec2> points, std::span<const SpeedBin> bins, double deviations,
                     std::size_t least) {
    BinsJudged judged;
    for (const SpeedBin& bin : bins) {
        double sum = 0.0;
        std::size_t count = 0;
        for (const Vec2 p : points) {
            if (p.x < bin.low || p.x >= bin.high) continue;
            sum += p.y;
            ++count;
        }
        if (count < least) continue;
        const double mean = sum / static_cast<double>(count);
        ++judged.used;
        if (std::abs(mean - bin.mean) <= deviations * bin.deviation) ++judged.good;
        judged.means.push_back({0.5 * (bin.low + bin.high), mean});
    }
    return judged;
}

void showBins(VerifyPlot& plot, std::span<const SpeedBin> bins, double deviations) {
    for (const SpeedBin& bin : bins) {
        const double middle = 0.5 * (bin.low + bin.high);
        plot.bandLow.push_back({middle, std::max(0.0, bin.mean - deviations * bin.deviation)});
        plot.bandHigh.push_back({middle, bin.mean + deviations * bin.deviation});
    }
}

double kolmogorovSmirnov(std::vector<double> values, const Distribution& distribution) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const double n = static_cast<double>(values.size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // The share below the value, from its inverse.
        double low = 1e-9, high = 1.0 - 1e-9;
        for (int k = 0; k < 50; ++k)
            (distribution.quantile(0.5 * (low + high)) < values[i] ? low : high) = 0.5 * (low + high);
        farthest = std::max({farthest, std::abs(static_cast<double>(i + 1) / n - low),
                             std::abs(low - static_cast<double>(i) / n)});
    }
    const double root = std::sqrt(n), lambda = (root + 0.12 + 0.11 / root) * farthest;
    double sum = 0.0;
    for (int k = 1; k <= 100; ++k)
        sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * lambda * lambda);
    return std::clamp(lambda < 0.2 ? 1.0 : sum, 0.0, 1.0);
}

}  // namespace muster
