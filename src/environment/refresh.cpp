// Keeps the caches of an environment true to its definitions and clock.
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "environment/environment_state.h"

namespace muster {
namespace {

constexpr double kBinSlack = 1e-6;  // [m] Bins list a little more than exact distances ask for.

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

// True where the open cell and the convex polygon share area: no edge has the cell on its outer side.
bool touchesCell(const Polygon& corners, Vec2 centre, double half) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 edge = corners[i] - corners[j];
        const double inward = cross(edge, centre - corners[j]) +
                              half * (std::fabs(edge.x) + std::fabs(edge.y));
        if (inward <= 1e-9 * length(edge)) return false;
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

void Environment::Impl::noteObstacle(const ObstacleEntry& entry) {
    if (entry.def.path.still()) widen(obstaclesDirty, dirtyObstacles, boundsOfEntry(entry));
    stale = true;
}

void Environment::Impl::notePatch(const PatchEntry& entry) {
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
        slowest.reset(grid, kNoPatch);
        travelSpeed.assign(static_cast<std::size_t>(grid.count()), 1.0f);
        for (PieceIndex* pieceIndex : {&index, &patchIndex}) {
            pieceIndex->stillBins.reset(def.box);
            pieceIndex->movingBins.reset(def.box);
        }
        clearanceArea = speedArea = all;
        freshRasters = false;
    } else {
        if (obstaclesDirty)
            clearanceArea = CellRect::touching(grid, dirtyObstacles.grown(kReach + kBinSlack));
        if (patchesDirty) speedArea = CellRect::touching(grid, dirtyPatches.grown(kBinSlack));
    }
    obstaclesDirty = patchesDirty = false;
    rebuildPieces();
    rebuildPatchPieces();
    clearance.uncover();
    rebuildStillClearance(clearanceArea);
    coverClearance();
    if (!clearanceArea.empty()) regions.clear();
    for (const CellRect& rect : slowest.uncover()) copySpeed(rect);
    rebuildStillSpeed(speedArea);
    coverSpeed();
    stale.store(false, std::memory_order_release);
}

void Environment::Impl::rebuildPieces() {
    pieces.clear();
    pieceEntry.clear();
    piecePart.clear();
    index.still.clear();
    index.moving.clear();
    for (std::size_t e = 0; e < obstacles.size(); ++e) {
        const std::size_t parts = std::max<std::size_t>(1, obstacles[e].parts.size());
        for (std::size_t k = 0; k < parts; ++k) {
            const bool moves = !obstacles[e].def.path.still();
            (moves ? index.moving : index.still).push_back(static_cast<std::int32_t>(pieces.size()));
            pieceEntry.push_back(static_cast<std::int32_t>(e));
            piecePart.push_back(static_cast<std::int32_t>(k));
            pieces.emplace_back();
        }
    }
    index.bounds.resize(pieces.size());
    index.reach.resize(pieces.size());
    for (std::size_t number = 0; number < pieces.size(); ++number)
        placePiece(static_cast<std::int32_t>(number));
    index.stillBins.fill(index.reach, index.still);
    index.movingBins.fill(index.reach, index.moving);
}

void Environment::Impl::placePiece(std::int32_t number) {
    const std::int32_t e = pieceEntry[number];
    const ObstacleEntry& entry = obstacles[e];
    const Placement& at = entry.placement;
    ObstaclePiece& piece = pieces[number];
    piece.obstacle = obstacleIds[e];
    piece.range = entry.def.range < 0.0 ? def.defaultRange : entry.def.range;
    piece.strength = entry.def.strength < 0.0 ? def.defaultStrength : entry.def.strength;
    piece.moving = !entry.def.path.still();
    if (entry.parts.empty()) {
        piece.centre = at.apply(entry.def.centre);
        piece.radius = entry.def.radius;
    } else {
        const Polygon& part = entry.parts[piecePart[number]];
        piece.corners.resize(part.size());
        for (std::size_t i = 0; i < part.size(); ++i)
            piece.corners[i] = piece.moving ? at.apply(part[i]) : part[i];
        piece.centre = centroid(piece.corners);
        double squared = 0.0;
        for (Vec2 p : piece.corners) squared = std::max(squared, lengthSquared(p - piece.centre));
        piece.radius = std::sqrt(squared);
    }
    piece.velocity = at.velocity +
                     perpendicular(piece.centre - at.pivot - at.now.position) * at.angularVelocity;
    index.bounds[number] = boundsOfPiece(piece);
    index.reach[number] = index.bounds[number].grown(std::max(kReach, piece.range) + kBinSlack);
}

void Environment::Impl::rebuildPatchPieces() {
    patchPieces.clear();
    patchPart.clear();
    patchIndex.still.clear();
    patchIndex.moving.clear();
    for (std::size_t e = 0; e < patches.size(); ++e) {
        for (std::size_t k = 0; k < patches[e].parts.size(); ++k) {
            const bool moves = !patches[e].def.path.still();
            (moves ? patchIndex.moving : patchIndex.still)
                .push_back(static_cast<std::int32_t>(patchPieces.size()));
            patchPart.push_back(static_cast<std::int32_t>(k));
            patchPieces.push_back({{}, static_cast<std::int32_t>(e)});
        }
    }
    patchIndex.bounds.resize(patchPieces.size());
    patchIndex.reach.resize(patchPieces.size());
    for (std::size_t number = 0; number < patchPieces.size(); ++number) {
        placePatchPiece(static_cast<std::int32_t>(number));
    }
    patchIndex.stillBins.fill(patchIndex.reach, patchIndex.still);
    patchIndex.movingBins.fill(patchIndex.reach, patchIndex.moving);
}

void Environment::Impl::placePatchPiece(std::int32_t number) {
    PatchPiece& piece = patchPieces[number];
    const PatchEntry& entry = patches[piece.patch];
    const Polygon& part = entry.parts[patchPart[number]];
    const bool moves = !entry.def.path.still();
    piece.corners.resize(part.size());
    for (std::size_t i = 0; i < part.size(); ++i)
        piece.corners[i] = moves ? entry.placement.apply(part[i]) : part[i];
    patchIndex.bounds[number] = boundsOf(piece.corners);
    patchIndex.reach[number] = patchIndex.bounds[number].grown(kBinSlack);
}

void Environment::Impl::rebuildStillClearance(const CellRect& area) {
    if (area.empty()) return;
    const Box& box = def.box;
    clearance.setStill(area, [&](Cell c) {
        const Vec2 p = grid.centre(c);
        const double inside = std::min(std::min(p.x - box.min.x, box.max.x - p.x),
                                       std::min(p.y - box.min.y, box.max.y - p.y));
        return static_cast<float>(std::min(inside, kClearanceLimit));
    });
    for (std::int32_t number : index.still) {
        const CellRect rect = CellRect::touching(grid, index.bounds[number].grown(kReach + kBinSlack))
                                  .common(area);
        clearance.lowerStill(rect,
                             [&](Cell c, float now) { return distanceBelow(number, grid.centre(c), now); });
    }
    clearance.copyStill(area);
}

void Environment::Impl::rebuildStillSpeed(const CellRect& area) {
    if (area.empty()) return;
    slowest.setStill(area, [](Cell) { return kNoPatch; });
    for (std::int32_t number : patchIndex.still) {
        const CellRect rect = CellRect::touching(grid, patchIndex.reach[number]).common(area);
        const PatchPiece& piece = patchPieces[number];
        const auto speed = static_cast<float>(patches[piece.patch].speed);
        slowest.lowerStill(rect, [&](Cell c, float) {
            return touchesCell(piece.corners, grid.centre(c), 0.5 * grid.cell) ? speed : kNoPatch;
        });
    }
    slowest.copyStill(area);
    copySpeed(area);
}

// A piece's distance, or `now` where the piece's box alone is clearly farther than that.
float Environment::Impl::distanceBelow(std::int32_t number, Vec2 p, float now) const {
    const double far = squaredDistance(index.bounds[number], p);
    const double bound = now + 1e-5;
    if (far > 0.0 && (bound < 0.0 || far > bound * bound)) return now;
    return static_cast<float>(pieces[number].signedDistance(p));
}

void Environment::Impl::coverClearance() {
    for (std::int32_t number : index.moving) {
        const CellRect rect = CellRect::touching(grid, index.bounds[number].grown(kReach + kBinSlack));
        clearance.lowerLive(rect,
                            [&](Cell c, float now) { return distanceBelow(number, grid.centre(c), now); });
    }
}

void Environment::Impl::coverSpeed() {
    for (std::int32_t number : patchIndex.moving) {
        const CellRect rect = CellRect::touching(grid, patchIndex.reach[number]);
        const PatchPiece& piece = patchPieces[number];
        const auto speed = static_cast<float>(patches[piece.patch].speed);
        slowest.lowerLive(rect, [&](Cell c, float) {
            return touchesCell(piece.corners, grid.centre(c), 0.5 * grid.cell) ? speed : kNoPatch;
        });
    }
    for (const CellRect& rect : slowest.covered()) copySpeed(rect);
}

void Environment::Impl::copySpeed(const CellRect& rect) {
    const std::span<const float> live = slowest.live();
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            const std::int32_t i = grid.index({x, y});
            travelSpeed[i] = live[i] == kNoPatch ? 1.0f : live[i];
        }
    }
}

// Where moving things lie: before they move, and after.
void Environment::Impl::noteCovered() {
    for (const RasterLayer* layer : {&clearance, &slowest})
        changes.insert(changes.end(), layer->covered().begin(), layer->covered().end());
}

void Environment::Impl::moveThings() {
    changes.clear();
    noteCovered();
    for (std::int32_t number : index.moving) placePiece(number);
    index.movingBins.fill(index.reach, index.moving);
    clearance.uncover();
    coverClearance();
    for (std::int32_t number : patchIndex.moving) placePatchPiece(number);
    patchIndex.movingBins.fill(patchIndex.reach, patchIndex.moving);
    for (const CellRect& rect : slowest.uncover()) copySpeed(rect);
    coverSpeed();
    noteCovered();
}

}  // namespace muster
