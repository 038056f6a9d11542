// Making a place: edits by messages, undo, the file, and what can be reached.
#include <doctest.h>

#include <algorithm>
#include <string>

#include "muster/scenario.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr const char* kBox =
    R"({"kind":"obstacle","definition":{"name":"Box","polygon":[[3,-1],[5,-1],[5,1],[3,1]],"height":2}})";

/// A session with one greeted director.
struct Desk {
    Session session = startedSession();
    FakeClient client{session};

    void edit(const std::string& events, const std::string& label = "Edit", std::uint32_t gesture = 0) {
        client.send(edited(label, gesture, "[" + events + "]"));
        settle();
    }
    void edit(const CommandBody& body) {
        client.send(protocol::Edit{"Edit", 0, commandBytes(body), {}});
        settle();
    }
    void undo(bool redo = false) {
        client.send(protocol::UndoEdit{redo});
        settle();
    }
    void settle() { run(session, 0.1, {&client}); }
    const World& world() const { return *session.world(); }
    std::size_t obstacles() const { return world().obstacleIds().size(); }
    ObstacleDef obstacle(std::size_t k) const { return world().obstacle(world().obstacleIds()[k]).def; }
    void restart() {
        client.send(protocol::Playback{protocol::PlaybackAction::Restart});
        settle();
    }
    WorldDef saved() const {
        const auto text = session.scenario();
        REQUIRE(text.ok());
        const auto def = parseScenario(*text, "saved.json", "");
        REQUIRE_MESSAGE(def.ok(), def.status().message());
        return *def;
    }
};

std::uint64_t hashAfter(const WorldDef& def, int steps) {
    auto world = World::create(def);
    REQUIRE_MESSAGE(world.ok(), world.status().message());
    for (int i = 0; i < steps; ++i) world->step();
    return world->hash();
}

}  // namespace

TEST_CASE("an edit adds an obstacle, and undo and redo take it away and back") {
    Desk desk;
    desk.edit(kBox, "Add box");
    REQUIRE(desk.obstacles() == 1);
    CHECK(desk.client.history.undo == 1);
    CHECK(desk.client.history.undoLabel == "Add box");
    CHECK(desk.client.history.edited);
    desk.undo();
    CHECK(desk.obstacles() == 0);
    CHECK(desk.client.history.undo == 0);
    CHECK(desk.client.history.redoLabel == "Add box");
    desk.undo(true);
    REQUIRE(desk.obstacles() == 1);
    CHECK(desk.obstacle(0).name == "Box");
    desk.undo(true);
    CHECK(desk.client.noticed("UndoEdit") == "nothing to do again");
}

TEST_CASE("edits of one gesture are taken back together") {
    Desk desk;
    desk.edit(kBox);
    const std::string id = std::to_string(desk.world().obstacleIds()[0].value);
    for (int k = 1; k <= 5; ++k) {
        const std::string x = std::to_string(k);
        desk.edit(R"({"kind":"changeObstacle","id":)" + id + R"(,"definition":{"centre":[)" + x +
                      R"(,0],"radius":1}})",
                  "Move", 7);
    }
    CHECK(desk.client.history.undo == 2);
    CHECK(desk.obstacle(0).centre.x == 5.0);
    desk.undo();
    CHECK(desk.obstacle(0).name == "Box");
    desk.undo(true);
    CHECK(desk.obstacle(0).centre.x == 5.0);
}

TEST_CASE("two drags in a row are two steps, however fast they follow each other") {
    Desk desk;
    desk.edit(kBox);
    const std::string id = std::to_string(desk.world().obstacleIds()[0].value);
    // Nothing is carried out between them.
    for (const auto& [x, gesture] : {std::pair{1, 7u}, {2, 7u}, {3, 8u}, {4, 8u}})
        desk.client.send(edited("Move", gesture,
                                R"([{"kind":"changeObstacle","id":)" + id + R"(,"definition":{"centre":[)" +
                                    std::to_string(x) + R"(,0],"radius":1}}])"));
    desk.settle();
    CHECK(desk.obstacle(0).centre.x == 4.0);
    CHECK(desk.client.history.undo == 3);
    desk.undo();
    CHECK(desk.obstacle(0).centre.x == 2.0);
    desk.undo();
    CHECK(desk.obstacle(0).name == "Box");
    for (int k = 0; k < 2; ++k) desk.undo(true);
    CHECK(desk.obstacle(0).centre.x == 4.0);
    CHECK(desk.client.noticed("rejected").empty());
}

