# tests/bench/drawings.sh -- drawings of Debian's icons and clip art, for other scripts to source
# SPDX-License-Identifier: MIT
# The packages are downloaded into $folder, not installed.
mkdir -p "$folder/svg"
for package in tango-icon-theme adwaita-icon-theme breeze-icon-theme inkscape openclipart-svg; do
    [ -e "$folder/$package" ] && continue
    (cd "$folder" && apt-get download -qq "$package") || exit 1
    dpkg-deb --fsys-tarfile "$folder/$package"_*.deb |
        tar -x -C "$folder/svg" --wildcards '*.svg' 2>/dev/null
    touch "$folder/$package"
done
seeded() { openssl enc -aes-128-ctr -pass pass:loft -nosalt -md sha256 </dev/zero 2>/dev/null; }
all() { (cd "$folder/svg" && find . -type f -name '*.svg' | LC_ALL=C sort); }
choose() { shuf -n "$1" --random-source=<(seeded); }
# the next ones of a list whose names are not in the column $3 of the results; $2: how many, 0: all
left_of() {
    grep -vxFf <(cut -f"$3" "$folder/$1-results") "$folder/$1-list" |
        if [ "$2" -gt 0 ]; then head -n "$2"; else cat; fi
}
