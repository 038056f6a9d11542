// Measures of twelve persons beside those that SciPy and Shapely give by PedPy's definitions (reference.py).
#include <doctest.h>

#include <cmath>

#include "lab/measures/crossings.h"
#include "lab/measures/speeds.h"
#include "lab/measures/voronoi.h"

using namespace muster;

namespace {

constexpr double kReferenceRate = 10.0;

Vec2 positionOf(int person, int frame) {
    const double t = frame / kReferenceRate;
    return {0.6 + 0.5 * (person % 4) + (0.9 + 0.05 * person) * t + 0.2 * std::sin(1.3 * t + person),
            0.5 + 0.46 * person + 0.15 * std::cos(0.7 * t + 2.0 * person)};
}

Region referenceGround() {
    const PolygonWithHoles ground{{{0, 0}, {8, 0}, {8, 3}, {5, 3}, {5, 4}, {8, 4}, {8, 6}, {0, 6}},
                                  {{{3.0, 2.0}, {3.0, 2.4}, {4.0, 2.4}, {4.0, 2.0}}}};
    return Region::create(std::span(&ground, 1)).value();
}

Trajectories referencePersons(const Region& ground) {
    std::vector<Sighting> all;
    for (int person = 0; person < 12; ++person)
        for (int frame = 0; frame < 40; ++frame)
            if (ground.contains(positionOf(person, frame)))
                all.push_back({frame, static_cast<std::uint32_t>(person), positionOf(person, frame)});
    return Trajectories::create(kReferenceRate, all).value();
}

}  // namespace

TEST_CASE("densities and speeds in an area are those of the reference") {
    const Region ground = referenceGround();
    const Region area = Region::create({{2.0, 1.0}, {6.5, 1.0}, {6.5, 5.0}, {2.0, 5.0}}).value();
    const Trajectories persons = referencePersons(ground);
    const auto speeds = personalSpeeds(persons, {.frameStep = 5});
    const VoronoiSeries series = voronoiSeries(persons, ground, area, {1.2, 3}, speeds);
    const auto classic = classicDensity(persons, area);
    struct Row {
        int frame;
        std::size_t present;
        double classic, density, speed;
    };
    for (const Row& row : {Row{0, 12, 0.111111111111, 0.121642627904, 0.0},
                           Row{13, 11, 0.333333333333, 0.312729519487, 0.626697662192},
                           Row{27, 10, 0.388888888889, 0.354355673440, 0.804120218747}}) {
        CAPTURE(row.frame);
        CHECK(persons.frame(row.frame).size() == row.present);
        CHECK(classic[row.frame] == doctest::Approx(row.classic).epsilon(1e-9));
        CHECK(series.density[row.frame] == doctest::Approx(row.density).epsilon(1e-9));
        CHECK(series.speed[row.frame] == doctest::Approx(row.speed).epsilon(1e-9));
    }
}

TEST_CASE("first crossings are those of the reference") {
    const Trajectories persons = referencePersons(referenceGround());
    const auto first = firstCrossings(crossings(persons, {{4.5, 0.0}, {4.5, 6.0}}));
    std::vector<std::pair<int, int>> found;
    for (const Crossing& c : first) found.emplace_back(c.frame, static_cast<int>(c.id));
    std::sort(found.begin(), found.end());
    const std::vector<std::pair<int, int>> expected{{16, 11}, {20, 7}, {21, 10}, {24, 3}, {24, 6}, {26, 9},
                                                    {29, 5},  {30, 2}, {31, 8},  {34, 4}, {37, 1}};
    CHECK(found == expected);
    const auto count = crossedByFrame(persons, first);
    CHECK(count[15] == 0);
    CHECK(count[24] == 5);
    CHECK(count[39] == 11);
    for (const Crossing& c : first) {
        CHECK(c.direction == 1);
        CHECK(c.time <= c.frame / kReferenceRate);
        CHECK(c.time >= (c.frame - 1) / kReferenceRate);
        CHECK(c.point.x == doctest::Approx(4.5));
    }
}
