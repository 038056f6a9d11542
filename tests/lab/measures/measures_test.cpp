// Crossings, flows, speeds, series, headways: cases that one can do by hand.
#include <doctest.h>

#include <cmath>

#include "lab/measures/crossings.h"
#include "lab/measures/series.h"
#include "lab/measures/speeds.h"

using namespace muster;

namespace {

/// A person who is at these places in the frames from `first` on.
void addPath(std::vector<Sighting>& all, std::uint32_t id, std::int32_t first, std::vector<Vec2> places) {
    for (const Vec2 p : places) all.push_back({first++, id, p});
}

Trajectories made(std::vector<Sighting> all, double rate = 10.0) {
    auto trajectories = Trajectories::create(rate, std::move(all));
    REQUIRE_MESSAGE(trajectories.ok(), trajectories.status().message());
    return std::move(trajectories).value();
}

const Line kUpright{{0.0, -1.0}, {0.0, 1.0}};

}  // namespace

TEST_CASE("sightings are sorted, and what is impossible is refused") {
    const Trajectories t = made({{5, 2, {1, 0}}, {3, 1, {0, 0}}, {5, 1, {2, 0}}});
    CHECK(t.firstFrame() == 3);
    CHECK(t.frameCount() == 3);
    CHECK(t.frame(0).size() == 1);
    CHECK(t.frame(1).empty());
    CHECK(t.frame(2).size() == 2);
    CHECK(t.frame(2)[0].id == 1);
    REQUIRE(t.persons().size() == 2);
    CHECK(t.ofPerson(0).size() == 2);
    CHECK_FALSE(Trajectories::create(0.0, {}).ok());
    CHECK_FALSE(Trajectories::create(10.0, {{1, 1, {0, 0}}, {1, 1, {1, 0}}}).ok());
    CHECK_FALSE(Trajectories::create(10.0, {{1, 1, {NAN, 0}}}).ok());
    CHECK(made({}).frameCount() == 0);
}

TEST_CASE("crossings: time, direction, ends of the line") {
    std::vector<Sighting> all;
    addPath(all, 1, 0, {{-0.3, 0.0}, {0.1, 0.0}});              // To the right, at three quarters.
    addPath(all, 2, 0, {{0.1, 0.5}, {-0.1, 0.5}, {0.2, 0.5}});  // To the left and back.
    addPath(all, 3, 0, {{-0.3, 2.0}, {0.1, 2.0}});              // Past its end.
    addPath(all, 4, 0, {{-0.3, 0.2}, {0.0, 0.2}, {0.4, 0.2}});  // Ends on it, and begins on it.
    addPath(all, 5, 0,
            {{-0.3, 0.2}, {0.0, 0.2}, {-0.4, 0.2}});  // Begins on it and goes back: PedPy counts it.
    all.push_back({0, 6, {-1, 0}});
    all.push_back({2, 6, {1, 0}});  // Not seen between.
    const Trajectories t = made(all);
    const auto found = crossings(t, kUpright);
    REQUIRE(found.size() == 5);
    CHECK(found[0].id == 2);
    CHECK(found[0].direction == -1);
    CHECK(found[0].time == doctest::Approx(0.05));
    CHECK(found[1].id == 1);
    CHECK(found[1].direction == 1);
    CHECK(found[1].time == doctest::Approx(0.075));
    CHECK(found[1].frame == 1);
    CHECK(found[1].point.y == 0.0);
    CHECK(found[2].id == 4);
    CHECK(found[2].frame == 2);
    CHECK(found[2].time == doctest::Approx(0.1));
    CHECK(found[3].id == 5);
    CHECK(found[4].id == 2);
    CHECK(firstCrossings(found).size() == 4);
    const auto right = firstCrossings(found, 1);
    REQUIRE(right.size() == 3);
    CHECK(right[2].id == 2);
    CHECK(crossings(t, {kUpright.b, kUpright.a})[0].direction == 1);
}

TEST_CASE("N-t and flow of a file with a gap of half a second") {
    std::vector<Sighting> all;
    for (int person = 0; person < 9; ++person) {
        std::vector<Vec2> places;
        for (int f = 0; f < 80; ++f) places.push_back({-1.05 - 0.5 * person + 0.1 * f, 0.0});
        addPath(all, static_cast<std::uint32_t>(person), 0, places);
    }
    const Trajectories t = made(all);
    const auto crossed = firstCrossings(crossings(t, kUpright));
    REQUIRE(crossed.size() == 9);
    CHECK(crossed[0].time == doctest::Approx(1.05));
    CHECK(meanFlow(crossed) == doctest::Approx(2.0));
    CHECK(flowBetween(crossed, 2, 6) == doctest::Approx(2.0));
    CHECK(std::isnan(flowBetween(crossed, 2, 9)));
    const auto count = crossedByFrame(t, crossed);
    CHECK(count[10] == 0);
    CHECK(count[11] == 1);
    CHECK(count[79] == 9);
    // By hand: the first at frame 11, one each 5 frames. Stretches of 10 frames: up to 21 three have passed,
    // counted to the frame after the last, 22: 3 in 11 frames; up to 31 two more, from 22 to 32.
    const auto speeds = personalSpeeds(t, {.frameStep = 2});
    const auto flow = flowSamples(t, crossed, 10, speeds);
    REQUIRE(flow.size() == 4);
    CHECK(flow[0].flow == doctest::Approx(30.0 / 11.0));
    CHECK(flow[1].flow == doctest::Approx(2.0));
    CHECK(flow[1].from == doctest::Approx(2.2));
    CHECK(flow[1].speed == doctest::Approx(1.0));
}

