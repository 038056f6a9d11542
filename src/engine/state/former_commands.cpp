// Commands by the names that they had, as those that say the same.
#include "muster/command.h"

namespace muster {

CommandBody converted(const AddObstacle& c) {
    return putThing(c.obstacle);
}
CommandBody converted(const ChangeObstacle& c) {
    return putThing(c.obstacle, c.id);
}
CommandBody converted(const RemoveObstacle& c) {
    return removeThing(c.id);
}
CommandBody converted(const AddPatch& c) {
    return putThing(c.patch);
}
CommandBody converted(const ChangePatch& c) {
    return putThing(c.patch, c.id);
}
CommandBody converted(const RemovePatch& c) {
    return removeThing(c.id);
}
CommandBody converted(const AddItem& c) {
    return putThing(c.item);
}
CommandBody converted(const ChangeItem& c) {
    return putThing(c.item, c.id);
}
CommandBody converted(const RemoveItem& c) {
    return removeThing(c.id);
}
CommandBody converted(const AddCheckpoint& c) {
    return putThing(c.checkpoint, {}, c.group);
}
CommandBody converted(const ChangeCheckpoint& c) {
    return putThing(c.checkpoint, c.id, c.group);
}
CommandBody converted(const RemoveCheckpoint& c) {
    return removeThing(c.id);
}
CommandBody converted(const PutArea& c) {
    return putThing(c.area, c.id, c.group);
}
CommandBody converted(const RemoveArea& c) {
    return removeThing(c.id);
}

CommandBody converted(const SetFormation& c) {
    return ChangeGroup{.group = c.group, .formation = c.formation};
}
CommandBody converted(const SetCount& c) {
    return ChangeGroup{.group = c.group, .count = c.count};
}
CommandBody converted(const SetConduct& c) {
    return ChangeGroup{.group = c.group, .conduct = c.conduct};
}
CommandBody converted(const SetRoles& c) {
    return ChangeGroup{.group = c.group, .roles = c.roles};
}
CommandBody converted(const SetDemands& c) {
    return ChangeGroup{.group = c.group, .demands = c.demands};
}
CommandBody converted(const SetPeople& c) {
    return ChangeGroup{.group = c.group, .people = c.people};
}
CommandBody converted(const NameGroup& c) {
    return ChangeGroup{.group = c.group, .name = c.name};
}
CommandBody converted(const ColourGroup& c) {
    return ChangeGroup{.group = c.group, .colour = GroupColour{c.colour}};
}
CommandBody converted(const SetAppearance& c) {
    return ChangeGroup{.group = c.group, .look = GroupLook{c.build, c.motions}};
}
CommandBody converted(const RemoveCharacters& c) {
    return TransferCharacters{c.ids, {}};
}
CommandBody converted(const SetBodies& c) {
    return ChangeCharacters{c.ids, c.bodies, {}};
}
CommandBody converted(const SetDriver& c) {
    return ChangeCharacters{c.ids, {}, c.driver};
}
CommandBody converted(const PlaceGroup& c) {
    return SetPose{c.group, c.position, c.angle, true};
}

}  // namespace muster
