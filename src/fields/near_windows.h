// Windows: cost fields of landmarks on the fine ground that reach a few metres.
#pragma once

#include <cstdint>
#include <vector>

#include "fields/field_lattice.h"
#include "fields/landmark_stencil.h"
#include "muster/fields/static_ground.h"

namespace muster {

/// Landmarks are centres of ground cells, spaced by four, two or one cell: the less, the less room there is, so that those
/// round a place see each other.
class NearWindows {
public:
    explicit NearWindows(std::int32_t capacity);  ///< Most windows kept.

    /// Begins a step on this ground; forgets all where it has changed.
    void beginStep(const StaticGround& ground);
    /// Makes at most `most` of those asked for.
    void build(std::int32_t most, ThreadPool& pool);
    /// Makes those named by an archive.
    void rebuild(ThreadPool& pool);
    /// The stencil of a place from the windows there are; asks for those that are missing.
    LandmarkStencil stencil(Vec2 place);
    /// The squared cost by a stencil; infinite where `from` lies outside one of the windows.
    double square(const LandmarkStencil& stencil, Vec2 from) const;
    /// The window in a slot.
    const CostField& field(std::int32_t slot) const { return lattice_.field(slot); }
    /// Asks for the window of a landmark, or notes that it is used.
    void keep(std::int32_t landmark) {
        if (lattice_.use(landmark) < 0) lattice_.wish(landmark);
    }
    /// The slot of a landmark's window, -1 for none.
    std::int32_t slotOf(std::int32_t landmark) const { return lattice_.find(landmark); }
    /// The free landmark nearest to `p`, of those spaced widest; `other` where there is none.
    std::int32_t landmarkNear(Vec2 p, std::int32_t other) const;
    /// Windows kept.
    std::int32_t count() const { return lattice_.count(); }

    /// Lets an archive read or write which windows there are.
    template <class Archive>
    void visit(Archive& archive) {
        archive(lattice_);
    }

    static constexpr std::int32_t kHalf = 24;  ///< Cells from a window's middle to its rim.

private:
    /// Working memory of one thread.
    struct Worker {
        EikonalSolver solver;
        UnitCost crop;
    };
    struct Corners {
        std::int32_t cell[4];
        std::int32_t count;
        bool square;
    };
    Corners cornersOf(Vec2 place) const;
    void solve(std::int32_t landmark, CostField& field, Worker& worker) const;
    void crop(std::int32_t landmark, UnitCost& cost) const;

    FieldLattice lattice_;
    const StaticGround* ground_ = nullptr;
    std::uint32_t version_ = 0;
    std::vector<Worker> workers_;
};

}  // namespace muster
