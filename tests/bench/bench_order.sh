#!/bin/bash
# tests/bench/bench_order.sh -- the travel of 20 drawings of Debian's clip art beside the best known
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_order.sh ORDER FOLDER [SECONDS]
# The packages are downloaded into FOLDER, not installed. 20 drawings with 200 to 5,000 paths are
# chosen by a fixed seed. See bench_order.c: SECONDS of work find the best known order.
set -u
order=$1 folder=$2 seconds=${3:-60}
. "${0%/*}/drawings.sh"
mapfile -t strokes < <(all | (cd "$folder/svg" && xargs -d '\n' grep -c '<path') |
    awk -F: '$NF >= 200 && $NF <= 5000 { sub(/:[0-9]*$/, ""); print }' |
    choose 20)
[ "${#strokes[@]}" = 20 ] || { echo "bench_order.sh: no 20 drawings in $folder" >&2; exit 1; }
(cd "$folder/svg" && "$OLDPWD/$order" 10 "$seconds" "${strokes[@]}")
