#include "engine/systems/orders/flow_marches.h"

#include <algorithm>
#include <cmath>

#include "base/bounds.h"
#include "base/maths.h"
#include "engine/orders/turning.h"
#include "engine/state/ground_class.h"
#include "engine/state/held_ground.h"
#include "engine/state/shared_places.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/orders/order_ways.h"

namespace muster {
namespace {

constexpr double kMostOffShare = 0.25;  // Share of places off the mesh above which they are laid out again.
// Steps between two looks whether other groups stand where a mesh rests.
constexpr std::uint32_t kLookSteps = 30;
// Distance to a wall below which a place counts as built on [radii of a place].
constexpr double kBuiltOnClearance = 0.5;
constexpr double kSameHeading = 0.99;  // Cosine of the angle up to which headings count as equal.
constexpr double kFirstShare = 0.02;   // Share of a march after which its first direction is read.
// Time that a member stands beside its place before the place comes to it [s].
constexpr double kBesideTime = 2.0;
// Gain towards an unreachable target that a walk must bring, as a share of its length.
constexpr double kGainShare = 0.25;

double spacingOf(const Group& group) {
    return std::max(group.def.formation.spacing, 1e-3);
}

double reachOf(std::span<const Vec2> offsets) {
    double reach = 0.0;
    for (const Vec2 offset : offsets) reach = std::max(reach, length(offset));
    return reach;
}

/// Lists the places of other groups for which `counts` is true, or their ends where such a group marches.
template <class Counts>
void listEnds(const WorldState& state, const Group& group, std::vector<Vec2>& ends, const Counts& counts) {
    ends.clear();
    for (const Group& other : state.groups) {
        if (other.id == group.id || other.members.empty() || !counts(other)) continue;
        const std::vector<Vec2>& targets = other.places.reachableTargets();
        if (other.flow.leads())
            other.flow.select(other.flow.ends, ends);
        else
            ends.insert(ends.end(), targets.begin(), targets.end());
    }
}

/// The mean of the places of the group.
Vec2 middleOf(const MarchFlow& flow) {
    Vec2 sum;
    for (const std::int32_t place : flow.kept) sum += flow.places[place];
    return sum / static_cast<double>(flow.kept.size());
}

/// The vector from the begin of a route to its first point at distance `reach` or more.
template <class Point>
Vec2 endOfWay(Point begin, Point end, double reach) {
    Point at = begin + 1;
    while (at + 1 != end && distance(*at, *begin) < reach) ++at;
    return *at - *begin;
}

}  // namespace

// The free space of a group's places, for which it refreshes the routes: their stages come later in the step.
FreeSpace FlowMarches::spaceOf(WorldState& state, const Group& group, const PlaceDef& places) {
    const RouteGraph& routes = state.refreshRoutes(group.groundClass);
    return {places, routes, mainRegion(state, group, regions_), nearest_};
}

// Reads where places are now; a place on which something was built starts at its holder's position.
void FlowMarches::findStarts(WorldState& state, const Group& group) {
    const Characters& c = state.characters;
    const PlaceDef places = placeDefOf(state, group);
    const FreeSpace space = spaceOf(state, group, places);
    starts_ = group.places.positions();
    const auto isBuiltOn = [&](Vec2 p) {
        return !state.environment.clearStaticLine(p, p, kBuiltOnClearance * places.radius);
    };
    for (const std::int32_t i : group.members) {
        const std::int32_t place = c.place[i];
        if (place < 0 || std::cmp_greater_equal(place, starts_.size()) || !isBuiltOn(starts_[place]))
            continue;
        starts_[place] = space.nearest(c.position[i]);
    }
}

// Pairs present positions of places with their ends so that routes cross least, and renumbers places and
// their holders accordingly: an agent ahead on the route or to the left of it stays so. Where weights or
// demands differ, places keep their numbers.
void FlowMarches::exchange(WorldState& state, Group& group, double reach) {
    MarchFlow& flow = group.flow;
    Characters& c = state.characters;
    findStarts(state, group);
    const std::vector<Vec2>& now = starts_;
    flow.starts = now;
    if (hasWeights(state, group)) return;
    const std::span<const std::uint8_t> classes = group.placeClass.size() == now.size()
                                                      ? std::span<const std::uint8_t>(group.placeClass)
                                                      : std::span<const std::uint8_t>();
    group.renumbered = true;
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
    }
    for (std::int32_t& place : group.lastAssignment)
        if (place >= 0 && std::cmp_less(place, places_.size())) place = places_[place];
    group.places.lead(flow.starts, state.parameters.stepTime);
}

