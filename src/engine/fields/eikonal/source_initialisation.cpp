#include "engine/fields/eikonal/source_initialisation.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Least radius() of a source on ground that is not uniform [cells].
constexpr double kLeastUniformRadius = 0.5;
// Distance to the source below which the cost of the straight line stands, as differences are poor there
// [cells].
constexpr double kSingularDistance = 1.6;
// Factor by which another path would have to be cheaper for the straight line not to stand.
constexpr double kStraightFactor = 1.25;

// True where all open directions of a cell cost `unit`, and one is open.
bool costsUniformly(const CellCost& c, float unit) {
    const auto fits = [unit](float side) { return side == unit || side == kUnreachableCost; };
    return fits(c.east) && fits(c.north) && fits(c.west) && fits(c.south) &&
           std::min({c.east, c.north, c.west, c.south}) == unit;
}

// Cost of the straight line from a cell's centre to the source, sampled every half cell; infinite where it
// meets a wall.
double straightLineCost(const UnitCost& cost, Vec2 from, Vec2 source) {
    const Vec2 line = source - from;
    const int samples = 1 + static_cast<int>(length(line) / (0.5 * cost.grid.cell));
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        const Vec2 p = lerp(from, source, (k + 0.5) / samples);
        sum += stepCost(cost.cells[cost.grid.index(cost.grid.nearestCell(p))], line / samples);
    }
    return sum;
}

// Lowest cost of any direction in the cells from `low` to `high`.
double lowestCost(const UnitCost& cost, Cell low, Cell high) {
    float least = kUnreachableCost;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const CellCost& c = cost.cells[cost.grid.index({x, y})];
            least = std::min({least, c.east, c.north, c.west, c.south});
        }
    }
    return least;
}

}  // namespace

double stepCost(const CellCost& cost, Vec2 by) {
    // A closed side costs as much as the opposite one: only the far side of the cell is closed.
    const auto side = [](float ahead, float behind) { return ahead < kUnreachableCost ? ahead : behind; };
    const double x = by.x > 0.0 ? side(cost.east, cost.west) : side(cost.west, cost.east);
    const double y = by.y > 0.0 ? side(cost.north, cost.south) : side(cost.south, cost.north);
    const double alongX = by.x == 0.0 ? 0.0 : by.x * x;
    const double alongY = by.y == 0.0 ? 0.0 : by.y * y;
    return std::sqrt(alongX * alongX + alongY * alongY);
}

// Distance of the nearest cell whose unit cost is not that of the source's cell, at most `radius`.
double SourceInitialiser::uniformRadius(const UnitCost& cost, Vec2 source, double radius) const {
    const Grid& grid = cost.grid;
    const CellCost& own = cost.cells[grid.index(grid.nearestCell(source))];
    const float unit = std::min({own.east, own.north, own.west, own.south});
    const Cell low = grid.nearestCell(source - Vec2{radius, radius});
    const Cell high = grid.nearestCell(source + Vec2{radius, radius});
    double squared = radius * radius;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const double here = lengthSquared(grid.centre({x, y}) - source);
            if (here < squared && !costsUniformly(cost.cells[grid.index({x, y})], unit)) squared = here;
        }
    }
    return std::sqrt(squared);
}

void SourceInitialiser::start(const UnitCost& cost, Vec2 source, double radius, double reach, Front& front) {
    const Grid& grid = cost.grid;
    radius_ = 0.0;
    const std::int32_t home = grid.index(grid.nearestCell(source));
    if (cost.wall(home)) return startFromWall(cost, source, front);
    // The four cells around the source always get their values here.
    radius = std::max(radius, 1.5 * grid.cell);
    const double uniform = uniformRadius(cost, source, radius);
    radius_ = std::max(uniform, kLeastUniformRadius * grid.cell);
    const CellCost& own = cost.cells[home];
    const auto node = std::lower_bound(cost.nodes.begin(), cost.nodes.end(), home,
                                       [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    const bool atWall = node != cost.nodes.end() && node->cell == home && node->unit > 0.0f;
    const float unit = atWall ? node->unit : std::min({own.east, own.north, own.west, own.south});
    const Vec2 at = (source - grid.centre({0, 0})) / grid.cell;
    const std::int32_t index = front.addSource(static_cast<float>(at.x), static_cast<float>(at.y), unit);
    const bool filled = front.fillVisible(grid.nearestCell(source), index,
                                          static_cast<float>(unit * reach / grid.cell));
    if (filled && uniform >= radius) return;
    startOnVaryingGround(cost, source, radius, index, front);
}

void SourceInitialiser::startOnVaryingGround(const UnitCost& cost, Vec2 source, double radius,
                                             std::int32_t index, Front& front) const {
    const Grid& grid = cost.grid;
    const Cell low = grid.nearestCell(source - Vec2{radius, radius});
    const Cell high = grid.nearestCell(source + Vec2{radius, radius});
    const double least = lowestCost(cost, low, high);
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Vec2 centre = grid.centre({x, y});
            if (distance(centre, source) > radius || cost.wall(grid.index({x, y}))) continue;
            float value = 0.0f;
            const Visibility visibility = front.visibility({x, y}, index, value);
            if (visibility == Visibility::Clear) front.seed({x, y}, value, index);
            if (visibility == Visibility::OtherGround) {
                const double straight = straightLineCost(cost, centre, source);
                const double away = distance(centre, source);
                const bool fixed = away < kSingularDistance * grid.cell ||
                                   straight <= kStraightFactor * away * least;
                front.seed({x, y}, static_cast<float>(straight / grid.cell), fixed ? kFixedValue : 0);
            }
        }
    }
}

void SourceInitialiser::startFromWall(const UnitCost& cost, Vec2 source, Front& front) const {
    const Grid& grid = cost.grid;
    const Cell middle = grid.nearestCell(source);
    double nearest = 1e300;
    // Visits a square ring of cells: finds the nearest free cell, or seeds cells about as near.
    const auto visit = [&](bool find, std::int32_t ring) {
        for (std::int32_t y = std::max(0, middle.y - ring); y <= std::min(grid.height - 1, middle.y + ring);
             ++y) {
            const bool edge = y == middle.y - ring || y == middle.y + ring;
            for (std::int32_t x = middle.x - ring; x <= middle.x + ring;
                 x += edge || ring == 0 ? 1 : 2 * ring) {
                if (!grid.contains({x, y}) || cost.wall(grid.index({x, y}))) continue;
                const double away = distance(grid.centre({x, y}), source);
                if (find) nearest = std::min(nearest, away);
                if (find || away > nearest + 0.5 * grid.cell) continue;
                const CellCost& c = cost.cells[grid.index({x, y})];
                const float unit = std::min({c.east, c.north, c.west, c.south});
                front.seed({x, y}, static_cast<float>(away / grid.cell) * unit, 0);
            }
        }
    };
    const std::int32_t last = std::max(grid.width, grid.height);
    std::int32_t ring = 0;
    while (ring <= last && nearest == 1e300) visit(true, ring++);
    // The corners of a ring are farther than the sides of the next ones, up to a factor of sqrt(2).
    const auto more = static_cast<std::int32_t>(0.42 * ring) + 2;
    for (std::int32_t k = ring; k < ring + more; ++k) visit(true, k);
    for (std::int32_t k = std::max(0, ring - 1); k < ring + more; ++k) visit(false, k);
}

}  // namespace muster
