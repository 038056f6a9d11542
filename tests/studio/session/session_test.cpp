#include <cmath>
#include "studio/session/fake_client.h"

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/parameter_table.h"
#include "muster/take.h"
#include "muster/views.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE(
    "A client is welcomed, then gets the directors, the scene, the motions, the meshes and a frame, in this "
    "order") {
    Session session = startedSession();
    const std::uint32_t id = session.connect();
    session.receive(id, protocol::encode(protocol::Hello{"me"}));
    std::vector<MessageBytes> messages;
    session.outgoing(id, messages);
    REQUIRE(messages.size() == 6);
    CHECK(messages[0][0] == protocol::Welcome::kNumber);
    CHECK(messages[1][0] == protocol::Directors::kNumber);
    CHECK(messages[2][0] == protocol::Scene::kNumber);
    CHECK(messages[3][0] == protocol::Motions::kNumber);
    CHECK(messages[4][0] == protocol::GroupMesh::kNumber);
    CHECK(messages[5][0] == protocol::Frame::kNumber);
    const auto welcome = std::get<protocol::Welcome>(protocol::decodeServer(messages[0]).value());
    CHECK(welcome.client == id);
    CHECK(welcome.scenarios.size() == 2);
}

TEST_CASE("The scene holds what the page draws") {
    SessionDef def = sessionDef();
    Session session(def);
    WorldDef floor = smallFloor();
    ObstacleDef car{.name = "Car \"A\"",
                    .centre = {5, 5},
                    .radius = 0.8,
                    .path = {.waypoints = {{0, {0, 0}, 0}, {4, {3, 0}, 0}}}};
    floor.obstacles.push_back(car);
    floor.patches.push_back({.name = "Net\xff", .polygon = {{-9, -9}, {-6, -9}, {-6, -6}}, .motion = 3});
    floor.items.push_back({{1, 2}, 0.5});
    REQUIRE(session.load("small", floor).ok());
    FakeClient client(session);
    run(session, 0.5, {&client});
    REQUIRE(client.scenes.size() == 1);
    const protocol::Scene& scene = client.scenes[0];
    CHECK(scene.title == "Small floor");
    CHECK(scene.box.min == Vec2{-12, -12});
    REQUIRE(scene.obstacles.size() == 1);
    CHECK(scene.obstacles[0].definition == car);
    REQUIRE(scene.patches.size() == 1);
    CHECK(scene.patches[0].definition == floor.patches[0]);
    REQUIRE(scene.clips.size() == defaultClipFacts().size());
    CHECK(scene.clips[3].name == defaultClipFacts()[3].name);
    CHECK(scene.clips[3].speed == defaultClipFacts()[3].speed);
    REQUIRE(scene.items.size() == 1);
    CHECK(scene.items[0].definition.position == Vec2{1, 2});
    REQUIRE(scene.groups.size() == 1);
    CHECK(scene.groups[0].count == 16);
    CHECK(scene.groups[0].formation == "square");
    CHECK(scene.groups[0].placed);
    CHECK(scene.parameters.size() == parameterTable().size());
    const auto& moving = client.frames.back().moving;
    REQUIRE(moving.size() == 1);
    // The frame shows the car's position after the last step: 3 m in 4 s.
    CHECK(moving[0].x == doctest::Approx(0.75 * inspect::environment(*session.world()).time()).epsilon(1e-5));
}

TEST_CASE("Frames show the world") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 1.0, {&client});
    const protocol::Frame& frame = client.frames.back();
    const CharactersView characters = session.world()->characters();
    CHECK(frame.step == 60);
    CHECK(frame.time == doctest::Approx(1.0));
    REQUIRE(client.page.x.size() == 16);
    for (std::size_t i = 0; i < 16; ++i) {
        CHECK(std::fabs(client.page.x[i] - characters.position[i].x) < 0.0006);
        CHECK(std::fabs(client.page.y[i] - characters.position[i].y) < 0.0006);
    }
    REQUIRE(frame.groups.size() == 1);
    REQUIRE(client.page.places[0].size() == 32);
    for (std::size_t k = 0; k < 16; ++k) {
        const Vec2 place = session.world()->group(0).placePositions[k];
        CHECK(std::fabs(client.page.places[0][2 * k] - place.x) < 0.006);
        CHECK(std::fabs(client.page.places[0][2 * k + 1] - place.y) < 0.006);
    }
    CHECK(frame.groups[0].vertices.size() == 2 * session.world()->group(0).finalMesh.size());
    // Triangles and boundary refer to these vertices.
    REQUIRE(client.meshes.size() == 1);
    for (const std::uint32_t v : client.meshes[0].triangles) CHECK(2 * v < frame.groups[0].vertices.size());
    std::size_t at = 0;
    while (at < client.meshes[0].boundary.size()) at += 1 + client.meshes[0].boundary[at];
    CHECK(at == client.meshes[0].boundary.size());
    // Ids are sent once.
    CHECK(client.frames[0].ids.size() == 16);
    CHECK(frame.ids.empty());
    CHECK(frame.group.empty());
}

