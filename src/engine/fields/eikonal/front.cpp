#include "engine/fields/eikonal/front.h"

#include <algorithm>

namespace muster {
namespace {

constexpr std::size_t kReservedSources = 1024;  // Number of pseudo-sources with memory from the start.

// Width of a bucket in units of the lowest unit cost. Cells of one bucket are visited in order of arrival,
// and again where that order was wrong: a smaller width saves visits, a larger one saves empty buckets.
constexpr float kBucketWidth = 0.125f;
// Relative difference between the costs of two steps up to which second-order differences are used: they need
// evenly spaced values.
constexpr float kMaxStepDifference = 0.2f;

// The upwind solution t of ((t - a) / ca)^2 + ((t - b) / cb)^2 = 1 for the values a and b of two neighbours
// at right angles, from which a step costs ca and cb; from a alone where t would lie below one of them.
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

void Front::resize(const Grid& grid) {
    if (grid.width == grid_.width && grid.height == grid_.height && !nodes_.empty()) {
        grid_ = grid;
        return;
    }
    grid_ = grid;
    stride_ = grid.width + 1;
    const std::size_t size = static_cast<std::size_t>(grid.height + 4) * stride_ + 2;
    nodes_.assign(size, {});
    sources_.reserve(kReservedSources);
    wallSource_.reserve(size);
    occluderOf_.assign(size, -1);
    // No value is below minus infinity: the padding is never reached.
    const FrontNode padding{kUnreachableCost, -kUnreachableCost, 0, 0};
    std::fill_n(nodes_.begin(), 2 * stride_ + 1, padding);
    std::fill(nodes_.begin() + node(0, grid.height) - 1, nodes_.end(), padding);
    for (std::int32_t y = 0; y < grid.height; ++y) nodes_[node(grid.width, y)] = padding;
}

void Front::begin(const UnitCost& cost, bool secondOrder) {
    cells_ = cost.cells.data();
    // No difference is below minus infinity.
    maxStepDifference_ = secondOrder ? kMaxStepDifference : -kUnreachableCost;
    bucketWidth_ = kBucketWidth * std::max(cost.lowest, 1e-6f);
    tolerance_ = 1e-3f * bucketWidth_;
    queue_.restart(1.0f / bucketWidth_);
    firstNode_ = std::numeric_limits<std::int32_t>::max();
    lastNode_ = -1;
    lineOfSight_.begin(cost);
    sources_.assign(1, {});
    wallSource_.assign(cost.nodes.size() + 1, 0);
    writtenLow_ = {grid_.width, grid_.height};
    writtenHigh_ = {-1, -1};
}

std::int32_t Front::addSource(float x, float y, float unit) {
    sources_.push_back({x, y, 0.0f, unit, 0.0f, 0.0f, 0});
    return static_cast<std::int32_t>(sources_.size()) - 1;
}

void Front::seed(Cell cell, float value, std::int32_t source) {
    const FrontCell at = this->at(cell);
    if (!(value < nodes_[at.node].tentative)) return;
    noteWritten(cell, cell);
    put(at, kUnreachableCost, value, source);
}

void Front::seedSource(Cell cell, float value) {
    const CellCost& cost = cells_[grid_.index(cell)];
    PseudoSource source;
    position(at(cell), source.x, source.y);
    source.cost = value;
    source.unit = std::min({cost.east, cost.north, cost.west, cost.south});
    sources_.push_back(source);
    seed(cell, value, static_cast<std::int32_t>(sources_.size()) - 1);
}

Visibility Front::visibility(Cell cell, std::int32_t source, float& value) const {
    const PseudoSource& from = sources_[source];
    const FrontCell at = this->at(cell);
    if (!lineOfSight_.uniform(at.cell, from.unit)) return Visibility::OtherGround;
    float x = 0.0f;
    float y = 0.0f;
    position(at, x, y);
    value = from.costAt(x, y);
    std::int32_t ignored = 0;
    return lineOfSight_.trace(x, y, from, ignored);
}

template <Front::Side kSide>
inline float Front::towards(const CellCost& c) {
    if constexpr (kSide == Side::East) return c.east;
    if constexpr (kSide == Side::North) return c.north;
    if constexpr (kSide == Side::West) return c.west;
    return c.south;
}

// Updates the neighbour from which `from` lies on side kSide with the new value of `from`. Only solutions
// through `from` are considered: solutions through the opposite neighbour were, when that was accepted.
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
    if (!(old > value) || there->source == kFixedValue) return;
    const auto to = [&] {
        return FrontCell{from.cell + static_cast<std::int32_t>(cellStep),
                         from.node + static_cast<std::int32_t>(step)};
    };
    const CellCost* const cost = fromCost + cellStep;
    float ca = towards<kSide>(*cost);
    if (!(ca < kUnreachableCost)) return;
    if (here->source > 0 && relaxFromSource(from, to(), old)) return;

    float a = value;
    const float last = ca;
    const float behind = here[-step].accepted;
    const float before = towards<kSide>(*fromCost);
    if (behind <= value && std::fabs(before - ca) <= maxStepDifference_ * ca) {
        a = (4.0f * value - behind) * (1.0f / 3.0f);
        ca *= 2.0f / 3.0f;
    }

    // The cheaper of the two neighbours at right angles.
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
    if (b + cb < kUnreachableCost) {
        const float acrossBehind = there[above ? 2 * across : -2 * across].accepted;
        if (acrossBehind <= b) {
            const CellCost& next = cost[above ? acrossCell : -acrossCell];
            const float beforeAcross = kAlong ? (above ? next.north : next.south)
                                              : (above ? next.east : next.west);
            if (std::fabs(beforeAcross - cb) <= maxStepDifference_ * cb) {
                b = (4.0f * b - acrossBehind) * (1.0f / 3.0f);
                cb *= 2.0f / 3.0f;
            }
        }
        best = upwind(a, ca, b, cb);
    }
    const float least = there->source > 0 && !(before < last) ? kDifferenceError * cost->east : tolerance_;
    if (best < old - least) put(to(), old, best, before < last ? kFromCheaperGround : 0);
}

inline void Front::relaxNeighbours(FrontCell from, const FrontNode* here) {
    const CellCost* const cost = cells_ + from.cell;
    relax<Side::West>(from, here, cost);
    relax<Side::East>(from, here, cost);
    relax<Side::South>(from, here, cost);
    relax<Side::North>(from, here, cost);
    if (here->source > 0 && lineOfSight_.wall(from.cell) != 0) relaxDiagonals(from);
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
        relaxNeighbours(from, &here);
    }
    return true;
}

// A solve writes to reached cells and their neighbours. Cells of fillVisible() and seeds that were never
// reached may lie apart from these.
void Front::end(Cell low, Cell high) {
    noteWritten(low, high);
    low = writtenLow_;
    high = writtenHigh_;
    const std::int32_t left = std::max(0, low.x - 1);
    const std::int32_t right = std::min(grid_.width - 1, high.x + 1);
    for (std::int32_t y = std::max(0, low.y - 1); y <= std::min(grid_.height - 1, high.y + 1); ++y) {
        std::fill(nodes_.begin() + node(left, y), nodes_.begin() + node(right, y) + 1, FrontNode{});
    }
    lineOfSight_.end();
}

}  // namespace muster
