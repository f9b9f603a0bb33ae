# tests/e2e/keys.sh -- keys, views and what a program is told
# SPDX-License-Identifier: MIT

case_hold_and_resume_by_key() {
    undisturbed
    machine keyed --speed real --once
    "$pty" type "$tmp/keyed.log" "1.2:h 2.2:r" "$loft" stream "$tmp/small.csv" --port "$tmp/keyed" \
        "${slowly[@]}" >"$tmp/out" 2>&1 || job_fails "exit code $?"
    gone "$machine"
    tr '\r' '\n' <"$tmp/out" >"$tmp/screen"
    says screen 'held, r resumes'
    says screen '%  [0-9]*:[0-9][0-9] left  feed  *[56][0-9]\.[0-9] mm/s  100 %  queue  *[0-9]*  X'
    says screen 'as commanded'
    counted keyed; same_path keyed calm
}
case_a_job_on_the_whole_terminal() {
    undisturbed
    machine viewed --speed real --once
    "$pty" type "$tmp/viewed.log" "1.2:h 2.4:s 3:r" "$loft" stream "$tmp/small.csv" --view \
        --port "$tmp/viewed" "${slowly[@]}" >"$tmp/out" 2>&1 || job_fails "exit code $?"
    gone "$machine"
    counted viewed; same_path viewed calm
    seen 'h hold  r resume  a abort'; seen '   pen '; seen 'queue'; seen '#'; seen '....'
    seen 'held, r resumes  X '; says after 'drawn: .*as commanded'
    draws viewed; one_line 64 'must be a terminal' "${job[@]}" --view
    one_line 64 'give both' "$loft" stream "$tmp/small.csv" --view --dry-run
}
case_the_whole_terminal_is_given_back() {   # by whatever ends the command
    local keys
    for keys in "1:^C" "1:^C 1.02:^C" "1:^\\" "1:a"; do
        rm -f "$tmp/taken.log"
        machine taken --speed real
        "$pty" type "$tmp/taken.log" "$keys" sh -c "trap : INT QUIT
            '$loft' stream '$tmp/small.csv' --view --port '$tmp/taken' --feed 60
            echo code \$?; stty -a" >"$tmp/out" 2>&1
        kill -9 "$machine"; gone "$machine"
        seen 'h hold'
        says after '^code '; says after ' icanon'; says after ' echo '; says after ' onlcr'
        case $keys in *a) says after '^code 75' ;; *C) says after '^code 75' ;; esac
    done
    machine lost --speed real
    (until_log lost ' begun'; sleep 1; kill -9 "$machine") &
    "$pty" type "$tmp/lost.log" "9:q" "$loft" stream "$tmp/small.csv" --view \
        --port "$tmp/lost" --feed 60 >"$tmp/out" 2>&1
    [ $? = 74 ] || job_fails "a lost machine: $(tail -c 200 "$tmp/out")"
    seen 'h hold'; says after 'loft: .*vanished'
}
case_a_program_is_told_in_json() {
    machine told --speed real
    draws told
    run 0 "${job[@]}" --json
    says err '^drawn: '
    lines "o[0]['event'] == 'job' and o[0]['curves'] == 7 and o[-1] == {'event': 'end', 'code': 0}"
    lines "len(states) > 20 and states[0]['part'] < 0.1 and states[-1]['part'] > 0.9"
    lines "[x['item'] for x in states] == sorted(x['item'] for x in states)"
    lines "max(x['feed'] for x in states) > 50 and {x['pen'] for x in states} == {'up', 'down'}"
    lines "all(x['override'] == 100 and len(x['at']) == 3 and 'queued' in x for x in states)"
    lines "states[-1]['items'] > 200 and abs(states[-1]['at'][0] - 60) < 1"
    "${job[@]}" --json >"$tmp/out" 2>"$tmp/err" & local sender=$!
    sleep 2.5; "$loft" stream --hold --port "$tmp/told" >/dev/null 2>&1
    kill -TERM $sender; wait $sender
    lines "o[-1] == {'event': 'end', 'code': 75}"
    run 0 "${job[@]}" --json
    lines "any(t.startswith('resuming at item') for t in told)"
    kill -9 "$machine"; gone "$machine"
    run 69 "${job[@]}" --json
    lines "o == [{'event': 'end', 'code': 69}]"
    run 0 "$loft" stream "$tmp/small.csv" --json --dry-run
    lines "len(o) == 2 and o[0]['seconds'] > 5 and o[0]['items'] > 200"
    one_line 64 'give one of them' "${job[@]}" --json --view
}
case_what_is_left_stays_while_held() {
    machine patient --speed real --once
    "$pty" type "$tmp/patient.log" "2:h 5.5:r" "$loft" stream "$tmp/small.csv" \
        --port "$tmp/patient" "${slowly[@]}" >"$tmp/out" 2>&1 || job_fails "exit code $?"
    gone "$machine"
    tr '\r' '\n' <"$tmp/out" | sed -n 's/.* \([0-9]*\):\([0-9]*\) left  held.*/\1 \2/p' >"$tmp/left"
    awk '{ s = 60 * $1 + $2; if (NR > 1 && s > was) exit 1; was = s } END { if (NR < 10) exit 1 }' \
        "$tmp/left" || job_fails "left while held: $(uniq -c "$tmp/left" | tr '\n' ',')"
}
case_a_wait_says_for_what() {
    machine stood --speed real --once
    "$pty" type "$tmp/stood.log" "0.8:h 4:r" env TERM=dumb "$loft" stream "$tmp/small.csv" \
        --port "$tmp/stood" "${slowly[@]}" >"$tmp/out" 2>&1 || job_fails "exit code $?"
    gone "$machine"
    says out 'waiting: the machine is held: .*--resume --port'
    says out 'as commanded'
    [ "$(grep -c 'waiting: ' "$tmp/out")" = 1 ] || job_fails "$(grep 'waiting: ' "$tmp/out")"
    machine asleep --speed real --once
    draws asleep; "${job[@]}" >"$tmp/out" 2>"$tmp/err" </dev/null & local sender=$!
    until_log asleep ' begun'
    sleep 0.5
    kill -STOP "$machine"
    sleep 4
    kill -CONT "$machine"
    wait $sender || job_fails "the sender ended with $?"
    gone "$machine"
    says err '^waiting: the machine does not answer: look at cable'
    says out 'as commanded$'
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    run 69 "$loft" stream --hold --port "$tmp/mute" --wait 2
    says err '^waiting: no machine has answered at .* yet: it is asked for 2 s$'
}
case_override_by_key() {
    undisturbed
    machine hurried --speed real --once
    "$pty" type "$tmp/hurried.log" \
        "0.8:+ 0.8:+ @ 120 %  queue@s @override 120 %@- 0:- 0:- 0:- @ 80 %  queue@0" "$loft" \
        stream "$tmp/small.csv" --port "$tmp/hurried" "${slowly[@]}" >"$tmp/out" 2>&1 \
        || job_fails "exit code $?"
    gone "$machine"
    tr '\r' '\n' <"$tmp/out" >"$tmp/screen"
    says screen ' 120 %  queue'
    says screen ' 80 %  queue'
    says screen 'override 120 %, feed'
    says screen 'as commanded'
    counted hurried; same_path hurried calm
}
case_abort_by_key() {
    machine aborted --speed real --once
    "$pty" type "$tmp/aborted.log" "1.2:a" "$loft" stream "$tmp/small.csv" --port "$tmp/aborted" \
        "${slowly[@]}" >"$tmp/out" 2>&1
    [ $? = 75 ] || job_fails "exit code is not 75"
    gone "$machine"
    says out 'aborted after [0-9]* of .*[0-9]* items: the machine is stopped on the path at'
    counted aborted
}
case_planning_is_seen() {               # on a terminal there is a bar, elsewhere nothing
    long_drawing
    echo ' begun' >"$tmp/any.log"
    "$pty" type "$tmp/any.log" "@planning@^C" "$loft" stream "$tmp/long.loft" \
        --dry-run >"$tmp/out" 2>&1
    tr '\r' '\n' <"$tmp/out" >"$tmp/screen"
    says screen '^\[.*%  [0-9-]*:[0-9-][0-9-] left  planning'
    interrupted 1.5 "$loft" stream "$tmp/long.loft" --dry-run
    ! grep -q planning "$tmp/err" || job_fails "$(cat "$tmp/err")"
}
case_reading_is_seen() {                # likewise; an error has a line of its own
    awk 'BEGIN { print "G21 G90 F900"; for (i = 1; i <= 60000; i++)
        printf "G1 X%d Y%d\n", i % 97, i % 89
        print "G1 Xq" }' >"$tmp/wrong.nc"
    echo ' begun' >"$tmp/any.log"
    "$pty" type "$tmp/any.log" "@reading@ " "$loft" stream "$tmp/wrong.nc" --dry-run \
        >"$tmp/out" 2>&1
    tr '\r' '\n' <"$tmp/out" >"$tmp/screen"
    says screen '^\[.*%  [0-9-]*:[0-9-][0-9-] left  reading'
    says screen 'wrong.nc:60002: '
    ! grep -q 'left  reading.*wrong' "$tmp/screen" || job_fails "$(cat "$tmp/screen")"
    one_line 65 'wrong.nc:60002: ' "$loft" stream "$tmp/wrong.nc" --dry-run
}
