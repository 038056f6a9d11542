// Orders and changes of units that clients send, and what frames tell of them.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "generated/random_commands.h"
#include "studio/session/fake_client.h"
#include "studio/session/golden.h"
#include "studio/session/inbox/received_commands.h"

using namespace muster;
using namespace muster::testing;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Result<std::vector<CommandBody>> read(const std::vector<std::uint8_t>& bytes,
                                      const SessionLimits& limits = {}) {
    return readDirections(bytes, limits, [](double time) { return time; });
}

/// The message of what is wrong with commands; empty where nothing is.
std::string wrongWith(const std::vector<std::uint8_t>& bytes, const SessionLimits& limits = {}) {
    return read(bytes, limits).status().message();
}

const EditQueue kHold{GroupId{1}, QueueEdit::Hold, 0};

}  // namespace

TEST_CASE("Commands are read from the bytes that takes have") {
    const auto bytes = commandBytes(
        R"([{"kind":"move","group":1,"x":4,"y":-2,"facing":0.5,"mode":"append","manner":"free"},
            {"kind":"queue","group":1,"edit":"hold"},
            {"kind":"split","group":1,"by":"line","points":[[0,-9],[0,9]]}])");
    const auto bodies = read(bytes);
    REQUIRE(bodies.ok());
    REQUIRE(bodies->size() == 3);
    const auto& give = std::get<GiveOrder>((*bodies)[0]);
    CHECK(give.group == GroupId{1});
    CHECK(give.mode == QueueMode::Append);
    CHECK(give.order.target == Vec2{4, -2});
    CHECK(give.order.facing == 0.5);
    CHECK(std::get<EditQueue>((*bodies)[1]).edit == QueueEdit::Hold);
    CHECK(commandBytes(*bodies) == bytes);
    // In a take, step, client and sequence come before.
    const auto inTake = encodeCommand({7, 2, 9, (*bodies)[1]});
    CHECK(std::vector(inTake.begin() + 12, inTake.end()) == commandBytes((*bodies)[1]));
}

// The page's tests read this file and write it again: both sides agree on each field of each command.
// MUSTER_UPDATE_GOLDEN=1 writes it again.
TEST_CASE("The commands that the page's tests read are what we write, of every kind") {
    CommandDraw draw(39);
    std::vector<CommandBody> bodies;
    for (std::size_t kind = 0; kind < std::variant_size_v<CommandKinds>; ++kind)
        for (int k = 0; k < 4; ++k) bodies.push_back(randomCommand(kind, draw));
    const auto bytes = commandBytes(bodies);
    CHECK(goldenBytes("commands.bin", bytes) == bytes);
}

TEST_CASE("Bad commands are refused with a sentence that says which and why") {
    const std::vector<CommandBody> both{kHold, removeThing(ObstacleId{1})};
    CHECK(has(wrongWith(commandBytes(both)), "commands[1]: found a command of another kind"));
    CHECK(has(wrongWith(commandBytes(Touch{})), "another kind"));
    CHECK(wrongWith({255}) == "commands[0]: command kind 255 is not known");
    auto bytes = commandBytes(kHold);
    bytes.pop_back();
    CHECK(wrongWith(bytes) == "commands[0]: EditQueue command is cut short");
    bytes = commandBytes(kHold);
    bytes.push_back(200);
    CHECK(wrongWith(bytes) == "commands[1]: command kind 200 is not known");
    CHECK(has(wrongWith(commandBytes(EditQueue{GroupId{1}, static_cast<QueueEdit>(77), 0})), "queue edit"));
    CHECK(has(wrongWith(commandBytes(SetPose{GroupId{1}, {1e9, 0}, 0})), "position"));
    CHECK(has(wrongWith(commandBytes(SetPose{GroupId{1}, {0, 0}, std::nan("")})), "angle"));
}

TEST_CASE("Bytes and number of commands have limits") {
    SessionLimits limits;
    limits.commandsPerMessage = 2;
    limits.charactersPerGroup = 1;
    std::vector<CommandBody> holds(2, kHold);
    CHECK(wrongWith(commandBytes(holds), limits).empty());
    holds.push_back(kHold);
    CHECK(has(wrongWith(commandBytes(holds), limits), "more than 2 commands"));
    CHECK(has(wrongWith(commandBytes(AddCharacters{GroupId{1}, {{0, 0}, {2, 0}}, {}}), limits),
              "2 characters"));
    CHECK(has(wrongWith(commandBytes(ChangeGroup{.group = GroupId{1}, .count = 2}), limits), "2 characters"));
    limits.commandBytes = 5;
    CHECK(has(wrongWith(commandBytes(kHold), limits), "bytes"));
}

TEST_CASE("A list of commands that is longer than its message is refused, and so are bytes behind it") {
    Session session = startedSession();
    FakeClient client(session);
    auto bytes = protocol::encode(commandsOf(kHold));
    bytes.push_back(0);
    client.sendBytes(bytes);
    bytes.resize(bytes.size() - 2);
    client.sendBytes(bytes);
    client.poll();
    REQUIRE(client.notices.size() == 2);
    CHECK(client.notices[0].text == "Commands: 1 bytes too many");
    CHECK(client.notices[1].text == "Commands: short or invalid bytes");
}

