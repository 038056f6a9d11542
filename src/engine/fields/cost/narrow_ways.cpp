#include "engine/fields/cost/narrow_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "engine/fields/cost/ground_node.h"
#include "engine/ground/routes/route_ground.h"

namespace muster {
namespace {

// Distance from the centre of a cell to its corner [cells].
constexpr double kToCorner = 0.70710678118654752;
// Greatest distance of the point where a body stands in a cell from its centre [cells].
constexpr double kToPoint = 1.0;
// Distance beyond the radius within which surfaces are walls of a narrow way [cells]: wider ways show in the
// raster.
constexpr double kWallReach = 1.0;
// Cosine of the angle between the directions to two walls below which they face each other.
constexpr double kFacingCosine = -0.1;
// Share of the radius: between the node of a free cell and the point where a body stands in it there is no
// wall if a disc of this share passes, since nodes lie on the forbidden zone's border only approximately.
constexpr double kThinShare = 0.5;
// Starts of the search for a point, from the centre of a cell: a point may be pushed out of the narrow way
// [cells].
constexpr Vec2 kStarts[] = {{0.0, 0.0}, {0.3, 0.3}, {-0.3, 0.3}, {-0.3, -0.3}, {0.3, -0.3}};
// Depth in the forbidden zone that a node of the raster may have [cells].
constexpr double kNodeDepth = 0.05;
// Number of times that a step from cell to cell is halved, at points where it may bend.
constexpr int kHalvings = 2;
// Dot product of the normals of two nodes above which they are on one side of a wall.
constexpr float kSameSide = 0.5f;
constexpr std::uint8_t kAllOpen = 0x0f;
// Offset of a point that would lie on the centre [cells].
constexpr float kCentreOffset = 1e-4f;

/// Finds the narrow cells of an area.
class Finder {
public:
    Finder(const Environment& environment, const GapIndex& gaps, double radius)
        : environment_(environment),
          gaps_(gaps),
          grid_(environment.grid()),
          radius_(radius),
          clearance_(environment.staticClearance()),
          rasters_{grid_, clearance_, RasterView(&kSpeed)},
          nodes_(rasters_, radius),
          ground_(environment, radius) {}

    void run(const CellRect& area, std::vector<NarrowCell>& found) {
        for (std::int32_t y = area.low.y; y <= area.high.y; ++y)
            for (std::int32_t x = area.low.x; x <= area.high.x; ++x) {
                const auto here = static_cast<double>(clearance_[grid_.index({x, y})]);
                if (here < radius_ - kToCorner * grid_.cell) continue;
                if (here < radius_ && addNarrow({x, y}, found)) continue;
                if (here <= grid_.cell) addNextToWall({x, y}, found);
            }
    }

private:
    static constexpr float kSpeed = 1.0f;

    // Calls `visit(way)` with the vector to each surface, and side of the world, within `reach`.
    template <class Visit>
    void forWalls(Vec2 p, double reach, const Visit& visit) const {
        environment_.forPiecesNear(p, reach, [&](const ObstaclePiece& piece) {
            if (piece.moving) return;
            const SurfacePoint surface = closestSurfacePoint(piece, p);
            if (surface.distance < reach) visit(surface.point - p);
        });
        const Box sides = environment_.def().sides();
        for (const Vec2 way : {Vec2{sides.min.x - p.x, 0.0}, Vec2{sides.max.x - p.x, 0.0},
                               Vec2{0.0, sides.min.y - p.y}, Vec2{0.0, sides.max.y - p.y}})
            if (length(way) < reach) visit(way);
    }

    // True where two surfaces face each other across a point.
    bool isBetweenWalls(Vec2 p) const {
        std::array<Vec2, 16> ways;
        std::size_t count = 0;
        bool facing = false;
        forWalls(p, radius_ + kWallReach * grid_.cell, [&](Vec2 way) {
            const Vec2 unit = normalized(way);
            for (std::size_t k = 0; k < count; ++k) facing = facing || dot(ways[k], unit) < kFacingCosine;
            if (count < ways.size()) ways[count++] = unit;
        });
        return facing;
    }

    bool hasTwoWalls(Vec2 p, double reach) const {
        int walls = 0;
        forWalls(p, reach, [&](Vec2) { ++walls; });
        return walls > 1;
    }

    // The point of a narrow cell; none for other cells.
    std::optional<Vec2> pointOf(Cell c) const {
        const auto here = static_cast<double>(clearance_[grid_.index(c)]);
        if (here < radius_ - kToCorner * grid_.cell || here >= radius_) return {};
        // Most cells have one wall, and need no search for a point.
        const double reach = radius_ + (kWallReach + kToPoint) * grid_.cell;
        const Vec2 centre = grid_.centre(c);
        if (!hasTwoWalls(centre, reach) || hasNode(c)) return {};
        for (const Vec2 start : kStarts) {
            const std::optional<Vec2> point = ground_.roomiest(c, centre + start * grid_.cell);
            if (point && isBetweenWalls(*point)) return point;
        }
        return {};
    }

    // True where the raster gives a cell a node at which a body can be.
    bool hasNode(Cell c) const {
        const GroundNode node = nodes_.find(c);
        const double least = radius_ - kNodeDepth * grid_.cell;
        return node.free && environment_.distanceToObstacle(pointOf(c, node)) >= least;
    }

    bool addNarrow(Cell c, std::vector<NarrowCell>& found) const {
        const std::optional<Vec2> point = pointOf(c);
        if (point) found.push_back(narrowCell(c, *point));
        return point.has_value();
    }

