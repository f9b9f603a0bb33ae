# tests/e2e/grbl.sh -- controllers of grbl's kind
# SPDX-License-Identifier: MIT

# peer NAME OPTIONS..: a controller of grbl's kind behind $tmp/NAME; at its end its path is in
# $tmp/NAME.csv
peer() {
    local name=$1; shift
    python3 tests/e2e/grbl_peer.py "$tmp/$name" "$tmp/$name.csv" "$@" & peer=$!
    children+=("$peer")
    disown "$peer"
    wait_for "$tmp/$name"
}
# drew NAME: all of outline12.csv within the tolerance, and the buffer never overflowed
drew() {
    kill "$peer"; gone "$peer"
    "$loft" flatten tests/drawings/outline12.csv --tol 0.0005 | tr ',' ' ' >"$tmp/true"
    grep -v '#' "$tmp/$1.csv" | awk -F, '$3 == 0 { print $1, $2 }' >"$tmp/was"
    python3 - "$tmp/true" "$tmp/was" 0.004 <<'PY' || job_fails "the path is not that of the drawing"
import sys
a, b = ([tuple(map(float, l.split()[:2])) for l in open(f) if l.strip()] for f in sys.argv[1:3])
def far(p, line):
    best = 1e9
    for (x, y), (u, v) in zip(line, line[1:]):
        q = (u - x) ** 2 + (v - y) ** 2
        t = 0 if q == 0 else min(1, max(0, ((p[0] - x) * (u - x) + (p[1] - y) * (v - y)) / q))
        best = min(best, (p[0] - x - t * (u - x)) ** 2 + (p[1] - y - t * (v - y)) ** 2)
    return best ** 0.5
worst = max(max(far(p, b) for p in a[::7]), max(far(p, a) for p in b[::7]))
if len(a) < 100 or len(b) < 100 or worst > float(sys.argv[3]):
    sys.exit(f"{len(a)} {len(b)} points, {worst:.5f} mm apart")
PY
    grep -q 'overflow 0 ' "$tmp/$1.csv" || job_fails "$(tail -1 "$tmp/$1.csv")"
}
case_grbl_draws_arcs() {
    peer arcs
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/arcs"
    says out '^drawn: 12 curves, 0.131 m, [0-9]* lines of G-code .*Grbl 1.1h'
    drew arcs
}
case_grbl_draws_cubics_and_work_coordinates() {
    peer g5 --g5 --mpos
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --g5 --feed 50 --port "$tmp/g5"
    says out '^drawn: 12 curves, 0.131 m, 1[0-9] lines'
    drew g5
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --g5 --dry-run
    [ "$(grep -c '^G5' "$tmp/out")" = 12 ] || job_fails "$(head -3 "$tmp/out")"
}
case_grbl_on_the_whole_terminal_and_in_json() {
    peer shown --held 30
    local job=("$loft" stream tests/drawings/outline12.csv --grbl --feed 1 --port "$tmp/shown")
    types shown '@pen down@h ~held~s ~%, held  X ~^L _r' "${job[@]}" --view \
        || job_fails "exit code $?"
    seen 'h hold  r resume  a abort'; seen 'pen down'; seen '#'; seen '....'; seen '@'
    seen 'sent ahead, override 100 %, held  X '; says after 'drawn: 12 curves, 0.131 m'
    drew shown
    peer told --paced
    job[7]=$tmp/told
    run 0 "${job[@]}" --json
    lines "o[0]['event'] == 'job' and o[0]['curves'] == 12 and o[0]['id'] is None"
    lines "o[-1] == {'event': 'end', 'code': 0} and states[-1]['items'] == states[-1]['item']"
    lines "[x['part'] for x in states] == sorted(x['part'] for x in states) and len(states) > 10"
    lines "{x['pen'] for x in states} >= {'down'} and len({x['at'][0] for x in states}) > 5"
    drew told
    one_line 64 'the G-code of --grbl --dry-run' "${job[@]}" --json --dry-run
    one_line 64 'must be a terminal' "${job[@]}" --view
}
case_grbl_troubles_are_told() {
    refuses() {
        local pattern=$1 code=$2; shift 2
        peer bad "$@"
        one_line "$code" "$pattern" "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 \
            --port "$tmp/bad" ${cubics:-}
        kill "$peer"; gone "$peer"; rm -f "$tmp/bad"
    }
    refuses 'locked after an alarm: home it' 78 --locked
    refuses 'alarm 2 at line [0-9]* of [0-9]*: .*travel' 76 --alarm 20
    refuses 'error 2 at line [0-9]* of [0-9]*, `G.*: a number that cannot be read' 76 --error 20
    refuses 'error Unsupported command.x1b.2J at line [0-9]* of [0-9]*, `G' 76 --error 20 --words
    visible err
    refuses 'the controller restarted at line [0-9]*' 76 --reset 20
    refuses '[0-9]* lines were not answered' 76 --mute 20
    cubics='--wait 1'
    refuses 'answers, but reports its position as MPos without WCO: set $10=0' 78 --nowco
    refuses 'bytes came, but no word of grbl' 76 --babble
    cubics=--g5; refuses 'error 20 at line 2 .*run without --g5' 76
}
case_grbl_answers_late() {     # a boot loader, and a board that is reset after it has answered
    peer late --late 10
    one_line 69 'no answer in 0.5 s: look at its power' "$loft" stream \
        tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/late" --wait 0.5
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/late" --wait 8
    says out '^drawn: 12 curves.*Grbl 1.1h'
    drew late
    peer twice --twice
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/twice"
    drew twice
}
case_grbl_says_what_it_is() {           # $$: its table, its unit, a file for --machine
    printf '0 0 10 0 20 0 30 0\n' | tr ' ' ',' >"$tmp/long.csv"
    for corner in '' --corner; do       # the work zero is 10 mm from the low end
        peer "in$corner" --table 41 $corner
        run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/in$corner"
        kill "$peer"; gone "$peer"
        peer "past$corner" --table 39 $corner
        one_line 65 'x 0..30, .*the table is x -10..29, y -10..29.*: moved by -1,0' \
            "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/past$corner"
        kill "$peer"; gone "$peer"
    done
    peer own --table 39
    printf 'x.travel = 50\n' >"$tmp/own.txt"
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/own" --machine "$tmp/own.txt"
    run 0 "$loft" settings --grbl --port "$tmp/own" --save "$tmp/grbl.txt"
    says out '^saved: '
    kill "$peer"; gone "$peer"
    for line in 'x.steps_per_mm = 250' 'z.max_speed = 5' 'x.max_accel = 80' 'x.travel = 39' \
        'x.min = '; do
        grep -q "^$line" "$tmp/grbl.txt" || job_fails "no $line: $(cat "$tmp/grbl.txt")"
    done
    one_line 65 'table is x -10..29' "$loft" plan "$tmp/long.csv" --machine "$tmp/grbl.txt"
    run 0 "$loft" plan "$tmp/long.csv" --total --at -9,0 --machine "$tmp/grbl.txt"
    peer inches --table 100 --inches --mpos
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/inches"
    run 0 "$loft" stream "$tmp/long.csv" --grbl --port "$tmp/inches"    # from 30 mm, not 1.18
    kill "$peer"; gone "$peer"
    awk -F, '!/#/ { if ($1 == 0 && was > 0 && was != 30) exit 1; was = $1 }' "$tmp/inches.csv" \
        || job_fails "inches were taken for mm: $(head -5 "$tmp/inches.csv")"
}
case_grbl_says_what_a_terminal_would_obey() {
    peer odd --coloured
    run 0 "$loft" stream tests/drawings/outline12.csv --grbl --feed 50 --port "$tmp/odd"
    visible out; says out '^drawn: .*Grbl 1.1h.x1b.0;owned'
    run 0 "$loft" settings --grbl --port "$tmp/odd"; visible out; visible err
    kill "$peer"; gone "$peer"
}
