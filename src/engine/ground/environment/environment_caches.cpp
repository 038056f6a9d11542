// Updates of the caches of an environment from its definitions and clock.
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

constexpr std::size_t kMaxStaticEdits = 256;  // Number of edits that are remembered.

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
    staticEdits.clear();
    staticEditsFrom = staticPatchVersion = staticVersion;
}

void Environment::Impl::markDirty(const ObstacleEntry& entry) {
    stale = true;
    if (!entry.def.path.still()) return;
    const Box box = boundsOfEntry(entry).grown(kReach + kReachSlack);
    if (!freshRasters) dirtyObstacles.push_back(box);
    noteStaticEdit(box);
}

void Environment::Impl::markDirty(const PatchEntry& entry) {
    stale = patchPiecesStale = true;
    if (!entry.def.path.still()) return;
    const Box box = boundsOf(entry.outline).grown(kReachSlack);
    if (!freshRasters) dirtyPatches.push_back(box);
    noteStaticEdit(box);
    staticPatchVersion = staticVersion + 1;
}

void Environment::Impl::noteStaticEdit(const Box& box) {
    if (staticEdits.size() >= kMaxStaticEdits) {
        const auto half = staticEdits.begin() + kMaxStaticEdits / 2;
        staticEditsFrom = (half - 1)->version;
        staticEdits.erase(staticEdits.begin(), half);
    }
    staticEdits.push_back({staticVersion + 1, CellRect::touching(grid, box)});
}

void Environment::Impl::refresh() {
    const std::lock_guard lock(mutex);
    if (!stale.load(std::memory_order_relaxed)) return;
    std::vector<CellRect> clearanceAreas, speedAreas;
    if (freshRasters) {
        const CellRect all{{0, 0}, {grid.width - 1, grid.height - 1}};
        clearance.reset(grid, static_cast<float>(kClearanceLimit));
        clearance.allocate();
        patchSpeed.reset(grid, kNoPatch);
        travelSpeed = {};
        for (PieceIndex* pieceIndex : {&index, &patchIndex}) {
            pieceIndex->fixedGrid.reset(def.box);
            pieceIndex->movingGrid.reset(def.box);
        }
        clearanceAreas.push_back(all);
        speedAreas.push_back(all);
        piecesStale = patchPiecesStale = true;
        freshRasters = false;
    } else {
        for (const Box& box : dirtyObstacles) clearanceAreas.push_back(CellRect::touching(grid, box));
        for (const Box& box : dirtyPatches) speedAreas.push_back(CellRect::touching(grid, box));
    }
    dirtyObstacles.clear();
    dirtyPatches.clear();
    refreshPieces();
    refreshPatchPieces();
    clearance.removeMoving();
    for (const CellRect& area : clearanceAreas) rebuildFixedClearance(area);
    addMovingClearance();
    for (const CellRect& rect : patchSpeed.removeMoving()) updateTravelSpeed(rect);
    for (const CellRect& area : speedAreas) rebuildFixedSpeed(area);
    addMovingSpeed();
    dropUnusedRasters();
    stale.store(false, std::memory_order_release);
}

void Environment::Impl::dropUnusedRasters() {
    if (index.moving.empty()) clearance.dropCombined();
    if (patchIndex.moving.empty()) patchSpeed.dropCombined();
    if (!patchPieces.empty()) return;
    patchSpeed.reset(grid, kNoPatch);
    travelSpeed = {};
}

// Fills in the distance to the border of the world, up to the limit.
void Environment::Impl::fillBorderClearance(const CellRect& area) {
    const Box box = def.sides();
    const auto distanceToBorder = [&](Cell c) {
        const Vec2 p = grid.centre(c);
        const double inside = std::min(std::min(p.x - box.min.x, box.max.x - p.x),
                                       std::min(p.y - box.min.y, box.max.y - p.y));
        return static_cast<float>(std::min(inside, kClearanceLimit));
    };
    const Box middle = box.grown(-kClearanceLimit - grid.cell);
    if (!(middle.min.x < middle.max.x && middle.min.y < middle.max.y))
        return clearance.setFixed(area, distanceToBorder);
    const CellRect inner = CellRect::touching(grid, middle).common(area);
    if (inner.empty()) return clearance.setFixed(area, distanceToBorder);
    clearance.fillFixed(inner, static_cast<float>(kClearanceLimit));
    clearance.setFixed({area.low, {area.high.x, inner.low.y - 1}}, distanceToBorder);
    clearance.setFixed({{area.low.x, inner.high.y + 1}, area.high}, distanceToBorder);
    clearance.setFixed({{area.low.x, inner.low.y}, {inner.low.x - 1, inner.high.y}}, distanceToBorder);
    clearance.setFixed({{inner.high.x + 1, inner.low.y}, {area.high.x, inner.high.y}}, distanceToBorder);
}

void Environment::Impl::rebuildFixedClearance(const CellRect& area) {
    if (area.empty()) return;
    fillBorderClearance(area);
    for (std::int32_t number : index.fixed) {
        const CellRect rect = CellRect::touching(grid, index.bounds[number].grown(kReach + kReachSlack))
                                  .common(area);
        clearance.lowerFixed(rect,
                             [&](Cell c, float now) { return lowerDistance(number, grid.centre(c), now); });
    }
    clearance.restoreFixed(area);
}

void Environment::Impl::rebuildFixedSpeed(const CellRect& area) {
    if (area.empty() || patchPieces.empty()) return;
    patchSpeed.fillFixed(area, kNoPatch);
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
    if (index.isBox[number] != 0) {
        const Box& box = index.bounds[number];
        if (squared > 0.0) return static_cast<float>(std::sqrt(squared));
        return static_cast<float>(
            -std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y}));
    }
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
    if (travelSpeed.empty()) travelSpeed.assign(grid.count(), 1.0f);
    const std::span<const float> speeds = patchSpeed.combined();
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            const std::int32_t i = grid.index({x, y});
            travelSpeed[i] = speeds[i] == kNoPatch ? 1.0f : speeds[i];
        }
    }
}

// Appends the areas of moving things; called before they move, and after.
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
