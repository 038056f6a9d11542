// Snapshots with flipped bits and cut ends: refused, or good enough to go on from; never a crash.
#include <doctest.h>

#include "engine/state/world_archive.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::vector<std::uint8_t> snapshotOf(std::uint64_t seed, int steps) {
    World world = World::create(busyFloor(seed)).value();
    RandomDirector director(seed);
    for (int s = 0; s < steps; ++s) {
        director.act(world);
        world.step();
    }
    return world.snapshot();
}

/// A small world, so that few bytes are of no account: controls, a detour, a checkpoint, an item.
std::vector<std::uint8_t> smallSnapshot(bool weights = false) {
    WorldDef def{.box = {{-4, -4}, {4, 4}},
                 .obstacles = {tree({0.5, 0.3}, 0.4)},
                 .patches = {rectangle(1, -2, 2, 2, 3)}};
    def.groups.emplace_back().count = 4;
    def.groups[0].position = {-2, 0};
    if (weights) def.groups[0].demands = {1.5, 0.5, 0.25, 2.0};
    def.items.push_back({{3, 3}, 0.3});
    def.checkpoints.emplace_back().position = {3, -3};
    World world = World::create(def).value();
    REQUIRE(give(world, Touch{TouchPhase::Down, 1, {-2, 0.5}, 0, {}}).ok());
    REQUIRE(give(world, Touch{TouchPhase::Down, 2, {-2, -0.5}, 0, {}}).ok());
    for (int s = 0; s < 30; ++s) {
        REQUIRE(give(world, Touch{TouchPhase::Move, 1, {-2 + 0.2 * s, 0.5}, world.time(), {}}).ok());
        world.step();
    }
    REQUIRE(world.submit({world.stepCount() + 2, 3, 1, SetParameter{"plan.period", 3}}).ok());
    return world.snapshot();
}

/// The same state under its true checksum: whoever tampers with a state may know it too.
std::vector<std::uint8_t> sealed(std::vector<std::uint8_t> bytes) {
    if (bytes.size() >= kSnapshotHeadBytes) sealSnapshot(bytes);
    return bytes;
}

/// Restores; where that is accepted, a few steps must be survived.
bool goesOn(const std::vector<std::uint8_t>& bytes) {
    Result<World> world = World::restore(bytes);
    if (!world.ok()) {
        const StatusCode code = world.status().code();
        CHECK((code == StatusCode::ParseError || code == StatusCode::Unsupported));
        CHECK_FALSE(world.status().message().empty());
        return false;
    }
    for (int s = 0; s < 6; ++s) world->step();
    for (const Vec2 p : world->characters().position) CHECK(isFinite(p));
    return true;
}

}  // namespace

TEST_CASE("one flipped bit anywhere in a small snapshot, with weights or without") {
    const auto plain = smallSnapshot(), weighted = smallSnapshot(true);
    REQUIRE(goesOn(plain));
    REQUIRE(goesOn(weighted));
    Random random(5);
    int refused = 0;
    for (int k = 0; k < 1400; ++k) {
        const auto& whole = k < 700 ? plain : weighted;
        auto bytes = whole;
        const auto head = static_cast<std::uint32_t>(kSnapshotHeadBytes);
        const std::uint32_t at = head + random.below(static_cast<std::uint32_t>(bytes.size()) - head);
        const std::uint32_t bit = random.below(8);
        CAPTURE(at);
        CAPTURE(bit);
        bytes[at] ^= static_cast<std::uint8_t>(1u << bit);
        CHECK_FALSE(goesOn(bytes));
        refused += goesOn(sealed(bytes)) ? 0 : 1;
    }
    CHECK(refused > 140);  // Lengths, indices, flags, exponents of numbers.
}

TEST_CASE("many flipped bits, and cut ends") {
    Random random(9);
    for (const std::uint64_t seed : {1u, 2u}) {
        const auto whole = snapshotOf(seed, 60);
        REQUIRE(goesOn(whole));
        for (int k = 0; k < 30; ++k) {
            auto bytes = whole;
            for (std::uint32_t flips = 1 + random.below(4); flips-- > 0;)
                bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] ^= static_cast<std::uint8_t>(
                    1u << random.below(8));
            (void)goesOn(sealed(bytes));
        }
        for (int k = 0; k < 60; ++k) {
            auto bytes = whole;
            bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
            CHECK_FALSE(goesOn(bytes));
            CHECK_FALSE(goesOn(sealed(bytes)));
        }
    }
}
