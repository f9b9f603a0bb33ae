# tests/e2e/cut_off.sh -- senders and lines that are cut off, and what goes on after them
# SPDX-License-Identifier: MIT

case_killed_and_run_again() {
    undisturbed
    machine killed "${starving[@]}" --halt 700,1800,3300 --once
    draws killed
    cut_off 700; cut_off 1800
    stop_at 3300 KILL; gone $sender     # the machine has items when the next one comes
    goes_on; gone "$machine"
    says err '^resuming at item [0-9]*\( of \(about \)\?[0-9]*\)\?$'
    says out 'as commanded$'
    counted killed
    same_path killed calm
}
case_a_job_begins_free_of_a_hold_before_it() {
    machine again "${starving[@]}" --halt 1000
    draws again; cut_off 1000
    run 0 "$loft" stream --hold --port "$tmp/again"
    until_log again held
    run 0 "$loft" stream --abort --port "$tmp/again"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/again" --feed 200
    says out 'as commanded$'
    is_empty err
}
case_control_from_another_run() {
    undisturbed
    machine told "${starving[@]}" --halt 1000 --once
    draws told; cut_off 1000
    run 0 "$loft" stream --hold --port "$tmp/told"; says out '^held: '
    run 0 "$loft" stream --resume --port "$tmp/told"; says out '^resumed: '
    run 0 "$loft" stream --hold --port "$tmp/told"
    one_line 75 'another job' "$loft" stream "$tmp/small.csv" --port "$tmp/told" --feed 10
    run 0 "${job[@]}"; gone "$machine"; counted told; same_path told calm
}
case_park_after_an_abort() {
    machine parked "${starving[@]}" --halt 1000
    draws parked
    cut_off 1000
    run 0 "$loft" stream --abort --port "$tmp/parked"
    says out '^aborted: '
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/parked" --feed 200 --park
    says out 'steps 0 0 0 as commanded$'
}
case_abort_from_another_run() {
    machine ended "${starving[@]}" --halt 1000 --once
    draws ended; cut_off 1000
    run 0 "$loft" stream --abort --port "$tmp/ended"
    gone "$machine"
    says out '^aborted: '
    counted ended
    machine idle --speed fast
    one_line 69 'no job is running' "$loft" stream --hold --port "$tmp/idle"
}
case_report_is_fetched_later() {
    machine later --speed fast --queue 1000 --halt 2000
    # the queue holds all items
    draws later; job+=(--jerk 0); cut_off_when_sent 2000; until_log later done
    run 0 "${job[@]}"; says err 'was drawn already'; counted later
    cp "$tmp/out" "$tmp/first"
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/later" --feed 200
    says out 'as commanded$'
    is_empty err
}
case_another_job_after_a_lost_one() {
    machine other --speed fast --queue 1000 --halt 2000
    draws other; job+=(--jerk 0); cut_off_when_sent 2000; until_log other done
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/other" --feed 200
    says out 'as commanded$'
    is_empty err
}
case_port_vanishes() {
    machine lost --speed fast --halt 700
    { halted lost 700; kill -9 "$machine"; } & children+=($!)
    one_line 74 'the port has vanished at item [0-9]* of' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/lost" --feed 20
    # those that it had executed after 0.7 of 12 s; all of them had been sent
    sed 's/.* item \([0-9]*\) of \(about \)\?\([0-9]*\) .*/\1 \3/' "$tmp/err" |
        awk '{ exit !($1 * 2 < $2) }' || job_fails "not the items executed: $(cat "$tmp/err")"
}
until_noted() {         # the sender has noted that its job began
    until_true is_noted || job_fails "nothing is noted of the job"
}
is_noted() { compgen -G "$tmp/state/loft/*[0-9a-f]" >/dev/null; }
# in_doubt COMMAND..: neither this nor another drawing begins
in_doubt() {
    one_line 69 'restarted in a job.*position may be lost: home it, or `loft zero' "$@"
}
case_machine_that_lost_its_power_is_placed_first() {
    machine m --speed fast --halt 100
    draws m
    { halted m 100; until_noted; kill -9 "$machine"; } & children+=($!)
    one_line 74 'if it lost its power, the position may be lost: home it' "${job[@]}"
    gone "$machine"; rm -f "$tmp/m"
    on_again m; in_doubt "${job[@]}"; in_doubt "$loft" go 1,1 --port "$tmp/m"
    kill "$machine"; gone "$machine"
    on_again m
    run 0 "$loft" zero xy --port "$tmp/m"; in_doubt "$loft" stream "$tmp/small.csv" --port "$tmp/m"
    says err '`loft zero z --port'
    kill "$machine"; gone "$machine"    # and those two are in doubt again
    on_again m; run 0 "$loft" zero z --port "$tmp/m"; in_doubt "${job[@]}"
    run 0 "$loft" zero --port "$tmp/m"; run 0 "${job[@]}" --feed 400
    kill "$machine"; gone "$machine"    # a restart after the job is none in it
    on_again m; run 0 "${job[@]}" --feed 400; kill "$machine"; gone "$machine"
    on_again m --speed fast --halt 100; draws m; cut_off_noted
    asks abort; kill "$machine"; gone "$machine"
    on_again m; run 0 "${job[@]}" --feed 400
}
cut_off_noted() {       # kill ${job[@]} when it has begun
    "${job[@]}" >/dev/null 2>&1 & local sender=$!
    disown $sender
    halted m 100; until_noted; kill -9 $sender; gone $sender
}
case_machine_restarts_in_mid_job() {
    machine after --speed fast
    machine again --speed fast --halt 700
    "$pty" relay "$tmp/line" "$tmp/again" & children+=($!); disown $!
    wait_for "$tmp/line"
    { halted again 700; ln -sfn "$(readlink "$tmp/after")" "$tmp/again"; kill -9 "$machine"
    } & children+=($!)
    one_line 76 'restarted in the middle of the job: home it' "$loft" stream "$tmp/small.csv" \
        --port "unix:$tmp/line" "${slowly[@]}"
    in_doubt "$loft" stream "$tmp/small.csv" --port "unix:$tmp/line"
}
case_second_sender_is_refused() {
    machine owned --speed fast --halt 100 --once
    draws owned; "${job[@]}" >/dev/null 2>&1 & local sender=$!
    halted owned 100
    one_line 69 'another program talks to it' "$loft" stream "$tmp/small.csv" --port "$tmp/owned"
    go_on owned
    wait $sender || job_fails "the first sender ended with $?"
    gone "$machine"
}
case_machine_talks_nonsense() {
    "$pty" noise "$tmp/noise" & children+=($!); disown $!
    wait_for "$tmp/noise"
    one_line 76 'no good frame' "$loft" stream "$tmp/small.csv" --port "$tmp/noise" --wait 1
}
case_machine_is_mute() {
    "$pty" mute "$tmp/mute" & children+=($!); disown $!
    wait_for "$tmp/mute"
    one_line 69 'no machine answered in 0.5 s' "$loft" stream "$tmp/small.csv" --port "$tmp/mute" \
        --wait 0.5
}
# The machine says what it knows, and the next command what to do.
case_a_sender_that_is_killed_in_a_move() {
    local what sender
    home_file
    echo 'x.home_seek = 4' >>"$tmp/home.txt"
    for what in probe home; do
        # a queue that takes no whole move: the machine runs out of items, and waits on the path:
        # an item is a second of a seek at most
        machine $what --speed fast --queue 4 --halt 300 --limits x-=-33 --probe z-=-30
        if [ $what = probe ]; then
            job=("$loft" probe --feed 3 --within 40 --port "$tmp/probe")
        else
            job=("$loft" home x --port "$tmp/home" --machine "$tmp/home.txt")
        fi
        drawing_on=$what; cut_off 300
        run 0 "$loft" ports "$tmp/$what"; says out '	in a job$'
        one_line 75 'a job is running: wait for its end, or `loft stream --abort' "${job[@]}"
        run 0 "$loft" stream --abort --port "$tmp/$what"
        says out '^aborted: [0-9]* items executed, at '; counted_place $what \
            "$(sed -n 's/.*steps //p' "$tmp/out")"
        run 0 "$loft" ports "$tmp/$what"; says out '	idle$'
        run 0 "${job[@]}"
    done
    says out '^homed: the tool is at 0.000 0.000 0.000$'
    # the whole move is in the machine: it ends by the guard, and the place is known
    machine whole --speed fast --halt 500 --probe z-=-5 --max-speed 20
    job=("$loft" probe --feed 3 --port "$tmp/whole"); drawing_on=whole; cut_off 500
    until_log whole ' aborted: '
    run 0 "$loft" ports "$tmp/whole"; says out '	idle$'
    one_line 69 'the probe touches already' "${job[@]}"
    goes ,,0 whole '0.000 0.000 -\?0.000'
    run 0 "${job[@]}"; says out '^touched at 0.000 0.000 -5.0'
}
