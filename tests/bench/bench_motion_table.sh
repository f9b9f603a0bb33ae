# tests/bench/bench_motion_table.sh -- rows of bench_motion.sh: plans at the hard end, on machines
# with 100 and 200 mm/s
# SPDX-License-Identifier: MIT
#
# It is sourced. A row without a number is a promise that nothing measures yet.

table_b=B:200:3000:100000

# measured NUM TOL KNOTS MACHINE[:FEED] LIST.. > rows of bench_motion_lists.c
measured() {
    local num=$1 tol=$2 knots=$3 m v a j feed; IFS=: read -r m v a j feed <<< "$4"; shift 4
    (cd "$build/lists" &&
        "$table_bin/lists-$num" "$v${feed:+:$feed}" "$a" "$j" "$tol" "$knots" "$@") |
        sed '/^list /d; /^sum /d'
}
# largest COLUMN PATTERN FILE..: the value, and the list that has it
largest() {
    awk -v c="$1" -v p="$2" '$1 ~ p && NF == 8 && $c + 0 > most + 0 { most = $c; name = $1 }
        END { print most, name }' "${@:3}"
}
# summed PATTERN FILE: seconds of all lists; nothing, if one has no plan
summed() {
    awk -v p="$1" '$1 ~ p { bad += NF != 8; s += $2; n++ }
        END { if (n > 0 && !bad) print s }' "$2"
}
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { if (a > 0 && b > 0) printf "%.4f\n", a / b }'; }

table_bin=$(cd "$build" && pwd)
shapes=
shape_lists() {     # once
    [ -z "$shapes" ] || return 0
    mkdir -p "$build/lists"
    /usr/bin/python3 tests/bench/motion_lists.py "$build/lists" || exit 1
    shapes=$(cd "$build/lists" && ls | sed -n 's/\.moves$//; /^outline\|^star\|^line/p')
}
icon_lists() {
    # 60 drawings that Debian packages have installed here, evenly chosen by name
    find /usr/share -name '*.svg' -size -40k 2>/dev/null | LC_ALL=C sort > "$build/svg"
    awk -v n="$(wc -l < "$build/svg")" -v m="${ICONS:-60}" \
        'int(NR * m / n) > int((NR - 1) * m / n)' "$build/svg" |
        nl -w1 -s' ' > "$build/icons"
    while read -r k file; do
        "$build/moves" "$file" 1 2>/dev/null | head -16000 > "$build/lists/icon-$k.moves"
        [ -s "$build/lists/icon-$k.moves" ] || rm -f "$build/lists/icon-$k.moves"
    done < "$build/icons"
    icons=$(cd "$build/lists" && ls | sed -n 's/\.moves$//; /^icon/p')
}

