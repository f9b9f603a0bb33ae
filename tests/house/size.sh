#!/bin/sh
# tests/house/size.sh -- print bytes of text and worst stack per function of lib/, per module, for
# four microcontrollers
# SPDX-License-Identifier: MIT
# usage: tests/house/size.sh [NUM [AXES]]   (q16 and 3); -Os, without what libgcc adds
set -u
. tests/target/targets.sh
num=${1:-q16} axes=${2:-3}
[ -z "$(missing_tools)" ] || { missing_tools; exit 1; }
[ "$num" = q16 ] || targets=$(echo "$targets" | sed 's/atmega328p//')

measure() {     # measure TARGET: lines `target object text data stack function`
    out=build/cross/$1-${num}x$axes
    compile_lib "$1" "$num" "$axes" >&2
    for o in "$out"/*.o; do
        case $o in */ports-*) continue ;; esac
        bytes=$("$(binutil "$1" size)" "$o" | awk 'NR == 2 { print $1, $2 + $3 }')
        worst=$(sort -t"$(printf '\t')" -k2,2nr "${o%.o}.su" |
            awk -F'\t' 'NR == 1 { n = split($1, f, ":"); print $2, f[n] }
                        END { if (!NR) print 0, "-" }')
        echo "$1 $(basename "$o" .o | sed 's|-|/|') $bytes $worst"
    done
}

for t in $targets; do measure "$t"; done |
    awk -v targets="$targets" -v build="$num, $axes axes, -Os" '
    function part(name, width) { printf " | %-*s", width, name }
    { if (!($2 in seen)) { seen[$2] = 1; order[++modules] = $2 }
      text[$2, $1] = $3; data[$1] += $4; stack[$2, $1] = $5
      total[$1] += $3; if ($5 > worst[$1]) { worst[$1] = $5; in_function[$1] = $6 } }
    END {
        n = split(targets, t, " ")
        printf "%-20s", build;           for (i = 1; i <= n; i++) part(t[i], 13); print ""
        printf "%-20s", "module"
        for (i = 1; i <= n; i++) part("  text  stack", 13)
        print ""
        for (m = 1; m <= modules; m++) {
            printf "%-20s", order[m]
            for (i = 1; i <= n; i++)
                printf " | %6d %6d", text[order[m], t[i]], stack[order[m], t[i]]
            print ""
        }
        printf "%-20s", "lib, all"
        for (i = 1; i <= n; i++) printf " | %6d %6d", total[t[i]], worst[t[i]]
        print ""
        printf "%-20s", "writable data"
        for (i = 1; i <= n; i++) printf " | %6d       ", data[t[i]]
        print ""
        print "stack: the largest frame of any function; the worst is"
        for (i = 1; i <= n; i++)
            printf "  %-12s %5d bytes in %s\n", t[i], worst[t[i]], in_function[t[i]]
    }'
