#!/usr/bin/env bash
# Every experiment of the paper once, each with one seed: each criterion counts as a test. Usage: run.sh PROGRAM [SEEDS]
set -u
program=$1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$program" reproduce --seeds "${2:-1}" --out "$out/report" >"$out/log" 2>"$out/errors"
code=$?
line=$(grep -E '^[0-9]+ of [0-9]+ criteria hold' "$out/log" | tail -n 1)
read -r held _ judged _ <<<"${line:-0 of 1}"
failed=$((judged - held))
# Held criteria with an exit code that says otherwise, or files that are missing, are failures as well.
[ "$code" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1
for file in index.html results.json summary.md; do
    [ -s "$out/report/$file" ] || { echo "the report lacks $file"; failed=$((failed + 1)); }
done
[ "$failed" -eq 0 ] || cat "$out/log" "$out/errors"
echo "$held passed, $failed failed"
[ "$failed" -eq 0 ]
