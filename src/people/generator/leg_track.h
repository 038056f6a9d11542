// The motion of a leg: steps, in which the foot is fixed to the ground, and swings between them.
#pragma once

#include <optional>
#include <vector>

#include "people/generator/course.h"
#include "people/generator/curve.h"

namespace muster::generator {

/// The swing of a leg between two steps: angles [rad] by the share of the swing, 0 to 1.
struct Swing {
    std::vector<Key> thigh;  ///< Angle of the thigh forward of the vertical.
    std::vector<Key> knee;   ///< Flexion of the knee.
    std::vector<Key> ankle;  ///< Angle of the foot raised relative to the shin.
};

/// A key of a swing by its share, 0 to 1, and angle [degrees].
inline Key swingKey(double share, double angle) {
    return {share, degrees(angle)};
}

/// A foot's contact with the ground. It lands on the heel if `strike` > 0, then lies flat, and leaves over
/// the ball.
struct Step {
    double begin = 0.0;   ///< Begin of the step [s].
    double end = 0.0;     ///< End of the step [s].
    Vec3 anchor;          ///< Ankle of the flat foot, in the ground frame [m].
    double yaw = 0.0;     ///< Yaw of the foot in the ground frame [rad].
    double strike = 0.0;  ///< Angle of the raised toes at landing [rad].
    double flat = 0.0;    ///< Duration from landing until flat [s].
    double rise = 0.0;    ///< Duration from heel-off to toe-off [s].
    double push = 0.0;    ///< Angle of the raised heel at the end [rad].
    Swing swing;          ///< The swing that follows the step.
};

/// The angles of a leg that a swing interpolates, in the travelling frame.
struct LegShape {
    double thigh = 0.0;  ///< Angle forward of the vertical [rad].
    double knee = 0.0;   ///< Flexion [rad].
    double ankle = 0.0;  ///< Angle of the foot raised relative to the shin [rad].
    double side = 0.0;   ///< Distance of the ankle to the left of the hip [m].
    double yaw = 0.0;    ///< Yaw of the foot [rad].
    double toe = 0.0;    ///< Flexion of the toes, downwards [rad].
};

/// A leg's shape and its rate of change at the time where a clip joins another in mid-swing.
struct LegJoin {
    double time = 0.0;
    LegShape shape;      ///< Shape at that time.
    LegShape rate;       ///< Rate of change of the shape [per second].
    double clear = 0.0;  ///< Share of the lift that clears the ground, 0 to 1.
};

/// The ankle of a foot rolled by `pitch` [rad] while its sole stays on the ground: it rolls on the heel if
/// the toes are up, else on the ball.
Vec3 rolledAnkle(Vec3 anchor, double yaw, double pitch);
/// A leg whose flat or rolled foot is on the ground, with flat toes.
Leg standingLeg(Vec3 anchor, double yaw, double pitch);

/// One leg's motion over time.
class LegTrack {
public:
    /// `steps` are in order of time. The foot stands before the first step and after the last. A join
    /// replaces all steps before or after its time.
    LegTrack(std::size_t side, std::vector<Step> steps, Course course, std::optional<LegJoin> before = {},
             std::optional<LegJoin> after = {});

    /// The leg at a time, in the travelling frame.
    Leg at(double time) const;
    /// The leg without ground clearance, for swings below the ground's level, into water or next to a rim.
    Leg inAir(double time) const;
    /// The join at a time.
    LegJoin join(double time) const;
    const std::vector<Step>& steps() const { return steps_; }

private:
    struct Flight {
        double begin = 0.0, end = 0.0;
        double clearBegin = 0.0, clearEnd = 0.0;
        Curve thigh, knee, ankle, side, yaw, toe;
    };
    const Step* standing(double time) const;
    LegShape shapeAt(double time) const;
    LegShape standingShape(const Step& step, double time) const;
    LegJoin edge(const Step& step, double time, bool landing) const;
    Flight flight(const LegJoin& from, const LegJoin& to, const Swing& swing) const;
    Leg standingAt(const Step& step, double time) const;
    Leg swinging(const Flight& flight, double time) const;
    Leg legAt(double time, bool clear) const;
    double clearAt(double time) const;

    std::size_t side_;
    std::vector<Step> steps_;
    Course course_;
    std::vector<Flight> flights_;
};

}  // namespace muster::generator
