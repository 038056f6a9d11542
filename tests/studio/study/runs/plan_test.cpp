#include "studio/study/runs/run_plan.h"

#include <doctest.h>

#include <map>
#include <set>

namespace muster {
namespace {

PeoplePlan planOf(std::int64_t number) {
    const auto plan = planPeople({}, number);
    REQUIRE(plan.ok());
    return plan.value();
}

TEST_CASE("eight runs in a row have all orders; environments and their neighbours are balanced") {
    for (const std::int64_t from : {0, 3, 16}) {
        std::set<std::int32_t> orders;
        std::map<std::string, int> places;
        std::map<std::string, int> neighbours;
        for (std::int64_t number = from; number < from + kPeopleOrders; ++number) {
            const PeoplePlan plan = planOf(number);
            orders.insert(plan.order);
            REQUIRE(plan.trials.size() == 10);
            for (std::size_t i = 0; i < 10; ++i) {
                const PlannedTrial& trial = plan.trials[i];
                CHECK(trial.practice == (i % 5 == 0));
                CHECK(trial.period == (i < 5 ? 1 : 2));
                CHECK(trial.position == static_cast<std::int32_t>(i % 5));
                CHECK(trial.def.scheme == plan.schemes[i / 5]);
                if (trial.practice) continue;
                ++places[trial.def.scheme + trial.def.environment + std::to_string(trial.period) +
                         std::to_string(trial.position)];
                if (trial.position > 1)
                    ++neighbours[plan.trials[i - 1].def.environment + ' ' + trial.def.environment];
            }
        }
        CHECK(orders.size() == kPeopleOrders);
        CHECK(places.size() == 2 * 4 * 2 * 4);
        for (const auto& [name, count] : places) CHECK(count == 1);
        CHECK(neighbours.size() == 12);
        for (const auto& [name, count] : neighbours) CHECK(count == 4);
    }
}

TEST_CASE("both controls have one layout, mirrored; who gets which is swapped over sixteen runs") {
    std::map<std::string, int> mirrored;
    std::set<std::uint64_t> seeds;
    for (std::int64_t number = 0; number < 16; ++number) {
        const PeoplePlan plan = planOf(number);
        for (std::size_t i = 1; i < 5; ++i)
            for (std::size_t j = 6; j < 10; ++j) {
                const TrialDef& one = plan.trials[i].def;
                const TrialDef& two = plan.trials[j].def;
                if (one.environment != two.environment) continue;
                CHECK(one.seed == two.seed);
                CHECK(one.mirrored != two.mirrored);
                CHECK(seeds.insert(one.seed).second);
                const TrialDef& touch = one.scheme == "touch" ? one : two;
                if (touch.mirrored)
                    ++mirrored[touch.environment + std::to_string(plan.trials[i].position) + plan.schemes[0]];
            }
    }
    // Four environments, four places, two orders of the controls: each twice, once mirrored under touch.
    CHECK(mirrored.size() == 32);
    for (const auto& [name, count] : mirrored) CHECK(count == 1);
    CHECK(seeds.size() == 64);
}

TEST_CASE("all trials of a plan can be built, and equal numbers give equal plans") {
    const PeoplePlan plan = planOf(5);
    const PeoplePlan again = planOf(5);
    for (std::size_t i = 0; i < plan.trials.size(); ++i) {
        CHECK(Trial::create(plan.trials[i].def).ok());
        CHECK(plan.trials[i].def.seed == again.trials[i].def.seed);
        CHECK(plan.trials[i].def.environment == again.trials[i].def.environment);
    }
}

TEST_CASE("plans that make no sense are refused by name") {
    CHECK(planPeople({}, -1).status().message().find("-1") != std::string::npos);
    CHECK(planPeople({"touch", 36}, 0).status().message().find("'touch' is no mouse") != std::string::npos);
    CHECK(planPeople({"touch-no-splits", 36}, 0).ok() == false);
    CHECK(planPeople({"trackball", 36}, 0).status().message().find("trackball") != std::string::npos);
    CHECK(planPeople({"mouse-paper", 0}, 0).status().message().find("crowd is 0") != std::string::npos);
    CHECK(planPeople({"mouse-paper", 16}, 0).ok());
}

}  // namespace
}  // namespace muster
