#!/bin/bash
# tests/bench/bench_drawings.sh -- plan drawings of Debian's icons and clip art; count what happens
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_drawings.sh LOFT ORDER FOLDER [FILES] [SECONDS]
# The packages are downloaded into FOLDER, not installed. FILES drawings, chosen by a fixed seed,
# are planned; what is refused or takes more than SECONDS is listed. ORDER measures the travel of 20
# drawings with 200 to 1,500 lines that have a path.
set -u
loft=$1 order=$2 folder=$3 files=${4:-2000} seconds=${5:-120}
packages="tango-icon-theme adwaita-icon-theme breeze-icon-theme inkscape openclipart-svg"
mkdir -p "$folder/svg"
for package in $packages; do
    [ -e "$folder/$package" ] && continue
    (cd "$folder" && apt-get download -qq "$package") || exit 1
    dpkg-deb --fsys-tarfile "$folder/$package"_*.deb |
        tar -x -C "$folder/svg" --wildcards '*.svg' 2>/dev/null
    touch "$folder/$package"
done
seeded() { openssl enc -aes-128-ctr -pass pass:loft -nosalt -md sha256 </dev/zero 2>/dev/null; }
find "$folder/svg" -type f -name '*.svg' | LC_ALL=C sort |
    shuf -n "$files" --random-source=<(seeded) >"$folder/list"

ok=0 warned=0 slow=0 refused=0
while IFS= read -r file; do
    said=$(timeout "$seconds" "$loft" plan --num f64 --total "$file" 2>&1 >/dev/null </dev/null)
    case $? in
    0)   ok=$((ok + 1)); [ -z "$said" ] || warned=$((warned + 1)) ;;
    124) slow=$((slow + 1)); echo "over $seconds s: ${file#"$folder/svg/"}" ;;
    *)   refused=$((refused + 1)); echo "refused: ${said##*share/}" ;;
    esac
done <"$folder/list"
echo "$files drawings: $ok planned ($warned with a warning), $refused refused, $slow slow"

mapfile -t strokes < <(find "$folder/svg" -type f -name '*.svg' | LC_ALL=C sort |
    xargs -d '\n' grep -c '<path' |
    awk -F: '$NF >= 200 && $NF <= 1500 { sub(/:[0-9]*$/, ""); print }' |
    shuf -n 20 --random-source=<(seeded))
"$order" 10 "${strokes[@]}"
