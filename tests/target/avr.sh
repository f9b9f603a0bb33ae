#!/bin/bash
# tests/target/avr.sh -- whole jobs on an emulated ATmega328P, a line `ok` or `FAIL` per number
# SPDX-License-Identifier: MIT
# usage: tests/target/avr.sh FOLDER/FIRMWARE.elf LOFT HELPERS ; HELPERS holds chip and rate, and
# FOLDER-fast the firmware for 100 slots in a ms, with pulses of 1 us
set -u
elf=$1 loft=$2 chip=$3/chip rate=$3/rate
drawing=tests/drawings/outline12.csv feed=50
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result
. tests/target/rows.sh
ram() { echo $(($(avr-size "$elf" | awk 'NR == 2 { print $2 + $3 }') + $(value stack))); }

# simulated [OPTION..]: the drawing on the simulated machine, its pulses in $tmp/here.csv
simulated() {
    "$loft" simulate --link "$tmp/here" --record "$tmp/here.csv" --once --steps 250 \
        --max-speed 320 --accel 500 --queue 12 --ramp 40 >"$tmp/log" &
    here=$!
    appears "$tmp/here"
    timeout 900 "$loft" stream "$drawing" --feed $feed "$@" --port "$tmp/here" >"$tmp/planned" 2>&1
    wait $here
}
time_ratio() {
    awk -F, -v t="$ticks" '
        /^[0-9]/ { if (!a) a = $1; b = $1 }
        END      { if (t) printf "%.4f", (b - a) / 16000 / t }' "$tmp/chip.csv"
}

echo "-- a drawing: $drawing at $feed mm/s, 250 steps/mm, planned here"
simulated
on_chip "$chip" "$elf" "$loft" stream "$drawing" --feed $feed --port "$tmp/port" \
    --record "$tmp/chip.csv"

ticks=$(sed -n 's/.*items, \([0-9]*\) ticks.*/\1/p' "$tmp/log")
row "the command ends well"                                 "$code" = 0
row "steps told and steps counted at the pins" \
    "$(told "$tmp/out")" = "$(value position)"
row "every axis steps as on the simulated machine" \
    "$(path_of "$tmp/chip.csv")" = "$(path_of "$tmp/here.csv")"
row "worst path error: tolerance 0.005 and a step" \
    "$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")" "<=" 0.0107 mm
row "machine time over the time of the plan"                "$(time_ratio)" "<=" 1.05
row "slots missed"                                          "$(value slots_missed)" = 0
row "bytes that overran the chip"                           "$(value overruns)" = 0
row "slot interrupt, mean"                                  "$(value slot_mean)" "<=" 72 cycles
row "slot interrupt, worst"                                 "$(value slot_most)" "<=" 90 cycles
row "slot interrupt, latest"                                "$(value slot_late)" "<=" 200 cycles
row "slots that found the ring empty in mid-job"            "$(value slots_empty)" = 0
row "making the slots of a tick, and the next tick, mean"   "$(value tick_mean)" "<=" 4000 cycles
# The worst call is not measured: a call prepares one tick or several, and may take time while slots
# are left.
row "slots left in the ring when a slot came, fewest" \
    "$(value ring_least)" ">=" 8 "of the 64 at which work begins"
row "all interrupts"                                        "$(value load)" "<=" 0.65 "of the time"
row "ticks that were slowed"                            "$(grep -c 'ticks slowed' "$tmp/out")" = 0
row "shortest pulse (2 us)"                                 "$(value pulse_least)" ">=" 32 cycles
row "direction set before the pulse, at least"              "$(value setup_least)" ">=" 320 cycles
row "direction kept after the pulse, at least"              "$(value hold_least)" ">=" 320 cycles
row "RAM: data, bss and the deepest stack; 60 of 2048 stay" "$(ram)" "<=" 1988 bytes

echo "-- the same as points, one per ms"
simulated --points
on_chip "$chip" "$elf" "$loft" stream "$drawing" --feed $feed --points --port "$tmp/port" \
    --record "$tmp/chip.csv"
ticks=$(sed -n 's/.*items, \([0-9]*\) ticks.*/\1/p' "$tmp/log")
row "points: the command ends well"                         "$code" = 0
row "points: every axis steps as on the simulated machine" \
    "$(path_of "$tmp/chip.csv")" = "$(path_of "$tmp/here.csv")"
row "points: machine time over the time of the plan"        "$(time_ratio)" "<=" 1.02
row "points: slots missed"                                  "$(value slots_missed)" = 0
row "points: RAM, data, bss and the deepest stack"          "$(ram)" "<=" 1988 bytes

