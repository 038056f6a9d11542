// Commands by the names that they had, as those that say the same.
#include "engine/state/command_archive.h"
#include "engine/state/group_change.h"

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

CommandBody converted(const TouchDown& c) {
    return Touch{TouchPhase::Down, c.touch, c.position, c.time, c.group};
}
CommandBody converted(const TouchMove& c) {
    return Touch{TouchPhase::Move, c.touch, c.position, c.time, {}};
}
CommandBody converted(const TouchUp& c) {
    return Touch{TouchPhase::Up, c.touch, {}, c.time, {}};
}
CommandBody converted(const TouchCancel& c) {
    return Touch{TouchPhase::Cancel, c.touch, {}, 0.0, {}};
}
CommandBody converted(const PinControl& c) {
    return EditControl{c.group, c.control, c.pinned ? ControlEdit::Pin : ControlEdit::Release};
}
CommandBody converted(const RemoveControl& c) {
    return EditControl{c.group, c.control, ControlEdit::Remove};
}

namespace {

/// One function for each kind that stands for several former ones.
struct Former {
    std::optional<FormerKinds> operator()(const ChangeGroup& c) const {
        if (givenFields(c).size() != 1) return std::nullopt;
        if (c.formation) return SetFormation{c.group, *c.formation};
        if (c.count) return SetCount{c.group, *c.count};
        if (c.people) return SetPeople{c.group, *c.people};
        if (c.conduct) return SetConduct{c.group, *c.conduct};
        if (c.roles) return SetRoles{c.group, *c.roles};
        if (c.demands) return SetDemands{c.group, *c.demands};
        if (c.name) return NameGroup{c.group, *c.name};
        if (c.colour) return ColourGroup{c.group, c.colour->colour};
        return SetAppearance{c.group, c.look->build, c.look->motions};
    }
    std::optional<FormerKinds> operator()(const SetPose& c) const {
        return c.characters ? std::optional<FormerKinds>(PlaceGroup{c.group, c.position, c.angle})
                            : std::nullopt;
    }
    std::optional<FormerKinds> operator()(const TransferCharacters& c) const {
        return c.group ? std::nullopt : std::optional<FormerKinds>(RemoveCharacters{c.ids});
    }
    std::optional<FormerKinds> operator()(const ChangeCharacters& c) const {
        if (c.bodies.has_value() == c.driver.has_value()) return std::nullopt;
        if (c.bodies) return SetBodies{c.ids, *c.bodies};
        return SetDriver{c.ids, *c.driver};
    }
    std::optional<FormerKinds> operator()(const Touch& c) const {
        if (c.phase == TouchPhase::Down) return TouchDown{c.touch, c.position, c.time, c.group};
        if (c.phase == TouchPhase::Move) return TouchMove{c.touch, c.position, c.time};
        if (c.phase == TouchPhase::Up) return TouchUp{c.touch, c.time};
        return TouchCancel{c.touch};
    }
    std::optional<FormerKinds> operator()(const EditControl& c) const {
        if (c.edit == ControlEdit::Remove) return RemoveControl{c.group, c.control};
        return PinControl{c.group, c.control, c.edit == ControlEdit::Pin};
    }
    template <class Other>
    std::optional<FormerKinds> operator()(const Other&) const {
        return std::nullopt;
    }
};

}  // namespace

std::optional<FormerKinds> formerOf(const CommandBody& body) {
    return std::visit(Former{}, body);
}

}  // namespace muster
