#!/usr/bin/env bash
# Installs everything into a folder of its own; builds and runs each sample that CMake builds outside the tree, with find_package(muster);
# tries the installed program. Each sample and the program count as one test. Usage: run.sh [--headers]
#
#     --headers   compiles each installed header alone, with every compiler: where headers have changed, and for a release
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. "$root/scripts/checks.sh"

# One build of all samples, which saves looking for the compiler once each.
build_samples() {
    cp -r "$root/samples" "$work/samples"
    {
        echo 'cmake_minimum_required(VERSION 3.25)'
        echo 'project(samples LANGUAGES CXX)'
        for file in "$work"/samples/*/CMakeLists.txt; do echo "add_subdirectory($(basename "$(dirname "$file")"))"; done
    } >"$work/samples/CMakeLists.txt"
    cmake -S "$work/samples" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" \
        -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DCMAKE_C_FLAGS="-pedantic -Wall -Wextra -Werror" >/dev/null && cmake --build "$work/build"
}

# Every installed header compiles alone, and exactly those of include/muster are installed.
headers_alone() {
    diff <(ls "$root/include/muster") <(ls "$work/prefix/include/muster") || return 1
    for header in "$work"/prefix/include/muster/*.h; do basename "$header"; done |
        xargs -P 2 -I {} sh -c 'echo "#include <muster/{}>" |
            ${CXX:-c++} -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I "$1" -x c++ - || { echo "{}"; exit 1; }' \
            sh "$work/prefix/include"
}

# The lockstep sample where things go wrong: bad datagrams change nothing; a peer that is alone, or left alone, ends and says
# so; two that play in different worlds are told.
lockstep_in_trouble() {
    local program=$work/build/lockstep/lockstep out=$work/lockstep.out code first
    "$program" --minutes 0.2 --loss 0.3 --garbage 0.5 >"$out/garbage" || return 1
    grep -q 'datagrams were malformed' "$out/garbage" || return 1
    "$program" --port 18981 --peer 18982 --patience 0.5 >"$out/alone"
    [ $? -eq 3 ] && grep -q 'has sent nothing for' "$out/alone" || return 1
    "$program" --port 18981 --peer 18982 --real --patience 2 >"$out/left" &
    first=$!
    timeout -s KILL 3 "$program" --port 18982 --peer 18981 --real >"$out/killed"
    wait "$first"
    [ $? -eq 3 ] && grep -q 'has sent nothing for' "$out/left" || return 1
    "$program" --port 18981 --peer 18982 >"$out/west" &
    first=$!
    "$program" --port 18982 --peer 18981 --people 51 >"$out/east"
    code=$?
    wait "$first"
    [ $((code + $?)) -gt 0 ] && cat "$out/west" "$out/east" | grep -q 'differ after step 1$'
}

# The header of the C API compiles alone as C99 with every compiler that is there.
c_header_alone() {
    local compiler
    for compiler in gcc clang clang-14; do
        command -v "$compiler" >/dev/null || continue
        echo "#include <muster/muster.h>" | "$compiler" -std=c99 -pedantic -Wall -Wextra -Wconversion -Werror -fsyntax-only \
            -I "$work/prefix/include" -x c - || { echo "$compiler: muster.h"; return 1; }
    done
}

# The shared library shows the C API and nothing else, and every function that the header declares.
symbols_hidden() {
    nm -D --defined-only "$work/prefix/lib/libmuster.so" | awk '{print $3}' | sort >"$work/shown"
    grep -ohE '\bmuster_[a-z0-9_]+\(' "$work/prefix/include/muster/muster.h" | tr -d '(' | grep -v '_\.\.\.' | sort -u >"$work/declared"
    [ -s "$work/declared" ] && diff "$work/declared" "$work/shown"
}

# The C sample by pkg-config, with the shared library and with the static one, and with clang: the same line each time.
by_pkg_config() {
    export PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig
    local flags="-std=c99 -pedantic -Wall -Wextra -Werror" source=$root/samples/c_hello/main.c compiler
    for compiler in gcc clang; do
        command -v "$compiler" >/dev/null || continue
        # shellcheck disable=SC2046,SC2086
        "$compiler" $flags "$source" $(pkg-config --cflags --libs muster) -o "$work/hello_shared" || return 1
        # shellcheck disable=SC2046,SC2086
        "$compiler" $flags "$source" $(pkg-config --cflags muster) "$work/prefix/lib/libmuster.a" \
            $(pkg-config --static --libs-only-l muster | sed 's/-lmuster//') -o "$work/hello_static" || return 1
        diff <(LD_LIBRARY_PATH=$work/prefix/lib "$work/hello_shared") <("$work/hello_static") || return 1
    done
}

# find_package with components: what was not built is refused with a sentence; core looks for no SQLite.
components() {
    mkdir -p "$work/components"
    cat >"$work/components/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(components LANGUAGES CXX)
find_package(muster 0.1 REQUIRED COMPONENTS ${WANTED})
if(TARGET SQLite::SQLite3)
    message("SQLite was looked for")
endif()
foreach(component core motion io studio)
    if(TARGET muster::${component})
        message("component ${component}")
    endif()
endforeach()
TEXT
    local configure=(cmake -S "$work/components" -B "$work/components/build" -DCMAKE_PREFIX_PATH="$work/prefix")
    local core motion none
    core=$("${configure[@]}" -DWANTED=core 2>&1) || return 1
    motion=$("${configure[@]}" "-DWANTED=core;motion" 2>&1) || return 1
    none=$("${configure[@]}" -DWANTED=engine 2>&1) && return 1
    grep -q 'component core' <<<"$core" && ! grep -q 'SQLite was\|component motion' <<<"$core" &&
        grep -q 'component motion' <<<"$motion" && ! grep -q 'SQLite was\|component io' <<<"$motion" &&
        grep -q 'found no component engine' <<<"$none"
}

# The installed program, its scenarios and, where it was built, its page.
try_program() {
    local program=$work/prefix/bin/muster studio
    "$program" --version && "$program" check "$work/prefix/share/muster/scenarios/open.json" || return 1
    [ -f "$root/web/dist/index.html" ] || { echo "skipped: the installed studio, as the page is not built"; return 0; }
    (cd "$work" && exec "$program" studio --port 18980 --json) >"$work/address" &
    studio=$!
    for _ in $(seq 600); do [ -s "$work/address" ] && break; sleep 0.1; done
    kill -TERM "$studio"
    wait "$studio" && grep -q '"address": "http://127.0.0.1:' "$work/address"
}

cmake --install "$root/build/release" --prefix "$work/prefix" >/dev/null || { echo "0 passed, 1 failed"; exit 1; }
build_samples || { echo "0 passed, 1 failed"; exit 1; }
for file in "$root"/samples/*/CMakeLists.txt; do
    name=$(basename "$(dirname "$file")")
    if [ "$name" = sdl_game ] && [ ! -x "$work/build/$name/$name" ]; then
        echo "skipped: sdl_game, as libsdl2-dev is not there"
        continue
    fi
    mkdir "$work/$name.out"
    check "$name" "$work/build/$name/$name" "$work/$name.out"
done
check "lockstep in trouble" lockstep_in_trouble 2>/dev/null
[ ! -d "$work/sdl_game.out" ] || check "the game's picture" test -s "$work/sdl_game.out/sdl_game.bmp"
check "the exported file" test -s "$work/record_export.out/sample.glb"
if [ "${1:-}" = --headers ]; then
    check "the installed headers" headers_alone
    check "the header of the C API" c_header_alone
fi
check "the symbols of the shared library" symbols_hidden
check "the description of the API" bash "$root/tests/bindings/c/description.sh" "$work/prefix/include" "$work/prefix/lib"
check "pkg-config" by_pkg_config
check "components" components
check "the recipes of package managers" bash "$root/packaging/check.sh"
check "the installed program" try_program
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
