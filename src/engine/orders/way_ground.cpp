#include "engine/orders/way_ground.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kLeastCell = 1.0;   // Least edge of a coarse cell [m].
constexpr double kMostCells = 64e3;  // Approximate number of coarse cells.
constexpr double kExactReach = 2.9;  // Distance up to which the ground's own distances are used [m].
constexpr float kNoDistance = 1e6f;  // A distance beyond all others [m].
// Two chamfer steps, scaled so that the error is below 5 % to both sides...
constexpr float kStraightLength = 0.955f;
constexpr float kDiagonalLength = 1.351f;  // ... (Borgefors 1986).

}  // namespace

void WayGround::update(const Environment& environment) {
    const GroundVersion version = versionOf(environment);
    const bool same = version_ == version;
    environment_ = &environment;
    if (same && !point_.empty()) return;
    version_ = version;
    fine_ = environment.grid();
    const double area = static_cast<double>(fine_.count()) * fine_.cell * fine_.cell;
    const double edge = std::max(kLeastCell, std::sqrt(area / kMostCells));
    factor_ = std::max(1, static_cast<std::int32_t>(std::ceil(edge / fine_.cell - 1e-9)));
    grid_.origin = fine_.origin;
    grid_.cell = fine_.cell * factor_;
    grid_.width = (fine_.width + factor_ - 1) / factor_;
    grid_.height = (fine_.height + factor_ - 1) / factor_;
    roomOf(environment.staticClearance());
    distances(environment.staticClearance());
    for (std::int32_t c = 0; c < grid_.count(); ++c)
        if (clearance_[c] >= kExactReach) clearance_[c] = std::max(clearance_[c], distance_[c]);
    findSlow(environment);
}

// Finds the point with most room in each coarse cell: its middle, where that has as much as any other.
void WayGround::roomOf(std::span<const float> near) {
    point_.resize(grid_.count());
    clearance_.resize(grid_.count());
    for (std::int32_t y = 0; y < grid_.height; ++y)
        for (std::int32_t x = 0; x < grid_.width; ++x) {
            const std::int32_t x1 = std::min((x + 1) * factor_, fine_.width);
            const std::int32_t y1 = std::min((y + 1) * factor_, fine_.height);
            std::int32_t best = fine_.index({std::min(x * factor_ + factor_ / 2, fine_.width - 1),
                                             std::min(y * factor_ + factor_ / 2, fine_.height - 1)});
            for (std::int32_t fy = y * factor_; fy < y1 && near[best] < kExactReach; ++fy)
                for (std::int32_t fx = x * factor_; fx < x1; ++fx)
                    if (near[fine_.index({fx, fy})] > near[best]) best = fine_.index({fx, fy});
            const std::int32_t cell = grid_.index({x, y});
            point_[cell] = fine_.centre(fine_.at(best));
            clearance_[cell] = near[best];
        }
}

// Spreads a chamfer distance from cells where the ground knows its own distance.
void WayGround::distances(std::span<const float> near) {
    const std::int32_t width = grid_.width, height = grid_.height;
    distance_.resize(grid_.count());
    for (std::int32_t c = 0; c < grid_.count(); ++c) {
        const Cell middle = fine_.nearestCell(grid_.centre(grid_.at(c)));
        const float value = near[fine_.index(middle)];
        distance_[c] = value < kExactReach ? value : kNoDistance;
    }
    const auto straight = static_cast<float>(kStraightLength * grid_.cell);
    const auto diagonal = static_cast<float>(kDiagonalLength * grid_.cell);
    const auto lower = [&](std::int32_t x, std::int32_t y, std::int32_t dx, std::int32_t dy) {
        if (!grid_.contains({x + dx, y + dy})) return;
        float& value = distance_[grid_.index({x, y})];
        const float step = dx != 0 && dy != 0 ? diagonal : straight;
        value = std::min(value, distance_[grid_.index({x + dx, y + dy})] + step);
    };
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x)
            for (const Cell d : {Cell{-1, 0}, Cell{-1, -1}, Cell{0, -1}, Cell{1, -1}}) lower(x, y, d.x, d.y);
    for (std::int32_t y = height; y-- > 0;)
        for (std::int32_t x = width; x-- > 0;)
            for (const Cell d : {Cell{1, 0}, Cell{1, 1}, Cell{0, 1}, Cell{-1, 1}}) lower(x, y, d.x, d.y);
}

