#include "engine/state/world_archive.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "engine/assignment/planning/assigner.h"
#include "engine/passages/way_number.h"
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

constexpr double kFastest = 1e6;  // [m/s]
constexpr std::int32_t kMostClasses = 24;

Status wrong(const char* what) {
    return invalidArgument(std::string("found ") + what);
}

bool isPlace(Vec2 p) {
    return std::fabs(p.x) <= 10.0 * kMaxCoordinate && std::fabs(p.y) <= 10.0 * kMaxCoordinate;
}

bool arePlaces(const std::vector<Vec2>& points) {
    return std::all_of(points.begin(), points.end(), isPlace);
}

bool isVelocity(Vec2 v) {
    return std::fabs(v.x) <= kFastest && std::fabs(v.y) <= kFastest;
}

bool isUnitOrNull(Vec2 v) {
    return std::fabs(v.x) <= 1.001 && std::fabs(v.y) <= 1.001;
}

template <class Id>
bool ascending(const std::vector<Id>& ids, std::uint32_t next) {
    for (std::size_t k = 0; k < ids.size(); ++k)
        if (ids[k] == 0 || ids[k] >= next || (k > 0 && ids[k] <= ids[k - 1])) return false;
    return true;
}

Status checkGround(const Environment& environment) {
    if (!(environment.time() >= 0.0 && environment.time() <= 1e9)) return wrong("a clock out of range");
    const auto motions = static_cast<std::int32_t>(environment.def().clips.size());
    if (motions == 0) return wrong("no clip");
    for (const ClipFacts& clip : environment.def().clips)
        if (Status s = validate(clip); !s.ok()) return s;
    for (const ObstacleId id : environment.obstacleIds())
        if (Status s = validate(*environment.obstacle(id)); !s.ok()) return s;
    for (const PatchId id : environment.patchIds())
        if (Status s = validatePatch(*environment.patch(id), motions); !s.ok()) return s;
    return {};
}

Status checkArrays(const Characters& c) {
    const std::size_t n = c.size();
    for (const std::size_t size :
         {c.group.size(),     c.position.size(),   c.velocity.size(), c.heading.size(), c.place.size(),
          c.direction.size(), c.cost.size(),       c.motion.size(),   c.phase.size(),   c.motionTime.size(),
          c.patch.size(),     c.lastSingle.size(), c.walk.size(),     c.claim.size(),   c.chosen.size(),
          c.body.size(),      c.driver.size(),     c.wanted.size(),   c.goal.size(),    c.setsOutAt.size()})
        if (size != n) return wrong("arrays of different lengths");
    if (!arePlaces(c.position) || !std::all_of(c.velocity.begin(), c.velocity.end(), isVelocity) ||
        !std::all_of(c.heading.begin(), c.heading.end(), isUnitOrNull) ||
        !std::all_of(c.direction.begin(), c.direction.end(), isUnitOrNull) ||
        !std::all_of(c.wanted.begin(), c.wanted.end(), isVelocity))
        return wrong("a character with a number out of range");
    if (n > 0 && !validateBodies(c.body, n, false).ok()) return wrong("a body out of range");
    if (std::any_of(c.driver.begin(), c.driver.end(), [](Driver d) { return d > Driver::Outside; }))
        return wrong("a character that nobody moves");
    for (std::size_t i = 0; i < n; ++i)
        if (std::isnan(c.cost[i]) || !(c.motionTime[i] >= 0.0 && c.motionTime[i] <= 1e9) ||
            c.phase[i] > MotionPhase::Locked || !isPlace(c.walk[i].anchor) || !isPlace(c.walk[i].camp) ||
            c.claim[i].turn < -kOvertakingTurns || c.claim[i].turn > kOvertakingTurns)
            return wrong("a character with a number out of range");
    return {};
}

bool isPathOf(const ControlPoint& point) {
    return std::all_of(point.trajectory.begin(), point.trajectory.end(),
                       [](const Checkpoint& c) { return isPlace(c.position) && std::fabs(c.time) <= 1e9; });
}

bool isOnMesh(const MeshPoint& point, const TriangleMesh& mesh) {
    return point.triangle >= 0 && static_cast<std::size_t>(point.triangle) < mesh.triangles.size() &&
           std::all_of(point.weight.begin(), point.weight.end(),
                       [](double w) { return std::fabs(w) <= 1e3; });
}

