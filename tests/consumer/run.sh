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
echo "1 passed, 0 failed"
