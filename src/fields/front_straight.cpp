// Straight ways on uniform ground: values that know the point they come from.
#include <algorithm>
#include <cmath>

#include "fields/front.h"

namespace muster {
namespace {

// A root this near to the line of cells is seen through the one cell between [cells across per cell along].
constexpr float kNearlyStraight = 1e-3f;
// Arcs lower than this over their chords count as straight [cells].
constexpr float kFlat = 0.01f;
// Roots this near to each other stand at one corner, for cells at least so far off [cells].
constexpr float kSameCorner = 2.5f;
constexpr float kFar = 6.0f;

// The middle of the arc between two points at a rounded corner, a root as good as the points themselves; false where
// the straight way between them runs outside.
bool middleOfArc(const WallNode& a, const WallNode& b, const Root& from, float x, float y, Root& middle) {
    const float dx = x - from.x;
    const float dy = y - from.y;
    const bool inside = dx * a.normalX + dy * a.normalY < 0.0f && dx * b.normalX + dy * b.normalY > 0.0f;
    const float outX = a.normalX + b.normalX;
    const float outY = a.normalY + b.normalY;
    const float outLength = std::sqrt(outX * outX + outY * outY);  // 2 cos(t / 2) for an arc of angle t.
    const float chord = std::sqrt(dx * dx + dy * dy);
    if (!inside || outLength < 0.5f) return false;
    // Height of an arc over its chord: half the chord times tan(t / 4); its length by a series in 1 - cos t, under
    // 0.3 % off up to a quarter turn.
    const float half = 0.5f * outLength;
    const float height = 0.5f * chord * std::sqrt(std::max(0.0f, (1.0f - half) / (1.0f + half)));
    const float turn = 2.0f * (1.0f - half * half);
    middle.x = from.x + 0.5f * dx + height * outX / outLength;
    middle.y = from.y + 0.5f * dy + height * outY / outLength;
    middle.unit = from.unit;
    middle.parent = from.parent;
    middle.normalX = outX / outLength;
    middle.normalY = outY / outLength;
    middle.cost = from.cost + 0.5f * from.unit * chord * (1.0f + turn * (1.0f / 12.0f) + turn * turn * (1.0f / 40.0f));
    return height > kFlat;
}

}  // namespace

// Where the value of a cell belongs, from the centre of cell (0, 0) [cells].
void Front::place(FrontCell cell, float& x, float& y) const {
    const std::int32_t row = cell.node - cell.cell - (2 * stride_ + 1);
    x = static_cast<float>(cell.cell - row * grid_.width);
    y = static_cast<float>(row);
    if (const std::int32_t number = sight_.wall(cell.cell); number != 0) {
        x += sight_.node(number).x;
        y += sight_.node(number).y;
    }
}

// True where a node is known to see the root: its value comes straight from there, or, far off, from another root at
// the same corner or from the root before it, as at the border between what the two see first.
inline bool Front::shows(std::int32_t node, std::int32_t number, bool far) const {
    const std::int32_t own = root_[node];
    if (own == number) return true;
    if (!far || own <= 0) return false;
    const Root& a = roots_[own];
    const Root& b = roots_[number];
    return own == b.parent || std::fabs(a.x - b.x) + std::fabs(a.y - b.y) < kSameCorner;
}

// What lies between a cell and a root. Between two cells that the root sees, those between which the way leaves
// towards it, it sees this one as well, unless a wall hides one from the other; else the way is looked along.
Ray Front::sees(FrontCell to, float x, float y, std::int32_t number) {
    if (hidden_[to.node] == number) return Ray::Wall;
    const Root& root = roots_[number];
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
    if (std::min(rise, rootRise) < kHidden) return Ray::Wall;
    const bool level = std::min(ax, ay) <= kNearlyStraight * std::max(ax, ay);
    const bool far = rootRise >= 0.0f && rootRise < 1.0f && ax + ay > kFar;
    const bool own = root_[straight] == number || root_[oblique] == number;
    if (own && rise >= kRisen && shows(straight, number, far) && (level || shows(oblique, number, far))) return Ray::Clear;
    return look(to, x, y, number);
}

Ray Front::look(FrontCell to, float x, float y, std::int32_t number) {
    const Ray ray = sight_.look(x, y, roots_[number]);
    if (ray == Ray::Wall) hidden_[to.node] = number;
    return ray;
}

// Offers `to` the cost of a straight way from the root of `from`, or from `from` itself where it lies at a wall.
// Returns false where differences should be tried: on other ground, or where the root is hidden.
bool Front::relaxStraight(FrontCell from, FrontCell to, float old) {
    const std::int32_t number = root_[from.node];
    if (root_[to.node] == number) return true;
    const Root& root = roots_[number];
    if (!sight_.plain(to.cell, root.unit)) return false;
    // A value from differences gives way to a straight one that is hardly worse.
    if (root_[to.node] == 0 && old < kInfiniteCost && accepted_[to.node] == kInfiniteCost) old += kDoubt * root.unit;
    float x = 0.0f;
    float y = 0.0f;
    place(to, x, y);
    const float straight = root.costAt(x, y);
    if (!(straight < old - tolerance_)) return true;
    const Ray ray = sees(to, x, y, number);
    if (ray == Ray::Clear) {
        put(to, tentative_[to.node], straight, number);
    } else if (sight_.wall(from.cell) != 0) {
        bend(from, to, old);
    } else {
        // Hidden: by other ground, or in the shadow of a wall whose corner will offer better to nearly all.
        return false;
    }
    return true;
}

// Offers `to` the way from `from`, which lies at a wall: straight, or along the arc where a round corner lies between.
void Front::bend(FrontCell from, FrontCell to, float old) {
    std::int32_t number = rootAt(from);
    float x = 0.0f;
    float y = 0.0f;
    place(to, x, y);
    const std::int32_t end = sight_.wall(to.cell);
    Root middle;
    const bool arc = end != 0 && middleOfArc(sight_.node(sight_.wall(from.cell)), sight_.node(end), roots_[number], x, y, middle);
    const float value = arc ? middle.costAt(x, y) : roots_[number].costAt(x, y);
    if (!(value < old - tolerance_)) return;
    if (arc) {
        number = static_cast<std::int32_t>(roots_.size());
        roots_.push_back(middle);
    }
    put(to, tentative_[to.node], value, number);
}

// The root at a wall cell, made where there is none yet.
std::int32_t Front::rootAt(FrontCell wallCell) {
    std::int32_t& number = wallRoot_[sight_.wall(wallCell.cell)];
    const float cost = accepted_[wallCell.node];
    if (number == 0 || roots_[number].cost != cost) {
        Root root;
        place(wallCell, root.x, root.y);
        root.cost = cost;
        root.parent = root_[wallCell.node];
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
            const float old = tentative_[to.node];
            if (!(old > accepted_[from.node]) || root_[to.node] == kGiven) continue;
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
    const std::int32_t root = root_[at];
    if (!(accepted_[at] < kInfiniteCost) || root <= 0) return accepted_[at];
    const auto x = static_cast<float>(c.x);
    const auto y = static_cast<float>(c.y);
    return accepted_[at] + roots_[root].costAt(x, y) - roots_[root].costAt(x + beside.x, y + beside.y);
}

}  // namespace muster
