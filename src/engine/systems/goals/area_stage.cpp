#include "engine/systems/goals/area_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "engine/geometry/polygon.h"
#include "engine/state/bare_groups.h"
#include "engine/state/draw_person.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/commands/join_one.h"

namespace muster {
namespace {

constexpr double kExitReach = 1.0;        // Cost to its exit up to which an agent may be in the exit [m].
constexpr double kEntryDistance = 1.02;   // Least distance of a person who comes in to others [sum of radii].
constexpr std::int32_t kEntryTries = 24;  // Points at which room for a person is looked for.
constexpr double kLatestEntry = 1e10;     // Latest time at which a source lets the next person in [s].

// True for a character of a group that leaves by exits, once it has set out.
bool isLeaving(const WorldState& state, std::int32_t i) {
    const Group& group = state.groups[state.characters.group[i]];
    if (!state.characters.hasSetOut(i, state.stepCount)) return false;
    const Gathering* const gathering = state.continuum.find(group.id);
    return gathering != nullptr && gathering->kind == OrderKind::Leave && gathering->active &&
           !group.orders.held;
}

}  // namespace

// Marks the characters whose centre is in the exit that they have chosen.
void AreaStage::findLeaving(WorldState& state) {
    const Characters& c = state.characters;
    leaves_.assign(c.size(), 0);
    for (Area& area : state.areas) {
        if (area.def.kind != AreaKind::Exit) continue;
        const bool inOrder = area.def.rate > 0.0 || !area.def.queue.empty();
        if (inOrder && isOpen(area.def, state.time())) passInOrder(state, area);
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.goal[i] == 0 || c.cost[i] > kExitReach) continue;
        const Area* const area = state.findArea(AreaId{c.goal[i]});
        const bool atOnce = area != nullptr && area->def.kind == AreaKind::Exit &&
                            isOpen(area->def, state.time()) && area->def.rate == 0.0 &&
                            area->def.queue.empty();
        if (atOnce && isLeaving(state, static_cast<std::int32_t>(i)) &&
            containsPoint(area->def.polygon, c.position[i]))
            leaves_[i] = 1;
    }
}

// An exit with a rate or a line lets the people in it through in the order in which they came.
void AreaStage::passInOrder(WorldState& state, Area& area) {
    const Characters& c = state.characters;
    std::vector<std::uint32_t>& line = area.exit.line;
    const auto wants = [&](std::int32_t i) {
        return i >= 0 && c.goal[i] == area.id.value && isLeaving(state, i);
    };
    const auto isIn = [&](std::int32_t i) { return containsPoint(area.def.polygon, c.position[i]); };
    std::erase_if(line, [&](std::uint32_t id) { return !wants(c.indexOf(id)); });
    if (area.def.queue.empty())
        for (std::size_t i = 0; i < c.size(); ++i)
            if (c.goal[i] == area.id.value && c.cost[i] <= kExitReach &&
                wants(static_cast<std::int32_t>(i)) && isIn(static_cast<std::int32_t>(i)) &&
                std::find(line.begin(), line.end(), c.id[i]) == line.end())
                line.push_back(c.id[i]);
    const double rate = area.def.rate;
    if (rate > 0.0) area.exit.credit += rate * state.parameters.stepTime;
    // At an exit without a line to stand in, a person who was pushed out again lets others pass.
    const std::size_t most = area.def.queue.empty() ? line.size() : std::min<std::size_t>(1, line.size());
    for (std::size_t k = 0; k < most && (rate == 0.0 || area.exit.credit >= 1.0); ++k) {
        const std::int32_t i = c.indexOf(line[k]);
        if (!isIn(i)) continue;
        leaves_[i] = 1;
        if (rate > 0.0) area.exit.credit -= 1.0;
    }
    area.exit.credit = std::min(area.exit.credit, 1.0);
    std::erase_if(line, [&](std::uint32_t id) { return leaves_[c.indexOf(id)] != 0; });
}

// Takes the people who leave out of the world. Groups without a formation need no new one.
void AreaStage::takeOut(WorldState& state, ThreadPool& pool, std::vector<Event>& events) {
    if (std::find(leaves_.begin(), leaves_.end(), 1) == leaves_.end()) return;
    pool.wait();  // Background work reads the plans.
    Characters& c = state.characters;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (leaves_[i] == 0) continue;
        Area& area = *state.findArea(AreaId{c.goal[i]});
        Group& group = state.groups[c.group[i]];
        ++area.count.passed;
        if (area.exit.isQueued) area.exit.served += 1.0;
        --group.def.count;
        events.push_back({EventKind::Exited, c.id[i], area.id.value, c.position[i]});
        events.push_back({EventKind::Left, c.id[i], group.id.value, c.position[i]});
    }
    removeCharacters(c, leaves_);
    state.refreshMembers();
}

