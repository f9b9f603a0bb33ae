# tests/e2e/home.sh -- homing and zero
# SPDX-License-Identifier: MIT

case_zero_tells_the_machine_where_it_stands() {
    machine there --speed fast
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/there"
    run 0 "$loft" zero xy --port "$tmp/there" --log "$tmp/talk.log"
    says out '^the tool was at 60.000 30.000 1.000, and is now at 0.000 0.000 1.000$'
    says talk.log '> CONTROL .* place position 0 0 80'
    run 0 "$loft" zero z --at -2.5 --port "$tmp/there"
    says out 'and is now at 0.000 0.000 -2.500$'
    printf '3,4,3,5,3,6,3,7\n' >"$tmp/line.csv"     # the next job begins there, and is drawn right
    run 0 "$loft" stream "$tmp/line.csv" --port "$tmp/there"
    says out 'steps 240 560 80 as commanded$'
    run 0 "$loft" zero --port "$tmp/there"
    says out '^the tool was at 3.000 7.000 1.000, and is now at 0.000 0.000 0.000$'
    one_line 64 'xx: give each axis once' "$loft" zero xx --port "$tmp/there"
    one_line 64 'no --port' "$loft" zero xy
    one_line 64 'name the axes in one word' "$loft" zero x y --port "$tmp/there"
    machine busy "${starving[@]}" --halt 500
    draws busy; cut_off 500                             # it waits for the rest of its job
    one_line 75 'a job is running: wait' "$loft" zero --port "$tmp/busy"
    run 0 "${job[@]}"; says err '^resuming at item'; says out 'as commanded$'
    kinematics corexy
    machine corexy --speed fast --machine "$tmp/corexy.txt"
    run 0 "$loft" zero x --at 7 --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out 'now at 7.000 0.000 0.000$'
    run 0 "$loft" zero y --at 2 --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out '^the tool was at 7.000 0.000 0.000, and is now at 7.000 2.000 0.000$'
}
case_home_finds_its_switches() {
    home_file
    local ends=x-=-33.37,y-=-12,z+=6 walls=x-=-36,y-=-15,z+=9
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits $ends --walls $walls --bounce 5
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt" --touches 5
        is_empty err
        says out '^z: its switch at the high end, after 6.000 mm, is at 12.000: 5 touches within 0'
        says out '^x: .* low end, after 33.37[0-9] mm, is at -3.000: 5 touches within [01] steps\?$'
        says out '^y: its switch at the low end, after 12.000 mm, is at -1.500: 5 touches within 0'
        says out '^homed: the tool is at 0.000 1.500 10.000$'
        [ "$(table_of $m)" = '-30.3750 -9.0000 4.0000, 0 steps lost' ] || job_fails "$(table_of $m)"
    done
    # what is told of the place is kept: the switch of x is at -3, and its motor stands at 0
    run 0 "$loft" home x --port "$tmp/q16" --machine "$tmp/home.txt"
    says out '^x: .* after 3.000 mm, is at -3.000: 2 touches within 0 steps$'
    printf '5,5,6,5,7,5,8,5\n' >"$tmp/line.csv"
    run 0 "$loft" stream "$tmp/line.csv" --port "$tmp/q16" --machine "$tmp/home.txt"
    says out 'steps 640 400 80 as commanded$'
    [ "$(table_of q16)" = '-22.3750 -5.5000 -5.0000, 0 steps lost' ] || job_fails "$(table_of q16)"
    # one input for both ends; the tool stands on the switch already
    machine uno --speed fast --shared --limits x-=0,x+=40,y-=-12,z+=6 --walls $walls
    run 0 "$loft" home --port "$tmp/uno" --machine "$tmp/home.txt"
    says out '^homed: the tool is at 0.000 1.500 10.000$'
    [ "$(table_of uno)" = '3.0000 -9.0000 4.0000, 0 steps lost' ] || job_fails "$(table_of uno)"
    # corexy: the switches are of the tool
    { echo 'kinematics = corexy'; cat "$tmp/home.txt"; } >"$tmp/corexy.txt"
    machine corexy --speed fast --limits $ends --walls $walls --bounce 5 --machine "$tmp/corexy.txt"
    run 0 "$loft" home --port "$tmp/corexy" --machine "$tmp/corexy.txt"
    says out '^homed: the tool is at -\?0\.0[0-9]* 1.500 10.000$'
    [[ "$(table_of corexy)" =~ ^-30\.3[678].*\ -9\.0000\ 4\.0000,\ 0\ steps ]] \
        || job_fails "$(table_of corexy)"
}
# by a file without a table, so that the host lets it pass; tool and table as seen by the table
case_a_homed_machine_refuses_what_leaves_its_table() {
    home_file; echo 'tolerance = 0.005' >"$tmp/bare.txt"
    printf '5,5,20,5,30,5,45,5\n' >"$tmp/right.csv"
    local bare=(--machine "$tmp/bare.txt") m how
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits x-=-33.37,y-=-12,z+=6
        goes 8,0 $m '8.000 0.000 0.000' "${bare[@]}"
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt"
        for how in "" --points "--plan chip"; do
            one_line 65 'item [0-9]* leaves the table, where the machine was homed' \
                "$loft" stream "$tmp/right.csv" --port "$tmp/$m" "${bare[@]}" $how
            run 0 "$loft" park --port "$tmp/$m" "${bare[@]}"
        done
        one_line 65 'leaves the table' "$loft" go 40.5 --port "$tmp/$m" "${bare[@]}"
        one_line 65 'leaves the table' "$loft" go -0.5 --port "$tmp/$m" "${bare[@]}"
        goes 40.05,29.5 $m '40.050 29.500 10.000' "${bare[@]}"
        # the table stays where it is when the drawing has another zero
        run 0 "$loft" zero xy --port "$tmp/$m"
        one_line 65 'leaves the table' "$loft" go 2 --port "$tmp/$m" "${bare[@]}"
        goes -39 $m '-39.000 0.000 10.000' "${bare[@]}"
        # kept for good: homed again, the drawing lies there, and the table where it was
        run 0 "$loft" set --machine "$tmp/home.txt" --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m"
        goes 15,10 $m '15.000 10.000 10.000'
        run 0 "$loft" zero xy --keep --port "$tmp/$m"
        says out 'and is now at 0.000 0.000 10.000$'
        one_line 65 'x 26 is beyond the table, -15..25' "$loft" go 26 --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m"
        says out '^homed: the tool is at -15.000 -8.500 10.000$'
        goes 25,20 $m '25.000 20.000 10.000'
        run 0 "$loft" settings --port "$tmp/$m"; says out '^x.zero = 15$'
        run 0 "$loft" zero xy --at 5 --keep --port "$tmp/$m"
        run 0 "$loft" settings --port "$tmp/$m"; says out '^x.zero = 35$'
        one_line 78 'home.txt: --keep changes the settings of the machine' \
            "$loft" zero --keep --port "$tmp/$m" --machine "$tmp/home.txt"
        # a machine that is homed again may look for its switches, wherever it thinks it is
        run 0 "$loft" zero --at 100 --port "$tmp/$m"
        run 0 "$loft" home --port "$tmp/$m" --machine "$tmp/home.txt"
        says out '^homed: the tool is at 0.000 1.500 10.000$'
    done
}
case_the_emergency_stop_stops_at_once() {
    machine pressed --speed fast --halt 1000 --once
    draws pressed
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & local sender=$!
    halted pressed 1000; kill -USR1 "$machine"; go_on pressed; wait $sender
    [ $? = 75 ] || job_fails "it ended with another code"
    says err 'the emergency stop closed and ended the job .* stopped at once .* is in doubt: then'
    gone "$machine"; counted pressed err
    machine m --speed fast --halt 500
    draws m
    "${job[@]}" >"$tmp/out" 2>"$tmp/err" & sender=$!
    halted m 500; kill -USR1 "$machine"; go_on m; wait $sender
    run 0 "$loft" ports "$tmp/m"
    says out '	its position is in doubt: `loft home`.*	closed: the emergency stop$'
    one_line 69 'the emergency stop is closed: open it' "$loft" unlock --port "$tmp/m"
    kill -USR1 "$machine"
    one_line 69 'its position is in doubt, as after an emergency stop: `loft home' "${job[@]}"
    one_line 69 'its position is in doubt' "$loft" go 0,0 --port "$tmp/m"
    run 0 "$loft" zero xy --port "$tmp/m"
    one_line 69 'its position is in doubt' "$loft" park --port "$tmp/m"
    run 0 "$loft" zero z --port "$tmp/m"
    run 0 "$loft" go 1,1 --port "$tmp/m"; says out '^the tool is at 1.000 1.000 0.000$'
}
# switches of the motors: three carriages, and a radius and an angle
case_home_finds_the_switches_of_motors() {
    local delta=(--machine "$tmp/delta.txt") polar=(--machine "$tmp/polar.txt")
    printf '%s\n' 'kinematics = delta' 'arm_length = 330' 'delta_radius = 160' 'max_speed = 300' \
        'home_order = 1' 'home_end = high' 'home_at = 25' 'home_search = 60' >"$tmp/delta.txt"
    machine delta --speed fast "${delta[@]}" --limits x+=20,y+=21,z+=19.5 \
        --walls x+=23,y+=24,z+=22 --bounce 5
    run 0 "$loft" home --port "$tmp/delta" "${delta[@]}"
    says out '^y: its switch at the high end, .* is at 25.000: 2 touches within [01] step'
    says out '^homed: the tool is at -\?0.000 -\?0.000 22.000$'
    [ "$(table_of delta)" = '17.0000 18.0000 16.5000, 0 steps lost' ] ||
        job_fails "$(table_of delta)"
    goes 10,5,10 delta '9\.99[0-9] 5\.01[0-9] 10.000' "${delta[@]}"
    one_line 78 'its three carriages are homed together' \
        "$loft" home x --port "$tmp/delta" "${delta[@]}"
    one_line 78 'its switches are those of the motors: `loft home`' \
        "$loft" unlock --port "$tmp/delta" "${delta[@]}"
    printf '%s\n' 'kinematics = polar' 'a.home_order = 1' 'b.home_order = 2' 'a.home_at = 10' \
        'b.home_at = -3' 'a.home_search = 50' 'b.home_search = 400' >"$tmp/polar.txt"
    machine polar --speed fast "${polar[@]}" --limits x-=-33,y-=-100
    run 0 "$loft" home --port "$tmp/polar" "${polar[@]}"
    says out '^homed: the tool is at 13.000 -\?0.000 0.000$'
    goes 20,20 polar '20\.00[0-9] 20\.00[0-9] 0.000' "${polar[@]}"
}
# the second motor ahead or behind, by less than home_back; and what cannot be squared
case_home_squares_a_gantry() {
    home_file; echo 'y.square = yes' >>"$tmp/home.txt"
    local ends=x-=-33.37,y-=-12,z+=6 file=(--machine "$tmp/home.txt") m skew=1.3
    for m in q16 f32 f64; do
        machine $m --speed fast --num $m --limits $ends --gantry y=$skew --bounce 5
        run 0 "$loft" home --port "$tmp/$m" "${file[@]}" --touches 3
        says out '^y: squared: its switches close within [01] step.* of each other, before 10[345]$'
        says out '^y: its switch at the low end, after 1[0-2]\.[0-9]* mm, is at -1.500: 3 touches'
        says out '^homed: the tool is at 0.000 1.500 10.000$'
        [[ "$(table_of $m)" =~ ' -9.0'[01].*' 4.0000, 0 steps lost, skewed by '-?0.0[01] ]] \
            || job_fails "$(table_of $m)"
        run 0 "$loft" home y --port "$tmp/$m" "${file[@]}"
        says out '^y: squared: its switches close within [01] steps\? of each other, before [012]$'
        goes 5,5,5 $m '5.000 5.000 5.000' "${file[@]}"
        skew=-1.3
    done
    machine far --speed fast --limits $ends --gantry y=5
    one_line 69 'y: its two motors differ by more than 3 mm, or a switch is stuck' \
        "$loft" home y --port "$tmp/far" "${file[@]}"
    one_line 69 'its position is in doubt' "$loft" go 0 --port "$tmp/far" "${file[@]}"
    machine one --speed fast --limits $ends
    one_line 78 'one motor or one switch pin for an axis with square = yes: square it by hand' \
        "$loft" home y --port "$tmp/one" "${file[@]}"
    one_line 64 'gantry w=1: give an axis and mm' "$loft" simulate --gantry w=1
}
case_home_says_what_is_wrong() {
    home_file
    local file=(--machine "$tmp/home.txt")
    machine none --speed fast --walls x-=-3
    one_line 69 'x: no switch at the low end within 50 mm: look at switch, wire and motor' \
        "$loft" home x --port "$tmp/none" "${file[@]}"
    machine stuck --speed fast --limits x-=-33nc
    one_line 69 'x: its switch at the low end stays closed over 12 mm: is it stuck' \
        "$loft" home x --port "$tmp/stuck" "${file[@]}"
    machine turned --speed fast --limits x+=-5nc                # the motor turns the wrong way
    one_line 69 'x: looking for the switch at the low end, the other one closed: the motor turns' \
        "$loft" home x --port "$tmp/turned" "${file[@]}"
    one_line 78 'no axis has a switch for homing: give z.home_order' "$loft" home --port "$tmp/none"
    one_line 78 'x: how far is its switch at most. give x.travel, or x.home_search' \
        "$loft" home x --port "$tmp/none"
    one_line 64 'xq: give each axis once' "$loft" home xq --port "$tmp/none"
    one_line 64 'name the axes in one word' "$loft" home x y --port "$tmp/none"
    one_line 64 'no --port' "$loft" home x "${file[@]}"
    printf 'kinematics = polar\n' >"$tmp/polar.txt"
    one_line 78 'kinematics = polar: the switch is one of motor a: give a.home_at, where it is' \
        "$loft" home x --port "$tmp/none" --machine "$tmp/polar.txt"
    bad_file() {
        printf "$1" >"$tmp/bad.txt"
        one_line 65 "bad.txt:$2" "$loft" home --machine "$tmp/bad.txt" --port "$tmp/none"
    }
    bad_file 'x.home_end = left\n' '1: write home_end = low, or high'
    bad_file 'home_end\n' '1: no `=` behind home_end'
    bad_file 'x.home_order = 4\n' '1: home_order is 4: give a whole number from 0 to 3'
    bad_file 'x.home_end = low\nx.home_end = high\n' '2: home_end is given in line 1 already'
    # ^C ends it on the path; what is known of the place is said, and the next run works
    machine slow --speed fast --halt 500 --limits x-=-33
    "$loft" home x --port "$tmp/slow" "${file[@]}" >"$tmp/out" 2>"$tmp/err" & local homing=$!
    halted slow 500; kill -INT $homing; until_log slow 'asked to'; go_on slow; wait $homing
    [ $? = 75 ] || job_fails "stopped with another code"
    says err '^loft: stopped: the tool is at -[0-9]*\.[0-9]* 0.000 0.000$'
    # killed without warning, when the machine has the whole move: it ends it at the switch
    machine killed --speed fast --halt 500 --limits x-=-33
    drawing_on=killed job=("$loft" home x --port "$tmp/killed" "${file[@]}")
    cut_off_when_sent 500
    until_rest killed
    run 0 "$loft" home x --port "$tmp/killed" "${file[@]}"
    says out '^homed: the tool is at 0.000 0.000 0.000$'
}
