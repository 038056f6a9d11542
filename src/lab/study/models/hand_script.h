// Movements of hands as pointer events in time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/study/models/chance.h"
#include "lab/study/models/motor.h"
#include "studio/gestures/input_event.h"

namespace muster {

/// One event and the time at which it is made.
struct ScriptedInput {
    double time = 0.0;  ///< World time [s].
    InputEvent event;   ///< The event, whose time stamp is the same.
};

/// A point of a path and the time that a hand takes to get there.
struct PathLeg {
    Vec2 to;               ///< End point of the leg [m].
    double seconds = 0.0;  ///< Time that the leg takes [s].
    double pause = 0.0;    ///< Time that the hand rests at the end [s].
};

/// Writes scripts. Positions are on the ground; a point off the screen is brought to its edge.
class HandScript {
public:
    HandScript(const GroundView& view, const Motor& motor, Chance& chance)
        : view_(&view), motor_(&motor), chance_(&chance) {}

    /// A finger or button goes down at `from` at the time `at`, follows the legs, and lifts, with scatter at
    /// both ends and wobble between; `width`: of the target of each end [mm]. Returns when it lifts.
    double stroke(std::uint32_t pointer, PointerButton button, Modifiers modifiers, double at, Vec2 from,
                  std::span<const PathLeg> legs, double width, std::vector<ScriptedInput>& script);
    /// A stroke that takes hold of a thing within a target of `grip` and carries it to one of `end` [mm]. A
    /// person sees the thing move, so the hand keeps as far beside its path as it took hold.
    double carry(std::uint32_t pointer, double at, Vec2 from, std::span<const PathLeg> legs, double grip,
                 double end, std::vector<ScriptedInput>& script);
    /// A click or tap. Returns when it ends.
    double click(PointerButton button, Modifiers modifiers, double at, Vec2 where, double width,
                 std::vector<ScriptedInput>& script);
    /// A key. Returns when it is down.
    double key(std::uint8_t key, Modifiers modifiers, double at, std::vector<ScriptedInput>& script);
    /// Last position of the hand [m].
    Vec2 last() const { return last_; }

private:
    double path(std::uint32_t pointer, PointerButton button, Modifiers modifiers, double at, Vec2 from,
                std::span<const PathLeg> legs, Vec2 beside, double end, std::vector<ScriptedInput>& script);
    void add(PointerPhase phase, std::uint32_t pointer, PointerButton button, Modifiers modifiers, double at,
             Vec2 ground, Vec2 errorMm, std::vector<ScriptedInput>& script);

    const GroundView* view_;
    const Motor* motor_;
    Chance* chance_;
    Vec2 last_;
};

}  // namespace muster
