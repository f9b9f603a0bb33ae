#!/bin/bash
# tests/bench/bench_machine.sh -- measures the machine: first bench_workshop.sh, then the controller
# and its line against grbl 1.1 on the same chip; each ends with the sums
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_machine.sh FIRMWARE.elf LOFT HELPERS TYPIST
# HELPERS holds chip, rate, trials, bench_line, bench_frames; TYPIST is build/e2e/pty.
# ROWS in the environment: some of the groups alone: home stop laser servo settings beside.
# Smaller TRIALS (2000), CUTS (500) and FRAMES (100000000) make it shorter.
# Emulated: an ATmega328P at 16 MHz, cycle by cycle, 115200 baud.
set -u
export ROWS=${ROWS:-home stop laser servo settings beside}
bash tests/bench/bench_workshop.sh "$@"; workshop=$?
[[ " $ROWS " == *' beside '* ]] || exit $workshop

elf=$1 loft=$2 bin=$3
TRIALS=${TRIALS:-2000} CUTS=${CUTS:-500} FRAMES=${FRAMES:-100000000}
drawing=tests/drawings/outline12.csv
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result; : > "$result"
. tests/target/rows.sh

# row WHAT GRBL VALUE OPERATOR BOUND [UNIT]
row() {
    local verdict=MISSED
    holds "$3" "$4" "$5" && verdict="ok    "
    printf '%s  %-80s %-10s %-12s %s %s%s\n' "$verdict" "$1" "$2" "${3:-nothing}" "$4" "$5" \
        "${6:+ $6}" | tee -a "$result"
}
note() { printf '        %-80s %-10s %s\n' "$1" "" "$2"; }
seconds() {
    awk -F, '/^[0-9]/ { if (!a) a = $1; b = $1 } END { printf "%.6f", (b - a) / 16e6 }' \
        "$tmp/chip.csv"
}

# ideal FEED: L/v + v/a of the drawing
ideal() { awk -v v="$1" 'BEGIN { print 130.819 / v + v / 500 }'; }
over_ideal() { awk -v t="$(seconds)" -v i="$(ideal "$1")" 'BEGIN { printf "%.3f", t / i }'; }

# The shortest time at 6000 mm/min within 500 mm/s2 in total is 1.7393 s (tests/support/topp.h;
# make bench-motion, outline-100-soft). The bound is 3 % more, as a fraction of that ideal.
SLOWER=$(awk -v i="$(ideal 100)" 'BEGIN { printf "%.3f", 1.03 * 1.7393 / i }')

# the speed in windows of 10 ms, without the first and the last 0.2 s: its deviation over its mean,
# and the number of windows at rest
cruise() {
    awk -F, '/^[0-9]/ {
            w = int($1 / 160000); x[w] = $2; y[w] = $3
            last = w; if (first == "") first = w
        }
        END { for (w = first + 20; w <= last - 20; w++) {
                  if (!(w in x)) { x[w] = x[w-1]; y[w] = y[w-1] }
                  v = sqrt((x[w] - x[w-1])^2 + (y[w] - y[w-1])^2)
                  n++; s += v; q += v * v; stand += v == 0
              }
              m = s / n; printf "%.4f %d", sqrt(q / n - m * m) / m, stand }' "$tmp/chip.csv"
}

printf '        %-80s %-10s %-12s %s\n' "" "grbl 1.1" loft bound
note "500 mm/s2 in bends too, so that 6000 mm/min are not possible everywhere; grbl: along" ""
note "the path alone" ""
while read -r spacing feed grbl bound; do
    python3 tests/target/dense.py $drawing "$spacing" > "$tmp/dense.loft"
    on_chip "$bin/chip" "$elf" "$loft" stream "$tmp/dense.loft" --feed "$feed" --jerk 0 \
        --lift 0 --port "$tmp/port"
    row "points every $spacing mm, $((feed * 60)) mm/min: time / (L/v + v/a)" \
        "$grbl" "$(over_ideal "$feed")" "<=" "$bound"
    if [ "$spacing $feed" = "0.01 50" ]; then
        read -r deviation stops < <(cruise)
        row "the same: deviation of the speed in the cruise" 0.83 "$deviation" "<=" 0.05
        row "the same: stops" 1 "$stops" = 0
    fi
