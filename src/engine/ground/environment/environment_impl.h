// The implementation of Environment: definitions, which are state, and their caches.
#pragma once

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>

#include "engine/ground/environment/box_grid.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/environment/layered_raster.h"

namespace muster {

/// The present position of a thing that may follow a path.
struct Placement {
    Vec2 pivot;                    ///< Defined point that it rotates about [m].
    Waypoint now;                  ///< Offset and rotation now.
    Vec2 velocity;                 ///< Velocity [m/s].
    double angularVelocity = 0.0;  ///< Angular velocity [rad/s].
    Rotation rotation;             ///< Rotation by now.angle.

    /// Follows `path` to `time`; true where anything changed.
    bool follow(const TimedPath& path, double time);
    /// Maps a defined point to its present position.
    Vec2 apply(Vec2 p) const { return pivot + rotation.apply(p - pivot) + now.position; }
};

/// An obstacle with its convex parts.
struct ObstacleEntry {
    ObstacleDef def;             ///< The given definition.
    std::vector<Polygon> parts;  ///< Convex parts as defined [m]; empty for a disc.
    Placement placement;
};

/// A patch with its convex parts.
struct PatchEntry {
    PatchDef def;                ///< The given definition.
    Polygon outline;             ///< The cleaned polygon as defined [m].
    std::vector<Polygon> parts;  ///< Convex parts as defined [m].
    Placement placement;         ///< Present position of the patch.
    double speed = 1.0;          ///< Travel speed relative to running; on stairs the mean.
    double up = 1.0;             ///< Travel speed up stairs,
    double down = 1.0;           ///< and down.
    Vec2 ascent;                 ///< Unit vector up stairs as defined; null elsewhere.
};

/// One convex part of a patch as it stands now.
struct PatchPiece {
    Polygon corners;         ///< Counter-clockwise [m].
    std::int32_t patch = 0;  ///< Index of the entry of its patch.
};

/// Broad phase over pieces: one grid of boxes for static pieces, one for pieces that may move.
struct PieceIndex {
    std::vector<Box> bounds;  ///< Bounds of each piece [m].
    std::vector<Box> reach;  ///< Reach of each piece: its bounds, grown by the distance at which it acts [m].
    std::vector<std::uint8_t> isBox;   ///< By piece: 1 where its bounds are the piece itself.
    std::vector<std::int32_t> fixed;   ///< Indices of pieces that never move.
    std::vector<std::int32_t> moving;  ///< Indices of pieces that may move.
    BoxGrid fixedGrid;                 ///< Grid of the reach of fixed pieces.
    BoxGrid movingGrid;                ///< Grid of the reach of moving pieces.