TEST_CASE("an edit of a drag takes the place of one that still waits") {
    Desk desk;
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    desk.settle();
    const std::uint32_t before = desk.world().stepCount();
    for (int k = 1; k <= 300; ++k)
        desk.client.send(edited(
            "Move", 7,
            R"([{"kind":"placeGroup","group":1,"x":)" + std::to_string(0.01 * k) + R"(,"y":1,"angle":0}])"));
    desk.settle();
    CHECK(desk.world().stepCount() == before + 1);
    CHECK(desk.world().group(0).pose.position.x == doctest::Approx(3.0));
    CHECK(desk.client.history.undo == 1);
    CHECK(desk.client.notices.empty());
}

TEST_CASE("a drag that leads back leaves nothing to take back") {
    Desk desk;
    const Vec2 at = desk.world().group(0).pose.position;
    const auto drag = [&](double x) {
        desk.edit(R"({"kind":"placeGroup","group":1,"x":)" + std::to_string(x) + R"(,"y":)" +
                      std::to_string(at.y) + R"(,"angle":0})",
                  "Move", 7);
    };
    drag(at.x + 1.0);
    CHECK(desk.client.history.undo == 1);
    drag(at.x);
    CHECK(desk.client.history.undo == 0);
    drag(at.x + 2.0);
    CHECK(desk.client.history.undo == 1);
    desk.undo();
    CHECK(desk.world().group(0).pose.position == at);
}

TEST_CASE("what was added and moved in one gesture comes back where it was moved to") {
    Desk desk;
    desk.edit(R"({"kind":"item","definition":{"position":[1,1]}})", "Draw", 9);
    const std::string id = std::to_string(desk.world().itemIds()[0].value);
    desk.edit(R"({"kind":"changeItem","id":)" + id + R"(,"definition":{"position":[2,2]}})", "Draw", 9);
    desk.undo();
    CHECK(desk.world().items().empty());
    desk.undo(true);
    REQUIRE(desk.world().items().size() == 1);
    CHECK(desk.world().items()[0].position == Vec2{2, 2});
    CHECK(desk.client.noticed("rejected").empty());
}

TEST_CASE("people who were taken out by a number come back as they were, also after a new beginning") {
    Desk desk;
    const auto ids = desk.world().characters().id;
    const std::vector<std::uint32_t> before(ids.begin(), ids.end());
    desk.edit(R"({"kind":"bodies","ids":[16],"bodies":[{"mass":3}]})", "Body");
    desk.edit(R"({"kind":"count","group":1,"count":12})", "People");
    CHECK(desk.saved().groups[0].count == 12);
    desk.undo();
    CHECK(desk.world().characters().size() == 16);
    CHECK(desk.world().characters().body[15].mass == 3.0);
    CHECK(desk.saved().groups[0].count == 16);
    desk.undo();  // The body of the last, who has another id now.
    CHECK(desk.world().characters().body[15].mass == 1.0);
    desk.undo(true);
    desk.undo(true);
    CHECK(desk.world().characters().size() == 12);
    desk.restart();
    CHECK(desk.world().characters().size() == 12);
    desk.undo();
    CHECK(desk.world().characters().size() == 16);
    CHECK(desk.saved().groups[0].count == 16);
    CHECK(desk.client.noticed("rejected").empty());
}

TEST_CASE("how a group starts is taken back, whatever was directed meanwhile") {
    Desk desk;
    desk.client.send(commandsOf(R"([{"kind":"formation","group":1,"formation":"ring"}])"));
    desk.settle();
    desk.edit(R"({"kind":"formation","group":1,"formation":"ring"})", "Shape");
    CHECK(desk.saved().groups[0].formation.kind == FormationKind::Ring);
    CHECK(desk.client.history.undoLabel == "Shape");
    desk.undo();
    CHECK(desk.saved().groups[0].formation.kind == FormationKind::Square);
    CHECK(desk.world().group(0).formation == FormationKind::Ring);
    desk.undo();
    CHECK(desk.world().group(0).formation == FormationKind::Square);
}

