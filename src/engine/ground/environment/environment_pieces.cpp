// The convex pieces of obstacles and patches, and the grids that find them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bounds.h"
#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

Box boundsOfPiece(const ObstaclePiece& piece) {
    if (!piece.corners.empty()) return boundsOf(piece.corners);
    return Box{piece.centre, piece.centre}.grown(piece.radius);
}

// True for a rectangle whose sides are parallel to the axes.
bool fillsBox(const Polygon& corners, const Box& box) {
    if (corners.size() != 4) return false;
    for (std::size_t i = 0, j = 3; i < 4; j = i++) {
        const Vec2 p = corners[i];
        const bool atCorner = (p.x == box.min.x || p.x == box.max.x) &&
                              (p.y == box.min.y || p.y == box.max.y);
        if (!atCorner || p == corners[j] || (p.x != corners[j].x && p.y != corners[j].y)) return false;
    }
    return true;
}

}  // namespace

void Environment::Impl::refreshPieces() {
    if (piecesStale) return rebuildPieces();
    for (const std::int32_t number : index.moving) updatePiece(number);
    index.movingGrid.fill(index.reach, index.moving);
}

void Environment::Impl::rebuildPieces() {
    piecesStale = false;
    pieces.clear();
    pieceEntry.clear();
    piecePart.clear();
    index.fixed.clear();
    index.moving.clear();
    for (std::size_t e = 0; e < obstacles.size(); ++e) {
        for (std::size_t k = 0; k < pieceCount(obstacles[e]); ++k) {
            const bool moves = !obstacles[e].def.path.still();
            (moves ? index.moving : index.fixed).push_back(static_cast<std::int32_t>(pieces.size()));
            pieceEntry.push_back(static_cast<std::int32_t>(e));
            piecePart.push_back(static_cast<std::int32_t>(k));
            pieces.emplace_back();
        }
    }
    index.bounds.resize(pieces.size());
    index.reach.resize(pieces.size());
    index.isBox.resize(pieces.size());
    for (std::size_t number = 0; number < pieces.size(); ++number)
        updatePiece(static_cast<std::int32_t>(number));
    index.fixedGrid.fill(index.reach, index.fixed);
    index.movingGrid.fill(index.reach, index.moving);
}

// Makes room for `after` pieces instead of `before` from `first` on, and renumbers the pieces behind them.
void Environment::Impl::resizePieces(std::size_t first, std::size_t before, std::size_t after) {
    const auto resize = [&](auto& list) {
        const auto at = list.begin() + static_cast<std::ptrdiff_t>(first);
        if (after > before)
            list.insert(at, after - before, {});
        else
            list.erase(at, at + static_cast<std::ptrdiff_t>(before - after));
    };
    resize(pieces);
    resize(pieceEntry);
    resize(piecePart);
    resize(index.bounds);
    resize(index.reach);
    resize(index.isBox);
    const auto behind = static_cast<std::int32_t>(first + before);
    const auto by = static_cast<std::int32_t>(after) - static_cast<std::int32_t>(before);
    for (std::vector<std::int32_t>* list : {&index.fixed, &index.moving})
        for (std::int32_t& number : *list) number += number >= behind ? by : 0;
    if (by != 0 && std::cmp_less(behind + by, pieces.size())) index.fixedGrid.renumber(behind, by);
}

void Environment::Impl::replacePieces(std::size_t entry, std::size_t before, bool removed) {
    if (freshRasters || piecesStale) return;
    const auto e = static_cast<std::int32_t>(entry);
    const auto first = std::lower_bound(pieceEntry.begin(), pieceEntry.end(), e) - pieceEntry.begin();
    const auto low = static_cast<std::int32_t>(first);
    const auto high = low + static_cast<std::int32_t>(before);
    for (std::int32_t number = low; number < high; ++number)
        if (!pieces[number].moving) index.fixedGrid.remove(index.reach[number], number);
    const auto replaced = [&](std::int32_t number) { return number >= low && number < high; };
    for (std::vector<std::int32_t>* list : {&index.fixed, &index.moving})
        list->erase(std::remove_if(list->begin(), list->end(), replaced), list->end());
    const std::size_t after = removed ? 0 : pieceCount(obstacles[entry]);
    resizePieces(first, before, after);
    if (removed)
        for (std::size_t k = first; k < pieceEntry.size(); ++k) --pieceEntry[k];
    std::vector<std::int32_t>& list = !removed && obstacles[entry].def.path.still() ? index.fixed
                                                                                    : index.moving;
    for (std::size_t k = 0; k < after; ++k) {
        const auto number = low + static_cast<std::int32_t>(k);
        pieceEntry[number] = e;
        piecePart[number] = static_cast<std::int32_t>(k);
        pieces[number] = {};
        updatePiece(number);
        list.insert(std::lower_bound(list.begin(), list.end(), number), number);
        if (!pieces[number].moving) index.fixedGrid.insert(index.reach[number], number);
    }
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
    index.isBox[number] = fillsBox(piece.corners, index.bounds[number]) ? 1 : 0;
    index.reach[number] = index.bounds[number].grown(std::max(kReach, piece.range) + kReachSlack);
}

void Environment::Impl::refreshPatchPieces() {
    if (patchPiecesStale) return rebuildPatchPieces();
    for (const std::int32_t number : patchIndex.moving) updatePatchPiece(number);
    patchIndex.movingGrid.fill(patchIndex.reach, patchIndex.moving);
}

void Environment::Impl::rebuildPatchPieces() {
    patchPiecesStale = false;
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

}  // namespace muster
