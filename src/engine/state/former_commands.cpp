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

}  // namespace muster
