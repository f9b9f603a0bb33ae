#!/bin/bash
# tests/e2e/e2e.sh -- tests whole jobs: the command, a pseudo terminal, the simulated machine,
# counted pulses
# SPDX-License-Identifier: MIT
# usage: tests/e2e/e2e.sh LOFT PLAIN HELPERS [CASE..] ; HELPERS contains pty and shim.so. LOFT may
# be sanitized, PLAIN is what users have: memory is measured with it. Each case prints one line; the
# last line is the sum.
# The cases mostly wait for machines in real time, so several run at once, each in a folder of its
# own ($tmp).
set -u
loft=$1 plain=$2 pty=$3/pty shim=$3/shim.so; shift 3
top=$(mktemp -d)
trap 'rm -rf "$top"' EXIT
# they keep their tables until the program ends
printf 'leak:%s.so\n' libfontconfig libncurses libtinfo >"$top/leaks"
export LSAN_OPTIONS=suppressions=$top/leaks:print_suppressions=0


# --- building blocks of the cases -----------------------------------------------------------------

# A heart, a wave and a line: 7 curves, with corners, pen lifts and a very short one.
cat >"$top/small.csv" <<'CSV'
10,10,10,20,25,25,30,15
30,15,35,25,50,20,50,10
50,10,50,0,35,-5,30,-10
30,-10,25,-5,10,0,10,10
5,30,15,45,25,15,35,30
35,30,35.003,30.001,35.006,30.001,35.01,30
60,0,60,10,60,20,60,30
CSV

job_fails() { why="$why; $*"; }

# machine NAME OPTIONS..: a simulated machine behind $tmp/NAME, its pulses in $tmp/NAME.csv
machine() {
    local name=$1; shift
    "$loft" simulate --link "$tmp/$name" --record "$tmp/$name.csv" "$@" >"$tmp/$name.log" 2>&1 &
    machine=$!; children+=("$machine"); disown "$machine"
    wait_for "$tmp/$name"
}
# a busy computer may take up to a minute
wait_for() {
    for _ in $(seq 3000); do
        [ -e "$1" ] && return
        sleep 0.02
    done
    job_fails "$1 did not appear"
}
gone() {
    for _ in $(seq 3000); do
        kill -0 "$1" 2>/dev/null || return
        sleep 0.02
    done
    job_fails "process $1 did not end"
    kill -9 "$1"
}
until_log() {
    for _ in $(seq 3000); do
        grep -q "$2" "$tmp/$1.log" && return
        sleep 0.02
    done
    job_fails "the machine never said: $2"
}

# until_rest MACHINE: each job that it has begun is over, 0.2 s later as well
until_rest() {
    local log=$tmp/$1.log still=0
    for _ in $(seq 3000); do
        still=$((still + 1))
        [ "$(grep -c ' begun' "$log")" = "$(grep -cE 'aborted|done' "$log")" ] || still=0
        [ $still -lt 11 ] || return 0
        sleep 0.02
    done
    job_fails "the machine never came to rest"
}

# run CODE COMMAND..: standard output to $tmp/out, standard error to $tmp/err; the exit code must
# be CODE
run() {
    local want=$1 got; shift
    timeout 200 "$@" >"$tmp/out" 2>"$tmp/err" </dev/null; got=$?
    [ "$got" = "$want" ] || job_fails "exit code $got, not $want: $(head -c 300 "$tmp/err")"
}
# interrupted SECONDS COMMAND..: after that time, once; timeout tells its group as well otherwise
interrupted() {
    timeout --foreground -s INT "$@" >"$tmp/out" 2>"$tmp/err"
    [ $? = 124 ] || job_fails "it was not planning any more"
}
says() { grep -q -- "$2" "$tmp/$1" || job_fails "does not say \`$2\`: $(tail -c 300 "$tmp/$1")"; }
# is_empty FILE: it has no lines except those about waiting on a busy computer
is_empty() {
    ! grep -qv '^waiting: ' "$tmp/$1" || job_fails "says: $(head -c 200 "$tmp/$1")"
}

# one_line CODE PATTERN COMMAND..: the error has exactly one line, with the key word of the remedy
one_line() {
    local code=$1 pattern=$2; shift 2
    run "$code" "$@"
    [ "$(wc -l <"$tmp/err")" = 1 ] || job_fails "$(wc -l <"$tmp/err") lines: $(cat "$tmp/err")"
    grep -q '^loft: ' "$tmp/err" || job_fails "no \`loft:\`: $(cat "$tmp/err")"
    says err "$pattern"
}

# the machine's own count: the last pulse of the record, against `steps X Y Z` in $tmp/out
counted() {
    local said record
    said=$(sed -n 's/.*steps \(-\?[0-9]* -\?[0-9]* -\?[0-9]*\).*/\1/p' "$tmp/${2:-out}" | head -1)
    record=$(grep -v '^#\|^slot' "$tmp/$1.csv" | tail -1 | cut -d, -f2- | tr ',' ' ')
    [ -n "$said" ] && [ "$said" = "${record:-0 0 0}" ] \
        || job_fails "said steps \`$said\`, the pulses led to \`$record\`"
}

# the sequence of steps of each axis, without their times
path_of() {
    awk -F, '!/^#/ && $1 != "slot" {
                 for (i = 2; i <= NF; i++)
                     if ($i != last[i]) { last[i] = $i; row[i] = row[i] " " $i }
             }
             END { for (i = 2; i <= 4; i++) print row[i] }' "$tmp/$1.csv" | cksum
}
same_path() {
    [ "$(path_of "$1")" = "$(path_of "$2")" ] \
        || job_fails "the steps differ from an undisturbed run"
}
undisturbed() {         # the reference: $tmp/calm.csv
    machine calm --speed fast --once
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/calm" "${slowly[@]}"; gone "$machine"
}
slowly=(--feed 60)      # the job lasts about 6 s of machine time
# draws MACHINE: set ${job[@]}
draws() { drawing_on=$1; job=("$loft" stream "$tmp/small.csv" --port "$tmp/$1" "${slowly[@]}"); }
# cut_off SECONDS: kill ${job[@]} without warning, SECONDS after the machine has begun
cut_off() {
    "${job[@]}" >/dev/null 2>&1 & local sender=$!
    disown $sender
    until_log "$drawing_on" ' begun'
    sleep "$1"
    kill -9 $sender || job_fails "the sender ended before it could be killed"
    gone $sender
}
cut_off_when_sent() {   # the same, as soon as the machine has accepted the last item
    "${job[@]}" --log "$tmp/talk.log" >/dev/null 2>&1 & local sender=$!
    disown $sender
    wait_for "$tmp/talk.log"
    until_log talk '< .* all'
    kill -9 $sender || job_fails "the sender ended before it could be killed"
    gone $sender
}


# --- jobs -----------------------------------------------------------------------------------------

exactly() {     # exactly MACHINE PLANNER OPTIONS..
    local m=$1 p=$2; shift 2
    machine "m$m$p" --speed fast --once --num "$m" --steps 320 --slots 80
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/m$m$p" --num "$p" --record "$tmp/m$m$p.csv" \
        "$@"
    gone "$machine"
    is_empty err; says out '^drawn: 7 curves, .*as commanded$'; says out '^line: '; counted "m$m$p"
    local worst; worst=$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")
    # the tolerance, plus on each axis half a step for the position at a tick and half a step for
    # the slots between
    awk -v w="$worst" 'BEGIN { exit !(w != "" && w <= 0.005 + sqrt(2) / 320 && w > 0) }' \
        || job_fails "worst path error \`$worst\`"
}
case_exact_q16()        { exactly q16 q16; }
case_exact_f32()        { exactly f32 f32; }
case_exact_f64()        { exactly f64 f64; }
case_exact_mixed()      { exactly f32 q16; exactly q16 f64; }
case_points()           { exactly q16 f32 --points; }
case_noisy_line()       {
    machine noisy --speed fast --once --noise 30
    draws noisy; run 0 "${job[@]}"; gone "$machine"; undisturbed
    says out 'as commanded$'; counted noisy; same_path noisy calm
}
case_two_jobs_and_park() {
    machine twice --speed fast
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice"
    says out 'steps 4800 2400 80 as commanded'
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice"
    says out 'steps 4800 2400 80 as commanded'
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice" --park
    says out 'steps 0 0 0 as commanded'
    kill "$machine"; gone "$machine"; counted twice
}
case_each_of_two_jobs_is_measured_alone() {
    printf '70,0,70,30,90,30,90,0\n' >"$tmp/arch.csv"
    machine both --speed fast
    for d in small arch; do
        run 0 "$loft" stream "$tmp/$d.csv" --port "$tmp/both" --record "$tmp/both.csv"
        says out 'as commanded$'
        awk '{ for (i = 1; i < NF; i++)
                   if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 80) exit 1 }' "$tmp/out" ||
            job_fails "$d: $(cat "$tmp/out")"
    done
    run 0 "$loft" plot "$tmp/arch.csv" --record "$tmp/both.csv" -o "$tmp/both.png"
    says out 'path error 0.0[01]'
}
case_dense_curves_at_115200_baud() {
    awk 'BEGIN { for (i = 0; i < 150; i++) { s = i % 2 ? 0.15 : -0.15
                 printf "%g,20,%g,%g,%g,%g,%g,20\n",
                     x + 20, x + 20.2, 20 + s, x + 20.3, 20 - s, x + 20.5
                 x += 0.5 } }' >"$tmp/squiggle.csv"
    machine dense --speed real --once
    "$pty" relay "$tmp/slow" "$tmp/dense" 115200 & children+=($!); disown $!
    wait_for "$tmp/slow"
    run 0 "$loft" stream "$tmp/squiggle.csv" --port "unix:$tmp/slow" --feed 60
    gone "$machine"
    counted dense
    # the machine took no longer than planned: the line has fed it in time
    local planned took
    read -r planned took < <(sed -n \
        's/.* done: .* items, \([0-9]*\) ticks in \([0-9.]*\) s.*/\1 \2/p' "$tmp/dense.log")
    awk -v p="$planned" -v t="$took" 'BEGIN { exit !(p > 4000 && 1000 * t - p < 500) }' \
        || job_fails "$planned ticks took $took s"
    awk '/^line/ { exit !($0 ~ / of 115200 baud/) }' "$tmp/out" \
        || job_fails "no share of the line: $(cat "$tmp/out")"
}
case_demo() {
    run 0 host-tools/demo.sh draw "$loft" "$tmp/small.csv" "$tmp/demo"
    says out 'worst path error 0.00[0-9]* mm, steps 19200 9600 320 as commanded$'
    says out "^picture: $tmp/demo/drawn.png"
    [ "$(head -c 4 "$tmp/demo/drawn.png" | tail -c 3)" = PNG ] || job_fails "no picture"
    one_line 64 '--tol: give --record FILE as well' "$loft" plot tests/drawings/demo.svg --tol 1
    printf '%s\n' 0,0,3,0,6,0,9,0 9,0,9,3,9,6,9,9 >"$tmp/corners.csv"
    run 0 "$loft" plot "$tmp/corners.csv" --record "$tmp/demo/pulses.csv" --tol 0.005 \
        -o "$tmp/corner.svg"
    says out ', inset: corner at 9.000,0.000$'
    one_line 66 'no such file' host-tools/demo.sh draw "$loft" "$tmp/none.svg" "$tmp/demo2"
}
case_from_a_pipe()      {
    machine pipe --speed fast --once
    run 0 sh -c "cat '$tmp/small.csv' | '$loft' stream - --port '$tmp/pipe'"
    gone "$machine"
    counted pipe
}
case_through_a_socket() {
    machine behind --speed fast --once
    "$pty" relay "$tmp/socket" "$tmp/behind" & children+=($!); disown $!
    wait_for "$tmp/socket"
    run 0 "$loft" stream "$tmp/small.csv" --port "unix:$tmp/socket"; counted behind
}
case_through_standard_streams() {
    machine std --speed fast --once
    run 0 sh -c "'$loft' stream '$tmp/small.csv' --port - <'$tmp/std' >'$tmp/std' 2>'$tmp/said'"
    gone "$machine"
    says said 'as commanded$'; counted std said
}
case_through_libserialport() {
    local serial=(env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD="$shim" "$loft" stream \
        "$tmp/small.csv" "${slowly[@]}")
    machine serial --speed fast --once
    run 0 "${serial[@]}" --port "$tmp/serial"; gone "$machine"; counted serial; is_empty err
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    one_line 69 'at 57600 baud: no machine answered' "${serial[@]}" --port "$tmp/mute" --wait 0.3 \
        --baud 57600
    machine unplugged --speed real
    { until_log unplugged " begun"; sleep 0.7; kill -9 "$machine"; } & children+=($!)
    one_line 74 'the port has vanished at item [0-9]* of' "${serial[@]}" --port "$tmp/unplugged"
}


chip_draws() {
    drawing_on=$1
    job=("$loft" stream "$tmp/small.csv" --port "$tmp/$1" "${slowly[@]}" --plan chip)
}
case_planned_here_or_there() {      # the same drawing: the same end, path, and time
    for m in q16 f32; do
        for where in host chip; do
            machine "at-$where" --speed fast --once --num $m --steps 320 --slots 80
            run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/at-$where" --plan=$where \
                --record "$tmp/at-$where.csv" --log "$tmp/at-$where.log"
            gone "$machine"
            is_empty err
            says out '^drawn: 7 curves, .*as commanded$'
            counted "at-$where"
            cp "$tmp/out" "$tmp/at-$where.out"
            awk '{ for (i = 1; i < NF; i++)
                       if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 320) exit 1 }' "$tmp/out" ||
                job_fails "$(cat "$tmp/out")"
        done
        [ "$(tail -1 "$tmp/at-host.csv" | cut -d, -f2-)" = \
            "$(tail -1 "$tmp/at-chip.csv" | cut -d, -f2-)" ] || job_fails "$m: another end"
        local took
        took=$(sed -n 's/.* m, \([0-9.]*\) s machine time.*/\1/p' "$tmp"/at-*.out \
            | sort -u | tr '\n' ' ')
        # on the machine, curves arrive during the planning, in other portions: at most 2 % was
        # measured (f32)
        awk -v t="$took" 'BEGIN { split(t, a, " "); b = a[2] ? a[2] : a[1]
                                  exit !(b <= 1.02 * a[1] + 0.11) }' || job_fails "$m: $took s"
        # frames of curves, each counted once: the number of status requests depends on the duration
        awk '$2 == ">" && $3 == "CURVES" && !seen[$7]++ { curves += $11; bytes += $12 }
             END { exit !(curves == 17 && bytes > 0 && bytes < 204) }' \
            "$tmp/at-chip.log" || job_fails "$m: $(grep CURVES "$tmp/at-chip.log")"
    done
}
case_planned_there_over_a_noisy_line() {
    machine noisy --speed fast --once --noise 60 --curves 8
    chip_draws noisy; run 0 "${job[@]}"; gone "$machine"; counted noisy; says out 'as commanded$'
}
case_planned_there_and_killed() {
    machine killed --speed real --once
    chip_draws killed
    for pause in 0.7 0.4; do cut_off $pause; done
    run 0 "$loft" stream --hold --port "$tmp/killed"
    says out '^held: [0-9]* items executed'
    one_line 75 'another job' "$loft" stream "$tmp/small.csv" --port "$tmp/killed" "${slowly[@]}" \
        # the same drawing, but another job
    run 0 "$loft" stream --resume --port "$tmp/killed"
    run 0 "${job[@]}" --record "$tmp/killed.csv"
    gone "$machine"
    says err '^resuming at item'
    says out 'as commanded$'
    counted killed
    awk '{ for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 80) exit 1 }' \
        "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_planned_there_and_aborted() {
    machine ended --speed real --once
    chip_draws ended; cut_off 1
    run 0 "$loft" stream --abort --port "$tmp/ended"
    gone "$machine"
    says out '^aborted: [0-9]* items'
    counted ended
}
case_a_machine_that_does_not_plan() {
    machine plain --speed fast --curves 0
    one_line 78 'does not plan by itself: give --plan host' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/plain" --plan chip
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/plain"; says out 'as commanded$'
    machine able --speed fast
    one_line 64 'give host or chip' "$loft" stream "$tmp/small.csv" --port "$tmp/able" --plan moon
    one_line 64 'takes curves'      "$loft" stream "$tmp/small.csv" --port "$tmp/able" --plan chip \
        --points
    run 0 "$loft" stream "$tmp/small.csv" --plan chip --dry-run; says out ' 17 curves, path within'
}


# --- disturbances ---------------------------------------------------------------------------------

case_killed_and_run_again() {
    undisturbed
    machine killed --speed real --once
    draws killed
    for pause in 0.7 0.4 1.1; do cut_off $pause; done
    run 0 "${job[@]}"; gone "$machine"
    says err '^resuming at item [0-9]*\( of \(about \)\?[0-9]*\)\?$'
    says out 'as commanded$'
    counted killed
    same_path killed calm
}
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
# seen WORD: the whole terminal showed it, then was given back; $tmp/after is what came then
seen() {
    grep -qF -- "$1" "$tmp/out" || job_fails "the view does not show \`$1\`"
    sed -z 's/.*\x1b\[?1049l//' "$tmp/out" >"$tmp/after"
    grep -q $'\x1b\[?1049h' "$tmp/out" && ! cmp -s "$tmp/out" "$tmp/after" \
        || job_fails "the terminal was not taken, or not given back"
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
# lines EXPRESSION: of the objects `o` in $tmp/out, by their events; each line is one object
lines() {
    python3 - "$tmp/out" "$1" <<'PY' || job_fails "not so: $1: $(tail -2 "$tmp/out")"
import json, sys
o = [json.loads(line) for line in open(sys.argv[1])]
states = [x for x in o if x['event'] == 'state']
told = [x['text'] for x in o if x['event'] == 'line']
sys.exit(not eval(sys.argv[2]))
PY
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
case_a_job_begins_free_of_a_hold_before_it() {
    machine again --speed real
    draws again; cut_off 1
    run 0 "$loft" stream --hold --port "$tmp/again"
    until_log again held
    run 0 "$loft" stream --abort --port "$tmp/again"
    run 0 timeout 60 "$loft" stream "$tmp/small.csv" --port "$tmp/again" --feed 200
    says out 'as commanded$'
    is_empty err
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
# more than half a minute of planning
long_drawing() {
    awk 'BEGIN { print "bspline 3"; for (i = 0; i < 30000; i++) print i % 97, i * 7 % 89 }' \
        >"$tmp/long.loft"
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
# peak COMMAND..: run it, and append the most memory that it had, in kB, to most[]
peak() {
    run 0 python3 -c 'import resource, subprocess, sys
code = subprocess.run(sys.argv[1:]).returncode
print("most", resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
sys.exit(code)' "$@"
    most+=("$(sed -n 's/^most //p' "$tmp/out")")
}
long_rows() {                           # long_rows N: each takes 13 s at 15 mm/s
    awk -v n="$1" 'BEGIN { for (i = 0; i < n; i++) {
            a = i % 2 ? 200 : 0
            printf "%g,%g,%g,%g,%g,%g,%g,%g\n",
                a, i / 9, a, i / 9, 200 - a, i / 9, 200 - a, i / 9
        } }' >"$tmp/rows.csv"
}
case_memory_of_a_long_job() {           # 800 thousand points, each of which took 48 bytes
    local most=()
    for rows in 10 60; do
        long_rows $rows
        machine "rows$rows" --speed fast --once
        peak "$plain" stream "$tmp/rows.csv" --feed 15 --points --port "$tmp/rows$rows"
        gone "$machine"; says out 'as commanded$'
    done
    # 131072 items are kept at most
    [ $((most[1] - most[0])) -lt 12000 ] || job_fails "${most[*]} kB"
}
case_memory_of_a_long_plan() {          # 6 more minutes of motion, each of which took 1600 kB
    local most=()
    for rows in 6 30; do
        long_rows $rows
        peak "$plain" plan "$tmp/rows.csv" --feed 15 --jerk 0 --spans -o "$tmp/spans.csv"
        [ "$(wc -l <"$tmp/spans.csv")" -gt $((50 * rows)) ] || job_fails "spans are missing"
    done
    [ $((most[1] - most[0])) -lt 2048 ] || job_fails "${most[*]} kB"
}
case_memory_of_a_long_program() {       # each line took 300 bytes
    local what most
    for what in "plan --total" "stream --dry-run"; do
        most=()
        for lines in 30000 100000; do
            awk -v n=$lines 'BEGIN { print "G21 G90\nG0 X50 Y0\nF18000"
                for (i = 1; i <= n; i++)
                    printf "G1 X%.5f Y%.5f\n", 50 * cos(i / 1000), 50 * sin(i / 1000)
                print "M30" }' >"$tmp/long.nc"
            # shellcheck disable=SC2086
            peak "$plain" $what "$tmp/long.nc" --feed 300 --accel 30000 --jerk 0
        done
        [ $((most[1] - most[0])) -lt 2048 ] || job_fails "$what: ${most[*]} kB"
    done
    most=()                             # lines that stay lines: each took 300 bytes more
    for lines in 20000 200000; do
        awk -v n=$lines 'BEGIN { print "G21 G90\nG0 X50 Y0\nF18000"
            for (i = 1; i <= n; i++)
                printf "G1 X%d Y%d\n", i % 2 * 2, i % 97
            print "M30" }' >"$tmp/hatch.nc"
        peak "$plain" stream --grbl --dry-run "$tmp/hatch.nc"
        [ "$(wc -l <"$tmp/out")" -gt $lines ] || job_fails "lines are missing"
    done
    [ $((most[1] - most[0])) -lt 4096 ] || job_fails "lines: ${most[*]} kB"
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
case_control_from_another_run() {
    undisturbed
    machine told --speed real --once
    draws told; cut_off 1
    run 0 "$loft" stream --hold --port "$tmp/told"; says out '^held: '
    run 0 "$loft" stream --resume --port "$tmp/told"; says out '^resumed: '
    run 0 "$loft" stream --hold --port "$tmp/told"
    one_line 75 'another job' "$loft" stream "$tmp/small.csv" --port "$tmp/told" --feed 10
    run 0 "${job[@]}"; gone "$machine"; counted told; same_path told calm
}
case_a_closed_limit_ends_a_job_and_lets_none_begin() {
    printf '20,10,18,10,16,10,14,10\n' >"$tmp/back.csv"
    for m in q16 f64; do
        machine $m --speed fast --num $m --limits x+=40,y-=-300
        local ended='the limit switch of x at its high end closed and ended the job after'
        one_line 75 "$ended [0-9]* of .*[0-9]* items: .* at [34][0-9]\..*--away" \
            "$loft" stream "$tmp/small.csv" --port "$tmp/$m"; counted $m err
        run 0 "$loft" ports "$tmp/$m"; says out '	closed: the limit switch of x at its high end$'
        for how in "" --points "--plan chip"; do
            one_line 69 'the limit switch of x at its high end is closed: move away .*--away' \
                "$loft" stream "$tmp/back.csv" --port "$tmp/$m" $how
        done
        run 0 "$loft" stream "$tmp/back.csv" --port "$tmp/$m" --away --log "$tmp/$m.talk"
        says out 'as commanded$'
        says $m.talk 'away inputs 0002'
        run 0 "$loft" stream "$tmp/back.csv" --port "$tmp/$m"; says out 'as commanded$'; counted $m
    done
    for bad in x=3 x-=y q+=3 x+=1e9 x+=3y x+=3nd; do
        one_line 64 'limits .*give axis, end and mm' "$loft" simulate --limits $bad
        one_line 64 'walls .*give axis, end and mm' "$loft" simulate --walls $bad
    done
    one_line 64 'probe z-=3nc: give axis, end and mm' "$loft" simulate --probe z-=3nc
}
case_a_wall_stops_the_tool_but_not_the_count() {
    printf '0,0,10,0,20,0,30,0\n' >"$tmp/right.csv"
    machine wall --speed fast --walls x+=20 --once      # 10 mm of 80 steps are lost
    run 0 "$loft" stream "$tmp/right.csv" --port "$tmp/wall"
    says out 'steps 2400 0 80 as commanded$'
    gone "$machine"; counted wall
    says wall.log '^table: the tool is at 20.0000 0.0000 1.0000, 800 steps lost$'
    printf 'kinematics = corexy\n' >"$tmp/corexy.txt"   # walls are of the tool, steps of the motors
    machine cross --speed fast --walls y-=-3 --once --machine "$tmp/corexy.txt"
    printf '0,0,0,-4,0,-8,0,-12\n' >"$tmp/down.csv"
    run 0 "$loft" stream "$tmp/down.csv" --port "$tmp/cross" --machine "$tmp/corexy.txt"
    gone "$machine"
    says cross.log '^table: the tool is at 0.0000 -3.0000 1.0000, 1440 steps lost$'
    # a switch that bounces for 20 ms ends the job once; one that opens there is closed before
    machine jumpy --speed fast --limits x+=20 --bounce 20
    one_line 75 'the limit switch of x at its high end closed and ended' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/jumpy"
    one_line 69 'the limit switch of x at its high end is closed: move away' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/jumpy"
    machine wired --speed fast --limits x+=20nc
    one_line 69 'the limit switch of x at its high end is closed: move away' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/wired"
}
case_park_after_an_abort() {
    machine parked --speed real
    draws parked
    cut_off 1
    run 0 "$loft" stream --abort --port "$tmp/parked"
    says out '^aborted: '
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/parked" --feed 200 --park
    says out 'steps 0 0 0 as commanded$'
}
case_abort_from_another_run() {
    machine ended --speed real --once
    draws ended; cut_off 1
    run 0 "$loft" stream --abort --port "$tmp/ended"
    gone "$machine"
    says out '^aborted: '
    counted ended
    machine idle --speed fast
    one_line 69 'no job is running' "$loft" stream --hold --port "$tmp/idle"
}
case_report_is_fetched_later() {
    machine later --speed real
    # few enough items for the queue to hold them all
    draws later; job+=(--jerk 0); cut_off_when_sent; until_log later done
    run 0 "${job[@]}"; says err 'was drawn already'; counted later
    cp "$tmp/out" "$tmp/first"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/later" --feed 200
    says out 'as commanded$'
    is_empty err
}
case_another_job_after_a_lost_one() {
    machine other --speed real
    draws other; job+=(--jerk 0); cut_off_when_sent; until_log other done
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/other" --feed 200
    says out 'as commanded$'
    is_empty err
}
case_port_vanishes() {
    machine lost --speed real
    { until_log lost " begun"; sleep 0.7; kill -9 "$machine"; } & children+=($!)
    one_line 74 'the port has vanished at item [0-9]* of' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/lost" --feed 20
    # those that it had executed after 0.7 of 18 s; all of them had been sent
    sed 's/.* item \([0-9]*\) of \(about \)\?\([0-9]*\) .*/\1 \3/' "$tmp/err" |
        awk '{ exit !($1 * 2 < $2) }' || job_fails "not the items executed: $(cat "$tmp/err")"
}
case_machine_restarts_in_mid_job() {
    machine again --speed real
    "$pty" relay "$tmp/line" "$tmp/again" & children+=($!); disown $!
    wait_for "$tmp/line"
    { until_log again " begun"; sleep 0.7; kill -9 "$machine"; rm -f "$tmp/again"
        exec "$loft" simulate --link "$tmp/again" >/dev/null 2>&1; } & children+=($!)
    one_line 76 'restarted in the middle of the job: home it' "$loft" stream "$tmp/small.csv" \
        --port "unix:$tmp/line" "${slowly[@]}"
}
case_second_sender_is_refused() {
    machine owned --speed real --once
    draws owned; "${job[@]}" >/dev/null 2>&1 & local sender=$!
    until_log owned " begun"
    one_line 69 'another program talks to it' "$loft" stream "$tmp/small.csv" --port "$tmp/owned"
    wait $sender || job_fails "the first sender ended with $?"
    gone "$machine"
}
case_machine_talks_nonsense() {
    "$pty" noise "$tmp/noise" & children+=($!); disown $!
    wait_for "$tmp/noise"
    one_line 76 'no good frame' "$loft" stream "$tmp/small.csv" --port "$tmp/noise" --wait 1
}
case_machine_is_mute() {
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    one_line 69 'no machine answered in 0.5 s' "$loft" stream "$tmp/small.csv" --port "$tmp/mute" \
        --wait 0.5
}


case_export() {                         # the same drawing by way of each form
    local form
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="50mm" viewBox="0 0 90 50">
            <path d="M5 5h20C40 5 40 25 25 25z"/><circle cx="60" cy="25" r="12"/></svg>' \
        >"$tmp/export.svg"
    run 0 "$loft" export "$tmp/export.svg" --as csv; cp "$tmp/out" "$tmp/want.csv"
    for form in svg csv loft; do
        run 0 "$loft" export "$tmp/export.svg" -o "$tmp/again.$form"; is_empty err
        run 0 "$loft" export "$tmp/again.$form" --as csv
        paste -d, "$tmp/want.csv" "$tmp/out" | awk -F, 'NR > 1 {
            for (i = 1; i <= 8; i++) if (($i - $(i + 8)) ^ 2 > 1e-11) exit 1 }
            END { exit NR < 5 }' || job_fails "by way of .$form the curves differ"
    done
    run 0 "$loft" plan --total "$tmp/export.svg"
    local drawn; drawn=$(awk '$1 == "drawn" { print $2 }' "$tmp/out")
    for form in arcs g5 lines; do
        run 0 "$loft" export "$tmp/export.svg" --curves $form -o "$tmp/again.nc"; is_empty err
        run 0 "$loft" plan --total "$tmp/again.nc"
        awk -v want="$drawn" '$1 == "drawn" && ($2 - want) ^ 2 < 0.05 ^ 2 { good = 1 }
            END { exit !good }' "$tmp/out" || job_fails "as $form: $(cat "$tmp/out")"
    done
    one_line 64 '-o x.doc: give h, nc, svg' "$loft" export "$tmp/export.svg" -o x.doc
    one_line 64 '--curves x: give arcs, g5 or lines' "$loft" export "$tmp/export.svg" --as nc \
        --curves x
    one_line 73 'cannot be written' "$loft" export "$tmp/export.svg" -o "$tmp/no/x.nc"
}

case_gcode() {                          # every place, and back: counted, and as commanded
    printf '%s\n' 'G21 G90' 'G0 Z1' 'G0 X10 Y10' 'G1 Z-1 F600' 'X20 F2400' 'G3 X30 Y20 R10' \
        'G5 I0 J5 P0 Q-5 X40 Y20' 'G2 X10 Y10 R20 Z-2' 'G0 Z0' 'M2' >"$tmp/part.nc"
    machine gcode --speed fast --once
    run 0 "$loft" stream "$tmp/part.nc" --port "$tmp/gcode"; gone "$machine"
    is_empty err; says out '^drawn: .*as commanded$'; counted gcode
    tail -1 "$tmp/gcode.csv" | awk -F, '$2 != 800 || $3 != 800 || $4 != 0 { exit 1 }' \
        || job_fails "it does not end at 10,10,0: $(tail -1 "$tmp/gcode.csv")"
    run 0 "$loft" plan --total "$tmp/part.nc"
    run 0 "$loft" plot -o "$tmp/part.png" "$tmp/part.nc"
}

case_gcode_tools() {                    # beside the path, with two tools; the second asks
    printf '%s\n' 'tool.1.diameter = 6' 'tool.2.diameter = 2' 'tool.2.pause = the small one' \
        >"$tmp/mills.txt"
    printf '%s\n' 'G21 G61' 'T1 M6' 'G0 X0 Y0' 'G41 D1' 'G1 X20 F3000' 'X40' 'Y20' 'G40' 'G1 X20' \
        'T2 M6' 'G42 G1 X10' 'X0' 'G40 Y0' 'M2' >"$tmp/mills.nc"
    machine mills --speed fast
    run 75 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" --port "$tmp/mills"
    says err 'tool 2 is next: the small one'
    printf '\n' | timeout 200 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" \
        --port "$tmp/mills" --from-tool 2 >"$tmp/out" 2>"$tmp/err" || job_fails 'it did not go on'
    says out '^drawn: .*as commanded$'
    run 0 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" --dry-run
    says out '^tool 1: planned: 4 curves'; says out '^tool 2: before it: the small one'
    one_line 78 'G61: a machine that plans does not stop' "$loft" stream "$tmp/mills.nc" \
        --machine "$tmp/mills.txt" --dry-run --plan chip
    one_line 65 'mills.nc:4: tool 1 has no diameter' "$loft" plan "$tmp/mills.nc"
}

case_a_spindle_a_wait_and_a_pause() {
    printf '%s\n' 'G21 G90 M3 S500' 'G1 X10 F600' 'G4 P0.5' 'Y10' '(MSG, turn it)' 'M0' 'M8' 'X0' \
        'M9' 'M30' >"$tmp/part.nc"
    printf 'spin_up = 2\n' >"$tmp/spin.txt"
    machine spin --speed fast --once
    # a sender that is killed in the pause, one that is stopped there, a resume, and the report
    "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt" 2>"$tmp/err" &
    local first=$!; children+=("$first"); disown "$first"
    until_log spin ' held: '; sleep 0.5
    kill -9 "$first"; gone "$first"
    says err '^pause: turn it: Enter goes on, a gives up$'
    run 0 "$loft" ports "$tmp/spin"; says out '	in a job, held: `loft stream --resume`'
    "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt" \
        >"$tmp/out" 2>"$tmp/err" </dev/null &
    first=$!; children+=("$first")
    for _ in $(seq 3000); do grep -q '^pause' "$tmp/err" && break; sleep 0.02; done
    kill -INT "$first"; wait "$first"
    [ $? = 75 ] || job_fails 'a pause that was left did not end with 75'
    says err '^pause: turn it: Enter goes on, a gives up$'
    run 0 "$loft" stream --resume --port "$tmp/spin"
    run 0 "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt"
    says out '^drawn: .*as commanded$'; gone "$machine"; counted spin
    # on at half power before the first pulse and spin_up, off at the end; the coolant for the last
    # line
    awk -F, '/^# output 1 = 32768 from/ { on = 1 } /^# output 2 = 65535/ { wet = $0 }
        /^# output 2 = 0 / { dry = 1 } /^# output 1/ { ones++ } /^[0-9]/ { if (!on) exit 1; n++ }
        n == 1 { first = $1 } END { exit !(ones == 2 && wet != "" && dry && first >= 80000) }' \
        "$tmp/spin.csv" || job_fails "$(grep output "$tmp/spin.csv")"
    [ "$(grep -c ' held: ' "$tmp/spin.log")" = 1 ] || job_fails 'it paused more than once'
    run 0 "$loft" stream "$tmp/part.nc" --dry-run --grbl
    words_of_it() { grep -E '^(M|G4)' "$tmp/out" | tr '\n' ' '; }
    [ "$(words_of_it)" = 'M3S500 G4P0.500 M0 M8 M9 ' ] || job_fails "as G-code: $(words_of_it)"
    run 0 "$loft" stream "$tmp/part.nc" --dry-run --points
    says err 'part.nc:1: M3, M4 or M5: the machine has no output for a spindle'
    says err 'part.nc:6: M0, M1 or M6: the machine does not stop there'
    run 0 "$loft" plan --total "$tmp/part.nc"
    says err 'part.nc:1: G4, M0, M3 and the like (5 times): the times are of motion without them'
    # as --dry-run does: 0.5 s of G4
    seconds_of() {
        run 0 "$loft" stream "$tmp/$1.nc" --dry-run
        sed -n 's/^planned: .* travelled, \([0-9.]*\) s,.*/\1/p' "$tmp/out"
    }
    sed 's/^G4.*/G4 P0/' "$tmp/part.nc" >"$tmp/brief.nc"
    awk -v a="$(seconds_of part)" -v b="$(seconds_of brief)" \
        'BEGIN { exit !(a - b > 0.35 && a - b < 0.65) }' || job_fails 'G4 is not in the time'
}

# a program of 1.1 MB, read in parts, whose events stand in its later ones
case_events_late_in_a_long_program() {
    awk 'BEGIN { print "G21 G90\nF18000"
        for (i = 1; i <= 40000; i++) {
            if (i == 20001) print "M3 S500\nG4 P0.25"
            if (i == 30001) print "M8"
            printf "G1 X%.5f Y%.5f\n", 50 * cos(i / 1000), 50 * sin(i / 1000)
        }
        print "M5" }' >"$tmp/late.nc"
    run 0 "$loft" stream "$tmp/late.nc" --dry-run --grbl --accel 30000 --jerk 0
    # each after the point that stands before it, the arcs around it end there
    grep -A1 'X20.4041Y45.6473' "$tmp/out" | grep -q '^M3S500$' || job_fails 'M3 elsewhere'
    grep -A1 '^M3S500' "$tmp/out" | grep -q '^G4P0.250$' || job_fails 'G4 elsewhere'
    grep -A1 'X7.7126Y-49.4016' "$tmp/out" | grep -q '^M8$' || job_fails 'M8 elsewhere'
    [ "$(tail -1 "$tmp/out")" = M5 ] || job_fails 'M5 is not at the end'
    # standard input is kept as a whole: the same words, the same job
    mv "$tmp/out" "$tmp/parts"
    whole() { "$loft" stream - --dry-run "$@" --accel 30000 --jerk 0 <"$tmp/late.nc" >"$tmp/out"; }
    whole --grbl || job_fails 'standard input was refused'
    cmp -s "$tmp/parts" "$tmp/out" || job_fails 'parts and the whole differ'
    run 0 "$loft" stream "$tmp/late.nc" --dry-run --accel 30000 --jerk 0
    mv "$tmp/out" "$tmp/parts"; says parts ' job [0-9a-f]*$'
    whole || job_fails 'standard input was refused'
    cmp -s "$tmp/parts" "$tmp/out" || job_fails 'jobs of parts and of the whole differ'
}

