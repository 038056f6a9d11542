// Straight ways on uniform ground: values that know the point they come from.
#include <algorithm>
#include <cmath>

#include "cost/thin_wall.h"
#include "eikonal/front.h"

namespace muster {
namespace {

// A root this near to the line of cells is seen through the one cell between [cells across per cell along].
constexpr float kNearlyStraight = 1e-3f;
// Arcs that keep less than this off the corner of their tangents count as straight [cells].
constexpr float kFlat = 0.01f;
// Roots this near to each other stand at one corner, for cells at least so far off [cells].
constexpr float kSameCorner = 2.5f;
constexpr float kFar = 6.0f;
// Where a wall hides a root, ways bend within this many cells.
constexpr std::int32_t kNearHiding = 2;
constexpr float kBesideBend = 6.0f;

// The middle of a rounded corner between two points at its wall, a root as good as the points themselves;
// false where the straight way between them runs outside. The corner is an arc that touches the walls' lines
// through both points, as wide as the nearer one allows: on round obstacles both lie on it, at a polygon one
// may lie far along its side.
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
    const float cosine = 0.5f * outLength;  // Of half the angle of the turn.
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    if (cosine < 0.25f || sine < 1e-3f) return false;
    // From the points to where the lines cross.
    const float turn = 2.0f * sine * cosine;
    const float before = above / turn;
    const float after = below / turn;
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
    // Half the angle by its series in the sine.
    const float s2 = sine * sine;
    const float angle = sine * (1.0f + s2 * (1.0f / 6.0f + s2 * (0.075f + s2 * 0.0446f)));
    middle.cost = from.cost + from.unit * (before - tangent + radius * angle);
    return inward > kFlat;
}

}  // namespace

// True where ways bend at a cell: where it touches a wall, or lies between two.
inline bool Front::bends(std::int32_t cell) const {
    const std::int32_t number = sight_.wall(cell);
    if (number == 0) return false;
    const WallNode& beside = sight_.node(number);
    if (beside.normalX != 0.0f || beside.normalY != 0.0f) return true;
    const CellCost& c = cells_[cell];
    return (c.east == kInfiniteCost && c.west == kInfiniteCost) ||
           (c.north == kInfiniteCost && c.south == kInfiniteCost);
}

// True where a node is known to see the root: its value comes straight from there, or, far off, from another
// root at the same corner or from the root before it, as at the border between what the two see first.
inline bool Front::shows(std::int32_t node, std::int32_t number, bool far) const {
    const std::int32_t own = nodes_[node].root;
    if (own == number) return true;
    if (!far || own <= 0) return false;
    const PseudoSource& a = roots_[own];
    const PseudoSource& b = roots_[number];
    return own == b.parent || std::fabs(a.x - b.x) + std::fabs(a.y - b.y) < kSameCorner;
}

// What lies between a cell and a root. Between two cells that the root sees, those between which the way
// leaves towards it, it sees this one as well, unless a wall hides one from the other; else the way is looked
// along.
Ray Front::sees(FrontCell to, float x, float y, std::int32_t number) {
    hiding_ = -1;
    if (nodes_[to.node].hidden == number) {
        hiding_ = hidingCell_[to.node];
        return Ray::Wall;
    }
    const PseudoSource& root = roots_[number];
    const float dx = x - root.x;
    const float dy = y - root.y;
    const float ax = std::fabs(dx);
    const float ay = std::fabs(dy);
    const std::int32_t alongX = dx > 0.0f ? -1 : 1;
    const std::int32_t alongY = dy > 0.0f ? -stride_ : stride_;
    const std::int32_t straight = to.node + (ax >= ay ? alongX : alongY);
    const std::int32_t oblique = to.node + alongX + alongY;
    const float rise = sight_.rise(to.cell, x, y, root);
    const float rootRise = root.rise(x, y);
    if (std::min(rise, rootRise) < kHidden) {
        if (rise < kHidden) hiding_ = to.cell;
        return Ray::Wall;
    }
    const bool level = std::min(ax, ay) <= kNearlyStraight * std::max(ax, ay);
    const bool far = rootRise >= 0.0f && rootRise < 1.0f && ax + ay > kFar;
    const bool own = nodes_[straight].root == number || nodes_[oblique].root == number;
    if (own && rise >= kRisen && shows(straight, number, far) && (level || shows(oblique, number, far)))
        return Ray::Clear;
    return look(to, x, y, number);
}

