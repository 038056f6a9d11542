#!/usr/bin/env bash
# Checks docs/api/muster_api.json against the headers as compilers see them, and against the library where one is given.
# Usage: description.sh INCLUDE_FOLDER [LIBRARY_FOLDER]
set -u
root=$(cd "$(dirname "$0")/../../.." && pwd)
include=$1
libraries=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
file=$root/docs/api/muster_api.json

fail() {
    echo "$1"
    exit 1
}

# Compiles the program that is made from a description.
compiles() {
    node "$root/tests/bindings/c/check_program.mjs" "$2" >"$work/program.c" &&
        "$1" -std=c99 -pedantic -Wall -Wextra -Wno-address -Werror -I "$include" -c "$work/program.c" -o "$work/program.o"
}

# Names that the preprocessed header declares, without those of the system's headers.
declared() {
    echo '#include <muster/muster.h>' | "${CC:-cc}" -std=c99 -E -I "$include" -x c - | grep -v '^#' |
        sed 's/enum Muster[A-Za-z]*Value//' | grep -ohE "\\b$1" | sort -u
}

# Names of a list of the description.
described() {
    node -e 'const api = JSON.parse(require("fs").readFileSync(process.argv[1]));
        for (const list of process.argv.slice(2)) for (const { name, values } of api[list])
            for (const one of list === "values" ? values ?? [] : [{ name }]) console.log(one.name);' "$file" "$@" | sort -u
}

diff <(declared 'muster_[a-z0-9_]+ *\(' | tr -d ' (') <(described functions) || fail "the description lacks functions"
diff <(declared 'Muster[A-Za-z0-9]+') <(described integers structs callbacks) || fail "the description lacks types"
for compiler in gcc clang; do
    command -v "$compiler" >/dev/null || continue
    compiles "$compiler" "$file" || fail "$compiler: the description does not fit the headers"
    # Faults of every kind are found: a parameter, a field that is gone, an order of fields, a number.
    for fault in 's/"type": "MusterWorldId"/"type": "MusterMapId"/' '/"name": "wantedVelocity"/s/wanted/found/' \
        's/"name": "squares"/"name": "sum2"/' 's/"value": 23/"value": 24/'; do
        sed "$fault" "$file" >"$work/wrong.json"
        cmp -s "$file" "$work/wrong.json" && fail "the fault $fault changes nothing"
        compiles "$compiler" "$work/wrong.json" 2>"$work/errors" && fail "$compiler: the fault $fault was not found"
    done
done
if [ -n "$libraries" ]; then
    compiles "${CC:-cc}" "$file" && "${CC:-cc}" "$work/program.o" -L "$libraries" -lmuster -o "$work/program" &&
        LD_LIBRARY_PATH=$libraries "$work/program" || fail "the library lacks functions"
    node "$root/tests/bindings/c/zero_program.mjs" >"$work/zero.c" &&
        "${CC:-cc}" -std=c99 -I "$include" "$work/zero.c" -L "$libraries" -lmuster -o "$work/zero" &&
        LD_LIBRARY_PATH=$libraries "$work/zero" || fail "a call with nothing ends the program, or succeeds"
fi
echo "the description fits"
