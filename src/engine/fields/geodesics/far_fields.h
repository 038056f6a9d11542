// Far fields: cost fields of landmarks over all coarse ground, or over a wide box where that is very large,
// for paths that leave the local fields (landmarks and triangle inequality: Goldberg and Harrelson 2005).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/geodesics/field_cache.h"
#include "engine/fields/geodesics/interpolation_stencil.h"
#include "engine/fields/geodesics/shared_far_fields.h"

namespace muster {

/// Landmarks lie on a square lattice of 4, 8, 16 or 32 m, half as far apart for places on slow ground, or on
/// the nearest free cell. Where the coarse ground is too large for whole fields (StaticGround::hasWideCoarse)
/// each field covers a box round its landmark. Without fields where the ground has no coarse copy.
class FarFields {
public:
    FarFields();  ///< Has no fields yet.

    /// Begins a step on this ground for a number of places; drops the fields that a change of the ground or
    /// of the lattice has made wrong, and returns true if there was one. The ground must outlive the next
    /// call.
    bool beginStep(const StaticGround& ground, std::size_t places);
    /// Allocates memory for the fields that a moving crowd needs on this ground.
    void reserve(const StaticGround& ground);
    /// Solves at most `most` of the requested fields, or takes them from the fields that groups share, where
    /// these are given; returns their number.
    std::int32_t solveRequested(std::int32_t most, ThreadPool& pool, SharedFarFields* shared = nullptr);
    /// Takes over the fields of `before` that an archive named. Call after reading it.
    void keepFieldsOf(FarFields& before);
    /// Sets the ground of the fields that an archive named: that of the archive. Call after keepFieldsOf(),
    /// before the first step.
    void bind(const StaticGround& ground);
    /// Solves the fields that an archive named and keepFieldsOf() did not bring.
    void solveMissing(ThreadPool& pool);
    /// The stencil of a place from the existing fields; requests missing ones.
    InterpolationStencil stencil(Vec2 place);
    /// The squared cost from `from` by a stencil [m^2]; infinite where the place cannot be reached, and
    /// outside the box of one of its fields.
    double squaredCost(const InterpolationStencil& stencil, Vec2 from) const;
    /// The field in a slot.
    const CostField& field(std::int32_t slot) const { return cache_.field(slot); }
    /// Number of fields.
    std::int32_t count() const { return cache_.count(); }
    /// Cells of one field.
    std::int32_t cellsOfField() const;

    /// Lets an archive read or write which fields there are.
    template <class Archive>
    void visit(Archive& archive) {
        archive(cache_, spacing_);
    }

private:
    /// Points of the coarse grid at a spacing.
    struct LandmarkLattice {
        std::int32_t spacing = 0;  // Distance between points [cells].
        std::int32_t width = 0;    // Number of points in a row.
        // The landmark of each point: a coarse cell, -1 for none, -2 for not searched yet.
        std::vector<std::int32_t> landmark;

        void reset(const Grid& grid, std::int32_t cells);
    };
    void resetLattices();
    bool isSlow(Vec2 place) const { return ground_->unitCost(place) > ground_->lowestUnitCost(); }
    LandmarkSquare squareRound(Vec2 place, LandmarkLattice& lattice) const;
    std::int32_t landmarkOf(Cell point, LandmarkLattice& lattice) const;
    /// Working memory of one thread.
    struct Worker {
        EikonalSolver solver;
        UnitCost crop;  // The unit cost in the box of a landmark.
    };
    void growWorkers(const ThreadPool& pool);
    void solve(std::int32_t landmark, CostField& field, Worker& worker) const;
    void solveInBox(std::int32_t landmark, CostField& field, Worker& worker) const;
    bool covers(std::int32_t slot, Vec2 from) const;
    double boundedSquaredCost(const InterpolationStencil& stencil, Vec2 from) const;
    bool nearlyStraight(const CostField& field, Vec2 place, double squaredCost) const;

    FieldCache cache_;
    const StaticGround* ground_ = nullptr;
    std::uint32_t version_ = 0;  // Version of the ground.
    bool kept_ = false;          // True after keepFieldsOf() and before bind().
    std::int32_t spacing_ = 0;   // Distance between the points of lattice_ [cells].
    LandmarkLattice lattice_;
    LandmarkLattice slowLattice_;    // Lattice for places on slow ground.
    std::vector<Worker> workers_;    // Workers, one per thread.
    std::vector<CellRect> changes_;  // Changes of the ground since the last step [ground cells].
};

}  // namespace muster
