#include <doctest.h>

#include <cmath>
#include <string>

#include "base/archive.h"
#include "base/text_file.h"
#include "files/scenario/schema_validator.h"
#include "muster/scenario.h"
#include "test_folders.h"

using namespace muster;

namespace {

constexpr double kOrderStep = 1.0 / 60.0;

CommandBody bodyOf(const std::string& event) {
    const auto commands = parseCommands(event, "M", kOrderStep);
    REQUIRE_MESSAGE(commands.ok(), commands.status().message());
    REQUIRE(commands->size() == 1);
    return commands->front().body;
}

Order orderOf(const std::string& event) {
    return std::get<GiveOrder>(bodyOf(event)).order;
}

std::string ordersFailure(const std::string& events) {
    const auto commands = parseCommands(events, "M", kOrderStep);
    return commands.ok() ? "" : commands.status().message();
}

bool failsWith(const std::string& events, const std::string& part) {
    const std::string message = ordersFailure(events);
    CAPTURE(message);
    return message.find(part) != std::string::npos;
}

/// A scenario that says all that groups and checkpoints can say of orders and units.
WorldDef unitsDef() {
    WorldDef def;
    GroupDef group{.count = 6};
    const Body pike{0.3, 1.1, 4.0, 2.0, 1.5, 1};
    group.bodies = {pike, pike, pike, pike, Body{}, Body{}};
    group.roles = {{RoleArea::Front, 1}, {RoleArea::Flanks, 2}};
    group.demands = {1, 2, 0.5, 0, 1, 1};
    group.conduct = {Stance::Hold, 0.25, 0.5, true};
    group.orders = {Order::move({3, 4}, 0.5), Order::face(1.0), Order::follow(GroupId{1}, {-3, 0})};
    group.orders[0].route = {{1, 1}, {2, 4}};
    group.patrols = true;
    group.formation.files = 3;
    def.groups = {group};
    def.checkpoints = {{.trigger = CheckpointTrigger::Mesh, .share = 0.9}};
    return def;
}

template <class Part>
std::vector<std::uint8_t> bytesOf(Part part) {
    Writer writer;
    writer(part);
    return writer.take();
}

}  // namespace

TEST_CASE("a move of a touch moves a finger, one of a group is an order") {
    const CommandBody finger = bodyOf(R"({"kind":"move","touch":3,"x":1,"y":2})");
    CHECK(std::get<Touch>(finger).position == Vec2{1, 2});
    const CommandBody body = bodyOf(R"({"kind":"move","group":2,"x":1,"y":2,"mode":"append"})");
    const auto& give = std::get<GiveOrder>(body);
    CHECK(give.group == GroupId{2});
    CHECK(give.mode == QueueMode::Append);
    CHECK(give.order.kind == OrderKind::Move);
    CHECK(give.order.target == Vec2{1, 2});
    CHECK(!give.order.facing);
    CHECK(give.order.manner == Manner::March);
    CHECK(give.order.share == 0.95);
    CHECK(failsWith(R"({"kind":"move","x":1,"y":2})", "M: $[0]: found neither \"touch\" nor \"group\""));
}

TEST_CASE("orders are called by what they ask for") {
    CHECK(orderOf(R"({"kind":"face","group":1,"facing":-2})").facing == -2.0);
    const Order follow = orderOf(R"({"kind":"follow","group":1,"leader":2,"offset":[-3,1]})");
    CHECK(follow.kind == OrderKind::Follow);
    CHECK(follow.group == GroupId{2});
    CHECK(follow.offset == Vec2{-3, 1});
    CHECK(orderOf(R"({"kind":"follow","group":1,"character":9})").character == 9);
    const Order guard = orderOf(R"({"kind":"guard","group":1,"x":5,"y":6,"halfSize":[2,1],
        "path":{"waypoints":[{"t":0},{"t":9,"x":4}]}})");
    CHECK(guard.kind == OrderKind::Guard);
    CHECK(guard.halfSize == Vec2{2, 1});
    CHECK(guard.path.waypoints.size() == 2);
    const Order free = orderOf(R"({"kind":"move","group":1,"x":0,"y":0,"manner":"free","turn":"keep",
        "formation":"wedge","pace":1.25,"share":0.5,"route":[[1,2],[3,4]]})");
    CHECK(free.manner == Manner::Free);
    CHECK(free.turn == Turn::Keep);
    REQUIRE(free.formation);
    CHECK(free.formation->kind == FormationKind::Wedge);
    CHECK(free.pace == 1.25);
    CHECK(free.share == 0.5);
    CHECK(free.route == std::vector<Vec2>{{1, 2}, {3, 4}});
}