TEST_CASE("A touch reaches the next frame and steers the crowd") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.2, {&client});
    const double page = 1.7e9;
    client.touchAt(TouchPhase::Down, {0.1, 0.1}, page);
    run(session, 1.0 / 60.0, {&client});
    REQUIRE(client.frames.back().groups[0].controls.size() == 1);
    const protocol::ControlFrame& control = client.frames.back().groups[0].controls[0];
    CHECK(control.client == client.id);
    CHECK(control.points.size() == 1);
    CHECK(client.frames.back().touchEcho == page);
    CHECK(session.world()->time() - session.world()->group(0).controls[0].startTime <= 0.05);
    for (int i = 1; i <= 60; ++i) {
        client.touchAt(TouchPhase::Move, {0.1 + 0.05 * i, 0.1}, page + i / 60.0);
        run(session, 1.0 / 60.0, {&client});
    }
    client.touchAt(TouchPhase::Up, {3.1, 0.1}, page + 61 / 60.0);
    run(session, 6.0, {&client});
    double mean = 0.0;
    for (const double x : client.page.x) mean += x / 16.0;
    CHECK(mean == doctest::Approx(3.0).epsilon(0.2));
    CHECK(client.notices.empty());
    CHECK(std::any_of(client.frames.begin(), client.frames.end(), [](const protocol::Frame& one) {
        return std::any_of(one.events.begin(), one.events.end(), [](const protocol::EventFrame& event) {
            return event.kind == EventKind::Arrived;
        });
    }));
}

TEST_CASE("A client that acknowledges nothing gets one frame, then the newest; its memory stays bounded") {
    Session session = startedSession();
    FakeClient stalled(session);
    FakeClient lively(session);
    run(session, 0.1, {&lively});
    stalled.poll(false);
    REQUIRE(stalled.frames.size() == 1);
    for (int i = 0; i < 600; ++i) {
        run(session, 1.0 / 60.0, {&lively});
        stalled.poll(false);
    }
    CHECK(stalled.frames.size() == 1);
    CHECK(lively.frames.size() > 500);
    CHECK(session.world()->stepCount() == 606);
    stalled.send(protocol::FrameAck{stalled.frames[0].frame});
    stalled.poll(false);
    REQUIRE(stalled.frames.size() == 2);
    CHECK(stalled.frames[1].step == 606);
    CHECK(stalled.frames[1].frame == 2);
}

TEST_CASE("Nothing is sent twice while the world does not change") {
    Session session = startedSession();
    FakeClient client(session);
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    run(session, 1.0, {&client});
    CHECK(client.frames.size() == 1);
    CHECK_FALSE(client.frames[0].playing);
    CHECK(session.world()->stepCount() == 0);
}

TEST_CASE("Playback: pause, single step, speed, restart") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.5, {&client});
    CHECK(session.world()->stepCount() == 30);
    client.send(protocol::Playback{protocol::PlaybackAction::SingleStep});
    run(session, 0.5, {&client});
    CHECK(session.world()->stepCount() == 31);
    client.send(protocol::SetSpeed{4.0f});
    client.send(protocol::Playback{protocol::PlaybackAction::Play});
    run(session, 0.5, {&client});
    CHECK(session.world()->stepCount() == doctest::Approx(151).epsilon(0.02));
    CHECK(client.frames.back().speed == 4.0f);
    client.send(protocol::SetSpeed{0.1f});
    const std::uint32_t before = session.world()->stepCount();
    run(session, 1.0, {&client});
    CHECK(session.world()->stepCount() - before >= 5);
    CHECK(session.world()->stepCount() - before <= 7);
    client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    CHECK(session.world()->stepCount() == 0);
    client.poll();
    CHECK(client.frames.back().step == 0);
}

