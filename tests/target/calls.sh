#!/bin/sh
# tests/target/calls.sh -- compares the tables of lib/motion with the cost of its calls on an
# emulated ATmega328P, Cortex-M0 and M4
# SPDX-License-Identifier: MIT
# usage: tests/target/calls.sh DIR
# Prints a line per number: it holds if the call takes at most that, and at least 7/10 of it.
set -u
dir=$1
for tool in avr-gcc simavr arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null ||
        { echo "FAIL $tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
mkdir -p "$dir"
sources="tests/target/calls.c $(echo lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c)"
sources="$sources lib/machine/pace.c lib/motion/scurve.c lib/motion/span.c lib/machine/step.c"
flags="-std=c99 -ffunction-sections -fdata-sections -Wl,--gc-sections"
flags="$flags -Ilib -Itests/target -DLOFT_AXES=3"
avr-gcc -mmcu=atmega328p -Os $flags $sources -o "$dir/calls.elf" &&
timeout 300 simavr -m atmega328p -f 16000000 "$dir/calls.elf" 2>&1 |
    sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' >"$dir/atmega328p"
for core in cortex-m0 cortex-m4; do
    arm-none-eabi-gcc -mthumb -mcpu=$core -O2 -ffreestanding -nostdlib $flags \
        -T tests/target/netduino.ld tests/target/microbit.c tests/target/semihost.S $sources -lgcc \
        -o "$dir/calls-$core.elf" &&
    timeout 300 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
        -icount shift=0 -semihosting-config enable=on,target=native \
        -kernel "$dir/calls-$core.elf" >"$dir/$core" 2>&1
done
awk -v dir="$dir" 'BEGIN {
        split("atmega328p cortex-m0 cortex-m4", core, " ")
        for (k = 1; k <= 3; k++)
            while ((getline line < (dir "/" core[k])) > 0) {
                n = split(line, f, " ")
                if (n == 2) cost[f[1], k] = f[2]
                if (n == 3 && f[1] == "bytes" && f[3] > size[f[2]]) size[f[2]] = f[3]
            }
    }
    function judge(what, said, is, least) {
        good = is + 0 > 0 && is <= said && is >= least * said; if (good) passed++; else failed++
        printf "%s %-34s %7d, said to be at most %d\n", good ? "ok  " : "FAIL", what, is, said
    }
    $2 ~ /^loft_/ && $3 ~ /^[0-9,]+$/ {
        gsub(",", "")
        for (k = 1; k <= 3; k++) judge($2 ", " core[k], $(k + 2), cost[$2, k], 0.7)
        if ($6 ~ /^loft_/) judge("bytes of " $6, $7, size[$6], 1)
    }
    END {
        printf "%d passed, %d failed\n", passed, failed + (passed + failed < 38)
        exit failed > 0 || passed < 38
    }' lib/motion/span.h lib/motion/scurve.h
