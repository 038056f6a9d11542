#include "engine/orders/way_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/infinite_cost.h"
#include "base/maths.h"

namespace muster {
namespace {

constexpr double kRoomTolerance = 0.05;  // Lack of room that does not matter [m].
constexpr double kMarginCost = 0.35;  // Extra cost of a metre beside an obstacle, where there is enough room.
constexpr double kNarrowCost = 1.0;   // Extra cost of a metre that is narrower than the formation...
constexpr double kMissingCost = 3.0;  // ... and further cost by the share that is missing.
// Extra cost of a metre where the formation may not narrow that far.
constexpr double kForbiddenCost = 1000.0;
constexpr std::array<Cell, 8> kSteps{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

}  // namespace

double WayNeeds::cost(double clearance) const {
    if (clearance < radius) return kInfiniteCost;
    if (clearance >= half + margin) return 1.0;
    if (flows || clearance >= half - kRoomTolerance)
        return 1.0 + kMarginCost * std::min(1.0, (half + margin - clearance) / std::max(margin, 1e-9));
    const double missing = 1.0 - clearance / half;
    const double narrow = 1.0 + kMarginCost + kNarrowCost + kMissingCost * missing;
    return clearance < least * half - kRoomTolerance ? narrow + kForbiddenCost : narrow;
}

double stretchCost(const WayGround& ground, const WayNeeds& needs, Vec2 a, Vec2 b) {
    const double whole = distance(a, b);
    if (whole < 1e-9) return 0.0;
    const auto n = std::max(1, static_cast<std::int32_t>(std::ceil(whole / ground.grid().cell)));
    double sum = 0.0;
    bool near = false;
    for (std::int32_t k = 0; k < n; ++k) {
        const Vec2 at = lerp(a, b, (k + 0.5) / n);
        const double clearance = ground.clearanceAt(at);
        near = near || clearance < needs.radius + ground.grid().cell;
        sum += needs.cost(std::max(clearance, needs.radius)) * ground.slownessAt(at, needs.half);
    }
    if (near && !ground.environment().clearStaticLine(a, b, needs.radius)) return kInfiniteCost;
    if (!clearOf(needs.held, a, b, needs.radius)) return kInfiniteCost;
    return sum * whole / n;
}

namespace {

/// Leaves out corners where the straight stretch costs no more.
void skip(const WayGround& ground, const WayNeeds& needs, std::vector<Vec2>& points,
          std::vector<double>& prefix) {
    constexpr double kMore = 1.002;  // Factor up to which costs count as equal.
    prefix.assign(1, 0.0);
    for (std::size_t k = 1; k < points.size(); ++k)
        prefix.push_back(prefix.back() + stretchCost(ground, needs, points[k - 1], points[k]));
    const auto good = [&](std::size_t from, std::size_t to) {
        return stretchCost(ground, needs, points[from], points[to]) <=
               kMore * (prefix[to] - prefix[from]) + 1e-9;
    };
    std::size_t kept = 0;
    for (std::size_t at = 0; at + 1 < points.size();) {
        std::size_t low = at + 1, high = points.size();
        for (std::size_t stride = 2; at + stride < points.size(); stride *= 2) {
            if (!good(at, at + stride)) {
                high = at + stride;
                break;
            }
            low = at + stride;
        }
        if (high == points.size() && low + 1 < high && good(at, high - 1)) low = high - 1;
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            (good(at, middle) ? low : high) = middle;
        }
        at = low;
        points[++kept] = points[at];
    }
    points.resize(points.empty() ? 0 : kept + 1);
}

/// Replaces corners by two points on their sides where that costs less.
void cut(const WayGround& ground, const WayNeeds& needs, std::vector<Vec2>& points, std::vector<Vec2>& out) {
    constexpr int kTries = 4;
    out.assign(1, points.front());
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const Vec2 a = out.back(), c = points[k], b = points[k + 1];
        double reach = 0.6 * std::min(distance(a, c), distance(c, b));
        bool done = false;
        for (int tries = 0; tries < kTries && !done && reach > 0.2; ++tries, reach *= 0.5) {
            const Vec2 p = c + normalized(a - c) * reach, q = c + normalized(b - c) * reach;
            const double around = stretchCost(ground, needs, p, c) + stretchCost(ground, needs, c, q);
            done = stretchCost(ground, needs, p, q) < around;
            if (!done) continue;
            out.push_back(p);
            out.push_back(q);
        }
        if (!done) out.push_back(c);
    }
    out.push_back(points.back());
    points.swap(out);
}

}  // namespace

void pullWay(const WayGround& ground, const WayNeeds& needs, std::vector<Vec2>& points,
             std::vector<Vec2>& scratch, std::vector<double>& prefix) {
    constexpr int kPasses = 3;
    if (points.size() < 3) return;
    skip(ground, needs, points, prefix);
    for (int pass = 0; pass < kPasses && points.size() > 2; ++pass) {
        cut(ground, needs, points, scratch);
        skip(ground, needs, points, prefix);
    }
}

