#!/bin/bash
# tests/house/beside.sh -- run commands in parallel, as many as there are cores
# SPDX-License-Identifier: MIT
# usage: [BESIDE=N] tests/house/beside.sh <COMMANDS ; one to a line, N at once
# The output of each is printed whole, in the order of the commands. The exit code is 1 if one of
# theirs is not 0. Not for commands that measure time.
set -u
cores=${BESIDE:-$(nproc)} count=0 shown=0 bad=0
said=$(mktemp -d); trap 'rm -rf "$said"' EXIT

show() {        # those that have ended, up to the first that has not
    while [ -e "$said/$shown.code" ]; do
        cat "$said/$shown"
        [ "$(cat "$said/$shown.code")" = 0 ] || {
            bad=1; echo "FAIL code $(cat "$said/$shown.code") of: $(cat "$said/$shown.run")"
        }
        rm "$said/$shown" "$said/$shown.run" "$said/$shown.code"
        shown=$((shown + 1))
    done
}

while read -r command || [ -n "$command" ]; do
    while [ "$(jobs -rp | wc -l)" -ge "$cores" ]; do wait -n; show; done
    printf '%s\n' "$command" >"$said/$count.run"
    {   bash -c "$command" >"$said/$count" 2>&1 </dev/null
        echo $? >"$said/$count.new"
        mv "$said/$count.new" "$said/$count.code"
    } &
    count=$((count + 1))
done
wait
show
[ "$shown" = "$count" ] || { echo "FAIL $((count - shown)) commands did not end"; bad=1; }
exit $bad
