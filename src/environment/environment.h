// Obstacles and patches of a world as they stand now, with the queries that all layers share.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "base/grid.h"
#include "environment/obstacle_piece.h"
#include "muster/patch.h"

namespace muster {

/// What never changes about an environment.
struct EnvironmentDef {
    Box box{{-16, -16}, {16, 16}};                      ///< The world; characters and places stay inside [m].
    double cell = 0.25;                                 ///< Edge of a ground cell [m] > 0.
    double defaultRange = 1.5;                          ///< Range of obstacles that give none [m].
    double defaultStrength = 1.0;                       ///< Strength of obstacles that give none.
    std::vector<ClipFacts> clips = defaultClipFacts();  ///< Indexed by MotionId.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(box.min, box.max, cell, defaultRange, defaultStrength, clips);
    }
};

/// What lies under one point.
struct GroundSample {
    PatchId patch;             ///< Patch that rules here; none in the open.
    MotionId motion = 0;       ///< Its motion.
    double travelSpeed = 1.0;  ///< Relative to running > 0.
};

/// A gap that is too narrow: between two obstacles, two parts of one, or an obstacle and the edge of the
/// world.
struct NarrowGap {
    ObstacleId a;  ///< One.
    /// The other; the same for a slot within one obstacle, none for the edge of the world.
    ObstacleId b;
    Vec2 where;          ///< Middle of the gap [m].
    double width = 0.0;  ///< [m]
};

/// Owns obstacles, patches and the rasters made of them. Everything kept beside the definitions
/// and the clock is a cache of these, so saving writes only definitions.
class Environment {
public:
    /// An empty world. Fails with InvalidArgument where the box is empty, the cell is not positive
    /// or there would be more than 16 million cells.
    static Result<Environment> create(const EnvironmentDef& def);
    Environment();  ///< Empty.
    ~Environment();
    Environment(Environment&&) noexcept;  ///< Moves.
    Environment& operator=(Environment&&) noexcept;

    const EnvironmentDef& def() const;  ///< As made.
    const Grid& grid() const;           ///< The ground cells.
    double time() const;                ///< [s] The clock that moving things follow.

    /// Adds an obstacle. Fails, adding nothing, where its shape or path is bad.
    Result<ObstacleId> addObstacle(const ObstacleDef& def);
    /// Replaces an obstacle's definition. Fails with NotFound, or as addObstacle.
    Status changeObstacle(ObstacleId id, const ObstacleDef& def);
    /// Takes an obstacle away. Fails with NotFound.
    Status removeObstacle(ObstacleId id);
    /// Adds a patch. Fails, adding nothing, where its shape, path, motion or speed is bad.
    Result<PatchId> addPatch(const PatchDef& def);
    /// Replaces a patch's definition. Fails with NotFound, or as addPatch.
    Status changePatch(PatchId id, const PatchDef& def);
    /// Takes a patch away. Fails with NotFound.
    Status removePatch(PatchId id);

    /// Ids in ascending order.
    std::span<const ObstacleId> obstacleIds() const;
    /// Ids in ascending order.
    std::span<const PatchId> patchIds() const;
    /// Definition by id, or null.
    const ObstacleDef* obstacle(ObstacleId id) const;
    /// Definition by id, or null.
    const PatchDef* patch(PatchId id) const;
    /// A patch's polygon where it stands now; empty for an unknown id.
    Polygon patchPolygon(PatchId id) const;

    /// Changes range [m] and strength of the field of obstacles that give none; ignores numbers that are
    /// negative or not finite.
    void setFieldDefaults(double range, double strength);

    /// Puts moving things where they are at `time` [s] and brings the rasters up to date.
    void setTime(double time);
    /// Grows by one whenever the ground changes (an edit, or a moving thing moved).
    std::uint64_t groundVersion() const;
    /// Grows by one whenever something that stands still is added, changed or removed.
    std::uint64_t staticVersion() const;
    /// Differs between any two environments of a program and after load(): with a version it tells caches
    /// what they hold.
    std::uint64_t instance() const;
    /// Appends to `areas` the cells whose clearance or travel speed may have changed since groundVersion()
    /// was `version`. False where that is not known any more: all cells may have.
    bool changesSince(std::uint64_t version, std::vector<CellRect>& areas) const;

    /// The cells whose clearance moving obstacles change now; some rectangles may be empty.
    std::span<const CellRect> movingObstacleAreas() const;
    /// The cells whose travel speed moving patches change now; some rectangles may be empty.
    std::span<const CellRect> movingPatchAreas() const;