// Lists where other groups stand, or will stand when their marches are over. A group that is about to go
// elsewhere takes no ground.
void FlowMarches::findTaken(const WorldState& state, const Group& group) {
    listEnds(state, group, taken_, [](const Group& other) {
        const OrderQueue& queue = other.orders;
        const bool searches = queue.march.phase == MarchPhase::Idle ||
                              queue.march.phase == MarchPhase::Search;
        const bool goes = !queue.orders.empty() && (!queue.begun || searches);
        return !goes && (other.flow.leads() || other.settling.rests());
    });
}

// Lays ends out on the present ground. Returns the definition by which the group's places are led.
PlaceDef FlowMarches::layOut(WorldState& state, Group& group, EndDef def, std::vector<Vec2>& ends, Pose& to) {
    const PlaceDef places = placeDefOf(state, group);
    const FreeSpace space = spaceOf(state, group, places);
    def.spacing = std::max(spacingOf(group), places.apart());
    endPlaces_.find(def, space, places.apart(), ends, to);
    return places;
}

// Writes the offsets of places in the formation, and returns the factor by which they are enlarged: above 1
// in a formation that is closer than its bodies.
double FlowMarches::takeOffsets(const WorldState& state, const Group& group, std::vector<Vec2>& offsets) {
    group.mesh.restPlaces(offsets);
    const double apart = placeDefOf(state, group).apart();
    double least = apart;
    if (spacingOf(group) < apart) {
        // Listed points may be farther from each other than the spacing says.
        cells_.sort(offsets, apart);
        cells_.forPairs(apart, [&](std::int32_t i, std::int32_t j) {
            least = std::min(least, distance(offsets[i], offsets[j]));
        });
    }
    const double room = apart / std::max(least, std::min(apart, spacingOf(group)));
    const Vec2 middle = meanOf(offsets);
    if (room > 1.0)
        for (Vec2& offset : offsets) offset = middle + (offset - middle) * room;
    return room;
}

// The ends of the group's formation at a pose, beside other groups.
EndDef FlowMarches::endsAt(const WorldState& state, const Group& group, const Pose& end,
                           std::span<const Vec2> offsets) {
    findTaken(state, group);
    EndDef ends;
    ends.offsets = offsets;
    ends.reach = reachOf(offsets);
    ends.pose = end;
    ends.taken = taken_;
    ends.from = meanOf(group.places.positions());
    return ends;
}

bool FlowMarches::pays(WorldState& state, Group& group, Vec2 at, std::optional<double> facing) {
    takeOffsets(state, group, offsets_);
    if (group.places.positions().size() != offsets_.size()) return true;
    // On changed ground the former ends may lie in walls.
    if (group.flow.leads() && group.flow.ground != state.groundEdits) return true;
    Pose to, end = group.flow.leads() ? group.flow.to : group.mesh.pose();
    end.position = at;
    if (facing) {
        const Rotation asked{cosine(*facing), sine(*facing)};
        if (asked.c * end.rotation.c + asked.s * end.rotation.s < kSameHeading) return true;
    }
    layOut(state, group, endsAt(state, group, end, offsets_), targets_, to);
    const Vec2 target = group.orders.orders.front().order.target;
    const Vec2 now = meanOf(group.flow.leads() ? group.flow.ends : group.places.positions());
    const Vec2 then = meanOf(targets_);
    return distance(now, target) - distance(then, target) > kGainShare * distance(now, then);
}

