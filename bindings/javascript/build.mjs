// Builds dist/ from src/ and the WebAssembly module that scripts/wasm.sh makes. The tools are those of the page (web/node_modules):
// TypeScript writes the types, esbuild one file for each entry.
//
//     bash scripts/wasm.sh muster_javascript && node bindings/javascript/build.mjs
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
const made = join(root, 'build/wasm/bindings/javascript');
const dist = join(here, 'dist');
const tools = createRequire(join(root, 'web/package.json'));

function stop(sentence) {
  console.error(`muster-engine: ${sentence}`);
  process.exit(1);
}

/** The version stands in CMakeLists.txt; the package has the same. */
function checkVersion() {
  const [, version] = /project\(muster VERSION ([\d.]+)/.exec(readFileSync(join(root, 'CMakeLists.txt'), 'utf8'));
  const found = JSON.parse(readFileSync(join(here, 'package.json'), 'utf8')).version;
  if (found !== version) stop(`package.json: version: found ${found}, expected ${version} as in CMakeLists.txt`);
}

function notices() {
  const licence = readFileSync(join(root, 'web/public/site/engine-licences.txt'), 'utf8');
  const heading = `What is in dist/ contains the work of others, under these licences. Muster itself is under the MIT licence
(LICENSE).\n`;
  return licence.replace(/^[^]*?\n(?=\n=====)/, heading);
}

/** esbuild comes with Vite. */
async function bundle(entry, file) {
  const vite = createRequire(tools.resolve('vite'));
  const { build } = await import(pathToFileURL(vite.resolve('esbuild')).href);
  await build({
    entryPoints: [join(here, 'src', entry)],
    outfile: join(dist, file),
    bundle: true,
    format: 'esm',
    platform: 'neutral',
    target: 'es2022',
    minify: true,
    // Messages name classes.
    keepNames: true,
    legalComments: 'none',
    alias: { 'muster-module': join(made, 'muster.js') },
    banner: {
      js: '// Muster, MIT licence. The work of others in it: THIRD-PARTY-NOTICES.txt',
    },
    logLevel: 'warning',
  });
}

if (!existsSync(join(made, 'muster.wasm'))) stop('the module is not built: run scripts/wasm.sh muster_javascript');
if (!existsSync(join(root, 'web/node_modules'))) stop('the tools are missing: run npm ci in web/');
checkVersion();
rmSync(dist, { recursive: true, force: true });
mkdirSync(dist, { recursive: true });
copyFileSync(join(made, 'muster.wasm'), join(dist, 'muster.wasm'));
execFileSync(process.execPath, [tools.resolve('typescript/bin/tsc'), '-p', here], { stdio: 'inherit' });
await bundle('index.ts', 'index.js');
await bundle('studio/index.ts', 'studio.js');
copyFileSync(join(root, 'LICENSE'), join(here, 'LICENSE'));
writeFileSync(join(here, 'THIRD-PARTY-NOTICES.txt'), notices());
