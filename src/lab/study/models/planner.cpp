#include "lab/study/models/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/maths.h"

namespace muster {

namespace {

// Radius of a crowd that gathers, over the root of its number of characters [m].
constexpr double kPackedRadius = 0.28;
// Shapes of divisions: columns and rows.
constexpr std::array<std::array<std::int32_t, 2>, 9> kDivisions{
    {{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 3}, {2, 2}, {4, 1}, {1, 4}, {3, 2}}};
// Ratio of a formation's width to that of a square above which it is wide.
constexpr double kWideRatio = 1.4;
constexpr std::size_t kFetchers = 4;  // Number of characters that are sent to fetch the left-overs.
// Length by which a formation may be pushed together at the border [m].
constexpr double kMostPushedLength = 1.0;
constexpr double kPushedSeconds = 15.0;  // Expected cost of a formation that is pushed together by more [s].

}  // namespace

SeenPart seenPart(std::vector<std::uint32_t> ids, std::vector<Vec2> positions) {
    SeenPart part{std::move(ids), std::move(positions), {}, {}};
    if (part.positions.empty()) return part;
    part.bounds = {part.positions[0], part.positions[0]};
    for (const Vec2 p : part.positions) {
        part.centre += p / static_cast<double>(part.positions.size());
        part.bounds.min = {std::min(part.bounds.min.x, p.x), std::min(part.bounds.min.y, p.y)};
        part.bounds.max = {std::max(part.bounds.max.x, p.x), std::max(part.bounds.max.y, p.y)};
    }
    return part;
}

Planner::Planner(const PlannerDef& def, const TourFinder& tours, const Motor& motor)
    : def_(def), tours_(&tours), motor_(&motor) {}

Sweep Planner::sweepOf(const SeenPart& part) const {
    Sweep sweep{.reach = def_.itemRadius};
    const std::size_t n = part.positions.size();
    if (def_.repertoire.keepsShape) {
        for (const Vec2 p : part.positions) sweep.offsets.push_back(p - part.centre);
    } else {
        // Packed as a disc, by the sunflower's angle.
        for (std::size_t i = 0; i < n; ++i) {
            const double r = kPackedRadius * std::sqrt(static_cast<double>(i) + 0.5);
            const double angle = 2.399963229728653 * static_cast<double>(i);
            sweep.offsets.push_back({r * cosine(angle), r * sine(angle)});
        }
    }
    for (const Vec2 offset : sweep.offsets)
        if (lengthSquared(offset) < lengthSquared(sweep.aim) || sweep.aim == Vec2{}) sweep.aim = offset;
    return sweep;
}

// The point to which the middle of a part goes so that one of its characters stands on an item: that of the
// aimed offset, or the nearest one, unless the border holds its character off the item.
Vec2 Planner::aimedAt(Vec2 from, Vec2 item, const Sweep& sweep) const {
    Vec2 best = def_.border.clamp(item - sweep.aim);
    double least = distance(from, best);
    for (const Vec2 offset : sweep.offsets) {
        const Vec2 to = def_.border.clamp(item - offset);
        if (distance(from, to) >= least || distance(to + offset, item) > 0.5 * sweep.reach) continue;
        least = distance(from, to);
        best = to;
    }
    return best;
}

// The way over these stops.
std::vector<Vec2> Planner::wayOver(Vec2 from, std::span<const std::int32_t> stops, const Sweep& sweep) const {
    std::vector<Vec2> way;
    for (const std::int32_t stop : stops) {
        const Vec2 item = tours_->items()[stop];
        const bool ends = def_.repertoire.draws && &stop == &stops.back();
        const Vec2 to = ends ? aimedAt(from, item, sweep) : def_.border.clamp(item - sweep.aim);
        if (def_.repertoire.draws)
            tours_->ground().appendWay(from, to, way);
        else
            way.push_back(to);
        from = to;
    }
    return way;
}

// Leads a part over items in this order, except for those that it sweeps up beside its way.
void Planner::lead(PlannedPart& planned, std::span<const std::int32_t> order) const {
    const Sweep sweep = sweepOf(planned.part);
    const Vec2 centre = planned.part.centre;
    planned.stops = tours_->thinned(centre, order, sweep);
    planned.way = wayOver(centre, planned.stops, sweep);
    if (!def_.repertoire.draws) return;
    // The way differs from that of the middle: an item that it misses becomes a stop as well, and one that
    // lies beside it does not.
    const auto missed = [&](std::int32_t item) { return !collectedOn(planned, sweep, item); };
    planned.stops.assign(order.begin(), order.end());
    planned.way = wayOver(centre, planned.stops, sweep);
    for (std::size_t i = 0; i < planned.stops.size();) {
        const std::vector<std::int32_t> kept = planned.stops;
        planned.stops.erase(planned.stops.begin() + static_cast<std::ptrdiff_t>(i));
        planned.way = wayOver(centre, planned.stops, sweep);
        if (std::none_of(order.begin(), order.end(), missed)) continue;
        planned.stops = kept;
        planned.way = wayOver(centre, planned.stops, sweep);
        ++i;
    }
}

bool Planner::collectedOn(const PlannedPart& planned, const Sweep& sweep, std::int32_t item) const {
    Vec2 at = planned.part.centre;
    for (const Vec2 to : planned.way) {
        if (sweep.collects(at, to, tours_->items()[item])) return true;
        at = to;
    }
    return false;
}

OperatorPlan Planner::plan(const SeenPart& crowd, std::span<const std::int32_t> open, Chance& chance) const {
    const std::vector<std::int32_t> tour = tours_->tour(
        crowd.centre, open, def_.parameters.routeDetour * 2.0 * chance.uniform(), chance);
    OperatorPlan best{.seconds = kInfinite};
    const auto most = static_cast<std::int32_t>(std::floor(def_.parameters.groupsInMind + 0.5));
    const auto consider = [&](OperatorPlan&& plan) {
        if (plan.seconds < best.seconds) best = std::move(plan);
    };
    for (const auto& [columns, rows] : kDivisions) {
        if (columns * rows > most || (columns * rows > 1 && !def_.repertoire.divides)) continue;
        if (std::ssize(crowd.ids) < 2 * columns * rows) continue;
        consider(divided(crowd, tour, columns, rows, chance));
    }
    if (!def_.repertoire.spreads) return best;
    for (const double width : kWidths) {
        if (width > def_.spacing * static_cast<double>(crowd.ids.size())) continue;
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
            consider(swept(crowd, open, along, width));
    }
    if (def_.repertoire.divides && most >= 2 && std::ssize(crowd.ids) >= 4)
        for (const std::int32_t columns : {1, 2})
            for (const double share : {0.35, 0.5, 0.65}) consider(parted(crowd, open, columns, share));
    return best;
}

// Length by which the formation would have to be pushed together at the border on its way [m].
double Planner::beyondBorder(const PlannedPart& planned) const {
    double most = 0.0;
    for (const Vec2 to : planned.way)
        for (const Vec2 p : planned.part.positions) {
            const Vec2 there = to + p - planned.part.centre;
            most = std::max(most, distance(there, def_.border.clamp(there)));
        }
    return most;
}

std::optional<PlannedPart> Planner::fetched(const SeenPart& part, std::span<const std::int32_t> open,
                                            Chance& chance) const {
    if (!def_.repertoire.divides || open.empty() || part.ids.size() <= 2 * kFetchers) return std::nullopt;
    const auto away = [&](std::size_t i, std::int32_t item) {
        return tours_->ground().distance(part.positions[i], tours_->items()[item]);
    };
    std::int32_t nearest = open[0];
    double least = kInfinite;
    for (const std::int32_t item : open)
        for (std::size_t i = 0; i < part.ids.size(); ++i)
            if (away(i, item) < least) {
                least = away(i, item);
                nearest = item;
            }
    std::vector<std::size_t> order(part.ids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return away(a, nearest) < away(b, nearest); });
    order.resize(kFetchers);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return part.ids[a] < part.ids[b]; });
    std::vector<std::uint32_t> ids;
    std::vector<Vec2> positions;
    for (const std::size_t i : order) {
        ids.push_back(part.ids[i]);
        positions.push_back(part.positions[i]);
    }
    return next(seenPart(std::move(ids), std::move(positions)), open, chance);
}