Ray Front::look(FrontCell to, float x, float y, std::int32_t number) {
    const Ray ray = sight_.look(x, y, roots_[number], hiding_);
    if (ray == Ray::Wall) {
        nodes_[to.node].hidden = number;
        hidingCell_[to.node] = hiding_;
    }
    return ray;
}

// Offers `to` the cost of a straight way from the root of `from`, or from `from` itself where it lies at a
// wall. Returns false where differences should be tried: on other ground, or where the root is hidden.
bool Front::relaxStraight(FrontCell from, FrontCell to, float old) {
    const std::int32_t number = nodes_[from.node].root;
    if (nodes_[to.node].root == number) return true;
    const PseudoSource& root = roots_[number];
    if (!sight_.plain(to.cell, root.unit)) return false;
    // A value from differences gives way to a straight one that is hardly worse.
    const FrontNode& there = nodes_[to.node];
    if (there.root == 0 && old < kInfiniteCost && there.accepted == kInfiniteCost) old += kDoubt * root.unit;
    float x = 0.0f;
    float y = 0.0f;
    place(to, x, y);
    const float straight = root.costAt(x, y);
    if (!(straight < old - tolerance_)) return true;
    const Ray ray = sees(to, x, y, number);
    if (ray == Ray::Clear) {
        put(to, nodes_[to.node].tentative, straight, number);
        return true;
    }
    const bool atWall = sight_.wall(from.cell) != 0;
    if (!bends(from.cell)) {
        const bool bendsThere = ray == Ray::Wall && hiding_ >= 0 && (nodes_[to.node].root <= 0 || atWall);
        if (bendsThere && bendAt(hiding_, to, x, y, root.unit, old)) return true;
        // Hidden: by other ground, or in the shadow of a wall whose corner will offer better to nearly all.
        if (!atWall) return false;
    }
    bend(from, to, old);
    return true;
}

// Adds a bend to those kept, in the order of their costs; of equal ones the first counts.
void Front::Bends::take(float cost, std::int32_t at) {
    int k = count;
    while (k > 0 && value[k - 1] > cost) --k;
    if (k == kMost || (k > 0 && value[k - 1] == cost)) return;
    count = std::min(count + 1, kMost);
    for (int m = count - 1; m > k; --m) {
        value[m] = value[m - 1];
        cell[m] = cell[m - 1];
    }
    value[k] = cost;
    cell[k] = at;
}

// The wall cells near the one that hides a root from a point at which the way to the point is cheapest, and
// below `limit`.
Front::Bends Front::bestBends(std::int32_t hiding, const PseudoSource& target, float limit) const {
    const Cell middle = grid_.at(hiding);
    const Cell low{std::max(0, middle.x - kNearHiding), std::max(0, middle.y - kNearHiding)};
    const Cell high{std::min(grid_.width - 1, middle.x + kNearHiding),
                    std::min(grid_.height - 1, middle.y + kNearHiding)};
    Bends best;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const FrontCell at = this->at({x, y});
            const float cost = nodes_[at.node].accepted;
            if (!(cost < limit) || !bends(at.cell)) continue;
            if (nodes_[at.node].root <= 0 || roots_[nodes_[at.node].root].unit != target.unit) continue;
            float px = 0.0f;
            float py = 0.0f;
            place(at, px, py);
            const float here = cost + target.costAt(px, py);
            if (here < limit && here > 0.0f) best.take(here, at.cell);
        }
    }
    return best;
}

