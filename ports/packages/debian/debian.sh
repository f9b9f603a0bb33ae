#!/bin/sh
# ports/packages/debian/debian.sh -- put debian/ into a tree of loft: names follow the soname
# SPDX-License-Identifier: MIT
# usage: debian.sh TREE   with VERSION SOVERSION DATE set
set -eu
from=$(dirname "$0") to=$1/debian
mkdir -p "$to/source"
sed "s/@SOVERSION@/$SOVERSION/g" "$from/control.in" > "$to/control"
cp "$from/rules" "$from/copyright" "$from/loft.install" "$from/loft.docs" \
    "$from/libloft-dev.install" "$from/libloft-surfaces-dev.install" \
    "$from/libloft-dev.examples" "$to"
cp "$from/format" "$to/source/format"
for library in libloft-q16 libloft-f32 libloft-f64 \
        libloft-surfaces-q16 libloft-surfaces-f32 libloft-surfaces-f64; do
    package=$library-$SOVERSION
    echo "/usr/lib/*/$library.so.*" > "$to/$package.install"
    printf '%s %s #MINVER#\n (symver)LOFT_%s %s\n' "$library.so.$SOVERSION" "$package" \
        "$SOVERSION" "$VERSION" > "$to/$package.symbols"
done
{   echo "loft ($VERSION-1) unstable; urgency=medium"
    printf '\n  * Version %s: see CHANGELOG.md.\n\n' "$VERSION"
    echo " -- The loft authors <loft@example.org>  $(LC_ALL=C date -u -d "$DATE" -R)"
} > "$to/changelog"
