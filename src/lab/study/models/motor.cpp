#include "lab/study/models/motor.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kLeastWidth = 1.0;  // Least width that a target counts with [mm].

// Index of difficulty by Shannon's form [bit].
double difficulty(double distance, double width) {
    return logarithm(distance / std::max(width, kLeastWidth) + 1.0) / logarithm(2.0);
}

}  // namespace

Motor::Motor(const OperatorParameters& parameters, bool touch, double factor)
    : device_(touch ? parameters.touch : parameters.mouse), touch_(touch), factor_(factor) {}

double Motor::point(double distance, double width) const {
    return factor_ * (device_.pointBase + device_.pointSlope * difficulty(distance, width));
}

double Motor::drag(double distance, double width) const {
    return factor_ * (device_.dragBase + device_.dragSlope * difficulty(distance, width));
}

double Motor::draw(double length, double width) const {
    const double left = std::max(width - device_.lostWidth, kLeastWidth);
    const double steering = device_.steerBase + device_.steerSlope * length / left;
    return factor_ * std::max(steering, device_.steerBase + length / device_.drawSpeed);
}

double Motor::scatter(double width) const {
    const double share = device_.scatterShare * width;
    return std::sqrt(share * share + device_.scatterLeast * device_.scatterLeast);
}

}  // namespace muster
