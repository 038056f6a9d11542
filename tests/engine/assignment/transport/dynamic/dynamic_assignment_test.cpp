// Dynamic assignment compared with the exact optimum over many steps.
#include <doctest.h>

#include <numeric>

#include "engine/assignment/transport/dynamic/assignment_scene.h"

namespace {

using muster::DynamicAssignment;
using muster::Vec2;
using muster_test::AssignmentScene;
using muster_test::lowThresholds;

struct Run {
    double worst = 0.0;  // Gap at every 30th step, the first second left out.
    double mean = 0.0;
    long changes = 0;
};

// Follows the formation for so many steps; `velocity(time)` and `turning` move it.
template <class Velocity>
Run follow(AssignmentScene& scene, const muster::DynamicAssignmentDef& def, int steps, Velocity velocity,
           double turning) {
    DynamicAssignment assignment;
    muster::ThreadPool pool(1);
    assignment.coldStart(def, scene.input(), scene.costs, pool);
    CHECK(scene.valid(assignment.placeOf()));
    Run run;
    int samples = 0;
    std::vector<std::int32_t> before(assignment.placeOf().begin(), assignment.placeOf().end());
    for (int k = 1; k <= steps; ++k) {
        scene.step(velocity(scene.time), turning, assignment.placeOf());
        assignment.update(def, scene.input(), scene.costs, pool);
        for (std::size_t i = 0; i < before.size(); ++i)
            run.changes += before[i] != assignment.placeOf()[i] ? 1 : 0;
        before.assign(assignment.placeOf().begin(), assignment.placeOf().end());
        if (k % 30 != 0) continue;
        REQUIRE(scene.valid(assignment.placeOf()));
        const double exact = scene.objective(assignment.placeOf(), def.exponent);
        CHECK(assignment.objective() == doctest::Approx(exact).epsilon(1e-4));
        const double gap = scene.gap(assignment.placeOf(), def.exponent);
        CHECK(gap > -1e-6);
        if (k <= 60) continue;
        run.worst = std::max(run.worst, gap);
        run.mean += gap;
        ++samples;
    }
    run.mean /= std::max(samples, 1);
    return run;
}

Vec2 forward(double) {
    return {1.4, 0.0};
}
Vec2 reversing(double time) {
    return {std::fmod(time, 5.0) < 2.5 ? 1.4 : -1.4, 0.0};
}

}  // namespace

TEST_CASE("a crowd of 160 keeps to within half a percent of the optimum") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        AssignmentScene scene(160, 160, seed);
        CHECK(follow(scene, lowThresholds(), 420, forward, 0.05).worst < 0.005);
        AssignmentScene turning(160, 160, seed);
        CHECK(follow(
                  turning, lowThresholds(), 300,
                  [](double) {
                      return Vec2{1.1, 0.6};
                  },
                  0.1)
                  .worst < 0.005);
        AssignmentScene back(160, 160, seed);
        CHECK(follow(back, lowThresholds(), 420, reversing, 0.0).worst < 0.005);
    }
}

TEST_CASE("a crowd of 1,000 keeps to within half a percent of the optimum, and seldom swaps") {
    AssignmentScene scene(1000, 1000, 4);
    muster::DynamicAssignmentDef def = lowThresholds();
    const Run run = follow(scene, def, 360, forward, 0.02);
    CHECK(run.worst < 0.005);
    // Characters start at random positions: the first second sorts them, later hardly anybody changes places.
    CHECK(run.changes < 6 * 1000);
    AssignmentScene far(1000, 1000, 5, 60.0);
    CHECK(follow(far, def, 300, forward, 0.0).worst < 0.003);
}

TEST_CASE("a round that is spread over several steps keeps near the optimum") {
    for (const std::int32_t steps : {2, 3, 6}) {
        CAPTURE(steps);
        muster::DynamicAssignmentDef def = lowThresholds();
        def.stepsPerRound = steps;
        CHECK(def.refreshSteps() + def.repairSteps() == steps);
        AssignmentScene scene(1000, 1000, 14);
        const Run run = follow(scene, def, 420, forward, 0.02);
        CHECK(run.worst < 0.01);
        CHECK(run.mean < 0.004);
        AssignmentScene back(160, 160, 15);
        CHECK(follow(back, def, 420, reversing, 0.0).worst < 0.01);
    }
    muster::DynamicAssignmentDef one = lowThresholds();
    CHECK(one.rounds(4) == 4);
    one.stepsPerRound = 6;
    CHECK(one.rounds(4) == 2);
    CHECK(one.rounds(1) == 1);
}

