#include "studio/session/takes/block_labels.h"

#include <algorithm>
#include <cctype>

#include "base/generated/enumeration_words.h"
#include "engine/geometry/polygon.h"
#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

constexpr double kBeside = 4.0;  // A target so near a thing is named after it [m].

double away(const Polygon& polygon, Vec2 at) {
    return polygon.size() < 3 ? kBeside : std::max(0.0, signedDistance(polygon, at));
}

/// The nearest thing with a name; empty for none beside that point.
std::string thingAt(const WorldDef& place, Vec2 at) {
    std::string name;
    double least = kBeside;
    const auto look = [&](const std::string& called, double distance) {
        if (called.empty() || distance >= least) return;
        least = distance;
        name = called;
    };
    for (const ObstacleDef& one : place.obstacles)
        look(one.name, one.polygon.empty() ? distance(one.centre, at) - one.radius : away(one.polygon, at));
    for (const PatchDef& one : place.patches) look(one.name, away(one.polygon, at));
    for (const AreaDef& one : place.areas) look(one.name, away(one.polygon, at));
    return name;
}

template <std::size_t N, class Value>
const char* wordOf(const std::array<const char*, N>& words, Value value) {
    return words[static_cast<std::size_t>(value)];
}

std::string groupName(const WorldDef& place, GroupId group) {
    const bool known = group.value > 0 && group.value <= place.groups.size();
    const std::string name = known ? place.groups[group.value - 1].name : std::string();
    return name.empty() ? "group " + std::to_string(group.value) : name;
}

std::string areaName(const WorldDef& place, AreaId area) {
    const bool known = area.value > 0 && area.value <= place.areas.size();
    return known ? place.areas[area.value - 1].name : std::string();
}

std::string formed(const FormationDef& formation) {
    if (formation.kind == FormationKind::Outline || formation.kind == FormationKind::Points)
        return "Take up a formation";
    return std::string("Form a ") + wordOf(kFormationKindWords, formation.kind);
}

struct BlockLabel {
    const WorldDef& place;

    std::string operator()(const GiveOrder& give) const {
        const Order& order = give.order;
        const std::string label = wordOf(kOrderKindLabels, order.kind);
        std::string where;
        if (order.kind == OrderKind::Move) where = thingAt(place, order.target);
        if (order.kind == OrderKind::Wait) where = areaName(place, order.area);
        if (order.kind == OrderKind::Leave && order.exits.size() == 1)
            where = areaName(place, order.exits[0]);
        if (order.kind == OrderKind::Follow || order.kind == OrderKind::Guard)
            return label + " " + (order.group ? groupName(place, order.group) : "somebody");
        const char* const joint = order.kind == OrderKind::Move    ? " to "
                                  : order.kind == OrderKind::Leave ? " by "
                                                                   : " in ";
        if (!where.empty()) return label + joint + where;
        return order.formation ? label + ", " + lowered(formed(*order.formation)) : label;
    }
    std::string operator()(const ChangeGroup& change) const {
        if (change.formation) return formed(*change.formation);
        if (change.count) return std::to_string(*change.count) + " people";
        if (change.name) return "Name";
        if (change.colour || change.look) return "Colour";
        return traitsOf(change).label;
    }
    std::string operator()(const EditQueue& edit) const { return wordOf(kQueueEditLabels, edit.edit); }
    std::string operator()(const EditControl& edit) const { return wordOf(kControlEditLabels, edit.edit); }
    std::string operator()(const Touch&) const { return "Touch"; }
    std::string operator()(const AddControl&) const { return "Touch"; }
    std::string operator()(const PutThing& put) const {
        return put.id == 0 ? "Add to the place" : "Change the place";
    }
    std::string operator()(const RemoveThing& remove) const {
        return std::string("Remove ") + wordOf(kThingKindWords, remove.thing);
    }
    std::string operator()(const ChangeCharacters& change) const {
        return change.driver ? "Own path" : "Bodies";
    }
    std::string operator()(const WriteMotion&) const { return "Own path"; }
    template <class Other>
    std::string operator()(const Other& other) const {
        const std::string label = traitsOf(other).label;
        return label.empty() ? "Change" : label;
    }

    static std::string lowered(std::string text) {
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
        return text;
    }
};

}  // namespace

std::string blockLabel(const CommandBody& body, const WorldDef& place) {
    return std::visit(BlockLabel{place}, body);
}

}  // namespace muster