TEST_CASE("areas come, change, go and come back, and orders follow them into the next beginning") {
    Desk desk;
    const auto area = [](const std::string& kind, const std::string& more = "") {
        return R"({"kind":"area","definition":{"kind":")" + kind + R"(","polygon":[[3,3],[5,3],[5,5]])" +
               more + "}";
    };
    desk.edit(area("exit", R"(,"name":"First")") + "}");
    desk.edit(area("exit", R"(,"name":"Second")") + "}");
    desk.edit(area("source", R"(,"rate":0.5)") + R"(,"group":1})", "Source", 5);
    REQUIRE(desk.world().areaCount() == 3);
    CHECK(desk.world().area(2).group == GroupId{1});
    REQUIRE(desk.client.scenes.back().areas.size() == 3);
    CHECK(desk.client.scenes.back().areas[1].definition.name == "Second");
    CHECK(desk.client.scenes.back().areas[2].group == 1);
    desk.edit(area("source", R"(,"rate":2)") + R"(,"group":1,"id":3})", "Source", 5);
    CHECK(desk.world().area(2).def.rate == 2.0);
    CHECK(desk.client.history.undo == 3);
    desk.edit(R"({"kind":"removeArea","id":1})");
    CHECK(desk.saved().areas.size() == 2);
    CHECK(desk.saved().areas[0].name == "Second");
    desk.restart();
    REQUIRE(desk.world().areaCount() == 2);
    CHECK(desk.world().area(0).id == AreaId{1});
    CHECK(desk.world().area(1).group == GroupId{1});
    desk.undo();
    REQUIRE(desk.world().areaCount() == 3);
    CHECK(desk.world().area(2).def.name == "First");
    desk.undo();
    CHECK(desk.world().areaCount() == 2);
    desk.undo(true);
    CHECK(desk.world().area(2).def.rate == 2.0);
    for (int k = 0; k < 3; ++k) desk.undo();
    CHECK(desk.world().areaCount() == 0);
    CHECK(desk.client.noticed("rejected").empty());
    CHECK(desk.client.noticed("Edit").empty());
}

TEST_CASE("orders of a place name the areas that are left") {
    WorldDef def = smallFloor();
    AreaDef area{.polygon = {{6, 6}, {7, 6}, {7, 7}}};
    def.areas = {area, area, area};
    def.areas[2].kind = AreaKind::Waiting;
    Order leave = Order::leave({AreaId{1}, AreaId{2}});
    leave.attractions = {1.0, 2.0};
    def.groups[0].orders = {leave, Order::wait(AreaId{3}), Order::leave({AreaId{1}})};
    Desk desk;
    REQUIRE(desk.session.load("areas", def).ok());
    desk.settle();
    desk.edit(R"({"kind":"removeArea","id":1})");
    const WorldDef saved = desk.saved();
    const std::vector<Order>& orders = saved.groups[0].orders;
    REQUIRE(orders.size() == 2);
    CHECK(orders[0].exits == std::vector{AreaId{1}});
    CHECK(orders[0].attractions == std::vector{2.0});
    CHECK(orders[1].area == AreaId{2});
    desk.restart();
    desk.edit(R"({"kind":"removeArea","id":2})");
    CHECK(desk.saved().groups[0].orders.size() == 1);
}

TEST_CASE("a paused world makes one step for each edit") {
    Desk desk;
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    desk.settle();
    const std::uint32_t before = desk.world().stepCount();
    desk.edit(kBox);
    desk.edit(R"({"kind":"item","definition":{"position":[1,1]}})");
    desk.undo();
    CHECK(desk.world().stepCount() == before + 3);
    CHECK(desk.obstacles() == 1);
    CHECK(desk.world().items().empty());
}

