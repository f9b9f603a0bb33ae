#!/bin/sh
# tests/house/readme.sh -- cut the example and its output out of README.md, and compare
# SPDX-License-Identifier: MIT
# usage: tests/house/readme.sh LIBRARY.a DIR
set -eu
library=$1 dir=$2
mkdir -p "$dir"
awk '/^```c$/ { on = 1; next } /^```$/ { if (on) exit } on' README.md > "$dir/example.c"
awk '/^```c$/ { seen = 1 } seen && /^```text$/ { on = 1; next } /^```$/ { if (on) exit } on' \
    README.md > "$dir/expected.txt"
lines=$(wc -l < "$dir/example.c")
if sh tests/house/example.sh "the README's example ($lines lines)" \
       "$dir/example.c" "$dir/expected.txt" "$dir" "$library"
then echo "1 passed, 0 failed"
else echo "0 passed, 1 failed"; exit 1
fi
