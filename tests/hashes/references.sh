#!/usr/bin/env bash
# Plays every scenario with the touches that it carries to its last step, by the exact and by the fast plan, and compares the
# number of steps and the hash of the last state with references.txt. Usage: references.sh PROGRAM [--quick | --rewrite]
#
#     --quick     leaves out the exact plan
#     --rewrite   writes references.txt anew; do so only where a change of behaviour is meant, and say which in the commit
set -u
program=$(realpath "$1")
option=${2:-}
cd "$(dirname "$0")/../.." || exit 1
references=tests/hashes/references.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# play PROGRAM SCENARIO PLAN: a line as in references.txt.
play() {
    local solver=0 figures
    [ "$3" = fast ] && solver=1
    figures=$("$1" play "scenarios/$2.json" --demo --threads 1 --set plan.solver=$solver --json) || { echo "$2 $3 failed"; return; }
    sed -nE -e 's/^  "steps": ([0-9]+),$/\1/p' -e 's/^  "hash": "([0-9a-f]+)",$/\1/p' <<<"$figures" | xargs echo "$2 $3"
}
export -f play

# The scenarios and plans: those of the folders, so that none is forgotten.
for file in scenarios/*.json scenarios/paper/*.json; do
    name=${file#scenarios/}
    [ "$option" = --quick ] || echo "${name%.json} exact"
    echo "${name%.json} fast"
done >"$work/runs"
# Each play on one thread, as many beside each other as there are processors; the dearest, which the exact plan makes, first.
sort -s -k2,2 "$work/runs" |
    xargs -P "$(nproc)" -L 1 bash -c 'play "$0" "$1" "$2"' "$program" >"$work/played"
LC_ALL=C sort "$work/played" >"$work/sorted"
if [ "$option" = --rewrite ]; then
    cp "$work/sorted" "$references"
    echo "wrote $references"
    exit 0
fi
passed=0
failed=0
while read -r name plan steps hash; do
    expected=$(grep "^$name $plan " "$references" | cut -d' ' -f3-)
    if [ "$steps $hash" = "$expected" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$name, $plan plan: $steps steps end in $hash, the reference says ${expected:-nothing}"
    fi
done <"$work/sorted"
# References of scenarios that are gone.
while read -r name _; do
    [ -f "scenarios/$name.json" ] || { failed=$((failed + 1)); echo "there is no scenarios/$name.json any more"; }
done <"$references"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
