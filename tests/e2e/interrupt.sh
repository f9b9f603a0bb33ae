# tests/e2e/interrupt.sh -- interrupts
# SPDX-License-Identifier: MIT

case_interrupt_holds_and_the_same_command_goes_on() {
    undisturbed
    machine stopped --speed real --once
    "$pty" type "$tmp/stopped.log" "1.2:^C" "$loft" stream "$tmp/small.csv" --port "$tmp/stopped" \
        "${slowly[@]}" >"$tmp/out" 2>&1
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
    interrupted 1.5 "$loft" stream "$tmp/long.loft" --dry-run
    says err '^loft: stopped: nothing was sent$'; is_empty out
    interrupted 0.4 "$loft" stream "$tmp/long.loft" --port "$tmp/idle"
    says err '^loft: stopped'; is_empty out
    run 0 "$loft" ports "$tmp/idle"; says out '	idle'
}
case_long_drawing_moves_while_it_is_planned() {
    long_drawing
    machine early --speed real
    "$loft" stream "$tmp/long.loft" --port "$tmp/early" >"$tmp/out" 2>"$tmp/err" &
    local sender=$! ticks
    until_log early ' begun'
    ticks=$(awk '{ print $14 + $15 }' /proc/$sender/stat)
    # 2 s of work; the sanitized command takes three times as long
    [ "$ticks" -lt $((6 * $(getconf CLK_TCK))) ] || job_fails "moved after $ticks ticks of work"
    sleep 1; kill -INT $sender; wait $sender; [ $? = 75 ] || job_fails "exit code is not 75"
    says err 'held at item [0-9]*.*: the machine is stopped on the path at'
    "$loft" stream "$tmp/long.loft" --port "$tmp/early" >"$tmp/out" 2>"$tmp/err" & sender=$!
    for _ in $(seq 3000); do
        grep -q "^resuming at item [1-9]" "$tmp/err" && break
        sleep 0.02
    done
    says err "^resuming at item [1-9]"
    sleep 1; kill -INT $sender; wait $sender; says err 'held at item'
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
    machine cut --speed real --once; drawing_on=cut; job+=(--port "$tmp/cut")
    for pause in 0.7 0.4; do cut_off $pause; done
    run 0 "${job[@]}"
    gone "$machine"
    says err '^resuming at item'
    says out 'as commanded$'
    counted cut
    same_path cut calm
}
case_second_interrupt_leaves_at_once() {
    undisturbed
    machine left --speed real --once
    "$pty" type "$tmp/left.log" "1.2:^C 1.22:^C" sh -c "trap : INT
        '$loft' stream '$tmp/small.csv' --port '$tmp/left' --feed 60
        echo code \$?; stty -a" >"$tmp/out" 2>&1
    says out '^code 75'; says out 'left at once'; says out ' icanon'; says out ' echo '
    draws left
    run 0 "${job[@]}"
    gone "$machine"
    says err '^resuming at item'
    counted left
    same_path left calm
}
