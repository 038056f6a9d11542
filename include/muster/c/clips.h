/* Made by schema/generate.mjs from schema/api/clips.txt: change these, not this file. */
/* Skeleton, poses, motion clips and BVH files. Component motion. */
#ifndef MUSTER_C_CLIPS_H
#define MUSTER_C_CLIPS_H

#include "muster/c/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A point or vector in space [m]. In the world x right, y forward, z up; in body axes x forward, y left, z
/// up.
typedef struct MusterVec3 {
    float x;  ///< First coordinate [m].
    float y;  ///< Second coordinate [m].
    float z;  ///< Height [m].
} MusterVec3;

/// A rotation in space: a unit quaternion.
typedef struct MusterQuat {
    float x;  ///< First imaginary part.
    float y;  ///< Second imaginary part.
    float z;  ///< Third imaginary part.
    float w;  ///< Real part.
} MusterQuat;

/// A rigid transform: rotation about the origin, then translation.
typedef struct MusterTransform {
    MusterQuat rotation;     ///< Rotation.
    MusterVec3 translation;  ///< Translation [m].
} MusterTransform;

/// The joints, parents before children. The values are indices into every array of joints.
typedef uint8_t MusterJointRole;
/// Values of MusterJointRole.
enum MusterJointRoleValue {
    MUSTER_JOINT_HIPS = 0,             ///< The hips.
    MUSTER_JOINT_SPINE = 1,            ///< The spine.
    MUSTER_JOINT_CHEST = 2,            ///< The chest.
    MUSTER_JOINT_NECK = 3,             ///< The neck.
    MUSTER_JOINT_HEAD = 4,             ///< The head.
    MUSTER_JOINT_LEFT_SHOULDER = 5,    ///< The left shoulder.
    MUSTER_JOINT_LEFT_ARM = 6,         ///< The left arm.
    MUSTER_JOINT_LEFT_FORE_ARM = 7,    ///< The left fore arm.
    MUSTER_JOINT_LEFT_HAND = 8,        ///< The left hand.
    MUSTER_JOINT_RIGHT_SHOULDER = 9,   ///< The right shoulder.
    MUSTER_JOINT_RIGHT_ARM = 10,       ///< The right arm.
    MUSTER_JOINT_RIGHT_FORE_ARM = 11,  ///< The right fore arm.
    MUSTER_JOINT_RIGHT_HAND = 12,      ///< The right hand.
    MUSTER_JOINT_LEFT_UP_LEG = 13,     ///< The left up leg.
    MUSTER_JOINT_LEFT_LEG = 14,        ///< The left leg.
    MUSTER_JOINT_LEFT_FOOT = 15,       ///< The left foot.
    MUSTER_JOINT_LEFT_TOE_BASE = 16,   ///< The left toe base.
    MUSTER_JOINT_RIGHT_UP_LEG = 17,    ///< The right up leg.
    MUSTER_JOINT_RIGHT_LEG = 18,       ///< The right leg.
    MUSTER_JOINT_RIGHT_FOOT = 19,      ///< The right foot.
    MUSTER_JOINT_RIGHT_TOE_BASE = 20,  ///< The right toe base.
    MUSTER_JOINT_COUNT = 21            ///< Their number.
};

/// A joint in the rest pose.
typedef struct MusterJoint {
    const char* name;   ///< Name in common use by animation programs: "LeftForeArm".
    int32_t parent;     ///< Index of the parent; -1 for the hips.
    MusterVec3 offset;  ///< Offset from the parent [m]; for the hips, from the ground below.
    MusterVec3 tip;     ///< End of the bone relative to the joint [m]; zero for joints with children.
} MusterJoint;

/// The MUSTER_JOINT_COUNT joints of the skeleton of a person 1.75 m tall. Valid for ever.
MUSTER_API const MusterJoint* muster_skeleton(void);
/// Body size of the character with that id, as a factor of the skeleton: uniform in 0.96 to 1.04.
MUSTER_API float muster_character_size(uint32_t character);

/// A pose of the body in body axes: the origin is on the ground below the character, which faces +x.
typedef struct MusterBodyPose {
    MusterVec3 hips;          ///< Position of the hips [m].
    MusterQuat rotation[21];  ///< Rotation of each joint relative to its parent; of the hips to the body
                              ///< axes.
} MusterBodyPose;

/// The rest pose.
MUSTER_API MusterBodyPose muster_rest_pose(void);
/// Forward kinematics: writes MUSTER_JOINT_COUNT transforms. `root` transforms body axes to the world.
MUSTER_API MusterStatus muster_joint_transforms(const MusterBodyPose* pose, const MusterTransform* root,
                                                MusterTransform* outJoints);
/// Interpolates between two poses; t = 0 gives `a`, t = 1 gives `b`.
MUSTER_API MusterStatus muster_blend_poses(const MusterBodyPose* a, const MusterBodyPose* b, float t,
                                           MusterBodyPose* outPose);

/// The part of a body that touches something in a contact.
typedef uint8_t MusterLimb;
/// Values of MusterLimb.
enum MusterLimbValue {
    MUSTER_LIMB_LEFT_FOOT = 0,   ///< The left foot.
    MUSTER_LIMB_RIGHT_FOOT = 1,  ///< The right foot.
    MUSTER_LIMB_LEFT_HAND = 2,   ///< The left hand.
    MUSTER_LIMB_RIGHT_HAND = 3,  ///< The right hand.
    MUSTER_LIMB_LEFT_KNEE = 4,   ///< The left knee.
    MUSTER_LIMB_RIGHT_KNEE = 5,  ///< The right knee.
    MUSTER_LIMB_COUNT = 6        ///< Their number.
};

