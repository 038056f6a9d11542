// Control schemes in the studio: raw inputs of a page, judged by the session.
#include <limits>

#include "studio/gestures/control_scheme.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kScale = 40.0;  // Pixels per metre.

protocol::SetView topView() {
    const GroundView view = GroundView::fromAbove({}, kScale, 960, 960, 0.28);
    protocol::SetView message;
    message.matrix.assign(view.toScreen.begin(), view.toScreen.end());
    message.width = view.width;
    message.height = view.height;
    message.mmPerPixel = view.mmPerPixel;
    return message;
}

protocol::RawInput pointer(TouchPhase phase, Vec2 ground, double time, protocol::PointerButton button,
                           protocol::PointerDevice device = protocol::PointerDevice::Mouse) {
    return {.phase = phase,
            .device = device,
            .button = button,
            .pointer = 1,
            .x = 480 + kScale * ground.x,
            .y = 480 - kScale * ground.y,
            .time = time};
}

/// Presses at `from`, moves to `to` and lets go.
void drag(Session& session, FakeClient& client, Vec2 from, Vec2 to, protocol::PointerButton button,
          protocol::PointerDevice device = protocol::PointerDevice::Mouse) {
    protocol::Inputs inputs{.events = {pointer(TouchPhase::Down, from, 0.0, button, device)}};
    client.send(inputs);
    run(session, 0.1, {&client});
    constexpr int kMoves = 10;
    for (int i = 1; i <= kMoves; ++i) {
        inputs.events = {pointer(TouchPhase::Move, from + (to - from) * (i / double(kMoves)), 0.1 + 0.05 * i,
                                 button, device)};
        client.send(inputs);
        run(session, 0.05, {&client});
    }
    inputs.events = {pointer(TouchPhase::Up, to, 0.7, button, device)};
    client.send(inputs);
    run(session, 0.1, {&client});
}

Vec2 middle(const Session& session) {
    Vec2 sum;
    const CharactersView characters = session.world()->characters();
    for (const Vec2 position : characters.position) sum = sum + position;
    return sum * (1.0 / static_cast<double>(characters.size()));
}

FakeClient clientWith(Session& session, const std::string& scheme) {
    FakeClient client(session);
    client.send(topView());
    client.send(protocol::SetScheme{scheme});
    client.poll();
    REQUIRE(client.notices.empty());
    return client;
}

}  // namespace

TEST_CASE("A page lists all control schemes and chooses one") {
    Session session = startedSession();
    FakeClient client(session);
    client.poll();
    REQUIRE(client.welcome);
    REQUIRE(client.welcome->schemes.size() == namedSchemes().size());
    CHECK(client.welcome->schemes[0].name == "touch");
    CHECK(client.welcome->schemes[0].mesh);
    CHECK(!client.welcome->schemes[1].mesh);
    client.send(protocol::SetScheme{"no such"});
    client.poll();
    CHECK(client.noticed("SetScheme").find("touch, mouse-paper") != std::string::npos);
    CHECK(client.marks.empty());
    client.send(protocol::SetScheme{"mouse-paper"});
    client.poll();
    REQUIRE(client.marks.size() == 1);
    CHECK(client.marks.back().scheme == "mouse-paper");
    client.send(protocol::SetScheme{""});
    client.poll();
    CHECK(client.marks.back().scheme.empty());
}

TEST_CASE("The paper's mouse selects by a right drag and sends by a left click") {
    Session session = startedSession();
    FakeClient client = clientWith(session, "mouse-paper");
    const Vec2 before = middle(session);
    drag(session, client, {-4, -4}, {4, 4}, protocol::PointerButton::Right);
    CHECK(client.marks.back().selected.size() == 16);
    bool boxed = false;
    for (const protocol::Marks& marks : client.marks) boxed |= marks.rectangle.size() == 8;
    CHECK(boxed);
    drag(session, client, {6, 0}, {6, 0}, protocol::PointerButton::Left);
    REQUIRE(client.marks.back().goals.size() == 2);
    CHECK(client.marks.back().goals[0] == doctest::Approx(6.0));
    run(session, 3.0, {&client});
    CHECK(middle(session).x > before.x + 2.0);
    CHECK(client.noticed("Inputs").empty());
}