PlannedPart Planner::renewed(const SeenPart& part, std::span<const std::int32_t> open, bool sweeps,
                             Chance& chance) const {
    PlannedPart best = next(part, open, chance);
    if (!def_.repertoire.spreads) return best;
    // A wide formation that is pushed together leaves items beside its way.
    if (beyondBorder(best) > kMostPushedLength) best.reforms = kPushedSeconds;
    double least = partSeconds(best);
    const double own = std::max(part.bounds.width(), part.bounds.height());
    const auto side = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(part.ids.size()))));
    const double square = def_.spacing * (side - 1);
    if (own > kWideRatio * std::max(square, def_.spacing)) {
        SeenPart squared = part;
        for (std::size_t i = 0; i < squared.positions.size(); ++i) {
            const auto n = static_cast<std::int32_t>(i);
            const std::int32_t rank = n / side;
            const Vec2 place{static_cast<double>(n - rank * side), static_cast<double>(rank)};
            squared.positions[i] = part.centre + place * def_.spacing - Vec2{0.5 * square, 0.5 * square};
        }
        PlannedPart led = next(seenPart(squared.ids, squared.positions), open, chance);
        led.square = true;
        led.reforms = 2.0 * motor_->point(0.0, kTargetMetres * def_.mmPerMetre) + (own - square) / def_.speed;
        const double seconds = partSeconds(led);
        if (seconds < least) {
            least = seconds;
            best = std::move(led);
        }
    }
    if (!sweeps) return best;
    PlannedPart sweep = bestSweep(part, open, 1.0);
    if (!sweep.way.empty() && partSeconds(sweep) < least) best = std::move(sweep);
    return best;
}

PlannedPart Planner::next(const SeenPart& part, std::span<const std::int32_t> open, Chance& chance) const {
    PlannedPart planned{part, {}, {}, 0.0, false, {}, 0.0, false, 0.0};
    lead(planned,
         tours_->tour(part.centre, open, def_.parameters.routeDetour * 2.0 * chance.uniform(), chance));
    return planned;
}

Repertoire repertoireOf(const SchemeDef& def) {
    Repertoire r{.touch = def.kind == SchemeKind::Touch,
                 .draws = def.kind == SchemeKind::Touch || def.kind == SchemeKind::MouseMesh,
                 .queues = def.kind == SchemeKind::MouseFull};
    r.divides = r.draws ? def.splits : true;
    r.spreads = r.touch && def.shapes && !def.oneFinger;
    r.calls = r.touch && def.splits && def.calls;
    r.keepsShape = r.draws || def.movement == SchemeMovement::Free;
    r.keepsGroups = def.kind == SchemeKind::MouseFull;
    return r;
}

}  // namespace muster
