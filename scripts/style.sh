#!/usr/bin/env bash
# The rules of style; ends with "N passed, N failed". Usage: style.sh [--all | --format]
#
#     without an option   formatting and words of all files; clang-tidy and lonely headers of those that differ from origin/main,
#                         of at most twenty each, which are drawn where there are more
#     --all               everything of all files
#     --format            formatting, words, links and paths of all files only
#
# It configures a build that is never built, for its compile_commands.json.
set -u
. "$(dirname "$0")/common.sh"

what=${1:-changed}
passed=0
failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# rule NAME COMMAND...: runs it and counts it.
rule() {
    local name=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "style: $name"; fi
}

# sources PATTERN...: files under version control or new, all of them or those that differ from origin/main (where there is
# none, from the last commit but one).
sources() {
    local base
    if [ "$what" = --all ] || [ "$what" = --format ]; then
        git ls-files --cached --others --exclude-standard -- "$@"
    else
        base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD~1 2>/dev/null || git rev-parse HEAD)
        [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1 || echo "$base")
        git diff --name-only --diff-filter=d "$base" -- "$@"
        git ls-files --others --exclude-standard -- "$@"
    fi | sort -u | while read -r file; do [ ! -e "$file" ] || echo "$file"; done
}

formatted() {
    git ls-files --cached --others --exclude-standard -- '*.cpp' '*.h' | while read -r file; do [ ! -e "$file" ] || echo "$file"; done |
        xargs -P "$(nproc)" -n 20 clang-format --dry-run -Werror 2>&1 | grep -E 'error' | cut -d: -f1 | sort -u >"$work/format"
    sed 's/^/clang-format -i /' "$work/format"
    [ ! -s "$work/format" ]
}

# No file names a place on somebody's machine.
portable() {
    ! git grep -InE '(^|[^a-zA-Z0-9_.])/(home|Users|root|work|mnt)/[a-z]' -- . ':!web/package-lock.json' ':!scripts/style.sh'
}

# Every relative link of a document leads to a file.
links() {
    local file link
    git ls-files '*.md' | while read -r file; do
        [ -e "$file" ] || continue
        grep -oE '\]\([^)#: ]+' "$file" | sed 's/](//' | while read -r link; do
            [ -e "$(dirname "$file")/$link" ] || echo "$file links to $link"
        done
    done >"$work/links"
    cat "$work/links"
    [ ! -s "$work/links" ]
}

# What generators write is what the declarations say.
fresh() {
    node schema/generate.mjs --check
}

# some KIND: of the files on standard input as many as a push has time for.
some() {
    sort >"$work/some"
    if [ "$what" != changed ] || [ "$(wc -l <"$work/some")" -le 20 ]; then
        cat "$work/some"
    else
        echo "measured: $1 looks at 20 of $(wc -l <"$work/some") changed files; --all looks at all" >&2
        shuf -n 20 --random-source=<(yes "$(git rev-parse HEAD)") "$work/some"
    fi
}

# What only emscripten compiles is left out.
tidy() {
    sources '*.cpp' | grep -E '^(src|apps|bench|bindings/c)/' | grep -vE '^apps/engine/(engine_exports|take_exporter)' | some clang-tidy | xargs -r -P "$(nproc)" -n 1 clang-tidy -p build/style --quiet >"$work/tidy" 2>"$work/errors"
    grep -E -A 3 '(warning|error): ' "$work/tidy"
    ! grep -qE '(warning|error): ' "$work/tidy"
}

# Those of the Python package need Python and files that are made by a build, those of the game's sample SDL.
lonely_headers() {
    local left_out='^bindings/(python|javascript)/'
    if ! pkg-config --exists sdl2 2>/dev/null; then
        echo "skipped: headers of samples/sdl_game, as libsdl2-dev is not there"
        left_out="$left_out|^samples/sdl_game/"
    fi
    sources '*.h' | grep -vE "$left_out" | some "what compiles headers alone" >"$work/headers"
    node scripts/lonely_headers.mjs build/style "$work/headers"
}

# page_rule SCRIPT: a script of the page's package.json, where there is one.
page_rule() {
    grep -q "\"$1\":" web/package.json || return 0
    (cd web && npm run --silent "$1")
}

rule "files that clang-format would change" formatted
rule "paths of a machine" portable
rule "links of documents to nowhere" links
rule "files that generators would write otherwise" fresh
rule "words that the glossary replaces" node scripts/style/words.mjs
rule "private names that two files of a module have" node scripts/style/private_names.mjs
if [ "$what" != --format ]; then
    cmake --preset style >/dev/null || fail "cmake could not configure the preset style"
    rule "findings of clang-tidy" tidy
    rule "headers that do not compile alone" lonely_headers
    install_page_packages
    rule "findings in the page's sources" page_rule lint
    rule "files of the page that are not formatted" page_rule format:check
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
