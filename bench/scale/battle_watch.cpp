#include "scale/battle_watch.h"

#include <algorithm>
#include <numeric>

namespace muster::scale {
namespace {

constexpr double kFarFromPlace = 1.5;  // Farther from its place somebody should walk [m].
constexpr double kMoved = 0.3;         // Who has not moved so far stands [m].
constexpr double kStands = 10.0;       // For so long [s].

double radiusOf(const World& world, std::size_t character) {
    const double own = world.characters().body[character].radius;
    return own > 0.0 ? own : world.parameters().character.radius;
}

}  // namespace

double distanceFromTarget(const World& world, std::size_t character) {
    const CharactersView characters = world.characters();
    const std::int32_t place = characters.place[character];
    const std::span<const Vec2> targets = world.group(characters.group[character]).placeTargets;
    if (place < 0 || std::cmp_greater_equal(place, targets.size())) return -1.0;
    return distance(characters.position[character], targets[place]);
}

void BattleWatch::lookAtOverlaps(const World& world) {
    const std::span<const Vec2> position = world.characters().position;
    order_.resize(position.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        return position[a].x != position[b].x ? position[a].x < position[b].x : a < b;
    });
    double largest = 0.0;
    for (std::size_t i = 0; i < position.size(); ++i) largest = std::max(largest, radiusOf(world, i));
    for (std::size_t a = 0; a < order_.size(); ++a)
        for (std::size_t b = a + 1; b < order_.size(); ++b) {
            const std::int32_t i = order_[a], j = order_[b];
            if (position[j].x - position[i].x >= 2.0 * largest) break;
            const double touching = radiusOf(world, i) + radiusOf(world, j);
            overlap_ = std::max(overlap_, 1.0 - distance(position[i], position[j]) / touching);
        }
}

void BattleWatch::lookAt(const World& world, std::size_t i, double topSpeed) {
    const CharactersView characters = world.characters();
    const double now = world.time(), dt = world.parameters().stepTime;
    const Vec2 here = characters.position[i];
    const auto [at, isNew] = records_.try_emplace(characters.id[i]);
    Record& record = at->second;
    if (isNew) record.spot = record.last = here, record.since = record.away = now;
    speed_ = std::max(speed_, distance(here, record.last) / dt / topSpeed);
    record.last = here;
    if (distance(here, record.spot) > kMoved) {
        record.spot = here;
        record.since = now;
    }
    if (distanceFromTarget(world, i) <= kFarFromPlace) record.away = now;
    if (record.counted || now - record.since < kStands || now - record.away < kStands) return;
    if (record.reported >= record.since) return;
    record.counted = true;
    ++stuck_;
}

void BattleWatch::look(const World& world, bool overlaps) {
    for (const Event& event : world.events()) {
        if (event.kind == EventKind::Swap) ++changes_;
        if (event.kind == EventKind::Stuck) records_[event.subject].reported = world.time();
    }
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const double own = characters.body[i].maxSpeed;
        lookAt(world, i, own > 0.0 ? own : world.parameters().character.maxSpeed);
    }
    if (overlaps) lookAtOverlaps(world);
}

}  // namespace muster::scale
