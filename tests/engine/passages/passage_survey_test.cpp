// Surveys of passages, in one step and over several.
#include <doctest.h>

#include <utility>

#include "base/archive.h"
#include "engine/passages/passage_scene.h"
#include "engine/passages/passage_survey.h"

using namespace muster;
using namespace muster::testing;

namespace {

SurveyState order(double people) {
    return {.phase = SurveyPhase::Search,
            .orders = {{{-10, 0}, {10, 0}, people, 2.0, 4.5, 2}},
            .crowd = {{-9, 2}, {-12, -1}}};
}

std::vector<std::uint8_t> bytesOf(SurveyState state) {
    Writer writer;
    writer(state);
    return writer.take();
}

/// The state after the survey, so many cells in each step. With `reload` it is repeated before each step, as
/// after loading.
SurveyState surveyed(const Environment& environment, const StaticGround& ground, SurveyState state,
                     std::int64_t cellsPerStep, bool reload = false, int* steps = nullptr) {
    PassageSurvey survey(12);
    for (int step = 1;; ++step) {
        std::int64_t cells = cellsPerStep;
        PassageSurvey fresh(12);
        if (steps != nullptr) *steps = step;
        if ((reload ? fresh : survey).advance(environment, ground, state, cells)) return state;
        REQUIRE(step < 10000);
    }
}

}  // namespace

TEST_CASE("a survey finds the ways that can help, the shortest first, and none in the open") {
    const auto survey = [](const Environment& environment, double people) {
        return surveyed(environment, groundOf(environment), order(people), 1 << 20).passages;
    };
    const Environment doors = walledFloor({{-12, -10}, {-0.6, 0.6}, {6, 11}});
    const std::vector<Passage> many = survey(doors, 200.0);
    REQUIRE(many.size() == 3);
    CHECK(many[0].width() == doctest::Approx(1.2));
    CHECK(many[1].width() == doctest::Approx(5.0));
    CHECK(many[2].width() == doctest::Approx(2.0));
    // Ten wait less than the way round takes, so that they have nothing to choose; three need not wait at
    // all.
    CHECK(survey(doors, 10.0).empty());
    CHECK(survey(doors, 3.0).empty());
    // In a row of many gaps nobody has to choose, nor where there is one door only.
    CHECK(
        survey(walledFloor({{-8, -7}, {-6, -5}, {-4, -3}, {-2, -1}, {0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}}),
               200.0)
            .empty());
    CHECK(survey(walledFloor({{-0.6, 0.6}}), 200.0).empty());
    // The narrowest gap of an open floor is wide enough for all.
    CHECK(survey(walledFloor({{-18, 18}}), 100.0).empty());
}

TEST_CASE("on wide cells whose centres lie on the wall's face all gaps are found") {
    Environment environment = Environment::create({.box = {{-55, -40}, {55, 40}}}).value();
    double from = -40.0;
    for (const auto& [low, high] :
         {std::pair{-29.6, -25.6}, {-9.6, -7.1}, {0.4, 2.4}, {14.4, 17.4}, {40.0, 40.0}}) {
        ObstacleDef part{.polygon = {{-0.5, from}, {0.5, from}, {0.5, low}, {-0.5, low}}};
        REQUIRE(environment.addObstacle(part).ok());
        from = high;
    }
    environment.setTime(0.0);
    const StaticGround ground = groundOf(environment);
    REQUIRE(ground.coarse().grid.cell == 1.0);
    SurveyState state = order(1500.0);
    state.orders[0].from = {-13.2, -1.6};
    state.orders[0].to = {14.8, -2.0};
    const SurveyState found = surveyed(environment, ground, state, 1 << 20);
    REQUIRE(found.passages.size() == 4);
    const double widths[] = {2.0, 2.5, 3.0, 4.0};
    for (std::size_t p = 0; p < 4; ++p) CHECK(found.passages[p].width() == doctest::Approx(widths[p]));
}

TEST_CASE("over several steps a survey finds the same, whether or not it is loaded in between") {
    const Environment doors = walledFloor({{-12, -10}, {-0.6, 0.6}, {6, 11}});
    const StaticGround ground = groundOf(doors);
    const SurveyState once = surveyed(doors, ground, order(200.0), 1 << 20);
    REQUIRE(once.passages.size() == 3);
    for (const std::int64_t cells : {97, 1500, 6000}) {
        int steps = 0;
        const SurveyState many = surveyed(doors, ground, order(200.0), cells, false, &steps);
        CHECK(steps > 1);
        CHECK(bytesOf(many) == bytesOf(once));
        CHECK(bytesOf(surveyed(doors, ground, order(200.0), cells, true)) == bytesOf(once));
    }
}

TEST_CASE("each step of a survey costs about what it may") {
    const Environment doors = walledFloor({{-12, -10}, {-0.6, 0.6}, {6, 11}});
    const StaticGround ground = groundOf(doors);
    SurveyState state = order(200.0);
    PassageSurvey survey(12);
    for (bool done = false; !done;) {
        std::int64_t cells = 2000;
        done = survey.advance(doors, ground, state, cells);
        CHECK(cells > -2000);  // The end of a search may take a little more.
    }
}

TEST_CASE("orders are made one after the other, each with the passages of those before closed") {
    const Environment doors = walledFloor({{-12, -10}, {-0.6, 0.6}, {6, 11}});
    const StaticGround ground = groundOf(doors);
    SurveyState state = order(200.0);
    state.orders.push_back({{-10, 3}, {10, 3}, 200.0, 2.0, 4.5, 1});
    state.crowd.push_back({-9, 3});
    const SurveyState both = surveyed(doors, ground, state, 1 << 20);
    CHECK(both.orders.empty());
    CHECK(both.crowd.empty());
    CHECK(both.known == 3);
    CHECK(both.passages.size() == 3);
}
