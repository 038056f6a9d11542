#include "engine/ground/environment/environment.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/archive.h"
#include "base/maths.h"
#include "engine/geometry/triangulation.h"
#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

// Bound on coordinates, so that doubles resolve a radius well [m].
constexpr double kFarthest = 1e7;
constexpr double kMostCells = 16e6;

bool isInRange(Vec2 p) {
    return isFinite(p) && std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest;
}

constexpr double kLargestCell = 100.0;  // Greatest edge of a cell, as in scenarios [m].

Status checkWorld(const EnvironmentDef& def) {
    if (!isInRange(def.box.min) || !isInRange(def.box.max) || !(def.box.width() > 0.0) ||
        !(def.box.height() > 0.0)) {
        return invalidArgument("the world's box is empty or not finite");
    }
    if (!std::isfinite(def.cell) || def.cell <= 0.0)
        return invalidArgument("the ground cell must be positive");
    if (def.cell > kLargestCell) return invalidArgument("the ground cell must be at most 100 m");
    const double cells = std::ceil(def.box.width() / def.cell) * std::ceil(def.box.height() / def.cell);
    if (!(cells <= kMostCells))
        return invalidArgument("the world would have more than 16 million ground cells");
    if (!std::isfinite(def.defaultRange) || def.defaultRange < 0.0 || def.defaultRange > kFarthest) {
        return invalidArgument("the default range of obstacles must be a number from 0 on");
    }
    if (!std::isfinite(def.defaultStrength) || def.defaultStrength < 0.0) {
        return invalidArgument("the default strength of obstacles must be a number from 0 on");
    }
    for (std::size_t i = 0; i < def.clips.size(); ++i) {
        if (std::isfinite(def.clips[i].speed) && def.clips[i].speed > 0.0) continue;
        return invalidArgument("the speed of clip " + std::to_string(i) + " must be positive");
    }
    return {};
}

Status checkObstacle(const ObstacleDef& def) {
    if (!std::isfinite(def.range) || def.range > kFarthest)
        return invalidArgument("the obstacle's range is not finite");
    if (!std::isfinite(def.strength)) return invalidArgument("the obstacle's strength is not finite");
    if (!std::isfinite(def.height) || def.height <= 0.0)
        return invalidArgument("the obstacle's height must be positive");
    if (Status status = def.path.validate(); !status.ok()) return status.within("path of the obstacle");
    if (!def.polygon.empty()) {
        return def.radius == 0.0 ? Status()
                                 : invalidArgument("the obstacle is given both as polygon and as disc");
    }
    if (!std::isfinite(def.radius) || def.radius <= 0.0 || def.radius > kFarthest) {
        return invalidArgument("the obstacle has neither a polygon nor a positive radius");
    }
    return isInRange(def.centre) ? Status()
                                 : invalidArgument("the obstacle's centre is not finite or too far away");
}

Result<ObstacleEntry> makeObstacle(const ObstacleDef& def, double time) {
    if (Status status = checkObstacle(def); !status.ok()) return status;
    ObstacleEntry entry;
    entry.def = def;
    entry.placement.pivot = def.centre;
    if (!def.polygon.empty()) {
        Result<std::vector<Polygon>> parts = decomposeConvex(def.polygon);
        if (!parts.ok()) return parts.status().within("obstacle");
        entry.parts = std::move(*parts);
        entry.placement.pivot = centroid(def.polygon);
    }
    entry.placement.follow(def.path, time);
    return entry;
}

// The mean of two speeds, by the time for a metre.
double meanSpeed(double up, double down) {
    return up == down ? up : 2.0 / (1.0 / up + 1.0 / down);
}

Result<PatchEntry> makePatch(const PatchDef& def, const std::vector<ClipFacts>& clips, double time) {
    if (def.motion < 0 || std::cmp_greater_equal(def.motion, clips.size())) {
        return invalidArgument("the patch plays motion " + std::to_string(def.motion) +
                               ", which no clip bears");
    }
    if (!std::isfinite(def.speed) || def.speed == 0.0 || !std::isfinite(def.speedDown) ||
        def.speedDown == 0.0)
        return invalidArgument("the patch's speed must be positive");
    if (!std::isfinite(def.ascent.value_or(0.0))) return invalidArgument("the patch's ascent is no angle");
    if (Status status = def.path.validate(); !status.ok()) return status.within("path of the patch");
    PatchEntry entry;
    entry.def = def;
    entry.speed = def.speed < 0.0 ? clips[def.motion].speed : def.speed;
    entry.up = entry.down = entry.speed;
    if (def.ascent) {
        entry.down = def.speedDown < 0.0 ? entry.up : def.speedDown;
        entry.ascent = {cosine(*def.ascent), sine(*def.ascent)};
        entry.speed = meanSpeed(entry.up, entry.down);
    }
    // The raster keeps it as a float, which must be above zero.
    if (static_cast<float>(entry.speed) <= 0.0f) return invalidArgument("the patch's speed must be positive");
    Result<Polygon> outline = cleanPolygon(def.polygon);
    if (!outline.ok()) return outline.status().within("patch");
    Result<std::vector<Polygon>> parts = decomposeConvex(*outline);
    if (!parts.ok()) return parts.status().within("patch");
    entry.outline = std::move(*outline);
    entry.parts = std::move(*parts);
    entry.placement.pivot = centroid(entry.outline);
    entry.placement.follow(def.path, time);
    return entry;
}

