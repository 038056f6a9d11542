// Commands of every kind by two directors: all taken back, the definition is the first one again; all done
// again, the last.
#include <algorithm>
#include <sstream>

#include "engine/world/inspect.h"
#include "muster/parameter_table.h"
#include "muster/scenario.h"
#include "studio/session/undo_desk.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::string textOf(const CommandBody& body) {
    const std::vector<Command> commands{{0, 1, 1, body}};
    std::string text = writeGestures(commands, 1.0);
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text.substr(text.find("kind") + 5);
}

/// What a command says, without the ids that come and go.
void putSorted(std::string& text, std::vector<std::string> parts) {
    std::sort(parts.begin(), parts.end());
    for (const std::string& part : parts) text += part + "\n";
}

std::string groupName(const World& world, GroupId id) {
    for (std::size_t g = 0; g < world.groupCount(); ++g)
        if (world.group(g).id == id) return std::string(world.group(g).name);
    return "none";
}

std::string groupText(const World& world, std::size_t g) {
    const GroupView view = world.group(g);
    const GroupDef def = world.groupDef(g);
    std::string text = def.name + " " + std::to_string(view.members.size());
    text += textOf(ChangeGroup{.group = {}, .colour = GroupColour{def.colour}}) +
            textOf(ChangeGroup{.group = {}, .look = GroupLook{def.build, def.motions}});
    text += textOf(ChangeGroup{.group = {}, .people = def.people}) +
            textOf(ChangeGroup{.group = {}, .conduct = def.conduct});
    text += textOf(ChangeGroup{.group = {}, .roles = def.roles}) +
            textOf(ChangeGroup{.group = {}, .demands = def.demands});
    if (!view.members.empty())
        text += textOf(ChangeGroup{.group = {}, .formation = inspect::ownFormation(world, g)});
    for (const QueuedOrder& order : view.orders) text += textOf(GiveOrder{{}, {}, 0, order.order});
    text += view.held ? " held" : "";
    text += view.patrols ? " patrols" : "";
    std::vector<std::string> bodies;
    for (const std::int32_t member : view.members)
        bodies.push_back(textOf(ChangeCharacters{
            {}, std::vector<Body>{world.characters().body[static_cast<std::size_t>(member)]}, {}}));
    putSorted(text, bodies);
    return text;
}

/// What is defined in a world, whatever ids its things have.
struct Defined {
    std::string text;
    std::vector<Pose> poses;  // Of the groups, in the order of the text.
};

bool same(const Defined& a, const Defined& b) {
    const auto near = [](const Pose& x, const Pose& y) {
        return distance(x.position, y.position) < 0.1 && std::abs(x.rotation.s - y.rotation.s) < 0.1;
    };
    return a.text == b.text &&
           std::equal(a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(), near);
}

Defined definitionOf(const World& world, bool poses) {
    Defined defined;
    std::string& text = defined.text;
    for (const ParameterInfo& info : parameterTable())
        text += std::string(info.name) + std::to_string(info.get(world.parameters())) + "\n";
    std::vector<std::string> parts;
    for (const ObstacleId id : world.obstacleIds()) parts.push_back(textOf(putThing(world.obstacle(id).def)));
    for (const PatchId id : world.patchIds()) parts.push_back(textOf(putThing(world.patch(id).def)));
    for (const ItemDef& item : world.items()) parts.push_back(textOf(putThing(item)));
    for (std::size_t k = 0; k < world.checkpoints().size(); ++k)
        parts.push_back(textOf(putThing(world.checkpoints()[k])) +
                        groupName(world, world.checkpointGroups()[k]));
    for (std::size_t a = 0; a < world.areaCount(); ++a)
        parts.push_back(textOf(putThing(world.area(a).def)) + groupName(world, world.area(a).group));
    putSorted(text, std::move(parts));
    std::vector<std::pair<std::string, std::size_t>> groups;
    for (std::size_t g = 0; g < world.groupCount(); ++g) groups.emplace_back(groupText(world, g), g);
    std::sort(groups.begin(), groups.end());
    for (const auto& [of, g] : groups) {
        text += of + "\n";
        if (poses) defined.poses.push_back(world.group(g).pose);
    }
    return defined;
}

