// Handover: a second session goes on with the world of the first, bit for bit.
#include <doctest.h>

#include <string>
#include <vector>

#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "studio/session/takes/handover.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A keeper: what the page does (web/src/link/engine/kept_world.ts).
struct HandoverKeeper {
    Handover kept;
    std::size_t received = 0;

    void ask(const Session& session) {
        const auto bytes = session.handover(kept.world, kept.take.size());
        REQUIRE(bytes.ok());
        received = bytes->size();
        auto now = Handover::parse(*bytes);
        REQUIRE(now.ok());
        std::vector<std::uint8_t> take = kept.take;
        REQUIRE(now->takeFrom <= take.size());
        take.resize(now->takeFrom);
        take.insert(take.end(), now->take.begin(), now->take.end());
        kept = *now;
        kept.take = take;
        kept.takeFrom = 0;
    }
};

void replaysTo(const Session& session, std::uint64_t hash) {
    const auto bytes = session.take();
    REQUIRE(bytes.ok());
    const auto take = parseTake(*bytes, "take");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    const auto played = replayTake(*take);
    REQUIRE_MESSAGE(played.ok(), played.status().message());
    CHECK(played->hash == hash);
}

std::string commandsTo(double x) {
    return R"([{"kind":"move","group":1,"x":)" + std::to_string(x) + R"(,"y":4}])";
}

}  // namespace

TEST_CASE("a second session goes on bit for bit, and its take holds everything since the world began") {
    Session first(sessionDef());
    FakeClient director(first);
    REQUIRE(first.load("floor", smallFloor()).ok());
    run(first, 0.3, {&director});
    director.send(commandsOf(commandsTo(9)));
    run(first, 1.5, {&director});
    HandoverKeeper keeper;
    keeper.ask(first);

    Session second(sessionDef());
    REQUIRE(second.takeOver(keeper.kept.bytes()).ok());
    CHECK(second.world()->stepCount() == first.world()->stepCount());
    // Both let the first director's fingers go; the first one's client goes.
    first.disconnect(director.id);
    FakeClient other(second);
    run(first, 1.0, {});
    run(second, 1.0, {&other});
    CHECK(other.page.ids.size() == 16);
    REQUIRE(second.world()->stepCount() > 130);
    replaysTo(second, second.world()->hash());

    SUBCASE("who directs there gets a number of their own, and can direct") {
        other.send(commandsOf(commandsTo(-9)));
        run(second, 1.0, {&other});
        CHECK(other.noticed("rejected") == "");
        CHECK(second.world()->group(0).orders.front().order.target.x == doctest::Approx(-9));
        replaysTo(second, second.world()->hash());
    }
}

TEST_CASE("a keeper gets only those bytes of the take that it does not have") {
    Session session(sessionDef());
    FakeClient director(session);
    REQUIRE(session.load("floor", smallFloor()).ok());
    HandoverKeeper keeper;
    for (int i = 0; i < 5; ++i) {
        director.send(commandsOf(commandsTo(i)));
        run(session, 0.4, {&director});
        keeper.ask(session);
        Session whole(sessionDef());
        REQUIRE(whole.takeOver(keeper.kept.bytes()).ok());
        CHECK(whole.world()->stepCount() == session.world()->stepCount());
    }
    const auto unknown = session.handover();
    REQUIRE(unknown.ok());
    CHECK(unknown->size() > keeper.received);
    // Another world: what is known of the one before does not count.
    REQUIRE(session.load("floor", smallFloor()).ok());
    keeper.ask(session);
    CHECK(keeper.kept.step == 0);
    CHECK(parseTake(keeper.kept.take, "take").ok());
}

TEST_CASE("pause, speed, recording, edits of the place and the demonstration go along") {
    Session first(sessionDef());
    FakeClient director(first);
    REQUIRE(first.load("floor", smallFloor()).ok());
    run(first, 0.3, {&director});
    director.send(edited(
        "Wall", 0, R"([{"kind":"obstacle","definition":{"polygon":[[7,7],[9,7],[9,9],[7,9]],"height":2}}])"));
    director.send(protocol::Record{true});
    run(first, 0.5, {&director});
    REQUIRE(director.noticed("Edit") == "");
    director.send(protocol::SetSpeed{2.0f});
    director.send(protocol::Playback{protocol::PlaybackAction::Pause});
    run(first, 0.2, {&director});
    const auto place = first.scenario();
    REQUIRE(place.ok());
    HandoverKeeper keeper;
    keeper.ask(first);
    CHECK(keeper.kept.recording);

    Session second(sessionDef());
    REQUIRE(second.takeOver(keeper.kept.bytes()).ok());
    FakeClient other(second);
    run(second, 0.5, {&other});
    CHECK_FALSE(second.playing());
    CHECK(second.world()->stepCount() == keeper.kept.step);
    CHECK(second.scenario().value() == place.value());
    other.send(protocol::Playback{protocol::PlaybackAction::Restart});
    run(second, 0.5, {&other});
    CHECK(second.world()->obstacleIds().size() == 1);
}

TEST_CASE("an open take goes on at the same step") {
    Session first(sessionDef());
    FakeClient director(first);
    REQUIRE(first.load("floor", smallFloor()).ok());
    director.send(commandsOf(commandsTo(9)));
    run(first, 2.0, {&director});
    const auto take = first.take();
    REQUIRE(take.ok());
    REQUIRE(first.openTake(*take, "take").ok());
    run(first, 0.5, {&director});
    HandoverKeeper keeper;
    keeper.ask(first);
    CHECK(keeper.kept.open);

    Session second(sessionDef());
    REQUIRE(second.takeOver(keeper.kept.bytes()).ok());
    FakeClient other(second);
    run(second, 0.02, {&other});
    CHECK(second.replaying());
    CHECK(second.world()->stepCount() >= keeper.kept.step);
    CHECK(second.take().value() == take.value());
}

TEST_CASE("damaged handovers are refused by a sentence and change nothing") {
    Session first(sessionDef());
    FakeClient director(first);
    REQUIRE(first.load("floor", smallFloor()).ok());
    run(first, 0.5, {&director});
    HandoverKeeper keeper;
    keeper.ask(first);
    const std::vector<std::uint8_t> whole = keeper.kept.bytes();

    Session second(sessionDef());
    CHECK(second.handover().status().code() == StatusCode::NotFound);
    REQUIRE(second.load("floor", smallFloor()).ok());
    const std::uint64_t hash = second.world()->hash();
    const auto refused = [&](std::vector<std::uint8_t> bytes) {
        const Status status = second.takeOver(bytes);
        CHECK_FALSE(status.ok());
        CHECK(second.world()->hash() == hash);
        return status.message();
    };
    for (std::size_t size = 0; size < whole.size(); size += 1 + size / 7)
        refused({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    auto newer = whole;
    newer[8] = 9;
    CHECK(refused(newer) == "the handover of a world: found version 9, expected 1");
    Handover torn = keeper.kept;
    torn.takeFrom = 12;
    CHECK(refused(torn.bytes()).find("the first 12 bytes of its take are missing") != std::string::npos);
    Handover other = keeper.kept;
    other.step += 7;
    CHECK(refused(other.bytes()).find("found a world of step") != std::string::npos);
    // Any byte may differ; what is taken over nevertheless goes on without a crash.
    for (std::size_t at = 0; at < whole.size(); at += 1 + at / 9) {
        auto flipped = whole;
        flipped[at] ^= 0x55;
        Session any(sessionDef());
        if (any.takeOver(flipped).ok()) run(any, 0.05, {});
    }
}
