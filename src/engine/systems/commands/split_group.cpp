// The command that divides a group.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "engine/geometry/polygon.h"
#include "engine/state/bare_groups.h"
#include "engine/state/group_edits.h"
#include "engine/state/reform.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_queues.h"

namespace muster {
namespace {

/// Ids of the characters of each part, ascending; the first part stays.
using Parts = std::vector<std::vector<std::uint32_t>>;

/// The point by which each member is divided: its place on Vf, or its position where it has no place.
std::vector<Vec2> standingsOf(const WorldState& state, const Group& group) {
    std::vector<Vec2> places, standings;
    group.mesh.placePositions(places);
    for (const std::int32_t i : group.members) {
        const std::int32_t place = state.characters.place[i];
        standings.push_back(place >= 0 ? places[place] : state.characters.position[i]);
    }
    return standings;
}

/// Two parts; members for which `leaves(member)` is true are the second.
template <class Leaves>
Parts divide(const WorldState& state, const Group& group, const Leaves& leaves) {
    Parts parts(2);
    for (std::size_t k = 0; k < group.members.size(); ++k)
        parts[leaves(k) ? 1 : 0].push_back(state.characters.id[group.members[k]]);
    return parts;
}

/// Parts of given shares, front to back or left to right in the axes of the mesh.
Parts divideByShares(const WorldState& state, const Group& group, const SplitGroup& command) {
    const std::vector<Vec2> standings = standingsOf(state, group);
    std::vector<double> key;
    for (const Vec2 p : standings) {
        const Vec2 local = group.mesh.pose().applyInverse(p);
        key.push_back(command.abreast ? -local.y : -local.x);
    }
    std::vector<std::int32_t> order(standings.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::int32_t a, std::int32_t b) { return key[a] < key[b]; });
    const double whole = std::accumulate(command.shares.begin(), command.shares.end(), 0.0);
    const auto count = static_cast<double>(order.size());
    Parts parts;
    double sum = 0.0;
    std::size_t next = 0;
    for (const double share : command.shares) {
        sum += share;
        const auto end = static_cast<std::size_t>(std::floor(count * std::min(1.0, sum / whole) + 0.5));
        std::vector<std::uint32_t>& part = parts.emplace_back();
        for (; next < std::min(end, order.size()); ++next)
            part.push_back(state.characters.id[group.members[order[next]]]);
        std::sort(part.begin(), part.end());
    }
    return parts;
}

Result<Parts> partsOf(const WorldState& state, const Group& group, const SplitGroup& command) {
    const std::vector<Vec2> standings = standingsOf(state, group);
    switch (command.by) {
        case SplitBy::Ids: {
            const auto index = static_cast<std::uint32_t>(&group - state.groups.data());
            std::vector<std::uint32_t> ids = command.ids;
            std::sort(ids.begin(), ids.end());
            for (const std::uint32_t id : ids) {
                const std::int32_t i = state.characters.indexOf(id);
                if (i < 0 || state.characters.group[i] != index)
                    return Status(StatusCode::NotFound,
                                  "no character of the group has the id " + std::to_string(id));
            }
            return divide(state, group, [&](std::size_t k) {
                return std::binary_search(ids.begin(), ids.end(), state.characters.id[group.members[k]]);
            });
        }
        case SplitBy::Line:
            return divide(state, group, [&](std::size_t k) {
                return cross(command.points[1] - command.points[0], standings[k] - command.points[0]) > 0.0;
            });
        case SplitBy::Lasso:
            return divide(state, group,
                          [&](std::size_t k) { return containsPoint(command.points, standings[k]); });
        case SplitBy::Shares:
            break;
    }
    return divideByShares(state, group, command);
}

/// A group for a part, with the orders and the progress of the whole; it has no characters yet.
Group partOf(const WorldState& state, const Group& whole, std::size_t number) {
    Group part;
    part.def = whole.def;
    part.def.name = whole.def.name + " " + std::to_string(number + 1);
    part.def.colour.reset();
    part.def.starts.clear();
    part.def.orders.clear();
    part.plan = makePlan(state.parameters);
    part.meanLag = whole.meanLag;
    part.order = whole.order;
    part.settling = whole.settling;
    part.surveyFrom = whole.surveyFrom;
    part.surveyTo = whole.surveyTo;
    part.waysFor = whole.waysFor;
    part.goalDrift = whole.goalDrift;
    part.foreseen = whole.foreseen;
    part.controls = whole.controls;
    return part;
}

/// Each control goes to the part whose places are nearest to the vertices that it holds.
void divideControls(std::span<Group* const> parts) {
    std::vector<std::vector<Vec2>> places(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) parts[p]->mesh.placePositions(places[p]);
    const std::vector<Control> all(parts[0]->controls.controls().begin(),
                                   parts[0]->controls.controls().end());
    for (const Control& control : all) {
        std::size_t owner = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t p = 0; p < parts.size(); ++p) {
            double sum = 0.0;
            for (const ControlPoint& point : control.points) {
                double least = std::numeric_limits<double>::infinity();
                for (const Vec2 place : places[p]) least = std::min(least, distance(place, point.position));
                sum += least;
            }
            if (sum >= nearest) continue;
            nearest = sum;
            owner = p;
        }
        for (std::size_t p = 0; p < parts.size(); ++p)
            if (p != owner) parts[p]->controls.remove(control.id);
    }
}

