#!/bin/bash
# tests/house/check.sh -- run the stages of `make check`, sum their `N passed, N failed` lines
# SPDX-License-Identifier: MIT
# usage: tests/house/check.sh STAGE.. ; a stage is a make target, or several with a + between:
# those run in parallel, and the output of each is printed whole when it has ended.
# What a stage leaves to `make check-all` is said again at the end. The last line is the sum, alone
# on a line.
set -u
passed=0 failed=0 start=$(date +%s)
log=$(mktemp) left=$(mktemp); trap 'rm -f "$log" "$left"' EXIT

for stage in "$@"; do
    targets=(${stage//+/ }) sync=()
    [ ${#targets[@]} = 1 ] || sync=(-k -Otarget)
    stage=${targets[*]}
    echo "== $stage"
    begun=$(date +%s)
    ${MAKE:-make} -s --no-print-directory -j"$(nproc)" ${sync[@]+"${sync[@]}"} \
        "${targets[@]}" 2>&1 | tee "$log"
    code=${PIPESTATUS[0]}
    grep '^left to make check-all: ' "$log" >>"$left"
    read -r p f sums < <(awk '
        /^[0-9]+ passed, [0-9]+ failed$/ { p += $1; f += $3; n++ }
        END { print p + 0, f + 0, n + 0 }' "$log")
    if [ "$code" != 0 ] && [ "$f" = 0 ]; then
        echo "FAIL stage $stage ended with code $code"; f=1
    elif [ "$p" = 0 ] && [ "$f" = 0 ] || [ "$sums" -lt ${#targets[@]} ]; then
        echo "FAIL stage $stage: not all of it ran a test"; f=$((f + 1))
    fi
    passed=$((passed + p)) failed=$((failed + f))
    echo "-- $stage: $p passed, $f failed in $(($(date +%s) - begun)) s"
done

cat "$left"
echo "all stages in $(($(date +%s) - start)) s"
echo "$passed passed, $failed failed"
[ $failed = 0 ]