bool FlowMarches::findEnds(WorldState& state, Group& group, const Pose& end) {
    MarchFlow& flow = group.flow;
    flow.end();
    const double room = takeOffsets(state, group, flow.offsets);
    if (group.places.positions().size() != flow.offsets.size()) return false;
    const EndDef ends = endsAt(state, group, end, flow.offsets);
    const PlaceDef places = layOut(state, group, ends, flow.ends, flow.to);
    flow.radius = lineRadius(places);
    flow.closest = places.apart();
    flow.version = group.formationVersion;
    flow.ground = state.groundEdits;
    flow.spacing = std::max(room * spacingOf(group), flow.closest);
    flow.from = group.mesh.pose();
    flow.poses.clear();
    flow.kept.clear();
    group.avoidance = {};
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
    group.places.stand(flow.ends);
}

// Lists the places of groups for which this group makes room: a group that holds its ground comes before
// others, then a group that was laid out beside others, then the older group.
void FlowMarches::findStanding(const WorldState& state, const Group& group) {
    listEnds(state, group, taken_, [&](const Group& other) {
        if (!other.settling.rests()) return false;
        return holdsGround(other) != holdsGround(group)
                   ? holdsGround(other)
                   : other.flow.leads() || other.id.value < group.id.value;
    });
}

// True where many of the points that the mesh asks for cannot be reached.
bool FlowMarches::isInWalls(const Group& group) {
    const std::vector<Vec2>& asked = group.places.targetsWithinReach();
    const std::vector<Vec2>& reached = group.places.reachableTargets();
    double off = 0.0;
    for (std::size_t k = 0; k < asked.size(); ++k) off += asked[k] == reached[k] ? 0.0 : 1.0;
    return off > kMostOffShare * static_cast<double>(asked.size());
}

// True where the mesh rests on places of the groups that findStanding() lists.
bool FlowMarches::isOnOthers(const WorldState& state, const Group& group) {
    const std::vector<Vec2>& asked = group.places.targetsWithinReach();
    if (asked.empty() || (group.settling.restSteps - Settling::kRestSteps) % kLookSteps != 0) return false;
    findStanding(state, group);
    double diameter = 0.0;
    for (const Group& other : state.groups) diameter = std::max(diameter, 2.0 * meanRadius(state, other));
    together_.assign(asked.begin(), asked.end());
    together_.insert(together_.end(), taken_.begin(), taken_.end());
    const auto own = static_cast<std::int32_t>(asked.size());
    bool meets = false;
    cells_.sort(together_, diameter);
    cells_.forPairs(diameter,
                    [&](std::int32_t i, std::int32_t j) { meets = meets || (i < own) != (j < own); });
    return meets;
}

// After a stop, the place of a member that stands beside it comes to the member, so that nobody has to walk.
void FlowMarches::comeToStanding(const WorldState& state, Group& group) {
    if (hasWeights(state, group)) return;
    const Characters& c = state.characters;
    MarchFlow& flow = group.flow;
    for (const std::int32_t i : group.members) {
        const std::int32_t place = c.place[i];
        const WalkProgress& walk = c.walk[i];
        const bool stands = state.stepCount - std::max(walk.movedAt, walk.since) >=
                            stepsIn(state, kBesideTime);
        if (!stands || walk.within || place < 0 || std::cmp_greater_equal(place, flow.ends.size())) continue;
        flow.ends[place] = flow.places[place] = c.position[i];
    }
}

void FlowMarches::settle(WorldState& state, Group& group) {
    if (group.flow.isStop()) comeToStanding(state, group);
    if (!group.settling.rests() || group.flow.leads()) return;
    const bool onOthers = state.groups.size() > 1 && isOnOthers(state, group);
    if (!onOthers && !isInWalls(group)) return;
    const std::vector<Vec2>& asked = group.places.targetsWithinReach();
    MarchFlow& flow = group.flow;
    flow.kept.clear();
    const Vec2 middle = meanOf(asked);
    flow.offsets.clear();
    for (const Vec2 p : asked) flow.offsets.push_back(p - middle);
    EndDef ends;
    ends.offsets = flow.offsets;
    ends.reach = reachOf(flow.offsets);
    ends.pose.position = middle;
    ends.moves = onOthers;
    if (onOthers) ends.taken = taken_;
    for (const std::int32_t i : group.members)
        ends.from += state.characters.position[i] / static_cast<double>(group.members.size());
    layOut(state, group, ends, flow.ends, flow.to);
    flow.version = group.formationVersion;
    flow.ground = state.groundEdits;
    flow.standAtEnds();
    group.orders.march.last = group.mesh.pose();
}

