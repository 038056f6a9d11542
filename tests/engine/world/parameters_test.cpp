#include "muster/parameter_table.h"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "engine/systems/plans/plan_stage.h"

using namespace muster;

TEST_CASE("every parameter is named once, described, and its default lies in its range") {
    std::set<std::string> names;
    Parameters defaults;
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        CHECK(names.insert(std::string(info.name)).second);
        CHECK(info.description.size() > 10);
        CHECK(info.description.back() == '.');
        CHECK(!info.unit.empty());
        CHECK(info.minimum < info.maximum);
        CHECK(setParameter(defaults, info.name, info.get(defaults)).ok());
    }
    CHECK(names.size() == parameterTable().size());
}

TEST_CASE("setting by name writes that member and no other") {
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        Parameters p;
        const double value = info.get(p) == info.maximum ? info.minimum : info.maximum;
        REQUIRE(setParameter(p, info.name, value).ok());
        CHECK(info.get(p) == value);
        for (const ParameterInfo& other : parameterTable())
            CHECK((other.name == info.name || other.get(p) == other.get(Parameters{})));
    }
}

TEST_CASE("bad values change nothing and are named") {
    Parameters p;
    const double huge = std::numeric_limits<double>::infinity();
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        for (double bad : {std::nan(""), huge, -huge, info.minimum - 1.0, info.maximum * 1.5 + 1.0}) {
            const Status status = setParameter(p, info.name, bad);
            CHECK(status.code() == StatusCode::InvalidArgument);
            CHECK(status.message().find(info.name) != std::string::npos);
            CHECK(info.get(p) == info.get(Parameters{}));
        }
    }
    CHECK(setParameter(p, "plan.exponentt", 1.0).code() == StatusCode::NotFound);
}

TEST_CASE("switches, modes and counts are whole") {
    Parameters p;
    for (const char* name : {"density.enabled", "plan.mode", "plan.solver", "plan.objective", "plan.period",
                             "contact.iterations"}) {
        CAPTURE(name);
        CHECK(setParameter(p, name, 1.0).ok());
        const Status half = setParameter(p, name, 1.5);
        CHECK(!half.ok());
    }
}

TEST_CASE("presets") {
    const auto paper = parameterPreset("paper");
    REQUIRE(paper.ok());
    CHECK(paper->plan.exponent == 1.0);
    CHECK(paper->plan.threshold == 0.0);
    CHECK(paper->plan.thresholdShare == 0.0);
    CHECK(paper->plan.period == 1);
    CHECK(parameterPreset("muster")->plan.exponent == Parameters{}.plan.exponent);
    CHECK(parameterPreset("rubens").status().code() == StatusCode::NotFound);
}

TEST_CASE("a plan's period is what was set, or else what suits the solver") {
    Parameters p;
    p.plan.solver = PlanSolver::Exact;
    CHECK(planPeriod(p.plan) == 4);
    p.plan.solver = PlanSolver::Fast;
    CHECK(planPeriod(p.plan) == 1);
    // Many groups of many take turns.
    CHECK(planPeriod(p.plan, 20, 599) == 1);
    CHECK(planPeriod(p.plan, 20, 600) == 4);
    CHECK(planPeriod(p.plan, 3, 5000) == 3);
    CHECK(planPeriod(p.plan, 20, 5000) == 6);
    p.plan.period = 9;
    CHECK(planPeriod(p.plan) == 9);
    CHECK(planPeriod(p.plan, 20, 5000) == 9);
    // The paper solves exactly whatever the default is.
    const auto paper = parameterPreset("paper");
    CHECK(paper->plan.solver == PlanSolver::Exact);
    CHECK(planPeriod(paper->plan) == 1);
}
