// Two peers of the lockstep sample in one process, with the emulated network between them.
#include <doctest.h>

#include "lockstep/battlefield.h"
#include "lockstep/lockstep_options.h"
#include "lockstep/lossy_link.h"
#include "lockstep/peer.h"
#include "lockstep/script.h"

using namespace lockstep;
using muster::Command;
using muster::StatusCode;
using muster::World;

namespace {

constexpr std::int32_t kPeople = 12;

World field() {
    return makeBattlefield(kPeople).value();
}

/// Two peers whose players' commands are kept.
struct Match {
    Match(std::uint32_t steps, LinkDef def, std::uint64_t seed) {
        for (std::uint32_t player = 0; player < 2; ++player) {
            def.seed = 10 * seed + player;
            links.emplace_back(def);
            scripts.push_back(std::make_unique<Script>(player, kPeople, seed));
            peers.push_back(std::make_unique<Peer>(field(), player, steps, [this, player](const World& seen) {
                auto bodies = scripts[player]->commands(seen);
                for (const auto& body : bodies)
                    given.push_back({seen.stepCount() + kInputDelay, player, sequence[player]++, body});
                return bodies;
            }));
        }
    }
    /// One tick of both; the second peer is late by `skew` ticks.
    muster::Status tick(std::uint32_t now, std::uint32_t skew = 0) {
        for (std::uint32_t player = 0; player < 2; ++player) {
            if (player == 1 && now < skew) continue;
            for (const Bytes& bytes : links[1 - player].arrivals(now)) peers[player]->receive(bytes);
            if (muster::Status status = peers[player]->tick(); !status.ok()) return status;
            links[player].send(now, peers[player]->datagram());
        }
        return {};
    }
    bool done() const { return peers[0]->done() && peers[1]->done(); }

    std::vector<LossyLink> links;
    std::vector<std::unique_ptr<Script>> scripts;
    std::vector<std::unique_ptr<Peer>> peers;
    std::vector<Command> given;
    std::uint32_t sequence[2] = {0, 0};
};

/// A world that is given all commands in time.
std::uint64_t hashInTime(const std::vector<Command>& commands, std::uint32_t steps) {
    World world = field();
    for (const Command& command : commands)
        if (command.step < steps) REQUIRE(world.submit(command).ok());
    while (world.stepCount() < steps) world.step();
    return world.hash();
}

}  // namespace

