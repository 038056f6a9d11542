// The structs of definitions in C++, with their archives.
import { definitions, isDefinition, isEnumeration } from './read.mjs';
import { aligned, call, docComment, withUnit } from './text.mjs';
import { isId, plain } from './types.mjs';

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
    includes: ['generated/enumerations', 'generated/ground_definitions', 'generated/orders_definitions', 'generated/people_definitions', 'ground', 'parameters', 'vec2'],
  },
};

/** The name in C++ of a type that fields have. */
export function cppName(type) {
  if (type === 'text') return 'std::string';
  return plain(type)?.cpp ?? definitions.find(({ name }) => name === type)?.cpp ?? type;
}

function cppType({ type, isList, isOptional }) {
  const item = cppName(type);
  if (isList) return `std::vector<${item}>`;
  return isOptional ? `std::optional<${item}>` : item;
}

/** " = 0.0", " = SplitBy::Ids"; empty where the type has a default of its own. */
function initialOf({ type, initial, isList, isOptional }) {
  if (isOptional || ((isList || isDefinition(type) || isId(type) || type === 'text') && initial === '')) return '';
  if (isEnumeration(type)) return ` = ${type}::${initial}`;
  if (type === 'Box') return initial.replace(/,(?=\S)/g, ', ');
  const value = initial === '' ? (plain(type)?.initial ?? '') : initial;
  return value === '' ? '' : ` = ${value}`;
}

/** A field as a member: {type, name, initial}. */
export const definitionMember = (field) => ({ type: cppType(field), name: field.name, initial: initialOf(field).replace(' = ', '') });

/** Fields as archives take them: those of one version together. */
export function archiveLines(fields) {
  const groups = [];
  for (const { name, since, flags } of fields) {
    const head = flags.has('unhashed') ? `archive.optionalSince(${since}, ` : since === '' ? 'archive(' : `archive.since(${since}, `;
    const last = groups.at(-1);
    if (last?.head === head && !flags.has('unhashed')) last.names.push(name);
    else groups.push({ head, names: [name] });
  }
  return groups.flatMap(({ head, names }) => call(head, names, ');', '        '));
}

function struct({ cpp, sentences, fields, functions, flags }) {
  const rows = fields.map((field) => ({ code: `${cppType(field)} ${field.name}${initialOf(field)};`, about: withUnit(field) }));
  const lines = [...sentences.flatMap((sentence) => (sentence === '' ? ['///'] : docComment(sentence))), `struct ${cpp} {`, ...aligned(rows)];
  if (functions.length > 0) lines.push('');
  for (const { sentence, code } of functions) lines.push(...docComment(sentence, '    '), `    ${code}`);
  if (!flags.has('unsaved'))
    lines.push('', '    /// Lets an archive read or write it.', '    template <class Archive>', '    void visit(Archive& archive) {', ...archiveLines(fields), '    }');
  if (flags.has('equal')) lines.push('    /// Equal in all parts.', `    friend bool operator==(const ${cpp}&, const ${cpp}&) = default;`);
  return [...lines, '};'].join('\n');
}

function header(subject) {
  const own = definitions.filter((definition) => definition.subject === subject);
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
