#!/bin/bash
# tests/packages/arduino.sh -- the library of make dist: sketches by arduino-builder, run in
# emulators; PlatformIO's file of the same library
# SPDX-License-Identifier: MIT
# usage: tests/packages/arduino.sh
row=arduino
. tests/packages/row.sh
needs arduino-builder avr-gcc arm-none-eabi-g++ simavr qemu-system-arm
given() {
    make -s dist && mkdir -p "$work/libraries" &&
        for name in loft loft-surfaces; do
            tar -xf "build/dist/$name-arduino-$(version).tar.gz" -C "$work/libraries" || return
        done
}
verdict "make dist: both libraries, each with its header and its source in src/" given
for name in loft loft_surfaces; do
    verdict "$name: library.properties as arduino-lint's rules ask for (it is not here)" \
        python3 tests/packages/forms.py arduino "$work/libraries/$name"
    verdict "$name: library.json as PlatformIO's rules ask for (it is not here)" \
        python3 tests/packages/forms.py platformio "$work/libraries/$name"
done
verdict "platformio.ini: sections and keys, by PlatformIO's rules (it is not here)" \
    python3 tests/packages/forms.py platformio-ini ports/packages/platformio/examples/walk

# Debian's avr-gcc 5.4 lacks DECIMAL_DIG in C++11, which the core asks for
build() {       # build BOARD SKETCH FLAG..: as the IDE does
    local board=$1 sketch=$2 out=$work/$1-$2; shift 2
    mkdir -p "$out"
    arduino-builder -compile -logger machine -hardware /usr/share/arduino-builder \
        -hardware /usr/share/arduino/hardware -hardware "$top/tests/packages/arduino" \
        -tools /usr/bin -libraries "$work/libraries" -fqbn "$board" -build-path "$out" \
        -warnings all -prefs=compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ "$@" \
        "$work"/libraries/*/examples/"$sketch/$sketch.ino" 2>&1
}
uno() {         # uno SKETCH: built without a warning of ours, and it fits
    build arduino:avr:uno "$1" > "$work/said" || { cat "$work/said"; return 1; }
    ! grep -E 'libraries/loft.*warning' "$work/said" &&
        avr-size -C --mcu=atmega328p "$work/arduino:avr:uno-$1/$1.ino.elf" | grep -E 'Program|Data'
}
on_uno() {      # on_uno SKETCH LINE: it says this on its serial port, in simavr
    timeout 20 simavr -m atmega328p -f 16000000 "$work/arduino:avr:uno-$1/$1.ino.elf" \
        > "$work/said" 2>&1
    tr -d '\r.' < "$work/said" | sed 's/\x1b\[[0-9;]*m//g' | grep -qx "$2" ||
        { tail -3 "$work/said"; return 1; }
}
arm() {
    build bare:arm:m0 "$1" > "$work/said" || { cat "$work/said"; return 1; }
    ! grep -E 'warning' "$work/said"
}
on_arm() {      # on_arm SKETCH LINE
    timeout 60 qemu-system-arm -M lm3s6965evb -nographic -semihosting \
        -kernel "$work/bare:arm:m0-$1/$1.ino.elf" > "$work/said" 2>&1 </dev/null
    grep -qx "$2" "$work/said" || { tail -3 "$work/said"; return 1; }
}
bytes() { avr-size "$work/arduino:avr:uno-$1/$1.ino.elf" | awk 'NR == 2 { print $1 + $2 }'; }
for sketch in "$work"/libraries/*/examples/*/; do
    sketch=$(basename "$sketch")
    verdict "$sketch.ino for the Uno, by arduino-builder and Debian's core" uno "$sketch"
    echo "     $(bytes "$sketch") bytes of flash with the core"
    verdict "$sketch.ino for a Cortex-M0, by arduino-builder and a core of ours" arm "$sketch"
done
verdict "Walk.ino ends on its last control point, on the Uno in simavr" on_uno Walk "2621440 0"
verdict "Walk.ino ends on its last control point, on a Cortex-M0 in QEMU" on_arm Walk "2621440 0"
verdict "Circle.ino is at 28, 128 after half a turn, on a Cortex-M0 in QEMU" on_arm Circle "9:28"
ended
