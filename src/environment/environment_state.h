// What stands behind Environment: definitions, and the caches made of them.
#pragma once

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>

#include "environment/box_bins.h"
#include "environment/environment.h"
#include "environment/raster_layer.h"
#include "environment/region_labels.h"

namespace muster {

/// A definition that follows a path, and where it stands now.
struct Placement {
    Vec2 pivot;                    ///< Turns about here [m].
    Waypoint now;                  ///< Offset and turn now.
    Vec2 velocity;                 ///< [m/s]
    double angularVelocity = 0.0;  ///< [rad/s]
    Rotation rotation;             ///< Of now.angle.

    /// Follows `path` to `time`; true where anything changed.
    bool follow(const TimedPath& path, double time);
    /// A defined point where it stands now.
    Vec2 apply(Vec2 p) const { return pivot + rotation.apply(p - pivot) + now.position; }
};

/// An obstacle with its convex parts as defined.
struct ObstacleEntry {
    ObstacleDef def;
    std::vector<Polygon> parts;  ///< Empty for a disc.
    Placement placement;
};

/// A patch with its convex parts as defined.
struct PatchEntry {
    PatchDef def;
    Polygon outline;  ///< Cleaned.
    std::vector<Polygon> parts;
    Placement placement;
    double speed = 1.0;
};

/// One convex part of a patch as it stands now.
struct PatchPiece {
    Polygon corners;
    std::int32_t patch = 0;  ///< Index of its entry.
};

/// Boxes of pieces, sorted by whether they move, in bins.
struct PieceIndex {
    std::vector<Box> bounds;           ///< Of each piece.
    std::vector<Box> reach;            ///< Grown by how far a piece acts.
    std::vector<std::int32_t> still;   ///< Numbers of pieces that never move.
    std::vector<std::int32_t> moving;  ///< Numbers of those that may.
    BoxBins stillBins;
    BoxBins movingBins;

    /// Calls `visit(number)` in ascending order for all pieces that act at `p`, a point of the world.
    template <class Visit>
    void forPiecesAt(Vec2 p, const Visit& visit) const {
        const std::span<const std::int32_t> a = stillBins.at(p);
        const std::span<const std::int32_t> b = movingBins.at(p);
        std::size_t i = 0, j = 0;
        while (i < a.size() || j < b.size()) {
            if (j == b.size() || (i < a.size() && a[i] < b[j])) {
                visit(a[i++]);
            } else {
                visit(b[j++]);
            }
        }
    }
};

/// Squared distance from a point to a box; 0 inside.
inline double squaredDistance(const Box& box, Vec2 p) {
    return lengthSquared(box.clamp(p) - p);
}

/// Edits mark the caches stale; the next query or setTime() brings them up to date.
struct Environment::Impl {
    EnvironmentDef def;
    Grid grid;
    double time = 0.0;
    std::vector<ObstacleId> obstacleIds;
    std::vector<ObstacleEntry> obstacles;  // In the order of ids.
    std::vector<PatchId> patchIds;
    std::vector<PatchEntry> patches;  // In the order of ids.
    std::uint32_t nextObstacle = 1;
    std::uint32_t nextPatch = 1;
    std::uint64_t groundVersion = 0;
    std::uint64_t staticVersion = 0;
    std::uint64_t instance = 0;

    // Caches.
    static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
    std::uint64_t changesFrom = kUnknown;  // The version from which `changes` lead to the present.
    std::vector<CellRect> changes;
    std::atomic<bool> stale{true};
    std::mutex mutex;
    bool freshRasters = true;          // Nothing in the rasters holds yet.
    Box dirtyObstacles, dirtyPatches;  // Where what stands still changed since the last refresh.
    bool obstaclesDirty = false, patchesDirty = false;
    std::vector<ObstaclePiece> pieces;
    std::vector<std::int32_t> pieceEntry;  // Index of each piece's entry.
    std::vector<std::int32_t> piecePart;   // Number within the entry.
    PieceIndex index;
    std::vector<PatchPiece> patchPieces;
    std::vector<std::int32_t> patchPart;
    PieceIndex patchIndex;
    RasterLayer clearance;
    RasterLayer slowest;  // Infinity where no patch lies.
    std::vector<float> travelSpeed;
    RegionLabels regions;

