#include "geodesics/window_costs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bilinear.h"
#include "geodesics/asked.h"
#include "geodesics/crowd_detour.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kLookPeriod = 4;  // Steps between two looks for the landmarks of a place.
constexpr std::int32_t kMostCorners = 8;  // Of a way through a window.

}  // namespace

double readingShift(const Grid& grid, Vec2 from, double unit) {
    const BilinearPoint at = bilinearPoint(grid, from);
    const double edge = unit * grid.cell;
    return edge * edge * (at.fx * (1.0 - at.fx) + at.fy * (1.0 - at.fy));
}

void WindowCosts::beginStep(const StaticGround& ground, const GroundLevel& level, const DynamicCost& excess,
                            std::span<const Vec2> places) {
    ground_ = &ground;
    excess_ = &excess;
    places_ = places;
    asked_.resize(places.size(), 0);
    owned_.resize(places.size(), 0);
    mixed_.resize(places.size(), 0);
    seen_.resize(places.size());
    stencil_.resize(places.size());
    windows_.beginStep(level, ground.version());
    if (!ground.open()) windows_.reserve(places.size());
}

// Places move little from step to step: those that have windows look again in turn.
bool WindowCosts::looks(std::size_t place) const {
    return seen_[place].count == 0 || (mixed_[place] > 0 && stencil_[place].count < 4) ||
           (step_ + place) % kLookPeriod == 0;
}

void WindowCosts::tick() {
    for (auto* steps : {&asked_, &owned_, &mixed_})
        for (std::uint8_t& left : *steps) left = static_cast<std::uint8_t>(left - (left > 0 ? 1 : 0));
}

void WindowCosts::look(std::size_t place, bool anew) {
    if (mixed_[place] == 0) stencil_[place].count = 0;
    if (!anew && !looks(place)) return;
    seen_[place] = windows_.seen(*ground_, places_[place]);
    if (mixed_[place] > 0)
        stencil_[place] = windows_.stencil(places_[place], ground_->unitCost(places_[place]));
}

void WindowCosts::findStencils(bool ticks) {
    if (ticks) ++step_;
    const bool anew = generation_ != windows_.generation();
    generation_ = windows_.generation();
    // First for those whom somebody walks to.
    bool others = false;
    for (std::size_t j = 0; j < places_.size(); ++j) {
        if (asked_[j] == 0)
            seen_[j].count = stencil_[j].count = 0;
        else if (owned_[j] > 0)
            look(j, anew);
        else
            others = true;
    }
    for (std::size_t j = 0; others && j < places_.size(); ++j)
        if (asked_[j] > 0 && owned_[j] == 0) look(j, anew);
    if (ticks) tick();
}

// What an archive told of must be there.
bool WindowCosts::slotsFit() const {
    const auto fits = [&](std::int32_t count, const std::array<std::int32_t, 4>& slots) {
        return count >= 0 && count <= 4 &&
               std::all_of(slots.begin(), slots.begin() + count,
                           [&](std::int32_t slot) { return slot >= 0 && slot < windows_.count(); });
    };
    return std::all_of(seen_.begin(), seen_.end(),
                       [&](const SeenWindows& s) { return fits(s.count, s.slot); }) &&
           std::all_of(stencil_.begin(), stencil_.end(),
                       [&](const LandmarkStencil& s) { return fits(s.count, s.slot); });
}

bool WindowCosts::reaches(Vec2 from, std::int32_t place) const {
    const Vec2 off = from - places_[place];
    const double reach = windows_.reach();
    return std::fabs(off.x) < reach && std::fabs(off.y) < reach;
}

void WindowCosts::ask(std::int32_t place, bool owner) const {
    noteAsked(asked_, place);
    if (owner) noteAsked(owned_, place);
}

const CostField& WindowCosts::field(std::int32_t place) const {
    return windows_.field(seen_[place].slot[0]);
}

// The excess along the corners of a way through the field, and on to the place.
double WindowCosts::excessAlong(const CostField& field, Vec2 from, Vec2 to) const {
    if (excess_->empty()) return 0.0;
    Vec2 corners[kMostCorners];
    const std::int32_t count = field.pathCorners(from, corners);
    double sum = 0.0;
    Vec2 at = from;
    for (std::int32_t k = 0; k < count; ++k) {
        sum += excessBetween(*ground_, *excess_, at, corners[k]);
        at = corners[k];
    }
    return sum + excessBetween(*ground_, *excess_, at, to);
}