TEST_CASE("Touches of a paused world apply in the next step") {
    Session session = startedSession();
    FakeClient client(session);
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    client.touchAt(TouchPhase::Down, {0, 0}, 100.0);
    run(session, 0.5, {&client});
    CHECK(session.world()->group(0).controls.empty());
    client.send(protocol::Playback{protocol::PlaybackAction::SingleStep});
    run(session, 0.1, {&client});
    CHECK(session.world()->stepCount() == 1);
    CHECK(session.world()->group(0).controls.size() == 1);
}

TEST_CASE("Formation, count and parameters change the world and the scene") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    client.send(shaped(1, FormationKind::Wedge));
    client.send(commandsOf(ChangeGroup{.group = GroupId{1}, .count = 20}));
    client.send(commandsOf(SetParameter{"plan.exponent", 1.0}));
    run(session, 0.2, {&client});
    CHECK(client.meshes.back().formation == "wedge");
    CHECK(client.frames.back().crowd.count == 20);
    CHECK(session.world()->parameters().plan.exponent == 1.0);
    CHECK(client.scenes.back().groups[0].count == 20);
    CHECK(client.scenes.back().revision == client.frames.back().sceneRevision);
    // The new mesh comes before the first frame that uses it, with a new list of ids for the new characters.
    CHECK(client.meshes.back().version == client.frames.back().groups[0].meshVersion);
    CHECK(client.notices.empty());
}

TEST_CASE("A control added by one message, pinned, then removed") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    client.send(commandsOf(AddControl{GroupId{1}, ControlKind::Line, {1, 2}, {{-1.5, 1.5}, {1.5, 1.5}}}));
    run(session, 0.1, {&client});
    REQUIRE(client.frames.back().groups[0].controls.size() == 1);
    const protocol::ControlFrame& made = client.frames.back().groups[0].controls[0];
    CHECK(made.kind == protocol::ControlKind::Line);
    const std::uint32_t id = made.id;
    client.send(commandsOf(EditControl{GroupId{1}, ControlId{id}, ControlEdit::Pin}));
    run(session, 0.1, {&client});
    CHECK(client.frames.back().groups[0].controls[0].pinned);
    client.send(commandsOf(EditControl{GroupId{1}, ControlId{id}, ControlEdit::Remove}));
    run(session, 0.1, {&client});
    CHECK(client.frames.back().groups[0].controls.empty());
    client.send(commandsOf(EditControl{GroupId{1}, ControlId{id}, ControlEdit::Pin}));
    run(session, 0.1, {&client});
    CHECK(client.noticed("rejected").find("control") != std::string::npos);
    CHECK(!client.notices.back().hasPlace);
}

TEST_CASE("What is held already is said so, and who lets go twice hears nothing") {
    Session session = startedSession();
    FakeClient client(session);
    const Vec2 corner = session.world()->group(0).userMesh.front();
    const GroupId group = session.world()->group(0).id;
    client.send(commandsOf(AddControl{group, ControlKind::Point, {1}, {corner}, 0.0}));
    run(session, 0.1, {&client});
    REQUIRE(session.world()->group(0).controls.size() == 1);
    const ControlId control = session.world()->group(0).controls[0].id;
    client.send(commandsOf(AddControl{group, ControlKind::Point, {2}, {corner}, 0.1}));
    run(session, 0.1, {&client});
    CHECK(client.noticed("rejected").find("is held already; let go of it first") != std::string::npos);
    client.notices.clear();
    for (int i = 0; i < 2; ++i) client.send(commandsOf(EditControl{group, control, ControlEdit::Remove}));
    run(session, 0.1, {&client});
    CHECK(session.world()->group(0).controls.empty());
    CHECK(client.notices.empty());
}

TEST_CASE("A notice says where a finger or a control was refused") {
    Session session(sessionDef());
    REQUIRE(session.load("small", smallFloor()).ok());
    FakeClient client(session);
    run(session, 0.1, {&client});
    client.touchAt(TouchPhase::Down, {7.5, -6.0}, 1.0, 1);
    run(session, 0.1, {&client});
    REQUIRE(client.noticed("rejected").find("no formation") != std::string::npos);
    CHECK(client.notices.back().hasPlace);
    CHECK(client.notices.back().x == 7.5f);
    CHECK(client.notices.back().y == -6.0f);

    // A line needs two points.
    client.send(commandsOf(AddControl{GroupId{1}, ControlKind::Line, {2, 3, 4}, {{0, 0}, {1, 1}, {2, 5}}}));
    run(session, 0.1, {&client});
    REQUIRE(client.notices.size() == 2);
    CHECK(client.notices.back().hasPlace);
    CHECK(client.notices.back().x == 1.0f);
    CHECK(client.notices.back().y == 2.0f);
    client.send(protocol::SetSpeed{99.0f});
    client.poll();
    CHECK(client.noticed("SetSpeed") != "");
    CHECK(!client.notices.back().hasPlace);
}

