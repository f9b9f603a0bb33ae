# tests/e2e/keys.sh -- keys, views and what a program is told
# SPDX-License-Identifier: MIT

case_hold_and_resume_by_key() {
    undisturbed
    machine keyed --speed fast --halt 1000 --once
    types keyed '#halted at tick 1000#. @left  feed@h #asked to hold#> @held, r resumes@r' \
        "$loft" stream "$tmp/small.csv" --port "$tmp/keyed" "${slowly[@]}" \
        || job_fails "exit code $?"
    gone "$machine"
    # which feed it shows depends on when this computer looks
    local feed='feed  *[0-9]*\.[0-9] mm/s  100 %  queue  *[0-9]*  X'
    says screen "%  [0-9-]*:[0-9-][0-9-] left  $feed"
    says screen 'as commanded'
    counted keyed; same_path keyed calm
}
case_a_job_on_the_whole_terminal() {
    undisturbed
    machine viewed --speed fast --halt 1200 --once
    types viewed '@h hold@. #halted at tick 1200#h #asked to hold#> ~held, r resumes~s
        ~held, r resumes  X ~^L @@r' \
        "$loft" stream "$tmp/small.csv" --view --port "$tmp/viewed" "${slowly[@]}" \
        || job_fails "exit code $?"
    gone "$machine"
    counted viewed; same_path viewed calm
    seen 'h hold  r resume  a abort'; seen '   pen '; seen 'queue'; seen '#'; seen '....'
    seen 'held, r resumes  X '; says after 'drawn: .*as commanded'
    draws viewed; one_line 64 'must be a terminal' "${job[@]}" --view
    one_line 64 'give one of them' "$loft" stream "$tmp/small.csv" --view --dry-run
}
case_the_whole_terminal_is_given_back() {   # by whatever ends the command
    local keys
    for keys in '^C #asked to hold#>' '^C #asked to hold#^C' '^\' 'a #asked to stop#>'; do
        machine taken --speed fast --halt 1000
        types taken "@h hold@. #halted at tick 1000#$keys" sh -c "trap : INT QUIT
            '$loft' stream '$tmp/small.csv' --view --port '$tmp/taken' --feed 60
            echo code \$?; stty -a"
        kill -9 "$machine"; gone "$machine"
        seen 'h hold'
        says after '^code '; says after ' icanon'; says after ' echo '; says after ' onlcr'
        case $keys in a*|^C*) says after '^code 75' ;; esac
    done
    machine lost --speed fast --halt 1000
    types lost '@h hold@. #halted at tick 1000#!' "$loft" stream "$tmp/small.csv" --view \
        --port "$tmp/lost" --feed 60
    [ $? = 74 ] || job_fails "a lost machine: $(tail -c 200 "$tmp/out")"
    seen 'h hold'; says after 'loft: .*vanished'
}
case_a_program_is_told_in_json() {
    local tick ticks sender
    run 0 "$loft" stream "$tmp/small.csv" "${slowly[@]}" --json --dry-run
    lines "len(o) == 2 and o[0]['seconds'] > 4 and o[0]['items'] > 200"
    ticks=$(sed -n 's/.*"seconds":\([0-9]*\)\.\([0-9]*\).*/\1\2/p' "$tmp/out")
    # where the pen is up, down, .., and near the end; then of a second job
    machine told --speed fast --halt 50,1000,2000,3000,4600,1100
    draws told
    "${job[@]}" --json >"$tmp/out" 2>"$tmp/err" & sender=$!
    for tick in 50 1000 2000 3000 4600; do
        halted told $tick
        until_file out "\"part\":$(awk -v t=$tick -v n="$ticks" 'BEGIN { printf "%.4f", t / n }'),"
        go_on told
    done
    wait $sender || job_fails "exit code $?"
    says err '^drawn: '
    lines "o[0]['event'] == 'job' and o[0]['curves'] == 7 and o[-1]['event'] == 'end'"
    lines "o[-1]['code'] == 0 and 0 < o[-1]['distance'] <= o[-1]['of'] and len(o[-1]['speed']) == 3"
    lines "0 < max(o[-1]['acceleration']) <= 1.005 and 0 < max(o[-1]['jerk']) <= 1.02"
    lines "len(states) >= 5 and states[0]['part'] < 0.1 and states[-1]['part'] > 0.9"
    lines "[x['item'] for x in states] == sorted(x['item'] for x in states)"
    lines "max(x['feed'] for x in states) > 50 and {x['pen'] for x in states} == {'up', 'down'}"
    lines "all(x['override'] == 100 and len(x['at']) == 3 and 'queued' in x for x in states)"
    lines "states[-1]['items'] > 200 and abs(states[-1]['at'][0] - 60) < 1"
    job+=(--json)
    stop_at 1100 TERM; until_log told 'asked to hold'; go_on told; wait $sender
    lines "o[-1] == {'event': 'end', 'code': 75}"
    run 0 "${job[@]}"
    lines "any(t.startswith('resuming at item') for t in told)"
    kill -9 "$machine"; gone "$machine"; rm -f "$tmp/told"  # its place may be another machine's
    run 69 "${job[@]}"
    lines "o == [{'event': 'end', 'code': 69}]"
    one_line 64 'give one of them' "${job[@]}" --view
}
case_what_is_left_stays_while_held() {
    machine patient --speed fast --halt 2000 --once
    local ten; ten=$(printf '@left  held@. %.0s' {1..10})
    types patient "#halted at tick 2000#h #asked to hold#> $ten @left  held@r" "$loft" stream \
        "$tmp/small.csv" --port "$tmp/patient" "${slowly[@]}" || job_fails "exit code $?"
    gone "$machine"
    sed -n 's/.*%  \([0-9:]*\)\( s\)* left  held.*/\1/p' "$tmp/screen" >"$tmp/left"
    awk -F: '{ s = NF > 1 ? 60 * $1 + $2 : $1; if (NR > 1 && s > was) exit 1; was = s }
             END { if (NR < 10) exit 1 }' "$tmp/left" \
        || job_fails "left while held: $(uniq -c "$tmp/left" | tr '\n' ',')"
}
silence_is_told() {     # the machine stands, also when something else lets it go on
    kill -STOP "$machine"
    grep -q '^waiting: the machine does not answer: look at cable' "$tmp/err"
}
case_a_wait_says_for_what() {
    local held='waiting: the machine is held: '
    machine stood --speed fast --halt 800 --once
    types stood "#halted at tick 800#h #asked to hold#> @$held@r" env TERM=dumb "$loft" stream \
        "$tmp/small.csv" --port "$tmp/stood" "${slowly[@]}" || job_fails "exit code $?"
    gone "$machine"
    says out 'waiting: the machine is held: .*--resume --port'
    says out 'as commanded'
    [ "$(grep -c "$held" "$tmp/out")" = 1 ] || job_fails "$(grep 'waiting: ' "$tmp/out")"
    machine asleep --speed fast --halt 500 --once
    draws asleep; "${job[@]}" >"$tmp/out" 2>"$tmp/err" </dev/null & local sender=$!
    halted asleep 500
    until_true silence_is_told || job_fails "nothing is told of a silence: $(cat "$tmp/err")"
    kill -CONT "$machine"
    go_on asleep
    wait $sender || job_fails "the sender ended with $?"
    gone "$machine"
    says out 'as commanded$'
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    run 69 "$loft" stream --hold --port "$tmp/mute" --wait 3
    says err '^waiting: no machine has answered at .* yet: it is asked for 3 s$'
}
case_override_by_key() {
    undisturbed
    machine hurried --speed fast --halt 800,1600,2400 --once
    # keys count from what was asked last, also if the machine has not said it yet
    types hurried "#halted at tick 800#+ @110 %@+ @ 120 %  queue@s @override 120 %@>
        #halted at tick 1600#- @@- @@- @@- @ 80 %  queue@> #halted at tick 2400#0 @100 %@>" \
        "$loft" stream "$tmp/small.csv" --port "$tmp/hurried" "${slowly[@]}" \
        || job_fails "exit code $?"
    gone "$machine"
    says screen 'override 120 %, feed'
    says screen 'as commanded'
    counted hurried; same_path hurried calm
}
case_abort_by_key() {
    machine aborted --speed fast --halt 1200 --once
    types aborted '#halted at tick 1200#a #asked to stop#>' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/aborted" "${slowly[@]}"
    [ $? = 75 ] || job_fails "exit code is not 75"
    gone "$machine"
    says out 'aborted after [0-9]* of .*[0-9]* items: the machine is stopped on the path at'
    counted aborted
}
case_planning_is_seen() {               # on a terminal there is a bar, elsewhere nothing
    long_drawing
    types none '@left  planning@^C' "$loft" stream "$tmp/long.loft" --dry-run
    says screen '^\[.*%  [0-9-]*:[0-9-][0-9-] left  planning'
    interrupted "$loft" stream "$tmp/long.loft" --dry-run
    ! grep -q 'left  planning' "$tmp/err" || job_fails "$(cat "$tmp/err")"
}
case_reading_is_seen() {                # likewise; an error has a line of its own
    awk 'BEGIN { print "G21 G90 F900"; for (i = 1; i <= 60000; i++)
        printf "G1 X%d Y%d\n", i % 97, i % 89
        print "G1 Xq" }' >"$tmp/wrong.nc"
    types none '@left  reading@.' "$loft" stream "$tmp/wrong.nc" --dry-run
    says screen '^\[.*%  [0-9-]*:[0-9-][0-9-] left  reading'
    says screen 'wrong.nc:60002: '
    ! grep -q 'left  reading.*wrong' "$tmp/screen" || job_fails "$(cat "$tmp/screen")"
    one_line 65 'wrong.nc:60002: ' "$loft" stream "$tmp/wrong.nc" --dry-run
}
