// Piecewise cubic curves through keys: splines and monotone easing curves.
#pragma once

#include <vector>

namespace muster::generator {

/// A value at a time.
struct Key {
    double time = 0.0;
    double value = 0.0;  ///< Value in the unit of the curve.
};

/// A piecewise cubic through keys in order of time; constant before the first key and after the last.
class Curve {
public:
    Curve() = default;
    /// The cubic spline with continuous second derivative and these slopes at its ends.
    static Curve spline(std::vector<Key> keys, double slopeBegin, double slopeEnd);
    /// The curve that never overshoots a key: its slope is zero at local extrema and at both ends.
    static Curve eased(std::vector<Key> keys);

    double at(double time) const;

private:
    std::vector<Key> keys_;
    std::vector<double> slopes_;
};

/// A position with its speed and acceleration at a time.
struct State {
    double time = 0.0;
    double place = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
};
/// Position between two states, by the quintic polynomial that matches both.
double between(const State& begin, const State& end, double time);

/// A smooth step from 0 at `begin` to 1 at `end`; first and second derivatives are zero at both.
double rise(double begin, double end, double time);
/// A smooth bump: 0 outside (begin, end), 1 in the middle, twice continuously differentiable as rise().
double hump(double begin, double end, double time);

/// Cosine of a phase given in cycles; 1 at whole cycles.
double cycleWave(double phase);

/// Converts degrees to radians.
constexpr double degrees(double angle) {
    return angle * (3.14159265358979323846 / 180.0);
}

}  // namespace muster::generator
