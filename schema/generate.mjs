// Writes all that follows from the declarations in this folder.
//
//     node schema/generate.mjs           writes the files
//     node schema/generate.mjs --check   writes nothing; exit code 1 where a committed file differs
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { cFiles } from './c.mjs';
import { cppFiles } from './cpp.mjs';
import { documentationFiles } from './documentation.mjs';
import { enumerationFiles } from './enumerations.mjs';
import { messageCppFiles } from './messages_cpp.mjs';
import { messageTypescriptFiles } from './messages_typescript.mjs';
import { root } from './read.mjs';
import { sampleFiles } from './samples.mjs';
import { scenarioFiles } from './scenario.mjs';
import { typescriptFiles } from './typescript.mjs';

const checks = process.argv.includes('--check');
let stale = 0;
for (const [path, text] of Object.entries({ ...enumerationFiles(), ...cppFiles(), ...cFiles(), ...scenarioFiles(), ...sampleFiles(), ...typescriptFiles(), ...messageCppFiles(), ...messageTypescriptFiles(), ...documentationFiles() })) {
  const file = join(root, path);
  let old = null;
  try {
    old = readFileSync(file, 'utf8');
  } catch {}
  if (old === text) continue;
  if (checks) {
    console.error(`${path} is not what the declarations in schema/ say: run node schema/generate.mjs`);
    stale = 1;
  } else {
    writeFileSync(file, text);
    console.log(`wrote ${path}`);
  }
}
process.exit(stale);
