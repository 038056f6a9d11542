// Paths of the open take, changed afterwards and simulated again.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "studio/session/take_watcher.h"
#include "studio/session/takes/bend_path.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A long floor with one group at its left end.
WorldDef longFloor() {
    return {
        .name = "Long floor", .box = {{-30, -15}, {30, 15}}, .groups = {{.count = 16, .position = {-20, 0}}}};
}

/// A take in which one order leads the group to the right.
std::vector<std::uint8_t> marchTake(double seconds) {
    Session session(sessionDef());
    REQUIRE(session.load("long", longFloor()).ok());
    FakeClient client(session);
    client.send(commandsOf(R"([{"kind":"move","group":1,"x":20,"y":0}])"));
    run(session, seconds, {&client});
    return *session.take();
}

/// A take in which one finger draws the group to the right.
std::vector<std::uint8_t> dragTake(double seconds) {
    Session session(sessionDef());
    REQUIRE(session.load("long", longFloor()).ok());
    FakeClient client(session);
    const int pictures = static_cast<int>(seconds * 60.0);
    for (int i = 0; i < pictures; ++i) {
        const Vec2 at{-20.0 + i / 30.0, 0.0};
        client.touchAt(i == 0 ? TouchPhase::Down : TouchPhase::Move, at, 10.0 + i / 60.0);
        run(session, 1.0 / 60.0, {&client});
    }
    return *session.take();
}

double highest(const std::vector<Vec2>& path) {
    double y = -1e9;
    for (const Vec2 p : path) y = std::max(y, p.y);
    return y;
}

}  // namespace

TEST_CASE("bends are whole at their moment, nothing beyond their reach, and even between") {
    CHECK(bendWeight(0.0, 3.0) == 1.0);
    CHECK(bendWeight(3.0, 3.0) == 0.0);
    CHECK(bendWeight(-4.0, 3.0) == 0.0);
    CHECK(bendWeight(1.5, 3.0) == doctest::Approx(0.5625));
    CHECK(bendWeight(1.5, 3.0) == bendWeight(-1.5, 3.0));
}

TEST_CASE("an ordered group goes by the point to which its path is drawn, and still arrives") {
    Watcher watcher(marchTake(25.0));
    const std::vector<Vec2> before = watcher.path(1);
    REQUIRE(before.size() >= 90);
    CHECK(highest(before) < 1.0);
    // Half way.
    const auto half = std::find_if(before.begin(), before.end(), [](Vec2 p) { return p.x > 0.0; });
    const auto step = static_cast<std::uint32_t>(half - before.begin()) * kPathSpacing;
    watcher.bend({1, 0, step, 0.0, 8.0, 3.0});
    CHECK(watcher.client.notices.empty());
    const std::vector<Vec2> after = watcher.path(1);
    CHECK(highest(after) > 6.0);
    CHECK(distance(after.back(), {20, 0}) < 1.5);
    CHECK(after.size() == before.size());
}

TEST_CASE("a changed take lies on the shelf beside the old one, and replays to its hashes") {
    Watcher watcher(marchTake(12.0));
    REQUIRE(watcher.shelf.takes.empty());
    watcher.bend({1, 0, 240, 0.0, 5.0, 3.0});
    REQUIRE(watcher.shelf.takes.size() == 1);
    REQUIRE(watcher.client.kept.size() == 1);
    CHECK(watcher.client.takes.back().name == watcher.client.kept[0].name);
    CHECK(watcher.client.takes.back().title == "Long floor (changed)");
    const auto take = parseTake(watcher.shelf.takes.begin()->second.bytes, "changed");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->finished);
    CHECK(take->steps() == 720);
    const auto played = replayTake(*take);
    REQUIRE_MESSAGE(played.ok(), played.status().message());
    CHECK(played->compared == 12);
    CHECK(*watcher.session.take() == watcher.shelf.takes.begin()->second.bytes);
}

TEST_CASE("the fingers that draw a group go elsewhere around the moment, and nowhere else") {
    Watcher watcher(dragTake(10.0));
    const std::vector<Vec2> before = watcher.path(1);
    watcher.bend({1, 0, 300, 0.0, 4.0, 2.0});
    CHECK(watcher.client.notices.empty());
    const std::vector<Vec2> after = watcher.path(1);
    REQUIRE(after.size() == before.size());
    CHECK(highest(after) > 1.0);
    for (std::size_t k = 0; k * kPathSpacing < 180; ++k) CHECK(distance(before[k], after[k]) < 1e-6);
}

TEST_CASE("one character is led along its changed path, and the others go on") {
    Watcher watcher(marchTake(16.0));
    const std::vector<Vec2> before = watcher.path(1, 5);
    const std::uint32_t step = 480;
    const Vec2 from = before[step / kPathSpacing];
    watcher.bend({1, 5, step, 0.0, -6.0, 2.0});
    CHECK(watcher.client.notices.empty());
    const std::vector<Vec2> after = watcher.path(1, 5);
    CHECK(distance(after[step / kPathSpacing], from + Vec2{0.0, -6.0}) < 0.5);
    CHECK(distance(after.back(), before.back()) < 3.0);
    const std::vector<Vec2> group = watcher.path(1);
    CHECK(highest(group) < 1.5);
}

TEST_CASE("a path that nothing directs, or that is not there, is left alone with one sentence") {
    Session still(sessionDef());
    REQUIRE(still.load("long", longFloor()).ok());
    FakeClient client(still);
    run(still, 5.0, {&client});
    Watcher watcher(*still.take());
    watcher.bend({1, 0, 100, 0.0, 4.0, 2.0});
    CHECK(watcher.client.noticed("BendPath").find("nothing directs group 1") != std::string::npos);
    watcher.bend({9, 0, 100, 0.0, 4.0, 2.0});
    CHECK(watcher.client.noticed("BendPath").find("group 9 has no path") != std::string::npos);
    watcher.bend({1, 77, 100, 0.0, 4.0, 2.0});
    CHECK(watcher.client.noticed("BendPath").find("character 77 has no path") != std::string::npos);
    watcher.bend({1, 0, 100, 0.0, std::nan(""), 2.0});
    CHECK(watcher.client.noticed("BendPath").find("not finite") != std::string::npos);
    watcher.bend({1, 0, 100, 0.0, 4.0, 0.1});
    CHECK(watcher.client.noticed("BendPath").find("expected 0.5 to 60") != std::string::npos);
    watcher.bend({1, 0, 99999, 0.0, 4.0, 2.0});
    CHECK(watcher.client.noticed("BendPath").find("expected at most 300") != std::string::npos);
    CHECK(watcher.shelf.takes.empty());
    client.send(protocol::BendPath{1, 0, 1, 0, 1, 1});
    CHECK(client.noticed("BendPath").empty());
    client.poll();
    CHECK(client.noticed("BendPath").find("no take is open") != std::string::npos);
}
