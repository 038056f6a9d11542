#!/usr/bin/env bash
# Records a short take of several scenarios, exports each as GLB, asks the Khronos validator, and compares all joints
# at many times with Muster's own; then compares binary USD with USD text, as another reader reads them. Usage: run.sh PROGRAM [SECONDS]
set -u
program=$(realpath "$1")
seconds=${2:-6}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
passed=0
failed=0

fail() { printf 'FAILED %s\n' "$*"; failed=$((failed + 1)); }

# The scenarios with every kind of ground: trees and branches, cars that move, the obstacle course, plain ground.
for scenario in woodland cars course open; do
    name=$out/$scenario
    if ! "$program" play "$root/scenarios/$scenario.json" --demo --seconds "$seconds" --take "$name.take" >"$out/log" 2>&1 ||
        ! "$program" export "$name.take" --format glb --out "$name.glb" >"$out/log" 2>&1 ||
        ! "$program" export "$name.take" --format joints --fps 3 --out "$name.json" >"$out/log" 2>&1; then
        fail "$scenario: no file: $(tail -n 1 "$out/log")"
        continue
    fi
    if [ ! -d "$root/web/node_modules/gltf-validator" ]; then
        echo "skipped: $scenario: the validator is not there (npm ci in web/)"
        continue
    fi
    if node "$root/tests/files/export/check_glb.mjs" "$root/web/node_modules" "$name.glb" "$name.json" >"$out/log" 2>&1; then
        passed=$((passed + 1))
        echo "measured: $scenario: $(sed -n 's/^ok \(.* joints .*\)$/\1/p' "$out/log")"
    else
        cat "$out/log"
        fail "$scenario: the GLB is not as it should be"
    fi
done

# One of the takes as USD, in both encodings.
if [ ! -d "$root/web/node_modules/tinyusdz" ]; then
    echo "skipped: USD: TinyUSDZ is not there (npm ci in web/)"
else
    for format in usda usdc; do
        "$program" export "$out/cars.take" --format "$format" --to 1 --out "$out/cars.$format" >"$out/log" 2>&1 || cat "$out/log"
    done
    if node "$root/tests/files/export/check_usd.mjs" "$root/web/node_modules" "$out/cars.usda" "$out/cars.usdc" >"$out/log" 2>&1; then
        passed=$((passed + 1))
        echo "measured: USD: $(sed -n 's/^ok //p' "$out/log")"
    else
        cat "$out/log"
        fail "the binary USD is not as the text"
    fi
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
