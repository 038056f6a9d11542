#include <doctest.h>

#include <cmath>
#include <limits>

#include "lab/study/statistics/describe.h"
#include "lab/study/statistics/made_tables.h"
#include "lab/study/statistics/numerics.h"
#include "lab/study/statistics/rank_tests.h"

using namespace muster;
using namespace muster::statistics;
using namespace muster::testing;

namespace {

/// The same by trying all signs.
double pByAllSigns(const std::vector<double>& differences) {
    std::vector<double> sizes;
    for (const double d : differences)
        if (d != 0.0) sizes.push_back(std::abs(d));
    const std::vector<double> ranks = meanRanks(sizes);
    const SignedRank test = signedRank(differences);
    const double least = std::min(test.positive, test.negative);
    int below = 0;
    const int all = 1 << ranks.size();
    for (int signs = 0; signs < all; ++signs) {
        double sum = 0.0;
        for (std::size_t i = 0; i < ranks.size(); ++i)
            if ((signs >> i) & 1) sum += ranks[i];
        below += sum <= least;
    }
    return std::min(1.0, 2.0 * below / all);
}

}  // namespace

TEST_CASE("Distributions have the values of tables") {
    CHECK(normalBelow(1.959963984540054) == doctest::Approx(0.975));
    CHECK(normalQuantile(0.975) == doctest::Approx(1.959963984540054).epsilon(1e-10));
    CHECK(studentQuantile(0.975, 1.0) == doctest::Approx(12.706204736).epsilon(1e-8));
    CHECK(studentQuantile(0.975, 10.0) == doctest::Approx(2.228138852).epsilon(1e-8));
    CHECK(studentBelow(0.0, 3.0) == doctest::Approx(0.5));
    CHECK(incompleteBeta(2.0, 3.0, 0.4) == doctest::Approx(0.5248));
}

TEST_CASE("Quantiles, boxes, Holm") {
    CHECK(quantile({4.0, 1.0, 3.0, 2.0}, 0.25) == doctest::Approx(1.75));
    CHECK(median({5.0, 1.0, 3.0}) == 3.0);
    CHECK(std::isnan(median({})));
    const BoxSummary box = boxSummary({1.0, 2.0, 3.0, 4.0, 100.0});
    CHECK(box.high == 4.0);
    REQUIRE(box.beyond.size() == 1);
    CHECK(box.beyond[0] == 100.0);
    const std::vector<double> p{0.01, 0.04, 0.03, 0.005};
    const std::vector<double> adjusted = holm(p);
    CHECK(adjusted[0] == doctest::Approx(0.03));
    CHECK(adjusted[1] == doctest::Approx(0.06));
    CHECK(adjusted[2] == doctest::Approx(0.06));
    CHECK(adjusted[3] == doctest::Approx(0.02));
}

TEST_CASE("The signed rank test is exact, with ties and zeros too") {
    CHECK(signedRank(std::vector<double>{1, 2, 3, 4, 5}).p == doctest::Approx(0.0625));
    CHECK(signedRank(std::vector<double>{1, 2, 3, 4, 5}).rankBiserial == 1.0);
    CHECK(signedRank(std::vector<double>{}).p == 1.0);
    CHECK(signedRank(std::vector<double>{0.0, 0.0}).p == 1.0);
    for (const std::vector<double>& differences : {std::vector<double>{1, -1, 2, 2, -3, 0, 5, 5, -2},
                                                   {0.5, 0.5, 0.5, 0.5},
                                                   {-1, 2, 4, 8, 16, -32, 64, 3}})
        CHECK(signedRank(differences).p == doctest::Approx(pByAllSigns(differences)).epsilon(1e-12));
    const double worst = std::numeric_limits<double>::infinity();
    CHECK(signedRank(std::vector<double>{worst, worst, 1.0, -2.0}).positive == 8.0);
}

