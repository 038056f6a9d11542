// Obstacles and patches of a world as they stand now, and the queries about them that all layers share.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "base/function_ref.h"
#include "base/grid.h"
#include "base/raster_view.h"
#include "base/ring.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "muster/generated/parameters.h"
#include "muster/ground.h"

namespace muster {

/// Constants of an environment.
struct EnvironmentDef {
    Box box{{-16, -16}, {16, 16}};  ///< The world [m]; characters and places stay inside.
    double cell = 0.25;             ///< Edge of a ground cell [m], above 0.
    /// Range of obstacles that have no own one [m], 0 or more.
    double defaultRange = Parameters::Field{}.range;
    /// Strength of obstacles that have no own one, 0 or more.
    double defaultStrength = Parameters::Field{}.strength;
    std::vector<ClipFacts> clips = defaultClipFacts();  ///< Facts of clips, indexed by MotionId.
    bool ring = false;  ///< True if the left and the right side of the box are joined.

    /// The sides of the world that nobody passes: the box, in a ring without its left and right side.
    Box sides() const {
        constexpr double kFar = 1e7;
        return ring ? Box{{-kFar, box.min.y}, {kFar, box.max.y}} : box;
    }
    /// The ring by which distances are measured.
    Ring joined() const { return ring ? Ring{box.min.x, box.width()} : Ring{}; }

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(box.min, box.max, cell, defaultRange, defaultStrength, clips, ring);
    }
};

/// The ground under one point.
struct GroundSample {
    PatchId patch;        ///< The slowest patch at the point; none in the open.
    MotionId motion = 0;  ///< Its motion.
    /// Travel speed relative to running, above 0; on stairs the mean of up and down.
    double travelSpeed = 1.0;
    Vec2 ascent;        ///< Unit vector up stairs or a ramp; null elsewhere.
    double up = 1.0;    ///< Travel speed up the stairs; elsewhere the same as travelSpeed,
    double down = 1.0;  ///< and down, above 0.

    /// True on stairs and ramps.
    bool isStairs() const { return !(ascent == Vec2{}); }
    /// Travel speed in the direction of a unit vector, or the mean for the null vector: on stairs the time
    /// for a metre changes from that of going down to that of going up with the cosine of the direction.
    double speedAlong(Vec2 way) const;
};

/// A gap that is too narrow: between two obstacles, two parts of one, or an obstacle and the edge of the
/// world.
struct NarrowGap {
    ObstacleId a;  ///< One obstacle.
    /// The other obstacle; the same for a slot within one obstacle, none for the edge of the world.
    ObstacleId b;
    Vec2 where;          ///< Midpoint of the gap [m].
    double width = 0.0;  ///< Width of the gap [m].
};

/// The shortest segment between two surfaces that are too near for something to pass between them.
struct ClosedGap {
    Vec2 a;  ///< End on one surface [m].
    Vec2 b;  ///< End on the other surface, or the edge of the world [m].
};
/// True where the segment from `a` to `b` meets the segment of the gap.
bool crosses(const ClosedGap& gap, Vec2 a, Vec2 b);

/// Owns obstacles, patches and their rasters. Definitions, ids and the clock are state; everything else is a
/// cache, so saving writes only the state.
class Environment {
public:
    /// An empty world. Fails with InvalidArgument where the box is empty, the cell is not positive
    /// or there would be more than 16 million cells.
    static Result<Environment> create(const EnvironmentDef& def);
    Environment();  ///< An empty environment.
    ~Environment();
    Environment(Environment&&) noexcept;  ///< Moves the environment.
    Environment& operator=(Environment&&) noexcept;

    const EnvironmentDef& def() const;  ///< The definition.
    const Grid& grid() const;           ///< The ground cells.
    double time() const;                ///< The clock that moving things follow [s].

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
    /// An obstacle's polygon where it stands now; empty for a disc and for an unknown id.
    Polygon obstaclePolygon(ObstacleId id) const;
    /// The present centre of area of an obstacle, or the centre of a disc [m].
    Vec2 obstacleCentre(ObstacleId id) const;
    /// A patch's polygon where it stands now; empty for an unknown id.
    Polygon patchPolygon(PatchId id) const;
    /// Writes a patch's polygon into one that may have memory already.
    void patchPolygon(PatchId id, Polygon& polygon) const;

    /// Changes range [m] and strength of the field of obstacles that have no own ones; ignores numbers that
    /// are negative or not finite.
    void setFieldDefaults(double range, double strength);

    /// Puts moving things where they are at `time` [s] and brings the rasters up to date.
    void setTime(double time);
    /// Rises by one whenever the ground changes (an edit, or a moving thing moved).
    std::uint64_t groundVersion() const;
    /// Rises by one whenever a static obstacle or patch is added, changed or removed.
    std::uint64_t staticVersion() const;
    /// Appends to `areas` the cells whose clearance or travel speed may have changed by static obstacles or
    /// patches since staticVersion() was `version`; some may overlap. False where that is not known any more,
    /// so that all cells may have changed.
    bool staticChangesSince(std::uint64_t version, std::vector<CellRect>& areas) const;
    /// The staticVersion() at which a static patch was last added, changed or removed.
    std::uint64_t staticPatchVersion() const;
    /// Differs between any two environments of a program and after load(). With a version it identifies the
    /// ground that a cache was made from.
    std::uint64_t instance() const;
    /// Appends to `areas` the cells whose clearance or travel speed may have changed since groundVersion()
    /// was `version`. False where that is not known any more, so that all cells may have changed.
    bool changesSince(std::uint64_t version, std::vector<CellRect>& areas) const;

