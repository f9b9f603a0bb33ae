#!/bin/bash
# tests/packages/host.sh -- libloft-host, installed: the program of host-tools/USE.md, outside of
# the tree, draws on a simulated machine
# SPDX-License-Identifier: MIT
# usage: tests/packages/host.sh
row=host
. tests/packages/row.sh
needs cc pkg-config nm
loft=$top/build/loft out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export PKG_CONFIG_PATH=$work/root/lib/pkgconfig
installed() { make -s install-lib tools LIBRARIES=loft-host PREFIX="$work/root"; }
verdict "make install-lib LIBRARIES=loft-host" installed

# what may be seen of it, and what it leaves to its program
seen() {
    nm "$work/root/lib/libloft-host.a" 2>/dev/null > "$work/names"
    ! grep ' [TDBRW] ' "$work/names" | grep -v ' T loft_host_' &&
        [ "$(grep -c ' T loft_host_' "$work/names")" -gt 30 ]
}
verdict "libloft-host.a shows its own functions and nothing else" seen
left() {
    local ends='_?exit|_Exit|abort|atexit' prints='stdin|stdout|stderr|v?printf|puts|putchar|perror'
    ! grep -wE " U ($ends|$prints|signal|sigaction|isatty|u?sleep|nanosleep|select)" \
        "$work/names" && ! grep -nE '\bpoll\(' "$top"/host-tools/{send,library}/*.c | grep -v ', 0)'
}
verdict "it never ends a program, prints, waits, or takes signals and the terminal" left

page() { awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' "$top/host-tools/USE.md"; }
short() { page > "$out/draw.c" && [ "$(wc -l < "$out/draw.c")" -le 40 ]; }
verdict "USE.md: the program has at most 40 lines" short
cd "$out" || exit
built() { cc -Wall -Wextra -Werror draw.c $(pkg-config --cflags --libs loft-host) -o draw; }
verdict "USE.md: the program, compiled outside of the tree by pkg-config" built
cxx() {
    echo '#include <loft/host.h>
int main() { loft_host_close(loft_host_open(new loft_host_calls())); }' > open.cc
    c++ -Wall -Wextra -Werror open.cc $(pkg-config --cflags --libs loft-host) -o open && ./open
}
verdict "loft/host.h in C++" cxx

machine() {     # machine NAME: one job, at the speed of this computer
    "$loft" simulate --link "$out/$1" --record "$out/$1.csv" --speed fast --once \
        > "$out/$1.log" 2>&1 &
    pid=$!
    appears "$out/$1"
}
steps() { grep -v '^#\|^slot' "$out/$1.csv"; }
draws() {       # draws NAME COMMAND..: the machine ends with its job, or is ended
    machine "$1" && timeout 300 "${@:2}" || { kill "$pid"; return 1; }
    wait "$pid"
}
drawn() {       # drawn DRAWING: the steps that it says were counted; the command makes the same
    draws mine ./draw "$1" mine > said || { cat said; return 1; }
    draws theirs "$loft" stream "$1" --order best --feed 40 --port theirs || return
    cat said; steps mine | tail -1
    [ "$(cat said)" = "steps $(steps mine | tail -1 | cut -d, -f2- | tr ',' ' ')" ] &&
        [ "$(steps mine | wc -l)" -gt 1000 ] && cmp <(steps mine) <(steps theirs)
}
cat > part.svg <<'E'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">
  <circle cx="40" cy="20" r="9"/><path d="M2 2C20 2 2 20 20 20M25 5h6v3z"/>
  <rect width="9" height="5"/>
</svg>
E
verdict "it draws a file: each pulse as of loft stream, the last where it says" drawn part.svg
halted() { until grep -q "$1" "$out/mine.log"; do kill -0 "$pid" || return; sleep 0.02; done; }
goes_on() {     # killed in the middle of a job and run again, it draws each step once
    "$loft" simulate --link "$out/mine" --record "$out/mine.csv" --halt 1500 \
        > "$out/mine.log" 2>&1 &
    pid=$!
    appears "$out/mine" && { ./draw part.svg mine > said 2>&1 & }
    local killed=$!
    halted 'halted at tick 1500'
    kill -9 "$killed"; wait "$killed"
    kill -USR2 "$pid"
    timeout 300 ./draw part.svg mine > said; code=$?; cat said
    kill "$pid"; wait "$pid"
    [ "$code" = 0 ] && cmp <(steps mine | cut -d, -f2-) <(steps theirs | cut -d, -f2-)
}
verdict "killed in a job and run again, it goes on: the same steps" goes_on
printf 'G21 G90\nG0 X5 Y5\nG1 X60 Y20 F1200\nG2 X80 Y40 I0 J20\nG1 X5 Y5\n' > part.nc
refused() {     # an error is told with its name, and the code comes back
    ./draw missing.svg /dev/null 2> said; code=$?; cat said
    [ "$code" = 66 ] && grep -q '^file.missing: no such file: check the name$' said || return
    ./draw part.nc /dev/null 2> said; code=$?; cat said
    [ "$code" = 64 ] && grep -q '^order.program: ' said
}
verdict "errors have a name, a remedy and a code" refused
ended
