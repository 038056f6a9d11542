#include "engine/formation/places/room_for_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kBeyondRadii = 0.04;  // Distance between two bodies [m].
constexpr double kLargeBody = 1.2;     // Ratio to the least radius from which on a body is large.
// Number of large bodies up to which each pushes alone; more are taken together.
constexpr std::size_t kFewLarge = 16;
constexpr std::int32_t kRoomSweeps = 40;  // Most sweeps over pairs that are too close.
constexpr double kRoomError = 1e-3;       // Distance by which pairs may remain too close [m].

}  // namespace

double RoomForBodies::needed(std::int32_t a, std::int32_t b) const {
    return std::max(least_, radii_[a] + radii_[b] + kBeyondRadii);
}

double RoomForBodies::nearest(std::span<const Vec2> places, std::int32_t place) const {
    double least2 = std::numeric_limits<double>::infinity();
    for (std::int32_t k = 0; std::cmp_less(k, places.size()); ++k)
        if (k != place) least2 = std::min(least2, lengthSquared(places[k] - places[place]));
    return std::sqrt(least2);
}

bool RoomForBodies::isTight(std::span<const Vec2> places) {
    bool tight = false;
    cells_.sort(places, reach_);
    cells_.forPairs(reach_, [&](std::int32_t a, std::int32_t b) {
        tight = tight || distance(places[a], places[b]) < needed(a, b) - kRoomError;
    });
    return tight;
}

// Pushes points at distance d to sqrt(d^2 + c^2): areas are kept, and the nearest point gets as far as it has
// to.
void RoomForBodies::push(std::span<Vec2> places, std::int32_t large) const {
    const double near = nearest(places, large);
    const double smallest = *std::min_element(radii_.begin(), radii_.end());
    const double wanted = std::max(least_, radii_[large] + smallest + kBeyondRadii);
    const double grown = wanted * wanted - near * near;
    if (!(grown > 0.0) || near == 0.0) return;
    for (std::int32_t k = 0; std::cmp_less(k, places.size()); ++k) {
        const Vec2 d = places[k] - places[large];
        const double d2 = lengthSquared(d);
        if (k != large) places[k] = places[large] + d * std::sqrt(1.0 + grown / d2);
    }
}

void RoomForBodies::findNearest(std::span<const Vec2> places) {
    near_.assign(places.size(), reach_);
    cells_.sort(places, reach_);
    cells_.forPairs(reach_, [&](std::int32_t a, std::int32_t b) {
        const double apart = distance(places[a], places[b]);
        near_[a] = std::min(near_[a], apart);
        near_[b] = std::min(near_[b], apart);
    });
}

// Grows the disc round a cluster evenly by the room that its members lack; outside, areas are kept.
void RoomForBodies::growCluster(std::span<Vec2> places, std::span<const std::int32_t> cluster) const {
    Vec2 middle;
    for (const std::int32_t k : cluster) middle += places[k];
    middle = middle / static_cast<double>(cluster.size());
    double spread = 0.0, lacking = 0.0;
    for (const std::int32_t k : cluster) {
        const double wanted = needed(k, k);
        spread += lengthSquared(places[k] - middle);
        lacking += std::max(0.0, wanted * wanted - near_[k] * near_[k]);
    }
    const double disc = std::max(2.0 * spread / static_cast<double>(cluster.size()), least_ * least_);
    for (Vec2& place : places) {
        const Vec2 d = place - middle;
        place = middle + d * std::sqrt(1.0 + lacking / kPi / std::max(lengthSquared(d), disc));
    }
}

// Halves clusters along their longer side down to a few, and lets each grow.
void RoomForBodies::grow(std::span<Vec2> places, std::span<std::int32_t> cluster, std::size_t share) {
    if (cluster.size() <= share) return growCluster(places, cluster);
    const auto [left, right] = std::minmax_element(
        cluster.begin(), cluster.end(),
        [&](std::int32_t a, std::int32_t b) { return places[a].x < places[b].x; });
    const auto [low, high] = std::minmax_element(
        cluster.begin(), cluster.end(),
        [&](std::int32_t a, std::int32_t b) { return places[a].y < places[b].y; });
    const bool alongX = places[*right].x - places[*left].x > places[*high].y - places[*low].y;
    std::sort(cluster.begin(), cluster.end(), [&](std::int32_t a, std::int32_t b) {
        const double u = alongX ? places[a].x : places[a].y, v = alongX ? places[b].x : places[b].y;
        return u != v ? u < v : a < b;
    });
    grow(places, cluster.first(cluster.size() / 2), share);
    grow(places, cluster.subspan(cluster.size() / 2), share);
}

// Makes one sweep of projections, pair by pair. True once no two were too close.
bool RoomForBodies::separate(std::span<Vec2> places) {
    bool done = true;
    cells_.sort(places, reach_);
    cells_.forPairs(reach_, [&](std::int32_t a, std::int32_t b) {
        const Vec2 apart = places[b] - places[a];
        const double now = length(apart), missing = needed(a, b) - now;
        if (missing < kRoomError) return;
        done = false;
        const Vec2 along = now > 1e-9 ? apart / now : Vec2{1.0, 0.0};
        places[a] -= along * (0.5 * missing);
        places[b] += along * (0.5 * missing);
    });
    return done;
}

void RoomForBodies::make(std::span<const double> radii, double least, std::span<Vec2> places) {
    if (places.size() < 2) return;
    radii_ = radii;
    least_ = least;
    const auto [small, largest] = std::minmax_element(radii.begin(), radii.end());
    reach_ = std::max(least, 2.0 * *largest + kBeyondRadii);
    if (!isTight(places)) return;
    large_.clear();
    for (std::int32_t k = 0; std::cmp_less(k, places.size()); ++k)
        if (radii[k] > kLargeBody * *small) large_.push_back(k);
    std::sort(large_.begin(), large_.end(), [&](std::int32_t a, std::int32_t b) {
        return radii[a] != radii[b] ? radii[a] > radii[b] : a < b;
    });
    if (large_.size() > kFewLarge) {
        findNearest(places);
        grow(places, large_, (large_.size() + kFewLarge - 1) / kFewLarge);
    } else {
        for (const std::int32_t k : large_) push(places, k);
    }
    for (std::int32_t sweep = 0; sweep < kRoomSweeps; ++sweep)
        if (separate(places)) break;
}

}  // namespace muster
