#!/bin/bash
# tests/packages/install.sh -- make install, uninstall; a program from the installed tree alone
# SPDX-License-Identifier: MIT
# usage: tests/packages/install.sh
row=install
. tests/packages/row.sh
needs mandoc zsh fish bash pkg-config
root=$work/root
expected="64 points, 262144 -65536, loft $(version)"
loft=$root/bin/loft

installed() { make -s install PREFIX="$root" LIBDIR="$root/lib/multi"; }
verdict "make install PREFIX= LIBDIR=" installed
cd "$work" || exit

# from the installed tree alone: no header of the clone is named
runs() {        # runs COMPILER NUM how: shared or static
    local flags libs said
    export PKG_CONFIG_PATH=$root/lib/multi/pkgconfig
    flags=$(pkg-config --cflags "loft-$2") || return
    libs=$(pkg-config --libs "loft-$2")
    [ "$3" = shared ] || libs=$root/lib/multi/libloft-$2.a
    $1 $flags "$top/tests/packages/user.c" $libs -o "user-$2-$3" || return
    said=$(LD_LIBRARY_PATH=$root/lib/multi "./user-$2-$3"); echo "$said"
    [ "$said" = "$expected" ]
}
for num in q16 f32 f64; do
    verdict "gcc, pkg-config loft-$num, shared: built and run" runs gcc $num shared
    verdict "gcc, libloft-$num.a: built and run" runs gcc $num static
done
hill() {        # a program of patches: loft-surfaces-q16 brings libloft-q16
    export PKG_CONFIG_PATH=$root/lib/multi/pkgconfig
    gcc $(pkg-config --cflags loft-surfaces-q16) "$top/lib/examples/grid.c" \
        $(pkg-config --libs loft-surfaces-q16) -o hill &&
        LD_LIBRARY_PATH=$root/lib/multi ./hill | grep -q '^  0.00  6.06  9.69'
}
verdict "gcc, pkg-config loft-surfaces-q16, shared: built and run" hill
verdict "musl-gcc, libloft-q16.a, no libc of Debian: built and run" \
    runs "musl-gcc -static" q16 static

soname() {      # of each library, from the version in loft.h
    local major minor so
    major=$(version_of MAJOR) minor=$(version_of MINOR)
    so=$major; [ "$major" != 0 ] || so=$major.$minor
    for name in libloft{,-surfaces}-{q16,f32,f64}; do
        objdump -p "$root/lib/multi/$name.so" | grep -q "SONAME *$name.so.$so$" &&
            [ -e "$root/lib/multi/$name.so.$so" ] || return
    done
}
version_of() { sed -n "s/^#define LOFT_VERSION_$1 //p" "$top/lib/loft.h"; }
verdict "sonames follow LOFT_VERSION" soname

symbols() {     # exactly the functions of names.h, each of the version of the interface
    for library in libloft libloft-surfaces; do for num in q16 f32 f64; do
        nm -D --defined-only "$root/lib/multi/$library-$num.so" |
            sed -n "s/.* T \(loft_[a-z0-9_]*\)_${num}x3@@LOFT_.*/\1/p" | LC_ALL=C sort > "$num.have"
        nm "$top/build/${num}x3/$library.a" 2>/dev/null |
            sed -n "s/.* T \(loft_[a-z0-9_]*\)_${num}x3$/\1/p" | LC_ALL=C sort -u > "$num.want"
        [ "$(wc -l < "$num.have")" -gt 300 ] && diff "$num.want" "$num.have" || return
        nm -D --defined-only "$root/lib/multi/$library-$num.so" | grep -v ' T loft_\| A LOFT_' &&
            return 1
    done; done
    true
}
verdict "shared libraries export the functions of lib/ and nothing else" symbols

bare() { ! nm -D --undefined-only "$root/lib/multi/libloft-q16.so" |
    grep -vE ' (w .*|U (memcpy|memset|memmove)(@.*)?)$'; }
verdict "libloft-q16.so needs memcpy and memset of a libc, and nothing else" bare

# man pages and completions
pages() {
    [ "$(ls "$root/share/man/man1" | wc -l)" -gt 12 ] &&
        mandoc -T lint -W warning "$root"/share/man/man1/*.1 &&
        for page in "$root"/share/man/man1/*.1; do
            groff -man -ww -z -Tutf8 "$page" 2>&1 | grep . && return 1
        done
    mandoc -T ascii "$root/share/man/man1/loft-stream.1" | col -b | grep -q -- '--feed SPEED'
}
verdict "man pages: mandoc -T lint and groff -ww have nothing to say" pages
every_option() {        # each option of each command's help stands in its page
    "$loft" --help | sed -n 's/^  \([a-z]*\) .*/\1/p' | while read -r name; do
        "$loft" "$name" --help | sed -n '/^options:/,$s/^  --\([a-z0-9-]*\).*/\1/p' |
            while read -r option; do
                sed 's/\\-/-/g' "$root/share/man/man1/loft-$name.1" |
                    grep -qF "\fB--$option\fR" || echo "$name --$option"
            done
    done | { ! grep .; }
}
verdict "man pages have every option of --help" every_option

in_bash() {     # in_bash WORD..: what it offers for the last one
    bash -c '. "$1"; shift
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
        _loft; printf "%s " "${COMPREPLY[@]}"' \
        - "$root/share/bash-completion/completions/loft" "$@"
}
by_bash() {
    [ "$(in_bash loft st)" = "stream study " ] &&
        [ "$(in_bash loft plan --mach)" = "--machine " ] &&
        [ "$(in_bash loft stream --num f)" = "f32 f64 " ] &&
        [ "$(in_bash loft stream --plan '')" = "host chip " ] &&
        [ -z "$(in_bash loft stream --feed 3 | tr -d ' ')" ] &&
        [ "$(in_bash loft help compa)" = "compare " ]
}
verdict "bash completes commands, options and their words" by_bash
by_fish() {
    offered() {
        fish -c "source $root/share/fish/vendor_completions.d/loft.fish; complete -C '$1'" |
        cut -f1 | LC_ALL=C sort | paste -sd' '; }
    [ "$(offered 'loft st')" = "stream study" ] &&
        [ "$(offered 'loft plan --mach')" = "--machine" ] &&
        [ "$(offered 'loft stream --num f')" = "f32 f64" ]
}
verdict "fish completes commands, options and their words" by_fish
# zsh in a pseudo terminal of its own, with TAB pressed
by_zsh() { timeout 600 zsh -f "$top/tests/packages/complete.zsh" "$root/share/zsh/site-functions"; }
verdict "zsh completes commands, options and their words" by_zsh

removed() {
    (cd "$top" && make -s uninstall PREFIX="$root" LIBDIR="$root/lib/multi") &&
        [ -z "$(find "$root" ! -type d)" ]
}
verdict "make uninstall leaves no file" removed
ended
