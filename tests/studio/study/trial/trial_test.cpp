#include <doctest.h>

#include "muster/world.h"
#include "studio/study/trial/trial.h"

namespace muster {
namespace {

PointerEvent finger(const Trial& trial, PointerPhase phase, Vec2 ground) {
    return {.phase = phase,
            .pointer = 1,
            .screen = trial.view().screenOf(ground).value(),
            .time = trial.world().time()};
}

// A finger drags the crowd to the right for two seconds.
void drag(Trial& trial) {
    const Vec2 start = trial.world().group(0).pose.position;
    REQUIRE(trial.input(finger(trial, PointerPhase::Down, start)).ok());
    for (std::int32_t i = 1; i <= 120; ++i) {
        REQUIRE(trial.input(finger(trial, PointerPhase::Move, start + Vec2{0.05 * i, 0.0})).ok());
        trial.step();
    }
    REQUIRE(trial.input(finger(trial, PointerPhase::Up, start + Vec2{6.0, 0.0})).ok());
    trial.step();
}

TEST_CASE("a trial is the same again from its inputs, bit for bit") {
    const TrialDef def{"corridor", 16, "touch", 3, true};
    auto made = Trial::create(def);
    REQUIRE(made.ok());
    Trial trial = std::move(made).value();
    drag(trial);
    while (!trial.over()) trial.step();
    const TrialResult result = trial.result();
    CHECK_FALSE(result.done);
    CHECK(result.seconds == doctest::Approx(studyRules().limit));
    CHECK(result.gestures == 1);

    const auto bytes = encodeInputs(trial.inputs());
    const auto inputs = decodeInputs(bytes);
    REQUIRE(inputs.ok());
    const auto again = replayTrial(def, inputs.value());
    REQUIRE(again.ok());
    CHECK(again.value().result().hash == result.hash);
    CHECK(again.value().result().collected == result.collected);
    CHECK(again.value().commands().size() == trial.commands().size());
}

TEST_CASE("inputs that are cut off or of another kind are refused") {
    const auto bytes = encodeInputs(std::vector<StampedInput>{{4, PointerEvent{}}, {5, KeyEvent{}}});
    for (std::size_t size = 0; size < bytes.size(); ++size)
        CHECK_FALSE(decodeInputs(std::span(bytes).first(size)).ok());
    CHECK(decodeInputs(bytes).value().size() == 2);
    auto damaged = bytes;
    damaged[12] = 9;  // The kind of the first input.
    CHECK_FALSE(decodeInputs(damaged).ok());
}

TEST_CASE("malformed inputs and unknown names change nothing") {
    Trial trial = Trial::create({"single-block", 36, "mouse-paper", 1, false}).value();
    PointerEvent event{.screen = {.x = std::numeric_limits<double>::quiet_NaN()}};
    CHECK_FALSE(trial.input(event).ok());
    CHECK(trial.inputs().size() == 1);
    GroundView flat;
    flat.toScreen.fill(0.0);
    CHECK_FALSE(trial.input(flat).ok());
    CHECK_FALSE(Trial::create({"single-block", 36, "joystick", 1, false}).ok());
    CHECK_FALSE(Trial::create({"maze", 36, "touch", 1, false}).ok());
}

TEST_CASE("a crowd that nobody directs is idle all the time") {
    Trial trial = Trial::create({"four-blocks", 16, "touch", 2, false}).value();
    for (std::int32_t i = 0; i < 120; ++i) trial.step();
    CHECK(trial.result().idleSeconds == doctest::Approx(2.0));
    CHECK(trial.result().collected == 0);
    CHECK(trial.result().commands == 0);
}

}  // namespace
}  // namespace muster