cut_rows() {        # MACHINE
    local m=${1%%:*} file
    shape_lists
    measured q16 0.005 400 "$1" $shapes > "$build/table-$m.out" &
    measured f64 0.005 400 "$1" $shapes > "$build/table-$m-f64.out"; wait $!
    for shape in outline star; do
        read -r value name < <(awk -v p="^$shape-" '
            $1 ~ p && NF == 8 { if (!least || $2 < least) least = $2
                                if ($2 > most) { most = $2; name = $1 } }
            $1 ~ p && NF != 8 { bad = $1 " " $2 }
            END { print bad ? "- " bad : most / least " " name }' "$build/table-$m.out")
        row "($m) $shape cut 1x .. 32x and in chords: longest over shortest time" \
            1.015 "${value#-}" "$name"
    done
    file="$build/table-$m.out $build/table-$m-f64.out"
    row "($m) speed of an axis, of the limit" 1.001 $(largest 3 . $file)
    row "($m) acceleration of an axis, of the limit" 1.005 $(largest 4 . $file)
    [ $m = D ] || row "($m) jerk of an axis, of the limit" 1.02 $(largest 5 . $file)
    row "($m) distance from the path (Frechet), of the tolerance" 1 $(largest 6 . $file)
    row "($m) time of q16 over f64, off 1 by, worst list" 0.003 $(awk '
        NR == FNR { t[$1] = $2; next }
        NF == 8 && t[$1] > 0 { d = $2 / t[$1] - 1; d = d < 0 ? -d : d
                               if (d > most) { most = d; name = $1 } }
        END { print most + 0, name }' "$build/table-$m-f64.out" "$build/table-$m.out")
}

A_rows() { cut_rows A:100:500:10000; }
B_rows() { cut_rows $table_b; }
C_rows() { cut_rows C:100:2000:40000; }
D_rows() { cut_rows D:100:500:0; }

# shapes written as chords, over the same as cubics; and a higher feed, which is never slower
chords_rows() {
    local machine m feed list n=0
    mkdir -p "$build/lists"
    rm -f "$build"/lists/*-cubics.moves "$build"/lists/*-{even,random}-*.moves
    /usr/bin/python3 tests/bench/motion_chords.py lists "$build/lists" || exit 1
    list=$(cd "$build/lists" && ls | sed -n 's/\.moves$//; /-cubics$\|-\(even\|random\)-/p')
    for machine in A:100:500:10000 $table_b C:100:2000:40000 D:100:500:0; do
        for feed in ${FEEDS:-20 60 100 200}; do
            measured q16 0.005 400 "$machine:$feed" $list | sed "s/$/ $feed/"
        done > "$build/chords-${machine%%:*}.out" &
        [ $((n = 1 - n)) = 1 ] || wait
    done
    # KEY MACHINE VALUE WHERE
    /usr/bin/python3 tests/bench/motion_chords.py judge "$build/chords.svg" \
        "$build"/chords-[A-D].out > "$build/chords.table"
    for m in A B C D; do
        row "($m) chords of a sag up to tol/2 over the same as cubics, worst" 1.02 \
            $(judged fine $m)
        row "($m) chords of a sag above tol/2 over the same as cubics, worst" 1.05 \
            $(judged coarse $m)
        row "($m) chords: distance from the path (Frechet), of the tolerance" 1 $(judged off $m)
        row "($m) chords: time over that with the next lower feed, worst" 1.002 $(judged feed $m)
        note "$(judged above $m)"
    done
}
judged() {
    awk -v key="$1" -v m="$2" '$1 == key && $2 == m { $1 = $2 = ""; print }' "$build/chords.table"
}

icons_rows() {
    local b=$table_b at before="" value name file
    shape_lists
    icon_lists
    for tol in 0.005 0.02 0.05; do
        measured q16 $tol 400 $b outline-cut-1 star-cut-1 $icons > "$build/table-$tol.out"
    done
    for pair in "0.005 0.02" "0.02 0.05"; do
        read -r at before <<< "$pair"
        read -r value name < <(awk '
            NR == FNR { t[$1] = $2; next }
            NF == 8 && t[$1] > 0 && $2 / t[$1] > most { most = $2 / t[$1]; name = $1 }
            END { print most, name }' "$build/table-$at.out" "$build/table-$before.out")
        row "(B) time with $before mm over time with $at mm, worst drawing" 1 "$value" "$name"
    done
    value=$(summed ^icon "$build/table-0.005.out")
    row "(B) icons: time with 0.02 mm over 0.005" \
        0.93 "$(ratio "$(summed ^icon "$build/table-0.02.out")" "$value")" "$value s"
    row "(B) icons: time with 0.05 mm over 0.005" \
        0.90 "$(ratio "$(summed ^icon "$build/table-0.05.out")" "$value")"
    row "(B) icons whose plan does not arrive" 0 \
        "$(awk '/^icon/ && NF != 8 { n++ } END { print n + 0 }' "$build/table-0.005.out")" \
        "of $(wc -l < "$build/icons")"
    file="$build/table-0.005.out $build/table-0.02.out $build/table-0.05.out"
    row "(B) icons: speed of an axis, of the limit" 1.001 $(largest 3 ^icon $file)
    row "(B) icons: acceleration of an axis, of the limit" 1.005 $(largest 4 ^icon $file)
    row "(B) icons: jerk of an axis, of the limit" 1.02 $(largest 5 ^icon $file)
    row "(B) icons: distance from the path (Frechet), of the tolerance" \
        1 $(largest 6 ^icon $file)
}

# against MACHINE COLUMN LESS: outline, star and icons over a reference, in this column of
# bench_motion_reference.c; a plan may last LESS seconds more. Prints the outline's ratio, that of
# the icons' sums, the worst one and its name.
against() {
    awk -v c="$2" -v less="$3" '
        NR == FNR { t[$1] = $c; next }
        NF == 8 && t[$1] > 0 { r = ($2 - less) / t[$1]
                               if ($1 ~ /^outline/) outline = $2 / t[$1]
                               if ($1 ~ /^icon/) { sum += $2; all += t[$1] }
                               if (r > most) { most = r; name = $1 } }
        END { if (all > 0) printf "%.4f %.4f %.4f %s\n", outline, sum / all, most, name }' \
        "$build/reference-$1.out" "$build/table-$1-5.out"
}

# chains over references that stop at corners, or blend them
stops_rows() {
    local m v a j outline sum worst name
    shape_lists
    icon_lists
    for m in $table_b D:100:500:0; do
        IFS=: read -r m v a j <<< "$m"
        (cd "$build/lists" && "$table_bin/reference-f64" "$v" "$a" "$j" 0.005 \
            outline-cut-1 star-cut-1 $icons) > "$build/reference-$m.out" &
        measured q16 0.005 400 "$m:$v:$a:$j" outline-cut-1 star-cut-1 $icons \
            > "$build/table-$m-5.out"
        wait $!
    done
    read -r outline sum worst name < <(against B 2 0)
    row "(B) outline: time over the reference that stops at corners" 1.00 "$outline"
    row "(B) icons: time over the reference that stops at corners" 0.94 "$sum"
    row "(B) time over the reference that stops at corners, worst" 1.01 "$worst" "$name"
    read -r outline sum worst name < <(against D 2 0.004)
    row "(D) outline: time over TOPP with stops at corners" 1.00 "$outline"
    row "(D) icons: time over TOPP with stops at corners" 1.00 "$sum"
    row "(D) less a period of 4 ms, over TOPP with stops at corners, worst" 1.00 "$worst" "$name"
    read -r outline sum worst name < <(against D 3 0)
    row "(D) icons: time over TOPP with blends of 0.005 mm" 1.05 "$sum"
    row "(D) time over TOPP with blends of 0.005 mm, worst" 1.05 "$worst" "$name"
}

ahead_rows() {
    shape_lists
    for knots in 176 400; do
        measured q16 0.005 $knots $table_b outline-cut-1 star-cut-1 > "$build/table-$knots.out"
    done
    for shape in outline star; do
        row "(B) $shape: 128 periods ahead over 352" 1.03 \
            "$(ratio "$(summed ^$shape "$build/table-176.out")" \
                "$(summed ^$shape "$build/table-400.out")")"
    done
}

lines_rows() {
    local value name
    shape_lists
    measured q16 0.005 400 $table_b $(echo "$shapes" | grep ^line) outline-cut-4 \
        > "$build/table-lines.out"
    read -r value name < <(awk '
        /^line-/ { split($1, w, "-"); l = w[2]; v = 200; a = 3000; j = 100000
                   top = (sqrt(a ^ 4 / j ^ 2 + 4 * a * l) - a * a / j) / 2
                   if (l < 2 * a ^ 3 / j ^ 2) t = 4 * (l / (2 * j)) ^ (1 / 3)
                   else { if (top > v) top = v; t = l / top + top / a + a / j }
                   r = ($2 - 0.003) / t; if (r > most) { most = r; name = $1 } }
        END { print most, name }' "$build/table-lines.out")
    row "(B) lines, less a period of 3 ms, over the exact S-curve, worst" 1.02 "$value" "$name mm"
    row "(B) host: ms for each curve of 2.5 mm" 0.3 \
        "$(awk '$1 == "outline-cut-4" { print $8 * $2 / 48 }' "$build/table-lines.out")"
}

# on emulated chips, with effort 1
chip_rows() {
    local core list most
    bash tests/bench/bench_motion_chip.sh "$build/chip" > "$build/chip.out" ||
        { row "load of a Cortex-M4 and M0" 0 "" "make deps-target"; return; }
    for core in m4 m0; do
        [ $core = m4 ] && most="0.5 2500000" || most="0.9 3000000"
        while read -r list load _ worst _; do
            case $list in       # no promise: it cannot plan these as fast as they are drawn
            m0:*-32|m0:*star*) printf '%-66s %10s %12s\n' "load, $list" "" "$load" ;;
            *) row "load, $list" ${most% *} "$load" ;;
            esac
            row "dearest call, instructions, $list" ${most#* } "$worst"
        done < <(grep "^$core:" "$build/chip.out")
    done
    row "memory of a plan that looks 128 periods ahead, bytes" 8192 \
        "$(awk '/^m4:/ { print $6; exit }' "$build/chip.out")"
}