TEST_CASE("The Hodges-Lehmann interval covers, and few differences give all of their range") {
    const Estimate middle = hodgesLehmann(std::vector<double>{1.0, 2.0, 3.0});
    CHECK(middle.value == 2.0);
    CHECK(middle.low == 1.0);
    CHECK(middle.high == 3.0);
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        std::vector<double> differences(15);
        for (double& d : differences) d = 0.7 + bell(random);
        const Estimate e = hodgesLehmann(differences);
        covered += e.low <= 0.7 && 0.7 <= e.high;
    }
    CHECK(covered >= 368);  // 95 % less three standard deviations.
}

TEST_CASE("Ratios: no effect is covered, an effect is found, the same seed gives the same") {
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        std::vector<double> a, b;
        for (int i = 0; i < 50; ++i) {
            const double layout = 3.5 + 0.2 * bell(random);
            a.push_back(std::exp(layout + 0.2 * bell(random)));
            b.push_back(std::exp(layout + 0.2 * bell(random)));
        }
        const Estimate ratio = ratioOfMedians(a, b, 1, 400);
        covered += ratio.low <= 1.0 && 1.0 <= ratio.high;
        if (seed > 1) continue;
        CHECK(ratioOfMedians(a, b, 1, 400).low == ratio.low);
        for (double& value : a) value *= 0.65;
        CHECK(ratioOfMedians(a, b).high < 0.8);
    }
    CHECK(covered >= 180);
    const std::vector<double> one{2.0}, four{4.0};
    CHECK(ratioOfMedians(one, four).low == 0.5);
}

TEST_CASE("The mixed model finds known effects and covers none") {
    TableDef def{.effects = {-0.43, -0.17, -0.22, 0.1}};
    const auto model = fitMixedModel(madeTable(def, 7));
    REQUIRE(model.ok());
    REQUIRE(model->effects.size() == 4);
    for (const MixedEffect& effect : model->effects) {
        const double truth = def.effects[static_cast<std::size_t>(effect.environment)];
        CHECK(std::abs(effect.estimate - truth) < 3.5 * effect.error);
        CHECK(effect.holm >= effect.p);
        CHECK(effect.df >= 1.0);
    }
    CHECK(model->effects[0].holm < 0.01);
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        TableDef none{.people = 12};
        const auto fitted = fitMixedModel(madeTable(none, seed));
        REQUIRE(fitted.ok());
        for (const MixedEffect& effect : fitted->effects)
            covered += effect.ratio.low <= 1.0 && 1.0 <= effect.ratio.high;
    }
    CHECK(covered >= 88);  // Of 100 that should be 95.
}

TEST_CASE("The mixed model bears missing cells and refuses what says nothing") {
    TableDef def{.missing = true};
    std::vector<MixedRow> rows = madeTable(def, 9);
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [](const MixedRow& r) { return r.environment == 2 && r.touch; }),
               rows.end());
    const auto model = fitMixedModel(rows);
    REQUIRE(model.ok());
    CHECK(model->effects.size() == 3);
    CHECK_FALSE(fitMixedModel({}).ok());
    def.people = 1;
    CHECK_FALSE(fitMixedModel(madeTable(def, 9)).ok());
    std::vector<MixedRow> same = madeTable({}, 9);
    for (MixedRow& row : same) row.logTime = 3.0;
    CHECK_FALSE(fitMixedModel(same).ok());
    same[0].logTime = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(fitMixedModel(same).ok());
}

TEST_CASE("Questionnaires are scored as published") {
    CHECK(susScore(std::vector<double>{5, 1, 5, 1, 5, 1, 5, 1, 5, 1}) == 100.0);
    CHECK(susScore(std::vector<double>(10, 3.0)) == 50.0);
    CHECK(std::isnan(susScore(std::vector<double>(9, 3.0))));
    CHECK(rawTlx(std::vector<double>{0, 20, 40, 60, 80, 100}) == 50.0);
    const UeqShort score = ueqShort(std::vector<double>{7, 7, 7, 7, 1, 1, 4, 4});
    CHECK(score.pragmatic == 3.0);
    CHECK(score.hedonic == -1.5);
    CHECK(std::isnan(ueqShort(std::vector<double>(8, 9.0)).hedonic));
}