void WayGround::findSlow(const Environment& environment) {
    const RasterView speed = environment.staticPatchSpeed();
    slowness_.clear();
    least_ = 1.0;
    if (speed.isConstant()) return;
    slowness_.assign(grid_.count(), 0.0f);
    for (std::int32_t k = 0; k < fine_.count(); ++k) {
        const Cell at = fine_.at(k);
        float& value = slowness_[grid_.index({at.x / factor_, at.y / factor_})];
        value = std::max(value, std::isfinite(speed[k]) ? 1.0f / speed[k] : 1.0f);
    }
    const auto [least, most] = std::minmax_element(slowness_.begin(), slowness_.end());
    least_ = *least;
    if (*least == *most)
        slowness_.clear();
    else
        spreadSlow();
}

// Spreads a chamfer distance from ground that is slower than the best.
void WayGround::spreadSlow() {
    slower_ = slowness_;
    toSlower_.resize(grid_.count());
    for (std::int32_t c = 0; c < grid_.count(); ++c)
        toSlower_[c] = slowness_[c] > least_ ? 0.0f : kNoDistance;
    const auto edge = static_cast<float>(grid_.cell);
    const auto take = [&](std::int32_t x, std::int32_t y, Cell d) {
        if (!grid_.contains({x + d.x, y + d.y})) return;
        const std::int32_t to = grid_.index({x, y}), from = grid_.index({x + d.x, y + d.y});
        const float away = toSlower_[from] +
                           edge * (d.x != 0 && d.y != 0 ? kDiagonalLength : kStraightLength);
        if (away >= toSlower_[to]) return;
        toSlower_[to] = away;
        slower_[to] = slower_[from];
    };
    for (std::int32_t y = 0; y < grid_.height; ++y)
        for (std::int32_t x = 0; x < grid_.width; ++x)
            for (const Cell d : {Cell{-1, 0}, Cell{-1, -1}, Cell{0, -1}, Cell{1, -1}}) take(x, y, d);
    for (std::int32_t y = grid_.height; y-- > 0;)
        for (std::int32_t x = grid_.width; x-- > 0;)
            for (const Cell d : {Cell{1, 0}, Cell{1, 1}, Cell{0, 1}, Cell{-1, 1}}) take(x, y, d);
    for (float& away : toSlower_) away = std::max(0.0f, away - 0.5f * edge);
}

double WayGround::clearanceAt(Vec2 p) const {
    const float near = environment_->staticClearance()[fine_.index(fine_.nearestCell(p))];
    if (near < kExactReach) return near;
    const double u = Grid::bounded((p.x - grid_.origin.x) / grid_.cell - 0.5, 0.0, grid_.width - 1.0);
    const double v = Grid::bounded((p.y - grid_.origin.y) / grid_.cell - 0.5, 0.0, grid_.height - 1.0);
    const std::int32_t x = std::min(static_cast<std::int32_t>(u), std::max(0, grid_.width - 2));
    const std::int32_t y = std::min(static_cast<std::int32_t>(v), std::max(0, grid_.height - 2));
    const std::int32_t x1 = std::min(x + 1, grid_.width - 1), y1 = std::min(y + 1, grid_.height - 1);
    const double below = distance_[grid_.index({x, y})] * (1.0 - (u - x)) +
                         distance_[grid_.index({x1, y})] * (u - x);
    const double above = distance_[grid_.index({x, y1})] * (1.0 - (u - x)) +
                         distance_[grid_.index({x1, y1})] * (u - x);
    return std::max(kExactReach, below * (1.0 - (v - y)) + above * (v - y));
}

}  // namespace muster
