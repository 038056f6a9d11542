// Commands by the names that they had, as those that say the same.
#include "engine/state/command_archive.h"

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

namespace {

/// One function for each kind that stands for several former ones.
struct Former {
    std::optional<FormerKinds> operator()(const ChangeGroup& c) const {
        const int given = int{c.formation.has_value()} + int{c.count.has_value()} +
                          int{c.people.has_value()} + int{c.conduct.has_value()} + int{c.roles.has_value()} +
                          int{c.demands.has_value()} + int{c.name.has_value()} + int{c.colour.has_value()} +
                          int{c.look.has_value()};
        if (given != 1) return std::nullopt;
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