    /// True where an obstacle or a patch is on the move now.
    bool moves() const;
    /// The cells whose clearance moving obstacles change now; some rectangles may be empty.
    std::span<const CellRect> movingObstacleAreas() const;
    /// The cells whose travel speed moving patches change now; some rectangles may be empty.
    std::span<const CellRect> movingPatchAreas() const;

    /// All convex parts as they stand now, ordered by obstacle id.
    std::span<const ObstaclePiece> pieces() const;
    /// Distance from a cell's centre to the nearest obstacle surface or edge of the box [m], one value
    /// per cell: exact up to kClearanceLimit and capped there; 0 or less inside.
    std::span<const float> clearance() const;
    /// Travel speed per cell, above 0: the speed of the slowest patch that shares area with the cell, else 1.
    RasterView travelSpeed() const;
    /// clearance() without moving obstacles.
    std::span<const float> staticClearance() const;
    /// Travel speed per cell of the slowest static patch; infinite where there is none.
    RasterView staticPatchSpeed() const;
    /// clearance() is capped here [m].
    static constexpr double kClearanceLimit = 3.0;

    /// The ground under `p` (exact polygons, not cells).
    GroundSample ground(Vec2 p) const;
    /// Length of the straight line from `a` to `b` in metres of open ground, by travel speed.
    double travelLength(Vec2 a, Vec2 b) const;
    /// True where both patches have one motion and overlap as they stand now, so that they count as one patch
    /// (SPEC C1).
    bool onePatch(PatchId a, PatchId b) const;
    /// Distance from `p` to the nearest obstacle surface [m], negative inside, `limit` where farther.
    double distanceToObstacle(Vec2 p, double limit = kClearanceLimit) const;
    /// Sets `near[i]` to 1 where `points[i]` is nearer than `reach` [m] >= 0 to an obstacle surface or to
    /// the edge of the box, in an obstacle or out of the box, and to 0 elsewhere.
    void markNearObstacles(std::span<const Vec2> points, double reach, std::span<std::uint8_t> near) const;
    /// Calls `visit(piece)` in ascending order for every piece whose surface may be within `radius` of `p`.
    void forPiecesNear(Vec2 p, double radius, FunctionRef<void(const ObstaclePiece&)> visit) const;
    /// True where a disc of `radius` can move straight from `a` to `b` without touching an obstacle
    /// and without leaving the box.
    bool clearLine(Vec2 a, Vec2 b, double radius) const;
    /// True where the line is clear of static obstacles; those that may move do not count.
    bool clearStaticLine(Vec2 a, Vec2 b, double radius) const;
    /// True where a disc of `radius` can get from `a` to `b` near the straight line between them: no static
    /// obstacle lies between them, and no gap narrower than the disc (closedGaps()). Both points must be free
    /// for the disc, and at most a diameter apart. The disc may have to go round a corner, so clearLine() may
    /// be false. Cells of a raster cannot tell: a gap may lie between two centres.
    bool stepIsFree(Vec2 a, Vec2 b, double radius) const;
    /// Appends the gaps narrower than `width` [m] between two convex static parts, or between one and the
    /// edge of the world, whose parts may act in `area` (all of them where it is the world's box). A disc of
    /// that diameter cannot cross their segments, wherever it comes from. In a fixed order.
    void closedGaps(const Box& area, double width, std::vector<ClosedGap>& gaps) const;
    /// Projects `p` onto the free space: moves it out of every obstacle and into the box, so that a disc of
    /// `radius` [m] is free. Where projections do not converge it returns the centre of the nearest free
    /// cell.
    Vec2 projectToFreeSpace(Vec2 p, double radius) const;
    /// The potential field of all obstacles at `p` (paper equation 1, SPEC M4): the sum over pieces with
    /// distance d < range of strength (1 - d / range) times the direction away from the piece's centre;
    /// inside, d is 0.
    Vec2 potentialField(Vec2 p) const;

    /// Gaps narrower than `width` [m], at most `most`: for each pair of obstacles the narrowest between
    /// convex parts that do not touch and have nothing between them, also within one obstacle, and to the
    /// edge of the world. Ordered by obstacles, edges last.
    std::vector<NarrowGap> narrowGaps(double width, std::int32_t most = 100) const;

    /// Writes the definitions, ids and clock.
    void save(class Writer& archive) const;
    /// Reads the data of save(); false where it does not fit.
    bool load(class Reader& archive);
    /// Takes over the rasters and versions of `before`, which becomes useless: they are edited where
    /// obstacles or patches differ, or made again where the boxes differ or there are too many differences.
    /// Call after load().
    void keepCachesOf(Environment& before);
    /// Adds the data of save() to a hash.
    void hash(class Hasher& archive) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
