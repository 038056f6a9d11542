// Which way to walk by the fields of the exact plan (SPEC A6).
#include <cmath>
#include <limits>

#include "planning/exact/exact_plan.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Taken off the radius before asking for a clear line, so that a character that touches a wall may walk along
// it [m].
constexpr double kHair = 0.01;

}  // namespace

void ExactPlan::guide(const GuidanceInput& input, ThreadPool&, std::span<Vec2> direction,
                      std::span<double> cost) {
    MUSTER_ASSERT(input.place.size() == input.characters.size() &&
                  direction.size() == input.characters.size() && cost.size() == input.characters.size());
    for (std::size_t i = 0; i < input.characters.size(); ++i) {
        Heading heading{{0.0, 0.0}, kInfinite};
        const std::int32_t place = input.place[i];
        if (place >= 0 && static_cast<std::size_t>(place) < input.places.size())
            heading = head(input.characters[i], place, input.places[place], *input.environment,
                           input.directReach);
        direction[i] = heading.direction;
        cost[i] = heading.cost;
    }
}

double ExactPlan::steerRadius() const {
    const double radius = finished_.valid()  ? finished_.cost().radius
                          : pending_.valid() ? pending_.cost().radius
                                             : 0.0;
    return radius > kHair ? radius - kHair : 0.0;
}

ExactPlan::Heading ExactPlan::head(Vec2 p, std::int32_t place, Vec2 placeNow, const Environment& environment,
                                   double direct) const {
    const double away = distance(p, placeNow);
    const Heading straight{normalized(placeNow - p), away};
    const CostField* field = finished_.field(place);
    // The field leads to where the place was. Once nearer to that than the place has moved on, it leads
    // astray.
    const bool passed = field != nullptr &&
                        distance(p, field->source()) < distance(field->source(), placeNow);
    if ((away <= direct || passed) && environment.clearLine(p, placeNow, steerRadius())) return straight;
    if (field == nullptr) return headUnknown(p, nullptr, placeNow, environment);
    const double cost = field->cost(p);
    const Vec2 way = std::isfinite(cost) ? field->direction(p) : Vec2{};
    if (way == Vec2{}) return headUnknown(p, field, placeNow, environment);
    return {way, cost};
}

// Off the ground that the front has marched: straight to the place where nothing is between, else back to the
// front.
ExactPlan::Heading ExactPlan::headUnknown(Vec2 p, const CostField* field, Vec2 placeNow,
                                          const Environment& environment) const {
    if (environment.clearLine(p, placeNow, steerRadius()))
        return {normalized(placeNow - p), distance(p, placeNow)};
    Cell cell;
    if (field == nullptr || !nearestReached(*field, finished_.cost().grid, p, cell))
        return {{0.0, 0.0}, kInfinite};
    const Vec2 to = finished_.cost().grid.centre(cell);
    return {normalized(to - p), static_cast<double>(field->value(cell)) + distance(p, to)};
}

}  // namespace muster
