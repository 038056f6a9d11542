// Types and unit tests of the page; ends with "N passed, N failed".
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folder = mkdtempSync(join(tmpdir(), 'muster-check-'));
const report = join(folder, 'vitest.json');
const run = (program, ...options) =>
  spawnSync('npx', ['--no-install', program, ...options], { stdio: ['ignore', 'inherit', 'inherit'] }).status;

const types = run('tsc', '--noEmit');
const tests = run('vitest', 'run', '--reporter=default', '--reporter=json', `--outputFile.json=${report}`);
let passed = types === 0 ? 1 : 0;
let failed = types === 0 ? 0 : 1;
try {
  const result = JSON.parse(readFileSync(report, 'utf8'));
  passed += result.numPassedTests;
  failed += result.numFailedTests + (result.numFailedTests === 0 && !result.success ? 1 : 0);
} catch {
  failed += 1;
}
if (tests !== 0 && failed === 0) failed = 1;
rmSync(folder, { recursive: true, force: true });
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
