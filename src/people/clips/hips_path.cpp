#include "people/clips/hips_path.h"

#include <algorithm>
#include <cmath>

#include "base/easing.h"

namespace muster {
namespace {

constexpr double kLeastTurn = 0.35;    // Angle below which a cycle that turns travels straight [rad].
constexpr double kLeastLength = 0.15;  // Length below which a path has no direction [m].
// Sine of half the rotation below which the chord does not determine the arc.
constexpr double kLeastLever = 0.3;
// Angle between facing and travel beyond which the motion goes sideways [rad].
constexpr double kMaxSidewaysAngle = 0.8;

Travel travelOf(double x, double y, double yaw) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(yaw)};
}

/// Moving average over `half` frames to both sides; the range shrinks to zero towards the ends.
void smooth(std::vector<double>& values, std::size_t half) {
    std::vector<double> sums(values.size() + 1, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t reach = std::min({half, i, values.size() - 1 - i});
        values[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
    }
}

/// Length of the arc over a chord [m]. After a full rotation the chord is useless, and the length of the
/// hips' path is used.
double arcOf(std::span<const HipsAt> hips, double chord, double turn) {
    const double lever = std::fabs(sine(0.5 * turn));
    if (std::fabs(turn) < kPi || (lever > kLeastLever && std::fabs(turn) < 2.0 * kPi))
        return 0.5 * chord * std::fabs(turn) / lever;
    double travelled = 0.0;
    for (std::size_t i = 1; i < hips.size(); ++i) {
        const double dx = hips[i].x - hips[i - 1].x, dy = hips[i].y - hips[i - 1].y;
        travelled += std::sqrt(dx * dx + dy * dy);
    }
    return travelled;
}

}  // namespace

void unwrap(std::vector<HipsAt>& hips) {
    for (std::size_t i = 1; i < hips.size(); ++i)
        hips[i].facing = hips[i - 1].facing + wrappedAngle(hips[i].facing - hips[i - 1].facing);
}

std::vector<Travel> evenTravel(std::span<const HipsAt> hips) {
    const HipsAt &a = hips.front(), &b = hips.back();
    const double dx = b.x - a.x, dy = b.y - a.y, chord = std::sqrt(dx * dx + dy * dy);
    double turn = b.facing - a.facing, mean = 0.0;
    if (std::fabs(turn) < kLeastTurn) turn = 0.0;
    for (const HipsAt& at : hips) mean += at.facing / static_cast<double>(hips.size());
    const double along = chord > kLeastLength ? arcTangent2(dy, dx) : mean;
    // The middle of the arc faces along the chord, unless the motion goes sideways.
    const double middle = std::fabs(wrappedAngle(along - mean)) < kMaxSidewaysAngle
                              ? mean + wrappedAngle(along - mean)
                              : mean;
    const double begin = middle - 0.5 * turn,
                 sideways = chord > kLeastLength ? wrappedAngle(along - middle) : 0.0;
    const double arc = turn == 0.0 ? chord : arcOf(hips, chord, turn);
    std::vector<Travel> travel;
    double shiftX = 0.0, shiftY = 0.0;
    for (std::size_t i = 0; i < hips.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(hips.size() - 1),
                     turned = share * turn;
        double x = share * arc, y = 0.0;
        if (turn != 0.0) x = arc / turn * sine(turned), y = arc / turn * (1.0 - cosine(turned));
        const double c = cosine(begin + sideways), s = sine(begin + sideways);
        travel.push_back(travelOf(a.x + c * x - s * y, a.y + s * x + c * y, begin + turned));
        shiftX += (hips[i].x - static_cast<double>(travel.back().x)) / static_cast<double>(hips.size());
        shiftY += (hips[i].y - static_cast<double>(travel.back().y)) / static_cast<double>(hips.size());
    }
    if (turn != 0.0) return travel;
    // The travelling frame moves below the mean of the hips' sway.
    for (Travel& at : travel) at = travelOf(at.x + shiftX, at.y + shiftY, at.yaw);
    return travel;
}

std::vector<Travel> smoothTravel(std::span<const HipsAt> hips, double rate, double window) {
    std::vector<double> x, y, facing;
    for (const HipsAt& at : hips) {
        x.push_back(at.x);
        y.push_back(at.y);
        facing.push_back(at.facing);
    }
    const auto half = static_cast<std::size_t>(std::max(1.0, 0.5 * window * rate));
    for (std::vector<double>* values : {&x, &y, &facing}) {
        smooth(*values, half);
        smooth(*values, half);
    }
    std::vector<Travel> travel;
    for (std::size_t i = 0; i < hips.size(); ++i) travel.push_back(travelOf(x[i], y[i], facing[i]));
    return travel;
}

void fromStart(std::vector<Travel>& travel) {
    if (travel.empty() ||
        (travel.front().x == 0.0f && travel.front().y == 0.0f && travel.front().yaw == 0.0f))
        return;
    const Travel first = travel.front();
    const double c = cosine(first.yaw), s = sine(first.yaw);
    for (Travel& at : travel) {
        const double x = static_cast<double>(at.x) - first.x, y = static_cast<double>(at.y) - first.y;
        at = travelOf(c * x + s * y, -s * x + c * y, static_cast<double>(at.yaw) - first.yaw);
    }
}

}  // namespace muster
