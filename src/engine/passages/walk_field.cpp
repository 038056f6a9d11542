#include "engine/passages/walk_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

enum Edge : std::uint8_t { kEast = 1, kNorth = 2, kWest = 4, kSouth = 8 };

constexpr double kExactSide = 3.0;   // Distance to a passage within which its line tells the side [cells].
constexpr double kExactReach = 2.0;  // That distance in metres [m].
constexpr double kSeedReach = 1.5;   // Distance to a passage at which the front starts [cells].
// Length by which a closed passage reaches into the walls beside it [cells].
constexpr double kClosedBeyond = 0.75;
constexpr std::int32_t kReachedRing = 3;  // Rings of cells in which a reached cell is looked for.

double edgeCost(const CellCost& cost, Edge edge) {
    return edge == kEast ? cost.east : edge == kNorth ? cost.north : edge == kWest ? cost.west : cost.south;
}

struct Step {
    Edge edge;
    std::int32_t x, y;
};
constexpr Step kSteps[] = {{kEast, 1, 0}, {kNorth, 0, 1}, {kWest, -1, 0}, {kSouth, 0, -1}};

enum Mark : std::uint8_t { kSolved = 1, kWanted = 2 };

/// The value of the nearer neighbour on an axis, and the cost of the step from it.
struct AxisValue {
    double value = kInfiniteCost;
    double edge = kInfiniteCost;
};

/// True where one of two points on the line of a passage lies in it and the other beyond its end. Cells on
/// the line belong to one side of the passage, but cells along the wall beside it to the room before the
/// wall.
bool leavesAlongLine(const Passage& passage, Vec2 p, Vec2 q) {
    const double width = passage.width();
    const auto onLine = [&](Vec2 x) { return std::fabs(passage.leftOf(x)) <= 1e-6 * width; };
    const auto inside = [&](Vec2 x) {
        const double along = dot(x - passage.a, passage.b - passage.a) / width;
        return along > 0.0 && along < width;
    };
    return onLine(p) && onLine(q) && inside(p) != inside(q);
}

/// The box of all points at which the line of the passage tells the side.
Box boxRound(const Passage& passage) {
    const Vec2 reach{kExactReach, kExactReach};
    return {Vec2{std::min(passage.a.x, passage.b.x), std::min(passage.a.y, passage.b.y)} - reach,
            Vec2{std::max(passage.a.x, passage.b.x), std::max(passage.a.y, passage.b.y)} + reach};
}

/// The value from both axes: the root of sum ((T - v) / e)^2 = 1.
double upwind(const AxisValue& x, const AxisValue& y) {
    const double vx = x.value, ex = x.edge, vy = y.value, ey = y.edge;
    const double one = std::min(vx + ex, vy + ey);
    if (!(vx < kInfiniteCost) || !(vy < kInfiniteCost)) return one;
    if (ex == ey) {
        const double apart = vx - vy, square = 2.0 * ex * ex - apart * apart;
        return apart * apart < ex * ex ? 0.5 * (vx + vy + std::sqrt(square)) : one;
    }
    const double wx = 1.0 / (ex * ex), wy = 1.0 / (ey * ey);
    const double mean = (wx * vx + wy * vy) / (wx + wy);
    const double rest = (1.0 - wx * (vx - mean) * (vx - mean) - wy * (vy - mean) * (vy - mean)) / (wx + wy);
    if (rest < 0.0) return one;
    const double both = mean + std::sqrt(rest);
    return both >= std::max(vx, vy) ? both : one;
}

}  // namespace

bool WalkField::isCutOff(std::int32_t cell) const {
    return open_[cell] != 0 && !(cost_[cell] < kUnreachableCost);
}

