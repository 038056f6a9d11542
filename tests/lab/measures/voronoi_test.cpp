// Voronoi cells beside a raster on which every point goes to the nearest person.
#include "lab/measures/voronoi.h"

#include <doctest.h>

#include <cmath>

#include "lab/measures/speeds.h"

using namespace muster;

namespace {

constexpr double kTau = 6.283185307179586;

/// Numbers between 0 and 1 that are spread evenly.
double spreadNumber(int index, double step) {
    return std::fmod(0.37 + index * step, 1.0);
}

std::vector<Sighting> somebody(int count) {
    std::vector<Sighting> all;
    for (int i = 0; i < count; ++i)
        all.push_back(
            {0,
             static_cast<std::uint32_t>(i + 1),
             {0.2 + 9.6 * spreadNumber(i, 0.6180339887), 0.2 + 5.6 * spreadNumber(i, 0.7548776662)}});
    return all;
}

Region hall() {
    return Region::create({{0, 0}, {10, 0}, {10, 6}, {0, 6}}).value();
}

/// Area of each cell by counting points of a raster, within the circle of the cut-off.
std::vector<double> countedAreas(const std::vector<Sighting>& persons, const Region& ground, double radius) {
    std::vector<double> areas(persons.size(), 0.0);
    constexpr double kStep = 0.01;
    for (double y = 0.5 * kStep; y < 6.0; y += kStep)
        for (double x = 0.5 * kStep; x < 10.0; x += kStep) {
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < persons.size(); ++i)
                if (distance(persons[i].position, {x, y}) < distance(persons[nearest].position, {x, y}))
                    nearest = i;
            const bool near = radius <= 0.0 || distance(persons[nearest].position, {x, y}) <= radius;
            if (near && ground.contains({x, y})) areas[nearest] += kStep * kStep;
        }
    return areas;
}

}  // namespace

TEST_CASE("cells cover the ground, each as a raster says") {
    const auto persons = somebody(23);
    const auto cells = voronoiCells(persons, hall());
    const auto counted = countedAreas(persons, hall(), 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        CAPTURE(i);
        CHECK(cells[i].id == persons[i].id);
        CHECK(cells[i].area == doctest::Approx(counted[i]).epsilon(0.02));
        sum += cells[i].area;
    }
    CHECK(sum == doctest::Approx(60.0));
}

TEST_CASE("a cut-off bounds cells") {
    const auto persons = somebody(12);
    const auto cells = voronoiCells(persons, hall(), {0.9, 25});
    const auto counted = countedAreas(persons, hall(), 0.9);
    for (std::size_t i = 0; i < cells.size(); ++i)
        CHECK(cells[i].area == doctest::Approx(counted[i]).epsilon(0.02));
    // Alone in the middle: the polygon with four times as many corners as a quarter has edges.
    const std::vector<Sighting> alone{{0, 1, {5.0, 3.0}}};
    CHECK(voronoiCells(alone, hall(), {1.0, 3})[0].area == doctest::Approx(6.0 * std::sin(kTau / 12)));
    CHECK(voronoiCells(alone, hall())[0].area == doctest::Approx(60.0));
}

TEST_CASE("two persons share a room half and half, and a wall between them takes its own") {
    const std::vector<Sighting> two{{0, 1, {2.5, 3.0}}, {0, 2, {7.5, 3.0}}};
    const auto cells = voronoiCells(two, hall());
    CHECK(cells[0].area == doctest::Approx(30.0));
    CHECK(cells[1].area == doctest::Approx(30.0));
    const Region walled = Region::create(
                              {{0, 0}, {6, 0}, {6, 5}, {6.2, 5}, {6.2, 0}, {10, 0}, {10, 6}, {0, 6}})
                              .value();
    // What is nearer to the second one but lies behind the wall hangs together with it by the gap above.
    const auto parted = voronoiCells(two, walled);
    CHECK(parted[0].area == doctest::Approx(30.0));
    CHECK(parted[1].area == doctest::Approx(29.0));
    CHECK(voronoiCells(std::vector<Sighting>{{0, 1, {6.1, 1.0}}}, walled)[0].area == 0.0);
}

TEST_CASE("density and speed of a square grid of persons") {
    std::vector<Sighting> all;
    for (int frame = 0; frame < 5; ++frame)
        for (int i = 0; i < 20; ++i)
            for (int k = 0; k < 12; ++k)
                all.push_back({frame,
                               static_cast<std::uint32_t>(i * 12 + k),
                               {0.25 + 0.5 * i + 0.01 * frame, 0.25 + 0.5 * k}});
    const Trajectories persons = Trajectories::create(10.0, all).value();
    const Region area = Region::create({{3, 2}, {6, 2}, {6, 4}, {3, 4}}).value();
    const auto speeds = personalSpeeds(persons, {.frameStep = 1});
    const VoronoiSeries series = voronoiSeries(persons, hall(), area, {}, speeds);
    for (int frame = 1; frame < 4; ++frame) {
        CHECK(series.density[frame] == doctest::Approx(4.0));
        CHECK(series.speed[frame] == doctest::Approx(0.1));
    }
    CHECK(series.speed[0] == 0.0);  // Nobody has a speed in its first frame.
    CHECK(classicDensity(persons, area)[2] == doctest::Approx(4.0));
    const VoronoiSeries cut = voronoiSeries(persons, hall(), area, {2.0, 5}, speeds);
    CHECK(cut.density[2] == doctest::Approx(4.0));
}

TEST_CASE("on a ring the seam is not felt") {
    std::vector<Sighting> all;
    for (int i = 0; i < 10; ++i) all.push_back({0, static_cast<std::uint32_t>(i), {0.5 + i, 1.0}});
    const Trajectories ring = Trajectories::create(1.0, all).value();
    const auto seen = withImages(ring, 0.0, 10.0, 3.0);
    REQUIRE(seen.ok());
    CHECK(seen->frame(0).size() == 16);
    const Region ground = Region::create({{-3, 0}, {13, 0}, {13, 2}, {-3, 2}}).value();
    const Region area = Region::create({{0, 0}, {10, 0}, {10, 2}, {0, 2}}).value();
    CHECK(voronoiSeries(*seen, ground, area).density[0] == doctest::Approx(0.5));
}
