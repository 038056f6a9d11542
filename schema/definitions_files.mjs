// The fields of definitions in scenario and gesture files: one description for reading, writing and the schema.
import { definitions, isDefinition, isEnumeration } from './read.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { line } from './scenario.mjs';
import { limit, quoted, real } from './text.mjs';
import { isId } from './types.mjs';

/** Lists and definitions that files have in a form of their own: a function that is written by hand for each. */
const kOwnForms = {
  'Body[]': (field, need) => ['describeBodies', ['v', `"${field.name}"`, `d.${field.name}`, need]],
  'RoleDef[]': (field, need) => ['describeRoles', ['v', `d.${field.name}`, need]],
  'PeopleDef[]': (field, need) => ['describePeople', ['v', `d.${field.name}`, need]],
  'Order[]': (field) => ['describeOrders', ['v', `d.${field.name}`, limit(field.count.high), quoted(aboutOf(field))]],
  Distribution: (field) => ['describeDrawn', ['v', `"${field.name}"`, `d.${field.name}`, `"${field.unit}"`, quoted(aboutOf(field))]],
  TimedPath: (field) => ['describePath', ['v', `d.${field.name}`]],
  FormationDef: (field, need) => ['describeShape', ['v', `"${field.name}"`, `d.${field.name}`, quoted(aboutOf(field)), ...(need === 'Need::Required' ? [need] : [])]],
  PolygonWithHoles: (field) => ['describeOutline', ['v', `d.${field.name}`, quoted(aboutOf(field))]],
};

const aboutOf = ({ inFiles, sentence }) => inFiles || sentence;

/** "{0.0, 100.0, "m"}". */
function rangeOf({ type, range, unit, name }) {
  if (isId(type) || type === 'CharacterId' || type === 'OrderId') return 'kId';
  if (range === null) throw new Error(`schema/definitions.txt: ${name} needs a range, as files tell it`);
  const low = range.orZero ? '0' : range.low;
  return `{${real(low)}, ${real(range.high)}${unit === '' ? '' : `, "${unit}"`}}`;
}

/** When a field that is left out at its default stands in a file. */
function saysSomething({ name, type, initial, unless }) {
  const value = `d.${name}`;
  const says =
    isId(type) ? `static_cast<bool>(${value})`
    : isEnumeration(type) ? `${value} != ${type}::${initial}`
    : type === 'bool' ? value
    : (type === 'f64' && initial === '') || type === 'Vec2' ? `isSet(${value})`
    : `${value} != ${initial === '' ? '0' : initial}`;
  return unless === '' ? says : `${unless} || ${says}`;
}

/** The call that describes a field: what is called, and its arguments. */
function callOf(field, need) {
  const { name, type, isList, isOptional, count } = field;
  const key = `"${field.key || name}"`;
  const value = `d.${name}`;
  const about = quoted(aboutOf(field));
  const needed = need === 'Need::Optional' ? [] : [need];
  const own = kOwnForms[isList ? `${type}[]` : type];
  if (own) return own(field, need);
  if (isList && isDefinition(type)) return ['describeList', ['v', key, value, limit(count.high), about, ...needed]];
  if (isDefinition(type)) return ['describeObject', ['v', key, value, about]];
  if (type === 'Polygon') return ['v.points', [key, value, '3', 'kMaxCorners', about, ...needed]];
  if (isList && type === 'Vec2') return ['v.points', [key, value, count.low, limit(count.high), about, ...needed]];
  if (isList && isId(type)) return ['describeIds', ['v', key, value, limit(count.high), about]];
  if (isList) return ['v.numbers', [key, value, rangeOf(field), limit(count.high), about, ...needed]];
  if (isEnumeration(type)) return ['describeWord', ['v', key, value, `k${type}Words`, about, ...needed]];
  if (type === 'text') return ['v.text', [key, value, about, ...(field.initial === '' ? needed : [need, field.initial])]];
  if (type === 'bool') return ['v.flag', [key, value, about]];
  if (type === 'Vec2') return ['v.point', [key, value, about, ...needed]];
  if (type === 'Colour') return ['v.colour', [key, value, about]];
  if (type === 'MotionIndex') return ['v.nameOrIndex', [key, value, 'motions', about, ...needed]];
  if (type === 'f64' && isOptional) return ['v.optionalNumber', [key, value, rangeOf(field), about, need]];
  if (type === 'f64' && field.range?.orNegative) return ['v.optionalNumber', [key, value, rangeOf(field), about]];
  return [type === 'f64' ? 'v.number' : 'v.whole', [key, isId(type) ? `${value}.value` : value, rangeOf(field), about, ...needed]];
}

/** The lines that describe a field. */
function describe(field) {
  const { name, apart, flags, unit, needed } = field;
  if (apart !== null) return apart === '' ? [] : [`    ${apart}`];
  if (flags.has('xy')) {
    const one = (axis) => line('v.number(', [`"${axis}"`, `d.${name}.${axis}`, `{-1e6, 1e6, "${unit}"}`, quoted(aboutOf(field))], ');', '    ');
    return [...one('x'), ...one('y')];
  }
  const need = flags.has('required') ? 'Need::Required' : needed === '' ? 'Need::Optional' : `${needed} && !Visitor::kSchema ? Need::Required : Need::Optional`;
  const [head, words] = callOf(field, need);
  const indent = flags.has('omit') ? '        ' : '    ';
  const lines = line(`${head}(`, words, ');', indent);
  return flags.has('omit') ? [`    if (takesPart<Visitor>(${saysSomething(field)}))`, ...lines] : lines;
}

/** The fields in the order of files. */
export function inFileOrder(fields) {
  const ordered = fields.filter(({ filesAfter }) => filesAfter === '');
  for (const field of fields.filter(({ filesAfter }) => filesAfter !== ''))
    ordered.splice(ordered.findIndex(({ name }) => name === field.filesAfter) + 1, 0, field);
  return ordered;
}

function description({ cpp, fields, context }) {
  const more = context.map(({ name, type }) => `, ${type} ${name}`).join('');
  const lines = inFileOrder(fields).flatMap(describe);
  return `template <class Visitor>
void describe(Visitor& v, ${cpp}& d${more}) {
${lines.join('\n')}
}`;
}

const header = () => `${kDefinitionsBanner}// The fields of each definition in files, for a visitor (fields.h).
#pragma once

#include <string>
#include <vector>

#include "files/scenario/describe_parts.h"
#include "muster/generated/world_definitions.h"

namespace muster {

${definitions.filter(({ flags }) => !flags.has('no-files')).map(description).join('\n')}

}  // namespace muster
`;

export const definitionFileFiles = () => ({ 'src/files/scenario/generated/described_definitions.h': header() });
