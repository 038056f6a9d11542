// Smooth curves through keys.
#pragma once

#include <vector>

namespace muster::generator {

/// A value at a time.
struct Key {
    double time = 0.0;
    double value = 0.0;
};

/// A piecewise cubic through keys in order of time, held before the first and after the last.
class Curve {
public:
    Curve() = default;
    /// Twice continuously differentiable, with these slopes at its ends.
    static Curve spline(std::vector<Key> keys, double slopeBegin, double slopeEnd);
    /// Never overshoots a key: it rests at turning points and at both ends.
    static Curve eased(std::vector<Key> keys);

    double at(double time) const;

private:
    std::vector<Key> keys_;
    std::vector<double> slopes_;
};

/// A place, its speed and its acceleration at a time.
struct State {
    double time = 0.0;
    double place = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
};
/// At a time between two states, by the one polynomial of fifth degree that meets both.
double between(const State& begin, const State& end, double time);

/// 0 before `begin`, 1 after `end`, between them a rise whose first and second derivatives vanish at its
/// ends.
double rise(double begin, double end, double time);
/// 0 outside (begin, end), 1 in the middle, as smooth as rise().
double hump(double begin, double end, double time);

/// The cosine of a phase, which is a share of a cycle; 1 at whole cycles.
double cycleWave(double phase);

/// Degrees in radians.
constexpr double degrees(double angle) {
    return angle * (3.14159265358979323846 / 180.0);
}

}  // namespace muster::generator