done <<TABLE
0.05 50 3.21 1.05
0.05 100 5.79 $SLOWER
0.01 50 13.3 1.05
0.01 100 24.0 $SLOWER
TABLE
on_chip "$bin/chip" "$elf" "$loft" stream $drawing --feed 50 --jerk 0 --lift 0 --port "$tmp/port"
row "the drawing's curves, as spans, 3000 mm/min: time / (L/v + v/a)" \
    - "$(over_ideal 50)" "<=" 1.03

for axes in 1 3; do
    on_chip "$bin/chip" "$elf" "$bin/rate" "$tmp/port" $axes 40
    row "steps per second and axis, every step there, $axes axes" \
        "$([ $axes = 1 ] && echo 40000 || echo 30000)" \
        "$([ $code = 0 ] && [ "$(said slowed)" = 0 ] && echo 40000)" ">=" 40000
done
on_chip "$bin/chip" "$elf" "$bin/rate" "$tmp/port" 3 100
row "100000 asked: steps lost" - "$code" = 0
row "100000 asked: it says how many ticks were slowed" - "$(said slowed)" ">=" 1
read -r flash ram < <(avr-size "$elf" | awk 'NR == 2 { print $1 + $2, $2 + $3 }')
row "flash" 29900 "$flash" "<=" 32256 bytes
row "RAM without the stack" 1630 "$ram" "<=" 1638 bytes

while read -r kind count what grbl; do
    "$bin/trials" "$elf" "$kind" "$count" >"$tmp/trials" 2>"$tmp/trials.err"
    sed 's/^/        /' "$tmp/trials.err"
    what=${what//_/ } grbl=${grbl//_/ } ran=$(said trials "$tmp/trials")
    row "$what, ${ran:-no} trials: wrong steps" "$grbl" "$(said wrong "$tmp/trials")" = 0
    row "$what, ${ran:-no} trials: jobs not ended" - "$(said incomplete "$tmp/trials")" = 0
    [ "$kind" != noise ] ||
        note "goodput: machine time of the job, noisy and clean" \
            "$(awk '{ printf "%.3f s, %.3f s; ", $11 / $3, $15
                      printf "%d frames sent again in %d jobs", $9, $3 }' "$tmp/trials")"
done <<TABLE
byte $TRIALS one_byte_flipped,_dropped,_doubled,_inserted 40_%
frames $CUTS line_cut_at_a_frame's_end,_back_after_0.1..60_s lost
cut $CUTS line_cut_at_any_byte,_back_after_0.1..60_s lost
killed $((CUTS / 5)) sender_killed_and_started_again lost
noise $((CUTS / 25)) bit_errors_1e-4_for_a_whole_job -
TABLE

"$bin/bench_line" >"$tmp/line"
rate() { awk -v rate="$1" '$1 == rate { print $2 }' "$tmp/line"; }
row "points per second at 115200, 3 axes, clean" 302 "$(rate 0)" ">=" 9000
row "the same, bit errors 1e-5" - "$(rate 1e-05)" ">=" 8500
note "the same, bit errors 1e-4" "$(rate 0.0001)"
on_chip "$bin/chip" "$elf" "$loft" stream $drawing --points --feed 50 --jerk 0 --lift 0 \
    --port "$tmp/port"
row "what the chip does of them at 1000 ticks per second, the drawing at 3000 mm/min" \
    - "$(awk -v n="$(sed -n 's/.* out for \([0-9]*\) points.*/\1/p' "$tmp/out")" \
        -v t="$(seconds)" 'BEGIN { if (t) printf "%.0f", n / t }')" ">=" 980

for half in 1 2; do
    "$bin/bench_frames" every $(((FRAMES + 1999999) / 2000000)) $half >"$tmp/every$half" &
done
wait
frames=$(cat "$tmp"/every[12] | awk '{ n += $3 } END { print n }')
row "damaged frames accepted of all $frames of some: 1, 2 bits, a byte less, twice, more" most \
    "$(cat "$tmp"/every[12] | awk '{ n += $5 } END { print n }')" = 0
for class in bits bytes lost doubled inserted; do
    for half in 1 2; do "$bin/bench_frames" $class $((FRAMES / 2)) $half >"$tmp/$class$half" & done
    wait
    row "damaged frames accepted of $FRAMES: $class" \
        most "$(cat "$tmp/$class"[12] | awk '{ n += $5 } END { print n }')" = 0
done

sum && [ $workshop = 0 ]
