#include "engine/systems/commands/apply_commands.h"

#include <algorithm>
#include <limits>
#include <string>

#include "base/maths.h"
#include "engine/formation/shapes/formation.h"
#include "engine/state/bare_groups.h"
#include "engine/state/ground_class.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/area_commands.h"
#include "engine/systems/commands/body_commands.h"
#include "engine/systems/commands/ended_paths.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_commands.h"
#include "engine/systems/commands/place_commands.h"
#include "engine/systems/commands/role_commands.h"
#include "engine/systems/commands/unit_commands.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

Status refused(bool accepted, const std::string& why) {
    return accepted ? Status{} : invalidArgument(why);
}

/// Applies the body of one command to a world.
class Apply {
public:
    Apply(WorldState& state, ThreadPool& pool, std::vector<Event>& events, const Command& command)
        : state_(state), pool_(pool), events_(events), command_(command) {}

    Status operator()(const TouchDown& touch) {
        Group* group = touch.group ? state_.findGroup(touch.group) : nearestGroup(touch.position);
        if (touch.group && group == nullptr) return notFound("group", touch.group.value);
        if (group == nullptr)
            return invalidArgument("touch " + std::to_string(touch.touch) + " begins on no formation");
        group->order.fresh = true;
        return refused(group->controls.touchDown(state_.parameters.input, command_.client, touch.touch,
                                                 touch.position, touch.time, group->mesh.formation().mesh,
                                                 group->mesh.finalMesh(), group->mesh.userMesh()),
                       "touch " + std::to_string(touch.touch) + " is down already, or its vertex is held");
    }
    Status operator()(const TouchMove& touch) {
        return eachSet(touch.touch, [&](ControlSet& set) {
            return set.touchMove(state_.parameters.input, command_.client, touch.touch, touch.position,
                                 stamp(touch.time));
        });
    }
    Status operator()(const TouchUp& touch) {
        return eachSet(touch.touch,
                       [&](ControlSet& set) { return set.touchUp(command_.client, touch.touch); });
    }
    Status operator()(const TouchCancel& touch) {
        return eachSet(touch.touch,
                       [&](ControlSet& set) { return set.touchCancel(command_.client, touch.touch); });
    }
    Status operator()(const AddControl& add) {
        Group* group = state_.findGroup(add.group);
        if (group == nullptr) return notFound("group", add.group.value);
        group->order.fresh = true;
        return refused(group->controls.addControl(command_.client, add.kind, add.touches, add.positions,
                                                  stamp(add.time), group->mesh.formation().mesh,
                                                  group->mesh.finalMesh(), group->mesh.userMesh()),
                       "the control's points do not suit its kind, or share a vertex that is held");
    }
    Status operator()(const PinControl& pin) {
        Group* group = state_.findGroup(pin.group);
        if (group == nullptr) return notFound("group", pin.group.value);
        return group->controls.setPinned(pin.control, pin.pinned) ? Status{}
                                                                  : notFound("control", pin.control.value);
    }
    Status operator()(const RemoveControl& remove) {
        Group* group = state_.findGroup(remove.group);
        if (group == nullptr) return notFound("group", remove.group.value);
        return group->controls.remove(remove.control) ? Status{} : notFound("control", remove.control.value);
    }
    Status operator()(const ReleaseClient&) {
        for (Group& group : state_.groups) group.controls.releaseClient(command_.client);
        return {};
    }
    Status operator()(const SetFormation& set) {
        Group* group = state_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        if (state_.continuum.isBare(group->id)) return defineFormation(*group, set.formation);
        const Status changed = changeFormation(state_, *group, set.formation, group->def.count);
        if (!changed.ok()) return changed;
        group->orders.own.reset();
        state_.continuum.end(group->id);
        return changed;
    }
    Status operator()(const SetCount& set) {
        Group* group = state_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        const std::int64_t sum = static_cast<std::int64_t>(state_.characters.size()) - group->def.count +
                                 set.count;
        const Status total = validateTotal(sum, state_.parameters);
        if (!total.ok()) return total;
        const bool bare = state_.continuum.isBare(group->id);
        const Status changed = bare ? Status()
                                    : changeFormation(state_, *group, group->def.formation, set.count);
        if (bare) group->def.count = set.count;
        if (changed.ok()) setCount(state_, *group, set.count);
        return changed;
    }
    Status operator()(const SetPose& set) {
        Group* group = state_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        group->controls.clear();
        if (state_.continuum.isBare(group->id)) formUp(editableGroups(), *group);
        state_.continuum.end(group->id);
        dropOrders(*group);
        group->orders.march.reversed = false;
        group->order.begin(state_.stepCount);
        group->mesh.setPose({set.position, {cosine(set.angle), sine(set.angle)}});
        return {};
    }
    Status operator()(const AddGroup& add) { return addGroup(state_, add.group); }
    Status operator()(const RemoveGroup& remove) {
        const Group* group = state_.findGroup(remove.group);
        if (group == nullptr) return notFound("group", remove.group.value);
        pool_.wait();  // Background work reads the plan.
        removeGroup(state_, static_cast<std::size_t>(group - state_.groups.data()));
        return {};
    }
    Status operator()(const AddObstacle& add) {
        return edited(editableGround().addObstacle(add.obstacle).status());
    }
    Status operator()(const ChangeObstacle& change) {
        return edited(editableGround().changeObstacle(change.id, change.obstacle));
    }
    Status operator()(const RemoveObstacle& remove) {
        return edited(editableGround().removeObstacle(remove.id));
    }
    Status operator()(const AddPatch& add) { return edited(editableGround().addPatch(add.patch).status()); }
    Status operator()(const ChangePatch& change) {
        return edited(editableGround().changePatch(change.id, change.patch));
    }
    Status operator()(const RemovePatch& remove) { return edited(editableGround().removePatch(remove.id)); }
    Status operator()(const SetParameter& set) {
        if (set.name == "time.step")
            return invalidArgument("parameter 'time.step' stands for the life of a world");
        Parameters next = state_.parameters;
        Status status = setParameter(next, set.name, set.value);
        if (status.ok()) status = validateParameters(next, state_.environment.def().box);
        if (status.ok()) status = validateTotal(static_cast<std::int64_t>(state_.characters.size()), next);
        if (!status.ok()) return status;
        const bool exchanged = next.plan.solver != state_.parameters.plan.solver;
        state_.parameters = next;
        if (exchanged) {
            pool_.wait();  // Background work reads the plans.
            exchangePlans(state_);
        }
        editableGround().setFieldDefaults(next.field.range, next.field.strength);
        return status;
    }
    Status operator()(const GiveOrder& give) { return giveOrder(state_, give, events_); }
    Status operator()(const EditQueue& edit) { return editQueue(state_, edit, events_); }
    Status operator()(const SetConduct& set) { return setConduct(state_, set); }
    Status operator()(const AddCharacters& add) { return addCharacters(editableGroups(), add, events_); }
    Status operator()(const RemoveCharacters& remove) {
        return removeCharacters(editableGroups(), remove, events_);
    }
    Status operator()(const TransferCharacters& transfer) {
        return transferCharacters(editableGroups(), transfer, events_);
    }
    Status operator()(const SplitGroup& split) { return splitGroup(editableGroups(), split, events_); }
    Status operator()(const MergeGroups& merge) { return mergeGroups(editableGroups(), merge, events_); }
    Status operator()(const SetBodies& set) { return setBodies(editableGroups(), set); }
    Status operator()(const SetRoles& set) { return setRoles(editableGroups(), set); }
    Status operator()(const SetDemands& set) { return setDemands(editableGroups(), set); }
    Status operator()(const SetDriver& set) { return setDriver(state_, set); }
    Status operator()(const WriteMotion& write) { return writeMotion(state_, write); }
    Status operator()(const AddItem& add) { return addItem(state_, add); }
    Status operator()(const ChangeItem& change) { return changeItem(state_, change); }
    Status operator()(const RemoveItem& remove) { return removeItem(state_, remove); }
    Status operator()(const AddCheckpoint& add) { return addCheckpoint(state_, add); }
    Status operator()(const ChangeCheckpoint& change) { return changeCheckpoint(state_, change); }
    Status operator()(const RemoveCheckpoint& remove) { return removeCheckpoint(state_, remove); }
    Status operator()(const PlaceGroup& place) { return placeGroup(editableGroups(), place); }
    Status operator()(const NameGroup& name) { return nameGroup(state_, name); }
    Status operator()(const ColourGroup& colour) { return colourGroup(state_, colour); }
    Status operator()(const SetAppearance& appearance) { return setAppearance(state_, appearance); }
    Status operator()(const PutArea& put) { return putArea(state_, put); }
    Status operator()(const RemoveArea& remove) { return removeArea(state_, remove); }
    Status operator()(const SetPeople& set) { return setPeople(editableGroups(), set); }

private:
    // Background work reads the plans.
    WorldState& editableGroups() {
        pool_.wait();
        return state_;
    }
    // Background work reads the ground.
    Environment& editableGround() {
        pool_.wait();
        return state_.environment;
    }
    // A group that has no formation now takes it up later.
    static Status defineFormation(Group& group, const FormationDef& def) {
        const Result<Formation> formation = makeFormation(def, std::max(1, group.def.count));
        if (!formation.ok()) return formation.status().within("group '" + group.def.name + "'");
        group.def.formation = def;
        group.orders.own.reset();
        return {};
    }
    // Counts the versions of the ground.
    Status edited(Status status) {
        state_.groundEdits += status.ok() ? 1 : 0;
        return status;
    }