TEST_CASE("speeds at the ends of a trajectory") {
    std::vector<Sighting> all;
    addPath(all, 1, 0, {{0, 0}, {1, 0}, {3, 0}, {6, 0}, {10, 0}, {15, 0}});
    const Trajectories t = made(all, 1.0);
    const auto adaptive = personalSpeeds(t, {.frameStep = 2});
    CHECK(std::isnan(adaptive[0]));
    CHECK(adaptive[1] == doctest::Approx(1.5));
    CHECK(adaptive[2] == doctest::Approx(2.5));
    CHECK(adaptive[4] == doctest::Approx(4.5));
    CHECK(std::isnan(adaptive[5]));
    const auto single = personalSpeeds(t, {.frameStep = 2, .border = SpeedBorder::SingleSided});
    CHECK(single[0] == doctest::Approx(1.5));
    CHECK(single[1] == doctest::Approx(2.5));
    CHECK(single[5] == doctest::Approx(4.5));
    const auto exclude = personalSpeeds(t, {.frameStep = 2, .border = SpeedBorder::Exclude});
    CHECK(std::isnan(exclude[1]));
    CHECK(exclude[2] == doctest::Approx(2.5));
    CHECK(std::isnan(exclude[4]));
}

TEST_CASE("speed along a direction, and across the seam of a ring") {
    std::vector<Sighting> all;
    addPath(all, 1, 0, {{9, 0}, {9.5, 0.5}, {0, 1}});
    const Trajectories t = made(all, 1.0);
    CHECK(personalSpeeds(t, {.frameStep = 1, .direction = Vec2{2, 0}, .period = 10.0})[1] ==
          doctest::Approx(0.5));
    CHECK(personalSpeeds(t, {.frameStep = 1, .direction = Vec2{0, -3}, .period = 10.0})[1] ==
          doctest::Approx(-0.5));
    CHECK(personalSpeeds(t, {.frameStep = 1, .period = 10.0})[1] == doctest::Approx(std::sqrt(0.5)));
}

TEST_CASE("the mean speed in an area is 0 where nobody is") {
    std::vector<Sighting> all;
    addPath(all, 1, 0, {{-2, 0}, {-1, 0}, {0.5, 0}, {1, 0}});
    addPath(all, 2, 0, {{5, 0}, {5, 0}, {5, 0}, {5, 0}});
    const Trajectories t = made(all, 1.0);
    const Region area = Region::create({{0, -1}, {2, -1}, {2, 1}, {0, 1}}).value();
    const auto mean = meanSpeed(t, area, personalSpeeds(t, {.frameStep = 1}));
    CHECK(mean == std::vector<double>{0.0, 0.0, 1.0, 0.0});
    CHECK(classicDensity(t, area) == std::vector<double>{0.0, 0.0, 0.25, 0.25});
}

TEST_CASE("steady states, first values, smoothing") {
    std::vector<double> values;
    for (int i = 0; i < 30; ++i) values.push_back(i / 30.0);
    for (int i = 0; i < 100; ++i) values.push_back(1.0 + (i % 2 == 0 ? 0.02 : -0.02));
    for (int i = 0; i < 20; ++i) values.push_back(1.0 - i / 20.0);
    const SteadyState steady = steadyState(values);
    CHECK(steady.begin >= 25);
    CHECK(steady.begin <= 32);
    CHECK(steady.end >= 128);
    CHECK(steady.end <= 134);
    CHECK(steady.mean == doctest::Approx(1.0).epsilon(0.005));
    CHECK(steadyState(std::vector<double>(50, 3.0)).mean == 3.0);
    CHECK(std::isnan(steadyState({}).mean));
    CHECK(firstReaching(values, 0.5) == 15);
    CHECK(firstReaching(values, 5.0) == values.size());
    CHECK(smoothed(std::vector<double>{1, 2, 6, 3}, 3) == std::vector<double>{1, 3, 11.0 / 3.0, 3});
    CHECK(meanOf(std::vector<double>{1, 3}).deviation == doctest::Approx(1.0));
}

TEST_CASE("headways in a file and round a ring") {
    const Trajectories t = made({{0, 1, {1, 0}}, {0, 2, {4, 0}}, {0, 3, {8.5, 0}}});
    const auto file = headways(t);
    REQUIRE(file.size() == 2);
    CHECK(file[0].ahead == 2);
    CHECK(file[0].distance == doctest::Approx(3.0));
    const auto ring = headways(t, 10.0);
    REQUIRE(ring.size() == 3);
    CHECK(ring[2].ahead == 1);
    CHECK(ring[2].distance == doctest::Approx(2.5));
    const auto back = headways(t, 10.0, true);
    CHECK(back[2].ahead == 3);
    CHECK(back[2].distance == doctest::Approx(2.5));
}

TEST_CASE("who is seen last, and when") {
    std::vector<Sighting> all;
    addPath(all, 1, 0, {{0, 0}, {0, 0}, {0, 0}});
    addPath(all, 2, 0, {{0, 0}});
    CHECK(lastSeen(made(all, 2.0)) == std::vector<double>{0.0, 1.0});
}
