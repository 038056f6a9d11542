/* Made by schema/generate.mjs from schema/api/scenario.txt: change these, not this file. */
/* Scenario files: everything a world starts from. Gesture files: touches and other commands with their
 * times. Component io. */
#ifndef MUSTER_C_SCENARIO_H
#define MUSTER_C_SCENARIO_H

#include "muster/c/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A scenario in the library's memory.
typedef struct MusterScenarioId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterScenarioId;

/// Reads a scenario file. Every failure is one sentence `FILE: JSON-PATH: found X, expected Y`.
MUSTER_API MusterStatus muster_scenario_load(const char* path, MusterScenarioId* outScenario);
/// The same from text of `size` bytes. `sourceName` stands for the file in messages; `baseFolder` is where
/// relative map files are looked for (null or empty: files are refused, only embedded maps are allowed).
MUSTER_API MusterStatus muster_scenario_parse(const char* text, size_t size, const char* sourceName,
                                              const char* baseFolder, MusterScenarioId* outScenario);
/// A scenario of a definition.
MUSTER_API MusterStatus muster_scenario_from_def(const MusterWorldDef* def, MusterScenarioId* outScenario);
/// Ends a scenario. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_scenario_destroy(MusterScenarioId scenario);

/// Its whole definition. Valid until the scenario is destroyed.
MUSTER_API MusterStatus muster_scenario_def(MusterScenarioId scenario, MusterWorldDef* outDef);
/// Builds a world of it, as muster_world_create() with muster_scenario_def().
MUSTER_API MusterStatus muster_scenario_create_world(MusterScenarioId scenario, int32_t threads,
                                                     MusterWorldId* outWorld);
/// The whole definition as text with its map embedded: parsing it gives the same definition, bit for bit.
MUSTER_API MusterStatus muster_scenario_text(MusterScenarioId scenario, MusterBuffer* outText);
/// Writes the text to a file. Fails with IoError.
MUSTER_API MusterStatus muster_scenario_save(MusterScenarioId scenario, const char* path);
/// Lists what is valid but likely a mistake: one sentence each, at most `most`. Valid until the next call for
/// this scenario.
MUSTER_API MusterStatus muster_scenario_warnings(MusterScenarioId scenario, int32_t most,
                                                 const char* const** outSentences, int32_t* outCount);
/// The JSON Schema (draft 2020-12) of scenario files.
MUSTER_API MusterStatus muster_scenario_schema(MusterBuffer* outText);

/// Reads a gestures file into commands for a world of that step time [s], ordered by (step, client,
/// sequence). Fails as muster_scenario_load() does.
MUSTER_API MusterStatus muster_gestures_load(const char* path, double stepTime, MusterCommandListId* outList);
/// The same from text of `size` bytes.
MUSTER_API MusterStatus muster_gestures_parse(const char* text, size_t size, const char* sourceName,
                                              double stepTime, MusterCommandListId* outList);
/// The same from the text of a single event or of an array of events: `t` may be left out and is 0 then.
MUSTER_API MusterStatus muster_gestures_parse_commands(const char* text, size_t size, const char* sourceName,
                                                       double stepTime, MusterCommandListId* outList);
/// The touches that a scenario carries which was read from `scenarioPath`. Empty where it carries none.
MUSTER_API MusterStatus muster_gestures_of_scenario(const char* scenarioPath, MusterScenarioId scenario,
                                                    MusterCommandListId* outList);
/// The JSON Schema of gesture files.
MUSTER_API MusterStatus muster_gestures_schema(MusterBuffer* outText);
/// Commands as the text of a gestures file: reading it gives the same commands, numbered again per client.
MUSTER_API MusterStatus muster_gestures_text(const MusterCommand* commands, int32_t commandCount,
                                             double stepTime, MusterBuffer* outText);
/// Writes that text to a file. Fails with IoError.
MUSTER_API MusterStatus muster_gestures_save(const MusterCommand* commands, int32_t commandCount,
                                             double stepTime, const char* path);

#ifdef __cplusplus
}
#endif

#endif
