#include "engine/passages/door_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

// Ratio of the width of the rooms on both sides to the width of a door, at least.
constexpr double kRoomRatio = 1.5;
// Distance straight before a door within which basins that meet belong to it [m].
constexpr double kDoorReach = 1.5;
// Cells to either side of the meeting point of two basins that are looked at.
constexpr std::int32_t kClimbCells = 4;
constexpr double kFilePace = 0.75;   // Share of the flow where two bodies do not fit side by side.
constexpr double kExitHeight = 1e6;  // Height of cells in exits [m].
// Distance to a door within which the rooms beside it are looked for [cells].
constexpr double kBesideReach = 2.0;
constexpr std::size_t kMostDoors = 64;

struct DoorStep {
    std::uint8_t bit;
    std::int32_t x, y;
};
constexpr DoorStep kDoorSteps[] = {{1, 1, 0}, {2, 0, 1}, {4, -1, 0}, {8, 0, -1}};

// True for a point straight before or behind a door, near it.
bool isBefore(const Passage& door, Vec2 p) {
    const Vec2 along = (door.b - door.a) / door.width();
    return std::fabs(dot(p - door.middle(), along)) <= 0.5 * door.width() &&
           std::fabs(cross(p - door.middle(), along)) < kDoorReach;
}

double awayFrom(const Passage& door, Vec2 p) {
    return distance(closestOnSegment(door.a, door.b, p), p);
}

}  // namespace

void DoorSearch::findHeights(const StaticGround& ground, const UnitCost& unitCost,
                             std::span<const Polygon> exits) {
    grid_ = unitCost.grid;
    radius_ = ground.radius();
    height_.assign(grid_.count(), -1.0);
    exitCells_.resize(exits.size());
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        if (!unitCost.wall(k)) {
            const Grid& fine = ground.grid();
            const Cell at = fine.nearestCell(grid_.centre(grid_.at(k)));
            height_[k] = std::max(0.0, static_cast<double>(ground.rawClearance()[fine.index(at)]));
        }
    for (std::size_t e = 0; e < exits.size(); ++e) {
        exitCells_[e].clear();
        const Box box = boundsOf(exits[e]);
        const Cell low = grid_.nearestCell(box.min), high = grid_.nearestCell(box.max);
        for (const bool beside : {false, true}) {
            for (std::int32_t y = low.y; y <= high.y; ++y)
                for (std::int32_t x = low.x; x <= high.x; ++x) {
                    const std::int32_t k = grid_.index({x, y});
                    if (height_[k] < 0.0) continue;
                    // An exit that holds the centre of no cell is entered from the cells that it touches.
                    if (beside || containsPoint(exits[e], grid_.centre({x, y}))) exitCells_[e].push_back(k);
                }
            if (!exitCells_[e].empty()) break;
        }
        for (const std::int32_t k : exitCells_[e]) height_[k] = kExitHeight;
    }
}

std::int32_t DoorSearch::rootOf(std::int32_t cell) {
    while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
    return cell;
}

// Lists the path from a cell to wider ground.
void DoorSearch::climb(std::int32_t cell, const DoorPlan& plan, std::vector<Vec2>& path) const {
    path.clear();
    for (std::int32_t k = 0; k < kClimbCells; ++k) {
        path.push_back(grid_.centre(grid_.at(cell)));
        std::int32_t next = cell;
        for (const DoorStep& step : kDoorSteps) {
            const std::int32_t other = cell + step.x + step.y * grid_.width;
            if ((plan.edges.ofCell(cell) & step.bit) != 0 && parent_[other] >= 0 &&
                height_[other] > height_[next])
                next = other;
        }
        if (next == cell) return;
        cell = next;
    }
}

// Joins two basins that meet, unless both are clearly wider than the gap between them.
void DoorSearch::meet(const Environment& environment, std::int32_t cell, std::int32_t other, DoorPlan& plan) {
    const std::int32_t a = rootOf(cell), b = rootOf(other);
    if (a == b) return;
    const auto join = [&] {
        const std::int32_t root = std::min(a, b);
        peak_[root] = std::max(peak_[a], peak_[b]);
        parent_[a] = parent_[b] = root;
    };
    const double lower = std::min(peak_[a], peak_[b]);
    if (lower <= kRoomRatio * height_[cell]) return join();
    const Vec2 at = grid_.centre(grid_.at(cell));
    for (const Passage& door : plan.doors)
        if (isBefore(door, at)) return;
    climb(cell, plan, part_);
    way_.assign(part_.rbegin(), part_.rend());
    climb(other, plan, part_);
    way_.insert(way_.end(), part_.begin(), part_.end());
    std::optional<Passage> gap = narrowestPassage(environment, way_, true);
    // Exits count as wide, but a wide opening does not become a door by an exit.
    if (!gap || std::min(lower, Environment::kClearanceLimit) < kRoomRatio * 0.5 * gap->width())
        return join();
    for (const Passage& door : plan.doors)
        if (isBefore(door, gap->middle())) return;
    if (gap->width() < 4.0 * radius_) gap->pace = kFilePace;
    plan.doors.push_back(*gap);
    plan.edges.close(*gap);
}

void DoorSearch::flood(const Environment& environment, DoorPlan& plan) {
    order_.clear();
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        if (height_[k] >= 0.0) order_.push_back({-height_[k], k});
    sort_.sort(order_);
    parent_.assign(grid_.count(), -1);
    peak_.assign(grid_.count(), 0.0);
    for (const SortKey& key : order_) {
        const std::int32_t cell = key.index;
        parent_[cell] = cell;
        peak_[cell] = height_[cell];
        for (const DoorStep& step : kDoorSteps) {
            const std::int32_t other = cell + step.x + step.y * grid_.width;
            if ((plan.edges.ofCell(cell) & step.bit) == 0 || parent_[other] < 0) continue;
            meet(environment, cell, other, plan);
        }
    }
}