void FlowMarches::start(WorldState& state, Group& group, const Pose& end, std::span<const Vec2> way,
                        bool drawn) {
    MarchFlow& flow = group.flow;
    const Vec2 moves = meanVelocity(group);
    way_.assign(way.begin(), way.end());
    if (!findEnds(state, group, end)) return;
    group.orders.march.reversed = false;
    flow.drawn = drawn;
    flow.way = way_;
    const Vec2 middle = meanOf(group.places.positions());
    if (flow.way.size() < 2) flow.way = {middle, meanOf(flow.ends)};
    flow.way.front() = middle;
    flow.way.back() = flow.to.position;
    exchange(state, group, extentOf(group).reach);
    plan(state, group, moves);
}

void FlowMarches::startPiece(WorldState& state, Group& group, const PieceDef& piece, bool drawn) {
    MarchFlow& flow = group.flow;
    const Vec2 moves = meanVelocity(group);
    bool& reversed = group.orders.march.reversed;
    listPoses(piece, reversed, poses_);
    if (!findEnds(state, group, poses_.back())) return;
    flow.poses = poses_;
    for (std::size_t k = flow.poses.size(); k-- > 0 && flow.poses[k].position == poses_.back().position;)
        flow.poses[k].position = flow.to.position;
    flow.drawn = drawn;
    flow.way.assign(piece.way.begin(), piece.way.end());
    if (flow.way.size() < 2) flow.way.assign(2, flow.to.position);
    flow.starts = group.places.positions();
    plan(state, group, moves);
}

// Begins the plan of a march; members that are moving keep their speed.
void FlowMarches::plan(WorldState& state, Group& group, Vec2 moves) {
    MarchFlow& flow = group.flow;
    listHeld(state, group, flow.held);
    flow.speed = length(moves);
    flow.places = flow.starts;
    flow.phase = FlowPhase::Planning;
    flow.plans.start(flow.def(), flow.held, versionOf(state.environment), state.environment.grid());
}

// Keeps the share of the members' speed that points along the begin of the plan.
void FlowMarches::keepSpeed(const WorldState& state, Group& group) {
    MarchFlow& flow = group.flow;
    Vec2 moves;
    for (const std::int32_t i : group.members) moves += state.characters.velocity[i];
    targets_ = flow.starts;
    flow.plans.best().at(kFirstShare, targets_);
    const Vec2 along = normalized(meanOf(targets_) - meanOf(flow.starts));
    flow.speed *= std::max(0.0, dot(normalized(moves), along));
}

// True where no edit of this step concerns ground that the plan of a march has read, nor opens a shorter
// route. Edits before this step are no longer known.
bool FlowMarches::stays(const WorldState& state, const Group& group) const {
    const MarchFlow& flow = group.flow;
    if (flow.phase != FlowPhase::Flowing || flow.ground != state.editsBefore || state.editedPatches)
        return false;
    const Grid& cells = state.environment.grid();
    const Vec2 from = group.mesh.pose().position, to = flow.way.back();
    const double left = flow.way.size() > 2 ? (1.0 - flow.q) * pathLength(flow.way) : 0.0;
    return std::none_of(state.editedAreas.begin(), state.editedAreas.end(), [&](const CellRect& area) {
        const Box box{cells.centre(area.low), cells.centre(area.high)};
        return flow.asked.meets(area) || distance(from, box.clamp(from)) + distance(box.clamp(to), to) < left;
    });
}

bool FlowMarches::goesOn(const WorldState& state, Group& group) const {
    MarchFlow& flow = group.flow;
    if (!stays(state, group)) return false;
    flow.ground = state.groundEdits;
    if (flow.plans.begun()) flow.plans.stay(versionOf(state.environment));
    return true;
}

