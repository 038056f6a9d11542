// The fields of commands in gesture files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "files/scenario/describe.h"
#include "muster/command.h"

namespace muster {

inline constexpr std::array kControlWords{"point", "line", "area"};

/// The fields of each kind of command in gesture files, except t, kind, client and step.
template <class Visitor>
struct BodyFields {
    Visitor& v;
    double& time;

    void finger(std::uint32_t& touch) { v.whole("touch", touch, kId, "Finger.", Need::Required); }
    void spot(Vec2& p) {
        v.number("x", p.x, kCoordinate, "World coordinate.", Need::Required);
        v.number("y", p.y, kCoordinate, "World coordinate.", Need::Required);
    }
    template <class Tag>
    void id(const char* key, Id<Tag>& value) {
        v.whole(key, value.value, kId, "Id.", Need::Required);
    }
    void operator()(TouchDown& c) {
        finger(c.touch);
        spot(c.position);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "Group; left out: the nearest mesh.");
        c.time = time;
    }
    void operator()(TouchMove& c) {
        finger(c.touch);
        spot(c.position);
        c.time = time;
    }
    void operator()(TouchUp& c) {
        finger(c.touch);
        c.time = time;
    }
    void operator()(TouchCancel& c) { finger(c.touch); }
    void operator()(AddControl& c) {
        id("group", c.group);
        describeWord(v, "control", c.kind, kControlWords, "Kind of control.", Need::Required);
        std::vector<std::pair<std::uint32_t, Vec2>> points;
        for (std::size_t i = 0; i < c.positions.size(); ++i)
            points.emplace_back(c.touches[i], c.positions[i]);
        v.list(
            "points", points, 64, "Its fingers.",
            [](auto& item, std::pair<std::uint32_t, Vec2>& point) {
                BodyFields<std::remove_reference_t<decltype(item)>> inner{item, point.second.x};
                inner.finger(point.first);
                inner.spot(point.second);
            },
            Need::Required);
        c.touches.clear();
        c.positions.clear();
        for (const auto& [touch, position] : points) {
            c.touches.push_back(touch);
            c.positions.push_back(position);
        }
        c.time = time;
    }
    void operator()(PinControl& c) {
        id("group", c.group);
        id("control", c.control);
        v.flag("pinned", c.pinned, "False lets it go.");
    }
    void operator()(RemoveControl& c) {
        id("group", c.group);
        id("control", c.control);
    }
    void operator()(ReleaseClient&) {}
    void operator()(SetFormation& c) {
        id("group", c.group);
        v.objectOrKind(
            "formation", "", [&](auto& inner) { describeFormation(inner, c.formation); }, Need::Required);
    }
    void operator()(SetCount& c) {
        id("group", c.group);
        v.whole("count", c.count, {1.0, kMaxCharacters}, "Characters.", Need::Required);
    }
    void operator()(SetPose& c) {
        id("group", c.group);
        spot(c.position);
        v.number("angle", c.angle, kAngle, "Where it faces.");
    }
    void operator()(AddGroup& c) {
        v.object(
            "definition", "", [&](auto& inner) { describeGroup(inner, c.group); }, Need::Required);
    }
    void operator()(RemoveGroup& c) { id("group", c.group); }
    void operator()(AddObstacle& c) { obstacle(c.obstacle); }
    void operator()(ChangeObstacle& c) {
        id("id", c.id);
        obstacle(c.obstacle);
    }
    void operator()(RemoveObstacle& c) { id("id", c.id); }
    void operator()(AddPatch& c) { patch(c.patch); }
    void operator()(ChangePatch& c) {
        id("id", c.id);
        patch(c.patch);
    }
    void operator()(RemovePatch& c) { id("id", c.id); }
    void operator()(SetParameter& c) {
        v.text("name", c.name, "Parameter.", Need::Required);
        v.number("value", c.value, {-1e9, 1e9}, "Its new value.", Need::Required);
    }
    void operator()(GiveOrder& c) {
        id("group", c.group);
        describeWord(v, "mode", c.mode, kModeWords, "Where it stands in the queue.");
        if (takesPart<Visitor>(c.index != 0))
            v.whole("index", c.index, kId, "For insert: before which order, counted from 0.");
        describeOrder(v, c.order);
    }
    void operator()(EditQueue& c) {
        id("group", c.group);
        describeWord(v, "edit", c.edit, kEditWords, "What is done to the queue.", Need::Required);
        if (takesPart<Visitor>(c.order != 0))
            v.whole("order", c.order, kId, "For cancel: its id; 0 for all.");
    }
    void operator()(SetConduct& c) {
        id("group", c.group);
        describeConduct(v, c.conduct);
    }
    void operator()(AddCharacters& c) {
        id("group", c.group);
        v.points("positions", c.positions, 1, kMaxCharacters, "Where they stand.", Need::Required);
        describeBodies(v, "bodies", c.bodies, Need::Optional);
    }
    void operator()(RemoveCharacters& c) { ids(c.ids); }
    void operator()(TransferCharacters& c) {
        ids(c.ids);
        id("group", c.group);
    }
    void operator()(SplitGroup& c) {
        id("group", c.group);
        describeWord(v, "by", c.by, kSplitWords, "How it is divided.", Need::Required);
        v.numbers("ids", c.ids, kId, kMaxCharacters, "For ids: who leaves.");
        v.points("points", c.points, 0, kMaxCorners, "For line: two points; for lasso: its corners.");
        v.numbers("shares", c.shares, {0.0, 1e6}, kMaxGroups, "For shares: of all parts.");
        v.flag("abreast", c.abreast, "For shares: parts lie side by side.");
        describeWord(v, "shape", c.shape, kShapeWords, "Formation of the parts.");
    }
    void operator()(MergeGroups& c) {
        std::vector<std::uint32_t> numbers;
        for (const GroupId group : c.groups) numbers.push_back(group.value);
        v.numbers("groups", numbers, kId, kMaxGroups, "Which; the first one stays.", Need::Required);
        c.groups.clear();
        for (const std::uint32_t number : numbers) c.groups.push_back({number});
        describeWord(v, "shape", c.shape, kShapeWords,
                     "All places stay, or the first one's formation for all.");
    }
    void operator()(SetBodies& c) {
        ids(c.ids);
        describeBodies(v, "bodies", c.bodies, Need::Required);
    }
    void operator()(SetRoles& c) {
        id("group", c.group);
        describeRoles(v, c.roles, Need::Required);
    }
    void operator()(SetDemands& c) {
        id("group", c.group);
        v.numbers("demands", c.demands, kDemand, kMaxCharacters, "Of each place; none for 1 each.",
                  Need::Required);
    }
    void operator()(SetDriver& c) {
        ids(c.ids);
        describeWord(v, "driver", c.driver, kDriverWords, "Who moves them.", Need::Required);
    }
    void operator()(WriteMotion& c) {
        ids(c.ids);
        v.points("positions", c.positions, 1, kMaxCharacters, "Where they are.", Need::Required);
        v.points("velocities", c.velocities, 0, kMaxCharacters, "How fast; left out: by the last positions.");
    }
    void operator()(AddItem& c) { item(c.item); }
    void operator()(ChangeItem& c) {
        id("id", c.id);
        item(c.item);
    }
    void operator()(RemoveItem& c) { id("id", c.id); }
    void operator()(AddCheckpoint& c) { checkpoint(c.checkpoint, c.group); }
    void operator()(ChangeCheckpoint& c) {
        id("id", c.id);
        checkpoint(c.checkpoint, c.group);
    }
    void operator()(RemoveCheckpoint& c) { id("id", c.id); }
    void operator()(PlaceGroup& c) {
        id("group", c.group);
        spot(c.position);
        v.number("angle", c.angle, kAngle, "Where it faces.");
    }
    void operator()(NameGroup& c) {
        id("group", c.group);
        v.text("name", c.name, "Shown on its chip.", Need::Required);
    }
    void operator()(ColourGroup& c) {
        id("group", c.group);
        v.colour("colour", c.colour, "Of its shirts and marks; left out: the palette's, by its id.");
    }
    void operator()(SetAppearance& c) {
        id("group", c.group);
        describeAppearance(v, c);
    }
    void operator()(PutArea& c) {
        if (takesPart<Visitor>(static_cast<bool>(c.id)))
            v.whole("id", c.id.value, kId, "Which is changed; left out: a new one.");
        v.object(
            "definition", "", [&](auto& inner) { describeArea(inner, c.area, [] {}); }, Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "For source: whom its people join.");
    }
    void operator()(RemoveArea& c) { id("id", c.id); }
    void operator()(SetPeople& c) {
        id("group", c.group);
        describePeople(v, c.people);
    }
    void ids(std::vector<std::uint32_t>& list) {
        v.numbers("ids", list, kId, kMaxCharacters, "Ids of characters.", Need::Required);
    }
    void obstacle(ObstacleDef& def) {
        v.object(
            "definition", "", [&](auto& inner) { describeObstacle(inner, def); }, Need::Required);
    }
    void patch(PatchDef& def) {
        v.object(
            "definition", "", [&](auto& inner) { describePatch(inner, def, {}); }, Need::Required);
    }
    void item(ItemDef& def) {
        v.object(
            "definition", "", [&](auto& inner) { describeItem(inner, def); }, Need::Required);
    }
    /// The group that it concerns has an id here.
    void checkpoint(FormationCheckpointDef& def, GroupId& group) {
        v.object(
            "definition", "", [&](auto& inner) { describeCheckpoint(inner, def, [] {}); }, Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(group)))
            v.whole("group", group.value, kId, "Group it concerns; left out: any.");
    }
};

}  // namespace muster
