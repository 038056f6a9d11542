#!/usr/bin/env bash
# Installs the library into a folder of its own and builds a small consumer outside the tree with find_package(muster).
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$root/build/release" --prefix "$work/prefix" >/dev/null
cp -r "$root/tests/consumer/program" "$work/program"
cmake -S "$work/program" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
cmake --build "$work/build"
"$work/build/consumer"
test -x "$work/prefix/bin/muster"
"$work/prefix/bin/muster" --version
# What is installed finds its scenarios and, where it was built, its page.
cd "$work"
if [ -f "$root/web/dist/index.html" ]; then
    "$work/prefix/bin/muster" studio --port 18980 --json >"$work/address" &
    studio=$!
    for _ in $(seq 50); do [ -s "$work/address" ] && break; sleep 0.1; done
    kill -TERM "$studio"
    wait "$studio"
    grep -q '"address": "http://127.0.0.1:' "$work/address"
else
    echo "skipped: the installed studio, as the page is not built"
fi
"$work/prefix/bin/muster" check "$work/prefix/share/muster/scenarios/open.json"
echo "1 passed, 0 failed"
