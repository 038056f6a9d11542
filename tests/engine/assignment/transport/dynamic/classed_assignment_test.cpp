// Characters and places with classes: everybody in the own class, near the optimum of each class alone.
#include "engine/assignment/transport/dynamic/classed_assignment.h"

#include <doctest.h>

#include "base/archive.h"
#include "engine/assignment/transport/dynamic/assignment_scene.h"

using namespace muster;
using namespace muster_test;

namespace {

/// A scene whose places have classes by rows, and whose characters have them at random.
struct ClassedScene : AssignmentScene {
    std::vector<std::uint8_t> characterClass, placeClass;

    ClassedScene(std::int32_t count, std::int32_t classes, std::uint64_t seed, double away)
        : AssignmentScene(count, count, seed, away) {
        // Classes of 1/2, 1/4, ... of the places; the last takes the rest.
        for (std::int32_t k = 0; k < count; ++k) {
            std::int32_t c = 0;
            for (std::int32_t rest = count / 2; c + 1 < classes && k >= count - rest; rest /= 2) ++c;
            placeClass.push_back(static_cast<std::uint8_t>(3 * c));
        }
        characterClass = placeClass;
        for (std::size_t k = characterClass.size(); k > 1; --k)
            std::swap(characterClass[k - 1], characterClass[random.below(static_cast<std::uint32_t>(k))]);
    }
    AssignmentClasses classes() const { return {characterClass, placeClass}; }
    std::int32_t strangers(std::span<const std::int32_t> placeOf) const {
        std::int32_t count = 0;
        for (std::size_t i = 0; i < placeOf.size(); ++i)
            if (placeOf[i] >= 0 && placeClass[placeOf[i]] != characterClass[i]) ++count;
        return count;
    }
    /// The sum of the optima of all classes, by a dense solver for each.
    double optimumByClass() const {
        double sum = 0.0;
        for (std::int32_t c = 0; c < 256; ++c) {
            std::vector<std::size_t> rows, columns;
            for (std::size_t i = 0; i < characterClass.size(); ++i)
                if (characterClass[i] == c) rows.push_back(i);
            for (std::size_t j = 0; j < placeClass.size(); ++j)
                if (placeClass[j] == c && input().isUsable(static_cast<std::int32_t>(j)))
                    columns.push_back(j);
            const bool transposed = rows.size() > columns.size();
            std::vector<double> matrix;
            for (const std::size_t a : transposed ? columns : rows)
                for (const std::size_t b : transposed ? rows : columns) {
                    const double cost = transposed ? costs.exact(b, a) : costs.exact(a, b);
                    matrix.push_back(cost * cost);
                }
            if (!matrix.empty())
                sum += leastSum(static_cast<std::int32_t>(std::min(rows.size(), columns.size())),
                                static_cast<std::int32_t>(std::max(rows.size(), columns.size())), matrix);
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("everybody ends in the own class, near the optimum of each class alone") {
    ThreadPool pool(1);
    for (const std::int32_t count : {36, 150, 600, 1500})
        for (std::uint64_t seed = 1; seed <= (count > 600 ? 2 : 6); ++seed) {
            ClassedScene scene(count, 2 + static_cast<std::int32_t>(seed % 4), seed, 8.0);
            scene.costs.wall = seed % 2 == 0;
            scene.costs.low = {-4, -6};
            scene.costs.high = {-4, 3};
            ClassedAssignment assignment;
            const DynamicAssignmentDef def = lowThresholds();
            assignment.coldStart(def, scene.input(), scene.classes(), scene.costs, pool);
            CHECK(scene.strangers(assignment.placeOf()) == 0);
            std::vector<std::int32_t> places;
            for (int step = 0; step < 40; ++step) {
                scene.step({1.2, 0.3}, 0.03, assignment.placeOf());
                places.assign(assignment.placeOf().begin(), assignment.placeOf().end());
                assignment.update(def, scene.input(), scene.classes(), places, scene.costs, pool);
                REQUIRE(scene.strangers(assignment.placeOf()) == 0);
                REQUIRE(scene.valid(assignment.placeOf()));
            }
            const double gap = scene.objective(assignment.placeOf(), 2.0) / scene.optimumByClass() - 1.0;
            INFO("count " << count << ", seed " << seed << ", gap " << gap);
            CHECK(gap > -1e-9);
            CHECK(gap < 0.02);
        }
}

TEST_CASE("classes may change from step to step, and places come and go") {
    ThreadPool pool(1);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        ClassedScene scene(200, 3, seed, 3.0);
        scene.usable.assign(200, 1);
        ClassedAssignment assignment;
        const DynamicAssignmentDef def = lowThresholds();
        assignment.coldStart(def, scene.input(), scene.classes(), scene.costs, pool);
        std::vector<std::int32_t> places;
        for (int step = 0; step < 120; ++step) {
            scene.step({1.2, 0.3}, 0.03, assignment.placeOf());
            const auto a = scene.random.below(200), b = scene.random.below(200);
            if (step % 3 == 0) scene.usable[a] ^= 1;
            if (step % 5 == 0) std::swap(scene.placeClass[a], scene.placeClass[b]);
            if (step % 40 == 0) std::swap(scene.characterClass[a], scene.characterClass[b]);
            places.assign(assignment.placeOf().begin(), assignment.placeOf().end());
            assignment.update(def, scene.input(), scene.classes(), places, scene.costs, pool);
            REQUIRE(scene.valid(assignment.placeOf()));
            // In each class as many as can be.
            for (const int c : {0, 3, 6}) {
                int characters = 0, open = 0, pairs = 0;
                for (std::size_t i = 0; i < 200; ++i) {
                    characters += scene.characterClass[i] == c ? 1 : 0;
                    open += scene.placeClass[i] == c && scene.usable[i] != 0 ? 1 : 0;
                    const std::int32_t j = assignment.placeOf()[i];
                    pairs += j >= 0 && scene.characterClass[i] == c && scene.placeClass[j] == c ? 1 : 0;
                }
                REQUIRE(pairs == std::min(characters, open));
            }
        }
    }
}

TEST_CASE("who finds no place in the own class takes another, and keeps it") {
    ThreadPool pool(1);
    ClassedScene scene(60, 2, 4, 5.0);
    // Ten more of the first class than it has places.
    int changed = 0;
    for (std::uint8_t& c : scene.characterClass)
        if (c == 3 && changed < 10) {
            c = 0;
            ++changed;
        }
    ClassedAssignment assignment;
    const DynamicAssignmentDef def = lowThresholds();
    assignment.coldStart(def, scene.input(), scene.classes(), scene.costs, pool);
    CHECK(scene.valid(assignment.placeOf()));
    CHECK(scene.strangers(assignment.placeOf()) == 10);
    std::vector<std::int32_t> places, before;
    int moves = 0;
    for (int step = 0; step < 60; ++step) {
        places.assign(assignment.placeOf().begin(), assignment.placeOf().end());
        assignment.update(def, scene.input(), scene.classes(), places, scene.costs, pool);
        if (step >= 30)
            for (std::size_t i = 0; i < 60; ++i) moves += places[i] != assignment.placeOf()[i] ? 1 : 0;
    }
    CHECK(scene.strangers(assignment.placeOf()) == 10);
    CHECK(moves == 0);
}

TEST_CASE("a class that is restored goes on with the same bits") {
    ThreadPool pool(1);
    ClassedScene scene(150, 3, 9, 4.0);
    const DynamicAssignmentDef def = lowThresholds();
    ClassedAssignment first;
    first.coldStart(def, scene.input(), scene.classes(), scene.costs, pool);
    std::vector<std::int32_t> places;
    const auto go = [&](ClassedAssignment& assignment) {
        places.assign(assignment.placeOf().begin(), assignment.placeOf().end());
        assignment.update(def, scene.input(), scene.classes(), places, scene.costs, pool);
    };
    for (int step = 0; step < 15; ++step) go(first);
    Writer writer;
    writer(first);
    ClassedAssignment second;
    Reader reader(writer.bytes());
    reader(second);
    REQUIRE(reader.ok());
    for (int step = 0; step < 40; ++step) {
        if (step == 20) std::swap(scene.placeClass[3], scene.placeClass[148]);
        go(first);
        go(second);
        REQUIRE(std::equal(first.placeOf().begin(), first.placeOf().end(), second.placeOf().begin()));
        CHECK(first.dualityGap() == second.dualityGap());
        scene.step({1.0, 0.0}, 0.05, first.placeOf());
    }
}