TEST_CASE("Fingers judged by the session drag a formation, and two clients keep theirs apart") {
    Session session = startedSession();
    FakeClient first = clientWith(session, "touch");
    FakeClient second = clientWith(session, "mouse-full-free");
    const Vec2 before = middle(session);
    drag(session, first, {0, 0}, {4, 3}, protocol::PointerButton::Left, protocol::PointerDevice::Touch);
    run(session, 3.0, {&first, &second});
    CHECK(middle(session).x > before.x + 2.0);
    REQUIRE(second.marks.size() == 1);
    CHECK(second.marks.back().selected.empty());
}

TEST_CASE("A take of a session with a control scheme replays to the same hashes") {
    Session session = startedSession();
    FakeClient client = clientWith(session, "mouse-full-continuum");
    drag(session, client, {-4, -4}, {4, 4}, protocol::PointerButton::Left);
    drag(session, client, {-6, 2}, {-6, 2}, protocol::PointerButton::Right);
    run(session, 1.0, {&client});
    const auto take = session.take();
    REQUIRE(take.ok());
    Session other = startedSession();
    FakeClient watcher(other);
    REQUIRE(other.openTake(take.value(), "take").ok());
    watcher.send(protocol::SetSpeed{8.0f});
    run(other, 1.5, {&watcher});
    CHECK(watcher.noticed("replay-end").find("as it was recorded") != std::string::npos);
    protocol::Inputs inputs{.events = {pointer(TouchPhase::Down, {}, 9.0, protocol::PointerButton::Left)}};
    watcher.send(inputs);
    watcher.poll();
    CHECK(watcher.noticed("Inputs").find("replayed") != std::string::npos);
}

TEST_CASE("Inputs that make no sense are refused with a sentence and change nothing") {
    Session session = startedSession();
    FakeClient client(session);
    protocol::Inputs inputs{.events = {pointer(TouchPhase::Down, {}, 0.0, protocol::PointerButton::Left)}};
    client.send(inputs);
    client.poll();
    CHECK(client.noticed("Inputs").find("choice of a control scheme") != std::string::npos);
    client.send(protocol::SetScheme{"touch"});
    client.send(inputs);
    client.poll();
    CHECK(client.noticed("Inputs").find("view of the ground") != std::string::npos);
    protocol::SetView flat = topView();
    flat.matrix.assign(9, 1.0);
    client.send(flat);
    client.poll();
    CHECK(client.noticed("SetView").find("inverted") != std::string::npos);
    flat.matrix.resize(8);
    client.send(flat);
    client.poll();
    CHECK(client.noticed("SetView").find("expected 9") != std::string::npos);
    client.send(topView());
    inputs.events[0].x = std::numeric_limits<double>::quiet_NaN();
    run(session, 1.0, {&client});
    client.send(inputs);
    client.poll();
    CHECK(client.noticed("Inputs").find("not finite") != std::string::npos);
    client.send(protocol::EnterStudy{});
    client.poll();
    CHECK(client.noticed("EnterStudy").find("muster study run") != std::string::npos);
    run(session, 0.5, {&client});
    CHECK(session.world()->group(0).controls.empty());
}

TEST_CASE("A scheme forgets what it knew when another world begins") {
    Session session = startedSession();
    FakeClient client = clientWith(session, "mouse-paper");
    drag(session, client, {-4, -4}, {4, 4}, protocol::PointerButton::Right);
    CHECK(client.marks.back().selected.size() == 16);
    client.send(protocol::LoadScenario{"small"});
    run(session, 0.1, {&client});
    CHECK(client.marks.back().selected.empty());
    CHECK(client.marks.back().scheme == "mouse-paper");
    drag(session, client, {-4, -4}, {4, 4}, protocol::PointerButton::Right);
    CHECK(client.marks.back().selected.size() == 16);
}
