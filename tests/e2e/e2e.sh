#!/bin/bash
# tests/e2e/e2e.sh -- tests whole jobs: the command, a pseudo terminal, the simulated machine,
# counted pulses
# SPDX-License-Identifier: MIT
# usage: tests/e2e/e2e.sh LOFT PLAIN HELPERS [CASE..] ; HELPERS contains pty and shim.so. LOFT may
# be sanitized, PLAIN is what users have: memory is measured with it. Each case prints one line; the
# last line is the sum. Cases are functions, case_CASE, of the files beside this one: a file for
# each subject. What several of those use is here.
# The cases mostly wait for machines in real time, so several run at once, each in a folder of its
# own ($tmp).
set -u
loft=$1 plain=$2 pty=$3/pty shim=$3/shim.so; shift 3
top=$(mktemp -d)
trap 'rm -rf "$top"' EXIT
declare -A machines=()
mkfifo "$top/never"
mapfile -t subjects < <(grep -l '^case_[a-z0-9_]*()' "${0%/*}"/*.sh)
for subject in "${subjects[@]}"; do . "$subject"; done
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

# A case never waits for a time: on a busy computer that is too short. It waits until a machine or a
# command has said something, or it halts the machine at a place in a job, does something to it, and
# lets it go on.

# machine NAME OPTIONS..: a new simulated machine behind $tmp/NAME, its pulses in $tmp/NAME.csv
machine() {
    rm -f "$tmp"/state/loft/*
    on_again "$@"
}
# on_again NAME OPTIONS..: one that had a job before, perhaps
on_again() {
    local name=$1; shift
    rm -f "$tmp/$name.log"              # the link of a machine that was killed may still be there
    "$loft" simulate --link "$tmp/$name" --record "$tmp/$name.csv" "$@" >"$tmp/$name.log" 2>&1 &
    machine=$!; children+=("$machine"); disown "$machine"
    machines[$name]=$machine
    until_log "$name" '^machine: '
}
# These wait for minutes, if they must.
wait_for() { until_true [ -e "$1" ] || job_fails "$1 did not appear"; }
gone() {
    until_true is_gone "$1" && return
    job_fails "process $1 did not end"
    kill -9 "$1"
}
is_gone() { ! kill -0 "$1" 2>/dev/null; }
until_true() {          # COMMAND..: it succeeds
    local tries=0
    until "$@"; do
        [ $((tries += 1)) -lt 30000 ] || return 1
        read -rt 0.02 <>"$top/never"
    done
    true
}
until_file() { "$pty" until "$tmp/$1" "$2" || job_fails "$1 never said: $2"; }
until_log() { until_file "$1.log" "$2"; }
# halted MACHINE TICK: it stands at a place of --halt, where go_on MACHINE lets it continue
halted() { until_log "$1" "halted at tick $2"'$'; }
go_on() { kill -USR2 "${machines[$1]}"; }

# until_rest MACHINE: each job that it has begun is over, and none of its own begins after it
until_rest() { until_true is_at_rest "$tmp/$1.log" || job_fails "the machine never came to rest"; }
is_at_rest() { [ "$(grep -c ' begun' "$1")" = "$(grep -cE 'aborted|done' "$1")" ]; }

# run CODE COMMAND..: standard output to $tmp/out, standard error to $tmp/err; the exit code must
# be CODE
run() {
    local want=$1 got; shift
    timeout 1000 "$@" >"$tmp/out" 2>"$tmp/err" </dev/null; got=$?
    [ "$got" = "$want" ] || job_fails "exit code $got, not $want: $(head -c 300 "$tmp/err")"
}
# worked PID: it has computed for half a second
worked() { until_true has_worked "$1" || job_fails "process $1 does not compute"; }
has_worked() {
    local fields
    read -r -a fields <"/proc/$1/stat" && [ $((fields[13] * 2)) -gt "$(getconf CLK_TCK)" ]
}
# interrupted COMMAND..: when it has worked
interrupted() {
    "$@" >"$tmp/out" 2>"$tmp/err" & local interrupted=$!
    worked $interrupted; kill -INT $interrupted; wait $interrupted
    [ $? = 75 ] || job_fails "the command ended with another code: $(cat "$tmp/err")"
}
says() { grep -q -- "$2" "$tmp/$1" || job_fails "does not say \`$2\`: $(tail -c 300 "$tmp/$1")"; }
# is_empty FILE: it has no lines except those about waiting on a busy computer
is_empty() {
    ! grep -qv '^waiting: ' "$tmp/$1" || job_fails "says: $(head -c 200 "$tmp/$1")"
}

# visible FILE: it has no byte that a terminal obeys
visible() {
    ! LC_ALL=C grep -q '[^[:print:][:space:]]' "$tmp/$1" \
        || job_fails "control bytes: $(head -c 200 "$tmp/$1" | cat -v)"
}

# one_line CODE PATTERN COMMAND..: the error has exactly one line, with the key word of the remedy,
# beside those about waiting
one_line() {
    local code=$1 pattern=$2; shift 2
    run "$code" "$@"
    [ "$(grep -cv '^waiting: ' "$tmp/err")" = 1 ] || job_fails "not one line: $(cat "$tmp/err")"
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
slowly=(--feed 60)      # the job lasts about 5 s of machine time
starving=(--speed fast --queue 40 --ramp 20)    # a machine that cannot hold all of it
# draws MACHINE: set ${job[@]}
draws() { drawing_on=$1; job=("$loft" stream "$tmp/small.csv" --port "$tmp/$1" "${slowly[@]}"); }
# cut_off TICK: kill ${job[@]} without warning when the machine is halted there; it goes on, and
# stops where it runs out of items
cut_off() {
    stop_at "$1" KILL; gone $sender
    go_on "$drawing_on"
}
# stop_at TICK SIGNAL [takes_up]: ${job[@]} gets it when the machine is halted there
stop_at() {
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & sender=$!
    [ "$2" != KILL ] || disown $sender
    ${3-}
    halted "$drawing_on" "$1"
    kill -"$2" $sender || job_fails "the sender ended before it got SIG$2"
}
# takes_up: the job of a machine that still stands where it was cut off by stop_at; it goes on
takes_up() { until_file err 'resuming at item'; go_on "$drawing_on"; }
# goes_on: ${job[@]} takes up such a job, to its end
goes_on() {
    "${job[@]}" "$@" >"$tmp/out" 2>"$tmp/err" </dev/null & sender=$!
    takes_up
    wait $sender || job_fails "exit code $?: $(head -c 300 "$tmp/err")"
}
# asks VERB: as another command does, of such a machine
asks() {
    "$loft" stream "--$1" --port "$tmp/$drawing_on" >"$tmp/out" 2>"$tmp/err" & local asking=$!
    until_log "$drawing_on" 'asked to'; go_on "$drawing_on"
    wait $asking || job_fails "exit code $?: $(cat "$tmp/err")"
}
cut_off_when_sent() {   # as soon as the machine has accepted the last item; it is halted at TICK
    "${job[@]}" --log "$tmp/talk.log" >/dev/null 2>&1 & sender=$!
    disown $sender
    until_log talk "< .* all"
    halted "$drawing_on" "$1"
    kill -9 $sender || job_fails "the sender ended before it could be killed"
    gone $sender
    go_on "$drawing_on"
}
# types MACHINE SCRIPT COMMAND..: on a terminal, see e2e_pty.c; what it prints is in $tmp/out, and
# without \r in $tmp/screen
types() {
    local name=$1 script=$2 code; shift 2
    timeout 1000 "$pty" type "$tmp/$name.log" "${machines[$name]-0}" "$script" "$@" >"$tmp/out" 2>&1
    code=$?
    tr '\r' '\n' <"$tmp/out" >"$tmp/screen"
    return $code
}

# seen WORD: the whole terminal showed it, then was given back; $tmp/after is what came then
seen() {
    grep -qF -- "$1" "$tmp/out" || job_fails "the view does not show \`$1\`"
    sed -z 's/.*\x1b\[?1049l//' "$tmp/out" >"$tmp/after"
    grep -q $'\x1b\[?1049h' "$tmp/out" && ! cmp -s "$tmp/out" "$tmp/after" \
        || job_fails "the terminal was not taken, or not given back"
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

# more than half a minute of planning
long_drawing() {
    awk 'BEGIN { print "bspline 3"; for (i = 0; i < 30000; i++) print i % 97, i * 7 % 89 }' \
        >"$tmp/long.loft"
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

# goes PLACE..: `loft go` ends there
goes() { run 0 "$loft" go "$1" --port "$tmp/$2" "${@:4}"; says out "^the tool is at $3\$"; }

counted_place() {       # the last pulse of the record
    local last
    last=$(tail -1 "$tmp/$1.csv" | cut -d, -f2- | tr ',' ' ')
    [ "$last" = "$2" ] || job_fails "the pulses led to \`$last\`, not to \`$2\`"
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


# --- run them -------------------------------------------------------------------------------------

run_case() {
    tmp=$top/$1 why='' children=()
    export XDG_STATE_HOME=$tmp/state    # where it is noted that a job began
    mkdir "$tmp"; cp "$top/small.csv" "$tmp"
    trap 'for c in "${children[@]}"; do kill "$c" 2>/dev/null; done' EXIT
    declare -F "case_$1" >/dev/null || job_fails "there is no such case"
    [ -n "$why" ] || "case_$1" 2>"$tmp/shell.err"
    if [ -z "$why" ]; then echo "ok   e2e $1"; else echo "FAIL e2e $1:${why#;}"; fi
}

main() {        # the shell has read all of it before it runs: the files may be edited meanwhile
    local cases=("$@") passed failed
    [ $# -gt 0 ] || mapfile -t cases < <(
        sed -n 's/^case_\([a-z0-9_]*\)().*/\1/p' "${subjects[@]}")
    for name in "${cases[@]}"; do
        while [ "$(jobs -rp | wc -l)" -ge 4 ]; do wait -n; done
        run_case "$name" | tee -a "$top/results" &
    done
    wait
    passed=$(grep -c '^ok' "$top/results")
    failed=$((${#cases[@]} - passed))
    for name in "${cases[@]}"; do
        grep -q "e2e $name\(:\|\$\)" "$top/results" ||
            echo "FAIL e2e $name: it ended without a word"
    done
    echo "$passed passed, $failed failed"
    [ $failed = 0 ]
    exit
}
main "$@"
