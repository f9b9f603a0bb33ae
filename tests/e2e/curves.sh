# tests/e2e/curves.sh -- the commands on curves
# SPDX-License-Identifier: MIT

case_eval_and_sample() {
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0,0.25,1 --points "0,0 4,8 12,0"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;2.25 3;12 0;" ] \
            || job_fails "eval $num: $(cat "$tmp/out")"
        run 0 "$loft" sample --num $num --n 4 --points "0,0 4,8 12,0"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;2.25 3;5 4;8.25 3;12 0;" ] \
            || job_fails "sample $num: $(cat "$tmp/out")"
    done
    run 0 sh -c "'$loft' sample --n 2 '$tmp/small.csv' | '$loft' flatten - | wc -l"
    says out '^ *[0-9]'
}
case_fit() {
    awk 'BEGIN { print "x,y"
                 for (i = 0; i <= 80; i++) print (i < 40 ? i : 40) "," (i < 40 ? 0 : i - 40)
                 for (i = 0; i < 90; i++) {
                     a = i / 90; print 40 * cos(a) "," 40 * sin(a) + 0.01 * (i % 3) }
                }' >"$tmp/measured.csv"
    sed -n '1,82p' "$tmp/measured.csv" >"$tmp/corner.csv"
    for num in q16 f32 f64; do                              # two lines, and the corner between them
        run 0 "$loft" fit --num $num "$tmp/corner.csv"; says out '^40 0$'
        [ "$(grep -c '^bezier 3' "$tmp/out")" = 2 ] || job_fails "corner $num: $(cat "$tmp/out")"
        cp "$tmp/out" "$tmp/fitted.loft"
        run 0 "$loft" eval --num $num --t 0.5 "$tmp/fitted.loft"
    done
    sed '2,82d' "$tmp/measured.csv" >"$tmp/arc.csv"
    run 0 "$loft" fit --tol 0.03 "$tmp/arc.csv"; says out ' for 90 points, within 0.0[12]'
    run 0 "$loft" fit --closed --tol 0.03 "$tmp/arc.csv"
    "$loft" fit --tol 0.03 "$tmp/arc.csv" | "$loft" measure - >"$tmp/out" || job_fails "no pipe"
    one_line 65 'measured.csv:2: not a point: give lines'  sh -c "printf 'x,y\n1,2,3,4\n' \
                >'$tmp/measured.csv'; exec '$loft' fit '$tmp/measured.csv'"
    printf '1 2\n' >"$tmp/one.txt"
    one_line 65 'one.txt:1: one point: give two or more'   "$loft" fit "$tmp/one.txt"
    # an ellipse that is rounded to 0.1 mm: refused, and within the tolerance that the refusal names
    awk 'BEGIN { for (i = 0; i < 70; i++) { a = 2 + 6.2 * i / 70; printf "%.1f,%.1f\n", 20 * cos(a),
                                            12 * sin(a) } }' >"$tmp/round.csv"
    one_line 65 'round.csv:1: the points are noisier than --tol 0.01.*: give --tol' \
        "$loft" fit "$tmp/round.csv"
    local enough; enough=$(grep -o 'give --tol [0-9.]*' "$tmp/err" | cut -d' ' -f3)
    "$loft" fit --tol "$enough" "$tmp/round.csv" |
        "$loft" measure - >"$tmp/out" || job_fails "the tolerance that is named"
    awk '/^all/ { exit !($3 > 98 && $3 < 103 && $4 > -20.2 && $7 < 12.2) }' "$tmp/out" ||
        job_fails "an ellipse: $(cat "$tmp/out")"
    printf '0 0\n40000 0\n40001 1\n' >"$tmp/far.txt"
    one_line 65 'far.txt'   "$loft" fit --num q16 "$tmp/far.txt"
}

case_parts() {
    printf 'bezier 3\n0 0\n0 20\n20 20\n20 0\n' >"$tmp/curve.loft"
    printf 'bezier 3\n10 0 0\n10 5 2\n5 10 4\n0 10 6\n' >"$tmp/space.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make split --num $num --of 0.3,0.7 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/parts.loft"
        run 0 "$loft" make join --num $num --of 0.001 "$tmp/parts.loft"
        cp "$tmp/out" "$tmp/one.loft"
        [ "$(grep -c bezier "$tmp/one.loft")" = 1 ] || job_fails "join $num: $(cat "$tmp/out")"
        run 0 "$loft" eval --num $num --t 0.5 "$tmp/one.loft"
        awk '{ exit !(($1 - 10)^2 + ($2 - 15)^2 < 1e-8) }' "$tmp/out" || job_fails "join $num"
        run 0 "$loft" make raise --num $num --of 4 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/high.loft"
        run 0 "$loft" make lowest --num $num --of 0.001 "$tmp/high.loft"; says out '^bezier 3$'
        run 0 "$loft" make lowest --num $num --of 100 "$tmp/high.loft";   says out '^bezier 1$'
        run 0 "$loft" make cut --num $num --of 0.25,0.75 "$tmp/curve.loft"; says out '^3.125 11.25$'
        run 0 "$loft" decide frame --num $num --of 0,1 "$tmp/space.loft"
        says out '^0 t 0 along 0 0.92847669.* normal -1 0 0$'; says out '^0 t 1 .* normal 0 -1 0$'
        run 0 "$loft" decide power --num $num --of=1,0,0,1;         says out '^power 1 -3 3 0$'
        run 0 "$loft" decide integral --num $num --of=0,0,1,0,0.5;  says out '^part 0.04166666'
        run 0 "$loft" decide smooth --num $num --of=0,0,1,1,0.5;    says out '^value 0.25$'
    done
    printf '0 0\n2 2\n4 0\n\n4 0\n6 2\n8 0\n' >"$tmp/corner.txt"
    run 0 "$loft" make join --of 0.001 "$tmp/corner.txt"
    [ "$(grep -c bezier "$tmp/out")" = 2 ] || job_fails "a corner is no curve"
    one_line 65 'cut: no curve has that part: give two'  "$loft" make cut --of 2,3 "$tmp/curve.loft"
    one_line 65 'join: a tolerance of 0: give one above' "$loft" make join --of 0 "$tmp/curve.loft"
}

