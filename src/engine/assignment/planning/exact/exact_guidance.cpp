// Guidance by the cost fields of the exact plan (SPEC A6).
#include <cmath>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/assignment/planning/exact/exact_plan.h"

namespace muster {
namespace {

// Length subtracted from the radius of clear lines, so that a character that touches a wall may walk along it
// [m].
constexpr double kTouchTolerance = 0.01;

}  // namespace

void ExactPlan::guide(const GuidanceInput& input, ThreadPool&, std::span<Vec2> direction,
                      std::span<double> cost) {
    MUSTER_ASSERT(input.place.size() == input.characters.size() &&
                  direction.size() == input.characters.size() && cost.size() == input.characters.size());
    for (std::size_t i = 0; i < input.characters.size(); ++i) {
        FieldGuidance guidance{{0.0, 0.0}, kInfiniteCost};
        const std::int32_t place = input.place[i];
        if (place >= 0 && std::cmp_less(place, input.places.size()))
            guidance = guideOne(input.characters[i], place, input.places[place], input.costs->environment(),
                                input.directReach);
        direction[i] = guidance.direction;
        cost[i] = guidance.cost;
    }
}

// Radius for which lines must be clear [m].
double ExactPlan::lineRadius() const {
    const double radius = finished_.valid()  ? finished_.unitCost().radius
                          : pending_.valid() ? pending_.unitCost().radius
                                             : 0.0;
    return radius > kTouchTolerance ? radius - kTouchTolerance : 0.0;
}

ExactPlan::FieldGuidance ExactPlan::guideOne(Vec2 p, std::int32_t place, Vec2 placeNow,
                                             const Environment& environment, double directReach) const {
    const double line = distance(p, placeNow);
    const CostField* field = finished_.field(place);
    // The field leads to the former position of the place. A character that is nearer to it than the place
    // has moved would be led away from the place.
    const bool passed = field != nullptr &&
                        distance(p, field->source()) < distance(field->source(), placeNow);
    if ((line <= directReach || passed) && environment.clearLine(p, placeNow, lineRadius()))
        return {normalized(placeNow - p), line};
    if (field == nullptr) return guideOffField(p, nullptr, placeNow, environment);
    const double cost = field->cost(p);
    const Vec2 direction = std::isfinite(cost) ? field->direction(p) : Vec2{};
    if (direction == Vec2{}) return guideOffField(p, field, placeNow, environment);
    return {direction, cost};
}

// Straight to the place where the line is clear, else back to the field.
ExactPlan::FieldGuidance ExactPlan::guideOffField(Vec2 p, const CostField* field, Vec2 placeNow,
                                                  const Environment& environment) const {
    if (environment.clearLine(p, placeNow, lineRadius()))
        return {normalized(placeNow - p), distance(p, placeNow)};
    const Grid& grid = finished_.unitCost().grid;
    Cell cell;
    if (field == nullptr || !nearestReached(*field, grid, p, cell)) return {{0.0, 0.0}, kInfiniteCost};
    const Vec2 to = grid.centre(cell);
    return {normalized(to - p), static_cast<double>(field->value(cell)) + distance(p, to)};
}

}  // namespace muster
