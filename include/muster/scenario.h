// Scenario files: everything a world starts from. Gesture files: time-stamped touches and other commands.
// Both are JSON (docs/scenario-format.md).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/generated/world_definitions.h"
#include "muster/status.h"

namespace muster {

inline constexpr std::size_t kMaxScenarioBytes = 64u << 20;  ///< Largest file that is read [bytes].

/// Reads a scenario file. Every failure is one sentence `FILE: JSON-PATH: found X, expected Y`
/// (syntax errors name line and column instead of the path).
Result<WorldDef> loadScenario(const std::string& path);
/// The same from text. `sourceName` stands for the file in messages; `baseFolder` is where relative map
/// files are looked for (empty: files are refused, only embedded maps are allowed).
Result<WorldDef> parseScenario(std::string_view text, const std::string& sourceName,
                               const std::string& baseFolder);
/// The whole definition as text with its map embedded: parsing it gives the same definition, bit for bit.
std::string writeScenario(const WorldDef& def);
/// Writes the text to a file. Fails with IoError.
Status saveScenario(const WorldDef& def, const std::string& path);

/// The JSON Schema (draft 2020-12) of scenario files, made from the same tables as the loader.
std::string scenarioSchema();

/// Lists what is valid but likely a mistake: gaps narrower than a character, starts inside obstacles or on
/// top of each other, orders that lead nowhere, exits and sources without room for a body, people without a
/// way to an exit. One sentence each, at most `most`.
std::vector<std::string> scenarioWarnings(const WorldDef& def, std::size_t most = 20);

/// Reads a gestures file into commands for a world of that step time, ordered by (step, client, sequence).
/// An event at time t belongs to step floor(t / stepTime + 1e-9); those of one step and client keep the order
/// of the file. Fails as loadScenario does.
Result<std::vector<Command>> loadGestures(const std::string& path, double stepTime);
/// The same from text.
Result<std::vector<Command>> parseGestures(std::string_view text, const std::string& sourceName,
                                           double stepTime);
/// The same from the text of a single event or of an array of events, as messages carry them: `t` may be left
/// out and is 0 then. Errors name the event by its index: `NAME: $[1].x: found...`.
Result<std::vector<Command>> parseCommands(std::string_view text, const std::string& sourceName,
                                           double stepTime);
/// The JSON Schema of gesture files, as scenarioSchema() for scenarios.
std::string gesturesSchema();
/// The touches that a scenario read from `scenarioPath` carries: its gestures file, which lies in the
/// scenario's folder or below, for a world of its step time. Empty where it carries none. Fails as
/// loadGestures does, naming the scenario.
Result<std::vector<Command>> loadScenarioGestures(const std::string& scenarioPath, const WorldDef& def);
/// Commands as the text of a gestures file: reading it gives the same commands, numbered again per client.
std::string writeGestures(std::span<const Command> commands, double stepTime);
/// Writes that text to a file. Fails with IoError.
Status saveGestures(std::span<const Command> commands, double stepTime, const std::string& path);

}  // namespace muster