# S/F for each mm, off in rapids: 20 mm at F1200 and 20 at F600 with half power, 20 with a quarter
case_a_laser_gives_each_mm_the_same() {
    printf '%s\n' 'G21 G90' 'M4 S500' 'G0 X5 Y5' 'G1 X25 F1200' 'Y25 F600' 'G0 X5' 'G1 Y5 S250' \
        'M5' >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    machine laser --speed fast --once
    run 0 "$loft" stream "$tmp/burn.nc" --port "$tmp/laser" --machine "$tmp/laser.txt"
    gone "$machine"; counted laser
    awk '/^output 1:/ { s = $3 } END { exit !(s > 1.99 && s < 2.01) }' "$tmp/laser.log" ||
        job_fails "$(cat "$tmp/laser.log"), expected 2.000 s"
    machine without --speed fast --once
    one_line 78 'burn.nc:2: the machine has no output for the laser with --points' \
        "$loft" stream "$tmp/burn.nc" --points --port "$tmp/without" --machine "$tmp/laser.txt"
    kill "$machine"
    # a slow line: the queue runs low again and again
    machine slow --speed real --queue 4 --ramp 20 --once
    run 0 "$loft" stream "$tmp/burn.nc" --port "$tmp/slow" --machine "$tmp/laser.txt"
    gone "$machine"; counted slow
    awk '/^output 1:/ { s = $3 } END { exit !(s > 1.97 && s < 2.03) }' "$tmp/slow.log" ||
        job_fails "$(cat "$tmp/slow.log"), expected 2.000 s"
}

# along the outline of the benchmarks, held twice, at 130 and 50 %, with a short queue
case_a_laser_in_holds_and_overrides() {
    "$loft" export tests/drawings/outline12.csv -o "$tmp/cut.nc"
    { printf 'G21 G90 G94 G17\nM4 S600\n'
      grep '^[GXY]' "$tmp/cut.nc" | sed '1d; /^G0/d'
      echo M5; } >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    machine m --speed real --queue 12 --ramp 40 --steps 250 --once
    "$pty" type "$tmp/m.log" \
        '0.3:+ 0.4:+ 0.5:+ 0.6:h 1.2:r 1.5:0 1.6:- 1.7:- 1.8:- 1.9:- 2:- 2.3:h 3:r' \
        "$loft" stream "$tmp/burn.nc" --port "$tmp/m" --machine "$tmp/laser.txt" \
        >"$tmp/out" 2>"$tmp/err" || job_fails "$(tail -1 "$tmp/err")"
    gone "$machine"
    python3 tests/target/energy.py "$tmp/m.csv" 1 >"$tmp/energy"
    # 20 ms of full power for each mm
    awk '{ is[$1] = $2 }
        END { exit !(is["windows"] > 100 && is["mean"] > 19.8 && is["mean"] < 20.2 &&
            is["worst"] <= 2 && is["standing"] == 0 && is["after"] == 0) }' "$tmp/energy" ||
        job_fails "$(tr '\n' ' ' <"$tmp/energy")"
    [ "$(grep -c ' held: ' "$tmp/m.log")" -ge 1 ] || job_fails 'it was not held'
}

# raster NAME MM [STOPS]: output 1 in the record NAME against $tmp/raster.nc
raster() {
    python3 tests/e2e/raster.py check "$tmp/$1.csv" "$tmp/raster.nc" >"$tmp/energy"
    awk -v most="$2" -v stops="${3:-0}" '{ is[$1] = $2 }
        END { exit !(is["rows"] == 4 && is["energy"] <= most && is["stops"] <= stops &&
            is["standing"] == 0 && is["levels"] > 100) }' "$tmp/energy" ||
        job_fails "$1: $(tr '\n' ' ' <"$tmp/energy")"
}
# Another S in each line: a row is one motion, of 60 mm/s, which is 0.06 mm in a tick. Pixels of 0.4
# mm and, four in a tick, of 0.015 mm; along x and aslant; with a queue that runs low.
case_a_raster_goes_through() {
    local row=0 mode pixel slope
    printf 'laser = yes\nx.max_accel = 3000\ny.max_accel = 3000\n' >"$tmp/laser.txt"
    while read -r mode pixel slope; do
        row=$((row + 1))
        python3 tests/e2e/raster.py make "$mode" 4 "$pixel" $row "$slope" >"$tmp/raster.nc"
        machine "m$row" --speed fast --once --steps 400
        run 0 "$loft" stream "$tmp/raster.nc" --port "$tmp/m$row" --machine "$tmp/laser.txt" \
            --record "$tmp/m$row.csv"
        gone "$machine"; counted "m$row"; raster "m$row" 0.06
        awk '{ for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) > 0.0086) exit 1 }' \
            "$tmp/out" || job_fails "$(cat "$tmp/out")"
    done <<'ROWS'
M3 0.4 0
M3 0.015 0.37
M4 0.4 0.37
M4 0.015 0
ROWS
    # 1,333 lines a row: one curve each, and an item in each ms at most
    run 0 "$loft" plan "$tmp/raster.nc" --machine "$tmp/laser.txt" --total --certify
    run 0 "$loft" stream "$tmp/raster.nc" --machine "$tmp/laser.txt" --dry-run
    says out 'planned: 4 curves, .* 1\.9 s, '
    [ "$(grep -c S "$tmp/raster.nc")" -gt 4000 ] || job_fails 'there are few pixels'
    # the line and its machine are slow, and stop where it said that it had nothing left; the words
    # stay as they are for a controller
    machine slow --speed real --once --steps 400 --queue 4 --ramp 20
    run 0 "$loft" stream "$tmp/raster.nc" --port "$tmp/slow" --machine "$tmp/laser.txt" \
        --log "$tmp/talk"
    gone "$machine"; counted slow; raster slow 0.06 "$(grep -c ' starved' "$tmp/talk")"
    run 0 "$loft" stream "$tmp/raster.nc" --machine "$tmp/laser.txt" --dry-run --grbl
    [ "$(grep -c '^M4S' "$tmp/out")" -gt 4000 ] || job_fails 'S is lost'
    machine chip --speed fast --once
    one_line 78 'raster.nc:2: the machine has no output for the laser with --plan chip' \
        "$loft" stream "$tmp/raster.nc" --plan=chip --port "$tmp/chip" --machine "$tmp/laser.txt"
    kill "$machine"
}
case_a_raster_is_held_and_goes_on() {
    printf 'laser = yes\nx.max_accel = 3000\ny.max_accel = 3000\n' >"$tmp/laser.txt"
    python3 tests/e2e/raster.py make M4 4 0.2 7 >"$tmp/raster.nc"
    machine held --speed real --once --steps 400
    "$pty" type "$tmp/held.log" '0.2:h 0.7:r 0.9:- 1.0:- 1.1:- 1.5:h 2:r 2.1:0' \
        "$loft" stream "$tmp/raster.nc" --port "$tmp/held" --machine "$tmp/laser.txt" \
        >"$tmp/out" 2>"$tmp/err" || job_fails "$(tail -1 "$tmp/err")"
    gone "$machine"; raster held 0.06 2
    [ "$(grep -c ' held: ' "$tmp/held.log")" -ge 1 ] || job_fails 'it was not held'
    # its sender is killed twice; the machine keeps what the laser is for, and no file says it
    machine killed --speed real --once --steps 400 --keep "$tmp/kept"
    run 0 "$loft" set laser=yes x.max_accel=3000 y.max_accel=3000 --port "$tmp/killed"
    drawing_on=killed; job=("$loft" stream "$tmp/raster.nc" --port "$tmp/killed")
    for pause in 0.7 0.4; do cut_off $pause; done
    run 0 "${job[@]}"; gone "$machine"
    says err '^resuming at item'; says out 'as commanded$'
    counted killed; raster killed 0.06 2
}

# The commands of ports/README.md, sections 4 to 7, as they stand there, on a table with switches.
case_the_page_of_the_boards() {
    sh tests/e2e/page.sh 4 Without "$loft" "$tmp/uno" >"$tmp/page.sh"
    [ "$(grep -c "$(realpath "$loft")" "$tmp/page.sh")" -ge 13 ] ||
        job_fails "the page has few commands"
    machine uno --speed real --steps 80 --keep "$tmp/kept" --limits x-=-20,y-=-15,z+=8 \
        --walls x-=-24,y-=-19,z+=12 --probe z-=-3
    (cd "$tmp" && run 0 bash -e page.sh; [ -z "$why" ] || echo "$why" >"$tmp/off")
    [ ! -e "$tmp/off" ] || job_fails "$(cat "$tmp/off")"
    says out 'drawn: 1 curve'; says out 'steps 1600 0 .*as commanded'; says out '^homed: '
    says out 'touched'
}

# --- bad input ------------------------------------------------------------------------------------