void DoorSearch::closeDoors(const UnitCost& unitCost, DoorPlan& plan) const {
    plan.edges.open(unitCost);
    for (const Passage& door : plan.doors) plan.edges.close(door);
}

void DoorSearch::labelRooms(DoorPlan& plan) {
    plan.room.assign(grid_.count(), -1);
    plan.rooms = 0;
    for (std::int32_t k = 0; k < grid_.count(); ++k) {
        if (height_[k] < 0.0 || plan.room[k] >= 0) continue;
        plan.room[k] = plan.rooms;
        stack_.assign(1, k);
        while (!stack_.empty()) {
            const std::int32_t cell = stack_.back();
            stack_.pop_back();
            for (const DoorStep& step : kDoorSteps) {
                if ((plan.edges.ofCell(cell) & step.bit) == 0) continue;
                const std::int32_t other = cell + step.x + step.y * grid_.width;
                if (height_[other] < 0.0 || plan.room[other] >= 0) continue;
                plan.room[other] = plan.rooms;
                stack_.push_back(other);
            }
        }
        ++plan.rooms;
    }
    plan.beside.clear();
    for (const Passage& door : plan.doors) plan.beside.push_back(roomsBeside(door, plan));
    findExitRooms(plan);
}

// The rooms of the cells nearest to the middle of a door, on either side.
std::array<std::int32_t, 2> DoorSearch::roomsBeside(const Passage& door, const DoorPlan& plan) const {
    const double reach = kBesideReach * grid_.cell + 0.5 * door.width();
    const Vec2 middle = door.middle(), far{reach, reach};
    const Cell low = grid_.nearestCell(middle - far), high = grid_.nearestCell(middle + far);
    std::array<std::int32_t, 2> rooms{-1, -1};
    std::array<double, 2> least{kInfiniteCost, kInfiniteCost};
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Vec2 p = grid_.centre({x, y});
            const std::int32_t room = plan.room[grid_.index({x, y})];
            if (room < 0 || awayFrom(door, p) > kBesideReach * grid_.cell) continue;
            const std::size_t side = door.onLeft(p) ? 1 : 0;
            const double away = distance(p, middle);
            if (!(away < least[side])) continue;
            least[side] = away;
            rooms[side] = room;
        }
    return rooms;
}

void DoorSearch::findExitRooms(DoorPlan& plan) const {
    plan.exitRooms.resize(exitCells_.size());
    for (std::size_t e = 0; e < exitCells_.size(); ++e) {
        std::vector<std::int32_t>& rooms = plan.exitRooms[e];
        rooms.clear();
        for (const std::int32_t cell : exitCells_[e]) {
            const auto at = std::lower_bound(rooms.begin(), rooms.end(), plan.room[cell]);
            if (at == rooms.end() || *at != plan.room[cell]) rooms.insert(at, plan.room[cell]);
        }
    }
}

// True where nobody waits between a door and an exit of the room behind it, or where there is no other exit:
// then the exit's flow is that of the door as well.
bool DoorSearch::isOfExit(const Passage& door, std::int32_t room, const DoorPlan& plan) const {
    for (std::size_t e = 0; e < exitCells_.size(); ++e) {
        if (!std::binary_search(plan.exitRooms[e].begin(), plan.exitRooms[e].end(), room)) continue;
        if (exitCells_.size() == 1) return true;
        for (const std::int32_t cell : exitCells_[e])
            if (awayFrom(door, grid_.centre(grid_.at(cell))) < kDoorReach) return true;
    }
    return false;
}

// Leaves out doors at which nobody has a choice; true where there were any. Such a door parts nothing, or
// leads only to an exit; with `deadEnds` also the only doors of rooms are left out.
bool DoorSearch::drop(DoorPlan& plan, bool deadEnds) {
    std::vector<std::int32_t> doorsOf(plan.rooms, 0);
    for (const auto& [right, left] : plan.beside)
        for (const std::int32_t room : {right, left})
            if (room >= 0) ++doorsOf[room];
    const std::size_t before = plan.doors.size();
    std::size_t kept = 0;
    for (std::size_t d = 0; d < before; ++d) {
        const auto [right, left] = plan.beside[d];
        const auto needless = [&](std::int32_t room) {
            return doorsOf[room] == 1 && (deadEnds || isOfExit(plan.doors[d], room, plan));
        };
        if (right < 0 || left < 0 || right == left || needless(right) || needless(left)) continue;
        plan.doors[kept++] = plan.doors[d];
    }
    plan.doors.resize(kept);
    return kept < before;
}

void DoorSearch::find(const Environment& environment, const StaticGround& ground, const UnitCost& unitCost,
                      std::span<const Polygon> exits, DoorPlan& plan) {
    plan.doors.clear();
    findHeights(ground, unitCost, exits);
    plan.edges.open(unitCost);
    flood(environment, plan);
    bool deadEnds = false;
    for (;;) {
        closeDoors(unitCost, plan);
        labelRooms(plan);
        if (plan.doors.empty()) break;
        if (drop(plan, deadEnds)) continue;
        if (plan.doors.size() <= kMostDoors) break;
        // There are more doors than people can choose among, as in a wood.
        if (deadEnds) plan.doors.clear();
        deadEnds = true;
    }
}

}  // namespace muster