    // A trajectory never lies in the world's future. (The stamp of a touch that comes down may, where the
    // world is paused: it tells which touches came down together.)
    double stamp(double time) const { return std::clamp(time, 0.0, state_.time()); }

    // The group whose final mesh lies nearest within reach; ties go to the lower id.
    Group* nearestGroup(Vec2 p) {
        Group* best = nullptr;
        double nearest = state_.parameters.input.reach;
        for (Group& group : state_.groups) {
            if (group.members.empty()) continue;
            const auto& triangles = group.mesh.formation().mesh.triangles;
            const MeshPoint point = locate(triangles, group.mesh.finalMesh(), p);
            const double d = distance(point.position(triangles, group.mesh.finalMesh()), p);
            if (d < nearest || (best == nullptr && d <= nearest)) {
                nearest = d;
                best = &group;
            }
        }
        return best;
    }

    template <class Change>
    Status eachSet(std::uint32_t touch, Change change) {
        for (Group& group : state_.groups)
            if (change(group.controls)) return {};
        return notFound("touch that is down", touch);
    }

    WorldState& state_;
    ThreadPool& pool_;
    std::vector<Event>& events_;
    const Command& command_;
};

// Lists where the ground was edited since it had a version. Very many edits count as one of the whole ground:
// of those the environment remembers the latest only.
void listEdits(WorldState& state, std::uint64_t version) {
    constexpr std::uint32_t kMostEdits = 64;
    const Grid& grid = state.environment.grid();
    state.editedAreas.clear();
    state.editedPatches = state.environment.staticPatchVersion() > version;
    if (state.groundEdits - state.editsBefore <= kMostEdits &&
        state.environment.staticChangesSince(version, state.editedAreas))
        return;
    state.editedAreas.assign(1, {{0, 0}, {grid.width - 1, grid.height - 1}});
}

}  // namespace

void applyCommands(WorldState& state, ThreadPool& pool, std::vector<Event>& events,
                   std::vector<Rejection>& rejections) {
    events.clear();
    rejections.clear();
    restOutside(state);
    const std::uint64_t version = state.environment.staticVersion();
    state.editsBefore = state.groundEdits;
    std::vector<Command>& queue = state.queue;
    std::ptrdiff_t done = 0;
    while (done < std::ssize(queue) && queue[done].step <= state.stepCount) {
        const Command& command = queue[done++];
        const Status status = std::visit(Apply(state, pool, events, command), command.body);
        if (status.ok())
            state.lastCommandStep = state.stepCount;
        else
            rejections.push_back({command, status});
    }
    queue.erase(queue.begin(), queue.begin() + done);
    state.environment.setTime(state.time());
    settleEndedPaths(state, pool);
    listEdits(state, version);
    updateGroundClasses(state, pool);
}

}  // namespace muster
