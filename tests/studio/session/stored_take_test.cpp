// A take that this Muster simulates otherwise plays from its stored frames.
#include <doctest.h>

#include <algorithm>

#include "files/take/take_encoder.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct Recorded {
    std::vector<std::uint8_t> bytes;
    std::vector<std::vector<Vec2>> positions;  // By step.
};

/// Records while a finger draws the group, as a page does.
Recorded recordDrag(double seconds) {
    Session session(sessionDef());
    WorldDef def{.name = "Long floor", .box = {{-30, -15}, {30, 15}}};
    def.groups.push_back({.count = 16, .position = {-20, 0}});
    REQUIRE(session.load("long", def).ok());
    FakeClient client(session);
    run(session, 0.5, {&client});
    client.send(protocol::Record{true});
    Recorded made;
    made.positions.resize(static_cast<std::size_t>((seconds + 3.0) * 60.0));
    const int pictures = static_cast<int>(seconds * 60.0);
    for (int i = 0; i < pictures; ++i) {
        const Vec2 at{-20.0 + i / 30.0, 0.0};
        client.touchAt(i == 0 ? TouchPhase::Down : TouchPhase::Move, at, 10.0 + i / 60.0);
        run(session, 1.0 / 60.0, {&client});
        const auto now = session.world()->characters().position;
        made.positions[session.world()->stepCount()] = {now.begin(), now.end()};
    }
    made.bytes = *session.take();
    return made;
}

/// The same take as another version of Muster, with other results, would have recorded it.
std::vector<std::uint8_t> ofAnotherVersion(const std::vector<std::uint8_t>& bytes, bool frames,
                                           std::uint32_t from = 0) {
    Take take = parseTake(bytes, "T").value();
    take.def.parameters.character.maxSpeed = 1.1;
    for (HashMark& mark : take.marks)
        if (mark.step >= from) mark.hash ^= 5;
    if (!frames) take.frames.clear();
    return TakeEncoder::whole(take, take.about);
}

double farthest(const World& world, const Recorded& made) {
    const auto now = world.characters().position;
    const auto& then = made.positions[world.stepCount()];
    double worst = 0.0;
    for (std::size_t i = 0; i < then.size(); ++i) worst = std::max(worst, distance(now[i], then[i]));
    return then.empty() ? 1e9 : worst;
}

}  // namespace

TEST_CASE("a take of another version plays, seeks both ways and ends from its frames") {
    const Recorded made = recordDrag(6.0);
    Session session(sessionDef());
    REQUIRE(session.openTake(ofAnotherVersion(made.bytes, true), "take").ok());
    FakeClient client(session);
    run(session, 2.0, {&client});
    REQUIRE(!client.takes.empty());
    CHECK(client.takes.back().stored);
    CHECK(session.replaying());
    CHECK(farthest(*session.world(), made) < 0.01);
    while (session.preparing()) session.prepare();
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    for (const std::uint32_t step : {250u, 90u, 333u, 200u, 60u}) {
        client.send(protocol::Seek{step});
        run(session, 0.2, {&client});
        CHECK(session.world()->stepCount() == step);
        CHECK(farthest(*session.world(), made) < 0.01);
    }
    client.notices.clear();
    client.send(protocol::TakeAgain{false});
    run(session, 0.1, {&client});
    REQUIRE(!client.notices.empty());
    CHECK(client.notices.back().text.find("stored frames") != std::string::npos);
    CHECK(session.replaying());
    client.notices.clear();
    client.send(protocol::BendPath{1, 0, 200, 1.0, 0.0, 2.0});
    run(session, 0.1, {&client});
    REQUIRE(!client.notices.empty());
    CHECK(client.notices.back().text.find("stored frames") != std::string::npos);
    client.notices.clear();
    client.send(protocol::Playback{protocol::PlaybackAction::Play});
    run(session, 8.0, {&client});
    REQUIRE(!client.notices.empty());
    CHECK(client.notices.back().text == "The take ends here; it was shown from its stored frames.");
}

TEST_CASE("what differs later only goes on from the frames, at the same moment") {
    const Recorded made = recordDrag(6.0);
    Take take = parseTake(made.bytes, "T").value();
    for (HashMark& mark : take.marks)
        if (mark.step >= 180) mark.hash ^= 5;
    Session session(sessionDef());
    REQUIRE(session.openTake(TakeEncoder::whole(take, {}), "take").ok());
    FakeClient client(session);
    run(session, 1.0, {&client});
    CHECK(!client.takes.back().stored);
    run(session, 3.0, {&client});
    CHECK(client.takes.back().stored);
    CHECK(session.world()->stepCount() > 200);
    CHECK(farthest(*session.world(), made) < 0.01);
}

TEST_CASE("without frames one sentence says why it cannot be shown") {
    const Recorded made = recordDrag(3.0);
    Session session(sessionDef());
    REQUIRE(session.openTake(ofAnotherVersion(made.bytes, false), "take").ok());
    FakeClient client(session);
    run(session, 3.0, {&client});
    CHECK(!client.takes.back().stored);
    const auto known = std::find_if(client.notices.begin(), client.notices.end(), [](const auto& notice) {
        return notice.text.find("another version of Muster and holds no stored frames") != std::string::npos;
    });
    CHECK(known != client.notices.end());
}

TEST_CASE("what is recorded holds frames from the moment of recording on, and replays to its hashes") {
    const Recorded made = recordDrag(3.0);
    const Take take = parseTake(made.bytes, "T").value();
    REQUIRE(!take.frames.empty());
    CHECK(take.frames.front().step > 25);
    CHECK(take.frames.back().step > 190);
    CHECK(replayTake(take).ok());
}
