#!/bin/sh
# tests/house/cross.sh -- checks lib/ for every microcontroller: the properties that firmware needs
# SPDX-License-Identifier: MIT
# Four checks per target, number type and number of axes, each a line `ok` or `FAIL` with places:
# lib/ compiles without a warning; it has no writable data; it needs only the compiler's own helpers
# and memcpy, memset; and code that runs in an interrupt calls no shift, product or quotient of 64
# bits that is a loop on that core. Six cells differ most: each core in q16, floats with a unit for
# them, doubles without one. ALL=1 checks all twelve.
set -u
. tests/target/targets.sh
[ -z "$(missing_tools)" ] || { missing_tools; echo "0 passed, 1 failed"; exit 1; }

# functions that may run in an interrupt, and the helpers that cost too much there
hot="loft_forward_next loft_forward_run loft_forward_exact_next loft_rational_walk_next"
hot="$hot loft_pace_next loft_step_load loft_step_next loft_step_take loft_step_give"
hot="$hot loft_drive_slot loft_drive_take"
slow='u?divdi3|u?moddi3|u?divmoddi4|ashldi3|ashrdi3|lshrdi3'
slow="^__($slow|aeabi_u?ldivmod|aeabi_lls[lr]|aeabi_lasr)\$"
slow_avr='^__(u?divdi3|u?moddi3|muldi3.*|umulsidi3|mulsidi3|ashldi3|ashrdi3|lshrdi3)$'

check() {       # check NAME: standard input lists what is wrong
    places=$(cat)
    if [ -z "$places" ]; then echo "ok   $1"
    else echo "FAIL $1"; echo "$places" | head -20 | sed 's/^/     /'; fi
}

symbols() {     # symbols DIRECTORY TARGET LETTERS: object, letter and name of those kinds
    for o in "$1"/*.o; do
        case $o in */ports-*) continue ;; esac          # a port may have data, and uses its board
        "$(binutil "$2" nm)" "$o" |
            awk -v o="$(basename "$o")" -v want="^[$3]$" '$(NF-1) ~ want { print o, $(NF-1), $NF }'
    done
}

# calls DIRECTORY TARGET: lines `caller callee`; every function has a section of its own
calls() {
    "$(binutil "$2" objdump)" -dr "$1"/*.o | awk '
        /^[0-9a-f]+ <.*>:$/   { from = substr($2, 2, length($2) - 3) }
        /[ \t]R_[A-Z0-9_]+\t/ { to = $NF
                                sub(/[-+]0x.*/, "", to); sub(/^\.text\.(unlikely\.)?/, "", to)
                                if (to != from && to !~ /^\./) print from, to }' | sort -u
}

slow_in_interrupts() {
    case $2 in atmega*) slow=$slow_avr ;; esac
    calls "$1" "$2" | awk -v hot="$hot" -v slow="$slow" -v tag="$3" '
        { callees[$1] = callees[$1] " " $2; known[$1] = 1 }
        END {
            n = split(hot, entry, " ")
            for (i = 1; i <= n; i++) {
                count = 0
                queue[++count] = entry[i] "_" tag; path[queue[1]] = entry[i]
                split("", seen)
                for (q = 1; q <= count; q++) {
                    m = split(callees[queue[q]], c, " ")
                    for (j = 1; j <= m; j++) {
                        if (seen[c[j]]++) continue
                        path[c[j]] = path[queue[q]] " > " c[j]
                        if (c[j] ~ slow) print path[c[j]]
                        else if (known[c[j]]) queue[++count] = c[j]
                    }
                }
            }
        }'
    for f in $hot; do       # a name that does not exist would pass unnoticed
        "$(binutil "$2" nm)" "$1"/*.o | grep -q " T ${f}_$3\$" || echo "$f: no such function"
    done
}

one() {         # one TARGET NUM AXES
    out=build/cross/$1-$2x$3 what="$1 $2 x$3"
    compile_lib "$1" "$2" "$3" | check "$what compiles"
    symbols "$out" "$1" BbDdCGgSs | check "$what has no writable data"
    symbols "$out" "$1" TtWVRr | awk '{ print $3 }' | sort -u >"$out/defined"
    symbols "$out" "$1" U | grep -vwFf "$out/defined" | grep -vE ' (__[a-z0-9_]+|memcpy|memset)$' |
        check "$what needs only the compiler's helpers"
    [ "$2" != q16 ] || slow_in_interrupts "$out" "$1" "$2x$3" | check "$what has fast interrupts"
}

if [ $# -gt 0 ]; then one "$@"; exit; fi          # in parallel: it calls itself
result=$(mktemp); trap 'rm -f "$result"' EXIT
cells="m0plus-q16-3 m4-q16-3 atmega328p-q16-3 rv32imac-q16-3 m4-f32-3 m0plus-f64-3"
others="atmega328p-q16-1 atmega328p-q16-6 m0plus-f32-3 m4-f64-3 rv32imac-f32-3 rv32imac-f64-3"
if [ -n "${ALL:-}" ]; then cells="$cells $others"
else echo "left to make check-all: $others"; fi
for cell in $cells; do echo "sh tests/house/cross.sh $(echo "$cell" | tr - ' ')"; done |
    bash tests/house/beside.sh | tee "$result"
passed=$(grep -c '^ok' "$result") failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
