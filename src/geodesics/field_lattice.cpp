#include "geodesics/field_lattice.h"

#include <algorithm>
#include <bit>

namespace muster {
namespace {

constexpr std::uint32_t kIdle = 240;       // Steps after which a field that nobody used may go.
constexpr std::size_t kMostWishes = 8192;  // Kept until the next build.
constexpr std::size_t kFilter = 4096;      // Wishes looked back to for doubles.

}  // namespace

FieldLattice::FieldLattice(std::int32_t capacity) : capacity_(capacity) {
    table_.assign(std::bit_ceil(static_cast<std::uint32_t>(2 * capacity)), -1);
    landmark_.reserve(capacity);
    used_.reserve(capacity);
    wishes_.reserve(kMostWishes);
    filter_.assign(kFilter, -1);
}

void FieldLattice::clear() {
    ++generation_;
    count_ = 0;
    landmark_.clear();
    used_.clear();
    wishes_.clear();
    std::fill(filter_.begin(), filter_.end(), -1);
    std::fill(table_.begin(), table_.end(), -1);
}

void FieldLattice::reserve(std::size_t fields, std::size_t cells, std::size_t roots) {
    const std::size_t first = fields_.size();
    fields_.resize(std::max(first, std::min(fields, static_cast<std::size_t>(capacity_))));
    for (std::size_t k = first; k < fields_.size(); ++k) fields_[k].reserve(cells, roots);
}

std::uint32_t FieldLattice::home(std::int32_t landmark) const {
    const std::uint32_t mixed = static_cast<std::uint32_t>(landmark) * 2654435761u;
    return (mixed ^ (mixed >> 15)) & static_cast<std::uint32_t>(table_.size() - 1);
}

std::int32_t FieldLattice::find(std::int32_t landmark) const {
    const auto mask = static_cast<std::uint32_t>(table_.size() - 1);
    for (std::uint32_t at = home(landmark); table_[at] >= 0; at = (at + 1) & mask)
        if (landmark_[table_[at]] == landmark) return table_[at];
    return -1;
}

std::int32_t FieldLattice::use(std::int32_t landmark) {
    const std::int32_t slot = find(landmark);
    if (slot >= 0) used_[slot] = clock_;
    return slot;
}

void FieldLattice::wish(std::int32_t landmark) {
    std::int32_t& last = filter_[home(landmark) % kFilter];
    if (last == landmark || wishes_.size() >= kMostWishes) return;
    last = landmark;
    wishes_.push_back(landmark);
}

void FieldLattice::insert(std::int32_t landmark, std::int32_t slot) {
    const auto mask = static_cast<std::uint32_t>(table_.size() - 1);
    std::uint32_t at = home(landmark);
    while (table_[at] >= 0) at = (at + 1) & mask;
    table_[at] = slot;
}

void FieldLattice::rehash() {
    std::fill(table_.begin(), table_.end(), -1);
    for (std::int32_t slot = 0; slot < count_; ++slot) insert(landmark_[slot], slot);
}

void FieldLattice::refilter() {
    std::fill(filter_.begin(), filter_.end(), -1);
    for (const std::int32_t landmark : wishes_) filter_[home(landmark) % kFilter] = landmark;
}

void FieldLattice::makeRoom() {
    ++generation_;
    std::int32_t kept = 0;
    for (std::int32_t slot = 0; slot < count_; ++slot) {
        if (clock_ - used_[slot] > kIdle) continue;
        if (kept != slot) {
            landmark_[kept] = landmark_[slot];
            used_[kept] = used_[slot];
            std::swap(fields_[kept], fields_[slot]);
        }
        ++kept;
    }
    count_ = kept;
    landmark_.resize(kept);
    used_.resize(kept);
    rehash();
}

void FieldLattice::admit(std::int32_t most) {
    fresh_.clear();
    if (wishes_.empty()) return;
    for (const std::int32_t landmark : wishes_) {
        if (static_cast<std::int32_t>(fresh_.size()) >= most) break;
        if (use(landmark) >= 0) continue;
        if (count_ >= capacity_) {
            // Slots move: only before anything new stands in them.
            if (!fresh_.empty()) break;
            makeRoom();
            if (count_ >= capacity_) break;
        }
        const std::int32_t slot = count_++;
        if (static_cast<std::size_t>(slot) >= fields_.size()) fields_.resize(slot + 1);
        landmark_.push_back(landmark);
        used_.push_back(clock_);
        insert(landmark, slot);
        fresh_.push_back(slot);
    }
    wishes_.clear();
    std::fill(filter_.begin(), filter_.end(), -1);
}

}  // namespace muster
