# tests/e2e/go.sh -- straight moves, probing and jogging
# SPDX-License-Identifier: MIT

case_go_moves_straight_to_a_place() {
    machine there --speed fast --limits x-=-10,x+=100 --walls x-=-15
    goes 10,20 there '10.000 20.000 0.000'; counted_place there '800 1600 0'
    goes -5,3 there '-5.000 3.000 0.000'
    goes ,,5 there '-5.000 3.000 5.000'
    goes -1 there '-6.000 3.000 5.000' --by
    goes 1,1,-1 there '-5.000 4.000 4.000' --by
    goes -5,4,4 there '-5.000 4.000 4.000'                  # it is there
    printf 'x.travel = 50\nx.min = -4\n' >"$tmp/table.txt"
    one_line 65 'x 47 is beyond the table, -4..46: stay on it' \
        "$loft" go 47 --port "$tmp/there" --machine "$tmp/table.txt"
    goes -4.5 there '-4.500 4.000 4.000' --machine "$tmp/table.txt"     # back to it
    run 0 "$loft" pen down --port "$tmp/there"; says out '^the tool is at -4.500 4.000 0.000$'
    run 0 "$loft" pen up --port "$tmp/there"; says out '^the tool is at -4.500 4.000 1.000$'
    run 0 "$loft" pen down --port "$tmp/there"
    printf 'x.park = 3\npen_up = 2.5\n' >"$tmp/park.txt"
    run 0 "$loft" park --port "$tmp/there" --machine "$tmp/park.txt"
    says out '^the tool is at 3.000 0.000 2.500$'; counted_place there '240 0 200'
    # into a switch, and away from it alone
    one_line 75 'the limit switch of x at its low end closed .*`loft unlock`' \
        "$loft" go -12 --port "$tmp/there"
    one_line 69 'low end is closed, and this does not lead away from it: `loft unlock' \
        "$loft" go -13 --port "$tmp/there"
    one_line 69 'does not lead away' "$loft" go ,10 --port "$tmp/there"
    goes 0 there '0.000 0.000 .*'
    # CoreXY: a place is one of the tool
    printf 'kinematics = corexy\n' >"$tmp/corexy.txt"
    machine cross --speed fast --machine "$tmp/corexy.txt"
    goes 10,20 cross '10.000 20.000 0.000' --machine "$tmp/corexy.txt"
    counted_place cross '2400 -800 0'
    # polar: past the pole, where the angle turns by half a turn
    printf 'kinematics = polar\nx.center = 0\n' >"$tmp/polar.txt"
    machine polar --speed fast --machine "$tmp/polar.txt"
    goes 20,0 polar '20.000 0.000 0.000' --machine "$tmp/polar.txt"
    goes -20,0 polar '-20.000 -\?0.000 0.000' --machine "$tmp/polar.txt"
    for bad in x 1,2,3,4 1,2x '' 1,1e9; do
        one_line 64 'give a place in mm as X,Y' "$loft" go "$bad" --port "$tmp/there"
    done
    one_line 64 'name one place' "$loft" go --port "$tmp/there"
    one_line 64 'name one place' "$loft" go 1 2 --port "$tmp/there"
    one_line 64 'no --port' "$loft" go 1
    one_line 64 'give up or down' "$loft" pen sideways --port "$tmp/there"
    one_line 64 'park takes no place' "$loft" park 3,4 --port "$tmp/there"
    machine busy "${starving[@]}" --halt 500
    draws busy; cut_off 500
    one_line 75 'a job is running' "$loft" go 1,1 --port "$tmp/busy"
}
case_probe_finds_a_surface() {
    for m in q16 f64; do
        machine $m --speed fast --num $m --probe z-=-3.333,x+=7 --walls z-=-5 --bounce 5
        run 0 "$loft" probe --port "$tmp/$m"        # 267 steps down is the first place beyond
        says out '^touched at 0.000 0.000 -3.337$'; says out '^the tool is at 0.000 0.000 -1.337$'
        run 0 "$loft" probe --at 15 --feed 5 --port "$tmp/$m"
        says out '^touched at 0.000 0.000 15.000$'; says out '^the tool is at 0.000 0.000 17.000$'
        run 0 "$loft" probe --port "$tmp/$m"; says out '^touched at 0.000 0.000 15.000$'
        run 0 "$loft" probe x+ --port "$tmp/$m" --back 0.5
        says out '^touched at 7.000 0.000 17.000$'; says out '^the tool is at 6.500 0.000 17.000$'
        [ "$(table_of $m)" = '6.5000 0.0000 -1.3375, 0 steps lost' ] || job_fails "$(table_of $m)"
    done
    one_line 69 'has touched nothing within 1 mm; the tool is at 6.500 1.000 17.000: give more' \
        "$loft" probe y+ --within 1 --port "$tmp/q16"
    run 0 "$loft" go ,,12 --port "$tmp/q16"
    one_line 69 'the probe touches already' "$loft" probe --port "$tmp/q16"
    one_line 64 'z: name one direction' "$loft" probe z --port "$tmp/q16"
}
case_jog_by_lines() {
    machine there --speed fast
    run 0 bash -c "printf 'x10\n\ny-2.5 z1\nx-1e0\ty2.5\n' | '$loft' jog --port '$tmp/there'"
    says out '^the tool is at 10.000 0.000 0.000$'; says out '^the tool is at 10.000 -2.500 1.000$'
    says out '^the tool is at 9.000 0.000 1.000$'; counted_place there '720 0 80'
    for bad in x x1x 1 'x1 x2' q; do
        one_line 65 '-:2: not a move: give axes and mm' \
            bash -c "printf 'x1\n$bad\nx1\n' | '$loft' jog --port '$tmp/there'"
    done
    printf 'x.travel = 20\n' >"$tmp/table.txt"
    one_line 65 'x 24 is beyond the table' \
        bash -c "echo x10 | '$loft' jog --port '$tmp/there' --machine '$tmp/table.txt'"
    one_line 64 'jog takes keys, or lines' "$loft" jog x1 --port "$tmp/there"
    one_line 64 'name a port' "$loft" jog --port -
}
case_jog_by_keys() {
    # a tap takes fewer ticks than a halt needs
    machine keyed --speed fast --halt 1500
    run 0 "$loft" go 1,1 --port "$tmp/keyed"
    # two taps, a step of 10 mm, an arrow (ESC [ C) of 0.1 mm
    types keyed '@step@d @2.000 1.000@. _d @3.000 1.000@4 @step 10 mm@w
        @3.000 11.000@2 @step 0.1 mm@^[ @@[ @@C @3.100 11.000@q' \
        "$loft" jog --port "$tmp/keyed" || job_fails "jog ended with another code"
    says out '3.100 11.000 0.000'; counted_place keyed '248 880 0'
    # a held key moves on, and its release stops the tool on the path, far before the end
    types keyed '@step@. *halted at tick 1500*a #asked to#> #aborted#q' \
        "$loft" jog --port "$tmp/keyed" || job_fails "jog ended with another code"
    local at; at=$(tail -1 "$tmp/keyed.csv" | cut -d, -f2)
    [ "$at" -lt -1000 ] && [ "$at" -gt -8000 ] || job_fails "a held key led to step $at"
    # the table ends it
    printf 'x.travel = 20\nx.min = -10\n' >"$tmp/table.txt"
    machine edge --speed fast
    run 0 "$loft" go 1,1 --port "$tmp/edge"
    types edge '@step@. *position -800 80 0*a @@q' "$loft" jog --port "$tmp/edge" \
        --machine "$tmp/table.txt" || job_fails "jog ended with another code"
    counted_place edge '-800 80 0'
}
