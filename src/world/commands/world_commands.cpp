// Commands: what each changes.
#include <algorithm>
#include <limits>
#include <string>

#include "base/maths.h"
#include "muster/parameter_table.h"
#include "world/commands/validation.h"
#include "world/state/derived_defs.h"
#include "world/state/world_state.h"

namespace muster {
namespace {

Status notFound(const char* what, std::uint32_t id) {
    return {StatusCode::NotFound, std::string("no ") + what + " has the id " + std::to_string(id)};
}

Status refused(bool accepted, const std::string& why) {
    return accepted ? Status{} : invalidArgument(why);
}

// Applies one command's body to a world.
class Apply {
public:
    Apply(World::Impl& world, const Command& command) : world_(world), command_(command) {}

    Status operator()(const TouchDown& touch) {
        Group* group = touch.group ? world_.findGroup(touch.group) : nearestGroup(touch.position);
        if (touch.group && group == nullptr) return notFound("group", touch.group.value);
        if (group == nullptr)
            return invalidArgument("touch " + std::to_string(touch.touch) + " begins on no formation");
        return refused(group->controls.touchDown(controlDef(world_.parameters), command_.client, touch.touch,
                                                 touch.position, touch.time, group->mesh.formation().mesh,
                                                 group->mesh.finalMesh(), group->mesh.userMesh()),
                       "touch " + std::to_string(touch.touch) + " is down already, or its vertex is held");
    }
    Status operator()(const TouchMove& touch) {
        return eachSet(touch.touch, [&](ControlSet& set) {
            return set.touchMove(controlDef(world_.parameters), command_.client, touch.touch, touch.position,
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
        Group* group = world_.findGroup(add.group);
        if (group == nullptr) return notFound("group", add.group.value);
        return refused(
            group->controls.addControl(controlDef(world_.parameters), command_.client, add.kind, add.touches,
                                       add.positions, stamp(add.time), group->mesh.formation().mesh,
                                       group->mesh.finalMesh(), group->mesh.userMesh()),
            "the control's points do not suit its kind, or share a vertex that is held");
    }
    Status operator()(const PinControl& pin) {
        Group* group = world_.findGroup(pin.group);
        if (group == nullptr) return notFound("group", pin.group.value);
        return group->controls.setPinned(pin.control, pin.pinned) ? Status{}
                                                                  : notFound("control", pin.control.value);
    }
    Status operator()(const RemoveControl& remove) {
        Group* group = world_.findGroup(remove.group);
        if (group == nullptr) return notFound("group", remove.group.value);
        return group->controls.remove(remove.control) ? Status{} : notFound("control", remove.control.value);
    }
    Status operator()(const ReleaseClient&) {
        for (Group& group : world_.groups) group.controls.releaseClient(command_.client);
        return {};
    }
    Status operator()(const SetFormation& set) {
        Group* group = world_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        return world_.changeFormation(*group, set.formation, group->def.count);
    }
    Status operator()(const SetCount& set) {
        Group* group = world_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        const std::int64_t sum = static_cast<std::int64_t>(world_.characters.size()) - group->def.count +
                                 set.count;
        const Status total = validateTotal(sum, world_.parameters);
        if (!total.ok()) return total;
        const Status changed = world_.changeFormation(*group, group->def.formation, set.count);
        if (changed.ok()) world_.setCount(*group, set.count);
        return changed;
    }
    Status operator()(const SetPose& set) {
        Group* group = world_.findGroup(set.group);
        if (group == nullptr) return notFound("group", set.group.value);
        group->controls.clear();
        group->mesh.setPose({set.position, {cosine(set.angle), sine(set.angle)}});
        return {};
    }
    Status operator()(const AddGroup& add) { return world_.addGroup(add.group); }
    Status operator()(const RemoveGroup& remove) {
        const Group* group = world_.findGroup(remove.group);
        if (group == nullptr) return notFound("group", remove.group.value);
        world_.removeGroup(static_cast<std::size_t>(group - world_.groups.data()));
        return {};
    }
    Status operator()(const AddObstacle& add) {
        return world_.environment.addObstacle(add.obstacle).status();
    }
    Status operator()(const ChangeObstacle& change) {
        return world_.environment.changeObstacle(change.id, change.obstacle);
    }
    Status operator()(const RemoveObstacle& remove) { return world_.environment.removeObstacle(remove.id); }
    Status operator()(const AddPatch& add) { return world_.environment.addPatch(add.patch).status(); }
    Status operator()(const ChangePatch& change) {
        return world_.environment.changePatch(change.id, change.patch);
    }
    Status operator()(const RemovePatch& remove) { return world_.environment.removePatch(remove.id); }
    Status operator()(const SetParameter& set) {
        if (set.name == "time.step")
            return invalidArgument("parameter 'time.step' stands for the life of a world");
        Parameters next = world_.parameters;
        Status status = setParameter(next, set.name, set.value);
        if (status.ok()) status = validateParameters(next, world_.environment.def().box);
        if (status.ok()) status = validateTotal(static_cast<std::int64_t>(world_.characters.size()), next);
        if (!status.ok()) return status;
        const bool exchanged = next.plan.solver != world_.parameters.plan.solver;
        world_.parameters = next;
        if (exchanged) world_.exchangePlans();
        world_.environment.setFieldDefaults(next.field.range, next.field.strength);
        if (set.name == "density.cell" || set.name == "density.lambda")
            world_.density = DensityField(world_.environment.def().box, next.density);
        return status;
    }

private:
    // What is drawn never lies in the world's future. (Stamps of touches that come down may, where it is
    // paused: they tell which came down together.)
    double stamp(double time) const { return std::clamp(time, 0.0, world_.time()); }

    // The group whose final mesh lies nearest within reach; ties go to the lower id.
    Group* nearestGroup(Vec2 p) {
        Group* best = nullptr;
        double nearest = world_.parameters.input.reach;
        for (Group& group : world_.groups) {
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
        for (Group& group : world_.groups)
            if (change(group.controls)) return {};
        return notFound("touch that is down", touch);
    }

    World::Impl& world_;
    const Command& command_;
};

}  // namespace

Status World::Impl::apply(const Command& command) {
    return std::visit(Apply(*this, command), command.body);
}

void World::Impl::applyCommands() {
    events.clear();
    rejections.clear();
    std::size_t done = 0;
    while (done < queue.size() && queue[done].step <= stepCount) {
        const Command& command = queue[done++];
        const Status status = apply(command);
        if (status.ok())
            lastCommandStep = stepCount;
        else
            rejections.push_back({command, status});
    }
    queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(done));
    environment.setTime(time());
}

}  // namespace muster
