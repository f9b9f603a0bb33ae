#!/bin/bash
# tests/bench/bench_motion.sh -- measures the promises of motion: one row per number, with its bound
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_motion.sh BUILD [CASES]
# BUILD/<what>-<q16|f64> and BUILD/moves are built; CASES of the property run in each type (100000).
# ROWS in the environment: some of the groups of rows, of `all` below or time, jerk, same: these
# compare plans for machines with random limits, and plans of q16 with those of f64.
set -u
build=$1 cases=${2:-100000}
chains=400 cubics=2000 smooth=40
passed=0 failed=0
trap 'kill $(jobs -p) 2>/dev/null' EXIT

# row WHAT BOUND VALUE WHERE: at most BOUND;
# WHERE is the place of the value, or the value of other programs
row() {
    if [ -n "$3" ] && awk -v v="$3" -v b="$2" 'BEGIN { exit !(v + 0 <= b + 0) }'; then
        verdict=ok; passed=$((passed + 1))
    else
        verdict=MISSED; failed=$((failed + 1))
    fi
    printf '%-66s %10s %12s  %-6s %s\n' "$1" "$2" "${3:--}" $verdict "${4:-}"
}
note() { printf '%-66s %s\n' "" "$1"; }
# pick FILE KEY FIELD
pick() { awk -v key="$2" '$1 == key { print $'"$3"'; exit }' "$build/$1"; }

. tests/bench/bench_motion_table.sh     # A_rows .. chip_rows

lists() {       # the drawings as lists of moves, feed 1
    for drawing in demo.svg curves.loft; do
        "$build/moves" tests/drawings/$drawing 1 > "$build/${drawing%.*}.moves" || exit 1
    done
    awk -F, '!/^#/ { print $1, $2, 0, $3, $4, 0, $5, $6, 0, $7, $8, 0, 1 }' \
        tests/drawings/outline12.csv > "$build/outline12.moves"
}

# in_both WHAT ARGUMENTS..: run both builds in parallel, output to BUILD/WHAT-NUM.out
in_both() {
    for num in q16 f64; do "$build/$1-$num" "${@:2}" > "$build/$1-$num.out" & done
    wait
}

limits_rows() {
    in_both limits "$build" $chains
    for key in speed along accel jerk jump; do
        case $key in
        speed) what="speed per axis, of the limit" bound=1.001 ;;
        along) what="speed along the path, of the feed" bound=1.001 ;;
        accel) what="acceleration per axis, of the limit" bound=1.005 ;;
        jerk)  what="jerk per axis, of the limit" bound=1.02 ;;
        jump)  what="jump of acceleration between spans, jerk limited, of the limit" bound=0.01 ;;
        esac
        for num in q16 f64; do
            row "$what, $num" \
                $bound "$(pick limits-$num.out $key 2)" "$(pick limits-$num.out $key 3)"
        done
    done
    for num in q16 f64; do
        row "paths whose plan does not arrive or has gaps, $num" \
            0 "$(grep -c '^broken' "$build/limits-$num.out")" "$(pick limits-$num.out broken 3)"
        row "distance (Frechet) from drawings and chains, of the tolerance, $num" \
            1 "$(pick limits-$num.out off 2)" "$(pick limits-$num.out off 3)"
    done
}

deviation_rows() {
    for box in 10 50 200; do
        in_both deviation $box $cubics
        case $box in
        10)  peers="(0.1 mm and 16 arcs: 0.090, 0.020 mm)" ;;
        50)  peers="(0.097, 0.097 mm)" ;;
        200) peers="(0.097, 0.34 mm)" ;;
        esac
        for num in q16 f64; do
            row "distance from $cubics random cubics in $box mm, of 0.005 mm, $num" \
                1 "$(pick deviation-$num.out off 2)" "$(pick deviation-$num.out off 3) $peers"
        done
    done
}

