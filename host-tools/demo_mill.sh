#!/bin/bash
# host-tools/demo_mill.sh -- mills surfaces on the simulated machine: path, pulses, and a picture of
# what is left
# SPDX-License-Identifier: MIT
# usage: host-tools/demo_mill.sh LOFT SURFACES DIRECTORY TOOL CUSP
set -eu
loft=$1 surfaces=$2 out=$3 tool=$4 cusp=$5
mkdir -p "$out"
rm -f "$out/machine" "$out/pulses.csv" "$out/left.png"

machine=
clean_up() { [ -z "$machine" ] || kill "$machine" 2>/dev/null || true; rm -f "$out/machine"; }
trap clean_up EXIT
trap 'exit 130' INT TERM

"$loft" mill "$surfaces" --tool "$tool" --cusp "$cusp" >"$out/path.loft"
grep '^#' "$out/path.loft"
"$loft" simulate --speed fast --steps 320 --slots 80 --link "$out/machine" \
    --record "$out/pulses.csv" --once >"$out/machine.log" 2>&1 &
machine=$!
for _ in $(seq 100); do
    [ -e "$out/machine" ] && break
    kill -0 "$machine" 2>/dev/null || { cat "$out/machine.log" >&2; exit 70; }
    sleep 0.05
done
"$loft" stream "$out/path.loft" --port "$out/machine"
wait "$machine" || { code=$?; machine=; cat "$out/machine.log" >&2; exit $code; }
machine=
"$loft" mill "$surfaces" --tool "$tool" --record "$out/pulses.csv" -o "$out/left.png"
