# tests/e2e/gcode.sh -- programs: G-code and text forms of a drawing
# SPDX-License-Identifier: MIT

case_export() {                         # the same drawing by way of each form
    local form
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="50mm" viewBox="0 0 90 50">
            <path d="M5 5h20C40 5 40 25 25 25z"/><circle cx="60" cy="25" r="12"/></svg>' \
        >"$tmp/export.svg"
    run 0 "$loft" export "$tmp/export.svg" --as csv; cp "$tmp/out" "$tmp/want.csv"
    for form in svg csv loft; do
        run 0 "$loft" export "$tmp/export.svg" -o "$tmp/again.$form"; is_empty err
        run 0 "$loft" export "$tmp/again.$form" --as csv
        paste -d, "$tmp/want.csv" "$tmp/out" | awk -F, 'NR > 1 {
            for (i = 1; i <= 8; i++) if (($i - $(i + 8)) ^ 2 > 1e-11) exit 1 }
            END { exit NR < 5 }' || job_fails "by way of .$form the curves differ"
    done
    run 0 "$loft" plan --total "$tmp/export.svg"
    local drawn; drawn=$(awk '$1 == "drawn" { print $2 }' "$tmp/out")
    for form in arcs g5 lines; do
        run 0 "$loft" export "$tmp/export.svg" --curves $form -o "$tmp/again.nc"; is_empty err
        run 0 "$loft" plan --total "$tmp/again.nc"
        awk -v want="$drawn" '$1 == "drawn" && ($2 - want) ^ 2 < 0.05 ^ 2 { good = 1 }
            END { exit !good }' "$tmp/out" || job_fails "as $form: $(cat "$tmp/out")"
    done
    one_line 64 '-o x.doc: give h, nc, svg' "$loft" export "$tmp/export.svg" -o x.doc
    one_line 64 '--curves x: give arcs, g5 or lines' "$loft" export "$tmp/export.svg" --as nc \
        --curves x
    one_line 73 'cannot be written' "$loft" export "$tmp/export.svg" -o "$tmp/no/x.nc"
}

case_gcode() {                          # every place, and back: counted, and as commanded
    printf '%s\n' 'G21 G90' 'G0 Z1' 'G0 X10 Y10' 'G1 Z-1 F600' 'X20 F2400' 'G3 X30 Y20 R10' \
        'G5 I0 J5 P0 Q-5 X40 Y20' 'G2 X10 Y10 R20 Z-2' 'G0 Z0' 'M2' >"$tmp/part.nc"
    machine gcode --speed fast --once
    run 0 "$loft" stream "$tmp/part.nc" --port "$tmp/gcode"; gone "$machine"
    is_empty err; says out '^drawn: .*as commanded$'; counted gcode
    tail -1 "$tmp/gcode.csv" | awk -F, '$2 != 800 || $3 != 800 || $4 != 0 { exit 1 }' \
        || job_fails "it does not end at 10,10,0: $(tail -1 "$tmp/gcode.csv")"
    run 0 "$loft" plan --total "$tmp/part.nc"
    run 0 "$loft" plot -o "$tmp/part.png" "$tmp/part.nc"
}

case_gcode_tools() {                    # beside the path, with two tools; the second asks
    printf '%s\n' 'tool.1.diameter = 6' 'tool.2.diameter = 2' 'tool.2.pause = the small one' \
        >"$tmp/mills.txt"
    printf '%s\n' 'G21 G61' 'T1 M6' 'G0 X0 Y0' 'G41 D1' 'G1 X20 F3000' 'X40' 'Y20' 'G40' 'G1 X20' \
        'T2 M6' 'G42 G1 X10' 'X0' 'G40 Y0' 'M2' >"$tmp/mills.nc"
    machine mills --speed fast
    run 75 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" --port "$tmp/mills"
    says err 'tool 2 is next: the small one'
    printf '\n' | timeout 1000 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" \
        --port "$tmp/mills" --from-tool 2 >"$tmp/out" 2>"$tmp/err" || job_fails 'it did not go on'
    says out '^drawn: .*as commanded$'
    run 0 "$loft" stream "$tmp/mills.nc" --machine "$tmp/mills.txt" --dry-run
    says out '^tool 1: planned: 4 curves'; says out '^tool 2: before it: the small one'
    one_line 78 'G61: a machine that plans does not stop' "$loft" stream "$tmp/mills.nc" \
        --machine "$tmp/mills.txt" --dry-run --plan chip
    one_line 65 'mills.nc:4: tool 1 has no diameter' "$loft" plan "$tmp/mills.nc"
}

