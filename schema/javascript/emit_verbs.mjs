// Writes layouts.ts, signatures.ts and verbs.ts of the TypeScript binding.
import { Docs, docLines, kHeading } from './emit_types.mjs';
import { kLeftOut, kWithin } from './model.mjs';

/** What parameters are where nothing is given, and nothing after them. */
const kDefaults = {
  threads: '1',
  overwrite: 'false',
  baseFolder: "''",
  unit: '0',
  allNear: 'false',
  from: '0',
  observe: 'null',
  progress: 'null',
  most: '100',
  placement: '{}',
};

const kSources = { muster_scenario_parse: 'scenario', muster_take_parse: 'take', muster_bvh_parse: 'bvh' };

const kResults = new Set(['out', 'new', 'outList', 'outRows', 'outTexts', 'outChars', 'outBytes', 'outFixed', 'outMaybe', 'outCommands']);

export function emitLayouts(model, names) {
  const lines = [kHeading, '/** Of each struct: mode, size, scalar of flat ones, maker | name, offset, type, shape, offset of count or flag. */'];
  lines.push('export const kLayouts: Readonly<Record<string, string>> = {');
  for (const { name, mode, size, flat, rows, maker, fields } of model.structs) {
    const head = [mode, size, flat ?? '-', rows ? 'rows' : '-', maker ?? '-'].join(' ');
    const parts = fields.map(({ name: field, at, type, shape, extra }) => {
      const code = shape === 'body' ? 'body' : names.code(type);
      return [field, at, code, ...(shape === 'one' ? [] : [shape, extra ?? 0])].join(' ');
    });
    lines.push(`  ${name}: '${[head, ...parts].join(' | ')}',`);
  }
  lines.push('};', '', '/** The struct of the body of each kind of command. */', 'export const kBodies: readonly string[] = [');
  for (const { type } of model.bodies()) lines.push(`  '${type}',`);
  return [...lines, '];', ''].join('\n');
}

/** Functions that have verbs. */
function verbsOf(model) {
  const makers = new Set(model.structs.filter(({ given }) => !given).map(({ maker }) => maker).filter(Boolean));
  return model.functions.filter(({ name }) => !(name in kLeftOut) && !kWithin.has(name) && !makers.has(name));
}

function signatureOf({ returns, moves, parts }, model, names) {
  const head = { number: () => names.code(returns.type), struct: () => `struct ${names.code(returns.type)}` };
  const list = () => `${returns.role} ${names.code(returns.type)} ${returns.extra ?? ''}`.trim();
  const first = head[returns.role]?.() ?? (returns.type ? list() : returns.role);
  const rest = parts.map(({ name, role, type, extra }) => {
    if (role === 'number') return `${name} ${names.code(type)}`;
    if (['text', 'chars', 'bytes', 'self', 'outTexts', 'outChars', 'outBytes', 'outCommands', 'count'].includes(role)) return `${name} ${role}`;
    return `${name} ${role} ${names.code(type)}${extra ? ` ${extra}` : ''}`;
  });
  return [moves ? `${first} moves` : first, ...rest].join(' | ');
}

export function emitSignatures(model, names) {
  const lines = [kHeading, '/** Of each function that has a verb: what it returns | its parameters, name, role, type. */'];
  lines.push('export const kSignatures = {');
  for (const one of verbsOf(model)) lines.push(`  ${one.name}: '${signatureOf(one, model, names)}',`);
  lines.push('} as const;', '', 'export type FunctionName = keyof typeof kSignatures;', '');
  lines.push('/** Functions that have no verb, with the reason. */', 'export const kLeftOut: Readonly<Record<string, string>> = {');
  for (const [name, reason] of Object.entries(kLeftOut)) lines.push(`  ${name}: '${reason}',`);
  return [...lines, '};', ''].join('\n');
}

function givenType({ role, type }, names, model) {
  if (role === 'text') return 'string';
  if (role === 'chars' || role === 'bytes') return role === 'bytes' ? 'Uint8Array' : 'string | Uint8Array';
  if (role === 'list') return names.givenList(type);
  if (role === 'handle') return model.nameOf(type);
  if (role === 'callback') return `${model.nameOf(type)} | null`;
  return names.givenOne(type);
}

function resultType({ role, type }, names, model) {
  if (role === 'new') return model.nameOf(type);
  if (role === 'outList') return names.list(type, 'copy');
  if (role === 'outRows') return names.list(type, 'readOut');
  if (role === 'outFixed') return names.list(type, 'copy');
  const fixed = { outTexts: 'readonly string[]', outChars: 'string', outBytes: 'Uint8Array<ArrayBuffer>', outCommands: 'Command[]' };
  return fixed[role] ?? (role === 'outMaybe' ? `${names.one(type)} | null` : names.one(type));
}

