// Updates of the caches of an environment from its definitions and clock.
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "environment/environment_impl.h"

namespace muster {
namespace {

constexpr double kReachSlack = 1e-6;  // Boxes are grown by this beyond exact distances, against rounding [m].

Box unite(const Box& a, const Box& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

Box boundsOfPiece(const ObstaclePiece& piece) {
    if (!piece.corners.empty()) return boundsOf(piece.corners);
    return Box{piece.centre, piece.centre}.grown(piece.radius);
}

Box boundsOfEntry(const ObstacleEntry& entry) {
    if (entry.def.polygon.empty()) return Box{entry.def.centre, entry.def.centre}.grown(entry.def.radius);
    return boundsOf(entry.def.polygon);
}

// True where the open cell and the convex polygon share area: no edge line separates them.
bool touchesCell(const Polygon& corners, Vec2 centre, double half) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 edge = corners[i] - corners[j];
        const double depth = cross(edge, centre - corners[j]) +
                             half * (std::fabs(edge.x) + std::fabs(edge.y));
        if (depth <= 1e-9 * length(edge)) return false;
    }
    return true;
}

void widen(bool& any, Box& box, const Box& more) {
    box = any ? unite(box, more) : more;
    any = true;
}

}  // namespace

bool Placement::follow(const TimedPath& path, double time) {
    const Waypoint next = path.at(time);
    const Vec2 nextVelocity = path.velocity(time);
    const double nextAngularVelocity = path.angularVelocity(time);
    const bool same = next.position == now.position && next.angle == now.angle && nextVelocity == velocity &&
                      nextAngularVelocity == angularVelocity;
    if (next.angle != now.angle) rotation = {cosine(next.angle), sine(next.angle)};
    now = next;
    velocity = nextVelocity;
    angularVelocity = nextAngularVelocity;
    return !same;
}

void Environment::Impl::start(const EnvironmentDef& definition) {
    static std::atomic<std::uint64_t> made{0};
    instance = ++made;
    def = definition;
    grid = Grid::covering(def.box, def.cell);
    freshRasters = true;
    stale = true;
}

void Environment::Impl::markDirty(const ObstacleEntry& entry) {
    if (entry.def.path.still()) widen(obstaclesDirty, dirtyObstacles, boundsOfEntry(entry));
    stale = true;
}

void Environment::Impl::markDirty(const PatchEntry& entry) {
    if (entry.def.path.still()) widen(patchesDirty, dirtyPatches, boundsOf(entry.outline));
    stale = true;
}

void Environment::Impl::refresh() {
    const std::lock_guard lock(mutex);
    if (!stale.load(std::memory_order_relaxed)) return;
    const CellRect all{{0, 0}, {grid.width - 1, grid.height - 1}};
    CellRect clearanceArea, speedArea;
    if (freshRasters) {
        clearance.reset(grid, static_cast<float>(kClearanceLimit));
        patchSpeed.reset(grid, kNoPatch);
        travelSpeed.assign(grid.count(), 1.0f);
        for (PieceIndex* pieceIndex : {&index, &patchIndex}) {
            pieceIndex->fixedGrid.reset(def.box);
            pieceIndex->movingGrid.reset(def.box);
        }
        clearanceArea = speedArea = all;
        freshRasters = false;
    } else {
        if (obstaclesDirty)
            clearanceArea = CellRect::touching(grid, dirtyObstacles.grown(kReach + kReachSlack));
        if (patchesDirty) speedArea = CellRect::touching(grid, dirtyPatches.grown(kReachSlack));
    }
    obstaclesDirty = patchesDirty = false;
    rebuildPieces();
    rebuildPatchPieces();
    clearance.removeMoving();
    rebuildFixedClearance(clearanceArea);
    addMovingClearance();
    if (!clearanceArea.empty()) components.clear();
    for (const CellRect& rect : patchSpeed.removeMoving()) updateTravelSpeed(rect);
    rebuildFixedSpeed(speedArea);
    addMovingSpeed();
    stale.store(false, std::memory_order_release);
}

