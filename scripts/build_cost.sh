#!/usr/bin/env bash
# Prints what it costs to build the parts of Muster from nothing. See --help.
set -u
. "$(dirname "$0")/common.sh"

if [ "${1:-}" = --help ] || [ "${1:-}" = -h ]; then
    cat <<'TEXT'
Usage: scripts/build_cost.sh [PART...]    builds each part from nothing, without ccache, in a folder of its own

Parts: library     the core as a game adds it by add_subdirectory (MUSTER_COMPONENTS=core)
       studio      the program that ./run starts
       lab         the program and muster-lab
       everything  both programs, all libraries, tests and benchmarks of scale
Each line names the part, the objects that were compiled, the core-seconds (user and system time of all processes) and the wall
time. Another load on the machine raises both.
TEXT
    exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_DISABLE=1

# measured PART BUILD TARGET...: builds the targets and prints a line.
measured() {
    local part=$1 build=$2 times
    shift 2
    TIMEFORMAT='%R %U %S'
    times=$({ time cmake --build "$build" --target "$@" >"$work/log" 2>&1; } 2>&1) || { tail -n 20 "$work/log" >&2; fail "$part does not build"; }
    awk -v part="$part" -v objects="$(grep -c 'Building CXX object' "$work/log")" \
        '{ printf "%-11s %4d objects %5.0f core-seconds %5.0f s\n", part, objects, $2 + $3, $1 }' <<<"$times"
}

[ $# -gt 0 ] || set -- library studio lab everything
for part in "$@"; do
    build=$work/$part
    case "$part" in
        library)
            mkdir "$work/game"
            printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(game CXX)' 'set(MUSTER_COMPONENTS core)' \
                "add_subdirectory(\"$root\" muster)" >"$work/game/CMakeLists.txt"
            cmake -S "$work/game" -B "$build" -G Ninja >/dev/null || fail "cmake could not configure the core"
            measured library "$build" all
            ;;
        studio | lab | everything)
            cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null 2>&1 || fail "cmake could not configure $part"
            targets=(muster_program)
            [ "$part" = studio ] || targets+=(muster_lab)
            [ "$part" != everything ] || targets=(all)
            measured "$part" "$build" "${targets[@]}"
            ;;
        *) fail "no part is called '$part'; see scripts/build_cost.sh --help" ;;
    esac
    rm -rf "$build"
done