TEST_CASE("restart begins with the edited place, and undo goes on") {
    Desk desk;
    desk.edit(R"({"kind":"item","definition":{"position":[1,1]}})");
    desk.edit(kBox, "Add box");
    desk.edit(R"({"kind":"removeItem","id":1})");
    desk.edit(R"({"kind":"item","definition":{"position":[2,2]}})");
    desk.restart();
    CHECK(desk.obstacles() == 1);
    REQUIRE(desk.world().items().size() == 1);
    CHECK(desk.world().itemIds()[0].value == 1);
    desk.undo();
    CHECK(desk.world().items().empty());
    desk.undo();
    REQUIRE(desk.world().items().size() == 1);
    CHECK(desk.world().items()[0].position == Vec2{1, 1});
    desk.undo();
    CHECK(desk.obstacles() == 0);
    CHECK(desk.client.noticed("rejected").empty());
}

TEST_CASE("how a group looks is one step of undo, shown in the scene and kept by the place") {
    struct Look {
        std::string kind, first, second;
        CommandBody bad;
        GroupDef firstShown, secondShown;
    };
    const Look looks[] = {{"colourGroup",
                           R"("colour":"#D60EA8")",
                           R"("colour":"#05536d")",
                           ChangeGroup{.group = GroupId{1}, .colour = GroupColour{0x1000000}},
                           {.colour = 0xD60EA8},
                           {.colour = 0x05536D}},
                          {"appearance",
                           R"("build":"narrow","motions":"march")",
                           R"("motions":"weary")",
                           ChangeGroup{.group = GroupId{1}, .look = GroupLook{{}, static_cast<MotionSet>(9)}},
                           {.build = BodyBuild::Narrow, .motions = MotionSet::March},
                           {.motions = MotionSet::Weary}}};
    for (const Look& look : looks) {
        CAPTURE(look.kind);
        Desk desk;
        const auto edit = [&](const std::string& value) {
            desk.edit(R"({"kind":")" + look.kind + R"(","group":1,)" + value + "}", "Look");
        };
        const auto shows = [&](const GroupDef& look) {
            const GroupDef& shown = desk.client.scenes.back().groups[0].definition;
            return shown.colour == look.colour && shown.build == look.build && shown.motions == look.motions;
        };
        const auto kept = [&] {
            const GroupDef saved = desk.saved().groups[0], now = desk.world().groupDef(0);
            return saved.colour == now.colour && saved.build == now.build && saved.motions == now.motions;
        };
        edit(look.first);
        CHECK(shows(look.firstShown));
        CHECK(desk.client.history.undo == 1);
        edit(look.second);
        CHECK(shows(look.secondShown));
        CHECK_FALSE(shows(look.firstShown));
        CHECK(kept());
        desk.restart();
        CHECK(shows(look.secondShown));
        CHECK(kept());
        desk.undo();
        CHECK(shows(look.firstShown));
        desk.undo();
        CHECK_FALSE(shows(look.firstShown));
        CHECK(kept());
        desk.undo(true);
        CHECK(shows(look.firstShown));
        desk.edit(R"({"kind":"removeGroup","group":1})");
        desk.undo();
        CHECK(shows(look.firstShown));
        desk.edit(look.bad);
        CHECK_FALSE(desk.client.noticed("Edit").empty());
        CHECK(desk.client.history.undo == 1);
    }
}

TEST_CASE("sorts of persons are one step of undo, draw who is there, and are kept by the place") {
    Desk desk;
    const auto radii = [&] {
        std::vector<double> all;
        for (const Body& body : desk.world().characters().body) all.push_back(body.radius);
        return all;
    };
    const std::vector<double> before = radii();
    desk.edit(
        R"({"kind":"people","group":1,"people":[{"share":1,"radius":0.3},{"share":1,"radius":0.2,"class":2}]})",
        "Persons");
    CHECK(desk.saved().groups[0].people.size() == 2);
    CHECK(desk.client.scenes.back().groups[0].definition.people == desk.saved().groups[0].people);
    const std::vector<double> mixed = radii();
    const auto broad = std::count(mixed.begin(), mixed.end(), 0.3);
    CHECK(std::abs(2 * broad - std::ssize(mixed)) <= 1);
    desk.restart();
    CHECK(radii() == mixed);
    desk.undo();
    CHECK(desk.saved().groups[0].people.empty());
    CHECK(radii() == before);
    desk.undo(true);
    CHECK(radii() == mixed);
    PeopleDef less;
    less.share = -1.0;
    desk.edit(ChangeGroup{.group = GroupId{1}, .people = std::vector<PeopleDef>{less}});
    CHECK(desk.client.noticed("Edit").find("share") != std::string::npos);
    CHECK(desk.client.history.undo == 1);
}

