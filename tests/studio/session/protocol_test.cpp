#include <doctest.h>

#include <cstdio>
#include <cstdlib>

#include "base/token_bucket.h"
#include "studio/session/fake_client.h"
#include "studio/session/golden.h"
#include "studio/session/inbox/pacer.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/inbox/touch_clock.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::string hex(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        char pair[3];
        std::snprintf(pair, sizeof pair, "%02x", byte);
        text += pair;
    }
    return text;
}

protocol::Frame sampleFrame() {
    protocol::Frame frame{.frame = 7,
                          .step = 42,
                          .time = 0.7,
                          .playing = true,
                          .speed = 1.0f,
                          .recordedSeconds = -1.0f,
                          .demonstrating = true,
                          .sceneRevision = 3,
                          .ids = {1, 2},
                          .group = {0, 1}};
    protocol::CrowdFrame& crowd = frame.crowd;
    crowd.count = 2;
    crowd.x0 = -32.5;
    crowd.y0 = 16.0;
    crowd.quantum = 0.0009765625f;
    crowd.stepX = {-128, 127};
    crowd.stepY = {0, -1};
    crowd.jumped = {1};
    crowd.jumpedX = {65535};
    crowd.jumpedY = {258};
    crowd.heading = {0, 200};
    crowd.headingFine = {7, 0};
    crowd.changed = {0};
    crowd.clip = {5};
    crowd.phase = {0, 255};
    crowd.phaseFine = {1, 128};
    crowd.near = {1};
    crowd.nearPlaces = {0.5f, -1.25f, 3.0f};
    crowd.nearPoses = {950, -3, -32767};
    protocol::GroupFrame& group = frame.groups.emplace_back();
    group.id = 1;
    group.vertices = {0, 0, 1, 0, 0, 1};
    group.walkSum = 12.5f;
    group.moved = {2};
    group.offsets = {-40, 300};
    group.unfit = {2};
    group.standings = {14, 0, 2};
    protocol::ControlFrame& control = group.controls.emplace_back();
    control.kind = protocol::ControlKind::Area;
    control.points.push_back({9, true, 1.0f, 2.0f, {3.0f, 4.0f}});
    frame.areas.push_back({3, 70000, 2});
    frame.moving.push_back({protocol::MovingKind::Patch, 2, 0.1f, 0.2f, 0.3f});
    group.queued = true;
    group.orders.push_back({4, Order::guard({0, 0}, {2, 1}, 1.5)});
    group.orders[0].order.route = {{1, -2}};
    group.orders[0].order.formation.emplace().kind = FormationKind::Wedge;
    group.way = {0.5f, 0.25f};
    group.held = true;
    group.stance = protocol::Stance::Yield;
    group.squeeze = 0.5f;
    frame.unitClass = {0, 3};
    frame.radius = {25, 60};
    frame.events.push_back({protocol::EventKind::Collect, 1, 2, 0.0f, 0.0f});
    return frame;
}

}  // namespace

TEST_CASE("Bytes on the wire are those the protocol promises") {
    // Written by hand from docs/protocol.md: number, then fields, little-endian.
    CHECK(hex(protocol::encode(protocol::Hello{"ab"})) == "00020000006162");
    protocol::Touches touches;
    touches.events.push_back({TouchPhase::Up, 258, 1.0, -2.0, 0.5, 3});
    CHECK(hex(protocol::encode(touches)) ==
          "01"
          "01000000"
          "02"
          "02010000"
          "000000000000f03f"
          "00000000000000c0"
          "000000000000e03f"
          "03000000");
    // The length of the commands, the number of the kind, and its fields.
    CHECK(hex(protocol::encode(commandsOf(EditControl{GroupId{1}, ControlId{2}, ControlEdit::Pin}))) ==
          "07"
          "0a000000"
          "34"
          "01000000"
          "02000000"
          "00");
    CHECK(hex(protocol::encode(protocol::SetSpeed{0.5f})) == "030000003f");
    CHECK(hex(protocol::encode(protocol::Pong{1.0})) == "07000000000000f03f");
}

