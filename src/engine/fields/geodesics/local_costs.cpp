#include "engine/fields/geodesics/local_costs.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/fields/geodesics/one_vertex_paths.h"

namespace muster {
namespace {

constexpr std::uint32_t kLandmarkPeriod = 4;  // Steps between two searches for the landmarks of a place.
constexpr std::int32_t kMaxCorners = 8;       // Greatest number of corners of a path through a local field.

}  // namespace

void LocalCosts::beginStep(const StaticGround& ground, const GroundLevel& level,
                           const DynamicCost& dynamicCost, std::span<const Vec2> places) {
    ground_ = &ground;
    dynamicCost_ = &dynamicCost;
    places_ = places;
    requests_.resize(places.size());
    assigneeRequests_.resize(places.size());
    stencilRequests_.resize(places.size());
    visible_.resize(places.size());
    stencil_.resize(places.size());
    fields_.beginStep(level);
    if (!ground.open()) fields_.reserve(places.size());
}

// True where the landmarks of a place are searched: places move little, so that places with landmarks take
// turns.
bool LocalCosts::isDue(std::size_t place) const {
    return visible_[place].count == 0 || (stencilRequests_.active(place) && stencil_[place].count < 4) ||
           (step_ + place) % kLandmarkPeriod == 0;
}

void LocalCosts::ageRequests() {
    requests_.age();
    assigneeRequests_.age();
    stencilRequests_.age();
}

void LocalCosts::findLandmarks(std::size_t place, bool fieldsMoved) {
    if (!stencilRequests_.active(place)) stencil_[place].count = 0;
    if (!fieldsMoved && !isDue(place)) return;
    visible_[place] = fields_.visibleLandmarks(*ground_, places_[place]);
    if (stencilRequests_.active(place))
        stencil_[place] = fields_.stencil(places_[place], ground_->unitCost(places_[place]));
}

void LocalCosts::updateLandmarks(bool countsAsStep) {
    if (countsAsStep) ++step_;
    const bool fieldsMoved = generation_ != fields_.generation();
    generation_ = fields_.generation();
    // Fields are solved in the order of their requests: fields for assignees come first.
    bool others = false;
    for (std::size_t j = 0; j < places_.size(); ++j) {
        if (!requests_.active(j))
            visible_[j].count = stencil_[j].count = 0;
        else if (assigneeRequests_.active(j))
            findLandmarks(j, fieldsMoved);
        else
            others = true;
    }
    for (std::size_t j = 0; others && j < places_.size(); ++j)
        if (requests_.active(j) && !assigneeRequests_.active(j)) findLandmarks(j, fieldsMoved);
    if (countsAsStep) ageRequests();
}

// True where all slots that an archive named are slots of fields.
bool LocalCosts::slotsValid() const {
    const auto valid = [&](std::int32_t count, const std::array<std::int32_t, 4>& slots) {
        return count >= 0 && count <= 4 &&
               std::all_of(slots.begin(), slots.begin() + count,
                           [&](std::int32_t slot) { return slot >= 0 && slot < fields_.count(); });
    };
    return std::all_of(visible_.begin(), visible_.end(),
                       [&](const VisibleLandmarks& v) { return valid(v.count, v.slot); }) &&
           std::all_of(stencil_.begin(), stencil_.end(),
                       [&](const InterpolationStencil& s) { return valid(s.count, s.slot); });
}

bool LocalCosts::covers(Vec2 from, std::int32_t place) const {
    const Vec2 off = from - places_[place];
    const double reach = fields_.reach();
    return std::fabs(off.x) < reach && std::fabs(off.y) < reach;
}

void LocalCosts::request(std::int32_t place, bool byAssignee) const {
    requests_.add(place);
    if (byAssignee) assigneeRequests_.add(place);
}

const CostField& LocalCosts::field(std::int32_t place) const {
    return fields_.field(visible_[place].slot[0]);
}

// The dynamic cost along the corners of the path through the field, and on to the place.
double LocalCosts::dynamicCostAlong(const CostField& field, Vec2 from, Vec2 to) const {
    if (dynamicCost_->empty()) return 0.0;
    Vec2 corners[kMaxCorners];
    const std::int32_t count = field.pathCorners(from, corners);
    double sum = 0.0;
    Vec2 at = from;
    for (std::int32_t k = 0; k < count; ++k) {
        sum += dynamicCostBetween(*ground_, *dynamicCost_, at, corners[k]);
        at = corners[k];
    }
    return sum + dynamicCostBetween(*ground_, *dynamicCost_, at, to);
}

double LocalCosts::cost(Vec2 from, std::int32_t place, double line) const {
    if (!known(place)) return kInfiniteCost;
    double fixed = staticCost(from, place);
    if (!(fixed < kInfiniteCost)) return kInfiniteCost;
    fixed = std::max(fixed, fields_.level().lowestUnitCost() * line);
    return fixed + dynamicCostAlong(field(place), from, places_[place]);
}

// The least cost by any of the visible landmarks. A point in a door that is too narrow for the cells to show
// it starts from the free cell next to it.
double LocalCosts::staticCost(Vec2 from, std::int32_t place) const {
    const VisibleLandmarks& visible = visible_[place];
    const GroundLevel& level = fields_.level();
    const Grid& grid = level.grid();
    double toFreeCell = 0.0;
    if (!(field(place).squaredCost(from) < kInfiniteCost)) {
        const std::int32_t cell = level.blocked(grid.index(grid.nearestCell(from))) ? level.freeCellNear(from)
                                                                                    : -1;
        if (cell < 0) return kInfiniteCost;
        const Vec2 out = grid.centre(grid.at(cell));
        toFreeCell = ground_->unitCost(out) * distance(from, out);
        from = out;
    }
    double best = kInfiniteCost;
    for (std::int32_t k = 0; k < visible.count; ++k)
        best = std::min(best, costByCorners(fields_.field(visible.slot[k]), from, places_[place]));
    if (!(best < kInfiniteCost)) best = interpolatedCost(from, place);
    return best + toFreeCell;
}

// The farthest point from `near` towards `far` in line of sight of `from`, by bisection; `near` is taken to
// be.
Vec2 LocalCosts::farthestVisible(Vec2 from, Vec2 near, Vec2 far) const {
    constexpr std::int32_t kBisections = 4;
    double visible = 0.0;
    double step = 0.5;
    for (std::int32_t k = 0; k < kBisections; ++k, step *= 0.5)
        if (ground_->lineOfSight(from, lerp(near, far, visible + step))) visible += step;
    return lerp(near, far, visible);
}

// Length of the path between two points that both see the landmark but not each other: it bends close to the
// boundary of the region that both see.
double LocalCosts::lengthAroundCorner(Vec2 from, Vec2 landmark, Vec2 to) const {
    const Vec2 boundary = farthestVisible(from, landmark, to);
    const Vec2 bend = farthestVisible(to, boundary, from);
    return distance(from, bend) + distance(bend, to);
}

// The cost of the path to the landmark, but from its last corner on to the place. Infinite where the corners
// are not known, and on slow ground.
double LocalCosts::costByCorners(const CostField& field, Vec2 from, Vec2 to) const {
    Vec2 corners[kMaxCorners];
    const std::int32_t count = field.pathCorners(from, corners);
    if (count < 0 || count == kMaxCorners) return kInfiniteCost;
    const Vec2 landmark = field.source();
    const float unitCost = fields_.level().lowestUnitCost();
    if (ground_->unitCost(to) != unitCost || ground_->unitCost(landmark) != unitCost ||
        ground_->unitCost(from) != unitCost)
        return kInfiniteCost;
    if (count == 0) return unitCost * lengthAroundCorner(from, landmark, to);
    const Vec2 last = corners[count - 1];
    return field.cost(from) + unitCost * (distance(last, to) - distance(last, landmark));
}

// Where paths bend at ground of another unit cost there are no corners: squared costs are interpolated
// between the landmarks round the place.
double LocalCosts::interpolatedCost(Vec2 from, std::int32_t place) const {
    stencilRequests_.add(place);
    const InterpolationStencil& stencil = stencil_[place];
    const Vec2 to = places_[place];
    if (stencil.count == 0)
        return field(place).cost(from) + ground_->unitCost(to) * distance(field(place).source(), to);
    const double square = fields_.squaredCost(stencil, from) -
                          interpolationBias(fields_.level().grid(), from, ground_->unitCost(from));
    return square < kInfiniteCost ? std::sqrt(std::max(0.0, square)) : kInfiniteCost;
}

Vec2 LocalCosts::direction(Vec2 from, std::int32_t place) const {
    // Ratio of the distance to the landmark and its distance to the place below which the path to it says
    // nothing of the path to the place.
    constexpr double kNearLandmark = 1.5;
    const CostField& down = field(place);
    const Vec2 to = places_[place];
    if (distance(from, down.source()) < kNearLandmark * distance(down.source(), to))
        return normalized(to - from);
    const GroundLevel& level = fields_.level();
    const Grid& grid = level.grid();
    const std::int32_t cell = down.squaredCost(from) < kInfiniteCost ? -1 : level.freeCellNear(from);
    return cell >= 0 ? normalized(grid.centre(grid.at(cell)) - from) : down.direction(from);
}

}  // namespace muster