TEST_CASE("a leave of a group is an order, one of ids takes characters out") {
    const CommandBody out = bodyOf(R"({"kind":"leave","ids":[3,17]})");
    CHECK(std::get<TransferCharacters>(out).ids.size() == 2);
    const Order leave = orderOf(R"({"kind":"leave","group":1})");
    CHECK(leave.kind == OrderKind::Leave);
    CHECK(leave.exits.empty());
    const Order chosen = orderOf(R"({"kind":"leave","group":1,"exits":[2,5],"choice":"nearest",
        "attractions":[3,-1.5],"herding":4,"misjudgement":2})");
    CHECK(chosen.exits == std::vector{AreaId{2}, AreaId{5}});
    CHECK(chosen.choice == ExitChoice::Nearest);
    CHECK(chosen.attractions == std::vector{3.0, -1.5});
    CHECK(chosen.herding == 4.0);
    CHECK(chosen.misjudgement == 2.0);
    const Order wait = orderOf(R"({"kind":"wait","group":1,"area":3,"seconds":20})");
    CHECK(wait.kind == OrderKind::Wait);
    CHECK(wait.area == AreaId{3});
    CHECK(wait.seconds == 20.0);
    const Order walk = orderOf(R"({"kind":"walk","group":1,"facing":0.5})");
    CHECK(walk.kind == OrderKind::Walk);
    CHECK(walk.facing == 0.5);
    CHECK(failsWith(R"({"kind":"wait","group":1})", "no \"area\""));
    CHECK(failsWith(R"({"kind":"walk","group":1})", "no \"facing\""));
    CHECK(failsWith(R"({"kind":"leave","group":1,"choice":"any"})", "$[0].choice:"));
    CHECK(failsWith(R"({"kind":"leave","group":1,"exits":[1],"attractions":[1,2]})", "2 attractions"));
}

TEST_CASE("a thing is put by one definition") {
    const auto put = std::get<PutThing>(bodyOf(R"({"kind":"putThing","id":4,"item":{"position":[1,2]}})"));
    CHECK(put.id == 4);
    CHECK(put.item->position == Vec2{1, 2});
    CHECK(failsWith(R"({"kind":"putThing","id":4})", "found 0 definitions, expected one"));
    CHECK(failsWith(R"({"kind":"putThing","item":{"position":[1,2]},"obstacle":{"radius":1}})",
                    "found 2 definitions, expected one"));
}

TEST_CASE("an event of a former kind is read as the one that says the same") {
    const CommandBody added = bodyOf(R"({"kind":"area","group":2,"definition":{"kind":"source",
        "polygon":[[0,0],[1,0],[1,1]],"rate":0.5,"timetable":[{"t":3,"count":4}]}})");
    const auto& put = std::get<PutThing>(added);
    CHECK(put.id == 0);
    CHECK(put.group == GroupId{2});
    CHECK(put.area->kind == AreaKind::Source);
    CHECK(put.area->timetable == std::vector{Arrivals{3.0, 4}});
    const CommandBody changed = bodyOf(
        R"({"kind":"area","id":3,"definition":{"kind":"exit","polygon":[[0,0],[1,0],[1,1]],"open":false}})");
    CHECK(std::get<PutThing>(changed).id == 3);
    CHECK_FALSE(std::get<PutThing>(changed).area->open);
    const auto remove = std::get<RemoveThing>(bodyOf(R"({"kind":"removeArea","id":3})"));
    CHECK(remove.thing == ThingKind::Area);
    CHECK(remove.id == 3);
    CHECK(failsWith(R"({"kind":"area","definition":{"kind":"door","polygon":[[0,0],[1,0],[1,1]]}})",
                    "$[0].definition.kind:"));
    CHECK(failsWith(R"({"kind":"area","definition":{"kind":"exit","polygon":[[0,0],[1,0],[1,1]],"group":1}})",
                    "unknown key \"group\""));
}

