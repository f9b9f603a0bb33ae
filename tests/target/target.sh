#!/bin/sh
# tests/target/target.sh -- check that q16 is the same, bit for bit, on an ATmega328P and Cortex-M0
# SPDX-License-Identifier: MIT
# Compiles tests/target/sums.c with lib/ for them and for this computer, runs it in simavr, in QEMU
# and here, and compares line by line. The AVR backend has its own code (shifts by moving bytes):
# this is its test.
set -u
for tool in avr-gcc simavr arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null ||
        { echo "$tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
work=build/target
mkdir -p $work

sources_of() {  # sources_of PART: the sources that the part links
    echo "tests/target/sums.c lib/num/*.c"
    case $1 in
    4) echo "lib/basis/bernstein.c lib/curve/bezier.c lib/surface/tensor/grid.c"
       echo "lib/surface/tensor/tensor.c lib/surface/triangle/triangle.c"
       echo "lib/surface/barycentric.c lib/geom/*.c" ;;
    *) echo "lib/geom/*.c lib/basis/*.c lib/curve/*.c" ;;
    esac
}

: > $work/here
: > $work/atmega328p
: > $work/cortex-m0
m0="arm-none-eabi-gcc -mthumb -mcpu=cortex-m0 -ffreestanding -nostdlib"
m0="$m0 -T tests/target/microbit.ld tests/target/microbit.c tests/target/semihost.S"
for part in 1 2 3 4; do
    sources=$(sources_of $part)
    flags="-std=c99 -ffunction-sections -Wl,--gc-sections -Ilib -DPART=$part"
    ${CC:-cc} $flags -O1 -fsanitize=undefined -fno-sanitize-recover=all $sources \
        -o $work/sums$part &&
    avr-gcc -mmcu=atmega328p -Os $flags $sources -o $work/sums$part.elf &&
    $m0 -Os $flags $sources -lgcc -o $work/sums$part-m0.elf ||
        { echo "FAIL target does not build"; echo "0 passed, 1 failed"; exit 1; }
    $work/sums$part >> $work/here
    timeout 900 simavr -m atmega328p -f 16000000 $work/sums$part.elf 2>&1 |
        sed 's/\x1b\[[0-9;]*m//g' > $work/said
    grep -oE '^[a-z_]+ [0-9a-f]{8}' $work/said >> $work/atmega328p
    grep -oE '^# .*[0-9]' $work/said
    timeout 900 qemu-system-arm -M microbit -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel $work/sums$part-m0.elf \
        >> $work/cortex-m0 2>&1
done

passed=0 failed=0
for chip in atmega328p cortex-m0; do
    while read -r name sum; do
        got=$(awk -v name="$name" '$1 == name { print $2 }' $work/$chip)
        if [ "$got" = "$sum" ]; then echo "ok   $chip $name"; passed=$((passed + 1))
        else echo "FAIL $chip $name: ${got:-nothing}, here $sum"; failed=$((failed + 1)); fi
    done < $work/here
done
[ $passed -gt 0 ] || failed=$((failed + 1))
echo "$passed passed, $failed failed"
[ $failed = 0 ]
