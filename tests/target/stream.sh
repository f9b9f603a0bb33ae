#!/bin/bash
# tests/target/stream.sh -- boards whose slots a timer and DMA give, in a model of both: each pulse,
# its slot, its length, directions, guards, and the instructions that it takes
# SPDX-License-Identifier: MIT
# usage: tests/target/stream.sh FIRMWARE_FOLDER LOFT HELPERS ; HELPERS holds arm_chip and rate
set -u
firmware=$1 loft=$2 helpers=$3
drawing=tests/drawings/outline12.csv feed=50
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result
. tests/target/rows.sh

# image_of BOARD: the file that is flashed
image_of() {
    case $1 in
    rp2*) echo "$firmware/$1/loft.uf2" ;;
    *)       echo "$firmware/$1/loft.elf" ;;
    esac
}

# on_arm BOARD OPTIONS COMMAND..: the board behind $tmp/port; as on_chip of rows.sh, $jobs too
on_arm() {
    local board=$1 options=$2 child
    shift 2
    # shellcheck disable=SC2086
    "$helpers/arm_chip" "$board" "$(image_of "$board")" --link "$tmp/port" \
        --record "$tmp/chip.csv" $options >"$tmp/chip" 2>"$tmp/chip.err" &
    child=$!
    appears "$tmp/port"
    timeout -k 5 900 "$@" >"$tmp/out" 2>"$tmp/err" </dev/null; code=$?
    [ -z "${jobs:-}" ] || kill $child 2>/dev/null
    timeout 300 tail --pid=$child -f /dev/null || kill $child
    wait $child
    sed 's/^/     /' "$tmp/chip.err"
    [ $code = 0 ] || sed 's/^/     /' "$tmp/err"
}

# numbers BOARD: of the simulated machine that is like it
numbers() {
    case $1 in
    nrf51)      echo --steps 250 --max-speed 80 --accel 500 --queue 160 --ramp 80 ;;
    stm32g0*)   echo --steps 250 --max-speed 200 --accel 1000 --queue 512 --ramp 200 ;;
    stm32f103*) echo --steps 250 --max-speed 200 --accel 1000 --queue 256 --ramp 200 ;;
    *)          echo --steps 250 --max-speed 400 --accel 2000 --queue 1024 --ramp 200 ;;
    esac
}

# slots_of RECORD CYCLES [AFTER]: the pulses with the slot of each, counted from the first, or from
# that after so many
slots_of() {
    awk -F, -v cycles="$2" -v after="${3:-0}" '
        /^[0-9]/ { if (n++ < after) next
                   if (n == after + 1) first = $1
                   printf "%.0f %s %s %s\n", ($1 - first) / cycles, $2, $3, $4 }' "$1" | cksum
}

# rates BOARD STEPS CYCLES LOAD PULSE[,PAUSE] [LATE]: STEPS per ms, one in each slot of CYCLES;
# LATE: the core gives them, up to so many cycles late, and LOAD is that of slots and ticks
rates() {
    local name="$1, $2 steps/ms" axes late=${6:-0} load=load${6:+_slots}
    for axes in 1 3; do
        on_arm "$1" "" "$helpers/rate" "$tmp/port" $axes "$2"
        row "$name, $axes axes: every step there"           "$code" = 0
        row "$name, $axes axes: steps counted at the pins" \
            "$(value position | awk '{ print $1 }')" = "$(said position)"
        row "$name, $axes axes: ticks that were slowed"     "$(said slowed)" = 0
        row "$name, $axes axes: all instructions" \
            "$(value "$load")" "<=" "$4" "of the time"
        row "$name, $axes axes: shortest pulse" \
            "$(value pulse_least)" ">=" "${5%,*}" cycles
        row "$name, $axes axes: shortest pause" \
            "$(value low_least)" ">=" "${5#*,}" cycles
        row "$name, $axes axes: steps apart, at least" \
            "$(value between_least)" ">=" $(($3 - late)) cycles
    done
    cp "$tmp/chip.csv" "$tmp/chip3.csv"
    # shellcheck disable=SC2046
    "$loft" simulate --link "$tmp/here" --record "$tmp/here.csv" --once --slots "$2" \
        $(numbers "$1") >"$tmp/log" & local here=$!
    appears "$tmp/here"
    timeout 600 "$helpers/rate" "$tmp/here" 3 "$2" >"$tmp/planned" 2>&1
    kill $here 2>/dev/null; wait $here 2>/dev/null
    if [ "$1" = nrf51 ]; then           # its queue is short, so a real line makes its start slower
        row "$name: every axis steps as on the simulated machine" \
            "$(path_of "$tmp/chip3.csv")" = "$(path_of "$tmp/here.csv")"
    else
        row "$name: each pulse in the slot of the simulated machine" \
            "$(slots_of "$tmp/chip3.csv" "$3")" = "$(slots_of "$tmp/here.csv" 1)"
    fi
}

