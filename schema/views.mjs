// The structs of api/*.txt that are written for C++ too: what is read of worlds. And how they become those of C.
import { apiStructs, isFlat } from './api.mjs';
import { call, docComment, rowsOf, withUnit } from './text.mjs';
import { enumerations } from './read.mjs';
import { cppItem, isId, plain } from './types.mjs';

const kBanner = '// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.\n';

/** The headers of C++: what they begin with, and the headers of the types in them. */
const kFiles = {
  event: { about: 'What happened in a step.', includes: ['generated/enumerations', 'vec2'], system: ['cstdint'] },
  characters: {
    about: 'Read access to the characters of a world, and to the contacts between them.',
    includes: ['generated/enumerations', 'patch', 'unit', 'vec2'],
    system: ['cstddef', 'cstdint', 'span'],
  },
  views: {
    about: 'Read access to a world except its characters: groups, obstacles, patches, areas.',
    includes: ['area', 'control', 'formation', 'id', 'obstacle', 'order', 'patch', 'unit', 'vec2', 'walk_totals'],
    system: ['cstdint', 'optional', 'span', 'string_view', 'vector'],
  },
};

const isEnumeration = (type) => enumerations.some(({ name }) => name === type);
const kItems = { MotionIndex: 'MotionId', f32: 'float' };

/** How C++ spells the type of a field. Columns hold ids as numbers. */
function typeOf(struct, { type, isList, isOptional }) {
  const item = struct.columns && isId(type) ? 'std::uint32_t' : (kItems[type] ?? cppItem(type));
  if (isList) return struct.columns || struct.spans ? `std::span<const ${item}>` : `std::vector<${item}>`;
  if (type === 'text' && struct.spans) return 'std::string_view';
  return isOptional ? `std::optional<${item}>` : item;
}

function initialOf(field) {
  if (field.isList || field.isOptional) return '';
  if (isEnumeration(field.type)) return field['='] ? ` = ${field.type}::${field['=']}` : '{}';
  const initial = plain(field.type)?.initial ?? '';
  return initial === '' ? '' : ` = ${initial}`;
}

const kArchive = (names) => [
  '',
  '    /// Lets an archive read or write it.',
  '    template <class Archive>',
  '    void visit(Archive& archive) {',
  ...call('archive(', names, ');', '        '),
  '    }',
];

function structOf(struct) {
  const fields = struct.fields.filter((field) => !field['c-only']);
  const rows = fields.map((field) => ({ code: `${typeOf(struct, field)} ${field.as ?? field.name}${initialOf(field)};`, about: withUnit(field) }));
  const lines = [...docComment(struct.sentence), `struct ${struct.cpp} {`, ...rowsOf(rows)];
  if (struct.columns) lines.push('', '    std::size_t size() const { return id.size(); }  ///< Number of entries.');
  if (struct.archived) {
    lines.push(...kArchive(fields.map(({ name }) => name)));
    lines.push('    /// Equal in all parts.', `    friend bool operator==(const ${struct.cpp}&, const ${struct.cpp}&) = default;`);
  }
  return [...lines, '};'].join('\n');
}

function header(file) {
  const { about, includes, system } = kFiles[file];
  return `${kBanner}// ${about}
#pragma once

${system.map((name) => `#include <${name}>`).join('\n')}

${includes.map((name) => `#include "muster/${name}.h"`).join('\n')}

namespace muster {

${apiStructs.filter((struct) => struct.in === file).map(structOf).join('\n\n')}

}  // namespace muster
`;
}

/** The line that fills one member of C; none where it is the number of a list. */
function marshal(struct, field) {
  const { name, type, isList, isOptional } = field;
  if (field['cpp-only'] || (field['c-only'] && !field.as)) return [];
  const from = `p.${field.as ?? name}`;
  const both = `c.${name}, ${from}`;
  const has = `c.has${name[0].toUpperCase()}${name.slice(1)}`;
  if (isList) {
    const count = field.count ?? (struct.columns ? 'count' : `${name.replace(/s$/, '')}Count`);
    return [`m.${isFlat(type) ? 'list' : 'items'}(c.${name}, c.${count}, ${from}, "${name}");`];
  }
  if (isOptional && isEnumeration(type)) return [`m.optionalChoice(${has}, ${both}, kLastOf<${type}>, "${name}");`];
  if (isOptional) return [`m.optional(${has}, ${both});`];
  if (isId(type)) return [`m.id(${both});`];
  if (isEnumeration(type)) return [`m.choice(${both}, kLastOf<${type}>, "${name}");`];
  if (type === 'text') return [`m.text(${both});`];
  return [isFlat(type) ? `m.plain(${both});` : `m.part(${both}, "${name}");`];
}

function fieldsOf(struct) {
  const version = struct.versioned ? [`m.template version<Muster${struct.name}>(c.structVersion);`] : [];
  const lines = [...version, ...struct.fields.flatMap((field) => marshal(struct, field))];
  return `template <class M>
void fields(M& m, C<M, Muster${struct.name}>& c, P<M, ${struct.cpp}>& p) {
${lines.map((line) => `    ${line}`).join('\n')}
}`;
}

/** Flat structs are copied as they are: their members must lie at the same places. */
function layoutOf({ name, cpp, fields }) {
  const same = fields.slice(1).map((field) => `offsetof(Muster${name}, ${field.name}) == offsetof(${cpp}, ${field.name})`);
  return `static_assert(${[`sizeof(Muster${name}) == sizeof(${cpp})`, ...same].join(' &&\n              ')});`;
}

function marshalling() {
  const written = apiStructs.filter(({ cpp }) => cpp);
  const isPlain = ({ name }) => isFlat(name);
  return `${kBanner}// What is read of worlds, as structs of C (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/world_fields.h"
#include "muster/c/views.h"
#include "muster/characters.h"
#include "muster/event.h"
#include "muster/views.h"

namespace muster::c_api {

${written.filter(isPlain).map(layoutOf).join('\n')}

${written.filter((struct) => !isPlain(struct)).map(fieldsOf).join('\n')}

}  // namespace muster::c_api
`;
}

export const viewFiles = () => ({
  ...Object.fromEntries(Object.keys(kFiles).map((file) => [`include/muster/generated/${file}.h`, header(file)])),
  'bindings/c/c_world/generated/view_fields.h': marshalling(),
});
