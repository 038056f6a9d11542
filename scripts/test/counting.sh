# shellcheck shell=bash disable=SC2154
# Counts what tests say, for ./test. Sourced, not run; $work is a folder of its own, and $complete says whether all has run.

# finish: the last lines, however we end.
finish() {
    local part ok bad skip passed=0 failed=0 skipped=0
    trap - EXIT
    [ "$complete" = yes ] || printf 'the tests, which ended early\t0\t1\t0\n' >>"$work/counts"
    while IFS=$'\t' read -r part ok bad skip; do
        passed=$((passed + ok)); failed=$((failed + bad)); skipped=$((skipped + skip))
        [ "$bad" -eq 0 ] || printf 'failed: %s\n' "$part"
    done <"$work/counts"
    rm -rf "$work"
    [ "$skipped" -eq 0 ] || printf '%d skipped\n' "$skipped"
    printf '%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ] || exit 1
}
# count PART PASSED FAILED SKIPPED
count() {
    printf '%s\t%d\t%d\t%d\n' "$@" >>"$work/counts"
    printf '%-28s %5d passed, %d failed, %d skipped\n' "$1" "$2" "$3" "$4"
}

# needed WHAT COMMAND...: a step without which a part cannot run; counted as a failure where it fails.
needed() {
    local what=$1
    shift
    ("$@") && return 0
    count "$what" 0 1 0
    return 1
}

# skipped_cases: of a doctest log, how many test cases say "skipped: ..." somewhere.
skipped_cases() {
    awk '/^TEST CASE:/ { name = $0 }
         / MESSAGE: skipped: / && !(name in seen) { seen[name]; count += 1 }
         END { print count + 0 }' "$1"
}

# told: of a doctest log, what its tests measured or skipped, without the places in the sources.
told() {
    sed -nE -e 's/^[^ ]+: MESSAGE: (skipped: .*)$/\1/p' -e t \
        -e 's/^[^ ]+: MESSAGE: (measured: )?(.*)$/measured: \2/p' -e t -e '/^measured: /p' "$1"
}

# run_doctest NAME PROGRAM FOLDER: runs those test cases of a test program whose sources lie in the folder, and counts them.
run_doctest() {
    local name=$1 program=$2 code line ok bad skip log
    log=$work/$name.log
    "$program" --no-colors "--source-file=*/$3/*" >"$log" 2>&1
    code=$?
    line=$(grep -E '^\[doctest\] test cases:' "$log" | tr -dc '0-9|')
    IFS='|' read -r _ ok bad _ <<<"$line"
    [ -z "$line" ] && { ok=0; bad=1; }
    [ "$code" -ne 0 ] && [ "${bad:-0}" -eq 0 ] && bad=1
    [ $((${ok:-0} + ${bad:-0})) -gt 0 ] || bad=1  # A folder without a test is a mistake.
    skip=$(skipped_cases "$log")
    [ "$skip" -le "${ok:-0}" ] || skip=${ok:-0}
    {
        [ "${bad:-0}" -eq 0 ] || tail -n 60 "$log"
        told "$log"
        count "$name" "$((${ok:-0} - skip))" "${bad:-0}" "$skip"
    } >"$log.told"
    cat "$log.told"  # At once, so that programs that run beside each other do not mix their lines.
}

# run_counting NAME COMMAND...: runs a command whose output holds a line "N passed, N failed".
run_counting() {
    local name=$1 code line ok bad log
    shift
    log=$work/$name.log
    "$@" >"$log" 2>&1
    code=$?
    line=$(grep -E '^[0-9]+ passed, [0-9]+ failed' "$log" | tail -n 1)
    ok=$(sed -E 's/^([0-9]+) passed.*/\1/' <<<"${line:-0 passed}")
    bad=$(sed -E 's/.* ([0-9]+) failed.*/\1/' <<<"${line:-, 1 failed}")
    [ "$code" -ne 0 ] && [ "$bad" -eq 0 ] && bad=1
    [ "$bad" -eq 0 ] || tail -n 80 "$log"
    grep -E '^(skipped|measured): ' "$log"
    count "$name" "$ok" "$bad" "$(grep -c '^skipped: ' "$log")"
}
