# Counting of checks, for scripts that end with "N passed, N failed". Sourced, not run.

passed=0
failed=0

# check NAME COMMAND...: counts a command that has to succeed.
check() {
    local name=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "failed: $name"; fi
}
