#!/bin/sh
# tests/house/reach.sh -- which functions of geometry a command reaches, header by header
# SPDX-License-Identifier: MIT
# usage: tests/house/reach.sh [--check]
# A function is reached if a host tool names it, itself or through another function of the library:
# the call graph is read off the sources, by name. Those that none reaches are in
# tests/house/unreached.txt. --check prints what the list lacks, and what it names in vain.
set -u
export LC_ALL=C
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT

rooms='lib/geom lib/basis lib/curve lib/surface lib/polygon lib/toolpath'
for header in $(find $rooms -name '*.h' | sort); do
    sed -n '/^static\|^typedef/d; s/^[a-z][A-Za-z0-9_ ]*[ *]\(loft_[a-z0-9_]*\)(.*/\1/p' "$header" |
        sort -u | sed "s|\$| $header|"
done | sort >"$work/all"

# lines `caller callee` of lib/; a static function, or one in a header, counts for its file
find lib -mindepth 2 -name '*.c' ! -path 'lib/examples/*' | sort | xargs awk '
    FNR == 1                        { from = FILENAME }
    /^[a-z].*[ *]loft_[a-z0-9_]*\(/ { if (!/;[ \t]*$/ && !/^static/) {
                                          from = $0; sub(/\(.*/, "", from); sub(/.*[ *]/, "", from)
                                      } }
    /^}/                            { from = FILENAME }
    {   rest = $0
        while (match(rest, /loft_[a-z0-9_]+\(/)) {
            to = substr(rest, RSTART, RLENGTH - 1); rest = substr(rest, RSTART + RLENGTH)
            if (to != from) print from, to
        }
        if (from != FILENAME && FNR > 1) print from, FILENAME
    }' | sort -u >"$work/calls"

grep -rhoE 'loft_[a-z0-9_]+' host-tools ports --include='*.[ch]' | sort -u >"$work/named"
awk 'NR == FNR { to[$1] = to[$1] " " $2; next }
     { queue[++n] = $1; seen[$1] = 1 }
     END { for (q = 1; q <= n; q++) {
               m = split(to[queue[q]], c, " ")
               for (i = 1; i <= m; i++) if (!seen[c[i]]++) queue[++n] = c[i] }
           for (q = 1; q <= n; q++) print queue[q] }' "$work/calls" "$work/named" |
    sort -u >"$work/reached"

join -v1 "$work/all" "$work/reached" | cut -d' ' -f1 >"$work/missing"
if [ "${1:-}" = --check ]; then
    grep -v '^#' tests/house/unreached.txt | sort >"$work/listed"
    comm -23 "$work/missing" "$work/listed" |
        sed 's/$/: no command reaches it: add one, or a line to tests\/house\/unreached.txt/'
    comm -13 "$work/missing" "$work/listed" |
        sed 's/$/: a command reaches it, or it is gone: take it off tests\/house\/unreached.txt/'
    exit
fi
awk 'NR == FNR { reached[$1] = 1; next }
     { all[$2]++; sum++; if ($1 in reached) { got[$2]++; total++ } else left[$2] = left[$2] " " $1 }
     END { for (h in all) printf "%-44s %3d of %3d %s\n", h, got[h], all[h], left[h] | "sort"
           close("sort")
           printf "%d of %d functions are reached by a command\n", total, sum }' \
    "$work/reached" "$work/all"
