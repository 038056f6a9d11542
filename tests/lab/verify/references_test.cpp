// Curves and bands of measured data, and the test of Kolmogorov and Smirnov.
#include "lab/verify/rows/references.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("Weidmann's curve has its known values") {
    CHECK(weidmannSpeed(0.5) == doctest::Approx(1.30).epsilon(0.005));
    CHECK(weidmannSpeed(1.0) == doctest::Approx(1.06).epsilon(0.005));
    CHECK(weidmannSpeed(2.0) == doctest::Approx(0.61).epsilon(0.01));
    CHECK(weidmannSpeed(3.0) == doctest::Approx(0.33).epsilon(0.02));
    CHECK(weidmannSpeed(4.0) == doctest::Approx(0.16).epsilon(0.03));
    CHECK(weidmannSpeed(5.4) == 0.0);
    CHECK(seyfriedSpeed(1.0) == doctest::Approx(0.60).epsilon(0.01));
    CHECK(seyfriedSpeed(2.0) == doctest::Approx(0.13).epsilon(0.02));
}

TEST_CASE("bands are linear between their points") {
    CHECK(rimeaFileBand().contains({1.0, 0.5}));
    CHECK_FALSE(rimeaFileBand().contains({1.0, 1.0}));
    CHECK_FALSE(rimeaFileBand().covers({7.0, 0.0}));
    CHECK(rimeaStairBand(true).contains({1.0, 0.6}));
    CHECK_FALSE(rimeaStairBand(false).contains({1.0, 0.5}));
    CHECK(rimeaStairBand(false).contains({0.7, 0.64}));
}

TEST_CASE("bins count where there are enough points") {
    const SpeedBin bins[] = {{0.0, 1.0, 1.0, 0.1}, {1.0, 2.0, 0.5, 0.1}, {2.0, 3.0, 0.2, 0.1}};
    std::vector<Vec2> points;
    for (int i = 0; i < 10; ++i) points.push_back({0.5, 1.1}), points.push_back({1.5, 0.9});
    points.push_back({2.5, 0.2});
    const BinsJudged judged = judgeBins(points, bins, 2.0);
    CHECK(judged.used == 2);
    CHECK(judged.good == 1);
    CHECK(judged.means[1].y == doctest::Approx(0.9));
}

TEST_CASE("values of a distribution fit it, and those of another do not") {
    std::vector<double> even;
    for (int i = 0; i < 60; ++i) even.push_back(10.0 + 90.0 * (i + 0.5) / 60.0);
    CHECK(kolmogorovSmirnov(even, Distribution::uniform(10.0, 100.0)) > 0.99);
    CHECK(kolmogorovSmirnov(even, Distribution::normal(60.0, 5.0, 0.0, 200.0)) < 0.001);
    CHECK(kolmogorovSmirnov({}, Distribution::uniform(0.0, 1.0)) == 0.0);
}
