#!/bin/sh
# tests/house/example.sh -- compile one example without a warning, run it, compare its output
# SPDX-License-Identifier: MIT
# usage: tests/house/example.sh NAME SOURCE.c EXPECTED.txt DIR LIBRARY.a [FLAG or LIBRARY.a ..]
# Prints one line, `ok` or `FAIL`, after the output of the compiler or of diff.
set -u
name=$1 source=$2 expected=$3 dir=$4 library=$5; shift 5
program=$dir/$(basename "$source" .c)
mkdir -p "$dir"
given="${CPPFLAGS:-} ${CFLAGS:-} ${LDFLAGS:-}"
if ${CC:-cc} -Ilib $given -std=c99 -Wall -Wextra -Wpedantic -Werror \
       "$source" "$library" "$@" -o "$program" &&
   [ -s "$expected" ] && "$program" > "$program.printed" && diff "$expected" "$program.printed"
then echo "ok   $name compiles and prints what it says"
else echo "FAIL $name does not compile, or prints something else than it says"; exit 1
fi
