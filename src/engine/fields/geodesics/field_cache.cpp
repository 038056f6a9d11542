#include "engine/fields/geodesics/field_cache.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace muster {
namespace {

constexpr std::uint32_t kIdleSteps = 240;  // Number of unused steps after which a field may be evicted.
// Greatest number of requests between two calls of solveRequested().
constexpr std::size_t kMaxRequests = 8192;
// Number of fields solved in a step for which there is memory at first.
constexpr std::size_t kMostAdmitted = 64;
constexpr std::int32_t kGiven = -2;        // Value in place of a landmark: another cache has the field.
constexpr std::size_t kFilterSize = 4096;  // Entries of the filter against double requests.

}  // namespace

// The other memory comes with the first field: on open ground there is none.
FieldCache::FieldCache(std::int32_t capacity) : capacity_(capacity) {}

void FieldCache::prepare() {
    if (!table_.empty()) return;
    table_.assign(std::bit_ceil(static_cast<std::uint32_t>(2 * capacity_)), -1);
    landmark_.reserve(capacity_);
    lastUse_.reserve(capacity_);
    requests_.reserve(kMaxRequests);
    admitted_.reserve(kMostAdmitted);
    filter_.assign(kFilterSize, -1);
}

void FieldCache::clear() {
    ++generation_;
    missing_.clear();
    count_ = 0;
    landmark_.clear();
    lastUse_.clear();
    requests_.clear();
    std::fill(holds_.begin(), holds_.end(), -1);
    std::fill(filter_.begin(), filter_.end(), -1);
    std::fill(table_.begin(), table_.end(), -1);
}

void FieldCache::reserve(std::size_t fields, std::size_t cells, std::size_t pseudoSources) {
    prepare();
    const std::size_t first = fields_.size();
    growFields(std::min<std::size_t>(fields, capacity_));
    for (std::size_t k = first; k < fields_.size(); ++k) fields_[k].reserve(cells, pseudoSources);
}

// Multiplicative hashing (Knuth 1973, 6.4).
std::uint32_t FieldCache::hashOf(std::int32_t landmark) const {
    const std::uint32_t product = static_cast<std::uint32_t>(landmark) * 2654435761u;
    return (product ^ (product >> 15)) & static_cast<std::uint32_t>(table_.size() - 1);
}

std::int32_t FieldCache::find(std::int32_t landmark) const {
    if (count_ == 0) return -1;
    const auto mask = static_cast<std::uint32_t>(table_.size() - 1);
    for (std::uint32_t at = hashOf(landmark); table_[at] >= 0; at = (at + 1) & mask)
        if (landmark_[table_[at]] == landmark) return table_[at];
    return -1;
}

std::int32_t FieldCache::use(std::int32_t landmark) {
    const std::int32_t slot = find(landmark);
    if (slot >= 0) lastUse_[slot] = clock_;
    return slot;
}

void FieldCache::request(std::int32_t landmark) {
    prepare();
    std::int32_t& last = filter_[hashOf(landmark) % kFilterSize];
    if (last == landmark || requests_.size() >= kMaxRequests) return;
    last = landmark;
    requests_.push_back(landmark);
}

void FieldCache::insert(std::int32_t landmark, std::int32_t slot) {
    const auto mask = static_cast<std::uint32_t>(table_.size() - 1);
    std::uint32_t at = hashOf(landmark);
    while (table_[at] >= 0) at = (at + 1) & mask;
    table_[at] = slot;
}

void FieldCache::keepFieldsOf(FieldCache& before) {
    if (!before.missing_.empty()) return;
    std::erase_if(missing_, [&](std::int32_t slot) {
        const std::int32_t landmark = landmark_[slot], used = before.find(landmark);
        const auto known = used >= 0 ? before.holds_.begin() + used
                                     : std::find(before.holds_.begin() + before.count_, before.holds_.end(),
                                                 landmark);
        if (known == before.holds_.end()) return false;
        fields_[slot] = std::move(before.fields_[known - before.holds_.begin()]);
        holds_[slot] = landmark;
        *known = kGiven;
        return true;
    });
    // Later steps may ask for the other fields, else their memory serves.
    for (std::size_t k = 0; k < before.fields_.size(); ++k) {
        if (before.holds_[k] == kGiven) continue;
        fields_.push_back(std::move(before.fields_[k]));
        // The ground of a cache that had not begun is unknown.
        holds_.push_back(begun() ? before.holds_[k] : -1);
    }
}

// Brings the field of its landmark to a slot, where it lies beyond the slots in use.
void FieldCache::takeKnown(std::int32_t slot) {
    const auto known = std::find(holds_.begin() + slot, holds_.end(), landmark_[slot]);
    if (known != holds_.end()) swapFields(slot, known - holds_.begin());
}

void FieldCache::rebuildTable() {
    if (count_ > 0) prepare();
    std::fill(table_.begin(), table_.end(), -1);
    for (std::int32_t slot = 0; slot < count_; ++slot) insert(landmark_[slot], slot);
}

void FieldCache::rebuildFilter() {
    if (!requests_.empty()) prepare();
    std::fill(filter_.begin(), filter_.end(), -1);
    for (const std::int32_t landmark : requests_) filter_[hashOf(landmark) % kFilterSize] = landmark;
}

void FieldCache::evictUnused() {
    ++generation_;
    keepWhere([&](std::int32_t slot) { return clock_ - lastUse_[slot] <= kIdleSteps; });
}

void FieldCache::admitRequests(std::int32_t most) {
    admitted_.clear();
    if (requests_.empty()) return;
    for (const std::int32_t landmark : requests_) {
        if (std::cmp_greater_equal(admitted_.size(), most)) break;
        if (use(landmark) >= 0) continue;
        if (count_ >= capacity_) {
            // Eviction moves slots, so it must come before any slot is admitted.
            if (!admitted_.empty()) break;
            evictUnused();
            if (count_ >= capacity_) break;
        }
        const std::int32_t slot = count_++;
        growFields(slot + 1);
        landmark_.push_back(landmark);
        lastUse_.push_back(clock_);
        insert(landmark, slot);
        takeKnown(slot);
        admitted_.push_back(slot);
    }
    requests_.clear();
    std::fill(filter_.begin(), filter_.end(), -1);
}

}  // namespace muster
