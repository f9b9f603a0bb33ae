#!/bin/bash
# tests/house/same.sh -- is everything that the command computes bit for bit what it was?
# SPDX-License-Identifier: MIT
# usage: tests/house/same.sh REVISION LOFT ; makes the command of that revision in build/same
# For changes that move or rename. Compared are the rows of plans (drawings, number types and
# limits) and the points of curves and surfaces.
set -u
revision=$1 loft=$PWD/$2 old=$PWD/build/same passed=0 failed=0
commit=$(git rev-parse --verify --quiet "$revision^{commit}") || {
    echo "same.sh: $revision: is not a commit: give OLD=REVISION"; exit 1
}
[ -d "$old" ] || git clone -q . "$old"
git -C "$old" fetch -q && git -C "$old" checkout -q "$commit" || exit 1
make -s -C "$old" build/loft || exit 1

same() {        # same NAME ARGUMENT..: both commands print the same, and more than a line
    local name=$1 new
    shift
    new=$("$loft" "$@" 2>&1)
    if [ "$new" = "$("$old/build/loft" "$@" 2>&1)" ] && [ "$(wc -l <<<"$new")" -gt 1 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1)); echo "FAIL same $name"
    fi
}

for num in q16 f32 f64; do
    for d in tests/drawings/outline12.csv tests/drawings/demo.svg; do
        for limits in "--feed 50" "--feed 200 --jerk 0" "--feed 100 --accel 3000 --jerk 1e5"; do
            # shellcheck disable=SC2086
            same "plan $d $num $limits" plan "$d" --num $num $limits --csv 1000
        done
    done
    for d in curves normals surfaces patch sided; do
        same "sample $d $num" sample "tests/drawings/$d.loft" --num $num
    done
done
echo "$passed passed, $failed failed"
[ $failed = 0 ] && [ $passed -gt 20 ]
