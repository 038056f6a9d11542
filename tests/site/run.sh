#!/usr/bin/env bash
# Builds the engine for browsers, writes a site with the program, and tries it in Chromium; with --all the engine with threads,
# too. Usage: run.sh PROGRAM [--all]
set -u
program=$(realpath "$1")
cd "$(dirname "$0")/../.." || exit 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# Without --all a site has no threads, whatever was built before.
threads() {
    rm -f build/wasm/apps/engine/muster-engine-threads.*
    [ "$1" != --all ] || bash scripts/wasm.sh --threads muster_engine
}
bash scripts/wasm.sh muster_engine && threads "${2:-}" && "$program" site -o "$folder/site" >&2 ||
    { echo "0 passed, 1 failed"; exit 1; }
MUSTER=$program node web/tests/site.mjs "$folder/site"