# rates NAME AXES STEPS_PER_TICK
rates() {
    on_chip "$chip" "$elf" "$rate" "$tmp/port" "$2" "$3"
    row "$1: every step there" "$code" = 0
}
# each_slot STEPS_PER_TICK LOAD CYCLES US: a step in each slot; slots last so many cycles, pulses US
each_slot() {
    local name axes
    for axes in 1 3; do
        name="$1 steps/ms, $axes axes"
        rates "$name" $axes "$1"
        row "$name: ticks that were slowed"         "$(said slowed)" = 0
        row "$name: slots missed"                   "$(value slots_missed)" = 0
        row "$name: slots that found the ring empty" "$(value slots_empty)" = 0
        row "$name: all interrupts"                 "$(value load)" "<=" "$2" "of the time"
        row "$name: steps apart, at least"          "$(value between_least)" ">=" "$3" cycles
        row "$name: shortest pulse ($4 us)"         "$(value pulse_least)" ">=" $(($4 * 16)) cycles
    done
}
each_slot 80 0.65 100 2
rates "120 steps/ms, 3 axes" 3 120
row "120 steps/ms, 3 axes: it says how many ticks were slowed" "$(said slowed)" ">=" 1
row "120 steps/ms, 3 axes: slots missed"                    "$(value slots_missed)" = 0

echo "-- 100 slots in a ms, pulses of 1 us"
slower=$elf elf=${elf%/*}-fast/${elf##*/}
each_slot 100 0.68 80 1
on_chip "$chip" "$elf" "$loft" stream "$drawing" --feed $feed --port "$tmp/port"
row "100 slots, a drawing: the command ends well"           "$code" = 0
row "100 slots, a drawing: steps told and steps counted at the pins" \
    "$(told "$tmp/out")" = "$(value position)"
row "100 slots, a drawing: slots that found the ring empty" "$(value slots_empty)" = 0
row "100 slots, a drawing: ticks that were slowed"      "$(grep -c 'ticks slowed' "$tmp/out")" = 0
row "100 slots, a drawing: all interrupts"                  "$(value load)" "<=" 0.68 "of the time"
row "100 slots: RAM, data, bss and the deepest stack"       "$(ram)" "<=" 1988 bytes
elf=$slower

echo "-- a guarded job: the switch of x closes with one pulse, without and with bouncing"
# guarded NAME STEPS_PER_TICK STEPS[,MS] [FILTER]
guarded() {
    touch=$3
    on_chip "$chip" "$elf" "$rate" "$tmp/port" 3 "$2" "${4:-8}"
    touch=
    row "$1: the guard ends the job"                        "$code" = 0
    row "$1: the latched place, in steps"                   "$(said latched)" = "${3%,*}"
    row "$1: rests behind it, on its count" \
        "$(said position)" = "$(value position | awk '{ print $1 }')"
    row "$1: slots missed"                                  "$(value slots_missed)" = 0
    row "$1: shortest pulse"                                "$(value pulse_least)" ">=" 32 cycles
}
guarded "5 mm/s"                     1.25 400
guarded "5 mm/s, bounces for 5 ms"   1.25 400,5
guarded "160 mm/s"                   40 10001
guarded "160 mm/s, bounces for 5 ms" 40 10001,5
# A hard stop drops the ring and the ticks: at most 2 ms behind the switch.
behind() { echo $(($(said position) - $(said latched))); }
row "160 mm/s: it slows down behind the switch, in steps"   "$(behind)" ">=" 1000
guarded "160 mm/s, at once"          40 10001 1!
row "160 mm/s, at once: steps behind the switch"            "$(behind)" "<=" 80
row "guards: RAM, data, bss and the deepest stack"          "$(ram)" "<=" 1988 bytes

echo "-- loft home: the switch of x closes at -2000 steps, bounces for 5 ms, and opens again"
printf 'x.home_order = 1\nx.home_search = 20\nx.home_at = 100\n' >"$tmp/home.txt"
touch=-2000,5 jobs=99
on_chip "$chip" "$elf" "$loft" home --port "$tmp/port" --machine "$tmp/home.txt"
touch='' jobs=
row "home: the command ends well"                           "$code" = 0
row "home: way to the switch, in mm"                        "$(said after)" = 8.000
row "home: the touches differ by, in steps"                 "$(said within)" = 0
row "home: the tool is at, in mm" \
    "$(sed -n 's/^homed: the tool is at //p' "$tmp/out")" = "103.000 0.000 0.000"
row "home: it stands 3 mm before the switch, by its pulses" "$(value position)" = "-1250 0 0"
row "home: shortest pulse"                                  "$(value pulse_least)" ">=" 32 cycles
row "home: RAM, data, bss and the deepest stack"            "$(ram)" "<=" 1988 bytes

echo "-- loft set: the chip keeps its settings in its EEPROM, and starts again for each command"
eeprom=$tmp/eeprom jobs=99
on_chip "$chip" "$elf" "$loft" set steps_per_mm=80 max_speed=100 x.travel=60 x.reversed=yes idle=1 \
    --port "$tmp/port"
