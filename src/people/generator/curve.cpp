#include "people/generator/curve.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster::generator {
namespace {

/// Slope of the straight line from key i to key i + 1.
double chord(const std::vector<Key>& keys, std::size_t i) {
    return (keys[i + 1].value - keys[i].value) / (keys[i + 1].time - keys[i].time);
}

}  // namespace

Curve Curve::spline(std::vector<Key> keys, double slopeBegin, double slopeEnd) {
    Curve curve;
    const std::size_t n = keys.size();
    curve.slopes_.assign(n, 0.0);
    curve.slopes_.front() = slopeBegin;
    curve.slopes_.back() = slopeEnd;
    // Second derivatives are continuous at inner keys. The Thomas algorithm solves the tridiagonal system.
    std::vector<double> factor(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = keys[i].time - keys[i - 1].time, after = keys[i + 1].time - keys[i].time;
        const double right = 3.0 * (after * chord(keys, i - 1) + before * chord(keys, i));
        const double pivot = 2.0 * (before + after) - after * factor[i - 1];
        factor[i] = before / pivot;
        curve.slopes_[i] = (right - after * curve.slopes_[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) curve.slopes_[i] -= factor[i] * curve.slopes_[i + 1];
    curve.keys_ = std::move(keys);
    return curve;
}

Curve Curve::eased(std::vector<Key> keys) {
    Curve curve;
    curve.slopes_.assign(keys.size(), 0.0);
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
        const double before = chord(keys, i - 1), after = chord(keys, i);
        if (before * after > 0.0) curve.slopes_[i] = 2.0 * before * after / (before + after);
    }
    curve.keys_ = std::move(keys);
    return curve;
}

double Curve::at(double time) const {
    if (keys_.empty()) return 0.0;
    if (time <= keys_.front().time) return keys_.front().value;
    if (time >= keys_.back().time) return keys_.back().value;
    const auto next = std::upper_bound(keys_.begin(), keys_.end(), time,
                                       [](double t, const Key& k) { return t < k.time; });
    const auto i = static_cast<std::size_t>(next - keys_.begin()) - 1;
    const double h = keys_[i + 1].time - keys_[i].time, u = (time - keys_[i].time) / h, v = 1.0 - u;
    return keys_[i].value * v * v * (1.0 + 2.0 * u) + slopes_[i] * h * u * v * v +
           keys_[i + 1].value * u * u * (1.0 + 2.0 * v) - slopes_[i + 1] * h * u * u * v;
}

double between(const State& begin, const State& end, double time) {
    const double h = end.time - begin.time, u = (time - begin.time) / h;
    const double bend = begin.acceleration * h * h;
    const double p = end.place - begin.place - begin.speed * h - 0.5 * bend;
    const double v = (end.speed - begin.speed) * h - bend, a = end.acceleration * h * h - bend;
    const double c3 = 10.0 * p - 4.0 * v + 0.5 * a, c4 = -15.0 * p + 7.0 * v - a,
                 c5 = 6.0 * p - 3.0 * v + 0.5 * a;
    return begin.place + u * (begin.speed * h + u * (0.5 * bend + u * (c3 + u * (c4 + u * c5))));
}

double rise(double begin, double end, double time) {
    const double u = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
    return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

double hump(double begin, double end, double time) {
    const double middle = 0.5 * (begin + end);
    return time < middle ? rise(begin, middle, time) : 1.0 - rise(middle, end, time);
}

double cycleWave(double phase) {
    return cosine(2.0 * kPi * (phase - std::floor(phase)));
}

}  // namespace muster::generator
