#!/bin/bash
# tests/packages/export.sh -- loft export: a drawing in the flash of a chip, read there
# SPDX-License-Identifier: MIT
# usage: tests/packages/export.sh
row=export
. tests/packages/row.sh
needs gcc avr-gcc avr-size simavr
drawing=tests/drawings/outline12.csv
made() { make -s build/loft && build/loft export -o "$work/icon.h" $drawing; }
verdict "loft export -o icon.h" made

cat > "$work/read.c" <<'C'
#include "loft.h"
#include "icon.h"
#if defined(__AVR__)
#  include <avr/interrupt.h>
#  include <avr/io.h>
#  include <avr/sleep.h>
static void put(char c) { while (!(UCSR0A & (1 << UDRE0))) {} UDR0 = (uint8_t)c; }
static void start(void) { UCSR0A = 1 << U2X0; UCSR0B = 1 << TXEN0; }
static void stop(void)  { put('\n'); cli(); sleep_enable(); sleep_cpu(); }
#else
#  include <stdio.h>
static void put(char c) { putchar(c); }
static void start(void) {}
static void stop(void)  {}
#endif
static void number(int32_t raw, char end)
{
    char digits[12];
    int n = 0;
    uint32_t left = raw < 0 ? 0 - (uint32_t)raw : (uint32_t)raw;
    if (raw < 0) put('-');
    do digits[n++] = (char)('0' + left % 10); while (left /= 10);
    while (n > 0) put(digits[--n]);
    put(end);
}
int main(void)
{
    loft_drawing_walk walk;
    loft_cubic c;
    bool lifted;
    start();
    if (loft_drawing_begin(&walk, &icon) != LOFT_OK) return 1;
    while (loft_drawing_next(&walk, &c, &lifted))
        for (int i = 0; i < 8; i++)
            number(loft_raw_from_real(c.p[i / 2].axis[i % 2]), i < 7 ? ',' : '\n');
    stop();
    return 0;
}
C
sources="$work/read.c lib/curve/drawing.c lib/curve/cubic.c lib/basis/bernstein.c"
here() {
    for num in q16 f32 f64; do
        gcc -std=c99 -Wall -Wextra -Werror -Ilib -DLOFT_NUM="$(macro $num)" $sources \
            lib/curve/bezier.c lib/num/*.c -o "$work/read" && "$work/read" > "$work/$num" &&
            cmp "$work/$num" "$work/q16" || return
    done
}
verdict "read back by a program, alike in q16, f32 and f64" here
true_to() {     # each control point within the rounding that the table states
    awk -F, -v most="$(sed -n 's/.*rounded by at most \([0-9.e-]*\) mm.*/\1/p' "$work/icon.h")" '
        /^#/ { next }
        NR == FNR { for (i = 1; i <= 8; i++) want[n, i] = $i; n++; next }
        { for (i = 1; i <= 8; i++) {
              off = $i / 65536 - want[read, i]; off = off < 0 ? -off : off
              if (off > most * 1.001) { print FILENAME ": curve " read ": off by " off; bad = 1 }
          }
          read++ }
        END { if (n < 10 || read != n) print read " curves of " n; exit bad || n < 10 || read != n }
    ' $drawing "$work/q16"
}
verdict "its control points are those of the drawing, within the rounding it states" true_to
on_avr() {
    avr-gcc -std=c99 -mmcu=atmega328p -Os -ffunction-sections -Wl,--gc-sections -Wall -Wextra \
        -Werror -Ilib $sources lib/num/avr.c -o "$work/read.elf" &&
        timeout 600 simavr -m atmega328p -f 16000000 "$work/read.elf" 2>&1 |
        sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' | grep -E '^-?[0-9]+,' > "$work/avr"
    diff "$work/avr" "$work/q16"
}
verdict "ATmega328P (simavr): the same points" on_avr
in_flash() {    # data and bss: no room for the table
    avr-size "$work/read.elf" | awk 'NR == 2 { print $2 + $3 " bytes of RAM"
                                               exit $2 + $3 > 32 }'
}
verdict "ATmega328P: the table takes no RAM" in_flash
ended
