// The structs of definitions in C, and both directions between C and C++.
import { makerOf, marshalled, sameLayout, structLines, versionLine } from './c_struct.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { definitions } from './read.mjs';
import { docComment } from './text.mjs';

export const definitionsInC = definitions.filter(({ flags }) => !flags.has('no-c'));

function struct(definition) {
  const { name, made } = definition;
  const lines = structLines(definition);
  if (made !== '') lines.push(...docComment(made), `MUSTER_API Muster${name} ${makerOf(definition)}(void);`);
  return lines.join('\n');
}

/** All of them in C. */
export const definitionLines = () => definitionsInC.map(struct).join('\n\n');

const marshalling = () => `${kDefinitionsBanner}// The fields of definitions, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/marshal.h"
#include "muster/generated/world_definitions.h"
#include "muster/muster.h"

namespace muster::c_api {

${definitionsInC.filter(({ version }) => version !== null).map(versionLine).join('\n')}

${definitionsInC.filter(({ flags }) => flags.has('flat')).flatMap(sameLayout).map((one) => `static_assert(${one});`).join('\n')}

/// Reads the preset, and what differs from it.
void parameterFields(FromC& m, const MusterWorldDef& c, Parameters& p);
/// Writes what differs from the preset "muster".
void parameterFields(ToC& m, MusterWorldDef& c, const Parameters& p);

${definitionsInC.map(marshalled).join('\n')}

}  // namespace muster::c_api
`;

const defaults = () => `${kDefinitionsBanner}// Definitions as they are made at first: those of the engine, so that none stands twice.
#include "bindings/c/c_world/default_of.h"

using namespace muster;
using namespace muster::c_api;

${definitionsInC.filter(({ made }) => made !== '').map((one) => `Muster${one.name} ${makerOf(one)}(void) {
    return defaultOf<Muster${one.name}, ${one.cpp}>();
}`).join('\n')}
`;

export const definitionCFiles = () => ({
  'bindings/c/c_world/generated/definition_fields.h': marshalling(),
  'bindings/c/c_world/generated/definition_defaults.cpp': defaults(),
});
