// Writes enums.ts and structs.ts of the TypeScript binding.
import { pascal } from './model.mjs';

export const kHeading = '// Made by schema/generate.mjs from schema/api: change these, not this file.\n';

/** A doc comment of one or several lines. */
export function docLines(text, indent = '') {
  const words = text.split(' ');
  const lines = [''];
  for (const word of words) {
    const last = lines[lines.length - 1];
    if (last && `${last} ${word}`.length > 112 - indent.length) lines.push(word);
    else lines[lines.length - 1] = last ? `${last} ${word}` : word;
  }
  if (lines.length === 1) return [`${indent}/** ${lines[0]} */`];
  return [`${indent}/**`, ...lines.map((line) => `${indent} * ${line}`), `${indent} */`];
}

/** Makes names of C those of TypeScript, and drops what only C needs. */
export class Docs {
  constructor(model) {
    this.model = model;
    this.verbs = new Map(model.functions.map((one) => [one.name, one.owner === 'Muster' ? one.verb : `${one.owner}.${one.verb}`]));
    this.values = new Map();
    for (const integer of model.api.integers)
      for (const [k, { name }] of (integer.values ?? []).entries())
        this.values.set(name, `${model.nameOf(integer.name)}.${valueNames(integer)[k]}`);
  }

  of(text) {
    return text
      .replace(/,? of `size` bytes/g, '')
      .replace(/, which belong to the caller \(muster_free_buffer\(\)\)/g, '')
      .replace(/\b(muster_\w+)\(\)/g, (whole, name) => (this.verbs.has(name) ? `${this.verbs.get(name)}()` : whole))
      .replace(/\bMUSTER_[A-Z_]+\b/g, (name) => this.values.get(name) ?? name)
      .replace(/\bMuster[A-Z]\w+/g, (name) => (this.model.types.structs.has(name) || this.model.types.integers.has(name) ? this.model.nameOf(name) : name))
      .split(/(?<=\.) (?=[A-Z`])/)
      .filter((sentence) => !/`out[A-Z]|^Set by /.test(sentence))
      .join(' ');
  }
}

/** Names of the values of an integer type without what all of them begin with. */
export function valueNames({ values }) {
  const words = values.map(({ name }) => name.split('_'));
  let shared = 0;
  while (words.every((one) => one.length > shared + 1 && one[shared] === words[0][shared])) shared += 1;
  return words.map((one) => pascal(one.slice(shared)));
}

export function emitEnums(model) {
  const docs = new Docs(model);
  const lines = [kHeading];
  for (const integer of model.api.integers) {
    const name = model.nameOf(integer.name);
    lines.push(...docLines(docs.of(integer.doc)));
    if (!integer.values) {
      lines.push(`export type ${name} = number;`, '');
      continue;
    }
    lines.push(`export const ${name} = {`);
    valueNames(integer).forEach((value, k) => {
      lines.push(...docLines(docs.of(integer.values[k].doc), '  '), `  ${value}: ${integer.values[k].value},`);
    });
    lines.push('} as const;', `export type ${name} = (typeof ${name})[keyof typeof ${name}];`, '');
  }
  return lines.join('\n');
}

function emitRead(struct, names, docs) {
  const fixed = struct.mode === 'definition' ? '' : 'readonly ';
  const lines = docLines(docs.of(struct.doc));
  lines.push(`export interface ${struct.name}${struct.mode === 'readOut' ? ' extends ReadOut' : ''} {`);
  for (const field of struct.fields)
    lines.push(...docLines(docs.of(field.doc), '  '), `  ${fixed}${field.name}: ${names.field(field, struct.mode)};`);
  return [...lines, '}', ''];
}

function emitInit(struct, names, docs) {
  const lines = [`/** What may be given of ${struct.name}. */`, `export interface ${struct.name}Init {`];
  for (const field of struct.fields) {
    const optional = names.isOptional(struct, field);
    const type = names.givenField(field);
    lines.push(...docLines(docs.of(field.doc), '  '));
    lines.push(`  readonly ${field.name}${optional ? '?' : ''}: ${type}${optional ? ' | undefined' : ''};`);
  }
  return [...lines, '}', ''];
}

/** A command is one of its kinds, with the body of that kind. */
function emitCommand(struct, model, names, docs) {
  const lines = [];
  for (const [ending, given] of [['', false], ['Init', true]]) {
    lines.push(given ? '/** What may be given of the body of each kind. */' : '/** The body of each kind. */');
    lines.push(`export interface CommandBodies${ending} {`);
    for (const { value, kind, type } of model.bodies()) {
      const name = given && names.hasInit(`Muster${type}`) ? `${type}Init` : type;
      lines.push(`  /** ${kind} */`, `  ${value}: ${name};`);
    }
    lines.push('}', '');
    lines.push(...docLines(`${docs.of(struct.doc)} Of one kind.`));
    lines.push(`export interface CommandOf${ending}<Kind extends keyof CommandBodies${ending}> {`, '  /** Which body it has. */', '  kind: Kind;');
    for (const { name, doc } of struct.fields.filter(({ shape, name: one }) => shape === 'one' && one !== 'kind'))
      lines.push(...docLines(docs.of(doc), '  '), given ? `  ${name}?: number | undefined;` : `  ${name}: number;`);
    lines.push('  /** The change. */', given ? `  body?: CommandBodies${ending}[Kind] | undefined;` : '  body: CommandBodies[Kind];', '}', '');
    lines.push(...docLines(given ? 'What may be given of Command.' : docs.of(struct.doc)));
    lines.push(`export type Command${ending} = {`, `  [Kind in keyof CommandBodies${ending}]: CommandOf${ending}<Kind>;`, `}[keyof CommandBodies${ending}];`, '');
  }
  return lines;
}

export function emitStructs(model, names) {
  const docs = new Docs(model);
  const aliases = model.api.integers.map(({ name }) => model.nameOf(name));
  const body = model.structs.flatMap((struct) => {
    if (struct.type === 'MusterCommand') return emitCommand(struct, model, names, docs);
    const init = struct.given && names.hasInit(struct.type) ? emitInit(struct, names, docs) : [];
    return [...emitRead(struct, names, docs), ...init];
  });
  const text = body.join('\n');
  const used = aliases.filter((name) => new RegExp(`[:<] (readonly )?${name}\\b`).test(text));
  return [
    kHeading,
    "import type { ReadOut } from '../binding/read_out.js';",
    "import type { Rows } from '../binding/rows.js';",
    `import type { ${used.join(', ')} } from './enums.js';`,
    '',
    text,
  ].join('\n');
}
