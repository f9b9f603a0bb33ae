#!/bin/bash
# tests/packages/boards.sh -- ESP-IDF, Zephyr and CMSIS: descriptions, options, samples
# SPDX-License-Identifier: MIT
# usage: tests/packages/boards.sh
row=boards
. tests/packages/row.sh
needs cmake ninja arm-none-eabi-gcc riscv64-unknown-elf-gcc qemu-system-arm
export CMAKE_GENERATOR=Ninja
form() { python3 tests/packages/forms.py "$@"; }
given() {
    make -s dist && for pack in esp-idf cmsis; do
        mkdir "$work/$pack" && tar -xf "build/dist/loft-$pack-$(version).tar.gz" -C "$work/$pack" ||
            return
    done
}
verdict "make dist: a component for ESP-IDF and a CMSIS pack" given
zephyr=ports/packages/zephyr idf=$work/esp-idf/loft pack=$work/cmsis/loft
verdict "zephyr/module.yml and sample.yaml: the form of Zephyr's schema (it is not here)" \
    form zephyr $zephyr
verdict "idf_component.yml: form of the component manager's (it is not here)" form esp-idf "$idf"
verdict "loft.loft.pdsc: form of PACK.xsd 1.7 (its checker is not here)" form cmsis "$pack"

options() {     # options KCONFIG FIRST..: kconfiglib reads it; each number type can be chosen
    /usr/bin/python3 - "$@" <<'P'
import sys
import kconfiglib
k = kconfiglib.Kconfig(sys.argv[1], warn_to_stderr=False)
assert not k.warnings, k.warnings
for first in sys.argv[2:]:
    k.syms[first].set_value(2)
assert k.syms['LOFT_AXES'].str_value == '3' and k.syms['LOFT_Q16'].str_value == 'y'
for num in ('LOFT_F32', 'LOFT_F64', 'LOFT_Q16'):
    k.syms[num].set_value(2)
    assert [n for n in ('LOFT_Q16', 'LOFT_F32', 'LOFT_F64') if k.syms[n].str_value == 'y'] == [num]
P
}
verdict "Kconfig of Zephyr, read by kconfiglib, which Zephyr uses" options $zephyr/Kconfig LOFT
verdict "Kconfig of ESP-IDF, read by kconfiglib" options "$idf/Kconfig"

last() { [ "$("$@" 2>&1 | tail -1)" = "2621440 0" ]; }
by_zephyr() {
    cmake -S $zephyr/samples/walk -B "$work/zephyr" -DZephyr_DIR="$top/tests/packages/zephyr" &&
        cmake --build "$work/zephyr" && last "$work/zephyr/app"
}
verdict "Zephyr: the module and samples/walk by CMake, Zephyr's functions by ours: built and run" \
    by_zephyr
by_idf() {
    IDF_PATH=$top/tests/packages/idf cmake -S "$idf/examples/walk" -B "$work/idf" &&
        cmake --build "$work/idf" && last "$work/idf/app"
}
verdict "ESP-IDF: the component and examples/walk by CMake, its functions by ours: built and run" \
    by_idf

on_c3() {       # the ESP32-C3's instructions
    riscv64-unknown-elf-gcc -march=rv32imc -mabi=ilp32 -std=c99 -ffreestanding -Wall -Wextra \
        -Werror -Os -ffunction-sections -c "$idf/loft.c" -o "$work/c3.o" &&
        riscv64-unknown-elf-nm "$work/c3.o" | grep -q loft_bezier_eval
}
verdict "ESP-IDF: loft.c for rv32imc (ESP32-C3)" on_c3
by_cmsis() {
    arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -Os -ffreestanding -c tests/packages/say.c \
        -o "$work/say.o" || return
    arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -Os -ffreestanding -ffunction-sections \
        -Wl,--gc-sections -nostartfiles -Wl,-T,tests/packages/arduino/bare/arm/m0.ld -Wall \
        -Werror -Dmain=user_main -I"$pack" "$pack/examples/walk/walk.c" "$pack/loft.c" \
        "$work/say.o" -o "$work/cmsis.elf" &&
        last timeout 600 qemu-system-arm -M lm3s6965evb -nographic -semihosting \
            -kernel "$work/cmsis.elf" </dev/null
}
verdict "CMSIS: the pack's files and sample for a Cortex-M3, run in QEMU" by_cmsis
ended
