# tests/e2e/mill.sh -- tool paths on surfaces
# SPDX-License-Identifier: MIT

# the net of a dome of 24 mm, beside the place where the machine stands
dome() {
    awk 'BEGIN { print "tensor 3 3"
                 for (i = 0; i < 4; i++) for (j = 0; j < 4; j++)
                     print 6 + 8 * i, 6 + 8 * j, (i % 3 && j % 3 ? 7 : 1) }'
}
case_mill_on_the_chip() {
    dome >"$tmp/dome.loft"
    local cut=("$loft" mill --plan chip --tool ball:6 --step 2 --feed 60 "$tmp/dome.loft")
    run 0 "${cut[@]}" --dry-run
    says out 'dome.loft:1: 1[0-9] lines of [0-9]* curves, .* in 9 items$'; says out '^planned: '
    machine chip --speed fast --once
    run 0 "${cut[@]}" --port "$tmp/chip" --log "$tmp/line"
    says out '^drawn: .* steps 0 0 0 as commanded$'; says out ' for 9 parts of a patch, '
    gone "$machine"; counted chip
    # JOB, END and these frames, 128 bytes each at most, are all that is sent but questions
    [ "$(grep -c '> CURVES' "$tmp/line")" -le 3 ] || job_fails "more than 3 frames of items"
    run 0 "$loft" mill --tool ball:6 --record "$tmp/chip.csv" -o "$tmp/left.png" "$tmp/dome.loft"
    # 0.010 of the lines, 0.005 of the plan, a step of 1/80 mm on each axis; cusps of 2 mm: 0.172
    awk '{ exit !($7 <= 0.172 + 0.037 && $12 <= 0.037) }' "$tmp/out" ||
        job_fails "not as asked: $(cat "$tmp/out")"
    machine again --speed fast --halt 500       # the sender dies, and comes back
    draws again; job=("${cut[@]}" --port "$tmp/again")
    stop_at 500 KILL; gone $sender
    goes_on; says out '^drawn: .* steps 0 0 0 as commanded$'; counted again
    same_path again chip
    { dome; printf 'tensor 1 1\n0 0 5\n0 9 5\n9 0 5\n9 9 5\n'; } >"$tmp/two.loft"
    run 0 "$loft" mill --plan chip --along u --tool ball:6 --step 9 "$tmp/two.loft" \
        --port "$tmp/again"
    [ "$(grep -c '^drawn: ' "$tmp/out")" = 2 ] || job_fails "two surfaces: $(cat "$tmp/out")"
    kill "$machine"; gone "$machine"
    machine few --speed fast --columns 2
    one_line 65 'give more --tol'       "${cut[@]}" --port "$tmp/few"
    machine none --speed fast --columns 0
    one_line 78 'leave out --plan chip' "${cut[@]}" --port "$tmp/none"
    printf 'tensor 2 2\n' >"$tmp/bowl.loft"
    printf '%s\n' '0 0 9' '0 5 9' '0 9 9' '5 0 9' '5 5 -9' '5 9 9' '9 0 9' '9 5 9' '9 9 9' \
        >>"$tmp/bowl.loft"
    one_line 65 'give a smaller --tool' "$loft" mill --plan chip --dry-run --tool ball:20 \
        "$tmp/bowl.loft"
    printf 'sphere 9\n' >"$tmp/ball.loft"
    one_line 65 'leave out --plan chip' "$loft" mill --plan chip --dry-run "$tmp/ball.loft"
    one_line 64 'give --tool ball'      "$loft" mill --plan chip --dry-run --tool flat:4 \
        "$tmp/dome.loft"
    one_line 64 'give host or chip'     "$loft" mill --plan moon "$tmp/dome.loft"
    one_line 64 'give --plan chip as'   "$loft" mill --dry-run "$tmp/dome.loft"
    one_line 64 'give --port PORT or'    "$loft" mill --plan chip "$tmp/dome.loft"
}
case_mill() {
    printf 'bicubic\n' >"$tmp/dome.loft"
    printf '%s\n' '0 0 0' '0 9 0' '0 9 6' '0 9 -6' '9 0 0' '9 9 0' '0 9 6' '0 9 -6' '9 0 6' \
                  '9 0 6' '0 0 0' '0 0 0' '9 0 -6' '9 0 -6' '0 0 0' '0 0 0' >>"$tmp/dome.loft"
    for num in q16 f64; do
        run 0 "$loft" mill --num $num --tool ball:4 --step cusp:0.1 --tol 0.02 "$tmp/dome.loft"
        is_empty err; says out '^# cuts below the surface: none, proved'
        says out '^# cusps: at most 0\.0[0-9]*, asked 0.1$'
        says out '^# left on the surfaces: at most 0\.1[01]'
        says out '^# left in hollows tighter than the tool: no more than 0\.14'
        cp "$tmp/out" "$tmp/path.loft"
        run 0 "$loft" plan "$tmp/path.loft";    says out '^in all'
    done
    run 0 "$loft" mill --tool bull:4:0.5 --step 3 --along y "$tmp/dome.loft"
    says out '^# bull:4:0.5, 6 lines'
    # along the lower border of a slope of 1.6 the ball must go 2 - 2 cos = 0.94 deeper, and half a
    # step of a cusp of 0.1 along the slope: 0.53 more; and 0.85 of its radius beside it
    printf 'tensor 1 1\n0 0 -5\n0 9 -5\n5 0 3\n5 9 3\n' >"$tmp/slope.loft"
    run 0 "$loft" mill --tool ball:4 --step cusp:0.1 "$tmp/slope.loft"
    awk '/^[-0-9]/ { if ($1 < x) x = $1; if ($3 < z) z = $3 }
         END { exit !(x < -1.69 && x > -1.75 && z < -6.4 && z > -6.5) }' "$tmp/out" ||
        job_fails "a steep border is not reached"
    run 0 "$loft" mill --tool ball:4 --step cusp:0.1 --floor -5 "$tmp/slope.loft"
    awk '/^[-0-9]/ && $3 < -5 { exit 1 }' "$tmp/out" || job_fails "below --floor"
    run 0 "$loft" mill --tool ball:4 --pattern waterline --step 1 --tol 0.05 "$tmp/dome.loft"
    # the last line is where the ball touches the lowest border, below all of the surface
    says out '^# ball:4, 4 lines'; says out '^# beside the surface: at most 0.05'
    cp "$tmp/out" "$tmp/path.loft"; run 0 "$loft" plan "$tmp/path.loft"; says out '^in all'
    for entry in ramp:5 helix:0.5:10; do
        run 0 "$loft" mill --tool ball:4 --pattern waterline --step 1 --tol 0.05 --entry $entry \
            "$tmp/dome.loft"
        says out "^# entries: .*[1-9] by a ${entry%%:*}"
    done
    one_line 64 'give straight, ramp:DEGREES' "$loft" mill --entry ramp:60 "$tmp/dome.loft"
    run 0 "$loft" mill --tool ball:4 --pattern spiral --step cusp:0.2 --tol 0.05 "$tmp/dome.loft"
    says out '^# cusps: at most 0\.[01][0-9]*, asked 0.2$'
    one_line 64 'give raster, spiral, waterline or pencil' \
        "$loft" mill --pattern round "$tmp/dome.loft"
    printf 'octant 9\n' >"$tmp/octant.loft"
    run 0 "$loft" mill --tool flat:3 --step 3 --floor 4 "$tmp/octant.loft"
    says out '^# flat:3, 5 lines'
    printf '# steps_per_mm = 10\n# slot_hz = 1000\n' >"$tmp/pulses.csv"
    awk 'BEGIN { s = 0; print ++s ",0,0,200"
                 for (y = 0; y <= 90; y += 4)
                     for (x = 0; x <= 90; x += 4) print ++s "," x "," y ",5"
               }' >>"$tmp/pulses.csv"
    printf 'tensor 1 1\n0 0 0.4\n0 9 0.4\n9 0 0.4\n9 9 0.4\n' >"$tmp/plane.loft"
    run 0 "$loft" mill --tool flat:4 --record "$tmp/pulses.csv" -o "$tmp/left.png" "$tmp/plane.loft"
    says out 'left.png: 529 places of the tool, 0.1000 mm left at worst, 0.0000 mm cut'
    printf '%s\n' 'tensor 1 1' '-9 -9 9' '-9 9 9' '9 -9 -9' '9 9 -9' 'tensor 1 1' '-9 -9 -9' \
        '-9 9 -9' '9 -9 9' '9 9 9' >"$tmp/valley.loft"
    run 0 "$loft" mill --tool ball:4 --pattern pencil --tol 0.05 "$tmp/valley.loft"
    says out '^# ball:4, 1 lines'; says out '^# cuts below the surface: none, proved'
    run 0 "$loft" mill --tool ball:4 --pattern pencil --tol 0.05 "$tmp/plane.loft"
    says out '^# ball:4, 0 lines'
    one_line 64 'pencil: is for a ball' "$loft" mill --tool flat:4 --pattern pencil \
        "$tmp/dome.loft"
    printf 'spatch 5 1\n0 9 4\n-8 3 2\n-5 -7 0\n5 -7 1\n8 3 3\n' >"$tmp/five.loft"
    printf 'line\n-3 -3\n3 -3\n3 3\n-3 3\n-3 -3\n' >"$tmp/loop.loft"
    printf 'line\n0.5 0.1\n0.9 0.1\n0.9 0.9\n0.5 0.1\n' >"$tmp/loop-uv.loft"
    for num in f32 f64; do
        run 0 "$loft" mill --num $num --tool ball:4 --step 3 --tol 0.1 "$tmp/five.loft"
        says out '^# ball:4, 8 lines'; says out '^# cuts below the surface: none, proved'
    done
    awk '/^ring/ { on = 1 } /^gb/ { on = 0 } on' tests/drawings/sided.loft >"$tmp/ring.loft"
    run 0 "$loft" mill --tool ball:20 --step 15 --tol 0.1 "$tmp/ring.loft"
    says out '^# ball:20, .* lines'; says out '^# cuts below the surface: none, proved'
    run 0 "$loft" mill --tool ball:4 --along v --step 0.25 --tol 0.1 "$tmp/plane.loft"
    says out '^# ball:4, 5 lines'; says out '^9 9 0.4'
    for way in '' --one-way; do                 # back in one chord, or in many along a line
        run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.05 $way "$tmp/dome.loft"
        awk -v way="$way" '/^[-0-9]/ { down = begun && $1 < x; if (down && back) twice++
                                       back = down; begun = 1; x = $1 }
             END { exit (way != "") == (twice > 0) }' "$tmp/out" || job_fails "mill $way"
        says out '^# cuts below the surface: none, proved'
    done
    one_line 64 'it is of a raster along x or y' "$loft" mill --one-way --pattern spiral \
        "$tmp/plane.loft"
    one_line 64 'is for --pattern raster and --step' "$loft" mill --along u "$tmp/plane.loft"
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.1 --trim "$tmp/loop.loft" "$tmp/five.loft"
    says out '^# ball:4, 4 lines'
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.1 --trim-uv "$tmp/loop-uv.loft" \
        "$tmp/plane.loft"
    says out '^1\.975 -1\.4'       # 0.7 radius beside the eighth that ends at u = 0.5
    one_line 65 'has no u and v: give' "$loft" mill --trim-uv "$tmp/loop-uv.loft" "$tmp/five.loft"
    printf 'line\n5 5\n6 5\n6 6\n5 5\n' >"$tmp/far.loft"
    one_line 65 'nothing is left inside' "$loft" mill --trim-uv "$tmp/far.loft" "$tmp/plane.loft"
    one_line 64 'give one of them' "$loft" mill --trim "$tmp/loop.loft" \
        --trim-uv "$tmp/loop.loft" "$tmp/five.loft"
    printf 'line\n0 0\n3 0\n3 3\n' >"$tmp/open.loft"
    one_line 65 'a path is open' "$loft" mill --trim "$tmp/open.loft" "$tmp/five.loft"
    sed 's/5 1/5 1 meanvalue/' "$tmp/five.loft" >"$tmp/mean.loft"
    one_line 65 'its bends have no bounds' "$loft" mill "$tmp/mean.loft"
    printf 'sphere 9\n' >"$tmp/ball.loft"
    one_line 65 'sphere: cannot be milled' "$loft" mill "$tmp/ball.loft"
    one_line 64 'is for a ball'    "$loft" mill --tool flat:4 --step cusp:0.1 "$tmp/dome.loft"
    one_line 64 'give ball:DIAMETER'      "$loft" mill --tool ball "$tmp/dome.loft"
    one_line 64 'less than a quarter'     "$loft" mill --step cusp:2 "$tmp/dome.loft"
    one_line 64 'give WIDTHxDEPTHxHEIGHT' "$loft" mill --stock 60x40 "$tmp/dome.loft"
    one_line 64 'and --stock'    "$loft" mill --plan chip --stock 6x4x2 --dry-run "$tmp/dome.loft"
    # a block: its place, ways above it, what leaves it, its picture from the place in the path
    run 0 "$loft" mill --tool ball:4 --step 3 --tol 0.05 --safe 2 --stock 14x13.5x4 --one-way \
        "$tmp/plane.loft"
    says out '^# out of --stock 14x13.5x4@-2.5,-2.25,-3.6, in one pass through all of it$'
    awk '/^[-0-9]/ { if (!n++ && $3 != 2.4) exit 1; low += $3 < 0.46; high += $3 == 2.4 }
         END { exit !(low >= 10 && high >= 10) }' "$tmp/out" || job_fails "not above the block"
    run 0 "$loft" mill --tool flat:4 --record "$tmp/pulses.csv" -o "$tmp/left.png" \
        --stock 14x13.5x4@-2.5,-2.25,-3.6 "$tmp/plane.loft"
    says out 'left.png: 529 places of the tool, 0.0000 mm left at worst, 0.0000 mm cut'
    one_line 65 ':1: tensor: reaches to x .*, 0.500 mm beyond the block: give a larger' \
        "$loft" mill --stock 8x9x4 "$tmp/plane.loft"
    one_line 65 'the lines reach to x 10.400, 0.900 mm beyond the block: .* a smaller --area' \
        "$loft" mill --tool ball:4 --step 3 --stock 10x40x4 "$tmp/plane.loft"
    one_line 65 'mm below the block: give a thicker' \
        "$loft" mill --tool ball:4 --step 3 --floor -5 --area -3,-3,12,12 \
        --stock 20x20x4 "$tmp/plane.loft"
    one_line 64 'give x, y, u or v'       "$loft" mill --along z "$tmp/dome.loft"
    one_line 64 'give --record FILE as well: it is that picture' \
        "$loft" mill -o "$tmp/path.loft" "$tmp/dome.loft"
    one_line 64 'give one of them: --record draws whole' \
        "$loft" mill --record "$tmp/a" --trim "$tmp/b" "$tmp/dome.loft"
    one_line 64 'two corners apart'       "$loft" mill --area 1,1,1,5 "$tmp/dome.loft"
    one_line 65 'no surface in it'        "$loft" mill "$tmp/small.csv"
}
