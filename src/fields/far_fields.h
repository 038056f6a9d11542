// Cost fields of landmarks on the coarse ground, for ways that leave the windows.
#pragma once

#include <cstdint>
#include <vector>

#include "fields/field_lattice.h"
#include "fields/landmark_stencil.h"
#include "muster/fields/static_ground.h"

namespace muster {

/// Landmarks lie on a square lattice, 4, 8, 16 or 32 m apart, or on the free cells next to it.
class FarFields {
public:
    FarFields();  ///< None.

    /// Begins a step on this ground for so many places; forgets all where the ground or the spacing has changed.
    void beginStep(const StaticGround& ground, std::size_t places);
    /// Makes at most `most` of those asked for; true where any was made.
    bool build(std::int32_t most, ThreadPool& pool);
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
    Corners cornersOf(Vec2 place);
    std::int32_t freeNear(Cell point);
    bool sees(const CostField& field, Vec2 place) const;

    FieldLattice lattice_;
    const StaticGround* ground_ = nullptr;
    std::uint32_t version_ = 0;
    std::int32_t spacing_ = 0;              // [coarse cells]
    std::vector<std::int32_t> moved_;       // Landmark of each lattice point: a coarse cell, -1 for none, -2 not looked for.
    std::int32_t movedWidth_ = 0;
    std::vector<EikonalSolver> solvers_;
};

}  // namespace muster