case_bad_drawings() {
    printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 0' >"$tmp/broken.svg"
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm"></svg>' \
        >"$tmp/empty.svg"
    printf 'this is no drawing\n' >"$tmp/text.txt"
    printf '(made by x)\n%%\nG21 G90\nG1 X1 Y2 F100\nG1 X\n' >"$tmp/job.nc"
    one_line 65 'job.nc:5: a number is missing' "$loft" stream "$tmp/job.nc" --dry-run
    one_line 64 '--dialect x: give linuxcnc, grbl' "$loft" plan "$tmp/job.nc" --dialect x
    head -c 4096 /dev/urandom >"$tmp/random.bin"
    : >"$tmp/nothing"
    one_line 66 'no such file' "$loft" stream "$tmp/absent.svg" --dry-run
    for bad in broken.svg empty.svg text.txt random.bin nothing; do
        one_line 65 "$bad" "$loft" stream "$tmp/$bad" --dry-run
    done
    printf '0,0,1e9,0,1,1,2,2\n' >"$tmp/far.csv"
    one_line 65 'far.csv' "$loft" stream "$tmp/far.csv" --dry-run
    printf '\n0,0,9000,0,1,1,2,2\n' >"$tmp/wide.csv"
    one_line 65 'wide.csv:2: a point at 9000,0 mm' "$loft" stream "$tmp/wide.csv" --dry-run
    printf '0,0 1,1\n0,zero\n'   >"$tmp/word.txt"
    one_line 65 'word.txt:1' "$loft" eval "$tmp/word.txt"
}
# warned PATTERN COMMAND..: a warning, which --strict makes an error; without it the job is done
warned() {
    local pattern=$1; shift
    run 0 "$@"
    says err "$pattern"; cp "$tmp/err" "$tmp/warnings"
    one_line 65 "$pattern.*--strict" "$@" --strict
    [ ! -s "$tmp/out" ] || job_fails "$* --strict prints: $(head -c 200 "$tmp/out")"
    grep -qF "$(sed 's/ (an error by --strict)//' "$tmp/err")" "$tmp/warnings" \
        || job_fails "another line than the first warning"
}
# a drawing for each warning of the reader of SVG (enum svg_warning): the tail of its name, what the
# line says, what is within <svg>
svg_warnings() {
    sed -e :a -e '/\\$/N; s/\\\n *//; ta' <<'TABLE'
SELECTOR|selector "path:nth-child(2)|<style>path:nth-child(2) { display: none }</style>
DATA|path data ends after|<path d="M0 0L5" stroke="red"/>
TEXT|<flowRoot> is not drawn|<flowRoot/>
LETTER|is in no font|<text x="5" y="9">a&#x10FFFD;</text>
LAYER|as AxiDraw does|<g i:groupmode="layer" i:label="% notes"><path d="M0 0h5" stroke="red"/></g>
LAYER_NUMBERS|no speed, height|\
    <g i:groupmode="layer" i:label="1 +S50"><path d="M0 0h5" stroke="red"/></g>
LINE|letters without single lines|<text x="5" y="9">&#x3a9;</text>
UPRIGHT|is read as horizontal|<text x="5" y="9" writing-mode="vertical-rl">a</text>
PICTURE|<image> is not drawn|<image width="5" height="5" href="a.png"/>
CLIP_PATH|clip-path: circle(2)|<path d="M0 0h5" stroke="red" clip-path="circle(2)"/>
MASK|not of white shapes|\
    <mask id="m"><path d="M0 0h9v9z" fill="#777"/></mask>\
    <path d="M0 0h5" stroke="red" mask="url(#m)"/>
PATTERN|tiles is left out|\
    <pattern id="p" width=".01" height=".01" patternUnits="userSpaceOnUse">\
    <path d="M0 0h1" stroke="red"/></pattern><path d="M0 0h40v40h-40z" fill="url(#p)"/>
DASHES|more than [0-9]* dashes|<path d="M0 0h40" stroke="red" stroke-dasharray=".0001"/>
BOX|transform-box: fill-box|\
    <path d="M0 0h5" stroke="red" style="transform-box: fill-box; transform: rotate(9deg)"/>
UNSEEN|without fill and stroke|<path d="M0 0h5" fill="none"/>
USE_NOTHING|<use> without href|<use/>
USE_ELSEWHERE|is not in this file|<use href="b.svg#a"/>
USE_MISSING|no element has this id|<use href="#a"/>
TABLE
}
case_strict_svg_warning_by_warning() {
    local kind pattern inside text
    while IFS='|' read -r kind pattern inside; do
        printf '%s\n%s\n' '<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm"
            viewBox="0 0 50 50" xmlns:i="http://www.inkscape.org/namespaces/inkscape">
            <path d="M1 1h3" stroke="red"/>' "$inside</svg>" >"$tmp/$kind.svg"
        [ $kind = LINE ] && text=line || text=outline
        warned "$kind.svg:[0-9]*: .*$pattern" "$loft" plan "$tmp/$kind.svg" --total --text $text
    done < <(svg_warnings)
    # each has a line above
    diff <(svg_warnings | cut -d'|' -f1 | sort) \
         <(sed -n 's/^    SVG_WARN_\([A-Z_]*\),\?$/\1/p' host-tools/read/svg.h | sort) \
        || job_fails "warnings without a line, or lines without a warning"
}
# a program for each word that G-code leaves out
case_strict_gcode_warning_by_warning() {
    local pattern lines dialect
    while IFS='|' read -r pattern dialect lines; do
        printf 'G21 G90 F600\nG1 X5\n%b\nG1 Y5\n' "$lines" >"$tmp/left.nc"
        warned "left.nc:\?[0-9]*: $pattern" "$loft" plan "$tmp/left.nc" --total --dialect $dialect
    done <<'TABLE'
M48: has no meaning|linuxcnc|M48
$: commands of a controller|grbl|$H
M107: has no meaning|marlin|M107
E: there is no extruder|marlin|G1 X9 E2
G61 in a part of it|linuxcnc|G61\nG1 X9\nG64
TABLE
}
# what is not in a reader
case_strict_elsewhere() {
    printf 'G21 G90 F600\nG1 X5\nG1 Y5\n' >"$tmp/plain.nc"
    printf '0,0 1,1 2,2 9,9\n' >"$tmp/one.csv"
    warned 'it has no layers of Inkscape' "$loft" plan "$tmp/one.csv" --total --order layer
    printf 'x.reversed = yes\nx.travel = 90\nkinematics = corexy\ntolerance = 0.01\n' \
        >"$tmp/plan.txt"
    machine strict --speed fast
    warned 'and what else is of firmware or plan, is not kept' \
        "$loft" set --machine "$tmp/plan.txt" --port "$tmp/strict"
}
case_strict_makes_warnings_errors() {
    cat >"$tmp/image.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
  <path d="M5 5h9" stroke="red"/><image width="5" height="5" href="a.png"/></svg>
SVG
    printf 'G21 G90 F600\nG1 X5\nM48\nG1 Y5\n' >"$tmp/left.nc"
    printf 'G21 G90 F600\nG1 X5\nG4 P1\nG1 Y5\n' >"$tmp/wait.nc"
    printf 'tool.red.colours = blue\n' >"$tmp/pens.txt"
    for command in "stream --dry-run" "plan --total" "measure" "plot -o $tmp/plot.svg" \
            "export -o $tmp/image.nc"; do
        rm -f "$tmp"/plot.svg "$tmp"/image.nc
        warned 'image.svg:2: ' "$loft" ${command%% *} "$tmp/image.svg" ${command#"${command%% *}"}
        run 65 "$loft" ${command%% *} "$tmp/left.nc" ${command#"${command%% *}"} --strict
        says err 'left.nc:3: M48.*--strict'
    done
    run 65 "$loft" plan "$tmp/wait.nc" --strict; says err 'wait.nc:3: .*times.*--strict'
    sed -i 's/<image.*//; $a</svg>' "$tmp/image.svg"
    warned '1 curve belongs to no tool' "$loft" plan "$tmp/image.svg" --total \
        --machine "$tmp/pens.txt"
    # these have no warnings: what is off is an error in any case
    echo 1,2,3 >"$tmp/short.csv"; one_line 65 'short.csv:1' "$loft" plan "$tmp/short.csv" --strict
    echo 'bend 0 0' >"$tmp/odd.loft"; one_line 65 'odd.loft:1' "$loft" plan "$tmp/odd.loft" --strict
    echo 'x.tavel = 3' >"$tmp/odd.txt"
    one_line 65 'odd.txt:1' "$loft" plan "$tmp/small.csv" --machine "$tmp/odd.txt" --strict
    run 0 "$loft" plan "$tmp/small.csv" --total --strict; is_empty err
}
case_bad_options() {
    one_line 64 'unknown command draw'     "$loft" draw
    one_line 64 'not an option'  "$loft" stream x --fast
    one_line 64 'needs a value'  "$loft" stream x --port
    one_line 64 'no --port'      "$loft" stream "$tmp/small.csv"
    one_line 64 'no drawing'     "$loft" stream --port "$tmp/x"
    one_line 64 'more than one'  "$loft" stream a b --port "$tmp/x"
    one_line 64 'no other argument' "$loft" stream --hold --abort --port "$tmp/x"
    one_line 64 '--feed -3'      "$loft" stream "$tmp/small.csv" --dry-run --feed -3
    one_line 64 'a whole one'    "$loft" sample --n 2.5 --points "0,0 1,1"
    one_line 74 'standard output' sh -c "'$loft' sample --points '0,0 1,1' >/dev/full"
    one_line 64 '--num q31'      "$loft" eval --num q31 --points "0,0 1,1"
    one_line 64 '--speed slow'   "$loft" simulate --speed slow
    one_line 64 'the whole name' "$loft" plan "$tmp/small.csv" --fee 3
    one_line 64 'the whole name' "$loft" plan "$tmp/small.csv" --mach=none
    one_line 64 'give one file'  "$loft" eval "$tmp/small.csv" "$tmp/small.csv"
    one_line 64 'not both'       "$loft" sample --points '0,0 1,1' "$tmp/small.csv"
    one_line 64 '2 to 32768'     "$loft" simulate --queue 1
    one_line 64 '0 for none'     "$loft" simulate --curves 3
    one_line 74 'standard output' sh -c "'$loft' --version >/dev/full"
    one_line 65 'give 0 to 1 for this tensor' "$loft" eval --uv 5,5 tests/drawings/patch.loft
    ln -s /dev/full "$tmp/full.pdf"; ln -s /dev/full "$tmp/full.png"
    for full in full.pdf full.png; do
        one_line 73 'No space left' "$loft" plot "$tmp/small.csv" -o "$tmp/$full"
    done
    one_line 64 'HOST:PORT'      "$loft" stream "$tmp/small.csv" --port tcp:1234
}
case_pages() {
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --page A4 --fit --margin 10 --rotate auto
    says out '^drawing: 190.000 x 235.731 mm at 10.000,30.634 on a page of 210 x 297 mm$'
    run 0 "$loft" plan "$tmp/small.csv" --total --page 100x60 --at 0,0 --copies 2x1
    says out '^drawing: 115.000 x .*, 15.000 mm beyond it$'; says out '^drawn  *360.541 '
    run 0 "$loft" plot "$tmp/small.csv" --page 40x20 --crop -o "$tmp/cut.svg"; says out ' curves'
    one_line 64 'say which, as --page A4' "$loft" plan "$tmp/small.csv" --fit
    one_line 64 '--page B9' "$loft" stream "$tmp/small.csv" --dry-run --page B9
}
case_text() {
    cat >"$tmp/text.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="40mm" viewBox="0 0 90 40">
<text x="10" y="30" font-size="30">TT</text></svg>
SVG
    run 0 "$loft" stream "$tmp/text.svg" --dry-run --text line
    says out '^drawing: 30.000 x 21.000 mm at 11.000,10.000 '; says out ' 4 curves, 0.070 m drawn'
    run 0 "$loft" export "$tmp/text.svg" --as csv; says out '^[0-9.,]*$'
    one_line 65 'nothing to draw' "$loft" stream "$tmp/text.svg" --dry-run --text none
    one_line 65 'no font "x"' "$loft" stream "$tmp/text.svg" --dry-run --text line:x
}
case_fill() {
    cat >"$tmp/box.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="40mm" viewBox="0 0 90 40">
<rect x="10" y="10" width="20" height="10"/></svg>
SVG
    run 0 "$loft" stream "$tmp/box.svg" --dry-run --fill hatch:0,2 --outline none
    says out ' 5 curves, 0.100 m drawn'
    run 0 "$loft" plan "$tmp/box.svg" --total --fill cross:0,2 --page 25x40 --crop
    says out '^drawn  *195.000 '
    one_line 65 'nothing in it is filled' "$loft" plan "$tmp/small.csv" --fill hatch
    one_line 64 'give hatch:ANGLE,MM' "$loft" plan "$tmp/box.svg" --fill wave
}
# A folder that is not there is told before anything is computed, in one line with the remedy.
case_bad_places_for_files() {
    local none=$tmp/none/x
    awk 'BEGIN { print "bspline 3"; for (i = 0; i < 20000; i++) print i % 170, i * 7 % 190 }' \
        >"$tmp/long.loft"
    printf '0,0\n4,0\n4,3\n2,1\n0,3\n' >"$tmp/polygon.csv"
    echo '# slot_hz = 1' >"$tmp/record.csv"
    for job in "plan $tmp/long.loft --plot $none.png" "plan $tmp/long.loft --spans -o $none.csv" \
        "export $tmp/small.csv -o $none.nc" "plot $tmp/small.csv -o $none.png" \
        "surface tests/drawings/surfaces.loft --tol 0.0001 -o $none.stl" \
        "harmonic $tmp/polygon.csv -o $none.h" "study gb -o $none/y" \
        "mill tests/drawings/patch.loft --record $tmp/record.csv -o $none.png"; do
        # shellcheck disable=SC2086
        one_line 73 'none/x.*: No such file or directory: name a place in a folder that exists' \
            timeout 10 "$loft" $job
    done
    one_line 73 'folder' "$loft" figures family -o "$none"
    one_line 73 'name a log' "$loft" stream "$tmp/small.csv" --port "$tmp/no" --log "$none"
    one_line 73 'name a file that can be written' "$loft" simulate --record "$none" --link "$tmp/l"
    one_line 73 'name a place in a folder that exists' "$loft" simulate --link "$none"
    one_line 73 'name a file that can be written' "$loft" simulate --link "$tmp/l" --keep "$none"
    mkdir "$tmp/folder"
    one_line 73 'Is a directory' "$loft" export "$tmp/small.csv" -o "$tmp/folder" --as nc
    # pieces of other files in the place of a machine file, and of what a machine keeps
    tail -c 400 tests/corpus/svg.tar.gz >"$tmp/settings"
    one_line 65 'settings: is not text' "$loft" plan "$tmp/small.csv" --machine "$tmp/settings"
    machine strange --speed fast --keep "$tmp/settings"
    run 0 "$loft" settings --port "$tmp/strange"; says out 'those of its firmware'
    run 0 "$loft" set x.travel=9 --port "$tmp/strange"
    run 0 "$loft" settings --port "$tmp/strange"; says out '^x.travel = 9$'
    kill "$machine"
}
case_bad_ports() {
    one_line 69 'No such file'      "$loft" stream "$tmp/small.csv" --port /dev/ttyNONE
    one_line 69 'not a serial port' "$loft" stream "$tmp/small.csv" --port /dev/null
    one_line 69 'not a serial port' "$loft" stream "$tmp/small.csv" --port "$tmp/small.csv"
    one_line 69 'No such file'      "$loft" stream "$tmp/small.csv" --port "unix:$tmp/none"
    one_line 69 'refused'           "$loft" stream "$tmp/small.csv" --port tcp:127.0.0.1:1
}


# --- numbers through pipes ------------------------------------------------------------------------

case_links_of_others_are_left_alone() {
    echo precious >"$tmp/file"
    ln -s "$tmp/file" "$tmp/mine"
    ln -s nowhere "$tmp/dangling"
    mkdir "$tmp/folder"
    one_line 73 'link to something other than a simulated machine' \
        "$loft" simulate --link "$tmp/mine"
    one_line 73 'link to something other than a simulated machine' \
        "$loft" simulate --link "$tmp/dangling"
    one_line 73 'is a file' "$loft" simulate --link "$tmp/file"
    one_line 73 'is a file' "$loft" simulate --link "$tmp/folder"
    [ "$(readlink "$tmp/mine") $(readlink "$tmp/dangling") $(cat "$tmp/mine")" = \
        "$tmp/file nowhere precious" ] || job_fails "$(ls -l "$tmp")"
    machine first --speed fast
    one_line 73 'another simulated machine has this link' "$loft" simulate --link "$tmp/first"
    run 0 "$loft" ports "$tmp/first"; says out '	idle'
    kill -9 "$machine"
    gone "$machine"
    [ -L "$tmp/first" ] || job_fails "no link is left behind to be replaced"
    machine first --speed fast
    until_log first '^machine: '
    run 0 "$loft" ports "$tmp/first"
    says out '	idle'
    ln -sfn elsewhere "$tmp/first"; kill "$machine"; gone "$machine"
    [ "$(readlink "$tmp/first")" = elsewhere ] || job_fails "a link of somebody else was removed"
}
case_help_everywhere() {
    run 0 "$loft" --help;    says out 'usage: loft COMMAND'
    run 0 "$loft" --version; says out '^loft [0-9]'
    run 64 "$loft"
    for command in stream simulate plot ports eval sample flatten measure compare surface contour \
                   export decide make mill figures fit
    do
        run 0 "$loft" help $command;   says out "^usage: loft $command"; cp "$tmp/out" "$tmp/help"
        run 0 "$loft" $command --help
        cmp -s "$tmp/out" "$tmp/help" || job_fails "help $command and $command --help differ"
    done
}
# the net of a dome of 24 mm, beside the place where the machine stands
dome() {
    awk 'BEGIN { print "tensor 3 3"
                 for (i = 0; i < 4; i++) for (j = 0; j < 4; j++)
                     print 6 + 8 * i, 6 + 8 * j, (i % 3 && j % 3 ? 7 : 1) }'
}
case_mill_on_the_chip() {
    dome >"$tmp/dome.loft"
    local cut=("$loft" mill --plan chip --tool ball:6 --step 2 --feed 60 "$tmp/dome.loft")
    run 0 "${cut[@]}" --dry-run
    says out 'dome.loft:1: 1[0-9] lines of [0-9]* curves, .* in 9 items$'; says out '^planned: '
    machine chip --speed fast --once
    run 0 "${cut[@]}" --port "$tmp/chip" --log "$tmp/line"
    says out '^drawn: .* steps 0 0 0 as commanded$'; says out ' for 9 parts of a patch, '
    gone "$machine"; counted chip
    # JOB, END and these frames, 128 bytes each at most, are all that is sent but questions
    [ "$(grep -c '> CURVES' "$tmp/line")" -le 3 ] || job_fails "more than 3 frames of items"
    run 0 "$loft" mill --tool ball:6 --record "$tmp/chip.csv" -o "$tmp/left.png" "$tmp/dome.loft"
    # 0.010 of the lines, 0.005 of the plan, a step of 1/80 mm on each axis; cusps of 2 mm: 0.172
    awk '{ exit !($7 <= 0.172 + 0.037 && $12 <= 0.037) }' "$tmp/out" ||
        job_fails "not as asked: $(cat "$tmp/out")"
    machine again --speed fast                  # the sender dies, and comes back
    draws again; job=("${cut[@]}" --port "$tmp/again")
    cut_off 0.5
    run 0 "${job[@]}"; says out '^drawn: .* steps 0 0 0 as commanded$'; counted again
    same_path again chip
    { dome; printf 'tensor 1 1\n0 0 5\n0 9 5\n9 0 5\n9 9 5\n'; } >"$tmp/two.loft"
    run 0 "$loft" mill --plan chip --along u --tool ball:6 --step 9 "$tmp/two.loft" \
        --port "$tmp/again"
    [ "$(grep -c '^drawn: ' "$tmp/out")" = 2 ] || job_fails "two surfaces: $(cat "$tmp/out")"
    kill "$machine"; gone "$machine"
    machine few --speed fast --columns 2
    one_line 65 'give more --tol'       "${cut[@]}" --port "$tmp/few"
    machine none --speed fast --columns 0
    one_line 78 'leave out --plan chip' "${cut[@]}" --port "$tmp/none"
    printf 'tensor 2 2\n' >"$tmp/bowl.loft"
    printf '%s\n' '0 0 9' '0 5 9' '0 9 9' '5 0 9' '5 5 -9' '5 9 9' '9 0 9' '9 5 9' '9 9 9' \
        >>"$tmp/bowl.loft"
    one_line 65 'give a smaller --tool' "$loft" mill --plan chip --dry-run --tool ball:20 \
        "$tmp/bowl.loft"
    printf 'sphere 9\n' >"$tmp/ball.loft"
    one_line 65 'leave out --plan chip' "$loft" mill --plan chip --dry-run "$tmp/ball.loft"
    one_line 64 'give --tool ball'      "$loft" mill --plan chip --tool flat:4 "$tmp/dome.loft"
    one_line 64 'give host or chip'     "$loft" mill --plan moon "$tmp/dome.loft"
    one_line 64 'are for --plan chip'   "$loft" mill --dry-run "$tmp/dome.loft"
    one_line 64 'no --port'             "$loft" mill --plan chip "$tmp/dome.loft"
}
case_mill() {
    printf 'bicubic\n' >"$tmp/dome.loft"
    printf '%s\n' '0 0 0' '0 9 0' '0 9 6' '0 9 -6' '9 0 0' '9 9 0' '0 9 6' '0 9 -6' '9 0 6' \
                  '9 0 6' '0 0 0' '0 0 0' '9 0 -6' '9 0 -6' '0 0 0' '0 0 0' >>"$tmp/dome.loft"
    for num in q16 f64; do
        run 0 "$loft" mill --num $num --tool ball:4 --step cusp:0.1 --tol 0.02 "$tmp/dome.loft"
        is_empty err; says out '^# cuts below the surface: none, proved'
        says out '^# cusps: at most 0\.0[0-9]*, asked 0.1$'
        says out '^# left on the surfaces: at most 0\.1[01]'
        says out '^# left in hollows tighter than the tool: no more than 0\.14'
        cp "$tmp/out" "$tmp/path.loft"
        run 0 "$loft" plan "$tmp/path.loft";    says out '^in all'
    done
    run 0 "$loft" mill --tool bull:4:0.5 --step 3 --along y "$tmp/dome.loft"
    says out '^# bull:4:0.5, 6 lines'
    # along the lower border of a slope of 1.6 the ball must go 2 - 2 cos = 0.94 deeper, and half a
    # step of a cusp of 0.1 along the slope: 0.53 more; and 0.85 of its radius beside it
    printf 'tensor 1 1\n0 0 -5\n0 9 -5\n5 0 3\n5 9 3\n' >"$tmp/slope.loft"
    run 0 "$loft" mill --tool ball:4 --step cusp:0.1 "$tmp/slope.loft"
    awk '/^[-0-9]/ { if ($1 < x) x = $1; if ($3 < z) z = $3 }
         END { exit !(x < -1.69 && x > -1.75 && z < -6.4 && z > -6.5) }' "$tmp/out" ||
        job_fails "a steep border is not reached"
    run 0 "$loft" mill --tool ball:4 --step cusp:0.1 --floor -5 "$tmp/slope.loft"
    awk '/^[-0-9]/ && $3 < -5 { exit 1 }' "$tmp/out" || job_fails "below --floor"
    run 0 "$loft" mill --tool ball:4 --pattern waterline --step 1 --tol 0.05 "$tmp/dome.loft"
    # the last line is where the ball touches the lowest border, below all of the surface
    says out '^# ball:4, 4 lines'; says out '^# beside the surface: at most 0.05'
    cp "$tmp/out" "$tmp/path.loft"; run 0 "$loft" plan "$tmp/path.loft"; says out '^in all'
    for entry in ramp:5 helix:0.5:10; do
        run 0 "$loft" mill --tool ball:4 --pattern waterline --step 1 --tol 0.05 --entry $entry \
            "$tmp/dome.loft"
        says out "^# entries: .*[1-9] by a ${entry%%:*}"
    done
    one_line 64 'give straight, ramp:DEGREES' "$loft" mill --entry ramp:60 "$tmp/dome.loft"
    run 0 "$loft" mill --tool ball:4 --pattern spiral --step cusp:0.2 --tol 0.05 "$tmp/dome.loft"
    says out '^# cusps: at most 0\.[01][0-9]*, asked 0.2$'
    one_line 64 'give raster, spiral, waterline or pencil' \
        "$loft" mill --pattern round "$tmp/dome.loft"
    printf 'octant 9\n' >"$tmp/octant.loft"
    run 0 "$loft" mill --tool flat:3 --step 3 --floor 4 "$tmp/octant.loft"
    says out '^# flat:3, 5 lines'
    printf '# steps_per_mm = 10\n# slot_hz = 1000\n' >"$tmp/pulses.csv"
    awk 'BEGIN { s = 0; print ++s ",0,0,200"
                 for (y = 0; y <= 90; y += 4)
                     for (x = 0; x <= 90; x += 4) print ++s "," x "," y ",5"
               }' >>"$tmp/pulses.csv"
    printf 'tensor 1 1\n0 0 0.4\n0 9 0.4\n9 0 0.4\n9 9 0.4\n' >"$tmp/plane.loft"
    run 0 "$loft" mill --tool flat:4 --record "$tmp/pulses.csv" -o "$tmp/left.png" "$tmp/plane.loft"
    says out 'left.png: 529 places of the tool, 0.1000 mm left at worst, 0.0000 mm cut'
    printf '%s\n' 'tensor 1 1' '-9 -9 9' '-9 9 9' '9 -9 -9' '9 9 -9' 'tensor 1 1' '-9 -9 -9' \
        '-9 9 -9' '9 -9 9' '9 9 9' >"$tmp/valley.loft"
    run 0 "$loft" mill --tool ball:4 --pattern pencil --tol 0.05 "$tmp/valley.loft"
    says out '^# ball:4, 1 lines'; says out '^# cuts below the surface: none, proved'
    run 0 "$loft" mill --tool ball:4 --pattern pencil --tol 0.05 "$tmp/plane.loft"
    says out '^# ball:4, 0 lines'
    one_line 64 'pencil: is for a ball' "$loft" mill --tool flat:4 --pattern pencil \
        "$tmp/dome.loft"
    printf 'spatch 5 1\n0 9 4\n-8 3 2\n-5 -7 0\n5 -7 1\n8 3 3\n' >"$tmp/five.loft"
    printf 'line\n-3 -3\n3 -3\n3 3\n-3 3\n-3 -3\n' >"$tmp/loop.loft"
    printf 'line\n0.5 0.1\n0.9 0.1\n0.9 0.9\n0.5 0.1\n' >"$tmp/loop-uv.loft"
    for num in f32 f64; do
        run 0 "$loft" mill --num $num --tool ball:4 --step 3 --tol 0.1 "$tmp/five.loft"
        says out '^# ball:4, 8 lines'; says out '^# cuts below the surface: none, proved'
    done
    awk '/^ring/ { on = 1 } /^gb/ { on = 0 } on' tests/drawings/sided.loft >"$tmp/ring.loft"
    run 0 "$loft" mill --tool ball:20 --step 15 --tol 0.1 "$tmp/ring.loft"
    says out '^# ball:20, .* lines'; says out '^# cuts below the surface: none, proved'
    run 0 "$loft" mill --tool ball:4 --along v --step 0.25 --tol 0.1 "$tmp/plane.loft"
    says out '^# ball:4, 5 lines'; says out '^9 9 0.4'
    for way in '' --one-way; do                 # back in one chord, or in many along a line
        run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.05 $way "$tmp/dome.loft"
        awk -v way="$way" '/^[-0-9]/ { down = begun && $1 < x; if (down && back) twice++
                                       back = down; begun = 1; x = $1 }
             END { exit (way != "") == (twice > 0) }' "$tmp/out" || job_fails "mill $way"
        says out '^# cuts below the surface: none, proved'
    done
    one_line 64 'is for --pattern raster along x' "$loft" mill --one-way --pattern spiral \
        "$tmp/plane.loft"
    one_line 64 'is for --pattern raster and --step' "$loft" mill --along u "$tmp/plane.loft"
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.1 --trim "$tmp/loop.loft" "$tmp/five.loft"
    says out '^# ball:4, 4 lines'
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.1 --trim-uv "$tmp/loop-uv.loft" \
        "$tmp/plane.loft"
    says out '^1\.975 -1\.4'       # 0.7 radius beside the eighth that ends at u = 0.5
    one_line 65 'has no u and v: give' "$loft" mill --trim-uv "$tmp/loop-uv.loft" "$tmp/five.loft"
    printf 'line\n5 5\n6 5\n6 6\n5 5\n' >"$tmp/far.loft"
    one_line 65 'nothing is left inside' "$loft" mill --trim-uv "$tmp/far.loft" "$tmp/plane.loft"
    one_line 64 'give one of them' "$loft" mill --trim "$tmp/loop.loft" \
        --trim-uv "$tmp/loop.loft" "$tmp/five.loft"
    printf 'line\n0 0\n3 0\n3 3\n' >"$tmp/open.loft"
    one_line 65 'a path is open' "$loft" mill --trim "$tmp/open.loft" "$tmp/five.loft"
    sed 's/5 1/5 1 meanvalue/' "$tmp/five.loft" >"$tmp/mean.loft"
    one_line 65 'its bends have no bounds' "$loft" mill "$tmp/mean.loft"
    printf 'sphere 9\n' >"$tmp/ball.loft"
    one_line 65 'sphere: cannot be milled' "$loft" mill "$tmp/ball.loft"
    one_line 64 'is for a ball'    "$loft" mill --tool flat:4 --step cusp:0.1 "$tmp/dome.loft"
    one_line 64 'give ball:DIAMETER'      "$loft" mill --tool ball "$tmp/dome.loft"
    one_line 64 'less than a quarter'     "$loft" mill --step cusp:2 "$tmp/dome.loft"
    one_line 64 'give WIDTHxDEPTHxHEIGHT' "$loft" mill --stock 60x40 "$tmp/dome.loft"
    one_line 64 'and --stock'    "$loft" mill --plan chip --stock 6x4x2 --dry-run "$tmp/dome.loft"
    # a block: its place, ways above it, what leaves it, its picture from the place in the path
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.05 --safe 2 --stock 14x13.5x4 --one-way \
        "$tmp/plane.loft"
    says out '^# out of --stock 14x13.5x4@-2.5,-2.25,-3.6, in one pass through all of it$'
    awk '/^[-0-9]/ { if (!n++ && $3 != 2.4) exit 1; low += $3 < 0.46; high += $3 == 2.4 }
         END { exit !(low >= 10 && high >= 10) }' "$tmp/out" || job_fails "not above the block"
    run 0 "$loft" mill --tool flat:4 --record "$tmp/pulses.csv" -o "$tmp/left.png" \
        --stock 14x13.5x4@-2.5,-2.25,-3.6 "$tmp/plane.loft"
    says out 'left.png: 529 places of the tool, 0.0000 mm left at worst, 0.0000 mm cut'
    one_line 65 ':1: tensor: reaches to x .*, 0.500 mm beyond the block: give a larger' \
        "$loft" mill --stock 8x9x4 "$tmp/plane.loft"
    one_line 65 'the lines reach to x 10.400, 0.900 mm beyond the block: .* a smaller --area' \
        "$loft" mill --tool ball:4 --step 3 --stock 10x40x4 "$tmp/plane.loft"
    one_line 65 'mm below the block: give a thicker' \
        "$loft" mill --tool ball:4 --step 3 --floor -5 --area -3,-3,12,12 \
        --stock 20x20x4 "$tmp/plane.loft"
    one_line 64 'give x, y, u or v'       "$loft" mill --along z "$tmp/dome.loft"
    one_line 64 'the picture of --record' "$loft" mill -o "$tmp/path.loft" "$tmp/dome.loft"
    one_line 64 'leave out --trim'   "$loft" mill --record "$tmp/a" --trim "$tmp/b" "$tmp/dome.loft"
    one_line 64 'two corners apart'       "$loft" mill --area 1,1,1,5 "$tmp/dome.loft"
    one_line 65 'no surface in it'        "$loft" mill "$tmp/small.csv"
}
case_eval_and_sample() {
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0,0.25,1 --points "0,0 4,8 12,0"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;2.25 3;12 0;" ] \
            || job_fails "eval $num: $(cat "$tmp/out")"
        run 0 "$loft" sample --num $num --n 4 --points "0,0 4,8 12,0"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;2.25 3;5 4;8.25 3;12 0;" ] \
            || job_fails "sample $num: $(cat "$tmp/out")"
    done
    run 0 sh -c "'$loft' sample --n 2 '$tmp/small.csv' | '$loft' flatten - | wc -l"
    says out '^ *[0-9]'
}
case_fit() {
    awk 'BEGIN { print "x,y"
                 for (i = 0; i <= 80; i++) print (i < 40 ? i : 40) "," (i < 40 ? 0 : i - 40)
                 for (i = 0; i < 90; i++) {
                     a = i / 90; print 40 * cos(a) "," 40 * sin(a) + 0.01 * (i % 3) }
                }' >"$tmp/measured.csv"
    sed -n '1,82p' "$tmp/measured.csv" >"$tmp/corner.csv"
    for num in q16 f32 f64; do                              # two lines, and the corner between them
        run 0 "$loft" fit --num $num "$tmp/corner.csv"; says out '^40 0$'
        [ "$(grep -c '^bezier 3' "$tmp/out")" = 2 ] || job_fails "corner $num: $(cat "$tmp/out")"
        cp "$tmp/out" "$tmp/fitted.loft"
        run 0 "$loft" eval --num $num --t 0.5 "$tmp/fitted.loft"
    done
    sed '2,82d' "$tmp/measured.csv" >"$tmp/arc.csv"
    run 0 "$loft" fit --tol 0.03 "$tmp/arc.csv"; says out ' for 90 points, within 0.0[12]'
    run 0 "$loft" fit --closed --tol 0.03 "$tmp/arc.csv"
    "$loft" fit --tol 0.03 "$tmp/arc.csv" | "$loft" measure - >"$tmp/out" || job_fails "no pipe"
    one_line 65 'measured.csv:2: not a point: give lines'  sh -c "printf 'x,y\n1,2,3,4\n' \
                >'$tmp/measured.csv'; exec '$loft' fit '$tmp/measured.csv'"
    printf '1 2\n' >"$tmp/one.txt"
    one_line 65 'one.txt:1: one point: give two or more'   "$loft" fit "$tmp/one.txt"
    printf '0 0\n40000 0\n40001 1\n' >"$tmp/far.txt"
    one_line 65 'far.txt'   "$loft" fit --num q16 "$tmp/far.txt"
}

case_parts() {
    printf 'bezier 3\n0 0\n0 20\n20 20\n20 0\n' >"$tmp/curve.loft"
    printf 'bezier 3\n10 0 0\n10 5 2\n5 10 4\n0 10 6\n' >"$tmp/space.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make split --num $num --of 0.3,0.7 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/parts.loft"
        run 0 "$loft" make join --num $num --of 0.001 "$tmp/parts.loft"
        cp "$tmp/out" "$tmp/one.loft"
        [ "$(grep -c bezier "$tmp/one.loft")" = 1 ] || job_fails "join $num: $(cat "$tmp/out")"
        run 0 "$loft" eval --num $num --t 0.5 "$tmp/one.loft"
        awk '{ exit !(($1 - 10)^2 + ($2 - 15)^2 < 1e-8) }' "$tmp/out" || job_fails "join $num"
        run 0 "$loft" make raise --num $num --of 4 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/high.loft"
        run 0 "$loft" make lowest --num $num --of 0.001 "$tmp/high.loft"; says out '^bezier 3$'
        run 0 "$loft" make lowest --num $num --of 100 "$tmp/high.loft";   says out '^bezier 1$'
        run 0 "$loft" make cut --num $num --of 0.25,0.75 "$tmp/curve.loft"; says out '^3.125 11.25$'
        run 0 "$loft" decide frame --num $num --of 0,1 "$tmp/space.loft"
        says out '^0 t 0 along 0 0.92847669.* normal -1 0 0$'; says out '^0 t 1 .* normal 0 -1 0$'
        run 0 "$loft" decide power --num $num --of=1,0,0,1;         says out '^power 1 -3 3 0$'
        run 0 "$loft" decide integral --num $num --of=0,0,1,0,0.5;  says out '^part 0.04166666'
        run 0 "$loft" decide smooth --num $num --of=0,0,1,1,0.5;    says out '^value 0.25$'
    done
    printf '0 0\n2 2\n4 0\n\n4 0\n6 2\n8 0\n' >"$tmp/corner.txt"
    run 0 "$loft" make join --of 0.001 "$tmp/corner.txt"
    [ "$(grep -c bezier "$tmp/out")" = 2 ] || job_fails "a corner is no curve"
    one_line 65 'cut: no curve has that part: give two'  "$loft" make cut --of 2,3 "$tmp/curve.loft"
    one_line 65 'join: a tolerance of 0: give one above' "$loft" make join --of 0 "$tmp/curve.loft"
}

