# tests/packages/row.sh -- what the rows of `make check-packages` share; sourced
# SPDX-License-Identifier: MIT
# usage: row=NAME; . tests/packages/row.sh; verdict "what was built and run" COMMAND..; ended
set -u
. tests/support/appears.sh
top=$(pwd) work=$(pwd)/build/packages/$row
rm -rf "$work"
mkdir -p "$work"
passed=0 failed=0
verdict() {     # verdict WHAT COMMAND..: is the command true? what it says is shown if not
    what=$1 began=$SECONDS; shift
    if "$@" >"$work/log" 2>&1; then echo "ok   $row: $what$(took)"; passed=$((passed + 1))
    else
        echo "FAIL $row: $what$(took)"; failed=$((failed + 1))
        tail -15 "$work/log" | sed 's/^/     /'
    fi
}
took() {        # the time of a slow one
    [ $((SECONDS - began)) -lt 10 ] || echo ", in $((SECONDS - began)) s"
}
needs() {       # needs TOOL..: is each there?
    for tool in "$@"; do
        command -v "$tool" >/dev/null || verdict "$tool is missing: make deps-packages" false
    done
}
ended() {
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}
macro() { echo "LOFT_$(echo "$1" | tr a-z A-Z)"; }
version() { sed -n 's/^#define LOFT_VERSION_[MP][A-Z]* //p' lib/loft.h | paste -sd.; }
