// Random definitions, for tests of all that carries definitions.
import { definitions, isDefinition, isEnumeration } from './read.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { isId } from './types.mjs';

const drawn = definitions.filter(({ name, flags }) => !flags.has('no-files') && name !== 'WorldDef' && name !== 'Distribution');

/** An expression that draws a number of a range. */
function number({ type, range, name }) {
  if (range === null) return type === 'f64' ? 'draw.real(0, 1)' : 'draw.number()';
  const bounds = `${range.low}, ${range.high}`;
  if (type !== 'f64') return type === 'u8' ? `static_cast<std::uint8_t>(draw.whole(${bounds}))` : `draw.whole(${bounds})`;
  if (range.orZero) return `draw.flag() ? 0.0 : draw.real(${bounds})`;
  return range.orNegative ? `draw.flag() ? -1.0 : draw.real(${bounds})` : `draw.real(${bounds})`;
}

/** An expression that draws one value of a type. */
function item(field) {
  const { type, range } = field;
  if (isId(type)) return `${type}{draw.number()}`;
  if (isEnumeration(type)) return `draw.value<${type}>()`;
  if (type === 'Distribution') return `draw.distribution(${range.low}, ${range.high})`;
  if (isDefinition(type)) return `random${type}(draw)`;
  if (type === 'Vec2') return range === null ? 'draw.place()' : `Vec2{draw.real(${range.low}, ${range.high}), draw.real(${range.low}, ${range.high})}`;
  if (type === 'text') return 'draw.text()';
  if (type === 'bool') return 'draw.flag()';
  if (type === 'Colour') return 'draw.number() & 0xffffffu';
  if (type === 'Polygon') return 'draw.polygon()';
  if (type === 'PolygonWithHoles') return 'draw.outline()';
  if (type === 'MotionIndex') return 'draw.whole(0, 7)';
  return number(field);
}

function statement(field) {
  const { name, isList, isOptional } = field;
  if (isList) return `    draw.list(d.${name}, [&] { return ${item(field)}; });`;
  return isOptional ? `    if (draw.flag()) d.${name} = ${item(field)};` : `    d.${name} = ${item(field)};`;
}

/** Fields that only one list of definitions has a meaning for are left as they are. */
const isDrawn = ({ name, type }) => !(type === 'i32' && name === 'group');

const random = ({ name, cpp, fields }) => `inline ${cpp} random${name}(DefinitionDraw& draw) {
    ${cpp} d;
${fields.filter(isDrawn).map(statement).join('\n')}
    draw.relate(d);
    return d;
}`;

export const definitionSampleFiles = () => ({
  'tests/generated/random_definitions.h': `${kDefinitionsBanner}// Random definitions of every kind, each of them valid.
#pragma once

#include "definition_draw.h"

namespace muster {

${drawn.map(random).join('\n')}

}  // namespace muster
`,
});
