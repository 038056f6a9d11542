// What is read of characters and groups, as properties of the Python classes.
import { apiStructs } from './api.mjs';
import { isFlat } from './c_struct.mjs';
import { isEnumeration } from './read.mjs';
import { call, docComment, quoted, withUnit, wrap } from './text.mjs';
import { isId } from './types.mjs';

const kNumbers = { u8: 'uint8', u32: 'uint32', i32: 'int32', f64: 'float64', MotionIndex: 'int32' };
const kShapes = { Vec2: 'Shape (n, 2), float64.', Triangle: 'Shape (n, 3), int32.', MeshPoint: 'Shape (n,), records of triangle and weight (3).' };

/** What Python has in a form of its own: ids and names are copies, a pose is position and angle. */
const kByHand = new Set(['id', 'name', 'pose']);

const snake = (name) => name.replace(/(?<=[a-z0-9])([A-Z])/g, '_$1').toLowerCase();

/** The shape of an array and the type of its elements. */
function shapeOf(type) {
  if (type in kShapes) return kShapes[type];
  if (isEnumeration(type)) return `Shape (n,), uint8: the index of a ${type}.`;
  if (isId(type) || type === 'CharacterId') return 'Shape (n,), uint32.';
  if (type in kNumbers) return `Shape (n,), ${kNumbers[type]}.`;
  return `Shape (n,), records with the fields of ${type}.`;
}

function property(field) {
  const sentence = withUnit(field).replace(/\bnone for\b/, 'None for');
  const doc = field.isList && isFlat(field.type) ? `${sentence} ${shapeOf(field.type)}` : sentence;
  const member = field.as || field.name;
  const texts = wrap(doc, 96).map((line, at, all) => quoted(at + 1 < all.length ? `${line} ` : line));
  const lines = call('define(', [`"${snake(member)}"`, `&View::${member}`], ',', '    ');
  const [first, ...others] = texts;
  const whole = `${lines[0]} ${first});`;
  if (others.length === 0 && whole.length <= 110) return whole;
  return [lines[0], ...texts.map((text, at) => `           ${text}${at + 1 < texts.length ? '' : ');'}`)].join('\n');
}

function visitor(name, about, view, fields) {
  return `${docComment(about).join('\n')}
template <class Define>
void ${name}(const Define& define) {
    using View = ${view};
${fields.map(property).join('\n')}
}`;
}

export function pythonViewFiles() {
  const fieldsOf = (cpp) => apiStructs.find((struct) => struct.cpp === cpp).fields.filter((field) => !field.flags.has('c-only'));
  const group = fieldsOf('GroupView').filter(({ name }) => !kByHand.has(name));
  return {
    'bindings/python/src/generated/view_properties.h': `// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What is read of characters and groups: the name in Python, the member and the description of each property.
#pragma once

#include "muster/views.h"

namespace muster::python {

${visitor('eachColumn', 'Calls `define` for each array of the characters.', 'CharactersView', fieldsOf('CharactersView'))}

${visitor('eachArray', 'Calls `define` for each array of a group.', 'GroupView', group.filter(({ isList, type }) => isList && isFlat(type)))}

${visitor('eachList', 'Calls `define` for each list of a group that is copied.', 'GroupView', group.filter(({ isList, type }) => isList && !isFlat(type)))}

${visitor('eachValue', 'Calls `define` for each value of a group.', 'GroupView', group.filter(({ isList }) => !isList))}

}  // namespace muster::python
`,
  };
}