TEST_CASE("A frame is the same after encoding and decoding") {
    const protocol::Frame sent = sampleFrame();
    const auto bytes = protocol::encode(sent);
    const auto message = protocol::decodeServer(bytes);
    REQUIRE(message.ok());
    const auto& frame = std::get<protocol::Frame>(message.value());
    CHECK(frame.ids == sent.ids);
    CHECK(frame.crowd.stepX == sent.crowd.stepX);
    CHECK(frame.crowd.jumpedX == sent.crowd.jumpedX);
    CHECK(frame.groups[0].offsets == sent.groups[0].offsets);
    CHECK(frame.groups[0].controls[0].points[0].path == sent.groups[0].controls[0].points[0].path);
    CHECK(frame.groups[0].controls[0].kind == protocol::ControlKind::Area);
    CHECK(frame.groups[0].orders[0].order.kind == OrderKind::Guard);
    CHECK(frame.groups[0].orders[0].order.route == sent.groups[0].orders[0].order.route);
    CHECK(frame.groups[0].stance == protocol::Stance::Yield);
    CHECK(frame.radius == sent.radius);
    CHECK(frame.moving[0].id == 2);
    CHECK(protocol::encode(frame) == bytes);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK_FALSE(protocol::decodeServer(std::span(bytes).first(length)).ok());
}

// The page's tests decode this file, so both sides agree on every kind of field. MUSTER_UPDATE_GOLDEN=1
// writes it again.
TEST_CASE("The frame that the page's tests read is what we write") {
    const auto bytes = protocol::encode(sampleFrame());
    CHECK(goldenBytes("frame.bin", bytes) == bytes);
}

TEST_CASE("The generated files are those that the declarations make") {
    if (std::system("node --version >/dev/null 2>&1") != 0) {
        MESSAGE("skipped: node is missing");
        return;
    }
    const std::string command = "node '" + sourceFolder() + "/schema/generate.mjs' --check";
    CHECK(std::system(command.c_str()) == 0);
}

TEST_CASE("Token bucket: burst, refill, edge") {
    TokenBucket bucket(10.0, 3.0);
    CHECK(bucket.take(0.0, 3.0));
    CHECK_FALSE(bucket.take(0.0));
    CHECK_FALSE(bucket.take(0.09));
    CHECK(bucket.take(0.1000001));
    CHECK_FALSE(bucket.take(100.0, 4.0));  // The bucket never holds more than the burst.
    CHECK(bucket.take(100.0, 3.0));
}

TEST_CASE("Pacer: real time at every speed, no growing backlog") {
    const double step = 1.0 / 60.0;
    for (const double speed : {0.1, 0.5, 1.0, 3.0, 8.0}) {
        Pacer pacer;
        int steps = 0;
        for (int look = 0; look < 1200; ++look) {  // Ten seconds at 120 updates per second.
            pacer.elapse(1.0 / 120.0, speed, step);
            for (; pacer.due(step, false); ++steps) pacer.pay(step);
        }
        CHECK(std::abs(steps - 600.0 * speed) <= 1.0);
    }
    Pacer late;
    late.elapse(10.0, 1.0, step);
    int steps = 0;
    for (; late.due(step, false); ++steps) late.pay(step);
    CHECK(steps == 2);
    CHECK(late.until(1.0, step, false) == doctest::Approx(step));
    CHECK(late.until(2.0, step, false) == doctest::Approx(step / 2));
}

TEST_CASE("Touch clock: offset, order, bounds, pause") {
    TouchClock clock;
    const double epoch = 1.7e9;
    // The first message sets the offset.
    CHECK(clock.stamp(epoch, 5.0, 3.0, 1.0) == 3.0);
    // This message travelled 10 ms longer.
    CHECK(clock.stamp(epoch + 0.1, 5.11, 3.11, 1.0) == doctest::Approx(3.1));
    CHECK(clock.stamp(epoch + 0.05, 5.12, 3.12, 1.0) == doctest::Approx(3.1));  // Stamps never decrease.
    CHECK(clock.stamp(epoch + 0.2, 5.15, 3.15, 1.0) ==
          // This message travelled faster than the first; its stamp is not in the future.
          doctest::Approx(3.15));
    CHECK(clock.stamp(epoch + 0.25, 5.2, 3.2, 1.0) ==
          doctest::Approx(3.2));                               // The offset is more precise now.
    CHECK(clock.stamp(epoch + 0.3, 15.0, 13.0, 1.0) == 12.5);  // A stamp is at most half a second old.
    // While paused the stamp is the present time.
    CHECK(clock.stamp(epoch + 20.0, 25.2, 13.0, 0.0) == 13.0);
    clock.restart();
    CHECK(clock.stamp(epoch + 30.0, 34.96, 0.25, 1.0) == doctest::Approx(0.24));
}
