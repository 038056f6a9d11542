#include "overrides.h"

#include <doctest.h>

#include <string>

#include "muster/parameter_table.h"

using namespace muster;

namespace {

WorldDef defOf() {
    return {.box = {{-10, -10}, {10, 10}}};
}

/// Names of the parameters in which two sets differ.
std::vector<std::string> differences(const Parameters& a, const Parameters& b) {
    std::vector<std::string> names;
    for (const ParameterInfo& info : parameterTable())
        if (info.get(a) != info.get(b)) names.emplace_back(info.name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("each option changes what it names and nothing else") {
    const WorldDef before = defOf();
    WorldDef def = before;
    CHECK(Overrides{}.apply(def).ok());
    CHECK(differences(def.parameters, before.parameters).empty());
    CHECK(Overrides{"exact", "", {}}.apply(def).ok());
    CHECK(differences(def.parameters, before.parameters) == Names{"plan.solver"});
    CHECK(Overrides{"fast", "", {}}.apply(def).ok());
    CHECK(differences(def.parameters, before.parameters).empty());
    CHECK(Overrides{"", "", {"character.radius=0.3", "cost.gamma=2"}}.apply(def).ok());
    CHECK(differences(def.parameters, before.parameters) == Names{"cost.gamma", "character.radius"});
    CHECK(def.parameters.character.radius == 0.3);
    CHECK(def.parameters.cost.gamma == 2.0);
}

TEST_CASE("settings come after the plan, the plan after the preset, and a preset leaves all else") {
    WorldDef def = defOf();
    def.parameters.character.maxSpeed = 1.25;
    REQUIRE(Overrides{"fast", "paper", {"plan.exponent=3", "plan.exponent=4"}}.apply(def).ok());
    CHECK(def.parameters.plan.solver == PlanSolver::Fast);  // The paper's is exact.
    CHECK(def.parameters.plan.exponent == 4.0);             // The paper's is 1; the last setting stands.
    CHECK(def.parameters.plan.threshold == 0.0);
    CHECK(def.parameters.plan.period == 1);
    CHECK(def.parameters.character.maxSpeed == 1.25);
    REQUIRE(Overrides{"exact", "", {"plan.solver=1"}}.apply(def).ok());
    CHECK(def.parameters.plan.solver == PlanSolver::Fast);
    REQUIRE(Overrides{"", "muster", {}}.apply(def).ok());
    CHECK(differences(def.parameters, Parameters{}) == Names{"plan.exponent", "character.maxSpeed"});
    REQUIRE(Overrides{"", "people", {}}.apply(def).ok());
    CHECK(def.parameters.character.maxSpeed == 1.34);
    REQUIRE(Overrides{"", "units", {}}.apply(def).ok());
    CHECK(differences(def.parameters, Parameters{}) == Names{"plan.exponent"});
}

TEST_CASE("what is no setting is refused with the option and the culprit in the sentence") {
    const auto refused = [](const Overrides& overrides, const std::string& option,
                            const std::string& culprit) {
        WorldDef def = defOf();
        const Status status = overrides.apply(def);
        CAPTURE(culprit);
        CHECK(!status.ok());
        CHECK(status.message().rfind(option + ": ", 0) == 0);
        CHECK_MESSAGE(status.message().find(culprit) != std::string::npos, status.message());
    };
    for (const std::string bad : {"", "=", "plan.exponent", "plan.exponent=", "plan.exponent=two",
                                  "plan.exponent=2x", "plan.exponent=2=2", "plan.exponent 2"})
        refused({"", "", {bad}}, "--set", "\"" + bad + "\"");
    refused({"", "", {"plan.exponents=2"}}, "--set", "plan.exponents");
    refused({"", "", {"=2"}}, "--set", "\"\"");
    for (const std::string value : {"0.5", "9", "nan", "inf", "-2"})
        refused({"", "", {"plan.exponent=" + value}}, "--set", "plan.exponent");
    refused({"", "", {"plan.mode=0.5"}}, "--set", "whole");
    refused({"", "rubens", {}}, "--preset", "rubens");
    // Each number is good by itself, and the two contradict each other.
    refused({"", "", {"density.min=5", "density.max=4"}}, "--set", "density.max");
    refused({"", "", {"cost.alpha=0", "cost.beta=0"}}, "--set", "cost.");
}

TEST_CASE("contradictions are looked for at the end, so the order of settings does not matter") {
    for (const Names& settings :
         {Names{"density.min=5", "density.max=6"}, Names{"density.max=6", "density.min=5"}}) {
        WorldDef def = defOf();
        CHECK(Overrides{"", "", settings}.apply(def).ok());
        CHECK(def.parameters.density.min == 5.0);
        CHECK(def.parameters.density.max == 6.0);
    }
}
