// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// Names of commands, and what each of their fields has to be.
#include "engine/state/command_checks.h"

#include <array>

#include "engine/state/generated/command_relations.h"
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

// clang-format off
constexpr auto kNames = std::to_array<const char*>({
    "Touch",
    "AddControl",
    "EditControl",
    "ReleaseClient",
    "ChangeGroup",
    "SetPose",
    "AddGroup",
    "RemoveGroup",
    "PutThing",
    "RemoveThing",
    "SetParameter",
    "GiveOrder",
    "EditQueue",
    "AddCharacters",
    "TransferCharacters",
    "SplitGroup",
    "MergeGroups",
    "ChangeCharacters",
    "WriteMotion",
    "ReverseQueue",
});
// clang-format on
static_assert(kNames.size() == std::variant_size_v<CommandKinds>);

/// One check per kind of command.
struct Validator {
    Status operator()(const Touch& c) const {
        Status status = isKnown(c.phase, kLastOf<TouchPhase>, "phase");
        if (status.ok()) status = place("position", c.position);
        if (status.ok()) status = numberIn("time", c.time, 0, 1e9, "[0, 1e9] s");
        return status;
    }
    Status operator()(const AddControl& c) const {
        Status status = isKnown(c.kind, kLastOf<ControlKind>, "control kind");
        if (status.ok()) status = numberIn("time", c.time, 0, 1e9, "[0, 1e9] s");
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const EditControl& c) const { return isKnown(c.edit, kLastOf<ControlEdit>, "edit"); }
    Status operator()(const ReleaseClient&) const { return {}; }
    Status operator()(const ChangeGroup& c) const {
        Status status = validateIfAny(c.formation);
        if (status.ok())
            status = checkIfAny(c.count,
                                [](const auto& value) { return countIn("count", value, 1, kMaxCharacters); });
        if (status.ok())
            status = checkIfAny(c.people, [](const auto& value) { return validatePeople(value); });
        if (status.ok()) status = validateIfAny(c.conduct);
        if (status.ok()) status = checkIfAny(c.roles, [](const auto& value) { return validateRoles(value); });
        if (status.ok()) status = checkIfAny(c.name, [](const auto& value) { return isText("name", value); });
        if (status.ok()) status = validateIfAny(c.colour);
        if (status.ok()) status = validateIfAny(c.look);
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const SetPose& c) const {
        Status status = place("position", c.position);
        if (status.ok()) status = numberIn("angle", c.angle, -1e6, 1e6, "[-1e6, 1e6] rad");
        return status;
    }
    Status operator()(const AddGroup& c) const { return validate(c.group); }
    Status operator()(const RemoveGroup&) const { return {}; }
    Status operator()(const PutThing& c) const {
        Status status = validateIfAny(c.obstacle);
        if (status.ok())
            status = checkIfAny(c.patch, [](const auto& value) { return validatePatch(value, kAnyMotion); });
        if (status.ok()) status = validateIfAny(c.item);
        if (status.ok())
            status = checkIfAny(c.checkpoint,
                                [](const auto& value) { return validateCheckpoint(value, kMaxGroups); });
        if (status.ok()) status = validateIfAny(c.area);
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const RemoveThing& c) const { return isKnown(c.thing, kLastOf<ThingKind>, "thing"); }
    Status operator()(const SetParameter& c) const {
        Status status = isText("name", c.name);
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const GiveOrder& c) const {
        Status status = isKnown(c.mode, kLastOf<QueueMode>, "queue mode");
        if (status.ok()) status = validate(c.order);
        return status;
    }
    Status operator()(const EditQueue& c) const { return isKnown(c.edit, kLastOf<QueueEdit>, "queue edit"); }
    Status operator()(const AddCharacters& c) const {
        Status status = places("positions", c.positions, 1, kMaxCharacters);
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const TransferCharacters& c) const { return eachOnce(c.ids); }
    Status operator()(const SplitGroup& c) const {
        Status status = isKnown(c.by, kLastOf<SplitBy>, "way of splitting");
        if (status.ok()) status = places("points", c.points, 0, kMaxCorners);
        if (status.ok()) status = isKnown(c.shape, kLastOf<PartShape>, "shape of parts");
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const MergeGroups& c) const {
        Status status = isKnown(c.shape, kLastOf<PartShape>, "shape of parts");
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const ChangeCharacters& c) const {
        Status status = eachOnce(c.ids);
        if (status.ok()) status = isKnown(c.driver, kLastOf<Driver>, "driver");
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const WriteMotion& c) const {
        Status status = eachOnce(c.ids);
        if (status.ok()) status = places("positions", c.positions, 1, kMaxCharacters);
        if (status.ok()) status = places("velocities", c.velocities, 0, kMaxCharacters);
        if (status.ok()) status = relations(c);
        return status;
    }
    Status operator()(const ReverseQueue&) const { return {}; }
};

}  // namespace

const char* commandName(const Command& command) {
    return kNames[command.body.index()];
}

Status validateCommand(const Command& command) {
    return std::visit(Validator(), command.body).within(commandName(command));
}

}  // namespace muster
