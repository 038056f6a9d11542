// Skeleton, poses and motion clips of characters, and BVH files, which most animation programs exchange.
//
// Every clip stands on Muster's skeleton; motion of other skeletons is retargeted to it by the roles of
// the joints.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/generated/enumerations.h"
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
    const char* name;     ///< Name in common use by animation programs: "LeftForeArm".
    std::int32_t parent;  ///< Role of the parent as an index; -1 for the hips.
    Vec3 offset;          ///< Offset from the parent [m]; for the hips, from the ground below.
    Vec3 tip;             ///< End of the bone relative to the joint [m]; zero for joints with children.
};

/// The skeleton of a person 1.75 m tall.
const std::array<Joint, kJointCount>& skeleton();

inline constexpr float kBodyHeight = 1.75f;  ///< Top of the head in the rest pose [m].

/// Body size of the character with that id, as a factor of the skeleton: uniform in 0.96 to 1.04.
float characterSize(std::uint32_t id);

/// A pose of the body in body axes: the origin is on the ground below the character, which faces +x.
struct BodyPose {
    Vec3 hips;  ///< Position of the hips [m].
    /// Rotation of each joint relative to its parent; of the hips relative to the body axes.
    std::array<Quat, kJointCount> rotation;
};

/// The rest pose.
BodyPose restPose();

/// Transform of each joint, in body axes or in the world.
using JointTransforms = std::array<Transform, kJointCount>;

/// Forward kinematics: computes position and rotation of every joint. `root` transforms body axes to the
/// world.
void jointTransforms(const BodyPose& pose, const Transform& root, JointTransforms& joints);

/// Interpolates between two poses: hips linearly, rotations by nlerp; t = 0 gives `a`, t = 1 gives `b`.
void blend(const BodyPose& a, const BodyPose& b, float t, BodyPose& out);

/// The part of a body that touches something in a contact.
enum class Limb : std::uint8_t { LeftFoot, RightFoot, LeftHand, RightHand, LeftKnee, RightKnee, Count };
inline constexpr std::size_t kLimbCount = static_cast<std::size_t>(Limb::Count);
/// The name of a limb for people: "left foot", "right hand"...
const char* limbName(Limb limb);
/// The joint that stays in place during a contact of the limb: ankle, wrist or knee.
JointRole limbJoint(Limb limb);

/// A time interval in which a limb does not move over the ground.
struct Contact {
    Limb limb = Limb::LeftFoot;  ///< The limb that is in contact.
    double begin = 0.0;          ///< Start time [s], in [0, duration).
    /// End time [s], above `begin`. In a cyclic clip it may exceed the duration: the contact goes on in the
    /// next cycle.
    double end = 0.0;
    /// Position of the joint during the contact [m], in the axes in which the travel starts.
    Vec3 anchor;
};

/// Displacement of the body axes on the ground since the clip began (root motion).
struct Travel {
    float x = 0.0f;    ///< Displacement forward [m].
    float y = 0.0f;    ///< Displacement to the left [m].
    float yaw = 0.0f;  ///< Rotation to the left [rad].
};

/// The obstacle that a single-step clip passes over, in the middle of the clip's length.
struct ClipObstacle {
    float height = 0.0f;     ///< Height [m]; 0 for no obstacle.
    float thickness = 0.0f;  ///< Extent along the travel [m].
};

/// A motion clip: poses at a fixed rate, their travel, and the contacts.
struct Clip {
    std::string name;  ///< Unique name: "run", "crawl-enter"...
    /// The motion it belongs to: "run", "duck", "crawl", "swim", "jump", "climb"...
    std::string motion;
    double rate = 60.0;  ///< Poses per second, above 0.
    bool cyclic = true;  ///< True where the first pose follows the last, displaced by the travel.
    /// Poses in the travelling body axes: duration * rate of a cyclic clip, one more of others.
    std::vector<BodyPose> poses;
    /// Travel at each pose; a cyclic clip has one more, with which the next cycle begins.
    std::vector<Travel> travel;
    std::vector<Contact> contacts;  ///< Contacts in order of `begin`.
    /// Of a transition: share of the cycle of the entered motion at which that motion continues.
    double entryPhase = 0.0;
    double exitPhase = 0.0;  ///< Of a transition: share of the cycle of the left motion at which it begins.
    ClipObstacle obstacle;   ///< The obstacle that a single-step clip passes over.
    /// The manner of walking that a gait belongs to; none for the plain one.
    std::optional<MotionSet> set;

