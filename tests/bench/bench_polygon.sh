#!/bin/sh
# tests/bench/bench_polygon.sh -- counts instructions for a point of each patch with n sides on a
# Cortex-M0 and M4, in QEMU, and compares the sums with those of the host
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_polygon.sh DIR
set -u
dir=$1
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null ||
        { echo "$tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
mkdir -p "$dir"
flags="-std=c99 -O2 -ffunction-sections -Wl,--gc-sections -Ilib -Itests/target -DLOFT_AXES=3
       tests/target/polygon.c lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c
       lib/surface/*.c lib/surface/*/*.c lib/polygon/*.c"
${CC:-cc} $flags -o "$dir/here" && "$dir/here" > "$dir/here.said" ||
    { echo "FAIL does not build here"; echo "0 passed, 1 failed"; exit 1; }
for core in cortex-m4 cortex-m0; do
    arm-none-eabi-gcc -mthumb -mcpu=$core -ffreestanding -nostdlib $flags \
        tests/target/microbit.c tests/target/semihost.S -T tests/target/netduino.ld \
        -lgcc -o "$dir/$core.elf" &&
    timeout 200 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
        -icount shift=0 -semihosting-config enable=on,target=native \
        -kernel "$dir/$core.elf" > "$dir/$core.said" 2>&1 ||
        { echo "FAIL $core"; : > "$dir/$core.said"; }
done
printf '%-36s %10s %10s   %s\n' "a point in q16, instructions" "Cortex-M4" "Cortex-M0" "sum as here"
passed=0 failed=0
while read -r name _ sum; do
    set -- $(awk -v name="$name" '$1 == name { print $2, $3 }' "$dir/cortex-m4.said") - - \
        $(awk -v name="$name" '$1 == name { print $2, $3 }' "$dir/cortex-m0.said")
    if [ "${2:-}" = "$sum" ] && [ "${6:-}" = "$sum" ]; then
        verdict=ok passed=$((passed + 1))
    else
        verdict=FAIL failed=$((failed + 1))
    fi
    printf '%-36s %10s %10s   %s\n' "$(echo "$name" | tr _ ' ')" "${1:-?}" "${5:-?}" "$verdict"
done < "$dir/here.said"
[ $passed -gt 0 ] || failed=$((failed + 1))
echo "$passed passed, $failed failed"
[ $failed = 0 ]
