# tests/e2e/settings.sh -- settings that live in the machine
# SPDX-License-Identifier: MIT

case_machines_as_text() {
    printf '# slow\nmax_speed = 20\ny.max_accel = 100 # mm/s2\nsteps_per_mm = 100\n' \
        >"$tmp/slow.txt"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60; cp "$tmp/out" "$tmp/fast"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60 --machine "$tmp/slow.txt"
    cmp -s "$tmp/out" "$tmp/fast" && job_fails "the limits of the file change nothing"
    printf '%s\n' '$100=100.000 (x, step/mm)' '$101=100.000' '$102=100.000' '$110=1200.000' \
        '$111=1200' '$112=1200' '$121=100.000' '$32=0' >"$tmp/grbl.txt"
    cp "$tmp/out" "$tmp/ours"
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --feed 60 --machine "$tmp/grbl.txt"
    cmp -s "$tmp/out" "$tmp/ours" ||
        job_fails "the same machine in grbl's numbers gives another plan"
    machine slow --speed fast --once --machine "$tmp/slow.txt"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/slow" --feed 60
    gone "$machine"
    counted slow
    says slow.csv '^# steps_per_mm_z = 100'
    bad_machine() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "bad.txt:$2" "$loft" simulate --machine "$tmp/bad.txt"
    }
    bad_machine '\nx.speed = 3\n'         '2: unknown key "x.speed": did you mean .*max_speed'
    bad_machine 'max_accel 5\n'           '1: no `=` behind max_accel'
    bad_machine 'z.max_accel = fast\n'    '1: max_accel is not a number: give one in mm/s'
    bad_machine 'slots = 3.5\n'           '1: slots is 3.5: give a whole number from 1 to 4096'
    bad_machine '# a\n$100=\n'            '2: not a setting of grbl'
    bad_machine 'corner = 0.1\n$11=0.2\n' \
        '2: corner is given in line 1 already: remove one'
    bad_machine 'y.max_jerk = 5\n\nmax_jerk = 6\n' \
        '3: max_jerk is given in line 1 already: put what holds for all axes first'
    bad_machine 'slots = 40\n\0\n'                          ' is not text'
    one_line 66 'none.txt' "$loft" simulate --machine "$tmp/none.txt"
}

# kept_lines FILE: settings without their first line, which names the port
kept_lines() { tail -n +2 "$1"; }

