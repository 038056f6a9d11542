// Time stamps and parameters on their path from a client to the world.
#include <doctest.h>

#include "muster/views.h"
#include "studio/session/fake_client.h"
#include "studio/session/inbox/touch_clock.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("While paused, stamps advance with real time; when the world runs again, they are world time") {
    TouchClock clock;
    CHECK(clock.stamp(100.0, 5.0, 3.0, 1.0) == 3.0);
    CHECK(clock.stamp(101.0, 6.0, 4.0, 0.0) == 4.0);  // The world is paused.
    CHECK(clock.stamp(103.5, 8.5, 4.0, 0.0) == 6.5);
    CHECK(clock.stamp(103.6, 8.6, 4.0, 0.0) == doctest::Approx(6.6));
    CHECK(clock.stamp(104.0, 9.0, 4.1, 1.0) == doctest::Approx(4.1));
    CHECK(clock.stamp(105.0, 10.0, 4.2, 0.0) == doctest::Approx(4.2));  // The world is paused again.
}

TEST_CASE("Fingers set down seconds apart on a paused world make no line; set down together they do") {
    for (const double later : {0.05, 3.0}) {
        Session session = startedSession();
        FakeClient client(session);
        run(session, 0.2, {&client});
        client.send(protocol::Playback{protocol::PlaybackAction::Pause});
        client.touchAt(TouchPhase::Down, {1, 1}, 100.0, 1);
        run(session, later, {&client});
        client.touchAt(TouchPhase::Down, {-1, -1}, 100.0 + later, 2);
        client.send(protocol::Playback{protocol::PlaybackAction::Play});
        run(session, 0.1, {&client});
        const auto controls = session.world()->group(0).controls;
        CAPTURE(later);
        REQUIRE(controls.size() == (later < 0.15 ? 1 : 2));
        CHECK(controls[0].kind == (later < 0.15 ? ControlKind::Line : ControlKind::Point));
    }
}

TEST_CASE("Parameters that contradict each other are refused with a notice") {
    Session session = startedSession();
    FakeClient client(session);
    client.send(commandsOf(SetParameter{"cost.alpha", 0.0}));
    run(session, 0.1, {&client});
    CHECK(client.notices.empty());
    client.send(commandsOf(SetParameter{"cost.beta", 0.0}));
    run(session, 0.1, {&client});
    CHECK(client.noticed("rejected").find("cost.beta") != std::string::npos);
    CHECK(session.world()->parameters().cost.beta == 0.5);
}
