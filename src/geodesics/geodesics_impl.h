// State of the shortest-path oracle, shared by its sources: geodesics.cpp (fields), cost_estimate.cpp (costs)
// and guidance.cpp (directions).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesics/far_fields.h"
#include "geodesics/field_requests.h"
#include "geodesics/geodesics.h"
#include "geodesics/local_costs.h"

namespace muster {

/// Where a cost comes from.
enum class CostSource {
    FineFields,     ///< Local fields on the ground cells.
    MiddleFields,   ///< Local fields on cells twice as wide.
    FarFields,      ///< Far fields on the coarse ground.
    RefractedPath,  ///< A path over ground of several unit costs without a wall.
    Guess,          ///< A multiple of the straight line's cost, until fields are there.
};

/// A cost with its source, and where its path leads first.
struct CostEstimate {
    double cost;         ///< [m]; infinite where the source does not know.
    CostSource source;   ///< Where the cost comes from.
    Vec2 firstVertex{};  ///< First vertex of a RefractedPath [m].
};

struct Geodesics::Impl {
    /// From this many places on the budgets of fields hold for each kind, and grow in proportion to the
    /// places.
    static constexpr std::int64_t kManyPlaces = 2500;
    /// From this distance on far fields are read first, whether or not there is a line of sight [m].
    static constexpr double kFarDistance = 20.0;

    GeodesicsDef def;
    const StaticGround* ground = nullptr;
    const DynamicCost* dynamicCost = nullptr;
    std::vector<Vec2> places;           // Of this step [m].
    LocalCosts fine;                    // Some metres round places, on the ground cells.
    LocalCosts middle;                  // Twice as far, on cells twice as wide.
    mutable FieldRequests farRequests;  // Added to by const queries, drained by updateFarStencils().
    std::vector<InterpolationStencil> farStencil;  // Per place.
    FarFields far;
    // Per place: 1 where its stencil was made since it was requested.
    std::vector<std::uint8_t> farStencilKnown;
    std::uint32_t step = 0;
    bool loaded = false;  // An archive was read whose fields are not solved yet.

    explicit Impl(const GeodesicsDef& d);

    template <class Archive>
    void visit(Archive& archive) {
        archive(places, farRequests, farStencilKnown, farStencil, step, fine, middle, far);
        if constexpr (Archive::kReading) {
            const std::size_t n = places.size();
            if (fine.places() != n || middle.places() != n || farRequests.size() != n ||
                farStencilKnown.size() != n || farStencil.size() != n)
                archive.fail();
            loaded = true;
        }
    }

    // Fields and requests (geodesics.cpp).
    std::int32_t scaledBudget(std::int32_t budget) const {
        return std::max(budget, static_cast<std::int32_t>(budget * static_cast<std::int64_t>(places.size()) /
                                                          kManyPlaces));
    }
    bool solveRequested(ThreadPool& pool);
    void updateFields(ThreadPool& pool);
    bool farStencilIsDue(std::size_t place) const;
    void updateFarStencils(bool all);
    void requestFields(Vec2 from, std::int32_t place);
    void requestFarWhereUnknown(std::span<const Vec2> from);

    // Costs (cost_estimate.cpp).
    float cost(Vec2 from, std::int32_t place) const;
    float lineOfSightCost(Vec2 from, Vec2 to, double line) const;
    double farCost(Vec2 from, std::int32_t place, double line) const;
    bool costByFarFields(Vec2 from, std::int32_t place, double line, float& cost) const;
    CostEstimate estimate(Vec2 from, std::int32_t place, bool byAssignee, double line) const;
    CostEstimate estimateByFields(Vec2 from, std::int32_t place, bool byAssignee, double line) const;
    CostEstimate estimateRefracted(Vec2 from, std::int32_t place, double line) const;
    CostEstimate orByFarFields(CostEstimate local, Vec2 from, std::int32_t place) const;
    double dynamicCostAtEnds(Vec2 from, Vec2 to, double line) const;

    // Directions (guidance.cpp).
    Guidance staticGuidance(Vec2 from, std::int32_t place, SteeringTarget& target) const;
    Vec2 avoidDenseCrowd(Vec2 from, std::int32_t place, const Guidance& guidance) const;
    Vec2 directionToTarget(const CostField& field, std::int32_t place, Vec2 from,
                           SteeringTarget& target) const;
    bool traceVisiblePoint(const CostField& field, Vec2 from, SteeringTarget& target) const;
    Vec2 refinedTarget(Vec2 from, std::int32_t place, Vec2 point) const;
    Vec2 slideAlongWall(Vec2 from, Vec2 direction) const;
    // A hash that spreads re-evaluations over steps: it differs from place to place and from step to step.
    std::uint32_t stagger(std::int32_t place) const {
        return ((static_cast<std::uint32_t>(place) * 977u + step) * 2654435761u) >> 16;
    }
};

}  // namespace muster
