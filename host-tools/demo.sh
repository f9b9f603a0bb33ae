#!/bin/bash
# host-tools/demo.sh -- runs a whole job on the simulated machine: from a drawing or from surfaces,
# through a pty, to counted pulses and a picture
# SPDX-License-Identifier: MIT
# usage: host-tools/demo.sh draw LOFT DRAWING DIRECTORY [MACHINE-FILE]
#        host-tools/demo.sh mill LOFT SURFACES DIRECTORY TOOL STEP STOCK
set -eu
what=$1 loft=$2 input=$3 out=$4; shift 4
is=(--steps 320 --slots 80) as=() job=$input tol=0.005
mkdir -p "$out"
rm -f "$out/machine" "$out/pulses.csv" "$out/drawn.png" "$out/left.png"
rm -rf "$out/state"             # a demo that was stopped leaves nothing in doubt
export XDG_STATE_HOME=$(cd "$out" && pwd)/state

machine=
clean_up() { [ -z "$machine" ] || kill "$machine" 2>/dev/null || true; rm -f "$out/machine"; }
trap clean_up EXIT
trap 'exit 130' INT TERM

if [ "$what" = mill ]; then
    tool=$1 step=$2 stock=$3 job=$out/path.loft
    "$loft" mill "$input" --tool "$tool" --step "$step" --stock "$stock" >"$job"
    grep '^#' "$job"
else
    [ $# = 0 ] || { is=(--machine "$1"); as=(--machine "$1")
        tol=$(awk -F= -v tol=$tol '/^tolerance/ { tol = $2 + 0 } END { print tol }' "$1"); }
    as+=(--record "$out/pulses.csv")
fi

"$loft" simulate --speed fast "${is[@]}" --link "$out/machine" --record "$out/pulses.csv" --once \
    >"$out/machine.log" 2>&1 &
machine=$!
for _ in $(seq 100); do
    [ -e "$out/machine" ] && break
    kill -0 "$machine" 2>/dev/null || { cat "$out/machine.log" >&2; exit 70; }
    sleep 0.05
done
"$loft" stream "$job" ${as[@]+"${as[@]}"} --port "$out/machine"
wait "$machine" || { code=$?; machine=; cat "$out/machine.log" >&2; exit $code; }
machine=

if [ "$what" = mill ]; then
    "$loft" mill "$input" --tool "$tool" --stock "$stock" --record "$out/pulses.csv" \
        -o "$out/left.png"
else
    "$loft" plot "$input" --record "$out/pulses.csv" --error 0 --tol "$tol" \
        --output "$out/drawn.png"
    echo "picture: $out/drawn.png"
fi
