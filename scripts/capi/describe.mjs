// Describes the C API as JSON, for generators of bindings: docs/api/muster_api.json. `--check` fails where that file is not what
// the headers say; `--print` writes the description to the output instead.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseHeader } from './parse.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const file = join(root, 'docs/api/muster_api.json');

/** The headers, each after those that it includes, and the component of the library that each belongs to. */
const kHeaders = {
  core: ['base', 'generated/enumerations', 'values', 'generated/definition_structs', 'definitions', 'generated/command_bodies', 'command', 'views', 'world'],
  motion: ['clips', 'bvh', 'motion'],
  io: ['scenario', 'take'],
};

function read(component, header) {
  const path = `muster/c/${header}.h`;
  try {
    const text = readFileSync(join(root, 'include', path), 'utf8');
    return parseHeader(text).map(({ list, entry }) => ({ list, entry: { ...entry, header: path, component } }));
  } catch (error) {
    throw new Error(`include/${path}: ${error.message}`);
  }
}

/** Values of an integer type stand with it: those of MusterStatus are the enum MusterStatusValue. */
function joinValues(api, values) {
  for (const { name, values: list } of values) {
    const integer = api.integers.find((one) => `${one.name}Value` === name);
    if (!integer) throw new Error(`enum ${name}: found no integer type of its name, expected one`);
    integer.values = list;
  }
}

/** Handles, and who makes structs that have a version. */
function addRoles(api) {
  for (const struct of api.structs) {
    const names = struct.fields.map((field) => field.name).join();
    if (names === 'index1,generation') struct.handle = true;
    if (struct.fields[0]?.name !== 'structVersion') continue;
    const maker = api.functions.find((one) => one.returns === struct.name && one.name.startsWith('muster_default_'));
    if (!maker) throw new Error(`struct ${struct.name}: found no muster_default_ function, expected one`);
    struct.madeBy = maker.name;
  }
}

/** Names every declaration that has no doc comment. */
function undocumented(api) {
  const missing = [];
  const look = (entry, path) => entry.doc || missing.push(path);
  for (const list of ['integers', 'structs', 'callbacks', 'functions'])
    for (const entry of api[list]) {
      look(entry, entry.name);
      for (const part of entry.fields ?? entry.values ?? []) look(part, `${entry.name}.${part.name}`);
    }
  return missing;
}

export function describe() {
  const api = { header: 'muster/muster.h', integers: [], structs: [], callbacks: [], functions: [] };
  const values = [];
  for (const [component, headers] of Object.entries(kHeaders))
    for (const header of headers)
      for (const { list, entry } of read(component, header)) (list === 'values' ? values : api[list]).push(entry);
  joinValues(api, values);
  addRoles(api);
  const missing = undocumented(api);
  if (missing.length > 0) throw new Error(`found no comment for ${missing.join(', ')}, expected one`);
  return api;
}

function main(option) {
  const text = `${JSON.stringify(describe(), null, 1)}\n`;
  if (option === '--print') {
    process.stdout.write(text);
  } else if (option === '--check') {
    if (readFileSync(file, 'utf8') === text) return 0;
    console.error('docs/api/muster_api.json is not what the headers say: run node scripts/capi/describe.mjs');
    return 1;
  } else {
    writeFileSync(file, text);
  }
  return 0;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) process.exitCode = main(process.argv[2]);