TEST_CASE("the saved place plays to the hash of the studio") {
    Desk desk;
    desk.edit(kBox);
    desk.edit(
        R"({"kind":"patch","definition":{"name":"Net","polygon":[[-6,-4],[-2,-4],[-2,4],[-6,4]],"motion":3}})");
    desk.edit(
        R"({"kind":"checkpoint","definition":{"position":[8,0],"radius":2,"formation":"wedge"},"group":1})");
    desk.edit(R"({"kind":"group","definition":{"name":"Second","count":9,"position":[-8,-8]}})");
    desk.edit(
        R"({"kind":"placeGroup","group":1,"x":-8,"y":4,"angle":0.5},{"kind":"nameGroup","group":1,"name":"First"})");
    desk.edit(R"({"kind":"colourGroup","group":1,"colour":"#05536d"})");
    desk.edit(R"({"kind":"appearance","group":1,"build":"broad"})");
    desk.edit(R"({"kind":"count","group":1,"count":12})");
    desk.edit(R"({"kind":"parameter","name":"character.maxSpeed","value":2.5})");
    const WorldDef saved = desk.saved();
    REQUIRE(saved.groups.size() == 2);
    CHECK(saved.groups[0].name == "First");
    CHECK(saved.groups[0].count == 12);
    CHECK(saved.groups[0].position == Vec2{-8, 4});
    REQUIRE(saved.checkpoints.size() == 1);
    CHECK(saved.checkpoints[0].group == 0);
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    for (int k = 0; k < 60; ++k) {
        desk.client.send(protocol::Playback{protocol::PlaybackAction::SingleStep});
        desk.settle();
    }
    CHECK(desk.world().stepCount() == 60);
    CHECK(desk.world().hash() == hashAfter(saved, 60));
}

TEST_CASE("an unedited scenario is saved as it was") {
    Desk desk;
    CHECK_FALSE(desk.client.history.edited);
    CHECK(*desk.session.scenario() == writeScenario(smallFloor()));
}

TEST_CASE("a map stays a map while nothing of it is changed") {
    Session session = startedSession();
    const char* text = R"({"format":"muster-scenario","version":1,"box":[[0,0],[16,16]],
        "groups":[{"count":4,"position":[3,3]}],
        "map":{"rows":["........","........","....@@..","....@@..","........","........","........","........"],"metresPerCell":2}})";
    const Status opened = session.openScenario("small map", text);
    if (!opened.ok()) MESSAGE(opened.message());
    REQUIRE(opened.ok());
    CHECK(session.scenarioName() == "smallmap.json");
    FakeClient client(session);
    client.send(
        edited("Add", 0,
               std::string("[") + R"({"kind":"obstacle","definition":{"centre":[3,12],"radius":1}})" + "]"));
    run(session, 0.1, {&client});
    auto saved = parseScenario(*session.scenario(), "saved.json", "");
    REQUIRE(saved.ok());
    CHECK(saved->map.has_value());
    CHECK(saved->obstacles.size() == 1);
    const std::string id = std::to_string(session.world()->obstacleIds()[0].value);
    client.send(edited("Remove", 0, R"([{"kind":"removeObstacle","id":)" + id + "}]"));
    run(session, 0.1, {&client});
    saved = parseScenario(*session.scenario(), "saved.json", "");
    REQUIRE(saved.ok());
    CHECK_FALSE(saved->map.has_value());
    CHECK(saved->obstacles.size() == session.world()->obstacleIds().size());
}

