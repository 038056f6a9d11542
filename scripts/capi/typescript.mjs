// Writes the generated part of the TypeScript binding, bindings/javascript/src/generated, from docs/api/muster_api.json: `--write`.
// `--check` fails where these files are not what the description says; `--layout` prints a C program that compiles for
// WebAssembly only where its compiler places the fields of all structs as the binding does.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { emitEnums, emitStructs } from './typescript/emit_types.mjs';
import { emitLayouts, emitSignatures, emitVerbs } from './typescript/emit_verbs.mjs';
import { Model } from './typescript/model.mjs';
import { TypeNames } from './typescript/types.mjs';
import { layoutProgram } from './typescript/wasm_layout.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const folder = join(root, 'bindings/javascript/src/generated');

function files(api) {
  const model = new Model(api);
  const names = new TypeNames(model);
  return {
    'enums.ts': emitEnums(model),
    'structs.ts': emitStructs(model, names),
    'layouts.ts': emitLayouts(model, names),
    'signatures.ts': emitSignatures(model, names),
    'verbs.ts': emitVerbs(model, names),
  };
}

function check(made) {
  const differ = Object.entries(made).filter(([name, text]) => {
    try {
      return readFileSync(join(folder, name), 'utf8') !== text;
    } catch {
      return true;
    }
  });
  for (const [name] of differ)
    console.error(`${name} is not what docs/api/muster_api.json says: run node scripts/capi/typescript.mjs --write`);
  return differ.length === 0 ? 0 : 1;
}

function main(option, file = join(root, 'docs/api/muster_api.json')) {
  const api = JSON.parse(readFileSync(file, 'utf8'));
  if (option === '--layout') {
    process.stdout.write(layoutProgram(api));
    return 0;
  }
  if (option === '--check') return check(files(api));
  if (option !== '--write') {
    console.error(`found ${option ?? 'no option'}, expected --write, --check or --layout`);
    return 2;
  }
  mkdirSync(folder, { recursive: true });
  for (const [name, text] of Object.entries(files(api))) writeFileSync(join(folder, name), text);
  return 0;
}

process.exitCode = main(...process.argv.slice(2));
