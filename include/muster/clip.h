// Skeleton, poses and motion clips of characters, and BVH files, which most animation programs exchange.
//
// Every clip stands on Muster's skeleton; motion of other skeletons is brought onto it by the roles of
// joints.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/quat.h"
#include "muster/status.h"
#include "muster/vec3.h"

namespace muster {

/// The joints, parents before children. The values are indices into every array of joints.
enum class JointRole : std::uint8_t {
    Hips,
    Spine,
    Chest,
    Neck,
    Head,
    LeftShoulder,
    LeftArm,
    LeftForeArm,
    LeftHand,
    RightShoulder,
    RightArm,
    RightForeArm,
    RightHand,
    LeftUpLeg,
    LeftLeg,
    LeftFoot,
    LeftToeBase,
    RightUpLeg,
    RightLeg,
    RightFoot,
    RightToeBase,
    Count
};

inline constexpr std::size_t kJointCount = static_cast<std::size_t>(JointRole::Count);  ///< 21.
constexpr std::size_t index(JointRole role) {
    return static_cast<std::size_t>(role);
}

/// A joint in the rest pose.
struct Joint {
    const char* name;     ///< As many animation programs call it: "LeftForeArm".
    std::int32_t parent;  ///< -1 for the hips.
    Vec3 offset;          ///< From the parent [m]; of the hips from the ground below.
    Vec3 tip;             ///< Where the bone of a joint without children ends, from the joint [m]; else zero.
};

/// The skeleton of a person 1.75 m tall.
const std::array<Joint, kJointCount>& skeleton();

inline constexpr float kBodyHeight = 1.75f;  ///< Top of the head in the rest pose [m].

/// Size of the character with that id: 0.96 to 1.04 of the skeleton, even over the crowd.
float characterSize(std::uint32_t id);

/// How a body is held, in the character's own frame: on the ground below it, facing +x.
struct BodyPose {
    Vec3 hips;  ///< Where the hips are [m].
    /// Of each joint relative to its parent; of the hips to the character.
    std::array<Quat, kJointCount> rotation;
};

/// The rest pose.
BodyPose restPose();

/// Joints in the character's own frame (or where `root` puts it).
using JointTransforms = std::array<Transform, kJointCount>;

/// Forward kinematics: every joint's place and rotation; `root` puts the character into the world.
void jointTransforms(const BodyPose& pose, const Transform& root, JointTransforms& joints);

/// Between two poses: hips straight, rotations by nlerp; t = 0 gives `a`.
void blend(const BodyPose& a, const BodyPose& b, float t, BodyPose& out);

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

/// A joint of a BVH file, in Muster's axes (x forward, y left, z up).
struct BvhJoint {
    std::string name;          ///< As the file spells it.
    std::int32_t parent = -1;  ///< Index of a joint before it; -1 for a root.
    Vec3 offset;               ///< From the parent in the rest pose [m].
    std::vector<Vec3> ends;    ///< End sites, from the joint [m].
    bool moves = false;        ///< It has position channels.
};

/// A whole BVH file, decoded.
struct BvhMotion {
    std::vector<BvhJoint> joints;   ///< Parents before children; at least one.
    std::vector<Transform> values;  ///< Frame by frame, joint by joint: relative to the parent [m].
    std::size_t frames = 0;         ///< At least one.
    double rate = 30.0;             ///< Frames a second > 0.
    double unit = 1.0;              ///< One unit of the file [m].

    /// One value per joint.
    std::span<const Transform> frame(std::size_t f) const {
        return std::span(values).subspan(f * joints.size(), joints.size());
    }
    /// From the first frame to the last [s].
    double duration() const { return static_cast<double>(frames - 1) / rate; }
};

/// How to read.
struct BvhOptions {
    double unit = 0.0;  ///< One unit of the file [m], 1e-6 to 1e3; 0: guessed from the size of the body.
};

inline constexpr std::size_t kMaxBvhBytes = 512u << 20;  ///< Largest file read.
inline constexpr std::size_t kMaxBvhJoints = 1000;       ///< Most joints.
inline constexpr std::size_t kMaxBvhValues = 8u << 20;   ///< Most frames times joints.

/// Reads BVH text: any hierarchy, any order of channels. Unit, up axis (Y or Z) and facing (to a quarter
/// turn) are guessed from the rest pose. Fails, as `sourceName:LINE: found X, expected Y`, on anything that
/// is no whole BVH file.
Result<BvhMotion> parseBvh(std::string_view text, const std::string& sourceName,
                           const BvhOptions& options = {});
/// The same from a file.
Result<BvhMotion> readBvh(const std::string& path, const BvhOptions& options = {});

/// A clip as BVH, in centimetres, Y up, facing +Z, as Maya, MotionBuilder, Unreal and Mixamo take it without
/// asking (Blender imports it with scale 0.01). A joint "Root" on the ground carries the travel, "Hips"
/// stands in it with six channels, all other joints of the skeleton have three. A cyclic clip ends with its
/// first pose again, one travel on.
std::string bvhText(const Clip& clip);

}  // namespace muster
