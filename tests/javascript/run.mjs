// Tests of the npm package under Node. PLACE is the folder into which it is installed, PROGRAM the native program.
import { runAll } from './checks.mjs';

for (const name of [
  'surface',
  'hashes',
  'takes',
  'commands',
  'values',
  'views',
  'refusals',
  'motion',
  'ground',
  'files',
])
  await import(`./cases/${name}.mjs`);
await runAll();