TEST_CASE("former changes of groups and characters are read as the ones that say the same") {
    const auto change = [](const std::string& event) { return std::get<ChangeGroup>(bodyOf(event)); };
    const ChangeGroup shaped = change(R"({"kind":"formation","group":2,"formation":"wedge"})");
    CHECK(shaped.group == GroupId{2});
    CHECK(shaped.formation->kind == FormationKind::Wedge);
    CHECK_FALSE(shaped.count);
    CHECK(change(R"({"kind":"count","group":2,"count":7})").count == 7);
    CHECK(change(R"({"kind":"conduct","group":2,"stance":"hold"})").conduct->stance == Stance::Hold);
    CHECK(change(R"({"kind":"roles","group":2,"roles":[]})").roles->empty());
    CHECK(change(R"({"kind":"demands","group":2,"demands":[1,2]})").demands == std::vector{1.0, 2.0});
    CHECK(change(R"({"kind":"people","group":2})").people->empty());
    CHECK(change(R"({"kind":"nameGroup","group":2,"name":"Van"})").name == "Van");
    CHECK(change(R"({"kind":"colourGroup","group":2})").colour == GroupColour{});
    CHECK(change(R"({"kind":"appearance","group":2,"build":"narrow"})").look ==
          GroupLook{BodyBuild::Narrow, {}});
    const auto pose = std::get<SetPose>(bodyOf(R"({"kind":"placeGroup","group":2,"x":1,"y":2})"));
    CHECK(pose.characters);
    CHECK_FALSE(std::get<SetPose>(bodyOf(R"({"kind":"pose","group":2,"x":1,"y":2})")).characters);
    const auto driven = std::get<ChangeCharacters>(
        bodyOf(R"({"kind":"driver","ids":[3],"driver":"outside"})"));
    CHECK(driven.driver == Driver::Outside);
    CHECK_FALSE(driven.bodies);
}

TEST_CASE("a change of a group says in files what it gives, also what is empty") {
    const ChangeGroup changes[] = {
        {.group = {2}, .count = 7, .name = ""},
        {.group = {2}, .people = std::vector<PeopleDef>(), .roles = std::vector<RoleDef>()},
        {.group = {2}, .conduct = Conduct{Stance::Hold, 0.5}, .demands = std::vector<double>()},
        {.group = {2}, .colour = GroupColour{}, .look = GroupLook{}},
        {.group = {2},
         .formation = FormationDef{.kind = FormationKind::Ring},
         .colour = GroupColour{0xff8000}},
    };
    for (const ChangeGroup& change : changes) {
        const Command command{0, 1, 0, change};
        const auto read = parseGestures(writeGestures(std::span(&command, 1), 1.0), "M", 1.0);
        REQUIRE(read.ok());
        CHECK(encodeCommand(read->front()) == encodeCommand(command));
    }
    CHECK(failsWith(R"({"kind":"changeGroup","group":2})", "expected one field or more"));
    CHECK(failsWith(R"({"kind":"changeGroup","group":2,"count":0})", "$[0].count:"));
    CHECK(
        failsWith(R"({"kind":"changeGroup","group":2,"conduct":{"stance":"mild"}})", "$[0].conduct.stance:"));
}

TEST_CASE("a drawn line gives place, facing and width") {
    // The left end lies to the left of who looks ahead: a front from (4, 5) to (4, 1) looks along +x.
    const Order line = orderOf(R"({"kind":"move","group":1,"line":[[4,5],[4,1]]})");
    CHECK(line.target == Vec2{4, 3});
    CHECK(line.width == 4.0);
    CHECK(std::fabs(line.facing.value()) < 1e-12);
    const Order north = Order::moveToLine({-1, 0}, {1, 0});
    CHECK(north.facing.value() == doctest::Approx(std::acos(0.0)));
    CHECK(failsWith(R"({"kind":"move","group":1,"line":[[4,5],[4,1]],"x":1})", "unknown key \"x\""));
    CHECK(failsWith(R"({"kind":"move","group":1,"line":[[4,5],[4,5]]})", "$[0].line: found two equal"));
}

TEST_CASE("bodies are listed with their numbers") {
    const CommandBody body = bodyOf(R"({"kind":"bodies","ids":[1,2,3],
        "bodies":[{"count":2,"class":1,"radius":0.4},{"class":2}]})");
    const std::vector<Body> bodies = std::get<ChangeCharacters>(body).bodies.value();
    REQUIRE(bodies.size() == 3);
    CHECK(bodies[1].radius == 0.4);
    CHECK(bodies[1].unitClass == 1);
    CHECK(bodies[2].unitClass == 2);
    CHECK(bodies[2].mass == 1.0);
}

