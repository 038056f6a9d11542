// Feet: steps that stand still on the ground, and swings between them.
#pragma once

#include <optional>
#include <vector>

#include "character/generator/course.h"
#include "character/generator/curve.h"

namespace muster::generator {

/// How a leg recovers between two steps: keys by the share of the swing [0, 1] and angle [rad].
struct Swing {
    std::vector<Key> thigh;  ///< Forward of the vertical.
    std::vector<Key> knee;   ///< Bent.
    std::vector<Key> ankle;  ///< Foot raised against the shin.
};

/// A key of a swing: share of it, 0 to 1, and angle [degrees].
inline Key swingKey(double share, double angle) {
    return {share, degrees(angle)};
}

/// A foot's contact with the ground. It lands on the heel where `strike` > 0, lies flat, and leaves over the
/// ball.
struct Step {
    double begin = 0.0;   ///< [s]
    double end = 0.0;     ///< [s]
    Vec3 anchor;          ///< The flat foot's ankle, in the ground's frame [m].
    double yaw = 0.0;     ///< Of the foot, in the ground's frame [rad].
    double strike = 0.0;  ///< Toes raised at landing [rad].
    double flat = 0.0;    ///< From landing until flat [s].
    double rise = 0.0;    ///< From where the heel begins to rise until the end [s].
    double push = 0.0;    ///< Heel raised at the end [rad].
    Swing swing;          ///< What follows.
};

/// A leg's shape as a swing interpolates it, in the travelling frame.
struct LegShape {
    double thigh = 0.0;  ///< Forward of the vertical [rad].
    double knee = 0.0;   ///< Bent [rad].
    double ankle = 0.0;  ///< Foot raised against the shin [rad].
    double side = 0.0;   ///< Ankle left of the hip [m].
    double yaw = 0.0;    ///< Of the foot [rad].
    double toe = 0.0;    ///< Toes bent down against the foot [rad].
};

/// A leg's shape and how it changes at one time: where a clip joins another in mid-swing.
struct LegJoin {
    double time = 0.0;
    LegShape shape;
    LegShape rate;       ///< Per second.
    double clear = 0.0;  ///< How much the foot keeps clear of the ground then, 0 to 1.
};

/// The ankle of a foot rolled by `pitch` [rad] (toes up: on its heel; else on its ball) with its sole's place
/// kept.
Vec3 rolledAnkle(Vec3 anchor, double yaw, double pitch);
/// The leg of a flat or rolled foot on the ground, toes flat.
Leg standingLeg(Vec3 anchor, double yaw, double pitch);

/// One leg's motion over time.
class LegTrack {
public:
    /// `steps` in order; before the first and after the last it stands. A join takes the place of all that
    /// lies before or after its time.
    LegTrack(std::size_t side, std::vector<Step> steps, Course course, std::optional<LegJoin> before = {},
             std::optional<LegJoin> after = {});

    /// In the travelling frame.
    Leg at(double time) const;
    /// The same where swings go below the ground's level: into water, beside a rim.
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
