# tests/e2e/raster.sh -- rasters
# SPDX-License-Identifier: MIT

# raster NAME MM [STOPS]: output 1 in the record NAME against $tmp/raster.nc
raster() {
    python3 tests/e2e/raster.py check "$tmp/$1.csv" "$tmp/raster.nc" >"$tmp/energy"
    awk -v most="$2" -v stops="${3:-0}" '{ is[$1] = $2 }
        END { exit !(is["rows"] == 4 && is["energy"] <= most && is["stops"] <= stops &&
            is["standing"] == 0 && is["levels"] > 100) }' "$tmp/energy" ||
        job_fails "$1: $(tr '\n' ' ' <"$tmp/energy")"
}
# Another S in each line: a row is one motion, of 60 mm/s, which is 0.06 mm in a tick. Pixels of 0.4
# mm and, four in a tick, of 0.015 mm; along x and aslant; with a queue that runs low.
case_a_raster_goes_through() {
    local row=0 mode pixel slope
    printf 'laser = yes\nx.max_accel = 3000\ny.max_accel = 3000\n' >"$tmp/laser.txt"
    while read -r mode pixel slope; do
        row=$((row + 1))
        python3 tests/e2e/raster.py make "$mode" 4 "$pixel" $row "$slope" >"$tmp/raster.nc"
        machine "m$row" --speed fast --once --steps 400
        run 0 "$loft" stream "$tmp/raster.nc" --port "$tmp/m$row" --machine "$tmp/laser.txt" \
            --record "$tmp/m$row.csv"
        gone "$machine"; counted "m$row"; raster "m$row" 0.06
        awk '{ for (i = 1; i < NF; i++) if ($i == "error" && $(i + 1) > 0.0086) exit 1 }' \
            "$tmp/out" || job_fails "$(cat "$tmp/out")"
    done <<'ROWS'
M3 0.4 0
M3 0.015 0.37
M4 0.4 0.37
M4 0.015 0
ROWS
    # 1,333 lines a row: one curve each, and an item in each ms at most
    run 0 "$loft" plan "$tmp/raster.nc" --machine "$tmp/laser.txt" --total --certify
    run 0 "$loft" stream "$tmp/raster.nc" --machine "$tmp/laser.txt" --dry-run
    says out 'planned: 4 curves, .* 1\.9 s, '
    [ "$(grep -c S "$tmp/raster.nc")" -gt 4000 ] || job_fails 'there are few pixels'
    # the line and its machine are slow, and stop where it said that it had nothing left; the words
    # stay as they are for a controller
    machine slow --speed fast --line-baud 57600 --once --steps 400 --queue 4 --ramp 20
    run 0 "$loft" stream "$tmp/raster.nc" --port "$tmp/slow" --machine "$tmp/laser.txt" \
        --log "$tmp/talk"
    gone "$machine"; counted slow; raster slow 0.06 "$(grep -c ' starved' "$tmp/talk")"
    run 0 "$loft" stream "$tmp/raster.nc" --machine "$tmp/laser.txt" --dry-run --grbl
    [ "$(grep -c '^M4S' "$tmp/out")" -gt 4000 ] || job_fails 'S is lost'
    machine chip --speed fast --once
    one_line 78 'raster.nc:2: the machine has no output for the laser with --plan chip' \
        "$loft" stream "$tmp/raster.nc" --plan=chip --port "$tmp/chip" --machine "$tmp/laser.txt"
    kill "$machine"
}
case_a_raster_is_held_and_goes_on() {
    printf 'laser = yes\nx.max_accel = 3000\ny.max_accel = 3000\n' >"$tmp/laser.txt"
    python3 tests/e2e/raster.py make M4 4 0.2 7 >"$tmp/raster.nc"
    machine held --speed fast --halt 200,400,900,1200 --once --steps 400
    types held "#halted at tick 200#h #asked to hold#> # held: #r
        #halted at tick 400#- @@- @@- @ 70 %@> #halted at tick 900#h #asked to hold#> # held: #r
        #halted at tick 1200#0 @100 %@>" \
        "$loft" stream "$tmp/raster.nc" --port "$tmp/held" --machine "$tmp/laser.txt" \
        || job_fails "$(tail -1 "$tmp/screen")"
    gone "$machine"; raster held 0.06 2
    [ "$(grep -c ' held: ' "$tmp/held.log")" -ge 2 ] || job_fails 'it was not held'
    # its sender is killed twice; the machine keeps what the laser is for, and no file says it
    machine killed --speed fast --halt 300,900 --once --steps 400 --keep "$tmp/kept"
    run 0 "$loft" set laser=yes x.max_accel=3000 y.max_accel=3000 --port "$tmp/killed"
    drawing_on=killed; job=("$loft" stream "$tmp/raster.nc" --port "$tmp/killed")
    for tick in 300 900; do cut_off $tick; done
    run 0 "${job[@]}"; gone "$machine"
    says err '^resuming at item'; says out 'as commanded$'
    counted killed; raster killed 0.06 2
}
