#!/bin/sh
# tests/target.sh -- is q16 the same, bit for bit, on an ATmega328P as here?
# SPDX-License-Identifier: MIT
# Compiles tests/target/sums.c with lib/ for both, runs the one in simavr, compares line by line. The AVR backend has
# roads of its own (shifts by moving bytes); here is where they are tested.
set -u
for tool in avr-gcc simavr; do
    command -v $tool >/dev/null || { echo "$tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
work=build/target
mkdir -p $work
sources="tests/target/sums.c lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c"


: > $work/here
: > $work/atmega328p
for part in 1 2 3; do
    ${CC:-cc} -std=c99 -O1 -fsanitize=undefined -fno-sanitize-recover=all -Ilib -DPART=$part $sources -o $work/sums$part &&
    avr-gcc -mmcu=atmega328p -std=c99 -Os -ffunction-sections -Wl,--gc-sections -Ilib -DPART=$part $sources -o $work/sums$part.elf ||
        { echo "FAIL target does not build"; echo "0 passed, 1 failed"; exit 1; }
    $work/sums$part >> $work/here
    timeout 300 simavr -m atmega328p -f 16000000 $work/sums$part.elf 2>&1 | sed 's/\x1b\[[0-9;]*m//g' |
        grep -oE '^[a-z_]+ [0-9a-f]{8}' >> $work/atmega328p
done

passed=0 failed=0
while read -r name sum; do
    got=$(awk -v name="$name" '$1 == name { print $2 }' $work/atmega328p)
    if [ "$got" = "$sum" ]; then echo "ok   atmega328p $name"; passed=$((passed + 1))
    else echo "FAIL atmega328p $name: ${got:-nothing}, here $sum"; failed=$((failed + 1)); fi
done < $work/here
[ $passed -gt 0 ] || failed=$((failed + 1))
echo "$passed passed, $failed failed"
[ $failed = 0 ]
