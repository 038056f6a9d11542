// Saving a pending plan: the restored plan continues bit for bit.
#include <doctest.h>

#include "engine/assignment/planning/plan_scene.h"
#include "engine/ground/environment/environment.h"

namespace {

using muster::Plan;
using muster::PlanResult;
using muster::Vec2;
using muster_test::OwnedInput;

constexpr std::int32_t kSlices = 4;

std::vector<std::uint8_t> saved(const Plan& plan) {
    muster::Writer writer;
    plan.save(writer);
    return writer.take();
}

std::uint64_t hashed(const Plan& plan) {
    muster::Hasher hasher;
    plan.hash(hasher);
    return hasher.value();
}

bool restore(Plan& plan, const std::vector<std::uint8_t>& bytes) {
    muster::Reader reader(bytes);
    muster::ThreadPool pool(2);
    return plan.load(reader, pool) && reader.ok() && reader.remaining() == 0;
}

OwnedInput scene(std::uint64_t seed) {
    muster::Random random(seed);
    auto ground = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.25);
    muster_test::addWall(ground, {{-1, -6}, {1, 6}});
    OwnedInput input = muster_test::randomInput(random, ground, 9, {{-7, -7}, {-2, 7}}, {{2, -7}, {7, 7}});
    for (std::size_t i = 0; i < input.incumbent.size(); ++i)
        input.incumbent[i] = static_cast<std::int32_t>(8 - i);
    input.usable.assign(9, 1);
    input.usable[3] = 0;
    input.supply.assign(9, 1.0);
    input.demand.assign(9, 1.0);
    return input;
}

void checkSame(Plan& a, Plan& b, const OwnedInput& input) {
    const muster::Environment environment;
    muster::FixedCosts costs;
    costs.world = &environment;
    const std::vector<std::int32_t> place = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    std::vector<Vec2> directionA(9), directionB(9);
    std::vector<double> costA(9), costB(9);
    const muster::GuidanceInput steering{input.characters, place, input.places, &costs, 1.5};
    muster::ThreadPool pool;
    a.guide(steering, pool, directionA, costA);
    b.guide(steering, pool, directionB, costB);
    CHECK(directionA == directionB);
    CHECK(costA == costB);
    for (std::int32_t j = 0; j < 9; ++j) CHECK(a.costAt(j, {-3.1, 2.2}) == b.costAt(j, {-3.1, 2.2}));
}

}  // namespace

TEST_CASE("a plan saved in the middle of its work continues equally") {
    muster::ThreadPool pool(1);
    for (std::int32_t stop = 0; stop <= kSlices; ++stop) {
        CAPTURE(stop);
        const auto plan = muster::makeExactPlan();
        PlanResult first;
        REQUIRE(muster_test::planAtOnce(*plan, {}, scene(1), first).ok());
        const OwnedInput second = scene(2);
        REQUIRE(plan->start({}, second.view()).ok());
        for (std::int32_t slice = 0; slice < stop; ++slice) plan->advance(slice, kSlices, pool);

        const auto copy = muster::makeExactPlan();
        const std::vector<std::uint8_t> bytes = saved(*plan);
        REQUIRE(restore(*copy, bytes));
        CHECK(copy->pending());
        CHECK(hashed(*copy) == hashed(*plan));
        CHECK(saved(*copy) == bytes);
        checkSame(*plan, *copy, second);
        for (std::int32_t slice = stop; slice < kSlices; ++slice) {
            plan->advance(slice, kSlices, pool);
            copy->advance(slice, kSlices, pool);
            CHECK(hashed(*copy) == hashed(*plan));
        }
        PlanResult resultA, resultB;
        REQUIRE(plan->finish(pool, resultA).ok());
        REQUIRE(copy->finish(pool, resultB).ok());
        CHECK(resultA.cost == resultB.cost);
        CHECK(resultA.objective == resultB.objective);
        CHECK(resultA.gapBound == resultB.gapBound);
        CHECK(resultA.reassigned == resultB.reassigned);
        CHECK(muster_test::placesOf(resultA, 9) == muster_test::placesOf(resultB, 9));
        checkSame(*plan, *copy, second);
        CHECK(hashed(*copy) == hashed(*plan));
    }
}

TEST_CASE("an empty plan saves and loads, and loading it empties a used plan") {
    const auto empty = muster::makeExactPlan();
    const auto used = muster::makeExactPlan();
    PlanResult result;
    REQUIRE(muster_test::planAtOnce(*used, {}, scene(1), result).ok());
    CHECK(hashed(*used) != hashed(*empty));
    REQUIRE(restore(*used, saved(*empty)));
    CHECK(hashed(*used) == hashed(*empty));
    CHECK(used->costAt(0, {3, 3}) == muster_test::kUnreachable);
}

TEST_CASE("the hash follows inputs and progress") {
    muster::ThreadPool pool(1);
    const auto a = muster::makeExactPlan();
    const auto b = muster::makeExactPlan();
    OwnedInput input = scene(1);
    REQUIRE(a->start({}, input.view()).ok());
    REQUIRE(b->start({}, input.view()).ok());
    CHECK(hashed(*a) == hashed(*b));
    a->advance(0, kSlices, pool);
    CHECK(hashed(*a) != hashed(*b));
    b->advance(0, kSlices, pool);
    CHECK(hashed(*a) == hashed(*b));
    input.characters[4].x += 1e-12;
    REQUIRE(b->start({}, input.view()).ok());
    REQUIRE(a->start({}, scene(1).view()).ok());
    CHECK(hashed(*a) != hashed(*b));
}

TEST_CASE("truncated and damaged snapshots are refused") {
    const auto plan = muster::makeExactPlan();
    PlanResult result;
    REQUIRE(muster_test::planAtOnce(*plan, {}, scene(1), result).ok());
    REQUIRE(plan->start({}, scene(2).view()).ok());
    const std::vector<std::uint8_t> bytes = saved(*plan);
    // A fifth of the raw size of two grids, since runs of equal cells are packed.
    CHECK(bytes.size() < 2 * 64 * 64 * 16 / 5);
    const auto other = muster::makeExactPlan();
    for (std::size_t size = 0; size < bytes.size(); size += 97)
        CHECK_FALSE(restore(*other, {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}));
    CHECK_FALSE(other->pending());
    muster::Random random(6);
    for (int k = 0; k < 300; ++k) {
        std::vector<std::uint8_t> damaged = bytes;
        damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] ^= static_cast<std::uint8_t>(
            1u << random.below(8));
        // Damage never crashes; plausible damaged values are left to the snapshot's checksum.
        restore(*other, damaged);
    }
}
