// State of the shortest-path oracle, shared by its sources: geodesics.cpp (fields), cost_estimate.cpp (costs)
// and guidance.cpp (directions).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/fields/geodesics/far_fields.h"
#include "engine/fields/geodesics/field_requests.h"
#include "engine/fields/geodesics/geodesics.h"
#include "engine/fields/geodesics/local_costs.h"
#include "engine/ground/routes/shared_ways.h"

namespace muster {

/// Source of a cost: the links of the chain of sources.
enum class CostSource {
    LineOfSight,    ///< The straight line.
    FineFields,     ///< Local fields on the ground cells.
    MiddleFields,   ///< Local fields on cells twice as wide.
    FarFields,      ///< Far fields on the coarse ground.
    RefractedPath,  ///< A path over ground of several unit costs without a wall.
    Route,          ///< A route that another character near by has found in the graph of routes.
    Guess,          ///< A multiple of the straight line's cost, until fields are there.
};

/// A question to the chain of sources.
struct CostQuery {
    Vec2 from;           ///< Start of the path [m].
    Vec2 to;             ///< Position of the place [m].
    std::int32_t place;  ///< The place.
    double line;         ///< Straight distance [m].
    bool byAssignee;     ///< True if the place belongs to the character that asks.
};

/// A cost with its source, and the begin of its path.
struct CostEstimate {
    double cost;         ///< Cost of the path [m].
    CostSource source;   ///< Source of the cost.
    Vec2 firstVertex{};  ///< First vertex of a RefractedPath [m].
};

struct Geodesics::Impl {
    /// Number of places from which on the budgets of fields hold for each kind, and grow in proportion to the
    /// places.
    static constexpr std::int64_t kManyPlaces = 2500;
    /// Number of places below which one field is solved in a step.
    static constexpr std::size_t kFewPlaces = 500;
    /// Distance from which on known far fields are read first, whether or not there is a line of sight [m].
    static constexpr double kFarDistance = 20.0;
    /// That distance on ground where far fields cover a box: many walk there with many walls between them
    /// [m].
    static constexpr double kFarDistanceInBox = 10.0;

    GeodesicsDef def;
    const StaticGround* ground = nullptr;
    const DynamicCost* dynamicCost = nullptr;
    std::vector<Vec2> places;           // Positions of the places in this step [m].
    LocalCosts fine;                    // Costs within some metres of places, on the ground cells.
    LocalCosts middle;                  // Costs twice as far, on cells twice as wide.
    mutable FieldRequests farRequests;  // Requests from const queries, drained by updateFarStencils().
    std::vector<InterpolationStencil> farStencil;  // Far stencil per place.
    FarFields far;
    // Per place: 1 where its stencil was made since it was requested.
    std::vector<std::uint8_t> farStencilKnown;
    std::uint32_t step = 0;
    // Number of steps in one of which fields are solved, and the step's turn.
    std::uint32_t sharePeriod = 1, shareRank = 0;
    SharedFarFields* sharedFar = nullptr;  // Far fields of all groups; null for none.
    bool hasRoutes = false;                // True if routes are found in every step.
    SharedWays ways;                       // Routes found by findRoutes().
    std::uint32_t nextRoute = 0;           // Character at which the round robin of routes begins.
    bool loaded = false;                   // True if an archive was read whose fields are not solved yet.

    explicit Impl(const GeodesicsDef& d);

    template <class Archive>
    void visit(Archive& archive) {
        archive(places, farRequests, farStencilKnown, farStencil, step, fine, middle, far, ways, nextRoute);
        if constexpr (Archive::kReading) {
            const std::size_t n = places.size();
            if (fine.places() != n || middle.places() != n || farRequests.size() != n ||
                farStencilKnown.size() != n || farStencil.size() != n || !ways.sane())
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
    std::int32_t solveFar(std::int32_t most, ThreadPool& pool) {
        if (goesByRoutes(*ground, places.size())) return 0;
        return far.solveRequested(most, pool, sharedFar);
    }
    void updateFields(ThreadPool& pool);
    bool farStencilIsDue(std::size_t place) const;
    void dropFarStencils();
    void updateFarStencils(bool all);
    void requestFields(Vec2 from, std::int32_t place);
    void requestFarWhereUnknown(std::span<const Vec2> from);

    // Routes (route_guidance.cpp). Small groups on large ground read the box of a far field so seldom, until
    // an edit in it drops it, that routes cost less. These know no unit costs.
    bool goesByRoutes(const StaticGround& on, std::size_t count) const {
        return hasRoutes && count < kFewPlaces && on.hasWideCoarse() && on.uniform();
    }
    bool routeServes(const CostQuery& q, SteeringTarget& target) const;
    std::int64_t findRoute(RouteGraph& routes, Vec2 from, SteeringTarget& target);
    Vec2 directionByRoute(const CostQuery& q, SteeringTarget& target) const;

    // Costs (cost_estimate.cpp).
    double farDistance() const { return ground->hasWideCoarse() ? kFarDistanceInBox : kFarDistance; }
    CostQuery query(Vec2 from, std::int32_t place, bool byAssignee) const {
        return {from, places[place], place, distance(from, places[place]), byAssignee};
    }
    float cost(Vec2 from, std::int32_t place) const;
    CostEstimate estimate(const CostQuery& q) const;
    CostEstimate estimateByFields(const CostQuery& q) const;
    std::optional<CostEstimate> byDistantFields(const CostQuery& q, bool& hidden) const;
    std::optional<CostEstimate> byLineOfSight(const CostQuery& q) const;
    std::optional<CostEstimate> byRefractedPath(const CostQuery& q) const;
    std::optional<CostEstimate> byLocalFields(const LocalCosts& level, CostSource source, const CostQuery& q,
                                              bool& missing) const;
    std::optional<CostEstimate> byFarFields(const CostQuery& q) const;
    std::optional<CostEstimate> byRoute(const CostQuery& q) const;
    CostEstimate guess(const CostQuery& q) const;
    CostEstimate orByFarFields(const CostEstimate& local, const CostQuery& q) const;
    double farCost(const CostQuery& q) const;
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

    // Working memory.
    RouteSearch routeSearch;
    std::vector<Vec2> path;  // Working memory of a path [m].
};

}  // namespace muster
