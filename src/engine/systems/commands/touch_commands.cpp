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

namespace {

Status comeDown(CommandContext& context, const Touch& touch) {
    WorldState& state = context.state;
    const auto picked = touch.group ? std::nullopt : pickedGroup(state, touch.position);
    Group* const group = picked ? &state.groups[*picked] : state.findGroup(touch.group);
    if (touch.group && group == nullptr) return noGroup(touch.group);
    if (group == nullptr)
        return invalidArgument("touch " + std::to_string(touch.touch) + " begins on no formation");
    group->order.fresh = true;
    return refused(
        group->controls.touchDown(context.state.parameters.input, context.command.client, touch.touch,
                                  touch.position, touch.time, group->mesh.formation().mesh,
                                  group->mesh.finalMesh(), group->mesh.userMesh()),
        "touch " + std::to_string(touch.touch) + " is down already, or its vertex is held");
}

}  // namespace

Status apply(CommandContext& context, const Touch& touch) {
    if (touch.phase == TouchPhase::Down) return comeDown(context, touch);
    const std::uint32_t client = context.command.client;
    return eachSet(context.state, touch.touch, [&](ControlSet& set) {
        if (touch.phase == TouchPhase::Up) return set.touchUp(client, touch.touch);
        if (touch.phase == TouchPhase::Cancel) return set.touchCancel(client, touch.touch);
        return set.touchMove(context.state.parameters.input, client, touch.touch, touch.position,
                             stamp(context.state, touch.time));
    });
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

Status apply(CommandContext& context, const EditControl& edit) {
    Group* group = context.state.findGroup(edit.group);
    if (group == nullptr) return noGroup(edit.group);
    const bool found = edit.edit == ControlEdit::Remove
                           ? group->controls.remove(edit.control)
                           : group->controls.setPinned(edit.control, edit.edit == ControlEdit::Pin);
    return found ? Status{} : notFound("control", edit.control.value);
}

Status apply(CommandContext& context, const ReleaseClient&) {
    for (Group& group : context.state.groups) group.controls.releaseClient(context.command.client);
    return {};
}

}  // namespace muster
