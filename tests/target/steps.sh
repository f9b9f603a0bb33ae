#!/bin/sh
# tests/target/steps.sh -- faster steps of walks and slots against their definitions: 10^7 random
# states on an emulated Cortex-M0 and M4, 10^6 on an ATmega328P
# SPDX-License-Identifier: MIT
# usage: tests/target/steps.sh DIR
set -u
dir=$1 passed=0 failed=0
mkdir -p "$dir"
sources="tests/target/steps.c lib/machine/step.c $(echo lib/num/*.c)"
flags="-std=gnu99 -ffunction-sections -fdata-sections -Wl,--gc-sections"
flags="$flags -Ilib -Iports -Itests/target -DLOFT_AXES=3"
for chip in cortex-m0 cortex-m4 atmega328p; do
    case $chip in
    atmega328p)
        avr-gcc -mmcu=atmega328p -Os $flags -DSWEPT=1000000u $sources -o "$dir/$chip.elf" &&
        timeout 3600 simavr -m atmega328p -f 16000000 "$dir/$chip.elf" >"$dir/$chip" 2>&1
        names=wrong_steps ;;
    *)
        arm-none-eabi-gcc -mthumb -mcpu=$chip -O2 -ffreestanding -nostdlib $flags \
            -DSWEPT=10000000u -T tests/target/netduino.ld tests/target/microbit.c \
            tests/target/semihost.S $sources -lgcc -o "$dir/$chip.elf" &&
        timeout 900 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
            -semihosting-config enable=on,target=native -kernel "$dir/$chip.elf" >"$dir/$chip" 2>&1
        names="wrong_steps wrong_words" ;;
    esac
    for name in $names; do
        wrong=$(grep -aoE "$name [0-9]+" "$dir/$chip" | cut -d' ' -f2)
        if [ "$wrong" = 0 ]; then echo "ok   $chip: $name 0"; passed=$((passed + 1))
        else echo "FAIL $chip: $name ${wrong:-nothing}"; failed=$((failed + 1)); fi
    done
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
