#!/usr/bin/env bash
# Experiments of the paper, with one seed each: every criterion counts as a test. Usage: run.sh PROGRAM [--all]
#
#     always      those that hold with one seed
#     --all       X8, too, which compares medians over five seeds, and X13: steps per second, which are printed only, as they
#                 depend on the machine and on what else it does
set -u
program=$1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
# run FOLDER SEEDS EXPERIMENTS...: 3 says that a criterion does not hold; which, the results tell.
run() {
    "$program" reproduce --seeds "$2" --out "$out/$1" "${@:3}" >"$out/log" 2>"$out/errors"
    code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || { cat "$out/log" "$out/errors"; echo "0 passed, 1 failed"; exit 1; }
}
run report 1 X1 X2 X3 X4 X5 X6 X7 X9 X10 X11
if [ "${2:-}" = --all ]; then
    run queue 5 X8
    run speed 1 X13
fi
node - "$out"/report "$out"/*/results.json <<'JS'
const { existsSync, readFileSync, statSync } = require('node:fs');
const [report, ...found] = process.argv.slice(2);
let passed = 0;
let failed = 0;
const fails = (what) => { failed += 1; console.log(what); };
for (const file of ['index.html', 'results.json', 'summary.md'])
  if (!existsSync(`${report}/${file}`) || statSync(`${report}/${file}`).size === 0) fails(`the report lacks ${file}`);
const results = found.flatMap((file) => JSON.parse(readFileSync(file, 'utf8')));
if (results.length === 0) fails('no criterion was judged');
// Known misses, and how far they may go: of a thousand who cross the wall one is pushed over its edge by a millimetre, out and in
// again (docs/method/steering.md).
const known = new Map([
  ['X6: 100 of 100 climb the wall once and jump the hedge once in every seed', 99],
  ['X6: each encounter by positions has exactly one climb or jump in the same step, in every seed', 1],
]);
for (const { experiment, criterion, preset, value, threshold, pass, binding } of results) {
  if (experiment === 'X13') console.log(`measured: X13, ${preset}: ${criterion}: ${Math.round(value)}`);
  else if (preset !== 'muster' || binding === false) continue; // Shown for comparison, or known to be missed.
  else if (pass) passed += 1;
  else if (known.has(`${experiment}: ${criterion}`) && Math.abs(value - threshold) <= Math.abs(known.get(`${experiment}: ${criterion}`) - threshold))
    console.log(`measured: a known miss: ${experiment}: ${criterion}: ${value}, the threshold is ${threshold}`);
  else fails(`${experiment}: ${criterion}: ${value}, the threshold is ${threshold}`);
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
JS
