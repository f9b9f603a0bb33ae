#!/bin/sh
# tests/bench/bench_motion_cortex.sh -- counts instructions for planning and stepping the outline on
# a Cortex-M0 and M4, in QEMU
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_motion_cortex.sh DIR      prints lines: core, jerk limit, then the names
# and numbers of tests/target/motion.c
set -eu
dir=$1
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null || { echo "$tool is missing: make deps-target" >&2; exit 1; }
done
mkdir -p "$dir"
sh tests/bench/outline_array.sh > "$dir/outline.h"
for core in cortex-m0 cortex-m4; do
    for jerk in 0 10000; do
        arm-none-eabi-gcc -mthumb -mcpu=$core -O2 -std=c99 -ffreestanding -nostdlib \
            -ffunction-sections -Wl,--gc-sections \
            -Ilib -Itests/target -I"$dir" -DLOFT_AXES=3 -DJERK=$jerk -DMOVES=4 -DKNOTS=176 \
            -T tests/target/netduino.ld tests/target/microbit.c tests/target/semihost.S \
            tests/target/motion.c lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c \
            lib/path/*.c lib/motion/*.c lib/machine/pace.c lib/machine/step.c -lgcc \
            -o "$dir/motion-$core.elf"
        timeout 200 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
            -icount shift=0 -semihosting-config enable=on,target=native \
            -kernel "$dir/motion-$core.elf" > "$dir/said" 2>&1 ||
            { cat "$dir/said"; exit 1; }
        echo "$core $jerk $(paste -sd' ' "$dir/said")"
    done
done
