#include "eikonal/start_disc.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// A source in ground that is not uniform has straight-line costs at least this near [cells].
constexpr double kAlwaysNear = 0.5;
// Straight-line costs stand within this many cells, and where no way round could be cheaper by a larger
// factor.
constexpr double kSingular = 1.6;
constexpr double kGoodEnough = 1.25;

// True where all directions that are open cost the same as `wanted`, and one is open.
bool uniform(const CellCost& c, float wanted) {
    const auto fits = [wanted](float side) { return side == wanted || side == kInfiniteCost; };
    return fits(c.east) && fits(c.north) && fits(c.west) && fits(c.south) &&
           std::min({c.east, c.north, c.west, c.south}) == wanted;
}

// Cost of the straight way from a cell's centre to the source, sampled every half cell; infinite where it
// meets a wall.
double rayCost(const UnitCost& cost, Vec2 from, Vec2 source) {
    const Vec2 way = source - from;
    const int samples = 1 + static_cast<int>(length(way) / (0.5 * cost.grid.cell));
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        const Vec2 p = lerp(from, source, (k + 0.5) / samples);
        sum += stepCost(cost.cells[cost.grid.index(cost.grid.nearestCell(p))], way / samples);
    }
    return sum;
}

// Of the cells from low to high, in any direction.
double lowestCost(const UnitCost& cost, Cell low, Cell high) {
    float least = kInfiniteCost;
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
    // A closed side costs as the other: only the far side of the cell is closed.
    const auto side = [](float ahead, float behind) { return ahead < kInfiniteCost ? ahead : behind; };
    const double x = by.x > 0.0 ? side(cost.east, cost.west) : side(cost.west, cost.east);
    const double y = by.y > 0.0 ? side(cost.north, cost.south) : side(cost.south, cost.north);
    const double alongX = by.x == 0.0 ? 0.0 : by.x * x;
    const double alongY = by.y == 0.0 ? 0.0 : by.y * y;
    return std::sqrt(alongX * alongX + alongY * alongY);
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

void StartDisc::start(const UnitCost& cost, Vec2 source, double radius, double reach, Front& front) {
    const Grid& grid = cost.grid;
    radius_ = 0.0;
    const std::int32_t home = grid.index(grid.nearestCell(source));
    if (cost.wall(home)) return startFromWall(cost, source, front);
    // The four cells around the source always get their start here.
    radius = std::max(radius, 1.5 * grid.cell);
    const double clear = clearRadius(cost, source, radius);
    radius_ = std::max(clear, kAlwaysNear * grid.cell);
    const CellCost& own = cost.cells[home];
    const auto node = std::lower_bound(cost.nodes.begin(), cost.nodes.end(), home,
                                       [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    const bool beside = node != cost.nodes.end() && node->cell == home && node->unit > 0.0f;
    const float unit = beside ? node->unit : std::min({own.east, own.north, own.west, own.south});
    const Vec2 at = (source - grid.centre({0, 0})) / grid.cell;
    const std::int32_t root = front.addSource(static_cast<float>(at.x), static_cast<float>(at.y), unit);
    const bool flooded = front.flood(grid.nearestCell(source), root,
                                     static_cast<float>(unit * reach / grid.cell));
    if (flooded && clear >= radius) return;
    const Cell low = grid.nearestCell(source - Vec2{radius, radius});
    const Cell high = grid.nearestCell(source + Vec2{radius, radius});
    const double least = lowestCost(cost, low, high);
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Vec2 centre = grid.centre({x, y});
            if (distance(centre, source) > radius || cost.wall(grid.index({x, y}))) continue;
            float value = 0.0f;
            const Ray ray = front.seen({x, y}, root, value);
            if (ray == Ray::Clear) front.seed({x, y}, value, root);
            if (ray == Ray::OtherGround) {
                // Differences are poor next to a point source, so that straight costs stand where little can
                // be gained.
                const double price = rayCost(cost, centre, source);
                const double away = distance(centre, source);
                const bool good = away < kSingular * grid.cell || price <= kGoodEnough * away * least;
                front.seed({x, y}, static_cast<float>(price / grid.cell), good ? kGiven : 0);
            }
        }
    }
}

void StartDisc::startFromWall(const UnitCost& cost, Vec2 source, Front& front) {
    const Grid& grid = cost.grid;
    const Cell middle = grid.nearestCell(source);
    double nearest = 1e300;
    // Rings of cells outwards; one more ring after the first find, as corners of a ring are farther than
    // sides of the next.
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
    const auto reach = static_cast<std::int32_t>(0.42 * ring) + 2;
    for (std::int32_t k = ring; k < ring + reach; ++k) visit(true, k);
    for (std::int32_t k = std::max(0, ring - 1); k < ring + reach; ++k) visit(false, k);
}

}  // namespace muster
