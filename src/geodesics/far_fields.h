// Cost fields of landmarks on the coarse ground, for ways that leave the windows.
#pragma once

#include <cstdint>
#include <vector>

#include "cost/static_ground.h"
#include "geodesics/field_lattice.h"
#include "geodesics/landmark_stencil.h"

namespace muster {

/// Landmarks lie on a square lattice, 4, 8, 16 or 32 m apart and for places on slow ground half as far, or on
/// the free cells next to it.
class FarFields {
public:
    FarFields();  ///< None.

    /// Begins a step on this ground for so many places; forgets all where the ground or the spacing has
    /// changed.
    void beginStep(const StaticGround& ground, std::size_t places);
    /// Makes at most `most` of those asked for; true where any was made.
    std::int32_t build(std::int32_t most, ThreadPool& pool);
    /// Makes those named by an archive.
    void rebuild(ThreadPool& pool);
    /// The stencil of a place from the fields there are; asks for those that are missing.
    LandmarkStencil stencil(Vec2 place);
    /// The squared cost by a stencil; infinite where `from` cannot be reached.
    double square(const LandmarkStencil& stencil, Vec2 from) const;
    /// The field in a slot.
    const CostField& field(std::int32_t slot) const { return lattice_.field(slot); }
    /// Fields kept.
    std::int32_t count() const { return lattice_.count(); }

    /// Lets an archive read or write which fields there are.
    template <class Archive>
    void visit(Archive& archive) {
        archive(lattice_, spacing_);
    }

private:
    struct Corners {
        std::int32_t cell[4];
        std::int32_t count;
        bool square;
    };
    /// Points so many coarse cells apart.
    struct Lattice {
        std::int32_t spacing = 0;
        std::int32_t width = 0;
        // Landmark of each point: a coarse cell, -1 for none, -2 not looked for.
        std::vector<std::int32_t> moved;

        void reset(const Grid& grid, std::int32_t cells);
    };
    bool slow(Vec2 place) const { return ground_->unitCost(place) > ground_->fine().lowest; }
    Corners cornersOf(Vec2 place, Lattice& lattice) const;
    std::int32_t freeNear(Cell point, Lattice& lattice) const;
    void solve(std::int32_t landmark, CostField& field, EikonalSolver& solver) const;
    double squareWithin(const LandmarkStencil& stencil, Vec2 from) const;
    bool sees(const CostField& field, Vec2 place, double square) const;

    FieldLattice lattice_;
    const StaticGround* ground_ = nullptr;
    std::uint32_t version_ = 0;
    std::int32_t spacing_ = 0;  // [coarse cells]
    Lattice wide_;
    Lattice narrow_;  // For places on slow ground.
    std::vector<EikonalSolver> solvers_;
};

}  // namespace muster
