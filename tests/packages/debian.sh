#!/bin/bash
# tests/packages/debian.sh -- the Debian package: dpkg-buildpackage, lintian, what is in it
# SPDX-License-Identifier: MIT
# usage: tests/packages/debian.sh
row=debian
. tests/packages/row.sh
needs dpkg-buildpackage lintian dh
version=$(version) so=$(version | cut -d. -f1,2)
case $so in 0.*) ;; *) so=${so%.*} ;; esac
unpacked() {
    make -s dist && tar -xf "build/dist/loft-$version.tar.gz" -C "$work" &&
        cp "build/dist/loft-$version.tar.gz" "$work/loft_$version.orig.tar.gz" &&
        VERSION=$version SOVERSION=$so sh ports/packages/debian/debian.sh "$work/loft-$version"
}
DATE=$(sed -n "s/^## \[$version\] - //p" CHANGELOG.md)
export DATE
verdict "debian/ in the tree of make dist" unpacked
cd "$work/loft-$version" || exit
packed() { dpkg-buildpackage -us -uc -j2 -d; }
verdict "dpkg-buildpackage, with make check-quick" packed
clean() {
    lintian --allow-root --fail-on warning,error --pedantic \
        --suppress-tags initial-upload-closes-no-bugs "$work"/loft_*.changes
}
verdict "lintian --pedantic: no error, no warning but of the bug that an upload closes" clean
cd "$work" || exit
holds() {       # holds PACKAGE PATTERN..: does it have these files?
    local package=$1; shift
    dpkg -c "$package"_*.deb > list || return
    for pattern in "$@"; do grep -qE "$pattern" list || { echo "$pattern"; return 1; }; done
}
verdict "loft has the command, man pages, completions" holds loft ' ./usr/bin/loft$' \
    'man1/loft-stream.1.gz' 'completions/loft$' '/_loft$' 'loft.fish$'
verdict "libloft-dev has headers, archives, pkg-config, CMake" holds libloft-dev \
    'include/loft/curve/bezier.h' 'libloft-f32.a' 'loft-f64.pc' 'loft-config.cmake'
verdict "libloft-surfaces-dev has the same of surfaces" holds libloft-surfaces-dev \
    'loft/loft/surfaces.h' 'libloft-surfaces-f32.a' 'loft-surfaces-f64.pc' \
    'loft-surfaces-config.cmake'
symbols() {
    dpkg -e libloft-q16-"$so"_*.deb control && cat control/symbols &&
        grep -q "^libloft-q16.so.$so libloft-q16-$so" control/symbols
}
verdict "libloft-q16-$so has a symbols file" symbols
# a program from the packages' files alone
runs() {
    for deb in *.deb; do dpkg -x "$deb" root || return; done
    local lib
    lib=$(dirname "$(find root -name 'libloft-q16.a')")
    gcc -Iroot/usr/include/loft -DLOFT_NUM=LOFT_Q16 "$top/tests/packages/user.c" -L"$lib" \
        -lloft-q16 -o user &&
        [ "$(LD_LIBRARY_PATH=$lib ./user)" = "64 points, 262144 -65536, loft $version" ] &&
        LD_LIBRARY_PATH=$lib root/usr/bin/loft --version
}
verdict "a program with the packages' files, built and run" runs
ended