/// The name of a limb: "left foot"... Null for other numbers.
MUSTER_API const char* muster_limb_name(MusterLimb limb);
/// The joint that stays in place during a contact of the limb. MUSTER_JOINT_COUNT for other numbers.
MUSTER_API MusterJointRole muster_limb_joint(MusterLimb limb);

/// A time interval in which a limb does not move over the ground.
typedef struct MusterLimbContact {
    MusterLimb limb;    ///< The limb that is in contact.
    double begin;       ///< Start time [s], in [0, duration).
    double end;         ///< End time [s], above `begin`; in a cyclic clip it may exceed the duration.
    MusterVec3 anchor;  ///< Position of the joint during the contact [m], in the axes in which the travel
                        ///< starts.
} MusterLimbContact;

/// Displacement of the body axes on the ground since the clip began (root motion).
typedef struct MusterTravel {
    float x;    ///< Displacement forward [m].
    float y;    ///< Displacement to the left [m].
    float yaw;  ///< Rotation to the left [rad].
} MusterTravel;

/// Composition: `then` begins at the position and yaw at which `first` ends.
MUSTER_API MusterTravel muster_travel_compose(MusterTravel first, MusterTravel then);

/// A motion clip: poses at a fixed rate, their travel, and the contacts.
typedef struct MusterClip {
    uint32_t structVersion;             ///< Set by muster_default_clip().
    const char* name;                   ///< Unique name: "run", "crawl-enter"...
    const char* motion;                 ///< The motion it belongs to: "run", "duck", "crawl"...
    double rate;                        ///< Poses per second, above 0.
    bool cyclic;                        ///< True where the first pose follows the last, displaced by the
                                        ///< travel.
    const MusterBodyPose* poses;        ///< Duration times rate of a cyclic clip, one more of others.
    int32_t poseCount;                  ///< Their number.
    const MusterTravel* travel;         ///< Travel at each pose; a cyclic clip has one more.
    int32_t travelCount;                ///< Their number.
    const MusterLimbContact* contacts;  ///< Contacts in order of `begin`.
    int32_t contactCount;               ///< Their number.
    double entryPhase;                  ///< Of a transition: share of the entered cycle at which that
                                        ///< continues.
    double exitPhase;                   ///< Of a transition: share of the left cycle at which it begins.
    float obstacleHeight;               ///< Height of what a single-step clip passes over [m]; 0 for nothing.
    float obstacleThickness;            ///< Its extent along the travel [m].
} MusterClip;

/// A cyclic clip without poses, at 60 poses per second.
MUSTER_API MusterClip muster_default_clip(void);

/// A set of clips.
typedef struct MusterClipLibraryId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterClipLibraryId;

/// All of Muster's own clips, made once at the first call (a tenth of a second).
MUSTER_API MusterStatus muster_clips_own(MusterClipLibraryId* outLibrary);
/// A library of given clips. Fails with InvalidArgument, naming the clip and the faulty value, also where two
/// have one name.
MUSTER_API MusterStatus muster_clips_create(const MusterClip* clips, int32_t clipCount,
                                            MusterClipLibraryId* outLibrary);
/// Ends the handle of a library; motions that play its clips keep them.
MUSTER_API MusterStatus muster_clips_destroy(MusterClipLibraryId library);
/// All clips of a library. Valid until it is destroyed.
MUSTER_API MusterStatus muster_clips_get(MusterClipLibraryId library, const MusterClip** outClips,
                                         int32_t* outCount);
/// The index of the clip of that name. Fails with NotFound.
MUSTER_API MusterStatus muster_clips_find(MusterClipLibraryId library, const char* name, int32_t* outIndex);

/// Measures of a clip.
typedef struct MusterClipMeasures {
    double duration;  ///< Duration of one play [s].
    double length;    ///< Distance from start to end of one play [m].
    double speed;     ///< Length by duration [m/s].
} MusterClipMeasures;

/// Measures of the clip of an index. Fails with InvalidArgument for other indices, as all that follow.
MUSTER_API MusterStatus muster_clip_measures(MusterClipLibraryId library, int32_t clip,
                                             MusterClipMeasures* outMeasures);
/// The pose at a time [s], which wraps in cyclic clips and is clamped to the clip in others.
MUSTER_API MusterStatus muster_clip_sample(MusterClipLibraryId library, int32_t clip, double time,
                                           MusterBodyPose* outPose);
/// The travel at a time [s]; cyclic clips go on travelling for times of any sign.
MUSTER_API MusterStatus muster_clip_travel_at(MusterClipLibraryId library, int32_t clip, double time,
                                              MusterTravel* outTravel);
/// The contact of a limb at a time [s]; null where none. Valid until the library is destroyed.
MUSTER_API MusterStatus muster_clip_contact_at(MusterClipLibraryId library, int32_t clip, MusterLimb limb,
                                               double time, const MusterLimbContact** outContact);
/// The clip as the text of a BVH file, in centimetres, Y up, facing +Z.
MUSTER_API MusterStatus muster_clip_bvh(MusterClipLibraryId library, int32_t clip, MusterBuffer* outText);

#ifdef __cplusplus
}
#endif

#endif