    double duration() const;  ///< Duration of one play [s].
    double length() const;    ///< Distance from start to end of one play [m].
    double speed() const;     ///< length / duration [m/s].
    /// The pose at a time [s], which wraps in cyclic clips and is clamped to the clip in others.
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
    std::vector<Clip> clips;  ///< With unique names.

    /// The clip of that name; null where there is none.
    const Clip* find(std::string_view name) const;
    /// The index of the clip of that name; -1 where there is none.
    std::int32_t indexOf(std::string_view name) const;
};

/// Composition of travels: `then` begins at the position and yaw at which `first` ends.
Travel operator*(const Travel& first, const Travel& then);

/// Fails with InvalidArgument, naming the clip and the faulty value, where numbers are not finite, counts do
/// not fit or contacts lie outside the clip.
Status validate(const Clip& clip);

/// A joint of a BVH file, in Muster's axes (x forward, y left, z up).
struct BvhJoint {
    std::string name;          ///< Name in the file.
    std::int32_t parent = -1;  ///< Index of a joint before it; -1 for a root.
    Vec3 offset;               ///< From the parent in the rest pose [m].
    std::vector<Vec3> ends;    ///< End sites, from the joint [m].
    bool moves = false;        ///< True where it has position channels.
};

/// A whole BVH file, decoded.
struct BvhMotion {
    std::vector<BvhJoint> joints;   ///< Parents before children; at least one.
    std::vector<Transform> values;  ///< Transforms relative to the parent [m], by frame and then by joint.
    std::size_t frames = 0;         ///< Number of frames, at least one.
    double rate = 30.0;             ///< Frames per second, above 0.
    double unit = 1.0;              ///< Length of one unit of the file [m].

    /// Transforms of all joints in frame `f`.
    std::span<const Transform> frame(std::size_t f) const {
        return std::span(values).subspan(f * joints.size(), joints.size());
    }
    /// Time from the first frame to the last [s].
    double duration() const { return static_cast<double>(frames - 1) / rate; }
};

/// Options of reading a BVH file.
struct BvhOptions {
    /// Length of one unit of the file [m], 1e-6 to 1e3; 0 to guess it from the body height.
    double unit = 0.0;
};

inline constexpr std::size_t kMaxBvhBytes = 512u << 20;  ///< Largest file that is read [bytes].
inline constexpr std::size_t kMaxBvhJoints = 1000;       ///< Largest number of joints.
inline constexpr std::size_t kMaxBvhValues = 8u << 20;   ///< Largest number of frames times joints.

/// Reads BVH text: any hierarchy, any order of channels. Unit, up axis (Y or Z) and facing (to a quarter
/// turn) are guessed from the rest pose. Fails, as `sourceName:LINE: found X, expected Y`, on anything that
/// is not a complete BVH file.
Result<BvhMotion> parseBvh(std::string_view text, const std::string& sourceName,
                           const BvhOptions& options = {});
/// The same from a file.
Result<BvhMotion> readBvh(const std::string& path, const BvhOptions& options = {});

/// A clip as BVH, in centimetres, Y up, facing +Z, which Maya, MotionBuilder, Unreal and Mixamo import with
/// default settings (Blender with scale 0.01). A joint "Root" on the ground carries the travel; "Hips" is
/// its child with six channels; all other joints have three. A cyclic clip ends with its first pose again,
/// displaced by the travel.
std::string bvhText(const Clip& clip);

}  // namespace muster
