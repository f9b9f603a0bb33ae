#!/bin/sh
# tests/bench_motion_avr.sh -- cycles and RAM of planning the outline on an AVR, in simavr
# SPDX-License-Identifier: MIT
# usage: tests/bench_motion_avr.sh DIR     prints `chip NAME flash BYTES`, then the names and numbers of tests/target/motion.c
# Two axes, even acceleration, one span per beat; rings of 2 curves and 6 pieces. Where its code does not fit an ATmega328P it is run
# on an ATmega2560: the same core, calls take a cycle more.
set -eu
dir=$1
for tool in avr-gcc simavr; do
    command -v $tool >/dev/null || { echo "$tool is missing: make deps-target" >&2; exit 1; }
done
mkdir -p "$dir"
sh tests/outline_array.sh > "$dir/outline.h"
build() {
    avr-gcc -mmcu=$1 -Os -std=c99 -ffreestanding -ffunction-sections -Wl,--gc-sections -Ilib -Itests/target -I"$dir" -DLOFT_AXES=2 \
        -DLOFT_PLAN_WINDOW=4 -DLOFT_PLAN_FILTER=1 -DJERK=0 -DMOVES=2 -DPIECES=6 tests/target/motion.c \
        lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c lib/motion/*.c -o "$dir/motion-avr.elf" 2> "$dir/avr.log"
}
chip=atmega328p
build $chip || { chip=atmega2560; build $chip || { cat "$dir/avr.log" >&2; exit 1; }; }
echo "chip $chip flash $(avr-size "$dir/motion-avr.elf" | awk 'NR == 2 { print $1 + $2 }')"
timeout 300 simavr -m $chip -f 16000000 "$dir/motion-avr.elf" 2>&1 | sed 's/\x1b\[[0-9;]*m//g' | grep -oE '^[a-z_]+ [0-9]+'