case_decide() {
    for num in q16 f32 f64; do
        run 0 "$loft" decide positive --num $num --of=1,-1,1      # (1 - 2 t)^2
        [ "$(tr '\n' ';' <"$tmp/out")" = \
            "positive no;nonnegative yes;roots 1;minimum 0;elevations more than 60;" ] ||
            job_fails "positive $num: $(cat "$tmp/out")"
        # (t (1 - t))^31 (1 - 2 t)^2, and a little less in the middle
        local ends; ends=$(printf '0,%.0s' {1..31})
        run 0 "$loft" decide positive --num $num --of="${ends}1.03125,-2,1.03125,${ends%,}"
        says out '^nonnegative yes$'; says out '^roots 3$'
        run 0 "$loft" decide positive --num $num --of="${ends}1.03125,-2.0001,1.03125,${ends%,}"
        says out '^nonnegative no$'; says out '^roots 4$'
        run 0 "$loft" decide copositive --num $num --of=1,-1,1,1,-1,1,-1,1,1,1,-1,1,1,-1,1
        says out 'copositive yes'                               # Horn's matrix
        printf '0 0\n2 4\n4 0\n\n0 2\n4 2\n' >"$tmp/touch.txt"
        run 0 "$loft" decide meet --num $num "$tmp/touch.txt"
        [ "$(cat "$tmp/out")" = "0 1 0.5 0.5 multiplicity 2" ] ||
            job_fails "meet $num: $(cat "$tmp/out")"
        printf '0 0\n2 4\n4 0\n\n0 2.0001\n4 2.0001\n' >"$tmp/miss.txt"
        run 0 "$loft" decide meet --num $num "$tmp/miss.txt"
        [ ! -s "$tmp/out" ] || job_fails "miss $num: $(cat "$tmp/out")"
        printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : 2\n' >"$tmp/conic.loft"
        run 0 "$loft" decide conic --num $num "$tmp/conic.loft"
        says out '^0 circle, ellipse'; says out '^centre 0 0'; says out '^axes 1 1'
        says out '^focus 0 0'
        printf 'rational 3\n3 0 : 3\n3 6 : 1\n-3 6 : 1\n-3 0 : 3\n' >"$tmp/half.loft"
        run 0 "$loft" decide conic --num $num "$tmp/half.loft"
        says out '^0 circle, ellipse'; says out '^centre 0 0'; says out '^axes 3 3'
        # a whole circle; its other part, with a negative weight; weights of 0: a line, a hyperbola
        { printf 'rational 2\n5 0 : 1\n5 5 : 1\n0 5 : 2\n'
          printf 'rational 2\n0 5 : 2\n-5 5 : 1\n-5 0 : 1\n'
          printf 'rational 2\n-5 0 : 1\n-5 -5 : 1\n0 -5 : 2\n'
          printf 'rational 2\n0 -5 : 2\n5 -5 : 1\n5 0 : 1\n'; } >"$tmp/whole.loft"
        run 0 "$loft" decide conic --num $num "$tmp/whole.loft"
        [ "$(grep -c '^[0-3] circle, ellipse$' "$tmp/out")" = 4 ] ||
            job_fails "whole circle $num: $(cat "$tmp/out")"
        printf 'rational 2\n5 0 : 1\n5 5 : -1\n0 5 : 2\n' >"$tmp/other.loft"
        run 0 "$loft" decide conic --num $num "$tmp/other.loft"
        says out '^0 circle, ellipse$'; says out '^centre 0 0$'; says out '^axes 5 5$'
        printf 'rational 2\n5 0 : 1\n5 5 : 0\n0 5 : 1\n' >"$tmp/zero.loft"
        run 0 "$loft" decide conic --num $num "$tmp/zero.loft"
        says out '^0 line$'
        printf 'rational 2\n1 0 : 1\n0 0 : 0\n0 1 : -1\n' >"$tmp/infinite.loft"
        run 0 "$loft" decide conic --num $num "$tmp/infinite.loft"
        says out '^0 line, through infinity$'
        printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : -1\n' >"$tmp/branches.loft"
        run 0 "$loft" decide conic --num $num "$tmp/branches.loft"
        says out '^0 hyperbola, through infinity$'
        printf 'tensor 1 1\n0 0 0\n0 2 0\n2 0 0\n2 2 0\n' >"$tmp/plane.loft"
        run 0 "$loft" decide ray --num $num --of=1,0.5,5,0,0,-2 "$tmp/plane.loft"
        [ "$(cat "$tmp/out")" = "0 t 2.5 u 0.5 v 0.25" ] ||
            job_fails "ray $num: $(cat "$tmp/out")"
        run 0 "$loft" decide nearest --num $num --of=5,1,0 "$tmp/plane.loft"
        says out '^0 u 1 v 0.5 distance 3 at 2 1 0'
        # of an octant the distance from its radius; of a B-spline surface that is this plane twice;
        # of a tetrahedron of triangles a sixth of its box
        printf 'octant 20\n' >"$tmp/octant.loft"
        run 0 "$loft" decide nearest --num $num --of=8,9,12 "$tmp/octant.loft"
        awk '{ off = $7 - 3; exit !(off < 1e-3 && off > -1e-3) }' "$tmp/out" ||
            job_fails "octant $num: $(cat "$tmp/out")"
        printf 'nurbs-surface 1 1 3 2\n0 0 0\n0 2 0\n2 0 0\n2 2 0\n4 0 0\n4 2 0\n' >"$tmp/two.loft"
        run 0 "$loft" decide ray --num $num --of=2,0.5,5,0,0,-2 "$tmp/two.loft"
        [ "$(cat "$tmp/out")" = "0 t 2.5 u 0.5 v 0.25 edge" ] ||
            job_fails "ray of two spans $num: $(cat "$tmp/out")"
        run 0 "$loft" decide area --num $num "$tmp/two.loft"; says out '^0 area 8$'
        run 0 "$loft" measure --num $num "$tmp/two.loft"; says out '^0 area 8$'
        for face in '0 0 0 0 6 0 6 0 0' '0 0 0 6 0 0 0 0 6' '6 0 0 0 6 0 0 0 6' \
                    '0 6 0 0 0 0 0 0 6'; do
            printf 'triangle 1\n%d %d %d\n%d %d %d\n%d %d %d\n' $face
        done >"$tmp/tetra.loft"
        run 0 "$loft" decide volume --num $num "$tmp/tetra.loft"; says out '^volume 36$'
        says out '^centroid 1.5 1.5 1.5$'
    done
    printf 'sphere 10\n' >"$tmp/ball.loft"
    for num in q16 f32 f64; do          # an octant of that ball, the ball
        run 0 "$loft" decide area --num $num --of 0.05 "$tmp/octant.loft"
        awk '{ exit !(($3 - 628.3185)^2 < 0.003) }' "$tmp/out" ||
            job_fails "area $num: $(cat "$tmp/out")"
        run 0 "$loft" decide volume --num $num --of 0.05 "$tmp/ball.loft"
        awk '/^volume/ { exit !(($2 - 4188.79)^2 < 0.2) }' "$tmp/out" ||
            job_fails "$num: $(cat "$tmp/out")"
        awk '/^centroid/ { n++; d = $2 ^ 2 + $3 ^ 2 + $4 ^ 2 } END { exit n != 1 || d > 1e-6 }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
    one_line 65 'not a tolerance' "$loft" decide area --of=-1 "$tmp/octant.loft"
    printf 'ring 3 2\n0 0\n5 0\n9 0\n5 5\n0 9\n0 5\n3 3 1\n' >"$tmp/sided.loft"
    one_line 65 'a ring is no quotient of polynomials' "$loft" decide area "$tmp/sided.loft"
    one_line 65 'a ring is no quotient of polynomials' "$loft" measure "$tmp/sided.loft"
    one_line 64 'holds surfaces: .loft make meet' "$loft" measure --intersect "$tmp/sided.loft"
    one_line 64 'nearest: give x,y,z' "$loft" measure --nearest 1,2 "$tmp/sided.loft"
    one_line 64 'not known to decide'  "$loft" decide nothing
    one_line 65 'degree 129: give 1 to 129 coefficients, to degree 128' \
        "$loft" decide convex --of "$(printf '0,%.0s' {1..129})1"
    one_line 64 'positive: --of has 0 numbers: give Bernstein'   "$loft" decide positive
    one_line 64 'bend: --of has 0 numbers: give parameters'      "$loft" decide bend -
    one_line 64 'ray: --of has 3 numbers: give a point and'      "$loft" decide ray --of=1,2,3 -
    one_line 65 'holds no surface' "$loft" decide ray --of=1,2,3,4,5,6 "$tmp/touch.txt"
}
# (t, t^2, t^3): derivatives, curvature 2 and torsion 3 at 0; a saddle z = x y; a sphere has no
# principal directions
case_local() {
    printf 'bezier 3\n0 0 0\n1 0 0\n2 1 0\n3 3 3\n' >"$tmp/screw.loft"
    printf 'tensor 1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 1\n' >"$tmp/saddle.loft"
    printf 'sphere 2\n0 0 0\n' >"$tmp/sphere.loft"
    printf 'line\n0 0\n4 0\n' >"$tmp/flat.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0 --deriv "$tmp/screw.loft"
        says out '^0 0 0 3 0 0 0 6 0 0 0 18$'
        run 0 "$loft" eval --num $num --t 0 --curvature --frame "$tmp/screw.loft"
        says out '^0 0 0 0.666666667 1 1 0 0 0 1 0 0 0 1$'
        run 0 "$loft" eval --num $num --uv 0,0 --deriv --normal --curvature "$tmp/saddle.loft"
        says out '^0 0 0 1 0 0 0 1 0 0 0 0 0 0 1 0 0 0 0 0 1 -1 0 -1 1$'
        run 0 "$loft" eval --num $num --uv 0,0 --frame "$tmp/saddle.loft"
        awk '{ x = $4 * $5 + 0.5; y = $7 * $8 - 0.5; if (x * x + y * y > 1e-8) bad = 1 }
             END { exit bad }' "$tmp/out" || job_fails "directions $num: $(cat "$tmp/out")"
        run 0 "$loft" eval --num $num --frame "$tmp/sphere.loft"; says out ' none$'
        run 0 "$loft" eval --num $num --normal --curvature "$tmp/flat.loft"; says out '^2 0 none 0$'
    done
}
# numbers over triangles and tetrahedra whose answers are whole
case_simplex() {
    printf 'triangle 2\n0 0 0\n1 0 0\n0 1 0\n2 0 4\n1 1 0\n0 2 0\n' >"$tmp/tri.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide shares --num $num --of 0,0,4,0,0,4,1,2
        says out '^shares 0.25 0.25 0.5$'; says out '^area 8$'
        run 0 "$loft" decide shares --num $num --of 0,0,0,4,0,0,0,4,0,0,0,4,1,1,1
        says out '^shares 0.25 0.25 0.25 0.25$'
        run 0 "$loft" decide plane --num $num --of 0,0,3,4,5,0
        says out '^equation -4 3 0$'; says out '^distance -4$'
        run 0 "$loft" decide plane --num $num --of 0,0,1,1,0,1,0,1,1,5,5,3
        says out '^normal 0 0 1$'; says out '^distance 2$'
        run 0 "$loft" decide sphere --num $num --of=1,0,0,3,1,3,4
        says out '^value 16$'; says out '^distance 2$'; says out '^normal 0 0.6'
        run 0 "$loft" decide sphere --num $num --of=1,0,0,3,1,0,0
        says out '^distance -3$'
        printf 'bezier 2\n0 0\n3 6\n6 0\n' >"$tmp/hill.loft"
        run 0 "$loft" decide under --num $num --of 0,1 "$tmp/hill.loft"; says out '^0 12$'
        run 0 "$loft" decide under --num $num --of 1,0.5 "$tmp/hill.loft"; says out '^0 -6$'
        run 0 "$loft" decide weights --num $num --of 3,0.5
        says out '^3 0 0.125$'; says out '^1 2 0.375$'
        run 0 "$loft" decide weights --num $num --of 2,0.25,0.25
        says out '^1 1 0 0.25$'; says out '^0 0 2 0.0625$'
        run 0 "$loft" decide weights --num $num --of 1,0.25,0.25,0.25; says out '^1 0 0 0 0.25$'
        run 0 "$loft" decide solid --num $num --of 0.25,0.25,0.5,0,1,2,4
        says out '^value 2.75$'; says out '^raised 0 0.5 1 2 1 1.5 2.5 2 3 4$'
        run 0 "$loft" decide iterate --num $num --of 1,0.25,0.25,0,0,0,1,0,1
        says out '^value 0.125$'
        run 0 "$loft" decide iterate --num $num --of 0,0.25,0.25,0,0,0,1,0,1; says out '^value 0.5$'
        run 0 "$loft" decide over --num $num --of 0,0,2,0,0,2,3,3,3; says out '^integral 6$'
        run 0 "$loft" decide polar --num $num --of 1,1,0,0,1 "$tmp/tri.loft"; says out '^1 1 0$'
    done
    one_line 65 'on a line or in a plane' "$loft" decide shares --of 0,0,1,1,2,2,0,1
    one_line 65 'give a degree 0 to 9' "$loft" decide weights --of 10,0,0
}
# a grid of points of z = x y / 8 needs one bicubic patch; of a wave more; a row that is short
# A tetrahedron bent by a net of degree 3: raised it is the same, its faces close, the coordinates
# of a point are those of three fields, and its volume is that of the mesh.
case_solids() {
    awk 'BEGIN { print "tetra"
                 for (m = 0; m <= 3; m++) for (n = 0; n <= m; n++) for (l = 0; l <= n; l++) {
                     x = 3 * (m - n); y = 3 * (n - l); z = 3 * l; k++
                     print x + (k * 7) % 5 / 4, y + (k * 3) % 4 / 4, z + (k * 5) % 3 / 4 } }' \
        >"$tmp/bent.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make raise --num $num --of 2 "$tmp/bent.loft"; cp "$tmp/out" "$tmp/high.loft"
        says out '^tetra 5$'
        for file in bent high; do
            "$loft" eval --num $num --uvw 0.25,0.125,0.5,0,0,1 "$tmp/$file.loft" >"$tmp/$file.at"
            "$loft" decide volume --num $num "$tmp/$file.loft" >>"$tmp/$file.at"
        done
        paste -d' ' "$tmp/bent.at" "$tmp/high.at" |
            awk '{ for (i = 1; i <= NF / 2; i++) { d = $i - $(i + NF / 2)
                       if (d > 0.02 || d < -0.02) bad = 1 } } END { exit bad || NR != 4 }' ||
            job_fails "raised $num: $(cat "$tmp/bent.at" "$tmp/high.at")"
        for axis in 1 2 3; do
            "$loft" decide solid --num $num \
                --of="0.25,0.125,0.5$(awk -v a=$axis 'NR > 1 { printf ",%s", $a }' \
                                      "$tmp/bent.loft")"
        done 2>&1 | awk '/^value/ { printf "%s%s", sep, $2; sep = " " }
                         END { print "" }' >"$tmp/fields"
        head -1 "$tmp/bent.at" | paste -d' ' - "$tmp/fields" |
            awk '{ for (i = 1; i <= 3; i++) if (($i - $(i + 3))^2 > 1e-9) exit 1; exit NF != 6 }' ||
            job_fails "fields $num: $(cat "$tmp/fields" "$tmp/bent.at")"
    done
    run 0 "$loft" surface --num f64 --tol 0.005 -o "$tmp/bent.stl" "$tmp/bent.loft"
    says out 'Euler number 2, closed$'
    awk -v v="$(sed -n 's/^volume //p' "$tmp/bent.at")" \
        '/^volume/ { exit !(($2 + 0 - v)^2 < 0.1 && v > 50) }' "$tmp/out" ||
        job_fails "volume: $(cat "$tmp/out" "$tmp/bent.at")"
    grep -h '^centroid' "$tmp/out" "$tmp/bent.at" |
        awk 'NR == 1 { for (i = 2; i < 5; i++) c[i] = $i; next }
             { for (i = 2; i < 5; i++) if (($i - c[i]) ^ 2 > 1e-5) exit 1 } END { exit NR != 2 }' ||
        job_fails "centroid: $(cat "$tmp/out" "$tmp/bent.at")"
    run 0 "$loft" plot --control -o "$tmp/bent.png" "$tmp/bent.loft"; says out ': 4 surfaces$'
    one_line 64 'numbers: give triples' "$loft" eval --uvw 0,1 "$tmp/bent.loft"
    one_line 64 'together at most 1'    "$loft" eval --uvw 1,1,0 "$tmp/bent.loft"
    printf 'triangle 1\n0 0 0\n1 0 0\n0 1 0\n' >"$tmp/flat.loft"
    one_line 65 'uvw: is for tetra'     "$loft" eval --uvw 0,1,0 "$tmp/flat.loft"
    printf 'tetra 2\n0 0 0\n' >"$tmp/few.loft"
    one_line 65 'tetra with 1 point: give 10' "$loft" decide volume "$tmp/few.loft"
}
case_fit_surface() {
    awk 'BEGIN { for (i = 0; i <= 8; i++) { for (j = 0; j <= 9; j++) print i, j, i * j / 8
                                            print "" } }' >"$tmp/saddle.csv"
    awk 'BEGIN { for (i = 0; i <= 24; i++) { for (j = 0; j <= 20; j++)
                     print i, j, 3 * sin(i / 3) * cos(j / 4)
                     print "" } }' >"$tmp/wave.csv"
    { cat "$tmp/saddle.csv"; echo 9 9 9; } >"$tmp/short.csv"
    for num in q16 f32 f64; do
        run 0 "$loft" fit --surface --num $num --tol 0.001 "$tmp/saddle.csv"
        says out '^nurbs-surface 3 3 4 4$'; says out '^8 9 9$'
        "$loft" fit --surface --num $num --tol 0.02 "$tmp/wave.csv" >"$tmp/wave.loft"
        run 0 "$loft" eval --num $num --uv 0,0,1,1 "$tmp/wave.loft"; says out '^0 0 0$'
        run 0 "$loft" decide nearest --num $num --of 12,10,1.8189 "$tmp/wave.loft"
        awk '{ exit !($7 < 0.03) }' "$tmp/out" || job_fails "wave $num: $(cat "$tmp/out")"
    done
    one_line 65 'a row of 1 points after rows of 10' "$loft" fit --surface "$tmp/short.csv"
    printf '0 0 0\n1 0 0\n' >"$tmp/one.csv"
    one_line 65 '2 points in one row: give 4 or more' "$loft" fit --surface "$tmp/one.csv"
    one_line 65 'two rows or columns are one' "$loft" fit --surface \
        <(cat "$tmp/one.csv"; echo; cat "$tmp/one.csv")
}
# the wave again, in no order and turned by 30 degrees; what a plane does not show, or not all over
case_fit_scattered() {
    awk 'BEGIN { srand(7); n = 600
                 for (k = 0; k < n; k++) {
                     x = k < 100 ? (k % 10) / 9 * 10 : 10 * rand()
                     y = k < 100 ? int(k / 10) / 9 * 8 : 8 * rand()
                     z = sin(x / 2) * cos(y / 3)
                     printf "%.6f,%.6f,%.6f\n", x * cos(.5236) - y * sin(.5236),
                            x * sin(.5236) + y * cos(.5236), z } }' >"$tmp/cloud.csv"
    for num in q16 f32 f64; do
        "$loft" fit --surface --num $num --tol 0.02 "$tmp/cloud.csv" >"$tmp/cloud.loft" ||
            job_fails "cloud $num"
        grep -qE '^# .* for 600 points in no order, within 0.0[01]' "$tmp/cloud.loft" ||
            job_fails "cloud $num: $(tail -1 "$tmp/cloud.loft")"
        # a place that was no point: x = 5, y = 4
        run 0 "$loft" decide nearest --num $num --of 2.330148,5.964076,0.140792 "$tmp/cloud.loft"
        awk '{ exit !($7 < 0.03) }' "$tmp/out" || job_fails "cloud $num: $(cat "$tmp/out")"
    done
    # the same points in another order: the same surface
    sort "$tmp/cloud.csv" | "$loft" fit --surface --tol 0.02 - | tail -1 >"$tmp/sorted"
    "$loft" fit --surface --tol 0.02 "$tmp/cloud.csv" | tail -1 | diff - "$tmp/sorted" ||
        job_fails "the order counts"
    # three lines tell three control points of four; a disc leaves corners of a finer net empty
    one_line 65 'do not tell 4 of 16 control points' "$loft" fit --surface <(awk 'BEGIN {
        for (k = 0; k < 60; k++) print k % 3, k / 20, k % 3 }')
    one_line 65 'do not tell [0-9]* of a finer net' "$loft" fit --surface --tol 0.002 <(awk 'BEGIN {
        srand(3); for (k = 0; k < 2000; k++) { x = 2 * rand() - 1; y = 2 * rand() - 1
            if (x * x + y * y < 1) print 20 * x, 20 * y, 5 * sqrt(1.5 - x * x - y * y) } }')
    one_line 65 'lie on a line' "$loft" fit --surface <(awk 'BEGIN { for (k = 0; k < 9; k++)
        print k, 2 * k, -k }')
    one_line 65 'stays [0-9.e-]* from a point' "$loft" fit --surface --tol 0.00001 "$tmp/cloud.csv"
}
# a parabola as a B-spline with five inner knots needs none
case_thin() {
    { echo 'bspline 2'
      printf '0 0\n0.5 0\n1.5 2\n2.5 6\n3.5 12\n4.5 20\n5.5 30\n6 36\n'
      echo 'knots 0 0 0 1 2 3 4 5 6 6 6'; } >"$tmp/many.loft"
    sed 's/2.5 6/2.5 9/' "$tmp/many.loft" >"$tmp/bump.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make thin --num $num --of 0.001 "$tmp/many.loft"
        says out '^bspline 2$'; says out '^6 36$'; says out '^knots 0 0 0 6 6 6$'
        run 0 "$loft" make thin --num $num --of 0.001 "$tmp/bump.loft"
        says out '^2.5 9$'; says out '^knots 0 0 0 1 2 3 4 6$'; says out '^knots 6 6$'
    done
    # with weights: none goes for nothing; the last one would need a weight out of range
    { echo 'nurbs 2'
      printf '1 0 : 1\n1 0.6 : 1\n0.6 1 : 1.25\n0 1 : 1.5\n-1 1 : 1\n-1 0 : 2\n'
      echo 'knots 0 0 0 1 2 3 4 4 4'; } >"$tmp/weighted.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make thin --num $num --of 0 "$tmp/weighted.loft"
        says out '^nurbs 2$'; says out '^knots 0 0 0 1 2 3 4 4'
        run 0 "$loft" make thin --num $num --of 100 "$tmp/weighted.loft"
        says out '^nurbs 2$'; says out '^knots 0 0 0 3 4 4 4$'; says out '^1 0 : 1$'
    done
    one_line 65 'is no `bspline`' "$loft" make thin --of 1 tests/drawings/curves.loft
    # a knot more changes nothing: the points at 0 and 1.5 are as before
    for num in q16 f32 f64; do
        "$loft" eval --num $num --t 0,1.5,6 "$tmp/many.loft" >"$tmp/before"
        run 0 "$loft" make insert --num $num --of 1.5,1.5,4 "$tmp/many.loft"
        says out '^bspline 2$'; says out '^knots 0 0 0 1 1.5 1.5 2 3$'
        cp "$tmp/out" "$tmp/more.loft"
        run 0 "$loft" eval --num $num --t 0,1.5,6 "$tmp/more.loft"
        diff "$tmp/before" "$tmp/out" >/dev/null || job_fails "insert $num: $(cat "$tmp/out")"
    done
    one_line 65 'a knot beyond the curve' "$loft" make insert --of 7 "$tmp/many.loft"
}
# (2 t - 1)^5 over t has a flat inflection; a circle is none; a loop of degree 5, and one of two
# pieces
case_shape_of_any_degree() {
    printf 'bezier 5\n0 -1\n1 1\n2 -1\n3 1\n4 -1\n5 1\n' >"$tmp/flat.loft"
    printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : 2\n' >"$tmp/round.loft"
    printf 'bezier 5\n0 0\n8 0\n16 16\n-8 16\n0 0\n8 0\n' >"$tmp/loop.loft"
    printf 'line\n0 0\n8 0\n8 8\n4 -4\n' >"$tmp/bent.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide inflections --num $num "$tmp/flat.loft"
        says out '^0 t 0.5 inflection, multiplicity 3$'
        run 0 "$loft" decide inflections --num $num "$tmp/round.loft"
        [ ! -s "$tmp/out" ] || job_fails "round $num: $(cat "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.001 "$tmp/loop.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "loop $num: $(cat "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.001 "$tmp/bent.loft"
        says out '^0 2 0.666666' ; says out ' at 5.3333'
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "bent $num: $(cat "$tmp/out")"
    done
    one_line 65 'a tolerance of 0' "$loft" decide loops --of 0 "$tmp/loop.loft"
    # a cubic with a loop, its projection by 1 + x / 8; two quarters of a circle and a part that
    # crosses the first one
    printf 'bezier 3\n0 0\n8 8\n-4 8\n4 0\n' >"$tmp/plain.loft"
    printf 'rational 3\n0 0 : 1\n4 4 : 2\n-8 16 : 0.5\n2.6666667 0 : 1.5\n' >"$tmp/weighted.loft"
    { printf 'nurbs 2\n5 0 : 1\n5 5 : 0.70710678\n0 5 : 1\n-5 5 : 0.70710678\n-5 0 : 1\n'
      printf -- '-4 -1 : 1\n8 4 : 1\nknots 0 0 0 1 1 2 2 3 3 3\n'; } >"$tmp/arch.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/plain.loft"
        cut -d' ' -f3,4 "$tmp/out" >"$tmp/at"
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/weighted.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "weighted $num: $(cat "$tmp/out")"
        paste -d' ' "$tmp/at" "$tmp/out" |
            awk '{ exit !(($1 - $5) ^ 2 + ($2 - $6) ^ 2 < 1e-10) }' ||
            job_fails "weighted $num: $(cat "$tmp/at" "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/arch.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "arch $num: $(cat "$tmp/out")"
        says out '^0 2 '
    done
}
# an octant of radius 8 and the plane z = 3 meet in a quarter of a circle, a line in one place; two
# equal parabolas across each other in the diagonals of their square
case_meet() {
    printf 'octant 8\ntensor 1 1\n-3 -5 3\n-3 20 3\n20 -5 3\n20 20 3\n' >"$tmp/cut.loft"
    printf 'line\n1 2 -1\n1 2 20\n' >"$tmp/line.loft"
    printf 'octant 8\n' >"$tmp/octant.loft"
    printf 'tensor 2 1\n-4 -4 6\n-4 4 6\n0 -4 10\n0 4 10\n4 -4 6\n4 4 6\n' >"$tmp/cross.loft"
    printf 'tensor 2 1\n-4 -4 6\n4 -4 6\n-4 0 10\n4 0 10\n-4 4 6\n4 4 6\n' >>"$tmp/cross.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/cut.loft"
        awk '/^line/ { n++; next }
             { r = $1 * $1 + $2 * $2 - 55; if (r * r > 1e-6 || ($3 - 3) * ($3 - 3) > 1e-9) bad = 1 }
             $1 < 1e-4 { ends++ } $2 < 1e-4 { ends++ }
             END { exit bad || n != 1 || ends != 2 }' "$tmp/out" ||
            job_fails "arc $num: $(cat "$tmp/out")"
        cp "$tmp/out" "$tmp/arc.loft"
        run 0 "$loft" stream --dry-run "$tmp/arc.loft"
        run 0 "$loft" decide pierce --num $num --of 0.01 "$tmp/line.loft" "$tmp/octant.loft"
        awk '{ z = $NF - sqrt(59) } END { exit NR != 1 || z > 1e-3 || z < -1e-3 }' "$tmp/out" ||
            job_fails "pierce $num: $(cat "$tmp/out")"
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/cross.loft"
        awk '/^[^-0-9]/ { next }
             { d = $1 * $1 - $2 * $2; if (d > 0.05 || d < -0.05) bad = 1
               if ($1 * $1 > 15.999) corner[($1 > 0) ($2 > 0)] = 1 }
             END { exit bad || length(corner) != 4 }' "$tmp/out" ||
            job_fails "cross $num: $(cat "$tmp/out")"
    done
    # a plane cuts a sphere in one circle over four octants; two spheres meet in one circle; lines
    # over spans end on the border
    printf 'sphere 8\n0 0 0\ntensor 1 1\n-9 -10 3\n-9 20 3\n20 -10 3\n20 20 3\n' >"$tmp/ball.loft"
    printf 'sphere 5\n0 0 0\nsphere 5\n6 0 0\n' >"$tmp/balls.loft"
    { echo 'nurbs-surface 2 2 5 4'
      awk 'BEGIN { for (i = 0; i < 5; i++) for (j = 0; j < 4; j++)
                       print 4 * i, 5 * j, (i * j * 7 + i * 3) % 5 }'
      echo 'knots u 0 0 0 1 2 3 3 3'; echo 'knots v 0 0 0 1 2 2 2'
      printf 'tensor 1 1\n-9 -10 1.5\n-9 20 1.5\n30 -10 2\n30 20 2\n'; } >"$tmp/spans.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/ball.loft"
        awk '/^line/ { n++; next }
             { r = $1 * $1 + $2 * $2 - 55; if (r * r > 1e-6) bad = 1; last = $0 }
             n == 1 && first == "" { first = $0 }
             END { exit bad || n != 1 || first != last }' "$tmp/out" ||
            job_fails "ball $num: $(cat "$tmp/out")"
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/spans.loft"
        awk 'function check() { if ($1 > 1e-3 && $1 < 15.999 && $2 > 1e-3 && $2 < 14.999) bad = 1 }
             /^line/ { if (n++) { $0 = last; check() } getline; check() } { last = $0 }
             END { $0 = last; check(); exit bad || n != 4 }' "$tmp/out" ||
            job_fails "spans $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make meet --of 0.01 "$tmp/balls.loft"
    awk '/^line/ { n++; next }
         { r = $2 * $2 + $3 * $3 - 16; if (r * r > 1e-6 || ($1 - 3) * ($1 - 3) > 1e-7) bad = 1 }
         END { exit bad || n != 1 }' "$tmp/out" || job_fails "balls: $(cat "$tmp/out")"
    run 0 "$loft" decide pierce --of 0.01 "$tmp/line.loft" "$tmp/ball.loft"
    says out '^0 0 .* v 0.17620819' ; says out ' at 1 2 3$'
    cat "$tmp/cut.loft" "$tmp/octant.loft" >"$tmp/twice.loft"
    run 0 "$loft" make meet --of 0.01 "$tmp/twice.loft"
    grep -q 'surfaces 0 and 2 coincide' "$tmp/out" || job_fails "twice: $(cat "$tmp/out")"
    # a pentagon, z = 12 - 3 (x^2 + y^2) / 100 at its net, as triangles of degree 6; the plane x = 3
    awk 'BEGIN { print "spatch 5 2"; a = atan2(0, -1)
                 for (i = 0; i < 5; i++) for (j = i; j < 5; j++) {
                     x = 10 * (cos(a * (0.5 + 0.4 * i)) + cos(a * (0.5 + 0.4 * j)))
                     y = 10 * (sin(a * (0.5 + 0.4 * i)) + sin(a * (0.5 + 0.4 * j)))
                     printf "%.9f %.9f %.9f\n", x, y, 12 - 3 * (x * x + y * y) / 100 } }' \
        >"$tmp/five.loft"
    { cat "$tmp/five.loft"; printf 'tensor 1 1\n3 -30 -9\n3 -30 30\n3 30 -9\n3 30 30\n'; } \
        >"$tmp/wall.loft"
    for num in f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/wall.loft"
        awk '/^line/ { n++; next } { if (($1 - 3) * ($1 - 3) > 1e-6) bad = 1 }
             END { exit bad || n != 1 || NR < 10 }' "$tmp/out" ||
            job_fails "wall $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make patches --num f64 "$tmp/five.loft"; cp "$tmp/out" "$tmp/parts.loft"
    [ "$(grep -c 'triangle 6' "$tmp/parts.loft")" = 5 ] || job_fails "patches: $(cat "$tmp/out")"
    for file in five parts; do
        "$loft" decide area --num f64 --of 0.01 "$tmp/$file.loft" >"$tmp/$file.txt"
    done
    awk 'FNR < NR { sum -= $3; next } { sum = $3 } END { exit !(sum < 0.1 && sum > -0.1) }' \
        "$tmp/five.txt" "$tmp/parts.txt" || job_fails "areas: $(cat "$tmp"/{five,parts}.txt)"
    { sed 's/spatch 5 2/spatch 5 2 meanvalue/' "$tmp/five.loft"; cat "$tmp/octant.loft"; } \
        >"$tmp/other.loft"
    one_line 65 'give wachspress coordinates' "$loft" make meet --of 0.01 "$tmp/other.loft"
    one_line 65 'no two surfaces meet'     "$loft" make meet --of 0.01 "$tmp/octant.loft"
    one_line 65 'a tolerance of 0'         "$loft" make meet --of 0 "$tmp/cut.loft"
    one_line 64 'give a file of curves, then one of surfaces' \
        "$loft" decide pierce --of 0.01 "$tmp/line.loft"
}
# toric patches and those with base points as tensor products: the place that is printed is that of
# `loft eval`, and the plane x = 7 cuts in it
case_quarters() {
    printf 'toric\ndomain 0 0  1 0  2 1  2 2  1 2  0 1\n0 0 0\n9 0 4 : 2\n' >"$tmp/six.loft"
    printf '0 9 1\n9 9 8 : 1 3\n18 9 2\n9 18 3\n18 18 -1 : 3\n' >>"$tmp/six.loft"
    printf 'basepoint 3 1 1 1\n6 0 1\n3 0 2\n6 3 3 : 2\n3 3 9\n0 3 2\n3 6 1\n0 6 -1\n' \
        >"$tmp/base.loft"
    for file in six.loft base.loft; do
        run 0 "$loft" decide nearest --num f64 --of 4,3,30 "$tmp/$file"
        place=$(awk '{ print $3 "," $5 }' "$tmp/out"); sed 's/.* at //' "$tmp/out" >"$tmp/near.txt"
        run 0 "$loft" eval --num f64 --uv "$place" "$tmp/$file"
        paste -d ' ' "$tmp/near.txt" "$tmp/out" |
            awk '{ for (i = 1; i < 4; i++) if (($i - $(i + 3)) ^ 2 > 1e-12) exit 1 }' ||
            job_fails "$file: the place of the nearest point: $(cat "$tmp/near.txt" "$tmp/out")"
    done
    { cat "$tmp/six.loft"; printf 'tensor 1 1\n7 -30 -9\n7 -30 30\n7 30 -9\n7 30 30\n'; } \
        >"$tmp/wall.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/wall.loft"
        awk '/^line/ { n++; next } { if (($1 - 7) * ($1 - 7) > 1e-6) bad = 1 }
             END { exit bad || n != 1 || NR < 10 }' "$tmp/out" ||
            job_fails "six, $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make patches --num f64 "$tmp/six.loft"
    [ "$(grep -c 'tensor 2 2' "$tmp/out")" = 6 ] || job_fails "quarters: $(cat "$tmp/out")"
    { printf 'toric\ndomain 0 0  10 0  0 1\n'; seq 12; } | sed 's/^[0-9]*$/& 0 0/' \
        >"$tmp/wide.loft"
    one_line 65 'higher than 9 over a side' "$loft" decide area "$tmp/wide.loft"
    printf 'toric\ndomain 0 0  1 0  0 1\n0 0 0 : 1 0.01\n9 0 3 : 256 30000\n0 9 4 : 256 30000\n' \
        >"$tmp/steep.loft"
    cat "$tmp/steep.loft" "$tmp/six.loft" >"$tmp/both.loft"
    one_line 65 'differ by over 2.15' "$loft" make meet --of 0.01 "$tmp/both.loft"
}
# z = (x^2 + y^2) / 8 over -8..8: the plane x + y = 4 cuts it within that plane; the silhouette from
# (1, 1, 0) is the line x + y = 0; the normal has 60 degrees to z on the circle of radius 4 sqrt 3
case_sections_and_silhouettes() {
    printf 'tensor 2 2\n-8 -8 16\n-8 0 0\n-8 8 16\n0 -8 0\n0 0 -16\n0 8 0\n' >"$tmp/bowl.loft"
    printf '8 -8 16\n8 0 0\n8 8 16\n' >>"$tmp/bowl.loft"
    lines_where() {         # EXPRESSION of x, y, z that is 0
        awk '/^line/ { n++; next } NF { x = $1; y = $2; z = $3; off = '"$1"'
               if (off > 2e-3 || off < -2e-3 || (z - (x * x + y * y) / 8) ^ 2 > 1e-8) exit 1 }
             END { exit n != 1 }' "$tmp/out" || job_fails "$num, $1: $(head -5 "$tmp/out")"
    }
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --along 1,1,0 --heights 2.8284271247 "$tmp/bowl.loft"
        lines_where 'x + y - 4'
        run 0 "$loft" contour --num $num --tol 0 --light 1,1,0 "$tmp/bowl.loft"
        lines_where 'x + y'
        run 0 "$loft" contour --num $num --tol 0 --light 0,0,5 --heights 60 "$tmp/bowl.loft"
        lines_where 'sqrt(x * x + y * y) - 4 * sqrt(3)'
    done
    printf 'sphere 5\n' >"$tmp/ball.loft"
    # the normal of a sphere has 60 degrees to z on the circle at z = r/2; it has a silhouette, as
    # have patches with n sides
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --tol 0 --light 0,0,1 --heights 60 "$tmp/ball.loft"
        awk '/^line/ { n++; next } NF { r = $1 * $1 + $2 * $2 - 18.75
                 if (r * r > 1e-5 || ($3 - 2.5) ^ 2 > 1e-6) bad = 1 } END { exit bad || n != 1 }' \
            "$tmp/out" || job_fails "isophote of a ball $num: $(head -5 "$tmp/out")"
        run 0 "$loft" contour --num $num --light 1,0,0 "$tmp/ball.loft"
        awk '/^line/ { n++; next } NF { if ($1 * $1 > 1e-6) bad = 1 } END { exit bad || n != 1 }' \
            "$tmp/out" || job_fails "silhouette of a ball $num: $(head -5 "$tmp/out")"
    done
    run 0 "$loft" contour --light 1,0,0 tests/drawings/sided.loft
    says out '^line'
    one_line 64 'a direction X,Y,Z'      "$loft" contour --along 0,0,0 "$tmp/bowl.loft"
    one_line 64 'give one of them'  "$loft" contour --along 1,0,0 --light 1,0,0 "$tmp/bowl.loft"
    one_line 65 'no normal has such'     "$loft" contour --light 0,0,1 "$tmp/bowl.loft"
}
# Parts of an octant keep its radius; spans of a NURBS surface keep its points.
case_patches_with_weights() {
    printf 'octant 20\n' >"$tmp/octant.loft"
    printf 'nurbs-surface 2 1 4 2\n0 0 0\n0 8 1\n9 0 5 : 2\n9 8 5\n20 0 0\n' >"$tmp/nurbs.loft"
    printf '20 8 3\n30 0 0\n30 8 3\n' >>"$tmp/nurbs.loft"
    for num in q16 f32 f64; do
        "$loft" make raise --num $num --of 2 "$tmp/octant.loft" >"$tmp/high.loft"
        "$loft" make split --num $num --of 0.3,0.4 "$tmp/high.loft" >"$tmp/parts.loft"
        [ "$(grep -c '^triangle 6' "$tmp/parts.loft")" = 3 ] || job_fails "$num: three parts"
        run 0 "$loft" eval --num $num --uv 0.2,0.3 "$tmp/parts.loft"
        awk 'NF { n++; off = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2) - 20; if (off ^ 2 > 1e-6) exit 1 }
             END { exit n != 3 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        "$loft" make patches --num $num "$tmp/nurbs.loft" >"$tmp/spans.loft"
        [ "$(grep -c '^tensor 2 1' "$tmp/spans.loft")" = 2 ] || job_fails "$num: two spans"
        run 0 "$loft" eval --num $num --uv 0.25,0.5,0.75,0.5 "$tmp/nurbs.loft"
        cp "$tmp/out" "$tmp/want"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/spans.loft"
        grep . "$tmp/out" | paste -d ' ' - "$tmp/want" | awk '{ for (i = 1; i <= 3; i++)
            if (($i - $(i + 3)) ^ 2 > 1e-8) exit 1 } END { exit NR != 2 }' ||
            job_fails "spans $num: $(cat "$tmp/out" "$tmp/want")"
        "$loft" make split --num $num --of 0.3,0.4 "$tmp/spans.loft" >"$tmp/parts.loft"
        [ "$(grep -c '^tensor 2 1' "$tmp/parts.loft")" = 8 ] || job_fails "$num: eight parts"
    done
    printf 'sphere 5\n' >"$tmp/ball.loft"
    "$loft" make patches "$tmp/ball.loft" >"$tmp/parts.loft"
    [ "$(grep -c '^tensor 2 2' "$tmp/parts.loft")" = 8 ] || job_fails 'eight octants of a sphere'
    run 0 "$loft" eval --uv 0.2,0.3 "$tmp/parts.loft"
    awk 'NF { n++; if ((sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2) - 5) ^ 2 > 1e-8) exit 1 }
         END { exit n != 8 }' "$tmp/out" || job_fails "octants: $(cat "$tmp/out")"
}
case_normals_and_curvatures() {         # of a sphere; of z = 32 x (10 - x) y (10 - y) / 10^4 on top
    printf 'sphere 10\n' >"$tmp/ball.loft"
    printf 'tensor 2 2\n0 0 0\n0 5 0\n0 10 0\n5 0 0\n5 5 8\n5 10 0\n10 0 0\n10 5 0\n10 10 0\n' \
        >"$tmp/hill.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --normal --uv 0.2,0.3,0.7,0.6 --num $num "$tmp/ball.loft"
        awk 'function off(a, b) { return a > b ? a - b : b - a }
            { for (i = 1; i <= 3; i++) if (off($i, 10 * $(i + 3)) > 1e-4) exit 1
              if (off($7, 0.01) > 1e-6 || off($8, -0.1) > 1e-6) exit 1 }
            END { exit NR != 2 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" eval --normal --num $num "$tmp/hill.loft"
        awk 'function off(a, b) { return a > b ? a - b : b - a }
            { exit off($6, 1) > 1e-6 || off($7, 0.0256) > 1e-6 || off($8, -0.16) > 1e-6 }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
}
case_compare_with() {
    printf 'bezier 3\n0 0\n10 30\n40 -20\n50 10\n' >"$tmp/curve.loft"
    printf 'triangle 2\n0 0 9\n10 0 2\n0 10 5\n20 0 4\n10 10 8\n0 20 3\n' >"$tmp/tri.loft"
    printf 'tensor 1 2\n0 0 0\n0 9 4\n0 20 0\n20 0 3\n20 9 9\n20 20 0\n' >"$tmp/ten.loft"
    printf 'sphere 10\n' >"$tmp/ball.loft"
    # at most BOUND LSB
    within() {
        awk -v b="$1" '!/^#/ { n++; if (!($5 <= b)) exit 1 } END { exit !n }' "$tmp/out" ||
            job_fails "$num, bound $1: $(cat "$tmp/out")"
    }
    for num in q16 f32 f64; do
        for name in curve tri ten; do
            "$loft" make raise --num $num --of 2 "$tmp/$name.loft" >"$tmp/more.loft"
            run 0 "$loft" compare --num $num --with "$tmp/$name.loft" "$tmp/more.loft"
            within 16                   # f64: the walk of degree 5, 11
            run 0 "$loft" compare --num $num "$tmp/$name.loft"; within 16
        done
        "$loft" make split --num $num --of 0.25,0.625 "$tmp/curve.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/curve.loft" --part 0,0.25,0.625,1 \
            "$tmp/parts.loft"; within 16
        "$loft" make split --num $num --of 0.25,0.5 "$tmp/ten.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/ten.loft" --part \
            0,0,0.25,0.5,0,0.5,0.25,1,0.25,0,1,0.5,0.25,0.5,1,1 "$tmp/parts.loft"; within 4
        "$loft" make quarter --num $num "$tmp/tri.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/tri.loft" --part \
            0,0,.5,0,0,.5,.5,0,1,0,.5,.5,0,.5,.5,.5,0,1,.5,.5,0,.5,.5,0 "$tmp/parts.loft"; within 4
        run 0 "$loft" compare --num $num --quadric=1,1,1,0,0,0,0,0,0,-100 "$tmp/ball.loft"
        within 4
        run 0 "$loft" compare --num $num --quadric=1,1,1,0,0,0,0,0,0,-100.01 "$tmp/ball.loft"
        awk '!/^#/ && $7 > 0.000499 && $7 < 0.00053 { n++ } END { exit n != 1 }' "$tmp/out" ||
            job_fails "a sphere that is larger by 0.0005: $(cat "$tmp/out")"
        "$loft" make continue --num $num --of 1,1 "$tmp/tri.loft" >"$tmp/next.loft"
        cat "$tmp/tri.loft" "$tmp/next.loft" >"$tmp/both.loft"
        run 0 "$loft" decide join --num $num --of 1,1 "$tmp/both.loft"; says out 'to order 2$'
        cat "$tmp/ten.loft" "$tmp/ten.loft" >"$tmp/both.loft"
        run 0 "$loft" decide join --num $num "$tmp/both.loft"; says out '^0 1 C0 no C1 no G1 no$'
    done
    one_line 64 'give one of --against' "$loft" compare --with "$tmp/tri.loft" --against f64 \
        "$tmp/tri.loft"
    one_line 64 'give 10' "$loft" compare --quadric 1,2 "$tmp/ball.loft"
    one_line 64 'give 6 for each' "$loft" compare --with "$tmp/tri.loft" --part 0,0 "$tmp/tri.loft"
    one_line 65 'as many' "$loft" compare --num f64 --with "$tmp/tri.loft" "$tmp/parts.loft"
    one_line 65 'no definition here' "$loft" compare tests/drawings/sided.loft
    one_line 65 'without weights' "$loft" make quarter "$tmp/ball.loft"
}
case_figures() {
    for num in q16 f32 f64; do
        run 0 "$loft" figures --num $num --brief --no-pictures -o "$tmp/$num"; is_empty err
        says out "numbers in $num, 0 of them beyond their bounds"
    done
    for name in $("$loft" figures --list | cut -d ' ' -f 1); do
        grep -q "<h2 id=\"$name\">" "$tmp/q16/index.html" || job_fails "$name is missing"
    done
    run 0 "$loft" figures --brief -o "$tmp/few" family triangle-split wachspress
    for name in family.svg triangle-split.png wachspress.png; do
        [ -s "$tmp/few/$name" ] || job_fails "$name is missing"
    done
    run 0 "$loft" figures -o "$tmp/one" polygon
    [ "$(ls "$tmp/one")" = "$(printf 'index.html\npolygon.loft\npolygon.svg')" ] ||
        job_fails "other files than those of one figure: $(ls "$tmp/one")"
    one_line 64 'no such figure' "$loft" figures -o "$tmp/one" nothing
    one_line 73 'name another folder' "$loft" figures -o "$tmp/one/polygon.svg/x"
}
case_make() {
    for num in q16 f32 f64; do
        printf 'bezier 2\n0 0\n4 8\n12 0\n' >"$tmp/curve.loft"
        run 0 "$loft" make raise --num $num --of 2 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/raised.loft"; says out '^bezier 4'
        run 0 "$loft" make lower --num $num --of 2 "$tmp/raised.loft"
        grep -v '#' "$tmp/out" | cmp -s - "$tmp/curve.loft" ||
            job_fails "raised and lowered, $num: $(cat "$tmp/out")"
        run 0 "$loft" make split --num $num --of 0.25 "$tmp/curve.loft"
        [ "$(sed -n 4p "$tmp/out")" = "2.25 3" ] || job_fails "split $num: $(cat "$tmp/out")"
        "$loft" make reverse --num $num "$tmp/out" >"$tmp/back.loft"
        run 0 "$loft" make reverse --num $num "$tmp/back.loft"
        [ "$(sed -n 2p "$tmp/out")" = "0 0" ] || job_fails "reverse $num: $(cat "$tmp/out")"
        printf 'bezier 1\n0 0 3\n9 0 3\nbezier 2\n0 9 0\n4 9 0\n9 9 0\n' >"$tmp/two.loft"
        for verb in ruled skin; do
            "$loft" make $verb --num $num "$tmp/two.loft" >"$tmp/$verb.loft" 2>"$tmp/err"
            run 0 "$loft" eval --num $num --uv 0,0.5 "$tmp/$verb.loft"
            [ "$(cat "$tmp/out")" = "0 4.5 1.5" ] ||
                job_fails "$verb $num: $(cat "$tmp/out" "$tmp/err")"
        done
        printf 'bezier 1\n5 0 0\n5 0 4\n' >"$tmp/line.loft"
        "$loft" make revolve --num $num "$tmp/line.loft" >"$tmp/tube.loft"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/tube.loft"
        awk 'NF == 3 { r = sqrt($1 * $1 + $2 * $2); n++
                       if (r < 4.9999 || r > 5.0001 || $3 != 2) exit 1 }
             END { exit n != 4 }' "$tmp/out" || job_fails "revolve $num: $(cat "$tmp/out")"
    done
    one_line 64 'not known to make' "$loft" make nothing "$tmp/curve.loft"
    one_line 65 'piece 0, of degree 2, goes to degree 32: give --of 1 to 30' \
        "$loft" make raise --of 31 "$tmp/curve.loft"
    "$loft" make raise --of 30 "$tmp/curve.loft" >"$tmp/high.loft"      # for drawings
    run 0 "$loft" plot --control --comb -o "$tmp/high.svg" "$tmp/high.loft"
    run 0 "$loft" plan --total "$tmp/high.loft"; cp "$tmp/out" "$tmp/total"
    run 0 "$loft" plan --total "$tmp/curve.loft"
    cmp -s "$tmp/out" "$tmp/total" || job_fails "a raised curve: $(cat "$tmp/out" "$tmp/total")"
    one_line 65 'only drawings take up to 32' "$loft" eval --t 0.5 "$tmp/high.loft"
    printf 'rational 2\n1 0\n1 1 : 0.7\n0 1\n' >"$tmp/weighted.loft"
    one_line 65 'with weights, goes to degree 18' "$loft" make raise --of 17 "$tmp/weighted.loft"
    one_line 64 'raise: --of has 2 numbers' "$loft" make raise --of 1,2 "$tmp/curve.loft"
    printf 'triangle 2\n0 0 9\n10 0 2\n0 10 5\n20 0 4\n10 10 8\n0 20 3\n' >"$tmp/tri.loft"
    printf 'tensor 1 2\n0 0 0\n0 9 4 : 2\n0 20 0\n20 0 3\n20 9 9\n20 20 0\n' >"$tmp/ten.loft"
    one_line 65 'surface 0, of degree 2, goes to degree 32: give --of 1 to 30' \
        "$loft" make raise --of 31 "$tmp/tri.loft"
    one_line 65 'with weights, goes to degree 18' "$loft" make raise --of 17 "$tmp/ten.loft"
    "$loft" make raise --of 30 "$tmp/tri.loft" >"$tmp/high.loft"
    "$loft" make raise --of 16 "$tmp/ten.loft" >>"$tmp/high.loft"
    [ "$(grep -c . "$tmp/high.loft")" = $((1 + 561 + 1 + 18 * 19)) ] || job_fails 'raised nets'
    run 0 "$loft" plot --control --curvature mean -o "$tmp/high.png" "$tmp/high.loft"
    one_line 65 'only `loft plot` takes up to 32' "$loft" eval --uv 0.5,0.5 "$tmp/high.loft"
}
case_make_surfaces_of_curves() {
    for num in q16 f32 f64; do
        printf 'bezier 2\n5 0\n5 5\n0 5\nline\n0 0 0\n20 0 0\n40 0 0\n' >"$tmp/pipe.loft"
        head -4 "$tmp/pipe.loft" >"$tmp/curve.loft"
        "$loft" make sweep --num $num --of 3 "$tmp/pipe.loft" >"$tmp/swept.loft"
        run 0 "$loft" eval --num $num --uv 1,1 "$tmp/swept.loft"
        [ "$(grep . "$tmp/out" | tr '\n' ,)" = "20 -5 0,40 -5 0," ] ||
            job_fails "sweep $num: $(cat "$tmp/out")"
        printf 'arc left\n%d 0 %d\n0 0 %d\n0 %d %d\n' 20 0 0 20 0 20 9 9 20 9 >"$tmp/four.loft"
        printf 'line\n20 0 0\n20 0 9\nline\n0 20 0\n0 20 9\n' >>"$tmp/four.loft"
        "$loft" make coons --num $num "$tmp/four.loft" >"$tmp/coons.loft"
        run 0 "$loft" eval --num $num --uv 0.3,0.5 "$tmp/coons.loft"
        awk 'NF { r = sqrt($1 * $1 + $2 * $2); n++
               if (r < 19.9998 || r > 20.0002 || $3 < 4.4999 || $3 > 4.5001) exit 1 }
             END { exit n < 1 }' "$tmp/out" || job_fails "coons $num: $(cat "$tmp/out")"
        "$loft" make gordon --num $num --of 3 "tests/drawings/network.loft" >"$tmp/gordon.loft"
        run 0 "$loft" eval --num $num --uv 1,1 "$tmp/gordon.loft"
        [ "$(head -1 "$tmp/out")" = "20 20 12" ] || job_fails "gordon $num: $(cat "$tmp/out")"
        for i in 0 10 20; do
            printf 'line\n%d 0 0\n%d 10 %d\n%d 20 %d\n' $i $i $i $i $((2 * i))
        done >"$tmp/grid.loft"
        for verb in adini bessel; do
            "$loft" make $verb --num $num "$tmp/grid.loft" >"$tmp/$verb.loft"
            run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/$verb.loft"
            awk 'NF { n++; off = $3 - $1 * $2 / 10; if (off > 1e-4 || off < -1e-4) exit 1 }
                 END { exit n != 4 }' "$tmp/out" || job_fails "$verb $num: $(cat "$tmp/out")"
        done
        run 0 "$loft" make ferguson --num $num "$tmp/grid.loft"; says out '^bicubic'
    done
    one_line 65 'stations' "$loft" make sweep --of 1 "$tmp/pipe.loft"
    one_line 65 'starts along the direction' "$loft" make sweep --of 3,1,0,0 "$tmp/pipe.loft"
    one_line 65 'give two paths' "$loft" make sweep --of 3 "$tmp/curve.loft"
    one_line 65 'give four' "$loft" make coons "$tmp/pipe.loft"
    sed '$s/.*/0 20 8/' "$tmp/four.loft" >"$tmp/apart.loft"
    one_line 65 'curves 2 and 4 do not meet' "$loft" make gordon --of 2 "$tmp/apart.loft"
    one_line 65 '2 curves, 2 of them along u' "$loft" make gordon --of 2 "$tmp/pipe.loft"
    one_line 65 'curve 3 has 2 points, the first one 3' "$loft" make bessel "$tmp/four.loft"
}
case_make_patches_that_join() {
    for num in q16 f32 f64; do
        { printf 'coons slopes 3 3\n0 0\n10 0\n20 0\n30 0\n0 30\n10 30\n20 30\n30 30\n'
          printf '0 30 0\n0 30 6\n0 30 6\n0 30 0\n0 30 0\n0 30 -6\n0 30 -6\n0 30 0\n'
          printf '0 0\n0 10\n0 20\n0 30\n30 0\n30 10\n30 20\n30 30\n'
          for k in 1 2 3 4 5 6 7 8; do echo '30 0'; done; } >"$tmp/slopes.loft"
        "$loft" make gregory --num $num "$tmp/slopes.loft" >"$tmp/gregory.loft"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/gregory.loft"
        [ "$(cat "$tmp/out")" = "15 15 0.5625" ] || job_fails "gregory $num: $(cat "$tmp/out")"
        run 0 "$loft" make fill --num $num "tests/drawings/ring.loft"
        cp "$tmp/out" "$tmp/fill.loft"; says out '^gb 5 5 split'
        awk '/within/ { exit !($5 < 0.001) }' "$tmp/out" ||
            job_fails "fill $num: $(sed -n 2p "$tmp/out")"
        cat "tests/drawings/ring.loft" "$tmp/fill.loft" >"$tmp/closed.loft"
        run 0 "$loft" surface --num $num -o "$tmp/closed.stl" "$tmp/closed.loft"
        printf 'nurbs-surface 2 1 3 2\n0 0 0\n0 8 1 : 2\n9 0 5\n9 8 5\n20 0 0\n20 8 3\n' \
            >"$tmp/nurbs.loft"
        sed 's/nurbs-surface.*/tensor 2 1/' "$tmp/nurbs.loft" >"$tmp/tensor.loft"
        "$loft" eval --num $num --uv 0.25,0.5 "$tmp/tensor.loft" >"$tmp/want"
        run 0 "$loft" eval --num $num --uv 0.25,0.5 "$tmp/nurbs.loft"
        paste "$tmp/want" "$tmp/out" |
            awk '{ for (i = 1; i < 4; i++) if (($i - $(i + 3))^2 > 1e-9) exit 1 }' ||
            job_fails "nurbs-surface $num: $(cat "$tmp/want" "$tmp/out")"
        run 0 "$loft" contour --num $num --heights 2 "$tmp/nurbs.loft"; says out '^line'
    done
    one_line 65 'not a tensor patch without weights' "$loft" make fill "$tmp/tensor.loft"
    printf 'tensor 1 1\n0 0\n0 1\n1 0\n1 1\n' >"$tmp/alone.loft"
    one_line 65 'leads away' "$loft" make fill "$tmp/alone.loft"
    cat "$tmp/alone.loft" "$tmp/alone.loft" >"$tmp/twice.loft"
    one_line 65 'no hole with 3 to 8 sides' "$loft" make fill "$tmp/twice.loft"
    one_line 65 'give `coons slopes 3 3`'   "$loft" make gregory "$tmp/tensor.loft"
    printf 'nurbs-surface 2 1 3 2\nknots u 0 0 1\n' >"$tmp/bad.loft"
    one_line 65 'bad.loft:1: 3 knots u for 3 points of degree 2' "$loft" eval "$tmp/bad.loft"
    printf 'nurbs-surface 2 1 2 2\n' >"$tmp/bad.loft"
    one_line 65 'bad.loft:1: not two degrees, rows and columns' "$loft" eval "$tmp/bad.loft"
}
case_flatten_keeps_its_tolerance() {
    for num in q16 f32 f64; do
        run 0 "$loft" flatten --num $num --tol 0.05 --points "0,0 0,50 50,50 50,0"
        cp "$tmp/out" "$tmp/chords"
        run 0 "$loft" sample --num f64 --n 2000 --points "0,0 0,50 50,50 50,0"
        awk 'NR == FNR { x[n] = $1; y[n++] = $2; next }
             { best = 1e9
               for (i = 1; i < n; i++) {
                   dx = x[i]-x[i-1]; dy = y[i]-y[i-1]
                   u = (($1-x[i-1])*dx + ($2-y[i-1])*dy) / (dx*dx + dy*dy)
                   u = u < 0 ? 0 : u > 1 ? 1 : u
                   ex = $1-x[i-1]-u*dx; ey = $2-y[i-1]-u*dy; d = sqrt(ex*ex + ey*ey)
                   if (d < best) best = d }
               if (best > worst) worst = best }
             END { exit !(n > 5 && n < 40 && worst > 0 && worst <= 0.05) }' \
            "$tmp/chords" "$tmp/out" || job_fails "$num leaves the curve"
    done
}
case_compare_holds_the_bounds() {
    run 0 "$loft" compare --points "0,0 100,200 300,-100 400,55.5"
    awk '/^q16/ { n++; if ($5 > 1) bad = 1 } /^q16 .* walk/ && $5 > 0.52 { bad = 1 }
         END { exit bad || n != 2 }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" compare --num q16 --against f64 --n 500 --points "0,0 100,200 300,-100 400,55.5"
    [ "$(grep -c '^q16  *f64' "$tmp/out")" = 2 ] || job_fails "$(cat "$tmp/out")"
}
# fields of row N of $tmp/out, a blank between
row() {
    awk -F'\t' -v n="$1" -v from="$2" \
        'NR == n + 1 { for (i = from; i <= NF; i++) printf "%s%s", $i, i < NF ? " " : "" }' \
        "$tmp/out"
}
case_measure() {
    local num
    printf 'arc left\n10 0\n0 0\n-10 0\nline\n-10 0\n10 0\nrational\n10 0\n10 10 : 0.7071\n0 10\n' \
        >"$tmp/m.loft"
    for num in q16 f32 f64; do
        # half a circle, its chord, a quarter again: 10 pi, 20, 5 pi
        run 0 "$loft" measure --num $num "$tmp/m.loft"
        awk -F'\t' 'function near(x, y) { return x - y < 2e-3 && y - x < 2e-3 }
             /:1/ { n += near($3, 31.4159265) && near($4, -10) && near($5, 0) &&
                         near($6, 10) && near($7, 10) }
             /:5/ { n += near($3, 20) && near($5, 0) && near($7, 0) }
             /:8/ { n += near($3, 15.7079632) }
             /^all/ { n += near($3, 67.1238898) }
             END { exit n != 4 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --nearest 0,4 "$tmp/m.loft"
        [ "$(awk -F'\t' 'NR > 1 { printf "%.2f %.2f;", $3, $6 }' "$tmp/out")" = \
            "0.50 6.00;0.50 4.00;1.00 6.00;" ] || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --joins "$tmp/m.loft"
        [ "$(row 1 3 | cut -c1-11) $(row 2 3 | cut -c1-11)" = "1 0 0 1 0 0 1 0 0 1 0 0" ] \
            || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --intersect "$tmp/m.loft"
        awk -F'\t' 'NR > 1 { n[$1 $5]++; seen[$12]++ }
             END { exit !(length(n) == 3 && seen["overlap"] >= 1 && seen["meet"] >= 2) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        # one overlap is one row, with numbers on both: the quarter is the first half of the arc
        awk -F'\t' 'function near(x, y) { return x != "-" && x - y < 2e-3 && y - x < 2e-3 }
             /:1\t.*:8\t/ { n++; good = near($2, 0) && near($4, 0.5) && near($6, 0) &&
                                         near($8, 1) && $12 == "overlap" }
             END { exit !(n == 1 && good && NR == 5) }' "$tmp/out" ||
            job_fails "$num: $(cat "$tmp/out")"
        # the foot, and not its distance alone, is within the tolerance
        for at in 0.3,0.5 3,4 -0.2,0.1 -7,0.01 40,30; do
            run 0 "$loft" measure --num $num --nearest "$at" "$tmp/m.loft"
            echo "$at" | awk -F'[,\t]' \
                'NR == FNR { r = 10 / sqrt($1 * $1 + $2 * $2); x = r * $1; y = r * $2; next }
                 /:1/ { good = $4 - x < 1e-3 && x - $4 < 1e-3 && $5 - y < 1e-3 && y - $5 < 1e-3 }
                 END { exit !good }' - "$tmp/out" ||
                job_fails "$num $at: $(cat "$tmp/out")"
        done
    done
    printf 'bezier\n0 0\n10 20\n20 -20\n30 0\n\nbezier\n0 1\n30 1\n' >"$tmp/x.loft"
    run 0 "$loft" measure --intersect "$tmp/x.loft"
    [ "$(grep -c 'meet$' "$tmp/out")" = 2 ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" measure --joins --num f64 --tol 1e-9 --points "0,0 1,1 2,0"
    [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "one curve has no joint"
    printf 'bezier\n0 0\n1 1\n2 1\n3 0\nbezier\n3 0\n4 -1\n5 -3\n7 0\n' >"$tmp/j.loft"
    run 0 "$loft" measure --joins "$tmp/j.loft"
    [ "$(row 1 3)" = "1 1 1 1 1 1 1 2" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" measure --nearest 3,0,4 --points "0,0,0 10,0,0"
    [ "$(row 1 4)" = "3 0 0 4" ] || job_fails "$(cat "$tmp/out")"
    one_line 64 'give x,y or x,y,z'   "$loft" measure --nearest 3 "$tmp/m.loft"
    one_line 64 'give one of them'    "$loft" measure --joins --intersect "$tmp/m.loft"
    printf 'line\n0 0\n1 1\nbezier\n0 0\n40000 0\n' >"$tmp/far.loft"
    one_line 65 'far.loft:4: .*f64'   "$loft" measure "$tmp/far.loft"
    one_line 66 'none.loft'           "$loft" measure "$tmp/none.loft"
}
case_measure_offset() {
    run 0 "$loft" measure --offset -5 --tol 0.01 tests/drawings/demo.svg; is_empty err
    printf 'bezier\n0 0\n0 50\n50 50\n50 0\n' >"$tmp/arch.loft"
    run 0 "$loft" measure --offset 5 --tol 0.01 "$tmp/arch.loft"; cp "$tmp/out" "$tmp/beside.loft"
    run 0 "$loft" sample --num f64 --n 8 "$tmp/beside.loft"
    grep . "$tmp/out" | tr ' ' , >"$tmp/points"
    while read -r at; do        # every point has the requested distance
        run 0 "$loft" measure --num f64 --tol 1e-4 --nearest "$at" "$tmp/arch.loft"
        awk -F'\t' 'NR == 2 { exit !($6 > 4.989 && $6 < 5.011) }' "$tmp/out" \
            || job_fails "$at: $(cat "$tmp/out")"
    done < <(awk 'NR % 7 == 1' "$tmp/points")
    [ "$(wc -l <"$tmp/points")" -gt 30 ] || job_fails "$(wc -l <"$tmp/points") points"
    run 0 "$loft" plot "$tmp/beside.loft" -o "$tmp/beside.svg"
    run 0 "$loft" stream "$tmp/beside.loft" --dry-run; says out '^planned:'
}
case_curves_of_every_kind() {
    local all=tests/drawings/curves.loft kinds
    run 0 "$loft" compare "$all"
    kinds=$(awk '/^q16/ { $1=$2=$3=$4=$5=$6=$7=$8=$9=""; print }' "$tmp/out" \
        | sort -u | tr -s ' \n' ' ')
    local expected=" arc bezier bspline cardinal hermite3 hermite5 line"
    expected="$expected natural chord natural uniform nurbs parabola rational "
    [ "$kinds" = "$expected" ] || job_fails "kinds:$kinds"
    awk '/^q16 .* eval / && $5 > ($10 == "rational" || $10 == "nurbs" ? 2 : 1) { exit 1 }
         /^q16 .* walk / && $5 > 2 { exit 1 }
         /^f32 .* eval / && $5 > 1 { exit 1 } /^f64 .* eval / && $5 > 32 { exit 1 }' "$tmp/out" ||
        job_fails "beyond the bounds: $(cat "$tmp/out")"
    run 0 "$loft" compare --num q16 --against f64 --n 64 "$all"
    run 0 sh -c "cat '$all' | '$loft' eval -"
    [ "$(grep -c . "$tmp/out")" = "$(grep -c '^[a-z]' "$all" | awk '{ print $1 - 2 }')" ] \
        || job_fails "$(cat "$tmp/out")"      # two lines of knots
}
case_curves_through_pipes() {
    printf 'natural\n0 0\n10 10\n20 0\narc left\n20 0\n20 10\n30 10\n' >"$tmp/two.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0,1 "$tmp/two.loft"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;10 10;;20 0;30 10;" ] \
            || job_fails "$num: $(cat "$tmp/out")"
        # one path: no empty line where the arc goes on
        run 0 "$loft" sample --num $num --n 1 "$tmp/two.loft"
        ! grep -q '^$' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        [ "$(head -3 "$tmp/out" | tr '\n' ';')$(tail -1 "$tmp/out")" = "0 0;10 10;20 0;30 10" ] ||
            job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" flatten --num $num --tol 0.01 "$tmp/two.loft"
        awk '$1 > 20.001 { d = sqrt(($1-20)^2 + ($2-10)^2) - 10
                           if (d > 1e-3 || d < -1e-3) bad = 1; n++ }
             END { exit bad || n < 5 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
    run 0 "$loft" stream "$tmp/two.loft" --dry-run; says out '^planned: .*path within 0.0050 mm'
    machine curves --speed fast --once
    run 0 "$loft" stream "$tmp/two.loft" --port "$tmp/curves" --feed 60
    gone "$machine"
    says out 'as commanded$'
    counted curves
}
case_the_page_of_the_format_is_true() {
    awk '/^```/ { on = !on; n += on; next } on && n == 1' host-tools/LOFT.md >"$tmp/page.loft"
    awk '/^```/ { on = !on; n += on; next } on && n == 2' host-tools/LOFT.md >"$tmp/patch.loft"
    run 0 "$loft" eval --uv 0,0 "$tmp/patch.loft"
    [ "$(tr '\n' ';' <"$tmp/out")" = "0 0 0;;20 0 0;" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" eval --t 0,1 "$tmp/page.loft"
    [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;20 0;;20 0;30 10;" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" plot "$tmp/page.loft" -o "$tmp/page.svg"
}
case_shapes_are_told() {
    run 0 "$loft" eval --shape --points "0,0 20,10 -10,10 10,0"
    says out '^0.0 bezier: loop, loop from 0.112701[0-9]* to 0.887298[0-9]*, box '
    run 0 "$loft" eval --shape --points "0,0 10,10 0,10 10,0"
    says out '^0.0 bezier: cusp, cusp at 0.5, box 0 0 to 10 7.5'
    run 0 "$loft" eval --shape --points "0,0 1,1"
    says out '^0.0 bezier: line, box 0 0 to 1 1$'
    run 0 "$loft" eval --shape --points "0,0 1,1 2,0"
    says out '^0.0 bezier: parabola, box 0 0 to 2 0.5'
    run 0 "$loft" eval --shape tests/drawings/curves.loft
    says out ' natural uniform: serpentine, inflection at 1.377[0-9]*, box '
    one_line 64 'give one of them' "$loft" eval --shape --t 0.5 --points "0,0 1,1"
}
case_combs_and_knots_are_drawn() {
    run 0 "$loft" plot tests/drawings/curves.loft --comb -o "$tmp/a.png"
    says out 'a.png: [0-9]* curves$'
    run 0 "$loft" plot --comb 20 --control tests/drawings/curves.loft -o "$tmp/b.svg"
    says out 'b.svg: [0-9]* curves$'
    run 0 "$loft" plot --comb=20 -o "$tmp/c.pdf" "$tmp/small.csv"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] || job_fails "no picture"
    run 0 "$loft" plot -o "$tmp/d.svg" tests/drawings/curves.loft
    [ "$(grep -c '<path' "$tmp/b.svg")" -gt "$(grep -c '<path' "$tmp/d.svg")" ] \
        || job_fails "no comb in the picture"
    one_line 64 '--comb x' "$loft" plot --comb=x "$tmp/small.csv"
}
case_surfaces_are_evaluated() {
    local corners="0 0 0;30 0 4;0 30 6;;40 0 0;70 0 4;40 30 6;;90 0 0;105 0 15;90 30 0;;"
    corners="${corners}0 50 0;30 45 0;20 68 0;;40 50 0;70 48 0;56 72 8;;102 48 0;82 68 0;82 48 20;;"
    corners="${corners}128 12 18;128 12 0;128 12 18;;118 50 0;142 50 4;118 72 4;"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --uv 0,0,1,0,0,1 tests/drawings/surfaces.loft
        [ "$(tr '\n' ';' <"$tmp/out")" = "$corners" ] ||
            job_fails "corners in $num: $(tr '\n' ';' <"$tmp/out")"
        run 0 "$loft" sample --num $num --n 4 tests/drawings/surfaces.loft
        [ "$(grep -c . "$tmp/out")" = $((5 * 25 + 3 * 15)) ] \
            || job_fails "$(grep -c . "$tmp/out") points in $num"
    done
    printf 'octant 20\n' | "$loft" eval --num f64 --uv 0.25,0.5 - \
        | awk '{ r = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2); exit !(r > 19.999999 && r < 20.000001) }' \
        || job_fails "the octant is not round"
    run 0 sh -c "cat tests/drawings/patch.loft | '$loft' eval -";      says out '^15 15 '
    one_line 64 'give pairs'           "$loft" eval --uv 0.5 tests/drawings/patch.loft
    one_line 64 'for curves'           "$loft" eval --t 0.5 tests/drawings/patch.loft
    one_line 64 'for surfaces'         "$loft" eval --uv 0,0 tests/drawings/curves.loft
    one_line 65 'u, v = 0.9, 0.9'      sh -c "printf 'octant 3\n' | '$loft' eval --uv 0.9,0.9 -"
    printf 'tensor 3 3\n' >"$tmp/far.loft"
    yes '30000 30000 30000' | head -15 >>"$tmp/far.loft"
    echo '0 0 40000' >>"$tmp/far.loft"
    one_line 65 'far.loft:1: tensor: ' "$loft" eval "$tmp/far.loft"
    run 0 "$loft" eval --num f32 "$tmp/far.loft"
}
case_surfaces_with_n_sides_are_used() {
    local sided=tests/drawings/sided.loft
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num "$sided"
        [ "$(grep -c . "$tmp/out")" = 6 ] || job_fails "$(cat "$tmp/out")"
        run 0 "$loft" sample --num $num --n 2 "$sided"
        [ "$(grep -c . "$tmp/out")" = $((9 * (5 + 6 + 6 + 5 + 6 + 7))) ] \
            || job_fails "$(grep -c . "$tmp/out") points in $num"
        run 0 "$loft" surface --num $num --n 8 -o "$tmp/sided.stl" "$sided"
        says out ': 6 surfaces, [0-9]* triangles$'
    done
    run 0 "$loft" plot "$sided" --control --heights 4,8 -o "$tmp/sided.svg"
    says out 'sided.svg: 6 surfaces$'
    run 0 "$loft" plot "$sided" --curvature gauss --contours 5 -o "$tmp/sided.pdf"
    says out 'sided.pdf: 6 surfaces$'
    one_line 65 'u, v = 2, 0'           "$loft" eval --uv 2,0 "$sided"
    one_line 64 'for surfaces'          "$loft" plot --contours 5 tests/drawings/curves.loft
    one_line 65 'n.loft:2: not a point' sh -c \
        "printf 'gb 5 3\n1 x\n' >'$tmp/n.loft'; '$loft' eval '$tmp/n.loft'"
}
# A separate reader checks sizes, indices, unit normals on the right side, and the area and volume
# of a sphere. For an eighth of it, a rational triangle (Farin, Piper, Worsey 1987), the normals
# equal the points.
case_meshes_are_read_back() {
    printf 'sphere 20\n1 2 3\n' >"$tmp/ball.loft"
    run 0 "$loft" surface --n 64 -o "$tmp/ball.stl" "$tmp/ball.loft"
    says out ': 1 surface, 8064 triangles$'
    run 0 "$loft" surface --n 64 -o "$tmp/ball.ply" "$tmp/ball.loft"
    python3 - >"$tmp/eighth.loft" <<'PY'
from math import sqrt
a, b, g = 1 - sqrt(1 / 3), (1 + sqrt(1 / 3)) / 2, 1 - (5 - sqrt(2)) * (7 - sqrt(3)) / 46
k, e, m, i = 4 * sqrt(3) * (sqrt(3) - 1), 3 * sqrt(2), 4, sqrt(2 / 3) * (3 + 2 * sqrt(2) - sqrt(3))
net = [(1, 0, 0), (1, a, 0), (1, 0, a), (b, b, 0), (1, g, g), (b, 0, b), (a, 1, 0), (g, 1, g),
       (g, g, 1), (a, 0, 1), (0, 1, 0), (0, 1, a), (0, b, b), (0, a, 1), (0, 0, 1)]
weight = [k, e, e, m, i, m, e, i, i, e, k, e, m, e, k]
print('triangle 4')
for p, w in zip(net, weight):
    print('%.15g %.15g %.15g' % tuple(20 * x for x in p), ': %.15g' % w)
PY
    run 0 "$loft" surface --num f64 --n 16 -o "$tmp/eighth.ply" "$tmp/eighth.loft"
    run 0 "$loft" surface --n 8 -o "$tmp/all.stl" tests/drawings/surfaces.loft
    for num in q16 f32 f64; do
        run 0 "$loft" surface --num $num --tol 0.05 -o "$tmp/fine.stl" "$tmp/ball.loft"
        says out 'Euler number 2, closed$'
        awk '/^volume/ { exit !($2 > 33510.33 - $4 && $2 < 33510.33 + $4 && $4 < 260) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" surface --num $num --tol 0.05 -o "$tmp/fine.ply" tests/drawings/ring.loft
        says out 'Euler number 0, not closed: [0-9]* edges open, 0 turned, 0 of'
    done
    one_line 64 'give one of them' "$loft" surface --n 8 --tol 1 "$tmp/ball.loft"
    cat >"$tmp/read.py" <<'PY'
import math, struct, sys
tmp = sys.argv[1]
def corners_of_stl(name):
    data = open(name, 'rb').read()
    count, = struct.unpack_from('<I', data, 80)
    assert len(data) == 84 + 50 * count, 'size of ' + name
    faces = (struct.unpack_from('<12f', data, 84 + 50 * i) for i in range(count))
    return [(f[:3], [f[3:6], f[6:9], f[9:12]]) for f in faces]
def corners_of_ply(name):
    head, data = open(name, 'rb').read().split(b'end_header\n', 1)
    elements = (line.split() for line in head.split(b'\n') if line.startswith(b'element'))
    size = {word[1]: int(word[2]) for word in elements}
    v = [struct.unpack_from('<6f', data, 24 * i) for i in range(size[b'vertex'])]
    assert len(data) == 24 * len(v) + 13 * size[b'face'], 'size of ' + name
    faces = [struct.unpack_from('<B3I', data, 24 * len(v) + 13 * i) for i in range(size[b'face'])]
    assert all(f[0] == 3 for f in faces)
    return v, [(None, [v[i][:3] for i in f[1:]]) for f in faces]
def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def check_ball(faces):
    area = volume = 0
    for normal, corner in faces:
        c = [[x - o for x, o in zip(p, (1, 2, 3))] for p in corner]
        assert all(abs(math.hypot(*p) - 20) < 1e-4 for p in c), 'a corner off the sphere'
        n = cross([b - a for a, b in zip(c[0], c[1])], [b - a for a, b in zip(c[0], c[2])])
        assert dot(n, c[0]) > 0, 'a triangle turned inside'
        area += math.hypot(*n) / 2
        volume += dot(cross(c[0], c[1]), c[2]) / 6
        if normal:
            assert abs(math.hypot(*normal) - 1) < 1e-5, 'a wrong normal'
            assert dot(normal, n) > 0.999 * math.hypot(*n), 'a wrong normal'
    assert 0.995 < area / (4 * math.pi * 400) < 1, area
    assert 0.99 < volume / (4 / 3 * math.pi * 8000) < 1, volume
check_ball(corners_of_stl(tmp + '/ball.stl'))
vertices, faces = corners_of_ply(tmp + '/ball.ply')
check_ball(faces)
for v in vertices:
    off = max(abs(v[i] - (1, 2, 3)[i] - 20 * v[i + 3]) for i in range(3))
    assert off < 1e-2, 'a normal of a vertex'
for v in corners_of_ply(tmp + '/eighth.ply')[0]:
    assert abs(math.hypot(*v[:3]) - 20) < 1e-5, 'a corner off the eighth'
    assert max(abs(v[i] / 20 - v[i + 3]) for i in range(3)) < 1e-6, 'a normal of the eighth'
assert len(corners_of_stl(tmp + '/all.stl')) > 8 * 64
PY
    run 0 python3 "$tmp/read.py" "$tmp"
    one_line 64 'ends with .stl or .ply' "$loft" surface -o "$tmp/a.obj" "$tmp/ball.loft"
    one_line 73 'cannot be written'      "$loft" surface -o "$tmp/none/a.stl" "$tmp/ball.loft"
    one_line 65 'no surface in it'       "$loft" surface tests/drawings/curves.loft
    one_line 66 'no such file'           "$loft" surface "$tmp/nothing.loft"
}
case_surfaces_are_drawn() {
    run 0 "$loft" plot tests/drawings/surfaces.loft --control --size 500 -o "$tmp/a.png"
    says out 'a.png: 8 surfaces$'
    run 0 "$loft" plot tests/drawings/patch.loft --curvature gauss --view 30,60,2 -o "$tmp/b.svg"
    run 0 "$loft" plot tests/drawings/patch.loft --wire --control -o "$tmp/c.pdf"
    run 0 sh -c "printf 'tensor 1 1\n0 0\n0 1\n1 0\n1 1\n' |
        '$loft' plot --curvature largest -o '$tmp/d.png' -"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] && [ -s "$tmp/d.png" ] || job_fails "no picture"
    one_line 64 'gauss, mean or largest' "$loft" plot --curvature red tests/drawings/patch.loft
    one_line 64 'AROUND,UP'              "$loft" plot --view 30 tests/drawings/patch.loft
    one_line 64 'AROUND,UP'              "$loft" plot --view 30,100 tests/drawings/patch.loft
    one_line 64 'are for drawings'       "$loft" plot --comb tests/drawings/patch.loft
    one_line 64 'are for surfaces'       "$loft" plot --wire tests/drawings/curves.loft
    one_line 64 'give one of them'       "$loft" plot --wire --curvature mean \
        tests/drawings/patch.loft
    one_line 64 '.png, .svg or .pdf'     "$loft" plot -o "$tmp/a.gif" tests/drawings/patch.loft
}
case_bad_surfaces() {
    bad_surface() {
        printf "$1" >"$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$2" "$loft" eval "$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$2" "$loft" surface "$tmp/bad.loft"
    }
    bad_surface 'tensor 3\n' \
        '1: not two degrees: give two whole numbers from 0 to 9'
    bad_surface 'tensor 1 1\n0 0 0\n'                   '1: tensor with 1 point: give 4'
    bad_surface 'tensor 1 0\n0 0 0\n1 0 0\n2 0 0\n'     '4: more than the 2 points of this tensor'
    bad_surface 'tensor 0 1\n0 0 0\n1 0 0 : 300\n' \
        '3: not a point: `x y z` or `x y z : weight`, a weight of 1/256 to 256'
    bad_surface '# c\ntriangle\n0 0 0\n1 0 0\n' \
        '2: triangle with 2 points: give 1 or 3'
    bad_surface 'coons bent 3 3\n'                      '1: not a kind of Coons patch'
    bad_surface 'coons 1 1\n0 0\n1 0\n0 1\n1 1\n0 0\n0 1\n2 0\n1 1\n' '1: coons: '
    bad_surface 'pn\n0 0 0\n'                          '2: not a point: `x y z : nx ny nz`'
    bad_surface 'sphere\n'                              '1: no radius'
    bad_surface 'sphere 3\n0 0 0\n1 1 1\n'              '3: more than the 1 point of this sphere'
    bad_surface 'octant -3\n'                           '1: no radius'
    bad_surface 'octant 3\nbezier 3\n'                  '2: `bezier` is not a kind of surface'
    printf 'line\n0 0\n1 1\ntensor 1 1\n' >"$tmp/bad.loft"
    local remedy='surfaces go into a file of their own'
    one_line 65 "bad.loft:4: \`tensor\` is not a kind of curve: $remedy" \
        "$loft" eval "$tmp/bad.loft"
}
case_waterlines() {
    local num
    printf 'sphere 10\n1 2 3\n' >"$tmp/ball.loft"
    # circles of radius 8 and 6 around the centre, closed, once about each
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --heights 9,-5 --n 64 --csv "$tmp/ball.loft"; is_empty err
        awk -F, 'NR == 1 { if ($0 != "surface,height,curve,x,y,z") exit bad = 1; next }
            { r = sqrt(($4 - 1) ^ 2 + ($5 - 2) ^ 2) - ($2 == 9 ? 8 : 6); z = $6 - $2
              if (r * r > 4e-6 || z * z > 1.1e-6) exit bad = 1
              if ($3 != curve) { curve = $3; curves++; first = $4 " " $5 }
              last = $4 " " $5; n[$2]++ }
            END { exit bad || curves != 1 || last != first || n[9] < 100 || n[-5] < 100 }' \
            curve=0 "$tmp/out" || job_fails "$num: $(head -3 "$tmp/out")"
    done
    run 0 "$loft" contour --n 20 --levels 5 tests/drawings/sided.loft
    cp "$tmp/out" "$tmp/lines.loft"
    says out '^line  *# surface 6, z = 15, closed$'
    run 0 "$loft" measure --num f64 "$tmp/lines.loft"
    says out '	line	'
    run 0 sh -c "'$loft' contour --n 64 --flat tests/drawings/patch.loft |
        '$loft' stream - --dry-run"
    says out '^planned: [0-9]* curves, 0\.39[0-9] m drawn'
    for heights in 5,6.5 20; do
        run 0 "$loft" plot "$tmp/ball.loft" --view -90,60 --heights $heights \
            -o "$tmp/at-$heights.svg"
    done
    [ "$(grep -c 'fill:rgb(42%' "$tmp/at-5,6.5.svg") $(grep -c 'fill:rgb(42%' "$tmp/at-20.svg")" = \
        "10 0" ] || job_fails "$(grep -c 'fill:rgb(42%' "$tmp/at-5,6.5.svg") labels"
    one_line 65 'reach from z = -7 to 13 mm' "$loft" contour --heights 20 "$tmp/ball.loft"
    one_line 65 'no surface in it'          "$loft" contour "$tmp/small.csv"
    one_line 64 'give one of them'          "$loft" contour --heights 1 --levels 3 "$tmp/ball.loft"
}
case_bad_curves() {
    bad_loft() {
        printf "$1" >"$tmp/bad.loft"; shift
        one_line 65 "$tmp/bad.loft:$1" "$loft" eval "$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$1" "$loft" stream --dry-run "$tmp/bad.loft"
    }
    bad_loft 'bezier 3\n0 0\n1 1\n'                      '1: bezier with 2 points: give 4'
    bad_loft '# c\n\nsnake\n'                            '3: `snake` is not a kind of curve'
    bad_loft 'line\n0 0\n1 1\nrational\n0 0\n1 1 : -1\n' '6: not a point: `x y : weight`'
    bad_loft 'natural chord\n0 0\n0 0\n1 1\n'            '1: natural chord: two points in one'
    bad_loft 'rational\n0 0 : 300\n1 1\n' \
        '2: not a point: `x y : weight`, a weight of 1/256 to 256'
    printf 'line\n0 0\n1 1 99999\n' >"$tmp/z.loft"
    one_line 65 'z.loft:1: 99999 mm is beyond' "$loft" stream --dry-run "$tmp/z.loft"
    printf 'hermite3\n0 0 : 90000 0\n1 0 : 90000 0\n' >"$tmp/far.loft"
    one_line 65 'far.loft:1: .*take --num f64' "$loft" sample "$tmp/far.loft"
    printf 'bspline 2\n0 0\n1 1\n2 0\n' >"$tmp/t.loft"
    one_line 65 't.loft:1: t = 1.5: give 0 to 1 for this bspline' "$loft" eval --t 1.5 "$tmp/t.loft"
}
case_dry_run_says_the_plan() {
    run 0 "$loft" stream "$tmp/small.csv" --dry-run
    local end='[0-9]* spans, path within 0.0050 mm, job [0-9a-f]*$'
    says out "^planned: 7 curves, 0\.[0-9]* m drawn, .* s, $end"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 1800mm/min; cp "$tmp/out" "$tmp/minutes"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 30mm/s
    cmp -s "$tmp/out" "$tmp/minutes" || job_fails "1800mm/min is not 30mm/s"
}
case_a_program_is_checked() {
    printf '%s\n' 'G21 G90' 'G0 Z5' 'G0 X10 Y10' 'G1 Z-1 F300' 'G1 X50 F60000' 'G0 X20' \
        'G2 X30 Y20 I0 J10 F1200' 'G0 Z5' M30 >"$tmp/part.nc"
    printf 'max_speed = 200\ny.max_speed = 100\nx.travel = 60\n' >"$tmp/m.txt"
    run 0 "$loft" stream "$tmp/part.nc" --check --machine "$tmp/m.txt"; is_empty err
    says out '^planned: .* s, '; says out '^box: x 0..50, y 0..30, z -1..5$'
    says out '^feeds: 5 to 1000 mm/s$'
    says out 'part.nc:5: a feed of 1000 mm/s, and x allows 200 there: 1 curve is drawn slower'
    says out 'part.nc:6: a rapid at z -1, below 0: 1 of them'
    printf 'x.travel = 40\n' >"$tmp/m.txt"
    one_line 65 'takes the tool to x 0..50, and the table is x 0..40' \
        "$loft" stream "$tmp/part.nc" --check --machine "$tmp/m.txt"
    one_line 64 'give one of them' "$loft" stream "$tmp/part.nc" --check --grbl
    run 0 "$loft" stream "$tmp/small.csv" --check; says out '^box: x .*, z 0..1$'
    says out '^feeds: 30 to 30 mm/s$'
    ! grep -q 'allows' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_tools_draw_one_after_the_other() {
    cat >"$tmp/pens.txt" <<'END'
x.park = 5
y.park = 6
tool.red.colours  = #f00
tool.red.feed     = 40
tool.red.pause    = the red pen
tool.blue.layers  = 2
tool.blue.pen_up  = 3
tool.blue.pause   = the blue pen
END
    cat >"$tmp/pens.svg" <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60"
     xmlns:i="http://www.inkscape.org/namespaces/inkscape">
  <g i:groupmode="layer" i:label="2 sky"><path d="M10 10h40v40h-40z" stroke="red"/></g>
  <path d="M20 20l20 20" stroke="red"/>
</svg>
END
    job=("$loft" stream "$tmp/pens.svg" --machine "$tmp/pens.txt" --port "$tmp/pens")
    run 0 "${job[@]}" --dry-run
    says out '^tool red: planned: 1 curve, 0.028 m drawn'; says out '^tool blue: planned: 4 curves'
    says out '^tool blue: before it: the blue pen$'; says out '^in all: 5 curves, 0.188 m drawn'
    run 0 "${job[@]}" --dry-run --grbl; says out '^(tool blue)$'; says out '^M0$'
    machine pens --speed fast
    run 75 "${job[@]}"; says err 'tool red is next: the red pen; then .* --from-tool red goes on'
    printf '\n' | timeout 200 "${job[@]}" >"$tmp/out" 2>"$tmp/err"
    [ "${PIPESTATUS[1]}" = 75 ] || job_fails "went on without an answer: $(cat "$tmp/err")"
    says out '^drawn: 1 curve, .*steps 400 480 80 as commanded'     # parked, and lifted
    says err 'tool blue is next: the blue pen; then .* --from-tool blue goes on'
    printf '\n' | timeout 200 "${job[@]}" --from-tool blue >"$tmp/out" 2>"$tmp/err" ||
        job_fails "$(cat "$tmp/err")"
    says out '^drawn: 4 curves, .*steps 800 4000 240 as commanded'; counted pens
    one_line 64 '--from-tool green: it is not in the machine file' "${job[@]}" --from-tool green
    kill "$machine"; gone "$machine"
}
case_a_tool_that_was_cut_off_goes_on() {
    printf 'tool.a.colours = red\ntool.b.colours = blue\n' >"$tmp/two.txt"
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">
        <path d="M10 10h9" stroke="red"/><path d="M10 10v40h40" stroke="blue"/></svg>' \
        >"$tmp/two.svg"
    job=("$loft" stream "$tmp/two.svg" --machine "$tmp/two.txt" --port "$tmp/two" --feed 20)
    machine whole --speed fast
    run 0 "${job[@]}" --port "$tmp/whole"; kill "$machine"; gone "$machine"
    machine two --speed real; drawing_on=two
    "${job[@]}" >/dev/null 2>&1 & local sender=$!
    disown $sender
    for _ in $(seq 3000); do
        [ "$(grep -c ' begun' "$tmp/two.log")" = 2 ] && break
        sleep 0.02
    done
    sleep 0.5; kill -9 $sender; gone $sender
    run 0 "${job[@]}"; says err '^tool b: resuming at item [1-9]'
    says out '^drawn: 2 curves, .*as commanded'; [ "$(grep -c '^drawn' "$tmp/out")" = 1 ] ||
        job_fails "drew a tool again"
    kill "$machine"; gone "$machine"; counted two; same_path whole two
}
case_short_lines_become_curves() {
    awk 'BEGIN { print "line"
                 for (i = 0; i <= 2000; i++)
                     printf "%.6f %.6f\n", 20 * cos(i * 0.002), 20 * sin(i * 0.002) }' \
        >"$tmp/dense.loft"
    run 0 "$loft" stream "$tmp/dense.loft" --dry-run --feed 60
    says out '^planned: [1-9][0-9]\? curves, 0.080 m drawn'
    run 0 "$loft" stream "$tmp/dense.loft" --dry-run --feed 60 --smooth 0
    says out '^planned: 2000 curves, 0.080 m drawn'
    one_line 64 'leave at least half of the tolerance' "$loft" plan "$tmp/dense.loft" --smooth 0.004
    machine dense --steps 250 --once
    run 0 "$loft" stream "$tmp/dense.loft" --feed 60 --port "$tmp/dense" --record "$tmp/dense.csv"
    gone "$machine"
    says out 'as commanded'
    awk '/worst path error/ {
             for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) < 0.0080) ok = 1
         }
         END { exit !ok }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_the_line_in_words() {
    machine watched --speed fast
    run 0 "$loft" ports "$tmp/watched"
    local queue='queue of 256 spans or 1280 points'
    says out "loft, 3 axes, 1000 ticks/s, 40 slots, $queue	steps/mm 80 80 80	idle"
    "$loft" monitor --port "$tmp/watched" --link "$tmp/between" >"$tmp/words" & local monitor=$!
    children+=("$monitor")
    wait_for "$tmp/between"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/between" --log "$tmp/log"
    kill -INT $monitor; wait $monitor || job_fails "monitor: exit code $?"
    for f in words log; do
        for line in '> HELLO ' '< WELCOME .* axes 3 queue 256 points 1280' \
            '> JOB .* spans start 0 0 0' '> SPANS .* first 0 ' '< ACK .* running' '> END .* total' \
            '< REPORT .* done position'; do
            grep -q -- "$line" "$tmp/$f" || job_fails "$f has no line $line"
        done
        ! grep -qE 'readable|unknown| \? ' "$tmp/$f" \
            || job_fails "$(grep -E 'readable|unknown' "$tmp/$f" | head -1)"
    done
    grep -q '^> [0-9]* bytes, [0-9]* frames, 0 damaged$' "$tmp/words" \
        || job_fails "$(tail -2 "$tmp/words")"
}
# peer NAME OPTIONS..: a controller of grbl's kind behind $tmp/NAME; at its end its path is in
# $tmp/NAME.csv
peer() {
    local name=$1; shift
    python3 tests/e2e/grbl_peer.py "$tmp/$name" "$tmp/$name.csv" "$@" & peer=$!
    children+=("$peer")
    disown "$peer"
    wait_for "$tmp/$name"
}
# drew NAME: all of outline12.csv within the tolerance, and the buffer never overflowed
drew() {
    kill "$peer"; gone "$peer"
    "$loft" flatten tests/drawings/outline12.csv --tol 0.0005 | tr ',' ' ' >"$tmp/true"
    grep -v '#' "$tmp/$1.csv" | awk -F, '$3 == 0 { print $1, $2 }' >"$tmp/was"
    python3 - "$tmp/true" "$tmp/was" 0.004 <<'PY' || job_fails "the path is not that of the drawing"
import sys
a, b = ([tuple(map(float, l.split()[:2])) for l in open(f) if l.strip()] for f in sys.argv[1:3])
def far(p, line):
    best = 1e9
    for (x, y), (u, v) in zip(line, line[1:]):
        q = (u - x) ** 2 + (v - y) ** 2
        t = 0 if q == 0 else min(1, max(0, ((p[0] - x) * (u - x) + (p[1] - y) * (v - y)) / q))
        best = min(best, (p[0] - x - t * (u - x)) ** 2 + (p[1] - y - t * (v - y)) ** 2)
    return best ** 0.5
worst = max(max(far(p, b) for p in a[::7]), max(far(p, a) for p in b[::7]))
if len(a) < 100 or len(b) < 100 or worst > float(sys.argv[3]):
    sys.exit(f"{len(a)} {len(b)} points, {worst:.5f} mm apart")
PY
    grep -q 'overflow 0 ' "$tmp/$1.csv" || job_fails "$(tail -1 "$tmp/$1.csv")"
}
case_grbl_draws_arcs() {
    peer arcs
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/arcs"
    says out '^drawn: 12 curves, 0.131 m, [0-9]* lines of G-code .*Grbl 1.1h'
    drew arcs
}
case_grbl_draws_cubics_and_work_coordinates() {
    peer g5 --g5 --mpos
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --g5 --feed 50 --port "$tmp/g5"
    says out '^drawn: 12 curves, 0.131 m, 1[0-9] lines'
    drew g5
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --g5 --dry-run
    [ "$(grep -c '^G5' "$tmp/out")" = 12 ] || job_fails "$(head -3 "$tmp/out")"
}
case_grbl_on_the_whole_terminal_and_in_json() {
    peer shown
    local job=("$loft" stream tests/drawings/outline12.csv --grbl --feed 1 --port "$tmp/shown")
    echo 'job begun' >"$tmp/shown.log"
    "$pty" type "$tmp/shown.log" "1:h 1.4:s 2:r" "${job[@]}" --view >"$tmp/out" 2>&1 \
        || job_fails "exit code $?"
    seen 'h hold  r resume  a abort'; seen 'pen down'; seen '#'; seen '....'; seen '@'
    seen 'sent ahead, override 100 %, held'; says after 'drawn: 12 curves, 0.131 m'
    drew shown
    peer told
    job[7]=$tmp/told
    run 0 "${job[@]}" --json
    lines "o[0]['event'] == 'job' and o[0]['curves'] == 12 and o[0]['id'] is None"
    lines "o[-1] == {'event': 'end', 'code': 0} and states[-1]['items'] == states[-1]['item']"
    lines "[x['part'] for x in states] == sorted(x['part'] for x in states) and len(states) > 10"
    lines "{x['pen'] for x in states} >= {'down'} and states[-1]['at'][0] != states[3]['at'][0]"
    drew told
    one_line 64 'leave out --json' "${job[@]}" --json --dry-run
    one_line 64 'must be a terminal' "${job[@]}" --view
}
case_grbl_troubles_are_told() {
    refuses() {
        local pattern=$1 code=$2; shift 2
        peer bad "$@"
        one_line "$code" "$pattern" "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 \
            --port "$tmp/bad" ${cubics:-}
        kill "$peer"; gone "$peer"; rm -f "$tmp/bad"
    }
    refuses 'locked after an alarm: home it' 78 --locked
    refuses 'alarm 2 at line [0-9]* of [0-9]*: .*travel' 76 --alarm 20
    refuses 'error 2 at line [0-9]* of [0-9]*, `G.*: a number that cannot be read' 76 --error 20
    refuses 'the controller restarted at line [0-9]*' 76 --reset 20
    refuses '[0-9]* lines were not answered' 76 --mute 20
    cubics='--wait 1'
    refuses 'answers, but reports its position as MPos without WCO: set $10=0' 78 --nowco
    refuses 'bytes came, but no word of grbl' 76 --babble
    cubics=--g5; refuses 'error 20 at line 2 .*run without --g5' 76
}
case_grbl_answers_late() {     # a boot loader, and a board that is reset after it has answered
    peer late --late 2500
    one_line 69 'no answer in 0.5 s: look at its power' "$loft" stream \
        tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/late" --wait 0.5
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/late" --wait 8
    says out '^drawn: 12 curves.*Grbl 1.1h'
    drew late
    peer twice --twice
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/twice"
    drew twice
}
case_grbl_says_what_it_is() {           # $$: its table, its unit, a file for --machine
    printf '0 0 10 0 20 0 30 0\n' | tr ' ' ',' >"$tmp/long.csv"
    for corner in '' --corner; do       # the work zero is 10 mm from the low end
        peer "in$corner" --table 41 $corner
        run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/in$corner"
        kill "$peer"; gone "$peer"
        peer "past$corner" --table 39 $corner
        one_line 65 'x 0..30, .*the table is x -10..29, y -10..29.*: moved by -1,0' \
            "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/past$corner"
        kill "$peer"; gone "$peer"
    done
    peer own --table 39
    printf 'x.travel = 50\n' >"$tmp/own.txt"
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/own" --machine "$tmp/own.txt"
    run 0 "$loft" settings --grbl --port "$tmp/own" --save "$tmp/grbl.txt"
    says out '^saved: '
    kill "$peer"; gone "$peer"
    for line in 'x.steps_per_mm = 250' 'z.max_speed = 5' 'x.max_accel = 80' 'x.travel = 39' \
        'x.min = '; do
        grep -q "^$line" "$tmp/grbl.txt" || job_fails "no $line: $(cat "$tmp/grbl.txt")"
    done
    one_line 65 'table is x -10..29' "$loft" plan "$tmp/long.csv" --machine "$tmp/grbl.txt"
    run 0 "$loft" plan "$tmp/long.csv" --total --at -9,0 --machine "$tmp/grbl.txt"
    peer inches --table 100 --inches --mpos
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/inches"
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/inches"    # from 30 mm, not 1.18
    kill "$peer"; gone "$peer"
    awk -F, '!/#/ { if ($1 == 0 && was > 0 && was != 30) exit 1; was = $1 }' "$tmp/inches.csv" \
        || job_fails "inches were taken for mm: $(head -5 "$tmp/inches.csv")"
}
case_plan_says_what_limits() {
    plan() { run 0 "$loft" plan "$@"; is_empty err; }
    limited() {
        local by=$1; shift
        plan --total "$@"
        grep -q "^drawn .*  $by [0-9]* %" "$tmp/out" || job_fails "not by $by: $(cat "$tmp/out")"
    }
    printf '0,0,10,0,20,0,30,0\n' >"$tmp/line.csv"
    printf 'arc left\n10 0\n0 0\n10 0\n' >"$tmp/ring.loft"
    awk 'BEGIN { print "line"; for (i = 0; i < 60; i++) print i * 0.5, i % 2 * 0.3 }' \
        >"$tmp/saw.loft"
    printf 'max_speed = 500\nx.max_speed = 20\nmax_jerk = 0\n' >"$tmp/slow.txt"
    plan "$tmp/line.csv" --jerk 0       # from rest to rest: 30 mm / 30 mm/s + 30 mm/s / 2000 mm/s2
    awk '$1 == 1 { good = $2 == 1 && $3 == "30.000" && $4 > 1.012 && $4 < 1.022 &&
                          $5 > 29.9 && $5 < 30.1 }
         END { exit !good }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
    limited feed "$tmp/line.csv"
    limited 'x speed' "$tmp/line.csv" --feed 60 --machine "$tmp/slow.txt"
    limited 'x acceleration' "$tmp/line.csv" --feed 1000 --jerk 0
    limited 'x jerk' "$tmp/line.csv" --feed 1000 --jerk 10000
    limited curvature "$tmp/ring.loft" --feed 1000 --accel 300 --jerk 0
    plan --total "$tmp/saw.loft" --jerk 0
    says out '^in all .*, corner [0-9]'
    for num in q16 f32 f64; do
        plan "$tmp/small.csv" --num $num
        [ "$(grep -c '^[0-9]' "$tmp/out")" = 7 ] || job_fails "$num: $(cat "$tmp/out")"
        # rows add up, limits add up, and the total is the plan of `stream`
        awk '/^[0-9]/ { d += $4; l += $3 } /^drawn/ { a = $3; b = $2 } /^in all/ { w = $4 }
             END { d -= a; l -= b
                   exit !(d < 0.01 && d > -0.01 && l < 0.01 && l > -0.01 && w > a) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        local all; all=$(awk '/^in all/ { print $4 }' "$tmp/out")
        run 0 "$loft" stream "$tmp/small.csv" --dry-run --num $num
        awk -v a="$all" '{ for (i = 1; i < NF; i++) if ($(i + 1) == "s,") d = $i - a }
             END { exit !(d < 0.06 && d > -0.06) }' "$tmp/out" ||
            job_fails "$num: $all, $(cat "$tmp/out")"
    done
}
case_plan_as_rows() {
    run 0 "$loft" plan "$tmp/small.csv" --csv 500; is_empty err; cp "$tmp/out" "$tmp/rows"
    # velocity is the slope of the position, and acceleration that of the velocity; limits hold; the
    # end is at rest above the last point
    awk -F, 'NR == 1 { if ($0 != "t,x,y,z,vx,vy,vz,ax,ay,az") exit bad = 1; next }
        NF != 10 { exit bad = 1 }
        NR > 2 && $1 - t > 0.0019 && $1 - t < 0.0021 {
            for (i = 2; i < 8; i++) {
                d = ($i - o[i]) / ($1 - t) - ($(i + 3) + o[i + 3]) / 2
                if (d < 0) d = -d
                if (d > (i < 5 ? 0.05 : 60)) {
                    print "row " NR " column " i " is off by " d
                    exit bad = 1
                }
            }
            n++
        }
        { t = $1; for (i = 2; i <= NF; i++) o[i] = $i }
        END { exit bad || n < 3000 ||
                   !($2 == 60 && $3 == 30 && $4 == 1 && $5 == 0 && $6 == 0 && $7 == 0) }' \
        "$tmp/rows" || job_fails "$(tail -1 "$tmp/rows")"
    run 0 "$loft" plan "$tmp/small.csv" --csv 500 -o "$tmp/file.csv"
    says out '^in all '
    cmp -s "$tmp/file.csv" "$tmp/rows" || job_fails "the file has other rows"
    run 0 sh -c "cat '$tmp/small.csv' | '$loft' plan - --csv 10 --num f64 --park | tail -1"
    says out ',0.000000,0.000000,0.000000,0.00000,0.00000,0.00000,'
}
case_plan_as_spans() {
    run 0 "$loft" plan "$tmp/small.csv" --spans; is_empty err; cp "$tmp/out" "$tmp/spans"
    # no gap in time or place, from rest to rest; every coordinate is a whole number of 2^-16 mm
    /usr/bin/python3 - "$tmp/spans" >"$tmp/why" 2>&1 <<'PY' || job_fails "$(tail -1 "$tmp/why")"
import csv, sys
from fractions import Fraction
rows = list(csv.reader(open(sys.argv[1])))
names = [a + str(k) for a in 'xyz' for k in range(4)]
assert rows[0] == ['start_s', 'duration_s'] + names, rows[0]
now, at = Fraction(0), ['0', '0', '0']
for row in rows[1:]:
    row = dict(zip(rows[0], row))
    assert Fraction(row['start_s']) == now and Fraction(row['duration_s']) > 0, row
    assert [row[a + '0'] for a in 'xyz'] == at, row
    assert all((Fraction(row[n]) * 65536).denominator == 1 for n in names), row
    at, now = [row[a + '3'] for a in 'xyz'], now + Fraction(row['duration_s'])
assert at == ['60', '30', '1'] and [row[a + '2'] for a in 'xyz'] == at, row
PY
    run 0 "$loft" plan "$tmp/small.csv" --spans -o "$tmp/file.csv"; says out '^in all '
    cmp -s "$tmp/file.csv" "$tmp/spans" || job_fails "the file has other spans"
    one_line 64 'give one of them'   "$loft" plan "$tmp/small.csv" --spans --csv 10
}
case_plan_is_certified() {
    run 0 "$loft" plan tests/drawings/outline12.csv --certify; is_empty err
    [ "$(grep -c ' ok$' "$tmp/out")" = 11 ] || job_fails "$(cat "$tmp/out")"
    awk '/^(motion|drawing) from/ { exit !($4 > 0 && $4 <= 0.005) }' "$tmp/out" ||
        job_fails "$(cat "$tmp/out")"
    printf 'kinematics = delta\narm_length = 200\ndelta_radius = 95\n' >"$tmp/delta.txt"
    one_line 64 'a delta machine'    "$loft" plan "$tmp/small.csv" --certify \
        --machine "$tmp/delta.txt"
    one_line 64 'give -o FILE'       "$loft" plan "$tmp/small.csv" --certify --spans
}
case_plan_stops_exactly_at_corners() {
    local rests='NR > 1 { for (k = 6; k < 15; k += 4) if ($(k - 1) != $k) next; print $6, $10 }'
    printf '%s\n' "0,0 10,0 20,0 30,0" "30,0 30,10 30,20 30,30" "30,30 30,31 30,32 31,40" |
        tr ' ' ',' >"$tmp/turn.csv"
    for exact in --exact --exact=60; do
        run 0 "$loft" plan "$tmp/turn.csv" $exact --spans
        awk -F, "$rests" "$tmp/out" >"$tmp/rests"
        grep -q '^30 0$' "$tmp/rests" || job_fails "no stop at 30,0: $(cat "$tmp/rests")"
        ! grep -q '^30 30$' "$tmp/rests" || job_fails "a stop on a smooth joint"
    done
    for exact in "" --exact=120; do
        run 0 "$loft" plan "$tmp/turn.csv" $exact --spans
        awk -F, "$rests" "$tmp/out" >"$tmp/rests"
        ! grep -q '^30 0$' "$tmp/rests" || job_fails "a stop at 30,0"
    done
    run 0 "$loft" plan "$tmp/turn.csv" --exact --certify; is_empty err
    one_line 64 'a machine that plans does not stop' "$loft" stream "$tmp/turn.csv" --dry-run \
        --plan chip --exact
    one_line 64 'exact' "$loft" plan "$tmp/turn.csv" --exact=181
}
case_plan_rounds_corners() {
    seconds() {
        run 0 "$loft" plan "$@" --feed 100 --total
        awk '/^in all/ { print $4 }' "$tmp/out"
    }
    printf '%s\n' "0,0 10,0 20,0 30,0" "30,0 30,10 30,20 30,30" "30,30 30,31 30,32 31,40" |
        tr ' ' ',' >"$tmp/turn.csv"
    printf 'corner = 0.05\n' >"$tmp/round.txt"
    for num in q16 f32 f64; do
        local sharp round said
        sharp=$(seconds "$tmp/turn.csv" --num $num)
        round=$(seconds "$tmp/turn.csv" --num $num --corner 0.05)
        said=$(seconds "$tmp/turn.csv" --num $num --machine "$tmp/round.txt")
        awk "BEGIN { exit !($round < $sharp && $round == $said) }" ||
            job_fails "$num: $sharp s, corners within 50 um $round s, as the machine's $said s"
        run 0 "$loft" plan "$tmp/turn.csv" --num $num --feed 100 --corner 0.05 --certify
        is_empty err
    done
    run 0 "$loft" stream "$tmp/turn.csv" --dry-run --corner 0.05
    run 0 "$loft" stream "$tmp/turn.csv" --dry-run --plan chip --corner 0.05
    one_line 64 'corner' "$loft" plan "$tmp/turn.csv" --corner 2
}
case_plan_as_a_picture() {
    run 0 "$loft" plan "$tmp/small.csv" --total --plot "$tmp/a.png" --size 400; says out '^drawn '
    run 0 "$loft" plan tests/drawings/curves.loft --total --jerk 0 --plot "$tmp/b.svg"
    run 0 "$loft" plan "$tmp/small.csv" --total --plot "$tmp/c.pdf"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] || job_fails "no picture"
    one_line 64 'ends with .png, .svg or .pdf' "$loft" plan "$tmp/small.csv" --plot "$tmp/a.gif"
    one_line 73 'cannot be written'  "$loft" plan "$tmp/small.csv" --plot "$tmp/none/a.png"
    one_line 73 'cannot be written'  "$loft" plan "$tmp/small.csv" --csv 10 -o "$tmp/none/a.csv"
    one_line 64 'give --csv RATE'    "$loft" plan "$tmp/small.csv" -o "$tmp/a.csv"
    one_line 64 'no drawing'         "$loft" plan
    one_line 66 'none.svg: no such'  "$loft" plan "$tmp/none.svg"
    one_line 65 'unknown key'        "$loft" plan "$tmp/small.csv" --machine "$tmp/small.csv"
    printf '\n0,0,9000,0,1,1,2,2\n' >"$tmp/wide.csv"
    one_line 65 'wide.csv:2: a point at 9000,0 mm' "$loft" plan "$tmp/wide.csv"
}
case_machines_as_text() {
    printf '# slow\nmax_speed = 20\ny.max_accel = 100 # mm/s2\nsteps_per_mm = 100\n' \
        >"$tmp/slow.txt"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60; cp "$tmp/out" "$tmp/fast"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60 --machine "$tmp/slow.txt"
    cmp -s "$tmp/out" "$tmp/fast" && job_fails "the limits of the file change nothing"
    printf '%s\n' '$100=100.000 (x, step/mm)' '$101=100.000' '$102=100.000' '$110=1200.000' \
        '$111=1200' '$112=1200' '$121=100.000' '$32=0' >"$tmp/grbl.txt"
    cp "$tmp/out" "$tmp/ours"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60 --machine "$tmp/grbl.txt"
    cmp -s "$tmp/out" "$tmp/ours" ||
        job_fails "the same machine in grbl's numbers gives another plan"
    machine slow --speed fast --once --machine "$tmp/slow.txt"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/slow" --feed 60
    gone "$machine"
    counted slow
    says slow.csv '^# steps_per_mm_z = 100'
    bad_machine() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "bad.txt:$2" timeout 5 "$loft" simulate --machine "$tmp/bad.txt"
    }
    bad_machine '\nx.speed = 3\n'         '2: unknown key "x.speed": there are'
    bad_machine 'max_accel 5\n'           '1: no `=` behind max_accel'
    bad_machine 'z.max_accel = fast\n'    '1: max_accel is not a number: give one in mm/s'
    bad_machine 'slots = 3.5\n'           '1: slots is 3.5: give a whole number from 1 to 4096'
    bad_machine '# a\n$100=\n'            '2: not a setting of grbl'
    bad_machine 'corner = 0.1\n$11=0.2\n' \
        '2: corner is given in line 1 already: remove one'
    bad_machine 'y.max_jerk = 5\n\nmax_jerk = 6\n' \
        '3: max_jerk is given in line 1 already: put what holds for all axes first'
    bad_machine 'slots = 40\n\0\n'                          ' is not text'
    one_line 66 'none.txt' "$loft" simulate --machine "$tmp/none.txt"
}

# kept_lines FILE: settings without their first line, which names the port
kept_lines() { tail -n +2 "$1"; }

case_settings_live_in_the_machine() {
    local m
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"
        says out 'those of its firmware: it keeps none yet'; says out '^steps_per_mm = 80$'
        run 0 "$loft" set x.steps_per_mm=157.48 travel=50 y.min=-5 --port "$tmp/$m" \
            --log "$tmp/talk.log"
        says out '^kept: [0-9]* of 2000 bytes; steps/mm 157.48 80 80$'
        says out 'another one now: `loft home` it, or `loft zero`$'
        says talk.log '> SET .* at 0, 4 bytes$'; says talk.log '< KEPT .* kept$'
        kill "$machine"; gone "$machine"; rm -f "$tmp/$m"
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"; cp "$tmp/out" "$tmp/$m.said"
        says out 'kept by the machine'; says out '^x.steps_per_mm = 157.48$'
        says out '^travel = 50$'; says out '^y.min = -5$'
        # the machine knows its table and its gearing; a file overrules
        one_line 65 'small.csv: takes the tool to x 5..60' \
            "$loft" stream "$tmp/small.csv" --port "$tmp/$m"
        printf 'travel = 80\nmin = -15\n' >"$tmp/wide.txt"
        run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$m" --machine "$tmp/wide.txt"
        says out 'steps 9449 2400 80 as commanded$'
        one_line 65 'the table' "$loft" go 70,0 --port "$tmp/$m"
        kill "$machine"; gone "$machine"
    done
    kept_lines "$tmp/q16.said" | cmp -s - <(kept_lines "$tmp/f64.said") ||
        job_fails "settings differ by number type"
}
case_settings_are_copied_as_a_file() {
    machine from --speed fast --shared --limits x+=40nc
    one_line 69 'the limit switch of x' "$loft" stream "$tmp/small.csv" --port "$tmp/from"
    run 0 "$loft" set x.limit=opens max_jerk=30000 --port "$tmp/from"
    one_line 75 'the limit switch of x closed and ended' \
        "$loft" stream "$tmp/small.csv" --port "$tmp/from"
    run 0 "$loft" settings --port "$tmp/from" --save "$tmp/saved.txt"
    says saved.txt '^x.limit = opens$'; says saved.txt '^max_jerk = 30000$'
    machine to --speed fast
    run 0 "$loft" set --machine "$tmp/saved.txt" --port "$tmp/to"
    run 0 "$loft" settings --port "$tmp/to"
    kept_lines "$tmp/out" | cmp -s - <(kept_lines "$tmp/saved.txt") ||
        job_fails "another machine has other settings: $(cat "$tmp/out")"
    # a motor that turns the other way, and a machine that homes by what it keeps
    machine turned --speed fast --once
    run 0 "$loft" set x.reversed=yes --port "$tmp/turned"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/turned"; gone "$machine"
    says turned.csv ',-4800,2400,80$'
    home_file
    machine homed --speed fast --limits x-=-3,y-=-1.5,z+=12 --walls x-=-9,y-=-9,z+=20
    run 0 "$loft" set --machine "$tmp/home.txt" --port "$tmp/homed"
    run 0 "$loft" home --port "$tmp/homed"
    says out '^homed: the tool is at'
}
case_settings_are_whole_after_a_kill() {
    local i
    machine cut --speed fast --noise 1500 --keep "$tmp/cut.kept"
    run 0 "$loft" set steps_per_mm=100 travel=100 --port "$tmp/cut" --wait 60
    for i in 1 2 3 4; do
        "$loft" set steps_per_mm=20$i travel=20$i --port "$tmp/cut" --wait 60 \
            --log "$tmp/kill.log" >/dev/null 2>&1 & local setting=$!
        for _ in $(seq 3000); do
            grep -q '> SET .* at [1-9][0-9]*, [1-9]' "$tmp/kill.log" 2>/dev/null && break
            sleep 0.01
        done
        if [ $((i % 2)) = 0 ]; then                     # the power fails
            kill -9 "$machine"; gone "$machine"; rm -f "$tmp/cut"
            machine cut --speed fast --noise 1500 --keep "$tmp/cut.kept"
        fi
        kill -9 $setting 2>/dev/null; wait $setting 2>/dev/null; rm -f "$tmp/kill.log"
        run 0 "$loft" settings --port "$tmp/cut" --wait 60
        says out 'kept by the machine'
        [ "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = \
          "$(sed -n 's/^travel = //p' "$tmp/out")" ] || job_fails "mixed: $(cat "$tmp/out")"
    done
}
case_settings_go_back_to_the_firmware() {
    local m
    for m in q16 f64; do
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"; cp "$tmp/out" "$tmp/own"
        run 0 "$loft" set steps_per_mm=100 travel=50 x.reversed=yes x.limit=opens --port "$tmp/$m"
        run 0 "$loft" set --defaults --port "$tmp/$m"
        says out '^back to those of its firmware; steps/mm 80 80 80$'; says out 'another one now'
        run 0 "$loft" settings --port "$tmp/$m"
        cmp -s "$tmp/own" "$tmp/out" || job_fails "other settings: $(cat "$tmp/out")"
        run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$m"
        says out 'steps 4800 2400 80 as commanded$'
        kill "$machine"; gone "$machine"; rm -f "$tmp/$m"
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"
        cmp -s "$tmp/own" "$tmp/out" || job_fails "others after a start: $(cat "$tmp/out")"
        run 0 "$loft" set y.travel=7 --port "$tmp/$m"
        run 0 "$loft" settings --port "$tmp/$m"
        says out 'kept by the machine'; says out '^y.travel = 7$'
        run 0 "$loft" set --defaults --port "$tmp/$m"       # twice has no further effect
        run 0 "$loft" set --defaults --port "$tmp/$m"; says out 'back to those of its firmware'
        kill "$machine"; gone "$machine"
    done
}
case_settings_that_cannot_be() {
    machine plain --speed fast --keep "$tmp/plain.kept"
    local to=(--port "$tmp/plain")
    one_line 64 'nothing to set: give NAME=VALUE' "$loft" set "${to[@]}"
    one_line 64 'no --port' "$loft" set x.travel=3
    one_line 64 'defaults sets all' "$loft" set --defaults x.travel=3 "${to[@]}"
    one_line 64 'no --port' "$loft" settings
    one_line 64 'takes no file' "$loft" settings saved.txt "${to[@]}"
    one_line 65 'set:1: unknown key "x.speed"' "$loft" set x.speed=3 "${to[@]}"
    one_line 65 'set:2: max_accel is 0: give a number from 1' \
        "$loft" set x.travel=10 max_accel=0 "${to[@]}"
    one_line 78 'queue is part of the machine.s firmware' "$loft" set queue=9 "${to[@]}"
    one_line 78 'tolerance is about the plan' "$loft" set tolerance=0.1 "${to[@]}"
    one_line 78 'this board cannot do it: pulse' "$loft" set pulse=9 "${to[@]}"
    one_line 73 'name a file that can be written' \
        "$loft" settings "${to[@]}" --save "$tmp/none/saved.txt"
    run 0 "$loft" settings "${to[@]}"; says out 'it keeps none yet'      # nothing was changed
    run 0 "$loft" set x.travel=100 "${to[@]}"
    run 0 "$loft" set x.travel=200 "${to[@]}"
    kill "$machine"; gone "$machine"; rm -f "$tmp/plain"
    local at
    for at in 30 2030; do printf '\252' | dd of="$tmp/plain.kept" bs=1 seek=$at conv=notrunc \
        2>/dev/null; done
    machine plain --speed fast --keep "$tmp/plain.kept"
    run 0 "$loft" settings "${to[@]}"; says out 'what it kept is damaged'
    run 0 "$loft" stream "$tmp/small.csv" "${to[@]}"
    says err '^loft: .*plain: its settings are damaged: it runs with those of its firmware'
    machine busy --speed real
    draws busy; cut_off 0.5
    one_line 75 'a job is running: wait' "$loft" set x.travel=9 --port "$tmp/busy"
    run 0 "${job[@]}"; says out 'as commanded$'
}

case_zero_tells_the_machine_where_it_stands() {
    machine there --speed fast
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/there"
    run 0 "$loft" zero xy --port "$tmp/there" --log "$tmp/talk.log"
    says out '^the tool was at 60.000 30.000 1.000, and is now at 0.000 0.000 1.000$'
    says talk.log '> CONTROL .* place position 0 0 80'
    run 0 "$loft" zero z --at -2.5 --port "$tmp/there"
    says out 'and is now at 0.000 0.000 -2.500$'
    printf '3,4,3,5,3,6,3,7\n' >"$tmp/line.csv"     # the next job begins there, and is drawn right
    run 0 "$loft" stream "$tmp/line.csv" --port "$tmp/there"
    says out 'steps 240 560 80 as commanded$'
    run 0 "$loft" zero --port "$tmp/there"
    says out '^the tool was at 3.000 7.000 1.000, and is now at 0.000 0.000 0.000$'
    one_line 64 'xx: give each axis once' "$loft" zero xx --port "$tmp/there"
    one_line 64 'no --port' "$loft" zero xy
    one_line 64 'name the axes in one word' "$loft" zero x y --port "$tmp/there"
    machine busy --speed real
    draws busy; cut_off 0.5                             # it waits for the rest of its job
    one_line 75 'a job is running: wait' "$loft" zero --port "$tmp/busy"
    run 0 "${job[@]}"; says err '^resuming at item'; says out 'as commanded$'
    kinematics corexy
    machine corexy --speed fast --machine "$tmp/corexy.txt"
    run 0 "$loft" zero x --at 7 --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out 'now at 7.000 0.000 0.000$'
    run 0 "$loft" zero y --at 2 --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out '^the tool was at 7.000 0.000 0.000, and is now at 7.000 2.000 0.000$'
}
# a table of 40 x 30 x 14 mm; the machine is switched on somewhere on it
home_file() {
    cat >"$tmp/home.txt" <<'END'
x.travel = 40
y.travel = 30
z.travel = 14
z.min = -4
z.home_order = 1
z.home_end = high
x.home_order = 2
y.home_order = 3
y.home_at = -1.5
z.home_back = 2
END
}
table_of() {            # the last place of the tool on its table, and the steps lost
    sed -n 's/^table: the tool is at //p' "$tmp/$1.log" | tail -1
}
case_home_finds_its_switches() {
    home_file
    local ends=x-=-33.37,y-=-12,z+=6 walls=x-=-36,y-=-15,z+=9
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits $ends --walls $walls --bounce 5
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt" --touches 5
        is_empty err
        says out '^z: its switch at the high end, after 6.000 mm, is at 12.000: 5 touches within 0'
        says out '^x: .* low end, after 33.37[0-9] mm, is at -3.000: 5 touches within [01] steps\?$'
        says out '^y: its switch at the low end, after 12.000 mm, is at -1.500: 5 touches within 0'
        says out '^homed: the tool is at 0.000 1.500 10.000$'
        [ "$(table_of $m)" = '-30.3750 -9.0000 4.0000, 0 steps lost' ] || job_fails "$(table_of $m)"
    done
    # what is told of the place is kept: the switch of x is at -3, and its motor stands at 0
    run 0 "$loft" home x --port "$tmp/q16" --machine "$tmp/home.txt"
    says out '^x: .* after 3.000 mm, is at -3.000: 2 touches within 0 steps$'
    printf '5,5,6,5,7,5,8,5\n' >"$tmp/line.csv"
    run 0 "$loft" stream "$tmp/line.csv" --port "$tmp/q16" --machine "$tmp/home.txt"
    says out 'steps 640 400 80 as commanded$'
    [ "$(table_of q16)" = '-22.3750 -5.5000 -5.0000, 0 steps lost' ] || job_fails "$(table_of q16)"
    # one input for both ends; the tool stands on the switch already
    machine uno --speed fast --shared --limits x-=0,x+=40,y-=-12,z+=6 --walls $walls
    run 0 "$loft" home --port "$tmp/uno" --machine "$tmp/home.txt"
    says out '^homed: the tool is at 0.000 1.500 10.000$'
    [ "$(table_of uno)" = '3.0000 -9.0000 4.0000, 0 steps lost' ] || job_fails "$(table_of uno)"
    # corexy: the switches are of the tool
    { echo 'kinematics = corexy'; cat "$tmp/home.txt"; } >"$tmp/corexy.txt"
    machine corexy --speed fast --limits $ends --walls $walls --bounce 5 --machine "$tmp/corexy.txt"
    run 0 "$loft" home --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out '^homed: the tool is at -\?0\.0[0-9]* 1.500 10.000$'
    [[ "$(table_of corexy)" =~ ^-30\.3[678].*\ -9\.0000\ 4\.0000,\ 0\ steps ]] \
        || job_fails "$(table_of corexy)"
}
# by a file without a table, so that the host lets it pass; tool and table as seen by the table
case_a_homed_machine_refuses_what_leaves_its_table() {
    home_file; echo 'tolerance = 0.005' >"$tmp/bare.txt"
    printf '5,5,20,5,30,5,45,5\n' >"$tmp/right.csv"
    local bare=(--machine "$tmp/bare.txt") m how
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits x-=-33.37,y-=-12,z+=6
        goes 8,0 $m '8.000 0.000 0.000' "${bare[@]}"
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt"
        for how in "" --points "--plan chip"; do
            one_line 65 'item [0-9]* leaves the table, where the machine was homed' \
                "$loft" stream "$tmp/right.csv" --port "$tmp/$m" "${bare[@]}" $how
            run 0 "$loft" park --port "$tmp/$m" "${bare[@]}"
        done
        one_line 65 'leaves the table' "$loft" go 40.5 --port "$tmp/$m" "${bare[@]}"
        one_line 65 'leaves the table' "$loft" go -0.5 --port "$tmp/$m" "${bare[@]}"
        goes 40.05,29.5 $m '40.050 29.500 10.000' "${bare[@]}"
        # the table stays where it is when the drawing has another zero
        run 0 "$loft" zero xy --port "$tmp/$m"
        one_line 65 'leaves the table' "$loft" go 2 --port "$tmp/$m" "${bare[@]}"
        goes -39 $m '-39.000 0.000 10.000' "${bare[@]}"
        # kept for good: homed again, the drawing lies there, and the table where it was
        run 0 "$loft" set --machine "$tmp/home.txt" --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m"
        goes 15,10 $m '15.000 10.000 10.000'
        run 0 "$loft" zero xy --keep --port "$tmp/$m"
        says out 'and is now at 0.000 0.000 10.000$'
        one_line 65 'x 26 is beyond the table, -15..25' "$loft" go 26 --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m"
        says out '^homed: the tool is at -15.000 -8.500 10.000$'
        goes 25,20 $m '25.000 20.000 10.000'
        run 0 "$loft" settings --port "$tmp/$m"; says out '^x.zero = 15$'
        run 0 "$loft" zero xy --at 5 --keep --port "$tmp/$m"
        run 0 "$loft" settings --port "$tmp/$m"; says out '^x.zero = 35$'
        one_line 78 'home.txt: --keep changes the settings of the machine' \
            "$loft" zero --keep --port "$tmp/$m" --machine "$tmp/home.txt"
        # a machine that is homed again may look for its switches, wherever it thinks it is
        run 0 "$loft" zero --at 100 --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt"
        says out '^homed: the tool is at 0.000 1.500 10.000$'
    done
}
case_the_emergency_stop_stops_at_once() {
    machine pressed --speed real --once
    draws pressed
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & local sender=$!
    until_log pressed ' begun'; sleep 1; kill -USR1 "$machine"; wait $sender
    [ $? = 75 ] || job_fails "it ended with another code"
    says err 'the emergency stop closed and ended the job .* stopped at once .* is in doubt: then'
    gone "$machine"; counted pressed err
    machine m --speed real
    draws m
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & sender=$!
    until_log m ' begun'; sleep 0.5; kill -USR1 "$machine"; wait $sender
    run 0 "$loft" ports "$tmp/m"
    says out '	its position is in doubt: `loft home`.*	closed: the emergency stop$'
    one_line 69 'the emergency stop is closed: open it' "$loft" unlock --port "$tmp/m"
    kill -USR1 "$machine"
    one_line 69 'its position is in doubt, as after an emergency stop: `loft home' "${job[@]}"
    one_line 69 'its position is in doubt' "$loft" go 0,0 --port "$tmp/m"
    run 0 "$loft" zero xy --port "$tmp/m"
    one_line 69 'its position is in doubt' "$loft" park --port "$tmp/m"
    run 0 "$loft" zero z --port "$tmp/m"
    run 0 "$loft" go 1,1 --port "$tmp/m"; says out '^the tool is at 1.000 1.000 0.000$'
}
# The machine says what it knows, and the next command what to do.
case_a_sender_that_is_killed_in_a_move() {
    local what sender
    home_file
    for what in probe home; do
        # a queue that takes no whole move: the machine runs out of items, and waits on the path
        machine $what --speed real --queue 4 --limits x-=-33 --probe z-=-30
        if [ $what = probe ]; then
            job=("$loft" probe --feed 3 --within 40 --port "$tmp/probe")
        else
            job=("$loft" home x --port "$tmp/home" --machine "$tmp/home.txt")
        fi
        drawing_on=$what; cut_off 0.3
        run 0 "$loft" ports "$tmp/$what"; says out '	in a job$'
        one_line 75 'a job is running: wait for its end, or `loft stream --abort' "${job[@]}"
        run 0 "$loft" stream --abort --port "$tmp/$what"
        says out '^aborted: [0-9]* items executed, at '; counted_place $what \
            "$(sed -n 's/.*steps //p' "$tmp/out")"
        run 0 "$loft" ports "$tmp/$what"; says out '	idle$'
        run 0 "${job[@]}"
    done
    says out '^homed: the tool is at 0.000 0.000 0.000$'
    # the whole move is in the machine: it ends by the guard, and the place is known
    machine whole --speed real --probe z-=-5 --max-speed 20
    job=("$loft" probe --feed 3 --port "$tmp/whole"); drawing_on=whole; cut_off 0.5
    until_log whole ' aborted: '
    run 0 "$loft" ports "$tmp/whole"; says out '	idle$'
    one_line 69 'the probe touches already' "${job[@]}"
    goes ,,0 whole '0.000 0.000 -\?0.000'
    run 0 "${job[@]}"; says out '^touched at 0.000 0.000 -5.0'
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
case_a_servo_in_the_settings() {
    machine servo --speed fast
    run 0 "$loft" set z.drive=servo servo_zero=1234 z.steps_per_mm=100 --port "$tmp/servo"
    run 0 "$loft" settings --port "$tmp/servo"
    says out '^z.drive = servo$'; says out '^servo_zero = 1230$'
    one_line 65 'x.drive = servo: only z can be one' "$loft" set x.drive=servo --port "$tmp/servo"
    run 0 "$loft" set z.drive=step --port "$tmp/servo"
    run 0 "$loft" settings --port "$tmp/servo"
    says out '^z.drive = step$'
    ! grep -q servo_zero "$tmp/out" || job_fails "a motor with $(grep servo_zero "$tmp/out")"
}
# switches of the motors: three carriages, and a radius and an angle
case_home_finds_the_switches_of_motors() {
    local delta=(--machine "$tmp/delta.txt") polar=(--machine "$tmp/polar.txt")
    printf '%s\n' 'kinematics = delta' 'arm_length = 330' 'delta_radius = 160' 'max_speed = 300' \
        'home_order = 1' 'home_end = high' 'home_at = 25' 'home_search = 60' >"$tmp/delta.txt"
    machine delta --speed fast "${delta[@]}" --limits x+=20,y+=21,z+=19.5 \
        --walls x+=23,y+=24,z+=22 --bounce 5
    run 0 "$loft" home --port "$tmp/delta" "${delta[@]}"
    says out '^y: its switch at the high end, .* is at 25.000: 2 touches within [01] step'
    says out '^homed: the tool is at -\?0.000 -\?0.000 22.000$'
    [ "$(table_of delta)" = '17.0000 18.0000 16.5000, 0 steps lost' ] ||
        job_fails "$(table_of delta)"
    goes 10,5,10 delta '9\.99[0-9] 5\.01[0-9] 10.000' "${delta[@]}"
    one_line 78 'its three carriages are homed together' \
        "$loft" home x --port "$tmp/delta" "${delta[@]}"
    one_line 78 'its switches are those of the motors: `loft home`' \
        "$loft" unlock --port "$tmp/delta" "${delta[@]}"
    printf '%s\n' 'kinematics = polar' 'a.home_order = 1' 'b.home_order = 2' 'a.home_at = 10' \
        'b.home_at = -3' 'a.home_search = 50' 'b.home_search = 400' >"$tmp/polar.txt"
    machine polar --speed fast "${polar[@]}" --limits x-=-33,y-=-100
    run 0 "$loft" home --port "$tmp/polar" "${polar[@]}"
    says out '^homed: the tool is at 13.000 -\?0.000 0.000$'
    goes 20,20 polar '20\.00[0-9] 20\.00[0-9] 0.000' "${polar[@]}"
}
# the second motor ahead or behind, by less than home_back; and what cannot be squared
case_home_squares_a_gantry() {
    home_file; echo 'y.square = yes' >>"$tmp/home.txt"
    local ends=x-=-33.37,y-=-12,z+=6 file=(--machine "$tmp/home.txt") m skew=1.3
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits $ends --gantry y=$skew --bounce 5
        run 0 "$loft" home --port "$tmp/$m" "${file[@]}" --touches 3
        says out '^y: squared: its switches close within [01] step.* of each other, before 10[345]$'
        says out '^y: its switch at the low end, after 1[0-2]\.[0-9]* mm, is at -1.500: 3 touches'
        says out '^homed: the tool is at 0.000 1.500 10.000$'
        [[ "$(table_of $m)" =~ ' -9.0'[01].*' 4.0000, 0 steps lost, skewed by '-?0.0[01] ]] \
            || job_fails "$(table_of $m)"
        run 0 "$loft" home y --port "$tmp/$m" "${file[@]}"
        says out '^y: squared: its switches close within [01] steps\? of each other, before [012]$'
        goes 5,5,5 $m '5.000 5.000 5.000' "${file[@]}"
        skew=-1.3
    done
    machine far --speed fast --limits $ends --gantry y=5
    one_line 69 'y: its two motors differ by more than 3 mm, or a switch is stuck' \
        "$loft" home y --port "$tmp/far" "${file[@]}"
    one_line 69 'its position is in doubt' "$loft" go 0 --port "$tmp/far" "${file[@]}"
    machine one --speed fast --limits $ends
    one_line 78 'one motor or one switch pin for an axis with square = yes: square it by hand' \
        "$loft" home y --port "$tmp/one" "${file[@]}"
    one_line 64 'gantry w=1: give an axis and mm' "$loft" simulate --gantry w=1
}
case_home_says_what_is_wrong() {
    home_file
    local file=(--machine "$tmp/home.txt")
    machine none --speed fast --walls x-=-3
    one_line 69 'x: no switch at the low end within 50 mm: look at switch, wire and motor' \
        "$loft" home x --port "$tmp/none" "${file[@]}"
    machine stuck --speed fast --limits x-=-33nc
    one_line 69 'x: its switch at the low end stays closed over 12 mm: is it stuck' \
        "$loft" home x --port "$tmp/stuck" "${file[@]}"
    machine turned --speed fast --limits x+=-5nc                # the motor turns the wrong way
    one_line 69 'x: looking for the switch at the low end, the other one closed: the motor turns' \
        "$loft" home x --port "$tmp/turned" "${file[@]}"
    one_line 78 'no axis has a switch for homing: give z.home_order' "$loft" home --port "$tmp/none"
    one_line 78 'x: how far is its switch at most. give x.travel, or x.home_search' \
        "$loft" home x --port "$tmp/none"
    one_line 64 'xq: give each axis once' "$loft" home xq --port "$tmp/none"
    one_line 64 'name the axes in one word' "$loft" home x y --port "$tmp/none"
    one_line 64 'no --port' "$loft" home x "${file[@]}"
    printf 'kinematics = polar\n' >"$tmp/polar.txt"
    one_line 78 'kinematics = polar: the switch is one of motor a: give a.home_at, where it is' \
        "$loft" home x --port "$tmp/none" --machine "$tmp/polar.txt"
    bad_file() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "bad.txt:$2" "$loft" home --machine "$tmp/bad.txt" --port "$tmp/none"
    }
    bad_file 'x.home_end = left\n' '1: write home_end = low, or high'
    bad_file 'home_end\n' '1: no `=` behind home_end'
    bad_file 'x.home_order = 4\n' '1: home_order is 4: give a whole number from 0 to 3'
    bad_file 'x.home_end = low\nx.home_end = high\n' '2: home_end is given in line 1 already'
    # ^C ends it on the path; what is known of the place is said, and the next run works
    machine slow --speed real --limits x-=-33
    "$loft" home x --port "$tmp/slow" "${file[@]}" >"$tmp/out" 2>"$tmp/err" & local homing=$!
    until_log slow ' begun'; sleep 0.5; kill -INT $homing; wait $homing
    [ $? = 75 ] || job_fails "stopped with another code"
    says err '^loft: stopped: the tool is at -[0-9]*\.[0-9]* 0.000 0.000$'
    # killed without warning: the machine ends its move at the switch, and is free for the next one
    machine killed --speed fast --limits x-=-33
    "$loft" home x --port "$tmp/killed" "${file[@]}" >/dev/null 2>&1 & homing=$!
    disown $homing; until_log killed ' begun'; kill -9 $homing; gone $homing
    until_rest killed
    run 0 "$loft" home x --port "$tmp/killed" "${file[@]}"
    says out '^homed: the tool is at 0.000 0.000 0.000$'
}
case_a_hard_limit_stops_at_once() {
    local to=x+=20 home='loft unlock.*its motors may have lost steps: then home it$'
    printf '0,0,20,0,40,0,60,0\n' >"$tmp/right.csv"
    printf 'limit_stop = hard\n' >"$tmp/hard.txt"
    for m in q16 f32 f64; do        # 100 mm/s: in 100 ticks it slows down over 5 mm
        machine $m --speed fast --num $m --limits $to --bounce 5 --walls x+=22
        one_line 75 'x at its high end closed and ended .* stopped on the path at 25\.' \
            "$loft" stream "$tmp/right.csv" --port "$tmp/$m" --feed 100
        run 0 "$loft" unlock --port "$tmp/$m"
        machine hard$m --speed fast --num $m --limits $to --bounce 5 --walls x+=22
        one_line 75 "high end closed and ended .* stopped at once at 2[01]\\.[0-9]* 0.000.*$home" \
            "$loft" stream "$tmp/right.csv" --port "$tmp/hard$m" --feed 100 \
            --machine "$tmp/hard.txt"
        [[ "$(table_of $m)" = *', 0 steps lost' ]] && job_fails "no wall was there"
        [[ "$(table_of hard$m)" = *', 0 steps lost' ]] || job_fails "$(table_of hard$m)"
        one_line 69 'the limit switch of x at its high end is closed: move away' \
            "$loft" stream "$tmp/right.csv" --port "$tmp/hard$m" --machine "$tmp/hard.txt"
        run 0 "$loft" go 5 --port "$tmp/hard$m" --machine "$tmp/hard.txt"
        one_line 75 'stopped at once at 2[01]\.' \
            "$loft" go 25 --port "$tmp/hard$m" --machine "$tmp/hard.txt"
    done
    printf 'limit_stop = soft\n' >"$tmp/soft.txt"
    one_line 65 'soft.txt:1: write limit_stop = ramp, or hard' \
        "$loft" go 5 --port "$tmp/q16" --machine "$tmp/soft.txt"
}
case_unlock_leads_away_from_a_switch() {
    printf '0,0,4,0,8,0,12,0\n' >"$tmp/right.csv"
    machine high --speed fast --limits x+=5 --walls x+=9
    run 75 "$loft" stream "$tmp/right.csv" --port "$tmp/high" --feed 20
    run 0 "$loft" unlock --port "$tmp/high"
    says out '^free: the tool is at [34]\.[0-9]* 0.000 0.000$'
    run 0 "$loft" unlock --port "$tmp/high"; says out '^no switch is closed'
    machine uno --speed fast --limits x+=5 --shared
    run 75 "$loft" stream "$tmp/right.csv" --port "$tmp/uno" --feed 20
    one_line 69 'at which end is not known: name the way out, as `loft unlock x+`' \
        "$loft" unlock --port "$tmp/uno"
    one_line 69 'x: its switch .* stays closed over 12 mm' "$loft" unlock x+ --port "$tmp/uno"
    one_line 69 'x: its switch .* stays closed over 12 mm' "$loft" unlock x- --port "$tmp/uno"
    run 0 "$loft" unlock x- --port "$tmp/uno"; says out '^free: the tool is at [34]\.[0-9]* '
    one_line 64 'x: name one way out' "$loft" unlock x --port "$tmp/uno"
}
# goes PLACE..: `loft go` ends there
goes() { run 0 "$loft" go "$1" --port "$tmp/$2" "${@:4}"; says out "^the tool is at $3\$"; }
case_go_moves_straight_to_a_place() {
    machine there --speed fast --limits x-=-10,x+=100 --walls x-=-15
    goes 10,20 there '10.000 20.000 0.000'; counted_place there '800 1600 0'
    goes -5,3 there '-5.000 3.000 0.000'
    goes ,,5 there '-5.000 3.000 5.000'
    goes -1 there '-6.000 3.000 5.000' --by
    goes 1,1,-1 there '-5.000 4.000 4.000' --by
    goes -5,4,4 there '-5.000 4.000 4.000'                  # it is there
    printf 'x.travel = 50\nx.min = -4\n' >"$tmp/table.txt"
    one_line 65 'x 47 is beyond the table, -4..46: stay on it' \
        "$loft" go 47 --port "$tmp/there" --machine "$tmp/table.txt"
    goes -4.5 there '-4.500 4.000 4.000' --machine "$tmp/table.txt"     # back to it
    run 0 "$loft" pen down --port "$tmp/there"; says out '^the tool is at -4.500 4.000 0.000$'
    run 0 "$loft" pen up --port "$tmp/there"; says out '^the tool is at -4.500 4.000 1.000$'
    run 0 "$loft" pen down --port "$tmp/there"
    printf 'x.park = 3\npen_up = 2.5\n' >"$tmp/park.txt"
    run 0 "$loft" park --port "$tmp/there" --machine "$tmp/park.txt"
    says out '^the tool is at 3.000 0.000 2.500$'; counted_place there '240 0 200'
    # into a switch, and away from it alone
    one_line 75 'the limit switch of x at its low end closed .*`loft unlock`' \
        "$loft" go -12 --port "$tmp/there"
    one_line 69 'low end is closed, and this does not lead away from it: `loft unlock' \
        "$loft" go -13 --port "$tmp/there"
    one_line 69 'does not lead away' "$loft" go ,10 --port "$tmp/there"
    goes 0 there '0.000 0.000 .*'
    # CoreXY: a place is one of the tool
    printf 'kinematics = corexy\n' >"$tmp/corexy.txt"
    machine cross --speed fast --machine "$tmp/corexy.txt"
    goes 10,20 cross '10.000 20.000 0.000' --machine "$tmp/corexy.txt"
    counted_place cross '2400 -800 0'
    # polar: past the pole, where the angle turns by half a turn
    printf 'kinematics = polar\nx.center = 0\n' >"$tmp/polar.txt"
    machine polar --speed fast --machine "$tmp/polar.txt"
    goes 20,0 polar '20.000 0.000 0.000' --machine "$tmp/polar.txt"
    goes -20,0 polar '-20.000 -\?0.000 0.000' --machine "$tmp/polar.txt"
    for bad in x 1,2,3,4 1,2x '' 1,1e9; do
        one_line 64 'give a place in mm as X,Y' "$loft" go "$bad" --port "$tmp/there"
    done
    one_line 64 'name one place' "$loft" go --port "$tmp/there"
    one_line 64 'name one place' "$loft" go 1 2 --port "$tmp/there"
    one_line 64 'no --port' "$loft" go 1
    one_line 64 'give up or down' "$loft" pen sideways --port "$tmp/there"
    one_line 64 'park takes no place' "$loft" park 3,4 --port "$tmp/there"
    machine busy --speed real
    draws busy; cut_off 0.5
    one_line 75 'a job is running' "$loft" go 1,1 --port "$tmp/busy"
}
counted_place() {       # the last pulse of the record
    local last
    last=$(tail -1 "$tmp/$1.csv" | cut -d, -f2- | tr ',' ' ')
    [ "$last" = "$2" ] || job_fails "the pulses led to \`$last\`, not to \`$2\`"
}
case_probe_finds_a_surface() {
    for m in q16 f64; do
        machine $m --speed fast --num $m --probe z-=-3.333,x+=7 --walls z-=-5 --bounce 5
        run 0 "$loft" probe --port "$tmp/$m"        # 267 steps down is the first place beyond
        says out '^touched at 0.000 0.000 -3.337$'; says out '^the tool is at 0.000 0.000 -1.337$'
        run 0 "$loft" probe --at 15 --feed 5 --port "$tmp/$m"
        says out '^touched at 0.000 0.000 15.000$'; says out '^the tool is at 0.000 0.000 17.000$'
        run 0 "$loft" probe --port "$tmp/$m"; says out '^touched at 0.000 0.000 15.000$'
        run 0 "$loft" probe x+ --port "$tmp/$m" --back 0.5
        says out '^touched at 7.000 0.000 17.000$'; says out '^the tool is at 6.500 0.000 17.000$'
        [ "$(table_of $m)" = '6.5000 0.0000 -1.3375, 0 steps lost' ] || job_fails "$(table_of $m)"
    done
    one_line 69 'has touched nothing within 1 mm; the tool is at 6.500 1.000 17.000: give more' \
        "$loft" probe y+ --within 1 --port "$tmp/q16"
    run 0 "$loft" go ,,12 --port "$tmp/q16"
    one_line 69 'the probe touches already' "$loft" probe --port "$tmp/q16"
    one_line 64 'z: name one direction' "$loft" probe z --port "$tmp/q16"
}
case_jog_by_lines() {
    machine there --speed fast
    run 0 bash -c "printf 'x10\n\ny-2.5 z1\nx-1e0\ty2.5\n' | '$loft' jog --port '$tmp/there'"
    says out '^the tool is at 10.000 0.000 0.000$'; says out '^the tool is at 10.000 -2.500 1.000$'
    says out '^the tool is at 9.000 0.000 1.000$'; counted_place there '720 0 80'
    for bad in x x1x 1 'x1 x2' q; do
        one_line 65 '-:2: not a move: give axes and mm' \
            bash -c "printf 'x1\n$bad\nx1\n' | '$loft' jog --port '$tmp/there'"
    done
    printf 'x.travel = 20\n' >"$tmp/table.txt"
    one_line 65 'x 24 is beyond the table' \
        bash -c "echo x10 | '$loft' jog --port '$tmp/there' --machine '$tmp/table.txt'"
    one_line 64 'jog takes keys, or lines' "$loft" jog x1 --port "$tmp/there"
    one_line 64 'name a port' "$loft" jog --port -
}
case_jog_by_keys() {
    machine keyed --speed real
    run 0 "$loft" go 1,1 --port "$tmp/keyed"
    # two taps, a step of 10 mm, an arrow (ESC [ C) of 0.1 mm
    "$pty" type "$tmp/keyed.log" "0.5:d 1.2:d 2:4 2.2:w 4:2 4.2:^[ 4.25:[ 4.3:C 5.5:q" \
        "$loft" jog --port "$tmp/keyed" >"$tmp/out"
    [ $? = 0 ] || job_fails "jog ended with another code"
    says out '3.100 11.000 0.000'; counted_place keyed '248 880 0'
    # a held key moves on, and its release stops the tool on the path, far before the end
    local held='' at
    for at in $(seq 500 33 2500); do held+="$(echo "$at" | sed 's/...$/.&/; s/^\./0./'):a "; done
    "$pty" type "$tmp/keyed.log" "$held 4.5:q" "$loft" jog --port "$tmp/keyed" >"$tmp/out"
    at=$(tail -1 "$tmp/keyed.csv" | cut -d, -f2)
    [ "$at" -lt -1000 ] && [ "$at" -gt -8000 ] || job_fails "a held key led to step $at"
    until_log keyed 'aborted'
    # the table ends it
    printf 'x.travel = 20\nx.min = -10\n' >"$tmp/table.txt"
    machine edge --speed real
    run 0 "$loft" go 1,1 --port "$tmp/edge"
    "$pty" type "$tmp/edge.log" "$held 4.5:q" "$loft" jog --port "$tmp/edge" \
        --machine "$tmp/table.txt" >"$tmp/out"
    counted_place edge '-800 80 0'
}
case_a_drawing_that_leaves_the_table() {
    # an arch: x 10..50, y 0..30, though its control points reach to 40
    printf '10,0,10,40,50,40,50,0\n' >"$tmp/arch.csv"
    table() { printf "$1" >"$tmp/table.txt"; }
    fits() { table "$1"; run 0 "$loft" stream "$tmp/arch.csv" --dry-run \
        --machine "$tmp/table.txt"; is_empty err; }
    leaves() { table "$1"; one_line 65 "arch.csv: takes the tool to $2" "$loft" stream \
        "$tmp/arch.csv" --dry-run --machine "$tmp/table.txt" "${@:3}"; }
    fits 'x.travel = 50\ny.travel = 30\n'
    fits 'x.travel = 40\nx.min = 10\ny.travel = 30\nz.travel = 1\n'
    fits 'x.travel = 49.996\n'                         # as far as the tolerance
    leaves 'x.travel = 49.99\n' 'x 10..50, and the table is x 0..49.99: moved by -0.01,0 it fits'
    leaves 'x.travel = 40\nx.min = 20\ny.travel = 30\ny.min = 5\n' \
        'x 10..50, y 0..30, and the table is x 20..60, y 5..35: moved by 10,5 it fits'
    leaves 'x.travel = 30\ny.travel = 50\n' 'x 10..50, y 0..30, .*: turned by 90 degrees it fits'
    leaves 'x.travel = 20\ny.travel = 20\n' '.* x 0..20, y 0..20: at 0.5 of its size it fits'
    leaves 'z.travel = 3\n' 'z 0..4, and the table is z 0..3: the drawing fits: .* --lift' --lift 4
    leaves 'z.travel = 3\nz.min = 1\n' 'z 0..1, .* z 1..4: the pen draws at z 0..0: give a z.min'
    printf 'line\n0 0 -2\n9 9 3\n' >"$tmp/space.loft"
    table 'z.travel = 9\nz.min = -2\n'
    run 0 "$loft" plan "$tmp/space.loft" --machine "$tmp/table.txt"
    table 'z.travel = 9\nz.min = -1\n'
    one_line 65 'z -2..4, .* z -1..8: the pen draws at z -2..3: give' "$loft" plan \
        "$tmp/space.loft" --machine "$tmp/table.txt"
    leaves 'x.min = 10\nx.travel = 40\n' 'x 0..50, .* leave out --park' --park
    leaves '$130=49.000\n$131=200.000\n' 'x 10..50, y 0..30, and the table is x 0..49, y 0..200'
    for kind in corexy polar; do        # the table is for the tool
        leaves "kinematics = $kind\nx.travel = 49\n" 'x 10..50, and the table is x 0..49'
    done
    table 'x.travel = 40\n'
    one_line 65 'x 0..40: moved by -10,0' "$loft" plan "$tmp/arch.csv" --machine "$tmp/table.txt"
    one_line 65 'x 0..40: moved by -10,0' "$loft" stream "$tmp/arch.csv" --grbl --dry-run \
        --machine "$tmp/table.txt"
    machine tabled --speed fast --machine "$tmp/table.txt"
    one_line 65 'x 0..40: moved by -10,0' "$loft" stream "$tmp/arch.csv" --port "$tmp/tabled" \
        --machine "$tmp/table.txt"
    grep -q ' begun' "$tmp/tabled.log" && job_fails "the machine has begun the job"
    [ "$(grep -c '^[0-9]' "$tmp/tabled.csv")" = 0 ] || job_fails "the machine has moved"
    table 'y.min = 5\n'
    one_line 65 'table.txt:1: y.min is 5, but the table has no size there: give y.travel' \
        "$loft" plan "$tmp/arch.csv" --machine "$tmp/table.txt"
}

# kinematics KIND: a machine of this kind in $tmp/KIND.txt, for small.csv
kinematics() {
    printf 'kinematics = %s\nslots = 200\n' "$1" >"$tmp/$1.txt"
    case $1 in
    corexy|hbot) echo 'steps_per_mm = 320' ;;
    delta) printf '%s\n' 'arm_length = 200' 'delta_radius = 95' 'x.center = 30' 'y.center = 10' \
        'steps_per_mm = 800' ;;
    polar) printf '%s\n' 'steps_per_mm = 320' 'b.steps_per_mm = 400 # per degree' \
        'x.center = 20' 'y.center = -30' 'b.max_speed = 400' ;;
    esac >>"$tmp/$1.txt"
}
# carries KIND BOUND OPTIONS..: draw on it; the error of the tool is at most the tolerance plus
# BOUND, the effect of the steps of its motors
carries() {
    local kind=$1 bound=$2 worst; shift 2
    kinematics "$kind"
    machine "$kind" --speed fast --once --machine "$tmp/$kind.txt"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$kind" --machine "$tmp/$kind.txt" \
        --record "$tmp/$kind.csv" "$@"
    gone "$machine"
    is_empty err; says out '^drawn: 7 curves, .*as commanded$'; counted "$kind"
    worst=$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")
    awk -v w="$worst" -v b="$bound" 'BEGIN { exit !(w != "" && w > 0 && w <= 0.005 + b) }' \
        || job_fails "$kind: worst path error \`$worst\`"
    run 0 "$loft" plot "$tmp/small.csv" --record "$tmp/$kind.csv" -o "$tmp/$kind.png"
    says out "path error $worst mm at worst"
    says "$kind.csv" "^# kinematics = $kind"
}
# A motor errs by half a step at a tick and half a step for the slots between. corexy: 1/320 mm in
# total. delta: 4 steps of 1/800 mm, at the edge of this drawing. polar: one step of radius, 1/320
# mm, and one of 1/400 degree, 65 mm from the pole.
case_kinematics_corexy()        { carries corexy 0.0032; carries hbot 0.0032 --num f64; }
case_kinematics_delta()         { carries delta 0.0050; }
case_kinematics_polar()         { carries polar 0.0043; }
case_kinematics_points() {
    carries delta 0.0050 --points
    carries polar 0.0043 --points --num f32
}
case_kinematics_planned_there() {
    carries corexy 0.0032 --plan chip
    carries delta 0.0050 --plan chip
    carries polar 0.0043 --plan chip
}
case_kinematics_cut_off() {
    kinematics delta
    machine there --speed real --machine "$tmp/delta.txt"
    job=("$loft" stream "$tmp/small.csv" --port "$tmp/there" --machine "$tmp/delta.txt" --feed 60)
    drawing_on=there
    cut_off 1
    run 0 "${job[@]}"
    says err '^resuming at item'
    says out 'as commanded$'
    local end; end=$(sed -n 's/.* \(steps .* as commanded\)$/\1/p' "$tmp/out")
    run 0 "${job[@]}"; says out "$end"
    run 0 "${job[@]}" --park; says out 'steps 0 0 0 as commanded'
}
case_kinematics_plan() {
    local kind
    for kind in corexy delta polar; do
        kinematics $kind
        run 0 "$loft" plan "$tmp/small.csv" --machine "$tmp/$kind.txt" --csv 500 -o "$tmp/rows" \
            --plot "$tmp/$kind.svg"
        is_empty err
        # The tool's rows: velocity is the slope of the position, acceleration that of the velocity.
        # In a span of one tick, rounding to 2^-16 mm changes the acceleration of a motor by at most
        # 12 * 2^-16 mm / tick^2 = 183 mm/s2, and the slope over two ticks by
        # 3 * 2^-16 mm / tick^2 = 46; the average is a hundredth. The feed holds, also for travels.
        awk -F, 'NR == 1 { next }
            NR > 2 && $1 - t > 0.0019 && $1 - t < 0.0021 {
                for (i = 2; i < 8; i++) {
                    d = ($i - o[i]) / ($1 - t) - ($(i + 3) + o[i + 3]) / 2
                    if (d < 0) d = -d
                    if (d > (i < 5 ? 0.05 : 230)) {
                        print "row " NR " column " i " is off by " d
                        exit bad = 1
                    }
                    if (i > 4) off += d * d
                }
                n++
            }
            {
                t = $1; for (i = 2; i <= NF; i++) o[i] = $i
                v = sqrt($5 ^ 2 + $6 ^ 2 + $7 ^ 2)
                if (v > 100.3 || ($4 < 0.001 && v > 30.1)) {
                    print "row " NR ": " v " mm/s"
                    exit bad = 1
                }
            }
            END {
                if (!bad && sqrt(off / 3 / n) > 5) {
                    print "acceleration is off by " sqrt(off / 3 / n) " on the average"
                    bad = 1
                }
                exit bad || n < 2000 || !($2 > 59.99 && $2 < 60.01 && $3 > 29.99 && $3 < 30.01 &&
                    $4 > 0.99 && $4 < 1.01)
            }' "$tmp/rows" >"$tmp/why" ||
            job_fails "$kind: $(cat "$tmp/why") $(tail -1 "$tmp/rows")"
        says out '^drawn  *180\.270 '; says out '[abc] jerk [0-9]'
    done
}
case_kinematics_refused() {
    bad_kind() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "$2" "$loft" plan "$tmp/small.csv" --machine "$tmp/bad.txt"
    }
    bad_kind 'kinematics = scara\n' \
        'bad.txt:1: write kinematics = cartesian, corexy, hbot, delta or polar'
    bad_kind '# a\nkinematics = delta\narm_length = 90\n' \
        'bad.txt:2: kinematics = delta needs delta_radius as well'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 90\n' \
        'bad.txt:3: arms of 90 mm do not reach'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 50\nb.tower_angle = 200\n' \
        'bad.txt:4: two towers at 210 and 200 degrees'
    bad_kind 'arm_length = 90\nkinematics = polar\n' \
        'bad.txt:1: arm_length is for kinematics = delta, and this machine is polar'
    bad_kind 'y.center = 90\n' \
        'bad.txt:1: center is for kinematics = delta or polar, and this machine is cartesian'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 50\n' \
        'small.csv:[0-9]*: .* is beyond a delta machine like this, .* from the tower of motor'
    bad_kind 'kinematics = polar\nx.center = 60\ny.center = 20\n' \
        'small.csv:7: .* from the pole'
    printf 'arc left 30\n40 0\n0 0\n40 0\n' >"$tmp/turns.loft"
    printf 'kinematics = polar\n' >"$tmp/bad.txt"
    one_line 65 'turns.loft:1: .* motor b would be at 8[0-9.]*, of 8191' "$loft" plan \
        "$tmp/turns.loft" --machine "$tmp/bad.txt"
    kinematics delta
    one_line 65 'for these motors 0.0012 mm are 0.000[56][0-9]*: give --tol' "$loft" plan \
        "$tmp/small.csv" --machine "$tmp/delta.txt" --tol 0.0012
    kinematics corexy; printf 'y.max_speed = 20\n' >>"$tmp/corexy.txt"     # one limit for both
    run 0 "$loft" plan "$tmp/small.csv" --machine "$tmp/corexy.txt" --total --feed 100
    awk '/^drawn/ { exit !($4 > 19.8 && $4 < 20.02) }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}


