# tests/e2e/bad_input.sh -- input, options and files that cannot be
# SPDX-License-Identifier: MIT

case_bad_drawings() {
    printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 0' >"$tmp/broken.svg"
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm"></svg>' \
        >"$tmp/empty.svg"
    printf 'this is no drawing\n' >"$tmp/text.txt"
    printf '(made by x)\n%%\nG21 G90\nG1 X1 Y2 F100\nG1 X\n' >"$tmp/job.nc"
    one_line 65 'job.nc:5: a number is missing' "$loft" stream "$tmp/job.nc" --dry-run
    one_line 64 '--dialect x: give linuxcnc, grbl' "$loft" plan "$tmp/job.nc" --dialect x
    head -c 4096 /dev/urandom >"$tmp/random.bin"
    : >"$tmp/nothing"
    one_line 66 'no such file' "$loft" stream "$tmp/absent.svg" --dry-run
    for bad in broken.svg empty.svg text.txt random.bin nothing; do
        one_line 65 "$bad" "$loft" stream "$tmp/$bad" --dry-run
    done
    printf '0,0,1e9,0,1,1,2,2\n' >"$tmp/far.csv"
    one_line 65 'far.csv' "$loft" stream "$tmp/far.csv" --dry-run
    printf '\n0,0,9000,0,1,1,2,2\n' >"$tmp/wide.csv"
    one_line 65 'wide.csv:2: a point at 9000,0 mm' "$loft" stream "$tmp/wide.csv" --dry-run
    printf '0,0 1,1\n0,zero\n'   >"$tmp/word.txt"
    one_line 65 'word.txt:1' "$loft" eval "$tmp/word.txt"
}
case_options_of_other_files_are_refused() {
    local o
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm">%s</svg>' \
        '<path stroke="red" d="M0,0L5,5"/>' >"$tmp/a.svg"
    printf 'G1 X5 F100\n' >"$tmp/a.nc"
    printf 'bezier\n0 0\n1 1\n' >"$tmp/a.loft"
    for o in '--from-line 3' '--dialect grbl'; do
        for f in a.svg a.loft small.csv; do
            one_line 64 "$f: ${o%% *}.*only G-code has" "$loft" plan "$tmp/$f" $o
        done
    done
    for o in '--layer 1' '--only red' '--text none'; do
        for f in a.nc a.loft small.csv; do
            one_line 64 "$f: $o: only SVG has" "$loft" stream --dry-run "$tmp/$f" $o
        done
    done
}
# every exit code that the program can give is in the table of host-tools/README.md
case_exit_codes_are_documented() {
    local code name number
    grep -hoE '\bEX_[A-Z]+' host-tools/*.c host-tools/*/*.[ch] | sort -u | while read -r name; do
        number=$(printf '#include <sysexits.h>\n%s\n' "$name" | cc -E -P - | tail -1)
        [ "$number" = 0 ] || echo "$number"
    done >"$tmp/given"
    sed -n '/^| code |/,/^$/s/^| \([0-9, ]*\) |.*/\1/p' host-tools/README.md | tr -d ' ' |
        tr ',' '\n' >"$tmp/told"
    run 0 "$loft" stream --help=man
    [ "$(wc -l <"$tmp/given")" -gt 9 ] || job_fails "the codes were not found"
    for code in $(cat "$tmp/given"); do
        grep -qx "$code" "$tmp/told" || job_fails "exit code $code is in no table"
        grep -qE "(^|[ ,])$code [a-z]" "$tmp/out" || job_fails "exit code $code is not in man"
    done
}
case_what_was_meant_is_told() {
    one_line 64 'unknown command strem: did you mean stream?' "$loft" strem
    one_line 64 'unknown command draw: did you mean stream?' "$loft" draw
    one_line 64 'small.csv: is a file, and no command: `loft plot' "$loft" "$tmp/small.csv"
    one_line 64 'did you mean --centre?' "$loft" plot "$tmp/small.csv" --center
    one_line 64 'did you mean --dry-run?' "$loft" stream "$tmp/small.csv" --dryrun
    printf 'x.max_sped = 3\n' >"$tmp/m.txt"
    one_line 65 'm.txt:1: unknown key "x.max_sped": did you mean max_speed' \
        "$loft" plan "$tmp/small.csv" --machine "$tmp/m.txt"
    echo '<svg xmlns="http://www.w3.org/2000/svg"/>' >"$tmp/m.svg"
    one_line 65 'm.svg: is a drawing or a page: --machine takes lines' \
        "$loft" plan "$tmp/small.csv" --machine "$tmp/m.svg"
    one_line 69 'a socket is written tcp:127.0.0.1:1$' \
        "$loft" stream "$tmp/small.csv" --port 127.0.0.1:1
    one_line 69 'COM3: no such port: here they are called /dev/tty' \
        "$loft" stream "$tmp/small.csv" --port COM3
    printf 'G04 a board*\n%%FSLAX46Y46*%%\nG01*\n' >"$tmp/a.gbr"
    one_line 65 'is Gerber: convert it' "$loft" plan "$tmp/a.gbr"
    printf '; holes\nM48\nMETRIC\nT1C0.8\n%%\n' >"$tmp/a.drl"
    one_line 65 'is Excellon, holes of a board: convert it' "$loft" plan "$tmp/a.drl"
    printf 'solid x\nfacet normal 0 0 1\n' >"$tmp/a.stl"
    one_line 65 'is STL, a solid: ' "$loft" plan "$tmp/a.stl"
    printf '0,0\n10,10\n' >"$tmp/xy.csv"
    one_line 65 'xy.csv:1: 2 numbers: .*by a line `line` before them' "$loft" plan "$tmp/xy.csv"
    { echo line; cat "$tmp/xy.csv"; } >"$tmp/xy.loft"; run 0 "$loft" plan "$tmp/xy.loft" --total
    printf 'M48\nG1 X5 F100\nM2\n' >"$tmp/a.nc"; run 0 "$loft" plan "$tmp/a.nc" --total
}
case_links_are_not_written_through() {
    printf 'precious\n' >"$tmp/kept"
    for name in link link.svg link.h; do ln -s kept "$tmp/$name"; done
    one_line 73 'is a symbolic link' "$loft" plan "$tmp/small.csv" --spans -o "$tmp/link"
    one_line 73 'is a symbolic link' "$loft" plot "$tmp/small.csv" -o "$tmp/link.svg"
    one_line 73 'is a symbolic link' "$loft" export "$tmp/small.csv" -o "$tmp/link.h"
    one_line 73 'is a symbolic link' "$loft" stream "$tmp/small.csv" --port "$tmp/none" \
        --log "$tmp/link"
    run 73 "$loft" simulate --record "$tmp/link" --link "$tmp/l"
    run 73 "$loft" simulate --keep "$tmp/link" --link "$tmp/l"
    run 0 "$loft" plan "$tmp/small.csv" --spans -o /dev/stdout; [ -s "$tmp/out" ] || job_fails empty
    [ "$(cat "$tmp/kept")" = precious ] || job_fails "written through a link"
}
case_words_of_others_are_made_visible() {
    local odd=$'\e[31mred\u9b\u202e\n.nc'
    one_line 66 '\\x1b.31mred\\u009b\\u202e\\x0a.nc: no such file' "$loft" plan "$tmp/$odd"
    visible err
    printf 'G1 X5 F600\n(MSG, \033]0;owned\007\302\233 turn)\nM0\nG1 X0\n' >"$tmp/$odd"
    run 0 "$loft" stream "$tmp/$odd" --check; visible out; visible err
    machine m
    "$loft" stream "$tmp/$odd" --port "$tmp/m" >"$tmp/paused" 2>&1 </dev/null & local sender=$!
    until_file paused '^pause: '
    kill -INT $sender; wait $sender
    says paused 'x1b.0;owned'; visible paused
    printf '1 2 x\033[2J\n' >"$tmp/odd.csv"
    one_line 65 'odd.csv:1' "$loft" plan "$tmp/odd.csv"; visible err
    one_line 64 'x1b' "$loft" plan $'--\e[1m'; visible err
    one_line 64 'x1b' "$loft" $'\e[1m'; visible err
}
# a terminal hears of a long silence within seconds; what cannot be asked is told before it
case_a_long_silence_is_told() {
    mkfifo "$tmp/silent.loft"           # a pipe that nobody writes
    exec 7<>"$tmp/silent.loft"
    timeout 1000 python3 - "$loft" measure "$tmp/silent.loft" >"$tmp/out" <<'PY'
import os, pty, signal, sys
pid, fd = pty.fork()
if pid == 0:
    os.execv(sys.argv[1], sys.argv[1:])
got = b''
while b'ends it' not in got:
    got += os.read(fd, 1000)
os.kill(pid, signal.SIGKILL)
print(got.decode())
PY
    exec 7>&-
    says out '^working: measure: 1 s by now; ^C ends it'
    { echo 'octant 91.0741'; echo '0.187034 0.333294 6.99643'; echo 'bicubic'; for i in 1 2 3 4; do
          for k in 1 2 3 4; do echo "$i 9$k $k"; done; done; } |
        sed '$s/.*/132.659 2147483648 143.245/' >"$tmp/both.loft"
    one_line 65 'area: the numbers do not fit' \
        sh -c 'ulimit -t 10; exec "$@"' - "$loft" measure "$tmp/both.loft"
    printf 'bezier\n0 0\n1 1\n2 0\n3 1\n4 0\n5 1\n6 0\n7 1\n8 0\n9 1\n10 0\n1e38 2\n' \
        >"$tmp/two.loft"
    one_line 65 'two.loft:1: .* mm is beyond' "$loft" plan "$tmp/two.loft"
}
# what the library refuses is told as what it is there, never as another cause
case_a_refused_argument_is_told_by_its_place() {
    one_line 65 'copositive: these numbers do not suit: give a symmetric matrix' \
        "$loft" decide copositive --of=1,2
    one_line 65 'smooth: these numbers do not suit: give 2 to 10 samples, how many times' \
        "$loft" decide smooth --of=1,2,0,0.5
    one_line 65 'the numbers do not fit: .*take --num f64' "$loft" decide smooth --of=40000,2,1,0.5
    run 0 "$loft" decide smooth --of=40000,2,1,0.5 --num f64; says out '^value 20001$'
    printf 'G0 X1\nG2 X2 Y0.5 I0.5 J-0.5 F9\n' >"$tmp/arc.nc"
    one_line 65 'arc.nc:2: an arc that starts 0.7.* and ends 1.1.* from its centre' \
        "$loft" plan "$tmp/arc.nc"
}
# warned PATTERN COMMAND..: a warning, which --strict makes an error; without it the job is done
warned() {
    local pattern=$1; shift
    run 0 "$@"
    says err "$pattern"; cp "$tmp/err" "$tmp/warnings"
    one_line 65 "$pattern.*--strict" "$@" --strict
    [ ! -s "$tmp/out" ] || job_fails "$* --strict prints: $(head -c 200 "$tmp/out")"
    grep -qF "$(sed 's/ (an error by --strict)//' "$tmp/err")" "$tmp/warnings" \
        || job_fails "another line than the first warning"
}
# a drawing for each warning of the reader of SVG (enum svg_warning): the tail of its name, what the
# line says, what is within <svg>
svg_warnings() {
    sed -e :a -e '/\\$/N; s/\\\n *//; ta' <<'TABLE'
SELECTOR|selector "path:has(a)|<style>path:has(a) { display: none }</style>
DATA|path data ends after|<path d="M0 0L5" stroke="red"/>
TEXT|<flowRoot> is not drawn|<flowRoot/>
LETTER|is in no font|<text x="5" y="9">a&#x10FFFD;</text>
LAYER|as AxiDraw does|<g i:groupmode="layer" i:label="% notes"><path d="M0 0h5" stroke="red"/></g>
LAYER_NUMBERS|no speed, height|\
    <g i:groupmode="layer" i:label="1 +S50"><path d="M0 0h5" stroke="red"/></g>
LINE|letters without single lines|<text x="5" y="9">&#x3a9;</text>
UPRIGHT|is read as horizontal|<text x="5" y="9" writing-mode="vertical-rl">a</text>
TEXT_STYLE|font-variation-settings: "wght" 700 is not applied|\
    <text x="5" y="9" style='font-variation-settings: "wght" 700'>a</text>
GEOMETRY|x, width, r or d of a shape is not used|\
    <rect width="5" height="5" style="x: 3px"/>
MOTION|rotate, scale, translate or offset-path|<rect width="5" height="5" style="rotate: 45deg"/>
PICTURE|<image> is not drawn|<image width="5" height="5" href="a.png"/>
CLIP_PATH|clip-path: circle(2)|<path d="M0 0h5" stroke="red" clip-path="circle(2)"/>
MASK|not of white shapes|\
    <mask id="m"><path d="M0 0h9v9z" fill="#777"/></mask>\
    <path d="M0 0h5v5" stroke="red" mask="url(#m)"/>
PATTERN|tiles is left out|\
    <pattern id="p" width=".01" height=".01" patternUnits="userSpaceOnUse">\
    <path d="M0 0h1" stroke="red"/></pattern><path d="M0 0h40v40h-40z" fill="url(#p)"/>
DASHES|more than [0-9]* dashes|<path d="M0 0h40" stroke="red" stroke-dasharray=".0001"/>
BOX|transform-box: fill-box|\
    <path d="M0 0h5" stroke="red" style="transform-box: fill-box; transform: rotate(9deg)"/>
UNSEEN|without fill and stroke|<path d="M0 0h5" fill="none"/>
USE_NOTHING|<use> without href|<use/>
USE_ELSEWHERE|is not in this file|<use href="b.svg#a"/>
USE_MISSING|no element has this id|<use href="#a"/>
USE_CYCLE|it uses itself|<use id="a" href="#a"/>
LENGTH|width="5zz" is not used|<rect width="5zz" height="5"/>
SIZE|whose size is not known|<rect width="50%" height="5"/>
TRANSFORM|"turn(3)" is not one of|<path d="M0 0h5" stroke="red" transform="turn(3)"/>
VIEW|viewBox="0 0 1" is not used|<svg viewBox="0 0 1"/>
FAR|is beyond +-16000 mm|<path d="M0 0h1e9" stroke="red"/>
MEDIA|"@import" is not used|<style>@import "a.css";</style>
FILTER|filter: url(#f) is not applied|<path d="M0 0h5" stroke="red" filter="url(#f)"/>
BLEND|mix-blend-mode: screen is|<path d="M0 0h5" stroke="red" style="mix-blend-mode:screen"/>
PAGE|is a white page and not drawn|<rect width="50" height="50" fill="white"/>
BACKGROUND|#eef is paper and not drawn|
TABLE
}
case_strict_svg_warning_by_warning() {
    local kind pattern inside text page
    while IFS='|' read -r kind pattern inside; do
        page='width="50mm" height="50mm" viewBox="0 0 50 50"'
        [ $kind != SIZE ] || page=
        [ $kind != BACKGROUND ] || page="$page style=\"background: #eef\""
        printf '<svg xmlns="http://www.w3.org/2000/svg" %s %s>\n%s\n%s</svg>\n' "$page" \
            'xmlns:i="http://www.inkscape.org/namespaces/inkscape"' \
            '<path d="M1 1h3" stroke="red"/>' "$inside" >"$tmp/$kind.svg"
        [ $kind = LINE ] && text=line || text=outline
        warned "$kind.svg:[0-9]*: .*$pattern" "$loft" plan "$tmp/$kind.svg" --total --text $text
    done < <(svg_warnings)
    # each has a line above
    diff <(svg_warnings | cut -d'|' -f1 | sort) \
         <(sed -n 's/^    SVG_WARN_\([A-Z_]*\),\?$/\1/p' host-tools/svg/svg.h | sort) \
        || job_fails "warnings without a line, or lines without a warning"
}
# a program for each word that G-code leaves out
case_strict_gcode_warning_by_warning() {
    local pattern lines dialect
    while IFS='|' read -r pattern dialect lines; do
        printf 'G21 G90 F600\nG1 X5\n%b\nG1 Y5\n' "$lines" >"$tmp/left.nc"
        warned "left.nc:\?[0-9]*: $pattern" "$loft" plan "$tmp/left.nc" --total --dialect $dialect
    done <<'TABLE'
M48: has no meaning|linuxcnc|M48
$: commands of a controller|grbl|$H
M107: has no meaning|marlin|M107
E: there is no extruder|marlin|G1 X9 E2
G61 in a part of it|linuxcnc|G61\nG1 X9\nG64
TABLE
}
# what is not in a reader
case_strict_elsewhere() {
    printf 'G21 G90 F600\nG1 X5\nG1 Y5\n' >"$tmp/plain.nc"
    printf '0,0 1,1 2,2 9,9\n' >"$tmp/one.csv"
    warned 'it has no layers of Inkscape' "$loft" plan "$tmp/one.csv" --total --order layer
    printf 'x.reversed = yes\nx.travel = 90\nkinematics = corexy\ntolerance = 0.01\n' \
        >"$tmp/plan.txt"
    machine strict --speed fast
    warned 'and what else is of firmware or plan, is not kept' \
        "$loft" set --machine "$tmp/plan.txt" --port "$tmp/strict"
}
case_strict_makes_warnings_errors() {
    cat >"$tmp/image.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
  <path d="M5 5h9" stroke="red"/><image width="5" height="5" href="a.png"/></svg>
SVG
    printf 'G21 G90 F600\nG1 X5\nM48\nG1 Y5\n' >"$tmp/left.nc"
    printf 'G21 G90 F600\nG1 X5\nG4 P1\nG1 Y5\n' >"$tmp/wait.nc"
    printf 'tool.red.colours = blue\n' >"$tmp/pens.txt"
    for command in "stream --dry-run" "plan --total" "measure" "plot -o $tmp/plot.svg" \
            "export -o $tmp/image.nc"; do
        rm -f "$tmp"/plot.svg "$tmp"/image.nc
        warned 'image.svg:2: ' "$loft" ${command%% *} "$tmp/image.svg" ${command#"${command%% *}"}
        run 65 "$loft" ${command%% *} "$tmp/left.nc" ${command#"${command%% *}"} --strict
        says err 'left.nc:3: M48.*--strict'
    done
    run 65 "$loft" plan "$tmp/wait.nc" --strict; says err 'wait.nc:3: .*times.*--strict'
    sed -i 's/<image.*//; $a</svg>' "$tmp/image.svg"
    warned '1 curve belongs to no tool' "$loft" plan "$tmp/image.svg" --total \
        --machine "$tmp/pens.txt"
    # these have no warnings: what is off is an error in any case
    echo 1,2,3 >"$tmp/short.csv"; one_line 65 'short.csv:1' "$loft" plan "$tmp/short.csv" --strict
    echo 'bend 0 0' >"$tmp/odd.loft"; one_line 65 'odd.loft:1' "$loft" plan "$tmp/odd.loft" --strict
    echo 'x.tavel = 3' >"$tmp/odd.txt"
    one_line 65 'odd.txt:1' "$loft" plan "$tmp/small.csv" --machine "$tmp/odd.txt" --strict
    run 0 "$loft" plan "$tmp/small.csv" --total --strict; is_empty err
}
case_bad_options() {
    one_line 64 'unknown command draw'     "$loft" draw
    one_line 64 'not an option'  "$loft" stream x --fast
    one_line 64 'needs a value'  "$loft" stream x --port
    one_line 64 'no --port'      "$loft" stream "$tmp/small.csv"
    one_line 64 'no DRAWING'     "$loft" stream --port "$tmp/x"
    one_line 64 'more than one'  "$loft" stream a b --port "$tmp/x"
    one_line 64 'give one of them' "$loft" stream --hold --abort --port "$tmp/x"
    one_line 64 '--feed -3'      "$loft" stream "$tmp/small.csv" --dry-run --feed -3
    one_line 64 'a whole one'    "$loft" sample --n 2.5 --points "0,0 1,1"
    one_line 74 'standard output' sh -c "'$loft' sample --points '0,0 1,1' >/dev/full"
    one_line 64 '--num q31'      "$loft" eval --num q31 --points "0,0 1,1"
    one_line 64 '--speed slow'   "$loft" simulate --speed slow
    one_line 64 'the whole name' "$loft" plan "$tmp/small.csv" --fee 3
    one_line 64 'the whole name' "$loft" plan "$tmp/small.csv" --mach=none
    one_line 64 'give one file'  "$loft" eval "$tmp/small.csv" "$tmp/small.csv"
    one_line 64 'give one of them' "$loft" sample --points '0,0 1,1' "$tmp/small.csv"
    one_line 64 '2 to 32768'     "$loft" simulate --queue 1
    one_line 64 '0 for none'     "$loft" simulate --curves 3
    one_line 74 'standard output' sh -c "'$loft' --version >/dev/full"
    one_line 65 'give 0 to 1 for this tensor' "$loft" eval --uv 5,5 tests/drawings/patch.loft
    ln -s /dev/full "$tmp/full.pdf"; ln -s /dev/full "$tmp/full.png"
    for full in full.pdf full.png; do
        one_line 73 'No space left' "$loft" plot "$tmp/small.csv" -o "$tmp/$full"
    done
    one_line 64 'HOST:PORT'      "$loft" stream "$tmp/small.csv" --port tcp:1234
}
case_pages() {
    run 0 "$loft" stream "$tmp/small.csv" --dry-run --page A4 --fit --margin 10 --rotate auto
    says out '^drawing: 190.000 x 235.731 mm at 10.000,30.634 on a page of 210 x 297 mm$'
    run 0 "$loft" plan "$tmp/small.csv" --total --page 100x60 --at 0,0 --copies 2x1
    says out '^drawing: 115.000 x .*, 15.000 mm beyond it$'; says out '^drawn  *360.541 '
    run 0 "$loft" plot "$tmp/small.csv" --page 40x20 --crop -o "$tmp/cut.svg"; says out ' curves'
    one_line 64 'say which, as --page A4' "$loft" plan "$tmp/small.csv" --fit
    one_line 64 '--page B9' "$loft" stream "$tmp/small.csv" --dry-run --page B9
}
case_text() {
    cat >"$tmp/text.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="40mm" viewBox="0 0 90 40">
<text x="10" y="30" font-size="30">TT</text></svg>
SVG
    run 0 "$loft" stream "$tmp/text.svg" --dry-run --text line
    says out '^drawing: 30.000 x 21.000 mm at 11.000,10.000 '; says out ' 4 curves, 0.070 m drawn'
    run 0 "$loft" export "$tmp/text.svg" --as csv; says out '^[0-9.,]*$'
    one_line 65 'nothing to draw' "$loft" stream "$tmp/text.svg" --dry-run --text none
    one_line 65 'no font "x"' "$loft" stream "$tmp/text.svg" --dry-run --text line:x
}
case_fill() {
    cat >"$tmp/box.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="40mm" viewBox="0 0 90 40">
<rect x="10" y="10" width="20" height="10"/></svg>
SVG
    run 0 "$loft" stream "$tmp/box.svg" --dry-run --fill hatch:0,2 --outline none
    says out ' 5 curves, 0.100 m drawn'
    run 0 "$loft" plan "$tmp/box.svg" --total --fill cross:0,2 --page 25x40 --crop
    says out '^drawn  *195.000 '
    one_line 65 'nothing in it is filled' "$loft" plan "$tmp/small.csv" --fill hatch
    one_line 64 'give hatch:ANGLE,MM' "$loft" plan "$tmp/box.svg" --fill wave
}
# A folder that is not there is told before anything is computed, in one line with the remedy.
case_bad_places_for_files() {
    local none=$tmp/none/x
    awk 'BEGIN { print "bspline 3"; for (i = 0; i < 20000; i++) print i % 170, i * 7 % 190 }' \
        >"$tmp/long.loft"
    printf '0,0\n4,0\n4,3\n2,1\n0,3\n' >"$tmp/polygon.csv"
    echo '# slot_hz = 1' >"$tmp/record.csv"
    for job in "plan $tmp/long.loft --plot $none.png" "plan $tmp/long.loft --spans -o $none.csv" \
        "export $tmp/small.csv -o $none.nc" "plot $tmp/small.csv -o $none.png" \
        "surface tests/drawings/surfaces.loft --tol 0.0001 -o $none.stl" \
        "harmonic $tmp/polygon.csv -o $none.h" "study gb -o $none/y" \
        "mill tests/drawings/patch.loft --record $tmp/record.csv -o $none.png"; do
        one_line 73 'none/x.*: No such file or directory: name a place in a folder that exists' \
            bash -c "ulimit -t 10; exec '$loft' $job"
    done
    one_line 73 'folder' "$loft" figures family -o "$none"
    one_line 73 'name a place in a folder' "$loft" stream "$tmp/small.csv" --port "$tmp/no" \
        --log "$none"
    one_line 73 'name a file that can be written' "$loft" simulate --record "$none" --link "$tmp/l"
    one_line 73 'name a place in a folder that exists' "$loft" simulate --link "$none"
    one_line 73 'name a file that can be written' "$loft" simulate --link "$tmp/l" --keep "$none"
    mkdir "$tmp/folder"
    one_line 73 'Is a directory' "$loft" export "$tmp/small.csv" -o "$tmp/folder" --as nc
    # pieces of other files in the place of a machine file, and of what a machine keeps
    tail -c 400 tests/corpus/svg.tar.gz >"$tmp/settings"
    one_line 65 'settings: is not text' "$loft" plan "$tmp/small.csv" --machine "$tmp/settings"
    machine strange --speed fast --keep "$tmp/settings"
    run 0 "$loft" settings --port "$tmp/strange"; says out 'those of its firmware'
    run 0 "$loft" set x.travel=9 --port "$tmp/strange"
    run 0 "$loft" settings --port "$tmp/strange"; says out '^x.travel = 9$'
    kill "$machine"
}
case_bad_ports() {
    one_line 69 'No such file'      "$loft" stream "$tmp/small.csv" --port /dev/ttyNONE
    one_line 69 'not a serial port' "$loft" stream "$tmp/small.csv" --port /dev/null
    one_line 69 'not a serial port' "$loft" stream "$tmp/small.csv" --port "$tmp/small.csv"
    one_line 69 'No such file'      "$loft" stream "$tmp/small.csv" --port "unix:$tmp/none"
    one_line 69 'refused'           "$loft" stream "$tmp/small.csv" --port tcp:127.0.0.1:1
}

case_links_of_others_are_left_alone() {
    echo precious >"$tmp/file"
    ln -s "$tmp/file" "$tmp/mine"
    ln -s nowhere "$tmp/dangling"
    mkdir "$tmp/folder"
    one_line 73 'link to something other than a simulated machine' \
        "$loft" simulate --link "$tmp/mine"
    one_line 73 'link to something other than a simulated machine' \
        "$loft" simulate --link "$tmp/dangling"
    one_line 73 'is a file' "$loft" simulate --link "$tmp/file"
    one_line 73 'is a file' "$loft" simulate --link "$tmp/folder"
    [ "$(readlink "$tmp/mine") $(readlink "$tmp/dangling") $(cat "$tmp/mine")" = \
        "$tmp/file nowhere precious" ] || job_fails "$(ls -l "$tmp")"
    machine first --speed fast
    one_line 73 'another simulated machine has this link' "$loft" simulate --link "$tmp/first"
    run 0 "$loft" ports "$tmp/first"; says out '	idle'
    kill -9 "$machine"
    gone "$machine"
    [ -L "$tmp/first" ] || job_fails "no link is left behind to be replaced"
    machine first --speed fast
    until_log first '^machine: '
    run 0 "$loft" ports "$tmp/first"
    says out '	idle'
    ln -sfn elsewhere "$tmp/first"; kill "$machine"; gone "$machine"
    [ "$(readlink "$tmp/first")" = elsewhere ] || job_fails "a link of somebody else was removed"
}
case_help_everywhere() {
    run 0 "$loft" --help;    says out 'usage: loft COMMAND'
    run 0 "$loft" --version; says out '^loft [0-9]'
    run 64 "$loft"
    for command in stream simulate plot ports eval sample flatten measure compare surface contour \
                   export decide make mill figures fit
    do
        run 0 "$loft" help $command;   says out "^usage: loft $command"; cp "$tmp/out" "$tmp/help"
        run 0 "$loft" $command --help
        cmp -s "$tmp/out" "$tmp/help" || job_fails "help $command and $command --help differ"
    done
}
