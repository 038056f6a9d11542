// Writes the C++ and TypeScript sides of the protocol from messages.json.
//
//     node protocol/generate.mjs           writes the files
//     node protocol/generate.mjs --check   writes nothing; exit code 1 where a committed file differs
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { cppFiles } from './cpp.mjs';
import { root } from './schema.mjs';
import { typescriptFiles } from './typescript.mjs';

let stale = 0;
for (const [path, text] of Object.entries({ ...cppFiles(), ...typescriptFiles() })) {
  const file = join(root, path);
  let old = null;
  try {
    old = readFileSync(file, 'utf8');
  } catch {}
  if (old === text) continue;
  if (process.argv.includes('--check')) {
    console.error(`${path} is not what protocol/messages.json says: run node protocol/generate.mjs`);
    stale = 1;
  } else {
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
    console.log(`wrote ${path}`);
  }
}
process.exit(stale);
