#!/usr/bin/env bash
# Records takes, exports them for the player in web pages, prints how large all parts are, and tries the player in Chromium.
# Usage: run.sh PROGRAM
set -u
program=$(realpath "$1")
cd "$(dirname "$0")/../.." || exit 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
made() { "$@" >"$folder/log" 2>&1 || { tail -n 5 "$folder/log"; echo "0 passed, 1 failed"; exit 1; }; }

# NAME SCENARIO SECONDS GESTURES...: a take, and its file for the player.
take() {
    made "$program" play "$2" "${@:4}" --seconds "$3" --take "$folder/$1.take"
    made "$program" export "$folder/$1.take" --format player --to "$3" --out "$folder/$1.muster-player"
}
take market scenarios/market.json 20 --demo
take course scenarios/course.json 40 --demo
take cars scenarios/cars.json 10 --demo
take thousand web/tests/scenarios/thousand.json 20 --gestures tests/player/thousand_gestures.json
for name in market cars; do
    made "$program" export "$folder/$name.take" --format pedpy --fps 15 --out "$folder/$name.txt"
    made "$program" export "$folder/$name.take" --format glb --fps 2 --to 1 --out "$folder/$name.glb"
done
made "$program" export "$folder/course.take" --format joints --fps 3 --to 39 --out "$folder/course.json"
made "$program" export "$folder/market.take" --format player-page --to 20 --out "$folder/market.html"
made "$program" export "$folder/market.take" --format player-folder --to 20 --out "$folder/talk"
node web/tests/player.mjs "$folder" ${MUSTER_SHOTS:+--shots "$MUSTER_SHOTS"}
