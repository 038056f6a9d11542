// Writes all that follows from the declarations in this folder.
//
//     node schema/generate.mjs           writes the files
//     node schema/generate.mjs --check   writes nothing; exit code 1 where a committed file differs
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { cFiles } from './c.mjs';
import { cHeaderFiles } from './c_header.mjs';
import { cppFiles } from './cpp.mjs';
import { definitionCFiles } from './definitions_c.mjs';
import { definitionCheckFiles } from './definitions_checks.mjs';
import { definitionFiles } from './definitions_cpp.mjs';
import { definitionFileFiles } from './definitions_files.mjs';
import { definitionSampleFiles } from './definitions_samples.mjs';
import { definitionTypescriptFiles } from './definitions_typescript.mjs';
import { descriptionFiles } from './description.mjs';
import { documentationFiles } from './documentation.mjs';
import { enumerationFiles } from './enumerations.mjs';
import { idFiles } from './ids.mjs';
import { javascriptFiles } from './javascript.mjs';
import { messageCppFiles } from './messages_cpp.mjs';
import { messageTypescriptFiles } from './messages_typescript.mjs';
import { parameterFiles } from './parameters.mjs';
import { pythonFiles } from './python.mjs';
import { pythonViewFiles } from './python_views.mjs';
import { root } from './read.mjs';
import { sampleFiles } from './samples.mjs';
import { scenarioFiles } from './scenario.mjs';
import { isUsed, typescriptFiles } from './typescript.mjs';
import { viewFiles } from './views.mjs';

const checks = process.argv.includes('--check');
const makers = [
  enumerationFiles, definitionFiles, definitionCheckFiles, definitionCFiles, definitionFileFiles, definitionSampleFiles, cppFiles, cFiles,
  scenarioFiles, sampleFiles, idFiles, typescriptFiles, () => definitionTypescriptFiles(isUsed), messageCppFiles, messageTypescriptFiles,
  documentationFiles, parameterFiles, cHeaderFiles, viewFiles, descriptionFiles, javascriptFiles, pythonFiles, pythonViewFiles,
];
let stale = 0;
for (const [path, text] of makers.flatMap((make) => Object.entries(make()))) {
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
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
    console.log(`wrote ${path}`);
  }
}
process.exit(stale);
