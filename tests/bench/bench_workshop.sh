#!/bin/bash
# tests/bench/bench_workshop.sh -- measures what a machine in a workshop needs: homing, stops,
# a laser, a servo, settings; ends with the sums
# SPDX-License-Identifier: MIT
# usage: tests/bench/bench_workshop.sh FIRMWARE.elf LOFT HELPERS TYPIST
# HELPERS holds chip, rate; TYPIST types keys: build/e2e/pty.
# ROWS in the environment: some of the groups of rows alone, see `all` below; others are passed by.
# The chip is an emulated ATmega328P at 16 MHz, cycle by cycle, 115200 baud; the firmware's tick has
# 1 ms and 80 slots.
set -u
elf=$1 loft=$2 chip=$3/chip rate=$3/rate pty=$4
all='home stop laser servo settings'
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result; : >"$result"
. tests/target/rows.sh

# row NAME VALUE OPERATOR BOUND [UNIT]
row() {
    local verdict=MISSED
    holds "$2" "$3" "$4" && verdict="ok    "
    printf '%s  %-78s %-10s %s %s%s\n' "$verdict" "$1" "${2:-nothing}" "$3" "$4" "${5:+ $5}" |
        tee -a "$result"
}


# --- homing ---------------------------------------------------------------------------------------

measure_home() {
    local bounces name
    printf 'x.home_order = 1\nx.home_search = 20\nx.home_at = 100\nx.home_touch = 5\n' \
        >"$tmp/home.txt"
    for bounces in 0 5; do
        name="homing at 5 mm/s, 250 steps/mm, a switch that bounces for $bounces ms"
        touch=-2000,$bounces jobs=99
        on_chip "$chip" "$elf" "$loft" home --port "$tmp/port" --machine "$tmp/home.txt" \
            --touches 9
        touch='' jobs=
        row "$name: 9 touches differ by" "$(said within)" "<=" 1 step
        # home_back is 750 steps; the switch closes at -2000, which counts as 100 mm
        row "the same: the tool is off its place by, at its pulses" \
            "$(value position | awk '{ d = $1 + 1250; print d < 0 ? -d : d }')" "<=" 1 step
    done
}


# --- stops ----------------------------------------------------------------------------------------

# The filter of a guard is 1 ms: the contact must last for two samples.
measure_stop() {
    local per_tick axes name filter what most then end place
    for per_tick in 5 40; do
        for axes in 1 3; do
            name="$axes axes at $((per_tick * 4)) mm/s, 250 steps/mm"
            while read -r filter what most then end; do
                : >"$tmp/stops"
                for place in 1 3 7 11 23; do
                    touch=$((per_tick * 250 + place))
                    on_chip "$chip" "$elf" "$rate" "$tmp/port" "$axes" "$per_tick" "$filter"
                    python3 tests/bench/stops.py "$tmp/chip.csv" "$touch" "$per_tick" >"$tmp/stop"
                    touch=
                    said "$what" "$tmp/stop" >>"$tmp/stops"
                done
                row "$name: from a switch to $end" \
                    "$(sort -n "$tmp/stops" | sed -n '5p')" \
                    "<=" "$most" "ms: two samples, ${then/_/ }"
            done <<TABLE
1 slower 3 1_tick the first slower tick
1! last 2.013 1_slot a hard stop
TABLE
        done
    done
}


# --- a laser --------------------------------------------------------------------------------------

# burnt NAME FILE: 13.33 ms of full power for each mm, as S400 of 1000 at 30 mm/s asks
burnt() {
    python3 tests/target/energy.py "$2" 1 >"$tmp/energy"
    row "$1: windows of 1 mm" "$(said windows "$tmp/energy")" ">=" 100
    row "$1: energy for each mm, off S/F by" "$(said mean "$tmp/energy" |
        awk '{ d = $1 * 0.075 - 1; printf "%.2f", 100 * (d < 0 ? -d : d) }')" "<=" 1 %
    row "$1: the mm that differs most from the mean" "$(said worst "$tmp/energy")" "<=" 2 %
    row "$1: energy while it stands, and after" \
        "$(awk '/^(standing|after)/ { s += $2 } END { print s }' "$tmp/energy")" = 0 ms
}

