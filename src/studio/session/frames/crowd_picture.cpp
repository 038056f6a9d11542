#include "studio/session/frames/crowd_picture.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kSteps = 65535.0;
constexpr double kFinest = 1.0 / 1024.0;  // Quantum of small crowds [m].
// Quantum of large crowds [m]; a runner's step still fits a single byte.
constexpr double kFinestLarge = 1.0 / 512.0;
// Share of the 16-bit range that a new lattice uses. The rest lets the crowd walk on.
constexpr double kUsedShare = 0.75;
// A lattice is replaced where its quantum exceeds the necessary one by this factor.
constexpr double kTooCoarse = 4.0;

struct Bounds {
    Vec2 min{0.0, 0.0};
    Vec2 max{0.0, 0.0};

    double span() const { return std::max(max.x - min.x, max.y - min.y); }
};

Bounds boundsOfPositions(std::span<const Vec2> positions) {
    if (positions.empty()) return {};
    Bounds bounds{positions.front(), positions.front()};
    for (const Vec2 p : positions) {
        bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y)};
        bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y)};
    }
    return bounds;
}

std::uint16_t number(double metres, double quantum) {
    return static_cast<std::uint16_t>(std::clamp(std::floor(metres / quantum + 0.5), 0.0, kSteps));
}

}  // namespace

void PlaceLattice::cover(std::span<const Vec2> positions) {
    const Bounds bounds = boundsOfPositions(positions);
    double needed = positions.size() > kFineCrowd ? kFinestLarge : kFinest;
    while (bounds.span() > needed * kSteps * kUsedShare) needed *= 2.0;
    const double reach = quantum_ * kSteps;
    const bool inside = bounds.min.x >= corner_.x && bounds.min.y >= corner_.y &&
                        bounds.max.x <= corner_.x + reach && bounds.max.y <= corner_.y + reach;
    if (inside && quantum_ >= 0.5 * needed && quantum_ < kTooCoarse * needed) return;
    quantum_ = needed;
    const Vec2 middle = (bounds.min + bounds.max) / 2.0;
    const auto snapped = [&](double value) {
        return std::floor(value / quantum_) * quantum_ - 32768.0 * quantum_;
    };
    corner_ = {snapped(middle.x), snapped(middle.y)};
}

std::uint16_t PlaceLattice::x(Vec2 p) const {
    return number(p.x - corner_.x, quantum_);
}
std::uint16_t PlaceLattice::y(Vec2 p) const {
    return number(p.y - corner_.y, quantum_);
}

void CrowdPicture::resize(std::size_t count) {
    for (auto* list : {&x, &y, &heading, &phase}) list->resize(count, 0);
    clip.resize(count, 0);
}

void CrowdPicture::place(std::span<const Vec2> positions) {
    resize(positions.size());
    lattice.cover(positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        x[i] = lattice.x(positions[i]);
        y[i] = lattice.y(positions[i]);
    }
}

}  // namespace muster