function returnType({ name, returns, parts }, names, model) {
  if (returns.role === 'text') return name === 'muster_version' || name === 'muster_status_name' ? 'string' : 'string | null';
  // Defaults belong to nobody: all of them are copies.
  if (returns.role === 'struct' && model.isReadOut(returns.type)) return `Omit<${names.one(returns.type)}, 'copy'>`;
  if (returns.role === 'number' || returns.role === 'struct') return names.one(returns.type);
  if (returns.role === 'list' || returns.role === 'fixed') return names.list(returns.type, 'copy');
  const results = parts.filter(({ role }) => kResults.has(role));
  if (results.length === 0) return 'void';
  if (results.length === 1) return resultType(results[0], names, model);
  return `{ ${results.map((one) => `readonly ${one.name}: ${resultType(one, names, model)}`).join('; ')} }`;
}

/** The parameters of a method, the last ones with what they are by default. */
function parametersOf({ name, parts }, names, model) {
  const shown = parts.filter(({ role }) => role !== 'self' && role !== 'count' && !kResults.has(role));
  const defaults = { ...kDefaults };
  if (kSources[name]) defaults.sourceName = `'${kSources[name]}'`;
  if (['muster_world_create', 'muster_take_writer_create', 'muster_scenario_from_def', 'muster_export_take'].includes(name)) defaults.def = '{}';
  let optional = true;
  return shown
    .reverse()
    .map((part) => {
      optional = optional && part.name in defaults;
      const type = givenType(part, names, model);
      return { name: part.name, text: `${part.name}: ${type}${optional ? ` = ${defaults[part.name]}` : ''}` };
    })
    .reverse();
}

function methodOf(one, names, model, docs) {
  const result = returnType(one, names, model);
  const parameters = parametersOf(one, names, model);
  const call = `this.call_(${[`'${one.name}'`, ...parameters.map(({ name }) => name)].join(', ')})`;
  if (one.name === 'muster_world_step')
    return [
      ...docLines('Advances by that many time steps. The engine reads no clock in any decision: the same commands give the same bits, whatever the time of day and the speed of the machine.', '  '),
      '  step(count = 1): void {',
      `    for (let k = 0; k < count; k += 1) ${call};`,
      '  }',
      '',
    ];
  return [
    ...docLines(docs.of(one.doc), '  '),
    `  ${one.verb}(${parameters.map(({ text }) => text).join(', ')}): ${result} {`,
    result === 'void' ? `    ${call};` : `    return ${call} as ${result};`,
    '  }',
    '',
  ];
}

function classLines(name, base, doc, methods, names, model, docs) {
  const body = methods.flatMap((one) => methodOf(one, names, model, docs));
  return [...docLines(doc), `export class ${name} extends ${base} {`, ...body.slice(0, -1), '}', ''];
}

export function emitVerbs(model, names) {
  const docs = new Docs(model);
  const verbs = verbsOf(model);
  const handles = model.api.structs.filter(({ handle, name }) => handle && name !== 'MusterCommandListId');
  const lines = [];
  const makers = [];
  for (const { name: type, doc } of handles) {
    const name = model.nameOf(type);
    const own = verbs.filter((one) => one.owner === name && one.own);
    lines.push(...classLines(name, 'Handle', docs.of(doc), own, names, model, docs));
    const made = verbs.filter((one) => one.owner === name && !one.own);
    if (made.length === 0) continue;
    makers.push(name);
    lines.push(...classLines(`${name}Maker`, 'Caller', `Makes ${name} objects.`, made, names, model, docs));
  }
  const free = verbs.filter(({ owner }) => owner === 'Muster');
  lines.push(...classLines('MusterFunctions', 'Caller', 'What belongs to no object.', free, names, model, docs));
  const all = handles.map(({ name }) => model.nameOf(name));
  lines.splice(-2, 0, '', ...makers.map((name) => `  /** Makes ${name} objects. */\n  readonly ${name} = new ${name}Maker(this.invoke_);`));
  lines.push('/** The classes of handles by their names. */', `export const kHandleClasses = { ${all.join(', ')} };`, '');
  const text = lines.join('\n');
  const imports = (list) => list.filter((name) => new RegExp(`(?<![.\\w'])${name}\\b(?!')`).test(text.replace(/\/\*[^]*?\*\//g, '')));
  const structs = model.structs.flatMap(({ name }) => [name, `${name}Init`]);
  const enums = model.api.integers.map(({ name }) => model.nameOf(name));
  return [
    kHeading,
    "import { Caller, Handle } from '../binding/handle.js';",
    "import type { ProgressFunction, ReplayFunction } from '../binding/callbacks.js';",
    "import type { Rows } from '../binding/rows.js';",
    `import type { ${imports(enums).join(', ')} } from './enums.js';`,
    `import type { ${imports(structs).join(', ')} } from './structs.js';`,
    '',
    text,
  ].join('\n');
}