# keys KEY COUNT: the key so often, at once
keys() { for _ in $(seq "$2"); do printf '@@%s ' "$1"; done; }

# here OPTIONS..: the simulated machine behind $tmp/m
here() {
    rm -f "$tmp/m" "$tmp/m.log"
    "$loft" simulate --link "$tmp/m" --record "$tmp/m.csv" --steps 250 --ramp 40 --once "$@" \
        >"$tmp/m.log" 2>&1 &
    machine=$!
    "$pty" until "$tmp/m.log" '^machine: '
}

# ends WHAT: the job was done; otherwise the machine is ended as well
ends() {
    timeout 60 tail --pid=$machine -f /dev/null || kill $machine
    wait $machine
    row "$1: the job is done" "$(grep -c ' done: ' "$tmp/m.log")" = 1
}

measure_laser() {
    "$loft" export tests/drawings/outline12.csv -o "$tmp/cut.nc"
    { printf 'G21 G90 G94 G17\nM4 S400\n'
      grep '^[GXY]' "$tmp/cut.nc" | sed '1d; /^G0/d'
      echo M5; } >"$tmp/burn.nc"
    printf 'laser = yes\n' >"$tmp/laser.txt"
    local burn=("$loft" stream "$tmp/burn.nc" --machine "$tmp/laser.txt")

    local held='#asked to hold#> # held: #r'
    here --queue 12 --halt 200,600,900,1000,1300,1600
    timeout 100 "$pty" type "$tmp/m.log" $machine "#halted at tick 200#. $(keys + 10) @200 %@>
        #halted at tick 600#h $held #halted at tick 900#0 @100 %@>
        #halted at tick 1000#. $(keys - 9) @ 10 %@> #halted at tick 1300#h $held
        #halted at tick 1600#0 @100 %@>" "${burn[@]}" --port "$tmp/m" >"$tmp/bar" 2>&1
    ends "outline12, held, at 10 to 200 %, simulated"
    row "the same: held, times" "$(grep -c ' held: ' "$tmp/m.log")" ">=" 2
    row "the same: lowest and highest override" "$(grep -o '[0-9]* %  queue' "$tmp/bar" |
        sort -n | sed -n '1s/ .*//p; $s/ .*//p' | tr '\n' ' ')" = '10 200 '
    burnt "the same" "$tmp/m.csv"

    # a line of 7500 baud brings half of the items that the plan needs
    here --queue 12 --line-baud 7500
    timeout 100 "${burn[@]}" --port "$tmp/m" >/dev/null 2>&1
    ends "outline12, a line that starves it, simulated"
    row "the same: time over that of the plan" "$(awk '/ done: / {
        for (i = 1; i < NF; i++) if ($i == "ticks") printf "%.2f", $(i + 2) * 1000 / $(i - 1) }' \
        "$tmp/m.log")" ">=" 1.3
    burnt "the same" "$tmp/m.csv"

    # the line is silent for 1 s after 17 and 34 items: the queue of the chip runs empty
    starve=17
    on_chip "$chip" "$elf" "${burn[@]}" --port "$tmp/port" --feed 30
    starve=
    row "outline12, the line silent twice, ATmega328P: the job is done" "$code" = 0
    row "the same: the way" "$(python3 tests/target/energy.py "$tmp/chip.csv" 1 |
        sed -n 's/^way //p')" "<=" 131 mm
    row "the same: stops of 50 ms at least" "$(awk -F, '/^[0-9]/ {
        if (a && $1 - a > 800000) n++; a = $1 } END { print n + 0 }' "$tmp/chip.csv")" = 2
    burnt "the same" "$tmp/chip.csv"
}


# --- a servo --------------------------------------------------------------------------------------