bool isControl(const Control& control, const TriangleMesh& mesh) {
    if (control.kind > ControlKind::Area || control.points.empty() ||
        !(std::fabs(control.startTime) <= 1e9) || !(std::fabs(control.clock) <= 1e9) ||
        control.weights.size() != control.supplementary.size() * control.points.size())
        return false;
    for (const ControlPoint& point : control.points)
        if (point.vertex < 0 || static_cast<std::size_t>(point.vertex) >= mesh.vertices.size() ||
            !isPlace(point.offset) || !isPlace(point.position) || !isPathOf(point))
            return false;
    for (const MeshPoint& point : control.supplementary)
        if (!isOnMesh(point, mesh)) return false;
    return std::all_of(control.weights.begin(), control.weights.end(),
                       [](double w) { return std::fabs(w) <= 1e6; });
}

Status checkControls(const ControlSet& set, const TriangleMesh& mesh) {
    std::vector<std::int32_t> vertices;
    for (const Control& control : set.controls()) {
        if (!isControl(control, mesh)) return wrong("a control that is not on its mesh");
        for (const ControlPoint& point : control.points) vertices.push_back(point.vertex);
    }
    std::sort(vertices.begin(), vertices.end());
    if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
        return wrong("a vertex that two controls hold");
    return {};
}

bool areSpots(const std::vector<HeldSpot>& held) {
    return std::all_of(held.begin(), held.end(), [](const HeldSpot& spot) {
        return isPlace(spot.position) && spot.radius > 0.0 && spot.radius <= kMaxCoordinate;
    });
}

bool isSane(const WayNeeds& needs) {
    const auto isSize = [](double x) { return x >= 0.0 && x <= 1e9; };
    return isSize(needs.half) && isSize(needs.margin) && isSize(needs.least) && needs.radius > 0.0 &&
           needs.radius <= 1e3 && areSpots(needs.held);
}

bool isSane(const MarchFlow& flow) {
    const std::size_t n = flow.offsets.size();
    const auto isPose = [](const Pose& pose) {
        const Rotation& r = pose.rotation;
        return isPlace(pose.position) && std::fabs(r.c * r.c + r.s * r.s - 1.0) < 1e-6;
    };
    if (flow.phase == FlowPhase::None) return true;
    return flow.phase <= FlowPhase::Standing && flow.q >= 0.0 && flow.q <= 1.0 && flow.speed >= 0.0 &&
           flow.speed <= kFastest && flow.rate >= 0.0 && flow.rate <= 1e9 && flow.spent >= 0 &&
           flow.spent <= 1'000'000'000 && isPose(flow.from) && isPose(flow.to) && flow.spacing > 0.0 &&
           flow.spacing <= kMaxCoordinate && flow.radius > 0.0 && flow.radius <= kMaxCoordinate &&
           flow.ends.size() == flow.places.size() &&
           (!flow.moves() || (flow.starts.size() == n && flow.ends.size() == n && flow.way.size() >= 2)) &&
           arePlaces(flow.offsets) && arePlaces(flow.starts) && arePlaces(flow.ends) && arePlaces(flow.way) &&
           std::all_of(flow.poses.begin(), flow.poses.end(), isPose) && arePlaces(flow.places) &&
           areSpots(flow.held) && std::all_of(flow.kept.begin(), flow.kept.end(), [&](std::int32_t place) {
               return place >= 0 && std::cmp_less(place, flow.places.size());
           });
}

bool isSane(const March& march) {
    const Rotation& r = march.last.rotation;
    return march.phase <= MarchPhase::Stand && arePlaces(march.way) && arePlaces(march.legs) &&
           march.next <= march.way.size() && isPlace(march.last.position) &&
           std::fabs(r.c * r.c + r.s * r.s - 1.0) < 1e-6 && isPlace(march.query.from) &&
           isPlace(march.query.to) && isSane(march.query.needs) && march.searched >= 0 &&
           march.searched <= 16'000'000 && (march.phase != MarchPhase::Go || march.next < march.way.size()) &&
           (march.phase != MarchPhase::Search || !march.way.empty());
}

