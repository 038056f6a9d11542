// The world of the lockstep sample whose inputs may come late.
#include <doctest.h>

#include "lockstep/battlefield.h"
#include "lockstep/rollback.h"

using namespace lockstep;
using muster::Command;

namespace {

constexpr std::uint32_t kSteps = 40;

RollbackWorld rollbackWorld() {
    return RollbackWorld(makeBattlefield(6).value());
}

/// Player 0 gives an order for step 10, player 1 one for step 12.
Input inputOf(std::uint32_t player, std::uint32_t step) {
    if (step != 10 + 2 * player) return {};
    return {Command{step, player, 0, muster::SetPose{{player + 1}, {0.0, 2.0}, 1.0}}};
}

/// Hashes of all states where inputs are there in time.
std::vector<std::uint64_t> hashesInTime() {
    muster::World world = makeBattlefield(6).value();
    std::vector<std::uint64_t> hashes{world.hash()};
    for (std::uint32_t step = 0; step < kSteps; ++step) {
        for (std::uint32_t player = 0; player < kPlayers; ++player)
            for (const Command& command : inputOf(player, step)) REQUIRE(world.submit(command).ok());
        world.step();
        hashes.push_back(world.hash());
    }
    return hashes;
}

}  // namespace

TEST_CASE("inputs that are late by up to eight steps end in the states of inputs in time") {
    const std::vector<std::uint64_t> expected = hashesInTime();
    REQUIRE(expected[11] != expected[10]);
    for (std::uint32_t late = 0; late <= kMostRollback; ++late) {
        CAPTURE(late);
        RollbackWorld world = rollbackWorld();
        while (world.final() < kSteps) {
            if (world.known(0) < kSteps) world.give(0, inputOf(0, world.known(0)));
            // The input of step s comes before step s + late is done.
            while (world.known(1) + late <= world.now() && world.known(1) < kSteps)
                world.give(1, inputOf(1, world.known(1)));
            REQUIRE(world.correct().ok());
            for (std::uint32_t step = 0; step <= world.final(); ++step)
                CHECK(world.hash(step) == expected[step]);
            if (world.now() < kSteps && world.mayStep()) REQUIRE(world.step().ok());
            if (world.now() == kSteps && world.known(1) < kSteps) world.give(1, inputOf(1, world.known(1)));
        }
        CHECK(world.counts().rollbacks == (late == 0 ? 0 : 1));
        CHECK(world.counts().longest == late);
        CHECK(world.counts().repeated == late);
    }
}

TEST_CASE("late inputs without commands cost no rollback, and nothing is final before they are there") {
    RollbackWorld world = rollbackWorld();
    for (std::uint32_t step = 0; step < 8; ++step) {
        world.give(0, {});
        REQUIRE(world.correct().ok());
        REQUIRE(world.mayStep());
        REQUIRE(world.step().ok());
        CHECK(world.final() == 0);
    }
    CHECK_FALSE(world.mayStep());
    for (std::uint32_t step = 0; step < 5; ++step) world.give(1, {});
    REQUIRE(world.correct().ok());
    CHECK(world.final() == 5);
    CHECK(world.now() == 8);
    CHECK(world.mayStep());
    CHECK(world.counts().rollbacks == 0);
}

TEST_CASE("inputs are kept for a bounded number of steps") {
    RollbackWorld world = rollbackWorld();
    for (std::uint32_t step = 0; step < kWindow; ++step) CHECK(world.give(0, {}));
    CHECK_FALSE(world.give(0, {}));
    CHECK(world.known(0) == kWindow);
}