# draws BOARD SLOTS CYCLES [LATE [CORE]]: the drawing; LATE: once the slots are made so many us
# late; CORE: the core gives them, up to so many cycles late
draws() {
    local name="$1, a drawing" late=${4:-} apart=$(($3 - ${5:-0}))
    # shellcheck disable=SC2046
    "$loft" simulate --link "$tmp/here" --record "$tmp/here.csv" --once --slots "$2" \
        $(numbers "$1") >"$tmp/log" & local here=$!
    appears "$tmp/here"
    timeout 600 "$loft" stream "$drawing" --feed $feed --port "$tmp/here" >"$tmp/planned" 2>&1
    wait $here
    on_arm "$1" "${late:+--late $late}" "$loft" stream "$drawing" --feed $feed --port "$tmp/port"
    name="$name${late:+, slots made $late us late}"
    row "$name: the command ends well"                      "$code" = 0
    row "$name: steps told and steps counted at the pins" \
        "$(told "$tmp/out")" = "$(value position)"
    row "$name: every axis steps as on the simulated machine" \
        "$(path_of "$tmp/chip.csv")" = "$(path_of "$tmp/here.csv")"
    row "$name: direction set before the pulse, at least" "$(value setup_least)" ">=" $apart cycles
    row "$name: direction kept after the pulse, at least" "$(value hold_least)" ">=" $apart cycles
    if [ "$(value host_late)" != 0 ]; then      # then the pace was lower for a while
        echo "     $name: the sender was late, so its slots are not compared"
    elif [ -z "$late" ]; then           # a real line fills the queue during the first 0.2 s
        row "$name: each pulse in the slot of the simulated machine, after 2000" \
            "$(slots_of "$tmp/chip.csv" "$3" 2000)" = "$(slots_of "$tmp/here.csv" 1 2000)"
    else
        row "$name: times that the slots waited"            "$(value waits)" = 1
    fi
}

# late BOARD STEPS CYCLES US: the highest rate, and once the slots are made so late
late() {
    local name="$1, $2 steps/ms, slots made $4 us late"
    on_arm "$1" "--late $4" "$helpers/rate" "$tmp/port" 3 "$2"
    row "$name: every step there"                           "$code" = 0
    row "$name: times that the slots waited"                "$(value waits)" = 1
    row "$name: steps counted at the pins" \
        "$(value position | awk '{ print $1 }')" = "$(said position)"
    row "$name: steps apart, at least"                     "$(value between_least)" ">=" "$3" cycles
}

# guarded BOARD STEPS_PER_TICK STEPS[,MS] FILTER [probe]: the switch of x, or the probe, closes with
# one pulse; its place is sampled each 10 us
guarded() {
    local name="$1, a guard${5:+, $5,} at $2 steps/ms${3#"${3%,*}"}" most=$(($2 / 100 + 1))
    on_arm "$1" "--touch $3${5:+ --contact $5}" \
        "$helpers/rate" "$tmp/port" 3 "$2" "$4" ${5:+"$5"}
    row "$name: the guard ends the job"                     "$code" = 0
    row "$name: steps between the switch and the latch"  $(($(said latched) - ${3%,*})) ">=" 0
    row "$name: the same, at most 10 us" $(($(said latched) - ${3%,*})) "<=" $most
    row "$name: rests behind it, on its count" \
        "$(said position)" = "$(value position | awk '{ print $1 }')"
}
behind() { echo $(($(said position) - $(said latched))); }

