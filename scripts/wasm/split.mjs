// Splits the engine for browsers in two files: the functions that a first visit calls, and the rest, which is loaded while
// people walk (bindings/javascript/src/studio/split_module.ts). Which they are is found by playing. Usage: node split.mjs FOLDER
//
// FOLDER holds muster-engine.js and muster-engine.wasm as they were linked. Beside them come muster-engine.wasm.xz, the first
// part, in the format of xz as it takes a quarter less than with gzip, and muster-engine-rest.wasm.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { playFirstVisit } from './first_visit.mjs';

const kFeatures = [
  '--enable-bulk-memory',
  '--enable-nontrapping-float-to-int',
  '--enable-sign-ext',
  '--enable-mutable-globals',
];
const kMostProfile = 1 << 20;

const folder = resolve(process.argv[2] ?? '.');
const linked = join(folder, 'muster-engine.wasm');
const work = mkdtempSync(join(tmpdir(), 'muster-split-'));
const instrumented = join(work, 'instrumented.wasm');
const profile = join(work, 'profile');

const split = (...options) => execFileSync('wasm-split', [...kFeatures, ...options], { stdio: 'inherit' });

/** The linked module in this process, and what it exports. */
async function load(file) {
  let raw = null;
  // The loader was made for workers and takes Node for one of CommonJS.
  Object.assign(globalThis, { require: createRequire(import.meta.url), __dirname: folder });
  const { default: make } = await import(pathToFileURL(join(folder, 'muster-engine.js')).href);
  const module = await make({
    instantiateWasm(imports, use) {
      const instance = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)), imports);
      raw = instance.exports;
      use(instance);
      return raw;
    },
  });
  return { module, raw };
}

try {
  split('--instrument', linked, '-o', instrumented);
  const { module, raw } = await load(instrumented);
  playFirstVisit(module);
  const at = module._malloc(kMostProfile);
  const size = raw.__write_profile(at, kMostProfile);
  if (size > kMostProfile) throw new Error(`the profile has ${size} bytes, more than ${kMostProfile}`);
  writeFileSync(profile, module.HEAPU8.slice(at, at + size));
  const first = join(work, 'first.wasm');
  split(
    '--export-prefix=%',
    linked,
    '--profile',
    profile,
    '-o1',
    first,
    '-o2',
    join(folder, 'muster-engine-rest.wasm'),
  );
  writeFileSync(
    `${linked}.xz`,
    execFileSync('xz', ['--check=crc32', '--lzma2=preset=9e,lc=4,pb=1', '--stdout', first], { maxBuffer: 1 << 28 }),
  );
} finally {
  rmSync(work, { recursive: true, force: true });
}
