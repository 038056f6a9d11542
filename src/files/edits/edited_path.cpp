#include "files/edits/edited_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {

double pinWeight(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return 1.0 - s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

double pinWeightSlope(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return -30.0 * s * s * (1.0 - s) * (1.0 - s);
}

OwnClock::OwnClock(std::vector<ClockPoint> points) : points_(std::move(points)) {
    const std::size_t count = points_.size();
    if (count == 0) return;
    std::vector<double> rates;  // Of the pieces.
    for (std::size_t k = 0; k + 1 < count; ++k)
        rates.push_back((points_[k + 1].own - points_[k].own) / (points_[k + 1].time - points_[k].time));
    slopes_.push_back(std::min(1.0, 3.0 * rates.front()));
    for (std::size_t k = 1; k + 1 < count; ++k) {
        // The harmonic mean of both pieces is monotone.
        const double before = rates[k - 1], after = rates[k];
        const double sum = before + after;
        slopes_.push_back(sum > 0.0 ? 2.0 * before * after / sum : 0.0);
    }
    slopes_.push_back(std::min(1.0, 3.0 * rates.back()));
}

OwnTime OwnClock::at(double time) const {
    if (points_.empty()) return {time, 1.0};
    const ClockPoint &first = points_.front(), &last = points_.back();
    if (time <= first.time) return {time + (first.own - first.time), 1.0};
    if (time >= last.time) return {time + (last.own - last.time), 1.0};
    const auto next = std::upper_bound(points_.begin(), points_.end(), time,
                                       [](double t, const ClockPoint& point) { return t < point.time; });
    const auto k = static_cast<std::size_t>(next - points_.begin()) - 1;
    const ClockPoint &a = points_[k], &b = points_[k + 1];
    const double span = b.time - a.time, s = (time - a.time) / span, rise = b.own - a.own;
    const double m0 = slopes_[k] * span, m1 = slopes_[k + 1] * span;
    const double c2 = 3.0 * rise - 2.0 * m0 - m1, c3 = m0 + m1 - 2.0 * rise;
    return {a.own + s * (m0 + s * (c2 + s * c3)), std::max(0.0, (m0 + s * (2.0 * c2 + 3.0 * s * c3)) / span)};
}

double OwnClock::when(double own) const {
    if (points_.empty()) return own;
    const ClockPoint &first = points_.front(), &last = points_.back();
    if (own <= first.own) return own - (first.own - first.time);
    if (own > last.own) return own - (last.own - last.time);
    double low = first.time, high = last.time;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (at(middle).time < own ? low : high) = middle;
    }
    return high;
}

PinMove pinMove(std::span<const PathPin> pins, double own) {
    PinMove move;
    for (std::size_t k = 0; k < pins.size(); ++k) {
        const PathPin& pin = pins[k];
        const double after = own - pin.time;
        double reach = pin.seconds;
        if (after < 0.0 && k > 0) reach = std::min(reach, pin.time - pins[k - 1].time);
        if (after > 0.0 && k + 1 < pins.size()) reach = std::min(reach, pins[k + 1].time - pin.time);
        const double share = std::fabs(after) / reach;
        if (share >= 1.0) continue;
        move.offset += pin.offset * pinWeight(share);
        move.velocity += pin.offset * (pinWeightSlope(share) * (after < 0.0 ? -1.0 : 1.0) / reach);
    }
    return move;
}

}  // namespace muster
