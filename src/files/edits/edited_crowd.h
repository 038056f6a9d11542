// The crowd of a take as its edits show it: the simulated world stays as it is.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/steering/character_arrays.h"
#include "files/edits/edited_path.h"
#include "files/edits/own_tracks.h"
#include "muster/clip.h"
#include "people/motion/shown_character.h"

namespace muster {

class Environment;

/// Tells after each step of a replay how edited people are shown.
class EditedCrowd {
public:
    /// Nobody is edited.
    EditedCrowd() = default;
    /// The edits must pass checkEdits(). Clips that the library does not have are left out.
    EditedCrowd(std::vector<TakeEdit> edits, const ClipLibrary& library);

    /// Tracks of those with clocks of their own; without them their clocks run as usual.
    void setTracks(std::shared_ptr<const OwnTracks> tracks) { tracks_ = std::move(tracks); }
    /// How edited people who are there are shown, in ascending order of ids. Call it after every step; where
    /// steps were left out, motions of the ground begin as steady ones.
    std::span<const ShownCharacter> shown(const World& world);
    /// The same as the last time.
    std::span<const ShownCharacter> shown() const { return shown_; }

    const std::vector<TakeEdit>& edits() const { return edits_; }         ///< The edits.
    const std::vector<std::uint32_t>& people() const { return people_; }  ///< Who is edited, ascending.
    bool empty() const { return people_.empty(); }                        ///< True where nobody is.

private:
    void show(const World& world, std::size_t index, std::size_t person);
    void goOn(const Environment& environment, double stepTime, bool follows, ShownCharacter& one);
    std::int32_t clipAt(const TakeEdit& edit, double time) const;
    void look(const World& world, const TakeEdit& edit, double time, ShownCharacter& one) const;

    std::vector<TakeEdit> edits_;
    std::vector<OwnClock> clocks_;  ///< By edit.
    std::vector<std::uint32_t> people_;
    std::vector<std::size_t> editOf_;  ///< Index of the edit, by entry of people_.
    const ClipLibrary* library_ = nullptr;
    std::shared_ptr<const OwnTracks> tracks_;
    std::vector<ShownCharacter> shown_, before_;
    std::uint32_t step_ = 0;
    bool begun_ = false;
    Characters one_;  ///< Working memory: a single character.
};

/// Where the simulation of motions has somebody with that velocity face, where it faced `heading` while it
/// went at `recorded`.
Vec2 turnedHeading(Vec2 heading, Vec2 recorded, Vec2 velocity);

}  // namespace muster
