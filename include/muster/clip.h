// Motion clips on Muster's skeleton.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "muster/pose.h"
#include "muster/status.h"

namespace muster {

/// What of a body touches something in a contact.
enum class Limb : std::uint8_t { LeftFoot, RightFoot, LeftHand, RightHand, LeftKnee, RightKnee, Count };
inline constexpr std::size_t kLimbCount = static_cast<std::size_t>(Limb::Count);
/// "left foot", "right hand"...
const char* limbName(Limb limb);
/// The joint that a contact of the limb holds: ankle, wrist or knee.
JointRole limbJoint(Limb limb);

/// A time in which a limb stays where it is.
struct Contact {
    Limb limb = Limb::LeftFoot;
    double begin = 0.0;  ///< [s], in [0, duration).
    /// [s] > begin; in a cyclic clip it may lie beyond the duration: it goes on in the next cycle.
    double end = 0.0;
    /// Where the joint stands flat, in the clip's ground frame (where the travel starts) [m].
    Vec3 anchor;
};

/// Where the character's own frame is: on the ground, from where the clip began.
struct Travel {
    float x = 0.0f;    ///< Forward [m].
    float y = 0.0f;    ///< To the left [m].
    float yaw = 0.0f;  ///< Turned to the left [rad].
};

/// An object that a single-step clip goes over, centred on the clip's length.
struct ClipObstacle {
    float height = 0.0f;     ///< [m]; 0 for none.
    float thickness = 0.0f;  ///< Along the travel [m].
};

/// A motion: poses at a fixed rate, where they travel, and what touches when.
struct Clip {
    std::string name;  ///< "run", "crawl-enter"...
    /// The motion it belongs to: "run", "duck", "crawl", "swim", "jump", "climb"...
    std::string motion;
    double rate = 60.0;  ///< Frames a second > 0.
    bool cyclic = true;  ///< The frame after the last is the first again, one travel on.
    /// Cyclic: duration * rate of them; else one more. In the travelling frame.
    std::vector<BodyPose> poses;
    /// As many as poses, and for cyclic clips one more: where the next cycle begins.
    std::vector<Travel> travel;
    std::vector<Contact> contacts;  ///< In order of `begin`.
    /// Share of a following cycle (of the motion entered) at which it continues.
    double entryPhase = 0.0;
    double exitPhase = 0.0;  ///< Share of the cycle of the motion before at which it begins.
    ClipObstacle obstacle;   ///< What it goes over.

    double duration() const;  ///< Of one play [s].
    double length() const;    ///< Net ground covered by one play [m].
    double speed() const;     ///< length / duration [m/s].
    /// The pose at a time [s]: wrapped where cyclic, else held at the ends.
    void sample(double time, BodyPose& out) const;
    /// The travel at a time [s]; cyclic clips go on travelling, cycle after cycle, for times of any sign.
    Travel travelAt(double time) const;
    /// True where the limb is in contact at that time.
    bool touches(Limb limb, double time) const;
    /// The contact of the limb at that time; null where none.
    const Contact* contactAt(Limb limb, double time) const;
};

/// A set of clips.
struct ClipLibrary {
    std::vector<Clip> clips;

    /// The clip of that name; null where there is none.
    const Clip* find(std::string_view name) const;
    /// Its index; -1 where there is none.
    std::int32_t indexOf(std::string_view name) const;
};

/// One travel after another: `then` begins where `first` ends, turned as it is.
Travel operator*(const Travel& first, const Travel& then);

/// Fails with InvalidArgument, naming clip and culprit, where numbers are not finite, counts do not fit or
/// contacts lie outside the clip.
Status validate(const Clip& clip);

}  // namespace muster
