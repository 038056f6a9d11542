#include "engine/systems/orders/flow_marches.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/state/ground_class.h"
#include "engine/state/held_ground.h"
#include "engine/state/shared_places.h"
#include "engine/systems/orders/order_ways.h"

namespace muster {
namespace {

constexpr double kMostOff = 0.25;  // Share of places that may be elsewhere than the mesh wants them.

Vec2 meanOf(std::span<const Vec2> points) {
    Vec2 sum;
    for (const Vec2 p : points) sum += p;
    return sum / std::max(1.0, static_cast<double>(points.size()));
}

double spacingOf(const Group& group) {
    return std::max(group.def.formation.spacing, 1e-3);
}

/// The rotation at a share of the turn from one to another, the shorter way.
Rotation turnedTo(const Rotation& from, const Rotation& to, double share) {
    const double angle = share * angleBetween({from.c, from.s}, {to.c, to.s});
    const double c = cosine(angle), s = sine(angle);
    const Rotation out{from.c * c - from.s * s, from.s * c + from.c * s};
    const double size = std::sqrt(out.c * out.c + out.s * out.s);
    return {out.c / size, out.s / size};
}

/// From the begin of a way to its first point that is so far from it.
template <class Point>
Vec2 endOfWay(Point begin, Point end, double reach) {
    Point at = begin + 1;
    while (at + 1 != end && distance(*at, *begin) < reach) ++at;
    return *at - *begin;
}

}  // namespace

// Each place begins where the one is that goes to it with the least crossing, and those who held that go with
// it: who is ahead on the way or to the left of it stays so. Where weights or demands differ places stay
// whose they are.
void FlowMarches::exchange(WorldState& state, Group& group, double reach) {
    MarchFlow& flow = group.flow;
    Characters& c = state.characters;
    const std::vector<Vec2>& now = group.places.positions();
    flow.starts.assign(now.begin(), now.end());
    if (hasWeights(state, group)) return;
    const std::span<const std::uint8_t> classes = group.placeClass.size() == now.size()
                                                      ? std::span<const std::uint8_t>(group.placeClass)
                                                      : std::span<const std::uint8_t>();
    const Vec2 first = normalized(endOfWay(flow.way.begin(), flow.way.end(), reach), {1, 0});
    const Vec2 last = normalized(-endOfWay(flow.way.rbegin(), flow.way.rend(), reach), {1, 0});
    const Vec2 between = normalized(first + last, perpendicular(last));
    const Rotation turn{dot(last, between), cross(last, between)};
    targets_ = flow.ends;
    for (Vec2& p : targets_)
        if (flow.way.size() > 2) p = turn.apply(p);
    const auto to = pairing_.pair(now, targets_, classes, classes);
    places_.assign(to.begin(), to.end());
    for (std::size_t k = 0; k < now.size(); ++k) flow.starts[places_[k]] = now[k];
    for (const std::int32_t i : group.members) {
        const std::int32_t place = c.place[i];
        if (place < 0 || std::cmp_greater_equal(place, places_.size())) continue;
        c.place[i] = places_[place];
        c.wait[i].place = -1;
        c.wait[i].cost = 0.0f;
    }
    for (std::int32_t& place : group.lastAssignment)
        if (place >= 0 && std::cmp_less(place, places_.size())) place = places_[place];
    group.places.lead(flow.starts, state.parameters.stepTime);
}

// Where other groups stand, or will stand when their marches are over. A group that is about to go elsewhere
// takes nothing.
void FlowMarches::findTaken(const WorldState& state, const Group& group) {
    taken_.clear();
    for (const Group& other : state.groups) {
        if (other.id == group.id || other.members.empty()) continue;
        if (!other.orders.orders.empty() && !other.orders.begun) continue;
        if (other.flow.leads())
            taken_.insert(taken_.end(), other.flow.ends.begin(), other.flow.ends.end());
        else if (other.settling.rests())
            taken_.insert(taken_.end(), other.places.positions().begin(), other.places.positions().end());
    }
}

// Lays the ends out on the present ground. Returns how the group's places are led.
PlaceDef FlowMarches::layOut(WorldState& state, Group& group, EndDef def) {
    MarchFlow& flow = group.flow;
    const PlaceDef places = placeDefOf(state, group);
    const FreeSpace space(places, state.routesOf(group), group.region, nearest_);
    def.spacing = std::max(spacingOf(group), places.apart());
    endPlaces_.find(def, space, places.apart(), flow.ends, flow.to);
    flow.version = group.formationVersion;
    flow.ground = state.groundEdits;
    return places;
}

bool FlowMarches::findEnds(WorldState& state, Group& group, const Pose& end) {
    MarchFlow& flow = group.flow;
    flow.end();
    group.mesh.restPlaces(flow.offsets);
    if (group.places.positions().size() != flow.offsets.size()) return false;
    // In a formation that is closer than its bodies they take as much more room as they need.
    const Vec2 middle = meanOf(flow.offsets);
    const double apart = placeDefOf(state, group).apart(), room = std::max(1.0, apart / spacingOf(group));
    EndDef ends;
    ends.reach = 0.0;
    for (Vec2& offset : flow.offsets) {
        if (room > 1.0) offset = middle + (offset - middle) * room;
        ends.reach = std::max(ends.reach, length(offset));
    }
    findTaken(state, group);
    ends.offsets = flow.offsets;
    ends.pose = end;
    ends.taken = taken_;
    ends.from = meanOf(group.places.positions());
    flow.radius = lineRadius(layOut(state, group, ends));
    flow.spacing = room * spacingOf(group);
    flow.from = group.mesh.pose();
    flow.q = flow.speed = flow.rate = 0.0;
    flow.spent = 0;
    return true;
}

void FlowMarches::stand(WorldState& state, Group& group) {
    MarchFlow& flow = group.flow;
    if (!findEnds(state, group, group.mesh.pose())) return;
    flow.starts = flow.ends;
    flow.way.clear();
    flow.standAtEnds();
    group.mesh.setPose(flow.to);
}

void FlowMarches::settle(WorldState& state, Group& group) {
    if (!group.settling.rests() || group.flow.leads()) return;
    const std::vector<Vec2>& asked = group.places.targetsWithinReach();
    const std::vector<Vec2>& reached = group.places.reachableTargets();
    const auto n = static_cast<double>(asked.size());
    double off = 0.0;
    for (std::size_t k = 0; k < asked.size(); ++k) off += asked[k] == reached[k] ? 0.0 : 1.0;
    if (off <= kMostOff * n) return;
    MarchFlow& flow = group.flow;
    const Vec2 middle = meanOf(asked);
    targets_.clear();
    double reach = 0.0;
    for (const Vec2 p : asked) {
        targets_.push_back(p - middle);
        reach = std::max(reach, distance(p, middle));
    }
    EndDef ends;
    ends.offsets = targets_;
    ends.reach = reach;
    ends.pose.position = middle;
    ends.moves = false;
    layOut(state, group, ends);
    flow.standAtEnds();
    group.orders.march.last = group.mesh.pose();
}

void FlowMarches::start(WorldState& state, Group& group, const Pose& end, std::span<const Vec2> way,
                        bool drawn) {
    MarchFlow& flow = group.flow;
    const Vec2 moves = meanVelocity(group);
    if (!findEnds(state, group, end)) return;
    flow.drawn = drawn;
    flow.way.assign(way.begin(), way.end());
    const Vec2 middle = meanOf(group.places.positions());
    if (flow.way.size() < 2) flow.way = {middle, meanOf(flow.ends)};
    flow.way.front() = middle;
    flow.way.back() = flow.to.position;
    exchange(state, group, extentOf(group).reach);
    listHeld(state, group, flow.held);
    // Who is on the move goes on.
    flow.speed = std::max(0.0, dot(moves, normalized(flow.way[1] - flow.way[0])));
    flow.places = flow.starts;
    flow.phase = FlowPhase::Planning;
    flow.stream.start(flow.def());
}

bool FlowMarches::advance(WorldState& state, const WayGround& ground, Group& group, const MarchDef& def) {
    MarchFlow& flow = group.flow;
    const auto room = [&](Vec2 p) { return clearanceBeside(flow.held, p, ground.clearanceAt(p)); };
    // After a restore the plan is made again up to where it was.
    if (flow.stream.places() == 0 && flow.moves()) {
        flow.stream.start(flow.def());
        if (flow.spent > 0) flow.stream.advance(room, flow.spent);
    }
    if (flow.phase == FlowPhase::Planning && budget_ > 0) {
        const StreamStatus status = flow.stream.advance(room, budget_);
        budget_ -= flow.stream.operations() - flow.spent;
        flow.spent = flow.stream.operations();
        if (status == StreamStatus::Blocked) {
            flow.end();
            return false;
        }
        if (status != StreamStatus::Planning) flow.phase = FlowPhase::Flowing;
    }
    if (flow.phase == FlowPhase::Flowing) move(state, group, def);
    return true;
}

void FlowMarches::move(WorldState& state, Group& group, const MarchDef& def) {
    MarchFlow& flow = group.flow;
    const double dt = state.parameters.stepTime;
    const Grid& grid = state.environment.grid();
    const RasterView ground = state.environment.travelSpeed();
    double left = 0.0;
    for (std::size_t i = 0; i < flow.places.size(); ++i)
        left = std::max(left, distance(flow.places[i], flow.ends[i]));
    const double stops = std::sqrt(2.0 * def.acceleration * left);
    flow.speed = std::min({def.speed * def.pace, flow.speed + def.acceleration * dt, std::max(stops, 0.2)});
    speeds_.resize(flow.places.size());
    for (std::size_t i = 0; i < speeds_.size(); ++i)
        speeds_[i] = std::max(1e-3, flow.speed * ground[grid.index(grid.nearestCell(flow.places[i]))]);
    if (flow.speed > 1e-4) flow.q = flow.stream.best().next(flow.q, dt, speeds_, flow.places, flow.rate);
    Pose pose;
    pose.rotation = turnedTo(flow.from.rotation, flow.to.rotation, flow.q);
    pose.position = meanOf(flow.places) - pose.rotation.apply(meanOf(flow.offsets));
    if (flow.q >= 1.0) {
        pose = flow.to;
        flow.phase = FlowPhase::Standing;
        flow.speed = 0.0;
    }
    group.mesh.setPose(pose);
}

}  // namespace muster