std::int32_t WalkField::reachedCell(Vec2 p) const {
    const Cell centre = grid_.nearestCell(p);
    // For a cell in a wall, a reached cell near it serves; not for a cell behind a closed passage.
    if (isCutOff(grid_.index(centre))) return -1;
    for (std::int32_t ring = 0; ring <= kReachedRing; ++ring) {
        std::int32_t best = -1;
        double least = kInfiniteCost;
        for (std::int32_t y = -ring; y <= ring; ++y)
            for (std::int32_t x = -ring; x <= ring; ++x) {
                const Cell c{centre.x + x, centre.y + y};
                if (std::max(std::abs(x), std::abs(y)) != ring || !grid_.contains(c)) continue;
                const double away = distance(grid_.centre(c), p);
                if (!(cost_[grid_.index(c)] < kUnreachableCost) || !(away < least)) continue;
                least = away;
                best = grid_.index(c);
            }
        if (best >= 0) return best;
    }
    return -1;
}

Walk WalkField::atSpot(const WalkSpot& spot) const {
    const auto& [p, stencil, nearestCell] = spot;
    double sum = 0.0, weight = 0.0, heaviest = 0.0;
    Walk walk{kInfiniteCost, 0};
    if (isCutOff(nearestCell)) return walk;
    for (int k = 0; k < 4; ++k) {
        const float cost = cost_[stencil.cell[k]];
        if (!(cost < kUnreachableCost) || !(stencil.weight[k] > 0.0)) continue;
        sum += stencil.weight[k] * static_cast<double>(cost);
        weight += stencil.weight[k];
        if (stencil.weight[k] <= heaviest) continue;
        heaviest = stencil.weight[k];
        const std::int8_t side = side_[stencil.cell[k]];
        walk.side = (side > 0 ? 1 : 0) - (side < 0 ? 1 : 0);
    }
    if (weight > 0.0) {
        walk.cost = sum / weight;
    } else {
        const std::int32_t cell = reachedCell(p);
        if (cell < 0) return walk;
        walk = {static_cast<double>(cost_[cell]) + distance(p, grid_.centre(grid_.at(cell))), side_[cell]};
    }
    if (walk.side == 0 || !near_.contains(p)) return walk;
    const Vec2 nearest = closestOnSegment(passage_.a, passage_.b, p);
    if (distance(nearest, p) < std::min(kExactSide * grid_.cell, kExactReach))
        walk.side = passage_.onLeft(p) ? 1 : -1;
    return walk;
}

// The neighbour of least cost over an open edge; diagonally where both routes round the corner are open.
std::int32_t WalkField::nextCell(std::int32_t cell) const {
    std::int32_t best = cell;
    const auto offer = [&](std::int32_t other) {
        if (cost_[other] < cost_[best]) best = other;
    };
    const std::int32_t width = grid_.width;
    const std::uint8_t open = open_[cell];
    for (const Step& step : kSteps)
        if ((open & step.edge) != 0) offer(cell + step.x + step.y * width);
    for (const Step& column : {kSteps[0], kSteps[2]})
        for (const Step& row : {kSteps[1], kSteps[3]}) {
            if ((open & column.edge) == 0 || (open & row.edge) == 0) continue;
            const std::int32_t beside = cell + column.x, above = cell + row.y * width;
            if ((open_[beside] & row.edge) != 0 && (open_[above] & column.edge) != 0)
                offer(beside + row.y * width);
        }
    return best;
}

void WalkField::trace(Vec2 p, std::size_t most, std::vector<Vec2>& path) const {
    path.clear();
    std::int32_t cell = reachedCell(p);
    if (cell < 0) return;
    while (path.size() < most) {
        path.push_back(grid_.centre(grid_.at(cell)));
        const std::int32_t next = nextCell(cell);
        if (next == cell) return;
        cell = next;
    }
}

void WalkEdges::open(const UnitCost& ground) {
    grid_ = ground.grid;
    open_.assign(grid_.count(), 0);
    std::int32_t k = 0;
    for (std::int32_t y = 0; y < grid_.height; ++y)
        for (std::int32_t x = 0; x < grid_.width; ++x, ++k)
            for (const Step& step : kSteps) {
                const bool inside = grid_.contains({x + step.x, y + step.y});
                if (inside && edgeCost(ground.cells[k], step.edge) < kInfiniteCost) open_[k] |= step.edge;
            }
}

