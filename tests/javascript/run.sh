#!/usr/bin/env bash
# Builds the npm package, installs its tarball into an empty folder without a network, and tries it: the binding against the
# description and the compiler, under Node, by TypeScript, in Chromium. Usage: run.sh PROGRAM
set -u
program=$(realpath "$1")
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
. scripts/checks.sh
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# The compiler places the fields of all structs as the binding does; faults of the description are found.
layouts() {
    local fault
    compiles() {
        node tests/javascript/layout_program.mjs "$1" >"$place/layout.c" &&
            NODE_PATH=/usr/share/nodejs emcc -std=c11 -I include -c "$place/layout.c" -o "$place/layout.o" 2>"$place/errors"
    }
    compiles docs/api/muster_api.json || { cat "$place/errors"; return 1; }
    for fault in '/"name": "wantedVelocity"/s/wanted/found/' '/"name": "jitter"/{n;s/double/float/}' \
        '/"name": "MusterItemDef"/,/"name": "radius"/s/MusterVec2/double/'; do
        sed "$fault" docs/api/muster_api.json >"$place/wrong.json"
        compiles "$place/wrong.json" && ! cmp -s docs/api/muster_api.json "$place/wrong.json" && { echo "$fault was not found"; return 1; }
    done
    return 0
}

# A program of a user with the strictest settings, in both ways in which imports are resolved, and the sample with Vite.
types() {
    local resolution strict=(--noEmit --strict --exactOptionalPropertyTypes --noUncheckedIndexedAccess --target ES2022)
    local tsc=$root/web/node_modules/typescript/bin/tsc
    cp tests/javascript/types/program.ts "$place/"
    cp -r samples/js_vite/src "$place/sample"
    for resolution in "NodeNext --module NodeNext" "Bundler --module ESNext"; do
        # shellcheck disable=SC2086
        (cd "$place" && node "$tsc" "${strict[@]}" --moduleResolution $resolution program.ts) || return 1
    done
    (cd "$place" && node "$tsc" "${strict[@]}" --moduleResolution Bundler --module ESNext sample/main.ts)
}

# The layout of the sources is that of the page's, but for what is generated.
formatted() {
    (cd web && npx prettier --config .prettierrc.json --log-level warn --check ../bindings/javascript/{src,*.mjs,*.json} ../samples/js_* ../tests/javascript \
        --ignore-path ../tests/javascript/.prettierignore >&2)
}

install_package() {
    bash scripts/wasm.sh muster_javascript && node bindings/javascript/build.mjs &&
        (cd bindings/javascript && npm pack --silent --pack-destination "$place" >&2) || return 1
    cd "$place" || return 1
    echo '{ "private": true, "type": "module" }' >package.json
    npm install --offline --no-audit --no-fund --silent ./muster-engine-*.tgz || return 1
    echo "export * from 'muster-engine';" >entry.mjs
    cd "$root" || return 1
}

# counting COMMAND...: adds the counts of its last line, and shows the others.
counting() {
    local ok bad
    PLACE=$place PROGRAM=$program "$@" >"$place/log" 2>&1
    grep -vE '^[0-9]+ passed' "$place/log"
    read -r ok _ bad _ < <(grep -E '^[0-9]+ passed, [0-9]+ failed' "$place/log" || echo "0 passed, 1 failed")
    passed=$((passed + ok))
    failed=$((failed + bad))
}

install_package || { echo "0 passed, 1 failed"; exit 1; }
check "structs lie as the compiler places them" layouts
check "types of the package" types
check "the sources' layout" formatted
counting node tests/javascript/run.mjs
counting node tests/javascript/browser.mjs
node tests/javascript/measure.mjs "$place" "$program"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
