// Desired directions: straight in line of sight, down a local field near by, towards a visible point of the
// path far away (SPEC A6).
#include <algorithm>

#include "base/infinite_cost.h"
#include "engine/fields/geodesics/geodesics_impl.h"

namespace muster {
namespace {

constexpr std::int32_t kTraceSteps = 10;  // Number of steps along a far path in search of its visible points.
constexpr double kTraceStep = 1.0;        // Length of each step [m].
// Number of these steps in which a landmark behind a corner is searched.
constexpr std::int32_t kLandmarkSteps = 3;
constexpr std::int32_t kMaxHidden = 5;      // Number of successive hidden points after which tracing stops.
constexpr double kMinTargetDistance = 0.9;  // Distance below which a visible point is no target [m].
constexpr double kWallTouch = 0.1;          // Clearance of a character that walks along a wall [m].
// Number of steps for which a target serves, and up to as many more.
constexpr std::uint32_t kTargetSteps = 8;
constexpr std::int32_t kSightPeriod = 4;  // Steps between two tests of the line of sight to a target.
constexpr double kTargetReached = 0.6;    // Distance at which a target is reached [m].
constexpr double kLookAhead = 2.0;        // Length over which headings in a dense crowd are compared [m].
constexpr double kDenseCrowd = 0.05;      // Relative dynamic cost ahead from which other headings are tried.
constexpr double kMinGain = 0.02;         // Cost that another heading must save [m of open ground].
constexpr double kBoundSlack = 1.0 - 1e-5;  // Factor that allows for rounded costs.
// Other headings in a dense crowd: 25, 50 and 75 degrees to either side.
constexpr Rotation kHeadings[] = {{0.90630778703664996, 0.42261826174069944},
                                  {0.64278760968653933, 0.76604444311897804},
                                  {0.25881904510252074, 0.96592582628906831}};
// Alternatives of a target: 3, 6 and 12 degrees to either side.
constexpr Rotation kTargetTurns[] = {{0.99862953475457383, 0.05233595624294383},
                                     {0.99452189536827329, 0.10452846326765347},
                                     {0.97814760073380569, 0.20791169081775934}};

}  // namespace

Guidance Geodesics::guidance(Vec2 from, std::int32_t place, SteeringTarget& target) const {
    Guidance result = impl_->staticGuidance(from, place, target);
    result.direction = impl_->avoidDenseCrowd(from, place, result);
    return result;
}

Guidance Geodesics::Impl::staticGuidance(Vec2 from, std::int32_t place, SteeringTarget& target) const {
    const Vec2 to = places[place];
    // Where many characters get other places at once, the first targets are staggered over several steps;
    // until then the field leads.
    if (target.place != place)
        target = {.point = from,
                  .place = place,
                  .steps = static_cast<std::int32_t>(stagger(place) % kTargetSteps),
                  .after = {},
                  .end = {}};
    const auto farField = [&]() -> const CostField& { return far.field(farStencil[place].nearest); };
    const CostEstimate found = estimate(query(from, place, true));
    Guidance result;
    result.cost = static_cast<float>(found.cost);
    switch (found.source) {
        case CostSource::LineOfSight:
            result.direction = normalized(to - from);
            break;
        case CostSource::RefractedPath:
            result.direction = normalized(found.firstVertex - from);
            break;
        case CostSource::FineFields:
            result.direction = fine.direction(from, place);
            break;
        case CostSource::MiddleFields:
            result.direction = directionToTarget(middle.field(place), place, from, target);
            break;
        case CostSource::FarFields:
            result.direction = directionToTarget(farField(), place, from, target);
            break;
        case CostSource::Route:
        case CostSource::Guess:
            // Whichever field comes first will do, since a character waits for it.
            if (!goesByRoutes(*ground, places.size())) farRequests.add(place);
            result.direction = directionByRoute(query(from, place, true), target);
            break;
    }
    return result;
}

// Traces the path down the field. Notes its last visible point within reach, and the landmark of a local
// field some metres on. Returns true where the point is worth a target.
bool Geodesics::Impl::traceVisiblePoint(const CostField& field, Vec2 from, SteeringTarget& target) const {
    Vec2 at = from;
    bool found = false;
    std::int32_t hidden = 0;
    target.landmark = -1;
    for (std::int32_t k = 0; k < kTraceSteps && hidden < kMaxHidden; ++k) {
        const Vec2 onward = field.direction(at);
        if (onward == Vec2{}) break;
        at += onward * kTraceStep;
        if (k < kLandmarkSteps) target.landmark = fine.fields().landmarkNear(at, target.landmark);
        if (ground->lineOfSight(from, at)) {
            target.point = at;
            found = distance(from, at) > kMinTargetDistance;
            hidden = 0;
        } else {
            ++hidden;
        }
    }
    return found;
}

// Paths down a landmark's field end at the landmark, so that all paths to places round it would coincide. The
// point, turned to either side, from which the place itself is nearest replaces the target.
Vec2 Geodesics::Impl::refinedTarget(Vec2 from, std::int32_t place, Vec2 point) const {
    const auto costFrom = [&](Vec2 p) { return farCost(query(p, place, false)); };
    Vec2 best = point;
    double least = costFrom(point);
    for (const Rotation& turn : kTargetTurns)
        for (const Vec2 p : {from + turn.apply(point - from), from + turn.applyInverse(point - from)}) {
            const double cost = costFrom(p);
            if (!(cost < least) || !ground->lineOfSight(from, p)) continue;
            least = cost;
            best = p;
        }
    return best;
}

// The direction to the visible point of the path; where there is none, down the local field of a landmark
// behind the corner.
Vec2 Geodesics::Impl::directionToTarget(const CostField& field, std::int32_t place, Vec2 from,
                                        SteeringTarget& target) const {
    // The target of a route serves for longer.
    target.steps = std::min(target.steps, 2 * static_cast<std::int32_t>(kTargetSteps));
    const bool checksSight = target.steps % kSightPeriod == 0;
    const bool valid = target.inSight && distance(from, target.point) > kTargetReached &&
                       (!checksSight || ground->lineOfSight(from, target.point));
    if (target.steps <= 0 || (target.inSight && !valid)) {
        const bool seesPlace = ground->lineOfSight(from, places[place]);
        if (seesPlace) target.point = places[place];
        target.inSight = seesPlace || traceVisiblePoint(field, from, target);
        if (!seesPlace && target.inSight && farStencil[place].count > 0)
            target.point = refinedTarget(from, place, target.point);
        // The number of steps varies, so that rows of characters do not trace in the same step.
        target.steps = kTargetSteps + static_cast<std::int32_t>(stagger(place) % kTargetSteps);
    }
    --target.steps;
    if (target.inSight) return normalized(target.point - from);
    const std::int32_t slot = target.landmark >= 0 ? fine.fields().find(target.landmark) : -1;
    const Vec2 direction = slot >= 0 ? fine.fields().field(slot).direction(from) : Vec2{};
    return direction == Vec2{} ? slideAlongWall(from, field.direction(from)) : direction;
}

// A direction of the coarse ground may lead into a wall; its part along the wall remains.
Vec2 Geodesics::Impl::slideAlongWall(Vec2 from, Vec2 direction) const {
    if (ground->interpolatedClearance(from) > kWallTouch) return direction;
    const double edge = ground->grid().cell;
    const Vec2 gradient{ground->interpolatedClearance(from + Vec2{edge, 0.0}) -
                            ground->interpolatedClearance(from - Vec2{edge, 0.0}),
                        ground->interpolatedClearance(from + Vec2{0.0, edge}) -
                            ground->interpolatedClearance(from - Vec2{0.0, edge})};
    const Vec2 normal = normalized(gradient);
    const double into = dot(direction, normal);
    return into < 0.0 ? normalized(direction - normal * into, perpendicular(normal)) : direction;
}

// Where the crowd ahead is dense, takes the best of a few headings: by the cost of the first metres, and of
// the path on from there.
Vec2 Geodesics::Impl::avoidDenseCrowd(Vec2 from, std::int32_t place, const Guidance& guidance) const {
    const Vec2 direction = guidance.direction;
    if (dynamicCost->empty() || direction == Vec2{} || guidance.cost < 2.0 * kLookAhead) return direction;
    const double unitCost = ground->unitCost(from);
    // The cost by a heading; infinite where it cannot be less than `most`.
    const auto costBy = [&](Vec2 heading, double most) {
        const Vec2 next = from + heading * kLookAhead;
        const double onward = dynamicCost->hasNegativeCost()
                                  ? -kInfiniteCost
                                  : kBoundSlack * ground->lowestUnitCost() * distance(next, places[place]);
        if (unitCost * kLookAhead + onward >= most || !ground->lineOfSight(from, next)) return kInfiniteCost;
        const double first = unitCost * (kLookAhead + dynamicCost->relativeAlong(from, next));
        return first + onward >= most ? kInfiniteCost : first + cost(next, place);
    };
    if (dynamicCost->relativeAlong(from, from + direction * kLookAhead) < kDenseCrowd * kLookAhead)
        return direction;
    Vec2 best = direction;
    double least = costBy(best, kInfiniteCost) - kMinGain;
    for (const Rotation& turn : kHeadings)
        for (const Vec2 heading : {turn.apply(direction), turn.applyInverse(direction)}) {
            const double cost = costBy(heading, least);
            if (!(cost < least)) continue;
            least = cost;
            best = heading;
        }
    return best;
}

}  // namespace muster