void Environment::Impl::rebuildPieces() {
    pieces.clear();
    pieceEntry.clear();
    piecePart.clear();
    index.fixed.clear();
    index.moving.clear();
    for (std::size_t e = 0; e < obstacles.size(); ++e) {
        const std::size_t parts = std::max<std::size_t>(1, obstacles[e].parts.size());
        for (std::size_t k = 0; k < parts; ++k) {
            const bool moves = !obstacles[e].def.path.still();
            (moves ? index.moving : index.fixed).push_back(static_cast<std::int32_t>(pieces.size()));
            pieceEntry.push_back(static_cast<std::int32_t>(e));
            piecePart.push_back(static_cast<std::int32_t>(k));
            pieces.emplace_back();
        }
    }
    index.bounds.resize(pieces.size());
    index.reach.resize(pieces.size());
    for (std::size_t number = 0; number < pieces.size(); ++number)
        updatePiece(static_cast<std::int32_t>(number));
    index.fixedGrid.fill(index.reach, index.fixed);
    index.movingGrid.fill(index.reach, index.moving);
}

void Environment::Impl::updatePiece(std::int32_t number) {
    const std::int32_t e = pieceEntry[number];
    const ObstacleEntry& entry = obstacles[e];
    const Placement& placement = entry.placement;
    ObstaclePiece& piece = pieces[number];
    piece.obstacle = obstacleIds[e];
    piece.range = entry.def.range < 0.0 ? def.defaultRange : entry.def.range;
    piece.strength = entry.def.strength < 0.0 ? def.defaultStrength : entry.def.strength;
    piece.moving = !entry.def.path.still();
    if (entry.parts.empty()) {
        piece.centre = placement.apply(entry.def.centre);
        piece.radius = entry.def.radius;
    } else {
        const Polygon& part = entry.parts[piecePart[number]];
        piece.corners.resize(part.size());
        for (std::size_t i = 0; i < part.size(); ++i)
            piece.corners[i] = piece.moving ? placement.apply(part[i]) : part[i];
        piece.centre = centroid(piece.corners);
        double squared = 0.0;
        for (Vec2 p : piece.corners) squared = std::max(squared, lengthSquared(p - piece.centre));
        piece.radius = std::sqrt(squared);
    }
    piece.velocity = placement.velocity +
                     perpendicular(piece.centre - placement.pivot - placement.now.position) *
                         placement.angularVelocity;
    index.bounds[number] = boundsOfPiece(piece);
    index.reach[number] = index.bounds[number].grown(std::max(kReach, piece.range) + kReachSlack);
}

void Environment::Impl::rebuildPatchPieces() {
    patchPieces.clear();
    patchPart.clear();
    patchIndex.fixed.clear();
    patchIndex.moving.clear();
    for (std::size_t e = 0; e < patches.size(); ++e) {
        for (std::size_t k = 0; k < patches[e].parts.size(); ++k) {
            const bool moves = !patches[e].def.path.still();
            (moves ? patchIndex.moving : patchIndex.fixed)
                .push_back(static_cast<std::int32_t>(patchPieces.size()));
            patchPart.push_back(static_cast<std::int32_t>(k));
            patchPieces.push_back({{}, static_cast<std::int32_t>(e)});
        }
    }
    patchIndex.bounds.resize(patchPieces.size());
    patchIndex.reach.resize(patchPieces.size());
    for (std::size_t number = 0; number < patchPieces.size(); ++number) {
        updatePatchPiece(static_cast<std::int32_t>(number));
    }
    patchIndex.fixedGrid.fill(patchIndex.reach, patchIndex.fixed);
    patchIndex.movingGrid.fill(patchIndex.reach, patchIndex.moving);
}

void Environment::Impl::updatePatchPiece(std::int32_t number) {
    PatchPiece& piece = patchPieces[number];
    const PatchEntry& entry = patches[piece.patch];
    const Polygon& part = entry.parts[patchPart[number]];
    const bool moves = !entry.def.path.still();
    piece.corners.resize(part.size());
    for (std::size_t i = 0; i < part.size(); ++i)
        piece.corners[i] = moves ? entry.placement.apply(part[i]) : part[i];
    patchIndex.bounds[number] = boundsOf(piece.corners);
    patchIndex.reach[number] = patchIndex.bounds[number].grown(kReachSlack);
}