/// Two directors who do all that can be taken back.
struct TwoDirectors : UndoDesk {
    FakeClient other{session, true, "other"};
    std::uint32_t seed;
    bool orders;
    std::vector<FakeClient*> did;  // Whose step each one was.

    TwoDirectors(std::uint32_t drawn, bool withOrders) : seed(drawn), orders(withOrders) {
        WorldDef def = twoGroups();
        def.box = {{-60, -60}, {60, 60}};
        def.cell = 0.5;
        if (withOrders) def.parameters.character.maxSpeed = 0.5;  // Nobody arrives.
        REQUIRE(session.load("two", def).ok());
        both();
    }
    std::uint32_t draw(std::size_t n) {
        seed = seed * 1664525u + 1013904223u;
        return (seed >> 16) % static_cast<std::uint32_t>(n);
    }
    double place() { return static_cast<double>(draw(40)) - 20.0; }
    void both(double seconds = 0.15) { run(session, seconds, {&client, &other}); }
    Defined definition() const { return definitionOf(world(), !orders); }

    std::string text(const CommandBody& body) const {
        const std::vector<Command> commands{{0, 1, 1, body}};
        const std::string file = writeGestures(commands, 1.0);
        return file.substr(file.find('['), file.rfind(']') - file.find('[') + 1);
    }
    GroupId anyGroup() { return group(draw(world().groupCount())).id; }
    std::vector<std::uint32_t> anyMembers(GroupId id, std::size_t most) {
        std::vector<std::uint32_t> ids;
        for (std::size_t g = 0; g < world().groupCount(); ++g)
            if (group(g).id == id)
                for (const std::int32_t member : group(g).members)
                    if (ids.size() < most && draw(3) == 0)
                        ids.push_back(world().characters().id[static_cast<std::size_t>(member)]);
        if (ids.empty()) ids.push_back(world().characters().id[0]);
        return ids;
    }
    FormationDef anyFormation() { return {.kind = static_cast<FormationKind>(draw(8))}; }
    Body anyBody() { return {.radius = 0.2 + 0.01 * draw(10)}; }

    CommandBody anyOrder() {
        const GroupId id = anyGroup();
        if (draw(3) == 0) {
            std::uint32_t order = 0;
            for (std::size_t g = 0; g < world().groupCount(); ++g)
                if (group(g).id == id && !group(g).orders.empty())
                    order = group(g).orders[draw(group(g).orders.size())].id;
            return EditQueue{id, static_cast<QueueEdit>(draw(6)), order};
        }
        const double far = draw(2) == 0 ? 50.0 : -50.0;
        const Order order = Order::move({far, place()});
        return GiveOrder{id, static_cast<QueueMode>(draw(3)), draw(3), order};
    }

    CommandBody anyAct() {
        const GroupId id = anyGroup(), second = anyGroup();
        switch (draw(orders ? 14 : 11)) {
            case 0:
                return ChangeGroup{.group = id, .formation = anyFormation()};
            case 1:
                return ChangeGroup{
                    .group = id,
                    .conduct = Conduct{static_cast<Stance>(draw(3)), 0.1 * draw(10), 1.0, draw(2) == 0}};
            case 2:
                return SplitGroup{id,
                                  SplitBy::Shares,
                                  {},
                                  {},
                                  {1.0, 2.0, 1.0},
                                  draw(2) == 0,
                                  static_cast<PartShape>(draw(2))};
            case 3:
                return SplitGroup{
                    id, SplitBy::Ids, anyMembers(id, 4), {}, {}, false, static_cast<PartShape>(draw(2))};
            case 4:
                return MergeGroups{{id, second}, static_cast<PartShape>(draw(2))};
            case 5:
                return TransferCharacters{anyMembers(id, 3), second};
            case 6:
                return TransferCharacters{anyMembers(id, 2), {}};
            case 7:
                return AddCharacters{id, {{place(), place()}, {place(), place()}}, {anyBody()}};
            case 8:
                return ChangeCharacters{anyMembers(id, 3), std::vector<Body>{anyBody()}, {}};
            case 9:
                return ChangeGroup{.group = id, .roles = std::vector<RoleDef>{{RoleArea::Rim, 1}}};
            case 10:
                return SetPose{id, {place(), place()}, 0.1 * draw(30)};
            default:
                return anyOrder();
        }
    }

