// Local fields: cost fields of landmarks within a box round each of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/fields/cost/ground_level.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/geodesics/field_cache.h"
#include "engine/fields/geodesics/interpolation_stencil.h"

namespace muster {

/// Number and size of local fields.
struct LocalFieldsDef {
    std::int32_t capacity = 6144;  ///< Most fields at a time >= 1.
    std::int32_t halfWidth = 16;   ///< Cells from a landmark to the edge of its field >= 5.
};

/// Landmarks in line of sight of a place whose local fields are there.
struct VisibleLandmarks {
    std::array<std::int32_t, 4> slot = {};  ///< Slots of their fields, the nearest landmark first.
    std::int32_t count = 0;                 ///< Number of them.

    /// Lets an archive read or write the landmarks.
    template <class Archive>
    void visit(Archive& archive) {
        archive(slot, count);
    }
};

/// Landmarks are centres of cells of one level of the ground, 4, 2 or 1 cells apart: the smaller the
/// clearance, the closer, so that landmarks round a place are in line of sight of each other.
class LocalFields {
public:
    explicit LocalFields(const LocalFieldsDef& def);  ///< Has no fields yet.

    /// Begins a step on this level of a ground, which must outlive the next call; drops the fields on whose
    /// boxes the ground has changed.
    void beginStep(const GroundLevel& level);
    /// Allocates working memory for fields on this level.
    void warmUp(const GroundLevel& level);
    /// Allocates memory for the fields that a number of places may need while they move.
    void reserve(std::size_t places);
    /// Solves at most `most` of the requested fields; returns their number.
    std::int32_t solveRequested(std::int32_t most, ThreadPool& pool);
    /// Takes over the fields of `before` that an archive named. Call after reading it.
    void keepFieldsOf(LocalFields& before);
    /// Sets the ground of the fields that an archive named: that of the archive. Call after keepFieldsOf(),
    /// before the first step.
    void bind(const GroundLevel& level);
    /// Solves the fields that an archive named and keepFieldsOf() did not bring.
    void solveMissing(ThreadPool& pool);
    /// The landmarks in line of sight of a place whose fields are there; requests the field of the nearest
    /// landmark.
    VisibleLandmarks visibleLandmarks(const StaticGround& ground, Vec2 place);
    /// The stencil of a place on ground of this unit cost, from the existing fields; requests missing ones.
    InterpolationStencil stencil(Vec2 place, float unitCost);
    /// The squared cost from `from` by a stencil [m^2]; infinite where `from` lies outside one of its fields.
    double squaredCost(const InterpolationStencil& stencil, Vec2 from) const;
    /// The field in a slot.
    const CostField& field(std::int32_t slot) const { return cache_.field(slot); }
    /// Number of fields.
    std::int32_t count() const { return cache_.count(); }
    /// Marks the field of a landmark as used, or requests it.
    void retain(std::int32_t landmark) {
        if (cache_.use(landmark) < 0) cache_.request(landmark);
    }
    /// The slot of a landmark's field, -1 for none.
    std::int32_t find(std::int32_t landmark) const { return cache_.find(landmark); }
    /// The free landmark nearest to `p` on the lattice of the widest spacing; `fallback` where there is none.
    std::int32_t landmarkNear(Vec2 p, std::int32_t fallback) const;
    /// Changes whenever a slot holds another field than before.
    std::uint32_t generation() const { return cache_.generation(); }
    /// The level of the ground in this step.
    const GroundLevel& level() const { return *level_; }
    /// Distance along each axis up to which a point near a place lies in the fields of all landmarks round it
    /// [m].
    double reach() const { return (def_.halfWidth - kWidestSpacing - 0.5) * level_->grid().cell; }

    /// Lets an archive read or write which fields there are.
    template <class Archive>
    void visit(Archive& archive) {
        archive(cache_);
    }

private:
    /// Working memory of one thread.
    struct Worker {
        EikonalSolver solver;
        UnitCost crop;  // The unit cost round the landmark.
        GroundLevel::Scratch scratch;
    };
    std::int32_t spacingAt(std::int32_t cell) const;
    LandmarkSquare squareRound(Vec2 place, std::int32_t spacing) const;
    void growWorkers(const ThreadPool& pool);
    void solve(std::int32_t landmark, CostField& field, Worker& worker) const;
    CellRect boxRound(std::int32_t landmark) const;
    void dropChanged();
    bool isChanged(std::int32_t landmark) const;

    static constexpr std::int32_t kWidestSpacing = 4;  // Greatest distance between landmarks [cells].

    LocalFieldsDef def_;
    FieldCache cache_;
    std::optional<GroundLevel> level_;
    std::uint32_t version_ = 0;  // Version of the ground.
    bool kept_ = false;          // True after keepFieldsOf() and before bind().
    std::vector<Worker> workers_;
    bool slow_ = false;              // True if some ground was slow when memory was reserved.
    std::vector<CellRect> changes_;  // Changes of the ground since the last step.
};

}  // namespace muster
