// The structs of api/*.txt that are written for C++ too: what is read of worlds. And how they become those of C.
import { apiSections, apiStructs, isFlat, makerOf } from './api.mjs';
import { call, docComment, hasOf, rowsOf, withUnit } from './text.mjs';
import { isEnumeration } from './read.mjs';
import { cppItem, isId, plain } from './types.mjs';

const kInclude = 'include/muster/generated';

/** The headers of C++: where they stand, what they are about, and what they include. */
const kFiles = {
  walk_totals: { about: 'Sums over the path costs of many.', uses: [], includes: [] },
  control: {
    about: 'Controls: points of a mesh that fingers move along trajectories (paper sections 4.1 and 4.2).',
    uses: ['cstdint', 'vector'],
    includes: ['generated/enumerations', 'geometry', 'id', 'vec2'],
  },
  event: { about: 'What happened in a step.', uses: ['cstdint'], includes: ['generated/enumerations', 'vec2'] },
  characters: {
    about: 'Read access to the characters of a world, and to the contacts between them.',
    uses: ['cstddef', 'cstdint', 'span'],
    includes: ['generated/enumerations', 'generated/people_definitions', 'ground', 'vec2'],
  },
  views: {
    about: 'Read access to a world except its characters: groups, obstacles, patches, areas.',
    uses: ['cstdint', 'optional', 'span', 'string_view', 'vector'],
    includes: ['generated/control', 'generated/orders_definitions', 'generated/walk_totals', 'ground', 'id', 'vec2'],
  },
  take: {
    about: 'What takes hold, and the outcome of a replay.',
    uses: ['cstddef', 'cstdint', 'string', 'vector'],
    includes: ['event', 'status', 'vec2'],
  },
  figures: {
    folder: 'src/engine/world/generated',
    about: "Figures of runs, in the words of the specification's section 8.",
    uses: ['array', 'cstdint', 'string', 'vector'],
    includes: ['generated/enumerations', 'generated/walk_totals', 'id', 'views'],
  },
};

/** Types that C++ spells in a way of its own. */
const kItems = {
  ...{ MotionIndex: 'MotionId', f32: 'float', u64: 'std::uint64_t', size: 'std::size_t' },
  EventCounts: 'std::array<std::uint64_t, kCountOf<EventKind>>',
  StageMeans: 'std::array<double, kStageCount>',
};

/** How C++ spells the type of a field. Columns hold ids as numbers. */
export function typeOf(struct, field) {
  const { type, isList, isOptional } = field;
  const item = struct.columns && isId(type) ? 'std::uint32_t' : (kItems[type] ?? cppItem(type));
  if (isList) return struct.columns || struct.spans ? `std::span<const ${item}>` : `std::vector<${item}>`;
  if (field.length) return `std::array<${item}, ${field.length}>`;
  if (type === 'text' && struct.spans) return 'std::string_view';
  return isOptional ? `std::optional<${item}>` : item;
}

/** The default of a field; empty where its type has one. */
export function initialOf(field) {
  const { type, isList, isOptional, length } = field;
  if (isList || isOptional) return '';
  if (isEnumeration(type)) return field['='] ? `${type}::${field['=']}` : '{}';
  if (field['=']) return field['='];
  if (type === 'EventCounts' || type === 'StageMeans' || length) return '{}';
  return ['u64', 'size'].includes(type) ? '0' : (plain(type)?.initial ?? '');
}

/** "double speed = 1.0". */
function declared(struct, field) {
  const initial = initialOf(field);
  const named = `${typeOf(struct, field)} ${field.as ?? field.name}`;
  return initial === '' || initial.startsWith('{') ? `${named}${initial}` : `${named} = ${initial}`;
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
  const rows = fields.map((field) => ({ code: `${declared(struct, field)};`, about: withUnit(field) }));
  const lines = [...docComment(struct.sentence), `struct ${struct.cpp} {`, ...rowsOf(rows)];
  if (struct.columns) lines.push('', '    std::size_t size() const { return id.size(); }  ///< Number of entries.');
  if (struct.functions.length > 0) lines.push('');
  for (const { sentence, code } of struct.functions) lines.push(...docComment(sentence, '    '), ...code.split('\\n').map((line) => `    ${line}`));
  if (struct.archived) lines.push(...kArchive(fields.map(({ name }) => name)));
  if (struct.equal) lines.push('    /// Equal in all parts.', `    friend bool operator==(const ${struct.cpp}&, const ${struct.cpp}&) = default;`);
  return [...lines, '};'].join('\n');
}

const includesOf = (names, mark) => (names.length === 0 ? '' : `${names.map(mark).join('\n')}\n\n`);

function header(name) {
  const { about, uses, includes } = kFiles[name];
  const structs = apiStructs.filter((struct) => struct.in === name);
  return `// Made by schema/generate.mjs from schema/api/${structs[0].file}.txt: change these, not this file.
// ${about}
#pragma once

${includesOf(uses, (one) => `#include <${one}>`)}${includesOf(includes, (one) => `#include "muster/${one}.h"`)}namespace muster {

${structs.map(structOf).join('\n\n')}

}  // namespace muster
`;
}

/** The line that fills one member of C; none where it is the number of a list. */
function marshal(struct, field) {
  const { name, type, isList, isOptional } = field;
  if (field['cpp-only'] || (field['c-only'] && !field.as)) return [];
  const from = `p.${field.as ?? name}`;
  const both = `c.${name}, ${from}`;
  const has = `c.${hasOf(name)}`;
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
  const version = struct.version ? [`m.template version<Muster${struct.name}>(c.structVersion);`] : [];
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
  const written = apiStructs.filter(({ cpp, file }) => cpp && file === 'views');
  const isPlain = ({ name }) => isFlat(name);
  return `// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What is read of worlds, as structs of C (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/world_fields.h"
#include "muster/event.h"
#include "muster/muster.h"
#include "muster/views.h"

namespace muster::c_api {

${written.filter(isPlain).map(layoutOf).join('\n')}

${written.filter((struct) => !isPlain(struct)).map(fieldsOf).join('\n')}

}  // namespace muster::c_api
`;
}

/** The versions of the structs of a component that callers hand over. */
function versions(component) {
  const structs = apiSections.filter((section) => section.component === component).flatMap(({ declarations }) => declarations.filter(({ version }) => version));
  const lines = structs.map((one) => `MUSTER_STRUCT_VERSION(Muster${one.name}, ${one.version.replace('.', ', ')}, "${makerOf(one)}");`);
  return `// Made by schema/generate.mjs from schema/api: change these, not this file.
// Versions of structs that callers hand over: a number per kind, and that of its members.
#pragma once

#include "bindings/c/c_world/struct_version.h"
#include "muster/muster.h"

namespace muster::c_api {

${lines.join('\n')}

}  // namespace muster::c_api
`;
}

const kModules = { core: 'c_world', motion: 'c_motion', io: 'c_io' };

export const viewFiles = () => ({
  ...Object.fromEntries(Object.entries(kModules).map(([component, module]) => [`bindings/c/${module}/generated/struct_versions.h`, versions(component)])),
  ...Object.fromEntries(Object.entries(kFiles).map(([name, { folder = kInclude }]) => [`${folder}/${name}.h`, header(name)])),
  'bindings/c/c_world/generated/view_fields.h': marshalling(),
});
