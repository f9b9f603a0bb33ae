# tests/e2e/plan.sh -- what `loft plan` says
# SPDX-License-Identifier: MIT

case_plan_says_what_limits() {
    plan() { run 0 "$loft" plan "$@"; is_empty err; }
    limited() {
        local by=$1; shift
        plan --total "$@"
        grep -q "^drawn .*  $by [0-9]* %" "$tmp/out" || job_fails "not by $by: $(cat "$tmp/out")"
    }
    printf '0,0,10,0,20,0,30,0\n' >"$tmp/line.csv"
    printf 'arc left\n10 0\n0 0\n10 0\n' >"$tmp/ring.loft"
    awk 'BEGIN { print "line"; for (i = 0; i < 60; i++) print i * 0.5, i % 2 * 0.3 }' \
        >"$tmp/saw.loft"
    printf 'max_speed = 500\nx.max_speed = 20\nmax_jerk = 0\n' >"$tmp/slow.txt"
    plan "$tmp/line.csv" --jerk 0       # from rest to rest: 30 mm / 30 mm/s + 30 mm/s / 2000 mm/s2
    awk '$1 == 1 { good = $2 == 1 && $3 == "30.000" && $4 > 1.012 && $4 < 1.022 &&
                          $5 > 29.9 && $5 < 30.1 }
         END { exit !good }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
    limited feed "$tmp/line.csv"
    limited 'x speed' "$tmp/line.csv" --feed 60 --machine "$tmp/slow.txt"
    limited 'x acceleration' "$tmp/line.csv" --feed 1000 --jerk 0
    limited 'x jerk' "$tmp/line.csv" --feed 1000 --jerk 10000
    limited curvature "$tmp/ring.loft" --feed 1000 --accel 300 --jerk 0
    plan --total "$tmp/saw.loft" --jerk 0
    says out '^in all .*, corner [0-9]'
    for num in q16 f32 f64; do
        plan "$tmp/small.csv" --num $num
        [ "$(grep -c '^[0-9]' "$tmp/out")" = 7 ] || job_fails "$num: $(cat "$tmp/out")"
        # rows add up, limits add up, and the total is the plan of `stream`
        awk '/^[0-9]/ { d += $4; l += $3 } /^drawn/ { a = $3; b = $2 } /^in all/ { w = $4 }
             END { d -= a; l -= b
                   exit !(d < 0.01 && d > -0.01 && l < 0.01 && l > -0.01 && w > a) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        local all; all=$(awk '/^in all/ { print $4 }' "$tmp/out")
        run 0 "$loft" stream "$tmp/small.csv" --dry-run --num $num
        awk -v a="$all" '{ for (i = 1; i < NF; i++) if ($(i + 1) == "s,") d = $i - a }
             END { exit !(d < 0.06 && d > -0.06) }' "$tmp/out" ||
            job_fails "$num: $all, $(cat "$tmp/out")"
    done
}
case_plan_as_rows() {
    run 0 "$loft" plan "$tmp/small.csv" --csv 500; is_empty err; cp "$tmp/out" "$tmp/rows"
    # velocity is the slope of the position, and acceleration that of the velocity; limits hold; the
    # end is at rest above the last point
    awk -F, 'NR == 1 { if ($0 != "t,x,y,z,vx,vy,vz,ax,ay,az") exit bad = 1; next }
        NF != 10 { exit bad = 1 }
        NR > 2 && $1 - t > 0.0019 && $1 - t < 0.0021 {
            for (i = 2; i < 8; i++) {
                d = ($i - o[i]) / ($1 - t) - ($(i + 3) + o[i + 3]) / 2
                if (d < 0) d = -d
                if (d > (i < 5 ? 0.05 : 60)) {
                    print "row " NR " column " i " is off by " d
                    exit bad = 1
                }
            }
            n++
        }
        { t = $1; for (i = 2; i <= NF; i++) o[i] = $i }
        END { exit bad || n < 3000 ||
                   !($2 == 60 && $3 == 30 && $4 == 1 && $5 == 0 && $6 == 0 && $7 == 0) }' \
        "$tmp/rows" || job_fails "$(tail -1 "$tmp/rows")"
    run 0 "$loft" plan "$tmp/small.csv" --csv 500 -o "$tmp/file.csv"
    says out '^in all '
    cmp -s "$tmp/file.csv" "$tmp/rows" || job_fails "the file has other rows"
    run 0 sh -c "cat '$tmp/small.csv' | '$loft' plan - --csv 10 --num f64 --park | tail -1"
    says out ',0.000000,0.000000,0.000000,0.00000,0.00000,0.00000,'
}
case_plan_as_spans() {
    run 0 "$loft" plan "$tmp/small.csv" --spans; is_empty err; cp "$tmp/out" "$tmp/spans"
    # no gap in time or place, from rest to rest; every coordinate is a whole number of 2^-16 mm
    /usr/bin/python3 - "$tmp/spans" >"$tmp/why" 2>&1 <<'PY' || job_fails "$(tail -1 "$tmp/why")"
import csv, sys
from fractions import Fraction
rows = list(csv.reader(open(sys.argv[1])))
names = [a + str(k) for a in 'xyz' for k in range(4)]
assert rows[0] == ['start_s', 'duration_s'] + names, rows[0]
now, at = Fraction(0), ['0', '0', '0']
for row in rows[1:]:
    row = dict(zip(rows[0], row))
    assert Fraction(row['start_s']) == now and Fraction(row['duration_s']) > 0, row
    assert [row[a + '0'] for a in 'xyz'] == at, row
    assert all((Fraction(row[n]) * 65536).denominator == 1 for n in names), row
    at, now = [row[a + '3'] for a in 'xyz'], now + Fraction(row['duration_s'])
assert at == ['60', '30', '1'] and [row[a + '2'] for a in 'xyz'] == at, row
PY
    run 0 "$loft" plan "$tmp/small.csv" --spans -o "$tmp/file.csv"; says out '^in all '
    cmp -s "$tmp/file.csv" "$tmp/spans" || job_fails "the file has other spans"
    one_line 64 'give one of them'   "$loft" plan "$tmp/small.csv" --spans --csv 10
}
case_plan_is_certified() {
    run 0 "$loft" plan tests/drawings/outline12.csv --certify; is_empty err
    [ "$(grep -c ' ok$' "$tmp/out")" = 11 ] || job_fails "$(cat "$tmp/out")"
    awk '/^(motion|drawing) from/ { exit !($4 > 0 && $4 <= 0.005) }' "$tmp/out" ||
        job_fails "$(cat "$tmp/out")"
    printf 'kinematics = delta\narm_length = 200\ndelta_radius = 95\n' >"$tmp/delta.txt"
    one_line 64 'a delta machine'    "$loft" plan "$tmp/small.csv" --certify \
        --machine "$tmp/delta.txt"
    one_line 64 'give --output FILE as well' "$loft" plan "$tmp/small.csv" --certify --spans
}
case_plan_within_the_least_tolerance() {    # a chain of chords: smoothing takes what is left
    awk 'BEGIN { print "G21 F1800"; for (k = 0; k < 80; k++)
        printf "G1 X%.4f Y%.4f\n", 2 * cos(k / 40), 2 * sin(k / 40); print "M2" }' >"$tmp/chords.nc"
    for tol in 0.00098 0.001 0.0011; do
        run 0 "$loft" plan "$tmp/chords.nc" --tol $tol --certify; is_empty err
        one_line 64 'at least 0.00098 mm' "$loft" plan "$tmp/chords.nc" --tol $tol --smooth 0.0003
    done
    one_line 64 'from 0.00098 to 1' "$loft" plan "$tmp/chords.nc" --tol 0.0009
}
case_plan_stops_exactly_at_corners() {
    local rests='NR > 1 { for (k = 6; k < 15; k += 4) if ($(k - 1) != $k) next; print $6, $10 }'
    printf '%s\n' "0,0 10,0 20,0 30,0" "30,0 30,10 30,20 30,30" "30,30 30,31 30,32 31,40" |
        tr ' ' ',' >"$tmp/turn.csv"
    for exact in --exact --exact=60; do
        run 0 "$loft" plan "$tmp/turn.csv" $exact --spans
        awk -F, "$rests" "$tmp/out" >"$tmp/rests"
        grep -q '^30 0$' "$tmp/rests" || job_fails "no stop at 30,0: $(cat "$tmp/rests")"
        ! grep -q '^30 30$' "$tmp/rests" || job_fails "a stop on a smooth joint"
    done
    for exact in "" --exact=120; do
        run 0 "$loft" plan "$tmp/turn.csv" $exact --spans
        awk -F, "$rests" "$tmp/out" >"$tmp/rests"
        ! grep -q '^30 0$' "$tmp/rests" || job_fails "a stop at 30,0"
    done
    run 0 "$loft" plan "$tmp/turn.csv" --exact --certify; is_empty err
    one_line 64 'a machine that plans does not stop' "$loft" stream "$tmp/turn.csv" --dry-run \
        --plan chip --exact
    one_line 64 'exact' "$loft" plan "$tmp/turn.csv" --exact=181
}
case_plan_rounds_corners() {
    seconds() {
        run 0 "$loft" plan "$@" --feed 100 --total
        awk '/^in all/ { print $4 }' "$tmp/out"
    }
    printf '%s\n' "0,0 10,0 20,0 30,0" "30,0 30,10 30,20 30,30" "30,30 30,31 30,32 31,40" |
        tr ' ' ',' >"$tmp/turn.csv"
    printf 'corner = 0.05\n' >"$tmp/round.txt"
    for num in q16 f32 f64; do
        local sharp round said
        sharp=$(seconds "$tmp/turn.csv" --num $num)
        round=$(seconds "$tmp/turn.csv" --num $num --corner 0.05)
        said=$(seconds "$tmp/turn.csv" --num $num --machine "$tmp/round.txt")
        awk "BEGIN { exit !($round < $sharp && $round == $said) }" ||
            job_fails "$num: $sharp s, corners within 50 um $round s, as the machine's $said s"
        run 0 "$loft" plan "$tmp/turn.csv" --num $num --feed 100 --corner 0.05 --certify
        is_empty err
    done
    run 0 "$loft" stream "$tmp/turn.csv" --dry-run --corner 0.05
    run 0 "$loft" stream "$tmp/turn.csv" --dry-run --plan chip --corner 0.05
    one_line 64 'corner' "$loft" plan "$tmp/turn.csv" --corner 2
}
case_plan_as_a_picture() {
    run 0 "$loft" plan "$tmp/small.csv" --total --plot "$tmp/a.png" --size 400; says out '^drawn '
    run 0 "$loft" plan tests/drawings/curves.loft --total --jerk 0 --plot "$tmp/b.svg"
    run 0 "$loft" plan "$tmp/small.csv" --total --plot "$tmp/c.pdf"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] || job_fails "no picture"
    one_line 64 'ends with .png, .svg or .pdf' "$loft" plan "$tmp/small.csv" --plot "$tmp/a.gif"
    one_line 73 'cannot be written'  "$loft" plan "$tmp/small.csv" --plot "$tmp/none/a.png"
    one_line 73 'cannot be written'  "$loft" plan "$tmp/small.csv" --csv 10 -o "$tmp/none/a.csv"
    one_line 64 'give --csv RATE'    "$loft" plan "$tmp/small.csv" -o "$tmp/a.csv"
    one_line 64 'no DRAWING'         "$loft" plan
    one_line 66 'none.svg: no such'  "$loft" plan "$tmp/none.svg"
    one_line 65 'unknown key'        "$loft" plan "$tmp/small.csv" --machine "$tmp/small.csv"
    printf '\n0,0,9000,0,1,1,2,2\n' >"$tmp/wide.csv"
    one_line 65 'wide.csv:2: a point at 9000,0 mm' "$loft" plan "$tmp/wide.csv"
}
case_a_drawing_that_leaves_the_table() {
    # an arch: x 10..50, y 0..30, though its control points reach to 40
    printf '10,0,10,40,50,40,50,0\n' >"$tmp/arch.csv"
    table() { printf "$1" >"$tmp/table.txt"; }
    fits() { table "$1"; run 0 "$loft" stream "$tmp/arch.csv" --dry-run \
        --machine "$tmp/table.txt"; is_empty err; }
    leaves() { table "$1"; one_line 65 "arch.csv: takes the tool to $2" "$loft" stream \
        "$tmp/arch.csv" --dry-run --machine "$tmp/table.txt" "${@:3}"; }
    fits 'x.travel = 50\ny.travel = 30\n'
    fits 'x.travel = 40\nx.min = 10\ny.travel = 30\nz.travel = 1\n'
    fits 'x.travel = 49.996\n'                         # as far as the tolerance
    leaves 'x.travel = 49.99\n' 'x 10..50, and the table is x 0..49.99: moved by -0.01,0 it fits'
    leaves 'x.travel = 40\nx.min = 20\ny.travel = 30\ny.min = 5\n' \
        'x 10..50, y 0..30, and the table is x 20..60, y 5..35: moved by 10,5 it fits'
    leaves 'x.travel = 30\ny.travel = 50\n' 'x 10..50, y 0..30, .*: turned by 90 degrees it fits'
    leaves 'x.travel = 20\ny.travel = 20\n' '.* x 0..20, y 0..20: at 0.5 of its size it fits'
    leaves 'z.travel = 3\n' 'z 0..4, and the table is z 0..3: the drawing fits: .* --lift' --lift 4
    leaves 'z.travel = 3\nz.min = 1\n' 'z 0..1, .* z 1..4: the pen draws at z 0..0: give a z.min'
    printf 'line\n0 0 -2\n9 9 3\n' >"$tmp/space.loft"
    table 'z.travel = 9\nz.min = -2\n'
    run 0 "$loft" plan "$tmp/space.loft" --machine "$tmp/table.txt"
    table 'z.travel = 9\nz.min = -1\n'
    one_line 65 'z -2..4, .* z -1..8: the pen draws at z -2..3: give' "$loft" plan \
        "$tmp/space.loft" --machine "$tmp/table.txt"
    leaves 'x.min = 10\nx.travel = 40\n' 'x 0..50, .* leave out --park' --park
    leaves '$130=49.000\n$131=200.000\n' 'x 10..50, y 0..30, and the table is x 0..49, y 0..200'
    for kind in corexy polar; do        # the table is for the tool
        leaves "kinematics = $kind\nx.travel = 49\n" 'x 10..50, and the table is x 0..49'
    done
    table 'x.travel = 40\n'
    one_line 65 'x 0..40: moved by -10,0' "$loft" plan "$tmp/arch.csv" --machine "$tmp/table.txt"
    one_line 65 'x 0..40: moved by -10,0' "$loft" stream "$tmp/arch.csv" --grbl --dry-run \
        --machine "$tmp/table.txt"
    machine tabled --speed fast --machine "$tmp/table.txt"
    one_line 65 'x 0..40: moved by -10,0' "$loft" stream "$tmp/arch.csv" --port "$tmp/tabled" \
        --machine "$tmp/table.txt"
    grep -q ' begun' "$tmp/tabled.log" && job_fails "the machine has begun the job"
    [ "$(grep -c '^[0-9]' "$tmp/tabled.csv")" = 0 ] || job_fails "the machine has moved"
    table 'y.min = 5\n'
    one_line 65 'table.txt:1: y.min is 5, but the table has no size there: give y.travel' \
        "$loft" plan "$tmp/arch.csv" --machine "$tmp/table.txt"
}