row "set: the command ends well"                            "$code" = 0
row "set: RAM, data, bss and the deepest stack"             "$(ram)" "<=" 1988 bytes
on_chip "$chip" "$elf" "$loft" settings --port "$tmp/port"
row "settings: the next start has them"     "$(grep -c 'kept by the machine' "$tmp/out")" = 1
row "settings: steps/mm"                    "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 80
row "settings: table"                       "$(sed -n 's/^x.travel = //p' "$tmp/out")" = 60
printf '0,0,5,0,15,0,20,0\n' >"$tmp/line.csv"
on_chip "$chip" "$elf" "$loft" stream "$tmp/line.csv" --lift 0 --port "$tmp/port"
row "settings: a line of 20 mm, told"                       "$(told "$tmp/out")" = "1600 0 0"
row "settings: the same at the pins, x turned"              "$(value position)" = "-1600 0 0"
row "settings: RAM, data, bss and the deepest stack"        "$(ram)" "<=" 1988 bytes
for at in 40 548; do printf '\252' | dd of="$eeprom" bs=1 seek=$at conv=notrunc 2>/dev/null; done
on_chip "$chip" "$elf" "$loft" settings --port "$tmp/port"
row "settings: damaged ones are told"       "$(grep -c 'what it kept is damaged' "$tmp/out")" = 1
row "settings: then its firmware's"         "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 250
on_chip "$chip" "$elf" "$loft" set steps_per_mm=80 --port "$tmp/port"
on_chip "$chip" "$elf" "$loft" set --defaults --port "$tmp/port"
row "settings: back to its firmware's"      "$(grep -c 'back to those of' "$tmp/out")" = 1
row "settings: RAM, data, bss and the deepest stack"        "$(ram)" "<=" 1988 bytes
on_chip "$chip" "$elf" "$loft" settings --port "$tmp/port"
row "settings: the next start has those"    "$(grep -c 'keeps none yet' "$tmp/out")" = 1
row "settings: steps/mm again"              "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 250
eeprom='' jobs=

echo "-- outputs: the same drawing burnt, each mm at 20 ms of full power; a spindle, left alone"
"$loft" export "$drawing" -o "$tmp/cut.nc"
{ printf 'G21 G90 G94 G17\nM4 S600\n'; grep '^[GXY]' "$tmp/cut.nc" | sed '1d; /^G0/d'; echo M5; } \
    >"$tmp/burn.nc"
printf 'laser = yes\n' >"$tmp/laser.txt"
on_chip "$chip" "$elf" "$loft" stream "$tmp/burn.nc" --machine "$tmp/laser.txt" \
    --port "$tmp/port" --feed 30
python3 tests/target/energy.py "$tmp/chip.csv" 1 >"$tmp/energy"
row "laser: the command ends well"                          "$code" = 0
row "laser: way, in mm"                            "$(said way "$tmp/energy")" ">=" 130.7 mm
row "laser: full power for each mm, S600 F1800, in ms"  "$(said mean "$tmp/energy")" ">=" 19.8
row "laser: the same, at most"                          "$(said mean "$tmp/energy")" "<=" 20.2
row "laser: the mm that differs most"                   "$(said worst "$tmp/energy")" "<=" 2 %
row "laser: ticks that were slowed"                     "$(grep -c 'ticks slowed' "$tmp/out")" = 0
row "laser: after the last pulse"                       "$(said after "$tmp/energy")" "<=" 0 ms
row "laser: slots missed"                                   "$(value slots_missed)" = 0
row "laser: all interrupts"                                 "$(value load)" "<=" 0.80 "of the time"
row "laser: RAM, data, bss and the deepest stack"           "$(ram)" "<=" 1988 bytes
# The line is silent twice: the queue runs empty, and the ticks become long.
starve=17
on_chip "$chip" "$elf" "$loft" stream "$tmp/burn.nc" --machine "$tmp/laser.txt" \
    --port "$tmp/port" --feed 30
starve=
python3 tests/target/energy.py "$tmp/chip.csv" 1 >"$tmp/energy"
row "laser, starved: the command ends well"                 "$code" = 0
row "laser, starved: times that the line was silent"        "$(value silences)" = 2
row "laser, starved: the mm that differs most"          "$(said worst "$tmp/energy")" "<=" 2 %
row "laser, starved: standing"                          "$(said standing "$tmp/energy")" "<=" 0 ms
printf '%s\n' 'G21 G90 M3 S250' 'M8' 'G1 X10 F600' 'S1000' 'X20' 'M9' 'X1500' >"$tmp/part.nc"
# levels N: those that output N has had, in 1/256
levels() { awk -v n="$1" '/^# output/ && $3 == n { printf "%s%d", c, ($5 + 1) / 256; c = " " }' \
    "$tmp/chip.csv"; }
