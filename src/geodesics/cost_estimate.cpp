// Costs by the cheapest source that knows: line of sight, refracted path, local fields, far fields.
#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "geodesics/dynamic_detour.h"
#include "geodesics/geodesics_impl.h"
#include "geodesics/refracted_path.h"

namespace muster {
namespace {

constexpr double kGuessFactor = 1.3;        // Times the straight line's cost: a path that no field knows.
constexpr double kRefractedDistance = 8.0;  // Refracted paths are searched up to this distance [m].
// From this cost of a local path on, as a multiple of the straight line's, one that leaves the local field
// may be cheaper.
constexpr double kDetourFactor = 1.6;
constexpr double
    kMinFarDistance = 5.0;  // Refracted paths shorter than this are not compared with far fields [m].
// A far field must tell less than this times the local cost, since it is off by up to a tenth near slow
// ground.
constexpr double kFarFactor = 0.6;
constexpr double kEndLength = 3.0;  // Of the straight line, at either end of a path of unknown course [m].

}  // namespace

bool Geodesics::lineOfSight(Vec2 from, std::int32_t place) const {
    return impl_->ground->lineOfSight(from, impl_->places[place]);
}

double Geodesics::leastUnitCost() const {
    return impl_->ground->fine().lowest;
}

// A path out of a disc of slow ground crosses at least its radius there.
double Geodesics::lowerBound(Vec2 from, std::int32_t place) const {
    const StaticGround& ground = *impl_->ground;
    const Vec2 to = impl_->places[place];
    const double line = distance(from, to);
    const double lowest = ground.fine().lowest;
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
    const Vec2 to = places[place];
    const double line = distance(from, to);
    float byFar = 0.0f;
    if (costByFarFields(from, place, line, byFar)) return byFar;
    if (ground->lineOfSight(from, to, line)) return lineOfSightCost(from, to, line);
    return static_cast<float>(estimate(from, place, false, line).cost);
}

float Geodesics::Impl::lineOfSightCost(Vec2 from, Vec2 to, double line) const {
    return static_cast<float>(ground->unitCost(to) * line +
                              dynamicCostBetween(*ground, *dynamicCost, from, to, line));
}

double Geodesics::Impl::farCost(Vec2 from, std::int32_t place, double line) const {
    const InterpolationStencil& stencil = farStencil[place];
    if (stencil.count == 0) return kInfiniteCost;
    const double square = far.squaredCost(stencil, from) -
                          interpolationBias(ground->coarse().grid, from, ground->unitCost(from));
    if (!(square < kInfiniteCost)) return kInfiniteCost;
    const double least = ground->fine().lowest * line;
    return std::sqrt(std::max(square, least * least));
}

// Over long distances far fields are cheaper to read than a line of sight, and tell the same where there is
// one.
bool Geodesics::Impl::costByFarFields(Vec2 from, std::int32_t place, double line, float& cost) const {
    if (line < kFarDistance || ground->open()) return false;
    farRequests.add(place);
    const double byFar = farCost(from, place, line);
    cost = static_cast<float>(byFar);
    return byFar < kInfiniteCost;
}

CostEstimate Geodesics::Impl::estimate(Vec2 from, std::int32_t place, bool byAssignee, double line) const {
    const CostEstimate refracted = estimateRefracted(from, place, line);
    const bool found = refracted.source == CostSource::RefractedPath;
    // Between points of different ground that is the path; within slow ground another may lead out and in
    // again.
    if (found && ground->unitCost(from) != ground->unitCost(places[place]))
        return orByFarFields(refracted, from, place);
    const CostEstimate byFields = estimateByFields(from, place, byAssignee, line);
    const bool better = refracted.cost < byFields.cost || byFields.source == CostSource::FarFields ||
                        byFields.source == CostSource::Guess;
    return found && better ? orByFarFields(refracted, from, place) : byFields;
}

// The finest local fields that cover the path; coarser ones where those do not know it.
CostEstimate Geodesics::Impl::estimateByFields(Vec2 from, std::int32_t place, bool byAssignee,
                                               double line) const {
    bool requested = false;  // Local fields that will tell are missing.
    if (fine.covers(from, place)) {
        fine.request(place, byAssignee);
        const double cost = fine.cost(from, place, line);
        if (cost < kInfiniteCost) return orByFarFields({cost, CostSource::FineFields}, from, place);
        requested = !fine.known(place);
    }
    if (middle.covers(from, place)) {
        if (!requested) middle.request(place, byAssignee);
        const double cost = middle.cost(from, place, line);
        if (cost < kInfiniteCost) return orByFarFields({cost, CostSource::MiddleFields}, from, place);
        requested = requested || !middle.known(place);
    }
    // On uniform ground the guess serves until the local fields are there.
    if (!requested || !ground->uniform()) farRequests.add(place);
    const double cost = farCost(from, place, line);
    const double atEnds = dynamicCostAtEnds(from, places[place], line);
    if (cost < kInfiniteCost) return {cost + atEnds, CostSource::FarFields};
    return {kGuessFactor * ground->lineCost(from, places[place]) + atEnds, CostSource::Guess};
}

// Unknown (infinite) on uniform ground, over long distances and behind walls.
CostEstimate Geodesics::Impl::estimateRefracted(Vec2 from, std::int32_t place, double line) const {
    const Vec2 to = places[place];
    if (ground->uniform() || line > kRefractedDistance || !ground->collisionFree(from, to))
        return {kInfiniteCost, CostSource::Guess};
    const RefractedPath path = refractedPath(*ground, from, to);
    double added = dynamicCostBetween(*ground, *dynamicCost, from, path.firstVertex);
    if (!(path.firstVertex == to)) added += dynamicCostBetween(*ground, *dynamicCost, path.firstVertex, to);
    return {path.cost + added, CostSource::RefractedPath, path.firstVertex};
}

// A local field knows no path that leaves it. Through slow ground the local path may cost much more than
// one around; where the far fields know a cheaper path, its cost is used. They are inexact for short paths.
CostEstimate Geodesics::Impl::orByFarFields(CostEstimate local, Vec2 from, std::int32_t place) const {
    const Vec2 to = places[place];
    const double line = distance(from, to);
    const bool refracted = local.source == CostSource::RefractedPath;
    if (ground->uniform() || (refracted && line < kMinFarDistance)) return local;
    const double straight = refracted ? ground->fine().lowest * line : ground->lineCost(from, to);
    if (local.cost <= kDetourFactor * straight) return local;
    farRequests.add(place);
    const double cost = farCost(from, place, line);
    return cost < kFarFactor * local.cost ? CostEstimate{cost, CostSource::FarFields} : local;
}

// The course of a far path is unknown: what moving obstacles add near its ends, as if it led straight there.
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
