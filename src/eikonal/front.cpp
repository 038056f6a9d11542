#include "eikonal/front.h"

#include <algorithm>

namespace muster {
namespace {

// A bucket's width in units of the lowest cost of one cell. Within a bucket cells come in order of arrival;
// what that spoils is mended by visiting a cell again, so a finer width saves visits and a coarser one empty
// buckets.
constexpr float kBucketShare = 0.125f;
// Second-order differences need evenly spaced values: they are used where the costs of two steps differ by
// less.
constexpr float kEven = 0.2f;

// The value that follows from those of two neighbours across each other, a step from which costs ca and cb;
// from a alone where it would lie below one of them.
inline float upwind(float a, float ca, float b, float cb) {
    const float alone = a + ca;
    if (!(b < alone && a < b + cb)) return alone;
    const float difference = a - b;
    const float sa = ca * ca;
    const float sb = cb * cb;
    const float sum = sa + sb;
    return (sb * a + sa * b + ca * cb * std::sqrt(std::max(0.0f, sum - difference * difference))) / sum;
}

}  // namespace

void Front::fit(const Grid& grid) {
    if (grid.width == grid_.width && grid.height == grid_.height && !nodes_.empty()) {
        grid_ = grid;
        return;
    }
    grid_ = grid;
    stride_ = grid.width + 1;
    const std::size_t size = static_cast<std::size_t>(grid.height + 4) * stride_ + 2;
    nodes_.assign(size, {});
    hidingCell_.assign(size, -1);
    // Nothing is ever below minus infinity: the padding is never marched.
    const FrontNode never{kInfiniteCost, -kInfiniteCost, 0, 0};
    std::fill_n(nodes_.begin(), 2 * stride_ + 1, never);
    std::fill(nodes_.begin() + node(0, grid.height) - 1, nodes_.end(), never);
    for (std::int32_t y = 0; y < grid.height; ++y) nodes_[node(grid.width, y)] = never;
}

void Front::begin(const UnitCost& cost, bool secondOrder) {
    cells_ = cost.cells.data();
    // No difference is below minus infinity.
    even_ = secondOrder ? kEven : -kInfiniteCost;
    width_ = kBucketShare * std::max(cost.lowest, 1e-6f);
    tolerance_ = 1e-3f * width_;
    queue_.restart(1.0f / width_);
    firstNode_ = std::numeric_limits<std::int32_t>::max();
    lastNode_ = -1;
    sight_.begin(cost);
    roots_.assign(1, {});
    wallRoot_.assign(cost.nodes.size() + 1, 0);
    writtenLow_ = {grid_.width, grid_.height};
    writtenHigh_ = {-1, -1};
}

std::int32_t Front::addSource(float x, float y, float unit) {
    roots_.push_back({x, y, 0.0f, unit, 0.0f, 0.0f, 0});
    return static_cast<std::int32_t>(roots_.size()) - 1;
}

void Front::seed(Cell cell, float value, std::int32_t root) {
    const FrontCell at = this->at(cell);
    if (!(value < nodes_[at.node].tentative)) return;
    noteWritten(cell, cell);
    put(at, kInfiniteCost, value, root);
}

Ray Front::seen(Cell cell, std::int32_t root, float& value) const {
    const PseudoSource& from = roots_[root];
    const FrontCell at = this->at(cell);
    if (!sight_.plain(at.cell, from.unit)) return Ray::OtherGround;
    float x = 0.0f;
    float y = 0.0f;
    place(at, x, y);
    value = from.costAt(x, y);
    std::int32_t ignored = 0;
    return sight_.look(x, y, from, ignored);
}

template <Front::Side kSide>
inline float Front::towards(const CellCost& c) {
    if constexpr (kSide == Side::East) return c.east;
    if constexpr (kSide == Side::North) return c.north;
    if constexpr (kSide == Side::West) return c.west;
    return c.south;
}

// Offers the new value of `from` to the neighbour from which `from` lies on side kSide. Only solutions that
// come through `from` are looked at: those through the opposite neighbour were offered when that one got its
// value.
template <Front::Side kSide>
inline void Front::relax(FrontCell from, const FrontNode* here, const CellCost* fromCost) {
    constexpr bool kAlong = kSide == Side::East || kSide == Side::West;
    const std::int32_t rowStep = kSide == Side::South ? 1 : kSide == Side::North ? -1 : 0;
    const std::int32_t columnStep = kSide == Side::West ? 1 : kSide == Side::East ? -1 : 0;
    const std::ptrdiff_t step = rowStep * stride_ + columnStep;
    const std::ptrdiff_t cellStep = rowStep * grid_.width + columnStep;
    const FrontNode* const there = here + step;
    const float value = here->accepted;
    const float old = there->tentative;
    if (!(old > value) || there->root == kGiven) return;
    const auto to = [&] {
        return FrontCell{from.cell + static_cast<std::int32_t>(cellStep),
                         from.node + static_cast<std::int32_t>(step)};
    };
    if (here->root > 0 && relaxStraight(from, to(), old)) return;
    const CellCost* const cost = fromCost + cellStep;

    float a = value;
    float ca = towards<kSide>(*cost);
    const float last = ca;
    if (!(ca < kInfiniteCost)) return;
    const float behind = here[-step].accepted;
    const float before = towards<kSide>(*fromCost);
    if (behind <= value && std::fabs(before - ca) <= even_ * ca) {
        a = (4.0f * value - behind) * (1.0f / 3.0f);
        ca *= 2.0f / 3.0f;
    }

    // The cheaper of the two neighbours across.
    const std::ptrdiff_t across = kAlong ? stride_ : 1;
    const std::ptrdiff_t acrossCell = kAlong ? grid_.width : 1;
    const float up = kAlong ? cost->north : cost->east;
    const float down = kAlong ? cost->south : cost->west;
    const float upValue = there[across].accepted;
    const float downValue = there[-across].accepted;
    const bool above = upValue + up <= downValue + down;
    float b = above ? upValue : downValue;
    float cb = above ? up : down;
    float best = a + ca;
    if (b + cb < kInfiniteCost) {
        const float acrossBehind = there[above ? 2 * across : -2 * across].accepted;
        if (acrossBehind <= b) {
            const CellCost& next = cost[above ? acrossCell : -acrossCell];
            const float beforeAcross = kAlong ? (above ? next.north : next.south)
                                              : (above ? next.east : next.west);
            if (std::fabs(beforeAcross - cb) <= even_ * cb) {
                b = (4.0f * b - acrossBehind) * (1.0f / 3.0f);
                cb *= 2.0f / 3.0f;
            }
        }
        best = upwind(a, ca, b, cb);
    }
    const float least = there->root > 0 && !(before < last) ? kDoubt * cost->east : tolerance_;
    if (best < old - least) put(to(), old, best, before < last ? kCheaper : 0);
}

inline void Front::spread(FrontCell from, const FrontNode* here) {
    const CellCost* const cost = cells_ + from.cell;
    relax<Side::West>(from, here, cost);
    relax<Side::East>(from, here, cost);
    relax<Side::South>(from, here, cost);
    relax<Side::North>(from, here, cost);
    if (here->root > 0 && sight_.wall(from.cell) != 0) bendRound(from);
}

bool Front::step() {
    if (!queue_.advance()) return false;
    const std::vector<FrontCell>& bucket = queue_.bucket();
    for (std::size_t k = 0; k < bucket.size(); ++k) {
        const FrontCell from = bucket[k];
        FrontNode& here = nodes_[from.node];
        if (!(here.tentative < here.accepted)) continue;
        here.accepted = here.tentative;
        noteReached(from.node);
        spread(from, &here);
    }
    return true;
}

// The march writes to reached cells and those beside them. The flood, and seeds that were never reached,
// stand apart.
void Front::end(Cell low, Cell high) {
    noteWritten(low, high);
    low = writtenLow_;
    high = writtenHigh_;
    const std::int32_t left = std::max(0, low.x - 1);
    const std::int32_t right = std::min(grid_.width - 1, high.x + 1);
    for (std::int32_t y = std::max(0, low.y - 1); y <= std::min(grid_.height - 1, high.y + 1); ++y) {
        std::fill(nodes_.begin() + node(left, y), nodes_.begin() + node(right, y) + 1, FrontNode{});
    }
    sight_.end();
}

}  // namespace muster
