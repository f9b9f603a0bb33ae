#!/bin/bash
# host-tools/demo.sh -- runs the main job on the simulated machine: from a drawing, through a pty,
# to counted pulses and a picture
# SPDX-License-Identifier: MIT
# usage: host-tools/demo.sh LOFT DRAWING DIRECTORY [MACHINE-FILE]
set -eu
loft=$1 drawing=$2 out=$3
is=(--steps 320 --slots 80) as=()
[ $# -lt 4 ] || { is=(--machine "$4"); as=(--machine "$4"); }
mkdir -p "$out"
rm -f "$out/machine" "$out/pulses.csv" "$out/drawn.png"

machine=
clean_up() { [ -z "$machine" ] || kill "$machine" 2>/dev/null || true; rm -f "$out/machine"; }
trap clean_up EXIT
trap 'exit 130' INT TERM

"$loft" simulate --speed fast "${is[@]}" --link "$out/machine" --record "$out/pulses.csv" --once \
    >"$out/machine.log" 2>&1 &
machine=$!
for _ in $(seq 100); do
    [ -e "$out/machine" ] && break
    kill -0 "$machine" 2>/dev/null || { cat "$out/machine.log" >&2; exit 70; }
    sleep 0.05
done

"$loft" stream "$drawing" ${as[@]+"${as[@]}"} --port "$out/machine" --record "$out/pulses.csv"
wait "$machine" || { code=$?; machine=; cat "$out/machine.log" >&2; exit $code; }
machine=
"$loft" plot "$drawing" --record "$out/pulses.csv" --error 0 --output "$out/drawn.png"
echo "picture: $out/drawn.png"
