// All that influences a later step is in the snapshot; nothing depends on threads.
#include <doctest.h>

#include "engine/state/world_archive.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("a world restored at a random step goes on bit for bit") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        World world = World::create(busyFloor(seed)).value();
        RandomDirector director(seed);
        for (std::uint32_t s = 20 + random.below(150); s > 0; --s) {
            director.act(world);
            world.step();
        }
        checkGoesOn(world, 90, director);
    }
}

TEST_CASE("the number of threads changes no bit") {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4, 8}) {
        World world = World::create(busyFloor(11), threads).value();
        RandomDirector director(3);
        for (int s = 0; s < 180; ++s) {
            director.act(world);
            world.step();
        }
        hashes.push_back(world.hash());
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

TEST_CASE("the order of submission does not matter, only step, client and sequence") {
    const auto run = [](bool reversed) {
        World world = World::create(openFloor()).value();
        std::vector<Command> commands;
        for (std::uint32_t i = 0; i < 20; ++i) {
            FormationDef formation{.kind = static_cast<FormationKind>(i % 8)};
            commands.push_back(
                {5 + i / 4, i % 3, i, ChangeGroup{.group = world.group(0).id, .formation = formation}});
        }
        if (reversed) std::reverse(commands.begin(), commands.end());
        for (const Command& command : commands) REQUIRE(world.submit(command).ok());
        for (int s = 0; s < 60; ++s) world.step();
        return world.hash();
    };
    CHECK(run(false) == run(true));
}

TEST_CASE("different seeds and different commands give different hashes") {
    World a = World::create(busyFloor(1)).value();
    World b = World::create(busyFloor(2)).value();
    CHECK(a.hash() != b.hash());
    World c = World::create(busyFloor(1)).value();
    CHECK(a.hash() == c.hash());
    REQUIRE(give(c, SetParameter{"character.maxSpeed", 1.9}).ok());
    a.step();
    c.step();
    CHECK(a.hash() != c.hash());
}

TEST_CASE("torn, foreign, tampered snapshots and other versions are refused with one sentence each") {
    World world = World::create(busyFloor(1)).value();
    for (int s = 0; s < 10; ++s) world.step();
    const auto bytes = world.snapshot();
    const std::uint64_t hash = world.hash();
    const auto refusal = [&](std::span<const std::uint8_t> changed) {
        const auto restored = World::restore(changed);
        REQUIRE_FALSE(restored.ok());
        const Status rewound = world.rewind(changed);
        CHECK(rewound.message() == restored.status().message());
        CHECK(world.hash() == hash);  // Nothing has changed.
        return restored.status().message();
    };
    const std::string state = std::to_string(bytes.size() - kSnapshotHeadBytes);
    for (std::size_t size = kSnapshotHeadBytes; size < bytes.size(); size += 1 + size / 7)
        CHECK(refusal(std::span(bytes).first(size)) == "snapshot: found " +
                                                           std::to_string(size - kSnapshotHeadBytes) +
                                                           " bytes of state, expected " + state);
    CHECK(refusal(std::span(bytes).first(20)) == "snapshot: found 20 bytes, expected a whole head of 28");
    const std::string foreign = "snapshot: found another kind of data, expected a world's snapshot";
    CHECK(refusal({}) == foreign);
    CHECK(refusal(std::vector<std::uint8_t>(500, 7)) == foreign);
    auto changed = bytes;
    changed.push_back(0);
    CHECK(refusal(changed).rfind("snapshot: found ", 0) == 0);
    for (const std::size_t at : {kSnapshotHeadBytes, bytes.size() / 2, bytes.size() - 1}) {
        changed = bytes;
        changed[at] ^= 1;
        CHECK(refusal(changed) ==
              "snapshot: found bytes that do not match their checksum, expected them as they were saved");
    }
    changed = bytes;
    changed[8] = 99;
    CHECK(refusal(changed) == "snapshot: found version 99, expected version 21, which this Muster writes");
    const std::vector<std::uint8_t> old{'2', 'P', 'S', 'M', 0, 0, 0, 0};
    CHECK(refusal(old) == "snapshot: found version 2, expected version 21, which this Muster writes");
}
