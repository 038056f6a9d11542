#include "engine/systems/goals/doors.h"

#include <algorithm>

#include "base/hash.h"
#include "engine/fields/cost/ground_level.h"

namespace muster {
namespace {

constexpr std::int32_t kFineDoorCells = 1 << 15;  // Number of cells above which cells twice as wide are used.
constexpr std::int32_t kMostDoorCells = 1 << 20;  // Number of cells above which no doors are looked for.
constexpr double kTurnBackShare = 0.9;            // Share of the cost by doors...
constexpr double kTurnBackLength = 1.0;  // ... less this [m], below which the field turns back in a door.
constexpr double kDoorEnd = 0.05;        // Distance between a body and the end of a door [m].
constexpr double kBehindDoor[] = {0.8, 0.4, 0.2, 0.0};  // Distances behind a door for which people head [m].

std::uint32_t keyOf(const std::vector<Passage>& doors) {
    if (doors.empty()) return 0;
    Hash hash;
    for (const Passage& door : doors)
        for (const double x : {door.a.x, door.a.y, door.b.x, door.b.y}) hash.add(x);
    return static_cast<std::uint32_t>(hash.value()) | 1u;
}

}  // namespace

void Doors::update(const WorldState& state, GoalFields& fields) {
    const StaticGround& ground = fields.ground(0);
    ids_.clear();
    std::size_t count = 0;
    bool changed = ground.version() != version_;
    for (const Area& area : state.areas) {
        if (area.def.kind != AreaKind::Exit) continue;
        ids_.push_back(area.id.value);
        changed = changed || count >= exits_.size() || exits_[count] != area.def.polygon;
        ++count;
    }
    if (changed || count != exits_.size()) {
        version_ = ground.version();
        exits_.clear();
        for (const Area& area : state.areas)
            if (area.def.kind == AreaKind::Exit) exits_.push_back(area.def.polygon);
        plan_.doors.clear();
        key_ = 0;
        toExit_.clear();
        fields_.clear();
        const std::int32_t cells = ground.grid().count();
        if (!ground.open() && cells <= kMostDoorCells && !exits_.empty()) {
            const bool isFine = cells <= kFineDoorCells;
            const UnitCost wide = isFine ? UnitCost() : ground.middle().unitCost();
            const UnitCost& unitCost = isFine ? fields.unitCost(0) : wide;
            grid_ = unitCost.grid;
            search_.find(state.environment, ground, unitCost, exits_, plan_);
            key_ = keyOf(plan_.doors);
            solveWalks(unitCost);
        }
    }
    if (any()) findShut(state);
}

Vec2 Doors::pointBehind(std::int32_t way, double away) const {
    const Passage& d = door(way);
    const Vec2 left = perpendicular(normalized(d.b - d.a));
    return d.middle() + left * (away * static_cast<double>(sideBehind(way)));
}

void Doors::solveWalks(const UnitCost& unitCost) {
    const std::size_t doors = plan_.doors.size();
    walks_.resize(doors);
    for (std::size_t d = 0; d < doors; ++d) {
        std::int64_t cells = std::int64_t{1} << 40;
        solver_.begin(unitCost, plan_.edges, plan_.doors[d], walks_[d]);
        solver_.advance(unitCost, walks_[d], cells);
    }
    waysFrom_.assign(static_cast<std::size_t>(plan_.rooms), {});
    next_.assign(ways(), {});
    fields_.resize(ways());
    toExit_.resize(exits_.size());
    for (std::int32_t way = 0; std::cmp_less(way, ways()); ++way) waysFrom_[before(way)].push_back(way);
    for (std::int32_t way = 0; std::cmp_less(way, ways()); ++way)
        for (const std::int32_t other : waysFrom_[behind(way)]) {
            if (passageOf(other) == passageOf(way)) continue;
            const double cost = walk(other, pointBehind(way, 1.5 * grid_.cell));
            if (cost < kInfiniteCost) next_[way].push_back({other, cost});
        }
}

double Doors::walk(std::int32_t way, Vec2 p) const {
    const Walk found = walks_[passageOf(way)].at(p);
    return found.side == sideBefore(way) ? found.cost : kInfiniteCost;
}

void Doors::findShut(const WorldState& state) {
    shut_.assign(plan_.doors.size(), 0);
    const double radius = state.parameters.character.radius;
    for (std::size_t d = 0; d < shut_.size(); ++d) {
        const Passage& door = plan_.doors[d];
        bool isFree = false;
        for (const double share : {0.5, 0.25, 0.75})
            isFree = isFree || state.environment.distanceToObstacle(lerp(door.a, door.b, share), radius) >=
                                   std::min(radius, 0.2 * door.width());
        shut_[d] = isFree ? 0 : 1;
    }
}

// The costs from all doors to the exit, for routes that do not turn back in a door (Bellman and Ford).
void Doors::findOnward(const GoalField& field, ToExit& to) const {
    to.onward.assign(ways(), kInfiniteCost);
    std::vector<double> straight(ways(), kInfiniteCost);
    for (std::int32_t way = 0; std::cmp_less(way, ways()); ++way) {
        straight[way] = field.cost(pointBehind(way, 0.0));
        if (!(straight[way] < kInfiniteCost)) straight[way] = field.cost(pointBehind(way, 1.5 * grid_.cell));
        if (!leadsTo(way, to)) continue;
        to.onward[way] = straight[way];
        to.free = std::min(to.free, straight[way]);
    }
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (std::int32_t way = 0; std::cmp_less(way, ways()); ++way) {
            if (leadsTo(way, to)) continue;
            for (const Next& next : next_[way]) {
                const double cost = next.cost + to.onward[next.way];
                if (!(cost < to.onward[way])) continue;
                to.onward[way] = cost;
                isChanged = true;
            }
        }
    }
    // The field to the exit is more precise than walks from door to door.
    for (std::size_t way = 0; way < ways(); ++way)
        if (to.onward[way] < kInfiniteCost &&
            straight[way] > kTurnBackShare * to.onward[way] - kTurnBackLength)
            to.onward[way] = straight[way];
}

