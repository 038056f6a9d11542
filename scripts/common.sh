# Shared by run and test: installing what is missing, building. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1

# Debian packages: to build the program; on top of that for the C++ tests, style, browser tests, WebAssembly, Blender, Python.
build_packages=(g++ cmake ninja-build libeigen3-dev nlohmann-json3-dev libcli11-dev libboost-dev libstb-dev libsqlite3-dev libqrcodegencpp-dev)
test_packages=(doctest-dev librapidcheck-dev liblemon-dev r-base-core r-cran-lme4 r-cran-lmertest)
style_packages=(clang-format clang-tidy git)
browser_packages=(chromium libgl1-mesa-dri libegl1)
firefox_packages=(firefox-esr xvfb libgl1-mesa-dri libegl1)
wasm_packages=(emscripten xz-utils)
blender_packages=(blender python3-numpy)
python_packages=(pybind11-dev python3-dev python3-numpy python3-pip python3-venv python3-pytest python3-pandas python3-matplotlib mypy)
configure_again=no  # Becomes yes once packages have come, for what is found now.

say() { printf '\033[1m%s\033[0m\n' "$*" >&2; }
fail() { printf 'muster: %s\n' "$*" >&2; exit 1; }

# install_packages NAME...: installs those Debian packages that are missing.
install_packages() {
    local missing=() name
    for name in "$@"; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "these packages are missing and neither root nor sudo is at hand: ${missing[*]}"
        as_root=(sudo)
    fi
    say "Installing ${missing[*]}"
    "${as_root[@]}" apt-get update -qq || fail "apt-get update failed; is there a network?"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null ||
        fail "apt-get could not install: ${missing[*]}"
    configure_again=yes
}

# Node from wherever it comes, else Debian's.
install_node() {
    if command -v node >/dev/null && command -v npm >/dev/null; then
        [ "$(node -p 'process.versions.node.split(".")[0]')" -ge 18 ] || fail "found Node $(node --version), expected 18 or newer"
        return 0
    fi
    install_packages nodejs npm
}

# configure PRESET: configures a build once, and again where packages have come.
configure() {
    [ -f "build/$1/build.ninja" ] && [ "$configure_again" = no ] && return 0
    cmake --preset "$1" >/dev/null || fail "cmake could not configure the preset $1"
}

# show_progress LOG: copies what ninja prints to LOG and shows how far it is: on a terminal in one line that changes, else in
# a line every ten seconds.
show_progress() {
    local line shown=$SECONDS
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$1"
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*) ]] || continue
        local percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
        if [ -t 2 ]; then
            printf '\r\033[K%3d %%  %.70s' "$percent" "${BASH_REMATCH[3]##*/}" >&2
        elif [ $((SECONDS - shown)) -ge 10 ]; then
            printf '%3d %%\n' "$percent" >&2
            shown=$SECONDS
        fi
    done
    [ ! -t 2 ] || printf '\r\033[K' >&2
}

# build_program PRESET TARGET...: configures where needed, then builds and shows the progress.
build_program() {
    local preset=$1 log=build/$1/build.log
    shift
    configure "$preset"
    : >"$log"
    NINJA_STATUS='[%f/%t] ' cmake --build "build/$preset" --target "$@" 2>&1 | show_progress "$log"
    [ "${PIPESTATUS[0]}" -eq 0 ] && return 0
    grep -A 12 -m 1 -E 'error|FAILED' "$log" >&2
    fail "the build failed; the whole log is $log"
}

# install_page_packages: what web/package-lock.json asks for.
install_page_packages() {
    [ ! -f web/node_modules/.package-lock.json ] || [ web/package-lock.json -nt web/node_modules/.package-lock.json ] || return 0
    say "Installing the page's packages"
    # No progress, but the reason where it fails.
    (cd web && npm ci --no-audit --no-fund --loglevel=error >&2) || fail "npm ci failed in web/"
    touch web/node_modules/.package-lock.json
}

# build_page: installs the page's packages and builds web/dist where sources are newer than it.
build_page() {
    install_page_packages
    if [ ! -f web/dist/index.html ] ||
        [ -n "$(find web protocol bindings/javascript/src -newer web/dist/index.html -type f -not -path 'web/node_modules/*' -not -path 'web/dist/*' -not -path 'web/test-results/*' -print -quit)" ]; then
        say "Building the page"
        (cd web && npm run --silent build) >&2 || fail "the page does not build"
        touch web/dist/index.html
    fi
}

# build_both TARGET...: builds these targets of the release build, and the page beside them, which mostly waits for its packages.
build_both() {
    local page
    install_node
    build_page &
    page=$!
    build_program release "$@"
    wait "$page" || fail "the page could not be built"
}