TEST_CASE("A message of commands steers the world, and a bad one changes nothing") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    client.send(commandsOf(R"([{"kind":"formation","group":1,"formation":"wedge"}])"));
    run(session, 0.1, {&client});
    CHECK(client.meshes.back().formation == "wedge");
    CHECK(client.notices.empty());
    const ChangeGroup shape{.group = {1}, .formation = FormationDef{.kind = FormationKind::Ring}};
    const std::vector<CommandBody> bad{shape, SetPose{GroupId{1}, {0, 0}, 1e9}};
    client.send(protocol::Commands{commandBytes(bad)});
    run(session, 0.1, {&client});
    CHECK(client.meshes.back().formation == "wedge");
    CHECK_FALSE(client.noticed("Commands").empty());
}

TEST_CASE("A group comes by a command, with what its definition says") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const std::size_t before = client.frames.back().groups.size();
    client.send(commandsOf(
        R"([{"kind":"group","definition":{"name":"Visitors","count":5,"formation":{"kind":"line","spacing":1.2},
            "position":[2,3],"bodies":[{"radius":0.3,"maxSpeed":1.5}]}}])"));
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
    CHECK(client.page.orders[0].empty());
    CHECK(client.frames.back().groups[0].way.empty());
    client.send(commandsOf(
        R"([{"kind":"move","group":1,"x":6,"y":-2,"facing":1.5,"width":3},
            {"kind":"move","group":1,"x":-6,"y":2,"route":[[0,5]],"mode":"append","manner":"free","turn":"keep"},
            {"kind":"conduct","group":1,"stance":"yield","cohesion":0.5,"squeeze":0.25,"avoids":true}])"));
    run(session, 0.2, {&client});
    CHECK(client.notices.empty());
    const protocol::GroupFrame& group = client.frames.back().groups[0];
    const std::vector<QueuedOrder> orders = client.page.orders[0];
    REQUIRE(orders.size() == 2);
    CHECK(orders[0].id != orders[1].id);
    const Order& first = orders[0].order;
    const Order& second = orders[1].order;
    CHECK((first.target == Vec2{6, -2} && first.width == 3.0 && first.facing == 1.5));
    CHECK(second.route == std::vector<Vec2>{{0, 5}});
    CHECK((second.manner == Manner::Free && second.turn == Turn::Keep));
    CHECK_FALSE(second.facing);
    CHECK((group.stance == protocol::Stance::Yield && group.avoids));
    CHECK((group.cohesion == 0.5f && group.squeeze == 0.25f));
    REQUIRE(group.way.size() >= 2);
    CHECK(std::abs(group.way[group.way.size() - 2] - 6.0f) < 0.5f);
    client.send(commandsOf(R"([{"kind":"queue","group":1,"edit":"hold"},
                                       {"kind":"queue","group":1,"edit":"patrol"}])"));
    run(session, 0.1, {&client});
    CHECK((client.frames.back().groups[0].held && client.frames.back().groups[0].patrols));
    client.send(commandsOf(R"([{"kind":"queue","group":1,"edit":"stop"}])"));
    run(session, 0.1, {&client});
    CHECK(client.page.orders[0].empty());
}

TEST_CASE("A queue comes in a frame only where the client does not know it") {
    Session session = startedSession();
    FakeClient client(session);
    client.send(commandsOf(R"([{"kind":"move","group":1,"x":60,"y":-2}])"));
    run(session, 0.3, {&client});
    const auto framesWithQueue = [](const FakeClient& one) {
        return std::count_if(one.frames.begin(), one.frames.end(),
                             [](const protocol::Frame& frame) { return frame.groups[0].queued; });
    };
    const auto before = framesWithQueue(client);
    REQUIRE(client.page.orders[0].size() == 1);
    FakeClient late(session);
    run(session, 0.5, {&client, &late});
    CHECK(framesWithQueue(client) == before);
    CHECK(client.frames.back().groups[0].orders.empty());
    CHECK(framesWithQueue(late) == 1);
    CHECK(late.page.orders[0] == client.page.orders[0]);
    client.send(commandsOf(R"([{"kind":"queue","group":1,"edit":"stop"}])"));
    run(session, 0.3, {&client, &late});
    CHECK(framesWithQueue(client) == before + 1);
    CHECK((client.page.orders[0].empty() && late.page.orders[0].empty()));
}

TEST_CASE("A split gives frames another group, with a scene and a mesh before it; a merge takes it away") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const std::size_t scenes = client.scenes.size();
    client.send(commandsOf(R"([{"kind":"split","group":1,"by":"line","points":[[0,-9],[0,9]]}])"));
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
    client.send(commandsOf("[{\"kind\":\"merge\",\"groups\":[1," + std::to_string(part) + "]}]"));
    run(session, 0.2, {&client});
    REQUIRE(client.frames.back().groups.size() == 1);
    CHECK(client.page.ids.size() == 16);
    CHECK(std::count(client.page.group.begin(), client.page.group.end(), 0) == 16);
}
