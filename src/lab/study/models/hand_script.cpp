#include "lab/study/models/hand_script.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kEventRate = 60.0;   // Rate of the events of a moving hand [1/s].
constexpr double kWobbleTime = 0.1;   // Time over which wobble is correlated [s].
constexpr double kTapSeconds = 0.05;  // Time that a finger is down for a tap [s].

// Share of a movement from rest to rest: half a cosine would do, a cubic costs less.
double eased(double t) {
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

void HandScript::add(PointerPhase phase, std::uint32_t pointer, PointerButton button, Modifiers modifiers,
                     double at, Vec2 ground, Vec2 errorMm, std::vector<ScriptedInput>& script) {
    PointerEvent event{.phase = phase,
                       .device = motor_->isTouch() ? PointerDevice::Touch : PointerDevice::Mouse,
                       .button = button,
                       .pointer = pointer};
    const Vec2 px = view_->screenOf(ground).value_or(Vec2{}) + errorMm / view_->mmPerPixel;
    event.screen = {std::clamp(px.x, 1.0, view_->width - 1.0), std::clamp(px.y, 1.0, view_->height - 1.0)};
    event.time = at;
    event.modifiers = modifiers;
    script.push_back({at, event});
}

double HandScript::stroke(std::uint32_t pointer, PointerButton button, Modifiers modifiers, double at,
                          Vec2 from, std::span<const PathLeg> legs, double width,
                          std::vector<ScriptedInput>& script) {
    add(PointerPhase::Down, pointer, button, modifiers, at, from, chance_->scatter(motor_->scatter(width)),
        script);
    return path(pointer, button, modifiers, at, from, legs, {}, width, script);
}

double HandScript::carry(std::uint32_t pointer, double at, Vec2 from, std::span<const PathLeg> legs,
                         double grip, double end, std::vector<ScriptedInput>& script) {
    const Vec2 beside = chance_->scatter(motor_->scatter(grip));
    add(PointerPhase::Down, pointer, PointerButton::Left, {}, at, from, beside, script);
    return path(pointer, PointerButton::Left, {}, at, from, legs, beside, end, script);
}

// Writes a path from the hand's touch until it lifts; all of it is off by `beside` [mm].
double HandScript::path(std::uint32_t pointer, PointerButton button, Modifiers modifiers, double at,
                        Vec2 from, std::span<const PathLeg> legs, Vec2 beside, double end,
                        std::vector<ScriptedInput>& script) {
    Vec2 wobble;
    const double keep = 1.0 - 1.0 / (kEventRate * kWobbleTime);
    const double fresh = motor_->device().wobble * std::sqrt(1.0 - keep * keep);
    double now = at;
    Vec2 begin = from;
    for (const PathLeg& leg : legs) {
        const auto count = static_cast<std::int32_t>(std::max(1.0, std::ceil(leg.seconds * kEventRate)));
        for (std::int32_t i = 1; i <= count; ++i) {
            const double t = static_cast<double>(i) / count;
            wobble = wobble * keep + chance_->scatter(fresh);
            add(PointerPhase::Move, pointer, button, modifiers, now + t * leg.seconds,
                lerp(begin, leg.to, eased(t)), beside + wobble, script);
        }
        now += leg.seconds + leg.pause;
        begin = leg.to;
    }
    now += motor_->press();
    add(PointerPhase::Up, pointer, button, modifiers, now, begin,
        beside + chance_->scatter(motor_->scatter(end)), script);
    last_ = begin;
    return now;
}

double HandScript::click(PointerButton button, Modifiers modifiers, double at, Vec2 where, double width,
                         std::vector<ScriptedInput>& script) {
    const Vec2 error = chance_->scatter(motor_->scatter(width));
    add(PointerPhase::Down, 1, button, modifiers, at, where, error, script);
    const double up = at + std::max(motor_->press(), kTapSeconds);
    add(PointerPhase::Up, 1, button, modifiers, up, where, error, script);
    last_ = where;
    return up;
}

double HandScript::key(std::uint8_t key, Modifiers modifiers, double at, std::vector<ScriptedInput>& script) {
    script.push_back({at, KeyEvent{key, at, modifiers}});
    return at;
}

}  // namespace muster
