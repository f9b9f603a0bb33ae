#!/bin/bash
# tests/packages/cpp.sh -- loft.hpp: what it gives, and that it costs nothing
# SPDX-License-Identifier: MIT
# usage: tests/packages/cpp.sh
row=cpp
. tests/packages/row.sh
needs g++ clang++ arm-none-eabi-g++
cat > "$work/user.cpp" <<'C'
#include <cstdio>
#include "loft.hpp"
int main()
{
    static const loft::point p[] = { { 0, 0 }, { 1, 2 }, { 3, 2 }, { 4, -1 } };
    const loft::bezier curve(p);
    unsigned count = 0;
    loft::vec at;
    if (!curve || loft::bezier({ p, 0 }))
        return 1;
    for (const loft::vec &v : curve.walk(64)) {
        at = v;
        count++;
    }
    for (const loft::vec &v : curve.walk(0))
        return v[0] != 0;
    const loft::vec middle = curve(loft::unit(0.5));
    const bool right = count == 64 && at == p[3] && middle == loft::vec(2, 1.375) &&
                       p[1] + p[2] == loft::vec(4, 4) && p[2] - p[1] == loft::vec(2, 0) &&
                       lerp(p[0], p[3], loft::unit(0.25)) == loft::vec(1, -0.25);
    std::puts(right ? "right" : "wrong");
    return !right;
}
C
runs() {        # runs COMPILER NUM
    $1 -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -Ilib -Iports/packages/cpp \
        -DLOFT_NUM="$(macro "$2")" "$work/user.cpp" "build/${2}x3/libloft.a" -o "$work/user" &&
        "$work/user"
}
built() { make -s libraries; }
verdict "the libraries" built
for num in q16 f32 f64; do
    for compiler in g++ clang++; do
        verdict "$compiler -std=c++17 $num: curves, walks, operators: built and run" \
            runs $compiler $num
    done
done

# the same function by the C calls and by loft.hpp
cat > "$work/c.cpp" <<'C'
#include "loft.h"
extern volatile loft_real pin[2];
#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y) } }
static const loft_vec p[4] = { XY(0, 0), XY(1, 2), XY(3, 2), XY(4, -1) };
bool draw();
bool draw()
{
    loft_bezier curve;
    loft_forward walk;
    loft_vec at;
    if (loft_bezier_init(&curve, p, 3) != LOFT_OK ||
        loft_forward_init(&walk, &curve, 64) != LOFT_OK)
        return false;
    while (loft_forward_next(&walk, &at)) {
        pin[0] = at.axis[0];
        pin[1] = at.axis[1];
    }
    return true;
}
C
cat > "$work/cpp.cpp" <<'C'
#include "loft.hpp"
extern volatile loft_real pin[2];
static const loft::point p[4] = { { 0, 0 }, { 1, 2 }, { 3, 2 }, { 4, -1 } };
bool draw();
bool draw()
{
    const loft::bezier curve(p);
    if (!curve)
        return false;
    for (const loft::vec &at : curve.walk(64)) {
        pin[0] = at[0];
        pin[1] = at[1];
    }
    return true;
}
C
text() {        # text NAME COMPILER..: bytes of code and constants
    local name=$1; shift
    "$@" -std=c++17 -Os -fno-exceptions -fno-rtti -ffunction-sections -Wall -Werror -Ilib \
        -Iports/packages/cpp -c "$work/$name.cpp" -o "$work/$name.o" || return
    "${1%g++}size" -A "$work/$name.o" | awk '/^\.text|^\.rodata/ { n += $2 } END { print n }'
}
no_cost() {     # no_cost BYTES COMPILER..: how many more there may be
    local more=$1 c cpp
    shift
    c=$(text c "$@") && cpp=$(text cpp "$@") || return
    echo "     $c bytes by the C calls, $cpp by loft.hpp" > "$work/bytes"
    cat "$work/bytes"
    [ "$cpp" -le $((c + more)) ]
}
verdict "Cortex-M0+ -Os: at most 8 bytes more than the C calls" no_cost 8 \
    arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb
cat "$work/bytes"
verdict "x86-64 -Os: at most 24 bytes more than the C calls" no_cost 24 g++
cat "$work/bytes"
ended
