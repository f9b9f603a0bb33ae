# tests/e2e/interrupt.sh -- interrupts
# SPDX-License-Identifier: MIT

case_interrupt_holds_and_the_same_command_goes_on() {
    undisturbed
    machine stopped --speed fast --halt 1200 --once
    types stopped '#halted at tick 1200#^C #asked to hold#>' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/stopped" "${slowly[@]}"
    [ $? = 75 ] || job_fails "exit code is not 75"
    says out 'held at item [0-9]* of .*[0-9]*: the machine is stopped on the path at'
    until_log stopped held
    local said held
    said=$(sed -n 's/.*mm, steps \(-\?[0-9]* -\?[0-9]* -\?[0-9]*\);.*/\1/p' "$tmp/out")
    held=$(sed -n 's/.* held: .*position \(.*\)/\1/p' "$tmp/stopped.log")
    [ "$said" = "$held" ] || job_fails "said $said, the machine stood at $held"
    draws stopped
    run 0 "${job[@]}"
    gone "$machine"
    says err '^resuming at item'
    counted stopped
    same_path stopped calm
}
case_interrupt_while_planning_ends_at_once() {
    long_drawing
    machine idle --speed fast
    interrupted "$loft" stream "$tmp/long.loft" --dry-run
    says err '^loft: stopped: nothing was sent$'; is_empty out
    interrupted "$loft" stream "$tmp/long.loft" --port "$tmp/idle"
    says err '^loft: stopped'; is_empty out
    run 0 "$loft" ports "$tmp/idle"; says out '	idle'
}
case_long_drawing_moves_while_it_is_planned() {
    long_drawing
    machine early --speed fast --halt 200
    job=("$loft" stream "$tmp/long.loft" --port "$tmp/early"); drawing_on=early
    job+=(--json); stop_at 200 INT
    until_log early 'asked to hold'; go_on early; wait $sender
    [ $? = 75 ] || job_fails "exit code is not 75"
    says err 'held at item [0-9]*.*: the machine is stopped on the path at'
    # the number of items is not known yet
    lines "any(x['at'] != [0, 0, 0] and x['items'] is None for x in states)"
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & sender=$!
    until_file out 'resuming at item [1-9]'
    kill -INT $sender; wait $sender; says err 'held at item'
}
case_long_drawing_killed_goes_on() {
    # the same steps and the same duration as a run that was never cut off
    awk 'BEGIN { print "bspline 3"; for (i = 0; i < 60; i++) print i % 17, i * 7 % 19 }' \
        >"$tmp/more.loft"
    job=("$loft" stream "$tmp/more.loft" --feed 300 --accel 20000)
    run 0 "${job[@]}" --dry-run
    local planned
    planned=$(sed -n 's/.* \([0-9.]*\) s, [0-9]* spans.*/\1/p' "$tmp/out")
    machine calm --speed fast --once; run 0 "${job[@]}" --port "$tmp/calm"; gone "$machine"
    # each is rounded to 0.1 s
    sed -n 's/.* \([0-9.]*\) s machine time.*/\1/p' "$tmp/out" | awk -v p="$planned" '
        { exit !(p - $1 < 0.11 && $1 - p < 0.11) }' || job_fails "not $planned s: $(cat "$tmp/out")"
    machine cut --speed fast --halt 700,1500 --once; drawing_on=cut; job+=(--port "$tmp/cut")
    for tick in 700 1500; do cut_off $tick; done
    run 0 "${job[@]}"
    gone "$machine"
    says err '^resuming at item'
    says out 'as commanded$'
    counted cut
    same_path cut calm
}
case_second_interrupt_leaves_at_once() {
    undisturbed
    machine left --speed fast --halt 1200 --once
    types left '#halted at tick 1200#^C #asked to hold#^C' sh -c "trap : INT
        '$loft' stream '$tmp/small.csv' --port '$tmp/left' --feed 60
        echo code \$?; stty -a"
    go_on left
    says out '^code 75'; says out 'left at once'; says out ' icanon'; says out ' echo '
    draws left
    run 0 "${job[@]}"
    gone "$machine"
    says err '^resuming at item'
    counted left
    same_path left calm
}
