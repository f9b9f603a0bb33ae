#!/bin/sh
# tests/readme.sh -- cut the example and its output out of README.md, compile it, run it, compare
# SPDX-License-Identifier: MIT
# usage: tests/readme.sh LIBRARY.a DIR
set -eu
library=$1 dir=$2
mkdir -p "$dir"
awk '/^```c$/ { on = 1; next } /^```$/ { if (on) exit } on' README.md > "$dir/example.c"
awk '/^```c$/ { seen = 1 } seen && /^```text$/ { on = 1; next } /^```$/ { if (on) exit } on' README.md > "$dir/expected.txt"
[ -s "$dir/example.c" ] && [ -s "$dir/expected.txt" ] || { echo "FAIL README.md holds no example"; echo "0 passed, 1 failed"; exit 1; }
lines=$(wc -l < "$dir/example.c")
${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Werror -Ilib "$dir/example.c" "$library" -o "$dir/example"
"$dir/example" > "$dir/printed.txt"
if diff "$dir/expected.txt" "$dir/printed.txt"; then
    echo "ok   the README's example ($lines lines) compiles and prints what the README says"; echo "1 passed, 0 failed"
else
    echo "FAIL the README's example prints something else"; echo "0 passed, 1 failed"; exit 1
fi