bool isSane(const Avoidance& avoidance) {
    return avoidance.chosen.wait >= 0.0 && avoidance.chosen.wait <= 1e3 && isPlace(avoidance.offCourse) &&
           std::fabs(avoidance.chosen.offCourse) <= kMaxCoordinate && length(avoidance.side) <= 1.0 + 1e-6 &&
           avoidance.waited >= 0.0 && avoidance.waited <= 1e3;
}

Status checkOrders(const Group& group, std::uint32_t nextOrder) {
    const OrderQueue& queue = group.orders;
    if (queue.orders.size() > kMaxOrders + 1) return wrong("too many orders");
    for (const QueuedOrder& queued : queue.orders) {
        if (queued.id == 0 || queued.id >= nextOrder) return wrong("an order of an unknown number");
        if (Status s = validate(queued.order); !s.ok()) return s;
    }
    if (queue.own)
        if (Status s = validate(*queue.own); !s.ok()) return s;
    const bool points = queue.own && queue.own->kind == FormationKind::Points;
    if (!isSane(queue.march) || !isSane(group.flow) || !isSane(group.avoidance) || !isPlace(queue.target) ||
        queue.arrived < 0 || (queue.begun && queue.orders.empty()) ||
        (points && std::cmp_less(queue.own->points.size(), 1)))
        return wrong("an order that contradicts itself");
    for (const std::vector<std::uint32_t>& visitors : group.visitors)
        if (!std::is_sorted(visitors.begin(), visitors.end())) return wrong("numbers out of order");
    return {};
}

Status checkGroup(const Group& group, const Grid& grid, bool bare) {
    const GroupDef& def = group.def;
    if (def.count < 0 || static_cast<std::size_t>(def.count) != group.members.size())
        return wrong("a group of another count");
    const std::size_t count = bare ? 0 : group.members.size();
    if (def.name.size() > kMaxText || !isPlace(def.position) || !arePlaces(def.starts))
        return wrong("a bad group");
    if (Status s = validateColour(def.colour); !s.ok()) return s;
    if (Status s = isKnown(def.build, kLastOf<BodyBuild>, "build"); !s.ok()) return s;
    if (Status s = isKnown(def.motions, kLastOf<MotionSet>, "set of motions"); !s.ok()) return s;
    if (Status s = validate(def.formation); !s.ok()) return s;
    const Formation& formation = group.mesh.formation();
    if (formation.places.size() != count || group.places.positions().size() != count)
        return wrong("places that do not suit their group");
    const MarchFlow& flow = group.flow;
    if (flow.leads() && (flow.kept.empty() ? flow.places.size() : flow.kept.size()) != count)
        return wrong("a march that does not suit its group");
    if (flow.phase == FlowPhase::Flowing && !flow.asked.fits(grid))
        return wrong("a march over another ground");
    for (const auto* points : {&formation.mesh.vertices, &group.mesh.userMesh(), &group.mesh.finalMesh()})
        if (!arePlaces(*points)) return wrong("a mesh that is out of range");
    if (!(group.meanLag >= 0.0 && group.meanLag <= kMaxCoordinate * 100.0))
        return wrong("a lag out of range");
    if (!isPlace(group.settling.centre)) return wrong("a group with a number out of range");
    if (group.room.wanted.size() != group.room.given.size() || !arePlaces(group.room.wanted) ||
        !arePlaces(group.room.given))
        return wrong("room of places out of range");
    if (group.order.arrival > ArrivalWatch::Awaited || group.order.withoutWay < 0 ||
        group.order.behindMoving < 0)
        return wrong("progress out of range");
    if (std::abs(group.groundClass) > kMostClasses) return wrong("a class of ground out of range");
    if (group.slice < 0 || group.slices < 1 || group.slice > group.slices)
        return wrong("shares of a plan out of range");
    if (!group.lastAssignment.empty() && group.lastAssignment.size() != count)
        return wrong("last places that do not suit their group");
    if (Status s = validateRoles(def.roles); !s.ok()) return s;
    if (Status s = validateDemands(def.demands); !s.ok()) return s;
    for (const std::int32_t place : group.lastAssignment)
        if (place < -1 || place >= def.count) return wrong("last places that do not suit their group");
    if (!group.plan->suits(count, count, grid)) return wrong("a plan for another group");
    return checkControls(group.controls, formation.mesh);
}

