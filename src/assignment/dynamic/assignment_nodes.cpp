#include "assignment/dynamic/assignment_nodes.h"

#include <algorithm>

namespace muster {

void AssignmentNodes::reset(std::int32_t characters, std::int32_t places) {
    const auto seats = static_cast<std::size_t>(std::max(characters, places));
    places_ = places;
    holder_.assign(seats, -1);
    seatOf_.assign(static_cast<std::size_t>(characters), -1);
    live_.assign(seats, 0);
    waiting_.reserve(seats);
    free_.reserve(seats);
}

void AssignmentNodes::warmStart(std::span<const std::int32_t> placeOf) {
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t place = placeOf[i];
        if (place >= 0 && place < places_ && holder(place) < 0) put(place, i);
    }
}

void AssignmentNodes::follow(const AssignmentInput& input, std::vector<std::int32_t>& flipped) {
    waiting_.clear();
    free_.clear();
    for (std::int32_t s = 0; s < count(); ++s) {
        const std::uint8_t live = s < places_ && input.mayTake(static_cast<std::size_t>(s)) ? 1 : 0;
        if (live != live_[s]) flipped.push_back(s);
        live_[s] = live;
    }
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t seat = seatOf(i);
        if (!input.takesPart(static_cast<std::size_t>(i))) {
            if (seat >= 0) {
                put(seat, -1);
                flipped.push_back(seat);
            }
            seatOf_[i] = -1;
        } else if (seat < 0 || !live(seat)) {
            waiting_.push_back(i);
        }
    }
    for (std::int32_t s = 0; s < count(); ++s)
        if (live(s) && holder(s) < 0) free_.push_back(s);
}

void AssignmentNodes::take(std::int32_t character, std::int32_t seat) {
    const std::int32_t before = seatOf(character);
    if (before >= 0) put(before, -1);
    put(seat, character);
}

void AssignmentNodes::seatRest() {
    std::int32_t seat = 0;
    for (const std::int32_t i : waiting_) {
        if (seatOf(i) >= 0) continue;
        while (live(seat) || holder(seat) >= 0) ++seat;
        put(seat, i);
    }
}

bool AssignmentNodes::consistent() const {
    const auto seats = std::max(seatOf_.size(), static_cast<std::size_t>(std::max(places_, 0)));
    if (places_ < 0 || holder_.size() != seats || live_.size() != seats) return false;
    for (std::int32_t s = 0; s < count(); ++s)
        if (holder(s) < -1 || holder(s) >= characters() || (holder(s) >= 0 && seatOf(holder(s)) != s))
            return false;
    for (std::int32_t i = 0; i < characters(); ++i)
        if (seatOf(i) < -1 || seatOf(i) >= count() || (seatOf(i) >= 0 && holder(seatOf(i)) != i))
            return false;
    return true;
}

}  // namespace muster
