#!/bin/bash
# tests/bench/bench_motion_chip.sh -- counts instructions for planning chains on a Cortex-M4 and M0,
# in QEMU
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_motion_chip.sh DIR [CORE:MACHINE:LIST..]
# Prints a line for each: load at the clock of the core, the most expensive call, seconds, memory.
set -eu
dir=$1; shift
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null || { echo "$tool is missing: make deps-target" >&2; exit 1; }
done
knots=${KNOTS:-112} moves=${MOVES:-32}
mkdir -p "$dir/lists"
[ -s "$dir/lists/outline-chords.moves" ] ||
    /usr/bin/python3 tests/bench/motion_lists.py "$dir/lists"

# chain_of LIST: the first 400 curves as raw Q16.16
chain_of() {
    awk 'function raw(x) { return x < 0 ? -int(0.5 - x * 65536) : int(x * 65536 + 0.5) }
         BEGIN { print "static const int32_t chain[][4][2] = {" }
         NR <= 400 {
             printf "    {"
             for (k = 1; k < 12; k += 3) printf " { %d, %d },", raw($k), raw($(k + 1))
             print " },"
         }
         END { print "};" }' "$dir/lists/$1.moves"
}

# library CPU FLAGS: its objects
library() {
    rm -rf "${dir:?}/$1"
    mkdir -p "$dir/$1"
    ls lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c lib/path/*.c lib/motion/*.c |
        xargs -P2 -I{} sh -c 'arm-none-eabi-gcc '"$2"' -c {} -o "$0/$(basename {} .c).o"' "$dir/$1"
    touch "$dir/$1/done"
}

rm -f "$dir"/*/done
[ $# -gt 0 ] || set -- m4:B:outline-cut-{1,8,32} m4:B:star-cut-{1,8} \
                       m0:A:outline-cut-{1,8,32} m0:A:star-cut-1
printf '%-26s %8s %8s %10s %8s %7s %7s %7s\n' \
    "core, machine, list" "load" "spans/s" "worst call" seconds bytes "+moves" stack
for what; do
    IFS=: read -r core machine list <<< "$what"
    case $core in m0) cpu=cortex-m0 mhz=48 ;; m4) cpu=cortex-m4 mhz=168 ;; esac
    case $machine in
    A) limits="-DSPEED=100 -DACCEL=500 -DJERK=10000" ;;
    B) limits="-DSPEED=200 -DACCEL=3000 -DJERK=100000" ;;
    esac
    out=$dir/$core-$machine-$list
    mkdir -p "$out"
    chain_of "$list" > "$out/chain.h"
    flags="-mthumb -mcpu=$cpu -O2 -std=c99 -ffreestanding -ffunction-sections"
    flags="$flags -DLOFT_PLAN_EFFORT=1 ${CHIP_FLAGS:-}"
    flags="$flags -Ilib -Itests/target -I$out -DLOFT_AXES=3 $limits -DMOVES=$moves -DKNOTS=$knots"
    [ -s "$dir/$cpu/done" ] || library $cpu "$flags"
    arm-none-eabi-gcc $flags -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments \
        -T tests/target/netduino.ld tests/target/microbit.c tests/target/semihost.S \
        tests/target/plan.c "$dir/$cpu"/*.o -lgcc -o "$out/plan.elf"
    timeout 600 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
        -icount shift=0 -semihosting-config enable=on,target=native ${QEMU_FLAGS:-} \
        -kernel "$out/plan.elf" > "$out/said" 2>&1 || { cat "$out/said"; exit 1; }
    awk -v what="$what" -v mhz=$mhz '
        { v[$1] = $2 }
        END { s = v["ticks"] / 1000
              printf "%-26s %8.3f %8.1f %10d %8.3f %7d %7d %7d\n", what,
                  v["planning"] / s / 1e6 / mhz, v["spans"] / s, v["worst"], s,
                  v["bytes_plan"] + v["bytes_knots"], v["bytes_moves"], v["stack"] }' "$out/said"
done
