// The times at which steps come: at an even rate, and early where a client waits for one.
#include <algorithm>
#include <vector>

#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kStep = 1.0 / 60.0;

/// Lets time pass in short intervals, as the studio's loop does; returns the real times of the steps.
std::vector<double> stepTimes(Session& session, FakeClient& client, double seconds, double touchEvery) {
    constexpr double kPiece = 1e-3;
    std::vector<double> times;
    double nextTouch = touchEvery;
    Vec2 at{3.0, 0.0};
    for (double now = kPiece; now < seconds; now += kPiece) {
        session.elapse(kPiece);
        if (now >= nextTouch) {
            at.x += 0.01;
            client.touchAt(TouchPhase::Move, at, 100.0 + now);
            nextTouch += touchEvery;
        }
        if (!session.stepDue()) continue;
        session.step();
        times.push_back(now);
        client.poll();
    }
    return times;
}

}  // namespace

TEST_CASE("A touch is stepped at once, and the next step comes no earlier than it would have") {
    Session session(sessionDef());
    REQUIRE(session.load("small", smallFloor()).ok());
    FakeClient client(session);
    session.elapse(kStep);
    REQUIRE(session.stepDue());
    session.step();
    session.elapse(0.25 * kStep);
    CHECK_FALSE(session.stepDue());
    client.touchAt(TouchPhase::Down, {1.0, 1.0}, 100.0);
    CHECK(session.untilNextStep() == 0.0);
    REQUIRE(session.stepDue());
    session.step();
    CHECK_FALSE(session.stepDue());
    CHECK(session.untilNextStep() == doctest::Approx(1.75 * kStep));
    // A second touch waits until the world is no longer ahead.
    client.touchAt(TouchPhase::Move, {1.5, 1.0}, 100.01);
    CHECK(session.untilNextStep() == doctest::Approx(0.75 * kStep));
    session.elapse(0.76 * kStep);
    CHECK(session.stepDue());
}

TEST_CASE("Touches at any rate do not change the rate of steps") {
    for (const double every : {0.003, 0.011, 1.0 / 60.0, 0.03, 0.4}) {
        Session session(sessionDef());
        REQUIRE(session.load("small", smallFloor()).ok());
        FakeClient client(session);
        client.touchAt(TouchPhase::Down, {1.0, 1.0}, 100.0);
        const std::vector<double> times = stepTimes(session, client, 3.0, every);
        CHECK(times.size() >= 178);
        CHECK(times.size() <= 182);
        double longest = 0.0;
        for (std::size_t k = 1; k < times.size(); ++k) longest = std::max(longest, times[k] - times[k - 1]);
        CHECK(longest < 2.1 * kStep);
    }
}