    // Closes the edges from a free cell to cells beyond a thin wall.
    void addNextToWall(Cell c, std::vector<NarrowCell>& found) const {
        const float here = clearance_[grid_.index(c)];
        std::uint8_t open = kAllOpen;
        std::optional<GroundNode> own;
        for (std::size_t k = 0; k < std::size(kNarrowSteps); ++k) {
            const Cell other{c.x + kNarrowSteps[k].x, c.y + kNarrowSteps[k].y};
            if (!grid_.contains(other)) continue;
            // With more clearance no wall lies between the centres.
            if (static_cast<double>(here + clearance_[grid_.index(other)]) > grid_.cell) continue;
            if (!own) own = nodes_.find(c);
            if (!own->free) return;
            const GroundNode node = nodes_.find(other);
            if (node.free && isDivided(c, *own, other, node)) open ^= static_cast<std::uint8_t>(1u << k);
        }
        if (open != kAllOpen) found.push_back({grid_.index(c), 0.0f, 0.0f, open});
    }

    Vec2 pointOf(Cell c, const GroundNode& node) const {
        return environment_.def().box.clamp(grid_.centre(c) + Vec2{node.x, node.y} * grid_.cell);
    }

    bool isDivided(Cell a, const GroundNode& nodeA, Cell b, const GroundNode& nodeB) const {
        // Points on one side of a wall lie in the same direction from it.
        if (nodeA.normalX * nodeB.normalX + nodeA.normalY * nodeB.normalY > kSameSide) return false;
        return !environment_.clearStaticLine(pointOf(a, nodeA), pointOf(b, nodeB), 0.0);
    }

    // The point where a body stands in a neighbour of a narrow cell, if that is narrow or free.
    std::optional<Vec2> pointNextTo(Cell c) const {
        if (const std::optional<Vec2> point = pointOf(c)) return point;
        const GroundNode node = nodes_.find(c);
        if (!node.free) return {};
        const Vec2 own = pointOf(c, node);
        const auto reaches = [&](const std::optional<Vec2>& point) {
            return point && environment_.clearStaticLine(own, *point, kThinShare * radius_) &&
                   (gaps_.empty() || !gaps_.crossed(own, *point, *point));
        };
        std::optional<Vec2> point = ground_.roomiest(c, own);
        for (std::size_t k = 0; k < std::size(kStarts) && !reaches(point); ++k)
            point = ground_.roomiest(c, grid_.centre(c) + kStarts[k] * grid_.cell);
        return reaches(point) ? point : std::nullopt;
    }

    // True where a body can walk from a point to a near one, straight or with bends where the clearance is
    // largest.
    bool walkLeads(Vec2 from, Vec2 to, int halvings) const {
        const Vec2 middle = 0.5 * (from + to);
        if (ground_.lineClear(from, to)) return gaps_.empty() || !gaps_.crossed(from, to, middle);
        if (halvings == 0) return false;
        const std::optional<Vec2> over = ground_.roomiest(middle);
        return over && walkLeads(from, *over, halvings - 1) && walkLeads(*over, to, halvings - 1);
    }

    NarrowCell narrowCell(Cell c, Vec2 point) const {
        const Vec2 offset = (point - grid_.centre(c)) * (1.0 / grid_.cell);
        NarrowCell cell{grid_.index(c), static_cast<float>(offset.x), static_cast<float>(offset.y), 0};
        if (cell.x == 0.0f && cell.y == 0.0f) cell.x = kCentreOffset;
        for (std::size_t k = 0; k < std::size(kNarrowSteps); ++k) {
            const Cell other{c.x + kNarrowSteps[k].x, c.y + kNarrowSteps[k].y};
            if (!grid_.contains(other)) continue;
            const std::optional<Vec2> to = pointNextTo(other);
            if (to && walkLeads(point, *to, kHalvings)) cell.open |= static_cast<std::uint8_t>(1u << k);
        }
        return cell;
    }

    const Environment& environment_;
    const GapIndex& gaps_;
    const Grid& grid_;
    double radius_;
    std::span<const float> clearance_;
    GroundRasters rasters_;
    GroundNodeFinder nodes_;
    RouteGround ground_;
};

}  // namespace

void NarrowWays::reset(double radius) {
    radius_ = radius;
    cells_.clear();
}

void NarrowWays::update(const Environment& environment, const GapIndex& gaps, const CellRect& area) {
    if (area.empty()) return;
    const Grid& grid = environment.grid();
    std::erase_if(cells_, [&](const NarrowCell& narrow) {
        const Cell c = grid.at(narrow.cell);
        return !area.common({c, c}).empty();
    });
    const auto kept = static_cast<std::ptrdiff_t>(cells_.size());
    Finder(environment, gaps, radius_).run(area, cells_);
    std::inplace_merge(cells_.begin(), cells_.begin() + kept, cells_.end(),
                       [](const NarrowCell& a, const NarrowCell& b) { return a.cell < b.cell; });
}

std::span<const NarrowCell> NarrowWays::between(std::int32_t first, std::int32_t last) const {
    const auto from = std::partition_point(cells_.begin(), cells_.end(),
                                           [&](const NarrowCell& narrow) { return narrow.cell < first; });
    const auto to = std::partition_point(from, cells_.end(),
                                         [&](const NarrowCell& narrow) { return narrow.cell <= last; });
    return std::span(cells_).subspan(from - cells_.begin(), to - from);
}

const NarrowCell* NarrowWays::find(std::int32_t cell) const {
    const std::span<const NarrowCell> found = between(cell, cell);
    return found.empty() ? nullptr : found.data();
}

}  // namespace muster
