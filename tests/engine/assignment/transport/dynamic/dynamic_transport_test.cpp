// Supplies and demands in the plane, against the dense solver.
#include "engine/assignment/transport/dynamic/dynamic_transport.h"

#include <doctest.h>

#include "base/archive.h"
#include "engine/assignment/transport/dynamic/assignment_scene.h"

using namespace muster;
using namespace muster_test;

namespace {

struct TransportScene : AssignmentScene {
    std::vector<double> supply, demand;
    std::vector<std::uint8_t> characterClass, placeClass;

    TransportScene(std::int32_t characters, std::int32_t places, std::uint64_t seed, double away)
        : AssignmentScene(characters, places, seed, away) {
        for (std::int32_t i = 0; i < characters; ++i) supply.push_back(0.25 * (1 + random.below(12)));
        for (std::int32_t j = 0; j < places; ++j) demand.push_back(0.1 * random.below(30));
    }
    DynamicTransport transport;
    void update(ThreadPool& pool) {
        const AssignmentInput positions = input();
        transport.update({positions, supply, demand, {characterClass, placeClass}, 2.0}, costs, pool);
    }
    double supplyOf(std::size_t i) const {
        return input().isPresent(static_cast<std::int32_t>(i)) ? supply[i] : 0;
    }
    double demandOf(std::size_t j) const {
        return input().isUsable(static_cast<std::int32_t>(j)) ? demand[j] : 0;
    }
    double amount() const {
        double sum = 0.0;
        for (const Flow& flow : transport.flows()) sum += flow.amount;
        return sum;
    }
    double objective() const {
        double sum = 0.0;
        for (const Flow& flow : transport.flows()) {
            const double c = costs.exact(flow.character, flow.place);
            sum += flow.amount * c * c;
        }
        return sum;
    }
    // The largest amount and its least cost by the dense solver.
    TransportationSolution optimum(double penalty = 0.0) const {
        std::vector<double> matrix, s, d;
        for (std::size_t i = 0; i < supply.size(); ++i) {
            s.push_back(supplyOf(i));
            for (std::size_t j = 0; j < demand.size(); ++j) {
                const double c = costs.exact(i, j);
                const bool same = characterClass.empty() || characterClass[i] == placeClass[j];
                matrix.push_back(c * c + (same ? 0.0 : penalty));
            }
        }
        for (std::size_t j = 0; j < demand.size(); ++j) d.push_back(demandOf(j));
        TransportationSolution solution;
        const auto rows = static_cast<std::int32_t>(s.size()), columns = static_cast<std::int32_t>(d.size());
        REQUIRE(TransportationSolver().solve({rows, columns, matrix, s, d}, solution).ok());
        return solution;
    }
    // Nobody sends more than there is, no place gets more than it demands.
    bool feasible() const {
        std::vector<double> sent(supply.size(), 0.0), filled(demand.size(), 0.0);
        for (const Flow& flow : transport.flows()) {
            if (flow.amount <= 0.0) return false;
            sent[flow.character] += flow.amount;
            filled[flow.place] += flow.amount;
        }
        for (std::size_t i = 0; i < sent.size(); ++i)
            if (sent[i] > supplyOf(i) + 1e-9) return false;
        for (std::size_t j = 0; j < filled.size(); ++j)
            if (filled[j] > demandOf(j) + 1e-9) return false;
        return true;
    }
    std::vector<std::int32_t> mainPlaces() const {
        std::vector<std::int32_t> places(supply.size(), -1);
        std::vector<double> most(supply.size(), 0.0);
        for (const Flow& flow : transport.flows())
            if (flow.amount > most[flow.character]) {
                most[flow.character] = flow.amount;
                places[flow.character] = flow.place;
            }
        return places;
    }
};

}  // namespace

TEST_CASE("a transport becomes the optimum of the dense solver, and follows it") {
    ThreadPool pool(1);
    for (const std::int32_t count : {12, 40, 150}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            TransportScene scene(count, count + static_cast<std::int32_t>(seed) - 3, seed, 6.0);
            scene.costs.wall = seed % 2 == 0;
            scene.costs.low = {-3, -5};
            scene.costs.high = {-3, 2};
            for (int step = 0; step < 40; ++step) {
                scene.update(pool);
                REQUIRE(scene.feasible());
                if (step % 10 != 9) {
                    scene.step({1.0, 0.3}, 0.1, scene.mainPlaces());
                    continue;
                }
                const TransportationSolution best = scene.optimum();
                INFO("count " << count << ", seed " << seed << ", step " << step);
                CHECK(scene.amount() == doctest::Approx(best.amount));
                CHECK(scene.objective() <= best.cost * 1.005 + 1e-6);
                CHECK(scene.objective() >= best.cost * 0.99999 - 1e-6);
            }
        }
    }
}

