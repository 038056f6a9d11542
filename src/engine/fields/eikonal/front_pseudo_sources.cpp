// Values from pseudo-sources: shortest paths over uniform ground are straight up to a corner of a wall, so
// that a value is exact once its pseudo-source is known. The idea is that of any-angle search (Theta*, Nash
// et al. 2007) within an ordered front.
#include <algorithm>
#include <cmath>

#include "engine/fields/cost/ground_node.h"
#include "engine/fields/eikonal/front.h"

namespace muster {
namespace {

// Slope up to which a line of sight counts as along a row or column, and leaves a cell through one neighbour
// only.
constexpr float kAxisSlope = 1e-3f;
// Distance from the corner of its tangents below which an arc counts as a sharp corner [cells].
constexpr float kSharpDistance = 0.01f;
// Distance up to which two pseudo-sources lie at one corner [cells, Manhattan distance].
constexpr float kSameCorner = 2.5f;
// Distance from a pseudo-source from which on a cell may rely on the lines of sight of others at the same
// corner [cells].
constexpr float kFarFromSource = 6.0f;
// Distance from an occluder within which corners are searched [cells].
constexpr std::int32_t kOccluderReach = 2;
// Length of the line from a corner that is traced: beyond, the line is next to one found to be clear [cells].
constexpr float kTracedLength = 6.0f;

// Makes the pseudo-source in the middle of a rounded corner between two wall nodes, `from` at node `a` and
// the point (x, y) at node `b`. The corner is an arc that touches the tangents of the walls through both
// nodes, with the radius that the nearer node allows: at round obstacles both nodes lie on the arc, at
// polygons one may lie far along its side. Returns false where there is no corner between the nodes, or a
// sharp one.
bool middleOfArc(const WallNode& a, const WallNode& b, const PseudoSource& from, float x, float y,
                 PseudoSource& middle) {
    const float dx = x - from.x;
    const float dy = y - from.y;
    const float below = -(dx * a.normalX + dy * a.normalY);
    const float above = dx * b.normalX + dy * b.normalY;
    if (!(below > 0.0f && above > 0.0f)) return false;
    const float outX = a.normalX + b.normalX;
    const float outY = a.normalY + b.normalY;
    const float outLength = std::sqrt(outX * outX + outY * outY);
    // Cosine and sine of half the angle between the tangents.
    const float cosine = 0.5f * outLength;
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    if (cosine < 0.25f || sine < 1e-3f) return false;
    // Distances of the nodes from the intersection of the tangents.
    const float sineOfAngle = 2.0f * sine * cosine;
    const float before = above / sineOfAngle;
    const float after = below / sineOfAngle;
    const float tangent = std::min(before, after);
    const float radius = tangent * cosine / sine;
    const bool left = dx * a.normalY - dy * a.normalX < 0.0f;
    const float alongX = left ? -a.normalY : a.normalY;
    const float alongY = left ? a.normalX : -a.normalX;
    const float inward = radius * (1.0f / cosine - 1.0f);
    middle.normalX = outX / outLength;
    middle.normalY = outY / outLength;
    middle.x = from.x + before * alongX - inward * middle.normalX;
    middle.y = from.y + before * alongY - inward * middle.normalY;
    middle.unit = from.unit;
    middle.parent = from.parent;
    // Half the angle, by the series of the arc sine.
    const float s2 = sine * sine;
    const float angle = sine * (1.0f + s2 * (1.0f / 6.0f + s2 * (0.075f + s2 * 0.0446f)));
    middle.cost = from.cost + from.unit * (before - tangent + radius * angle);
    return inward > kSharpDistance;
}

}  // namespace

// True for a cell where shortest paths may bend: it touches a wall, or lies between two walls.
inline bool Front::isCorner(std::int32_t cell) const {
    const std::int32_t number = lineOfSight_.wall(cell);
    if (number == 0) return false;
    const WallNode& wallNode = lineOfSight_.node(number);
    if (wallNode.normalX != 0.0f || wallNode.normalY != 0.0f) return true;
    const CellCost& c = cells_[cell];
    return (c.east == kUnreachableCost && c.west == kUnreachableCost) ||
           (c.north == kUnreachableCost && c.south == kUnreachableCost);
}

// True where a node is known to see a pseudo-source: its value comes from it. Far from the pseudo-source its
// value may also come from another one at the same corner or from the parent, as it does at the border
// between the regions that these see.
inline bool Front::seesSource(std::int32_t node, std::int32_t source, bool far) const {
    const std::int32_t own = nodes_[node].source;
    if (own == source) return true;
    if (!far || own <= 0) return false;
    const PseudoSource& a = sources_[own];
    const PseudoSource& b = sources_[source];
    return own == b.parent || std::fabs(a.x - b.x) + std::fabs(a.y - b.y) < kSameCorner;
}

// The obstruction between a cell and a pseudo-source. The line is clear where both cells between which the
// line leaves the cell see the pseudo-source, and no wall at the cell occludes it. Otherwise the line is
// traced.
Visibility Front::findVisibility(FrontCell to, float x, float y, std::int32_t source) {
    occluder_ = -1;
    if (nodes_[to.node].occluded == source) {
        occluder_ = occluderOf_[to.node];
        return Visibility::Wall;
    }
    const PseudoSource& origin = sources_[source];
    const float dx = x - origin.x;
    const float dy = y - origin.y;
    const float ax = std::fabs(dx);
    const float ay = std::fabs(dy);
    const std::int32_t alongX = dx > 0.0f ? -1 : 1;
    const std::int32_t alongY = dy > 0.0f ? -stride_ : stride_;
    const std::int32_t straight = to.node + (ax >= ay ? alongX : alongY);
    const std::int32_t oblique = to.node + alongX + alongY;
    const float elevation = lineOfSight_.elevation(to.cell, x, y, origin);
    const float originElevation = origin.elevation(x, y);
    if (std::min(elevation, originElevation) < kOccludedElevation) {
        if (elevation < kOccludedElevation) occluder_ = to.cell;
        return Visibility::Wall;
    }
    const bool alongAxis = std::min(ax, ay) <= kAxisSlope * std::max(ax, ay);
    const bool far = originElevation >= 0.0f && originElevation < 1.0f && ax + ay > kFarFromSource;
    const std::int32_t up = dy > 0.0f ? -grid_.width : grid_.width;
    const bool narrow = lineOfSight_.narrow(to.cell + (ax >= ay ? alongX : up)) ||
                        lineOfSight_.narrow(to.cell + alongX + up);
    const bool own = !narrow && (nodes_[straight].source == source || nodes_[oblique].source == source);
    if (own && elevation >= kVisibleElevation && seesSource(straight, source, far) &&
        (alongAxis || seesSource(oblique, source, far)))
        return Visibility::Clear;
    return traceAndNote(to, x, y, source);
}

Visibility Front::traceAndNote(FrontCell to, float x, float y, std::int32_t source) {
    const Visibility visibility = lineOfSight_.trace(x, y, sources_[source], occluder_);
    if (visibility == Visibility::Wall) {
        nodes_[to.node].occluded = source;
        occluderOf_[to.node] = occluder_;
    }
    return visibility;
}

// Updates `to` by the straight path from the pseudo-source of `from`, or from `from` itself where that lies
// at a wall. Returns false where differences are to be tried: on other ground, or where the pseudo-source is
// occluded.
bool Front::relaxFromSource(FrontCell from, FrontCell to, float old) {
    const std::int32_t source = nodes_[from.node].source;
    if (nodes_[to.node].source == source) return true;
    const PseudoSource& origin = sources_[source];
    if (!lineOfSight_.uniform(to.cell, origin.unit)) return false;
    const FrontNode& there = nodes_[to.node];
    // A path to or from a narrow cell bends there, and at the next cell.
    if (lineOfSight_.narrow(from.cell) || lineOfSight_.narrow(to.cell)) {
        relaxFromWall(from, to, old);
        return true;
    }
    if (there.source == 0 && old < kUnreachableCost && there.accepted == kUnreachableCost)
        old += kDifferenceError * origin.unit;
    float x = 0.0f;
    float y = 0.0f;
    position(to, x, y);
    const float straight = origin.costAt(x, y);
    if (!(straight < old - tolerance_)) return true;
    const Visibility visibility = findVisibility(to, x, y, source);
    if (visibility == Visibility::Clear) {
        put(to, nodes_[to.node].tentative, straight, source);
        return true;
    }
    const bool atWall = lineOfSight_.wall(from.cell) != 0;
    if (!isCorner(from.cell)) {
        const bool roundOccluder = visibility == Visibility::Wall && occluder_ >= 0 &&
                                   (nodes_[to.node].source <= 0 || atWall);
        if (roundOccluder && relaxRoundOccluder(occluder_, to, x, y, origin.unit, old)) return true;
        // Either other ground is between, or a corner of the occluder will give nearly all cells behind it
        // better values.
        if (!atWall) return false;
    }
    relaxFromWall(from, to, old);
    return true;
}

// Keeps the cheapest corners; of several at equal cost the first one.
void Front::Corners::insert(float pathCost, std::int32_t atCell) {
    int k = count;
    while (k > 0 && cost[k - 1] > pathCost) --k;
    if (k == kMax || (k > 0 && cost[k - 1] == pathCost)) return;
    count = std::min(count + 1, kMax);
    for (int m = count - 1; m > k; --m) {
        cost[m] = cost[m - 1];
        cell[m] = cell[m - 1];
    }
    cost[k] = pathCost;
    cell[k] = atCell;
}

// The corners near an occluder over which the paths to `target` are cheapest, and cheaper than `limit`.
Front::Corners Front::bestCorners(std::int32_t occluder, const PseudoSource& target, float limit) const {
    const Cell middle = grid_.at(occluder);
    const Cell low{std::max(0, middle.x - kOccluderReach), std::max(0, middle.y - kOccluderReach)};
    const Cell high{std::min(grid_.width - 1, middle.x + kOccluderReach),
                    std::min(grid_.height - 1, middle.y + kOccluderReach)};
    Corners best;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const FrontCell at = this->at({x, y});
            const float cost = nodes_[at.node].accepted;
            if (!(cost < limit) || !isCorner(at.cell)) continue;
            if (nodes_[at.node].source <= 0 || sources_[nodes_[at.node].source].unit != target.unit) continue;
            float px = 0.0f;
            float py = 0.0f;
            position(at, px, py);
            const float pathCost = cost + target.costAt(px, py);
            if (pathCost < limit && pathCost > 0.0f) best.insert(pathCost, at.cell);
        }
    }
    return best;
}