TEST_CASE("the exponent may be 1 or 8") {
    for (const double p : {1.0, 8.0}) {
        muster::DynamicAssignmentDef def = lowThresholds();
        def.exponent = p;
        if (p == 1.0) def.threshold = 0.02;
        def.thresholdShare = 0.002;
        AssignmentScene scene(160, 160, 6);
        CHECK(follow(scene, def, 360, forward, 0.02).worst < 0.005);
    }
}

TEST_CASE("a wall between crowd and formation") {
    for (const std::uint64_t seed : {7, 8}) {
        AssignmentScene scene(160, 160, seed, 14.0);
        scene.costs.wall = true;
        scene.costs.low = {-7.0, -9.0};
        scene.costs.high = {-7.0, 5.0};
        const Run run = follow(
            scene, lowThresholds(), 600, [](double) { return Vec2{}; }, 0.0);
        CHECK(run.worst < 0.02);
        CHECK(run.mean < 0.005);
    }
}

TEST_CASE("characters may have different unit costs") {
    AssignmentScene scene(160, 160, 9);
    for (int i = 0; i < 160; ++i) scene.costs.unitCostOf.push_back(0.5 + 0.01 * i);
    muster::DynamicAssignmentDef def = lowThresholds();
    def.thresholdShare = 0.001;  // A share of 0.01 would keep back more than this test allows.
    CHECK(follow(scene, def, 360, forward, 0.02).worst < 0.005);
}

TEST_CASE("more places than characters, and fewer") {
    AssignmentScene more(140, 160, 10);
    CHECK(follow(more, lowThresholds(), 420, forward, 0.0).mean < 0.005);
    AssignmentScene fewer(160, 140, 11);
    CHECK(follow(fewer, lowThresholds(), 420, forward, 0.0).mean < 0.02);
}

TEST_CASE("places and characters that come and go are matched at once") {
    AssignmentScene scene(200, 200, 12);
    scene.usable.assign(200, 1);
    scene.present.assign(200, 1);
    DynamicAssignment assignment;
    muster::ThreadPool pool(1);
    const muster::DynamicAssignmentDef def = lowThresholds();
    assignment.coldStart(def, scene.input(), scene.costs, pool);
    double sum = 0.0;
    int samples = 0;
    for (int k = 1; k <= 400; ++k) {
        // Eight places close and open at random, as places next to a wall do.
        for (std::size_t j = 90; j < 98; ++j)
            if (scene.random.below(8) == 0) scene.usable[j] ^= 1;
        if (k % 10 == 0) scene.present[scene.random.below(200)] ^= 1;
        scene.step({1.0, 0.2}, 0.0, assignment.placeOf());
        assignment.update(def, scene.input(), scene.costs, pool);
        REQUIRE(scene.valid(assignment.placeOf()));
        if (k % 20 != 0) continue;
        sum += scene.gap(assignment.placeOf(), 2.0);
        ++samples;
    }
    CHECK(sum / samples < 0.12);
    // Once they stay, the optimum is found again.
    for (int k = 0; k < 120; ++k) {
        scene.step({1.0, 0.2}, 0.0, assignment.placeOf());
        assignment.update(def, scene.input(), scene.costs, pool);
    }
    CHECK(scene.gap(assignment.placeOf(), 2.0) < 0.01);
}

