# tests/target/rows.sh -- rows of measured values, and the emulated ATmega328P behind a port;
# sourced, with $tmp a folder and $result a file
# SPDX-License-Identifier: MIT
. tests/support/appears.sh

# holds VALUE OPERATOR BOUND: exit code 0 if it does
holds() {
    awk -v x="$1" -v op="$2" -v y="$3" 'BEGIN {
        exit !(x != "" &&
            (op == "<=" ? x + 0 <= y + 0 : op == ">=" ? x + 0 >= y + 0 : x "" == y "")) }'
}

# row NAME VALUE OPERATOR BOUND [UNIT]
row() {
    local verdict=FAIL
    holds "$2" "$3" "$4" && verdict="ok  "
    printf '%s %-60s %s%s (%s %s)\n' "$verdict" "$1" "${2:-nothing}" "${5:+ $5}" "$3" "$4" |
        tee -a "$result"
}

# the sequence of steps of each axis, without their times
path_of() { path_rows "$1" | cksum; }
path_rows() {
    awk -F, '!/^#/ && $1 != "slot" {
                 for (i = 2; i <= NF; i++)
                     if ($i != last[i]) { last[i] = $i; row[i] = row[i] " " $i }
             }
             END { for (i = 2; i <= 4; i++) print row[i] }' "$1"
}

# told OUTPUT: the position that the command reports
told() { sed -n 's/.*steps \(-*[0-9]* -*[0-9]* -*[0-9]*\).*as commanded.*/\1/p' "$1" | head -1; }

# on_chip CHIP FIRMWARE COMMAND..: the chip behind $tmp/port, its pulses in $tmp/chip.csv, its
# results in $tmp/chip; with $touch set, the switch of x closes there; with $starve, its line
# is silent for 1 s after so many items, and after twice as many; with $jobs, it runs so many
# jobs, or until COMMAND ends; with $eeprom set, that file is its EEPROM, and with $states, that
# file gets what the EEPROM is after each byte that is written;
# COMMAND's output in $tmp/out and $tmp/err, its exit code in $code
on_chip() {
    local chip=$1 elf=$2 tick child
    shift 2
    tick=0x$(avr-nm "$elf" | awk '$3 == "loft_port_work_stub" { print $1 }')
    "$chip" "$elf" --tick "$tick" --link "$tmp/port" --record "$tmp/chip.csv" \
        ${starve:+--starve "$starve"} ${touch:+--touch "$touch"} ${jobs:+--jobs "$jobs"} \
        ${eeprom:+--eeprom "$eeprom"} ${states:+--states "$states"} >"$tmp/chip" 2>"$tmp/chip.err" &
    child=$!
    appears "$tmp/port"
    timeout 900 "$@" >"$tmp/out" 2>"$tmp/err" </dev/null; code=$?
    [ -z "${jobs:-}" ] || kill $child
    timeout 300 tail --pid=$child -f /dev/null || kill $child     # it ends when the job is closed
    wait $child
    sed 's/^/     /' "$tmp/chip.err"
    [ $code = 0 ] || sed 's/^/     /' "$tmp/err"
}
value() { awk -v name="$1" '$1 == name { $1 = ""; print substr($0, 2) }' "$tmp/chip"; }

# said NAME: the number after a name in $tmp/out, or in FILE
said() {
    awk -v name="$1" '{ for (i = 1; i < NF; i++) if ($i == name) print $(i + 1) }' "${2:-$tmp/out}"
}

# sum: the last line
sum() {
    local passed failed
    passed=$(grep -c '^ok' "$result") failed=$(grep -cE '^(FAIL|MISSED)' "$result")
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}
