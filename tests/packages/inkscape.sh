#!/bin/bash
# tests/packages/inkscape.sh -- the extension for Inkscape: alone, and in Inkscape without a window
# SPDX-License-Identifier: MIT
# usage: tests/packages/inkscape.sh
row=inkscape
. tests/packages/row.sh
needs inkscape Xvfb xmllint python3
make -s tools || exit 1
export LOFT=$top/build/loft XDG_STATE_HOME=$work/state INKSCAPE_PROFILE_DIR=$work/profile
unset DISPLAY
script=$top/ports/packages/inkscape/loft_inkscape.py state=$work/state/loft
cat >"$work/two.svg" <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">
  <defs><path id="far" d="M0 0h9"/></defs>
  <g id="layer"><path id="one" d="M10 10h20" stroke="black"/>
    <g id="pair"><path id="two" d="M10 20h40v30" stroke="black"/><use href="#far" id="three"
        x="9" y="9" stroke="black"/></g></g>
</svg>
END
called() { python3 "$script" "$@" "$work/two.svg" >"$work/out.svg" 2>"$work/said"; }
says() { grep -q -- "$1" "$work/said" || { cat "$work/said"; false; }; }

unchanged() { called && cmp "$work/two.svg" "$work/out.svg"; }
verdict "the document comes back unchanged" unchanged
all() { says 'planned: 4 curves' && [ -s "$state/preview.png" ]; }
verdict "a preview of all: time and a picture" all
some() { called --id=one && says 'planned: 1 curve, 0.020 m' && called --id=pair &&
         says 'planned: 3 curves'; }
verdict "a preview of what is selected, also of a group" some
missing() { LOFT=/none called && says 'install loft'; }
verdict "it says that loft is not installed" missing

machine() {     # machine NAME SPEED
    "$LOFT" simulate --link "$work/$1" --speed "$2" >"$work/$1.log" 2>&1 & simulated=$!
    for _ in $(seq 100); do [ -e "$work/$1" ] || sleep 0.1; done
}
until_log() { for _ in $(seq 300); do grep -q "$1" "$state/log" && return; sleep 0.1; done
              cat "$state/log"; false; }
draws() { called --action=draw --port="$work/quick" --id=one --terminal=false &&
          until_log '^drawn: 1 curve, .* as commanded'; }
machine quick fast
verdict "what is selected is drawn" draws
kill $simulated
holds() {
    called --action=draw --port="$work/slow" --terminal=false --options="--feed 10" &&
        says 'loft draws all' && called --action=hold && says '^loft: held at item' &&
        called --action=draw --port="$work/slow" --terminal=false --options="--feed 10" &&
        until_log 'resuming at item' && called --action=abort --port="$work/slow" &&
        says '^aborted: '
}
machine slow real
verdict "hold, go on, give up" holds
kill $simulated

mkdir -p "$work/profile/extensions"
cp ports/packages/inkscape/loft* "$work/profile/extensions"
in_inkscape() {     # it shows what was said in a window and stays, so it is ended here
    local server shown
    rm -f "$state/preview.txt"
    Xvfb -displayfd 3 -screen 0 800x600x24 3>"$work/display" 2>/dev/null & server=$!
    for _ in $(seq 100); do [ -s "$work/display" ] || sleep 0.1; done
    DISPLAY=:$(cat "$work/display") inkscape --with-gui --batch-process \
        --actions="select-by-id:one;org.loft.draw.noprefs" "$work/two.svg" </dev/null & shown=$!
    for _ in $(seq 1500); do [ -s "$state/preview.txt" ] || sleep 0.1; done
    kill $shown $server
    wait
    grep 'planned: 1 curve, 0.020 m' "$state/preview.txt"
}
conforms() {
    xmllint --noout --relaxng /usr/share/inkscape/extensions/inkscape.extension.rng \
        ports/packages/inkscape/loft.inx
}
verdict "Inkscape's own schema accepts loft.inx" conforms
verdict "in Inkscape itself: a preview of what is selected" in_inkscape
ended
