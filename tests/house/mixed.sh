#!/bin/sh
# tests/house/mixed.sh -- builds with different arithmetic do not link, and the message says why;
# three number types link into one program
# SPDX-License-Identifier: MIT
# usage: tests/house/mixed.sh BUILD ; the libraries BUILD/{q16,f32,f64}x3/libloft.a must exist
set -u
build=$1 work=$1/mixed
cc="${CC:-cc} ${CPPFLAGS:-} ${CFLAGS:-}"
result=$work/result
mkdir -p "$work"
: > "$result"
verdict() {     # verdict NAME COMMAND..: is the command true?
    name=$1; shift
    if "$@"; then echo "ok   mixed $name"; else echo "FAIL mixed $name"; fi | tee -a "$result"
}

# A part of a program: the diagonal of the unit square in its own number type, as a double.
cat > "$work/part.c" <<'PART'
#include "geom/vec.h"
#if LOFT_NUM == LOFT_Q16
#  define UNIT 4294967296.0
#else
#  define UNIT 1.0
#endif
double PART(void);
double PART(void)
{
    const loft_acc square[2] = { loft_to_acc(LOFT_REAL(1)), loft_to_acc(LOFT_REAL(1)) };
    return (double)loft_acc_hypot(square, 2) / UNIT;
}
PART
cat > "$work/main.c" <<'MAIN'
#include <stdio.h>
double part_q16(void), part_f32(void), part_f64(void);
int main(void)
{
    printf("%.6f %.12f %.12f\n", part_q16(), part_f32(), part_f64());
    return 0;
}
MAIN
printf 'double part(void); int main(void) { return part() > 0 ? 0 : 1; }\n' > "$work/one.c"

part() {        # part NUM AXES NAME: compile the part for a number type
    $cc -std=c99 -Ilib -DLOFT_NUM=LOFT_"$(echo "$1" | tr a-z A-Z)" -DLOFT_AXES="$2" -DPART="$3" \
        -c "$work/part.c" -o "$work/$1x$2.o"
}
links() {       # links NUM AXES LIBRARY: does a program of that arithmetic link with that library?
    part "$1" "$2" part &&
        $cc ${LDFLAGS:-} "$work/one.c" "$work/$1x$2.o" "$build/$3/libloft.a" -o "$work/one" \
            2> "$work/$1x$2.log"
}
# refused NUM AXES LIBRARY: it does not, and the linker names the arithmetic that is missing
refused() {
    ! links "$1" "$2" "$3" && grep -q "loft_acc_hypot_$1x$2" "$work/$1x$2.log"
}

for num in q16 f32 f64; do
    verdict "$num program, $num library: links" links $num 3 ${num}x3
    for other in q16 f32 f64; do
        [ $num = $other ] ||
            verdict "$num program, $other library: refused, names _${num}x3" \
                refused $num 3 ${other}x3
    done
done
verdict "two axes, library of three: refused, names _q16x2" refused q16 2 q16x3

all() {
    for num in q16 f32 f64; do part $num 3 part_$num || return 1; done
    $cc ${LDFLAGS:-} "$work/main.c" "$work/q16x3.o" "$work/f32x3.o" "$work/f64x3.o" \
        "$build/q16x3/libloft.a" "$build/f32x3/libloft.a" "$build/f64x3/libloft.a" -o "$work/all" &&
    [ "$("$work/all")" = "1.414214 1.414213562373 1.414213562373" ]
}
verdict "three number types in one program link and run" all

passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
