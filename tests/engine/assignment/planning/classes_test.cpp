// Plans with classes of characters and places.
#include <doctest.h>

#include "base/infinite_cost.h"
#include "engine/assignment/planning/walk_scene.h"

using namespace muster;
using muster_test::Walk;

namespace {

// Front rows of class 1, back rows of class 2, the others of none; characters in any order.
Walk classed(std::int32_t count, std::uint64_t seed) {
    Walk scene(count, {-12, -1}, {11, 2}, seed);
    Random random(seed + 100);
    for (std::int32_t k = 0; k < count; ++k)
        scene.placeClass.push_back(static_cast<std::uint8_t>(k < count / 4            ? 1
                                                             : k >= count - count / 3 ? 2
                                                                                      : 0));
    scene.characterClass = scene.placeClass;
    for (std::size_t k = scene.characterClass.size(); k > 1; --k)
        std::swap(scene.characterClass[k - 1],
                  scene.characterClass[random.below(static_cast<std::uint32_t>(k))]);
    return scene;
}

std::int32_t strangers(const Walk& scene) {
    std::int32_t count = 0;
    for (std::size_t i = 0; i < scene.incumbent.size(); ++i)
        if (scene.incumbent[i] >= 0 && scene.placeClass[scene.incumbent[i]] != scene.characterClass[i])
            ++count;
    return count;
}

}  // namespace

TEST_CASE("with classes the fast plan stays near the exact one, and everybody in the own class") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        Walk scene = classed(100, seed);
        const auto plan = makeFastPlan();
        ThreadPool pool(2);
        double worst = 0.0;
        for (int step = 0; step < 240; ++step) {
            scene.take(scene.plan(*plan, pool));
            REQUIRE(strangers(scene) == 0);
            scene.walk(*plan, pool, 0.05);
            for (Vec2& p : scene.places) p += Vec2{0.004, 0.006};
            if (step % 60 == 59) worst = std::max(worst, scene.gap(pool));
        }
        CHECK(worst < 0.02);
    }
}

TEST_CASE("the exact plan with classes is the sum of the exact plans of all classes") {
    Walk scene = classed(36, 4);
    ThreadPool pool(1);
    const PlanResult whole = scene.plan(*makeExactPlan(), pool);
    scene.take(whole);
    CHECK(strangers(scene) == 0);
    double sum = 0.0;
    for (const int c : {0, 1, 2}) {
        Walk part = classed(36, 4);
        part.characters.clear();
        part.places.clear();
        for (std::size_t k = 0; k < 36; ++k) {
            if (scene.characterClass[k] == c) part.characters.push_back(scene.characters[k]);
            if (scene.placeClass[k] == c) part.places.push_back(scene.places[k]);
        }
        part.characterClass.clear();
        part.placeClass.clear();
        part.incumbent.assign(part.characters.size(), -1);
        sum += part.plan(*makeExactPlan(), pool).objective;
    }
    CHECK(whole.objective == doctest::Approx(sum));
    CHECK(whole.gapBound == doctest::Approx(0.0));
}

TEST_CASE("both plans fill all places when a class has too few of its own") {
    for (const bool fast : {false, true}) {
        Walk scene = classed(36, 5);
        int changed = 0;
        for (std::uint8_t& c : scene.characterClass)
            if (c == 2 && changed < 4) {
                c = 1;
                ++changed;
            }
        const auto plan = fast ? makeFastPlan() : makeExactPlan();
        ThreadPool pool(1);
        for (int k = 0; k < 40; ++k) {
            const PlanResult result = scene.plan(*plan, pool);
            scene.take(result);
            CHECK(result.flows.size() == 36);
            if (k > 30) CHECK(result.reassigned == 0);
        }
        CHECK(strangers(scene) == 4);
    }
}

TEST_CASE("classes that change move those concerned only") {
    Walk scene = classed(64, 6);
    const auto plan = makeFastPlan();
    ThreadPool pool(1);
    for (int k = 0; k < 40; ++k) scene.take(scene.plan(*plan, pool));
    std::swap(scene.placeClass[0], scene.placeClass[63]);
    const std::vector<std::int32_t> before = scene.incumbent;
    for (int k = 0; k < 20; ++k) scene.take(scene.plan(*plan, pool));
    CHECK(strangers(scene) == 0);
    int moved = 0;
    for (std::size_t i = 0; i < 64; ++i) moved += scene.incumbent[i] != before[i] ? 1 : 0;
    CHECK(moved >= 2);
    // None but the classes of these two places: 16 of class 1 and 21 of class 2.
    for (std::size_t i = 0; i < 64; ++i)
        if (scene.characterClass[i] == 0) CHECK(scene.incumbent[i] == before[i]);
}

TEST_CASE("classes need a class for each character and place") {
    Walk scene = classed(36, 7);
    scene.placeClass.pop_back();
    CHECK(!makeFastPlan()->start(scene.def, scene.input()).ok());
    CHECK(!makeExactPlan()->start(scene.def, scene.input()).ok());
}