case_settings_live_in_the_machine() {
    local m
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"
        says out 'those of its firmware: it keeps none yet'; says out '^steps_per_mm = 80$'
        run 0 "$loft" set x.steps_per_mm=157.48 travel=50 y.min=-5 --port "$tmp/$m" \
            --log "$tmp/talk.log"
        says out '^kept: [0-9]* of 2000 bytes; steps/mm 157.48 80 80$'
        says out 'another one now: `loft home` it, or `loft zero`$'
        says talk.log '> SET .* at 0, 4 bytes$'; says talk.log '< KEPT .* kept$'
        kill "$machine"; gone "$machine"; rm -f "$tmp/$m"
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"; cp "$tmp/out" "$tmp/$m.said"
        says out 'kept by the machine'; says out '^x.steps_per_mm = 157.48$'
        says out '^travel = 50$'; says out '^y.min = -5$'
        # the machine knows its table and its gearing; a file overrules
        one_line 65 'small.csv: takes the tool to x 5..60' \
            "$loft" stream "$tmp/small.csv" --port "$tmp/$m"
        printf 'travel = 80\nmin = -15\n' >"$tmp/wide.txt"
        run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$m" --machine "$tmp/wide.txt"
        says out 'steps 9449 2400 80 as commanded$'
        one_line 65 'the table' "$loft" go 70,0 --port "$tmp/$m"
        kill "$machine"; gone "$machine"
    done
    kept_lines "$tmp/q16.said" | cmp -s - <(kept_lines "$tmp/f64.said") ||
        job_fails "settings differ by number type"
}
case_settings_are_copied_as_a_file() {
    machine from --speed fast --shared --limits x+=40nc
    one_line 69 'the limit switch of x' "$loft" stream "$tmp/small.csv" --port "$tmp/from"
    run 0 "$loft" set x.limit=opens max_jerk=30000 --port "$tmp/from"
    one_line 75 'the limit switch of x closed and ended' \
        "$loft" stream "$tmp/small.csv" --port "$tmp/from"
    run 0 "$loft" settings --port "$tmp/from" --save "$tmp/saved.txt"
    says saved.txt '^x.limit = opens$'; says saved.txt '^max_jerk = 30000$'
    machine to --speed fast
    run 0 "$loft" set --machine "$tmp/saved.txt" --port "$tmp/to"
    run 0 "$loft" settings --port "$tmp/to"
    kept_lines "$tmp/out" | cmp -s - <(kept_lines "$tmp/saved.txt") ||
        job_fails "another machine has other settings: $(cat "$tmp/out")"
    # a motor that turns the other way, and a machine that homes by what it keeps
    machine turned --speed fast --once
    run 0 "$loft" set x.reversed=yes --port "$tmp/turned"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/turned"; gone "$machine"
    says turned.csv ',-4800,2400,80$'
    home_file
    machine homed --speed fast --limits x-=-3,y-=-1.5,z+=12 --walls x-=-9,y-=-9,z+=20
    run 0 "$loft" set --machine "$tmp/home.txt" --port "$tmp/homed"
    run 0 "$loft" home --port "$tmp/homed"
    says out '^homed: the tool is at'
}
case_settings_are_whole_after_a_kill() {
    local i
    machine cut --speed fast --noise 1500 --keep "$tmp/cut.kept"
    run 0 "$loft" set steps_per_mm=100 travel=100 --port "$tmp/cut" --wait 60
    for i in 1 2 3 4; do
        "$loft" set steps_per_mm=20$i travel=20$i --port "$tmp/cut" --wait 60 \
            --log "$tmp/kill.log" >/dev/null 2>&1 & local setting=$!
        until_file kill.log '> SET .* at [1-9][0-9]*, [1-9]'
        if [ $((i % 2)) = 0 ]; then                     # the power fails
            kill -9 "$machine"; gone "$machine"; rm -f "$tmp/cut"
            machine cut --speed fast --noise 1500 --keep "$tmp/cut.kept"
        fi
        kill -9 $setting 2>/dev/null; wait $setting 2>/dev/null; rm -f "$tmp/kill.log"
        run 0 "$loft" settings --port "$tmp/cut" --wait 60
        says out 'kept by the machine'
        [ "$(sed -n 's/^steps_per_mm = //p' "$tmp/out")" = \
          "$(sed -n 's/^travel = //p' "$tmp/out")" ] || job_fails "mixed: $(cat "$tmp/out")"
    done
}
case_settings_go_back_to_the_firmware() {
    local m
    for m in q16 f64; do
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"; cp "$tmp/out" "$tmp/own"
        run 0 "$loft" set steps_per_mm=100 travel=50 x.reversed=yes x.limit=opens --port "$tmp/$m"
        run 0 "$loft" set --defaults --port "$tmp/$m"
        says out '^back to those of its firmware; steps/mm 80 80 80$'; says out 'another one now'
        run 0 "$loft" settings --port "$tmp/$m"
        cmp -s "$tmp/own" "$tmp/out" || job_fails "other settings: $(cat "$tmp/out")"
        run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/$m"
        says out 'steps 4800 2400 80 as commanded$'
        kill "$machine"; gone "$machine"; rm -f "$tmp/$m"
        machine $m --speed fast --num $m --keep "$tmp/$m.kept"
        run 0 "$loft" settings --port "$tmp/$m"
        cmp -s "$tmp/own" "$tmp/out" || job_fails "others after a start: $(cat "$tmp/out")"
        run 0 "$loft" set y.travel=7 --port "$tmp/$m"
        run 0 "$loft" settings --port "$tmp/$m"
        says out 'kept by the machine'; says out '^y.travel = 7$'
        run 0 "$loft" set --defaults --port "$tmp/$m"       # twice has no further effect
        run 0 "$loft" set --defaults --port "$tmp/$m"; says out 'back to those of its firmware'
        kill "$machine"; gone "$machine"
    done
}
case_settings_that_cannot_be() {
    machine plain --speed fast --keep "$tmp/plain.kept"
    local to=(--port "$tmp/plain")
    one_line 64 'no NAME=VALUE: nothing to set: give' "$loft" set "${to[@]}"
    one_line 64 'no --port' "$loft" set x.travel=3
    one_line 64 'defaults sets all' "$loft" set --defaults x.travel=3 "${to[@]}"
    one_line 64 'no --port' "$loft" settings
    one_line 64 'takes no file' "$loft" settings saved.txt "${to[@]}"
    one_line 65 'set:1: unknown key "x.speed"' "$loft" set x.speed=3 "${to[@]}"
    one_line 65 'set:2: max_accel is 0: give a number from 1' \
        "$loft" set x.travel=10 max_accel=0 "${to[@]}"
    one_line 78 'queue is part of the machine.s firmware' "$loft" set queue=9 "${to[@]}"
    one_line 78 'tolerance is about the plan' "$loft" set tolerance=0.1 "${to[@]}"
    one_line 78 'this board cannot do it: pulse' "$loft" set pulse=9 "${to[@]}"
    one_line 73 'name a place in a folder' \
        "$loft" settings "${to[@]}" --save "$tmp/none/saved.txt"
    run 0 "$loft" settings "${to[@]}"; says out 'it keeps none yet'      # nothing was changed
    run 0 "$loft" set x.travel=100 "${to[@]}"
    run 0 "$loft" set x.travel=200 "${to[@]}"
    kill "$machine"; gone "$machine"; rm -f "$tmp/plain"
    local at
    for at in 30 2030; do printf '\252' | dd of="$tmp/plain.kept" bs=1 seek=$at conv=notrunc \
        2>/dev/null; done
    machine plain --speed fast --keep "$tmp/plain.kept"
    run 0 "$loft" settings "${to[@]}"; says out 'what it kept is damaged'
    run 0 "$loft" stream "$tmp/small.csv" "${to[@]}"
    says err '^loft: .*plain: its settings are damaged: it runs with those of its firmware'
    machine busy "${starving[@]}" --halt 500
    draws busy; cut_off 500
    one_line 75 'a job is running: wait' "$loft" set x.travel=9 --port "$tmp/busy"
    run 0 "${job[@]}"; says out 'as commanded$'
}
case_a_servo_in_the_settings() {
    machine servo --speed fast
    run 0 "$loft" set z.drive=servo servo_zero=1234 z.steps_per_mm=100 --port "$tmp/servo"
    run 0 "$loft" settings --port "$tmp/servo"
    says out '^z.drive = servo$'; says out '^servo_zero = 1230$'
    one_line 65 'x.drive = servo: only z can be one' "$loft" set x.drive=servo --port "$tmp/servo"
    run 0 "$loft" set z.drive=step --port "$tmp/servo"
    run 0 "$loft" settings --port "$tmp/servo"
    says out '^z.drive = step$'
    ! grep -q servo_zero "$tmp/out" || job_fails "a motor with $(grep servo_zero "$tmp/out")"
}