TEST_CASE("small cases: nobody, one place for two, two that cross") {
    muster::ThreadPool pool(1);
    const muster::DynamicAssignmentDef def = lowThresholds();
    DynamicAssignment assignment;
    AssignmentScene none(0, 0, 1);
    assignment.coldStart(def, none.input(), none.costs, pool);
    assignment.update(def, none.input(), none.costs, pool);
    CHECK(assignment.placeOf().empty());
    CHECK(assignment.objective() == 0.0);

    muster_test::WallCosts costs;
    costs.characters = {{0, 0}, {3, 0}};
    costs.places = {{4, 0}};
    const auto input = [&] { return muster::AssignmentInput{costs.characters, costs.places, {}, {}}; };
    assignment.update(def, input(), costs, pool);  // Other sizes lead to a cold start.
    CHECK(assignment.placeOf()[0] == -1);
    CHECK(assignment.placeOf()[1] == 0);
    CHECK(assignment.objective() == doctest::Approx(1.0));

    costs.places = {{4, 0}, {1, 0}};
    const std::int32_t crossed[] = {0, 1};
    assignment.warmStart(def, input(), crossed, costs, pool);
    CHECK(assignment.placeOf()[0] == 0);
    CHECK(assignment.objective() == doctest::Approx(20.0));
    assignment.update(def, input(), costs, pool);
    CHECK(assignment.placeOf()[0] == 1);
    CHECK(assignment.objective() == doctest::Approx(2.0));
    CHECK(assignment.dualityGap() == doctest::Approx(0.0));
}

TEST_CASE("a start that is spread over steps keeps all places, then improves as one at once does") {
    AssignmentScene scene(300, 300, 22);
    muster::ThreadPool pool(1);
    muster::DynamicAssignmentDef def = lowThresholds();
    def.startNodes = 90;
    DynamicAssignment first;
    first.coldStart(def, scene.input(), scene.costs, pool);
    std::vector<std::int32_t> held(first.placeOf().begin(), first.placeOf().end());
    // Some stand wrong, and two have no place.
    for (std::size_t i = 0; i + 7 < held.size(); i += 11) std::swap(held[i], held[i + 7]);
    held[5] = held[17] = -1;
    DynamicAssignment spread, atOnce;
    spread.beginFrom(def, scene.input(), held, scene.costs, pool);
    atOnce.warmStart(def, scene.input(), held, scene.costs, pool);
    int calls = 0;
    for (; spread.starting(); ++calls) {
        REQUIRE(calls < 10);
        CHECK(scene.valid(spread.placeOf()));
        for (std::size_t i = 0; i < held.size(); ++i)
            if (held[i] >= 0) CHECK(spread.placeOf()[i] == held[i]);
        CHECK(spread.dualityGap() == doctest::Approx(spread.objective()));
        spread.update(def, scene.input(), scene.costs, pool);
    }
    CHECK(calls == 5);  // 300 nodes, 90 in a call, and one for the duals.
    for (int k = 0; k < 20; ++k) {
        spread.update(def, scene.input(), scene.costs, pool);
        atOnce.update(def, scene.input(), scene.costs, pool);
    }
    CHECK(scene.gap(spread.placeOf(), def.exponent) < 0.005);
    CHECK(spread.objective() < 1.005 * atOnce.objective());
}

TEST_CASE("an exchange that gains too little is not committed") {
    muster::ThreadPool pool(1);
    muster_test::WallCosts costs;
    costs.characters = {{0, 0}, {0, 0.3}};
    costs.places = {{2, 0.1}, {2, 0}};  // Exchanging gains 2 x 0.1 x 0.3 = 0.06.
    const muster::AssignmentInput input{costs.characters, costs.places, {}, {}};
    const std::int32_t crossed[] = {0, 1};
    DynamicAssignment assignment;
    muster::DynamicAssignmentDef def = lowThresholds();
    def.threshold = 0.05;
    def.thresholdShare = 0.01;  // Of about 8, so that a gain of 0.08 is required.
    for (const double share : {0.01, 0.001}) {
        def.thresholdShare = share;
        assignment.warmStart(def, input, crossed, costs, pool);
        for (int k = 0; k < 40; ++k) assignment.update(def, input, costs, pool);
        CHECK(assignment.placeOf()[0] == (share == 0.01 ? 0 : 1));
    }
}

