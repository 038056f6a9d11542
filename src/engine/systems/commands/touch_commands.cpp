// Commands of fingers and of the controls that they make.
#include <algorithm>
#include <string>

#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/picked_group.h"

namespace muster {
namespace {

Status refused(bool accepted, const std::string& why) {
    return accepted ? Status{} : invalidArgument(why);
}

// The time of a touch, at most the present, so that no trajectory lies in the future. (A touch that comes
// down while the world is paused may be stamped later: the stamp tells which touches belong together.)
double stamp(const WorldState& state, double time) {
    return std::clamp(time, 0.0, state.time());
}

// Calls `change` for the controls of each group until one of them holds the touch.
template <class Change>
Status eachSet(WorldState& state, std::uint32_t touch, Change change) {
    for (Group& group : state.groups)
        if (change(group.controls)) return {};
    return notFound("touch that is down", touch);
}

}  // namespace

Status apply(CommandContext& context, const TouchDown& touch) {
    WorldState& state = context.state;
    const auto picked = touch.group ? std::nullopt : pickedGroup(state, touch.position);
    Group* const group = picked ? &state.groups[*picked] : state.findGroup(touch.group);
    if (touch.group && group == nullptr) return notFound("group", touch.group.value);
    if (group == nullptr)
        return invalidArgument("touch " + std::to_string(touch.touch) + " begins on no formation");
    group->order.fresh = true;
    return refused(
        group->controls.touchDown(context.state.parameters.input, context.command.client, touch.touch,
                                  touch.position, touch.time, group->mesh.formation().mesh,
                                  group->mesh.finalMesh(), group->mesh.userMesh()),
        "touch " + std::to_string(touch.touch) + " is down already, or its vertex is held");
}

Status apply(CommandContext& context, const TouchMove& touch) {
    return eachSet(context.state, touch.touch, [&](ControlSet& set) {
        return set.touchMove(context.state.parameters.input, context.command.client, touch.touch,
                             touch.position, stamp(context.state, touch.time));
    });
}

Status apply(CommandContext& context, const TouchUp& touch) {
    return eachSet(context.state, touch.touch,
                   [&](ControlSet& set) { return set.touchUp(context.command.client, touch.touch); });
}

Status apply(CommandContext& context, const TouchCancel& touch) {
    return eachSet(context.state, touch.touch,
                   [&](ControlSet& set) { return set.touchCancel(context.command.client, touch.touch); });
}

Status apply(CommandContext& context, const AddControl& add) {
    Group* group = context.state.findGroup(add.group);
    if (group == nullptr) return notFound("group", add.group.value);
    group->order.fresh = true;
    return refused(group->controls.addControl(context.command.client, add.kind, add.touches, add.positions,
                                              stamp(context.state, add.time), group->mesh.formation().mesh,
                                              group->mesh.finalMesh(), group->mesh.userMesh()),
                   "the control's points do not suit its kind, or share a vertex that is held");
}

Status apply(CommandContext& context, const PinControl& pin) {
    Group* group = context.state.findGroup(pin.group);
    if (group == nullptr) return notFound("group", pin.group.value);
    return group->controls.setPinned(pin.control, pin.pinned) ? Status{}
                                                              : notFound("control", pin.control.value);
}

Status apply(CommandContext& context, const RemoveControl& remove) {
    Group* group = context.state.findGroup(remove.group);
    if (group == nullptr) return notFound("group", remove.group.value);
    return group->controls.remove(remove.control) ? Status{} : notFound("control", remove.control.value);
}

Status apply(CommandContext& context, const ReleaseClient&) {
    for (Group& group : context.state.groups) group.controls.releaseClient(context.command.client);
    return {};
}

}  // namespace muster