double WindowCosts::cost(Vec2 from, std::int32_t place, double line) const {
    if (!known(place)) return kInfinite;
    double still = stillCost(from, place);
    if (!(still < kInfinite)) return kInfinite;
    still = std::max(still, windows_.ground().cost.lowest * line);
    return still + excessAlong(field(place), from, places_[place]);
}

// By the best of the landmarks in sight. Whoever stands in a door too narrow for the cells to show it goes by
// the free cell beside it.
double WindowCosts::stillCost(Vec2 from, std::int32_t place) const {
    const SeenWindows& seen = seen_[place];
    const GroundLevel& level = windows_.ground();
    const Grid& grid = level.cost.grid;
    double more = 0.0;
    if (!(field(place).squaredCost(from) < kInfinite)) {
        const std::int32_t cell = level.blocked(grid.index(grid.nearestCell(from))) ? level.freeCellNear(from)
                                                                                    : -1;
        if (cell < 0) return kInfinite;
        const Vec2 out = grid.centre(grid.at(cell));
        more = ground_->unitCost(out) * distance(from, out);
        from = out;
    }
    double best = kInfinite;
    for (std::int32_t k = 0; k < seen.count; ++k)
        best = std::min(best, through(windows_.field(seen.slot[k]), from, places_[place]));
    if (!(best < kInfinite)) best = interpolated(from, place);
    return best + more;
}

// The farthest point on the way from `near` to `far` that can be seen, `near` at least.
Vec2 WindowCosts::lastSeen(Vec2 from, Vec2 near, Vec2 far) const {
    constexpr std::int32_t kHalvings = 4;
    double seen = 0.0;
    double step = 0.5;
    for (std::int32_t k = 0; k < kHalvings; ++k, step *= 0.5)
        if (ground_->lineOfSight(from, lerp(near, far, seen + step))) seen += step;
    return lerp(near, far, seen);
}

// Length of the way between two points that both see the mark but not each other: it bends close to where
// that ends.
double WindowCosts::aroundCorner(Vec2 from, Vec2 mark, Vec2 to) const {
    const Vec2 shown = lastSeen(from, mark, to);
    const Vec2 bend = lastSeen(to, shown, from);
    return distance(from, bend) + distance(bend, to);
}

// The way to the landmark, but from its last corner on to the place. Infinite where the corners are not
// known, and on slow ground.
double WindowCosts::through(const CostField& field, Vec2 from, Vec2 to) const {
    Vec2 corners[kMostCorners];
    const std::int32_t count = field.pathCorners(from, corners);
    if (count < 0 || count == kMostCorners) return kInfinite;
    const Vec2 mark = field.source();
    const float unit = windows_.ground().cost.lowest;
    if (ground_->unitCost(to) != unit || ground_->unitCost(mark) != unit || ground_->unitCost(from) != unit)
        return kInfinite;
    if (count == 0) return unit * aroundCorner(from, mark, to);
    const Vec2 last = corners[count - 1];
    return field.cost(from) + unit * (distance(last, to) - distance(last, mark));
}

// Where ways bend at other ground there are no corners: squares between landmarks round the place.
double WindowCosts::interpolated(Vec2 from, std::int32_t place) const {
    noteAsked(mixed_, place);
    const LandmarkStencil& stencil = stencil_[place];
    const Vec2 to = places_[place];
    if (stencil.count == 0)
        return field(place).cost(from) + ground_->unitCost(to) * distance(field(place).source(), to);
    const double square = windows_.square(stencil, from) -
                          readingShift(windows_.ground().cost.grid, from, ground_->unitCost(from));
    return square < kInfinite ? std::sqrt(std::max(0.0, square)) : kInfinite;
}

Vec2 WindowCosts::direction(Vec2 from, std::int32_t place) const {
    const CostField& down = field(place);
    const Vec2 to = places_[place];
    // Beside the landmark the way to it says nothing of the way to the place.
    if (distance(from, down.source()) < 1.5 * distance(down.source(), to)) return normalized(to - from);
    const GroundLevel& level = windows_.ground();
    const Grid& grid = level.cost.grid;
    const std::int32_t cell = down.squaredCost(from) < kInfinite ? -1 : level.freeCellNear(from);
    return cell >= 0 ? normalized(grid.centre(grid.at(cell)) - from) : down.direction(from);
}

}  // namespace muster
