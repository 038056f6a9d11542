// The gaits of Muster's own clips as a table, fitted to measurements of people
// (docs/method/motion-generator.md).
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"

namespace muster::generator {
namespace {

constexpr double kUsual = std::numeric_limits<double>::quiet_NaN();  // As in any gait.

/// A parameter of all gaits, in the order of GaitKind.
struct GaitRow {
    double Gait::*field;
    double values[kGaitKinds];
};

/// Middle and swing [degrees] of a wave in all gaits, and how late it is.
struct WaveRow {
    Wave Gait::*field;
    double values[kGaitKinds][3];
};

// walk, jog, run, sprint, duck, marching walk and jog, weary walk and jog
constexpr double kCycleFrames[kGaitKinds]{64, 45, 45, 39, 54, 62, 45, 70, 45};

constexpr GaitRow kMeasures[]{
    {&Gait::speed, {1.25, 1.95, 2.6, 3.8, 1.04, 1.25, 1.95, 1.1, 1.95}},
    {&Gait::contact, {0.60, 0.34, 0.31, 0.27, 0.58, 0.60, 0.34, 0.63, 0.34}},
    {&Gait::footForward, {-0.098, -0.14, -0.15, -0.165, -0.07, -0.098, -0.14, -0.098, -0.14}},
    {&Gait::footOut, {0.055, 0.04, 0.04, 0.03, 0.085, 0.045, 0.04, 0.07, 0.055}},
    {&Gait::flat, {0.09, 0.05, 0.05, 0.05, 0.08, 0.09, 0.05, 0.09, 0.05}},
    {&Gait::heelRise, {0.22, 0.22, 0.22, 0.22, 0.24, 0.22, 0.22, 0.22, 0.22}},
    {&Gait::height, {0.911, 0.915, 0.912, 0.893, 0.70, 0.911, 0.915, 0.895, 0.915}},
    {&Gait::lift, {0, 0.03, 0.026, 0.03, 0, 0, 0.03, 0, 0.03}},
    {&Gait::bob, {0.028, 0.025, 0.025, 0.025, 0.016, 0.028, 0.025, 0.02, 0.025}},
    {&Gait::surge, {0.008, 0.008, 0.008, 0.008, 0.006, 0.008, 0.008, 0.008, 0.008}},
    {&Gait::sway, {0.022, 0.012, 0.012, 0.012, 0.022, 0.012, 0.008, 0.034, 0.02}},
    {&Gait::forward, {0, 0, 0, 0, -0.10, 0, 0, 0, 0}},
};

// In degrees.
constexpr GaitRow kAngles[]{
    {&Gait::toeOut, {7, 6, 6, 6, 10, 4, 6, 12, 10}},
    {&Gait::strike, {20, 8, 8, 3, 10, 20, 8, 12, 8}},
    {&Gait::push, {58, 48, 54, 66, 50, 58, 48, 46, 48}},
    {&Gait::pelvisPitch, {4, 6, 8, 11, 38, 2, 4, 9, 9}},
    {&Gait::pelvisYaw, {5, 6, 8, 10, 7, 5, 4, 5, 6}},
    {&Gait::pelvisRoll, {4, 4, 4, 4, 4, 2, 4, 5, 4}},
    {&Gait::lean, {2, 6, 9, 13, 62, -3, 1, 19, 17}},
    {&Gait::nod, {1, 2, 2, 2, 1.5, 0, 1, 2, 3}},
    {&Gait::chestYaw, {6, 10, 13, 15, 7, 4, 4, 4, 8}},
    {&Gait::chestRoll, {1.5, 2, 2, 2, kUsual, 0, 1, 3, 4}},
    {&Gait::headPitch, {2, 3, 3, 3, 18, -2, 0, 20, 14}},
    {&Gait::armOut, {9, 12, 12, 12, 16, 6, 8, 7, 12}},
    {&Gait::armTurn, {18, 14, 14, 14, 25, 10, 14, 26, 14}},
    {&Gait::armAcross, {8, 10, 10, 10, 0, 0, 0, 8, 10}},
    {&Gait::wrist, {8, kUsual, kUsual, kUsual, kUsual, 2, kUsual, 8, kUsual}},
};

constexpr WaveRow kWaves[]{
    {&Gait::arm,
     {{-5, 20, 0.03},
      {-8, 28, 0.02},
      {-8, 38, 0.02},
      {-4, 50, 0.02},
      {42, 20, 0.03},
      {2, 36, 0.02},
      {-14, 24, 0.02},
      {10, 9, 0.05},
      {4, 16, 0.04}}},
    {&Gait::elbow,
     {{36, 22, 0.06},
      {97, 10, 0.1},
      {98, 17, 0.1},
      {96, 18, 0.1},
      {70, 12, 0.08},
      {9, 5, 0.04},
      {92, 4, 0.1},
      {20, 6, 0.08},
      {68, 10, 0.1}}},
};

using SwingKeys = std::vector<std::array<double, 2>>;  // Shares, and angles [degrees].

Swing swingOf(const SwingKeys& thigh, const SwingKeys& knee, const SwingKeys& ankle) {
    const auto keys = [](const SwingKeys& pairs) {
        std::vector<Key> made;
        for (const auto& [share, angle] : pairs) made.push_back(swingKey(share, angle));
        return made;
    };
    return {keys(thigh), keys(knee), keys(ankle)};
}

Swing swingOf(GaitKind kind) {
    switch (kind) {
        case GaitKind::Walk:
        case GaitKind::WearyWalk:
            return swingOf({{0.25, 11}, {0.5, 28}, {0.75, 31}}, {{0.28, 71}, {0.5, 64}, {0.75, 30}},
                           {{0.13, -15}, {0.30, 2}, {0.6, 11}});
        case GaitKind::MarchingWalk:
            return swingOf({{0.25, 16}, {0.5, 43}, {0.75, 38}}, {{0.28, 76}, {0.5, 82}, {0.75, 38}},
                           {{0.13, -15}, {0.30, 2}, {0.6, 11}});
        case GaitKind::Run:
            return swingOf({{0.10, -15}, {0.275, 1}, {0.42, 24}, {0.565, 39}, {0.71, 36}},
                           {{0.09, 40}, {0.275, 82}, {0.42, 107}, {0.52, 105}, {0.71, 60}, {0.86, 32}},
                           {{0.06, -13}, {0.15, -6}, {0.275, 6}, {0.5, 13}, {0.75, 20}});
        case GaitKind::Sprint:
            return swingOf({{0.08, -20}, {0.275, 6}, {0.42, 36}, {0.565, 56}, {0.71, 50}},
                           {{0.275, 90}, {0.42, 120}, {0.52, 117}, {0.71, 72}, {0.86, 36}},
                           {{0.06, -13}, {0.15, -6}, {0.275, 6}, {0.5, 13}, {0.75, 18}});
        case GaitKind::Duck:
            return swingOf({{0.5, 62}}, {{0.38, 106}, {0.7, 92}}, {{0.35, 8}, {0.7, 12}});
        default:
            return swingOf({{0.08, -10}, {0.26, 1}, {0.42, 21}, {0.56, 35}, {0.72, 32}},
                           {{0.26, 74}, {0.42, 98}, {0.52, 97}, {0.71, 56}, {0.86, 32}},
                           {{0.07, -12}, {0.16, -5}, {0.275, 6}, {0.5, 12}, {0.75, 17}});
    }
}

}  // namespace

Gait gaitOf(GaitKind kind) {
    const auto column = static_cast<std::size_t>(kind);
    Gait gait;
    gait.cycle = kCycleFrames[column] / kFrameRate;
    gait.swing = swingOf(kind);
    for (const GaitRow& row : kMeasures) gait.*row.field = row.values[column];
    for (const GaitRow& row : kAngles)
        if (!std::isnan(row.values[column])) gait.*row.field = degrees(row.values[column]);
    for (const WaveRow& row : kWaves) {
        const auto& [middle, swing, late] = row.values[column];
        gait.*row.field = {degrees(middle), degrees(swing), late};
    }
    return gait;
}

}  // namespace muster::generator