# burns BOARD: the drawing, each mm at 20 ms of full power; then a spindle and a coolant
burns() {
    "$loft" export "$drawing" -o "$tmp/cut.nc"
    { printf 'G21 G90 G94 G17\nM4 S600\n'; grep '^[GXY]' "$tmp/cut.nc" | sed '1d; /^G0/d'
      echo M5; } >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    on_arm "$1" "" "$loft" stream "$tmp/burn.nc" --machine "$tmp/laser.txt" --port "$tmp/port" \
        --feed 30
    python3 tests/target/energy.py "$tmp/chip.csv" 1 >"$tmp/energy"
    row "$1, a laser: the command ends well"                "$code" = 0
    row "$1, a laser: way, in mm"                    "$(said way "$tmp/energy")" ">=" 130.7 mm
    row "$1, a laser: full power for each mm, S600 F1800, in ms" \
        "$(said mean "$tmp/energy")" ">=" 19.8
    row "$1, a laser: the same, at most"                    "$(said mean "$tmp/energy")" "<=" 20.2
    row "$1, a laser: the mm that differs most"             "$(said worst "$tmp/energy")" "<=" 2 %
    row "$1, a laser: after the last pulse"                 "$(said after "$tmp/energy")" "<=" 0 ms
    printf '%s\n' 'G21 G90 M3 S250' 'M8' 'G1 X10 F600' 'S1000' 'X20' 'M9' 'X25' 'M5' >"$tmp/part.nc"
    on_arm "$1" "" "$loft" stream "$tmp/part.nc" --port "$tmp/port"
    row "$1, a spindle: the command ends well"              "$code" = 0
    row "$1, a spindle: power of S250, S1000 and M5, of 256" "$(levels 1)" = "64 256 0"
    row "$1, a spindle: coolant"                            "$(levels 2)" = "256 0"
}
# levels N: those that output N has had, in 1/256
levels() { awk -v n="$1" '/^# output/ && $3 == n { printf "%s%d", c, ($5 + 1) / 256; c = " " }' \
    "$tmp/chip.csv"; }

# mills BOARD SLOTS: a bicubic patch of 6 mm, which the board turns into its path by itself
mills() {
    local name="$1, a patch"
    awk 'BEGIN { print "tensor 3 3"
                 for (i = 0; i < 4; i++) for (j = 0; j < 4; j++)
                     print 4 + 2 * i, 4 + 2 * j, (i % 3 && j % 3 ? 2 : 1) }' >"$tmp/patch.loft"
    set -- "$1" "$2" "$loft" mill --plan chip --tool ball:3 --step 1.5 --safe 2 --feed 60 \
        "$tmp/patch.loft"
    # shellcheck disable=SC2046
    "$loft" simulate --link "$tmp/here" --record "$tmp/here.csv" --once --slots "$2" \
        $(numbers "$1") >"$tmp/log" & local here=$!
    appears "$tmp/here"
    timeout 600 "${@:3}" --port "$tmp/here" >"$tmp/planned" 2>&1
    wait $here
    on_arm "$1" "" "${@:3}" --port "$tmp/port" --log "$tmp/line"
    row "$name: the command ends well"                      "$code" = 0
    row "$name: frames of items, of 128 bytes at most" \
        "$(grep -c '> CURVES' "$tmp/line")" "<=" 3
    row "$name: steps told and steps counted at the pins" \
        "$(told "$tmp/out")" = "$(value position)"
    row "$name: lines and curves, as on the simulated machine" \
        "$(head -1 "$tmp/out" | cut -d: -f3)" = "$(head -1 "$tmp/planned" | cut -d: -f3)"
    "$loft" mill --tool ball:3 --record "$tmp/chip.csv" -o "$tmp/left.png" "$tmp/patch.loft" \
        >"$tmp/cut"
    # cusps of 1.5 mm: 0.192; lines within 0.01, the plan within 0.005, steps of 1/250 mm
    row "$name: left on it, in mm"                   "$(said_before left "$tmp/cut")" "<=" 0.214
    row "$name: cut off it, in mm"                   "$(said_before cut "$tmp/cut")" "<=" 0.022
    if [ "$(value host_late)" != 0 ]; then      # it has waited for END
        echo "     $name: the sender was late, so its time is not compared"
    else                                # there the planner does more
        row "$name: machine time, in s" "$(said_before machine)" "<=" \
            "$(awk -v s="$(said_before machine "$tmp/planned")" 'BEGIN { print 1.25 * s }')"
        # 0.1 for the pace, 0.08 to check the patch, 0.17 for the first knots, and the law of supply
        row "$name: it is held or waits, in s" "$(said_before held)" "<=" 0.5
    fi
    row "$name: ticks that were slowed"             "$(grep -c slowed "$tmp/out")" = 0
    row "$name: all instructions"                    "$(value load)" "<=" 0.5 "of the time"
}
# said_before WORD [FILE]: the number, and its unit, before it
said_before() {
    awk -v name="$1" '
        { for (i = 3; i <= NF; i++)
              if ($i == name) {         # 12.5 s, 3:09 or 3:09:12
                  n = split($(i - 1) ~ /:/ ? $(i - 1) : $(i - 2), part, ":")
                  for (sum = k = 0; k++ < n;)
                      sum = 60 * sum + part[k]
                  print sum
              } }' \
        "${2:-$tmp/out}"
}

