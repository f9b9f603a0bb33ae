#!/bin/busybox sh
# tests/target/gpio_init.sh -- the guest of gpio.sh: two simulated GPIO chips, and loft-gpio on
# their lines, case by case
# SPDX-License-Identifier: MIT
# It prints `job NAME` on the console when a machine listens at its serial port, and writes the
# results to the debug port.
/bin/busybox --install -s /bin
export PATH=/bin
mount -t proc p /proc; mount -t sysfs s /sys; mount -t devtmpfs d /dev
mount -t debugfs g /sys/kernel/debug
insmod /lib/configfs.ko && insmod /lib/gpio-sim.ko || guest exit 9
mount -t configfs c /sys/kernel/config; mount -t tracefs t /sys/kernel/tracing

# chip LABEL LINES: its folder of lines in $folder
chip() {
    local at=/sys/kernel/config/gpio-sim/$1
    mkdir "$at" "$at/bank"
    echo "$2" > "$at/bank/num_lines"; echo "$1" > "$at/bank/label"
    [ "$1" != switches ] || { mkdir "$at/bank/line5"; echo ESTOP > "$at/bank/line5/name"; }
    echo 1 > "$at/live" || guest exit 9
    folder=/sys/devices/platform/$(cat "$at/dev_name")/$(cat "$at/bank/chip_name")
}
chip motors 8; motors=$folder
chip switches 8; switches=$folder

cat > /machine <<E
chip    = motors
x.step  = 0
x.dir   = 1
enable  = 2 low
z.step  = 3
z.dir   = 4
y.step  = switches:0        # an axis on another chip
y.dir   = switches:1
estop   = ESTOP up          # by its name; opens against a bias, so a torn wire stops, too
x.limit = switches:6 low
port    = /dev/ttyS1
hold    = switches:3
resume  = switches:4
E
mkdir /etc; echo 'plain:x:1000:1000::/:/bin/sh' > /etc/passwd
chmod 777 /tmp
trace=/sys/kernel/tracing
echo mono > $trace/trace_clock; echo 24576 > $trace/buffer_size_kb
echo 1 > $trace/events/gpio/gpio_value/enable

# begin VERSION NAME OPTION..: a machine that listens; $pid
begin() {
    local version=$1 name=$2
    shift 2
    echo > $trace/trace
    rm -f /tmp/record
    set -- loft-gpio$version --once --record /tmp/record "$@" /machine
    if [ "$name" = plain ]; then ulimit -l 64; su plain -c "exec $*"; else exec "$@"; fi \
        > /said 2>&1 &
    pid=$!
    while ! grep -q machine: /said && kill -0 $pid; do usleep 20000; done
    # the emergency stop is closed to ground, against the bias that the machine has asked for
    guest pull $switches/sim_gpio5/pull down 100000 > /dev/null
    echo "job $name$version"
}
# finish VERSION NAME: wait for its end
finish() {
    wait $pid; echo "code $?" >> /said
    guest put "$2$1.said" < /said
    guest put "$2$1.record" < /tmp/record
    guest changes < $trace/trace | guest put "$2$1.lines"
    guest put "$2$1.pulls" < /pulls
    : > /pulls
}
# moving: wait until at least a thousand pulses have been made
# (the record is written in portions)
moving() { while [ "$(wc -c < /tmp/record)" -lt 16000 ] && kill -0 $pid; do usleep 20000; done; }

: > /pulls
for version in 1 2; do
    guest put map$version < /sys/kernel/debug/gpio
    guest pull $switches/sim_gpio6/pull up 1000 > /dev/null

    begin $version whole
    finish $version whole

    # a pulse shorter than the debouncing, then a switch that bounces and stays closed
    begin $version estop max_speed=20
    moving
    guest pull $switches/sim_gpio5/pull up 2000 down 300000 \
        up 300 down 700 up 200 down 1500 up 1000 down 100 up 0 > /pulls
    finish $version estop

    begin $version limit max_speed=20
    moving
    guest pull $switches/sim_gpio3/pull up 400000 down 0 > /dev/null
    guest pull $switches/sim_gpio4/pull up 300000 down 0 > /dev/null
    guest pull $switches/sim_gpio6/pull down 300 up 700 down 0 > /pulls
    finish $version limit
    guest pull $switches/sim_gpio6/pull up 1000 > /dev/null

    # a second machine finds the lines in use; the first one is told to end during the job
    begin $version term max_speed=20
    {   loft-gpio$version --look /machine
        loft-gpio$version link=/tmp/other port= /machine
        echo "code $?"
    } 2>&1 | guest put busy$version
    moving
    kill -TERM $pid
    finish $version term

    # an account without rights, next to another program that uses all the time it gets
    chown plain /dev/gpiochip* /dev/ttyS1
    yes > /dev/null & busy=$!
    begin $version plain
    finish $version plain
    kill $busy

    # a chip that disappears during a job
    begin $version gone max_speed=20
    moving
    echo 0 > /sys/kernel/config/gpio-sim/motors/live
    finish $version gone
    echo 1 > /sys/kernel/config/gpio-sim/motors/live
done
guest exit 16