TEST_CASE("two peers on a bad network end as one world that gets all commands in time") {
    struct Case {
        double delay, jitter, loss, garbage;
        std::uint32_t skew;
    };
    constexpr std::uint32_t kSteps = 900;
    std::uint64_t seed = 1;
    for (const Case c : {Case{0, 0, 0, 0, 0}, Case{100, 30, 0.05, 0, 0}, Case{100, 30, 0.05, 0.5, 40},
                         Case{150, 80, 0.3, 0, 0}, Case{100, 60, 0.7, 0, 7}}) {
        CAPTURE(c.loss);
        CAPTURE(c.delay);
        Match match(kSteps, {c.delay, c.jitter, c.loss, c.garbage, 0}, ++seed);
        std::uint32_t tick = 0;
        for (; tick < 20'000 && !match.done(); ++tick) REQUIRE(match.tick(tick, c.skew).ok());
        REQUIRE(match.done());
        const std::uint64_t expected = hashInTime(match.given, kSteps);
        CHECK(match.given.size() > 20);
        for (const auto& peer : match.peers) {
            CHECK(peer->world().hash(kSteps) == expected);
            CHECK(peer->world().counts().longest <= kMostRollback);
            CHECK(peer->counts().compared > (c.loss > 0.5 ? 500u : 890u));
            CHECK((peer->world().counts().rollbacks == 0) == (c.delay == 0));
            CHECK((peer->counts().refused > 0) == (c.garbage > 0));
        }
    }
}

TEST_CASE("who begins later is waited for, and then nobody stalls for it") {
    Match match(3000, {100.0, 0.0, 0.0, 0.0, 0}, 5);
    std::uint32_t tick = 0, stalls = 0;
    for (; tick < 1500; ++tick) REQUIRE(match.tick(tick, 30).ok());
    stalls = match.peers[0]->counts().stalls;
    for (; tick < 2500; ++tick) REQUIRE(match.tick(tick).ok());
    CHECK(match.peers[0]->counts().stalls == stalls);
    CHECK(match.peers[0]->counts().waits > 0);
    const auto first = static_cast<int>(match.peers[0]->world().now());
    CHECK(std::abs(first - static_cast<int>(match.peers[1]->world().now())) <= 2);
}

TEST_CASE("a peer that hears nothing stops after the delay of inputs and the longest rollback") {
    Script script(0, kPeople, 3);
    Peer peer(field(), 0, 3600, [&](const World& seen) { return script.commands(seen); });
    for (int tick = 0; tick < 500; ++tick) {
        REQUIRE(peer.tick().ok());
        CHECK(peer.datagram().size() <= kMostBytes);
    }
    CHECK(peer.world().now() == kInputDelay + kMostRollback);
    CHECK(peer.world().final() == kInputDelay);
    CHECK(peer.counts().stalls == 500 - peer.world().now());
    CHECK_FALSE(peer.done());
}

TEST_CASE("a hash of another state ends the match and the step is named") {
    Match match(600, {50.0, 0.0, 0.0, 0.0, 0}, 4);
    for (std::uint32_t tick = 0; tick < 200; ++tick) REQUIRE(match.tick(tick).ok());
    Datagram forged = decode(match.peers[1]->datagram(), 1).value();
    REQUIRE(forged.hashes.size() == kMostHashes);
    const std::uint32_t step = forged.firstHash + kMostHashes - 1;
    REQUIRE(step > match.peers[0]->equalUpTo());
    forged.hashes.back() ^= 1;
    match.peers[0]->receive(encode(forged));
    muster::Status status;
    for (std::uint32_t tick = 200; tick < 210 && status.ok(); ++tick) status = match.tick(tick);
    CHECK(status.code() == StatusCode::Corrupt);
    CHECK(status.message() == "the states of the two peers differ after step " + std::to_string(step));
}

TEST_CASE("datagrams about steps that cannot be are refused and change nothing") {
    Match match(600, {0.0, 0.0, 0.0, 0.0, 0}, 6);
    for (std::uint32_t tick = 0; tick < 100; ++tick) REQUIRE(match.tick(tick).ok());
    Peer& peer = *match.peers[0];
    const Bytes before = peer.datagram();
    const Datagram good = decode(match.peers[1]->datagram(), 1).value();
    const auto refused = [&](auto change) {
        Datagram bad = good;
        change(bad);
        const std::uint32_t count = peer.counts().refused;
        peer.receive(encode(bad));
        return peer.counts().refused == count + 1 &&
               peer.lastRefusal() == "a datagram speaks of steps that cannot be";
    };
    CHECK(refused([](Datagram& d) { d.now = ~0u; }));
    CHECK(refused([](Datagram& d) { d.received = 5000; }));
    CHECK(refused([](Datagram& d) { d.confirmed = 5000; }));
    CHECK(refused([](Datagram& d) {
        d.firstInput = ~0u - 2;
        d.inputs.assign(9, {});
    }));
    CHECK(peer.datagram() == before);
    Datagram wild = good;
    wild.ahead = std::numeric_limits<std::int32_t>::min();
    wild.firstHash = ~0u - 1;
    peer.receive(encode(wild));
    CHECK(peer.tick().ok());
}

TEST_CASE("the emulated network loses its share and keeps the others within delay and jitter") {
    LossyLink link({100.0, 30.0, 0.05, 0.0, 9});
    std::uint32_t arrived = 0, early = 99, late = 0;
    for (std::uint32_t tick = 0; tick < 20'100; ++tick) {
        for (const Bytes& bytes : link.arrivals(tick)) {
            const std::uint32_t took = tick - ByteReader(bytes).get<std::uint32_t>();
            early = std::min(early, took);
            late = std::max(late, took);
            ++arrived;
        }
        Bytes bytes;
        put(bytes, tick);
        if (tick < 20'000) link.send(tick, bytes);
    }
    CHECK(link.sent() == 20'000);
    CHECK(arrived + link.lost() == link.sent());
    // Four standard deviations of 1000 losses.
    CHECK(std::abs(static_cast<int>(link.lost()) - 1000) < 4 * 31);
    CHECK(early == 5);  // 70 ms are 4.2 ticks...
    CHECK(late == 8);   // ... and 130 ms 7.8.
}

TEST_CASE("a wrong command line is told in one sentence that names the culprit") {
    const auto told = [](std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "lockstep");
        return readOptions(static_cast<int>(arguments.size()), arguments.data()).status().message();
    };
    CHECK(told({}).empty());
    CHECK(told({"--minutes", "10", "--real", "out"}).empty());
    CHECK(told({"--loss"}).starts_with("--loss is ''"));
    CHECK(told({"--loss", "nan"}).starts_with("--loss is 'nan'"));
    CHECK(told({"--loss", "0.5x"}).starts_with("--loss is '0.5x'"));
    CHECK(told({"--fast"}) == "no option is called '--fast'");
    CHECK(told({"--port", "4000"}) == "--port and --peer go together");
    CHECK(told({"--port", "4000", "--peer", "4000"}) == "--port and --peer are the same");
}
