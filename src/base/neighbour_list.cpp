#include "base/neighbour_list.h"

#include <algorithm>

namespace muster {
namespace {

constexpr Vec2 kNowhere{1e300, 1e300};
// Inverse share of points that have moved too far above which all points are listed again.
constexpr std::size_t kStrayShare = 32;
// Number of points per link of the overflow chains below which all points are listed again.
constexpr std::size_t kLinkShare = 4;
// Number of pairs and links per point for which memory is reserved, so that it need not grow later: points
// that keep the reach from each other have at most 6 neighbours each within a skin of 0.8, and few points are
// listed again one by one.
constexpr std::size_t kPairsPerPoint = 7;
constexpr std::size_t kLinksPerPoint = 2;

}  // namespace

void NeighbourList::build(std::span<const Vec2> points, double reach, double skin, const Ring& ring) {
    reach_ = reach;
    skin_ = skin;
    listedReach_ = reach * (1.0 + skin);
    pairs_.clear();
    pairs_.reserve(points.size() * kPairsPerPoint);
    listedAt_.assign(points.begin(), points.end());
    if (points.size() < 2) return;
    cells_.sort(points, listedReach_);
    cells_.forPairs(listedReach_, [&](std::int32_t low, std::int32_t high) {
        pairs_.push_back({low, high});
    });
    if (ring.length > 0.0) addPairsAcross(points, ring);
}

// Sweeps along the joint of a ring.
void NeighbourList::addPairsAcross(std::span<const Vec2> points, const Ring& ring) {
    atLeft_.clear();
    atRight_.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double x = points[k].x - ring.left;
        if (x < listedReach_) atLeft_.push_back(static_cast<std::int32_t>(k));
        if (ring.length - x < listedReach_) atRight_.push_back(static_cast<std::int32_t>(k));
    }
    const auto isBelow = [&](std::int32_t a, std::int32_t b) {
        return points[a].y != points[b].y ? points[a].y < points[b].y : a < b;
    };
    std::sort(atLeft_.begin(), atLeft_.end(), isBelow);
    std::sort(atRight_.begin(), atRight_.end(), isBelow);
    std::size_t first = 0;
    for (const std::int32_t l : atLeft_) {
        while (first < atRight_.size() && points[atRight_[first]].y < points[l].y - listedReach_) ++first;
        for (std::size_t k = first; k < atRight_.size(); ++k) {
            const std::int32_t r = atRight_[k];
            if (points[r].y > points[l].y + listedReach_) break;
            if (lengthSquared(ring.between(points[l], points[r])) < listedReach_ * listedReach_ && l != r)
                pairs_.push_back({std::min(l, r), std::max(l, r)});
        }
    }
}

void NeighbourList::update(std::span<const Vec2> points, double reach, double skin) {
    if (reach != reach_ || skin != skin_ || !holdsFor(points, 0.5 * skin * reach)) build(points, reach, skin);
}

bool NeighbourList::holdsFor(std::span<const Vec2> points, double distance) const {
    if (listedAt_.size() != points.size()) return false;
    const double most = distance * distance;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!(lengthSquared(points[k] - listedAt_[k]) <= most)) return false;
    return true;
}

void NeighbourList::updateRows(std::span<const Vec2> points, std::span<const Vec2> next,
                               std::span<const std::uint8_t> active, double reach, double skin) {
    if (reach == reach_ && skin == skin_ && findStrays(points, next, active)) {
        for (const std::int32_t stray : strays_) relist(stray, points[stray] - drift_);
        return;
    }
    reach_ = reach;
    skin_ = skin;
    listedReach_ = reach * (1.0 + skin);
    buildRows(points, active);
}

// Finds the points for which the list is invalid. False where all points had better be listed again.
bool NeighbourList::findStrays(std::span<const Vec2> points, std::span<const Vec2> next,
                               std::span<const std::uint8_t> active) {
    strays_.clear();
    if (listedAt_.size() != points.size() || listed_.empty()) return false;
    Vec2 sum;
    double count = 0.0;
    for (const std::int32_t k : listed_) {
        if (active[k] == 0) continue;
        sum += points[k] - listedAt_[k];
        count += 1.0;
    }
    drift_ = count > 0.0 ? sum / count : Vec2{};
    const double most = 0.5 * skin_ * reach_;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (active[k] == 0) continue;
        const Vec2 here = listedAt_[k] + drift_;
        const double far = std::max(lengthSquared(points[k] - here), lengthSquared(next[k] - here));
        if (!(far <= most * most)) strays_.push_back(static_cast<std::int32_t>(k));
    }
    return strays_.size() <= points.size() / kStrayShare && overflow_.size() <= points.size() / kLinkShare;
}

void NeighbourList::buildRows(std::span<const Vec2> points, std::span<const std::uint8_t> active) {
    drift_ = {};
    strays_.reserve(points.size());
    pairs_.reserve(points.size() * kPairsPerPoint);
    overflow_.reserve(points.size() * kLinksPerPoint);
    listedAt_.assign(points.size(), kNowhere);
    listed_.clear();
    cellPoints_.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (active[k] == 0) continue;
        listedAt_[k] = points[k];
        listed_.push_back(static_cast<std::int32_t>(k));
        cellPoints_.push_back(points[k]);
    }
    cells_.sort(cellPoints_, listedReach_);
    pairs_.clear();
    if (!listed_.empty())
        cells_.forPairs(listedReach_, [&](std::int32_t a, std::int32_t b) {
            pairs_.push_back({listed_[a], listed_[b]});
        });
    fillRows();
}

// Counting sort of the pairs by each of their points.
void NeighbourList::fillRows() {
    overflow_.clear();
    overflowOfRow_.assign(listedAt_.size(), -1);
    overflowOfCell_.assign(cells_.grid().count(), -1);
    rowStart_.assign(listedAt_.size() + 1, 0);
    for (const NeighbourPair pair : pairs_) {
        ++rowStart_[pair.low];
        ++rowStart_[pair.high];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : rowStart_) s = sum += s;
    row_.reserve(2 * pairs_.capacity());
    row_.resize(2 * pairs_.size());
    for (const NeighbourPair pair : pairs_) {
        row_[--rowStart_[pair.low]] = pair.high;
        row_[--rowStart_[pair.high]] = pair.low;
    }
}

void NeighbourList::prepend(std::int32_t& chain, std::int32_t point) {
    overflow_.push_back({point, chain});
    chain = static_cast<std::int32_t>(overflow_.size()) - 1;
}

// Lists one point at `at`, without the drift. Its old entries stay, which costs time but changes nothing.
void NeighbourList::relist(std::int32_t point, Vec2 at) {
    if (listedAt_[point] == kNowhere) listed_.push_back(point);
    listedAt_[point] = at;
    anyInCellsAround(at, [&](std::int32_t other) {
        if (other == point || !(lengthSquared(listedAt_[other] - at) < listedReach_ * listedReach_))
            return false;
        pairs_.push_back({std::min(point, other), std::max(point, other)});
        prepend(overflowOfRow_[point], other);
        prepend(overflowOfRow_[other], point);
        return false;
    });
    const Grid& grid = cells_.grid();
    prepend(overflowOfCell_[grid.index(grid.nearestCell(at))], point);
}

}  // namespace muster
