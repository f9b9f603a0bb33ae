# tests/e2e/surfaces.sh -- the commands on surfaces
# SPDX-License-Identifier: MIT

# numbers over triangles and tetrahedra whose answers are whole
case_simplex() {
    printf 'triangle 2\n0 0 0\n1 0 0\n0 1 0\n2 0 4\n1 1 0\n0 2 0\n' >"$tmp/tri.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" decide shares --num $num --of 0,0,4,0,0,4,1,2
        says out '^shares 0.25 0.25 0.5$'; says out '^area 8$'
        run 0 "$loft" decide shares --num $num --of 0,0,0,4,0,0,0,4,0,0,0,4,1,1,1
        says out '^shares 0.25 0.25 0.25 0.25$'
        run 0 "$loft" decide plane --num $num --of 0,0,3,4,5,0
        says out '^equation -4 3 0$'; says out '^distance -4$'
        run 0 "$loft" decide plane --num $num --of 0,0,1,1,0,1,0,1,1,5,5,3
        says out '^normal 0 0 1$'; says out '^distance 2$'
        run 0 "$loft" decide sphere --num $num --of=1,0,0,3,1,3,4
        says out '^value 16$'; says out '^distance 2$'; says out '^normal 0 0.6'
        run 0 "$loft" decide sphere --num $num --of=1,0,0,3,1,0,0
        says out '^distance -3$'
        printf 'bezier 2\n0 0\n3 6\n6 0\n' >"$tmp/hill.loft"
        run 0 "$loft" decide under --num $num --of 0,1 "$tmp/hill.loft"; says out '^0 12$'
        run 0 "$loft" decide under --num $num --of 1,0.5 "$tmp/hill.loft"; says out '^0 -6$'
        run 0 "$loft" decide weights --num $num --of 3,0.5
        says out '^3 0 0.125$'; says out '^1 2 0.375$'
        run 0 "$loft" decide weights --num $num --of 2,0.25,0.25
        says out '^1 1 0 0.25$'; says out '^0 0 2 0.0625$'
        run 0 "$loft" decide weights --num $num --of 1,0.25,0.25,0.25; says out '^1 0 0 0 0.25$'
        run 0 "$loft" decide solid --num $num --of 0.25,0.25,0.5,0,1,2,4
        says out '^value 2.75$'; says out '^raised 0 0.5 1 2 1 1.5 2.5 2 3 4$'
        run 0 "$loft" decide iterate --num $num --of 1,0.25,0.25,0,0,0,1,0,1
        says out '^value 0.125$'
        run 0 "$loft" decide iterate --num $num --of 0,0.25,0.25,0,0,0,1,0,1; says out '^value 0.5$'
        run 0 "$loft" decide over --num $num --of 0,0,2,0,0,2,3,3,3; says out '^integral 6$'
        run 0 "$loft" decide polar --num $num --of 1,1,0,0,1 "$tmp/tri.loft"; says out '^1 1 0$'
    done
    one_line 65 'on a line or in a plane' "$loft" decide shares --of 0,0,1,1,2,2,0,1
    one_line 65 'give a degree 0 to 9' "$loft" decide weights --of 10,0,0
}
# a grid of points of z = x y / 8 needs one bicubic patch; of a wave more; a row that is short
# A tetrahedron bent by a net of degree 3: raised it is the same, its faces close, the coordinates
# of a point are those of three fields, and its volume is that of the mesh.
case_solids() {
    awk 'BEGIN { print "tetra"
                 for (m = 0; m <= 3; m++) for (n = 0; n <= m; n++) for (l = 0; l <= n; l++) {
                     x = 3 * (m - n); y = 3 * (n - l); z = 3 * l; k++
                     print x + (k * 7) % 5 / 4, y + (k * 3) % 4 / 4, z + (k * 5) % 3 / 4 } }' \
        >"$tmp/bent.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make raise --num $num --of 2 "$tmp/bent.loft"; cp "$tmp/out" "$tmp/high.loft"
        says out '^tetra 5$'
        for file in bent high; do
            "$loft" eval --num $num --uvw 0.25,0.125,0.5,0,0,1 "$tmp/$file.loft" >"$tmp/$file.at"
            "$loft" decide volume --num $num "$tmp/$file.loft" >>"$tmp/$file.at"
        done
        paste -d' ' "$tmp/bent.at" "$tmp/high.at" |
            awk '{ for (i = 1; i <= NF / 2; i++) { d = $i - $(i + NF / 2)
                       if (d > 0.02 || d < -0.02) bad = 1 } } END { exit bad || NR != 4 }' ||
            job_fails "raised $num: $(cat "$tmp/bent.at" "$tmp/high.at")"
        for axis in 1 2 3; do
            "$loft" decide solid --num $num \
                --of="0.25,0.125,0.5$(awk -v a=$axis 'NR > 1 { printf ",%s", $a }' \
                                      "$tmp/bent.loft")"
        done 2>&1 | awk '/^value/ { printf "%s%s", sep, $2; sep = " " }
                         END { print "" }' >"$tmp/fields"
        head -1 "$tmp/bent.at" | paste -d' ' - "$tmp/fields" |
            awk '{ for (i = 1; i <= 3; i++) if (($i - $(i + 3))^2 > 1e-9) exit 1; exit NF != 6 }' ||
            job_fails "fields $num: $(cat "$tmp/fields" "$tmp/bent.at")"
    done
    run 0 "$loft" surface --num f64 --tol 0.005 -o "$tmp/bent.stl" "$tmp/bent.loft"
    says out 'Euler number 2, closed$'
    awk -v v="$(sed -n 's/^volume //p' "$tmp/bent.at")" \
        '/^volume/ { exit !(($2 + 0 - v)^2 < 0.1 && v > 50) }' "$tmp/out" ||
        job_fails "volume: $(cat "$tmp/out" "$tmp/bent.at")"
    grep -h '^centroid' "$tmp/out" "$tmp/bent.at" |
        awk 'NR == 1 { for (i = 2; i < 5; i++) c[i] = $i; next }
             { for (i = 2; i < 5; i++) if (($i - c[i]) ^ 2 > 1e-5) exit 1 } END { exit NR != 2 }' ||
        job_fails "centroid: $(cat "$tmp/out" "$tmp/bent.at")"
    run 0 "$loft" plot --control -o "$tmp/bent.png" "$tmp/bent.loft"; says out ': 4 surfaces$'
    one_line 64 'numbers: give triples' "$loft" eval --uvw 0,1 "$tmp/bent.loft"
    one_line 64 'together at most 1'    "$loft" eval --uvw 1,1,0 "$tmp/bent.loft"
    printf 'triangle 1\n0 0 0\n1 0 0\n0 1 0\n' >"$tmp/flat.loft"
    one_line 65 'uvw: is for tetra'     "$loft" eval --uvw 0,1,0 "$tmp/flat.loft"
    printf 'tetra 2\n0 0 0\n' >"$tmp/few.loft"
    one_line 65 'tetra with 1 point: give 10' "$loft" decide volume "$tmp/few.loft"
}
case_fit_surface() {
    awk 'BEGIN { for (i = 0; i <= 8; i++) { for (j = 0; j <= 9; j++) print i, j, i * j / 8
                                            print "" } }' >"$tmp/saddle.csv"
    awk 'BEGIN { for (i = 0; i <= 24; i++) { for (j = 0; j <= 20; j++)
                     print i, j, 3 * sin(i / 3) * cos(j / 4)
                     print "" } }' >"$tmp/wave.csv"
    { cat "$tmp/saddle.csv"; echo 9 9 9; } >"$tmp/short.csv"
    for num in q16 f32 f64; do
        run 0 "$loft" fit --surface --num $num --tol 0.001 "$tmp/saddle.csv"
        says out '^nurbs-surface 3 3 4 4$'; says out '^8 9 9$'
        "$loft" fit --surface --num $num --tol 0.02 "$tmp/wave.csv" >"$tmp/wave.loft"
        run 0 "$loft" eval --num $num --uv 0,0,1,1 "$tmp/wave.loft"; says out '^0 0 0$'
        run 0 "$loft" decide nearest --num $num --of 12,10,1.8189 "$tmp/wave.loft"
        awk '{ exit !($7 < 0.03) }' "$tmp/out" || job_fails "wave $num: $(cat "$tmp/out")"
    done
    # a crease: no net that the points tell comes within 0.001
    awk 'BEGIN { for (i = 0; i < 20; i++) { for (j = 0; j < 4; j++) print i / 2, 3 * j,
                     (i > 9 ? i - 9 : 0)
                     print "" } }' >"$tmp/crease.csv"
    one_line 65 'or have a crease: 13 x 4 .* come within 0.[0-9]*: give --tol 0' \
        "$loft" fit --surface --tol 0.001 "$tmp/crease.csv"
    run 0 "$loft" fit --surface --tol 0.2 "$tmp/crease.csv"
    one_line 65 'a row of 1 points after rows of 10' "$loft" fit --surface "$tmp/short.csv"
    printf '0 0 0\n1 0 0\n' >"$tmp/one.csv"
    one_line 65 '2 points in one row: give 4 or more' "$loft" fit --surface "$tmp/one.csv"
    one_line 65 'two rows or columns are one' "$loft" fit --surface \
        <(cat "$tmp/one.csv"; echo; cat "$tmp/one.csv")
}
# the wave again, in no order and turned by 30 degrees; what a plane does not show, or not all over
case_fit_scattered() {
    awk 'BEGIN { srand(7); n = 600
                 for (k = 0; k < n; k++) {
                     x = k < 100 ? (k % 10) / 9 * 10 : 10 * rand()
                     y = k < 100 ? int(k / 10) / 9 * 8 : 8 * rand()
                     z = sin(x / 2) * cos(y / 3)
                     printf "%.6f,%.6f,%.6f\n", x * cos(.5236) - y * sin(.5236),
                            x * sin(.5236) + y * cos(.5236), z } }' >"$tmp/cloud.csv"
    for num in q16 f32 f64; do
        "$loft" fit --surface --num $num --tol 0.02 "$tmp/cloud.csv" >"$tmp/cloud.loft" ||
            job_fails "cloud $num"
        grep -qE '^# .* for 600 points in no order, within 0.0[01]' "$tmp/cloud.loft" ||
            job_fails "cloud $num: $(tail -1 "$tmp/cloud.loft")"
        # a place that was no point: x = 5, y = 4
        run 0 "$loft" decide nearest --num $num --of 2.330148,5.964076,0.140792 "$tmp/cloud.loft"
        awk '{ exit !($7 < 0.03) }' "$tmp/out" || job_fails "cloud $num: $(cat "$tmp/out")"
    done
    # the same points in another order: the same surface
    sort "$tmp/cloud.csv" | "$loft" fit --surface --tol 0.02 - | tail -1 >"$tmp/sorted"
    "$loft" fit --surface --tol 0.02 "$tmp/cloud.csv" | tail -1 | diff - "$tmp/sorted" ||
        job_fails "the order counts"
    # three lines tell three control points of four; a disc leaves corners of a finer net empty
    one_line 65 'do not tell 4 of 16 control points' "$loft" fit --surface <(awk 'BEGIN {
        for (k = 0; k < 60; k++) print k % 3, k / 20, k % 3 }')
    # a disc of a plane: no net is refused, but the corners are a guess
    run 0 "$loft" fit --surface --tol 0.01 <(awk 'BEGIN {
        srand(3); for (k = 0; k < 900; k++) { x = 2 * rand() - 1; y = 2 * rand() - 1
                      if (x * x + y * y < 1) print x, y, x / 4 } }')
    grep -q 'no point is within .* where the surface is a guess' "$tmp/err" ||
        job_fails "a disc: $(cat "$tmp/err")"
    one_line 65 'do not tell [0-9]* of a finer net' "$loft" fit --surface --tol 0.002 <(awk 'BEGIN {
        srand(3); for (k = 0; k < 2000; k++) { x = 2 * rand() - 1; y = 2 * rand() - 1
            if (x * x + y * y < 1) print 20 * x, 20 * y, 5 * sqrt(1.5 - x * x - y * y) } }')
    one_line 65 'lie on a line' "$loft" fit --surface <(awk 'BEGIN { for (k = 0; k < 9; k++)
        print k, 2 * k, -k }')
    one_line 65 'noisier than --tol 1e-05.*give --tol 0.000' "$loft" fit --surface --tol 0.00001 \
        "$tmp/cloud.csv"
}
# an octant of radius 8 and the plane z = 3 meet in a quarter of a circle, a line in one place; two
# equal parabolas across each other in the diagonals of their square
case_meet() {
    printf 'octant 8\ntensor 1 1\n-3 -5 3\n-3 20 3\n20 -5 3\n20 20 3\n' >"$tmp/cut.loft"
    printf 'line\n1 2 -1\n1 2 20\n' >"$tmp/line.loft"
    printf 'octant 8\n' >"$tmp/octant.loft"
    printf 'tensor 2 1\n-4 -4 6\n-4 4 6\n0 -4 10\n0 4 10\n4 -4 6\n4 4 6\n' >"$tmp/cross.loft"
    printf 'tensor 2 1\n-4 -4 6\n4 -4 6\n-4 0 10\n4 0 10\n-4 4 6\n4 4 6\n' >>"$tmp/cross.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/cut.loft"
        awk '/^line/ { n++; next }
             { r = $1 * $1 + $2 * $2 - 55; if (r * r > 1e-6 || ($3 - 3) * ($3 - 3) > 1e-9) bad = 1 }
             $1 < 1e-4 { ends++ } $2 < 1e-4 { ends++ }
             END { exit bad || n != 1 || ends != 2 }' "$tmp/out" ||
            job_fails "arc $num: $(cat "$tmp/out")"
        cp "$tmp/out" "$tmp/arc.loft"
        run 0 "$loft" stream --dry-run "$tmp/arc.loft"
        run 0 "$loft" decide pierce --num $num --of 0.01 "$tmp/line.loft" "$tmp/octant.loft"
        awk '{ z = $NF - sqrt(59) } END { exit NR != 1 || z > 1e-3 || z < -1e-3 }' "$tmp/out" ||
            job_fails "pierce $num: $(cat "$tmp/out")"
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/cross.loft"
        awk '/^[^-0-9]/ { next }
             { d = $1 * $1 - $2 * $2; if (d > 0.05 || d < -0.05) bad = 1
               if ($1 * $1 > 15.999) corner[($1 > 0) ($2 > 0)] = 1 }
             END { exit bad || length(corner) != 4 }' "$tmp/out" ||
            job_fails "cross $num: $(cat "$tmp/out")"
    done
    # a wall stands on a plane: its border; two lines 0.22 mm apart; two planes that are one
    floor='tensor 1 1\n-12 -12 0\n-12 12 0\n12 -12 0\n12 12 0\n'
    printf "tensor 1 1\n0 0 0\n0 10 0\n0 0 10\n0 10 10\n$floor" >"$tmp/wall.loft"
    printf "tensor 2 1\n-5 -5 1\n-5 5 1\n0 -5 -1.001\n0 5 -1.001\n5 -5 1\n5 5 1\n$floor" \
        >"$tmp/near.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.001 "$tmp/wall.loft"
        awk '/^line/ { n++; next } { if ($1 || $3) bad = 1; last = $2 }
             n && first == "" { first = $2 }
             END { exit bad || n != 1 || first + last != 10 || first * last != 0 }' "$tmp/out" ||
            job_fails "wall $num: $(cat "$tmp/out")"
        run 0 "$loft" make meet --num $num --of 0.001 "$tmp/near.loft"
        [ "$(grep -c '^line' "$tmp/out")" = 2 ] || job_fails "two lines $num: $(cat "$tmp/out")"
    done
    { printf 'tensor 1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n'
      printf 'tensor 1 1\n0 0 0\n0 2 0\n2 0 0\n2 2 0\n'; } >"$tmp/one.loft"
    one_line 65 'touch along a line, or are so near each other that 0.0005 mm does not tell' \
        "$loft" make meet --num f64 --of 0.0005 "$tmp/one.loft"
    # a plane cuts a sphere in one circle over four octants; two spheres meet in one circle; lines
    # over spans end on the border
    printf 'sphere 8\n0 0 0\ntensor 1 1\n-9 -10 3\n-9 20 3\n20 -10 3\n20 20 3\n' >"$tmp/ball.loft"
    printf 'sphere 5\n0 0 0\nsphere 5\n6 0 0\n' >"$tmp/balls.loft"
    { echo 'nurbs-surface 2 2 5 4'
      awk 'BEGIN { for (i = 0; i < 5; i++) for (j = 0; j < 4; j++)
                       print 4 * i, 5 * j, (i * j * 7 + i * 3) % 5 }'
      echo 'knots u 0 0 0 1 2 3 3 3'; echo 'knots v 0 0 0 1 2 2 2'
      printf 'tensor 1 1\n-9 -10 1.5\n-9 20 1.5\n30 -10 2\n30 20 2\n'; } >"$tmp/spans.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/ball.loft"
        awk '/^line/ { n++; next }
             { r = $1 * $1 + $2 * $2 - 55; if (r * r > 1e-6) bad = 1; last = $0 }
             n == 1 && first == "" { first = $0 }
             END { exit bad || n != 1 || first != last }' "$tmp/out" ||
            job_fails "ball $num: $(cat "$tmp/out")"
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/spans.loft"
        awk 'function check() { if ($1 > 1e-3 && $1 < 15.999 && $2 > 1e-3 && $2 < 14.999) bad = 1 }
             /^line/ { if (n++) { $0 = last; check() } getline; check() } { last = $0 }
             END { $0 = last; check(); exit bad || n != 4 }' "$tmp/out" ||
            job_fails "spans $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make meet --of 0.01 "$tmp/balls.loft"
    awk '/^line/ { n++; next }
         { r = $2 * $2 + $3 * $3 - 16; if (r * r > 1e-6 || ($1 - 3) * ($1 - 3) > 1e-7) bad = 1 }
         END { exit bad || n != 1 }' "$tmp/out" || job_fails "balls: $(cat "$tmp/out")"
    run 0 "$loft" decide pierce --of 0.01 "$tmp/line.loft" "$tmp/ball.loft"
    says out '^0 0 .* v 0.17620819' ; says out ' at 1 2 3$'
    cat "$tmp/cut.loft" "$tmp/octant.loft" >"$tmp/twice.loft"
    run 0 "$loft" make meet --of 0.01 "$tmp/twice.loft"
    grep -q 'surfaces 0 and 2 coincide' "$tmp/out" || job_fails "twice: $(cat "$tmp/out")"
    # a pentagon, z = 12 - 3 (x^2 + y^2) / 100 at its net, as triangles of degree 6; the plane x = 3
    awk 'BEGIN { print "spatch 5 2"; a = atan2(0, -1)
                 for (i = 0; i < 5; i++) for (j = i; j < 5; j++) {
                     x = 10 * (cos(a * (0.5 + 0.4 * i)) + cos(a * (0.5 + 0.4 * j)))
                     y = 10 * (sin(a * (0.5 + 0.4 * i)) + sin(a * (0.5 + 0.4 * j)))
                     printf "%.9f %.9f %.9f\n", x, y, 12 - 3 * (x * x + y * y) / 100 } }' \
        >"$tmp/five.loft"
    { cat "$tmp/five.loft"; printf 'tensor 1 1\n3 -30 -9\n3 -30 30\n3 30 -9\n3 30 30\n'; } \
        >"$tmp/wall.loft"
    for num in f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/wall.loft"
        awk '/^line/ { n++; next } { if (($1 - 3) * ($1 - 3) > 1e-6) bad = 1 }
             END { exit bad || n != 1 || NR < 10 }' "$tmp/out" ||
            job_fails "wall $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make patches --num f64 "$tmp/five.loft"; cp "$tmp/out" "$tmp/parts.loft"
    [ "$(grep -c 'triangle 6' "$tmp/parts.loft")" = 5 ] || job_fails "patches: $(cat "$tmp/out")"
    for file in five parts; do
        "$loft" decide area --num f64 --of 0.01 "$tmp/$file.loft" >"$tmp/$file.txt"
    done
    awk 'FNR < NR { sum -= $3; next } { sum = $3 } END { exit !(sum < 0.1 && sum > -0.1) }' \
        "$tmp/five.txt" "$tmp/parts.txt" || job_fails "areas: $(cat "$tmp"/{five,parts}.txt)"
    { sed 's/spatch 5 2/spatch 5 2 meanvalue/' "$tmp/five.loft"; cat "$tmp/octant.loft"; } \
        >"$tmp/other.loft"
    one_line 65 'give wachspress coordinates' "$loft" make meet --of 0.01 "$tmp/other.loft"
    one_line 65 'no two surfaces meet'     "$loft" make meet --of 0.01 "$tmp/octant.loft"
    one_line 65 'a tolerance of 0'         "$loft" make meet --of 0 "$tmp/cut.loft"
    one_line 64 'give a file of curves, then one of surfaces' \
        "$loft" decide pierce --of 0.01 "$tmp/line.loft"
}
# toric patches and those with base points as tensor products: the place that is printed is that of
# `loft eval`, and the plane x = 7 cuts in it
case_quarters() {
    printf 'toric\ndomain 0 0  1 0  2 1  2 2  1 2  0 1\n0 0 0\n9 0 4 : 2\n' >"$tmp/six.loft"
    printf '0 9 1\n9 9 8 : 1 3\n18 9 2\n9 18 3\n18 18 -1 : 3\n' >>"$tmp/six.loft"
    printf 'basepoint 3 1 1 1\n6 0 1\n3 0 2\n6 3 3 : 2\n3 3 9\n0 3 2\n3 6 1\n0 6 -1\n' \
        >"$tmp/base.loft"
    for file in six.loft base.loft; do
        run 0 "$loft" decide nearest --num f64 --of 4,3,30 "$tmp/$file"
        place=$(awk '{ print $3 "," $5 }' "$tmp/out"); sed 's/.* at //' "$tmp/out" >"$tmp/near.txt"
        run 0 "$loft" eval --num f64 --uv "$place" "$tmp/$file"
        paste -d ' ' "$tmp/near.txt" "$tmp/out" |
            awk '{ for (i = 1; i < 4; i++) if (($i - $(i + 3)) ^ 2 > 1e-12) exit 1 }' ||
            job_fails "$file: the place of the nearest point: $(cat "$tmp/near.txt" "$tmp/out")"
    done
    { cat "$tmp/six.loft"; printf 'tensor 1 1\n7 -30 -9\n7 -30 30\n7 30 -9\n7 30 30\n'; } \
        >"$tmp/wall.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" make meet --num $num --of 0.01 "$tmp/wall.loft"
        awk '/^line/ { n++; next } { if (($1 - 7) * ($1 - 7) > 1e-6) bad = 1 }
             END { exit bad || n != 1 || NR < 10 }' "$tmp/out" ||
            job_fails "six, $num: $(cat "$tmp/out")"
    done
    run 0 "$loft" make patches --num f64 "$tmp/six.loft"
    [ "$(grep -c 'tensor 2 2' "$tmp/out")" = 6 ] || job_fails "quarters: $(cat "$tmp/out")"
    { printf 'toric\ndomain 0 0  10 0  0 1\n'; seq 12; } | sed 's/^[0-9]*$/& 0 0/' \
        >"$tmp/wide.loft"
    one_line 65 'higher than 9 over a side' "$loft" decide area "$tmp/wide.loft"
    printf 'octant 91.0741\n' >"$tmp/octant.loft"       # pi / 2 r^2, at a small cost
    for num in q16 f32 f64; do
        run 0 "$loft" measure --num $num "$tmp/octant.loft"; says out '^0 area 13028.95[67]'
    done
    { printf 'tensor 2 2\n0 0\n0 500\n3000 1000\n0 500\n-1500 1000\n'
      printf '0 1500\n3000 1000\n0 1500\n0 2000\n'; } >"$tmp/folded.loft"
    one_line 65 'surface 0 folds, or its weights differ, by too much for this tolerance: give a l' \
        "$loft" measure "$tmp/folded.loft"
    run 0 "$loft" measure --tol 100 "$tmp/folded.loft"
    printf 'toric\ndomain 0 0  1 0  0 1\n0 0 0 : 1 0.01\n9 0 3 : 256 30000\n0 9 4 : 256 30000\n' \
        >"$tmp/steep.loft"
    cat "$tmp/steep.loft" "$tmp/six.loft" >"$tmp/both.loft"
    one_line 65 'differ by over 2.15' "$loft" make meet --of 0.01 "$tmp/both.loft"
}
# z = (x^2 + y^2) / 8 over -8..8: the plane x + y = 4 cuts it within that plane; the silhouette from
# (1, 1, 0) is the line x + y = 0; the normal has 60 degrees to z on the circle of radius 4 sqrt 3
case_sections_and_silhouettes() {
    printf 'tensor 2 2\n-8 -8 16\n-8 0 0\n-8 8 16\n0 -8 0\n0 0 -16\n0 8 0\n' >"$tmp/bowl.loft"
    printf '8 -8 16\n8 0 0\n8 8 16\n' >>"$tmp/bowl.loft"
    lines_where() {         # EXPRESSION of x, y, z that is 0
        awk '/^line/ { n++; next } NF { x = $1; y = $2; z = $3; off = '"$1"'
               if (off > 2e-3 || off < -2e-3 || (z - (x * x + y * y) / 8) ^ 2 > 1e-8) exit 1 }
             END { exit n != 1 }' "$tmp/out" || job_fails "$num, $1: $(head -5 "$tmp/out")"
    }
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --along 1,1,0 --heights 2.8284271247 "$tmp/bowl.loft"
        lines_where 'x + y - 4'
        run 0 "$loft" contour --num $num --tol 0 --light 1,1,0 "$tmp/bowl.loft"
        lines_where 'x + y'
        run 0 "$loft" contour --num $num --tol 0 --light 0,0,5 --heights 60 "$tmp/bowl.loft"
        lines_where 'sqrt(x * x + y * y) - 4 * sqrt(3)'
    done
    printf 'sphere 5\n' >"$tmp/ball.loft"
    # the normal of a sphere has 60 degrees to z on the circle at z = r/2; it has a silhouette, as
    # have patches with n sides
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --tol 0 --light 0,0,1 --heights 60 "$tmp/ball.loft"
        awk '/^line/ { n++; next } NF { r = $1 * $1 + $2 * $2 - 18.75
                 if (r * r > 1e-5 || ($3 - 2.5) ^ 2 > 1e-6) bad = 1 } END { exit bad || n != 1 }' \
            "$tmp/out" || job_fails "isophote of a ball $num: $(head -5 "$tmp/out")"
        run 0 "$loft" contour --num $num --light 1,0,0 "$tmp/ball.loft"
        awk '/^line/ { n++; next } NF { if ($1 * $1 > 1e-6) bad = 1 } END { exit bad || n != 1 }' \
            "$tmp/out" || job_fails "silhouette of a ball $num: $(head -5 "$tmp/out")"
    done
    run 0 "$loft" contour --light 1,0,0 tests/drawings/sided.loft
    says out '^line'
    one_line 64 'a direction X,Y,Z'      "$loft" contour --along 0,0,0 "$tmp/bowl.loft"
    one_line 64 'give one of them'  "$loft" contour --along 1,0,0 --light 1,0,0 "$tmp/bowl.loft"
    one_line 65 'no normal has such'     "$loft" contour --light 0,0,1 "$tmp/bowl.loft"
}
# Parts of an octant keep its radius; spans of a NURBS surface keep its points.
case_patches_with_weights() {
    printf 'octant 20\n' >"$tmp/octant.loft"
    printf 'nurbs-surface 2 1 4 2\n0 0 0\n0 8 1\n9 0 5 : 2\n9 8 5\n20 0 0\n' >"$tmp/nurbs.loft"
    printf '20 8 3\n30 0 0\n30 8 3\n' >>"$tmp/nurbs.loft"
    for num in q16 f32 f64; do
        "$loft" make raise --num $num --of 2 "$tmp/octant.loft" >"$tmp/high.loft"
        "$loft" make split --num $num --of 0.3,0.4 "$tmp/high.loft" >"$tmp/parts.loft"
        [ "$(grep -c '^triangle 6' "$tmp/parts.loft")" = 3 ] || job_fails "$num: three parts"
        run 0 "$loft" eval --num $num --uv 0.2,0.3 "$tmp/parts.loft"
        awk 'NF { n++; off = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2) - 20; if (off ^ 2 > 1e-6) exit 1 }
             END { exit n != 3 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        "$loft" make patches --num $num "$tmp/nurbs.loft" >"$tmp/spans.loft"
        [ "$(grep -c '^tensor 2 1' "$tmp/spans.loft")" = 2 ] || job_fails "$num: two spans"
        run 0 "$loft" eval --num $num --uv 0.25,0.5,0.75,0.5 "$tmp/nurbs.loft"
        cp "$tmp/out" "$tmp/want"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/spans.loft"
        grep . "$tmp/out" | paste -d ' ' - "$tmp/want" | awk '{ for (i = 1; i <= 3; i++)
            if (($i - $(i + 3)) ^ 2 > 1e-8) exit 1 } END { exit NR != 2 }' ||
            job_fails "spans $num: $(cat "$tmp/out" "$tmp/want")"
        "$loft" make split --num $num --of 0.3,0.4 "$tmp/spans.loft" >"$tmp/parts.loft"
        [ "$(grep -c '^tensor 2 1' "$tmp/parts.loft")" = 8 ] || job_fails "$num: eight parts"
    done
    printf 'sphere 5\n' >"$tmp/ball.loft"
    "$loft" make patches "$tmp/ball.loft" >"$tmp/parts.loft"
    [ "$(grep -c '^tensor 2 2' "$tmp/parts.loft")" = 8 ] || job_fails 'eight octants of a sphere'
    run 0 "$loft" eval --uv 0.2,0.3 "$tmp/parts.loft"
    awk 'NF { n++; if ((sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2) - 5) ^ 2 > 1e-8) exit 1 }
         END { exit n != 8 }' "$tmp/out" || job_fails "octants: $(cat "$tmp/out")"
}
case_normals_and_curvatures() {         # of a sphere; of z = 32 x (10 - x) y (10 - y) / 10^4 on top
    printf 'sphere 10\n' >"$tmp/ball.loft"
    printf 'tensor 2 2\n0 0 0\n0 5 0\n0 10 0\n5 0 0\n5 5 8\n5 10 0\n10 0 0\n10 5 0\n10 10 0\n' \
        >"$tmp/hill.loft"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --normal --uv 0.2,0.3,0.7,0.6 --num $num "$tmp/ball.loft"
        awk 'function off(a, b) { return a > b ? a - b : b - a }
            { for (i = 1; i <= 3; i++) if (off($i, 10 * $(i + 3)) > 1e-4) exit 1
              if (off($7, 0.01) > 1e-6 || off($8, -0.1) > 1e-6) exit 1 }
            END { exit NR != 2 }' "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" eval --normal --num $num "$tmp/hill.loft"
        awk 'function off(a, b) { return a > b ? a - b : b - a }
            { exit off($6, 1) > 1e-6 || off($7, 0.0256) > 1e-6 || off($8, -0.16) > 1e-6 }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
    done
}
case_compare_with() {
    printf 'bezier 3\n0 0\n10 30\n40 -20\n50 10\n' >"$tmp/curve.loft"
    printf 'triangle 2\n0 0 9\n10 0 2\n0 10 5\n20 0 4\n10 10 8\n0 20 3\n' >"$tmp/tri.loft"
    printf 'tensor 1 2\n0 0 0\n0 9 4\n0 20 0\n20 0 3\n20 9 9\n20 20 0\n' >"$tmp/ten.loft"
    printf 'sphere 10\n' >"$tmp/ball.loft"
    # at most BOUND LSB
    within() {
        awk -v b="$1" '!/^#/ { n++; if (!($5 <= b)) exit 1 } END { exit !n }' "$tmp/out" ||
            job_fails "$num, bound $1: $(cat "$tmp/out")"
    }
    for num in q16 f32 f64; do
        for name in curve tri ten; do
            "$loft" make raise --num $num --of 2 "$tmp/$name.loft" >"$tmp/more.loft"
            run 0 "$loft" compare --num $num --with "$tmp/$name.loft" "$tmp/more.loft"
            within 16                   # f64: the walk of degree 5, 11
            run 0 "$loft" compare --num $num "$tmp/$name.loft"; within 16
        done
        "$loft" make split --num $num --of 0.25,0.625 "$tmp/curve.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/curve.loft" --part 0,0.25,0.625,1 \
            "$tmp/parts.loft"; within 16
        "$loft" make split --num $num --of 0.25,0.5 "$tmp/ten.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/ten.loft" --part \
            0,0,0.25,0.5,0,0.5,0.25,1,0.25,0,1,0.5,0.25,0.5,1,1 "$tmp/parts.loft"; within 4
        "$loft" make quarter --num $num "$tmp/tri.loft" >"$tmp/parts.loft"
        run 0 "$loft" compare --num $num --with "$tmp/tri.loft" --part \
            0,0,.5,0,0,.5,.5,0,1,0,.5,.5,0,.5,.5,.5,0,1,.5,.5,0,.5,.5,0 "$tmp/parts.loft"; within 4
        run 0 "$loft" compare --num $num --quadric=1,1,1,0,0,0,0,0,0,-100 "$tmp/ball.loft"
        within 4
        run 0 "$loft" compare --num $num --quadric=1,1,1,0,0,0,0,0,0,-100.01 "$tmp/ball.loft"
        awk '!/^#/ && $7 > 0.000499 && $7 < 0.00053 { n++ } END { exit n != 1 }' "$tmp/out" ||
            job_fails "a sphere that is larger by 0.0005: $(cat "$tmp/out")"
        "$loft" make continue --num $num --of 1,1 "$tmp/tri.loft" >"$tmp/next.loft"
        cat "$tmp/tri.loft" "$tmp/next.loft" >"$tmp/both.loft"
        run 0 "$loft" decide join --num $num --of 1,1 "$tmp/both.loft"; says out 'to order 2$'
        cat "$tmp/ten.loft" "$tmp/ten.loft" >"$tmp/both.loft"
        run 0 "$loft" decide join --num $num "$tmp/both.loft"; says out '^0 1 C0 no C1 no G1 no$'
    done
    one_line 64 'and --with: give one of them' \
        "$loft" compare --with "$tmp/tri.loft" --against f64 "$tmp/tri.loft"
    one_line 64 'give 10' "$loft" compare --quadric 1,2 "$tmp/ball.loft"
    one_line 64 'give 6 for each' "$loft" compare --with "$tmp/tri.loft" --part 0,0 "$tmp/tri.loft"
    one_line 65 'as many' "$loft" compare --num f64 --with "$tmp/tri.loft" "$tmp/parts.loft"
    one_line 65 'no definition here' "$loft" compare tests/drawings/sided.loft
    one_line 65 'without weights' "$loft" make quarter "$tmp/ball.loft"
}
case_make_patches_that_join() {
    for num in q16 f32 f64; do
        { printf 'coons slopes 3 3\n0 0\n10 0\n20 0\n30 0\n0 30\n10 30\n20 30\n30 30\n'
          printf '0 30 0\n0 30 6\n0 30 6\n0 30 0\n0 30 0\n0 30 -6\n0 30 -6\n0 30 0\n'
          printf '0 0\n0 10\n0 20\n0 30\n30 0\n30 10\n30 20\n30 30\n'
          for k in 1 2 3 4 5 6 7 8; do echo '30 0'; done; } >"$tmp/slopes.loft"
        "$loft" make gregory --num $num "$tmp/slopes.loft" >"$tmp/gregory.loft"
        run 0 "$loft" eval --num $num --uv 0.5,0.5 "$tmp/gregory.loft"
        [ "$(cat "$tmp/out")" = "15 15 0.5625" ] || job_fails "gregory $num: $(cat "$tmp/out")"
        run 0 "$loft" make fill --num $num "tests/drawings/ring.loft"
        cp "$tmp/out" "$tmp/fill.loft"; says out '^gb 5 5 split'
        awk '/within/ { exit !($5 < 0.001) }' "$tmp/out" ||
            job_fails "fill $num: $(sed -n 2p "$tmp/out")"
        cat "tests/drawings/ring.loft" "$tmp/fill.loft" >"$tmp/closed.loft"
        run 0 "$loft" surface --num $num -o "$tmp/closed.stl" "$tmp/closed.loft"
        printf 'nurbs-surface 2 1 3 2\n0 0 0\n0 8 1 : 2\n9 0 5\n9 8 5\n20 0 0\n20 8 3\n' \
            >"$tmp/nurbs.loft"
        sed 's/nurbs-surface.*/tensor 2 1/' "$tmp/nurbs.loft" >"$tmp/tensor.loft"
        "$loft" eval --num $num --uv 0.25,0.5 "$tmp/tensor.loft" >"$tmp/want"
        run 0 "$loft" eval --num $num --uv 0.25,0.5 "$tmp/nurbs.loft"
        paste "$tmp/want" "$tmp/out" |
            awk '{ for (i = 1; i < 4; i++) if (($i - $(i + 3))^2 > 1e-9) exit 1 }' ||
            job_fails "nurbs-surface $num: $(cat "$tmp/want" "$tmp/out")"
        run 0 "$loft" contour --num $num --heights 2 "$tmp/nurbs.loft"; says out '^line'
    done
    one_line 65 'not a tensor patch without weights' "$loft" make fill "$tmp/tensor.loft"
    printf 'tensor 1 1\n0 0\n0 1\n1 0\n1 1\n' >"$tmp/alone.loft"
    one_line 65 'leads away' "$loft" make fill "$tmp/alone.loft"
    cat "$tmp/alone.loft" "$tmp/alone.loft" >"$tmp/twice.loft"
    one_line 65 'no hole with 3 to 8 sides' "$loft" make fill "$tmp/twice.loft"
    one_line 65 'give `coons slopes 3 3`'   "$loft" make gregory "$tmp/tensor.loft"
    printf 'nurbs-surface 2 1 3 2\nknots u 0 0 1\n' >"$tmp/bad.loft"
    one_line 65 'bad.loft:1: 3 knots u for 3 points of degree 2' "$loft" eval "$tmp/bad.loft"
    printf 'nurbs-surface 2 1 2 2\n' >"$tmp/bad.loft"
    one_line 65 'bad.loft:1: not two degrees, rows and columns' "$loft" eval "$tmp/bad.loft"
}
case_surfaces_are_evaluated() {
    local corners="0 0 0;30 0 4;0 30 6;;40 0 0;70 0 4;40 30 6;;90 0 0;105 0 15;90 30 0;;"
    corners="${corners}0 50 0;30 45 0;20 68 0;;40 50 0;70 48 0;56 72 8;;102 48 0;82 68 0;82 48 20;;"
    corners="${corners}128 12 18;128 12 0;128 12 18;;118 50 0;142 50 4;118 72 4;"
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num --uv 0,0,1,0,0,1 tests/drawings/surfaces.loft
        [ "$(tr '\n' ';' <"$tmp/out")" = "$corners" ] ||
            job_fails "corners in $num: $(tr '\n' ';' <"$tmp/out")"
        run 0 "$loft" sample --num $num --n 4 tests/drawings/surfaces.loft
        [ "$(grep -c . "$tmp/out")" = $((5 * 25 + 3 * 15)) ] \
            || job_fails "$(grep -c . "$tmp/out") points in $num"
    done
    printf 'octant 20\n' | "$loft" eval --num f64 --uv 0.25,0.5 - \
        | awk '{ r = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2); exit !(r > 19.999999 && r < 20.000001) }' \
        || job_fails "the octant is not round"
    run 0 sh -c "cat tests/drawings/patch.loft | '$loft' eval -";      says out '^15 15 '
    one_line 64 'give pairs'           "$loft" eval --uv 0.5 tests/drawings/patch.loft
    one_line 64 'for curves'           "$loft" eval --t 0.5 tests/drawings/patch.loft
    one_line 64 'for surfaces'         "$loft" eval --uv 0,0 tests/drawings/curves.loft
    one_line 65 'u, v = 0.9, 0.9'      sh -c "printf 'octant 3\n' | '$loft' eval --uv 0.9,0.9 -"
    printf 'tensor 3 3\n' >"$tmp/far.loft"
    yes '30000 30000 30000' | head -15 >>"$tmp/far.loft"
    echo '0 0 40000' >>"$tmp/far.loft"
    one_line 65 'far.loft:1: tensor: ' "$loft" eval "$tmp/far.loft"
    run 0 "$loft" eval --num f32 "$tmp/far.loft"
}
case_surfaces_with_n_sides_are_used() {
    local sided=tests/drawings/sided.loft
    for num in q16 f32 f64; do
        run 0 "$loft" eval --num $num "$sided"
        [ "$(grep -c . "$tmp/out")" = 6 ] || job_fails "$(cat "$tmp/out")"
        run 0 "$loft" sample --num $num --n 2 "$sided"
        [ "$(grep -c . "$tmp/out")" = $((9 * (5 + 6 + 6 + 5 + 6 + 7))) ] \
            || job_fails "$(grep -c . "$tmp/out") points in $num"
        run 0 "$loft" surface --num $num --n 8 -o "$tmp/sided.stl" "$sided"
        says out ': 6 surfaces, [0-9]* triangles$'
    done
    run 0 "$loft" plot "$sided" --control --heights 4,8 -o "$tmp/sided.svg"
    says out 'sided.svg: 6 surfaces$'
    run 0 "$loft" plot "$sided" --curvature gauss --contours 5 -o "$tmp/sided.pdf"
    says out 'sided.pdf: 6 surfaces$'
    one_line 65 'u, v = 2, 0'           "$loft" eval --uv 2,0 "$sided"
    one_line 64 'for surfaces'          "$loft" plot --contours 5 tests/drawings/curves.loft
    one_line 65 'n.loft:2: not a point' sh -c \
        "printf 'gb 5 3\n1 x\n' >'$tmp/n.loft'; '$loft' eval '$tmp/n.loft'"
}
# A separate reader checks sizes, indices, unit normals on the right side, and the area and volume
# of a sphere. For an eighth of it, a rational triangle (Farin, Piper, Worsey 1987), the normals
# equal the points.
case_meshes_are_read_back() {
    printf 'sphere 20\n1 2 3\n' >"$tmp/ball.loft"
    run 0 "$loft" surface --n 64 -o "$tmp/ball.stl" "$tmp/ball.loft"
    says out ': 1 surface, 8064 triangles$'
    run 0 "$loft" surface --n 64 -o "$tmp/ball.ply" "$tmp/ball.loft"
    python3 - >"$tmp/eighth.loft" <<'PY'
from math import sqrt
a, b, g = 1 - sqrt(1 / 3), (1 + sqrt(1 / 3)) / 2, 1 - (5 - sqrt(2)) * (7 - sqrt(3)) / 46
k, e, m, i = 4 * sqrt(3) * (sqrt(3) - 1), 3 * sqrt(2), 4, sqrt(2 / 3) * (3 + 2 * sqrt(2) - sqrt(3))
net = [(1, 0, 0), (1, a, 0), (1, 0, a), (b, b, 0), (1, g, g), (b, 0, b), (a, 1, 0), (g, 1, g),
       (g, g, 1), (a, 0, 1), (0, 1, 0), (0, 1, a), (0, b, b), (0, a, 1), (0, 0, 1)]
weight = [k, e, e, m, i, m, e, i, i, e, k, e, m, e, k]
print('triangle 4')
for p, w in zip(net, weight):
    print('%.15g %.15g %.15g' % tuple(20 * x for x in p), ': %.15g' % w)
PY
    run 0 "$loft" surface --num f64 --n 16 -o "$tmp/eighth.ply" "$tmp/eighth.loft"
    run 0 "$loft" surface --n 8 -o "$tmp/all.stl" tests/drawings/surfaces.loft
    for num in q16 f32 f64; do
        run 0 "$loft" surface --num $num --tol 0.05 -o "$tmp/fine.stl" "$tmp/ball.loft"
        says out 'Euler number 2, closed$'
        awk '/^volume/ { exit !($2 > 33510.33 - $4 && $2 < 33510.33 + $4 && $4 < 260) }' \
            "$tmp/out" || job_fails "$num: $(cat "$tmp/out")"
        run 0 "$loft" surface --num $num --tol 0.05 -o "$tmp/fine.ply" tests/drawings/ring.loft
        says out 'Euler number 0, not closed: [0-9]* edges open, 0 turned, 0 of'
    done
    one_line 64 'give one of them' "$loft" surface --n 8 --tol 1 "$tmp/ball.loft"
    cat >"$tmp/read.py" <<'PY'
import math, struct, sys
tmp = sys.argv[1]
def corners_of_stl(name):
    data = open(name, 'rb').read()
    count, = struct.unpack_from('<I', data, 80)
    assert len(data) == 84 + 50 * count, 'size of ' + name
    faces = (struct.unpack_from('<12f', data, 84 + 50 * i) for i in range(count))
    return [(f[:3], [f[3:6], f[6:9], f[9:12]]) for f in faces]
def corners_of_ply(name):
    head, data = open(name, 'rb').read().split(b'end_header\n', 1)
    elements = (line.split() for line in head.split(b'\n') if line.startswith(b'element'))
    size = {word[1]: int(word[2]) for word in elements}
    v = [struct.unpack_from('<6f', data, 24 * i) for i in range(size[b'vertex'])]
    assert len(data) == 24 * len(v) + 13 * size[b'face'], 'size of ' + name
    faces = [struct.unpack_from('<B3I', data, 24 * len(v) + 13 * i) for i in range(size[b'face'])]
    assert all(f[0] == 3 for f in faces)
    return v, [(None, [v[i][:3] for i in f[1:]]) for f in faces]
def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def check_ball(faces):
    area = volume = 0
    for normal, corner in faces:
        c = [[x - o for x, o in zip(p, (1, 2, 3))] for p in corner]
        assert all(abs(math.hypot(*p) - 20) < 1e-4 for p in c), 'a corner off the sphere'
        n = cross([b - a for a, b in zip(c[0], c[1])], [b - a for a, b in zip(c[0], c[2])])
        assert dot(n, c[0]) > 0, 'a triangle turned inside'
        area += math.hypot(*n) / 2
        volume += dot(cross(c[0], c[1]), c[2]) / 6
        if normal:
            assert abs(math.hypot(*normal) - 1) < 1e-5, 'a wrong normal'
            assert dot(normal, n) > 0.999 * math.hypot(*n), 'a wrong normal'
    assert 0.995 < area / (4 * math.pi * 400) < 1, area
    assert 0.99 < volume / (4 / 3 * math.pi * 8000) < 1, volume
check_ball(corners_of_stl(tmp + '/ball.stl'))
vertices, faces = corners_of_ply(tmp + '/ball.ply')
check_ball(faces)
for v in vertices:
    off = max(abs(v[i] - (1, 2, 3)[i] - 20 * v[i + 3]) for i in range(3))
    assert off < 1e-2, 'a normal of a vertex'
for v in corners_of_ply(tmp + '/eighth.ply')[0]:
    assert abs(math.hypot(*v[:3]) - 20) < 1e-5, 'a corner off the eighth'
    assert max(abs(v[i] / 20 - v[i + 3]) for i in range(3)) < 1e-6, 'a normal of the eighth'
assert len(corners_of_stl(tmp + '/all.stl')) > 8 * 64
PY
    run 0 python3 "$tmp/read.py" "$tmp"
    one_line 64 'ends with .stl or .ply' "$loft" surface -o "$tmp/a.obj" "$tmp/ball.loft"
    one_line 73 'cannot be written'      "$loft" surface -o "$tmp/none/a.stl" "$tmp/ball.loft"
    one_line 65 'no surface in it'       "$loft" surface tests/drawings/curves.loft
    one_line 66 'no such file'           "$loft" surface "$tmp/nothing.loft"
}
case_surfaces_are_drawn() {
    run 0 "$loft" plot tests/drawings/surfaces.loft --control --size 500 -o "$tmp/a.png"
    says out 'a.png: 8 surfaces$'
    run 0 "$loft" plot tests/drawings/patch.loft --curvature gauss --view 30,60,2 -o "$tmp/b.svg"
    run 0 "$loft" plot tests/drawings/patch.loft --wire --control -o "$tmp/c.pdf"
    run 0 sh -c "printf 'tensor 1 1\n0 0\n0 1\n1 0\n1 1\n' |
        '$loft' plot --curvature largest -o '$tmp/d.png' -"
    [ "$(head -c 4 "$tmp/a.png" | tail -c 3)" = PNG ] && [ -s "$tmp/b.svg" ] \
        && [ -s "$tmp/c.pdf" ] && [ -s "$tmp/d.png" ] || job_fails "no picture"
    one_line 64 'gauss, mean or largest' "$loft" plot --curvature red tests/drawings/patch.loft
    one_line 64 'AROUND,UP'              "$loft" plot --view 30 tests/drawings/patch.loft
    one_line 64 'AROUND,UP'              "$loft" plot --view 30,100 tests/drawings/patch.loft
    one_line 64 'are for drawings'       "$loft" plot --comb tests/drawings/patch.loft
    one_line 64 'are for surfaces'       "$loft" plot --wire tests/drawings/curves.loft
    one_line 64 'give one of them'       "$loft" plot --wire --curvature mean \
        tests/drawings/patch.loft
    one_line 64 '.png, .svg or .pdf'     "$loft" plot -o "$tmp/a.gif" tests/drawings/patch.loft
}
case_bad_surfaces() {
    bad_surface() {
        printf "$1" >"$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$2" "$loft" eval "$tmp/bad.loft"
        one_line 65 "$tmp/bad.loft:$2" "$loft" surface "$tmp/bad.loft"
    }
    bad_surface 'tensor 3\n' \
        '1: not two degrees: give two whole numbers from 0 to 9'
    bad_surface 'tensor 1 1\n0 0 0\n'                   '1: tensor with 1 point: give 4'
    bad_surface 'tensor 1 0\n0 0 0\n1 0 0\n2 0 0\n'     '4: more than the 2 points of this tensor'
    bad_surface 'tensor 0 1\n0 0 0\n1 0 0 : 300\n' \
        '3: not a point: `x y z` or `x y z : weight`, a weight of 1/256 to 256'
    bad_surface '# c\ntriangle\n0 0 0\n1 0 0\n' \
        '2: triangle with 2 points: give 1 or 3'
    bad_surface 'coons bent 3 3\n'                      '1: not a kind of Coons patch'
    bad_surface 'coons 1 1\n0 0\n1 0\n0 1\n1 1\n0 0\n0 1\n2 0\n1 1\n' '1: coons: '
    bad_surface 'pn\n0 0 0\n'                          '2: not a point: `x y z : nx ny nz`'
    bad_surface 'sphere\n'                              '1: no radius'
    bad_surface 'sphere 3\n0 0 0\n1 1 1\n'              '3: more than the 1 point of this sphere'
    bad_surface 'octant -3\n'                           '1: no radius'
    bad_surface 'octant 3\nbezier 3\n'                  '2: `bezier` is not a kind of surface'
    printf 'line\n0 0\n1 1\ntensor 1 1\n' >"$tmp/bad.loft"
    local remedy='surfaces go into a file of their own'
    one_line 65 "bad.loft:4: \`tensor\` is not a kind of curve: $remedy" \
        "$loft" eval "$tmp/bad.loft"
}
case_waterlines() {
    local num
    printf 'sphere 10\n1 2 3\n' >"$tmp/ball.loft"
    # circles of radius 8 and 6 around the centre, closed, once about each
    for num in q16 f32 f64; do
        run 0 "$loft" contour --num $num --heights 9,-5 --n 64 --csv "$tmp/ball.loft"; is_empty err
        awk -F, 'NR == 1 { if ($0 != "surface,height,curve,x,y,z") exit bad = 1; next }
            { r = sqrt(($4 - 1) ^ 2 + ($5 - 2) ^ 2) - ($2 == 9 ? 8 : 6); z = $6 - $2
              if (r * r > 4e-6 || z * z > 1.1e-6) exit bad = 1
              if ($3 != curve) { curve = $3; curves++; first = $4 " " $5 }
              last = $4 " " $5; n[$2]++ }
            END { exit bad || curves != 1 || last != first || n[9] < 100 || n[-5] < 100 }' \
            curve=0 "$tmp/out" || job_fails "$num: $(head -3 "$tmp/out")"
    done
    run 0 "$loft" contour --n 20 --levels 5 tests/drawings/sided.loft
    cp "$tmp/out" "$tmp/lines.loft"
    says out '^line  *# surface 6, z = 15, closed$'
    run 0 "$loft" measure --num f64 "$tmp/lines.loft"
    says out '	line	'
    run 0 sh -c "'$loft' contour --n 64 --flat tests/drawings/patch.loft |
        '$loft' stream - --dry-run"
    says out '^planned: [0-9]* curves, 0\.39[0-9] m drawn'
    for heights in 5,6.5 20; do
        run 0 "$loft" plot "$tmp/ball.loft" --view -90,60 --heights $heights \
            -o "$tmp/at-$heights.svg"
    done
    [ "$(grep -c 'fill:rgb(42%' "$tmp/at-5,6.5.svg") $(grep -c 'fill:rgb(42%' "$tmp/at-20.svg")" = \
        "10 0" ] || job_fails "$(grep -c 'fill:rgb(42%' "$tmp/at-5,6.5.svg") labels"
    # a ridge of 0.06 mm between two rings; a peak within one of the cells; a saddle at the height
    # 0.001 - (x x + y y - 25)^2 / 100 on -10..10, of control points of x^2 and x^4
    awk 'BEGIN { print "tensor 4 4"
         split("100 0 -33.3333333333333333 0 100", c, " ")
         split("10000 -10000 10000 -10000 10000", d, " ")
         for (i = 1; i <= 5; i++) for (j = 1; j <= 5; j++) {
             square = d[i] + d[j] + 2 * c[i] * c[j] - 50 * (c[i] + c[j]) + 625
             printf "%g %g %.15g\n", 5 * i - 15, 5 * j - 15, 0.001 - square / 100 }
         }' >"$tmp/ridge.loft"
    run 0 "$loft" contour --num f64 --heights 0 --tol 0.00001 "$tmp/ridge.loft"; is_empty err
    [ "$(grep -c '^line.*closed$' "$tmp/out")" = 2 ] || job_fails "ridge: $(grep line "$tmp/out")"
    awk '/^[-0-9]/ { r = sqrt($1 * $1 + $2 * $2) - 5; r = r < 0 ? -r : r
                     if (r < 0.02 || r > 0.05) exit 1 }' "$tmp/out" || job_fails "not at 5 +- 0.032"
    awk 'BEGIN { print "tensor 2 2"; split("0.2209 -0.2491 0.2809", c, " ")
         for (i = 1; i <= 3; i++) for (j = 1; j <= 3; j++)
             printf "%g %g %.9g\n", 5 * i, 5 * j, 0.0005 - c[i] - c[j] }' >"$tmp/peak.loft"
    run 0 "$loft" contour --num f64 --n 16 --heights 0 "$tmp/peak.loft"; is_empty err
    [ "$(grep -c '^line.*closed$' "$tmp/out")" = 1 ] || job_fails "peak: $(cat "$tmp/out")"
    printf 'tensor 1 1\n-1 -1 1\n-1 1 -1\n1 -1 -1\n1 1 1\n' >"$tmp/saddle.loft"
    run 0 "$loft" contour --num f64 --n 16 --heights 0 "$tmp/saddle.loft"
    says err 'saddle.loft:1: tensor: near .*: lines may be joined otherwise there: give another'
    one_line 65 'reach from z = -7 to 13 mm' "$loft" contour --heights 20 "$tmp/ball.loft"
    one_line 65 'no surface in it'          "$loft" contour "$tmp/small.csv"
    one_line 64 'give one of them'          "$loft" contour --heights 1 --levels 3 "$tmp/ball.loft"
}
