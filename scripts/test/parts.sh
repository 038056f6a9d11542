# shellcheck shell=bash disable=SC2034,SC2154
# The parts of ./test: what each needs, and how it is run. Sourced, not run.

# What a push needs, in the order in which it is run; parts that a release needs on top are named by ./test --help.
push_parts=(cpp hashes style wasm paper verify export python server web browser player javascript site consumer)
known_parts=(style cpp sanitize hashes wasm javascript site consumer python paper verify export player blender server web browser firefox)

# needs PART: the Debian packages that only this part needs.
needs() {
    case "$1" in
        style) echo "${style_packages[@]}" "${test_packages[@]}" ;;
        cpp | sanitize) echo "${test_packages[@]}" ;;
        wasm) echo "${wasm_packages[@]}" ;;
        javascript | site) echo "${wasm_packages[@]}" "${browser_packages[@]}" ;;
        browser | player) echo "${browser_packages[@]}" ;;
        firefox) echo "${firefox_packages[@]}" ;;
        blender) echo "${blender_packages[@]}" ;;
        python) echo "${python_packages[@]}" ;;
    esac
}

# uses PART: what must be built before it runs: targets of the release build, "page", and "wasm:" with targets for WebAssembly.
uses() {
    case "$1" in
        cpp) test_programs ;;
        hashes | export | blender | server | python) echo muster_program ;;
        paper | verify) echo muster_program muster_lab ;;
        wasm) echo scenario_hashes wasm:scenario_hashes ;;
        consumer) echo muster_everything page ;;
        browser | firefox) echo muster_program page ;;
        player) echo muster_program page ;;
        javascript) echo muster_program page wasm:muster_javascript ;;
        site) echo muster_program page wasm:muster_engine ;;
    esac
}

# test_programs: the programs of the suites that were asked for; lines "suite program folder" are there once the build is configured.
# Without names all of them, and what nobody runs but everybody may break.
test_programs() {
    local suite program
    [ "$quick" = yes ] || [ ${#suites[@]} -gt 0 ] || echo all
    while read -r suite program _; do
        chosen "$suite" && echo "$program"
    done <build/release/tests/suites.txt | sort -u
}

# chosen SUITE: whether this run has it. The answer that matters leaves out what tests programs.
chosen() {
    [ "$quick" = no ] || [[ " cli reproduce verify bench muster " != *" $1 "* ]] || return 1
    [ ${#suites[@]} -eq 0 ] || [[ " ${suites[*]} " == *" $1 "* ]]
}

# run_suites PRESET PREFIX: runs the suites, as many beside each other as there are processors, the longest first.
run_suites() {
    local suite program folder
    {
        grep -E '^(world|transport) ' "build/$1/tests/suites.txt"
        grep -vE '^(world|transport) ' "build/$1/tests/suites.txt"
    } >"$work/suites"
    while read -r suite program folder; do
        chosen "$suite" || continue
        while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
        run_doctest "$2$suite" "build/$1/tests/$program" "$folder" </dev/null &
    done <"$work/suites"
    wait
}

run_part() {
    local program=build/release/muster
    case "$1" in
        style)
            run_counting style bash scripts/style.sh "${style_options[@]}"
            run_counting "work of compiling" node scripts/build_work.mjs build/release
            ;;
        cpp)
            run_suites release ""
            run_counting graph node tests/graph/check.mjs build/release
            ;;
        sanitize) needed "build asan" build_program asan all && run_suites asan "sanitized " ;;
        hashes) run_counting hashes bash tests/hashes/references.sh "$program" "${hash_options[@]}" ;;
        wasm) run_counting builds bash tests/hashes/run.sh "${all_options[@]}" ;;
        javascript) run_counting javascript bash tests/javascript/run.sh "$program" ;;
        site) run_counting site bash tests/site/run.sh "$program" "${all_options[@]}" ;;
        consumer) run_counting consumer bash tests/consumer/run.sh "${header_options[@]}" ;;
        python) run_counting python bash tests/python/run.sh "$program" ;;
        paper) run_counting paper bash tests/lab/reproduce/run.sh "$program" "${all_options[@]}" ;;
        verify) run_counting verify bash tests/lab/verify/run.sh "$program" "${all_options[@]}" ;;
        export) needed "the page's packages" install_page_packages && run_counting export bash tests/files/export/run.sh "$program" ;;
        player) run_counting player bash tests/player/run.sh "$program" ;;
        blender) run_counting blender bash scripts/blender/check.sh "$program" ;;
        server) run_counting server node tests/server/run.mjs "$program" ;;
        web) needed "the page's packages" install_page_packages && run_counting page bash -c 'cd web && npm run --silent check' ;;
        browser) run_counting browser node web/tests/browser.mjs "${all_options[@]}" ;;
        firefox) run_counting firefox bash -c 'cd web && npm run --silent firefox' ;;
    esac
}
