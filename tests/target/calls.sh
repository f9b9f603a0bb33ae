#!/bin/sh
# tests/target/calls.sh -- compares the tables of lib/motion with the cost of its calls on an
# emulated ATmega328P, Cortex-M0 and M4, and that of hot loops with lib/COSTS.md
# SPDX-License-Identifier: MIT
# usage: tests/target/calls.sh DIR
# Prints a line per number. It holds if the call takes at most that, and at least 7/10 of it. Those
# of COSTS.md hold if they are within 3 %. The slots that the ATmega328P makes in assembly must also
# be those of Bresenham's line.
set -u
dir=$1
for tool in avr-gcc simavr arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null ||
        { echo "FAIL $tool is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1; }
done
mkdir -p "$dir"
sources="tests/target/calls.c $(echo lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c)"
sources="$sources lib/machine/pace.c lib/motion/scurve.c lib/motion/span.c lib/machine/step.c"
sources="$sources lib/surface/tensor/grid.c lib/surface/tensor/tensor.c"
sources="$sources lib/surface/tensor/coons.c lib/toolpath/lines.c lib/toolpath/lines_check.c"
flags="-std=c99 -ffunction-sections -fdata-sections -Wl,--gc-sections"
flags="$flags -Ilib -Itests/target -DLOFT_AXES=3"
avr-gcc -mmcu=atmega328p -Os $flags $sources -o "$dir/calls.elf" &&
timeout 900 simavr -m atmega328p -f 16000000 "$dir/calls.elf" 2>&1 |
    sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' >"$dir/atmega328p"
avr-gcc -mmcu=atmega328p -DLINES -Os $flags $sources -o "$dir/lines.elf" &&
timeout 900 simavr -m atmega328p -f 16000000 "$dir/lines.elf" 2>&1 |
    sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' >>"$dir/atmega328p"
avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -Os $flags -Wl,--section-start=.ring=0x800100 \
    -Wl,-Tdata=0x800180 tests/target/slots.c lib/machine/step.c lib/num/*.c -o "$dir/slots.elf" &&
timeout 900 simavr -m atmega328p -f 16000000 "$dir/slots.elf" 2>&1 |
    sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' >>"$dir/atmega328p"
# cycles_of NAME FUNCTION..: of the dearest call of the first, by cycles.awk
cycles_of() {
    name=$1
    shift
    ranges=$(arm-none-eabi-nm -S "$dir/calls-$core.elf" | awk -v names=" $* " '
        { name = $4; sub(/_q16x3$/, "", name) }
        index(names, " " name " ") { printf "%s0x%s+0x%s", comma, $1, $2; comma = "," }')
    timeout 900 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
        -icount shift=0 -singlestep -d exec,nochain -dfilter "$ranges" -D "$dir/trace" \
        -semihosting-config enable=on,target=native -kernel "$dir/calls-$core.elf" >"$dir/out" 2>&1
    first=$(arm-none-eabi-nm "$dir/calls-$core.elf" |
        awk -v name="${1}_q16x3" '$3 == name { sub(/^0+/, "", $1); print $1 }')
    echo "cycles_of_$name $(awk -v core=$core -v first="$first" -v entry="${1}_q16x3" \
        -f tests/target/cycles.awk "$dir/listing" "$dir/trace")" >>"$dir/$core"
    rm -f "$dir/trace"
}
for core in cortex-m0 cortex-m4; do
    arm-none-eabi-gcc -mthumb -mcpu=$core -O2 -ffreestanding -nostdlib $flags \
        -T tests/target/netduino.ld tests/target/microbit.c tests/target/semihost.S $sources -lgcc \
        -o "$dir/calls-$core.elf" &&
    timeout 900 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
        -icount shift=0 -semihosting-config enable=on,target=native \
        -kernel "$dir/calls-$core.elf" >"$dir/$core" 2>&1
    arm-none-eabi-objdump -d "$dir/calls-$core.elf" >"$dir/listing"
    cycles_of loft_forward_next loft_forward_next
    cycles_of loft_forward_run loft_forward_run loft_walk_run
    # a trace of a Cortex-M0 would have a gigabyte
    [ $core = cortex-m0 ] ||
        cycles_of loft_lines_next loft_lines_next add_tip add_cross loft_grid_next column_of \
            loft_walk2_step start_row loft_powers_init loft_walk_init loft_walk_powers \
            loft_walk_differences loft_limbs_divide loft_acc_hypot loft_acc_quot loft_acc_muldiv \
            loft_unit_ratio loft_root_q16x3.part.0 memcpy memset __udivmoddi4
done
awk -v dir="$dir" 'BEGIN {
        split("atmega328p cortex-m0 cortex-m4", core, " ")
        for (k = 1; k <= 3; k++)
            while ((getline line < (dir "/" core[k])) > 0) {
                n = split(line, f, " ")
                if (n == 2) cost[f[1], k] = f[2]
                if (n == 3 && f[1] == "bytes" && f[3] > size[f[2]]) size[f[2]] = f[3]
            }
    }
    function judge(what, said, is, least) {
        good = is + 0 > 0 && is <= said && is >= least * said; if (good) passed++; else failed++
        printf "%s %-34s %7d, said to be at most %d\n", good ? "ok  " : "FAIL", what, is, said
    }
    function near(what, said, is) {
        good = is + 0 > 0 && is <= 1.03 * said && is >= 0.97 * said
        if (good) passed++; else failed++
        printf "%s %-34s %7d, said to be %d within 3 %%\n", good ? "ok  " : "FAIL", what, is, said
    }
    $1 == "|" && match($0, /`[a-z_]+` \|[ 0-9,]*\|[ 0-9,]*\|/) {     # of COSTS.md
        name = substr($0, RSTART + 1); sub(/`.*/, "", name)
        gsub(",", ""); split($0, f, "|")
        for (k = 1; k <= 3; k++)
            if (f[k + 2] + 0 > 0) near(name ", " core[k], f[k + 2], cost[name, k])
    }
    $2 ~ /^loft_/ && $3 ~ /^[0-9,]+$/ {
        gsub(",", "")
        for (k = 1; k <= 3; k++) judge($2 ", " core[k], $(k + 2), cost[$2, k], 0.7)
        if ($6 ~ /^loft_/) judge("bytes of " $6, $7, size[$6], 1)
    }
    END {
        printf "%s wrong slots of %d in assembly: %d\n",
               cost["wrong", 1] == "0" ? "ok  " : "FAIL", cost["slots", 1], cost["wrong", 1]
        if (cost["wrong", 1] == "0" && cost["slots", 1] > 100000) passed++; else failed++
        for (k = 1; k <= 3; k++) {
            printf "%s %-34s %7s\n", cost["wrong_steps", k] == "0" ? "ok  " : "FAIL",
                   "wrong sums of a walk, " core[k], cost["wrong_steps", k]
            if (cost["wrong_steps", k] == "0") passed++; else failed++
        }
        printf "%d passed, %d failed\n", passed, failed + (passed + failed < 88)
        exit failed > 0 || passed < 88
    }' lib/motion/span.h lib/motion/scurve.h lib/COSTS.md
