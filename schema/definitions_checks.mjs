// What each field of a definition has to be.
import { definitionOf, definitions, isDefinition, isEnumeration } from './read.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { kWidth, limit, real } from './text.mjs';
import { isId } from './types.mjs';

/** Those that a command or a world holds; the rest is checked where it is made. */
const checked = definitions.filter(({ name, flags }) => !flags.has('no-files') && name !== 'TimedPath');

/** Checks that are written by hand, by the type of the field. */
const kOwnChecks = {
  TimedPath: ({ name }) => `isPath(d.${name})`,
  Distribution: ({ name, range }) => `isDistribution("${name}", d.${name}, ${real(range.low)}, ${real(range.high)})`,
  Colour: ({ name }) => `validateColour(d.${name})`,
};

/** The check of a number; null where every value will do. */
function numberCheck({ name, type, range, called, isOptional }) {
  if (range === null || (type === 'u8' && range.low === '0' && range.high === '255')) return null;
  const check = range.orZero ? 'isOwn' : range.orNegative ? 'isOwnOrNegative' : 'inRange';
  const [low, high] = type === 'f64' || type === 'Vec2' ? [real(range.low), real(range.high)] : [range.low, limit(range.high)];
  const one = (value) => `${check}("${called || name}", ${value}, ${low}, ${high})`;
  if (type === 'Vec2') return [one(`d.${name}.x`), one(`d.${name}.y`)];
  return one(isOptional ? `d.${name}.value_or(0.0)` : `d.${name}`);
}

/** The check of a list. */
function listCheck({ name, type, count, range }) {
  const list = `"${name}", d.${name}, ${limit(count.high)}`;
  if (type === 'Vec2') return `arePlaces(${list})`;
  if (isDefinition(type)) return `each(${list})`;
  if (isId(type)) return `atMost("${name}", d.${name}.size(), ${limit(count.high)})`;
  return `eachInRange(${list}, ${real(range.low)}, ${real(range.high)})`;
}

/** The checks of one field, as expressions of type Status. */
function checksOf(field) {
  const { name, type, isList, isOptional, flags, called } = field;
  const value = `d.${name}`;
  if (flags.has('unchecked')) return [];
  const checkList = definitionOf(type)?.inCommands['check-list'];
  const within = flags.has('within') ? `.within("${name}")` : '';
  if (isList) return [checkList ? checkList.replace('#', value) + within : listCheck(field)];
  if (kOwnChecks[type]) return [kOwnChecks[type](field) + within];
  if (isDefinition(type)) return [`${isOptional ? 'validateIfAny' : 'validate'}(${value})${within}`];
  if (isEnumeration(type)) return [`isKnown(${value}, kLastOf<${type}>, "${called || name}")`];
  if (type === 'text') return [`isText("${name}", ${value})`];
  if (type === 'Polygon') return [`${flags.has('required') ? 'isShape' : 'isShapeOrNone'}("${name}", ${value})`];
  if (type === 'Box') return [`isPlace("${name}", ${value}.min)`, `isPlace("${name}", ${value}.max)`];
  if (type === 'Vec2' && field.range === null) return [`isPlace("${name}", ${value})`];
  return [numberCheck(field) ?? []].flat();
}

/** A check that is too long for its line goes on below, behind its parenthesis. */
function statement(head, check) {
  const line = `    ${head}${check};`;
  if (line.length <= kWidth) return [line];
  const at = line.lastIndexOf(', ', kWidth - 1);
  return [line.slice(0, at + 1), ' '.repeat(line.indexOf('(', head.length) + 1) + line.slice(at + 2)];
}

function validator({ cpp, fields, flags }) {
  const checks = fields.flatMap(checksOf);
  if (flags.has('relations')) checks.push('relations(d)');
  if (checks.length === 1) return `Status validate(const ${cpp}& d) {\n    return ${checks[0]};\n}`;
  const [first, ...others] = checks;
  return [
    `Status validate(const ${cpp}& d) {`,
    ...statement('Status status = ', first),
    ...others.flatMap((check) => statement('if (status.ok()) status = ', check)),
    '    return status;',
    '}',
  ].join('\n');
}

const header = () => `${kDefinitionsBanner}// Checks of definitions: InvalidArgument or LimitExceeded, naming the first field that is bad.
#pragma once

#include "muster/generated/world_definitions.h"

namespace muster {

${checked.map(({ cpp }) => `Status validate(const ${cpp}& d);`).join('\n')}

// What the fields of a definition have to be together is written by hand.
${checked.filter(({ flags }) => flags.has('relations')).map(({ cpp }) => `Status relations(const ${cpp}& d);`).join('\n')}

}  // namespace muster
`;

const source = () => `${kDefinitionsBanner}#include "engine/state/generated/definition_checks.h"

#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {

${checked.map(validator).join('\n\n')}

}  // namespace muster
`;

export const definitionCheckFiles = () => ({
  'src/engine/state/generated/definition_checks.h': header(),
  'src/engine/state/generated/definition_checks.cpp': source(),
});