    CommandBody anyEdit() {
        const GroupId id = anyGroup();
        const auto among = [&](auto ids) { return ids[draw(ids.size())]; };
        switch (draw(15)) {
            case 0: {
                ObstacleDef wall{.name = "Post", .centre = {place() + 35.0, place() + 35.0}, .radius = 0.5};
                if (world().obstacleIds().empty() || draw(2) == 0) return putThing(wall);
                return putThing(wall, among(world().obstacleIds()));
            }
            case 1:
                if (!world().obstacleIds().empty()) return removeThing(among(world().obstacleIds()));
                return ChangeGroup{.group = id, .colour = GroupColour{draw(1000)}};
            case 2:
                if (world().itemIds().empty() || draw(2) == 0) return putThing(ItemDef{{40.0, place()}, 0.3});
                return putThing(ItemDef{{40.0, place()}, 0.4}, among(world().itemIds()));
            case 3:
                if (!world().itemIds().empty()) return removeThing(among(world().itemIds()));
                return ChangeGroup{.group = id, .look = GroupLook{BodyBuild::Narrow, {}}};
            case 4: {
                FormationCheckpointDef checkpoint{.position = {55.0, place()}};
                if (world().checkpointIds().empty() || draw(2) == 0) return putThing(checkpoint);
                return putThing(checkpoint, among(world().checkpointIds()));
            }
            case 5:
                if (!world().checkpointIds().empty()) return removeThing(among(world().checkpointIds()));
                return ChangeGroup{.group = id, .name = "Name " + std::to_string(draw(100))};
            case 6: {
                AreaDef area{.polygon = {{50, 50}, {55, 50}, {55, 50.0 + 1 + draw(5)}}};
                if (world().areaCount() == 0 || draw(2) == 0) return putThing(area);
                return putThing(area, world().area(draw(world().areaCount())).id);
            }
            case 7:
                if (world().areaCount() > 0) return removeThing(world().area(draw(world().areaCount())).id);
                return ChangeGroup{.group = id, .count = 4 + static_cast<std::int32_t>(draw(20))};
            case 8:
                return ChangeGroup{.group = id, .count = 4 + static_cast<std::int32_t>(draw(20))};
            case 9: {
                return AddGroup{.group = {.name = "New " + std::to_string(draw(1000)),
                                          .count = 5,
                                          .position = {place(), place()}}};
            }
            case 10:
                if (world().groupCount() > 2) return RemoveGroup{id};
                return ChangeGroup{.group = id, .name = "Name " + std::to_string(draw(100))};
            case 11:
                return SetPose{id, {place(), place()}, 0.1 * draw(20), true};
            case 12: {
                PatchDef patch{.polygon = {{-50, -50}, {-45, -50}, {-45, -49.0 + draw(4)}}};
                if (world().patchIds().empty() || draw(2) == 0) return putThing(patch);
                return putThing(patch, among(world().patchIds()));
            }
            case 13:
                if (!world().patchIds().empty()) return removeThing(among(world().patchIds()));
                return ChangeGroup{.group = id, .formation = anyFormation()};
            default:
                return SetParameter{"plan.exponent", 1.0 + 0.1 * draw(9)};
        }
    }

    void drag(FakeClient& who) {
        const Vec2 at = group(draw(world().groupCount())).pose.position;
        const Vec2 to = at + Vec2{0.5 + 0.1 * draw(5), 0.5};
        const double now = world().time();
        who.touchAt(TouchPhase::Down, at, now);
        both(0.05);
        who.touchAt(TouchPhase::Move, to, now + 0.05);
        both(0.05);
        who.touchAt(TouchPhase::Up, to, now + 0.1);
        const auto follows = [&] {
            for (std::size_t g = 0; g < world().groupCount(); ++g)
                if (!group(g).controls.empty()) return true;
            return false;
        };
        for (int k = 0; k < 300 && follows(); ++k) both(0.1);
    }