void WalkEdges::close(const Passage& passage) {
    const Grid& grid = grid_;
    const double length = passage.width();
    if (!(length > 0.0)) return;
    const Vec2 beyond = (passage.b - passage.a) * (kClosedBeyond * grid.cell / length);
    const Vec2 a = passage.a - beyond, b = passage.b + beyond;
    const Cell low = grid.nearestCell(
        {std::min(a.x, b.x) - 1.5 * grid.cell, std::min(a.y, b.y) - 1.5 * grid.cell});
    const Cell high = grid.nearestCell(
        {std::max(a.x, b.x) + 1.5 * grid.cell, std::max(a.y, b.y) + 1.5 * grid.cell});
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x)
            for (const Step& step : {kSteps[0], kSteps[1]}) {
                const Cell from{x, y}, to{x + step.x, y + step.y};
                if (!grid.contains(to)) continue;
                const Vec2 p = grid.centre(from), q = grid.centre(to);
                const bool apart = passage.onLeft(p) != passage.onLeft(q);
                const bool within = (cross(q - p, a - p) > 0.0) != (cross(q - p, b - p) > 0.0);
                if (!(apart && within) && !leavesAlongLine(passage, p, q)) continue;
                open_[grid.index(from)] &= static_cast<std::uint8_t>(~step.edge);
                open_[grid.index(to)] &= static_cast<std::uint8_t>(~(step.edge << 2));
            }
}

void WalkSolver::reset(const WalkEdges& edges, WalkField& field) {
    field.grid_ = edges.grid_;
    field.open_ = edges.open_;
    field.cost_.assign(edges.open_.size(), kUnreachableCost);
    field.side_.assign(edges.open_.size(), 0);
    mark_.assign(edges.open_.size(), 0);
    heap_.clear();
    wanted_ = -1;
    most_ = kUnreachableCost;
}

void WalkSolver::push(float cost, std::int32_t cell) {
    // Costs are not negative: their bits are in the order of their values.
    std::uint32_t bits = 0;
    std::memcpy(&bits, &cost, sizeof bits);
    heap_.push_back(static_cast<std::uint64_t>(bits) << 32 | static_cast<std::uint32_t>(cell));
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void WalkSolver::seed(WalkField& field, std::int32_t cell, double cost, std::int32_t side) {
    if (!(static_cast<float>(cost) < field.cost_[cell])) return;
    field.cost_[cell] = static_cast<float>(cost);
    field.side_[cell] = static_cast<std::int8_t>(side);
    push(field.cost_[cell], cell);
}

void WalkSolver::seedPassage(const UnitCost& ground, WalkField& field) {
    const Grid& grid = field.grid_;
    const Passage& passage = field.passage_;
    const double unit = static_cast<double>(ground.lowest);
    for (double reach = kSeedReach; reach < 5.0; reach += 1.0) {
        const double far = reach * grid.cell;
        const Cell low = grid.nearestCell(
            {std::min(passage.a.x, passage.b.x) - far, std::min(passage.a.y, passage.b.y) - far});
        const Cell high = grid.nearestCell(
            {std::max(passage.a.x, passage.b.x) + far, std::max(passage.a.y, passage.b.y) + far});
        bool left = false, right = false;
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) {
                const std::int32_t cell = grid.index({x, y});
                const Vec2 p = grid.centre({x, y});
                const double away = distance(p, closestOnSegment(passage.a, passage.b, p));
                if (away > far || field.open_[cell] == 0) continue;
                const bool onLeft = passage.onLeft(p);
                (onLeft ? left : right) = true;
                seed(field, cell, unit * away, onLeft ? 1 : -1);
            }
        if (left && right) return;
    }
}