// The nearest cell, at `p` or beside it, with a clear line to its point; -1 for none.
std::int32_t WaySearch::cellNear(const WayGround& ground, Vec2 p) const {
    const Grid& grid = ground.grid();
    const Cell middle = grid.nearestCell(p);
    std::int32_t best = -1;
    double nearest = kInfiniteCost;
    for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            const Cell c{middle.x + dx, middle.y + dy};
            if (!grid.contains(c)) continue;
            const std::int32_t cell = grid.index(c);
            const double away = distance(ground.point(cell), p);
            if (away >= nearest || ground.clearance(cell) < query_.needs.radius ||
                !ground.environment().clearStaticLine(p, ground.point(cell), query_.needs.radius))
                continue;
            nearest = away;
            best = cell;
        }
    return best;
}

void WaySearch::start(const WayGround& ground, const WayQuery& query) {
    query_ = query;
    expanded_ = 0;
    const auto count = static_cast<std::size_t>(ground.grid().count());
    if (seen_.size() != count) {
        seen_.assign(count, 0);
        held_.assign(count, 0);
        cost_.resize(count);
        parent_.resize(count);
        closed_.resize(count);
        mark_ = 0;
    }
    ++mark_;
    open_.clear();
    path_.clear();
    markHeld(ground);
    const std::int32_t from = cellNear(ground, query.from);
    goal_ = cellNear(ground, query.to);
    status_ = from < 0 || goal_ < 0 ? WayStatus::None : WayStatus::Searching;
    if (status_ != WayStatus::None) reach(from, -1, 0.0, distance(query.from, query.to));
}

void WaySearch::reach(std::int32_t cell, std::int32_t from, double cost, double estimate) {
    if (seen_[cell] != mark_) {
        seen_[cell] = mark_;
        cost_[cell] = kInfiniteCost;
        closed_[cell] = 0;
    }
    if (closed_[cell] != 0 || cost >= cost_[cell]) return;
    cost_[cell] = cost;
    parent_[cell] = from;
    open_.push_back({estimate, cell});
    std::push_heap(open_.begin(), open_.end());
}

// Marks cells near holders. A step leads at most two cells along each axis.
void WaySearch::markHeld(const WayGround& ground) {
    const Grid& grid = ground.grid();
    for (const HeldSpot& spot : query_.needs.held) {
        const double reach = spot.radius + query_.needs.radius + 3.0 * grid.cell;
        const Cell low = grid.nearestCell(spot.position - Vec2{reach, reach});
        const Cell high = grid.nearestCell(spot.position + Vec2{reach, reach});
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) held_[grid.index({x, y})] = mark_;
    }
}

// Expands a cell. A step between the points of neighbouring cells is clear where their discs overlap, else by
// exact geometry, which comes last because it is costly.
void WaySearch::expand(const WayGround& ground, std::int32_t cell) {
    const Grid& grid = ground.grid();
    const WayNeeds& needs = query_.needs;
    const Cell at = grid.at(cell);
    const Vec2 here = ground.point(cell), goal = ground.point(goal_);
    const double own = ground.clearance(cell), overlap = 2.0 * needs.radius + 0.5 * grid.cell;
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
        const Cell next{at.x + kSteps[k].x, at.y + kSteps[k].y};
        if (!grid.contains(next)) continue;
        const std::int32_t to = grid.index(next);
        const bool seen = seen_[to] == mark_;
        if (seen && closed_[to] != 0) continue;
        const double room = ground.clearance(to);
        if (std::min(own, room) < needs.radius) continue;
        const Vec2 there = ground.point(to);
        const double step = distance(here, there);
        const double slowness = ground.uneven() ? 0.5 * (ground.slowness(cell, needs.half) +
                                                         ground.slowness(to, needs.half))
                                                : 1.0;
        const double cost = cost_[cell] + step * slowness * needs.cost(std::min(own, room));
        if (seen && cost >= cost_[to]) continue;
        if (own + room < step + overlap && !ground.environment().clearStaticLine(here, there, needs.radius))
            continue;
        if (held_[cell] != mark_ || clearOf(needs.held, here, there, needs.radius))
            reach(to, cell, cost, cost + ground.leastSlowness() * distance(there, goal));
    }
}

void WaySearch::trace(const WayGround& ground) {
    path_.assign(1, query_.to);
    for (std::int32_t cell = goal_; cell >= 0; cell = parent_[cell]) path_.push_back(ground.point(cell));
    path_.push_back(query_.from);
    std::reverse(path_.begin(), path_.end());
    pullWay(ground, query_.needs, path_, scratch_, prefix_);
}

WayStatus WaySearch::advance(const WayGround& ground, std::int32_t cells) {
    while (status_ == WayStatus::Searching && cells > 0) {
        if (open_.empty()) {
            status_ = WayStatus::None;
            break;
        }
        std::pop_heap(open_.begin(), open_.end());
        const std::int32_t cell = open_.back().cell;
        open_.pop_back();
        if (closed_[cell] != 0) continue;
        closed_[cell] = 1;
        if (cell == goal_) {
            trace(ground);
            status_ = WayStatus::Found;
            break;
        }
        expand(ground, cell);
        ++expanded_;
        --cells;
    }
    return status_;
}

}  // namespace muster
