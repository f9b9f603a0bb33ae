#!/bin/bash
# tests/bench/bench_rsvg.sh -- compare drawings of Debian's icons and clip art with librsvg
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_rsvg.sh PROGRAM FOLDER [FILES] [PIECE]
# Half of FILES drawings are chosen among all by a fixed seed, half among those with text, dashes,
# clips, masks, markers or symbols; PIECE of them are compared in a call (0: all that are left).
# Results are kept in FOLDER/rsvg-results: verdict, counts (see bench_rsvg.c), name, last message.
set -u
program=$1 folder=$2 files=${3:-500} piece=${4:-0}
. "${0%/*}/drawings.sh"
special='<text|<use|stroke-dasharray[:=]["'"'"' ]*[0-9]|clip-path[:=]|mask[:=]|marker-[a-z]*[:=]'
if [ ! -e "$folder/rsvg-list" ]; then
    (all | choose $((files / 2))
        all | (cd "$folder/svg" && xargs -d '\n' grep -lE "$special") | choose "$files") |
        awk '!seen[$0]++' | head -n "$files" >"$folder/rsvg-list"
fi
touch "$folder/rsvg-results"
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT
left_of rsvg "$piece" 6 |
    while IFS= read -r file; do
        said=$(timeout 120 "$program" "$pictures" "$folder/svg/$file" 2>"$pictures/said") ||
            said=$(printf 'not compared\t-\t-\t-\t-')
        printf '%s\t%s\t%s\n' "$said" "$file" "$(tail -n 1 "$pictures/said")" \
            >>"$folder/rsvg-results"
    done
awk -F '\t' '{ n[$1]++; if ($1 != "agrees") print }
             END { printf "%d drawings:", NR; for (v in n) printf " %d %s,", n[v], v; print "" }' \
    "$folder/rsvg-results" | sed '$s/,$//'
