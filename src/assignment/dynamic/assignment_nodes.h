// Who sits where: every character that takes part has a seat, with a place or without.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/dynamic_assignment_def.h"

namespace muster {

/// As many seats as there are characters or places, whichever is more. Seat s stands for place s while that
/// may be taken; every other seat is one to wait in. Exchanges are cycles of seats, whether somebody sits
/// there or not.
class AssignmentNodes {
public:
    /// Empties all seats.
    void reset(std::int32_t characters, std::int32_t places);
    /// Seats the characters at the places named; whoever names none, or one that is taken, has no seat yet.
    void warmStart(std::span<const std::int32_t> placeOf);
    /// Takes over who takes part and which places may be taken. Lists those who wait and the places that are
    /// free; adds the seats to `flipped` that are another thing than before.
    void follow(const AssignmentInput& input, std::vector<std::int32_t>& flipped);
    /// Gives those still without a seat one to wait in.
    void seatRest();
    /// Puts a character (-1: nobody) on a seat; what it left is not emptied.
    void put(std::int32_t seat, std::int32_t character) {
        holder_[seat] = character;
        if (character >= 0) seatOf_[character] = seat;
    }
    /// Moves a character that waits to a free place.
    void take(std::int32_t character, std::int32_t seat);

    std::int32_t count() const { return static_cast<std::int32_t>(holder_.size()); }  ///< Seats.
    /// As at reset().
    std::int32_t characters() const { return static_cast<std::int32_t>(seatOf_.size()); }
    /// As at reset().
    std::int32_t places() const { return places_; }
    bool live(std::int32_t seat) const { return live_[seat] != 0; }         ///< Has a place.
    std::int32_t holder(std::int32_t seat) const { return holder_[seat]; }  ///< -1: nobody.
    /// The seat of a character, -1 for none.
    std::int32_t seatOf(std::int32_t character) const { return seatOf_[character]; }
    /// True where moving the holder to its place costs something.
    bool matched(std::int32_t seat) const { return live(seat) && holder(seat) >= 0; }
    /// Where a seat is [m].
    Vec2 at(std::int32_t seat, const AssignmentStep& context) const {
        return live(seat) ? context.input.places[seat] : context.anchor;
    }
    /// By follow(): characters, ascending.
    const std::vector<std::int32_t>& waiting() const { return waiting_; }
    const std::vector<std::int32_t>& free() const { return free_; }  ///< By follow(): seats, ascending.

    /// Lets an archive read or write the seats.
    template <class Archive>
    void visit(Archive& archive) {
        archive(places_, holder_, seatOf_, live_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    bool consistent() const;

    std::int32_t places_ = 0;
    std::vector<std::int32_t> holder_;  // Per seat.
    std::vector<std::int32_t> seatOf_;  // Per character.
    std::vector<std::uint8_t> live_;    // Per seat.
    std::vector<std::int32_t> waiting_;
    std::vector<std::int32_t> free_;
};

}  // namespace muster
