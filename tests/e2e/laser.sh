# tests/e2e/laser.sh -- laser power
# SPDX-License-Identifier: MIT

# S/F for each mm, off in rapids: 20 mm at F1200 and 20 at F600 with half power, 20 with a quarter
case_a_laser_gives_each_mm_the_same() {
    printf '%s\n' 'G21 G90' 'M4 S500' 'G0 X5 Y5' 'G1 X25 F1200' 'Y25 F600' 'G0 X5' 'G1 Y5 S250' \
        'M5' >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    machine laser --speed fast --once
    run 0 "$loft" stream "$tmp/burn.nc" --port "$tmp/laser" --machine "$tmp/laser.txt"
    gone "$machine"; counted laser
    awk '/^output 1:/ { s = $3 } END { exit !(s > 1.99 && s < 2.01) }' "$tmp/laser.log" ||
        job_fails "$(cat "$tmp/laser.log"), expected 2.000 s"
    machine without --speed fast --once
    one_line 78 'burn.nc:2: the machine has no output for the laser with --points' \
        "$loft" stream "$tmp/burn.nc" --points --port "$tmp/without" --machine "$tmp/laser.txt"
    kill "$machine"
    # a slow line: the queue runs low again and again
    machine slow --speed fast --line-baud 4800 --queue 4 --ramp 20 --once
    run 0 "$loft" stream "$tmp/burn.nc" --port "$tmp/slow" --machine "$tmp/laser.txt"
    gone "$machine"; counted slow
    awk '/^output 1:/ { s = $3 } END { exit !(s > 1.97 && s < 2.03) }' "$tmp/slow.log" ||
        job_fails "$(cat "$tmp/slow.log"), expected 2.000 s"
}

# along the outline of the benchmarks, held twice, at 130 and 50 %, with a short queue
case_a_laser_in_holds_and_overrides() {
    "$loft" export tests/drawings/outline12.csv -o "$tmp/cut.nc"
    { printf 'G21 G90 G94 G17\nM4 S600\n'
      grep '^[GXY]' "$tmp/cut.nc" | sed '1d; /^G0/d'
      echo M5; } >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    machine m --speed fast --halt 300,600,900,1300 --queue 12 --ramp 40 --steps 250 --once
    types m "#halted at tick 300#+ @@+ @@+ @130 %@>
        #halted at tick 600#h #asked to hold#> # held: #r
        #halted at tick 900#0 @@- @@- @@- @@- @@- @ 50 %@>
        #halted at tick 1300#h #asked to hold#> # held: #r" \
        "$loft" stream "$tmp/burn.nc" --port "$tmp/m" --machine "$tmp/laser.txt" \
        || job_fails "$(tail -1 "$tmp/screen")"
    gone "$machine"
    python3 tests/target/energy.py "$tmp/m.csv" 1 >"$tmp/energy"
    # 20 ms of full power for each mm
    awk '{ is[$1] = $2 }
        END { exit !(is["windows"] > 100 && is["mean"] > 19.8 && is["mean"] < 20.2 &&
            is["worst"] <= 2 && is["standing"] == 0 && is["after"] == 0) }' "$tmp/energy" ||
        job_fails "$(tr '\n' ' ' <"$tmp/energy")"
    [ "$(grep -c ' held: ' "$tmp/m.log")" -ge 2 ] || job_fails 'it was not held'
}