void Environment::Impl::rebuildFixedClearance(const CellRect& area) {
    if (area.empty()) return;
    const Box& box = def.box;
    clearance.setFixed(area, [&](Cell c) {
        const Vec2 p = grid.centre(c);
        const double inside = std::min(std::min(p.x - box.min.x, box.max.x - p.x),
                                       std::min(p.y - box.min.y, box.max.y - p.y));
        return static_cast<float>(std::min(inside, kClearanceLimit));
    });
    for (std::int32_t number : index.fixed) {
        const CellRect rect = CellRect::touching(grid, index.bounds[number].grown(kReach + kReachSlack))
                                  .common(area);
        clearance.lowerFixed(rect,
                             [&](Cell c, float now) { return lowerDistance(number, grid.centre(c), now); });
    }
    clearance.restoreFixed(area);
}

void Environment::Impl::rebuildFixedSpeed(const CellRect& area) {
    if (area.empty()) return;
    patchSpeed.setFixed(area, [](Cell) { return kNoPatch; });
    for (std::int32_t number : patchIndex.fixed) {
        const CellRect rect = CellRect::touching(grid, patchIndex.reach[number]).common(area);
        const PatchPiece& piece = patchPieces[number];
        const auto speed = static_cast<float>(patches[piece.patch].speed);
        patchSpeed.lowerFixed(rect, [&](Cell c, float) {
            return touchesCell(piece.corners, grid.centre(c), 0.5 * grid.cell) ? speed : kNoPatch;
        });
    }
    patchSpeed.restoreFixed(area);
    updateTravelSpeed(area);
}

// The distance from `p` to a piece, or `now` where the piece's box is clearly farther than that.
float Environment::Impl::lowerDistance(std::int32_t number, Vec2 p, float now) const {
    const double squared = squaredDistance(index.bounds[number], p);
    const double bound = now + 1e-5;
    if (squared > 0.0 && (bound < 0.0 || squared > bound * bound)) return now;
    return static_cast<float>(pieces[number].signedDistance(p));
}

void Environment::Impl::addMovingClearance() {
    for (std::int32_t number : index.moving) {
        const CellRect rect = CellRect::touching(grid, index.bounds[number].grown(kReach + kReachSlack));
        clearance.lowerCombined(
            rect, [&](Cell c, float now) { return lowerDistance(number, grid.centre(c), now); });
    }
}

void Environment::Impl::addMovingSpeed() {
    for (std::int32_t number : patchIndex.moving) {
        const CellRect rect = CellRect::touching(grid, patchIndex.reach[number]);
        const PatchPiece& piece = patchPieces[number];
        const auto speed = static_cast<float>(patches[piece.patch].speed);
        patchSpeed.lowerCombined(rect, [&](Cell c, float) {
            return touchesCell(piece.corners, grid.centre(c), 0.5 * grid.cell) ? speed : kNoPatch;
        });
    }
    for (const CellRect& rect : patchSpeed.movingAreas()) updateTravelSpeed(rect);
}

void Environment::Impl::updateTravelSpeed(const CellRect& rect) {
    const std::span<const float> speeds = patchSpeed.combined();
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            const std::int32_t i = grid.index({x, y});
            travelSpeed[i] = speeds[i] == kNoPatch ? 1.0f : speeds[i];
        }
    }
}

// Called before moving things move, and after.
void Environment::Impl::appendMovingAreas() {
    for (const LayeredRaster* layer : {&clearance, &patchSpeed})
        changes.insert(changes.end(), layer->movingAreas().begin(), layer->movingAreas().end());
}

void Environment::Impl::moveThings() {
    changes.clear();
    appendMovingAreas();
    for (std::int32_t number : index.moving) updatePiece(number);
    index.movingGrid.fill(index.reach, index.moving);
    clearance.removeMoving();
    addMovingClearance();
    for (std::int32_t number : patchIndex.moving) updatePatchPiece(number);
    patchIndex.movingGrid.fill(patchIndex.reach, patchIndex.moving);
    for (const CellRect& rect : patchSpeed.removeMoving()) updateTravelSpeed(rect);
    addMovingSpeed();
    appendMovingAreas();
}

}  // namespace muster
