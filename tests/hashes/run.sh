#!/usr/bin/env bash
# Compares the hashes of every scenario, by the exact and by the fast plan, between builds. Usage: run.sh [--all] [SECONDS]
#
#     always      release with 1 and 3 threads, and WebAssembly under Node: what a push may break
#     --all       2 and 8 threads; -O3 -march=native; debug (the first quarter); clang with -O2 where it is installed: a release
#
# The builds other than release compile each module as one file (CMAKE_UNITY_BUILD): they are made from nothing once and
# hardly ever again.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root" || exit 1
all=no
[ "${1:-}" != --all ] || { all=yes; shift; }
seconds=${1:-8}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# compare NAME FILE [STEPS]: each scenario is one comparison with the release build on one thread, up to that step.
compare() {
    local scenario
    awk -v most="${3:-1000000000}" '$2 <= most' "$work/all" >"$work/reference"
    for scenario in $(cut -d' ' -f1 "$work/reference" | sort -u); do
        if diff -q <(grep "^$scenario " "$work/reference") <(grep "^$scenario " "$2") >/dev/null; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "$1: $scenario differs, first at step $(diff <(grep "^$scenario " "$work/reference") <(grep "^$scenario " "$2") | grep -m1 '^<' | cut -d' ' -f3)"
        fi
    done
}

# build PRESET: a build of the hash program; its path is build/PRESET/tests/hashes/scenario_hashes.
build() {
    [ -f "build/$1/build.ninja" ] || cmake --preset "$1" >/dev/null || return 1
    cmake --build "build/$1" --target scenario_hashes >"build/$1/hashes.log" 2>&1 || { tail -n 20 "build/$1/hashes.log"; return 1; }
}

build release || { echo "0 passed, 1 failed"; exit 1; }
build/release/tests/hashes/scenario_hashes scenarios "$seconds" 1 >"$work/all" || { echo "0 passed, 1 failed"; exit 1; }
cat "$work/all"
counts=(3)
[ "$all" = no ] || counts=(2 3 8)
for threads in "${counts[@]}"; do
    build/release/tests/hashes/scenario_hashes scenarios "$seconds" "$threads" >"$work/threads" || failed=$((failed + 1))
    compare "$threads threads" "$work/threads"
done
others=()
[ "$all" = no ] || others=(native debug)
if [ "$all" = no ]; then
    :
elif command -v clang++ >/dev/null; then others+=(clang); else echo "skipped: clang, which is not installed"; fi
for name in "${others[@]}"; do
    if build "hashes-$name"; then
        # Without optimisation a quarter of the time has to do; hashes come every 120 steps.
        played=$seconds
        [ "$name" = debug ] && played=$((seconds >= 8 ? seconds / 8 * 2 : seconds))
        "build/hashes-$name/tests/hashes/scenario_hashes" scenarios "$played" 2 >"$work/$name" || failed=$((failed + 1))
        compare "$name" "$work/$name" $((played * 60))
    else
        failed=$((failed + 1))
    fi
done

if bash scripts/wasm.sh scenario_hashes; then
    node build/wasm/tests/hashes/scenario_hashes.js scenarios "$seconds" 1 >"$work/wasm" 2>"$work/errors" ||
        { failed=$((failed + 1)); tail -c 1000 "$work/errors"; }
    compare WebAssembly "$work/wasm"
else
    failed=$((failed + 1))
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
