// One trial of the study: a world, a control scheme, a clock, and a log of every input.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "muster/take.h"
#include "studio/gestures/scheme_driver.h"
#include "studio/study/trial/trial_environment.h"

namespace muster {

/// An input and the step that it belongs to: it is judged before the step from `step` to `step + 1`.
struct StampedInput {
    std::uint32_t step = 0;  ///< Number of steps done when it came.
    InputEvent event;        ///< What came.
};

/// Writes inputs as bytes.
std::vector<std::uint8_t> encodeInputs(std::span<const StampedInput> inputs);
/// Reads them. Fails with ParseError on other bytes.
Result<std::vector<StampedInput>> decodeInputs(std::span<const std::uint8_t> bytes);

/// What a trial is of.
struct TrialDef {
    std::string environment;  ///< Name of the environment.
    std::int32_t crowd = 36;  ///< Number of characters.
    std::string scheme;       ///< Name of the control scheme.
    std::uint64_t seed = 1;   ///< Places the items.
    bool mirrored = false;    ///< Top and bottom are swapped.
};

/// How a trial went.
struct TrialResult {
    bool done = false;           ///< All items were collected; else it is censored.
    std::uint32_t steps = 0;     ///< Steps until then, or all.
    double seconds = 0.0;        ///< The same as time [s].
    std::int32_t items = 0;      ///< Number of items.
    std::int32_t collected = 0;  ///< How many were collected.
    std::int32_t gestures = 0;   ///< Pointers that went down, and keys.
    std::int32_t commands = 0;   ///< Commands given, moves of fingers not counted.
    double idleSeconds = 0.0;    ///< Time in which fewer than a tenth of the characters moved [s].
    std::uint64_t hash = 0;      ///< Of the world at the end.
};

/// Runs one trial. The same inputs give the same result, bit for bit.
class Trial {
public:
    /// Builds the world. Fails where a name is unknown or a number out of range.
    static Result<Trial> create(const TrialDef& def);

    /// Takes an input for the next step. Fails, changing nothing, where it is malformed.
    Status input(const InputEvent& event);
    /// Makes a step.
    void step();
    /// True once all items are collected or the time is over.
    bool over() const;

    const TrialDef& def() const { return def_; }                      ///< What it is of.
    const World& world() const { return world_; }                     ///< Its world.
    const ControlScheme& scheme() const { return driver_.scheme(); }  ///< To show its marks.
    const GroundView& view() const { return view_; }                  ///< How it is seen.
    TrialResult result() const;                                       ///< Up to now.
    std::span<const StampedInput> inputs() const { return inputs_; }  ///< All, the view first.
    std::span<const Command> commands() const { return commands_; }   ///< All that the scheme gave.

private:
    Trial(TrialDef def, const SchemeDef& scheme, World world);

    TrialDef def_;
    World world_;
    SchemeDriver driver_;
    GroundView view_;
    std::vector<StampedInput> inputs_;
    std::vector<Command> commands_;
    std::vector<Command> stepCommands_;
    TrialResult result_;
};

/// Runs a trial again from its inputs, to its end.
Result<Trial> replayTrial(const TrialDef& def, std::span<const StampedInput> inputs);

}  // namespace muster
