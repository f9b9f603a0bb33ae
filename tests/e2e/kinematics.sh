# tests/e2e/kinematics.sh -- machines that are not cartesian
# SPDX-License-Identifier: MIT

# carries KIND BOUND OPTIONS..: draw on it; the error of the tool is at most the tolerance plus
# BOUND, the effect of the steps of its motors
carries() {
    local kind=$1 bound=$2 worst; shift 2
    kinematics "$kind"
    machine "$kind" --speed fast --once --machine "$tmp/$kind.txt"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$kind" --machine "$tmp/$kind.txt" \
        --record "$tmp/$kind.csv" "$@"
    gone "$machine"
    is_empty err; says out '^drawn: 7 curves, .*as commanded$'; counted "$kind"
    worst=$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")
    awk -v w="$worst" -v b="$bound" 'BEGIN { exit !(w != "" && w > 0 && w <= 0.005 + b) }' \
        || job_fails "$kind: worst path error \`$worst\`"
    run 0 "$loft" plot "$tmp/small.csv" --record "$tmp/$kind.csv" -o "$tmp/$kind.png"
    says out "path error $worst mm at worst"
    says "$kind.csv" "^# kinematics = $kind"
}
# A motor errs by half a step at a tick and half a step for the slots between. corexy: 1/320 mm in
# total. delta: 4 steps of 1/800 mm, at the edge of this drawing. polar: one step of radius, 1/320
# mm, and one of 1/400 degree, 65 mm from the pole.
case_kinematics_corexy()        { carries corexy 0.0032; carries hbot 0.0032 --num f64; }
case_kinematics_delta()         { carries delta 0.0050; }
case_kinematics_polar()         { carries polar 0.0043; }
case_kinematics_points() {
    carries delta 0.0050 --points
    carries polar 0.0043 --points --num f32
}
case_kinematics_planned_there() {
    carries corexy 0.0032 --plan chip
    carries delta 0.0050 --plan chip
    carries polar 0.0043 --plan chip
}
case_kinematics_cut_off() {
    kinematics delta
    machine there "${starving[@]}" --halt 1000 --machine "$tmp/delta.txt"
    job=("$loft" stream "$tmp/small.csv" --port "$tmp/there" --machine "$tmp/delta.txt" --feed 60)
    drawing_on=there
    cut_off 1000
    run 0 "${job[@]}"
    says err '^resuming at item'
    says out 'as commanded$'
    local end; end=$(sed -n 's/.* \(steps .* as commanded\)$/\1/p' "$tmp/out")
    run 0 "${job[@]}"; says out "$end"
    run 0 "${job[@]}" --park; says out 'steps 0 0 0 as commanded'
}
case_kinematics_plan() {
    local kind
    for kind in corexy delta polar; do
        kinematics $kind
        run 0 "$loft" plan "$tmp/small.csv" --machine "$tmp/$kind.txt" --csv 500 -o "$tmp/rows" \
            --plot "$tmp/$kind.svg"
        is_empty err
        # The tool's rows: velocity is the slope of the position, acceleration that of the velocity.
        # In a span of one tick, rounding to 2^-16 mm changes the acceleration of a motor by at most
        # 12 * 2^-16 mm / tick^2 = 183 mm/s2, and the slope over two ticks by
        # 3 * 2^-16 mm / tick^2 = 46; the average is a hundredth. The feed holds, also for travels.
        awk -F, 'NR == 1 { next }
            NR > 2 && $1 - t > 0.0019 && $1 - t < 0.0021 {
                for (i = 2; i < 8; i++) {
                    d = ($i - o[i]) / ($1 - t) - ($(i + 3) + o[i + 3]) / 2
                    if (d < 0) d = -d
                    if (d > (i < 5 ? 0.05 : 230)) {
                        print "row " NR " column " i " is off by " d
                        exit bad = 1
                    }
                    if (i > 4) off += d * d
                }
                n++
            }
            {
                t = $1; for (i = 2; i <= NF; i++) o[i] = $i
                v = sqrt($5 ^ 2 + $6 ^ 2 + $7 ^ 2)
                if (v > 100.3 || ($4 < 0.001 && v > 30.1)) {
                    print "row " NR ": " v " mm/s"
                    exit bad = 1
                }
            }
            END {
                if (!bad && sqrt(off / 3 / n) > 5) {
                    print "acceleration is off by " sqrt(off / 3 / n) " on the average"
                    bad = 1
                }
                exit bad || n < 2000 || !($2 > 59.99 && $2 < 60.01 && $3 > 29.99 && $3 < 30.01 &&
                    $4 > 0.99 && $4 < 1.01)
            }' "$tmp/rows" >"$tmp/why" ||
            job_fails "$kind: $(cat "$tmp/why") $(tail -1 "$tmp/rows")"
        says out '^drawn  *180\.270 '; says out '[abc] jerk [0-9]'
    done
}
case_kinematics_refused() {
    bad_kind() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "$2" "$loft" plan "$tmp/small.csv" --machine "$tmp/bad.txt"
    }
    bad_kind 'kinematics = scara\n' \
        'bad.txt:1: write kinematics = cartesian, corexy, hbot, delta or polar'
    bad_kind '# a\nkinematics = delta\narm_length = 90\n' \
        'bad.txt:2: kinematics = delta needs delta_radius as well'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 90\n' \
        'bad.txt:3: arms of 90 mm do not reach'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 50\nb.tower_angle = 200\n' \
        'bad.txt:4: two towers at 210 and 200 degrees'
    bad_kind 'arm_length = 90\nkinematics = polar\n' \
        'bad.txt:1: arm_length is for kinematics = delta, and this machine is polar'
    bad_kind 'y.center = 90\n' \
        'bad.txt:1: center is for kinematics = delta or polar, and this machine is cartesian'
    bad_kind 'kinematics = delta\narm_length = 90\ndelta_radius = 50\n' \
        'small.csv:[0-9]*: .* is beyond a delta machine like this, .* from the tower of motor'
    bad_kind 'kinematics = polar\nx.center = 60\ny.center = 20\n' \
        'small.csv:7: .* from the pole'
    printf 'arc left 30\n40 0\n0 0\n40 0\n' >"$tmp/turns.loft"
    printf 'kinematics = polar\n' >"$tmp/bad.txt"
    one_line 65 'turns.loft:1: .* motor b would be at 8[0-9.]*, of 8191' "$loft" plan \
        "$tmp/turns.loft" --machine "$tmp/bad.txt"
    kinematics delta
    one_line 65 'for these motors 0.0012 mm are 0.000[56][0-9]*: give --tol' "$loft" plan \
        "$tmp/small.csv" --machine "$tmp/delta.txt" --tol 0.0012
    kinematics corexy; printf 'y.max_speed = 20\n' >>"$tmp/corexy.txt"     # one limit for both
    run 0 "$loft" plan "$tmp/small.csv" --machine "$tmp/corexy.txt" --total --feed 100
    awk '/^drawn/ { exit !($4 > 19.8 && $4 < 20.02) }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
