// Walking, running and all between, upright or stooped, straight or in a bend, from one set of numbers.
#pragma once

#include <string>

#include "character/generator/leg_track.h"
#include "muster/clip.h"

namespace muster::generator {

inline constexpr double kGravity = 9.81;  ///< [m/s^2]

/// A swing about a middle, once a cycle.
struct Wave {
    double middle = 0.0;  ///< [rad]
    double swing = 0.0;   ///< To each side [rad].
    double late = 0.0;    ///< Share of the cycle by which it lags behind the opposite leg.
};

/// A gait. Angles in radians; shares are of a cycle. Phase 0: the left foot lands.
struct Gait {
    double cycle = 1.0;    ///< [s]
    double speed = 1.0;    ///< Along its way [m/s].
    double contact = 0.6;  ///< Share of the cycle that a foot stands, 0.2 to 0.7.
    double bend = 0.0;     ///< One over the radius of its way, to the left [1/m].

    double footForward = 0.0;  ///< Of the foot before the hips in the middle of its stay [m].
    double footOut = 0.06;     ///< Of the foot from the middle line [m].
    double toeOut = 0.1;
    double strike = 0.3;     ///< Toes raised at landing.
    double flat = 0.08;      ///< Share of the cycle from landing until flat.
    double heelRise = 0.25;  ///< Share of the cycle from heel-off to toe-off.
    double push = 1.0;       ///< Heel raised at toe-off.
    Swing swing;

    double height = 0.9;   ///< Mean height of the hips; running: at landing [m].
    double lift = 0.0;     ///< Running: so much higher they are where a foot leaves than where it lands [m].
    double bob = 0.025;    ///< Rise and fall of the hips in walking [m]; running follows from flight.
    double surge = 0.01;   ///< Fore and aft against even travel [m].
    double sway = 0.02;    ///< Sideways over the standing foot [m].
    double forward = 0.0;  ///< Of the hips before the travelling frame [m].
    double pelvisPitch = 0.05;
    double pelvisYaw = 0.08;
    double pelvisRoll = 0.06;
    double lean = 0.03;  ///< Of the chest, forwards.
    double nod = 0.0;    ///< Change of the lean, twice a cycle.
    double chestYaw = 0.08;
    double chestRoll = 0.03;
    double headPitch = 0.0;

    Wave arm;  ///< Upper arm forwards.
    double armOut = 0.15;
    double armTurn = 0.3;
    double armAcross = 0.0;  ///< More turned inwards when it is forward.
    Wave elbow;
    double wrist = 0.15;

    /// True where both feet leave the ground.
    bool flies() const { return contact < 0.5; }
};

/// A gait in time: phase 0 at time `start`.
class GaitTrack {
public:
    explicit GaitTrack(const Gait& gait, double start = 0.0);

    const Gait& gait() const { return gait_; }
    /// The travelling frame; at the ground's origin at `start`.
    Placement travel(double time) const;
    /// Trunk, head and arms.
    Body body(double time) const;
    /// Travel and body as functions.
    Course course() const;
    /// Steps of one foot that begin in cycles `first` to `last`.
    std::vector<Step> steps(std::size_t side, int first, int last) const;
    /// One step, anchored where `course` is in the middle of its stay.
    Step step(std::size_t side, int cycle, const Course& course) const;
    /// Where the foot's stay begins [s].
    double landing(std::size_t side, int cycle) const;
    /// The legs of a time within a cycle or so of `start`.
    LegTrack leg(std::size_t side) const;

private:
    void addTrunk(double phase, Body& body) const;
    void addArms(double phase, Body& body) const;
    void addBend(Body& body) const;
    double height(double phase) const;

    Gait gait_;
    double start_;
};

/// A clip of one cycle of the gait at 60 frames a second; its cycle must be a whole number of frames.
Clip gaitClip(const std::string& name, const std::string& motion, const Gait& gait);

/// Muster's gaits.
Gait walkGait();
Gait jogGait();
Gait runGait();
Gait sprintGait();
Gait duckGait();
/// The same gait in a bend of that radius [m], to the left where positive.
Gait bent(Gait gait, double radius);

}  // namespace muster::generator