bool FlowMarches::advance(WorldState& state, const WayGround& ways, Group& group, const MarchDef& def,
                          Vec2 offCourse) {
    MarchFlow& flow = group.flow;
    // Up to the clearance that the ground knows exactly, so that an edit elsewhere leaves the plan as it is.
    const Environment& ground = state.environment;
    const auto clearance = [&](Vec2 p) {
        const std::int32_t cell = ground.grid().index(ground.grid().nearestCell(p));
        return held_.clearanceAt(p, ground.staticClearance()[cell]);
    };
    const auto speed = [&](Vec2 p) { return 1.0 / ways.slownessAt(p, 0.0); };
    const StreamGround room = ways.uneven() ? StreamGround(clearance, speed) : StreamGround(clearance);
    if (flow.phase == FlowPhase::Planning || !flow.plans.begun())
        held_.reset(flow.held, Environment::kClearanceLimit);
    // After a restore the plan is made again up to the point that it had reached.
    if (!flow.plans.begun() && flow.moves())
        flow.plans.resume(flow.def(), flow.held, versionOf(ground), ground.grid(), room, flow.spent);
    if (flow.phase == FlowPhase::Planning && budget_ > 0) {
        const StreamStatus status = flow.plans.advance(room, budget_);
        budget_ -= flow.plans.operations() - flow.spent;
        flow.spent = flow.plans.operations();
        if (status == StreamStatus::Blocked && flow.poses.empty()) {
            flow.end();
            return false;
        }
        if (status == StreamStatus::Blocked) {
            Pose end = flow.to;
            if (group.orders.march.reversed) end.rotation = {-end.rotation.c, -end.rotation.s};
            way_ = flow.way;
            start(state, group, end, way_, flow.drawn);
            return group.flow.leads();
        }
        if (status != StreamStatus::Planning) {
            flow.phase = FlowPhase::Flowing;
            flow.asked = flow.plans.asked();
            keepSpeed(state, group);
        }
    }
    if (flow.phase == FlowPhase::Flowing) move(state, group, def, offCourse);
    return true;
}

void FlowMarches::move(WorldState& state, Group& group, const MarchDef& def, Vec2 offCourse) {
    MarchFlow& flow = group.flow;
    const double dt = state.parameters.stepTime;
    const Grid& grid = state.environment.grid();
    const RasterView ground = state.environment.travelSpeed();
    double left = 0.0;
    for (std::size_t i = 0; i < flow.places.size(); ++i)
        left = std::max(left, distance(flow.places[i], flow.ends[i]));
    const double stops = std::sqrt(2.0 * def.brakes * left);
    flow.speed = std::min({def.speed * def.pace, flow.speed + def.acceleration * dt, std::max(stops, 0.2)});
    speeds_.resize(flow.places.size());
    for (std::size_t i = 0; i < speeds_.size(); ++i) {
        double travelSpeed = ground[grid.index(grid.nearestCell(flow.places[i]))];
        if (travelSpeed != 1.0 && i < group.places.velocities().size()) {
            const GroundSample here = state.environment.ground(flow.places[i]);
            if (here.isStairs()) travelSpeed = here.speedAlong(normalized(group.places.velocities()[i]));
        }
        speeds_[i] = std::max(1e-3, flow.speed * travelSpeed);
    }
    for (Vec2& p : flow.places) p -= group.avoidance.offCourse;
    if (flow.speed > 1e-4) flow.q = flow.plans.best().next(flow.q, dt, speeds_, flow.places, flow.rate);
    Pose pose = flow.poses.empty() ? between(flow.from, flow.to, flow.q) : flow.plans.best().pieceAt(flow.q);
    group.avoidance.offCourse = flow.q < 1.0 ? offCourse : Vec2{};
    for (Vec2& p : flow.places) p += group.avoidance.offCourse;
    if (!flow.poses.empty())
        pose.position += group.avoidance.offCourse;
    else
        pose.position = meanOf(flow.places) - pose.rotation.apply(meanOf(flow.offsets));
    if (!flow.kept.empty()) pose.position = middleOf(flow);
    if (flow.q >= 1.0) {
        pose = flow.to;
        flow.phase = FlowPhase::Standing;
        flow.speed = 0.0;
    }
    group.mesh.setPose(pose);
}

}  // namespace muster