TEST_CASE("Overlays: the field, one character's cost, density; at most five a second") {
    Session session(sessionDef());
    WorldDef floor = smallFloor();
    floor.obstacles.push_back({.centre = {6, 0}, .radius = 1.0});
    REQUIRE(session.load("small", floor).ok());
    FakeClient client(session);
    run(session, 0.5, {&client});
    client.send(protocol::SetOverlay{protocol::OverlayKind::Field, 0});
    run(session, 2.0, {&client});
    CHECK(client.overlays.size() >= 8);
    CHECK(client.overlays.size() <= 11);
    const protocol::Overlay& field = client.overlays.back();
    REQUIRE(field.values.size() == std::size_t{field.width} * field.height);
    const auto at = [](const protocol::Overlay& o, double x, double y) {
        const auto column = static_cast<std::size_t>((x - o.x) / o.cell + 0.5);
        const auto row = static_cast<std::size_t>((y - o.y) / o.cell + 0.5);
        return o.values[row * o.width + column];
    };
    CHECK(at(field, 4.6, 0.0) > 0.2f);
    CHECK(at(field, -9.0, 9.0) == 0.0f);

    client.send(protocol::SetOverlay{protocol::OverlayKind::Cost, 1});
    run(session, 0.5, {&client});
    const protocol::Overlay& cost = client.overlays.back();
    CHECK(cost.kind == protocol::OverlayKind::Cost);
    CHECK(cost.character == 1);
    CHECK(cost.path.size() >= 4);
    CHECK(cost.way >= cost.straight - 1e-3f);

    client.send(protocol::SetOverlay{protocol::OverlayKind::Density, 0});
    run(session, 0.5, {&client});
    CHECK(client.overlays.back().kind == protocol::OverlayKind::Density);
    double people = 0.0;
    for (const float v : client.overlays.back().values) people += v;
    CHECK(people > 1.0);

    client.send(protocol::SetOverlay{protocol::OverlayKind::None, 0});
    const std::size_t before = client.overlays.size();
    run(session, 1.0, {&client});
    CHECK(client.overlays.size() == before);
}

TEST_CASE("A client that leaves lifts its fingers, and the log records it") {
    Session session = startedSession();
    auto client = std::make_unique<FakeClient>(session);
    client->touchAt(TouchPhase::Down, {0, 0}, 1.0);
    run(session, 0.2, {client.get()});
    REQUIRE(session.world()->group(0).controls.size() == 1);
    session.disconnect(client->id);
    run(session, 0.5);
    CHECK(session.world()->group(0).controls.empty());
    const auto bytes = session.take();
    REQUIRE(bytes.ok());
    const auto take = parseTake(bytes.value(), "memory");
    REQUIRE(take.ok());
    CHECK(std::holds_alternative<ReleaseClient>(take->commands.back().body));
}

TEST_CASE(
    "A new scene comes with its meshes and with the ids of its characters, even where both are unchanged") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.5, {&client});
    const std::size_t meshes = client.meshes.size();
    const std::size_t frames = client.frames.size();
    WorldDef same = smallFloor();
    REQUIRE(session.load("again", same).ok());
    run(session, 0.5, {&client});
    REQUIRE(client.scenes.size() == 2);
    CHECK(client.meshes.size() > meshes);
    bool idsSent = false;
    for (std::size_t k = frames; k < client.frames.size(); ++k) {
        if (client.frames[k].sceneRevision != client.scenes[1].revision) continue;
        idsSent = !client.frames[k].ids.empty();
        break;
    }
    CHECK(idsSent);
}

TEST_CASE("Warnings about a scenario are sent on load and to clients that join later, not on restart") {
    WorldDef def = smallFloor();
    for (const double x : {6.0, 7.3}) def.obstacles.push_back({.centre = {x, 6.0}, .radius = 0.5});
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    CHECK(client.noticed("scenario") == "");
    REQUIRE(session.load("narrow", def).ok());
    client.poll();
    CHECK(client.noticed("scenario").find("0.30 m wide") != std::string::npos);
    FakeClient late(session);
    late.poll();
    CHECK(late.noticed("scenario").find("0.30 m wide") != std::string::npos);
    client.notices.clear();
    client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    client.send(protocol::LoadScenario{"small"});
    run(session, 0.1, {&client});
    CHECK(client.noticed("scenario") == "");
}
