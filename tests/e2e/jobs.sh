# tests/e2e/jobs.sh -- whole drawings, as commanded
# SPDX-License-Identifier: MIT

exactly() {     # exactly MACHINE PLANNER OPTIONS..
    local m=$1 p=$2; shift 2
    machine "m$m$p" --speed fast --once --num "$m" --steps 320 --slots 80
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/m$m$p" --num "$p" --record "$tmp/m$m$p.csv" \
        "$@"
    gone "$machine"
    is_empty err; says out '^drawn: 7 curves, .*as commanded$'; says out '^line: '; counted "m$m$p"
    local worst; worst=$(sed -n 's/.*worst path error \([0-9.]*\) mm.*/\1/p' "$tmp/out")
    # the tolerance, plus on each axis half a step for the position at a tick and half a step for
    # the slots between
    awk -v w="$worst" 'BEGIN { exit !(w != "" && w <= 0.005 + sqrt(2) / 320 && w > 0) }' \
        || job_fails "worst path error \`$worst\`"
}
case_exact_q16()        { exactly q16 q16; }
case_exact_f32()        { exactly f32 f32; }
case_exact_f64()        { exactly f64 f64; }
case_exact_mixed()      { exactly f32 q16; exactly q16 f64; }
case_points()           { exactly q16 f32 --points; }
case_noisy_line()       {
    machine noisy --speed fast --once --noise 30
    draws noisy; run 0 "${job[@]}"; gone "$machine"; undisturbed
    says out 'as commanded$'; counted noisy; same_path noisy calm
}
case_two_jobs_and_park() {
    machine twice --speed fast
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice"
    says out 'steps 4800 2400 80 as commanded'
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice"
    says out 'steps 4800 2400 80 as commanded'
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/twice" --park
    says out 'steps 0 0 0 as commanded'
    kill "$machine"; gone "$machine"; counted twice
}
case_each_of_two_jobs_is_measured_alone() {
    printf '70,0,70,30,90,30,90,0\n' >"$tmp/arch.csv"
    machine both --speed fast
    for d in small arch; do
        run 0 "$loft" stream "$tmp/$d.csv" --port "$tmp/both" --record "$tmp/both.csv"
        says out 'as commanded$'
        awk '{ for (i = 1; i < NF; i++)
                   if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 80) exit 1 }' "$tmp/out" ||
            job_fails "$d: $(cat "$tmp/out")"
    done
    run 0 "$loft" plot "$tmp/arch.csv" --record "$tmp/both.csv" -o "$tmp/both.png"
    says out 'path error 0.0[01]'
}
case_dense_curves_at_115200_baud() {
    awk 'BEGIN { for (i = 0; i < 150; i++) { s = i % 2 ? 0.15 : -0.15
                 printf "%g,20,%g,%g,%g,%g,%g,20\n",
                     x + 20, x + 20.2, 20 + s, x + 20.3, 20 - s, x + 20.5
                 x += 0.5 } }' >"$tmp/squiggle.csv"
    machine dense --speed fast --line-baud 115200 --once
    run 0 "$loft" stream "$tmp/squiggle.csv" --port "$tmp/dense" --feed 60
    gone "$machine"
    counted dense
    # the machine took no longer than planned: the line has fed it in time
    local planned took
    read -r planned took < <(sed -n \
        's/.* done: .* items, \([0-9]*\) ticks in \([0-9.]*\) s.*/\1 \2/p' "$tmp/dense.log")
    awk -v p="$planned" -v t="$took" 'BEGIN { exit !(p > 4000 && 1000 * t - p < 500) }' \
        || job_fails "$planned ticks took $took s"
    awk '/^line/ { exit !($0 ~ / of 115200 baud/) }' "$tmp/out" \
        || job_fails "no share of the line: $(cat "$tmp/out")"
}
case_demo() {
    run 0 host-tools/demo.sh draw "$loft" "$tmp/small.csv" "$tmp/demo"
    says out 'worst path error 0.00[0-9]* mm, steps 19200 9600 320 as commanded$'
    says out "^picture: $tmp/demo/drawn.png"
    [ "$(head -c 4 "$tmp/demo/drawn.png" | tail -c 3)" = PNG ] || job_fails "no picture"
    one_line 64 '--tol: give --record FILE as well' "$loft" plot tests/drawings/demo.svg --tol 1
    printf '%s\n' 0,0,3,0,6,0,9,0 9,0,9,3,9,6,9,9 >"$tmp/corners.csv"
    run 0 "$loft" plot "$tmp/corners.csv" --record "$tmp/demo/pulses.csv" --tol 0.005 \
        -o "$tmp/corner.svg"
    says out ', inset: corner at 9.000,0.000$'
    one_line 66 'no such file' host-tools/demo.sh draw "$loft" "$tmp/none.svg" "$tmp/demo2"
}
case_from_a_pipe()      {
    machine pipe --speed fast --once
    run 0 sh -c "cat '$tmp/small.csv' | '$loft' stream - --port '$tmp/pipe'"
    gone "$machine"
    counted pipe
}
case_through_a_socket() {
    machine behind --speed fast --once
    "$pty" relay "$tmp/socket" "$tmp/behind" & children+=($!); disown $!
    wait_for "$tmp/socket"
    run 0 "$loft" stream "$tmp/small.csv" --port "unix:$tmp/socket"; counted behind
}
case_through_standard_streams() {
    machine std --speed fast --once
    run 0 sh -c "'$loft' stream '$tmp/small.csv' --port - <'$tmp/std' >'$tmp/std' 2>'$tmp/said'"
    gone "$machine"
    says said 'as commanded$'; counted std said
}
case_through_libserialport() {
    local serial=(env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD="$shim" "$loft" stream \
        "$tmp/small.csv" "${slowly[@]}")
    machine serial --speed fast --once
    run 0 "${serial[@]}" --port "$tmp/serial"; gone "$machine"; counted serial; is_empty err
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    one_line 69 'at 57600 baud: no machine answered' "${serial[@]}" --port "$tmp/mute" --wait 0.3 \
        --baud 57600
    machine unplugged --speed fast --halt 700
    { halted unplugged 700; kill -9 "$machine"; } & children+=($!)
    one_line 74 'the port has vanished at item [0-9]* of' "${serial[@]}" --port "$tmp/unplugged"
}