// Updates `to`, at (x, y), by the cheapest clear path over a corner near the occluder.
bool Front::relaxRoundOccluder(std::int32_t occluder, FrontCell to, float x, float y, float unit, float old) {
    const PseudoSource target{x, y, 0.0f, unit};
    occluderOf_[to.node] = -1;
    const Corners best = bestCorners(occluder, target, old - tolerance_);
    for (int k = 0; k < best.count; ++k) {
        const FrontCell from = at(grid_.at(best.cell[k]));
        PseudoSource corner = target;
        position(from, corner.x, corner.y);
        const float length = std::sqrt((x - corner.x) * (x - corner.x) + (y - corner.y) * (y - corner.y));
        const float share = std::min(1.0f, kTracedLength / std::max(length, 1.0f));
        std::int32_t ignored = 0;
        if (lineOfSight_.trace(corner.x + share * (x - corner.x), corner.y + share * (y - corner.y), corner,
                               ignored) != Visibility::Clear)
            continue;
        put(to, nodes_[to.node].tentative, best.cost[k], pseudoSourceAt(from));
        return true;
    }
    return false;
}

// Updates `to` by the path from `from`, which lies at a wall: straight, or along the arc of a rounded corner
// between the two.
void Front::relaxFromWall(FrontCell from, FrontCell to, float old) {
    std::int32_t source = pseudoSourceAt(from);
    float x = 0.0f;
    float y = 0.0f;
    position(to, x, y);
    const std::int32_t end = lineOfSight_.wall(to.cell);
    const PseudoSource& origin = sources_[source];
    if (end != 0 && crossesThinWall(origin, lineOfSight_.node(end), x - origin.x, y - origin.y)) return;
    PseudoSource middle;
    const bool arc = end != 0 && middleOfArc(lineOfSight_.node(lineOfSight_.wall(from.cell)),
                                             lineOfSight_.node(end), sources_[source], x, y, middle);
    const float value = arc ? middle.costAt(x, y) : sources_[source].costAt(x, y);
    if (!(value < old - tolerance_)) return;
    if (arc) {
        source = static_cast<std::int32_t>(sources_.size());
        sources_.push_back(middle);
    }
    put(to, nodes_[to.node].tentative, value, source);
}

