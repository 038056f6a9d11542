// Cache of landmark fields: cost fields made on request, and evicted when long unused.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "engine/fields/eikonal/cost_field.h"

namespace muster {

/// Cost fields by landmark (the index of a cell), found by open addressing. A requested landmark gets its
/// field in the next solveRequested(). At capacity the fields that nobody has used for some seconds are
/// evicted. A field that was evicted, or that a rewound world had later, is not solved again: it counts as
/// solved and is taken from where it lies, as long as the ground is the same.
class FieldCache {
public:
    /// Holds at most `capacity` fields.
    explicit FieldCache(std::int32_t capacity);
    /// Drops all fields and requests.
    void clear();
    /// Allocates memory for `fields` fields, at most the capacity, of `cells` cells and `pseudoSources`
    /// pseudo-sources each.
    void reserve(std::size_t fields, std::size_t cells, std::size_t pseudoSources);
    /// Drops the fields and requests of landmarks for which `isBad(landmark)`.
    template <class IsBad>
    void drop(const IsBad& isBad) {
        const std::int32_t before = count_;
        keepWhere([&](std::int32_t slot) { return !isBad(landmark_[slot]); });
        if (count_ != before) ++generation_;
        for (std::int32_t& landmark : holds_)
            if (landmark >= 0 && isBad(landmark)) landmark = -1;
        std::erase_if(requests_, isBad);
        rebuildFilter();
    }
    /// Begins a step.
    void beginStep() { ++clock_; }
    /// True after the first step.
    bool begun() const { return clock_ > 0; }
    /// The slot of a landmark's field, -1 where there is none; marks the field as used in this step.
    std::int32_t use(std::int32_t landmark);
    /// The slot of a landmark's field, -1 where there is none.
    std::int32_t find(std::int32_t landmark) const;
    /// Requests the field of a landmark.
    void request(std::int32_t landmark);
    /// Solves at most `most` of the requested fields, in the order of the requests, and drops the other
    /// requests. `solve(landmark, field, worker)` fills one field. Returns the number of fields solved. Where
    /// `most` is 0 nothing happens and all requests stay.
    template <class Solve>
    std::int32_t solveRequested(std::int32_t most, ThreadPool& pool, const Solve& solve) {
        if (most <= 0) return 0;
        admitRequests(most);
        pool.run(static_cast<std::int32_t>(admitted_.size()),
                 [&](std::int32_t item, std::int32_t worker) { solveSlot(admitted_[item], worker, solve); });
        return static_cast<std::int32_t>(admitted_.size());
    }
    /// Solves the fields that an archive named and keepFieldsOf() did not bring.
    template <class Solve>
    void solveMissing(ThreadPool& pool, const Solve& solve) {
        pool.run(static_cast<std::int32_t>(missing_.size()),
                 [&](std::int32_t item, std::int32_t worker) { solveSlot(missing_[item], worker, solve); });
        missing_.clear();
    }
    /// Takes from `before` the fields of the landmarks that an archive named, and its other fields for later;
    /// both are of one ground.
    void keepFieldsOf(FieldCache& before);
    /// Marks the fields of landmarks for which `isLost(landmark)` as missing, whatever was kept: the ground
    /// is another.
    template <class IsLost>
    void loseFields(const IsLost& isLost) {
        std::size_t next = 0;  // Index in missing_, whose slots ascend.
        const std::vector<std::int32_t> before = std::exchange(missing_, {});
        for (std::int32_t slot = 0; slot < count_; ++slot) {
            const bool missing = next < before.size() && before[next] == slot;
            next += missing ? 1 : 0;
            if (missing || isLost(landmark_[slot])) missing_.push_back(slot);
        }
        for (std::int32_t& landmark : holds_)
            if (landmark >= 0 && isLost(landmark)) landmark = -1;
    }
    /// The field in a slot.
    const CostField& field(std::int32_t slot) const { return fields_[slot]; }
    /// The landmark of the field in a slot.
    std::int32_t landmark(std::int32_t slot) const { return landmark_[slot]; }
    /// Changes whenever a slot holds another field than before.
    std::uint32_t generation() const { return generation_; }
    /// Number of fields.
    std::int32_t count() const { return count_; }

