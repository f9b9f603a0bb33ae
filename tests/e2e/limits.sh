# tests/e2e/limits.sh -- limit switches, walls and unlocking
# SPDX-License-Identifier: MIT

case_a_closed_limit_ends_a_job_and_lets_none_begin() {
    printf '20,10,18,10,16,10,14,10\n' >"$tmp/back.csv"
    for m in q16 f64; do
        machine $m --speed fast --num $m --limits x+=40,y-=-300
        local ended='the limit switch of x at its high end closed and ended the job after'
        one_line 75 "$ended [0-9]* of .*[0-9]* items: .* at [34][0-9]\..*--away" \
            "$loft" stream "$tmp/small.csv" --port "$tmp/$m"; counted $m err
        run 0 "$loft" ports "$tmp/$m"; says out '	closed: the limit switch of x at its high end$'
        for how in "" --points "--plan chip"; do
            one_line 69 'the limit switch of x at its high end is closed: move away .*--away' \
                "$loft" stream "$tmp/back.csv" --port "$tmp/$m" $how
        done
        run 0 "$loft" stream "$tmp/back.csv" --port "$tmp/$m" --away --log "$tmp/$m.talk"
        says out 'as commanded$'
        says $m.talk 'away inputs 0002'
        run 0 "$loft" stream "$tmp/back.csv" --port "$tmp/$m"; says out 'as commanded$'; counted $m
    done
    for bad in x=3 x-=y q+=3 x+=1e9 x+=3y x+=3nd; do
        one_line 64 'limits .*give axis, end and mm' "$loft" simulate --limits $bad
        one_line 64 'walls .*give axis, end and mm' "$loft" simulate --walls $bad
    done
    one_line 64 'probe z-=3nc: give axis, end and mm' "$loft" simulate --probe z-=3nc
}
case_a_wall_stops_the_tool_but_not_the_count() {
    printf '0,0,10,0,20,0,30,0\n' >"$tmp/right.csv"
    machine wall --speed fast --walls x+=20 --once      # 10 mm of 80 steps are lost
    run 0 "$loft" stream "$tmp/right.csv" --port "$tmp/wall"
    says out 'steps 2400 0 80 as commanded$'
    gone "$machine"; counted wall
    says wall.log '^table: the tool is at 20.0000 0.0000 1.0000, 800 steps lost$'
    printf 'kinematics = corexy\n' >"$tmp/corexy.txt"   # walls are of the tool, steps of the motors
    machine cross --speed fast --walls y-=-3 --once --machine "$tmp/corexy.txt"
    printf '0,0,0,-4,0,-8,0,-12\n' >"$tmp/down.csv"
    run 0 "$loft" stream "$tmp/down.csv" --port "$tmp/cross" --machine "$tmp/corexy.txt"
    gone "$machine"
    says cross.log '^table: the tool is at 0.0000 -3.0000 1.0000, 1440 steps lost$'
    # a switch that bounces for 20 ms ends the job once; one that opens there is closed before
    machine jumpy --speed fast --limits x+=20 --bounce 20
    one_line 75 'the limit switch of x at its high end closed and ended' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/jumpy"
    one_line 69 'the limit switch of x at its high end is closed: move away' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/jumpy"
    machine wired --speed fast --limits x+=20nc
    one_line 69 'the limit switch of x at its high end is closed: move away' \
        "$loft" stream "$tmp/right.csv" --port "$tmp/wired"
}
case_a_hard_limit_stops_at_once() {
    local to=x+=20 home='loft unlock.*its motors may have lost steps: then home it$'
    printf '0,0,20,0,40,0,60,0\n' >"$tmp/right.csv"
    printf 'limit_stop = hard\n' >"$tmp/hard.txt"
    for m in q16 f32 f64; do        # 100 mm/s: in 100 ticks it slows down over 5 mm
        machine $m --speed fast --num $m --limits $to --bounce 5 --walls x+=22
        one_line 75 'x at its high end closed and ended .* stopped on the path at 25\.' \
            "$loft" stream "$tmp/right.csv" --port "$tmp/$m" --feed 100
        run 0 "$loft" unlock --port "$tmp/$m"
        machine hard$m --speed fast --num $m --limits $to --bounce 5 --walls x+=22
        one_line 75 "high end closed and ended .* stopped at once at 2[01]\\.[0-9]* 0.000.*$home" \
            "$loft" stream "$tmp/right.csv" --port "$tmp/hard$m" --feed 100 \
            --machine "$tmp/hard.txt"
        [[ "$(table_of $m)" = *', 0 steps lost' ]] && job_fails "no wall was there"
        [[ "$(table_of hard$m)" = *', 0 steps lost' ]] || job_fails "$(table_of hard$m)"
        one_line 69 'the limit switch of x at its high end is closed: move away' \
            "$loft" stream "$tmp/right.csv" --port "$tmp/hard$m" --machine "$tmp/hard.txt"
        run 0 "$loft" go 5 --port "$tmp/hard$m" --machine "$tmp/hard.txt"
        one_line 75 'stopped at once at 2[01]\.' \
            "$loft" go 25 --port "$tmp/hard$m" --machine "$tmp/hard.txt"
    done
    printf 'limit_stop = soft\n' >"$tmp/soft.txt"
    one_line 65 'soft.txt:1: write limit_stop = ramp, or hard' \
        "$loft" go 5 --port "$tmp/q16" --machine "$tmp/soft.txt"
}
case_unlock_leads_away_from_a_switch() {
    printf '0,0,4,0,8,0,12,0\n' >"$tmp/right.csv"
    machine high --speed fast --limits x+=5 --walls x+=9
    run 75 "$loft" stream "$tmp/right.csv" --port "$tmp/high" --feed 20
    run 0 "$loft" unlock --port "$tmp/high"
    says out '^free: the tool is at [34]\.[0-9]* 0.000 0.000$'
    run 0 "$loft" unlock --port "$tmp/high"; says out '^no switch is closed'
    machine uno --speed fast --limits x+=5 --shared
    run 75 "$loft" stream "$tmp/right.csv" --port "$tmp/uno" --feed 20
    one_line 69 'at which end is not known: name the way out, as `loft unlock x+`' \
        "$loft" unlock --port "$tmp/uno"
    one_line 69 'x: its switch .* stays closed over 12 mm' "$loft" unlock x+ --port "$tmp/uno"
    one_line 69 'x: its switch .* stays closed over 12 mm' "$loft" unlock x- --port "$tmp/uno"
    run 0 "$loft" unlock x- --port "$tmp/uno"; says out '^free: the tool is at [34]\.[0-9]* '
    one_line 64 'x: name one way out' "$loft" unlock x --port "$tmp/uno"
}
