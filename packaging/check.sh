#!/usr/bin/env bash
# Checks the recipes as far as that can be done without vcpkg and Conan; ends with "N passed, N failed".
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. "$root/scripts/checks.sh"

version=$(grep -oE '^project\(muster VERSION [0-9.]+' "$root/CMakeLists.txt" | grep -oE '[0-9.]+$')
port=$root/packaging/vcpkg/muster
recipe=$root/packaging/conan/conanfile.py

port_is_json() {
    node -e 'const port = JSON.parse(require("fs").readFileSync(process.argv[1]));
        const features = Object.keys(port.features);
        const own = Object.values(port.features).flatMap(({ dependencies }) => dependencies ?? [])
            .filter(({ name }) => name === port.name).flatMap((one) => one.features);
        const good = port.version === process.argv[2] && port.license === "MIT" &&
            [...own, ...port["default-features"]].every((name) => features.includes(name));
        process.exit(good ? 0 : 1);' "$port/vcpkg.json" "$version"
}

recipe_compiles() {
    python3 -c 'import ast, sys
source = open(sys.argv[1]).read()
compile(source, sys.argv[1], "exec")
fields = {n.targets[0].id: n.value.value for c in ast.parse(source).body if isinstance(c, ast.ClassDef)
          for n in c.body if isinstance(n, ast.Assign) and isinstance(n.value, ast.Constant)}
sys.exit(0 if fields["version"] == sys.argv[2] and fields["license"] == "MIT" else 1)' "$recipe" "$version"
}

# Every MUSTER_ option that a recipe passes is one that the build knows.
options_are_known() {
    grep -rhoE '(option|set)\(MUSTER_[A-Z_]+' "$root/CMakeLists.txt" "$root/cmake" | sed 's/.*(//' | sort -u >"$work/known"
    {
        grep -oE 'MUSTER_(BUILD|WITH|HOST|COMPONENTS)[A-Z_]*' "$port/portfile.cmake" "$recipe" -h | grep -v '_$'
        printf 'MUSTER_BUILD_%s\n' APPS TESTS HASHES SCALE
    } | sort -u >"$work/passed"
    [ -z "$(comm -13 "$work/known" "$work/passed")" ]
}

# configures NAME OPTION...: CMake accepts the options and makes the targets that the recipe installs.
configures() {
    local name=$1
    shift
    cmake -S "$root" -B "$work/$name" -G Ninja -DMUSTER_BUILD_APPS=OFF -DMUSTER_BUILD_TESTS=OFF -DMUSTER_BUILD_HASHES=OFF \
        -DMUSTER_BUILD_SCALE=OFF "$@" >"$work/$name.log" 2>&1 || { cat "$work/$name.log"; return 1; }
}

core_alone() {
    configures core -DMUSTER_COMPONENTS=core -DMUSTER_BUILD_SHARED=ON -DMUSTER_BUILD_ARCHIVE=OFF -DMUSTER_WITH_SQLITE=OFF &&
        ! grep -qE 'nlohmann|sqlite|libmuster_export' "$work/core/build.ninja" && grep -q 'libmuster\.so' "$work/core/build.ninja"
}

archive_of_all() {
    configures io "-DMUSTER_COMPONENTS=core;motion;io" -DMUSTER_BUILD_SHARED=OFF -DMUSTER_BUILD_ARCHIVE=ON -DMUSTER_WITH_SQLITE=ON &&
        grep -q 'libmuster\.a' "$work/io/build.ninja" && ! grep -q 'libmuster\.so' "$work/io/build.ninja"
}

needs_are_named() {
    ! cmake -S "$root" -B "$work/bad" -G Ninja "-DMUSTER_COMPONENTS=core;io" -DMUSTER_BUILD_TESTS=OFF >"$work/bad.log" 2>&1 &&
        grep -q 'component io needs motion' "$work/bad.log"
}

check "vcpkg.json" port_is_json
check "conanfile.py" recipe_compiles
check "the options of the recipes" options_are_known
check "core alone" core_alone
check "an archive of all components" archive_of_all
check "a component without what it needs" needs_are_named
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