jobs=99
# the sender is killed when x has made 5500 steps, as the record says
on_chip "$chip" "$elf" bash -c '
    "$0" stream "$1" --port "$2" & sender=$!
    until [ "$(tail -n 2 "$3" | head -n 1 | cut -d, -f2)" -gt 5500 ] 2>/dev/null; do
        kill -0 $sender 2>/dev/null || break
        sleep 0.05
    done
    kill -KILL $sender; wait $sender 2>/dev/null
    "$0" stream --abort --port "$2"' \
    "$loft" "$tmp/part.nc" "$tmp/port" "$tmp/chip.csv"
jobs=
row "spindle: the abort ends well"                          "$code" = 0
row "spindle: it went on to X1500"  "$(awk '{ print ($1 > 5000) }' <(value position))" = 1
row "spindle: power of S250, S1000 and the abort, of 256"   "$(levels 1)" = "64 256 0"
row "spindle: coolant"                                      "$(levels 2)" = "256 0"

echo "-- a servo in place of z: 1000 us at 0, 100 us for each mm"
# widths FROM: pulses and their distances after the cycle FROM, in us: least and most of each
widths() {
    awk -v from="$1" '/^# servo/ && $8 >= from { w = $4; d = at ? ($8 - at) / 16 : 20000; at = $8
            if (!n++) { w0 = w1 = w; d0 = d1 = d }
            w0 = w < w0 ? w : w0; w1 = w > w1 ? w : w1; d0 = d < d0 ? d : d0; d1 = d > d1 ? d : d1
            last = w }
        END { print "pulses", n; print "least", w0; print "most", w1; print "last", last
            print "jitter", w1 - w0; print "moved", d1 - d0 }' "$tmp/chip.csv" >"$tmp/widths"
}
eeprom=$tmp/servo jobs=99
on_chip "$chip" "$elf" "$loft" set z.drive=servo servo_zero=1000 z.steps_per_mm=100 \
    x.steps_per_mm=250 y.steps_per_mm=250 z.max_speed=320 --port "$tmp/port"
row "servo: set"                                            "$code" = 0
jobs=
printf '%s\n' 'G21 G90' 'G1 Z5 F1500' 'G4 P0.1' 'Z-9' 'G4 P0.1' 'Z3.5' 'G4 P0.3' >"$tmp/pen.nc"
on_chip "$chip" "$elf" "$loft" stream "$tmp/pen.nc" --feed 25 --port "$tmp/port"
row "servo: the command ends well"                          "$code" = 0
widths 0
row "servo: the widest pulse, z = 5"                    "$(said most "$tmp/widths")" "<=" 1502 us
row "servo: at least"                                   "$(said most "$tmp/widths")" ">=" 1498 us
row "servo: never below 500 us"                         "$(said least "$tmp/widths")" = 500.00
row "servo: the last one, z = 3.5"                      "$(said last "$tmp/widths")" "<=" 1352 us
row "servo: at least"                                   "$(said last "$tmp/widths")" ">=" 1348 us
on_chip "$chip" "$elf" "$rate" "$tmp/port" 3 40
row "servo, 3 axes at 40 steps/ms: every step there"        "$code" = 0
# z has left the range of a servo in the first 0.2 s
widths "$(awk '/^# servo/ && !n { n = $8 } END { print n + 3200000 }' "$tmp/chip.csv")"
row "servo, 3 axes at 40 steps/ms: pulses"              "$(said pulses "$tmp/widths")" ">=" 15
row "servo, 3 axes at 40 steps/ms: the widest"          "$(said most "$tmp/widths")" "<=" 2504 us
row "servo, 3 axes at 40 steps/ms: the narrowest"       "$(said least "$tmp/widths")" ">=" 2496 us
row "servo, 3 axes at 40 steps/ms: jitter of the width" "$(said jitter "$tmp/widths")" "<=" 8 us
row "servo, 3 axes at 40 steps/ms: jitter of 20 ms"     "$(said moved "$tmp/widths")" "<=" 8 us
row "servo, 3 axes at 40 steps/ms: slots missed"            "$(value slots_missed)" = 0
row "servo, 3 axes at 40 steps/ms: slot interrupt, latest"  "$(value slot_late)" "<=" 200 cycles
row "servo: RAM, data, bss and the deepest stack"           "$(ram)" "<=" 1988 bytes
eeprom=''

echo "-- a line that is cut"
"$loft" simulate --link "$tmp/cut" --speed real >"$tmp/log" & here=$!
appears "$tmp/cut"
{ for _ in $(seq 3000); do grep -q begun "$tmp/log" && break; sleep 0.02; done; kill -9 $here; } &
timeout 600 "$rate" "$tmp/cut" 3 40 >"$tmp/out" 2>"$tmp/said"; code=$?
wait
row "the test's own sender ends"                            "$code" = 1

sum
