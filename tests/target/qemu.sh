#!/bin/bash
# tests/target/qemu.sh -- a whole job on each 32-bit board in QEMU: every pulse at the pins, in the
# order of the simulated machine
# SPDX-License-Identifier: MIT
# usage: tests/target/qemu.sh FIRMWARE_FOLDER LOFT PLUGIN.so BAD_LINE ARM_CHIP
# QEMU has no DMA of timers: the boards that step by it run in arm_chip.c instead.
# The same over a bad line (bad_line.c): bytes flipped, lost, doubled, inserted;
# the cable unplugged repeatedly; the sender killed and started again.
# Counted instructions are the clock (-icount): a slot lasts as long as on a real part, and idle
# time is skipped. An emulated line has no speed.
set -u
firmware=$1 loft=$2 plugin=$3 bad_line=$4 arm_chip=$5
drawing=tests/drawings/outline12.csv feed=50
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began

. tests/target/rows.sh
result=/dev/null          # each lane writes its own

# board NAME QEMU MACHINE SHIFT "MACHINE'S NUMBERS" HOST|CHIP [FAULT SEED]: a drawing here and
# there, planned by the host or the chip
board() {
    local name=$1 qemu=$2 machine=$3 shift=$4 numbers=$5 plan=$6 fault=${7:-none} seed=${8:-1}
    local elf=$firmware/$1/loft.elf extra=() code port
    local at=$tmp/$name-$plan-$fault-$seed what="$1, planned on the $6"
    local log=$at/log
    mkdir "$at"
    case $name in
    nrf51)      extra=(-trace nrf51_gpio_write -D "$log") ;;
    riscv-virt) local pins=0x$(riscv64-unknown-elf-nm "$elf" | awk '$3 == "pins" { print $1 }')
                local hi; hi=$(printf '0x%x' $((pins + 64)))
                extra=(-bios none -plugin "$plugin,lo=$pins,hi=$hi,out=$log") ;;
    *)          extra=(-d unimp -D "$log") ;;
    esac
    local job=$drawing
    if [ $fault = killed ]; then            # twice: not all of it is sent before the first step
        job=$at/twice.csv
        cat "$drawing" "$drawing" >"$job"
    fi
    if [ $fault = none ] || [ $fault = killed ]; then
        # shellcheck disable=SC2086
        "$loft" simulate --link "$at/here" --record "$at/here.csv" --once --quiet $numbers \
            >"$at/said" &
        local here=$!
        appears "$at/here"
        timeout 900 "$loft" stream "$job" --feed $feed --plan=$plan --port "$at/here" \
            >"$at/planned" 2>&1
        wait $here
    else
        cp "$tmp/$name-$plan-none-1/here.csv" "$at"         # the run over a good line came before
    fi
    if [ "$qemu" = arm_chip ]; then
        timeout -k 10 300 "$arm_chip" "$name" "$elf" --socket "$at/sock" --record "$at/csv" \
            >"$at/qemu" 2>&1 &
    else
        timeout -k 10 300 "$qemu" -M "$machine" -nographic -monitor none -kernel "$elf" \
            -icount "shift=$shift,sleep=off" "${extra[@]}" \
            -chardev "socket,id=s0,path=$at/sock,server=on,wait=on" -serial chardev:s0 \
            >"$at/qemu" 2>&1 &
    fi
    local child=$!
    appears "$at/sock"
    port=$at/sock
    case $fault in
    none)   local line= ;;
    bytes)  what="$what, 0.4 % of all bytes damaged, seed $seed"; line="115200 $seed 1000 0 1" ;;
    cuts)   what="$what, the cable out for up to 0.5 s, seed $seed"; line="9600 $seed 0 3000 500" ;;
    killed) what="$what, the sender killed"; line="4800 $seed 0 0 1" ;;
    esac
    if [ -n "$line" ]; then
        # shellcheck disable=SC2086
        "$bad_line" "$at/bad" "$at/sock" $line >"$at/line" & local between=$!
        port=$at/bad
        appears "$port"
    fi
    if [ $fault = killed ]; then            # once it has drawn something
        "$loft" stream "$job" --feed $feed --plan=$plan --port "unix:$port" \
            --log "$at/talk" >"$at/first" 2>&1 </dev/null &
        local first=$!
        for _ in $(seq 3000); do
            ! grep -q '< ACK .* executed [1-9]' "$at/talk" 2>/dev/null || break
            sleep 0.02
        done
        { kill -KILL $first; wait $first; } 2>/dev/null
    fi
    timeout 900 "$loft" stream "$job" --feed $feed --plan=$plan --port "unix:$port" \
        >"$at/out" 2>"$at/err" </dev/null
    code=$?
    [ -z "$line" ] || { kill $between; wait $between; }
    kill $child; wait $child 2>/dev/null
    [ $code = 0 ] || sed 's/^/     /' "$at/err" "$at/qemu"
    [ "$qemu" = arm_chip ] || python3 tests/target/pins.py "$name" "$log" > "$at/csv"

    row "$what: the command ends well" "$code" = 0
    row "$what: steps told and steps counted at the pins" \
        "$(awk -F, '/^[0-9]/ { at = $2 " " $3 " " $4 } END { print at }' "$at/csv")" = \
        "$(told "$at/out")"
    if [ $plan = chip ]; then       # with less effort: an axis may turn a step later
        path_rows "$at/csv" | tr ' ' '\n' > "$at/places"
        row "$what: places of an axis that the simulated machine has not, or it alone" \
            "$(path_rows "$at/here.csv" | tr ' ' '\n' | diff "$at/places" - | grep -c '^[<>]')" \
            "<=" 4 "of $(wc -l < "$at/places")"
    else
        row "$what: every axis steps as on the simulated machine" \
            "$(path_of "$at/csv")" = "$(path_of "$at/here.csv")"
    fi
    case $fault in
    none)   ;;
    killed) row "$what: the second one goes on at this share of the job" \
                "$(awk '/^resuming at item/ { printf "%.2f", $4 / $NF }' "$at/err")" "<=" 0.99
            return ;;
    *)      row "$what: bytes damaged, and times that the cable was out" \
                "$(awk '{ print $2 + $4 }' "$at/line")" ">=" 3
            return ;;
    esac
    row "$what: frames sent twice" \
        "$(sed -n 's/.* \([0-9]*\) of [0-9]* frames resent.*/\1/p' "$at/out" "$at/err")" = 0
}

