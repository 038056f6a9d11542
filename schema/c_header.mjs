// The header of the C API: all that api/*.txt, enumerations.txt, definitions.txt and commands.txt declare.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { apiSections, cType, functionParameters, makerOf, returnType, structMembers } from './api.mjs';
import { commandLines } from './c.mjs';
import { definitionLines } from './definitions_c.mjs';
import { enumerationLines } from './enumerations.mjs';
import { folder } from './read.mjs';
import { aligned, call, docComment, kWidth, rowsOf, upperWords, wrap } from './text.mjs';

const pairs = (parameters) => parameters.map(({ name, type }) => `${type} ${name}`);

/** The declaration of a member, without its semicolon. */
function declared({ type, name, length, parameters, returns }) {
  if (type === 'function') return `${returns} (*${name})(${pairs(parameters).join(', ')})`;
  return `${type} ${name}${length ? `[${length}]` : ''}`;
}

/** Pointers to functions have their comments before them. */
function membersOf(members) {
  const lines = [];
  let rows = [];
  const flush = () => {
    if (rows.length > 0) lines.push(...aligned(rows));
    rows = [];
  };
  for (const member of members) {
    const row = { code: `${declared(member)};`, about: member.about };
    if (member.type === 'function') {
      flush();
      lines.push(...docComment(row.about, '    '), `    ${row.code}`);
    } else {
      rows.push(row);
    }
  }
  flush();
  return lines;
}

const struct = (name, sentence, members) => [...docComment(sentence), `typedef struct Muster${name} {`, ...membersOf(members), `} Muster${name};`];

const kHandle = [
  { type: 'uint32_t', name: 'index1', about: 'Slot, counted from 1; 0 for none.' },
  { type: 'uint32_t', name: 'generation', about: 'Which of those that had the slot.' },
];

const prototype = (returns, name, parameters) =>
  call(`MUSTER_API ${returns} ${name}(`, parameters.length === 0 ? ['void'] : pairs(parameters), ');', '');

const valueName = (prefix, name) => ['MUSTER', prefix, upperWords(name)].filter(Boolean).join('_');

/** The values of an enumeration: {name, value, about}. */
export function valuesOf({ prefix, values, isCounted }) {
  const all = isCounted ? [...values, { name: 'Count', sentence: 'Their number.' }] : values;
  return all.map(({ name, sentence }, value) => ({ name: valueName(prefix, name), value, about: sentence }));
}

function enumeration(declaration) {
  const { name, type, sentence } = declaration;
  const rows = valuesOf(declaration).map((one, at, all) => ({ code: `${one.name} = ${one.value}${at + 1 < all.length ? ',' : ''}`, about: one.about }));
  return [...docComment(sentence), `typedef ${cType(type)} Muster${name};`, `/// Values of Muster${name}.`, `enum Muster${name}Value {`, ...rowsOf(rows), '};'];
}

function linesOf(declaration) {
  const { kind, name, sentence } = declaration;
  if (kind === 'enum') return enumeration(declaration);
  if (kind === 'number') return [...docComment(sentence), `typedef ${cType(declaration.type)} Muster${name};`];
  if (kind === 'handle') return struct(name, sentence, kHandle);
  if (kind === 'callback')
    return [...docComment(sentence), ...call(`typedef ${returnType(declaration)} (*Muster${name})(`, pairs(functionParameters(declaration)), ');', '')];
  if (kind === 'function') return [...docComment(sentence), ...prototype(returnType(declaration), `muster_${name}`, functionParameters(declaration))];
  const lines = struct(name, sentence, structMembers(declaration));
  if (declaration.made) lines.push('', ...docComment(declaration.made), ...prototype(`Muster${name}`, makerOf(declaration), []));
  return lines;
}

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
