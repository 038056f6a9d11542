#include <doctest.h>

#include <set>

#include "lab/study/models/operator_parameters.h"

namespace muster {
namespace {

TEST_CASE("every constant of the operators lies in its range and has a source and a name of its own") {
    OperatorParameters parameters = operatorSetting("default").value();
    std::set<std::string_view> names;
    for (const OperatorConstant& constant : operatorConstants()) {
        INFO(std::string(constant.name));
        CHECK(constant.at(parameters) >= constant.low);
        CHECK(constant.at(parameters) <= constant.high);
        CHECK(constant.low < constant.high);
        CHECK_FALSE(constant.source.empty());
        CHECK(names.insert(constant.name).second);
    }
}

TEST_CASE("each row of the hypercube is in the ranges, and each stratum of each range is drawn once") {
    std::vector<OperatorParameters> rows;
    for (std::int32_t row = 0; row < kHypercubeDraws; ++row)
        rows.push_back(operatorSetting("draw " + std::to_string(row)).value());
    for (const OperatorConstant& constant : operatorConstants()) {
        std::set<std::int32_t> strata;
        for (OperatorParameters& row : rows) {
            const double share = (constant.at(row) - constant.low) / (constant.high - constant.low);
            CHECK(share >= 0.0);
            CHECK(share < 1.0);
            strata.insert(static_cast<std::int32_t>(share * kHypercubeDraws));
        }
        CHECK(strata.size() == static_cast<std::size_t>(kHypercubeDraws));
    }
}

TEST_CASE("one constant at a time: both ends of each range, and nothing else changes") {
    const std::vector<std::string> settings = oneAtATimeSettings();
    CHECK(settings.size() == 2 * operatorConstants().size());
    OperatorParameters usual = operatorSetting("default").value();
    for (const std::string& setting : settings) {
        OperatorParameters changed = operatorSetting(setting).value();
        std::int32_t differences = 0;
        for (const OperatorConstant& constant : operatorConstants())
            differences += constant.at(changed) != constant.at(usual) ? 1 : 0;
        // One end of a range may be the usual value.
        CHECK(differences <= 1);
    }
}

TEST_CASE("unknown settings are refused by name") {
    for (const char* wrong : {"", "fast", "draw", "draw -1", "draw 200", "draw 3x", "key", "key=", "key=zero",
                              "kex=0.2", "key=9"}) {
        INFO(std::string(wrong));
        CHECK_FALSE(operatorSetting(wrong).ok());
    }
    CHECK(operatorSetting("key=9").status().message() == "found key=9, expected a value in the range of key");
}

}  // namespace
}  // namespace muster
