#!/bin/sh
# tests/house/corpus.sh -- feed the files of an archive to a program of tests/support/fuzz_main.c
# SPDX-License-Identifier: MIT
# usage: tests/house/corpus.sh PROGRAM ARCHIVE.tar.gz
set -u
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
mkdir "$folder/in"
tar -xzf "$2" -C "$folder/in" || exit 1
find "$folder/in" -type f | sort | xargs "$1" >"$folder/said" 2>"$folder/wrong" &&
    tail -n 1 "$folder/said" && exit 0
file=$(tail -n 1 "$folder/said")
cat "$folder/wrong"
echo "FAIL $1: ${file##*/} of $2: unpack it, and give it to the program"
echo "0 passed, 1 failed"
exit 1