// Finds a free point in a source; false where there is none.
bool AreaStage::findRoom(WorldState& state, Area& area, double radius, Vec2& spot) {
    const Characters& c = state.characters;
    const Parameters::Character& usual = state.parameters.character;
    const Environment& ground = state.environment;
    if (!sorted_) {
        largest_ = radius;
        for (const Body& body : c.body) largest_ = std::max(largest_, radiusOf(usual, body));
        cells_.sort(c.position, 2.0 * kEntryDistance * std::max(largest_, usual.radius));
    }
    sorted_ = true;
    const Box box = boundsOf(area.def.polygon);
    const auto isNear = [&](std::int32_t i, Vec2 p) {
        return distance(c.position[i], p) < kEntryDistance * (radius + radiusOf(usual, c.body[i]));
    };
    // The body is larger than all so far: look for others from farther away.
    const bool beyond = radius > largest_;
    for (std::int32_t k = 0; k < kEntryTries; ++k) {
        const double x = area.source.random.uniform(box.min.x, box.max.x);
        const double y = area.source.random.uniform(box.min.y, box.max.y);
        const Vec2 p{x, y};
        if (!containsPoint(area.def.polygon, p) || !ground.def().box.grown(-radius).contains(p) ||
            ground.distanceToObstacle(p, 2.0 * radius) < radius)
            continue;
        bool taken = std::any_of(come_.begin(), come_.end(), [&](std::int32_t i) { return isNear(i, p); });
        if (beyond)
            for (std::size_t i = 0; i < c.size() && !taken; ++i)
                taken = isNear(static_cast<std::int32_t>(i), p);
        else
            taken = taken || (cells_.grid().count() > 0 &&
                              cells_.anyBeside(p, [&](std::int32_t i) { return isNear(i, p); }));
        if (taken) continue;
        spot = p;
        return true;
    }
    return false;
}

// Counts the people who are due, and lets in those for whom there is room.
void AreaStage::admit(WorldState& state, Area& area, ThreadPool& pool, std::vector<Event>& events) {
    const AreaDef& def = area.def;
    SourceFlow& source = area.source;
    Group* const group = state.findGroup(area.group);
    if (!def.open || group == nullptr) return;
    const double now = state.time();
    for (; source.entry < def.timetable.size() && def.timetable[source.entry].time <= now; ++source.entry)
        area.count.waiting += static_cast<std::uint32_t>(def.timetable[source.entry].count);
    if (def.rate > 0.0) {
        const auto draw = [&](double after) {
            source.next = std::min(kLatestEntry, after - logarithm(1.0 - source.random.uniform()) / def.rate);
        };
        // Waits have no memory: after a change of the rate the next wait is drawn afresh.
        if (source.next < 0.0 || source.rate != def.rate) draw(std::max(def.from, now));
        source.rate = def.rate;
        while (source.next <= now && source.next <= def.until && (def.most == 0 || source.sent < def.most)) {
            ++area.count.waiting;
            ++source.sent;
            draw(source.next);
        }
    }
    while (area.count.waiting > 0) {
        const auto total = static_cast<std::int64_t>(state.characters.size()) + 1;
        if (!validateTotal(total, state.parameters).ok()) return;
        const std::size_t index = group->members.size() + area.count.passed;
        const Body body = drawMember(group->def, index, state.seed, state.nextCharacter);
        Vec2 spot;
        if (!findRoom(state, area, radiusOf(state.parameters.character, body), spot)) return;
        if (come_.empty()) pool.wait();  // Background work reads the plans.
        come_.push_back(joinOne(state, *group, spot, body));
        --area.count.waiting;
        ++area.count.passed;
        const std::uint32_t id = state.characters.id.back();
        events.push_back({EventKind::Entered, id, area.id.value, spot});
        events.push_back({EventKind::Joined, id, group->id.value, spot});
    }
}

// A group that leaves the world ends with its last member, unless a source still sends it people.
void AreaStage::endGroups(WorldState& state, ThreadPool& pool, std::vector<Event>& events) {
    for (std::size_t g = state.groups.size(); g-- > 0;) {
        const Group& group = state.groups[g];
        const Gathering* const gathering = state.continuum.find(group.id);
        if (!group.members.empty() || gathering == nullptr || gathering->kind != OrderKind::Leave) continue;
        const bool fed = std::any_of(state.areas.begin(), state.areas.end(), [&](const Area& area) {
            return area.def.kind == AreaKind::Source && area.group == group.id && maySend(area);
        });
        if (fed) continue;
        const Vec2 at = group.mesh.pose().position;
        if (group.orders.begun && group.orders.orders.front().order.kind == OrderKind::Leave)
            events.push_back({EventKind::OrderDone, group.id.value, group.orders.orders.front().id, at});
        events.push_back({EventKind::GroupRemoved, group.id.value, 0, at});
        pool.wait();
        state.continuum.end(group.id);
        removeGroup(state, g);
    }
}

void AreaStage::run(WorldState& state, ThreadPool& pool, std::vector<Event>& events) {
    if (state.areas.empty()) return;
    findLeaving(state);
    takeOut(state, pool, events);
    sorted_ = false;
    come_.clear();
    for (Area& area : state.areas)
        if (area.def.kind == AreaKind::Source) admit(state, area, pool, events);
    endGroups(state, pool, events);
}

}  // namespace muster