TEST_CASE("a large transport comes near the optimum within a second of steps") {
    ThreadPool pool(1);
    TransportScene scene(300, 290, 3, 20.0);
    for (int step = 0; step < 40; ++step) scene.update(pool);
    const TransportationSolution best = scene.optimum();
    CHECK(scene.amount() == doctest::Approx(best.amount));
    CHECK(scene.objective() <= best.cost * 1.001);
}

TEST_CASE("amounts, places and characters come and go") {
    ThreadPool pool(1);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TransportScene scene(60, 55, seed, 3.0);
        scene.usable.assign(55, 1);
        scene.present.assign(60, 1);
        for (int step = 0; step < 100; ++step) {
            scene.supply[scene.random.below(60)] = 0.5 * (1 + scene.random.below(8));
            scene.demand[scene.random.below(55)] = scene.random.below(4) / 3.0;
            if (step % 2 == 0) scene.usable[scene.random.below(55)] ^= 1;
            if (step % 5 == 0) scene.present[scene.random.below(60)] ^= 1;
            scene.update(pool);
            REQUIRE(scene.feasible());
            if (step % 10 != 9) continue;
            for (int k = 0; k < 4; ++k) scene.update(pool);
            const TransportationSolution best = scene.optimum();
            CHECK(scene.amount() == doctest::Approx(best.amount));
            CHECK(scene.objective() <= best.cost * 1.005 + 1e-6);
        }
    }
}

TEST_CASE("classes come before costs") {
    ThreadPool pool(1);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TransportScene scene(50, 48, seed, 4.0);
        for (int i = 0; i < 50; ++i)
            scene.characterClass.push_back(static_cast<std::uint8_t>(scene.random.below(3)));
        for (int j = 0; j < 48; ++j)
            scene.placeClass.push_back(static_cast<std::uint8_t>(scene.random.below(3)));
        for (int k = 0; k < 20; ++k) scene.update(pool);
        constexpr double kPenalty = 1e6;
        const TransportationSolution best = scene.optimum(kPenalty);
        double strangers = 0.0, fewest = 0.0;
        for (const Flow& flow : scene.transport.flows())
            if (scene.characterClass[flow.character] != scene.placeClass[flow.place])
                strangers += flow.amount;
        for (const Flow& flow : best.flows)
            if (scene.characterClass[flow.character] != scene.placeClass[flow.place]) fewest += flow.amount;
        CHECK(scene.amount() == doctest::Approx(best.amount));
        CHECK(strangers == doctest::Approx(fewest));
        CHECK(scene.objective() <= (best.cost - kPenalty * fewest) * 1.005 + 1e-3);
    }
}

TEST_CASE("a transport that is restored goes on with the same bits") {
    ThreadPool pool(1);
    TransportScene scene(120, 110, 8, 5.0);
    for (int step = 0; step < 10; ++step) scene.update(pool);
    Writer writer;
    writer(scene.transport);
    TransportScene copy = scene;
    copy.transport.clear();
    Reader reader(writer.bytes());
    reader(copy.transport);
    REQUIRE(reader.ok());
    for (int step = 0; step < 30; ++step) {
        scene.step({1.0, 0.2}, 0.05, scene.mainPlaces());
        copy.costs.characters = scene.costs.characters;
        copy.costs.places = scene.costs.places;
        scene.update(pool);
        copy.update(pool);
        REQUIRE(scene.transport.flows().size() == copy.transport.flows().size());
        CHECK(scene.objective() == copy.objective());
        CHECK(scene.transport.gap() == copy.transport.gap());
    }
}

TEST_CASE("nobody, nothing, and amounts of zero are fine") {
    ThreadPool pool(1);
    TransportScene scene(5, 4, 1, 1.0);
    scene.supply.assign(5, 0.0);
    scene.update(pool);
    CHECK(scene.transport.flows().empty());
    scene.supply.assign(5, 2.0);
    scene.demand.assign(4, 0.0);
    scene.update(pool);
    CHECK(scene.transport.flows().empty());
    // Thirds that do not fill a whole leave nobody matched by rounding.
    scene.supply = {1, 1, 1, 1, 1};
    scene.demand = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
    for (int k = 0; k < 5; ++k) scene.update(pool);
    CHECK(scene.amount() == doctest::Approx(1.0));
    DynamicTransport none;
    const AssignmentInput empty{};
    none.update({empty, {}, {}, {}, 2.0}, scene.costs, pool);
    CHECK(none.flows().empty());
}