case_decide() {
    for num in q16 f32 f64; do
        run 0 "$loft" decide positive --num $num --of=1,-1,1      # (1 - 2 t)^2
        [ "$(tr '\n' ';' <"$tmp/out")" = \
            "positive no;nonnegative yes;roots 1;minimum 0;elevations more than 60;" ] ||
            job_fails "positive $num: $(cat "$tmp/out")"
        # (t (1 - t))^31 (1 - 2 t)^2, and a little less in the middle
        local ends; ends=$(printf '0,%.0s' {1..31})
        run 0 "$loft" decide positive --num $num --of="${ends}1.03125,-2,1.03125,${ends%,}"
        says out '^nonnegative yes$'; says out '^roots 3$'
        run 0 "$loft" decide positive --num $num --of="${ends}1.03125,-2.0001,1.03125,${ends%,}"
        says out '^nonnegative no$'; says out '^roots 4$'
        run 0 "$loft" decide copositive --num $num --of=1,-1,1,1,-1,1,-1,1,1,1,-1,1,1,-1,1
        says out 'copositive yes'                               # Horn's matrix
        printf '0 0\n2 4\n4 0\n\n0 2\n4 2\n' >"$tmp/touch.txt"
        run 0 "$loft" decide meet --num $num "$tmp/touch.txt"
        [ "$(cat "$tmp/out")" = "0 1 0.5 0.5 multiplicity 2" ] ||
            job_fails "meet $num: $(cat "$tmp/out")"
        printf '0 0\n2 4\n4 0\n\n0 2.0001\n4 2.0001\n' >"$tmp/miss.txt"
        run 0 "$loft" decide meet --num $num "$tmp/miss.txt"
        [ ! -s "$tmp/out" ] || job_fails "miss $num: $(cat "$tmp/out")"
        printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : 2\n' >"$tmp/conic.loft"
        run 0 "$loft" decide conic --num $num "$tmp/conic.loft"
        says out '^0 circle, ellipse'; says out '^centre 0 0'; says out '^axes 1 1'
        says out '^focus 0 0'
        printf 'rational 3\n3 0 : 3\n3 6 : 1\n-3 6 : 1\n-3 0 : 3\n' >"$tmp/half.loft"
        run 0 "$loft" decide conic --num $num "$tmp/half.loft"
        says out '^0 circle, ellipse'; says out '^centre 0 0'; says out '^axes 3 3'
        # thirds and roots are rounded: within that it is a conic, and a circle
        { printf 'rational 3\n3 0 : 1\n3 6 : 0.33333333333333331\n'
          printf -- '-3 6 : 0.33333333333333331\n-3 0 : 1\n'; } >"$tmp/third.loft"
        run 0 "$loft" decide conic --num $num "$tmp/third.loft"
        says out '^0 circle, ellipse, within the rounding of its numbers$'
        printf 'rational 2\n1 0 : 1\n1 1 : 0.70710678118654757\n0 1 : 1\n' >"$tmp/root.loft"
        run 0 "$loft" decide conic --num $num "$tmp/root.loft"
        says out '^0 circle, ellipse, within the rounding of its numbers$'
        # arcs of 25, 45 and 80 degrees whose centres and axes are not of few digits
        printf '%s\n' 'rational 3' \
            '-11.53005547059864 55.480433327128871 : 1' \
            '-6.3282725932867567 52.772556557076051 : 0.98419733807995557' \
            '-1.8358845429645156 49.002995400945437 : 0.98419733807995557' \
            '1.7341336116494119 44.350457160348824 : 1' 'rational 3' \
            '9.9971446647455728 0.86914183790399191 : 1' \
            '10.032314248604656 1.6746577410483194 : 0.94925302167419112' \
            '9.7565491166590661 2.4323162141417538 : 0.94925302167419112' \
            '9.2118320104303724 3.0267706228469806 : 1' 'rational 2' \
            '9.9971446647455728 0.86914183790399191 : 1' \
            '10.051347890232957 2.1105998064357712 : 0.92387953251128674' \
            '9.2118320104303724 3.0267706228469806 : 1' 'rational 3' \
            '80.848888922025552 -56.069690242163489 : 1' \
            '89.007684480352296 -65.792964160041066 : 0.84402962874598531' \
            '101.5076844803523 -67.997051418896859 : 0.84402962874598531' \
            '112.5 -61.650635094610962 : 1' >"$tmp/arcs.loft"
        run 0 "$loft" decide conic --num $num "$tmp/arcs.loft"
        [ "$(grep -c '^[0-9] circle, ellipse, within the rounding of its n' "$tmp/out")" = 4 ] ||
            job_fails "arcs $num: $(cat "$tmp/out")"
        printf 'rational 3\n3 0 : 1\n3 6 : 0.334\n-3 6 : 0.333\n-3 0 : 1\n' >"$tmp/none.loft"
        run 0 "$loft" decide conic --num $num "$tmp/none.loft"
        says out '^0 no conic within the rounding of its numbers$'
        # a cusp is no crossing
        printf 'bezier 3\n0 0\n50 50\n0 50\n50 0\n' >"$tmp/cusp.loft"
        run 0 "$loft" decide loops --num $num --of 0.001 "$tmp/cusp.loft"; is_empty out
        # a whole circle; its other part, with a negative weight; weights of 0: a line, a hyperbola
        { printf 'rational 2\n5 0 : 1\n5 5 : 1\n0 5 : 2\n'
          printf 'rational 2\n0 5 : 2\n-5 5 : 1\n-5 0 : 1\n'
          printf 'rational 2\n-5 0 : 1\n-5 -5 : 1\n0 -5 : 2\n'
          printf 'rational 2\n0 -5 : 2\n5 -5 : 1\n5 0 : 1\n'; } >"$tmp/whole.loft"
        run 0 "$loft" decide conic --num $num "$tmp/whole.loft"
        [ "$(grep -c '^[0-3] circle, ellipse$' "$tmp/out")" = 4 ] ||
            job_fails "whole circle $num: $(cat "$tmp/out")"
        printf 'rational 2\n5 0 : 1\n5 5 : -1\n0 5 : 2\n' >"$tmp/other.loft"
        run 0 "$loft" decide conic --num $num "$tmp/other.loft"
        says out '^0 circle, ellipse$'; says out '^centre 0 0$'; says out '^axes 5 5$'
        printf 'rational 2\n5 0 : 1\n5 5 : 0\n0 5 : 1\n' >"$tmp/zero.loft"
        run 0 "$loft" decide conic --num $num "$tmp/zero.loft"
        says out '^0 line$'
        printf 'rational 2\n1 0 : 1\n0 0 : 0\n0 1 : -1\n' >"$tmp/infinite.loft"
        run 0 "$loft" decide conic --num $num "$tmp/infinite.loft"
        says out '^0 line, through infinity$'
        printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : -1\n' >"$tmp/branches.loft"
        run 0 "$loft" decide conic --num $num "$tmp/branches.loft"
        says out '^0 hyperbola, through infinity$'
        printf 'tensor 1 1\n0 0 0\n0 2 0\n2 0 0\n2 2 0\n' >"$tmp/plane.loft"
        run 0 "$loft" decide ray --num $num --of=1,0.5,5,0,0,-2 "$tmp/plane.loft"
        [ "$(cat "$tmp/out")" = "0 t 2.5 u 0.5 v 0.25" ] ||
            job_fails "ray $num: $(cat "$tmp/out")"
        run 0 "$loft" decide nearest --num $num --of=5,1,0 "$tmp/plane.loft"
        says out '^0 u 1 v 0.5 distance 3 at 2 1 0'
        # of an octant the distance from its radius; of a B-spline surface that is this plane twice;
        # of a tetrahedron of triangles a sixth of its box
        printf 'octant 20\n' >"$tmp/octant.loft"
        run 0 "$loft" decide nearest --num $num --of=8,9,12 "$tmp/octant.loft"
        awk '{ off = $7 - 3; exit !(off < 1e-3 && off > -1e-3) }' "$tmp/out" ||
            job_fails "octant $num: $(cat "$tmp/out")"
        printf 'nurbs-surface 1 1 3 2\n0 0 0\n0 2 0\n2 0 0\n2 2 0\n4 0 0\n4 2 0\n' >"$tmp/two.loft"
        run 0 "$loft" decide ray --num $num --of=2,0.5,5,0,0,-2 "$tmp/two.loft"
        [ "$(cat "$tmp/out")" = "0 t 2.5 u 0.5 v 0.25 edge" ] ||
            job_fails "ray of two spans $num: $(cat "$tmp/out")"
        run 0 "$loft" decide area --num $num "$tmp/two.loft"; says out '^0 area 8$'
        run 0 "$loft" measure --num $num "$tmp/two.loft"; says out '^0 area 8$'
        for face in '0 0 0 0 6 0 6 0 0' '0 0 0 6 0 0 0 0 6' '6 0 0 0 6 0 0 0 6' \
                    '0 6 0 0 0 0 0 0 6'; do
            printf 'triangle 1\n%d %d %d\n%d %d %d\n%d %d %d\n' $face
        done >"$tmp/tetra.loft"
        run 0 "$loft" decide volume --num $num "$tmp/tetra.loft"; says out '^volume 36$'
        says out '^centroid 1.5 1.5 1.5$'
    done
    printf 'sphere 10\n' >"$tmp/ball.loft"
    for num in q16 f32 f64; do          # an octant of that ball, the ball
        run 0 "$loft" decide area --num $num --of 0.05 "$tmp/octant.loft"
        awk '{ exit !(($3 - 628.3185)^2 < 0.003) }' "$tmp/out" ||
            job_fails "area $num: $(cat "$tmp/out")"
        run 0 "$loft" decide volume --num $num --of 0.05 "$tmp/ball.loft"
        awk '/^volume/ { exit !(($2 - 4188.79)^2 < 0.2) }' "$tmp/out" ||
            job_fails "$num: $(cat "$tmp/out")"
        awk '/^centroid/ { n++; d = $2 ^ 2 + $3 ^ 2 + $4 ^ 2 } END { exit n != 1 || d > 1e-6 }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
    one_line 65 'not a tolerance' "$loft" decide area --of=-1 "$tmp/octant.loft"
    printf 'ring 3 2\n0 0\n5 0\n9 0\n5 5\n0 9\n0 5\n3 3 1\n' >"$tmp/sided.loft"
    one_line 65 'a ring is not rational' "$loft" decide area "$tmp/sided.loft"
    one_line 65 'a ring is not rational' "$loft" measure "$tmp/sided.loft"
    one_line 64 'holds surfaces: .loft make meet' "$loft" measure --intersect "$tmp/sided.loft"
    one_line 64 'nearest: give x,y,z' "$loft" measure --nearest 1,2 "$tmp/sided.loft"
    one_line 64 'not known to decide'  "$loft" decide nothing
    one_line 65 'degree 129: give 1 to 129 coefficients, to degree 128' \
        "$loft" decide convex --of "$(printf '0,%.0s' {1..129})1"
    one_line 64 'positive: --of has 0 numbers: give Bernstein'   "$loft" decide positive
    one_line 64 'bend: --of has 0 numbers: give parameters'      "$loft" decide bend -
    one_line 64 'ray: --of has 3 numbers: give a point and'      "$loft" decide ray --of=1,2,3 -
    one_line 65 'holds no surface' "$loft" decide ray --of=1,2,3,4,5,6 "$tmp/touch.txt"
}
# (t, t^2, t^3): derivatives, curvature 2 and torsion 3 at 0; a saddle z = x y; a sphere has no
# principal directions
case_local() {
    printf 'bezier 3\n0 0 0\n1 0 0\n2 1 0\n3 3 3\n' >"$tmp/screw.loft"
    printf 'tensor 1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 1\n' >"$tmp/saddle.loft"
    printf 'sphere 2\n0 0 0\n' >"$tmp/sphere.loft"
    printf 'line\n0 0\n4 0\n' >"$tmp/flat.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0 --deriv "$tmp/screw.loft"
        says out '^0 0 0 3 0 0 0 6 0 0 0 18$'
        run 0 "$loft" eval --num $num --t 0 --curvature --frame "$tmp/screw.loft"
        says out '^0 0 0 0.6666666[67]* 1 1 0 0 0 1 0 0 0 1$'
        run 0 "$loft" eval --num $num --uv 0,0 --deriv --normal --curvature "$tmp/saddle.loft"
        says out '^0 0 0 1 0 0 0 1 0 0 0 0 0 0 1 0 0 0 0 0 1 -1 0 -1 1$'
        run 0 "$loft" eval --num $num --uv 0,0 --frame "$tmp/saddle.loft"
        awk '{ x = $4 * $5 + 0.5; y = $7 * $8 - 0.5; if (x * x + y * y > 1e-8) bad = 1 }
             END { exit bad }' "$tmp/out" || job_fails "directions $num: $(cat "$tmp/out")"
        run 0 "$loft" eval --num $num --frame "$tmp/sphere.loft"; says out ' none$'
        run 0 "$loft" eval --num $num --normal --curvature "$tmp/flat.loft"; says out '^2 0 none 0$'
    done
}
# a parabola as a B-spline with five inner knots needs none
case_thin() {
    { echo 'bspline 2'
      printf '0 0\n0.5 0\n1.5 2\n2.5 6\n3.5 12\n4.5 20\n5.5 30\n6 36\n'
      echo 'knots 0 0 0 1 2 3 4 5 6 6 6'; } >"$tmp/many.loft"
    sed 's/2.5 6/2.5 9/' "$tmp/many.loft" >"$tmp/bump.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make thin --num $num --of 0.001 "$tmp/many.loft"
        says out '^bspline 2$'; says out '^6 36$'; says out '^knots 0 0 0 6 6 6$'
        run 0 "$loft" make thin --num $num --of 0.001 "$tmp/bump.loft"
        says out '^2.5 9$'; says out '^knots 0 0 0 1 2 3 4 6$'; says out '^knots 6 6$'
    done
    # with weights: none goes for nothing; the last one would need a weight out of range
    { echo 'nurbs 2'
      printf '1 0 : 1\n1 0.6 : 1\n0.6 1 : 1.25\n0 1 : 1.5\n-1 1 : 1\n-1 0 : 2\n'
      echo 'knots 0 0 0 1 2 3 4 4 4'; } >"$tmp/weighted.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make thin --num $num --of 0 "$tmp/weighted.loft"
        says out '^nurbs 2$'; says out '^knots 0 0 0 1 2 3 4 4'
        run 0 "$loft" make thin --num $num --of 100 "$tmp/weighted.loft"
        says out '^nurbs 2$'; says out '^knots 0 0 0 3 4 4 4$'; says out '^1 0 : 1$'
    done
    one_line 65 'is no `bspline`' "$loft" make thin --of 1 tests/drawings/curves.loft
    # a knot more changes nothing: the points at 0 and 1.5 are as before
    for num in q16 f32 f64; do
        "$loft" eval --num $num --t 0,1.5,6 "$tmp/many.loft" >"$tmp/before"
        run 0 "$loft" make insert --num $num --of 1.5,1.5,4 "$tmp/many.loft"
        says out '^bspline 2$'; says out '^knots 0 0 0 1 1.5 1.5 2 3$'
        cp "$tmp/out" "$tmp/more.loft"
        run 0 "$loft" eval --num $num --t 0,1.5,6 "$tmp/more.loft"
        diff "$tmp/before" "$tmp/out" >/dev/null || job_fails "insert $num: $(cat "$tmp/out")"
    done
    one_line 65 'a knot beyond the curve' "$loft" make insert --of 7 "$tmp/many.loft"
}
# (2 t - 1)^5 over t has a flat inflection; a circle is none; a loop of degree 5, and one of two
# pieces
case_shape_of_any_degree() {
    printf 'bezier 5\n0 -1\n1 1\n2 -1\n3 1\n4 -1\n5 1\n' >"$tmp/flat.loft"
    printf 'rational 2\n1 0 : 1\n1 1 : 1\n0 1 : 2\n' >"$tmp/round.loft"
    printf 'bezier 5\n0 0\n8 0\n16 16\n-8 16\n0 0\n8 0\n' >"$tmp/loop.loft"
    printf 'line\n0 0\n8 0\n8 8\n4 -4\n' >"$tmp/bent.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide inflections --num $num "$tmp/flat.loft"
        says out '^0 t 0.5 inflection, multiplicity 3$'
        run 0 "$loft" decide inflections --num $num "$tmp/round.loft"
        [ ! -s "$tmp/out" ] || job_fails "round $num: $(cat "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.001 "$tmp/loop.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "loop $num: $(cat "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.001 "$tmp/bent.loft"
        says out '^0 2 0.666666' ; says out ' at 5.3333'
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "bent $num: $(cat "$tmp/out")"
    done
    one_line 65 'a tolerance of 0' "$loft" decide loops --of 0 "$tmp/loop.loft"
    # a cubic with a loop, its projection by 1 + x / 8; two quarters of a circle and a part that
    # crosses the first one
    printf 'bezier 3\n0 0\n8 8\n-4 8\n4 0\n' >"$tmp/plain.loft"
    printf 'rational 3\n0 0 : 1\n4 4 : 2\n-8 16 : 0.5\n2.6666667 0 : 1.5\n' >"$tmp/weighted.loft"
    { printf 'nurbs 2\n5 0 : 1\n5 5 : 0.70710678\n0 5 : 1\n-5 5 : 0.70710678\n-5 0 : 1\n'
      printf -- '-4 -1 : 1\n8 4 : 1\nknots 0 0 0 1 1 2 2 3 3 3\n'; } >"$tmp/arch.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/plain.loft"
        cut -d' ' -f3,4 "$tmp/out" >"$tmp/at"
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/weighted.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "weighted $num: $(cat "$tmp/out")"
        paste -d' ' "$tmp/at" "$tmp/out" |
            awk '{ exit !(($1 - $5) ^ 2 + ($2 - $6) ^ 2 < 1e-10) }' ||
            job_fails "weighted $num: $(cat "$tmp/at" "$tmp/out")"
        run 0 "$loft" decide loops --num $num --of 0.002 "$tmp/arch.loft"
        [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "arch $num: $(cat "$tmp/out")"
        says out '^0 2 '
    done
}
case_figures() {
    for num in q16 f32 f64; do
        run 0 "$loft" figures --num $num --brief --no-pictures -o "$tmp/$num"; is_empty err
        says out "numbers in $num, 0 of them beyond their bounds"
    done
    for name in $("$loft" figures --list | cut -d ' ' -f 1); do
        grep -q "<h2 id=\"$name\">" "$tmp/q16/index.html" || job_fails "$name is missing"
    done
    run 0 "$loft" figures --brief -o "$tmp/few" family triangle-split wachspress
    for name in family.svg triangle-split.png wachspress.png; do
        [ -s "$tmp/few/$name" ] || job_fails "$name is missing"
    done
    run 0 "$loft" figures -o "$tmp/one" polygon
    [ "$(ls "$tmp/one")" = "$(printf 'index.html\npolygon.loft\npolygon.svg')" ] ||
        job_fails "other files than those of one figure: $(ls "$tmp/one")"
    one_line 64 'no such figure' "$loft" figures -o "$tmp/one" nothing
    one_line 73 'name another folder' "$loft" figures -o "$tmp/one/polygon.svg/x"
}
case_make() {
    for num in q16 f32 f64; do
        printf 'bezier 2\n0 0\n4 8\n12 0\n' >"$tmp/curve.loft"
        run 0 "$loft" make raise --num $num --of 2 "$tmp/curve.loft"
        cp "$tmp/out" "$tmp/raised.loft"; says out '^bezier 4'
        run 0 "$loft" make lower --num $num --of 2 "$tmp/raised.loft"
        grep -v '#' "$tmp/out" | cmp -s - "$tmp/curve.loft" ||
            job_fails "raised and lowered, $num: $(cat "$tmp/out")"
        run 0 "$loft" make split --num $num --of 0.25 "$tmp/curve.loft"
        [ "$(sed -n 4p "$tmp/out")" = "2.25 3" ] || job_fails "split $num: $(cat "$tmp/out")"
        "$loft" make reverse --num $num "$tmp/out" >"$tmp/back.loft"
        run 0 "$loft" make reverse --num $num "$tmp/back.loft"
        [ "$(sed -n 2p "$tmp/out")" = "0 0" ] || job_fails "reverse $num: $(cat "$tmp/out")"
        printf 'bezier 1\n0 0 3\n9 0 3\nbezier 2\n0 9 0\n4 9 0\n9 9 0\n' >"$tmp/two.loft"
        for verb in ruled skin; do
            "$loft" make $verb --num $num "$tmp/two.loft" >"$tmp/$verb.loft" 2>"$tmp/err"
            run 0 "$loft" eval --num $num --uv 0,0.5 "$tmp/$verb.loft"
            [ "$(cat "$tmp/out")" = "0 4.5 1.5" ] ||
                job_fails "$verb $num: $(cat "$tmp/out" "$tmp/err")"
        done
        printf 'bezier 1\n5 0 0\n5 0 4\n' >"$tmp/line.loft"
        "$loft" make revolve --num $num "$tmp/line.loft" >"$tmp/tube.loft"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/tube.loft"
        awk 'NF == 3 { r = sqrt($1 * $1 + $2 * $2); n++
                       if (r < 4.9999 || r > 5.0001 || $3 != 2) exit 1 }
             END { exit n != 4 }' "$tmp/out" || job_fails "revolve $num: $(cat "$tmp/out")"
    done
    one_line 64 'not known to make' "$loft" make nothing "$tmp/curve.loft"
    one_line 65 'piece 0, of degree 2, goes to degree 32: give --of 1 to 30' \
        "$loft" make raise --of 31 "$tmp/curve.loft"
    "$loft" make raise --of 30 "$tmp/curve.loft" >"$tmp/high.loft"      # for drawings
    run 0 "$loft" plot --control --comb -o "$tmp/high.svg" "$tmp/high.loft"
    run 0 "$loft" plan --total "$tmp/high.loft"; cp "$tmp/out" "$tmp/total"
    run 0 "$loft" plan --total "$tmp/curve.loft"
    cmp -s "$tmp/out" "$tmp/total" || job_fails "a raised curve: $(cat "$tmp/out" "$tmp/total")"
    one_line 65 'only drawings take up to 32' "$loft" eval --t 0.5 "$tmp/high.loft"
    printf 'rational 2\n1 0\n1 1 : 0.7\n0 1\n' >"$tmp/weighted.loft"
    one_line 65 'with weights, goes to degree 18' "$loft" make raise --of 17 "$tmp/weighted.loft"
    one_line 64 'raise: --of has 2 numbers' "$loft" make raise --of 1,2 "$tmp/curve.loft"
    printf 'triangle 2\n0 0 9\n10 0 2\n0 10 5\n20 0 4\n10 10 8\n0 20 3\n' >"$tmp/tri.loft"
    printf 'tensor 1 2\n0 0 0\n0 9 4 : 2\n0 20 0\n20 0 3\n20 9 9\n20 20 0\n' >"$tmp/ten.loft"
    one_line 65 'surface 0, of degree 2, goes to degree 32: give --of 1 to 30' \
        "$loft" make raise --of 31 "$tmp/tri.loft"
    one_line 65 'with weights, goes to degree 18' "$loft" make raise --of 17 "$tmp/ten.loft"
    "$loft" make raise --of 30 "$tmp/tri.loft" >"$tmp/high.loft"
    "$loft" make raise --of 16 "$tmp/ten.loft" >>"$tmp/high.loft"
    [ "$(grep -c . "$tmp/high.loft")" = $((1 + 561 + 1 + 18 * 19)) ] || job_fails 'raised nets'
    run 0 "$loft" plot --control --curvature mean -o "$tmp/high.png" "$tmp/high.loft"
    one_line 65 'only `loft plot` takes up to 32' "$loft" eval --uv 0.5,0.5 "$tmp/high.loft"
}
case_make_surfaces_of_curves() {
    for num in q16 f32 f64; do
        printf 'bezier 2\n5 0\n5 5\n0 5\nline\n0 0 0\n20 0 0\n40 0 0\n' >"$tmp/pipe.loft"
        head -4 "$tmp/pipe.loft" >"$tmp/curve.loft"
        "$loft" make sweep --num $num --of 3 "$tmp/pipe.loft" >"$tmp/swept.loft"
        run 0 "$loft" eval --num $num --uv 1,1 "$tmp/swept.loft"
        [ "$(grep . "$tmp/out" | tr '\n' ,)" = "20 -5 0,40 -5 0," ] ||
            job_fails "sweep $num: $(cat "$tmp/out")"
        printf 'arc left\n%d 0 %d\n0 0 %d\n0 %d %d\n' 20 0 0 20 0 20 9 9 20 9 >"$tmp/four.loft"
        printf 'line\n20 0 0\n20 0 9\nline\n0 20 0\n0 20 9\n' >>"$tmp/four.loft"
        "$loft" make coons --num $num "$tmp/four.loft" >"$tmp/coons.loft"
        run 0 "$loft" eval --num $num --uv 0.3,0.5 "$tmp/coons.loft"
        awk 'NF { r = sqrt($1 * $1 + $2 * $2); n++
               if (r < 19.9998 || r > 20.0002 || $3 < 4.4999 || $3 > 4.5001) exit 1 }
             END { exit n < 1 }' "$tmp/out" || job_fails "coons $num: $(cat "$tmp/out")"
        "$loft" make gordon --num $num --of 3 "tests/drawings/network.loft" >"$tmp/gordon.loft"
        run 0 "$loft" eval --num $num --uv 1,1 "$tmp/gordon.loft"
        [ "$(head -1 "$tmp/out")" = "20 20 12" ] || job_fails "gordon $num: $(cat "$tmp/out")"
        for i in 0 10 20; do
            printf 'line\n%d 0 0\n%d 10 %d\n%d 20 %d\n' $i $i $i $i $((2 * i))
        done >"$tmp/grid.loft"
        for verb in adini bessel; do
            "$loft" make $verb --num $num "$tmp/grid.loft" >"$tmp/$verb.loft"
            run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/$verb.loft"
            awk 'NF { n++; off = $3 - $1 * $2 / 10; if (off > 1e-4 || off < -1e-4) exit 1 }
                 END { exit n != 4 }' "$tmp/out" || job_fails "$verb $num: $(cat "$tmp/out")"
        done
        run 0 "$loft" make ferguson --num $num "$tmp/grid.loft"; says out '^bicubic'
    done
    one_line 65 'stations' "$loft" make sweep --of 1 "$tmp/pipe.loft"
    one_line 65 'starts along the direction' "$loft" make sweep --of 3,1,0,0 "$tmp/pipe.loft"
    one_line 65 'give two paths' "$loft" make sweep --of 3 "$tmp/curve.loft"
    one_line 65 'give four' "$loft" make coons "$tmp/pipe.loft"
    sed '$s/.*/0 20 8/' "$tmp/four.loft" >"$tmp/apart.loft"
    one_line 65 'curves 2 and 4 do not meet' "$loft" make gordon --of 2 "$tmp/apart.loft"
    one_line 65 '2 curves, 2 of them along u' "$loft" make gordon --of 2 "$tmp/pipe.loft"
    one_line 65 'curve 3 has 2 points, the first one 3' "$loft" make bessel "$tmp/four.loft"
}
case_flatten_keeps_its_tolerance() {
    for num in q16 f32 f64; do
        run 0 "$loft" flatten --num $num --tol 0.05 --points "0,0 0,50 50,50 50,0"
        cp "$tmp/out" "$tmp/chords"
        run 0 "$loft" sample --num f64 --n 2000 --points "0,0 0,50 50,50 50,0"
        awk 'NR == FNR { x[n] = $1; y[n++] = $2; next }
             { best = 1e9
               for (i = 1; i < n; i++) {
                   dx = x[i]-x[i-1]; dy = y[i]-y[i-1]
                   u = (($1-x[i-1])*dx + ($2-y[i-1])*dy) / (dx*dx + dy*dy)
                   u = u < 0 ? 0 : u > 1 ? 1 : u
                   ex = $1-x[i-1]-u*dx; ey = $2-y[i-1]-u*dy; d = sqrt(ex*ex + ey*ey)
                   if (d < best) best = d }
               if (best > worst) worst = best }
             END { exit !(n > 5 && n < 40 && worst > 0 && worst <= 0.05) }' \
            "$tmp/chords" "$tmp/out" || job_fails "$num leaves the curve"
    done
}
case_compare_holds_the_bounds() {
    run 0 "$loft" compare --points "0,0 100,200 300,-100 400,55.5"
    awk '/^q16/ { n++; if ($5 > 1) bad = 1 } /^q16 .* walk/ && $5 > 0.52 { bad = 1 }
         END { exit bad || n != 2 }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" compare --num q16 --against f64 --n 500 --points "0,0 100,200 300,-100 400,55.5"
    [ "$(grep -c '^q16  *f64' "$tmp/out")" = 2 ] || job_fails "$(cat "$tmp/out")"
}
# fields of row N of $tmp/out, a blank between
row() {
    awk -F'\t' -v n="$1" -v from="$2" \
        'NR == n + 1 { for (i = from; i <= NF; i++) printf "%s%s", $i, i < NF ? " " : "" }' \
        "$tmp/out"
}
case_measure() {
    local num
    # all digits of the type
    run 0 "$loft" measure --num f64 --points "0,0 1,0 2,1 3,3"; says out '4\.436828742660'
    run 0 "$loft" measure --points "0,0 9000,0 9000,12000.0001"; says out '17112\.320[0-9][0-9]'
    printf 'arc left\n10 0\n0 0\n-10 0\nline\n-10 0\n10 0\nrational\n10 0\n10 10 : 0.7071\n0 10\n' \
        >"$tmp/m.loft"
    for num in q16 f32 f64; do
        # half a circle, its chord, a quarter again: 10 pi, 20, 5 pi
        run 0 "$loft" measure --num $num "$tmp/m.loft"
        awk -F'\t' 'function near(x, y) { return x - y < 2e-3 && y - x < 2e-3 }
             /:1/ { n += near($3, 31.4159265) && near($4, -10) && near($5, 0) &&
                         near($6, 10) && near($7, 10) }
             /:5/ { n += near($3, 20) && near($5, 0) && near($7, 0) }
             /:8/ { n += near($3, 15.7079632) }
             /^all/ { n += near($3, 67.1238898) }
             END { exit n != 4 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --nearest 0,4 "$tmp/m.loft"
        [ "$(awk -F'\t' 'NR > 1 { printf "%.2f %.2f;", $3, $6 }' "$tmp/out")" = \
            "0.50 6.00;0.50 4.00;1.00 6.00;" ] || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --joins "$tmp/m.loft"
        [ "$(row 1 3 | cut -c1-11) $(row 2 3 | cut -c1-11)" = "1 0 0 1 0 0 1 0 0 1 0 0" ] \
            || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" measure --num $num --intersect "$tmp/m.loft"
        awk -F'\t' 'NR > 1 { n[$1 $5]++; seen[$12]++ }
             END { exit !(length(n) == 3 && seen["overlap"] >= 1 && seen["meet"] >= 2) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        # one overlap is one row, with numbers on both: the quarter is the first half of the arc
        awk -F'\t' 'function near(x, y) { return x != "-" && x - y < 2e-3 && y - x < 2e-3 }
             /:1\t.*:8\t/ { n++; good = near($2, 0) && near($4, 0.5) && near($6, 0) &&
                                         near($8, 1) && $12 == "overlap" }
             END { exit !(n == 1 && good && NR == 5) }' "$tmp/out" ||
            job_fails "$num: $(cat "$tmp/out")"
        # the foot, and not its distance alone, is within the tolerance
        for at in 0.3,0.5 3,4 -0.2,0.1 -7,0.01 40,30; do
            run 0 "$loft" measure --num $num --nearest "$at" "$tmp/m.loft"
            echo "$at" | awk -F'[,\t]' \
                'NR == FNR { r = 10 / sqrt($1 * $1 + $2 * $2); x = r * $1; y = r * $2; next }
                 /:1/ { good = $4 - x < 1e-3 && x - $4 < 1e-3 && $5 - y < 1e-3 && y - $5 < 1e-3 }
                 END { exit !good }' - "$tmp/out" ||
                job_fails "$num $at: $(cat "$tmp/out")"
        done
    done
    printf 'bezier\n0 0\n10 20\n20 -20\n30 0\n\nbezier\n0 1\n30 1\n' >"$tmp/x.loft"
    run 0 "$loft" measure --intersect "$tmp/x.loft"
    [ "$(grep -c 'meet$' "$tmp/out")" = 2 ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" measure --joins --num f64 --tol 1e-9 --points "0,0 1,1 2,0"
    [ "$(wc -l <"$tmp/out")" = 1 ] || job_fails "one curve has no joint"
    printf 'bezier\n0 0\n1 1\n2 1\n3 0\nbezier\n3 0\n4 -1\n5 -3\n7 0\n' >"$tmp/j.loft"
    run 0 "$loft" measure --joins "$tmp/j.loft"
    [ "$(row 1 3)" = "1 1 1 1 1 1 1 2" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" measure --nearest 3,0,4 --points "0,0,0 10,0,0"
    [ "$(row 1 4)" = "3 0 0 4" ] || job_fails "$(cat "$tmp/out")"
    one_line 64 'give x,y or x,y,z'   "$loft" measure --nearest 3 "$tmp/m.loft"
    one_line 64 'give one of them'    "$loft" measure --joins --intersect "$tmp/m.loft"
    printf 'line\n0 0\n1 1\nbezier\n0 0\n40000 0\n' >"$tmp/far.loft"
    one_line 65 'far.loft:4: .*f64'   "$loft" measure "$tmp/far.loft"
    one_line 66 'none.loft'           "$loft" measure "$tmp/none.loft"
}
case_measure_offset() {
    run 0 "$loft" measure --offset -5 --tol 0.01 tests/drawings/demo.svg; is_empty err
    printf 'bezier\n0 0\n0 50\n50 50\n50 0\n' >"$tmp/arch.loft"
    run 0 "$loft" measure --offset 5 --tol 0.01 "$tmp/arch.loft"; cp "$tmp/out" "$tmp/beside.loft"
    run 0 "$loft" sample --num f64 --n 8 "$tmp/beside.loft"
    grep . "$tmp/out" | tr ' ' , >"$tmp/points"
    while read -r at; do        # every point has the requested distance
        run 0 "$loft" measure --num f64 --tol 1e-4 --nearest "$at" "$tmp/arch.loft"
        awk -F'\t' 'NR == 2 { exit !($6 > 4.989 && $6 < 5.011) }' "$tmp/out" \
            || job_fails "$at: $(cat "$tmp/out")"
    done < <(awk 'NR % 7 == 1' "$tmp/points")
    [ "$(wc -l <"$tmp/points")" -gt 30 ] || job_fails "$(wc -l <"$tmp/points") points"
    run 0 "$loft" plot "$tmp/beside.loft" -o "$tmp/beside.svg"
    run 0 "$loft" stream "$tmp/beside.loft" --dry-run; says out '^planned:'
}
case_curves_of_every_kind() {
    local all=tests/drawings/curves.loft kinds
    run 0 "$loft" compare "$all"
    kinds=$(awk '/^q16/ { $1=$2=$3=$4=$5=$6=$7=$8=$9=""; print }' "$tmp/out" \
        | sort -u | tr -s ' \n' ' ')
    local expected=" arc bezier bspline cardinal hermite3 hermite5 line"
    expected="$expected natural chord natural uniform nurbs parabola rational "
    [ "$kinds" = "$expected" ] || job_fails "kinds:$kinds"
    awk '/^q16 .* eval / && $5 > ($10 == "rational" || $10 == "nurbs" ? 2 : 1) { exit 1 }
         /^q16 .* walk / && $5 > 2 { exit 1 }
         /^f32 .* eval / && $5 > 1 { exit 1 } /^f64 .* eval / && $5 > 32 { exit 1 }' "$tmp/out" ||
        job_fails "beyond the bounds: $(cat "$tmp/out")"
    run 0 "$loft" compare --num q16 --against f64 --n 64 "$all"
    run 0 sh -c "cat '$all' | '$loft' eval -"
    [ "$(grep -c . "$tmp/out")" = "$(grep -c '^[a-z]' "$all" | awk '{ print $1 - 2 }')" ] \
        || job_fails "$(cat "$tmp/out")"      # two lines of knots
}
case_curves_through_pipes() {
    printf 'natural\n0 0\n10 10\n20 0\narc left\n20 0\n20 10\n30 10\n' >"$tmp/two.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --t 0,1 "$tmp/two.loft"
        [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;10 10;;20 0;30 10;" ] \
            || job_fails "$num: $(cat "$tmp/out")"
        # one path: no empty line where the arc goes on
        run 0 "$loft" sample --num $num --n 1 "$tmp/two.loft"
        ! grep -q '^$' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        [ "$(head -3 "$tmp/out" | tr '\n' ';')$(tail -1 "$tmp/out")" = "0 0;10 10;20 0;30 10" ] ||
            job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" flatten --num $num --tol 0.01 "$tmp/two.loft"
        awk '$1 > 20.001 { d = sqrt(($1-20)^2 + ($2-10)^2) - 10
                           if (d > 1e-3 || d < -1e-3) bad = 1; n++ }
             END { exit bad || n < 5 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
    run 0 "$loft" stream "$tmp/two.loft" --dry-run
    says out '^planned: .*path within 0.00[0-9]* of 0.0050 mm'
    machine curves --speed fast --once
    run 0 "$loft" stream "$tmp/two.loft" --port "$tmp/curves" --feed 60
    gone "$machine"
    says out 'as commanded$'
    counted curves
}
case_the_page_of_the_format_is_true() {
    awk '/^```/ { on = !on; n += on; next } on && n == 1' host-tools/LOFT.md >"$tmp/page.loft"
    awk '/^```/ { on = !on; n += on; next } on && n == 2' host-tools/LOFT.md >"$tmp/patch.loft"
    run 0 "$loft" eval --uv 0,0 "$tmp/patch.loft"
    [ "$(tr '\n' ';' <"$tmp/out")" = "0 0 0;;20 0 0;" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" eval --t 0,1 "$tmp/page.loft"
    [ "$(tr '\n' ';' <"$tmp/out")" = "0 0;20 0;;20 0;30 10;" ] || job_fails "$(cat "$tmp/out")"
    run 0 "$loft" plot "$tmp/page.loft" -o "$tmp/page.svg"
}
case_shapes_are_told() {
    run 0 "$loft" eval --shape --points "0,0 20,10 -10,10 10,0"
    says out '^0.0 bezier: loop, loop from 0.112701[0-9]* to 0.887298[0-9]*, box '
    run 0 "$loft" eval --shape --points "0,0 10,10 0,10 10,0"
    says out '^0.0 bezier: cusp, cusp at 0.5, box 0 0 to 10 7.5'
    # what the whole curve has and its piece has not
    run 0 "$loft" eval --shape --points "0,0 0,0.55 0.45,1 1,1"
    says out '^0.0 bezier: arch (loop outside 0..1), box '
    run 0 "$loft" eval --shape --points "0,0 1,0 2,1 3,3.5"
    says out '^0.0 bezier: arch (.*outside 0..1), box '
    run 0 "$loft" eval --shape --points "0,0 1,1"
    says out '^0.0 bezier: line, box 0 0 to 1 1$'
    run 0 "$loft" eval --shape --points "0,0 1,1 2,0"
    says out '^0.0 bezier: parabola, box 0 0 to 2 0.5'
    run 0 "$loft" eval --shape tests/drawings/curves.loft
    says out ' natural uniform: serpentine (an inflection outside 0..1), inflection at 1.377'
    one_line 64 'give one of them' "$loft" eval --shape --t 0.5 --points "0,0 1,1"
}
case_combs_and_knots_are_drawn() {
    run 0 "$loft" plot tests/drawings/curves.loft --comb -o "$tmp/a.png"
    says out 'a.png: [0-9]* curves$'
    run 0 "$loft" plot --comb 20 --control tests/drawings/curves.loft -o "$tmp/b.svg"
    says out 'b.svg: [0-9]* curves$'
    run 0 "$loft" plot --comb=20 -o "$tmp/c.pdf" "$tmp/small.csv"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] || job_fails "no picture"
    run 0 "$loft" plot -o "$tmp/d.svg" tests/drawings/curves.loft
    [ "$(grep -c '<path' "$tmp/b.svg")" -gt "$(grep -c '<path' "$tmp/d.svg")" ] \
        || job_fails "no comb in the picture"
    one_line 64 '--comb x' "$loft" plot --comb=x "$tmp/small.csv"
}
case_bad_curves() {
    bad_loft() {
        printf "$1" >"$tmp/bad.loft"; shift
        one_line 65 "$tmp/bad.loft:$1" "$loft" eval "$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$1" "$loft" stream --dry-run "$tmp/bad.loft"
    }
    bad_loft 'bezier 3\n0 0\n1 1\n'                      '1: bezier with 2 points: give 4'
    bad_loft '# c\n\nsnake\n'                            '3: `snake` is not a kind of curve'
    bad_loft 'line\n0 0\n1 1\nrational\n0 0\n1 1 : -1\n' '6: not a point: `x y : weight`'
    bad_loft 'natural chord\n0 0\n0 0\n1 1\n'            '1: natural chord: two points in one'
    bad_loft 'rational\n0 0 : 300\n1 1\n' \
        '2: not a point: `x y : weight`, a weight of 1/256 to 256'
    printf 'line\n0 0\n1 1 99999\n' >"$tmp/z.loft"
    one_line 65 'z.loft:1: 99999 mm is beyond' "$loft" stream --dry-run "$tmp/z.loft"
    printf 'hermite3\n0 0 : 90000 0\n1 0 : 90000 0\n' >"$tmp/far.loft"
    one_line 65 'far.loft:1: .*take --num f64' "$loft" sample "$tmp/far.loft"
    printf 'bspline 2\n0 0\n1 1\n2 0\n' >"$tmp/t.loft"
    one_line 65 't.loft:1: t = 1.5: give 0 to 1 for this bspline' "$loft" eval --t 1.5 "$tmp/t.loft"
}
