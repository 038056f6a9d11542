// The field cache: requests are served in order, unused fields are evicted at capacity.
#include <doctest.h>

#include <vector>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/geodesics/field_cache.h"

using namespace muster;
using namespace muster::test;

namespace {

// A cache over a small open ground; landmarks are its cells.
struct CacheScene {
    Environment environment = squareWorld(6.0);
    StaticGround ground;
    EikonalSolver solver;
    ThreadPool pool{1};
    FieldCache cache;
    std::vector<std::int32_t> solved;

    explicit CacheScene(std::int32_t capacity) : cache(capacity) {
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
    }
    Vec2 at(std::int32_t landmark) const { return ground.grid().centre(ground.grid().at(landmark)); }
    std::int32_t solve(std::int32_t most) {
        cache.beginStep();
        return cache.solveRequested(most, pool, [&](std::int32_t landmark, CostField& field, std::int32_t) {
            solved.push_back(landmark);
            solver.solve(ground.fineLevel().unitCost(), at(landmark), {}, field);
        });
    }
    // Every field is that of its landmark.
    bool consistent() const {
        for (std::int32_t slot = 0; slot < cache.count(); ++slot)
            if (distance(cache.field(slot).source(), at(cache.landmark(slot))) > 1e-9) return false;
        return true;
    }
};

}  // namespace

TEST_CASE("requests are served in order up to the budget, and the others are dropped") {
    CacheScene scene(16);
    for (const std::int32_t landmark : {700, 20, 700, 311, 20, 55}) scene.cache.request(landmark);
    CHECK(scene.solve(0) == 0);  // Drops nothing.
    CHECK(scene.solve(2) == 2);
    CHECK(scene.solved == std::vector<std::int32_t>{700, 20});
    CHECK(scene.solve(2) == 0);
    CHECK(scene.cache.find(311) == -1);
    CHECK(scene.cache.count() == 2);
    CHECK(scene.cache.use(20) == scene.cache.find(20));
    CHECK(scene.consistent());
    scene.cache.request(20);  // Has a field already.
    CHECK(scene.solve(4) == 0);
}

TEST_CASE("at capacity the fields unused for long are evicted, and the others stay consistent") {
    CacheScene scene(8);
    for (std::int32_t landmark = 100; landmark < 108; ++landmark) scene.cache.request(landmark);
    scene.solve(100);
    CHECK(scene.cache.count() == 8);
    const std::uint32_t before = scene.cache.generation();
    // All are in use, so that none is evicted.
    scene.cache.request(300);
    CHECK(scene.solve(1) == 0);
    for (int step = 0; step < 300; ++step) {
        scene.cache.beginStep();
        for (const std::int32_t landmark : {101, 104, 107}) CHECK(scene.cache.use(landmark) >= 0);
    }
    for (const std::int32_t landmark : {300, 301}) scene.cache.request(landmark);
    CHECK(scene.solve(5) == 2);
    CHECK(scene.cache.count() == 5);
    CHECK(scene.cache.generation() > before);
    CHECK(scene.cache.find(100) == -1);
    for (const std::int32_t landmark : {101, 104, 107, 300, 301}) CHECK(scene.cache.find(landmark) >= 0);
    CHECK(scene.consistent());
    scene.cache.clear();
    CHECK(scene.cache.count() == 0);
    CHECK(scene.cache.find(101) == -1);
}

TEST_CASE("an archive restores which fields there are, and one beyond the capacity is refused") {
    CacheScene scene(32);
    for (std::int32_t landmark = 0; landmark < 900; landmark += 61) scene.cache.request(landmark);
    scene.solve(9);
    Writer writer;
    scene.cache.visit(writer);
    CacheScene copy(32);
    Reader reader(writer.bytes());
    copy.cache.visit(reader);
    REQUIRE(reader.ok());
    copy.cache.solveMissing(copy.pool, [&](std::int32_t landmark, CostField& field, std::int32_t) {
        copy.solver.solve(copy.ground.fineLevel().unitCost(), copy.at(landmark), {}, field);
    });
    CHECK(copy.cache.count() == 9);
    CHECK(copy.consistent());
    for (std::int32_t landmark = 0; landmark < 900; landmark += 61)
        CHECK(copy.cache.find(landmark) == scene.cache.find(landmark));
    CacheScene small(4);  // Its capacity is below the number saved.
    Reader again(writer.bytes());
    small.cache.visit(again);
    CHECK_FALSE(again.ok());
}

TEST_CASE(
    "fields are taken over by landmark, only what is missing is solved, and lost ones are solved again") {
    CacheScene before(32);
    for (std::int32_t landmark = 0; landmark < 900; landmark += 61) before.cache.request(landmark);
    before.solve(9);
    Writer writer;
    before.cache.visit(writer);
    before.cache.request(899);  // The later cache has one more, and others in other slots.
    before.solve(1);
    CacheScene copy(32);
    Reader reader(writer.bytes());
    copy.cache.visit(reader);
    copy.cache.keepFieldsOf(before.cache);
    std::int32_t solved = 0;
    const auto solve = [&](std::int32_t landmark, CostField& field, std::int32_t) {
        copy.solver.solve(copy.ground.fineLevel().unitCost(), copy.at(landmark), {}, field);
        ++solved;
    };
    copy.cache.loseFields([](std::int32_t landmark) { return landmark == 61 || landmark == 122; });
    copy.cache.solveMissing(copy.pool, solve);
    CHECK(solved == 2);
    CHECK(copy.consistent());
    copy.cache.solveMissing(copy.pool, solve);
    CHECK(solved == 2);
    // Of a cache whose own fields are missing nothing is taken.
    CacheScene unsolved(32), other(32);
    Reader again(writer.bytes()), third(writer.bytes());
    unsolved.cache.visit(again);
    other.cache.visit(third);
    other.cache.keepFieldsOf(unsolved.cache);
    other.cache.solveMissing(copy.pool, solve);
    CHECK(solved == 2 + 9);
}

TEST_CASE("a field that a rewound cache had later is taken when it is asked for, not one of other ground") {
    CacheScene before(32);
    for (const std::int32_t landmark : {100, 161, 222}) before.cache.request(landmark);
    before.solve(9);
    Writer writer;
    before.cache.visit(writer);
    for (const std::int32_t landmark : {500, 501, 502}) before.cache.request(landmark);
    before.solve(9);
    CacheScene copy(32);
    Reader reader(writer.bytes());
    copy.cache.visit(reader);
    copy.cache.keepFieldsOf(before.cache);
    copy.cache.drop([](std::int32_t landmark) { return landmark == 501; });
    for (const std::int32_t landmark : {502, 501, 600}) copy.cache.request(landmark);
    CHECK(copy.solve(9) == 3);  // All count.
    CHECK(copy.solved == std::vector<std::int32_t>{501, 600});
    CHECK(copy.consistent());
    copy.cache.clear();
    copy.cache.request(500);
    CHECK(copy.solve(9) == 1);
    CHECK(copy.solved.back() == 500);
}
