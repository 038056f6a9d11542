// The studio says how orders get on.
#include "studio/session/frames/notices.h"

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/standings.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A floor of 24 m with a wall from edge to edge, and 16 characters on its left.
WorldDef walledFloor() {
    WorldDef def = smallFloor();
    def.obstacles = {{.polygon = {{-0.5, -12}, {0.5, -12}, {0.5, 12}, {-0.5, 12}}}};
    def.groups[0].name = "Blue";
    def.groups[0].position = {-6, 0};
    return def;
}

/// What is said after an order, in ten seconds.
std::vector<EventNotice> said(World& world, const CommandBody& body) {
    REQUIRE(world.submit({world.stepCount(), 1, world.stepCount(), body}).ok());
    std::vector<EventNotice> notices;
    for (int s = 0; s < 600; ++s) {
        world.step();
        appendNotices(world, notices);
    }
    return notices;
}

}  // namespace

TEST_CASE("one sentence per group and kind names the group and the number") {
    World world = World::create(walledFloor()).value();
    const GroupId blue = world.group(0).id;
    const auto none = said(world, SetPose{blue, {6, 0}, 0.0});
    REQUIRE(!none.empty());
    CHECK(none[0].code == "noPath");
    CHECK(none[0].text == "Blue: there is no way to any of the places.");
    CHECK(none[0].level == protocol::NoticeLevel::Warning);
    CHECK(distance(none[0].position, {6, 0}) < 0.2);
    const auto some = said(world, SetPose{blue, {0, 0}, 0.0});
    REQUIRE(!some.empty());
    CHECK(some[0].text == "Blue: 8 of 16 places cannot be reached.");
    CHECK(said(world, SetPose{blue, {-6, 3}, 0.0}).empty());  // Of arrivals frames tell.
}

TEST_CASE("clients get each notice once, with the place") {
    Session session(sessionDef());
    WorldDef def = walledFloor();
    REQUIRE(session.load("walled", def).ok());
    FakeClient client(session);
    FakeClient other(session);
    run(session, 0.5, {&client, &other});
    client.touchAt(TouchPhase::Down, {-6, 0}, 0.5);
    run(session, 0.2, {&client, &other});
    client.touchAt(TouchPhase::Move, {6, 0}, 0.7);
    run(session, 12.0, {&client, &other});
    for (const FakeClient* each : {&client, &other}) {
        CHECK(each->noticed("noPath") == "Blue: there is no way to any of the places.");
        const auto count = std::count_if(each->notices.begin(), each->notices.end(),
                                         [](const protocol::Notice& one) { return one.code == "noPath"; });
        CHECK(count == 1);
    }
    for (const protocol::Notice& one : client.notices)
        if (one.code == "noPath") {
            CHECK(one.hasPlace);
            CHECK(one.x > 0.0f);
        }
}

TEST_CASE("who stands beside a place outside the ground is announced, once for each order") {
    Session session(sessionDef());
    WorldDef def = smallFloor();
    def.groups[0].name = "Blue";
    REQUIRE(session.load("floor", def).ok());
    FakeClient client(session);
    run(session, 3.0, {&client});
    CHECK(client.notices.empty());
    const auto barred = [&] {
        return std::count_if(client.notices.begin(), client.notices.end(),
                             [](const protocol::Notice& one) { return one.code == "standing"; });
    };
    for (const int times : {1, 2}) {
        client.send(commandsOf(SetPose{session.world()->group(0).id, {-6, 0}, 0.0}));
        run(session, 10.0, {&client});
        client.send(commandsOf(SetPose{session.world()->group(0).id, {12, 0}, 0.0}));
        run(session, 20.0, {&client});
        CHECK(barred() == times);
        CHECK(client.noticed("standing").find("in place.") != std::string::npos);
        CHECK(client.noticed("standing").find(" outside the ground") != std::string::npos);
        CHECK(client.noticed("arrived").empty());
    }
    client.send(protocol::AskStandings{5});
    client.poll();
    REQUIRE(client.standings.size() == 1);
    CHECK(client.standings[0].number == 5);
    const auto& frame = client.frames.back().groups[0];
    const StandingCounts counts = countStandings(*session.world())[0];
    CHECK(client.standings[0].people.size() == barredOf(counts));
    CHECK(frame.standings.size() <= counts.size());
    for (const protocol::StandingFrame& one : client.standings[0].people)
        if (one.standing == Standing::Outside) CHECK(one.x > 12.0f);
}

TEST_CASE("a formation that a finger holds beyond the edge is announced when the finger lifts") {
    Session session(sessionDef());
    REQUIRE(session.load("floor", smallFloor()).ok());
    FakeClient client(session);
    run(session, 1.0, {&client});
    const Vec2 middle = session.world()->group(0).pose.position;
    client.touchAt(TouchPhase::Down, middle, 1.0);
    for (int k = 1; k <= 20; ++k) {
        client.touchAt(TouchPhase::Move, middle + Vec2{1.0 * k, 0}, 1.0 + 0.1 * k);
        run(session, 0.1, {&client});
    }
    run(session, 15.0, {&client});
    CHECK(client.noticed("standing").empty());
    client.touchAt(TouchPhase::Up, middle + Vec2{20, 0}, 20.0);
    run(session, 15.0, {&client});
    CHECK(client.noticed("standing").find(" outside the ground") != std::string::npos);
}

TEST_CASE("people inside a wall that is built over them are announced, and walk out") {
    Session session(sessionDef());
    REQUIRE(session.load("floor", smallFloor()).ok());
    FakeClient client(session);
    run(session, 1.0, {&client});
    const Vec2 middle = session.world()->group(0).pose.position;
    const Vec2 low = middle - Vec2{2.0, 2.0}, high = middle + Vec2{2.0, 2.0};
    const PutThing wall{.obstacle = ObstacleDef{.polygon = {low, {high.x, low.y}, high, {low.x, high.y}}}};
    client.send(protocol::Edit{"Wall", 0, commandBytes(CommandBody(wall)), {}});
    run(session, 0.5, {&client});
    CHECK(client.noticed("buried").find(" inside an obstacle; they walk out.") != std::string::npos);
    run(session, 6.0, {&client});
    for (const Vec2 p : session.world()->characters().position)
        CHECK(inspect::environment(*session.world()).distanceToObstacle(p) > 0.0);
}
