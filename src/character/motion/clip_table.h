// Facts of a library's clips that playing needs, computed once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/clip.h"

namespace muster {

/// How a clip is played.
enum class ClipUse : std::uint8_t {
    Locomotion,  ///< Chosen frame by frame by motion matching.
    Cycle,       ///< Repeats while its patch lasts: duck, crawl, swim.
    Transition,  ///< Into or out of a cycle.
    Action,      ///< Once over its patch: jump, climb.
};

/// Limbs that are locked in contacts at run time.
inline constexpr std::array<Limb, 4> kLockableLimbs{Limb::LeftFoot, Limb::RightFoot, Limb::LeftHand,
                                                    Limb::RightHand};
inline constexpr std::size_t kLockableLimbCount = kLockableLimbs.size();

/// A limb's end in one frame of a contact, relative to its anchor, in the character's axes when the contact
/// began.
struct ContactFrame {
    Vec3 roll;          ///< From the anchor to the joint [m].
    Quat rotation;      ///< Of the joint.
    float turn = 0.0f;  ///< Yaw of the character since the contact began [rad].
};

/// A contact and its frames.
struct ContactTrack {
    float begin = 0.0f;           ///< [s]
    float end = 0.0f;             ///< [s], in a cyclic clip maybe beyond the duration.
    float height = 0.0f;          ///< Of the anchor [m].
    std::int32_t firstFrame = 0;  ///< Number of the first of `frames`, counted on beyond the duration.
    std::uint32_t frames = 0;     ///< Index into ClipEntry::frames.
    std::uint32_t count = 0;      ///< How many.
};

/// One clip.
struct ClipEntry {
    const Clip* clip = nullptr;
    ClipUse use = ClipUse::Locomotion;
    bool cyclic = true;
    bool standing = false;    ///< It goes nowhere.
    bool handsTouch = false;  ///< A hand has a contact.
    bool feetTouch = false;   ///< A foot has a contact.
    bool onFloor = false;     ///< No foot of it comes below the floor: it does not swim.
    bool strides = false;     ///< On feet alone: its steps may be longer or shorter.
    float duration = 0.0f;    ///< [s]
    float speed = 0.0f;       ///< [m/s]
    float length = 0.0f;      ///< [m]
    std::int32_t enter = -1;  ///< Clip that leads into this cycle; -1 for none.
    std::int32_t exit = -1;   ///< Clip that leads out of it; -1 for none.
    std::array<Vec3, 2>
        stance;  ///< Middle of where each ankle is while it touches the ground, in the own frame [m].
    std::vector<float> localSpeed;  ///< Of the travel, per frame [m/s].
    std::array<std::vector<ContactTrack>, kLockableLimbCount>
        contacts;                      ///< By index of kLockableLimbs, in order of `begin`.
    std::vector<ContactFrame> frames;  ///< Of all contacts.
};

/// The clips of a library, which must outlive this.
class ClipTable {
public:
    /// Reads the library; an empty one is allowed.
    explicit ClipTable(const ClipLibrary& library);

    std::size_t size() const { return entries_.size(); }                            ///< How many clips.
    const ClipEntry& operator[](std::size_t clip) const { return entries_[clip]; }  ///< One of them.
    /// The clip of that name; -1 where there is none.
    std::int32_t find(std::string_view name) const { return library_->indexOf(name); }
    const ClipLibrary& library() const { return *library_; }  ///< The clips.
    std::int32_t idle() const { return idle_; }               ///< The clip of standing; -1 for none.
    float slowest() const { return slowest_; }  ///< Speed of the slowest cyclic way to go [m/s].

    /// Speed of the travel at a time within one play [m/s].
    float speedAt(std::size_t clip, float time) const;
    /// The contact of a limb (index of kLockableLimbs) at a time within one play; null where none.
    const ContactTrack* contactAt(std::size_t clip, std::size_t limb, float time) const;
    /// The limb's end at a time in that contact.
    ContactFrame contactFrameAt(std::size_t clip, const ContactTrack& contact, float time) const;

private:
    void addContacts(ClipEntry& entry) const;

    const ClipLibrary* library_;
    std::vector<ClipEntry> entries_;
    std::int32_t idle_ = -1;
    float slowest_ = 0.0f;
};

}  // namespace muster