case_study_of_a_patch() {
    run 0 "$loft" study gb --fine 6 --brief
    says out ' numbers beside expected ones, 0 of them off; 0 without'
    run 0 "$loft" study gb --fine 4 --expected tests/vectors/ch4_numbers.csv
    says out '^4-3;P1_regular;B0 at the centre (vertex mean);H;0.2864;0.2864;'
    local ray='Z_tt on the centre-vertex ray at rho=0.5, 0.75, 0.9; dz=4.4'
    says out "^4-6..4-11;P3_irregular;$ray;MV;"
    sed 's/vertex mean);W;0.2864;/vertex mean);W;0.2865;/' tests/vectors/ch4_numbers.csv \
        >"$tmp/other.csv"
    run 65 "$loft" study gb --fine 4 --expected "$tmp/other.csv" --brief
    says out ';0.2864;0.2865;.*;off$'
    says out ' 1 of them off'
    one_line 64 'give `gb`' "$loft" study
    head -c 100000 /dev/urandom >"$tmp/random.bin"; : >"$tmp/nothing"
    for other in "$tmp/random.bin" "$tmp/nothing" tests/vectors/flatten.csv; do
        one_line 65 'no row of it is a number of this study' "$loft" study gb --fine 4 --brief \
            --expected "$other"
    done
    one_line 65 'cannot be read' "$loft" study gb --fine 4 --expected "$tmp"
    one_line 66 'none.csv: no such file' "$loft" study gb --expected "$tmp/none.csv"
    one_line 73 'name a place in a folder' "$loft" study gb --pictures-only -o "$tmp/none/deep"
}
case_harmonic_coordinates_as_a_table() {
    printf '0,0\n4,0 # a notch\n4,3\n2,1\n0,3\n' >"$tmp/notch.csv"
    run 0 "$loft" harmonic "$tmp/notch.csv" -o "$tmp/notch.h"; says out '^error at most [0-9.e-]*, '
    grep -q '^static const loft_harmonic_table ' "$tmp/notch.h" || job_fails "no table"
    printf '%s\n' '#include "polygon/harmonic.h"' '#include "notch.h"' \
        'int main(void) { return notch_table.sides != 5; }' >"$tmp/use.c"
    gcc -std=c99 -Wall -Wextra -Werror -Ilib -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=3 "$tmp/use.c" \
        -o "$tmp/use" 2>"$tmp/err" && "$tmp/use" || job_fails "$(head -3 "$tmp/err")"
    run 0 "$loft" harmonic "$tmp/notch.csv" --num f64 -o "$tmp/notch.csv.csv"
    says notch.csv.csv '^term,'
    run 0 "$loft" harmonic "$tmp/notch.csv" --at 2,0.5
    says out '^0\.[0-9]*,0\.[0-9]*,0\.[0-9]*,0\.[0-9]*,0\.[0-9]*$'
    printf '0,0\n1,1\n1,0\n0,1\n' >"$tmp/cross.csv"
    one_line 65 'cross.csv: .*cross' "$loft" harmonic "$tmp/cross.csv"
    one_line 65 'not 3 to 8' "$loft" harmonic /dev/null
    one_line 66 'none.csv' "$loft" harmonic "$tmp/none.csv"
    printf '0,0\n4,0\n4,3\n2.0005,3\n2,0.0005\n' >"$tmp/deep.csv"
    run 0 "$loft" harmonic "$tmp/deep.csv"; says out '^error at most [0-9.]*e-0[789], '
    printf '%s\n' 26.1,-0.468 27.149,0.755 2.026,-0.682 23.439,-0.811 29.516,-0.844 15.011,-0.323 \
        >"$tmp/blade.csv"
    run 0 "$loft" harmonic "$tmp/blade.csv"; says out '^error at most [0-9.]*e-0[789], '
    printf '0,0\n100,0.001\n200,0\n100,0.002\n' >"$tmp/needle.csv"
    run 65 "$loft" harmonic "$tmp/needle.csv"
    says err 'needle.csv: the error is above 1e-6, [0-9.e-]*: the polygon is too narrow somewhere'
}


# --- run them -------------------------------------------------------------------------------------

run_case() {
    tmp=$top/$1 why='' children=()
    mkdir "$tmp"; cp "$top/small.csv" "$tmp"
    trap 'for c in "${children[@]}"; do kill "$c" 2>/dev/null; done' EXIT
    declare -F "case_$1" >/dev/null || job_fails "there is no such case"
    [ -n "$why" ] || "case_$1" 2>"$tmp/shell.err"
    if [ -z "$why" ]; then echo "ok   e2e $1"; else echo "FAIL e2e $1:${why#;}"; fi
}

main() {        # the shell reads this as a whole before it runs: the file may be edited meanwhile
    local cases=("$@") passed failed
    [ $# -gt 0 ] || mapfile -t cases < <(sed -n 's/^case_\([a-z0-9_]*\)().*/\1/p' "$0")
    for name in "${cases[@]}"; do
        while [ "$(jobs -rp | wc -l)" -ge 4 ]; do wait -n; done
        run_case "$name" | tee -a "$top/results" &
    done
    wait
    passed=$(grep -c '^ok' "$top/results")
    failed=$((${#cases[@]} - passed))
    echo "$passed passed, $failed failed"
    [ $failed = 0 ]
    exit
}
main "$@"
