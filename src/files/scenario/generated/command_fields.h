// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// The fields of each kind of command in gesture files, except t, kind, client and step.
#pragma once

#include "files/scenario/command_by_hand.h"

namespace muster {

/// What files call each kind of command. Orders are called by what they ask for.
// clang-format off
inline constexpr std::array kCommandWords{
    "touch",
    "control",
    "editControl",
    "release",
    "changeGroup",
    "pose",
    "group",
    "removeGroup",
    "putThing",
    "removeThing",
    "parameter",
    "order",
    "queue",
    "join",
    "transfer",
    "split",
    "merge",
    "changeCharacters",
    "motion",
    "reverseQueue",
};
// clang-format on
static_assert(kCommandWords.size() == std::variant_size_v<CommandKinds>);

/// What older files call commands that worlds no longer have.
// clang-format off
inline constexpr std::array kFormerWords{
    "obstacle",
    "changeObstacle",
    "removeObstacle",
    "patch",
    "changePatch",
    "removePatch",
    "item",
    "changeItem",
    "removeItem",
    "checkpoint",
    "changeCheckpoint",
    "removeCheckpoint",
    "area",
    "removeArea",
    "formation",
    "count",
    "conduct",
    "leave",
    "bodies",
    "roles",
    "demands",
    "driver",
    "placeGroup",
    "nameGroup",
    "colourGroup",
    "appearance",
    "people",
    "down",
    "move",
    "up",
    "cancel",
    "pin",
    "remove",
};
// clang-format on
static_assert(kFormerWords.size() == std::variant_size_v<FormerKinds>);

/// Describes the fields of each kind of command to a visitor.
template <class Visitor>
struct BodyFields {
    Visitor& v;
    double& time;

