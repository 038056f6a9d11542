#include "fields/start_disc.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// A source in ground that is not uniform has straight-line costs at least this near [cells].
constexpr double kAlwaysNear = 0.5;

// True where all directions that are open cost the same as `wanted`, and one is open.
bool uniform(const CellCost& c, float wanted) {
    const auto fits = [wanted](float side) { return side == wanted || side == kInfiniteCost; };
    return fits(c.east) && fits(c.north) && fits(c.west) && fits(c.south) &&
           std::min({c.east, c.north, c.west, c.south}) == wanted;
}

// Cost of the straight way from a cell's centre to the source, sampled every half cell; infinite where it meets a wall.
double rayCost(const UnitCost& cost, Vec2 from, Vec2 source) {
    const Vec2 way = source - from;
    const int samples = 1 + static_cast<int>(length(way) / (0.5 * cost.grid.cell));
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        const Vec2 p = lerp(from, source, (k + 0.5) / samples);
        sum += straightCost(cost.cells[cost.grid.index(cost.grid.nearestCell(p))], way / samples);
    }
    return sum;
}

}  // namespace

double straightCost(const CellCost& cost, Vec2 by) {
    const double x = by.x == 0.0 ? 0.0 : by.x * (by.x > 0.0 ? cost.east : cost.west);
    const double y = by.y == 0.0 ? 0.0 : by.y * (by.y > 0.0 ? cost.north : cost.south);
    return std::sqrt(x * x + y * y);
}

// The distance of the nearest cell whose costs are others than those at the source, at most `radius`.
double StartDisc::clearRadius(const UnitCost& cost, Vec2 source, double radius) const {
    const Grid& grid = cost.grid;
    const CellCost& own = cost.cells[grid.index(grid.nearestCell(source))];
    const float wanted = std::min({own.east, own.north, own.west, own.south});
    const Cell low = grid.nearestCell(source - Vec2{radius, radius});
    const Cell high = grid.nearestCell(source + Vec2{radius, radius});
    double squared = radius * radius;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const double here = lengthSquared(grid.centre({x, y}) - source);
            if (here < squared && !uniform(cost.cells[grid.index({x, y})], wanted)) squared = here;
        }
    }
    return std::sqrt(squared);
}

void StartDisc::start(const UnitCost& cost, Vec2 source, double radius, Front& front) {
    const Grid& grid = cost.grid;
    radius_ = 0.0;
    if (cost.wall(grid.index(grid.nearestCell(source)))) return startFromWall(cost, source, front);
    // The four cells around the source always get their start here.
    radius = std::max(radius, 1.5 * grid.cell);
    const double clear = clearRadius(cost, source, radius);
    radius_ = std::max(clear, kAlwaysNear * grid.cell);
    const Cell low = grid.nearestCell(source - Vec2{radius, radius});
    const Cell high = grid.nearestCell(source + Vec2{radius, radius});
    const CellCost& own = cost.cells[grid.index(grid.nearestCell(source))];
    const float unit = std::min({own.east, own.north, own.west, own.south});
    fixed_.clear();
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Vec2 centre = grid.centre({x, y});
            const double away = distance(centre, source);
            if (away > radius || cost.wall(grid.index({x, y}))) continue;
            const FrontCell cell = front.at({x, y});
            if (away < clear) {
                front.fix(cell, static_cast<float>(away * unit / grid.cell));
                fixed_.push_back(cell);
            } else {
                front.seed(cell, static_cast<float>(rayCost(cost, centre, source) / grid.cell));
            }
        }
    }
    for (const FrontCell cell : fixed_) front.offer(cell);
}

void StartDisc::startFromWall(const UnitCost& cost, Vec2 source, Front& front) {
    const Grid& grid = cost.grid;
    const Cell middle = grid.nearestCell(source);
    double nearest = 1e300;
    // Rings of cells outwards; one more ring after the first find, as corners of a ring are farther than sides of the next.
    const auto visit = [&](bool find, std::int32_t ring) {
        for (std::int32_t y = std::max(0, middle.y - ring); y <= std::min(grid.height - 1, middle.y + ring); ++y) {
            const bool edge = y == middle.y - ring || y == middle.y + ring;
            for (std::int32_t x = middle.x - ring; x <= middle.x + ring; x += edge || ring == 0 ? 1 : 2 * ring) {
                if (!grid.contains({x, y}) || cost.wall(grid.index({x, y}))) continue;
                const double away = distance(grid.centre({x, y}), source);
                if (find) nearest = std::min(nearest, away);
                if (find || away > nearest + 0.5 * grid.cell) continue;
                const CellCost& c = cost.cells[grid.index({x, y})];
                const float unit = std::min({c.east, c.north, c.west, c.south});
                front.seed(front.at({x, y}), static_cast<float>(away / grid.cell) * unit);
            }
        }
    };
    const std::int32_t last = std::max(grid.width, grid.height);
    std::int32_t ring = 0;
    while (ring <= last && nearest == 1e300) visit(true, ring++);
    const auto reach = static_cast<std::int32_t>(0.42 * ring) + 2;
    for (std::int32_t k = ring; k < ring + reach; ++k) visit(true, k);
    for (std::int32_t k = std::max(0, ring - 1); k < ring + reach; ++k) visit(false, k);
}

}  // namespace muster
