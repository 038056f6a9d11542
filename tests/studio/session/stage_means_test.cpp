// Times of the stages of steps, for clients that watch them.
#include <doctest.h>

#include "muster/views.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Makes that many steps of a paused session.
void makeSteps(Session& session, int count, const std::vector<FakeClient*>& clients) {
    for (int i = 0; i < count; ++i) {
        clients.front()->send(protocol::Playback{protocol::PlaybackAction::SingleStep});
        while (session.stepDue()) session.step();
        for (FakeClient* client : clients) client->poll();
    }
}

}  // namespace

TEST_CASE("Who watches gets the means of 60 steps for every stage, in the order of the step") {
    Session session = startedSession();
    FakeClient watcher(session), other(session);
    makeSteps(session, 5, {&watcher, &other});
    watcher.send(protocol::WatchStages{true});
    makeSteps(session, 59, {&watcher, &other});
    CHECK(watcher.stageTimes.empty());
    makeSteps(session, 1, {&watcher, &other});
    REQUIRE(watcher.stageTimes.size() == 1);
    const protocol::StageTimes& times = watcher.stageTimes[0];
    CHECK(times.step == 65);
    REQUIRE(times.stages.size() == kStageCount);
    double sum = 0.0;
    for (std::size_t s = 0; s < kStageCount; ++s) {
        CHECK(times.stages[s].name == stepStages()[s].name);
        CHECK(times.stages[s].about == stepStages()[s].about);
        CHECK(times.stages[s].milliseconds >= 0.0f);
        sum += static_cast<double>(times.stages[s].milliseconds);
    }
    CHECK(times.total > 0.0f);
    CHECK(sum > 0.0);
    CHECK(sum <= static_cast<double>(times.total) * (1.0 + 1e-5));
    makeSteps(session, 120, {&watcher, &other});
    REQUIRE(watcher.stageTimes.size() == 3);
    CHECK(watcher.stageTimes[2].step == 185);
    CHECK(other.stageTimes.empty());
    CHECK(watcher.notices.empty());
}

TEST_CASE("Who watches no longer gets no more times, and others still do") {
    Session session = startedSession();
    FakeClient first(session), second(session);
    first.send(protocol::WatchStages{true});
    second.send(protocol::WatchStages{true});
    makeSteps(session, 60, {&first, &second});
    first.send(protocol::WatchStages{false});
    makeSteps(session, 60, {&first, &second});
    CHECK(first.stageTimes.size() == 1);
    CHECK(second.stageTimes.size() == 2);
    second.send(protocol::WatchStages{false});
    makeSteps(session, 90, {&first, &second});
    CHECK(second.stageTimes.size() == 2);
    // What nobody watched is in no mean, and what was sent before does not come again.
    first.send(protocol::WatchStages{true});
    makeSteps(session, 59, {&first, &second});
    CHECK(first.stageTimes.size() == 1);
    makeSteps(session, 1, {&first, &second});
    REQUIRE(first.stageTimes.size() == 2);
    CHECK(first.stageTimes[1].step == 270);
    CHECK(second.stageTimes.size() == 2);
}

TEST_CASE("Steps of two worlds are in no mean together") {
    Session session = startedSession();
    FakeClient client(session);
    client.send(protocol::WatchStages{true});
    makeSteps(session, 40, {&client});
    client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    makeSteps(session, 59, {&client});
    CHECK(client.stageTimes.empty());
    makeSteps(session, 1, {&client});
    REQUIRE(client.stageTimes.size() == 1);
    CHECK(client.stageTimes[0].step == 60);
}

TEST_CASE("Who has not drawn a frame gets the newest times alone") {
    Session session = startedSession();
    FakeClient slow(session), steady(session);
    slow.send(protocol::WatchStages{true});
    slow.poll(false);
    makeSteps(session, 180, {&steady});
    slow.poll(false);
    CHECK(slow.stageTimes.empty());
    slow.send(protocol::FrameAck{slow.frames.back().frame});
    slow.poll();
    REQUIRE(slow.stageTimes.size() == 1);
    CHECK(slow.stageTimes[0].step == 180);
}

TEST_CASE("Watching stages changes nothing in the world and is refused before Hello") {
    Session watched = startedSession(), plain = startedSession();
    FakeClient watcher(watched), other(plain), silent(plain, false);
    watcher.send(protocol::WatchStages{true});
    silent.send(protocol::WatchStages{true});
    makeSteps(watched, 61, {&watcher});
    makeSteps(plain, 61, {&other, &silent});
    CHECK(watched.world()->hash() == plain.world()->hash());
    CHECK(watched.take().value() == plain.take().value());
    CHECK(silent.stageTimes.empty());
    CHECK(silent.noticed("WatchStages") != "");
}

TEST_CASE("Times of stages are the same after encoding and decoding, and refused when damaged") {
    protocol::StageTimes sent;
    sent.step = 60;
    sent.total = 0.75f;
    sent.stages = {{"commands", "Applies the commands.", 0.25f}, {"orders", "", 0.5f}};
    const std::vector<std::uint8_t> bytes = protocol::encode(sent);
    const auto message = protocol::decodeServer(bytes);
    REQUIRE(message.ok());
    const auto& times = std::get<protocol::StageTimes>(message.value());
    CHECK(times.step == 60);
    CHECK(times.stages.size() == 2);
    CHECK(times.stages[0].about == "Applies the commands.");
    CHECK(times.stages[1].milliseconds == 0.5f);
    CHECK(protocol::encode(times) == bytes);
    // Number, step, total and the number of stages, as in web/src/protocol/messages.test.ts.
    CHECK(std::vector(bytes.begin(), bytes.begin() + 13) ==
          std::vector<std::uint8_t>{0x13, 60, 0, 0, 0, 0, 0, 0x40, 0x3F, 2, 0, 0, 0});
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK_FALSE(protocol::decodeServer(std::span(bytes).first(length)).ok());
    std::vector<std::uint8_t> many = bytes;
    many[9] = many[10] = many[11] = many[12] = 0xFF;  // The number of stages.
    CHECK_FALSE(protocol::decodeServer(many).ok());
    CHECK(protocol::encode(protocol::WatchStages{true}) == std::vector<std::uint8_t>{28, 1});
    CHECK_FALSE(protocol::decodeClient(std::vector<std::uint8_t>{34, 2}).ok());
    CHECK_FALSE(protocol::decodeClient(std::vector<std::uint8_t>{34}).ok());
}
