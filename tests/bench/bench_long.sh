#!/bin/bash
# tests/bench/bench_long.sh -- long G-code: lines per second, and the most memory
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_long.sh LOFT FOLDER [LINES]
# Chords of a circle (G1 X.. Y.., 0.05 mm) of 10,000 and of LINES lines: read alone, planned as
# curves, and planned line by line. User time is measured: it does not depend on other work.
set -u
loft=$1 folder=$2 most=${3:-1000000}
how=(--feed 300 --accel 30000 --jerk 0)
mkdir -p "$folder"
chords() {
    awk -v n="$1" 'BEGIN { print "G21 G90\nG0 X50 Y0\nF18000"
        for (i = 1; i <= n; i++)
            printf "G1 X%.5f Y%.5f\n", 50 * cos(i / 1000), 50 * sin(i / 1000)
        print "M30" }'
}
row() {                                 # row WHAT LINES COMMAND..
    local what=$1 lines=$2; shift 2
    /usr/bin/time -o "$folder/time" -f '%U %M' "$@" >/dev/null || exit 1
    read -r seconds kb <"$folder/time"
    awk -v w="$what" -v n="$lines" -v s="$seconds" -v kb="$kb" -v b="$size" 'BEGIN {
        s = s > 0.01 ? s : 0.01
        printf "%-22s %8d lines  %8.0f lines/s  %6.1f MB/s  %8d kB\n", w, n, n / s, b / s / 1e6, kb
    }'
}
for lines in 10000 "$most"; do
    file=$folder/chords$lines.nc
    [ -s "$file" ] || chords "$lines" >"$file"
    size=$(wc -c <"$file")
    row "read" "$lines" "$loft" plan --total "$file" --from-line $((lines + 3)) "${how[@]}"
    row "plan" "$lines" "$loft" plan --total "$file" "${how[@]}"
    row "stream --dry-run" "$lines" "$loft" stream --dry-run "$file" "${how[@]}"
    row "plan --smooth 0" "$lines" "$loft" plan --total "$file" --smooth 0 "${how[@]}"
done