    /// All convex parts as they stand now, ordered by obstacle id.
    std::span<const ObstaclePiece> pieces() const;
    /// Distance from a cell's centre to the nearest obstacle surface or edge of the box [m], one value
    /// per cell: exact up to kClearanceLimit and capped there; 0 or less inside.
    std::span<const float> clearance() const;
    /// Travel speed per cell > 0 (every cell a patch touches takes its speed; the slowest wins).
    std::span<const float> travelSpeed() const;
    /// clearance() as it were without moving obstacles.
    std::span<const float> stillClearance() const;
    /// Travel speed per cell of the slowest patch that stands still; infinite where there is none.
    std::span<const float> stillPatchSpeed() const;
    /// Where clearance() stops [m].
    static constexpr double kClearanceLimit = 3.0;

    /// What lies under `p` (exact polygons, not cells).
    GroundSample ground(Vec2 p) const;
    /// True where both patches are of one motion and overlap as they stand now, so that they count as one
    /// (SPEC C1).
    bool onePatch(PatchId a, PatchId b) const;
    /// Distance from `p` to the nearest obstacle surface [m], negative inside, `limit` where farther.
    double distanceToObstacle(Vec2 p, double limit = kClearanceLimit) const;
    /// Sets `close[i]` to 1 where `points[i]` is nearer than `reach` [m] >= 0 to an obstacle surface or to
    /// the edge of the box, in an obstacle or out of the box, and to 0 elsewhere.
    void markClose(std::span<const Vec2> points, double reach, std::span<std::uint8_t> close) const;
    /// Calls `visit(piece)` in ascending order for every piece whose surface may be within `radius` of `p`.
    void forPiecesNear(Vec2 p, double radius, const std::function<void(const ObstaclePiece&)>& visit) const;
    /// Writes to `found` the numbers of these pieces in pieces(), ascending; reuses its memory.
    void piecesNear(Vec2 p, double radius, std::vector<std::int32_t>& found) const;
    /// True where a disc of `radius` can move straight from `a` to `b` without touching an obstacle
    /// and without leaving the box.
    bool clearLine(Vec2 a, Vec2 b, double radius) const;
    /// `p` moved out of every obstacle and into the box so that a disc of `radius` [m] is free; where
    /// no free spot is found by sliding, the centre of the nearest free cell.
    Vec2 pushOut(Vec2 p, double radius) const;
    /// The potential field of all obstacles at `p`: sum of strength (1 - d / r) times the direction away
    /// from each piece's centre for 0 < d < r (paper eq. 1, SPEC M4); inside a piece d counts as 0.
    Vec2 potentialField(Vec2 p) const;

    /// Label of the connected free region of a cell for discs of `radius` [m]; -1 for blocked cells.
    /// Obstacles that move do not count. Labels are numbered in row-major order of first cells.
    std::int32_t region(Vec2 p, double radius) const;
    /// How many such regions there are.
    std::int32_t regionCount(double radius) const;
    /// The centre of the free cell nearest to `p` with that region label (any region where -1), or `p`
    /// itself where it already lies in one or there is none.
    Vec2 nearestInRegion(Vec2 p, double radius, std::int32_t label) const;
    /// A way for a disc of `radius` from `a` to `b` as corner points, both ends included (A* on the
    /// ground cells, then pulled straight); empty where there is none or more than `maxCells` cells
    /// would be looked at. Moving obstacles count where they stand now. An end that is not free is left
    /// by the nearest free cell; the way to a goal that is not free ends in that cell.
    std::vector<Vec2> findPath(Vec2 a, Vec2 b, double radius, std::int32_t maxCells = 200000) const;
    /// The same, written to `way`: reuses its memory, and such of this thread as grows with the ground.
    void findPath(Vec2 a, Vec2 b, double radius, std::vector<Vec2>& way,
                  std::int32_t maxCells = 200000) const;

    /// Gaps narrower than `width` [m], at most `most`: for each pair of obstacles the narrowest between
    /// convex parts that do not touch and have nothing between them, within one obstacle likewise, and to the
    /// edge of the world. Ordered by obstacles, edges last.
    std::vector<NarrowGap> narrowGaps(double width, std::int32_t most = 100) const;

    /// Writes the definitions, ids and clock.
    void save(class Writer& archive) const;
    /// Reads what save() wrote; false where it does not fit.
    bool load(class Reader& archive);
    /// Adds what save() writes to a hash.
    void hash(class Hasher& archive) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
