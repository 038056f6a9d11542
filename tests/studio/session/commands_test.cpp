// Orders and changes of units that clients send as text, and what frames tell of them.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "studio/session/fake_client.h"
#include "studio/session/inbox/command_text.h"

using namespace muster;
using namespace muster::testing;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The message of what is wrong with a text; empty where nothing is.
std::string wrongWith(const std::string& text, const SessionLimits& limits = {}) {
    return parseCommandText(text, limits).status().message();
}

}  // namespace

TEST_CASE("Commands are read in the words of gesture files") {
    const auto bodies = parseCommandText(
        R"([{"kind":"move","group":1,"x":4,"y":-2,"facing":0.5,"mode":"append","manner":"free"},
            {"kind":"queue","group":1,"edit":"hold"},
            {"kind":"split","group":1,"by":"line","points":[[0,-9],[0,9]]}])",
        {});
    REQUIRE(bodies.ok());
    REQUIRE(bodies->size() == 3);
    const auto& give = std::get<GiveOrder>((*bodies)[0]);
    CHECK(give.group == GroupId{1});
    CHECK(give.mode == QueueMode::Append);
    CHECK(give.order.kind == OrderKind::Move);
    CHECK(give.order.target == Vec2{4, -2});
    CHECK(give.order.facing == 0.5);
    CHECK(give.order.manner == Manner::Free);
    CHECK(std::get<EditQueue>((*bodies)[1]).edit == QueueEdit::Hold);
    CHECK(std::get<SplitGroup>((*bodies)[2]).points.size() == 2);
}

TEST_CASE("What is no order is refused with a sentence that names it") {
    CHECK(has(wrongWith("[{"), "commands"));
    CHECK(has(wrongWith(R"([{"kind":"dance","group":1}])"), "dance"));
    CHECK(has(wrongWith(R"([{"kind":"queue","group":1,"edit":"hold"},{"kind":"removeObstacle","id":1}])"),
              "$[1]"));
    CHECK(has(wrongWith(R"([{"kind":"parameter","name":"plan.exponent","value":1}])"), "another kind"));
    CHECK_FALSE(wrongWith(R"([{"kind":"move","group":1,"x":"far","y":0}])").empty());
    CHECK_FALSE(wrongWith(R"([{"kind":"move","group":1,"x":1e400,"y":0}])").empty());
}

TEST_CASE("Text and number of commands have limits") {
    SessionLimits limits{.charactersPerGroup = 1, .commandsPerMessage = 2};
    const std::string hold = R"({"kind":"queue","group":1,"edit":"hold"})";
    CHECK(wrongWith("[" + hold + "," + hold + "]", limits).empty());
    CHECK(has(wrongWith("[" + hold + "," + hold + "," + hold + "]", limits), "3 commands"));
    CHECK(has(wrongWith(R"([{"kind":"join","group":1,"positions":[[0,0],[2,0]]}])", limits), "2 characters"));
    CHECK(has(wrongWith(R"([{"kind":"group","definition":{"count":2}}])", limits), "2 characters"));
    limits.commandBytes = 10;
    CHECK(has(wrongWith("[" + hold + "]", limits), "bytes"));
}

TEST_CASE("A message of commands steers the world, and a bad one changes nothing") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    client.send(protocol::Commands{R"([{"kind":"formation","group":1,"formation":"wedge"}])"});
    run(session, 0.1, {&client});
    CHECK(client.meshes.back().formation == "wedge");
    CHECK(client.notices.empty());
    client.send(protocol::Commands{R"([{"kind":"formation","group":1,"formation":"ring"},{"kind":"pin"}])"});
    run(session, 0.1, {&client});
    CHECK(client.meshes.back().formation == "wedge");
    CHECK_FALSE(client.noticed("Commands").empty());
}

TEST_CASE("A group comes by a command, with what its definition says") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const std::size_t before = client.frames.back().groups.size();
    client.send(protocol::Commands{
        R"([{"kind":"group","definition":{"name":"Visitors","count":5,"formation":{"kind":"line","spacing":1.2},
            "position":[2,3],"bodies":[{"radius":0.3,"maxSpeed":1.5}]}}])"});
    run(session, 0.1, {&client});
    CHECK(client.notices.empty());
    CHECK(client.frames.back().groups.size() == before + 1);
    CHECK(client.meshes.back().formation == "line");
}

TEST_CASE("Classes and radii come with the ids, and only where somebody has other ones") {
    Session session = startedSession();
    FakeClient plain(session);
    run(session, 0.1, {&plain});
    for (const protocol::Frame& frame : plain.frames)
        CHECK((frame.unitClass.empty() && frame.radius.empty()));
    WorldDef def = smallFloor();
    def.groups[0].bodies.resize(16);
    def.groups[0].bodies[3].unitClass = 2;
    def.groups[0].bodies[5].radius = 0.4;
    REQUIRE(session.load("small", def).ok());
    run(session, 0.1, {&plain});
    const auto known = std::find_if(plain.frames.rbegin(), plain.frames.rend(),
                                    [](const protocol::Frame& frame) { return !frame.ids.empty(); });
    REQUIRE(known != plain.frames.rend());
    REQUIRE(known->unitClass.size() == 16);
    CHECK(known->unitClass[3] == 2);
    CHECK(std::count(known->unitClass.begin(), known->unitClass.end(), 0) == 15);
    REQUIRE(known->radius.size() == 16);
    CHECK(known->radius[5] == 40);
    const double usual = session.world()->parameters().character.radius;
    CHECK(known->radius[0] == static_cast<int>(100.0 * usual + 0.5));
    CHECK(plain.frames.back().ids.empty());
    CHECK(plain.frames.back().unitClass.empty());
}

