// The Python types of definitions, commands and what is read of worlds, and the table of C++ that converts them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { apiStructs } from './api.mjs';
import { memberOf } from './cpp_struct.mjs';
import { commands, definitions, enumerations, folder, formerCommands, isEnumeration } from './read.mjs';
import { lowerFirst, withUnit } from './text.mjs';

/** Structs that have a Python class of their own, or none. */
const kLeftOut = new Set(['CharactersView', 'GroupView', 'ObstacleView', 'PatchView', 'AreaView', 'TakeFrame']);

/** Classes with methods, which stand in python/NAME.py. */
const kWithMethods = ['Order', 'Distribution'];

const kRenamed = { def: 'placement', from: 'from_' };
const kWhole = /^(std::u?int(8|16|32|64)_t|std::size_t|MotionId|\w+Id)$/;

/** Types of C++ in Python: their annotation, and their default where the field has none of its own. */
const kPlain = {
  double: ['float', ''],
  bool: ['bool', 'False'],
  'std::string': ['str', '""'],
  Vec2: ['Vec2', '(0.0, 0.0)'],
  Box: ['Box', ''],
  Polygon: ['list[Vec2]', 'field(default_factory=list)'],
  Parameters: ['dict[str, float]', 'field(default_factory=dict)'],
  CommandBody: ['CommandBody', 'field(default_factory=Touch)'],
};

const pythonDoc = (text) => text.replace(/(\w)::(\w)/g, '$1.$2');

const structOf = (struct) => ({
  name: struct.cpp,
  doc: struct.sentences.filter((sentence) => sentence !== '').join(' '),
  fields: struct.fields.filter(({ flags }) => !flags.has('c-only')).map((field) => ({ ...memberOf(struct, field), doc: withUnit(field) })),
});

/** All structs, each after those that it is made of: {name, doc, fields: [{type, name, initial, doc}]}. */
function allStructs() {
  const read = apiStructs.filter(({ cpp }) => cpp && !kLeftOut.has(cpp));
  const found = [...definitions, ...commands, ...formerCommands, ...read].map(structOf);
  const byName = new Map(found.map((struct) => [struct.name, struct]));
  const ordered = new Map();
  const add = (struct) => {
    for (const { type } of struct.fields) {
      const parts = type === 'CommandBody' ? [...commands, ...formerCommands].map(({ name }) => name) : type.match(/\w+/g);
      for (const part of parts) if (byName.has(part) && !ordered.has(part)) add(byName.get(part));
    }
    ordered.set(struct.name, struct);
  };
  for (const struct of found) if (!ordered.has(struct.name)) add(struct);
  return [...ordered.values()];
}

/** A name of C++ as one of Python: maxSpeed, max_speed. */
const snake = (name) => kRenamed[name] ?? name.replace(/(?<=[a-z0-9])([A-Z])/g, '_$1').toLowerCase();

function annotation(type) {
  if (kWhole.test(type)) return 'int';
  if (type in kPlain) return kPlain[type][0];
  const [, outer, inner] = type.match(/^std::(optional|vector)<(.+)>$/) ?? [];
  if (outer === 'optional') return `${annotation(inner)} | None`;
  if (outer === 'vector') return `list[${annotation(inner)}]`;
  if (type === 'std::array<double, 3>') return 'tuple[float, float, float]';
  if (type.startsWith('std::array<double, ')) return 'dict[str, float]';
  if (type.startsWith('std::array<std::uint64_t, ')) return 'dict[str, int]';
  return type;
}

const float = (text) => (Number.isInteger(Number(text)) ? `${Number(text)}.0` : String(Number(text)));
const tuple = (text) => `(${text.split(',').map((part) => float(part.trim())).join(', ')})`;

/** The Python expression of a field's default. */
function defaultOf({ type, initial, name }) {
  if (type.startsWith('std::optional')) return 'None';
  if (initial === 'defaultClipFacts()') return 'field(default_factory=lambda: _core.default_clip_facts())';
  if (type.startsWith('std::vector') || type === 'Polygon') return 'field(default_factory=list)';
  if (type.startsWith('std::array') && initial === '{}') return 'field(default_factory=dict)';
  if (isEnumeration(type)) return `${type}.${snake(initial === '{}' ? enumerations.find((one) => one.name === type).values[0].name : initial.split('::')[1]).toUpperCase()}`;
  if (initial === 'true' || initial === 'false') return initial === 'true' ? 'True' : 'False';
  if (type === 'Box') return `(${[...initial.matchAll(/\{([-\d., ]+)\}/g)].map(([, corner]) => tuple(corner)).join(', ')})`;
  if (type === 'std::array<double, 3>') return tuple(initial.slice(1, -1));
  if (initial !== '' && initial !== '{}') return initial;
  if (kPlain[type]?.[1]) return kPlain[type][1];
  if (annotation(type) === 'int') return '0';
  if (type === 'double') throw new Error(`${name}: found a number without a default, expected one`);
  return `field(default_factory=${type})`;
}

