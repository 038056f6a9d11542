#!/usr/bin/env bash
# Installs the package into a virtual environment, as users do, and tests it there; ends with "N passed, N failed".
# Usage: run.sh PROGRAM; the build folder of the program is used again. MUSTER_PYTHON names another interpreter than Debian's.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
program=$(realpath "$1")
build=$root/build/release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export MUSTER_PROGRAM=$program MUSTER_BUILD_DIR=$build PYTHONDONTWRITEBYTECODE=1

"${MUSTER_PYTHON:-/usr/bin/python3}" -m venv --system-site-packages "$work/venv" || exit 1
# No network: the build needs nothing, and NumPy is the system's.
"$work/venv/bin/pip" install --quiet --no-index "$root/bindings/python" || { echo "0 passed, 1 failed"; exit 1; }
# What other packages of the system lack is no concern of this one.
! "$work/venv/bin/pip" check | grep -i '^muster ' || { echo "pip check fails"; echo "0 passed, 1 failed"; exit 1; }
cd "$root/tests/python" || exit 1  # Away from the sources of the package.
"$work/venv/bin/python" -m pytest -q --no-header -p no:cacheprovider .
