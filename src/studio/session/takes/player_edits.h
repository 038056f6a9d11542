// The edits of people in the open take: how they are shown while it is replayed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "files/edits/edited_crowd.h"
#include "files/take/replayer.h"
#include "muster/take.h"

namespace muster {

/// Shows edited people, and gathers in small steps what it has to know of those with clocks of their own.
class PlayerEdits {
public:
    /// Nobody is edited until set() is called.
    PlayerEdits(const Take& take, bool stored) : take_(&take), stored_(stored) {}

    /// The edits from now on. The library must outlive this.
    void set(const std::vector<TakeEdit>& edits, const ClipLibrary& library);
    /// How edited people are shown after the world's step.
    std::span<const ShownCharacter> shown(const World& world) { return crowd_.shown(world); }
    /// Who is edited, or was at any time; in ascending order.
    const std::vector<std::uint32_t>& touched() const { return touched_; }

    bool gathering() const { return gatherer_ != nullptr; }  ///< True while something is to be gathered.
    /// One step of that; true where the last one is done and the people are shown otherwise now.
    bool gather();

private:
    struct Gatherer {
        World world;
        Replayer replayer;
        OwnTracks tracks;
    };
    void beginGathering(std::vector<std::uint32_t> people);

    const Take* take_;
    bool stored_;
    EditedCrowd crowd_;
    std::vector<std::uint32_t> touched_;
    std::shared_ptr<const OwnTracks> tracks_;
    std::unique_ptr<Gatherer> gatherer_;
};

}  // namespace muster
