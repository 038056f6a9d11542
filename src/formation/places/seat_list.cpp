#include "formation/places/seat_list.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Pairs are listed up to this much farther apart than asked, and a seat is listed anew once it moved half of
// that.
constexpr double kMargin = 0.8;
constexpr Vec2 kNowhere{1e300, 1e300};
constexpr std::size_t kStrayShare = 32;  // More strays than one of so many seats: all are listed anew;
constexpr std::size_t kLinkShare = 4;    // and where one by one brought more links than one for so many.
// No growth later: seats that stand apart have no more pairs than 6 each, and few are listed anew one by one.
constexpr std::size_t kMostPairs = 7;
constexpr std::size_t kMostLinks = 2;

}  // namespace

// Those that the list does not hold for. False where all had better be listed anew.
bool SeatList::findStrays(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                          const std::vector<std::uint8_t>& fit) {
    strays_.clear();
    if (foundAt_.size() != seats.size() || listed_.empty()) return false;
    Vec2 sum;
    double count = 0.0;
    for (const std::int32_t listed : listed_) {
        const auto k = static_cast<std::size_t>(listed);
        if (fit[k] == 0) continue;
        sum += seats[k] - foundAt_[k];
        count += 1.0;
    }
    drift_ = count > 0.0 ? sum / count : Vec2{};
    const double most = 0.5 * kMargin * apart_;
    for (std::size_t k = 0; k < seats.size(); ++k) {
        if (fit[k] == 0) continue;
        const Vec2 here = foundAt_[k] + drift_;
        const double far = std::max(lengthSquared(seats[k] - here), lengthSquared(next[k] - here));
        if (!(far <= most * most)) strays_.push_back(static_cast<std::int32_t>(k));
    }
    return strays_.size() <= seats.size() / kStrayShare && links_.size() <= seats.size() / kLinkShare;
}

void SeatList::update(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                      const std::vector<std::uint8_t>& fit, double apart) {
    if (apart == apart_ && findStrays(seats, next, fit)) {
        for (const std::int32_t stray : strays_) {
            const auto k = static_cast<std::size_t>(stray);
            listAnew(k, seats[k] - drift_);
        }
        return;
    }
    apart_ = apart;
    listAll(seats, fit);
}

void SeatList::listAll(const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit) {
    drift_ = {};
    strays_.reserve(seats.size());
    pairs_.reserve(seats.size() * kMostPairs);
    links_.reserve(seats.size() * kMostLinks);
    foundAt_.assign(seats.size(), kNowhere);
    listed_.clear();
    listedAt_.clear();
    for (std::size_t k = 0; k < seats.size(); ++k) {
        if (fit[k] == 0) continue;
        foundAt_[k] = seats[k];
        listed_.push_back(static_cast<std::int32_t>(k));
        listedAt_.push_back(seats[k]);
    }
    const double reach = apart_ * (1.0 + kMargin);
    cells_.sort(listedAt_, reach);
    pairs_.clear();
    if (!listed_.empty())
        cells_.forPairs(reach, [&](std::int32_t a, std::int32_t b) {
            pairs_.push_back({listed_[a], listed_[b]});
        });
    linkPairs();
}

// Pairs by each of their seats.
void SeatList::linkPairs() {
    links_.clear();
    laterOther_.assign(foundAt_.size(), -1);
    laterIn_.assign(static_cast<std::size_t>(cells_.grid().count()), -1);
    start_.assign(foundAt_.size() + 1, 0);
    for (const Pair pair : pairs_) {
        ++start_[pair.low];
        ++start_[pair.high];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : start_) s = sum += s;
    other_.resize(2 * pairs_.size());
    for (const Pair pair : pairs_) {
        other_[--start_[pair.low]] = pair.high;
        other_[--start_[pair.high]] = pair.low;
    }
}

void SeatList::chain(std::int32_t& first, std::size_t seat) {
    links_.push_back({static_cast<std::int32_t>(seat), first});
    first = static_cast<std::int32_t>(links_.size()) - 1;
}

// A seat is within half the margin of where it was found, moved along with all.
template <class Visit>
bool SeatList::anyRound(Vec2 p, const Visit& visit) const {
    const Grid& grid = cells_.grid();
    const Cell cell = grid.nearestCell(p);
    const std::int32_t left = std::max(cell.x - 1, 0), right = std::min(cell.x + 1, grid.width - 1);
    for (std::int32_t y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, grid.height - 1); ++y) {
        for (const std::int32_t at : cells_.within(grid.index({left, y}), grid.index({right, y})))
            if (visit(static_cast<std::size_t>(listed_[at]))) return true;
        if (links_.empty()) continue;
        for (std::int32_t x = left; x <= right; ++x)
            for (std::int32_t at = laterIn_[grid.index({x, y})]; at >= 0; at = link(at).next)
                if (visit(static_cast<std::size_t>(link(at).seat))) return true;
    }
    return false;
}

// Lists one as found here. What is listed of where it was found before stays: it is looked at in vain.
void SeatList::listAnew(std::size_t seat, Vec2 at) {
    if (foundAt_[seat] == kNowhere) listed_.push_back(static_cast<std::int32_t>(seat));
    foundAt_[seat] = at;
    const double reach = apart_ * (1.0 + kMargin);
    anyRound(at, [&](std::size_t other) {
        if (other == seat || !(lengthSquared(foundAt_[other] - at) < reach * reach)) return false;
        const auto [low, high] = std::minmax(seat, other);
        pairs_.push_back({static_cast<std::int32_t>(low), static_cast<std::int32_t>(high)});
        chain(laterOther_[seat], other);
        chain(laterOther_[other], seat);
        return false;
    });
    const Grid& grid = cells_.grid();
    chain(laterIn_[grid.index(grid.nearestCell(at))], seat);
}

bool SeatList::occupied(Vec2 spot, const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit,
                        std::size_t self) const {
    return !listed_.empty() && anyRound(spot - drift_, [&](std::size_t k) {
        return k != self && fit[k] != 0 && lengthSquared(seats[k] - spot) < apart_ * apart_;
    });
}

}  // namespace muster
