// Costs by the chain of sources: far fields over long distances, line of sight, refracted path, local fields,
// far fields, routes, guess.
#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/fields/geodesics/geodesics_impl.h"
#include "engine/fields/geodesics/one_vertex_paths.h"

namespace muster {
namespace {

constexpr double kGuessFactor = 1.3;  // Factor of the straight line's cost for a path that no field knows.
constexpr double kRefractedDistance = 8.0;  // Distance up to which refracted paths are searched [m].
// Cost of a local path, as a multiple of the straight line's, from which on one that leaves the local field
// may be cheaper.
constexpr double kDetourFactor = 1.6;
// Length below which refracted paths are not compared with far fields [m].
constexpr double kMinFarDistance = 5.0;
// Factor of the local cost below which a far field must be, since it is off by up to a tenth near slow
// ground.
constexpr double kFarFactor = 0.6;
constexpr double kRouteReach = 10.0;  // Distance within which a route serves other characters [m].
// Length of the straight line at either end of a path of unknown course [m].
constexpr double kEndLength = 3.0;

}  // namespace

bool Geodesics::lineOfSight(Vec2 from, std::int32_t place) const {
    return impl_->ground->lineOfSight(from, impl_->places[place]);
}

double Geodesics::leastUnitCost() const {
    return impl_->ground->lowestUnitCost();
}

// A path out of a disc of slow ground crosses at least its radius there.
double Geodesics::lowerBound(Vec2 from, std::int32_t place) const {
    const StaticGround& ground = *impl_->ground;
    const Vec2 to = impl_->places[place];
    const double line = distance(from, to);
    const double lowest = ground.lowestUnitCost();
    if (ground.uniform()) return lowest * line;
    const double atStart = std::clamp(ground.uniformClearance(from), 0.0, line);
    const double atEnd = std::clamp(ground.uniformClearance(to), 0.0, line - atStart);
    return lowest * line + (ground.unitCost(from) - lowest) * atStart +
           (ground.unitCost(to) - lowest) * atEnd;
}

bool Geodesics::hasMovingCost(Vec2 p) const {
    return impl_->dynamicCost->hasMovingCost(p);
}

float Geodesics::cost(Vec2 from, std::int32_t place) const {
    return impl_->cost(from, place);
}

float Geodesics::Impl::cost(Vec2 from, std::int32_t place) const {
    return static_cast<float>(estimate(query(from, place, false)).cost);
}

// Walks down the chain of sources: the first that knows the cost answers. Refracted paths and fields compete,
// and far fields correct both.
CostEstimate Geodesics::Impl::estimate(const CostQuery& q) const {
    bool hidden = false;
    if (const auto found = byDistantFields(q, hidden)) return *found;
    if (!hidden)
        if (const auto found = byLineOfSight(q)) return *found;
    const auto refracted = byRefractedPath(q);
    // Between points of different ground that is the path; within slow ground another may lead out and in
    // again.
    if (refracted && ground->unitCost(q.from) != ground->unitCost(q.to)) return orByFarFields(*refracted, q);
    const CostEstimate byFields = estimateByFields(q);
    const bool local = byFields.source == CostSource::FineFields ||
                       byFields.source == CostSource::MiddleFields;
    const bool better = refracted && (!local || refracted->cost < byFields.cost);
    return better ? orByFarFields(*refracted, q) : byFields;
}

// The estimate of the finest fields that know the path.
CostEstimate Geodesics::Impl::estimateByFields(const CostQuery& q) const {
    bool missing = false;  // Local fields that will know the path are requested.
    if (const auto found = byLocalFields(fine, CostSource::FineFields, q, missing))
        return orByFarFields(*found, q);
    if (const auto found = byLocalFields(middle, CostSource::MiddleFields, q, missing))
        return orByFarFields(*found, q);
    // On uniform ground the guess serves until the local fields are there.
    if (!goesByRoutes(*ground, places.size())) {
        if (!missing || !ground->uniform()) farRequests.add(q.place);
        if (const auto found = byFarFields(q)) return *found;
    }
    if (const auto found = byRoute(q)) return *found;
    return guess(q);
}

// Over long distances far fields are read, which is cheaper than a line of sight and gives the same cost.
// Where there is no field yet a line of sight is looked for first, since a field costs more than many of
// them. The dynamic cost is left out.
std::optional<CostEstimate> Geodesics::Impl::byDistantFields(const CostQuery& q, bool& hidden) const {
    if (goesByRoutes(*ground, places.size()) || ground->open() || q.line < farDistance()) return {};
    const double cost = farCost(q);
    const bool known = cost < kInfiniteCost;
    if (!known && ground->lineOfSight(q.from, q.to, q.line))
        return CostEstimate{ground->unitCost(q.to) * q.line, CostSource::LineOfSight};
    farRequests.add(q.place);
    hidden = !known;
    if (!known) return {};
    return CostEstimate{cost, CostSource::FarFields};
}

std::optional<CostEstimate> Geodesics::Impl::byLineOfSight(const CostQuery& q) const {
    if (!ground->lineOfSight(q.from, q.to, q.line)) return {};
    const double cost = ground->unitCost(q.to) * q.line +
                        dynamicCostBetween(*ground, *dynamicCost, q.from, q.to, q.line);
    return CostEstimate{cost, CostSource::LineOfSight};
}

// The estimate of a refracted path: on ground of several unit costs, over short distances and without a wall
// in between.
std::optional<CostEstimate> Geodesics::Impl::byRefractedPath(const CostQuery& q) const {
    if (ground->uniform() || q.line > kRefractedDistance || !ground->collisionFree(q.from, q.to)) return {};
    const RefractedPath refracted = refractedPath(*ground, q.from, q.to);
    const Vec2 vertex = refracted.firstVertex;
    double added = dynamicCostBetween(*ground, *dynamicCost, q.from, vertex);
    if (!(vertex == q.to)) added += dynamicCostBetween(*ground, *dynamicCost, vertex, q.to);
    return CostEstimate{refracted.cost + added, CostSource::RefractedPath, vertex};
}

// Requests the fields of one level where they cover the path and no finer ones are on their way.
std::optional<CostEstimate> Geodesics::Impl::byLocalFields(const LocalCosts& level, CostSource source,
                                                           const CostQuery& q, bool& missing) const {
    if (!level.covers(q.from, q.place)) return {};
    if (!missing) level.request(q.place, q.byAssignee);
    const double cost = level.cost(q.from, q.place, q.line);
    if (cost < kInfiniteCost) return CostEstimate{cost, source};
    missing = missing || !level.known(q.place);
    return {};
}

std::optional<CostEstimate> Geodesics::Impl::byFarFields(const CostQuery& q) const {
    const double cost = farCost(q);
    if (!(cost < kInfiniteCost)) return {};
    return CostEstimate{cost + dynamicCostAtEnds(q.from, q.to, q.line), CostSource::FarFields};
}

// The estimate along a known route that passes near both ends.
std::optional<CostEstimate> Geodesics::Impl::byRoute(const CostQuery& q) const {
    const double length = ways.lengthAlong(q.from, q.to, kRouteReach);
    if (!(length < kInfiniteCost)) return {};
    return CostEstimate{ground->lowestUnitCost() * length + dynamicCostAtEnds(q.from, q.to, q.line),
                        CostSource::Route};
}

CostEstimate Geodesics::Impl::guess(const CostQuery& q) const {
    return {kGuessFactor * ground->lineCost(q.from, q.to) + dynamicCostAtEnds(q.from, q.to, q.line),
            CostSource::Guess};
}

double Geodesics::Impl::farCost(const CostQuery& q) const {
    const InterpolationStencil& stencil = farStencil[q.place];
    if (stencil.count == 0) return kInfiniteCost;
    const double square = far.squaredCost(stencil, q.from) -
                          interpolationBias(ground->coarse().grid, q.from, ground->unitCost(q.from));
    if (!(square < kInfiniteCost)) return kInfiniteCost;
    const double least = ground->lowestUnitCost() * q.line;
    return std::sqrt(std::max(square, least * least));
}

// A local field knows no path that leaves it. Through slow ground the local path may cost much more than
// one around; where the far fields know a cheaper path, its cost is used. They are inexact for short paths.
CostEstimate Geodesics::Impl::orByFarFields(const CostEstimate& local, const CostQuery& q) const {
    const bool refracted = local.source == CostSource::RefractedPath;
    if (ground->uniform() || (refracted && q.line < kMinFarDistance)) return local;
    const double straight = refracted ? ground->lowestUnitCost() * q.line : ground->lineCost(q.from, q.to);
    if (local.cost <= kDetourFactor * straight) return local;
    farRequests.add(q.place);
    const double cost = farCost(q);
    return cost < kFarFactor * local.cost ? CostEstimate{cost, CostSource::FarFields} : local;
}

// The dynamic cost near both ends of a far path, as if it led straight there, since its course is unknown.
double Geodesics::Impl::dynamicCostAtEnds(Vec2 from, Vec2 to, double line) const {
    const double fraction = std::min(1.0, kEndLength / line);
    const auto hasMovingCost = [&](Vec2 end, Vec2 onward) {
        const Vec2 until = lerp(end, onward, fraction);
        return dynamicCost->movingCostCentroid(end, until, distance(end, until)) >= 0.0;
    };
    double sum = 0.0;
    if (hasMovingCost(from, to))
        sum += dynamicCostBetween(*ground, *dynamicCost, from, lerp(from, to, fraction));
    if (fraction < 1.0 && hasMovingCost(to, from))
        sum += dynamicCostBetween(*ground, *dynamicCost, lerp(to, from, fraction), to);
    return sum;
}

}  // namespace muster