    /// Lets an archive read or write which fields there are, but not the fields themselves.
    template <class Archive>
    void visit(Archive& archive) {
        archive(clock_, generation_, count_, landmark_, lastUse_, requests_);
        if constexpr (Archive::kReading) restore(archive);
    }

private:
    template <class Archive>
    void restore(Archive& archive) {
        if (count_ < 0 || count_ > capacity_ || !std::cmp_equal(landmark_.size(), count_) ||
            !std::cmp_equal(lastUse_.size(), count_))
            return archive.fail();
        growFields(landmark_.size());
        rebuildTable();
        rebuildFilter();
        missing_.clear();
        loseFields([](std::int32_t) { return true; });
    }
    // Drops the slots that are not kept; the others move together.
    template <class Keeps>
    void keepWhere(const Keeps& keeps) {
        std::int32_t remaining = 0;
        // Indices in missing_, whose slots ascend: the next slot, and the slots that stay.
        std::size_t next = 0, missing = 0;
        for (std::int32_t slot = 0; slot < count_; ++slot) {
            const bool isMissing = next < missing_.size() && missing_[next] == slot;
            next += isMissing ? 1 : 0;
            if (!keeps(slot)) continue;
            if (isMissing) missing_[missing++] = remaining;
            if (remaining != slot) {
                landmark_[remaining] = landmark_[slot];
                lastUse_[remaining] = lastUse_[slot];
                swapFields(remaining, slot);
            }
            ++remaining;
        }
        missing_.resize(missing);
        if (remaining == count_) return;
        count_ = remaining;
        landmark_.resize(remaining);
        lastUse_.resize(remaining);
        rebuildTable();
    }
    // Fills a slot, where it does not hold the field already.
    template <class Solve>
    void solveSlot(std::int32_t slot, std::int32_t worker, const Solve& solve) {
        if (holds_[slot] == landmark_[slot]) return;
        solve(landmark_[slot], fields_[slot], worker);
        holds_[slot] = landmark_[slot];
    }
    void growFields(std::size_t count) {
        fields_.resize(std::max(fields_.size(), count));
        holds_.resize(fields_.size(), -1);
    }
    void swapFields(std::size_t a, std::size_t b) {
        std::swap(fields_[a], fields_[b]);
        std::swap(holds_[a], holds_[b]);
    }
    void prepare();
    void takeKnown(std::int32_t slot);
    void admitRequests(std::int32_t most);
    void evictUnused();
    void rebuildTable();
    void rebuildFilter();
    void insert(std::int32_t landmark, std::int32_t slot);
    std::uint32_t hashOf(std::int32_t landmark) const;

    std::int32_t capacity_;
    std::uint32_t clock_ = 0;  // Number of the step.
    std::uint32_t generation_ = 0;
    std::int32_t count_ = 0;
    std::vector<std::int32_t> landmark_;  // Landmark of each slot.
    std::vector<std::uint32_t> lastUse_;  // Step in which each slot was last used.
    // Field of each slot; fields beyond `count_` keep their memory for later ones.
    std::vector<CostField> fields_;
    std::vector<std::int32_t> holds_;  // Landmark to which each of fields_ belongs on this ground; -1: none.
    std::vector<std::int32_t> table_;  // Hash table: slots by landmark, -1 for none.
    std::vector<std::int32_t> requests_;  // Landmarks, in the order of the requests.
    std::vector<std::int32_t> filter_;   // Last request of each hash, so that few landmarks are listed twice.
    std::vector<std::int32_t> missing_;  // Slots whose fields an archive named and nobody solved since.
    std::vector<std::int32_t> admitted_;  // Slots of the fields to be solved now.
};

}  // namespace muster