    void operator()(Touch& c) { describeByHand(v, c, time); }
    void operator()(AddControl& c) { describeByHand(v, c, time); }
    void operator()(EditControl& c) {
        v.whole("group", c.group.value, kId, "Group that the control belongs to.", Need::Required);
        v.whole("control", c.control.value, kId, "Its id.", Need::Required);
        describeWord(v, "edit", c.edit, kControlEditWords, "What is done to it.", Need::Required);
    }
    void operator()(ReleaseClient&) {}
    void operator()(ChangeGroup& c) {
        v.whole("group", c.group.value, kId, "Group to change.", Need::Required);
        given("formation", c.formation, [&](auto& value, Need need) {
            describeShape(v, "formation", value, "Its formation; none for the one that it has.", need);
        });
        given("count", c.count, [&](auto& value, Need need) {
            v.whole("count", value, {1.0, kMaxCharacters}, "How many people it has.", need);
        });
        given("people", c.people, [&](auto& value, Need need) { describePeople(v, value, need); });
        maybe("conduct", c.conduct, "How it behaves; none for as it does.",
              [](auto& inner, auto& def) { describe(inner, def); });
        given("roles", c.roles, [&](auto& value, Need need) { describeRoles(v, value, need); });
        given("demands", c.demands, [&](auto& value, Need need) {
            v.numbers("demands", value, {0.0, 1000.0}, kMaxCharacters,
                      "Units of supply that each place demands; empty for 1 each.", need);
        });
        given("name", c.name, [&](auto& value, Need need) {
            v.text("name", value, "Its name, of at most 4,096 bytes; none for the one that it has.", need);
        });
        maybe("colour", c.colour, "Its colour; none for the one that it has.",
              [](auto& inner, auto& def) { describe(inner, def); });
        maybe("look", c.look, "How its people look; none for as they do.",
              [](auto& inner, auto& def) { describe(inner, def); });
    }
    void operator()(SetPose& c) {
        v.whole("group", c.group.value, kId, "Group to move.", Need::Required);
        spot(c.position);
        v.number("angle", c.angle, kAngle, "New heading, counter-clockwise from +x.");
        if (takesPart<Visitor>(c.characters))
            v.flag("characters", c.characters,
                   "True: its places and characters are there at once, and stand still.");
    }
    void operator()(AddGroup& c) {
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.group); }, Need::Required);
    }
    void operator()(RemoveGroup& c) {
        v.whole("group", c.group.value, kId, "Group to remove.", Need::Required);
    }
    void operator()(PutThing& c) {
        if (takesPart<Visitor>(c.id != 0))
            v.whole("id", c.id, kId, "Thing that gets another definition; 0 to add one.");
        maybe("obstacle", c.obstacle, "An obstacle; none for other things.",
              [](auto& inner, auto& def) { describe(inner, def); });
        maybe("patch", c.patch, "A patch; none for other things.",
              [](auto& inner, auto& def) { describe(inner, def, {}); });
        maybe("item", c.item, "An item to collect; none for other things.",
              [](auto& inner, auto& def) { describe(inner, def); });
        maybe("checkpoint", c.checkpoint,
              "A formation checkpoint (SPEC M7), whose `group` is not read; none for other things.",
              [](auto& inner, auto& def) { describe(inner, def, [] {}); });
        maybe("area", c.area, "An area, whose `group` is not read; none for other things.",
              [](auto& inner, auto& def) { describe(inner, def, [] {}); });
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId,
                    "Group that a checkpoint concerns, none for any, or that people of a source join.");
    }
    void operator()(RemoveThing& c) {
        describeWord(v, "thing", c.thing, kThingKindWords, "What it is.", Need::Required);
        v.whole("id", c.id, kId, "Its id.", Need::Required);
    }
    void operator()(SetParameter& c) {
        v.text("name", c.name, "Name in parameterTable(): \"plan.exponent\".", Need::Required);
        v.number("value", c.value, {-1e9, 1e9}, "New value, in the range of the parameter.", Need::Required);
    }
    void operator()(GiveOrder& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describeWord(v, "mode", c.mode, kQueueModeWords, "Where the order stands in the queue.");
        if (takesPart<Visitor>(c.index != 0))
            v.whole("index", c.index, kId, "For Insert: before which order, counted from 0.");
        describe(v, c.order);
    }
    void operator()(EditQueue& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describeWord(v, "edit", c.edit, kQueueEditWords, "What is done to the queue.", Need::Required);
        if (takesPart<Visitor>(c.order != 0))
            v.whole("order", c.order, kId, "For Cancel: the id of the order; 0 for all.");
    }
    void operator()(AddCharacters& c) {
        v.whole("group", c.group.value, kId, "Group that they join.", Need::Required);
        v.points("positions", c.positions, 1, kMaxCharacters,
                 "Where they stand; they part where they would stand in each other.", Need::Required);
        describeBodies(v, "bodies", c.bodies, Need::Optional);
    }
    void operator()(TransferCharacters& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "Group that they join; none to leave the world.");
    }
    void operator()(SplitGroup& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describeWord(v, "by", c.by, kSplitByWords, "How it is divided.", Need::Required);
        v.numbers("ids", c.ids, kId, kMaxCharacters, "For Ids: the characters that leave.");
        v.points("points", c.points, 0, kMaxCorners,
                 "For Line: two points; for Lasso: the corners of the polygon.");
        v.numbers("shares", c.shares, {0.0, 1e6}, kMaxGroups,
                  "For Shares: of all parts, above 0; their sum counts as the whole.");
        v.flag("abreast", c.abreast, "For Shares: parts lie side by side, not one behind the other.");
        describeWord(v, "shape", c.shape, kPartShapeWords, "Formation of the parts.");
    }
    void operator()(MergeGroups& c) {
        describeIds(v, "groups", c.groups, kMaxGroups, "Two or more.", Need::Required);
        describeWord(v, "shape", c.shape, kPartShapeWords,
                     "Smaller: the formation of the first for all; AsHeld: all places stay.");
    }
    void operator()(ChangeCharacters& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
        given("bodies", c.bodies, [&](auto& value, Need need) { describeBodies(v, "bodies", value, need); });
        describeWord(v, "driver", c.driver, kDriverWords, "What moves them; none for what moves them now.");
    }
    void operator()(WriteMotion& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
        v.points("positions", c.positions, 1, kMaxCharacters, "Where they are.", Need::Required);
        v.points("velocities", c.velocities, 0, kMaxCharacters,
                 "Their velocities; empty for what follows from the last positions.");
    }
    void operator()(ReverseQueue& c) { v.whole("group", c.group.value, kId, "The group.", Need::Required); }
    void operator()(AddObstacle& c) {
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.obstacle); }, Need::Required);
    }
    void operator()(ChangeObstacle& c) {
        v.whole("id", c.id.value, kId, "Its id.", Need::Required);
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.obstacle); }, Need::Required);
    }
    void operator()(RemoveObstacle& c) { v.whole("id", c.id.value, kId, "Its id.", Need::Required); }
    void operator()(AddPatch& c) {
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.patch, {}); }, Need::Required);
    }
    void operator()(ChangePatch& c) {
        v.whole("id", c.id.value, kId, "Its id.", Need::Required);
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.patch, {}); }, Need::Required);
    }
    void operator()(RemovePatch& c) { v.whole("id", c.id.value, kId, "Its id.", Need::Required); }
    void operator()(AddItem& c) {
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.item); }, Need::Required);
    }
    void operator()(ChangeItem& c) {
        v.whole("id", c.id.value, kId, "Its id.", Need::Required);
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.item); }, Need::Required);
    }
    void operator()(RemoveItem& c) { v.whole("id", c.id.value, kId, "Its id.", Need::Required); }
    void operator()(AddCheckpoint& c) {
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.checkpoint, [] {}); }, Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "Group that it concerns; none for any group.");
    }
    void operator()(ChangeCheckpoint& c) {
        v.whole("id", c.id.value, kId, "Its id.", Need::Required);
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.checkpoint, [] {}); }, Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "Group that it concerns; none for any group.");
    }
    void operator()(RemoveCheckpoint& c) { v.whole("id", c.id.value, kId, "Its id.", Need::Required); }
    void operator()(PutArea& c) {
        if (takesPart<Visitor>(static_cast<bool>(c.id)))
            v.whole("id", c.id.value, kId, "The area that is changed; none to add one.");
        v.object(
            "definition", "", [&](auto& inner) { describe(inner, c.area, [] {}); }, Need::Required);
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "For Source: the group that its people join.");
    }
    void operator()(RemoveArea& c) { v.whole("id", c.id.value, kId, "Its id.", Need::Required); }
    void operator()(SetFormation& c) {
        v.whole("group", c.group.value, kId, "Group to change.", Need::Required);
        v.objectOrKind(
            "formation", "", [&](auto& inner) { describe(inner, c.formation); }, Need::Required);
    }
    void operator()(SetCount& c) {
        v.whole("group", c.group.value, kId, "Group to change.", Need::Required);
        v.whole("count", c.count, {1.0, kMaxCharacters}, "New number of characters.", Need::Required);
    }
    void operator()(SetConduct& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describe(v, c.conduct);
    }
    void operator()(RemoveCharacters& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
    }
    void operator()(SetBodies& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
        describeBodies(v, "bodies", c.bodies, Need::Required);
    }
    void operator()(SetRoles& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describeRoles(v, c.roles, Need::Optional);
    }
    void operator()(SetDemands& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        v.numbers("demands", c.demands, {0.0, 1000.0}, kMaxCharacters,
                  "Of each place, 0 to 1000; empty for 1 each.", Need::Required);
    }
    void operator()(SetDriver& c) {
        v.numbers("ids", c.ids, kId, kMaxCharacters, "Their ids.", Need::Required);
        describeWord(v, "driver", c.driver, kDriverWords, "What moves them.", Need::Required);
    }
    void operator()(PlaceGroup& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        spot(c.position);
        v.number("angle", c.angle, kAngle, "New heading, counter-clockwise from +x.");
    }
    void operator()(NameGroup& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        v.text("name", c.name, "At most 4,096 bytes.", Need::Required);
    }
    void operator()(ColourGroup& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        v.colour("colour", c.colour, "0xRRGGBB; none for the palette's, by the group's id.");
    }
    void operator()(SetAppearance& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describeWord(v, "build", c.build, kBodyBuildWords,
                     "Build of the drawn bodies; left out: both, by their ids.");
        describeWord(v, "motions", c.motions, kMotionSetWords, "How they walk and jog; left out: plainly.");
    }
    void operator()(SetPeople& c) {
        v.whole("group", c.group.value, kId, "The group.", Need::Required);
        describePeople(v, c.people, Need::Optional);
    }
    void operator()(TouchDown& c) {
        v.whole("touch", c.touch, kId, "Number of the finger, unique per client while it is down.",
                Need::Required);
        spot(c.position);
        c.time = time;
        if (takesPart<Visitor>(static_cast<bool>(c.group)))
            v.whole("group", c.group.value, kId, "Group to edit; none to pick it by position.");
    }
    void operator()(TouchMove& c) {
        v.whole("touch", c.touch, kId, "Number of the finger.", Need::Required);
        spot(c.position);
        c.time = time;
    }
    void operator()(TouchUp& c) {
        v.whole("touch", c.touch, kId, "Number of the finger.", Need::Required);
        c.time = time;
    }
    void operator()(TouchCancel& c) {
        v.whole("touch", c.touch, kId, "Number of the finger.", Need::Required);
    }
    void operator()(PinControl& c) {
        v.whole("group", c.group.value, kId, "Group that the control belongs to.", Need::Required);
        v.whole("control", c.control.value, kId, "Its id.", Need::Required);
        v.flag("pinned", c.pinned, "False to release it.");
    }
    void operator()(RemoveControl& c) {
        v.whole("group", c.group.value, kId, "Group that the control belongs to.", Need::Required);
        v.whole("control", c.control.value, kId, "Its id.", Need::Required);
    }

private:
    void spot(Vec2& p) {
        v.number("x", p.x, kCoordinate, "World coordinate.", Need::Required);
        v.number("y", p.y, kCoordinate, "World coordinate.", Need::Required);
    }
    /// A value that may be left out: `describe(value, need)` where it is given.
    template <class Value, class Describe>
    void given(const char* key, std::optional<Value>& value, const Describe& describe) {
        if constexpr (Visitor::kSchema) {
            Value none{};
            describe(none, Need::Optional);
            v.eraseDefault(key);
        } else if constexpr (Visitor::kReading) {
            if (v.has(key)) describe(value.emplace(), Need::Required);
        } else if (value) {
            describe(*value, Need::Required);
        }
    }
    /// A definition that may be left out.
    template <class Def, class Describe>
    void maybe(const char* key, std::optional<Def>& def, const char* about, const Describe& describe) {
        given(key, def, [&](auto& value, Need need) {
            v.object(
                key, about, [&](auto& inner) { describe(inner, value); }, need);
        });
    }
};

}  // namespace muster
