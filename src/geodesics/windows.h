// Windows: cost fields of landmarks that reach some cells far.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cost/static_ground.h"
#include "geodesics/field_lattice.h"
#include "geodesics/landmark_stencil.h"

namespace muster {

/// How many and how large.
struct WindowsDef {
    std::int32_t capacity = 6144;  ///< Most windows kept.
    std::int32_t half = 16;        ///< Cells from a window's middle to its rim.
};

/// Slots of windows whose landmarks a place sees.
struct SeenWindows {
    std::array<std::int32_t, 4> slot = {};
    std::int32_t count = 0;

    /// Lets an archive read or write them.
    template <class Archive>
    void visit(Archive& archive) {
        archive(slot, count);
    }
};

/// Landmarks are centres of cells of one level of the ground, spaced by four, two or one cell: the less, the
/// less room there is, so that those round a place see each other.
class Windows {
public:
    explicit Windows(const WindowsDef& def);  ///< None yet.

    /// Begins a step on this ground, which must live until the next; forgets all windows where its version is
    /// another.
    void beginStep(const GroundLevel& ground, std::uint32_t version);
    /// Makes room for the windows that so many places may need while they are led about.
    void reserve(std::size_t places);
    /// Makes at most `most` of those asked for; returns how many.
    std::int32_t build(std::int32_t most, ThreadPool& pool);
    /// Makes those named by an archive.
    void rebuild(ThreadPool& pool);
    /// The windows there are of landmarks in sight of a place, the nearest first; asks for that of the
    /// nearest landmark.
    SeenWindows seen(const StaticGround& still, Vec2 place);
    /// The stencil of a place, where a metre costs `unit`, from the windows there are; asks for those that
    /// are missing.
    LandmarkStencil stencil(Vec2 place, float unit);
    /// The squared cost by a stencil; infinite where `from` lies outside one of the windows.
    double square(const LandmarkStencil& stencil, Vec2 from) const;
    /// The window in a slot.
    const CostField& field(std::int32_t slot) const { return lattice_.field(slot); }
    /// Windows there are.
    std::int32_t count() const { return lattice_.count(); }
    /// Asks for the window of a landmark, or notes that it is used.
    void keep(std::int32_t landmark) {
        if (lattice_.use(landmark) < 0) lattice_.wish(landmark);
    }
    /// The slot of a landmark's window, -1 for none.
    std::int32_t slotOf(std::int32_t landmark) const { return lattice_.find(landmark); }
    /// The free landmark nearest to `p`, of those spaced widest; `other` where there is none.
    std::int32_t landmarkNear(Vec2 p, std::int32_t other) const;
    /// Grows whenever slots mean other windows than before.
    std::uint32_t generation() const { return lattice_.generation(); }
    /// The ground of this step.
    const GroundLevel& ground() const { return *ground_; }
    /// How far points may be from a place, along each axis, to lie in the windows of all its landmarks [m].
    double reach() const { return (def_.half - kWidest - 0.5) * ground_->cost.grid.cell; }

    /// Lets an archive read or write which windows there are.
    template <class Archive>
    void visit(Archive& archive) {
        archive(lattice_);
    }

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
    std::int32_t spacingAt(std::int32_t cell) const;
    Corners cornersOf(Vec2 place, std::int32_t spacing) const;
    void solve(std::int32_t landmark, CostField& field, Worker& worker) const;
    void crop(std::int32_t landmark, UnitCost& cost) const;

    static constexpr std::int32_t kWidest = 4;  // Cells between landmarks.

    WindowsDef def_;
    FieldLattice lattice_;
    const GroundLevel* ground_ = nullptr;
    std::uint32_t version_ = 0;
    std::vector<Worker> workers_;
};

}  // namespace muster
