#!/bin/bash
# tests/check.sh -- run the stages of `make check`, each a command; sum their `N passed, N failed` lines
# SPDX-License-Identifier: MIT
# usage: tests/check.sh STAGE.. ; a stage is a make target. The last line is the sum, alone on a line.
set -u
passed=0 failed=0 start=$(date +%s)
log=$(mktemp); trap 'rm -f "$log"' EXIT

for stage in "$@"; do
    echo "== $stage"
    begun=$(date +%s)
    ${MAKE:-make} -s --no-print-directory -j"$(nproc)" "$stage" 2>&1 | tee "$log"
    code=${PIPESTATUS[0]}
    read -r p f < <(awk '/^[0-9]+ passed, [0-9]+ failed$/ { p += $1; f += $3 } END { print p + 0, f + 0 }' "$log")
    if [ "$code" != 0 ] && [ "$f" = 0 ]; then
        echo "FAIL stage $stage ended with code $code"; f=1
    elif [ "$p" = 0 ] && [ "$f" = 0 ]; then
        echo "FAIL stage $stage ran no test"; f=1
    fi
    passed=$((passed + p)) failed=$((failed + f))
    echo "-- $stage: $p passed, $f failed in $(($(date +%s) - begun)) s"
done

echo "all stages in $(($(date +%s) - start)) s"
echo "$passed passed, $failed failed"
[ $failed = 0 ]
