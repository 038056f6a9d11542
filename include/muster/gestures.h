// Gesture files: time-stamped touches and other commands, as JSON (docs/scenario-format.md).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/status.h"
#include "muster/world_def.h"

namespace muster {

/// Reads a gestures file into commands for a world of that step time, ordered by (step, client, sequence).
/// An event at time t belongs to step floor(t / stepTime + 1e-9); those of one step and client keep the order
/// of the file. Fails as loadScenario does.
Result<std::vector<Command>> loadGestures(const std::string& path, double stepTime);
/// The same from text.
Result<std::vector<Command>> parseGestures(std::string_view text, const std::string& sourceName,
                                           double stepTime);
/// The touches that a scenario read from `scenarioPath` carries: its gestures file, which lies in the
/// scenario's folder or below, for a world of its step time. Empty where it carries none. Fails as
/// loadGestures does, naming the scenario.
Result<std::vector<Command>> loadScenarioGestures(const std::string& scenarioPath, const WorldDef& def);
/// Any command log as a gestures file: reading it gives the same commands, numbered anew per client.
std::string writeGestures(std::span<const Command> commands, double stepTime);
/// Writes that text to a file. Fails with IoError.
Status saveGestures(std::span<const Command> commands, double stepTime, const std::string& path);

}  // namespace muster
