// The structs of definitions in C++, with their archives.
import { structLines } from './cpp_struct.mjs';
import { definitions } from './read.mjs';

export const kDefinitionsBanner = '// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.\n';

/** The header of each subject: what it is about, and what else it includes. */
const kHeaders = {
  ground: { about: 'What lies on the ground: obstacles, patches, areas, items, maps.', includes: ['generated/enumerations', 'geometry', 'id', 'status', 'vec2'] },
  people: { about: 'What single characters are, and how the persons of a group differ.', includes: ['generated/enumerations'] },
  orders: {
    about: 'What groups are to do, one after the other, and how they behave meanwhile (SPEC B3, B11, B12, B14, B15).',
    includes: ['generated/enumerations', 'generated/ground_definitions', 'geometry', 'id', 'vec2'],
  },
  world: {
    about: 'What a world is made of: the data of a scenario.',
    includes: ['generated/enumerations', 'generated/ground_definitions', 'generated/orders_definitions', 'generated/parameters', 'generated/people_definitions', 'ground', 'vec2'],
  },
};

const struct = (one) => structLines(one, { archived: one.flags.has('unsaved') ? '' : 'it' }).join('\n');

function header(subject) {
  const own = definitions.filter((definition) => definition.header === subject);
  const { about, includes } = kHeaders[subject];
  return `${kDefinitionsBanner}// ${about}
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

${includes.map((name) => `#include "muster/${name}.h"`).join('\n')}

namespace muster {

${own.map(struct).join('\n\n')}

}  // namespace muster
`;
}

export const definitionFiles = () =>
  Object.fromEntries(Object.keys(kHeaders).map((subject) => [`include/muster/generated/${subject}_definitions.h`, header(subject)]));
