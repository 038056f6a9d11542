// Scenario files: everything a world starts from, as JSON (docs/scenario-format.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text_file.h"
#include "muster/status.h"
#include "muster/world_def.h"

namespace muster {

inline constexpr std::size_t kMaxScenarioBytes = kMaxTextBytes;  ///< Largest file read.

/// Reads a scenario file. Every failure is one sentence `FILE: JSON-PATH: found X, expected Y`
/// (syntax errors name line and column instead of the path).
Result<WorldDef> loadScenario(const std::string& path);
/// The same from text. `sourceName` stands for the file in messages; `baseFolder` is where relative map
/// files are looked for (empty: files are refused, only embedded maps are allowed).
Result<WorldDef> parseScenario(std::string_view text, const std::string& sourceName,
                               const std::string& baseFolder);
/// The whole definition as text, its map embedded: parsing it gives the same definition, bit for bit.
std::string writeScenario(const WorldDef& def);
/// Writes the text to a file. Fails with IoError.
Status saveScenario(const WorldDef& def, const std::string& path);

/// The JSON Schema (draft 2020-12) of scenario files, made from the same tables as the loader.
std::string scenarioSchema();

/// What is legal but likely a mistake: gaps narrower than a character, starts inside obstacles, groups that
/// overlap. One sentence each, at most `most`.
std::vector<std::string> scenarioWarnings(const WorldDef& def, std::size_t most = 20);

}  // namespace muster
