# tests/e2e/planned_there.sh -- drawings that the machine plans
# SPDX-License-Identifier: MIT

chip_draws() {
    drawing_on=$1
    job=("$loft" stream "$tmp/small.csv" --port "$tmp/$1" "${slowly[@]}" --plan chip)
}
case_planned_here_or_there() {      # the same drawing: the same end, path, and time
    for m in q16 f32; do
        for where in host chip; do
            machine "at-$where" --speed fast --once --num $m --steps 320 --slots 80
            run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/at-$where" --plan=$where \
                --record "$tmp/at-$where.csv" --log "$tmp/at-$where.log"
            gone "$machine"
            is_empty err
            says out '^drawn: 7 curves, .*as commanded$'
            counted "at-$where"
            cp "$tmp/out" "$tmp/at-$where.out"
            awk '{ for (i = 1; i < NF; i++)
                       if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 320) exit 1 }' "$tmp/out" ||
                job_fails "$(cat "$tmp/out")"
        done
        [ "$(tail -1 "$tmp/at-host.csv" | cut -d, -f2-)" = \
            "$(tail -1 "$tmp/at-chip.csv" | cut -d, -f2-)" ] || job_fails "$m: another end"
        local took
        took=$(sed -n 's/.* m, \([0-9.]*\) s machine time.*/\1/p' "$tmp"/at-*.out \
            | sort -u | tr '\n' ' ')
        # on the machine, curves arrive during the planning, in other portions: at most 2 % was
        # measured (f32)
        awk -v t="$took" 'BEGIN { split(t, a, " "); b = a[2] ? a[2] : a[1]
                                  exit !(b <= 1.02 * a[1] + 0.11) }' || job_fails "$m: $took s"
        # frames of curves, each counted once: the number of status requests depends on the duration
        awk '$2 == ">" && $3 == "CURVES" && !seen[$7]++ { curves += $11; bytes += $12 }
             END { exit !(curves == 17 && bytes > 0 && bytes < 204) }' \
            "$tmp/at-chip.log" || job_fails "$m: $(grep CURVES "$tmp/at-chip.log")"
    done
}
case_planned_there_over_a_noisy_line() {
    machine noisy --speed fast --once --noise 60 --curves 8
    chip_draws noisy; run 0 "${job[@]}"; gone "$machine"; counted noisy; says out 'as commanded$'
}
case_planned_there_and_killed() {
    machine killed --speed fast --halt 700,2200 --once
    chip_draws killed
    stop_at 700 KILL; gone $sender
    stop_at 2200 KILL takes_up; gone $sender
    asks hold
    says out '^held: [0-9]* items executed'
    one_line 75 'another job' "$loft" stream "$tmp/small.csv" --port "$tmp/killed" "${slowly[@]}" \
        # the same drawing, but another job
    run 0 "${job[@]}" --record "$tmp/killed.csv"
    gone "$machine"
    says err '^resuming at item'
    says out 'as commanded$'
    counted killed
    awk '{ for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) > 0.005 + 1.42 / 80) exit 1 }' \
        "$tmp/out" || job_fails "$(cat "$tmp/out")"
}
case_planned_there_and_aborted() {
    machine ended --speed fast --halt 1000 --once
    chip_draws ended; stop_at 1000 KILL; gone $sender
    asks abort
    gone "$machine"
    says out '^aborted: [0-9]* items'
    counted ended
}
case_a_machine_that_does_not_plan() {
    machine plain --speed fast --curves 0
    one_line 78 'does not plan by itself: give --plan host' "$loft" stream "$tmp/small.csv" \
        --port "$tmp/plain" --plan chip
    run 0 "$loft" stream "$tmp/small.csv" --port "$tmp/plain"; says out 'as commanded$'
    machine able --speed fast
    one_line 64 'give host or chip' "$loft" stream "$tmp/small.csv" --port "$tmp/able" --plan moon
    one_line 64 'takes curves'      "$loft" stream "$tmp/small.csv" --port "$tmp/able" --plan chip \
        --points
    run 0 "$loft" stream "$tmp/small.csv" --plan chip --dry-run; says out ' 17 curves, path within'
}