Result<Reform> formPart(const WorldState& state, const Group& whole, const HeldPlaces& held,
                        const std::vector<std::uint32_t>& ids, PartShape shape) {
    HeldPlaces own = held;
    own.keep(ids);
    if (state.continuum.isBare(whole.id)) return Reform{};
    if (shape == PartShape::AsHeld) return asHeld(state, whole, own, ids);
    return refit(state, whole, own, resized(whole, own, ids, true), ids);
}

/// Gives a part its formation at the pose of the whole, or none where the whole has none.
void formUpAs(WorldState& state, Group& part, const Group& whole, Reform& reform) {
    if (!state.continuum.isBare(whole.id)) return applyReform(state, part, std::move(reform), whole.mesh);
    if (&part != &whole) (void)part.mesh.reset(whole.mesh.formation(), whole.mesh.pose());
    dissolveFormation(state, part);
    part.def.count = static_cast<std::int32_t>(part.members.size());
}

/// Adds the groups of all parts but the first; the whole keeps its index.
void addParts(WorldState& state, std::uint32_t whole, const Parts& parts) {
    const std::size_t marks = state.checkpoints.size();
    for (std::size_t p = 1; p < parts.size(); ++p) {
        Group part = partOf(state, state.groups[whole], p);
        part.id = GroupId{state.nextGroup++};
        state.continuum.share(state.groups[whole].id, part.id);
        const auto index = static_cast<std::uint32_t>(state.groups.size());
        for (const std::uint32_t id : parts[p]) state.characters.group[state.characters.indexOf(id)] = index;
        state.groups.push_back(std::move(part));
        for (std::size_t c = 0; c < marks; ++c)
            state.checkpointState.push_back(state.checkpointState[whole * marks + c]);
    }
    state.refreshMembers();
}

}  // namespace

Status apply(CommandContext& context, const SplitGroup& command) {
    WorldState& state = context.groups();
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    const Result<Parts> parts = partsOf(state, *group, command);
    if (!parts.ok()) return parts.status();
    for (const auto& part : *parts)
        if (part.empty()) return invalidArgument("a part of the group would have no characters");
    if (state.groups.size() + parts->size() - 1 > kMaxGroups)
        return {StatusCode::LimitExceeded,
                "the world would hold more than " + std::to_string(kMaxGroups) + " groups"};
    const auto whole = static_cast<std::uint32_t>(group - state.groups.data());
    state.groups.reserve(state.groups.size() + parts->size());
    HeldPlaces held;
    held.add(state, state.groups[whole], state.groups[whole]);
    std::vector<Reform> reforms;
    for (const auto& part : *parts) {
        Result<Reform> reform = formPart(state, state.groups[whole], held, part, command.shape);
        if (!reform.ok()) return reform.status().within("group '" + state.groups[whole].def.name + "'");
        reforms.push_back(std::move(*reform));
    }
    std::vector<Vec2> places;
    state.groups[whole].mesh.placePositions(places);
    const Vec2 middle = std::accumulate(places.begin(), places.end(), Vec2{}) /
                        std::max(1.0, static_cast<double>(places.size()));
    const std::size_t first = state.groups.size();
    addParts(state, whole, *parts);
    std::vector<Group*> formed{&state.groups[whole]};
    for (std::size_t p = 1; p < parts->size(); ++p) formed.push_back(&state.groups[first + p - 1]);
    // The whole comes last, since the places of the other parts are taken from its own.
    for (std::size_t p = parts->size(); p-- > 0;) formUpAs(state, *formed[p], *formed[0], reforms[p]);
    divideControls(formed);
    shareOrders(state, formed, middle);
    for (std::size_t p = 1; p < formed.size(); ++p)
        context.events.push_back({EventKind::GroupAdded, formed[p]->id.value, formed[0]->id.value,
                                  formed[p]->mesh.pose().position});
    return {};
}

}  // namespace muster
