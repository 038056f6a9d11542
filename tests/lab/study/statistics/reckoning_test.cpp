// The statistics against a second reckoning: R with lme4 (and lmerTest, where it is there).
#include <doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "lab/study/statistics/made_tables.h"
#include "lab/study/statistics/rank_tests.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::statistics;
using namespace muster::testing;

namespace {

using Values = std::map<std::string, double>;

bool hasR() {
    return std::system("Rscript -e 'library(lme4)' >/dev/null 2>&1") == 0;
}

/// Columns of differences: plain, with ties and zeros, many, few.
std::map<std::string, std::vector<double>> differenceTable() {
    Random random(5);
    std::map<std::string, std::vector<double>> table;
    for (int i = 0; i < 24; ++i) {
        table["plain"].push_back(bell(random) + 0.4);
        table["ties"].push_back(std::floor(2.0 * bell(random)) + 1.0);
    }
    for (int i = 0; i < 60; ++i) table["many"].push_back(bell(random) + 0.2);
    for (int i = 0; i < 60; ++i) table["manyties"].push_back(std::floor(3.0 * bell(random)) + 1.0);
    table["few"] = {0.5, -0.25, 1.5, 2.25, 3.125, 0.75};
    return table;
}

Values reckoned(const std::vector<MixedRow>& rows, const std::map<std::string, std::vector<double>>& table) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("muster_reckoning_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream trials(folder / "trials.csv");
    trials.precision(17);
    trials << "y,environment,touch,period,order,person,layout\n";
    for (const MixedRow& r : rows)
        trials << r.logTime << ',' << r.environment << ',' << r.touch << ',' << r.period << ',' << r.order
               << ',' << r.person << ',' << r.layout << '\n';
    trials.close();
    std::ofstream differences(folder / "differences.csv");
    differences.precision(17);
    std::size_t longest = 0;
    std::string heading;
    for (const auto& [name, column] : table) {
        heading += (heading.empty() ? "" : ",") + name;
        longest = std::max(longest, column.size());
    }
    differences << heading << '\n';
    for (std::size_t i = 0; i < longest; ++i) {
        std::size_t place = 0;
        for (const auto& [name, column] : table) {
            if (place++ > 0) differences << ',';
            if (i < column.size())
                differences << column[i];
            else
                differences << "NA";
        }
        differences << '\n';
    }
    differences.close();
    const std::string command = "Rscript '" + sourceFolder() + "/tests/lab/study/reckoning/reckon.R' '" +
                                (folder / "trials.csv").string() + "' '" +
                                (folder / "differences.csv").string() + "' >'" +
                                (folder / "values").string() + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    Values values;
    std::ifstream file(folder / "values");
    std::string name;
    double value = 0.0;
    while (file >> name >> value) values[name] = value;
    std::filesystem::remove_all(folder);
    return values;
}

void checkModel(const std::vector<MixedRow>& rows, const Values& r) {
    const auto model = fitMixedModel(rows);
    REQUIRE(model.ok());
    CHECK(model->criterion == doctest::Approx(r.at("criterion")).epsilon(1e-6));
    CHECK(model->residual == doctest::Approx(r.at("residual")).epsilon(2e-3));
    CHECK(std::abs(model->person - r.at("person")) < 2e-3);
    CHECK(std::abs(model->slope - r.at("slope")) < 2e-3);
    CHECK(std::abs(model->layout - r.at("layout")) < 2e-3);
    REQUIRE(model->effects.size() == 4);
    for (const MixedEffect& effect : model->effects) {
        const std::string e = std::to_string(effect.environment);
        CHECK(effect.estimate == doctest::Approx(r.at("estimate" + e)).epsilon(1e-3));
        CHECK(effect.error == doctest::Approx(r.at("error" + e)).epsilon(2e-3));
        if (r.contains("df" + e)) CHECK(effect.df == doctest::Approx(r.at("df" + e)).epsilon(0.03));
    }
}

}  // namespace

TEST_CASE("R and lme4 reckon the same") {
    if (!hasR()) {
        MESSAGE("skipped: R with lme4 is not installed");
        return;
    }
    const auto table = differenceTable();
    TableDef effects{.effects = {-0.4, -0.2, -0.2, 0.1}};
    TableDef missing = effects;
    missing.missing = true;
    TableDef none{.slope = 0.0, .layout = 0.0};
    for (const TableDef& def : {effects, missing, none}) {
        const std::vector<MixedRow> rows = madeTable(def, 3);
        const Values r = reckoned(rows, table);
        checkModel(rows, r);
        if (def.missing || def.slope == 0.0) continue;
        for (const auto& [name, column] : table) {
            CAPTURE(name);
            const SignedRank test = signedRank(column);
            CHECK(test.positive == doctest::Approx(r.at(name + ".v")));
            // R's exact test knows neither ties nor zeros; ours is exact with them: nearly the same.
            const bool same = r.at(name + ".plain") > 0.0 || !test.exact;
            CHECK(std::abs(test.p - r.at(name + ".p")) < (same ? 1e-9 : 0.01));
            if (r.at(name + ".plain") > 0.0) {
                const Estimate middle = hodgesLehmann(column);
                const double tolerance = test.exact ? 1e-9 : 0.02;
                CHECK(std::abs(middle.value - r.at(name + ".estimate")) < tolerance);
                CHECK(std::abs(middle.low - r.at(name + ".low")) < tolerance);
                CHECK(std::abs(middle.high - r.at(name + ".high")) < tolerance);
            }
            for (const auto& [text, q] :
                 {std::pair{"0.025", 0.025}, {"0.25", 0.25}, {"0.5", 0.5}, {"0.9", 0.9}})
                CHECK(quantile(column, q) == doctest::Approx(r.at(name + ".q" + text)));
        }
    }
}
