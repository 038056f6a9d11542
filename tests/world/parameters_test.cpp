#include "muster/parameters.h"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace muster;

TEST_CASE("every parameter is named once, described, and its default lies in its range") {
    std::set<std::string> names;
    std::set<const double*> members;
    Parameters defaults;
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        CHECK(names.insert(std::string(info.name)).second);
        CHECK(members.insert(&(defaults.*info.member)).second);
        CHECK(info.description.size() > 10);
        CHECK(info.description.back() == '.');
        CHECK(!info.unit.empty());
        CHECK(info.minimum < info.maximum);
        CHECK(setParameter(defaults, info.name, defaults.*info.member).ok());
    }
    // No number of the struct is left out of the table.
    CHECK(members.size() * sizeof(double) == sizeof(Parameters));
}

TEST_CASE("setting by name writes that member and no other") {
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        Parameters p;
        const double value = p.*info.member == info.maximum ? info.minimum : info.maximum;
        REQUIRE(setParameter(p, info.name, value).ok());
        CHECK(p.*info.member == value);
        Parameters expected;
        expected.*info.member = value;
        for (const ParameterInfo& other : parameterTable()) CHECK(p.*other.member == expected.*other.member);
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
            CHECK(p.*info.member == Parameters{}.*info.member);
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
    CHECK(paper->exponent == 1.0);
    CHECK(paper->threshold == 0.0);
    CHECK(paper->thresholdShare == 0.0);
    CHECK(paper->planPeriod == 1.0);
    CHECK(parameterPreset("muster")->exponent == Parameters{}.exponent);
    CHECK(parameterPreset("rubens").status().code() == StatusCode::NotFound);
}

TEST_CASE("a plan's period is what was set, or else what suits the solver") {
    Parameters p;
    p.planSolver = static_cast<double>(PlanSolver::Exact);
    CHECK(planPeriodOf(p) == 4);
    p.planSolver = static_cast<double>(PlanSolver::Fast);
    CHECK(planPeriodOf(p) == 1);
    p.planPeriod = 9.0;
    CHECK(planPeriodOf(p) == 9);
    // The paper solves exactly whatever the default is.
    const auto paper = parameterPreset("paper");
    CHECK(paper->planSolver == 0.0);
    CHECK(planPeriodOf(*paper) == 1);
}
