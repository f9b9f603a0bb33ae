#!/bin/bash
# tests/target/avr.sh -- whole jobs on an emulated ATmega328P, each number a line `ok` or `FAIL`
# SPDX-License-Identifier: MIT
# usage: tests/target/avr.sh FIRMWARE.elf LOFT HELPERS ; HELPERS holds chip and rate
set -u
elf=$1 loft=$2 chip=$3/chip rate=$3/rate
drawing=tests/drawings/outline12.csv feed=50
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
tick=0x$(avr-nm "$elf" | awk '$3 == "loft_port_work_stub" { print $1 }')
ring=$(avr-nm "$elf" | awk '{ at[$3] = substr($1, 5) } END { print "0x" at["ring_head"] ",0x" at["ring_tail"] }')
result=$tmp/result

row() {         # row NAME VALUE OPERATOR BOUND [UNIT]
    local verdict
    verdict=$(awk -v x="$2" -v op="$3" -v y="$4" 'BEGIN {
        good = x != "" && (op == "<=" ? x + 0 <= y + 0 : op == ">=" ? x + 0 >= y + 0 : x "" == y ""); print good ? "ok  " : "FAIL" }')
    printf '%s %-60s %s%s (%s %s)\n' "$verdict" "$1" "${2:-nothing}" "${5:+ $5}" "$3" "$4" | tee -a "$result"
}
value() { awk -v name="$1" '$1 == name { $1 = ""; print substr($0, 2) }' "$tmp/chip"; }

# on_chip COMMAND..: the chip behind $tmp/port, its pulses in $tmp/chip.csv, what it came to in $tmp/chip; COMMAND's output in $tmp/out
on_chip() {
    "$chip" "$elf" --tick "$tick" --ring "$ring" --link "$tmp/port" --record "$tmp/chip.csv" >"$tmp/chip" 2>"$tmp/chip.err" & local child=$!
    for _ in $(seq 100); do [ -e "$tmp/port" ] && break; sleep 0.02; done
    timeout 40 "$@" >"$tmp/out" 2>"$tmp/err" </dev/null; code=$?
    timeout 5 tail --pid=$child -f /dev/null || kill $child     # it ends when the job is closed
    wait $child
    sed 's/^/     /' "$tmp/chip.err"
}
# every axis' own row of steps, whatever the time between them
path_of() {
    awk -F, '!/^#/ && $1 != "slot" { for (i = 2; i <= NF; i++) if ($i != last[i]) { last[i] = $i; row[i] = row[i] " " $i } }
             END { for (i = 2; i <= 4; i++) print row[i] }' "$1" | cksum
}

echo "-- a drawing: $drawing at $feed mm/s, 250 steps/mm, planned here"
"$loft" simulate --link "$tmp/here" --record "$tmp/here.csv" --once --steps 250 --max-speed 160 --accel 500 --queue 12 --ramp 40 >"$tmp/log" & here=$!
for _ in $(seq 100); do [ -e "$tmp/here" ] && break; sleep 0.02; done
timeout 40 "$loft" stream "$drawing" --feed $feed --port "$tmp/here" >"$tmp/planned" 2>&1; wait $here
on_chip "$loft" stream "$drawing" --feed $feed --port "$tmp/port" --record "$tmp/chip.csv"

ticks=$(sed -n 's/.*items, \([0-9]*\) ticks.*/\1/p' "$tmp/log")
row "the command ends well"                                 "$code" = 0
row "steps told and steps counted at the pins"              "$(sed -n 's/.*steps \(-*[0-9]* -*[0-9]* -*[0-9]*\).*as commanded.*/\1/p' "$tmp/out" | head -1)" = "$(value position)"
row "every axis steps as on the simulated machine"          "$(path_of "$tmp/chip.csv")" = "$(path_of "$tmp/here.csv")"
row "worst path error: tolerance 0.005 and a step"          "$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")" "<=" 0.0107 mm
row "machine time over the time of the plan"                "$(awk -F, -v t="$ticks" '/^[0-9]/ { if (!a) a = $1; b = $1 } END { if (t) printf "%.4f", (b - a) / 16000 / t }' "$tmp/chip.csv")" "<=" 1.05
row "slots missed"                                          "$(value slots_missed)" = 0
row "bytes that overran the chip"                           "$(value overruns)" = 0
row "slot interrupt, mean"                                  "$(value slot_mean)" "<=" 120 cycles
row "slot interrupt, worst"                                 "$(value slot_most)" "<=" 160 cycles
row "slot interrupt, latest"                                "$(value slot_late)" "<=" 200 cycles
row "slots that found the ring empty in mid-job"            "$(value slots_empty)" = 0
row "making the slots of a tick, and the next tick, mean"   "$(value tick_mean)" "<=" 4000 cycles
row "the same, worst"                                       "$(value tick_most)" "<=" 10000 cycles
row "all interrupts"                                        "$(value load)" "<=" 0.85 "of the time"
row "shortest pulse (2 us)"                                 "$(value pulse_least)" ">=" 32 cycles
row "direction set before the pulse, at least"              "$(value setup_least)" ">=" 320 cycles
row "direction kept after the pulse, at least"              "$(value hold_least)" ">=" 320 cycles
row "RAM: data, bss and the deepest stack of 2048"          "$(($(avr-size "$elf" | awk 'NR == 2 { print $2 + $3 }') + $(value stack)))" "<=" 2048 bytes

# rates NAME AXES STEPS_PER_TICK
rates() { on_chip "$rate" "$tmp/port" "$2" "$3"; row "$1: every step there" "$code" = 0; }
said() { awk -v name="$1" '{ for (i = 1; i < NF; i++) if ($i == name) print $(i + 1) }' "$tmp/out"; }
for axes in 1 3; do
    rates "40 steps/ms, $axes axes" $axes 40
    row "40 steps/ms, $axes axes: ticks that were slowed"   "$(said slowed)" = 0
    row "40 steps/ms, $axes axes: slots missed"             "$(value slots_missed)" = 0
    row "40 steps/ms, $axes axes: slots that found the ring empty" "$(value slots_empty)" = 0
    row "40 steps/ms, $axes axes: all interrupts"           "$(value load)" "<=" 0.97 "of the time"
    row "40 steps/ms, $axes axes: steps apart, at least"    "$(value between_least)" ">=" 200 cycles
done
rates "60 steps/ms, 3 axes" 3 60
row "60 steps/ms, 3 axes: it says how many ticks were slowed" "$(said slowed)" ">=" 1
row "60 steps/ms, 3 axes: slots missed"                     "$(value slots_missed)" = 0

passed=$(grep -c '^ok' "$result") failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