# keeps BOARD: settings in its flash; the power fails in an early word of a change, and in a late
# one
keeps() {
    local name="$1, settings" cut flash="--jobs 99 --flash $tmp/flash"
    jobs=99
    on_arm "$1" "$flash" "$loft" set steps_per_mm=80 max_speed=100 --port "$tmp/port"
    row "$name: the command ends well"                      "$code" = 0
    row "$name: words written"                              "$(value flash_written)" ">=" 50
    row "$name: sectors erased"                             "$(value flash_erased)" = 1
    row "$name: words written twice, orders refused" \
        "$(value flash_again) $(value flash_refused)" = "0 0"
    on_arm "$1" "$flash" "$loft" settings --port "$tmp/port"
    row "$name: the next start has them"    "$(grep -c 'kept by the machine' "$tmp/out")" = 1
    row "$name: steps/mm"               "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 80
    row "$name: words written by a start"                   "$(value flash_written)" = 0
    for cut in 2 40; do
        # the chip says its numbers when it ends, at the cut; nobody answers the command then
        on_arm "$1" "$flash --cut $cut" bash -c '
            "$0" set steps_per_mm=100 --port "$1" & command=$!
            until [ -s "$2" ]; do kill -0 $command 2>/dev/null || break; sleep 0.05; done
            kill $command 2>/dev/null; wait $command' "$loft" "$tmp/port" "$tmp/chip"
        on_arm "$1" "$flash" "$loft" settings --port "$tmp/port"
        row "$name, the power fails in word $cut: steps/mm as before" \
            "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 80
    done
    on_arm "$1" "$flash" "$loft" set steps_per_mm=100 --port "$tmp/port"
    on_arm "$1" "$flash" "$loft" settings --port "$tmp/port"
    row "$name: a change after that"    "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = 100
    jobs=
}

keeps stm32f405
mills stm32f405 250
burns stm32f405
rates stm32f405-fast 1000 168 0.10 84
rates stm32g0-fast   320 200 0.60 63 60
# its pulse lasts 139 cycles: of a slot that begins 60 late 121 remain
rates stm32g0        200 320 0.60 127,121 60
rates nrf51          100 160 0.65 31 60
rates rp2040-fast   1000 125 0.20 60
rates rp2350-fast   1000 150 0.15 72
rates rp2040         250 500 0.15 240
rates rp2350         250 600 0.10 288
rates stm32f405      250  672 0.10 336
rates stm32f103-fast 500  144 0.15 72
draws stm32f103 250 288
draws stm32f405 250 672
draws stm32f405-fast 1000 168
draws stm32f405 250 672 600
draws stm32g0-fast 320 200 '' 60
draws rp2040 250 500
draws rp2350 250 600
draws rp2350-fast 1000 150
draws rp2040-fast 1000 125
draws rp2040 250 500 600
late rp2040-fast 1000 125 600
late rp2350-fast 1000 150 600
late stm32f405-fast 1000 168 600
late stm32f103-fast 500 144 600
guarded stm32f103 100 20001,5 8
guarded stm32f405 5 700 8
guarded stm32g0-fast 100 20001,5 8
guarded rp2040 100 20001,5 8
guarded rp2040-fast 5 700 8
for board in stm32f405 stm32f103 stm32g0 rp2040 rp2350; do guarded $board 5 700 8 probe; done
guarded rp2040-fast 1000 200001 8
guarded rp2350 100 20001,5 8
guarded rp2350-fast 5 700 8
guarded rp2350-fast 1000 200001 8
guarded stm32f405 100 20001,5 8
row "stm32f405: it slows down behind the switch, in steps"  "$(behind)" ">=" 1000
# the ring of half a tick, the filter of two samples, and the sample of the main loop
guarded stm32f405 100 20001 1!
row "stm32f405, at once: steps behind the switch, 3.5 ms"   "$(behind)" "<=" 350
guarded stm32f405-fast 1000 200001 1!
row "stm32f405-fast, at once: steps behind the switch, 5 ms" "$(behind)" "<=" 5000
sum