// Index of an id in the ascending list, or -1.
template <class T>
std::ptrdiff_t indexOf(const std::vector<T>& ids, T id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? at - ids.begin() : -1;
}

template <class T>
Status notFound(const char* kind, T id) {
    return {StatusCode::NotFound, std::string("no ") + kind + " has the id " + std::to_string(id.value)};
}

}  // namespace

Result<Environment> Environment::create(const EnvironmentDef& def) {
    if (Status status = checkWorld(def); !status.ok()) return status;
    Environment made;
    made.impl_->start(def);
    return made;
}

Environment::Environment() : impl_(std::make_unique<Impl>()) {
    impl_->start({});
}
Environment::~Environment() = default;
Environment::Environment(Environment&&) noexcept = default;
Environment& Environment::operator=(Environment&&) noexcept = default;

const EnvironmentDef& Environment::def() const {
    return impl_->def;
}
const Grid& Environment::grid() const {
    return impl_->grid;
}
double Environment::time() const {
    return impl_->time;
}

Result<ObstacleId> Environment::addObstacle(const ObstacleDef& def) {
    Impl& s = *impl_;
    Result<ObstacleEntry> entry = makeObstacle(def, s.time);
    if (!entry.ok()) return entry.status();
    const ObstacleId id{s.nextObstacle++};
    s.obstacleIds.push_back(id);
    s.markDirty(*entry);
    s.countEdit(def.path.still());
    s.obstacles.push_back(std::move(*entry));
    s.replacePieces(s.obstacles.size() - 1, 0, false);
    return id;
}

Status Environment::changeObstacle(ObstacleId id, const ObstacleDef& def) {
    Impl& s = *impl_;
    const std::ptrdiff_t at = indexOf(s.obstacleIds, id);
    if (at < 0) return notFound("obstacle", id);
    Result<ObstacleEntry> entry = makeObstacle(def, s.time);
    if (!entry.ok()) return entry.status();
    s.markDirty(s.obstacles[at]);
    s.markDirty(*entry);
    s.countEdit(s.obstacles[at].def.path.still() || def.path.still());
    const std::size_t before = Impl::pieceCount(s.obstacles[at]);
    s.obstacles[at] = std::move(*entry);
    s.replacePieces(at, before, false);
    return {};
}

Status Environment::removeObstacle(ObstacleId id) {
    Impl& s = *impl_;
    const std::ptrdiff_t at = indexOf(s.obstacleIds, id);
    if (at < 0) return notFound("obstacle", id);
    s.markDirty(s.obstacles[at]);
    s.countEdit(s.obstacles[at].def.path.still());
    const std::size_t before = Impl::pieceCount(s.obstacles[at]);
    s.obstacles.erase(s.obstacles.begin() + at);
    s.obstacleIds.erase(s.obstacleIds.begin() + at);
    s.replacePieces(at, before, true);
    return {};
}

void Environment::setFieldDefaults(double range, double strength) {
    Impl& s = *impl_;
    if (!(range >= 0.0 && range <= kFarthest) || !(strength >= 0.0 && std::isfinite(strength))) return;
    if (range == s.def.defaultRange && strength == s.def.defaultStrength) return;
    s.def.defaultRange = range;
    s.def.defaultStrength = strength;
    s.piecesStale = true;  // Both kinds of pieces carry these numbers.
    s.stale = true;
}

Result<PatchId> Environment::addPatch(const PatchDef& def) {
    Impl& s = *impl_;
    Result<PatchEntry> entry = makePatch(def, s.def.clips, s.time);
    if (!entry.ok()) return entry.status();
    const PatchId id{s.nextPatch++};
    s.patchIds.push_back(id);
    s.markDirty(*entry);
    s.countEdit(def.path.still());
    s.patches.push_back(std::move(*entry));
    return id;
}