bool isSane(const Passage& passage) {
    const auto isDepth = [](double depth) { return depth >= 0.0 && depth <= 1e3; };
    return isPlace(passage.a) && isPlace(passage.b) && passage.width() > 0.0 && passage.speed > 0.0 &&
           passage.speed <= 1e3 && passage.pace > 0.0 && passage.pace <= 1.0 && isDepth(passage.left) &&
           isDepth(passage.right);
}

bool isSane(const SurveyDef& def) {
    return isPlace(def.from) && isPlace(def.to) && def.people >= 0.0 && def.people <= 1e9 &&
           def.speed > 0.0 && def.speed <= 1e9;
}

bool isSane(const SurveyState& survey, std::size_t passages) {
    const auto all = [](const auto& list) {
        return std::all_of(list.begin(), list.end(), [](const auto& x) { return isSane(x); });
    };
    std::size_t crowd = 0;
    for (const SurveyDef& def : survey.orders) crowd += def.crowd;
    const bool searching = survey.phase == SurveyPhase::Search;
    const bool idle = survey.phase == SurveyPhase::None;
    return survey.phase <= SurveyPhase::Fields && all(survey.orders) && all(survey.passages) &&
           arePlaces(survey.crowd) && crowd == survey.crowd.size() && (searching || survey.orders.empty()) &&
           (idle || (survey.known >= passages && survey.known <= survey.passages.size())) &&
           (survey.openCost.empty() ||
            (searching && !survey.orders.empty() && survey.openCost.size() == survey.orders.front().crowd)) &&
           survey.shortest >= 0.0 && survey.capacity >= 0.0 && survey.cells >= 0;
}

Status checkOwnRoutes(const WorldState& state) {
    std::uint32_t last = 0;
    for (const OwnRoute& route : state.ownRoutes) {
        if (route.character <= last || route.character >= state.nextCharacter || !isPlace(route.goal) ||
            !arePlaces(route.path) || !(route.cost >= 0.0f))
            return wrong("a route out of range");
        last = route.character;
    }
    return {};
}

bool areStanding(const std::vector<StandingSpot>& spots, std::uint32_t nextCharacter) {
    std::uint32_t last = 0;
    for (const StandingSpot& spot : spots) {
        if (spot.character <= last || spot.character >= nextCharacter || !isPlace(spot.spot)) return false;
        last = spot.character;
    }
    return true;
}

Status checkContinuum(const WorldState& state) {
    std::uint32_t last = 0;
    for (const Gathering& gathering : state.continuum.gatherings) {
        if (gathering.group.value <= last || !isPlace(gathering.target) ||
            !ascending(gathering.arrived, state.nextCharacter) ||
            !(gathering.kind == OrderKind::Move || isBare(gathering.kind)) ||
            gathering.since > state.stepCount || !areStanding(gathering.spots, state.nextCharacter))
            return wrong("a gathering out of range");
        last = gathering.group.value;
    }
    std::int32_t lastClass = std::numeric_limits<std::int32_t>::min();
    for (const FrozenCost& frozen : state.continuum.costs) {
        if (frozen.groundClass <= lastClass || !(frozen.cost.grid == state.environment.grid()) ||
            !validateUnitCost(frozen.cost).ok())
            return wrong("frozen costs of another ground");
        lastClass = frozen.groundClass;
    }
    if (state.continuum.frozenAt > state.stepCount) return wrong("frozen costs of a later step");
    return {};
}

Status checkWays(const WorldState& state) {
    for (const Passage& passage : state.passages)
        if (!isSane(passage)) return wrong("a passage out of range");
    if (!isSane(state.survey, state.passages.size())) return wrong("a survey that contradicts itself");
    for (const ChosenWay& chosen : state.characters.chosen)
        if (chosen.way < -1 || (chosen.way >= 0 && passageOf(chosen.way) >= state.passages.size()) ||
            !(std::fabs(chosen.passAt) <= 1e9) || !(chosen.share >= 0.0 && chosen.share <= 1.0))
            return wrong("a way out of range");
    for (const Group& group : state.groups)
        if (!isPlace(group.surveyFrom) || !isPlace(group.surveyTo) || !isPlace(group.waysFor) ||
            !isVelocity(group.goalDrift) || !isPlace(group.foreseen))
            return wrong("a survey out of range");
    return {};
}

/// True where ids ascend below the next one.
template <class AnyId>
bool ascend(const std::vector<AnyId>& ids, std::uint32_t next) {
    for (std::size_t k = 0; k < ids.size(); ++k)
        if (ids[k].value == 0 || ids[k].value >= next || (k > 0 && ids[k] <= ids[k - 1])) return false;
    return true;
}

