#!/bin/bash
# tests/house/footprint.sh -- flash and RAM of what firmware typically takes of lib/, per chip,
# beside the table of lib/COSTS.md: what grew, what shrank
# SPDX-License-Identifier: MIT
# usage: tests/house/footprint.sh [write]   ; write: puts the measured table into the page
# Flash: the functions and all that they call, memcpy and the compiler's arithmetic too, at -Os in
# q16 with three axes. RAM: their structs.
set -u
write=${1:-}
. tests/target/targets.sh
page=lib/COSTS.md out=build/footprint chips="m0plus m4 atmega328p rv32imac"
[ -z "$(missing_tools)" ] || { missing_tools; echo "0 passed, 1 failed"; exit 1; }

# what is taken | its functions, without loft_ | its structs
selections='a point of a cubic|cubic_eval|cubic
walk a curve exactly|bezier_init forward_init forward_next|bezier forward
flatten a cubic for a display|flatten_init flatten_next|flatten
flatten a drawing in flash|drawing_begin drawing_next flatten_init flatten_next|drawing_walk flatten
y at x, without overshoot|monotone_init monotone_eval|monotone
easing as in CSS|tween_init tween_eval|tween
one axis to a target|scurve_init scurve_eval|scurve
the same, retargeted while it moves|scurve_init scurve_eval scurve_retarget|scurve
a natural spline|natural_init cubic_from_natural|natural
a NURBS curve|nurbs_init nurbs_eval|nurbs
steps and hold|step_init step_load step_next pace_init pace_aim pace_next|step pace
frames of a line|frame_encode frame_init frame_push|frame
look-ahead with limited jerk|plan_init plan_push plan_end plan_next|plan
a ball over a patch, line by line|lines_init lines_next|lines'

mkdir -p "$out"
built() {       # built CHIP: its objects, those of `make check-cross`, and the sizes of structs
    local wrong
    wrong=$(compile_lib "$1" q16 3)
    [ -z "$wrong" ] || { echo "$wrong"; return 1; }
    {   echo '#include "loft/surfaces.h"'
        echo "$selections" | cut -d'|' -f3 | tr ' ' '\n' | sort -u |
            sed 's/.*/char size_&[sizeof(loft_&)];/'
    } > "$out/$1.c"
    $(compiler "$1") -std=c99 -ffreestanding -fno-common -Ilib -c "$out/$1.c" -o "$out/$1.o"
}
measured() {    # measured CHIP FUNCTIONS STRUCTS: `flash RAM`
    local wanted='' first ram=0 objects=build/cross/$1-q16x3 library
    library="$objects/ports-bare-memory.o -lgcc"
    [ "$1" != atmega328p ] || library='-lc -lgcc'
    for f in $2; do wanted="$wanted -Wl,-u,loft_${f}_q16x3"; first=${first:-loft_${f}_q16x3}; done
    $(compiler "$1") -nostdlib -nostartfiles -Wl,--gc-sections -Wl,--entry="$first" $wanted \
        $(ls "$objects"/*.o | grep -v /ports-) $library -o "$out/linked" || return
    for s in $3; do
        size=$($(binutil "$1" nm) -S "$out/$1.o" | awk -v s="size_$s" '$4 == s { print $2 }')
        ram=$((ram + 0x$size))
    done
    $(binutil "$1" size) "$out/linked" | awk -v chip="$1" -v ram=$ram 'NR == 2 {
        if (chip != "atmega328p" || ($1 + $2 <= 32768 && ram <= 2048)) print $1 + $2, ram
        else print "will not fit" > "/dev/stderr" }'
}
thousands() { echo "$1" | sed -E ':a; s/([0-9])([0-9]{3})($|,)/\1,\2\3/; ta'; }

cell() {        # cell [FLASH RAM]
    if [ $# = 2 ]; then echo "$(thousands "$1"); $(thousands "$2")"; else echo -; fi
}
same() {        # same `FLASH;RAM` [FLASH RAM]: within 1 %, and 8 bytes; - where it does not fit
    local said=$1 more
    [ $# = 3 ] || { [ "$said" = - ] && grep -q 'will not fit' "$out/log"; return; }
    case $said in *[!0-9\;]*|\;*) return 1 ;; esac
    more=$(($2 - ${said%;*}))
    [ ${more#-} -le $((${said%;*} / 100 + 8)) ] && [ "$3" = "${said#*;}" ]
}

for chip in $chips; do built $chip || { echo "0 passed, 1 failed"; exit 1; }; done
passed=0 failed=0
: > "$out/table"
while IFS='|' read -r name functions structs; do
    line="| $name |" column=1
    for chip in $chips; do
        column=$((column + 1))
        set -- $(measured $chip "$functions" "$structs" 2>"$out/log")
        line="$line $(cell "$@") |"
        [ "$write" != write ] || continue
        said=$(sed -n "s/^| $name |/&/p" $page | cut -d'|' -f$((column + 1)) | tr -d ' ,')
        if same "${said:-nothing}" "$@"; then passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAIL $name, $chip: $(cell "$@"), the page says ${said:-nothing}: look why, then" \
                "make footprint"
        fi
    done
    echo "$line" | tee -a "$out/table"
done <<< "$selections"
if [ "$write" = write ]; then
    awk -v table="$out/table" '
        /^\| selection \|/ {
            print; getline; print
            while ((getline l < table) > 0) print l
            skip = 1
            next
        }
        skip && /^\|/ { next }
        { skip = 0; print }' $page > "$out/page" && cp "$out/page" $page
    exit
fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]
