#!/bin/bash
# tests/packages/tool.sh -- the command without the libraries that may be left out
# SPDX-License-Identifier: MIT
# usage: tests/packages/tool.sh
row=tool
. tests/packages/row.sh
needs musl-gcc

# what is left out is refused in one line, and the rest works
without=$work/without/loft
none="cairo geos libserialport ncurses libwebsockets"
built() { make -s tools WITHOUT="$none" TOOL_OUT="$work/without"; }
verdict "make tools WITHOUT=\"$none\"" built
free() { ! ldd "$without" | grep -E 'cairo|geos|serialport|ncurses|websockets|json-c'; }
verdict "it is linked with none of them" free
refuses() {     # refuses WORD ARGUMENT..: with the code 69 and one line that has the word
    local word=$1 said
    shift
    said=$("$without" "$@" 2>&1 >/dev/null </dev/null)
    [ $? = 69 ] && [ "$(echo "$said" | wc -l)" = 1 ] && echo "$said" | grep -q "without $word"
}
verdict "loft plot is refused, with the cause" refuses cairo plot tests/drawings/demo.svg
echo '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h9v9z"/></svg>' >"$work/filled.svg"
verdict "contour fills are refused, with the cause" refuses geos plan "$work/filled.svg" \
    --fill contour
verdict "loft ports is refused, with the cause" refuses libserialport ports
verdict "loft serve is refused, with the cause" refuses libwebsockets serve --listen 127.0.0.1:0
view() {        # on a terminal
    ! script -qec "'$without' stream tests/drawings/demo.svg --port /dev/null --view" /dev/null |
        grep -v "without ncurses"
}
verdict "loft stream --view is refused, with the cause" view
streams() {     # a whole job on the simulated machine
    "$without" simulate --once --quiet --link "$work/machine" & local machine=$!
    appears "$work/machine"
    if echo 0,0,1,2,3,2,4,0 | timeout 600 "$without" stream - --port "$work/machine"; then
        wait $machine
    else                            # nothing is left running
        kill $machine
        wait $machine
        false
    fi
}
verdict "loft stream draws on the simulated machine" streams

# Debian has no libraries for musl: every source is compiled with its headers, nothing is linked
on_musl() {
    local sources
    mkdir -p "$work/include" && cp -r /usr/include/{unicode,zlib.h,zconf.h} "$work/include" &&
        sources=$(make -s WITHOUT="$none" print-tool-sources) &&
        [ -n "$sources" ] &&
        for source in $sources; do
            musl-gcc -std=c99 -Wall -Wextra -Werror -D_GNU_SOURCE -DLOFT_WITHOUT_CAIRO -Ilib \
                -Ihost-tools -Iports -isystem "$work/include" -isystem /usr/include/libxml2 \
                -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=3 -fsyntax-only "$source" || return 1
        done
}
verdict "musl: every source of the command compiles (not linked: no libxml2 for musl)" on_musl
ended
