# tests/e2e/boards.sh -- what ports/README.md says, walked through
# SPDX-License-Identifier: MIT

# The commands of ports/README.md, sections 4 to 7, as they stand there, on a table with switches.
case_the_page_of_the_boards() {
    sh tests/e2e/page.sh 4 Without "$loft" "$tmp/uno" >"$tmp/page.sh"
    [ "$(grep -c "$(realpath "$loft")" "$tmp/page.sh")" -ge 13 ] ||
        job_fails "the page has few commands"
    machine uno --speed fast --steps 80 --keep "$tmp/kept" --limits x-=-20,y-=-15,z+=8 \
        --walls x-=-24,y-=-19,z+=12 --probe z-=-3
    (cd "$tmp" && run 0 bash -e page.sh; [ -z "$why" ] || echo "$why" >"$tmp/off")
    [ ! -e "$tmp/off" ] || job_fails "$(cat "$tmp/off")"
    says out 'drawn: 1 curve'; says out 'steps 1600 0 .*as commanded'; says out '^homed: '
    says out 'touched'
}
case_the_walk_through_the_page_of_the_boards() {
    local page=ports/README.md block words
    # parts 5 and 7, and their machine: every line as it is printed, with another port
    block_of() {
        awk -v part="^### $1 " -v which="$2" '
            /^### /{on = $0 ~ part} on && /^```$/{code = 0} code == which && which
            on && /^```sh$/{code = ++count}' $page
    }
    local here; here=$(realpath "$loft")
    at() { local text=${1//build\/loft/$here}; echo "${text//\/dev\/ttyACM0/$tmp\/$2}"; }
    block=$(block_of 7 1)
    sed -n '/^### Without a board/,/^```$/p' $page | tr -d '\n\\' >"$tmp/alone"
    read -r -a options < <(sed 's/.*--speed real *\(--limits [^&]*\)&.*/\1/' "$tmp/alone")
    [ "$(grep -c build/loft <<<"$block")" = 5 ] || job_fails "part 7 has other commands: $block"
    [ "${options[0]}" = --limits ] || job_fails "no machine: $(cat "$tmp/alone")"
    words=$(block_of 5 2)
    [ "$(grep -c 'build/loft set' <<<"$words")" = 2 ] || job_fails "part 5 has other words: $words"
    machine m --speed fast "${options[@]}" --probe z-=-3 --steps 250
    local first; first=$(block_of 5 1)
    (cd "$tmp" && bash -e -c "$(at "$first" m)") >"$tmp/out" 2>"$tmp/err" </dev/null \
        || job_fails "part 5 fails: $(cat "$tmp/err")"
    says out '^kept: .*; steps/mm 80 80 80$'; says out '^x.travel = 280$'
    kill "$machine"; gone "$machine"
    machine words --speed fast
    bash -e -c "$(at "$words" words)" >"$tmp/out" 2>"$tmp/err" </dev/null \
        || job_fails "part 5 fails: $(cat "$tmp/err")"
    run 0 "$loft" settings --port "$tmp/words"
    says out '^x.reversed = yes$'; says out '^limit = opens$'; says out '^idle = 60$'
    machine table --speed fast "${options[@]}" --probe z-=-3
    run 0 "$loft" set --machine "$tmp/mine.txt" --port "$tmp/table"
    (cd "$tmp" && bash -e -c "$(at "$block" table)") >"$tmp/out" 2>"$tmp/err" </dev/null \
        || job_fails "a command fails: $(cat "$tmp/err")"
    is_empty err
    says out '^homed: the tool is at 0.000 0.000 30.000$'
    says out '^the tool is at 100.000 50.000 30.000$'
    says out '^touched at 100.000 50.000 0.000$'
    says out '^the tool is at 0.000 0.000 2.000$'
}