case_a_pause_takes_enter_from_a_pipe() {
    printf '%s\n' 'G21 G90' 'G1 X10 F6000' '(MSG, turn it)' 'M0' 'G0 Y5' 'G1 X0' 'M0' 'G1 X5' M2 \
        >"$tmp/asks.nc"
    run 0 "$loft" plot "$tmp/asks.nc" -o "$tmp/asks.svg"; says out ': 3 curves$'
    machine asks --speed fast --once
    printf 'x\n\n' | timeout 1000 "$loft" stream "$tmp/asks.nc" --port "$tmp/asks" \
        >"$tmp/out" 2>"$tmp/err" || job_fails 'it did not go on'
    says err '^pause: turn it: Enter goes on, a gives up$'; says out '^drawn: .*as commanded$'
    gone "$machine"; counted asks
    machine asks --speed fast
    printf 'a\n' | timeout 1000 "$loft" stream "$tmp/asks.nc" --port "$tmp/asks" \
        >"$tmp/out" 2>"$tmp/err" && job_fails 'a did not give up'
    says err 'abort\|given up\|gave up\|ended'
}

case_a_spindle_a_wait_and_a_pause() {
    printf '%s\n' 'G21 G90 M3 S500' 'G1 X10 F600' 'G4 P0.5' 'Y10' '(MSG, turn it)' 'M0' 'M8' 'X0' \
        'M9' 'M30' >"$tmp/part.nc"
    printf 'spin_up = 2\n' >"$tmp/spin.txt"
    machine spin --speed fast --once
    # a sender that is killed in the pause, one that is stopped there, a resume, and the report
    "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt" 2>"$tmp/err" &
    local first=$!; children+=("$first"); disown "$first"
    until_log spin ' held: '; until_file err '^pause'
    kill -9 "$first"; gone "$first"
    says err '^pause: turn it: Enter goes on, a gives up$'
    run 0 "$loft" ports "$tmp/spin"; says out '	in a job, held: `loft stream --resume`'
    "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt" \
        >"$tmp/out" 2>"$tmp/err" </dev/null &
    first=$!; children+=("$first")
    until_file err '^pause'
    kill -INT "$first"; wait "$first"
    [ $? = 75 ] || job_fails 'a pause that was left did not end with 75'
    says err '^pause: turn it: Enter goes on, a gives up$'
    run 0 "$loft" stream --resume --port "$tmp/spin"
    run 0 "$loft" stream "$tmp/part.nc" --port "$tmp/spin" --machine "$tmp/spin.txt"
    says out '^drawn: .*as commanded$'; gone "$machine"; counted spin
    # on at half power before the first pulse and spin_up, off at the end; the coolant for the last
    # line
    awk -F, '/^# output 1 = 32768 from/ { on = 1 } /^# output 2 = 65535/ { wet = $0 }
        /^# output 2 = 0 / { dry = 1 } /^# output 1/ { ones++ } /^[0-9]/ { if (!on) exit 1; n++ }
        n == 1 { first = $1 } END { exit !(ones == 2 && wet != "" && dry && first >= 80000) }' \
        "$tmp/spin.csv" || job_fails "$(grep output "$tmp/spin.csv")"
    [ "$(grep -c ' held: ' "$tmp/spin.log")" = 1 ] || job_fails 'it paused more than once'
    run 0 "$loft" stream "$tmp/part.nc" --dry-run --grbl
    words_of_it() { grep -E '^(M|G4)' "$tmp/out" | tr '\n' ' '; }
    [ "$(words_of_it)" = 'M3S500 G4P0.500 M0 M8 M9 ' ] || job_fails "as G-code: $(words_of_it)"
    run 0 "$loft" stream "$tmp/part.nc" --dry-run --points
    says err 'part.nc:1: M3, M4 or M5: the machine has no output for a spindle'
    says err 'part.nc:6: M0, M1 or M6: the machine does not stop there'
    run 0 "$loft" plan --total "$tmp/part.nc"
    says err 'part.nc:1: G4, M0, M3 and the like (5 times): the times are of motion without them'
    # as --dry-run does: 0.5 s of G4
    seconds_of() {
        run 0 "$loft" stream "$tmp/$1.nc" --dry-run
        sed -n 's/^planned: .* travelled, \([0-9.]*\) s,.*/\1/p' "$tmp/out"
    }
    sed 's/^G4.*/G4 P0/' "$tmp/part.nc" >"$tmp/brief.nc"
    awk -v a="$(seconds_of part)" -v b="$(seconds_of brief)" \
        'BEGIN { exit !(a - b > 0.35 && a - b < 0.65) }' || job_fails 'G4 is not in the time'
}

