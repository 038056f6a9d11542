#!/usr/bin/env bash
# Builds the engine for browsers, writes a site with the program, and tries it in Chromium. Usage: run.sh PROGRAM
set -u
program=$(realpath "$1")
cd "$(dirname "$0")/../.." || exit 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bash scripts/wasm.sh muster_engine && bash scripts/wasm.sh --threads muster_engine && "$program" site -o "$folder/site" >&2 ||
    { echo "0 passed, 1 failed"; exit 1; }
MUSTER=$program node web/tests/site.mjs "$folder/site"