TEST_CASE("errors of orders and units name the field") {
    CHECK(
        failsWith(R"([{"kind":"up","touch":1},{"kind":"move","group":1,"x":1}])", "M: $[1]: found no \"y\""));
    CHECK(failsWith(R"({"kind":"face","group":1})", "no \"facing\""));
    CHECK(failsWith(R"({"kind":"follow","group":1})", "neither a group nor a character"));
    CHECK(failsWith(R"({"kind":"move","group":1,"x":0,"y":0,"manner":"hop"})", "$[0].manner:"));
    CHECK(failsWith(R"({"kind":"move","group":1,"x":0,"y":0,"share":0})", "$[0].share:"));
    CHECK(failsWith(R"({"kind":"queue","group":1,"edit":"drop"})", "$[0].edit:"));
    CHECK(failsWith(R"({"kind":"leave","ids":[1,-2]})", "$[0].ids[1]:"));
    CHECK(failsWith(R"({"kind":"leave","ids":[1,1]})", "id 1 is named twice"));
    CHECK(failsWith(R"({"kind":"leave","ids":[]})", "found 0 ids"));
    CHECK(failsWith(R"({"kind":"split","group":1,"by":"line","points":[[0,0]]})",
                    "M: $[0]: SplitGroup: a line needs"));
    CHECK(failsWith(R"({"kind":"merge","groups":[1]})", "found 1 groups"));
    CHECK(failsWith(R"({"kind":"roles","group":1,"roles":[{"area":"front","class":0}]})",
                    "$[0].roles[0].class:"));
    CHECK(failsWith(R"({"kind":"bodies","ids":[1],"bodies":[{"count":200000},{"count":1}]})",
                    "more than 200000 bodies"));
    CHECK(failsWith(R"({"kind":"bodies","ids":[1],"bodies":[{"radius":0.01}]})", "radius is 0.01"));
    CHECK(failsWith(R"({"kind":"motion","ids":[1],"positions":[[0,0],[1,1]]})", "differ in number"));
    CHECK(failsWith("3", "M: $: found the number 3"));
    CHECK(failsWith("[3]", "M: $[0]: found the number 3"));
    CHECK(failsWith("{", "M:1:"));
}

TEST_CASE("messages need no times, and keep their order") {
    const auto commands = parseCommands(R"([{"kind":"leave","ids":[3]},{"t":1,"kind":"leave","ids":[2]},
        {"kind":"leave","ids":[1]}])",
                                        "M", kOrderStep);
    REQUIRE(commands.ok());
    CHECK(std::get<TransferCharacters>((*commands)[0].body).ids.front() == 3);
    CHECK(std::get<TransferCharacters>((*commands)[1].body).ids.front() == 1);
    CHECK((*commands)[1].step == 0);
    CHECK((*commands)[2].step == 60);
    CHECK(parseCommands("[]", "M", kOrderStep)->empty());
}

TEST_CASE("scenarios carry orders, bodies, roles and conducts, bit for bit") {
    const WorldDef def = unitsDef();
    const std::string text = writeScenario(def);
    CHECK(testing::breaks(testing::Json::parse(scenarioSchema()), testing::Json::parse(text)) == "");
    const auto back = parseScenario(text, "S", "");
    REQUIRE_MESSAGE(back.ok(), back.status().message());
    CHECK(bytesOf(back->groups[0]) == bytesOf(def.groups[0]));
    CHECK(bytesOf(back->checkpoints[0]) == bytesOf(def.checkpoints[0]));
    CHECK(writeScenario(*back) == text);
}

TEST_CASE("a scenario's orders are refused by their path") {
    const auto failure = [](const std::string& group) {
        const auto def = parseScenario(
            R"({"format":"muster-scenario","version":1,"groups":[{"count":4,)" + group + "}]}", "S", "");
        return def.ok() ? "" : def.status().message();
    };
    CHECK(failure(R"("orders":[{"kind":"move","x":1,"y":1}])") == "");
    CHECK(failure(R"("orders":[{"kind":"move","x":1}])").find("S: $.groups[0].orders[0]: found no") == 0);
    CHECK(failure(R"("orders":[{"x":1,"y":1}])").find("found no \"kind\"") != std::string::npos);
    CHECK(failure(R"("bodies":[{"count":3}])").find("found 3 bodies, expected 1 or 4") != std::string::npos);
    CHECK(failure(R"("conduct":{"stance":"flee"})").find("$.groups[0].conduct.stance:") != std::string::npos);
    CHECK(failure(R"("demands":[1,2000])").find("$.groups[0].demands[1]:") != std::string::npos);
    CHECK(failure(R"("formation":{"kind":"square","files":-1})").find("formation.files:") !=
          std::string::npos);
}

TEST_CASE("shipped gestures conform to the schema, and mistakes do not") {
    const testing::Json rules = testing::Json::parse(gesturesSchema());
    const std::string folder = sourceFolder() + "/scenarios/gestures/";
    const testing::Json shipped = testing::Json::parse(*readTextFile(folder + "course.json"));
    CHECK(testing::breaks(rules, shipped) == "");
    for (const char* bad : {R"({"t":1,"kind":"move","group":1,"x":1,"y":1,"manner":"hop"})",
                            R"({"t":1,"kind":"leave","ids":[-1]})", R"({"t":1,"kind":"queue","group":1})",
                            R"({"t":1,"kind":"merge","groups":[1,2],"by":"ids"})"}) {
        CAPTURE(bad);
        testing::Json file = shipped;
        file["events"] = testing::Json::array({testing::Json::parse(bad)});
        CHECK(testing::breaks(rules, file) != "");
    }
}