# 1 us a step: the servo is at its end, 2500 us, for most of the time
measure_servo() {
    rm -f "$tmp/servo"
    eeprom=$tmp/servo jobs=99
    on_chip "$chip" "$elf" "$loft" set z.drive=servo servo_zero=1000 z.steps_per_mm=100 \
        x.steps_per_mm=250 y.steps_per_mm=250 z.max_speed=320 --port "$tmp/port"
    jobs=
    on_chip "$chip" "$elf" "$rate" "$tmp/port" 3 40
    eeprom=''
    row "3 axes at 40 steps/ms and a servo: every step is there" "$code" = 0
    awk '/^# servo/ { if (!n++) from = $8 + 3200000
            if ($8 < from) next
            e = $4 - 2500; e = e < 0 ? -e : e; if (e > error) error = e
            if (!m++ || $4 < w0) w0 = $4
            if ($4 > w1) w1 = $4 }
        END { print "pulses", m; print "error", error + 0; print "jitter", w1 - w0 }' \
        "$tmp/chip.csv" >"$tmp/widths"
    row "the same: pulses of the servo" "$(said pulses "$tmp/widths")" ">=" 15
    row "the same: error of their width" "$(said error "$tmp/widths")" "<=" 4 us
    row "the same: jitter of their width" "$(said jitter "$tmp/widths")" "<=" 8 us
}


# --- settings -------------------------------------------------------------------------------------

# kept NAME: what the chip says with the EEPROM $eeprom
kept() {
    jobs=99
    on_chip "$chip" "$elf" "$loft" settings --port "$tmp/port"
    jobs=
    sed '1d' "$tmp/out" >"$tmp/$1"
    grep -c 'kept by the machine' "$tmp/out" >"$tmp/sound"
}

# Each state of the EEPROM while settings are written: as it is, and with the next byte half
# written, that is erased.
measure_settings() {
    local states n at which mixed=0 old=0 new=0 unsound=0
    rm -f "$tmp/eeprom"
    eeprom=$tmp/eeprom jobs=99
    on_chip "$chip" "$elf" "$loft" set steps_per_mm=80 max_speed=100 x.travel=60 x.reversed=yes \
        idle=1 --port "$tmp/port"
    kept old
    states=$tmp/states jobs=99
    on_chip "$chip" "$elf" "$loft" set steps_per_mm=100 max_speed=200 x.travel=75 x.reversed=no \
        idle=2 --port "$tmp/port"
    states=''
    kept new
    n=$(($(stat -c %s "$tmp/states") / 1024))
    row "settings: bytes written one by one, and as many states half written" "$n" ">=" 60
    eeprom=$tmp/cut
    for ((k = 0; k < 2 * n - 1; k++)); do
        dd if="$tmp/states" of="$eeprom" bs=1024 skip=$((k / 2)) count=1 2>/dev/null
        if [ $((k % 2)) = 1 ]; then
            dd if="$tmp/states" of="$tmp/next" bs=1024 skip=$((k / 2 + 1)) count=1 2>/dev/null
            at=$(cmp "$eeprom" "$tmp/next" | sed 's/.*byte \([0-9]*\),.*/\1/')
            printf '\377' | dd of="$eeprom" bs=1 seek=$((at - 1)) conv=notrunc 2>/dev/null
        fi
        kept now
        if cmp -s "$tmp/now" "$tmp/old"; then old=$((old + 1))
        elif cmp -s "$tmp/now" "$tmp/new"; then new=$((new + 1))
        else mixed=$((mixed + 1)); fi
        [ "$(cat "$tmp/sound")" = 1 ] || unsound=$((unsound + 1))
    done
    eeprom=''
    row "settings, the power cut in each of them: the old ones are kept" "$old" ">=" 60
    row "the same: the new ones" "$new" ">=" 1
    row "the same: a mixture, or others" "$mixed" = 0
    row "the same: the firmware's, as damaged" "$unsound" = 0
}

for rows in ${ROWS:-$all}; do
    case " $all " in *" $rows "*) measure_"$rows" ;; esac
done
sum
