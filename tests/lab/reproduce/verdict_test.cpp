// Samples, their figures, and how criteria are judged.
#include "lab/reproduce/experiments/verdict.h"

#include <doctest.h>

#include <cmath>

#include "lab/reproduce/experiments/samples.h"
#include "lab/reproduce/fake.h"

using namespace muster;
using namespace muster::testing;

namespace {

RunSample sample(double time) {
    RunSample run;
    run.figures["time"] = time;
    return run;
}

Verdict judged(const std::vector<double>& values, Aggregate aggregate, Comparison comparison,
               double threshold, std::size_t expected, const std::string& preset = "muster") {
    Judge judge(expected);
    judge.require("criterion", preset, values, aggregate, comparison, threshold, "s");
    REQUIRE(judge.verdicts().size() == 1);
    return judge.verdicts().front();
}

}  // namespace

TEST_CASE("samples keep arms and presets apart, in the order of seeds") {
    Samples samples;
    CHECK(samples.seeds() == 0);
    samples.add("a", "muster", sample(3.0));
    samples.add("a", "muster", sample(1.0));
    samples.add("a", "paper", sample(7.0));
    samples.add("b", "muster", sample(9.0));
    CHECK(samples.values("a", "muster", "time") == std::vector<double>{3.0, 1.0});
    CHECK(samples.values("a", "paper", "time") == std::vector<double>{7.0});
    CHECK(samples.values("b", "paper", "time").empty());
    CHECK(samples.values("a", "muster", "length").empty());
    CHECK(samples.runs("c", "muster").empty());
    CHECK(samples.runs("a", "muster").size() == 2);
    CHECK(samples.seeds() == 2);
}

TEST_CASE("a run without a value is left out of values but stays a run") {
    Samples samples;
    samples.add("a", "muster", sample(kNone));
    samples.add("a", "muster", sample(2.0));
    samples.add("a", "muster", {});
    CHECK(samples.values("a", "muster", "time") == std::vector<double>{2.0});
    CHECK(samples.runs("a", "muster").size() == 3);
}

TEST_CASE("median of odd, even and no numbers") {
    CHECK(median({5.0}) == 5.0);
    CHECK(median({9.0, 1.0, 5.0}) == 5.0);
    CHECK(median({4.0, 1.0, 2.0, 9.0}) == 3.0);
    CHECK(std::isnan(median({})));
}

TEST_CASE("ratios go pair by pair, as far as both have values") {
    CHECK(ratios({6.0, 8.0, 1.0}, {3.0, 2.0}) == std::vector<double>{2.0, 4.0});
    CHECK(ratios({}, {1.0}).empty());
    const std::vector<double> byZero = ratios({1.0, 0.0}, {0.0, 4.0});
    REQUIRE(byZero.size() == 2);
    CHECK(std::isnan(byZero[0]));
    CHECK(byZero[1] == 0.0);
}

TEST_CASE("each aggregate picks its value; low and high are of all seeds") {
    const std::vector<double> values = {4.0, 1.0, 2.0, 9.0};
    const Verdict middle = judged(values, Aggregate::Median, Comparison::AtLeast, 0.0, 4);
    CHECK(middle.value == 3.0);
    CHECK(middle.low == 1.0);
    CHECK(middle.high == 9.0);
    CHECK(middle.seeds == 4);
    CHECK(middle.unit == "s");
    CHECK(judged(values, Aggregate::Lowest, Comparison::AtLeast, 0.0, 4).value == 1.0);
    CHECK(judged(values, Aggregate::Highest, Comparison::AtLeast, 0.0, 4).value == 9.0);
}

TEST_CASE("the threshold itself passes, what is beyond it fails") {
    const double above = std::nextafter(2.0, 3.0), below = std::nextafter(2.0, 1.0);
    CHECK(judged({2.0}, Aggregate::Median, Comparison::AtLeast, 2.0, 1).pass);
    CHECK(judged({2.0}, Aggregate::Median, Comparison::AtMost, 2.0, 1).pass);
    CHECK(judged({above}, Aggregate::Median, Comparison::AtLeast, 2.0, 1).pass);
    CHECK_FALSE(judged({below}, Aggregate::Median, Comparison::AtLeast, 2.0, 1).pass);
    CHECK(judged({below}, Aggregate::Median, Comparison::AtMost, 2.0, 1).pass);
    CHECK_FALSE(judged({above}, Aggregate::Median, Comparison::AtMost, 2.0, 1).pass);
    // One bad seed is enough where every seed counts.
    CHECK_FALSE(judged({36.0, 35.0, 36.0}, Aggregate::Lowest, Comparison::AtLeast, 36.0, 3).pass);
    CHECK_FALSE(judged({1.0, 1.0, above}, Aggregate::Highest, Comparison::AtMost, 2.0, 3).pass);
    CHECK(judged({36.0, 35.0, 36.0}, Aggregate::Median, Comparison::AtLeast, 36.0, 3).pass);
}

TEST_CASE("too few values fail, however good they are") {
    CHECK(judged({9.0, 9.0}, Aggregate::Median, Comparison::AtLeast, 1.0, 2).pass);
    CHECK_FALSE(judged({9.0, 9.0}, Aggregate::Median, Comparison::AtLeast, 1.0, 3).pass);
    const Verdict gap = judged({9.0, kNone, 9.0}, Aggregate::Lowest, Comparison::AtLeast, 1.0, 3);
    CHECK_FALSE(gap.pass);
    CHECK(gap.seeds == 2);
    CHECK(gap.value == 9.0);
    for (const auto& values : {std::vector<double>{}, std::vector<double>{kNone, kNone}}) {
        const Verdict none = judged(values, Aggregate::Median, Comparison::AtMost, 1.0, values.size());
        CHECK_FALSE(none.pass);
        CHECK(none.seeds == 0);
        CHECK(std::isnan(none.value));
        CHECK(std::isnan(none.low));
    }
}

TEST_CASE("criteria of the preset muster bind, others do not") {
    CHECK(judged({1.0}, Aggregate::Median, Comparison::AtLeast, 2.0, 1, "muster").binding);
    CHECK_FALSE(judged({1.0}, Aggregate::Median, Comparison::AtLeast, 2.0, 1, "paper").binding);
}