TEST_CASE("takes hold edits and undo, and replay to the same hash") {
    Desk desk;
    desk.edit(kBox);
    desk.edit(R"({"kind":"item","definition":{"position":[1,1]}})");
    desk.undo();
    desk.edit(R"({"kind":"placeGroup","group":1,"x":-6,"y":0})");
    run(desk.session, 1.0, {&desk.client});
    const auto bytes = desk.session.take();
    REQUIRE(bytes.ok());
    const auto take = parseTake(*bytes, "take");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    const auto played = replayTake(*take);
    CHECK_MESSAGE(played.ok(), played.status().message());
}

TEST_CASE("bad edits are answered by one sentence and change nothing") {
    Desk desk;
    const auto refused = [&](const auto& edit) {
        desk.client.notices.clear();
        desk.edit(edit);
        run(desk.session, 1.0, {&desk.client});
        REQUIRE(desk.client.notices.size() == 1);
        return desk.client.notices[0].text;
    };
    CHECK(refused(std::string()).find("at least one") != std::string::npos);
    CHECK(refused(std::string(R"({"kind":"move","group":1,"x":0,"y":0})"))
              .find("expected a change of the place") != std::string::npos);
    CHECK(refused(std::string(R"({"kind":"removeObstacle","id":77})")).find("no obstacle has the id 77") !=
          std::string::npos);
    CHECK(refused(AddItem{{{1, 1}, -1.0}}).find("radius") != std::string::npos);
    CHECK(refused(std::string(R"({"kind":"count","group":1,"count":199999})")).find("characters") !=
          std::string::npos);
    CHECK(refused(
              std::string(
                  R"({"kind":"checkpoint","definition":{"position":[0,0],"formation":"square"},"group":9})"))
              .find("no group has the id 9") != std::string::npos);
    CHECK(
        refused(std::string(
                    R"({"kind":"nameGroup","group":1,"name":"A"},{"kind":"nameGroup","group":1,"name":"B"})"))
            .find("expected each once") != std::string::npos);
    CHECK(desk.client.history.undo == 0);
    CHECK(desk.obstacles() == 0);
    desk.undo();
    CHECK(desk.client.noticed("UndoEdit") == "nothing to take back");
}

TEST_CASE("a bad scenario is refused and the place stays") {
    Desk desk;
    desk.edit(kBox);
    const Status status = desk.session.openScenario("x", "{\"format\": 1}");
    CHECK_FALSE(status.ok());
    CHECK(status.message().find("x.json") == 0);
    CHECK(desk.obstacles() == 1);
    CHECK(desk.client.history.undo == 1);
}

TEST_CASE("the overlay of reach tells what is closed off, and gaps") {
    Desk desk;
    desk.client.send(protocol::SetOverlay{protocol::OverlayKind::Reach, 0});
    desk.settle();
    REQUIRE(desk.client.overlays.size() == 1);
    const auto count = [&](float value) {
        const auto& values = desk.client.overlays.back().values;
        return std::count(values.begin(), values.end(), value);
    };
    CHECK(count(1.0f) == 0);
    CHECK(desk.client.overlays.back().gaps.empty());
    // Four walls round (8, 8), with a gap of 0.2 m at one corner.
    const auto wall = [](const char* polygon) {
        return std::string(R"({"kind":"obstacle","definition":{"polygon":)") + polygon + "}}";
    };
    desk.edit(wall("[[5,5],[11,5],[11,5.5],[5,5.5]]") + "," + wall("[[5,10.5],[11,10.5],[11,11],[5,11]]") +
              "," + wall("[[5,5.7],[5.5,5.7],[5.5,10.5],[5,10.5]]") + "," +
              wall("[[10.5,5.5],[11,5.5],[11,10.5],[10.5,10.5]]"));
    run(desk.session, 0.5, {&desk.client});
    REQUIRE(desk.client.overlays.size() == 2);
    const double cell = desk.client.overlays.back().cell;
    CHECK(static_cast<double>(count(1.0f)) * cell * cell == doctest::Approx(4.5 * 4.5).epsilon(0.25));
    REQUIRE(desk.client.overlays.back().gaps.size() == 3);
    CHECK(desk.client.overlays.back().gaps[2] == doctest::Approx(0.2).epsilon(0.01));
    run(desk.session, 1.0, {&desk.client});
    CHECK(desk.client.overlays.size() == 2);
}