void Doors::findNearest(ToExit& to) const {
    to.nearest.assign(plan_.room.size(), -1);
    for (std::int32_t k = 0; std::cmp_less(k, plan_.room.size()); ++k) {
        const std::int32_t room = plan_.room[k];
        if (room < 0 || to.inRoom[room] != 0) continue;
        double least = kInfiniteCost;
        for (const std::int32_t way : waysFrom_[room]) {
            const Walk found = walks_[passageOf(way)].ofCell(k);
            const double cost = found.cost + to.onward[way];
            if (found.side != sideBefore(way) || !(cost < least)) continue;
            least = cost;
            to.nearest[k] = static_cast<std::int16_t>(way);
        }
    }
}

const Doors::ToExit& Doors::toExit(const Area& exit, const GoalField& field) {
    const auto e = static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), exit.id.value) -
                                            ids_.begin());
    if (toExit_[e] != nullptr) return *toExit_[e];
    toExit_[e] = std::make_unique<ToExit>();
    ToExit& to = *toExit_[e];
    to.inRoom.assign(static_cast<std::size_t>(plan_.rooms), 0);
    for (const std::int32_t room : plan_.exitRooms[e]) to.inRoom[room] = 1;
    findOnward(field, to);
    findNearest(to);
    return to;
}

// All other doors are walls, so that the field leads through this one.
void Doors::prepareField(std::int32_t way, GoalFields& fields) {
    if (fields_[way] != nullptr) return;
    fields_[way] = std::make_unique<GoalField>();
    const StaticGround& ground = fields.ground(0);
    UnitCost unitCost = fields.unitCost(0);
    const Grid& grid = unitCost.grid;
    WalkEdges before, after;
    before.open(unitCost);
    after.open(unitCost);
    for (std::size_t d = 0; d < plan_.doors.size(); ++d)
        if (d != passageOf(way)) after.close(plan_.doors[d]);
    std::vector<std::uint8_t> closed(grid.count(), 0);
    for (std::int32_t k = 0; k < grid.count(); ++k) closed[k] = before.ofCell(k) != after.ofCell(k) ? 1 : 0;
    const auto isClosed = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) && closed[grid.index({x, y})] != 0;
    };
    for (std::int32_t y = 0; y < grid.height; ++y)
        for (std::int32_t x = 0; x < grid.width; ++x) {
            CellCost& cost = unitCost.cells[grid.index({x, y})];
            const bool own = isClosed(x, y);
            if (own || isClosed(x + 1, y)) cost.east = kUnreachableCost;
            if (own || isClosed(x, y + 1)) cost.north = kUnreachableCost;
            if (own || isClosed(x - 1, y)) cost.west = kUnreachableCost;
            if (own || isClosed(x, y - 1)) cost.south = kUnreachableCost;
        }
    std::erase_if(unitCost.nodes, [&](const WallNode& node) { return closed[node.cell] != 0; });
    const Passage& d = door(way);
    const double margin = std::min(ground.radius() + kDoorEnd, 0.5 * d.width());
    const Vec2 along = normalized(d.b - d.a), half = along * (0.5 * d.width() - margin);
    const double narrows = fromLeft(way) ? d.right : d.left;
    for (const double beyond : kBehindDoor) {
        const Vec2 middle = pointBehind(way, beyond > 0.0 ? narrows + beyond : 0.0);
        if (beyond > 0.0 && !ground.collisionFree(d.middle(), middle)) continue;
        const Vec2 line[] = {middle - half, middle + half};
        fields_[way]->solveToLine(ground, unitCost, line, eikonal_);
        return;
    }
}

}  // namespace muster
