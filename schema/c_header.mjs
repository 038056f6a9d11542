// The header of the C API: all that api/*.txt, enumerations.txt, definitions.txt and commands.txt declare.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { apiSections } from './api.mjs';
import { commandLines } from './c.mjs';
import { asInC, makerOf, membersLines, structLines } from './c_struct.mjs';
import { definitionLines } from './definitions_c.mjs';
import { enumerations, folder } from './read.mjs';
import { aligned, call, docComment, kWidth, singular, upperWords, wrap } from './text.mjs';
import { cType } from './types.mjs';

const pairs = (parameters) => parameters.map(({ name, type }) => `${type} ${name}`);

/** The parameters of a function of C: {name, type, out, count}. */
export function functionParameters({ parameters }) {
  return parameters.flatMap((parameter, at) => {
    const { name, type, isOut, isList, isPointer, isChanged } = parameter;
    const item = cType(type);
    if (isOut) {
      const own = `out${name[0].toUpperCase()}${name.slice(1)}`;
      if (!isList) return [{ name: own, type: isPointer ? `const ${item}**` : `${item}*`, out: true }];
      const list = { name: own, type: type === 'text' ? 'const char* const**' : `const ${item}**`, out: true, count: 'outCount' };
      const isLast = !(parameters[at + 1]?.isOut && parameters[at + 1].isList);
      return isLast ? [list, { name: 'outCount', type: 'int32_t*', out: true }] : [list];
    }
    if (type === 'bytes' || type === 'chars')
      return [{ name, type: type === 'bytes' ? 'const uint8_t*' : 'const char*', count: 'size' }, { name: 'size', type: 'size_t' }];
    if (isList) return [{ name, type: `const ${item}*`, count: `${singular(name)}Count` }, { name: `${singular(name)}Count`, type: 'int32_t' }];
    return [{ name, type: isPointer ? `const ${item}*` : isChanged ? `${item}*` : item }];
  });
}

/** What a function or a callback returns: a callback nothing, a function a status where it says nothing else. */
export function returnType({ kind, returns }) {
  if (returns === '') return kind === 'callback' ? 'void' : 'MusterStatus';
  return returns.endsWith('&') ? `const ${cType(returns.slice(0, -1))}*` : cType(returns);
}

/** The members of a handle. */
export const kHandle = [
  { type: 'uint32_t', name: 'index1', about: 'Slot, counted from 1; 0 for none.' },
  { type: 'uint32_t', name: 'generation', about: 'Which of those that had the slot.' },
];

const prototype = (returns, name, parameters) =>
  call(`MUSTER_API ${returns} ${name}(`, parameters.length === 0 ? ['void'] : pairs(parameters), ');', '');

const valueName = (prefix, name) => ['MUSTER', prefix, upperWords(name)].filter(Boolean).join('_');

/** The values of an enumeration: {name, value, about}. */
export function valuesOf({ prefix, values, isCounted }) {
  const all = isCounted ? [...values, { name: 'Count', sentence: 'Their number.' }] : values;
  return all.map(({ name, sentence }, value) => ({ name: valueName(prefix, name), value, about: asInC(sentence) }));
}

function enumeration(declaration) {
  const { name, type, sentence } = declaration;
  const rows = valuesOf(declaration).map((one, at, all) => ({ code: `${one.name} = ${one.value}${at + 1 < all.length ? ',' : ''}`, about: one.about }));
  return [...docComment(sentence), `typedef ${cType(type)} Muster${name};`, `/// Values of Muster${name}.`, `enum Muster${name}Value {`, ...aligned(rows), '};'];
}

function linesOf(declaration) {
  const { kind, name, sentence } = declaration;
  if (kind === 'enum') return enumeration(declaration);
  if (kind === 'number') return [...docComment(sentence), `typedef ${cType(declaration.type)} Muster${name};`];
  if (kind === 'handle') return membersLines(name, sentence, kHandle);
  if (kind === 'callback')
    return [...docComment(sentence), ...call(`typedef ${returnType(declaration)} (*Muster${name})(`, pairs(functionParameters(declaration)), ');', '')];
  if (kind === 'function') return [...docComment(sentence), ...prototype(returnType(declaration), `muster_${name}`, functionParameters(declaration))];
  const lines = structLines(declaration);
  if (declaration.made) lines.push('', ...docComment(declaration.made), ...prototype(`Muster${name}`, makerOf(declaration), []));
  return lines;
}

/** Enumerations of definitions, orders, commands and events, as those that api/*.txt declares. */
export const cEnumerations = enumerations.map((one) => ({ ...one, kind: 'enum', type: 'u8' }));
const enumerationLines = () => cEnumerations.map((one) => enumeration(one).join('\n')).join('\n\n');

/** What another file than api/*.txt declares, before the rest of its section. */
const kBefore = { values: enumerationLines, definitions: definitionLines, commands: commandLines };

/** "values: What definitions are made of." and its component, in lines behind the first word. */
function contents({ name, component, sentence }) {
  const column = Math.max(...apiSections.map((one) => one.name.length)) + 2;
  const about = component === 'core' ? sentence : `${sentence} Component ${component}.`;
  return wrap(about, kWidth - column - 8).map((line, at) => ` *   ${(at === 0 ? name : '').padEnd(column)}${line}`);
}

function section({ name, sentence, declarations }) {
  const title = `/* ==== ${name} ${'='.repeat(kWidth - name.length - 20)}`;
  const before = name in kBefore ? `\n${kBefore[name]()}\n` : '';
  const own = declarations.map((one) => `${one.isApart ? '\n' : ''}${linesOf(one).join('\n')}\n`).join('');
  return `${[title, ...wrap(sentence, kWidth - 6).map((line) => ` * ${line}`)].join('\n')} */
${before}${own}`;
}

const header = () => `/* Made by schema/generate.mjs from the declarations in schema/: change these, not this file. */
/* ${readFileSync(join(folder, 'api/introduction.txt'), 'utf8').trimEnd().split('\n').join('\n * ').replace(/ +$/gm, '')}
 *
 * Contents, in this order; a line of ==== begins each:
 *
${apiSections.flatMap(contents).join('\n')}
 */
#ifndef MUSTER_MUSTER_H
#define MUSTER_MUSTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(MUSTER_BUILDING) && defined(_WIN32)
#define MUSTER_API __declspec(dllexport)
#elif defined(MUSTER_SHARED) && defined(_WIN32)
#define MUSTER_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MUSTER_API __attribute__((visibility("default")))
#else
#define MUSTER_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

${apiSections.map(section).join('\n')}
#ifdef __cplusplus
}
#endif

#endif
`;

export const cHeaderFiles = () => ({ 'include/muster/muster.h': header() });
