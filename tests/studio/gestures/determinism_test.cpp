// The same inputs give the same world bit for bit, and malformed ones change nothing.
#include <limits>

#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef busy() {
    WorldDef def = floorWith({squareOf(16, {-4, 0}), squareOf(9, {5, 0}, 3.0)});
    for (GroupDef& group : def.groups) group.jitter = 0.1;
    return def;
}

/// Widens, drags, cuts, calls between people and on free ground, joins.
std::uint64_t touched(double dragTo) {
    DrivenWorld driven(busy(), "touch");
    driven.down(1, {-4, -1.5});
    driven.down(2, {-4, 1.5});
    driven.run(0.2);
    driven.glide({{1, {-4, -2.5}}, {2, {-4, 2.5}}}, 0.5);
    driven.up(1);
    driven.up(2);
    driven.draw({driven.positionOf(3), {-4, dragTo}}, 0.5);
    driven.run(0.5);
    driven.draw({{-9, driven.middle().y}, {0, driven.middle().y}}, 0.3);
    driven.tapTwice({6.5, 1.5});
    driven.tapTwice({0, -10});
    driven.run(1.0);
    CHECK(driven.world.groupCount() == 5);  // The halves of the first, the second, and two who were called.
    driven.draw({{-10, -8}, {12, -8}, {12, 10}, {-10, 10}, {-10, -7.8}}, 0.2);
    driven.run(2.0);
    CHECK(driven.world.groupCount() == 1);
    return driven.world.hash();
}

/// Selects, sends, queues, brings back.
std::uint64_t clicked(const char* scheme, Vec2 to) {
    DrivenWorld driven(busy(), scheme);
    driven.draw({{-6, -3}, {5, 3}}, 0.2);
    driven.modifiers.control = true;
    driven.key('1');
    driven.modifiers.control = false;
    driven.button = PointerButton::Right;
    driven.tap(to);
    driven.modifiers.shift = true;
    driven.tap({0, -8});
    driven.modifiers.shift = false;
    driven.run(1.0);
    driven.key('1');
    driven.tap({-3, 9});
    driven.run(3.0);
    CHECK(driven.middle().y > 1.0);
    return driven.world.hash();
}

std::uint64_t dragged(double to) {
    DrivenWorld driven(busy(), "mouse-mesh");
    driven.modifiers.shift = true;
    driven.draw({{-4, -1.5}, {-4, 1.5}}, 0.3);
    driven.modifiers.shift = false;
    driven.draw({{-4, 1.5}, {-3, to}}, 0.5);
    driven.run(2.0);
    driven.key('P');
    driven.run(1.0);
    CHECK(driven.world.group(0).controls.size() == 1);
    return driven.world.hash();
}

}  // namespace

TEST_CASE("The same touches give the same world, others another one") {
    const std::uint64_t hash = touched(5.0);
    CHECK(touched(5.0) == hash);
    CHECK(touched(5.1) != hash);
}

TEST_CASE("The same clicks and keys give the same world, others another one") {
    for (const char* scheme : {"mouse-full-free", "mouse-full-continuum"}) {
        CAPTURE(scheme);
        const std::uint64_t hash = clicked(scheme, {8, 8});
        CHECK(clicked(scheme, {8, 8}) == hash);
        CHECK(clicked(scheme, {8, 7}) != hash);
    }
}

TEST_CASE("The same drags on the mesh give the same world, others another one") {
    const std::uint64_t hash = dragged(4.0);
    CHECK(dragged(4.0) == hash);
    CHECK(dragged(4.2) != hash);
}

TEST_CASE("Inputs that do not move people leave the world as it is without them") {
    DrivenWorld silent(busy(), "touch");
    DrivenWorld tapped(busy(), "touch-no-calls");
    tapped.tapTwice({0, -10});
    tapped.draw({{0, 8}, {2, 8}}, 0.2);
    silent.run(tapped.world.time());
    REQUIRE(silent.world.stepCount() == tapped.world.stepCount());
    CHECK(silent.world.hash() == tapped.world.hash());
}

TEST_CASE("Malformed inputs are refused with a sentence and give no command") {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    DrivenWorld driven(busy(), "touch");
    PointerEvent event{.screen = *driven.view.screenOf(driven.positionOf(1))};
    const auto refusal = [&](const InputEvent& input) {
        const Status status = driven.driver.input(input, driven.world);
        return status.ok() ? std::string() : status.message();
    };
    PointerEvent bad = event;
    bad.screen.x = nothing;
    CHECK(refusal(bad).find("not finite") != std::string::npos);
    bad = event;
    bad.time = nothing;
    CHECK(refusal(bad).find("not finite") != std::string::npos);
    bad = event;
    bad.phase = static_cast<PointerPhase>(9);
    CHECK(refusal(bad).find("unknown kind") != std::string::npos);
    CHECK(refusal(KeyEvent{'A', nothing, {}}).find("not finite") != std::string::npos);
    GroundView flat;
    flat.toScreen.fill(1.0);
    CHECK(refusal(flat).find("cannot be inverted") != std::string::npos);
    std::vector<Command> commands;
    driven.driver.take(driven.world, commands);
    CHECK(commands.empty());
    CHECK(!driven.driver.scheme().busy());
    CHECK(refusal(event).empty());
    driven.driver.take(driven.world, commands);
    CHECK(commands.size() == 1);
}