    void anything() {
        FakeClient& who = draw(2) == 0 ? client : other;
        const std::uint32_t before = who.history.undo;
        const std::uint32_t kind = draw(20);
        if (kind < 11)
            who.send(commandsOf(anyAct()));
        else if (kind < 19 || orders)
            who.send(protocol::Edit{"Edit", 0, commandBytes(anyEdit()), {}});
        else
            drag(who);
        both(0.6);  // Two messages of a slider would be one step.
        if (who.history.undo > before) did.push_back(&who);
    }
    void undoBy(FakeClient& who, bool redo) {
        who.send(protocol::UndoEdit{redo});
        both();
        both();
    }
};

/// The lines of one text that the other lacks.
std::string linesOnlyIn(const std::string& text, const std::string& other) {
    std::string only;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (other.find(line + "\n") == std::string::npos) only += "\n      " + line;
    return only;
}

/// In what the definitions differ.
std::string firstOther(const Defined& a, const Defined& b) {
    std::string text = linesOnlyIn(a.text, b.text) + "\n   should be" + linesOnlyIn(b.text, a.text);
    for (std::size_t k = 0; k < std::min(a.poses.size(), b.poses.size()); ++k)
        if (distance(a.poses[k].position, b.poses[k].position) > 0.1)
            text += std::to_string(a.poses[k].position.x) + "," + std::to_string(a.poses[k].position.y) +
                    " should be " + std::to_string(b.poses[k].position.x) + "," +
                    std::to_string(b.poses[k].position.y) + "; ";
    return text;
}

void undoAndRedo(std::uint32_t seed, bool orders, int count) {
    TwoDirectors desk(seed, orders);
    std::vector<Defined> states{desk.definition()};
    for (int k = 0; k < count; ++k) {
        const std::size_t before = desk.did.size();
        desk.anything();
        if (desk.did.size() > before)
            states.push_back(desk.definition());
        else
            states.back() = desk.definition();
    }
    const Defined last = desk.definition();
    desk.client.notices.clear();
    desk.other.notices.clear();
    for (std::size_t k = desk.did.size(); k-- > 0;) {
        const std::string label = desk.did[k]->history.undoLabel;
        desk.undoBy(*desk.did[k], false);
        const Defined now = desk.definition();
        CHECK_MESSAGE(same(now, states[k]), "undo of ", k, " ", label, " seed ", seed, ":\n   ",
                      firstOther(now, states[k]));
        if (!same(now, states[k])) return;
    }
    for (std::size_t k = 0; k < desk.did.size(); ++k) {
        const std::string label = desk.did[k]->history.redoLabel;
        desk.undoBy(*desk.did[k], true);
        const Defined now = desk.definition();
        CHECK_MESSAGE(same(now, states[k + 1]), "redo of ", k, " ", label, " seed ", seed, ":\n   ",
                      firstOther(now, states[k + 1]));
        if (!same(now, states[k + 1])) return;
    }
    CHECK(same(desk.definition(), last));
    CHECK_MESSAGE(desk.trouble().empty(), desk.trouble());
    CHECK(desk.other.noticed("rejected").empty());
}

}  // namespace

TEST_CASE("what two directors do is taken back to the first definition, and done again to the last") {
    for (std::uint32_t seed = 1; seed <= 6; ++seed) undoAndRedo(seed, true, 60);
}

TEST_CASE("places, shapes and drags are taken back to where the crowd was to stand") {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) undoAndRedo(seed, false, 40);
}

TEST_CASE("random acts of two directors with undo between them replay to the same hash") {
    TwoDirectors desk(7, true);
    for (int k = 0; k < 150; ++k) {
        FakeClient& who = desk.draw(2) == 0 ? desk.client : desk.other;
        if (desk.draw(3) == 0)
            who.send(protocol::UndoEdit{desk.draw(4) == 0});
        else
            who.send(commandsOf(desk.anyAct()));
        desk.both(desk.draw(3) == 0 ? 0.0 : 0.1);
    }
    desk.replays();
}
