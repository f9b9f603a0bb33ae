#!/bin/bash
# ports/packages/dist.sh -- what is given away: the sources, two files, trees for other tool chains
# SPDX-License-Identifier: MIT
# usage: dist.sh FOLDER   with VERSION SOVERSION DATE set, and NUM and ROOMS for the two files
# The same sources give the same bytes: files sorted, owned by nobody, with the version's date.
set -eu
out=$1 name=loft-$VERSION
rm -rf "$out"
mkdir -p "$out"
packed() {      # packed ARCHIVE FOLDER TREE: FOLDER/TREE as ARCHIVE
    (cd "$2" && find "$3" -print0 | LC_ALL=C sort -z |
        tar --null --no-recursion -T - --format=ustar --mtime="$DATE 00:00:00Z" --owner=0 \
            --group=0 --numeric-owner --mode=u=rwX,go=rX -cf -) | gzip -9n > "$out/$1"
}

# the sources, as git knows them, or all but build/ where there is no git
tree=$(mktemp -d); trap 'rm -rf "$tree"' EXIT
mkdir "$tree/$name"
if [ -e .git ]
then git ls-files -z --cached --others --exclude-standard
else find . -type f ! -path './build/*' ! -path './debian/*' -printf '%P\0'; fi |
    tar --null -T - -cf - | tar -xf - -C "$tree/$name"
packed "$name.tar.gz" "$tree" "$name"
hash=$(sha256sum < "$out/$name.tar.gz" | cut -d' ' -f1)


# what it is made of
from=$(pwd)
(cd "$tree/$name" && find . -type f -printf '%P\0' | LC_ALL=C sort -z |
    xargs -0 python3 "$from/ports/packages/sbom.py" "$VERSION" "$DATE" \
        "$from/$out/$name.tar.gz") > "$out/$name.spdx.json"

# each library as two files
one=$tree/loft-c-$VERSION
python3 ports/packages/amalgam/amalgam.py --num "${NUM:-q16}" --rooms "${ROOMS:-all}" --out "$one"
cp LICENSE ports/packages/cpp/loft.hpp "$one"
packed "loft-c-$VERSION.tar.gz" "$tree" "loft-c-$VERSION"

filled() { sed "s/@VERSION@/$VERSION/g; s/@HASH@/$hash/" "$1"; }

surfaces() {    # surfaces FOLDER: their files there, if the rooms have some
    [ ! -e "$one/loft_surfaces.c" ] ||
        cp -r "$one/loft_surfaces.h" "$one/loft_surfaces.c" "$one/loft" "$1"
}
# Arduino and PlatformIO: a library of curves and motion, with sketches, and one of surfaces
library=$tree/loft
mkdir -p "$library/src"
cp "$one/loft.h" "$one/loft.c" "$library/src"
cp -r ports/packages/arduino/examples ports/packages/arduino/keywords.txt LICENSE "$library"
filled ports/packages/arduino/library.properties > "$library/library.properties"
filled ports/packages/platformio/library.json > "$library/library.json"
packed "loft-arduino-$VERSION.tar.gz" "$tree" loft
if [ -e "$one/loft_surfaces.c" ]; then
    library=$tree/loft_surfaces
    mkdir -p "$library/src"
    surfaces "$library/src"
    cp -r ports/packages/arduino/surfaces/. LICENSE "$library"
    filled ports/packages/arduino/surfaces/library.properties > "$library/library.properties"
    filled ports/packages/platformio/surfaces.json > "$library/library.json"
    packed "loft-surfaces-arduino-$VERSION.tar.gz" "$tree" loft_surfaces
fi

# ESP-IDF: a component; CMSIS: a pack's description beside the same two files
component=$tree/esp/loft
mkdir -p "$component"
cp -r ports/packages/esp-idf/. "$component"
cp "$one/loft.h" "$one/loft.c" LICENSE "$component"
surfaces "$component"
filled ports/packages/esp-idf/idf_component.yml > "$component/idf_component.yml"
packed "loft-esp-idf-$VERSION.tar.gz" "$tree/esp" loft
pack=$tree/cmsis/loft
mkdir -p "$pack"
cp "$one/loft.h" "$one/loft.c" LICENSE "$pack"
surfaces "$pack"
cp -r ports/packages/cmsis/examples "$pack"
sed "s/@VERSION@/$VERSION/g; s/@DATE@/$DATE/g" ports/packages/cmsis/loft.pdsc \
    > "$pack/loft.loft.pdsc"
packed "loft-cmsis-$VERSION.tar.gz" "$tree/cmsis" loft

# meson: loft.wrap, and what it puts over the sources
mkdir -p "$out/meson/packagefiles/loft"
filled ports/packages/meson/loft.wrap > "$out/meson/loft.wrap"
cp ports/packages/meson/meson.build ports/packages/meson/meson_options.txt \
    "$out/meson/packagefiles/loft"

(cd "$out" && find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort |
    xargs sha256sum > SHA256SUMS)
