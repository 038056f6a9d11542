// Parameters: their structs and their table in C++, their table for people, and their names in TypeScript.
import { addValue, fail, readKinds, readRange, word } from './read.mjs';
import { inCpp } from './enumerations.mjs';
import { aligned, docComment, lowerFirst, quoted, withUnit } from './text.mjs';

const kFrom = 'Made by schema/generate.mjs from schema/parameters.txt: change these, not this file.';
const kBanner = `// ${kFrom}\n`;
const kTypes = { f64: 'double', i32: 'std::int32_t', bool: 'bool' };

/** "preset units also muster "..."". */
function readPreset(tokens, line) {
  const preset = { name: word(tokens, line, 'a name'), also: [], sentence: '' };
  while (tokens[0]?.word === 'also') {
    tokens.shift();
    preset.also.push(word(tokens, line, 'another name'));
  }
  preset.sentence = tokens.shift()?.text ?? fail(line, `found no sentence for ${preset.name}`);
  return preset;
}

/** "group mesh "The deformable mesh."": a group may go on later, without a sentence. */
function readGroup(tokens, line) {
  const name = word(tokens, line, 'a name');
  const isInside = tokens[0]?.word === 'inside' && tokens.shift() !== undefined;
  return { name, isInside, sentence: tokens.shift()?.text ?? '', parameters: [] };
}

/** "reach f64 [m] 0..100 = 1.5 people 1 "..."". */
function readParameter(group, tokens, line) {
  const own = word(tokens, line, 'a name');
  const type = word(tokens, line, 'a type');
  const parameter = { name: `${group.name}.${own}`, own, type, unit: '', range: null, initial: '', presets: {}, sentence: '' };
  while (tokens.length > 0) {
    const { word: next, unit, text } = tokens.shift();
    if (text !== undefined) parameter.sentence = text;
    else if (unit !== undefined) parameter.unit = unit;
    else if (next === '=') parameter.initial = word(tokens, line, 'a default');
    else if (next === 'member') parameter.own = word(tokens, line, 'the name of a member');
    else if (next.includes('..')) parameter.range = readRange(next);
    else parameter.presets[next] = word(tokens, line, `the value in the preset ${next}`);
  }
  if (parameter.initial === '' || !parameter.sentence.endsWith('.')) fail(line, `${parameter.name} needs a default and a sentence`);
  group.parameters.push(parameter);
}

/** "enum PlanMode "How often..."". */
const readMode = (tokens, line) => ({ name: word(tokens, line, 'a name'), sentence: tokens.shift()?.text ?? fail(line, 'found no sentence'), values: [] });

const refuse = (owner, tokens, line) => fail(line, 'found a line of its own, expected none');
const found = readKinds('parameters.txt', {
  preset: { open: readPreset, add: refuse },
  retired: { open: (tokens, line) => word(tokens, line, 'a name'), add: refuse },
  enum: { open: readMode, add: addValue },
  group: { open: readGroup, add: readParameter },
});
const all = (kind) => found.filter(({ keyword }) => keyword === kind).map(({ owner }) => owner);

const presets = all('preset');
const others = presets.slice(1);
const modes = all('enum');
const groups = all('group');
export const parameters = groups.flatMap((group) => group.parameters.map((one) => ({ ...one, group })));
const modeOf = (type) => modes.find(({ name }) => name === type);

for (const { name, type, range, presets: values } of parameters) {
  if (!(type in kTypes) && !modeOf(type)) throw new Error(`schema/parameters.txt: ${name} has the unknown type ${type}`);
  if ((range === null) !== (type === 'bool' || modeOf(type) !== undefined)) throw new Error(`schema/parameters.txt: ${name}: only numbers have a range`);
  for (const preset of Object.keys(values))
    if (!others.some((one) => one.name === preset)) throw new Error(`schema/parameters.txt: ${name}: there is no preset ${preset}`);
}

/** "2" -> "2.0", "1/60" -> "1.0 / 60.0". */
const real = (text) => text.split('/').map((part) => (/[.e]/.test(part) ? part : `${part}.0`)).join(' / ');
const upperFirst = (text) => text[0].toUpperCase() + text.slice(1);
const structOf = ({ name }) => upperFirst(name);

/** A value as C++ spells it. */
function literal({ type }, value) {
  if (modeOf(type)) return `${type}::${value}`;
  return type === 'f64' ? real(value) : value;
}

/** What the table calls its unit. */
function unitOf({ type, unit }) {
  if (type === 'bool') return 'switch';
  return modeOf(type) ? 'mode' : unit || '1';
}

function boundsOf({ type, range }) {
  if (range !== null) return range;
  return { low: '0', high: String(type === 'bool' ? 1 : modeOf(type).values.length - 1) };
}

/** "[s], 0 to 2" behind the sentence. */
function commentOf(parameter) {
  const { type, unit, range } = parameter;
  if (modeOf(type)) return modeOf(type).sentence;
  const withRange = range === null ? parameter.sentence : parameter.sentence.replace(/\.$/, `; ${range.low} to ${range.high}.`);
  return withUnit({ sentence: withRange, unit: type === 'i32' ? '' : unit });
}

const row = (parameter) => ({
  code: `${kTypes[parameter.type] ?? parameter.type} ${parameter.own} = ${literal(parameter, parameter.initial)};`,
  about: commentOf(parameter),
});

/** The groups that are structs, each once, with all of its parameters. */
const structs = [...new Set(groups.map(({ name }) => name))]
  .map((name) => {
    const parts = groups.filter((group) => group.name === name);
    return { ...parts[0], parameters: parts.flatMap((part) => part.parameters) };
  });

