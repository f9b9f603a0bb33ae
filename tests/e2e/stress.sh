#!/bin/bash
# tests/e2e/stress.sh -- runs a case of e2e.sh many times side by side, beside a load
# SPDX-License-Identifier: MIT
# usage: tests/e2e/stress.sh RUNS LOFT PLAIN HELPERS CASE.. ; the load is LOAD loops that compute,
# 20 without it, and with PAUSE=SECONDS each process stands for up to so long now and then
# (pauses.py). The last line is the sum.
set -u
runs=$1 name="${*:5}"; shift
[ -n "$name" ] || { echo "stress: give CASE=one of tests/e2e/*.sh"; exit 64; }
load=()
for _ in $(seq "${LOAD:-20}"); do
    while :; do :; done & load+=($!)
done
[ -z "${PAUSE-}" ] || { python3 "${0%/*}/pauses.py" "${SEED:-1}" "$PAUSE" & load+=($!); }
trap '[ ${#load[@]} = 0 ] || kill "${load[@]}" 2>/dev/null' EXIT
results=$(for _ in $(seq "$runs"); do echo "bash ${0%/*}/e2e.sh $*"; done |
    BESIDE=8 bash "${0%/*}/../house/beside.sh" | grep -E '^(ok|FAIL)')
grep '^FAIL' <<<"$results"
passed=$(grep -c '^ok' <<<"$results") failed=$(grep -c '^FAIL' <<<"$results")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ] && [ "$passed" -gt 0 ]