// Gives the neighbours of a solved cell their values.
void WalkSolver::spread(const UnitCost& ground, WalkField& field, std::int32_t cell) {
    const Grid& grid = field.grid_;
    const auto nearer = [&](std::int32_t of, const Step& up, const Step& down) {
        AxisValue best;
        for (const Step& step : {up, down}) {
            const std::int32_t other = of + step.x + step.y * grid.width;
            if ((field.open_[of] & step.edge) == 0 || (mark_[other] & kSolved) == 0) continue;
            const double edge = edgeCost(ground.cells[of], step.edge) * grid.cell;
            const auto value = static_cast<double>(field.cost_[other]);
            if (value + edge < best.value + best.edge) best = {value, edge};
        }
        return best;
    };
    for (const Step& step : kSteps) {
        if ((field.open_[cell] & step.edge) == 0) continue;
        const std::int32_t other = cell + step.x + step.y * grid.width;
        if ((mark_[other] & kSolved) != 0) continue;
        const AxisValue x = nearer(other, kSteps[0], kSteps[2]), y = nearer(other, kSteps[1], kSteps[3]);
        const auto value = static_cast<float>(upwind(x, y));
        if (!(value < field.cost_[other])) continue;
        field.cost_[other] = value;
        field.side_[other] = field.side_[cell];
        push(value, other);
    }
}

bool WalkSolver::advance(const UnitCost& ground, WalkField& field, std::int64_t& cells) {
    while (!heap_.empty() && wanted_ != 0) {
        if (cells <= 0) return false;
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const auto cell = static_cast<std::int32_t>(heap_.back() & 0xffffffffu);
        heap_.pop_back();
        if ((mark_[cell] & kSolved) != 0) continue;
        if (field.cost_[cell] > most_) break;
        if ((mark_[cell] & kWanted) != 0) --wanted_;
        mark_[cell] |= kSolved;
        --cells;
        spread(ground, field, cell);
    }
    heap_.clear();
    return true;
}

bool WalkSolver::want(std::int32_t cell, const WalkField& field) {
    if (field.open_[cell] == 0) return false;
    if ((mark_[cell] & kWanted) == 0) ++wanted_;
    mark_[cell] |= kWanted;
    return true;
}

void WalkSolver::stopAt(Vec2 p, const WalkField& field) {
    wanted_ = std::max(wanted_, 0);
    bool any = false;
    for (const std::int32_t cell : bilinearStencil(field.grid_, p).cell) any = want(cell, field) || any;
    if (any) return;
    const Cell centre = field.grid_.nearestCell(p);
    for (std::int32_t y = -kReachedRing; y <= kReachedRing; ++y)
        for (std::int32_t x = -kReachedRing; x <= kReachedRing; ++x) {
            const Cell c{centre.x + x, centre.y + y};
            if (field.grid_.contains(c)) want(field.grid_.index(c), field);
        }
}

void WalkSolver::begin(const UnitCost& ground, const WalkEdges& edges, const Passage& passage,
                       WalkField& field) {
    reset(edges, field);
    field.passage_ = passage;
    field.near_ = boxRound(passage);
    seedPassage(ground, field);
}

void WalkSolver::begin(const UnitCost&, const WalkEdges& edges, Vec2 source, WalkField& field) {
    reset(edges, field);
    field.passage_ = {source, source, 1.0};
    field.near_ = boxRound(field.passage_);
    const Grid& grid = field.grid_;
    const Cell centre = grid.nearestCell(source);
    for (std::int32_t ring = 0; ring <= kReachedRing && heap_.empty(); ++ring)
        for (std::int32_t y = centre.y - ring; y <= centre.y + ring; ++y)
            for (std::int32_t x = centre.x - ring; x <= centre.x + ring; ++x)
                if (grid.contains({x, y}) && field.open_[grid.index({x, y})] != 0)
                    seed(field, grid.index({x, y}), distance(grid.centre({x, y}), source), 0);
}

}  // namespace muster
