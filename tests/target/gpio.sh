#!/bin/bash
# tests/target/gpio.sh -- loft-gpio on a real kernel with simulated GPIO chips, with libgpiod 1.x
# and 2.x; a line `ok` or `FAIL` per number
# SPDX-License-Identifier: MIT
# usage: tests/target/gpio.sh CACHE GUEST LOFT ; CACHE is made by gpio_get.sh, GUEST holds
# loft-gpio1, loft-gpio2 and guest
# Counted instructions are the clock (-icount, 125 per us; idle time is skipped): the lateness of
# pulses does not depend on the load of this computer.
# The sender is this computer, at the other end of the guest's serial port.
set -u
cache=$1 guest=$2 loft=$3
drawing=tests/drawings/outline12.csv feed=50
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result
. tests/target/rows.sh

for tool in qemu-system-x86_64 cpio python3 busybox; do
    command -v $tool >/dev/null ||
        { echo "FAIL $tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done

# image: the guest's files, packed
image() {
    local root=$tmp/root
    mkdir -p "$root"/{bin,lib,proc,sys,dev,tmp}
    cp "$(command -v busybox)" "$guest"/{loft-gpio1,loft-gpio2,guest} "$root/bin/"
    cp "$cache"/*.ko "$root/lib/"
    cp tests/target/gpio_init.sh "$root/init"
    chmod +x "$root/init"
    (cd "$root" && find . | cpio -o -H newc 2>/dev/null | gzip -1) > "$tmp/image"
}

# here NAME SPEED: the same job on the simulated machine, its pulses in $tmp/here.NAME
here() {
    "$loft" simulate --link "$tmp/at.$1" --record "$tmp/here.$1" --once --quiet --steps 80 \
        --max-speed "$2" --accel 500 --slots 20 --queue 1024 >"$tmp/sim" &
    local sim=$!
    appears "$tmp/at.$1"
    timeout 900 "$loft" stream "$drawing" --feed $feed --port "$tmp/at.$1" >"$tmp/planned" 2>&1
    wait $sim
}

# send CASE: stream to the machine of this case when it listens;
# output in $tmp/CASE.out, exit code in $tmp/CASE.code
send() {
    until grep -q "^job $1" "$tmp/console" 2>/dev/null; do
        kill -0 $qemu 2>/dev/null || return 1
        sleep 0.05
    done
    # each case has a machine of its own, whose place no job before has lost
    XDG_STATE_HOME=$tmp/state.$1 timeout 900 "$loft" stream "$drawing" --feed $feed \
        --port "unix:$tmp/line" >"$tmp/$1.out" 2>&1 </dev/null
    echo $? > "$tmp/$1.code"
}

# wave CASE: its numbers for `value`
wave() {
    python3 tests/target/gpio_wave.py "$tmp/dump" "$1" "$tmp/$1.csv" >"$tmp/chip"
    code=$(cat "$tmp/$1.code")
}

# starts CASE: does every axis step as in the first part of the slow job on the simulated machine?
starts() {
    python3 - "$tmp/$1.csv" "$tmp/here.slow" <<'P'
import sys
def rows(path):
    steps, last = [[], [], []], [0, 0, 0]
    for line in open(path):
        if line[0].isdigit():
            for i, at in enumerate(map(int, line.split(",")[1:])):
                if at != last[i]:
                    steps[i].append(at)
                    last[i] = at
    return steps
case, slow = rows(sys.argv[1]), rows(sys.argv[2])
print(sum(len(a) for a in case) and all(a == b[:len(a)] for a, b in zip(case, slow)))
P
}

# paper NAME WHAT PLAN: the job by loft-gpio-NAME, here, on lines of paper, behind a pseudo
# terminal, planned by the host or the machine
paper() {
    local dump=$tmp/dump.$1
    LOFT_PAPER=$tmp/paper "$guest/loft-gpio-$1" --once --record "$tmp/record" link="$tmp/paper.$1" \
        priority=0 chip=/dev/0 x.step=0 x.dir=1 enable="2 low" \
        z.step=3 z.dir=4 y.step=/dev/1:0 y.dir=/dev/1:1 >"$tmp/said" 2>&1 & local machine=$!
    appears "$tmp/paper.$1"
    timeout 900 "$loft" stream "$drawing" --feed $feed --plan="$3" --port "$tmp/paper.$1" \
        >"$tmp/out" 2>&1 </dev/null
    code=$?
    wait $machine
    echo "code $?" >> "$tmp/said"
    {   echo "=== map0"
        echo "gpiochip0: GPIOs 0-7, parent: none, motors"
        echo "gpiochip1: GPIOs 100-107, parent: none, switches"
        echo "=== paper0.said"; cat "$tmp/said"
        echo "=== paper0.record"; cat "$tmp/record"
        echo "=== paper0.lines"; cat "$tmp/paper"
        echo "=== paper0.pulls"
    } > "$dump"
    python3 tests/target/gpio_wave.py "$dump" paper0 "$tmp/paper.csv" >"$tmp/chip"
    echo "-- on paper, under $2, planned by the $3"
    row "the command ends well"                               "$code" = 0
    row "the program ends well"                               "$(value code)" = 0
    row "every axis steps as on the simulated machine" \
        "$(path_of "$tmp/paper.csv")" = "$(path_of "$tmp/here.fast")"
    row "direction set before a pulse (5 us), at least"       "$(value setup)" ">=" 5 us
    row "direction kept after a pulse (5 us), at least"       "$(value hold)" ">=" 5 us
    safe "paper"
    [ "$(value code)" = 0 ] || cat "$tmp/said"
}

# channel: a PWM channel of the kernel, whose duty cycles go to $tmp/duty
channel() {
    mkdir -p "$tmp/pwm"; rm -f "$tmp/pwm"/*; : >"$tmp/pwm/period"; : >"$tmp/pwm/enable"
    mkfifo "$tmp/pwm/duty_cycle"
    cat <"$tmp/pwm/duty_cycle" >"$tmp/duty" & reader=$!
}

# on_paper ARGUMENT..: the machine on lines of paper, under ThreadSanitizer; $machine, $tmp/at.paper
on_paper() {
    rm -f "$tmp/at.paper"
    LOFT_PAPER=$tmp/paper "$guest/loft-gpio-race" link="$tmp/at.paper" priority=0 chip=/dev/0 \
        x.step=0 x.dir=1 y.step=/dev/1:0 y.dir=/dev/1:1 z.step=3 z.dir=4 "$@" \
        >"$tmp/said" 2>"$tmp/err" & machine=$!
    appears "$tmp/at.paper"
}

# outputs: a laser by the PWM, a spindle by a relay, a laser that a relay refuses
outputs() {
    echo "-- on paper: outputs"
    printf '%s\n' 'G21 G90' 'M4 S500' 'G1 X10 F1200' 'M8' 'X20' 'M9' 'M5' >"$tmp/burn.nc"
    echo 'laser = yes' >"$tmp/laser.txt"
    channel
    on_paper pwm="$tmp/pwm" spindle=5 coolant=6 --once
    timeout 900 "$loft" stream "$tmp/burn.nc" --machine "$tmp/laser.txt" --port "$tmp/at.paper" \
        >"$tmp/out" 2>&1 </dev/null; code=$?
    wait $machine; row "laser: the program ends well" "$?" = 0
    wait $reader
    row "laser: the command ends well"                        "$code" = 0
    row "laser: period of 1 kHz, on" \
        "$(cat "$tmp/pwm/period" "$tmp/pwm/enable" | xargs)" = "1000000 1"
    row "laser: half of the power at full speed" \
        "$(sort -n "$tmp/duty" | tail -1 | awk '{ print ($1 > 490000 && $1 < 505000) }')" = 1
    row "laser: less where it starts and stops" \
        "$(awk '$1 > 0 && $1 < 250000' "$tmp/duty" | wc -l)" ">=" 10
    row "laser: off at the end"                               "$(tail -1 "$tmp/duty")" = 0
    # where the ring runs dry on a busy computer a laser is off as well
    row "laser: its enable, off, on, .. off" \
        "$(awk '$2 == 5 { print $3 }' "$tmp/paper" | uniq | sed '1p; 2p; $!d' | xargs)" = "0 1 0"
    row "coolant: off, on, off" "$(awk '$2 == 6 { printf "%s ", $3 }' "$tmp/paper")" = "0 1 0 "
    on_paper relay=5 --once
    sed 's/M4/M3/; /M[89]/d' "$tmp/burn.nc" >"$tmp/turn.nc"
    timeout 900 "$loft" stream "$tmp/turn.nc" --port "$tmp/at.paper" >"$tmp/out" 2>&1 </dev/null
    row "relay: the command ends well"                        "$?" = 0
    wait $machine
    row "relay: on, off"  "$(awk '$2 == 5 { printf "%s ", $3 }' "$tmp/paper")" = "0 1 0 "
    on_paper relay=5 --once
    sed '/M[89]/d' "$tmp/burn.nc" >"$tmp/cut.nc"
    timeout 900 "$loft" stream "$tmp/cut.nc" --machine "$tmp/laser.txt" --port "$tmp/at.paper" \
        >"$tmp/out" 2>&1 </dev/null
    row "relay: a laser is not drawn"                         "$?" = 75
    wait $machine
    row "relay: it says why" "$(grep -c 'relay: a line cannot give a laser a part' "$tmp/err")" = 1
    row "relay: it was never on"  "$(awk '$2 == 5 { printf "%s ", $3 }' "$tmp/paper")" = "0 "
    row "outputs: races" "$(grep -c 'WARNING: ThreadSanitizer' "$tmp/err")" = 0
}

# apart: the steps of line 0 less those of line 2
apart() {
    awk '$2 == 1 { way = $3 ? 1 : -1 }
         $3 && $2 == 0 { d += way } $3 && $2 == 2 { d -= way } END { print d }' "$tmp/paper"
}

# homes: the switch of x is 400 steps, 5 mm, towards minus
homes() {
    echo "-- on paper: loft home and loft probe"
    printf '%s\n' 'x.travel = 40' 'x.home_order = 1' 'x.home_seek = 5' 'x.home_touch = 0.25' \
        >"$tmp/home.txt"
    LOFT_PAPER_SWITCH=400 on_paper x.limit=5
    timeout 900 "$loft" home --machine "$tmp/home.txt" --port "$tmp/at.paper" >"$tmp/out" 2>&1
    code=$?
    row "home: the command ends well"                         "$code" = 0
    row "home: the touches differ by, in steps" \
        "$(sed -n 's/.* within \([0-9]*\) step.*/\1/p' "$tmp/out")" "<=" 1
    row "home: the tool stands 3 mm before the switch" \
        "$(sed -n 's/^homed: the tool is at //p' "$tmp/out")" = "0.000 0.000 0.000"
    kill $machine; wait $machine
    row "home: there by its pulses, in steps" "$(awk '
        $2 == 1 { minus = $3 } $2 == 0 && $3 { x += minus ? -1 : 1 }
        END { x += 160; print x < 0 ? -x : x }' "$tmp/paper")" "<=" 1
    LOFT_PAPER_SWITCH=400 on_paper probe=6
    timeout 900 "$loft" probe x- --feed 1 --port "$tmp/at.paper" >"$tmp/out" 2>&1; code=$?
    row "probe: the command ends well"                        "$code" = 0
    row "probe: touched at, in mm" \
        "$(sed -n 's/^touched at -\([0-9.]*\) .*/\1/p' "$tmp/out")" "<=" 5.05
    kill $machine; wait $machine
    sed -i "s/^x.home_touch.*/x.home_touch = 2/" "$tmp/home.txt"
    echo "x.square = yes" >>"$tmp/home.txt"
    LOFT_PAPER_SWITCH=400 LOFT_PAPER_SKEW=30 on_paper x.step2=2 x.limit=5 x.limit2=7
    timeout 900 "$loft" home --machine "$tmp/home.txt" --port "$tmp/at.paper" >"$tmp/out" 2>&1
    code=$?
    row "square: the command ends well"                       "$code" = 0
    row "square: its switches close within, in steps" \
        "$(sed -n 's/.* close within \([0-9]*\) step.*/\1/p' "$tmp/out")" "<=" 2
    # sought at 400 steps/s: the first switch is seen some ms later
    row "square: they did before, 30 steps, at least" \
        "$(sed -n 's/.* each other, before //p' "$tmp/out")" ">=" 24
    row "square: the same, at most" "$(sed -n 's/.* each other, before //p' "$tmp/out")" "<=" 32
    kill $machine; wait $machine
    row "square: the first motor went on, by its pulses, least" "$(apart)" ">=" 28
    row "square: the same, at most"                           "$(apart)" "<=" 32
    row "home, probe: races" "$(grep -c 'WARNING: ThreadSanitizer' "$tmp/err")" = 0
}

# refuses CODE TEXT ARGUMENT..: with that exit code and one line that has TEXT
refuses() {
    local expected=$1 text=$2 code
    shift 2
    LOFT_PAPER=$tmp/paper timeout 600 "$guest/loft-gpio-memory" "$@" >"$tmp/out" 2>"$tmp/err"
    code=$?
    row "refused: $*" "$code $(wc -l < "$tmp/err") $(grep -c "$text" "$tmp/err")" = "$expected 1 1"
}

# section NAME: of the guest's output on the debug port
section() { awk -v n="=== $1" '/^===/ { on = $0 == n } on' "$tmp/dump"; }

# safe NAME: the properties that hold in each case
safe() {
    row "$1: steps told and steps counted at the lines"       "$(value told)" = "$(value position)"
    row "$1: shortest pulse (5 us)"                           "$(value width)" ">=" 5 us
    row "$1: between two pulses of an axis, at least"         "$(value low)" ">=" 5 us
    row "$1: step lines high at the end"                      "$(value high)" = 0
    row "$1: enable (active low): off, on, off"               "$(value enable)" = "1 0 1"
}

image
timeout 600 qemu-system-x86_64 -accel tcg -icount shift=3,sleep=off -m 384 -nodefaults \
    -no-user-config -display none -no-reboot \
    -serial "file:$tmp/console" -chardev "socket,id=line,path=$tmp/line,server=on,wait=off" \
    -serial chardev:line \
    -chardev "file,id=dump,path=$tmp/dump" -device isa-debugcon,iobase=0xe9,chardev=dump \
    -device isa-debug-exit,iobase=0xf4,iosize=0x4 \
    -kernel "$cache/vmlinuz" -initrd "$tmp/image" -append "console=ttyS0 quiet panic=-1" \
    >"$tmp/qemu" 2>&1 </dev/null &
qemu=$!
here fast 100
here slow 20
for version in 1 2; do
    for case in whole estop limit term plain gone; do send $case$version || break; done
done
wait $qemu; ended=$?
paper race ThreadSanitizer host
paper memory AddressSanitizer chip
outputs
homes
refuses 64 'no axis: give a file'                       chip=/dev/0
refuses 64 'what is --lok'                              --lok
refuses 65 'unknown key: see --help'           chip=/dev/0 w.step=1
refuses 65 'give a whole number from 1 to 1000'         slots=2.5
refuses 65 'at most 200000 slots per second'            slots=1000 x.step=/dev/0:0 x.dir=/dev/0:1
refuses 65 'low may follow the line'                    x.step="1 high"
refuses 78 'it is in place of a pwm'                    chip=/dev/0 x.step=0 x.dir=1 relay=5 pwm=/x
refuses 78 'it belongs to a pwm'                        chip=/dev/0 x.step=0 x.dir=1 spindle=5
refuses 77 'give the folder of a channel'               chip=/dev/0 x.step=0 x.dir=1 pwm=/x
refuses 66 'cannot read: No such file'                  /nonexistent
refuses 78 'two motors of an axis are squared by a switch each' \
    chip=/dev/0 x.step=0 x.dir=1 x.step2=2 x.limit=5
refuses 78 'two motors of an axis are squared by a switch each' \
    chip=/dev/0 x.step=0 x.dir=1 x.limit2=5
refuses 78 'x.step has no dir'                          x.step=/dev/0:0
refuses 78 'is the same line as x.step'                 chip=/dev/0 x.step=0 x.dir=0
refuses 78 'a number, but of which chip'                x.step=0 x.dir=1
refuses 78 'has no such line'                           chip=/dev/0 x.step=0 x.dir=8
refuses 71 'another program has it\|not a serial port'  chip=/dev/0 x.step=0 x.dir=1 port=/dev/null
row "the guest: kernel, modules, chips, every case" "$ended" = 33        # (16 << 1) | 1
[ "$ended" = 33 ] || { cat "$tmp/qemu" "$tmp/console" "$tmp"/*.out; sum; exit 1; }

for v in 1 2; do
    name="libgpiod $("$guest/loft-gpio$v" --help | sed -n 's/.*(libgpiod \([0-9.]*\)).*/\1/p')"
    echo "-- $name: $drawing at $feed mm/s, 80 steps/mm, axes on two chips"
    wave whole$v
    row "the command ends well"                               "$code" = 0
    row "every axis steps as on the simulated machine" \
        "$(path_of "$tmp/whole$v.csv")" = "$(path_of "$tmp/here.fast")"
    row "steps at the lines and steps put down" \
        "$(value pulses)" = "$(value recorded)"
    safe "job"
    row "direction set before a pulse (5 us), at least"       "$(value setup)" ">=" 5 us
    row "direction kept after a pulse (5 us), at least"       "$(value hold)" ">=" 5 us
    row "closer to the one before than planned (50 us and calls)" "$(value closer)" "<=" 75 us
    row "lateness told, worst"                                "$(value worst)" "<=" 1000 us
    row "later than told, seen at the lines" \
        "$(awk -v a="$(value apart)" -v t="$(value worst)" 'BEGIN { print a - t }')" "<=" 30 us
    row "slower than planned, seen less told" \
        "$(awk -v a="$(value longer)" -v t="$(value slower)" 'BEGIN { print a - t }')" "<=" 0.1 ms
    row "time to planned time"                                "$(value took)" "<=" 1.01
    row "ran dry"                                             "$(value dry)" = 0

    echo "-- $name: emergency stop in mid-job, before it a touch of 2 ms"
    wave estop$v
    row "the machine says that the job was aborted"           "$(value ended)" = aborted
    row "estop: steps after the touch"                        "$(value between)" ">=" 200
    row "estop: standing after its last bounce"               "$(value standing)" "<=" 150 ms
    row "estop: the path until there is that of the job"      "$(starts estop$v)" = True
    safe "estop"

    echo "-- $name: a limit switch, active low, that bounces"
    wave limit$v
    row "the machine says that the job was aborted"           "$(value ended)" = aborted
    row "hold and resume before it: the longest pause"        "$(value pause)" ">=" 250 ms
    row "limit: standing after its last bounce"               "$(value standing)" "<=" 150 ms
    row "limit: the path until there is that of the job"      "$(starts limit$v)" = True
    safe "limit"

    echo "-- $name: kill -TERM in mid-job; before it, a second machine on the same lines"
    wave term$v
    row "the program ends well"                               "$(value code)" = 0
    row "and has aborted the job"                             "$(value ended)" = aborted
    row "kill: the path until there is that of the job"       "$(starts term$v)" = True
    safe "kill"
    section busy$v > "$tmp/busy"
    row "the second: lines that it is told who has" \
        "$(grep -c 'in use by loft' "$tmp/busy")" = 11
    row "the second: refuses, with the owner's name" \
        "$(grep -c 'loft-gpio: x.step: 0: /dev/gpiochip[0-9]* line 0 is in use by "loft"' \
            "$tmp/busy")" = 1
    row "the second: exit code" \
        "$(sed -n 's/^code //p' "$tmp/busy")" = 69

    echo "-- $name: an account without rights, beside a program that takes all the time it gets"
    wave plain$v
    section plain$v.said > "$tmp/said"
    row "it says that memory is not locked" \
        "$(grep -c 'memory cannot be locked' "$tmp/said")" = 1
    row "it says that it has no priority" \
        "$(grep -c 'no real-time priority' "$tmp/said")" = 1
    row "every axis steps as on the simulated machine" \
        "$(path_of "$tmp/plain$v.csv")" = "$(path_of "$tmp/here.fast")"
    safe "plain"
    row "lateness told, worst"                                "$(value worst)" ">=" 100 us
    row "closer to the one before than planned (50 us and calls)" "$(value closer)" "<=" 75 us
    row "slower than planned, seen less told" \
        "$(awk -v a="$(value longer)" -v t="$(value slower)" \
            'BEGIN { d = a - t; print d < 0 ? -d : d }')" "<=" 0.2 ms
    row "time to planned time"                                "$(value took)" "<=" 1.5

    echo "-- $name: a chip that goes in mid-job"
    wave gone$v
    section gone$v.said > "$tmp/said"
    row "the program says so" \
        "$(grep -c 'a chip no longer obeys' "$tmp/said")" = 1
    row "its exit code"                                       "$(value code)" = 74
done

sum
