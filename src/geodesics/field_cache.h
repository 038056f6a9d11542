// Cache of landmark fields: cost fields made on request, and evicted when long unused.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "eikonal/cost_field.h"

namespace muster {

/// Cost fields by landmark (the index of a cell), found by open addressing. A requested landmark gets its
/// field in the next solveRequested(). At capacity the fields that nobody has used for some seconds are
/// evicted.
class FieldCache {
public:
    /// Holds at most `capacity` fields.
    explicit FieldCache(std::int32_t capacity);
    /// Drops all fields and requests.
    void clear();
    /// Allocates memory for so many fields, at most the capacity, of so many cells and pseudo-sources each.
    void reserve(std::size_t fields, std::size_t cells, std::size_t pseudoSources);
    /// Begins a step.
    void beginStep() { ++clock_; }
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
        pool.run(static_cast<std::int32_t>(admitted_.size()), [&](std::int32_t item, std::int32_t worker) {
            const std::int32_t slot = admitted_[item];
            solve(landmark_[slot], fields_[slot], worker);
        });
        return static_cast<std::int32_t>(admitted_.size());
    }
    /// Solves all fields again: after an archive was read, or where the costs have changed.
    template <class Solve>
    void solveAll(ThreadPool& pool, const Solve& solve) {
        pool.run(count_, [&](std::int32_t slot, std::int32_t worker) {
            solve(landmark_[slot], fields_[slot], worker);
        });
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
        fields_.resize(std::max(fields_.size(), landmark_.size()));
        rebuildTable();
        rebuildFilter();
    }
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
    std::vector<std::int32_t> landmark_;  // Of each slot.
    std::vector<std::uint32_t> lastUse_;  // Of each slot: the step in which it was last used.
    std::vector<CostField> fields_;  // Of each slot; fields beyond `count_` keep their memory for later ones.
    std::vector<std::int32_t> table_;     // Hash table: slots by landmark, -1 for none.
    std::vector<std::int32_t> requests_;  // Landmarks, in the order of the requests.
    std::vector<std::int32_t> filter_;  // Last request of each hash, so that few landmarks are listed twice.
    std::vector<std::int32_t> admitted_;  // Slots of the fields to be solved now.
};

}  // namespace muster
