// A monotone priority queue of cells: a ring of buckets, each in order of arrival.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "muster/assert.h"

namespace muster {

/// A cell with its place in the row-major costs and in the solver's padded arrays.
struct FrontCell {
    std::int32_t cell;  ///< Index in the unit cost.
    std::int32_t node;  ///< Index in the padded arrays.
};

/// Cells by key; keys are never below the bucket that is being emptied (lower ones are put into it). Cells
/// too far ahead for the ring wait in a list.
class BucketQueue {
public:
    BucketQueue() : buckets_(kRing) {
        for (auto& bucket : buckets_) bucket.reserve(32);
    }

    /// Empties the queue; buckets will be `1 / inverseWidth` wide.
    void restart(float inverseWidth) {
        for (auto& bucket : buckets_) bucket.clear();
        for (auto& word : used_) word = 0;
        far_.clear();
        inverseWidth_ = inverseWidth;
        current_ = 0;
        farLowest_ = kFarthest;
    }

    /// The number of the bucket of `key` >= 0; at least 1, as bucket 0 stays empty.
    std::int32_t number(float key) const {
        const float k = key * inverseWidth_;
        return k < static_cast<float>(kFarthest) ? static_cast<std::int32_t>(k) + 1 : kFarthest;
    }

    /// Adds a cell to the bucket of that number.
    void push(std::int32_t bucket, FrontCell cell) {
        if (bucket < current_) bucket = current_;
        if (bucket - current_ >= kRing) return putFar(bucket, cell);
        put(bucket, cell);
    }

    /// Moves on to the next bucket that holds cells; false where there is none.
    bool advance() {
        buckets_[slot(current_)].clear();
        used_[slot(current_) / 64] &= ~(1ull << (slot(current_) % 64));
        std::int32_t next = nextUsed();
        if (next >= farLowest_) {
            if (far_.empty()) return false;
            if (next > farLowest_) next = farLowest_;
            current_ = next;
            recall();
        }
        current_ = next;
        return true;
    }

    /// The bucket being emptied; it may grow meanwhile, so look at its size anew for every cell.
    const std::vector<FrontCell>& bucket() const { return buckets_[slot(current_)]; }
    /// Its number.
    std::int32_t current() const { return current_; }

private:
    static constexpr std::int32_t kRing = 512;  // Buckets; a multiple of 64.
    static constexpr std::int32_t kFarthest = 1 << 30;

    struct Far {
        std::int32_t bucket;
        FrontCell cell;
    };

    static std::uint32_t slot(std::int32_t bucket) { return static_cast<std::uint32_t>(bucket) % kRing; }

    void put(std::int32_t bucket, FrontCell cell) {
        const std::uint32_t at = slot(bucket);
        if (buckets_[at].empty()) used_[at / 64] |= 1ull << (at % 64);
        buckets_[at].push_back(cell);
    }

    void putFar(std::int32_t bucket, FrontCell cell) {
        far_.push_back({bucket, cell});
        if (bucket < farLowest_) farLowest_ = bucket;
    }

    std::int32_t nextUsed() const {
        const std::uint32_t first = slot(current_);
        for (std::uint32_t k = 0; k <= kRing / 64; ++k) {
            std::uint64_t word = used_[(first / 64 + k) % (kRing / 64)];
            if (k == 0) word &= ~0ull << (first % 64);
            if (k == kRing / 64) word &= ~(~0ull << (first % 64));
            if (word != 0)
                return current_ + static_cast<std::int32_t>(64 * k - first % 64) + std::countr_zero(word);
        }
        return kFarthest;
    }

    // Brings the waiting cells that the ring can hold now into it.
    void recall() {
        std::size_t kept = 0;
        farLowest_ = kFarthest;
        for (const Far& far : far_) {
            if (far.bucket - current_ < kRing) {
                put(far.bucket, far.cell);
                continue;
            }
            if (far.bucket < farLowest_) farLowest_ = far.bucket;
            far_[kept++] = far;
        }
        far_.resize(kept);
    }

    std::vector<std::vector<FrontCell>> buckets_;
    std::uint64_t used_[kRing / 64] = {};
    std::vector<Far> far_;
    float inverseWidth_ = 1.0f;
    std::int32_t current_ = 0;
    std::int32_t farLowest_ = kFarthest;
};

}  // namespace muster
