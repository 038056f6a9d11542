#!/usr/bin/env bash
# Builds targets for WebAssembly in build/wasm, with Debian's emscripten. Usage: scripts/wasm.sh [--threads] TARGET...
#
#     muster_engine                   the engine for pages without a server (muster site)
#     muster_javascript               the C API, for the npm package
#     scenario_hashes                 the program that prints the hash of every scenario
#
# With --threads it builds them in build/wasm-threads, and puts the engine for isolated pages beside the other.
set -u
cd "$(dirname "$0")/.." || exit 1
build=$PWD/build/wasm
threads=OFF
if [ "${1:-}" = --threads ]; then
    shift
    build=$PWD/build/wasm-threads
    threads=ON
fi
# Debian's emscripten finds its JavaScript packages here.
export NODE_PATH=/usr/share/nodejs
mkdir -p "$build/deps"
ln -sfn /usr/include/eigen3 "$build/deps/eigen3"
ln -sfn /usr/include/nlohmann "$build/deps/nlohmann"
if [ ! -f "$build/build.ninja" ]; then
    emcmake cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=50 \
        -DMUSTER_BUILD_APPS=OFF -DMUSTER_BUILD_TESTS=OFF -DMUSTER_BUILD_SCALE=OFF -DMUSTER_BUILD_HASHES=ON -DMUSTER_BUILD_ENGINE=ON \
        -DMUSTER_WASM_THREADS=$threads -DMUSTER_DEPS_INCLUDE="$build/deps" >"$build/configure.log" 2>&1 ||
        { tail -n 20 "$build/configure.log" >&2; exit 1; }
fi
cmake --build "$build" --target "$@" >"$build/build.log" 2>&1 || { grep -A 12 -m 1 -E 'error|FAILED' "$build/build.log" >&2; exit 1; }
if [ $threads = ON ] && [[ " $* " == *" muster_engine "* ]]; then
    mkdir -p build/wasm/apps/engine
    cp "$build"/apps/engine/muster-engine-threads.{js,worker.js,wasm} build/wasm/apps/engine/
fi
