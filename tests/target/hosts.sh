#!/bin/bash
# tests/target/hosts.sh -- run the tests as programs of another processor: a row for each test
# SPDX-License-Identifier: MIT
# usage: tests/target/hosts.sh FOLDER.. ; each is named PROCESSOR-NUM and has the program `tests`
# that hosts.mk made
set -u
result=$(mktemp); trap 'rm -f "$result"' EXIT

one() {         # one FOLDER EMULATOR TEST: a row, and below it what failed
    local said code
    said=$(timeout 600 "$2" "$1/tests" "$3" 2>&1); code=$?
    if [ $code = 0 ]; then
        echo "ok   ${1##*/} $3: $(tail -1 <<<"$said")"
    else
        echo "FAIL ${1##*/} $3: code $code"; grep -v '^ok' <<<"$said" | head -8 | sed 's/^/     /'
    fi
}
if [ "$1" = one ]; then shift; one "$@"; exit; fi

for folder in "$@"; do
    case ${folder##*/} in powerpc-*) emulator=qemu-ppc ;; i686-*) emulator=qemu-i386 ;; esac
    command -v $emulator >/dev/null || {
        echo "FAIL $emulator is missing: make deps-target"; echo "0 passed, 1 failed"; exit 1
    }
    # a kernel of 64 bits runs them as they are, if it has not been built without 32
    case ${folder##*/} in i686-*) ! "$folder/tests" >/dev/null 2>&1 || emulator=env ;; esac
    for test in $($emulator "$folder/tests"); do
        echo "bash tests/target/hosts.sh one $folder $emulator $test"
    done
done | bash tests/house/beside.sh | tee "$result"

passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ] && [ "$passed" -gt 100 ]
