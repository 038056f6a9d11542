#!/usr/bin/env bash
# The standard tests of pedestrian dynamics: every test that is run counts. Usage: run.sh PROGRAM [--all]
#
#     always      the short set, one seed each
#     --all       all tests with all their seeds
#
# Known misses are printed and do not count, as long as they are missed; docs/people.md says why.
set -u
program=$1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
set_of=(--brief)
[ "${2:-}" != --all ] || set_of=()
"$program" verify "${set_of[@]}" --json --page "$out/page.html" >"$out/results.json" 2>"$out/errors"
code=$?
[ "$code" -le 1 ] && [ -s "$out/results.json" ] || { cat "$out/errors"; echo "0 passed, 1 failed"; exit 1; }
node - "$out/results.json" "$out/page.html" "$code" <<'JS'
const { readFileSync } = require('node:fs');
const [file, pageFile, code] = process.argv.slice(2);
const { rows, fail } = JSON.parse(readFileSync(file, 'utf8'));
const page = readFileSync(pageFile, 'utf8');
let passed = 0;
let failed = 0;
const fails = (what) => { failed += 1; console.log(what); };
const known = new Set(['RiMEA 4', 'Data 4', 'Data 5']);
for (const { id, outcome, checks } of rows) {
  if (!page.includes(`<span class="id">${id}</span>`)) fails(`the page lacks ${id}`);
  const missed = checks.filter((check) => check.binding && !check.pass);
  const words = missed.map(({ what, value, low, high }) => `${what}: ${value}, required ${low ?? ''} to ${high ?? ''}`).join('; ');
  if (outcome === 'pass') passed += 1;
  else if (outcome === 'fail' && known.has(id)) console.log(`measured: a known miss: ${id}: ${words}`);
  else if (outcome === 'fail') fails(`${id}: ${words}`);
}
if (passed === 0) fails('no test passed');
if ((Number(code) === 1) !== (fail > 0)) fails(`the exit code is ${code} with ${fail} failures`);
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
JS
