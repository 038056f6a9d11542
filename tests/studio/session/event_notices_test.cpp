// The studio says how orders get on.
#include "studio/session/frames/notices.h"

#include <algorithm>

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
    const auto all = said(world, SetPose{blue, {-6, 3}, 0.0});
    REQUIRE(all.size() == 1);
    CHECK(all[0].text == "Blue: everybody is in place.");
    CHECK(all[0].level == protocol::NoticeLevel::Info);
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