bool isSane(const Area& area, std::uint32_t nextCharacter) {
    const auto isAmount = [](double x) { return x >= 0.0 && x <= 1e9; };
    const ExitFlow& exit = area.exit;
    const SourceFlow& source = area.source;
    return isAmount(exit.served) && isAmount(exit.queued) && isAmount(exit.credit) &&
           std::all_of(exit.line.begin(), exit.line.end(),
                       [&](std::uint32_t id) { return id < nextCharacter; }) &&
           source.next >= -1.0 && source.next <= 1e10 && isAmount(source.rate) && source.sent >= 0 &&
           source.entry <= area.def.timetable.size();
}

Status checkQueueAndMarks(const WorldState& state) {
    if (state.lastCommandStep > state.stepCount || state.collected.size() != state.items.size() ||
        state.checkpointState.size() != state.groups.size() * state.checkpoints.size() ||
        state.checkpointGroups.size() != state.checkpoints.size() ||
        state.checkpointIds.size() != state.checkpoints.size() || state.itemIds.size() != state.items.size())
        return wrong("lists of different lengths");
    if (!ascend(state.itemIds, state.nextItem) || !ascend(state.checkpointIds, state.nextCheckpoint))
        return wrong("ids of items or checkpoints out of order");
    for (const ItemDef& item : state.items)
        if (Status s = validate(item); !s.ok()) return s;
    for (const FormationCheckpointDef& checkpoint : state.checkpoints)
        if (Status s = validateCheckpoint(checkpoint, kMaxGroups); !s.ok()) return s;
    std::vector<AreaId> areas;
    for (const Area& area : state.areas) {
        if (Status s = validate(area.def); !s.ok()) return s;
        if (!isSane(area, state.nextCharacter)) return wrong("an area with a number out of range");
        areas.push_back(area.id);
    }
    if (!ascend(areas, state.nextArea)) return wrong("ids of areas out of order");
    for (std::size_t k = 0; k < state.queue.size(); ++k)
        if (state.queue[k].step < state.stepCount ||
            (k > 0 && comesBefore(state.queue[k], state.queue[k - 1])))
            return wrong("commands out of order");
    return {};
}

}  // namespace

Status checkState(WorldState& state) {
    if (Status s = validateParameters(state.parameters, state.environment.def().box); !s.ok()) return s;
    if (Status s = checkGround(state.environment); !s.ok()) return s;
    if (Status s = checkArrays(state.characters); !s.ok()) return s;
    if (Status s = validateTotal(static_cast<std::int64_t>(state.characters.size()), state.parameters);
        !s.ok())
        return s;
    if (state.groups.size() > kMaxGroups || !ascending(state.characters.id, state.nextCharacter))
        return wrong("numbers out of order");
    const std::size_t motions = state.environment.def().clips.size();
    for (std::size_t i = 0; i < state.characters.size(); ++i)
        if (state.characters.group[i] >= state.groups.size() || state.characters.motion[i] < 0 ||
            static_cast<std::size_t>(state.characters.motion[i]) >= motions)
            return wrong("a character of no group or motion");
    state.refreshMembers();
    std::vector<std::uint32_t> ids;
    for (const Group& group : state.groups) {
        const bool bare = state.continuum.isBare(group.id);
        if (Status s = checkGroup(group, state.environment.grid(), bare); !s.ok()) return s;
        if (Status s = checkOrders(group, state.nextOrder); !s.ok()) return s;
        if (group.visitors.size() > state.checkpoints.size()) return wrong("lists of different lengths");
        ids.push_back(group.id.value);
    }
    if (!ascending(ids, state.nextGroup)) return wrong("numbers out of order");
    for (std::size_t i = 0; i < state.characters.size(); ++i)
        if (state.characters.place[i] < -1 ||
            state.characters.place[i] >= state.groups[state.characters.group[i]].def.count)
            return wrong("a character with a place that is none");
    if (Status s = checkWays(state); !s.ok()) return s;
    if (Status s = checkOwnRoutes(state); !s.ok()) return s;
    if (Status s = checkContinuum(state); !s.ok()) return s;
    return checkQueueAndMarks(state);
}

}  // namespace muster