Status Environment::changePatch(PatchId id, const PatchDef& def) {
    Impl& s = *impl_;
    const std::ptrdiff_t at = indexOf(s.patchIds, id);
    if (at < 0) return notFound("patch", id);
    Result<PatchEntry> entry = makePatch(def, s.def.clips, s.time);
    if (!entry.ok()) return entry.status();
    s.markDirty(s.patches[at]);
    s.markDirty(*entry);
    s.countEdit(s.patches[at].def.path.still() || def.path.still());
    s.patches[at] = std::move(*entry);
    return {};
}

Status Environment::removePatch(PatchId id) {
    Impl& s = *impl_;
    const std::ptrdiff_t at = indexOf(s.patchIds, id);
    if (at < 0) return notFound("patch", id);
    s.markDirty(s.patches[at]);
    s.countEdit(s.patches[at].def.path.still());
    s.patches.erase(s.patches.begin() + at);
    s.patchIds.erase(s.patchIds.begin() + at);
    return {};
}

std::span<const ObstacleId> Environment::obstacleIds() const {
    return impl_->obstacleIds;
}
std::span<const PatchId> Environment::patchIds() const {
    return impl_->patchIds;
}

const ObstacleDef* Environment::obstacle(ObstacleId id) const {
    const std::ptrdiff_t at = indexOf(impl_->obstacleIds, id);
    return at < 0 ? nullptr : &impl_->obstacles[at].def;
}

const PatchDef* Environment::patch(PatchId id) const {
    const std::ptrdiff_t at = indexOf(impl_->patchIds, id);
    return at < 0 ? nullptr : &impl_->patches[at].def;
}

Polygon Environment::obstaclePolygon(ObstacleId id) const {
    const std::ptrdiff_t at = indexOf(impl_->obstacleIds, id);
    if (at < 0) return {};
    const ObstacleEntry& entry = impl_->obstacles[at];
    Polygon polygon = entry.def.polygon;
    if (entry.def.path.still()) return polygon;
    for (Vec2& p : polygon) p = entry.placement.apply(p);
    return polygon;
}

Vec2 Environment::obstacleCentre(ObstacleId id) const {
    const std::ptrdiff_t at = indexOf(impl_->obstacleIds, id);
    if (at < 0) return {};
    const Placement& placement = impl_->obstacles[at].placement;
    return placement.apply(placement.pivot);
}

void Environment::patchPolygon(PatchId id, Polygon& polygon) const {
    polygon.clear();
    const std::ptrdiff_t at = indexOf(impl_->patchIds, id);
    if (at < 0) return;
    const PatchEntry& entry = impl_->patches[at];
    polygon.assign(entry.outline.begin(), entry.outline.end());
    if (entry.def.path.still()) return;
    for (Vec2& p : polygon) p = entry.placement.apply(p);
}

Polygon Environment::patchPolygon(PatchId id) const {
    Polygon polygon;
    patchPolygon(id, polygon);
    return polygon;
}

void Environment::setTime(double time) {
    MUSTER_ASSERT(std::isfinite(time));
    Impl& s = *impl_;
    s.time = time;
    bool moved = false;
    for (ObstacleEntry& entry : s.obstacles) {
        if (!entry.def.path.still() && entry.placement.follow(entry.def.path, time)) moved = true;
    }
    for (PatchEntry& entry : s.patches) {
        if (!entry.def.path.still() && entry.placement.follow(entry.def.path, time)) moved = true;
    }
    if (s.stale.load(std::memory_order_acquire)) {
        if (moved) s.countEdit(false);
        s.refresh();
    } else if (moved) {
        s.changesFrom = s.groundVersion++;
        s.moveThings();
    }
}

bool Environment::moves() const {
    const auto isOnTheMove = [](const auto& entry) {
        return !(entry.placement.velocity == Vec2{}) || entry.placement.angularVelocity != 0.0;
    };
    return std::any_of(impl_->obstacles.begin(), impl_->obstacles.end(), isOnTheMove) ||
           std::any_of(impl_->patches.begin(), impl_->patches.end(), isOnTheMove);
}

std::uint64_t Environment::groundVersion() const {
    return impl_->groundVersion;
}
std::uint64_t Environment::staticVersion() const {
    return impl_->staticVersion;
}
std::uint64_t Environment::staticPatchVersion() const {
    return impl_->staticPatchVersion;
}
std::uint64_t Environment::instance() const {
    return impl_->instance;
}

