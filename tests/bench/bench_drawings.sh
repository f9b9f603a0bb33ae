#!/bin/bash
# tests/bench/bench_drawings.sh -- plan drawings of Debian's icons and clip art; count what happens
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_drawings.sh LOFT FOLDER [FILES] [SECONDS] [PIECE]
# The packages are downloaded into FOLDER, not installed. FILES drawings, chosen by a fixed seed,
# are planned, PIECE of them in a call (0: all that are left); what is refused or takes more than
# SECONDS is listed. Results are kept in FOLDER/plan-results: a call goes on where the last one
# ended.
set -u
loft=$1 folder=$2 files=${3:-2000} seconds=${4:-120} piece=${5:-0}
. "${0%/*}/drawings.sh"
all | choose "$files" >"$folder/plan-list"
touch "$folder/plan-results"

# a line for each drawing: exit code, what it says last, its name
left_of plan "$piece" 3 |
    while IFS= read -r file; do
        said=$(timeout "$seconds" "$loft" plan --num f64 --total "$folder/svg/$file" 2>&1 \
            >/dev/null </dev/null)
        code=$?
        said=${said##*$'\n'} said=${said#*.svg:}
        printf '%s\t%s\t%s\n' "$code" "${said//$'\t'/ }" "$file" >>"$folder/plan-results"
    done

awk -F '\t' -v seconds="$seconds" '
    NR == FNR { want[$0]; next }
    !($3 in want) { next }
    { n++ }
    $1 == 0 { ok++; warned += $2 != "" }
    $1 == 124 { slow++; print "over " seconds " s: " $3 }
    $1 != 0 && $1 != 124 {
        refused++; why = $2; sub(/^[0-9]+:/, "", why); list[why] = list[why] "\n    " $3
    }
    END { for (why in list) print "refused:" why ":" list[why]
          printf "%d drawings: %d planned (%d with a warning), %d refused, %d slow\n",
              n, ok, warned, refused, slow }' "$folder/plan-list" "$folder/plan-results"
[ "$(cut -f3 "$folder/plan-results" | grep -cxFf "$folder/plan-list")" -ge "$files" ] ||
    echo "to be continued: call it again"