    /// How far pieces are listed beyond their box [m].
    static constexpr double kReach = kClearanceLimit;
    /// Slack of contact tests: a disc set exactly against a surface counts as free [m].
    static constexpr double kTouch = 1e-7;
    /// What float rounding may take off a clearance [m].
    static constexpr double kFloatSlack = 1e-6;
    /// Of `slowest` where no patch lies.
    static constexpr float kNoPatch = std::numeric_limits<float>::infinity();

    void start(const EnvironmentDef& definition);
    /// Reads or writes the definitions, ids and clock; only a reader fills the two lists.
    template <class Archive>
    void visit(Archive& archive, std::vector<ObstacleDef>& obstacleDefs, std::vector<PatchDef>& patchDefs);
    /// Counts an edit; `still` where something that stands still is part of it.
    void countEdit(bool still) {
        ++groundVersion;
        if (still) ++staticVersion;
        changesFrom = kUnknown;
    }
    void noteObstacle(const ObstacleEntry& entry);
    void notePatch(const PatchEntry& entry);
    void refresh();
    void ensure() {
        if (stale.load(std::memory_order_acquire)) refresh();
    }
    void moveThings();
    void noteCovered();

    void rebuildPieces();
    void rebuildPatchPieces();
    void placePiece(std::int32_t number);
    void placePatchPiece(std::int32_t number);
    void rebuildStillClearance(const CellRect& area);
    void rebuildStillSpeed(const CellRect& area);
    float distanceBelow(std::int32_t number, Vec2 p, float now) const;
    void coverClearance();
    void coverSpeed();
    void copySpeed(const CellRect& rect);

    bool inBox(Vec2 p) const { return def.box.contains(p); }
    /// The box that a disc's centre must keep to.
    Box roomFor(double radius) const;
    bool blockedLine(Vec2 a, Vec2 b, double radius) const;
    /// Distance from `p` to the nearest surface [m], negative inside, `limit` where farther.
    double distanceTo(Vec2 p, double limit) const {
        return shownFar(p, limit) ? limit : exactDistance(p, limit);
    }
    double exactDistance(Vec2 p, double limit) const;
    /// A lower bound of the distance from `p` to the nearest surface, from the raster; no bound
    /// (minus infinity) off the grid.
    double roughDistance(Vec2 p) const;
    /// True where the raster shows that every surface is at least `limit` [m] away.
    bool shownFar(Vec2 p, double limit) const {
        const Cell c = grid.cellOf(p);
        if (!grid.contains(c)) return false;
        const double known = clearance.live()[grid.index(c)] - kFloatSlack;
        // Three quarters of an edge are more than any point of a cell is away from the centre.
        return known - 0.75 * grid.cell >= limit || known - distance(p, grid.centre(c)) >= limit;
    }
    bool jumpOut(Vec2 p, double radius, Vec2& best) const;
    std::optional<Cell> nearestFreeCell(Vec2 p, double radius) const;

    /// Calls `visit(number)` in ascending order for pieces whose box lies within `radius` of `p`;
    /// the visitor may lower `radius` on the way.
    template <class Visit>
    void forNear(Vec2 p, const double& radius, const Visit& visit) const {
        const auto look = [&](std::int32_t number) {
            if (squaredDistance(index.bounds[number], p) <= radius * radius) visit(number);
        };
        if (radius <= kReach && inBox(p)) {
            index.forPiecesAt(p, look);
            return;
        }
        const auto count = static_cast<std::int32_t>(pieces.size());
        for (std::int32_t number = 0; number < count; ++number) look(number);
    }
};

}  // namespace muster
