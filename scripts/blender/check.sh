#!/usr/bin/env bash
# Imports the GLB and the BVH files of a take of 36 characters into Blender and compares all joints at ten times with
# Muster's own: they must agree within a millimetre. With PICTURE it also renders a still from the GLB.
# Usage: check.sh PROGRAM [SCENARIO] [PICTURE.png [TIME [MORE OPTIONS OF check_export.py]]]
set -u
program=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenario=${2:-$here/../../scenarios/paper/x04-woodland.json}
picture=${3:-}
time=${4:-4}
shift $(($# < 4 ? $# : 4))
command -v blender >/dev/null || { echo "skipped: Blender is not installed"; echo "0 passed, 0 failed"; exit 0; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

part=(--from 1 --to 10)
if ! { "$program" play "$scenario" --demo --seconds 10 --take "$out/take" &&
    "$program" export "$out/take" --format glb --out "$out/take.glb" "${part[@]}" &&
    "$program" export "$out/take" --format bvh --out "$out/bvh" "${part[@]}" &&
    "$program" export "$out/take" --format joints --out "$out/joints.json" "${part[@]}" --fps 1; } >"$out/log" 2>&1; then
    tail -n 3 "$out/log"
    echo "0 passed, 1 failed"
    exit 1
fi

still=()
[ -z "$picture" ] || still=(--still "$picture" --time "$time" "$@")
blender -b --factory-startup -P "$here/check_export.py" -- --joints "$out/joints.json" --glb "$out/take.glb" \
    --bvh "$out/bvh" "${still[@]}" >"$out/log" 2>&1

# Blender exits 0 whatever happens: only what it says counts.
passed=$(grep -c '^OK ' "$out/log")
failed=$(grep -c '^FAILED ' "$out/log")
if grep -qE 'Traceback|^Error' "$out/log" || ! grep -q '^DONE' "$out/log"; then
    grep -E -A 6 'Traceback|Error' "$out/log" | head -n 20
    failed=$((failed + 1))
fi
grep -E '^(OK|FAILED) ' "$out/log" | sed 's/^OK /measured: /'
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
