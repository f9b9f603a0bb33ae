#!/bin/bash
# tests/packages/onefile.sh -- the single files of both libraries: each compiler alone, tests
# SPDX-License-Identifier: MIT
# usage: tests/packages/onefile.sh
row=onefile
. tests/packages/row.sh
needs gcc clang g++ clang++ avr-gcc arm-none-eabi-gcc
amalgam() { python3 ports/packages/amalgam/amalgam.py "$@"; }
verdict "loft.h and loft.c of all rooms" amalgam --out "$work/all"
verdict "loft.h and loft.c of the curves, --num f32" amalgam --rooms curve --num f32 \
    --out "$work/curve"
cp tests/packages/user.c "$work"
cd "$work" || exit
warnings="-Wall -Wextra -Wpedantic -Werror"

alone() {       # alone FOLDER COMPILER..: without a warning, and neither file needs another
    local folder=$1; shift
    for one in loft loft_surfaces; do
        "$@" $warnings -c "$folder/$one.c" -o "$folder/$one.o" || return
    done
}
for num in q16 f32 f64; do
    verdict "gcc -std=c99, $num" alone all gcc -std=c99 -DLOFT_NUM="$(macro $num)"
    same() {
        nm all/loft.o all/loft_surfaces.o | sed -n 's/.* T //p' | LC_ALL=C sort > have
        nm "$top/build/${num}x3"/libloft{,-surfaces}.a 2>/dev/null | sed -n 's/.* T //p' |
            LC_ALL=C sort > want
        [ "$(wc -l < have)" -gt 500 ] && diff want have
    }
    verdict "$num: has the functions of both archives" same
    # the library's own tests, linked with loft.o instead
    tested() {
        for one in loft loft_surfaces; do
            gcc -O1 -DLOFT_NUM="$(macro $num)" -c all/$one.c -o all/$one.o || return
        done
        for test in bezier forward hermite rational nurbs offset tensor triangle gb plan codec \
                    sender machine step; do
            gcc -std=c99 -I"$top/lib" -I"$top/tests" -DLOFT_NUM="$(macro $num)" \
                "$(find "$top/tests/lib" -name "test_$test.c")" all/loft_surfaces.o all/loft.o \
                -lm -o test || return
            LOFT_CASES=100 ./test || return
        done
    }
    verdict "$num: 14 tests of the library run with it" tested
    ran() {
        gcc -Icurve -DLOFT_NUM="$(macro $num)" user.c curve/loft.c -o user &&
            ./user | grep -q '^64 points, 262144 -65536'
    }
    verdict "$num: a program with the curves alone, built and run" ran
done
verdict "clang -std=c99" alone all clang -std=c99
# designated initializers and compound literals are extensions of both compilers in C++17
cplusplus="-std=gnu++17 -Wno-missing-field-initializers -x c++"
warnings="-Wall -Wextra -Werror"
for compiler in g++ "clang++ -Wno-c99-designator"; do
    verdict "${compiler%% *} -std=gnu++17" alone all $compiler $cplusplus
done
verdict "avr-gcc for the ATmega328P" alone all avr-gcc -mmcu=atmega328p -std=c99 -Os
verdict "arm-none-eabi-gcc for the Cortex-M0+" alone all \
    arm-none-eabi-gcc -mthumb -mcpu=cortex-m0plus -std=c99 -ffreestanding -Os
ended
