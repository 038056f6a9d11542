#include "formation/seat_list.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Pairs are listed up to this much farther apart than asked, and listed anew once a seat moved half of that.
constexpr double kMargin = 0.8;
constexpr Vec2 kNowhere{1e300, 1e300};

}  // namespace

bool SeatList::holds(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                     const std::vector<std::uint8_t>& fit) {
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
        if (!(far <= most * most)) return false;
    }
    return true;
}

void SeatList::update(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                      const std::vector<std::uint8_t>& fit, double apart) {
    if (apart == apart_ && holds(seats, next, fit)) return;
    apart_ = apart;
    drift_ = {};
    foundAt_.assign(seats.size(), kNowhere);
    listed_.clear();
    listedAt_.clear();
    for (std::size_t k = 0; k < seats.size(); ++k) {
        if (fit[k] == 0) continue;
        foundAt_[k] = seats[k];
        listed_.push_back(static_cast<std::int32_t>(k));
        listedAt_.push_back(seats[k]);
    }
    const double reach = apart * (1.0 + kMargin);
    cells_.sort(listedAt_, reach);
    pairs_.clear();
    if (!listed_.empty())
        cells_.forPairs(reach, [&](std::int32_t a, std::int32_t b) {
            pairs_.push_back({listed_[static_cast<std::size_t>(a)], listed_[static_cast<std::size_t>(b)]});
        });
    link();
}

// Pairs by each of their seats.
void SeatList::link() {
    start_.assign(foundAt_.size() + 1, 0);
    for (const Pair pair : pairs_) {
        ++start_[static_cast<std::size_t>(pair.low)];
        ++start_[static_cast<std::size_t>(pair.high)];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : start_) s = sum += s;
    other_.resize(2 * pairs_.size());
    for (const Pair pair : pairs_) {
        other_[static_cast<std::size_t>(--start_[static_cast<std::size_t>(pair.low)])] = pair.high;
        other_[static_cast<std::size_t>(--start_[static_cast<std::size_t>(pair.high)])] = pair.low;
    }
}

bool SeatList::occupied(Vec2 spot, const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit,
                        std::size_t self) const {
    if (listed_.empty()) return false;
    // A seat is within half the margin of where it was found, moved along with all.
    const Grid& grid = cells_.grid();
    const Cell cell = grid.cellOf(spot - drift_);
    const std::int32_t left = std::max(cell.x - 1, 0), right = std::min(cell.x + 1, grid.width - 1);
    if (left > right) return false;
    for (std::int32_t y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, grid.height - 1); ++y) {
        for (const std::int32_t at : cells_.within(grid.index({left, y}), grid.index({right, y}))) {
            const auto k = static_cast<std::size_t>(listed_[static_cast<std::size_t>(at)]);
            if (k != self && fit[k] != 0 && lengthSquared(seats[k] - spot) < apart_ * apart_) return true;
        }
    }
    return false;
}

}  // namespace muster