time_rows() {
    in_both time "$build" $smooth
    for num in q16 f64; do
        while read -r name ratio seconds; do
            row "time to the least possible, $name, $num" 1.03 "$ratio" "$seconds s"
        done < <(awk '$1 == "accel" && $2 ~ /^outline/ { print $2, $3 / $4, $3 }' \
            "$build/time-$num.out")
        read -r name ratio < <(awk '
            $1 == "accel" && $2 ~ /^smooth/ && $3 / $4 > most { most = $3 / $4; name = $2 }
            END { print name, most }' "$build/time-$num.out")
        row "time to the least possible, worst of smooth chains, $num" 1.03 "$ratio" "$name"
        # the spline lasts two beats longer than the sampled time,
        # and ends at a whole beat
        read -r name ratio < <(awk '
            $1 == "rest" { r = ($3 - 3 * $5) / $4; if (r > most) { most = r; name = $2 } }
            END { print name, most }' "$build/time-$num.out")
        row "time less 3 beats to the best jerk-limited one, worst of lines, $num" \
            1.08 "$ratio" "$name"
    done
}

jerk_rows() {       # after time
    for num in q16 f64; do
        while read -r name ratio seconds; do
            row "time to a short jerk-limited one, $name, $num" 1.03 "$ratio" "$seconds s"
        done < <(awk '$1 == "jerk" && $2 ~ /^outline/ { print $2, $3 / $4, $3 }' \
            "$build/time-$num.out")
        read -r name ratio < <(awk '
            $1 == "jerk" && $2 ~ /^smooth/ && $3 / $4 > most { most = $3 / $4; name = $2 }
            END { print name, most }' "$build/time-$num.out")
        row "time to a short jerk-limited one, worst of smooth chains, $num" 1.03 "$ratio" "$name"
    done
    row "the short one on a line, off L / v + v / a + a / j by" 0.002 \
        "$(awk '$1 == "jerk" && $2 == "line" { d = $4 / 2.15 - 1; print d < 0 ? -d : d }' \
            "$build/time-f64.out")"
}

same_rows() {
    "$build/same-q16" "$build" $smooth && "$build/same-f64" "$build" $smooth > "$build/same.out"
    row "time of q16 to f64, off 1 by" 0.005 "$(pick same.out time 2)" "$(pick same.out time 3)"
    row "path of q16 from that of f64, of 1 LSB + tolerance" \
        1 "$(pick same.out apart 2)" "$(pick same.out apart 3)"
}

outline_rows() {
    in_both outline "$build"
    for num in q16 f64; do
        row "outline: time / (L / v + v / a), $num" \
            1.02 "$(pick outline-$num.out ratio 2)" \
            "$(pick outline-$num.out ratio 3) (a G-code controller: 3.21 in chords of 0.05 mm)"
        row "outline: variation of speed in the cruise, $num" \
            0.02 "$(pick outline-$num.out vary 2)" \
            "$(pick outline-$num.out vary 3) (its cv: 0.07, at 30 % of the feed)"
        slowest=$(pick outline-$num.out slowest 2)
        row "outline: stops in the cruise, $num" \
            0 "$(awk -v v="$slowest" 'BEGIN { print (v > 0) ? 0 : 1 }')" "slowest $slowest mm/s"
        row "outline: steps lost at 250 steps/mm, $num" \
            0 "$((1 - $(pick outline-$num.out steps 2)))"
    done
}

cortex_rows() { # instructions, for the README
    sh tests/bench/bench_motion_cortex.sh "$build" > "$build/cortex.out" ||
        { row "instructions on Cortex-M0 and M4" 0 "" "make deps-target"; return; }
    awk '{ for (k = 3; k < NF; k += 2) v[$k] = $(k + 1)
           core = $1 == "cortex-m0" ? "Cortex-M0" : "Cortex-M4"
           name = core ($2 > 0 ? ", jerk limited" : "") ": instructions per "
           per("planned curve", v["planning"] / v["curves"])
           per("planned millisecond", v["planning"] / v["ticks"])
           per("span to begin", v["begin"] / v["spans"])
           per("tick of 3 axes", v["ticking"] / v["ticks"])
           per("slot of 3 axes", v["slotting"] / v["slots"]) }
         function per(what, n) { printf "%-66s %10s %12d\n", name what, "", n }' "$build/cortex.out"
}

# the same cases in both, in parallel: 20 minutes for 100000 on two free processors
property_rows() {
    in_both any 1 "$cases"
    for num in q16 f64; do
        row "cases with a violation, deadlock or lost step, seeds 1..$cases, $num" \
            0 "$(awk '/ failed$/ { print $3 }' "$build/any-$num.out")" \
            "$(awk '$1 == "fault" && $3 > 0 { printf "%s %s  ", $2, $3 }' "$build/any-$num.out")"
        grep '^  seed' "$build/any-$num.out" | head -30
    done
}

printf '%-66s %10s %12s  %-6s %s\n' what "at most" measured "" "where"
all="A B C D chords lines ahead icons stops chip limits deviation outline cortex property"
for rows in ${ROWS:-$all}; do
    case $rows in limits|time|same|outline) lists ;; esac
    ${rows}_rows
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
