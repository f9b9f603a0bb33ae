#!/bin/sh
# tests/house/examples.sh -- run the programs of lib/examples, link the files of lib/RECIPES.md
# SPDX-License-Identifier: MIT
# usage: tests/house/examples.sh BUILD ; libloft.a and libloft-surfaces.a of BUILD/{q16,f32,f64}x3
# must exist
# It calls itself for parallel work: examples.sh BUILD linked RECIPE
set -u
build=$1 work=$1/examples most=40 page=lib/RECIPES.md
result=$work/result
macro() { echo "LOFT_$(echo "$1" | tr a-z A-Z)"; }

# --- recipes: the functions of each need the files that it lists, no more and no less
recipe() {      # recipe NUMBER: its part of the page
    awk -v wanted="$1" '/^##+ / { on = /^### / && ++number == wanted } on' $page
}
functions() { grep -o '`loft_[a-z0-9_]*`' | tr -d '`' | LC_ALL=C sort -u; }
files() {
    awk '/^```text$/ { on = 1; next } /^```$/ { on = 0 } on' | tr -s ' ' '\n' | LC_ALL=C sort
}
caller() {      # caller HEADER FUNCTION..: a program that needs each of them
    echo "#include \"$1\""
    shift
    echo 'typedef void (*any)(void);'
    echo 'extern const any all[];'
    echo 'const any all[] = {'
    for name in "$@"; do echo "    (any)$name,"; done
    echo '};'
    echo 'int main(void) { return all[0] == 0; }'
}
taken() {       # taken SOURCE NUM: files that the linker takes from the library, by its trace
    given="${CPPFLAGS:-} ${CFLAGS:-} ${LDFLAGS:-}"
    ${CC:-cc} -std=c99 -Ilib $given -DLOFT_NUM="$(macro "$2")" -DLOFT_AXES=3 \
        "$1" "$build/${2}x3/libloft-surfaces.a" "$build/${2}x3/libloft.a" -Wl,-t,-t \
        -o "${1%.c}" > "${1%.c}.trace" || return
    sed -n 's/^.*libloft[a-z-]*\.a[()]\([a-z0-9_]*\)\.o)*$/\1.c/p' "${1%.c}.trace"
}
linked() {      # linked NUMBER: in all number types together
    title=$(recipe "$1" | sed -n '1s/^### //p')
    source=$work/recipe$1.c
    recipe "$1" | files > "$work/recipe$1.listed"
    header=loft.h               # one that needs no file of surfaces needs no header of them
    ! grep -qE '^(surface|polygon|toolpath)/' "$work/recipe$1.listed" || header=loft/surfaces.h
    caller $header $(recipe "$1" | functions) > "$source"
    for num in q16 f32 f64; do taken "$source" $num || echo "$num does not link"; done |
        LC_ALL=C sort -u > "$work/recipe$1.names"
    while read -r name; do
        find lib -name "$name" ! -path 'lib/examples/*' | sed 's/^lib\///' | grep . || echo "$name"
    done < "$work/recipe$1.names" | LC_ALL=C sort > "$work/recipe$1.taken"
    if [ -s "$work/recipe$1.listed" ] && diff "$work/recipe$1.listed" "$work/recipe$1.taken"
    then echo "ok   recipe: $title"
    else echo "FAIL recipe: $title: < is listed, > is what its functions need"
    fi
}
if [ $# -gt 1 ]; then shift; "$@"; exit; fi

# --- programs
mkdir -p "$work"
expected() {    # expected SOURCE: the lines of its last comment
    awk '/^\/\* prints$/ { on = 1; next }
         / \*\/$/ { on = 0 }
         on && /^ \* / { print substr($0, 8) }' "$1"
}
short() {       # short SOURCE: is the program before that comment short enough?
    lines=$(awk '/^\/\* prints$/ { exit } /./ { last = NR } END { print last }' "$1")
    if [ "$lines" -le $most ]; then echo "ok   $1 has $lines lines"
    else echo "FAIL $1 has $lines lines, at most $most are allowed"; fi
}
programs() {    # one command to a line
    for source in lib/examples/*.c; do
        wanted=$work/$(basename "$source" .c).expected
        expected "$source" > "$wanted"
        surfaces=$(grep -c '"loft/surfaces.h"' "$source")
        for num in q16 f32 f64; do
            library=$build/${num}x3/libloft.a
            [ "$surfaces" = 0 ] || library="$build/${num}x3/libloft-surfaces.a $library"
            echo "sh tests/house/example.sh '$source in $num' $source $wanted $work/$num" \
                 "$library -DLOFT_NUM=$(macro $num) -DLOFT_AXES=3"
        done
    done
}

for source in lib/examples/*.c; do short "$source"; done | tee "$result"
recipes=$(grep -c '^### ' $page)
{ programs
  for number in $(seq "$recipes"); do echo "sh tests/house/examples.sh $build linked $number"; done
} | bash tests/house/beside.sh | tee -a "$result"
passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
[ "$recipes" -ge 20 ] && [ "$passed" -ge $((8 * 4 + recipes)) ] ||
    { echo "FAIL less than 8 programs in 3 number types and 20 recipes"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
