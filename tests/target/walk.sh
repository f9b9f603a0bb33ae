#!/bin/bash
# tests/target/walk.sh -- the walk of ports/README.md on an emulated ATmega328P: sections 4 to 6
# SPDX-License-Identifier: MIT
# usage: tests/target/walk.sh FIRMWARE.elf LOFT HELPERS ; HELPERS holds chip.
# The chip has one switch, so section 7, homing, is run on the simulated machine (e2e.sh).
set -u
tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
export XDG_STATE_HOME=$tmp/state       # where it is noted that a job began
result=$tmp/result
. tests/target/rows.sh
sh tests/e2e/page.sh 4 7 "$2" "$tmp/port" >"$tmp/page.sh"
row "commands of the page" "$(grep -c "$(realpath "$2")" "$tmp/page.sh")" ">=" 8
eeprom=$tmp/page jobs=99
on_chip "$3/chip" "$1" bash -c "cd $tmp && bash -e page.sh"
row "all of them end well"              "$code" = 0
row "a line of 20 mm, steps told"       "$(told "$tmp/out")" = "1600 0 80"
row "the same at the pins"              "$(value position)" = "1600 0 80"
sum
