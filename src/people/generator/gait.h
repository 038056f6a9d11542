// A parametric gait model for walking, running and all gaits between, upright or stooped, straight or along
// an arc.
#pragma once

#include <cstddef>
#include <string>

#include "muster/clip.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

inline constexpr double kGravity = 9.81;  ///< Acceleration of gravity [m/s^2].

/// A sinusoidal swing about a mean angle, once per cycle.
struct Wave {
    double middle = 0.0;  ///< Mean angle [rad].
    double swing = 0.0;   ///< Amplitude [rad].
    double late = 0.0;    ///< Lag behind the opposite leg [share of the cycle].
};

/// Parameters of a gait. Angles are in radians, shares are of a cycle. At phase 0 the left foot lands.
struct Gait {
    double cycle = 1.0;    ///< Duration of a cycle [s].
    double speed = 1.0;    ///< Speed along its path [m/s].
    double contact = 0.6;  ///< Share of the cycle in which a foot stands, 0.2 to 0.7.
    double bend = 0.0;     ///< Curvature of its path, positive to the left [1/m].

    double footForward = 0.0;  ///< Distance of the foot ahead of the hips in mid-contact [m].
    double footOut = 0.06;     ///< Distance of the foot from the middle line [m].
    double toeOut = 0.1;       ///< Outward yaw of the feet.
    double strike = 0.3;       ///< Angle of the raised toes at landing.
    double flat = 0.08;        ///< Share of the cycle from landing until flat.
    double heelRise = 0.25;    ///< Share of the cycle from heel-off to toe-off.
    double push = 1.0;         ///< Angle of the raised heel at toe-off.
    Swing swing;               ///< Angles of the leg between two steps.

    double height = 0.9;        ///< Mean height of the hips; running: at landing [m].
    double lift = 0.0;          ///< Rise of the hips from landing to toe-off, in running [m].
    double bob = 0.025;         ///< Vertical swing of the hips, unused in running [m].
    double surge = 0.01;        ///< Forward swing of the hips relative to even travel [m].
    double sway = 0.02;         ///< Sideways swing of the hips towards the standing foot [m].
    double forward = 0.0;       ///< Distance of the hips ahead of the travelling frame [m].
    double pelvisPitch = 0.05;  ///< Constant forward tilt of the pelvis.
    double pelvisYaw = 0.08;    ///< Amplitude of the pelvis' yaw.
    double pelvisRoll = 0.06;   ///< Amplitude of the pelvis' roll.
    double lean = 0.03;         ///< Mean forward lean of the chest.
    double nod = 0.0;           ///< Amplitude of the lean, which swings twice per cycle.
    double chestYaw = 0.08;     ///< Amplitude of the chest's yaw.
    double chestRoll = 0.03;    ///< Amplitude of the chest's roll.
    double headPitch = 0.0;     ///< Constant pitch of the head.

    Wave arm;                ///< Forward swing of the upper arm.
    double armOut = 0.15;    ///< Constant angle of the arms away from the body.
    double armTurn = 0.3;    ///< Mean inward rotation of the arms.
    double armAcross = 0.0;  ///< Additional inward rotation of an arm that is forward.
    Wave elbow;              ///< Flexion of the elbow.
    double wrist = 0.15;     ///< Constant flexion of the wrist.

    /// True if both feet leave the ground.
    bool flies() const { return contact < 0.5; }
};

/// A gait as a function of time; its phase is 0 at time `start`.
class GaitTrack {
public:
    explicit GaitTrack(const Gait& gait, double start = 0.0);

    const Gait& gait() const { return gait_; }
    /// The travelling frame at a time; it is at the origin of the ground at `start`.
    Placement travel(double time) const;
    /// Trunk, head and arms at a time.
    ChannelValues body(double time) const;
    /// Travel and body as functions.
    Course course() const;
    /// The steps of one foot that begin in the cycles `first` to `last`.
    std::vector<Step> steps(std::size_t side, int first, int last) const;
    /// One step, anchored at the position of `course` in the middle of its contact.
    Step step(std::size_t side, int cycle, const Course& course) const;
    /// Time at which the foot lands [s].
    double landing(std::size_t side, int cycle) const;
    /// The leg's motion; valid within about one cycle of `start`.
    LegTrack leg(std::size_t side) const;

private:
    void addTrunk(double phase, ChannelValues& body) const;
    void addArms(double phase, ChannelValues& body) const;
    void addBend(ChannelValues& body) const;
    double height(double phase) const;

    Gait gait_;
    double start_;
};

/// A clip of one cycle of the gait at 60 frames per second. The cycle must be a whole number of frames.
Clip gaitClip(const std::string& name, const std::string& motion, const Gait& gait);

/// The gaits of Muster's own clips.
enum class GaitKind { Walk, Jog, Run, Sprint, Duck, MarchingWalk, MarchingJog, WearyWalk, WearyJog };
inline constexpr std::size_t kGaitKinds = 9;
Gait gaitOf(GaitKind kind);
/// A gait along an arc of that radius [m]; a positive radius turns to the left.
Gait bent(Gait gait, double radius);

}  // namespace muster::generator