# a program of 1.1 MB, read in parts, whose events stand in its later ones
case_events_late_in_a_long_program() {
    awk 'BEGIN { print "G21 G90\nF18000"
        for (i = 1; i <= 40000; i++) {
            if (i == 20001) print "M3 S500\nG4 P0.25"
            if (i == 30001) print "M8"
            printf "G1 X%.5f Y%.5f\n", 50 * cos(i / 1000), 50 * sin(i / 1000)
        }
        print "M5" }' >"$tmp/late.nc"
    run 0 "$loft" stream "$tmp/late.nc" --dry-run --grbl --accel 30000 --jerk 0
    # each after the point that stands before it, the arcs around it end there
    grep -A1 'X20.4041Y45.6473' "$tmp/out" | grep -q '^M3S500$' || job_fails 'M3 elsewhere'
    grep -A1 '^M3S500' "$tmp/out" | grep -q '^G4P0.250$' || job_fails 'G4 elsewhere'
    grep -A1 'X7.7126Y-49.4016' "$tmp/out" | grep -q '^M8$' || job_fails 'M8 elsewhere'
    [ "$(tail -1 "$tmp/out")" = M5 ] || job_fails 'M5 is not at the end'
    # standard input is kept as a whole: the same words, the same job
    mv "$tmp/out" "$tmp/parts"
    whole() { "$loft" stream - --dry-run "$@" --accel 30000 --jerk 0 <"$tmp/late.nc" >"$tmp/out"; }
    whole --grbl || job_fails 'standard input was refused'
    cmp -s "$tmp/parts" "$tmp/out" || job_fails 'parts and the whole differ'
    run 0 "$loft" stream "$tmp/late.nc" --dry-run --accel 30000 --jerk 0
    mv "$tmp/out" "$tmp/parts"; says parts ' job [0-9a-f]*$'
    whole || job_fails 'standard input was refused'
    cmp -s "$tmp/parts" "$tmp/out" || job_fails 'jobs of parts and of the whole differ'
}
case_dry_run_says_the_plan() {
    run 0 "$loft" stream "$tmp/small.csv" --dry-run
    local end='[0-9]* spans, path within 0.00[0-9]* of 0.0050 mm, .* of jerk, job [0-9a-f]*$'
    says out "^planned: 7 curves, 0\.[0-9]* m drawn, .* s, $end"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 1800mm/min; cp "$tmp/out" "$tmp/minutes"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 30mm/s
    cmp -s "$tmp/out" "$tmp/minutes" || job_fails "1800mm/min is not 30mm/s"
}
case_a_program_is_checked() {
    printf '%s\n' 'G21 G90' 'G0 Z5' 'G0 X10 Y10' 'G1 Z-1 F300' 'G1 X50 F60000' 'G0 X20' \
        'G2 X30 Y20 I0 J10 F1200' 'G0 Z5' M30 >"$tmp/part.nc"
    printf 'max_speed = 200\ny.max_speed = 100\nx.travel = 60\n' >"$tmp/m.txt"
    run 0 "$loft" stream "$tmp/part.nc" --check --machine "$tmp/m.txt"; is_empty err
    says out '^planned: .* s, '; says out '^box: x 0..50, y 0..30, z -1..5$'
    says out '^feeds: 5 to 1000 mm/s$'
    says out 'part.nc:5: a feed of 1000 mm/s, and x allows 200 there: 1 curve is drawn slower'
    says out 'part.nc:6: a rapid at z -1, below 0: 1 of them'
    printf 'x.travel = 40\n' >"$tmp/m.txt"
    one_line 65 'takes the tool to x 0..50, and the table is x 0..40' \
        "$loft" stream "$tmp/part.nc" --check --machine "$tmp/m.txt"
    one_line 64 'give one of them' "$loft" stream "$tmp/part.nc" --check --grbl
    run 0 "$loft" stream "$tmp/small.csv" --check; says out '^box: x .*, z 0..1$'
    says out '^feeds: 30 to 30 mm/s$'
    ! grep -q 'allows' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_tools_draw_one_after_the_other() {
    cat >"$tmp/pens.txt" <<'END'
x.park = 5
y.park = 6
tool.red.colours  = #f00
tool.red.feed     = 40
tool.red.pause    = the red pen
tool.blue.layers  = 2
tool.blue.pen_up  = 3
tool.blue.pause   = the blue pen
END
    cat >"$tmp/pens.svg" <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60"
     xmlns:i="http://www.inkscape.org/namespaces/inkscape">
  <g i:groupmode="layer" i:label="2 sky"><path d="M10 10h40v40h-40z" stroke="red"/></g>
  <path d="M20 20l20 20" stroke="red"/>
</svg>
END
    job=("$loft" stream "$tmp/pens.svg" --machine "$tmp/pens.txt" --port "$tmp/pens")
    run 0 "${job[@]}" --dry-run
    says out '^tool red: planned: 1 curve, 0.028 m drawn'; says out '^tool blue: planned: 4 curves'
    says out '^tool blue: before it: the blue pen$'; says out '^in all: 5 curves, 0.188 m drawn'
    run 0 "${job[@]}" --dry-run --grbl; says out '^(tool blue)$'; says out '^M0$'
    machine pens --speed fast
    run 75 "${job[@]}"; says err 'tool red is next: the red pen; then .* --from-tool red goes on'
    printf '\n' | timeout 1000 "${job[@]}" >"$tmp/out" 2>"$tmp/err"
    [ "${PIPESTATUS[1]}" = 75 ] || job_fails "went on without an answer: $(cat "$tmp/err")"
    says out '^drawn: 1 curve, .*steps 400 480 80 as commanded'     # parked, and lifted
    says err 'tool blue is next: the blue pen; then .* --from-tool blue goes on'
    printf '\n' | timeout 1000 "${job[@]}" --from-tool blue >"$tmp/out" 2>"$tmp/err" ||
        job_fails "$(cat "$tmp/err")"
    says out '^drawn: 4 curves, .*steps 800 4000 240 as commanded'; counted pens
    one_line 64 '--from-tool green: it is not in the machine file' "${job[@]}" --from-tool green
    kill "$machine"; gone "$machine"
}
case_a_tool_that_was_cut_off_goes_on() {
    printf 'tool.a.colours = red\ntool.b.colours = blue\n' >"$tmp/two.txt"
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">
        <path d="M10 10h9" stroke="red"/><path d="M10 10v40h40" stroke="blue"/></svg>' \
        >"$tmp/two.svg"
    job=("$loft" stream "$tmp/two.svg" --machine "$tmp/two.txt" --port "$tmp/two" --feed 20)
    machine whole --speed fast
    run 0 "${job[@]}" --port "$tmp/whole"; kill "$machine"; gone "$machine"
    machine two --speed fast --halt 1500; drawing_on=two         # the first job is shorter
    stop_at 1500 KILL; gone $sender
    [ "$(grep -c ' begun' "$tmp/two.log")" = 2 ] || job_fails 'it was cut off in another job'
    goes_on; says err '^tool b: resuming at item [1-9]'
    says out '^drawn: 2 curves, .*as commanded'; [ "$(grep -c '^drawn' "$tmp/out")" = 1 ] ||
        job_fails "drew a tool again"
    kill "$machine"; gone "$machine"; counted two; same_path whole two
}
case_short_lines_become_curves() {
    awk 'BEGIN { print "line"
                 for (i = 0; i <= 2000; i++)
                     printf "%.6f %.6f\n", 20 * cos(i * 0.002), 20 * sin(i * 0.002) }' \
        >"$tmp/dense.loft"
    run 0 "$loft" stream "$tmp/dense.loft" --dry-run --feed 60
    says out '^planned: [1-9][0-9]\? curves, 0.080 m drawn'
    run 0 "$loft" stream "$tmp/dense.loft" --dry-run --feed 60 --smooth 0
    says out '^planned: 2000 curves, 0.080 m drawn'
    one_line 64 'leave half of the tolerance' "$loft" plan "$tmp/dense.loft" --smooth 0.004
    machine dense --steps 250 --once
    run 0 "$loft" stream "$tmp/dense.loft" --feed 60 --port "$tmp/dense" --record "$tmp/dense.csv"
    gone "$machine"
    says out 'as commanded'
    awk '/worst path error/ {
             for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) < 0.0080) ok = 1
         }
         END { exit !ok }' "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_the_line_in_words() {
    machine watched --speed fast
    run 0 "$loft" ports "$tmp/watched"
    local queue='queue of 256 spans or 1280 points'
    says out "loft, 3 axes, 1000 ticks/s, 40 slots, $queue	steps/mm 80 80 80	idle"
    "$loft" monitor --port "$tmp/watched" --link "$tmp/between" >"$tmp/words" & local monitor=$!
    children+=("$monitor")
    wait_for "$tmp/between"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/between" --log "$tmp/log"
    kill -INT $monitor; wait $monitor || job_fails "monitor: exit code $?"
    for f in words log; do
        for line in '> HELLO ' '< WELCOME .* axes 3 queue 256 points 1280' \
            '> JOB .* spans start 0 0 0' '> SPANS .* first 0 ' '< ACK .* running' '> END .* total' \
            '< REPORT .* done position'; do
            grep -q -- "$line" "$tmp/$f" || job_fails "$f has no line $line"
        done
        ! grep -qE 'readable|unknown| \? ' "$tmp/$f" \
            || job_fails "$(grep -E 'readable|unknown' "$tmp/$f" | head -1)"
    done
    grep -q '^> [0-9]* bytes, [0-9]* frames, 0 damaged$' "$tmp/words" \
        || job_fails "$(tail -2 "$tmp/words")"
}
