// Precomputed facts about a library's clips that playback needs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/clip.h"

namespace muster {

/// The use of a clip by the player.
enum class ClipUse : std::uint8_t {
    Locomotion,  ///< Motion matching chooses its frames.
    Cycle,       ///< It repeats while its patch lasts: duck, crawl, swim.
    Transition,  ///< It leads into or out of a cycle.
    Action,      ///< It is played once over its patch: jump, climb.
};

/// Limbs that are locked in contacts at run time.
inline constexpr std::array<Limb, 4> kLockableLimbs{Limb::LeftFoot, Limb::RightFoot, Limb::LeftHand,
                                                    Limb::RightHand};
inline constexpr std::size_t kLockableLimbCount = kLockableLimbs.size();

/// The end of a limb in one frame of a contact, relative to the anchor, in the body axes at the begin of the
/// contact.
struct ContactFrame {
    Vec3 roll;          ///< Vector from the anchor to the joint [m].
    Quat rotation;      ///< Rotation of the joint.
    float turn = 0.0f;  ///< Yaw of the character since the contact began [rad].
};

/// A contact and its frames.
struct ContactTrack {
    float begin = 0.0f;           ///< Begin of the contact [s].
    float end = 0.0f;             ///< End of the contact, which may exceed the duration of a cyclic clip [s].
    float height = 0.0f;          ///< Height of the anchor [m].
    std::int32_t firstFrame = 0;  ///< Clip frame of the first entry; may exceed the clip's last.
    std::uint32_t frames = 0;     ///< Index of the first entry in ClipEntry::frames.
    std::uint32_t count = 0;      ///< Number of entries.
};

/// One clip.
struct ClipEntry {
    const Clip* clip = nullptr;
    ClipUse use = ClipUse::Locomotion;  ///< Use of the clip.
    bool cyclic = true;                 ///< True if it repeats.
    bool standing = false;              ///< True if it does not travel.
    bool handsTouch = false;            ///< True if a hand has a contact.
    bool feetTouch = false;             ///< True if a foot has a contact.
    bool onFloor = false;               ///< True if no foot goes below the floor; false for swimming.
    bool strides = false;               ///< True if only feet touch, so that its steps may be scaled.
    float duration = 0.0f;              ///< Duration [s].
    float speed = 0.0f;                 ///< Mean speed [m/s].
    float length = 0.0f;                ///< Length of the travel [m].
    std::int32_t enter = -1;            ///< Clip that leads into this cycle; -1 for none.
    std::int32_t exit = -1;             ///< Clip that leads out of it; -1 for none.
    std::array<Vec3, 2> stance;         ///< Mean position of each ankle in contact, in the body axes [m].
    std::vector<float> localSpeed;      ///< Speed of the travel, per frame [m/s].
    /// Contacts by index of kLockableLimbs, in order of `begin`.
    std::array<std::vector<ContactTrack>, kLockableLimbCount> contacts;
    std::vector<ContactFrame> frames;  ///< Frames of all contacts.
};

/// The clips of a library. The library must outlive the table.
class ClipTable {
public:
    /// Reads the library; an empty one is allowed.
    explicit ClipTable(const ClipLibrary& library);

    std::size_t size() const { return entries_.size(); }                            ///< Number of clips.
    const ClipEntry& operator[](std::size_t clip) const { return entries_[clip]; }  ///< The entry of a clip.
    /// The clip of that name; -1 for none.
    std::int32_t find(std::string_view name) const { return library_->indexOf(name); }
    const ClipLibrary& library() const { return *library_; }  ///< The clips.
    std::int32_t idle() const { return idle_; }               ///< The clip of standing; -1 for none.
    float slowest() const { return slowest_; }                ///< Speed of the slowest plain gait [m/s].

    /// Speed of the travel at a time within one play [m/s].
    float speedAt(std::size_t clip, float time) const;
    /// The contact of a limb (index of kLockableLimbs) at a time within one play; null for none.
    const ContactTrack* contactAt(std::size_t clip, std::size_t limb, float time) const;
    /// The end of the limb at a time in that contact.
    ContactFrame contactFrameAt(std::size_t clip, const ContactTrack& contact, float time) const;

private:
    void addContacts(ClipEntry& entry) const;

    const ClipLibrary* library_;
    std::vector<ClipEntry> entries_;
    std::int32_t idle_ = -1;
    float slowest_ = 0.0f;
};

}  // namespace muster
