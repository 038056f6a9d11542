// Untidy priority queue (Yatziv, Bartesaghi and Sapiro 2006): cells in a ring of buckets (Dial 1969), each in
// order of arrival.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "muster/assert.h"

namespace muster {

/// Both indices of a cell of the front.
struct FrontCell {
    std::int32_t cell;  ///< Row-major index in the unit cost.
    std::int32_t node;  ///< Index in the padded arrays of the front.
};

/// A monotone priority queue: keys are not below the bucket that is being emptied; lower ones go into that
/// bucket. Cells beyond the ring wait in a list.
class BucketQueue {
public:
    BucketQueue() : buckets_(kRing) {
        for (auto& bucket : buckets_) bucket.reserve(128);
    }

    /// Empties the queue and sets the width of its buckets to `1 / inverseWidth`.
    void restart(float inverseWidth) {
        for (auto& bucket : buckets_) bucket.clear();
        for (auto& word : used_) word = 0;
        overflow_.clear();
        inverseWidth_ = inverseWidth;
        current_ = 0;
        lowestOverflow_ = kLargest;
    }

    /// The number of the bucket of `key` >= 0; at least 1, as bucket 0 stays empty.
    std::int32_t number(float key) const {
        const float k = key * inverseWidth_;
        return k < static_cast<float>(kLargest) ? static_cast<std::int32_t>(k) + 1 : kLargest;
    }

    /// Adds a cell to the bucket of this number.
    void push(std::int32_t bucket, FrontCell cell) {
        if (bucket < current_) bucket = current_;
        if (bucket - current_ >= kRing) return putOverflow(bucket, cell);
        put(bucket, cell);
    }

    /// Moves on to the next bucket that holds cells; false where there is none.
    bool advance() {
        buckets_[slot(current_)].clear();
        used_[slot(current_) / 64] &= ~(1ull << (slot(current_) % 64));
        std::int32_t next = nextUsed();
        if (next >= lowestOverflow_) {
            if (overflow_.empty()) return false;
            if (next > lowestOverflow_) next = lowestOverflow_;
            current_ = next;
            refill();
        }
        current_ = next;
        return true;
    }

    /// The bucket that is being emptied. It may grow meanwhile, so its size must be read again for every
    /// cell.
    const std::vector<FrontCell>& bucket() const { return buckets_[slot(current_)]; }
    /// The number of that bucket.
    std::int32_t current() const { return current_; }

private:
    static constexpr std::int32_t kRing = 512;  // Number of buckets; a multiple of 64.
    static constexpr std::int32_t kLargest = 1 << 30;

    struct Overflow {
        std::int32_t bucket;
        FrontCell cell;
    };

    static std::uint32_t slot(std::int32_t bucket) { return static_cast<std::uint32_t>(bucket) % kRing; }

    void put(std::int32_t bucket, FrontCell cell) {
        const std::uint32_t at = slot(bucket);
        if (buckets_[at].empty()) used_[at / 64] |= 1ull << (at % 64);
        buckets_[at].push_back(cell);
    }

    void putOverflow(std::int32_t bucket, FrontCell cell) {
        overflow_.push_back({bucket, cell});
        if (bucket < lowestOverflow_) lowestOverflow_ = bucket;
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
        return kLargest;
    }

    // Moves waiting cells that the ring can hold now into it.
    void refill() {
        std::size_t waiting = 0;
        lowestOverflow_ = kLargest;
        for (const Overflow& entry : overflow_) {
            if (entry.bucket - current_ < kRing) {
                put(entry.bucket, entry.cell);
                continue;
            }
            if (entry.bucket < lowestOverflow_) lowestOverflow_ = entry.bucket;
            overflow_[waiting++] = entry;
        }
        overflow_.resize(waiting);
    }

    std::vector<std::vector<FrontCell>> buckets_;
    std::uint64_t used_[kRing / 64] = {};  // One bit per bucket of the ring: whether it holds cells.
    std::vector<Overflow> overflow_;       // Cells beyond the ring.
    float inverseWidth_ = 1.0f;            // Inverse width of a bucket [buckets per key].
    std::int32_t current_ = 0;
    std::int32_t lowestOverflow_ = kLargest;  // Lowest bucket number in overflow_.
};

}  // namespace muster