/** Text in lines of at most 120 characters. */
function wrapped(text, indent) {
  const lines = [];
  let line = indent;
  for (const part of text.split(' ')) {
    if (line.length + part.length > 118 && line.trim() !== '') {
      lines.push(line.trimEnd());
      line = `${indent}    `;
    }
    line += `${part} `;
  }
  return [...lines, line.trimEnd()].join('\n');
}

function enumerationOf({ name, sentence, values }) {
  const named = (value) => snake(value.name).toUpperCase();
  return [
    `class ${name}(str, Enum):`,
    wrapped(`"""${pythonDoc(sentence)}`, '    '),
    '',
    ...values.map((value) => wrapped(`${named(value)}: ${pythonDoc(value.sentence)}`, '    ')),
    '    """',
    '',
    ...values.map((value) => `    ${named(value)} = "${lowerFirst(value.name)}"`),
  ].join('\n');
}

function classOf({ name, doc, fields }) {
  const lines = [
    '@dataclass(slots=True)',
    `class ${name}:`,
    wrapped(`"""${pythonDoc(doc)}`, '    '),
    '',
    '    Attributes:',
    ...fields.map((field) => wrapped(`${snake(field.name)}: ${pythonDoc(field.doc)}`, '        ')),
    '    """',
    '',
    ...fields.map((field) => `    ${snake(field.name)}: ${annotation(field.type)} = ${defaultOf(field)}`),
  ];
  if (kWithMethods.includes(name)) lines.push('', readFileSync(join(folder, 'python', `${name.toLowerCase()}.py`), 'utf8').trimEnd());
  return lines.join('\n');
}

const kHead = `"""Definitions, commands, orders and what is read of worlds, as plain data. Made by schema/generate.mjs: change what is declared
there, not this file.

Points are pairs (x, y) in metres, x to the right and y forward; wherever a list of points stands, an array of shape (n, 2) is taken
too. Ids are numbers, 0 for none. A value of an enumeration may be given as its word: \`FormationDef(kind="wedge")\`.
Ranges are checked where the engine gets the data, and a failure names the field.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Union

from . import _core

Vec2 = tuple[float, float]
Box = tuple[Vec2, Vec2]
`;

const kBody = () => `CommandBody = Union[\n${[...commands, ...formerCommands].map(({ name }) => `    ${name},`).join('\n')}\n]`;

function types(structs) {
  const names = [...enumerations, ...structs].map(({ name }) => name).concat('CommandBody', 'Vec2', 'Box').sort();
  const classes = structs.flatMap((struct) => (struct.name === 'Command' ? [kBody(), classOf(struct)] : [classOf(struct)]));
  return `${kHead}
__all__ = [
${names.map((name) => `    "${name}",`).join('\n')}
]


${[...enumerations.map(enumerationOf), ...classes].join('\n\n\n')}
`;
}

const words = ({ name, values }) => `template <>
struct Words<${name}> {
    static constexpr const char* kName = "${name}";
    static constexpr std::array kWords{${values.map((value) => `"${lowerFirst(value.name)}"`).join(', ')}};
};`;

const described = ({ name, fields }) => `template <>
struct Described<${name}> : std::true_type {
    static constexpr const char* kName = "${name}";
    template <class Visitor, class Value>
    static void fields(Visitor& visitor, Value& value) {
${fields.map((field) => `        visitor("${snake(field.name)}", value.${field.name});`).join('\n')}
    }
};`;

const table = (structs) => `// Made by schema/generate.mjs: names and fields of the Python types. Change what is declared in schema/, not this file.

${[...enumerations.map(words), ...structs.map(described)].join('\n')}
/// Every described type.
using AllDescribed = std::tuple<${structs.map(({ name }) => name).join(', ')}>;
`;

export function pythonFiles() {
  const structs = allStructs();
  return { 'bindings/python/muster/_types.py': types(structs), 'bindings/python/src/generated/described_types.inc': table(structs) };
}