for tool in qemu-system-arm qemu-system-riscv32 python3; do
    command -v $tool >/dev/null ||
        { echo "$tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
f405="--steps 250 --max-speed 400 --accel 2000 --slots 250 --queue 1024 --ramp 200"
mps2="--steps 250 --max-speed 160 --accel 1000 --slots 40 --queue 1024 --ramp 160"
(   board stm32f405   arm_chip            -             - "$f405" host
    board nrf51       qemu-system-arm     microbit      6 \
        "--steps 250 --max-speed 80 --accel 500 --slots 100 --queue 160 --ramp 80" host
    board stm32f405   arm_chip            -             - "$f405" chip
    for fault in "bytes 1" "bytes 2" "cuts 1" "killed 1"; do
        # shellcheck disable=SC2086
        board stm32f405   arm_chip            -             - "$f405" host $fault
    done
) > "$tmp/result2" & other=$!
(   for m in mps2-an385 mps2-an386 mps2-an500 mps2-an505; do
        board $m qemu-system-arm $m 5 "$mps2" host
    done
    for fault in none "bytes 1" "cuts 1" "killed 1"; do
        # shellcheck disable=SC2086
        board riscv-virt qemu-system-riscv32 virt 3 "$mps2" host $fault
    done
) | tee "$tmp/result"
wait $other
cat "$tmp/result2"

passed=$(cat "$tmp"/result* | grep -c '^ok') failed=$(cat "$tmp"/result* | grep -c '^FAIL')
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
