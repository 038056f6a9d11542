#include "engine/state/group_change.h"

#include <optional>

namespace muster {
namespace {

/// An archive that notes which fields are given.
struct Given {
    std::vector<std::size_t> fields;
    std::size_t next = 0;

    template <class... T>
    void operator()(T&... values) {
        (note(values), ...);
    }
    void note(const GroupId&) {}
    template <class T>
    void note(const std::optional<T>& value) {
        if (value) fields.push_back(next);
        ++next;
    }
};

}  // namespace

std::vector<std::size_t> givenFields(ChangeGroup change) {
    Given given;
    change.visit(given);
    return given.fields;
}

void setPlainFields(GroupDef& def, const ChangeGroup& change) {
    if (change.conduct) def.conduct = *change.conduct;
    if (change.roles) def.roles = *change.roles;
    if (change.demands) def.demands = *change.demands;
    if (change.name) def.name = *change.name;
    if (change.colour) def.colour = change.colour->colour;
    if (!change.look) return;
    def.build = change.look->build;
    def.motions = change.look->motions;
}

ChangeGroup wholeChange(GroupId group, const GroupDef& def) {
    return {group,
            def.formation,
            def.count,
            def.people,
            def.conduct,
            def.roles,
            def.demands,
            def.name,
            GroupColour{def.colour},
            GroupLook{def.build, def.motions}};
}

}  // namespace muster
