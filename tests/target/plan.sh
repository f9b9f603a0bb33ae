#!/bin/bash
# tests/target/plan.sh -- plan a drawing on an emulated AVR; a line `ok` or `FAIL` per number
# SPDX-License-Identifier: MIT
# usage: tests/target/plan.sh IMAGE.elf CHIP HERE PLAN_CHIP ;
# HERE plans the same on this computer, PLAN_CHIP is the emulator
set -u
elf=$1 chip=$2 here=$3 emulator=$4
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
result=$tmp/result

. tests/target/rows.sh
value() { awk -v name="$1" '$1 == name { print $2 }' "$tmp/said"; }
bytes() {
    avr-nm -S -t d "$elf" |
        awk -v names=" $* " 'index(names, " " $4 " ") { n += $2 } END { print n }'
}

"$here" >"$tmp/here" 2>"$tmp/said"
"$emulator" "$elf" "$chip" "$(avr-nm "$elf" | awk '$3 == "span" { print substr($1, 5) }')" \
    >"$tmp/chip" 2>>"$tmp/said"

echo "-- tests/drawings/outline12.csv planned on an $chip at 16 MHz:" \
    "50 mm/s, 500 mm/s2, 3 axes, without a limit of jerk; no steps are made"
row "spans as planned here, bit for bit" \
    "$(cmp -s "$tmp/here" "$tmp/chip" && wc -l <"$tmp/chip")" = "$(value spans)"
row "time over length / speed + speed / acceleration"       "$(value ratio)" "<=" 1.02
row "distance of the spans from the curves"                 "$(value deviation)" "<=" 0.005 mm
row "RAM of the planner: plan, 2 curves, 6 pieces" \
    "$(bytes plan moves pieces)" "<=" "$MOST_RAM" bytes
row "its stack" \
    "$(value stack)" "<=" "$MOST_STACK" bytes
row "flash" \
    "$(avr-size "$elf" | awk 'NR == 2 { print $1 + $2 }')" "<=" "$MOST_FLASH" bytes
row "time of planning over the time of the motion" \
    "$(awk -v c="$(value cycles)" -v t="$(value ticks)" \
        'BEGIN { if (t) printf "%.3f", c / (16000 * t) }')" "<=" "$MOST_LOAD"

sum