bool Environment::changesSince(std::uint64_t version, std::vector<CellRect>& areas) const {
    const Impl& s = *impl_;
    if (version == s.groundVersion) return true;
    if (version != s.changesFrom) return false;
    areas.insert(areas.end(), s.changes.begin(), s.changes.end());
    return true;
}

bool Environment::staticChangesSince(std::uint64_t version, std::vector<CellRect>& areas) const {
    const Impl& s = *impl_;
    if (version < s.staticEditsFrom || version > s.staticVersion) return false;
    for (const Impl::StaticEdit& edit : s.staticEdits)
        if (edit.version > version) areas.push_back(edit.area);
    return true;
}

std::span<const CellRect> Environment::movingObstacleAreas() const {
    impl_->ensure();
    return impl_->clearance.movingAreas();
}

std::span<const CellRect> Environment::movingPatchAreas() const {
    impl_->ensure();
    return impl_->patchSpeed.movingAreas();
}

std::span<const ObstaclePiece> Environment::pieces() const {
    impl_->ensure();
    return impl_->pieces;
}

std::span<const float> Environment::clearance() const {
    impl_->ensure();
    return impl_->clearance.combined();
}

std::span<const float> Environment::staticClearance() const {
    impl_->ensure();
    return impl_->clearance.fixed();
}

RasterView Environment::staticPatchSpeed() const {
    impl_->ensure();
    return impl_->patchSpeed.fixedView();
}

RasterView Environment::travelSpeed() const {
    static constexpr float kOpen = 1.0f;
    impl_->ensure();
    return impl_->travelSpeed.empty() ? RasterView(&kOpen) : RasterView(impl_->travelSpeed);
}

namespace {

// One description serves saving, loading and hashing; only loading copies the definitions.
template <class Archive, class Ids, class Entries, class Def>
void visitThings(Archive& archive, Ids& ids, Entries& entries, std::vector<Def>& read) {
    archive(ids);
    if constexpr (Archive::kReading) {
        archive(read);
    } else {
        auto count = static_cast<std::uint32_t>(entries.size());
        archive(count);
        for (auto& entry : entries) archive(entry.def);
    }
}

template <class T>
bool ascending(const std::vector<T>& ids, std::uint32_t next) {
    std::uint32_t last = 0;
    for (T id : ids) {
        if (id.value <= last || id.value >= next) return false;
        last = id.value;
    }
    return true;
}

}  // namespace

template <class Archive>
void Environment::Impl::visit(Archive& archive, std::vector<ObstacleDef>& obstacleDefs,
                              std::vector<PatchDef>& patchDefs) {
    archive(def, time, nextObstacle, nextPatch);
    visitThings(archive, obstacleIds, obstacles, obstacleDefs);
    visitThings(archive, patchIds, patches, patchDefs);
}

void Environment::save(Writer& archive) const {
    std::vector<ObstacleDef> noObstacles;
    std::vector<PatchDef> noPatches;
    impl_->visit(archive, noObstacles, noPatches);
}

void Environment::hash(Hasher& archive) const {
    std::vector<ObstacleDef> noObstacles;
    std::vector<PatchDef> noPatches;
    impl_->visit(archive, noObstacles, noPatches);
}

bool Environment::load(Reader& archive) {
    auto read = std::make_unique<Impl>();
    std::vector<ObstacleDef> obstacleDefs;
    std::vector<PatchDef> patchDefs;
    read->visit(archive, obstacleDefs, patchDefs);
    if (!archive.ok() || !std::isfinite(read->time) || !checkWorld(read->def).ok()) return false;
    if (obstacleDefs.size() != read->obstacleIds.size() || patchDefs.size() != read->patchIds.size())
        return false;
    if (!ascending(read->obstacleIds, read->nextObstacle) || !ascending(read->patchIds, read->nextPatch))
        return false;
    for (const ObstacleDef& def : obstacleDefs) {
        Result<ObstacleEntry> entry = makeObstacle(def, read->time);
        if (!entry.ok()) return false;
        read->obstacles.push_back(std::move(*entry));
    }
    for (const PatchDef& def : patchDefs) {
        Result<PatchEntry> entry = makePatch(def, read->def.clips, read->time);
        if (!entry.ok()) return false;
        read->patches.push_back(std::move(*entry));
    }
    // Callers that know an old version must see that the ground changed.
    read->groundVersion = impl_->groundVersion + 1;
    read->staticVersion = read->staticEditsFrom = impl_->staticVersion + 1;
    read->start(EnvironmentDef(read->def));
    impl_ = std::move(read);
    return true;
}

}  // namespace muster
