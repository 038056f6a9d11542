// Animation of a crowd: which clip each character plays, and its pose with feet on the floor (SPEC C3 to C6).
//
// Reads the world and never changes it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "muster/clip.h"
#include "muster/own_clips.h"
#include "muster/world.h"

namespace muster {

/// The clip that a character plays: enough to draw it from baked poses.
struct MotionState {
    std::uint16_t clip = 0;      ///< Index into the library.
    std::uint16_t fromClip = 0;  ///< The clip that fades out.
    float time = 0.0f;           ///< Time in `clip` [s], within one play.
    float fromTime = 0.0f;       ///< Time in `fromClip` [s].
    float fade = 0.0f;           ///< Share of `fromClip` still shown, 0 to 1.
    Vec2 position;               ///< Origin of the body axes in the world: the simulated position [m].
    float yaw = 0.0f;            ///< Heading, counter-clockwise from +x [rad].
    float size = 1.0f;           ///< Factor of the skeleton: characterSize() of its id.
};

/// Options of CrowdMotion.
struct CrowdMotionDef {
    /// True: all characters get whole poses until setNear() is called. False: none does.
    bool allNear = true;
};

struct CrowdView;
struct ShownCharacter;
/// The motion of a crowd at one moment (CrowdMotion::state()).
struct CrowdMotionState;

/// The motion of all characters of a world. Not thread-safe.
class CrowdMotion {
public:
    /// Motion by the clips of `library`, which must outlive this.
    explicit CrowdMotion(const ClipLibrary& library, const CrowdMotionDef& def = {});
    ~CrowdMotion();
    CrowdMotion(CrowdMotion&&) noexcept;  ///< Moves.
    CrowdMotion& operator=(CrowdMotion&&) noexcept;

    /// Forgets all characters; the next update starts their motion again.
    void restart();
    /// Call after every step of the world. The motion of new characters, and of those that
    /// were moved by a command, starts again.
    void update(const World& world);
    /// The same, with some characters, in ascending order of ids, shown otherwise; internal.
    void update(const World& world, std::span<const ShownCharacter> shown);
    /// The motion of these characters, by ids in ascending order, starts again with the next update.
    void forget(std::span<const std::uint32_t> ids);
    /// The same for a crowd that is not a World; internal.
    void update(const CrowdView& crowd);

    /// All that later motion depends on, to go back to together with a snapshot of the world.
    std::shared_ptr<const CrowdMotionState> state() const;
    /// Goes back, or on, to a state of a motion by the same clips.
    void goBack(const CrowdMotionState& state);
    /// The memory of a state [bytes].
    static std::size_t sizeOf(const CrowdMotionState& state);

    /// Ids of the characters that get whole poses from the next update on, in any order; unknown ids are
    /// ignored. Empty for none.
    void setNear(std::span<const std::uint32_t> ids);

    /// The clip and time of each character, in the world's order.
    std::span<const MotionState> states() const;
    /// Indices of characters with whole poses, ascending.
    std::span<const std::uint32_t> near() const;
    /// The id of near()[k].
    std::uint32_t nearId(std::size_t k) const;
    /// The pose of near()[k], with locked feet, for a body of size 1. In the world it is scaled by `size`,
    /// rotated by `yaw` and moved to `position`.
    const BodyPose& pose(std::size_t k) const;
    /// True while that limb of near()[k] is locked in a contact.
    bool locked(std::size_t k, Limb limb) const;

    const ClipLibrary& library() const;  ///< The clips it plays.

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Computes the joints of a character in the world [m] from its state and its pose.
void worldJoints(const MotionState& state, const BodyPose& pose, JointTransforms& joints);

}  // namespace muster
