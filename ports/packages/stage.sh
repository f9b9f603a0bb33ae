#!/bin/sh
# ports/packages/stage.sh -- lay out what is installed: FOLDER/include, lib, bin, share
# SPDX-License-Identifier: MIT
# usage: stage.sh FOLDER [COMMAND]   with VERSION SOVERSION DATE AXES NUMS INCLUDEDIR LIBDIR set,
# LOFT_ROOMS and SURFACES_ROOMS, and LIBRARIES: some of loft, loft-surfaces, loft-host; for the last
# one its archive HOST_LIBRARY and what it needs, HOST_PKG
# With COMMAND, the command loft that was built: bin and share too. Same input, same bytes.
set -eu
stage=$1 command=${2:-}
macro() { echo "LOFT_$(echo "$1" | tr a-z A-Z)"; }
filled() {      # filled FILE [NAME NUM WHAT NEEDS]: with the places that @..@ stands for
    sed -e "s|@VERSION@|$VERSION|g; s|@INCLUDEDIR@|$INCLUDEDIR|g; s|@LIBDIR@|$LIBDIR|g" \
        -e "s|@AXES@|$AXES|g; s|@NAME@|${2:-}|g; s|@NUM@|${3:-}|g; s|@WHAT@|${4:-}|g" \
        -e "s|@NEEDS@|${5:-}|g; /^Requires: *\$/d" "$1"
}
has() { case " $LIBRARIES " in *" $1 "*) ;; *) return 1 ;; esac; }

rm -rf "$stage"
mkdir -p "$stage/lib/pkgconfig"
headers() {     # headers PLACE..: files and folders of lib/
    (cd lib && find "$@" -name '*.h') | LC_ALL=C sort | while read -r header; do
        mkdir -p "$stage/include/loft/$(dirname "$header")"
        cp "lib/$header" "$stage/include/loft/$header"
    done
}
# libraries LIBRARY WHAT [NEEDS]: of each number type, and what CMake knows it by
libraries() {
    for num in $NUMS; do
        name=$1-$num$suffix built=build/${num}x$AXES
        cp "$built/lib$1.a" "$stage/lib/lib$name.a"
        cp "$built/lib$name.so" "$stage/lib/lib$name.so.$VERSION"
        [ "$VERSION" = "$SOVERSION" ] ||
            ln -s "lib$name.so.$VERSION" "$stage/lib/lib$name.so.$SOVERSION"
        ln -s "lib$name.so.$SOVERSION" "$stage/lib/lib$name.so"
        filled ports/packages/loft.pc.in "$name" "$(macro "$num")" "$2" \
            "${3:+$3-$num$suffix = $VERSION}" > "$stage/lib/pkgconfig/$name.pc"
    done
    mkdir -p "$stage/lib/cmake/$1"
    filled "ports/packages/cmake/$1-config.cmake.in" > "$stage/lib/cmake/$1/$1-config.cmake"
    filled ports/packages/cmake/loft-config-version.cmake.in \
        > "$stage/lib/cmake/$1/$1-config-version.cmake"
}
suffix=
[ "$AXES" = 3 ] || suffix=x$AXES
if has loft; then
    headers loft.h config.h names.h $LOFT_ROOMS
    cp ports/packages/cpp/loft.hpp "$stage/include/loft/loft.hpp"
    libraries loft "Curves and motion for microcontrollers"
fi
if has loft-surfaces; then
    headers loft/surfaces.h $SURFACES_ROOMS
    libraries loft-surfaces "Surfaces and paths of a mill over them, above loft" loft
fi

if has loft-host; then
    mkdir -p "$stage/include/loft/loft"
    cp host-tools/library/host.h "$stage/include/loft/loft/host.h"
    cp "$HOST_LIBRARY" "$stage/lib/libloft-host.a"
    filled ports/packages/loft-host.pc.in "" "" "" "$HOST_PKG" > "$stage/lib/pkgconfig/loft-host.pc"
fi

[ -n "$command" ] || exit 0
share=$stage/share
mkdir -p "$stage/bin" "$share/man/man1" "$share/bash-completion/completions" \
    "$share/zsh/site-functions" "$share/fish/vendor_completions.d" "$share/doc/loft" \
    "$share/inkscape/extensions"
cp "$command" "$stage/bin/loft"
page() { sed "1s/ \"\" / \"$DATE\" /" > "$share/man/man1/$1.1"; }
"$command" --help=man | page loft
"$command" --help | sed -n 's/^  \([a-z]*\) .*/\1/p' | while read -r name; do
    "$command" "$name" --help=man | page "loft-$name"
done
"$command" --help=bash > "$share/bash-completion/completions/loft"
"$command" --help=zsh > "$share/zsh/site-functions/_loft"
"$command" --help=fish > "$share/fish/vendor_completions.d/loft.fish"
cp LICENSE README.md CHANGELOG.md host-tools/LOFT.md host-tools/MACHINE.md host-tools/USE.md \
    "$share/doc/loft"
cp ports/packages/inkscape/loft.inx ports/packages/inkscape/loft_inkscape.py \
    "$share/inkscape/extensions"
