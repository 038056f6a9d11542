// Cost fields of landmarks on a lattice, made when asked for and kept.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "eikonal/eikonal_solver.h"

namespace muster {

/// Fields by landmark (the index of a cell). A landmark wished for gets its field in the next build(); those
/// not used for long make room for others.
class FieldLattice {
public:
    /// At most `capacity` fields.
    explicit FieldLattice(std::int32_t capacity);
    /// Forgets all fields.
    void clear();
    /// Makes room for so many fields, at most the capacity, of so many cells and roots each.
    void reserve(std::size_t fields, std::size_t cells, std::size_t roots);
    /// Begins a step.
    void beginStep() { ++clock_; }
    /// The slot of a landmark's field, -1 where there is none; it counts as used now.
    std::int32_t use(std::int32_t landmark);
    /// The same without counting as use.
    std::int32_t find(std::int32_t landmark) const;
    /// Asks for a landmark's field.
    void wish(std::int32_t landmark);
    /// Makes at most `most` of the fields wished for, in the order of the wishes, and forgets the other
    /// wishes. `solve(landmark, field, worker)` fills one. Returns how many. None where `most` is 0: wishes
    /// stay then.
    template <class Solve>
    std::int32_t build(std::int32_t most, ThreadPool& pool, const Solve& solve) {
        if (most <= 0) return 0;
        admit(most);
        pool.run(static_cast<std::int32_t>(fresh_.size()), [&](std::int32_t item, std::int32_t worker) {
            const std::int32_t slot = fresh_[item];
            solve(landmark_[slot], fields_[slot], worker);
        });
        return static_cast<std::int32_t>(fresh_.size());
    }
    /// Fills all fields anew, after load() or where the costs have changed.
    template <class Solve>
    void rebuild(ThreadPool& pool, const Solve& solve) {
        pool.run(count_, [&](std::int32_t slot, std::int32_t worker) {
            solve(landmark_[slot], fields_[slot], worker);
        });
    }
    /// The field in a slot.
    const CostField& field(std::int32_t slot) const { return fields_[slot]; }
    /// The landmark of a slot.
    std::int32_t landmark(std::int32_t slot) const { return landmark_[slot]; }
    /// Grows whenever slots mean other fields than before.
    std::uint32_t generation() const { return generation_; }
    /// Fields held.
    std::int32_t count() const { return count_; }

    /// Lets an archive read or write which fields there are, not the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(clock_, generation_, count_, landmark_, used_, wishes_);
        if constexpr (Archive::kReading) restore(archive);
    }

private:
    template <class Archive>
    void restore(Archive& archive) {
        const auto size = static_cast<std::size_t>(std::max(count_, 0));
        if (count_ < 0 || count_ > capacity_ || landmark_.size() != size || used_.size() != size)
            return archive.fail();
        fields_.resize(std::max(fields_.size(), size));
        rehash();
        refilter();
    }
    void admit(std::int32_t most);
    void makeRoom();
    void rehash();
    void refilter();
    void insert(std::int32_t landmark, std::int32_t slot);
    std::uint32_t home(std::int32_t landmark) const;

    std::int32_t capacity_;
    std::uint32_t clock_ = 0;
    std::uint32_t generation_ = 0;
    std::int32_t count_ = 0;
    std::vector<std::int32_t> landmark_;  // Of each slot.
    std::vector<std::uint32_t> used_;     // Step in which it was last used.
    std::vector<CostField> fields_;       // Of each slot, and memory for later ones.
    std::vector<std::int32_t> table_;     // Slots by landmark, -1 for none: open addressing.
    std::vector<std::int32_t> wishes_;
    std::vector<std::int32_t> filter_;  // Wishes by landmark, so that few are noted twice.
    std::vector<std::int32_t> fresh_;
};

}  // namespace muster