TEST_CASE("A mesh comes with its shape at rest: its places lie where the formation has them") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const protocol::GroupMesh& mesh = client.meshes.back();
    const protocol::GroupFrame& group = client.frames.back().groups[0];
    CHECK(mesh.spacing == 1.0f);
    REQUIRE(mesh.rest.size() == group.vertices.size());
    // Nothing has deformed it yet, and it faces x: the rest shape, moved to its centre, is the mesh.
    for (std::size_t i = 0; i < mesh.rest.size(); i += 2) {
        CHECK(std::abs(mesh.rest[i] + group.x - group.vertices[i]) < 1e-4f);
        CHECK(std::abs(mesh.rest[i + 1] + group.y - group.vertices[i + 1]) < 1e-4f);
    }
    CHECK(group.facing == 0.0f);
}

TEST_CASE("A queue comes to the page as it was given, with the way and the conduct") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    CHECK(client.frames.back().groups[0].orders.empty());
    CHECK(client.frames.back().groups[0].way.empty());
    client.send(protocol::Commands{
        R"([{"kind":"move","group":1,"x":6,"y":-2,"facing":1.5,"width":3},
            {"kind":"move","group":1,"x":-6,"y":2,"route":[[0,5]],"mode":"append","manner":"free","turn":"keep"},
            {"kind":"conduct","group":1,"stance":"yield","cohesion":0.5,"squeeze":0.25,"avoids":true}])"});
    run(session, 0.2, {&client});
    CHECK(client.notices.empty());
    const protocol::GroupFrame& group = client.frames.back().groups[0];
    REQUIRE(group.orders.size() == 2);
    const protocol::OrderFrame& first = group.orders[0];
    const protocol::OrderFrame& second = group.orders[1];
    CHECK(first.id != second.id);
    CHECK((first.x == 6.0f && first.y == -2.0f && first.width == 3.0f));
    CHECK((first.hasFacing && first.facing == 1.5f));
    CHECK(second.route == std::vector<float>{0.0f, 5.0f});
    CHECK((second.manner == protocol::Manner::Free && second.turn == protocol::Turn::Keep));
    CHECK_FALSE(second.hasFacing);
    CHECK((group.stance == protocol::Stance::Yield && group.avoids));
    CHECK((group.cohesion == 0.5f && group.squeeze == 0.25f));
    REQUIRE(group.way.size() >= 2);
    CHECK(std::abs(group.way[group.way.size() - 2] - 6.0f) < 0.5f);
    client.send(protocol::Commands{R"([{"kind":"queue","group":1,"edit":"hold"},
                                       {"kind":"queue","group":1,"edit":"patrol"}])"});
    run(session, 0.1, {&client});
    CHECK((client.frames.back().groups[0].held && client.frames.back().groups[0].patrols));
    client.send(protocol::Commands{R"([{"kind":"queue","group":1,"edit":"stop"}])"});
    run(session, 0.1, {&client});
    CHECK(client.frames.back().groups[0].orders.empty());
}

TEST_CASE("A split gives frames another group, with a scene and a mesh before it; a merge takes it away") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const std::size_t scenes = client.scenes.size();
    client.send(protocol::Commands{R"([{"kind":"split","group":1,"by":"line","points":[[0,-9],[0,9]]}])"});
    run(session, 0.2, {&client});
    CHECK(client.notices.empty());
    REQUIRE(client.frames.back().groups.size() == 2);
    CHECK(client.scenes.size() > scenes);
    const std::uint32_t part = client.frames.back().groups[1].id;
    CHECK(client.meshes.back().group == part);
    CHECK(std::count(client.page.group.begin(), client.page.group.end(), 1) == 8);
    // Those to the left of a line to the north stood in the west.
    for (std::size_t i = 0; i < client.page.ids.size(); ++i)
        CHECK((client.page.group[i] == 1) == (client.page.x[i] < 0.0));
    bool added = false;
    for (const protocol::Frame& frame : client.frames)
        for (const protocol::EventFrame& event : frame.events)
            added |= event.kind == protocol::EventKind::GroupAdded && event.subject == part &&
                     event.value == 1;
    CHECK(added);
    client.send(protocol::Commands{"[{\"kind\":\"merge\",\"groups\":[1," + std::to_string(part) + "]}]"});
    run(session, 0.2, {&client});
    REQUIRE(client.frames.back().groups.size() == 1);
    CHECK(client.page.ids.size() == 16);
    CHECK(std::count(client.page.group.begin(), client.page.group.end(), 0) == 16);
}
