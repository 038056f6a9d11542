#include "engine/systems/passages/way_fields.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"
#include "engine/passages/way_number.h"

namespace muster {

bool onOppositeSides(const Walk& one, const Walk& other) {
    return one.side * other.side < 0 && one.cost < kInfiniteCost && other.cost < kInfiniteCost;
}

bool WayFields::Set::holds(const StaticGround& now, const std::vector<Passage>& wanted) const {
    const auto same = [](const Passage& x, const Passage& y) {
        return x.a == y.a && x.b == y.b && x.speed == y.speed;
    };
    return ground == now.version() &&
           std::equal(passages.begin(), passages.end(), wanted.begin(), wanted.end(), same);
}

void WayFields::update(const StaticGround& ground, const std::vector<Passage>& passages) {
    ground_ = &ground;
    if (!present_.holds(ground, passages)) {
        if (!other_.holds(ground, passages)) begin(ground, passages);
        std::int64_t cells = std::numeric_limits<std::int64_t>::max();
        if (other_.solved < passages.size()) solve(ground, cells);
        std::swap(present_, other_);
        preparing_ = false;
    }
    present_.passages = passages;
}

// Begins the prepared set again.
void WayFields::begin(const StaticGround& ground, const std::vector<Passage>& passages) {
    other_.passages = passages;
    other_.ground = ground.version();
    other_.fields.resize(std::max(other_.fields.size(), passages.size()));
    other_.solved = 0;
    if (passages.empty()) return;
    edges_.open(ground.coarse());
    for (const Passage& passage : passages) edges_.close(passage);
    solver_.begin(ground.coarse(), edges_, passages.front(), other_.fields.front());
}

bool WayFields::solve(const StaticGround& ground, std::int64_t& cells) {
    while (other_.solved < other_.passages.size()) {
        if (!solver_.advance(ground.coarse(), other_.fields[other_.solved], cells)) return false;
        if (++other_.solved == other_.passages.size()) break;
        solver_.begin(ground.coarse(), edges_, other_.passages[other_.solved], other_.fields[other_.solved]);
    }
    return true;
}

bool WayFields::prepare(const StaticGround& ground, const std::vector<Passage>& passages, std::int64_t& done,
                        std::int64_t& cells) {
    if (!preparing_ || !other_.holds(ground, passages)) {
        begin(ground, passages);
        std::int64_t again = done;
        if (again > 0) solve(ground, again);
        preparing_ = true;
    }
    const std::int64_t before = cells;
    const bool all = solve(ground, cells);
    done += before - cells;
    return all;
}

Vec2 WayFields::inRoom(Vec2 p) const {
    const double cell = ground_->coarse().grid.cell;
    for (const Passage& passage : present_.passages) {
        const double away = distance(closestOnSegment(passage.a, passage.b, p), p);
        if (away >= cell) continue;
        const Vec2 left = perpendicular((passage.b - passage.a) / passage.width());
        return p + (passage.onLeft(p) ? left : -left) * (cell - away);
    }
    return p;
}

bool WayFields::isInside(std::int32_t way, Vec2 p) const {
    return way >= 0 && walk(passageOf(way), p).side == sideBehind(way);
}

}  // namespace muster
