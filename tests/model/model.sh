#!/bin/sh
# tests/model/model.sh -- search every state of the session's model with spin
# The model is tests/model/session.pml.
# SPDX-License-Identifier: MIT
# Prints a line `ok` or `FAIL` per search. The last searches plant a mistake, which must be found.
set -u
if ! command -v spin >/dev/null; then
    echo "FAIL model: spin is not installed (make deps)"
    echo "0 passed, 1 failed"
    exit 1
fi
model=$(pwd)/tests/model/session.pml
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
count=0
ok()   { echo "ok   model $*"; }
fail() { echo "FAIL model $*"; }

# search NAME WANTED "cc flags" "run flags" MODEL-FLAGS..
# WANTED is `none`, or the property that a planted mistake must break
search() {
    name=$1 wanted=$2 build=$3 run=$4; shift 4
    count=$((count + 1))
    here=$work/$count
    mkdir "$here"
    if ! (cd "$here" && spin -a "$@" "$model" && ${CC:-cc} -O2 -w $build -o pan pan.c &&
          timeout 900 ./pan -m4000000 -w24 $run) >"$here/out" 2>&1; then
        fail "$name: the search did not run"; tail -5 "$here/out"; return
    fi
    states=$(awk '/states, stored/ { print $1 }' "$here/out")
    found=$(sed -n 's/^pan:1: \(.*\) (at depth.*/\1/p' "$here/out")
    whole=$(grep -c 'max search depth too small' "$here/out")
    case "$wanted:$found:$whole" in
    none::0) ok "$name ($states states)" ;;
    none:*)  fail "$name: ${found:-the search was cut short}" ;;
    *::*)    fail "$name: not found" ;;
    *)       case $found in
             *"$wanted"*) ok "$name (found: $found)" ;;
             *)           fail "$name: found $found instead" ;;
             esac ;;
    esac
}
safe='-DSAFETY -DNOCLAIM' live='-DNFAIR=3'

# the long ones in parallel with the others
long_ones() {
    count=100
    search "timeouts at any moment, a frame lost or doubled" \
        none "$safe" "-E" -DFREE -DK=2 -DFAULTS=1
}
long_ones >"$work/long" &
{
    search "3 frames lost or doubled, the program killed, the machine restarted" \
        none "$safe" "" -DFAULTS=3 -DDEATHS=1 -DREBOOTS=1
    search "5 items, window 3, killed twice" \
        none "$safe" "" -DK=5 -DW=3 -DQ=3 -DM=8 -DFAULTS=2 -DDEATHS=2
    search "the job ends, 3 frames lost or doubled, killed once" \
        none "$live" "-a -f" -DFAULTS=3 -DDEATHS=1
    search "the job ends, a frame lost or doubled, the machine restarted" \
        none "$live" "-a -f" -DFAULTS=1 -DREBOOTS=1
    search "2 frames lost or doubled, killed, a limit closes twice and opens" \
        none "$safe" "" -DK=2 -DFAULTS=2 -DDEATHS=1 -DLIMITS=2
    search "the job ends, a frame lost or doubled, a limit closes" \
        none "$live" "-a -f" -DK=2 -DFAULTS=1 -DLIMITS=1
    search "placed at any time, 2 frames lost or doubled, killed, the guard comes true" \
        none "$safe" "" -DK=2 -DFAULTS=2 -DDEATHS=1 -DGUARDS=1 -DPLACES=2
    search "the job ends, placed first, a frame lost or doubled, the guard comes true" \
        none "$live" "-a -f" -DK=2 -DFAULTS=1 -DGUARDS=1 -DPLACES=1
    search "settings written, 2 frames lost or doubled, killed, the power cut" \
        none "$safe" "" -DK=1 -DFAULTS=2 -DDEATHS=1 -DREBOOTS=1 -DSETS=1
    search "the job ends, settings written first, 2 frames lost or doubled" \
        none "$live" "-a -f" -DK=1 -DFAULTS=2 -DSETS=1
    search "settings written by a host that does not greet again, killed" \
        none "$safe" "" -DK=1 -DFAULTS=2 -DDEATHS=1 -DSETS=2
    search "two pauses, 2 frames lost or doubled, killed twice" \
        none "$safe" "" -DFAULTS=2 -DDEATHS=2 -DPAUSES=1
    search "the job ends, two pauses, a frame lost or doubled, killed" \
        none "$live" "-a -f" -DK=2 -DFAULTS=1 -DDEATHS=1 -DPAUSES=1
    search "planted: a job begins with settings it was not planned with" \
        "item==m_copy" "$safe" "" -DK=1 -DFAULTS=1 -DSETS=2 -DBUG=6
    search "planted: settings are written to the copy in force" \
        "m_copy" "$safe" "" -DK=1 -DFAULTS=1 -DREBOOTS=1 -DSETS=1 -DBUG=7
    search "planted: a RESUME is obeyed twice" \
        "lifted<=wishes" "$safe" "" -DFAULTS=2 -DPAUSES=1 -DBUG=8
    search "planted: a place is obeyed in a job" \
        "m_state!=" "$safe" "" -DK=2 -DFAULTS=2 -DDEATHS=1 -DPLACES=2 -DBUG=5
    search "planted: a refused JOB begins later" \
        "((h_phase==" "$safe" "" -DK=2 -DFAULTS=2 -DLIMITS=1 -DBUG=4
    search "planted: END counts nothing" "m_executed==" "$safe" "" -DBUG=1
    search "planted: an item ahead is taken" "item==m_next" "$safe" "" -DBUG=2
    search "planted: credit is counted" "h_send<" "$safe" "" -DBUG=3
    search "planted: as many numbers as the window is wide" \
        "item==m_next" "$safe" "-E" -DFREE -DK=2 -DFAULTS=1 -DM=2
} | tee "$work/said"
wait
cat "$work/long" | tee -a "$work/said"
passed=$(grep -c '^ok' "$work/said") failed=$(grep -c '^FAIL' "$work/said")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
