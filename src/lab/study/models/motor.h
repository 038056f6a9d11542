// Time and scatter of the movements of a hand: Fitts's law, the steering law.
#pragma once

#include "lab/study/models/chance.h"
#include "lab/study/models/operator_parameters.h"

namespace muster {

/// The hand of one model with one device. Lengths are on the display [mm], times in [s].
class Motor {
public:
    /// `touch`: fingers, else a mouse. `factor`: the model's own factor of all times.
    Motor(const OperatorParameters& parameters, bool touch, double factor);

    /// Expected time to point at a target, or to tap it; pressing and releasing not counted.
    double point(double distance, double width) const;
    /// Expected time to drag to a target.
    double drag(double distance, double width) const;
    /// Expected time to draw a path of that length which may be strayed from by half of `width` to each side.
    double draw(double length, double width) const;
    /// Time for pressing, and as long again for releasing.
    double press() const { return factor_ * device_.press; }
    /// Standard deviation of an end point in a target of that width [mm].
    double scatter(double width) const;

    const DeviceParameters& device() const { return device_; }  ///< Constants of the device.
    bool isTouch() const { return touch_; }                     ///< True for fingers, false for a mouse.
    double factor() const { return factor_; }                   ///< The model's own factor.

private:
    DeviceParameters device_;
    bool touch_ = false;
    double factor_ = 1.0;
};

}  // namespace muster