TEST_CASE("the duals prove a lower bound") {
    AssignmentScene scene(300, 300, 13);
    DynamicAssignment assignment;
    muster::ThreadPool pool(1);
    assignment.coldStart(lowThresholds(), scene.input(), scene.costs, pool);
    for (int k = 0; k < 60; ++k) {
        scene.step({1, 0}, 0.0, assignment.placeOf());
        assignment.update(lowThresholds(), scene.input(), scene.costs, pool);
    }
    std::vector<double> dual(300);
    assignment.duals(scene.input(), dual);
    double bound = 0.0;
    for (const double v : dual) bound += v;
    for (std::size_t i = 0; i < 300; ++i) {
        double least = 1e300;
        for (std::size_t j = 0; j < 300; ++j)
            least = std::min(least, muster::power(scene.costs.exact(i, j), 2.0) - dual[j]);
        bound += least;
    }
    const double best = scene.optimum(2.0);
    CHECK(bound <= best * (1 + 1e-6));
    CHECK(bound > 0.98 * best);
    CHECK(assignment.objective() <= best + assignment.dualityGap() + 0.02 * best);
}

TEST_CASE("costs that drift are followed, though they change little in any one step") {
    // Unit costs rise to four in a zone that crosses the crowd within seconds.
    AssignmentScene scene(160, 160, 6);
    scene.costs.unitCostOf.assign(160, 1.0);
    muster::DynamicAssignmentDef def = lowThresholds();
    DynamicAssignment assignment;
    muster::ThreadPool pool(1);
    assignment.coldStart(def, scene.input(), scene.costs, pool);
    double worst = 0.0;
    for (int k = 1; k <= 300; ++k) {
        scene.step(reversing(scene.time), 0.0, assignment.placeOf());
        for (std::size_t i = 0; i < 160; ++i) {
            const double zone = std::fabs(scene.costs.characters[i].y + 6.0 - 0.04 * k);
            scene.costs.unitCostOf[i] = 1.0 + 3.0 * std::max(0.0, 1.0 - zone / 2.0);
        }
        assignment.update(def, scene.input(), scene.costs, pool);
        if (k % 10 == 0 && k > 30) worst = std::max(worst, scene.gap(assignment.placeOf(), def.exponent));
    }
    CAPTURE(worst);
    CHECK(worst < 0.03);
}

TEST_CASE(
    "arcs with unsteady costs, and those of a crowd that has nearly arrived, are refreshed more often") {
    // Everybody stands half a metre from its place; the costs of one character are unsteady.
    class CountingCosts final : public muster_test::WallCosts {
    public:
        std::int32_t unsteadyCharacter = -1;
        std::vector<long> evaluations = std::vector<long>(160, 0);
        bool unsteady(std::int32_t character, std::int32_t) const override {
            return character == unsteadyCharacter;
        }
        void evaluate(std::span<const muster::AssignmentPair> pairs, std::span<float> cost,
                      muster::ThreadPool& pool) override {
            for (const muster::AssignmentPair& p : pairs) ++evaluations[p.character];
            WallCosts::evaluate(pairs, cost, pool);
        }
    };
    const auto evaluationsIn64Steps = [](std::int32_t unsteadyCharacter, double nearCost) {
        CountingCosts costs;
        std::vector<std::int32_t> placeOf;
        for (std::int32_t k = 0; k < 160; ++k) {
            costs.places.push_back(muster::Vec2{static_cast<double>(k % 16), static_cast<double>(k / 16)});
            costs.characters.push_back(costs.places.back() + muster::Vec2{0.5, 0.0});
            placeOf.push_back(k);
        }
        costs.unsteadyCharacter = unsteadyCharacter;
        muster::DynamicAssignmentDef def = lowThresholds();
        def.nearCost = nearCost;
        DynamicAssignment assignment;
        muster::ThreadPool pool(1);
        const muster::AssignmentInput input{costs.characters, costs.places, {}, {}};
        assignment.warmStart(def, input, placeOf, costs, pool);
        costs.evaluations.assign(160, 0);
        for (int k = 0; k < 64; ++k) assignment.update(def, input, costs, pool);
        return costs.evaluations;
    };
    const std::vector<long> usual = evaluationsIn64Steps(-1, 0.0);
    const std::vector<long> unsteady = evaluationsIn64Steps(70, 0.0);
    const std::vector<long> arrived = evaluationsIn64Steps(-1, 1.0);
    CHECK(unsteady[70] > usual[70] + 60);
    CHECK(unsteady[90] == usual[90]);
    const auto sum = [](const std::vector<long>& all) { return std::accumulate(all.begin(), all.end(), 0L); };
    // Matched costs are evaluated in each step.
    CHECK(sum(arrived) - 64 * 160 > 1.5 * (sum(usual) - 64 * 160));
}