function structOfGroup(group) {
  return [...docComment(group.sentence, '    '), `    struct ${structOf(group)} {`, ...aligned(group.parameters.map(row), '        '), '    };'].join('\n');
}

function header() {
  const nested = structs.filter(({ isInside }) => !isInside);
  const members = [
    ...structs.filter(({ isInside }) => isInside).flatMap((group) => group.parameters.map(row)),
    ...nested.map((group) => ({ code: `${structOf(group)} ${group.name};`, about: group.sentence.replace(/ \(SPEC[^)]*\)/, '') })),
  ];
  return `${kBanner}// Parameters of a world: every number that researchers and users may change.
#pragma once

#include <cstdint>

namespace muster {

${modes.map((mode) => inCpp({ ...mode, isCounted: false })).join('\n\n')}

/// The definition of a world's behaviour. The defaults are the preset \`${presets[0].name}\`. parameterTable() has the
/// name of each field in files and messages: "plan.exponent".
struct Parameters {
${nested.map(structOfGroup).join('\n\n')}

${aligned(members).join('\n')}
};

}  // namespace muster
`;
}

function tableRow(parameter) {
  const { name, own, group, sentence } = parameter;
  const { low, high } = boundsOf(parameter);
  const pointers = group.isInside ? `&P::${own}` : `&P::${group.name}, &P::${structOf(group)}::${own}`;
  return `    parameter<${pointers}>("${name}", "${unitOf(parameter)}", ${real(low)}, ${real(high)},\n        ${quoted(sentence)}),`;
}

/** The statements that make a preset of the defaults. */
function presetCase({ name }) {
  const own = parameters.filter((one) => name in one.presets);
  const statements = own.map((one) => `        p.${one.group.isInside ? '' : `${one.group.name}.`}${one.own} = ${literal(one, one.presets[name])};`);
  return [`    if (name == "${name}") {`, ...statements, '        return true;', '    }'].join('\n');
}

function rows() {
  const [first] = presets;
  const names = [first.name, ...first.also].map((name) => `name == "${name}"`).join(' || ');
  const list = (texts) => `std::to_array<std::string_view>({${texts.map((text) => `"${text}"`).join(', ')}});`;
  return `${kBanner}// The rows of the table of parameters, and what presets change.
#pragma once

#include <array>
#include <string_view>

#include "engine/state/parameter_row.h"

namespace muster::parameter_rows {

using P = Parameters;

// clang-format off
inline constexpr auto kAll = std::to_array<ParameterInfo>({
${parameters.map(tableRow).join('\n')}
});

/// Names of earlier versions.
inline constexpr auto kRetired = ${list(all('retired'))}

/// The presets, the defaults first.
inline constexpr auto kPresets = ${list(presets.map(({ name }) => name))}
// clang-format on

/// Makes a preset of the defaults; false where there is none of that name.
inline bool makePreset(Parameters& p, std::string_view name) {
    if (${names}) return true;
${others.map(presetCase).join('\n')}
    return false;
}

}  // namespace muster::parameter_rows
`;
}

/** "on", "0.5", "1": as people read a value. */
function shown({ type }, value) {
  if (type === 'bool') return value === 'true' ? 'on' : 'off';
  const mode = modeOf(type);
  return mode ? String(mode.values.findIndex(({ name }) => name === value)) : value;
}

const rangeShown = (parameter) => (parameter.type === 'bool' ? 'on, off' : `${boundsOf(parameter).low} to ${boundsOf(parameter).high}`);
const unitShown = ({ type, unit }) => (type in kTypes ? unit : '');

function documentRow(parameter) {
  const values = others.map(({ name }) => (name in parameter.presets ? shown(parameter, parameter.presets[name]) : ''));
  const cells = [`\`${parameter.name}\``, unitShown(parameter), rangeShown(parameter), shown(parameter, parameter.initial), ...values, parameter.sentence];
  return `| ${cells.join(' | ')} |`;
}

function document() {
  const tables = structs.map((group) => `## \`${group.name}\`

${group.sentence}

| parameter | unit | range | default | ${others.map(({ name }) => name).join(' | ')} | |
| --- | --- | --- | --- | ${others.map(() => '---').join(' | ')} | --- |
${group.parameters.map((one) => documentRow(one)).join('\n')}`);
  return `<!-- ${kFrom} -->
# Parameters

Every number of a world that may be changed: by \`--set NAME=VALUE\`, under \`parameters\` in [scenarios](scenario-format.md), while it
runs by the command \`SetParameter\`, and in the C++, C, Python and JavaScript interfaces by the same names. Where a cell of a preset is
empty it has the default. [Why they have these values](method/reproduction-parameters.md).

| preset | |
| --- | --- |
${presets.map(({ name, sentence }) => `| \`${name}\` | ${sentence} |`).join('\n')}

${tables.join('\n\n')}
`;
}

const valuesOf = ({ name, sentence, values }) => `/** ${sentence} */
export const k${name} = { ${values.map((value, at) => `${lowerFirst(value.name)}: ${at}`).join(', ')} } as const;`;

function names() {
  return `${kBanner}// Names of parameters, and the values of those that choose.

${modes.map(valuesOf).join('\n\n')}

/** A parameter of the world. */
export type ParameterName =
${parameters.map(({ name }) => `  | '${name}'`).join('\n')};
`;
}

export const parameterFiles = () => ({
  'include/muster/generated/parameters.h': header(),
  'src/engine/state/generated/parameter_rows.h': rows(),
  'docs/parameters.md': document(),
  'web/src/protocol/generated/parameters.ts': names(),
});