// Offers `to`, which lies at (x, y), the cheapest clear way bent at a wall near the cell that hides a root
// from it.
bool Front::bendAt(std::int32_t hiding, FrontCell to, float x, float y, float unit, float old) {
    const PseudoSource target{x, y, 0.0f, unit};
    hidingCell_[to.node] = -1;
    const Bends best = bestBends(hiding, target, old - tolerance_);
    for (int k = 0; k < best.count; ++k) {
        const FrontCell from = at(grid_.at(best.cell[k]));
        PseudoSource bent = target;
        place(from, bent.x, bent.y);
        // Farther off the way lies beside the one that was clear as far as here.
        const float apart = std::sqrt((x - bent.x) * (x - bent.x) + (y - bent.y) * (y - bent.y));
        const float share = std::min(1.0f, kBesideBend / std::max(apart, 1.0f));
        std::int32_t ignored = 0;
        if (sight_.look(bent.x + share * (x - bent.x), bent.y + share * (y - bent.y), bent, ignored) !=
            Ray::Clear)
            continue;
        put(to, nodes_[to.node].tentative, best.value[k], rootAt(from));
        return true;
    }
    return false;
}

// Offers `to` the way from `from`, which lies at a wall: straight, or along the arc where a round corner lies
// between.
void Front::bend(FrontCell from, FrontCell to, float old) {
    std::int32_t number = rootAt(from);
    float x = 0.0f;
    float y = 0.0f;
    place(to, x, y);
    const std::int32_t end = sight_.wall(to.cell);
    const PseudoSource& root = roots_[number];
    if (end != 0 && throughThinWall(root, sight_.node(end), x - root.x, y - root.y)) return;
    PseudoSource middle;
    const bool arc = end != 0 && middleOfArc(sight_.node(sight_.wall(from.cell)), sight_.node(end),
                                             roots_[number], x, y, middle);
    const float value = arc ? middle.costAt(x, y) : roots_[number].costAt(x, y);
    if (!(value < old - tolerance_)) return;
    if (arc) {
        number = static_cast<std::int32_t>(roots_.size());
        roots_.push_back(middle);
    }
    put(to, nodes_[to.node].tentative, value, number);
}

// The root at a wall cell, made where there is none yet.
std::int32_t Front::rootAt(FrontCell wallCell) {
    std::int32_t& number = wallRoot_[sight_.wall(wallCell.cell)];
    const float cost = nodes_[wallCell.node].accepted;
    if (number == 0 || roots_[number].cost != cost) {
        PseudoSource root;
        place(wallCell, root.x, root.y);
        root.cost = cost;
        root.parent = nodes_[wallCell.node].root;
        root.unit = roots_[root.parent].unit;
        const WallNode& beside = sight_.node(sight_.wall(wallCell.cell));
        root.normalX = beside.normalX;
        root.normalY = beside.normalY;
        number = static_cast<std::int32_t>(roots_.size());
        roots_.push_back(root);
    }
    return number;
}

// From a cell at a wall ways also lead to the cells at its corners, past one wall cell at most.
void Front::bendRound(FrontCell from) {
    for (const std::int32_t right : {1, -1}) {
        for (const std::int32_t up : {1, -1}) {
            const FrontCell to{from.cell + up * grid_.width + right, from.node + up * stride_ + right};
            const float old = nodes_[to.node].tentative;
            if (!(old > nodes_[from.node].accepted) || nodes_[to.node].root == kGiven) continue;
            const CellCost& cost = cells_[from.cell];
            const bool beside = (right > 0 ? cost.east : cost.west) < kInfiniteCost;
            const bool above = (up > 0 ? cost.north : cost.south) < kInfiniteCost;
            if (beside || above) relaxStraight(from, to, old);
        }
    }
}

float Front::centreValue(const WallNode& beside) const {
    const Cell c = grid_.at(beside.cell);
    const std::int32_t at = node(c.x, c.y);
    const std::int32_t root = nodes_[at].root;
    if (!(nodes_[at].accepted < kInfiniteCost) || root <= 0) return nodes_[at].accepted;
    const auto x = static_cast<float>(c.x);
    const auto y = static_cast<float>(c.y);
    return nodes_[at].accepted + roots_[root].costAt(x, y) - roots_[root].costAt(x + beside.x, y + beside.y);
}

}  // namespace muster