// Index of the pseudo-source at the wall node of a cell, which is made where there is none for the cell's
// present value.
std::int32_t Front::pseudoSourceAt(FrontCell wallCell) {
    std::int32_t& index = wallSource_[lineOfSight_.wall(wallCell.cell)];
    const float cost = nodes_[wallCell.node].accepted;
    if (index == 0 || sources_[index].cost != cost) {
        PseudoSource source;
        position(wallCell, source.x, source.y);
        source.cost = cost;
        source.parent = nodes_[wallCell.node].source;
        source.unit = sources_[source.parent].unit;
        const WallNode& wallNode = lineOfSight_.node(lineOfSight_.wall(wallCell.cell));
        source.normalX = wallNode.normalX;
        source.normalY = wallNode.normalY;
        index = static_cast<std::int32_t>(sources_.size());
        sources_.push_back(source);
    }
    return index;
}

// Updates the diagonal neighbours of a cell at a wall to which two edges lead, over one of the two cells
// between.
void Front::relaxDiagonals(FrontCell from) {
    if (lineOfSight_.narrow(from.cell)) return;
    for (const std::int32_t right : {1, -1}) {
        for (const std::int32_t up : {1, -1}) {
            const FrontCell to{from.cell + up * grid_.width + right, from.node + up * stride_ + right};
            const float old = nodes_[to.node].tentative;
            if (!(old > nodes_[from.node].accepted) || nodes_[to.node].source == kFixedValue) continue;
            if (lineOfSight_.narrow(to.cell)) continue;
            const auto opensAlong = [&](std::int32_t cell) {
                return (right > 0 ? cells_[cell].east : cells_[cell].west) < kUnreachableCost;
            };
            const auto opensAcross = [&](std::int32_t cell) {
                return (up > 0 ? cells_[cell].north : cells_[cell].south) < kUnreachableCost;
            };
            const std::int32_t beside = from.cell + right, above = from.cell + up * grid_.width;
            if ((opensAlong(from.cell) && opensAcross(beside)) ||
                (opensAcross(from.cell) && opensAlong(above)))
                relaxFromSource(from, to, old);
        }
    }
}

float Front::centreValue(const WallNode& wallNode) const {
    const Cell c = grid_.at(wallNode.cell);
    const std::int32_t at = node(c.x, c.y);
    const std::int32_t source = nodes_[at].source;
    if (!(nodes_[at].accepted < kUnreachableCost) || source <= 0) return nodes_[at].accepted;
    const auto x = static_cast<float>(c.x);
    const auto y = static_cast<float>(c.y);
    return nodes_[at].accepted + sources_[source].costAt(x, y) -
           sources_[source].costAt(x + wallNode.x, y + wallNode.y);
}

}  // namespace muster
