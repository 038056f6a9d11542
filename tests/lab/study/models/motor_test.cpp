#include <doctest.h>

#include <cmath>

#include "lab/study/models/motor.h"

namespace muster {
namespace {

TEST_CASE("pointing and dragging follow Fitts's law with the published constants") {
    const OperatorParameters parameters = operatorSetting("default").value();
    const Motor mouse(parameters, false, 1.0);
    const Motor touch(parameters, true, 1.0);
    // Three bits: a distance of seven widths.
    CHECK(mouse.point(70.0, 10.0) == doctest::Approx(0.17 + 0.18 * 3.0));
    CHECK(touch.point(70.0, 10.0) == doctest::Approx(0.2 + 0.115 * 3.0));
    CHECK(mouse.drag(70.0, 10.0) == doctest::Approx(0.135 + 0.249 * 3.0));
    CHECK(touch.drag(70.0, 10.0) == doctest::Approx(1.18 * mouse.drag(70.0, 10.0)));
    // The notes' two check values: 584 and 579 ms at 3.34 bits.
    CHECK(touch.point((std::exp2(3.34) - 1.0) * 10.0, 10.0) == doctest::Approx(0.584).epsilon(0.01));
}

TEST_CASE("a path takes as long as its narrowness or the top speed of the hand asks for") {
    const OperatorParameters parameters = operatorSetting("default").value();
    const Motor mouse(parameters, false, 1.0);
    const Motor touch(parameters, true, 1.0);
    CHECK(mouse.draw(200.0, 10.0) == doctest::Approx(0.1 + 0.08 * 20.0));
    CHECK(mouse.draw(400.0, 400.0) == doctest::Approx(0.1 + 1.0));
    // A finger hides 4 mm of the width.
    CHECK(touch.draw(200.0, 14.0) == doctest::Approx(1.2 * (0.1 + 0.08 * 20.0)));
}

TEST_CASE("end points scatter as published: one mouse target in 25 is missed, fingers by 1.5 mm and more") {
    const OperatorParameters parameters = operatorSetting("default").value();
    CHECK(Motor(parameters, false, 1.0).scatter(4.13) == doctest::Approx(1.0));
    const Motor touch(parameters, true, 1.0);
    // Bi and Zhai 2016, the mean of both axes: sqrt(0.0075 W^2 + 1.68) and sqrt(0.0108 W^2 + 1.33) mm.
    for (const double width : {3.0, 6.0, 12.0}) {
        const double published = 0.5 * (std::sqrt(0.0075 * width * width + 1.68) +
                                        std::sqrt(0.0108 * width * width + 1.33));
        CHECK(touch.scatter(width) == doctest::Approx(published).epsilon(0.02));
    }
}

TEST_CASE("equal motor constants leave no difference between the devices") {
    const OperatorParameters parameters = operatorSetting("equal-motor").value();
    const Motor mouse(parameters, false, 1.2);
    const Motor touch(parameters, true, 1.2);
    for (const double distance : {5.0, 50.0, 300.0}) {
        CHECK(mouse.point(distance, 8.0) == touch.point(distance, 8.0));
        CHECK(mouse.drag(distance, 8.0) == touch.drag(distance, 8.0));
        CHECK(mouse.draw(distance, 8.0) == touch.draw(distance, 8.0));
    }
    CHECK(mouse.press() == touch.press());
}

TEST_CASE("draws have the moments that they should have") {
    Chance chance(5);
    double sum = 0.0;
    double squares = 0.0;
    double gammas = 0.0;
    double gammaSquares = 0.0;
    double logs = 0.0;
    constexpr int kCount = 40000;
    for (int i = 0; i < kCount; ++i) {
        const double z = chance.normal();
        sum += z;
        squares += z * z;
        const double g = chance.gamma(0.3);
        gammas += g;
        gammaSquares += g * g;
        logs += std::log(chance.logNormal(0.22)) * std::log(chance.logNormal(0.22)) > -1e9 ? 1.0 : 0.0;
    }
    CHECK(std::abs(sum / kCount) < 0.02);
    CHECK(squares / kCount == doctest::Approx(1.0).epsilon(0.03));
    CHECK(gammas / kCount == doctest::Approx(1.0).epsilon(0.01));
    const double variance = gammaSquares / kCount - (gammas / kCount) * (gammas / kCount);
    CHECK(std::sqrt(variance) == doctest::Approx(0.3).epsilon(0.03));
    CHECK(logs == kCount);
}

}  // namespace
}  // namespace muster