    /// Calls `visit(piece)` in ascending order for all pieces that act at `p`, a point of the world.
    template <class Visit>
    void forPiecesAt(Vec2 p, const Visit& visit) const {
        if (moving.empty()) {
            for (const std::int32_t piece : fixedGrid.at(p)) visit(piece);
            return;
        }
        const std::span<const std::int32_t> a = fixedGrid.at(p);
        const std::span<const std::int32_t> b = movingGrid.at(p);
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

/// Distance below which two parts touch [m].
inline constexpr double kTouching = 1e-9;

/// True where two boxes have a point in common.
inline bool boxesMeet(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// Squared distance from a point to a box; 0 inside.
inline double squaredDistance(const Box& box, Vec2 p) {
    return lengthSquared(box.clamp(p) - p);
}

/// Edits mark the caches stale; the next query or setTime() updates them.
struct Environment::Impl {
    EnvironmentDef def;
    Grid grid;
    double time = 0.0;
    std::vector<ObstacleId> obstacleIds;
    std::vector<ObstacleEntry> obstacles;  // Obstacles in the order of ids.
    std::vector<PatchId> patchIds;
    std::vector<PatchEntry> patches;  // Patches in the order of ids.
    std::uint32_t nextObstacle = 1;
    std::uint32_t nextPatch = 1;
    std::uint64_t groundVersion = 0;
    std::uint64_t staticVersion = 0;
    std::uint64_t instance = 0;

    // Caches.
    static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
    std::uint64_t changesFrom = kUnknown;  // The ground version from which `changes` lead to the present one.
    std::vector<CellRect> changes;         // Cells that the last motion may have changed.
    std::atomic<bool> stale{true};
    std::mutex mutex;
    bool freshRasters = true;         // True if the rasters and pieces hold nothing yet.
    bool piecesStale = false;         // True if all pieces must be made again.
    bool patchPiecesStale = false;    // True if the pieces of patches must be made again.
    std::vector<Box> dirtyObstacles;  // Boxes where static obstacles changed since the last refresh.
    std::vector<Box> dirtyPatches;    // Boxes where static patches changed since the last refresh.
    /// Cells that an edit of a static obstacle or patch may have changed, and the version that it led to.
    struct StaticEdit {
        std::uint64_t version = 0;
        CellRect area;
    };
    std::vector<StaticEdit> staticEdits;   // The latest edits, oldest first.
    std::uint64_t staticEditsFrom = 0;     // The version from which `staticEdits` lead to the present one.
    std::uint64_t staticPatchVersion = 0;  // The version of the last edit of a patch.
    std::vector<ObstaclePiece> pieces;
    std::vector<std::int32_t> pieceEntry;  // Index of the obstacle of each piece.
    std::vector<std::int32_t> piecePart;   // Index of each piece within its obstacle's parts.
    PieceIndex index;
    std::vector<PatchPiece> patchPieces;
    std::vector<std::int32_t> patchPart;  // Index of each patch piece within its patch's parts.
    PieceIndex patchIndex;
    LayeredRaster clearance;   // Clearance [m].
    LayeredRaster patchSpeed;  // Travel speed of the slowest patch; kNoPatch where none lies.
    // Travel speed like patchSpeed with moving patches; 1 where no patch lies. Empty without patches.
    std::vector<float> travelSpeed;
    // without patches.

    /// Distance beyond its box at which a piece acts at least [m].
    static constexpr double kReach = kClearanceLimit;
    /// Tolerance of contact tests: a disc set exactly against a surface counts as free [m].
    static constexpr double kContactTolerance = 1e-7;
    /// Bound on the rounding error of a clearance, which is kept as a float [m].
    static constexpr double kFloatError = 1e-6;
    static constexpr double kReachSlack = 1e-6;  ///< Length by which boxes are grown against rounding [m].
    /// Value of patchSpeed where no patch lies.
    static constexpr float kNoPatch = std::numeric_limits<float>::infinity();

    void start(const EnvironmentDef& definition);
    /// Reads or writes the definitions, ids and clock; only a reader fills the two lists.
    template <class Archive>
    void visit(Archive& archive, std::vector<ObstacleDef>& obstacleDefs, std::vector<PatchDef>& patchDefs);
    /// Counts an edit; `still` if a static obstacle or patch is part of it.
    void countEdit(bool still) {
        ++groundVersion;
        if (still) ++staticVersion;
        changesFrom = kUnknown;
    }
    /// Notes that an edit, counted next, changes the ground of an entry.
    void markDirty(const ObstacleEntry& entry);
    void markDirty(const PatchEntry& entry);
    void noteStaticEdit(const Box& box);
    /// Replaces the pieces of an obstacle, of which there were `before`, by its present ones; none and
    /// `removed` where it was erased. Does nothing before the first refresh().
    void replacePieces(std::size_t entry, std::size_t before, bool removed);
    void refresh();
    /// Updates the caches where they are stale.
    void ensure() {
        if (stale.load(std::memory_order_acquire)) refresh();
    }
    void moveThings();
    void appendMovingAreas();

    void refreshPieces();
    void refreshPatchPieces();
    void rebuildPieces();
    void rebuildPatchPieces();
    void resizePieces(std::size_t first, std::size_t before, std::size_t after);
    /// Number of pieces of an obstacle.
    static std::size_t pieceCount(const ObstacleEntry& entry) {
        return std::max<std::size_t>(1, entry.parts.size());
    }
    void updatePiece(std::int32_t number);
    void updatePatchPiece(std::int32_t number);
    void fillBorderClearance(const CellRect& area);
    void rebuildFixedClearance(const CellRect& area);
    void rebuildFixedSpeed(const CellRect& area);
    float lowerDistance(std::int32_t number, Vec2 p, float now) const;
    void addMovingClearance();
    void addMovingSpeed();
    void updateTravelSpeed(const CellRect& rect);
    void dropUnusedRasters();

    bool inBox(Vec2 p) const { return def.box.contains(p); }
    /// The box for the centres of discs that lie in the world; a point or line where the world is narrower
    /// than a disc.
    Box centreBox(double radius) const;
    bool blockedLine(Vec2 a, Vec2 b, double radius, bool fixedOnly) const;
    /// Distance from `p` to the nearest surface [m], negative inside, `limit` where farther.
    double distanceTo(Vec2 p, double limit) const {
        return isFarther(p, limit) ? limit : exactDistance(p, limit);
    }
    double exactDistance(Vec2 p, double limit) const;
    /// A lower bound of the distance from `p` to the nearest surface or edge of the world [m], from the
    /// raster; minus infinity off the grid.
    double distanceLowerBound(Vec2 p) const;
    /// A lower bound of the distance without moving obstacles.
    double stillDistanceLowerBound(Vec2 p) const;
    /// True where the raster proves that every surface is at least `limit` [m] away.
    bool isFarther(Vec2 p, double limit) const {
        const Cell c = grid.cellOf(p);
        if (!grid.contains(c)) return false;
        const double known = clearance.combined()[grid.index(c)] - kFloatError;
        // No point of a cell is farther from its centre than three quarters of an edge.
        return known - 0.75 * grid.cell >= limit || known - distance(p, grid.centre(c)) >= limit;
    }
    bool projectThroughSurface(Vec2 p, double radius, Vec2& best) const;
    std::optional<Cell> nearestFreeCell(Vec2 p, double radius) const;

    /// Calls `visit(piece)` in ascending order for pieces whose box lies within `radius` of `p`;
    /// the visitor may lower `radius` meanwhile.
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
