// Compares a binary USD file with the text file of the same export, both as TinyUSDZ reads them.
// Usage: node check_usd.mjs FOLDER_OF_NODE_MODULES FILE.usda FILE.usdc
// Prints "ok ..." or "FAILED ..." lines; exits 1 where anything failed.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

// Largest difference between numbers, as a share of those above 1: the text has five decimals, the reader prints six digits.
const kLimit = 2e-5;
const kNumber = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;

const { process } = globalThis;
const [modules, ...paths] = process.argv.slice(2);
const folder = resolve(modules, 'tinyusdz');
const files = paths.map((path) => readFileSync(path));

/** The reader is built for pages. */
async function loadReader() {
  const wasmBinary = readFileSync(`${folder}/tinyusdz.wasm`);
  const address = pathToFileURL(`${folder}/tinyusdz.js`).href;
  Object.assign(globalThis, { window: globalThis, document: {}, process: undefined });
  const reader = await (await import(address)).default({ wasmBinary });
  globalThis.process = process;
  return reader;
}

function read(reader, bytes, name) {
  const file = new reader.TinyUSDZLoaderNative();
  if (!file.loadAsLayerFromBinary(bytes, name)) throw new Error(`${name}: ${file.error()}`);
  const text = file.layerToString();
  if (!file.composeReferences() || !file.layerToRenderScene()) throw new Error(`${name}: ${file.error()}`);
  return { text, meshes: file.numMeshes() };
}

function compare(a, b) {
  // The reader writes each prim of a binary file as "def", whatever it is.
  const plain = (text) => text.replace(kNumber, '#').replace(/^( *)(?:over|class) /gm, '$1def ');
  if (plain(a.text) !== plain(b.text)) throw new Error('the files hold different things');
  const [one, other] = [a, b].map(({ text }) => text.match(kNumber).map(Number));
  const worst = one.reduce((most, value, i) => Math.max(most, Math.abs(value - other[i]) / Math.max(1, Math.abs(value))), 0);
  if (!(worst <= kLimit)) throw new Error(`numbers differ by up to ${worst}`);
  if (a.meshes !== b.meshes || a.meshes === 0) throw new Error(`${a.meshes} and ${b.meshes} meshes are shown`);
  console.log(`ok ${one.length} numbers in ${a.meshes} meshes and their animation, at most ${worst} apart`);
}

try {
  const reader = await loadReader();
  compare(read(reader, files[0], 'text.usda'), read(reader, files[1], 'binary.usdc'));
} catch (error) {
  console.log(`FAILED ${error.message}`);
  process.exitCode = 1;
}
