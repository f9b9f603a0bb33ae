#!/bin/sh
# tests/lint.sh -- the rules of the house, each one line `ok` or `FAIL` with the places
# SPDX-License-Identifier: MIT
# usage: tests/lint.sh ; it calls itself for what runs side by side: compiled COMPILER NUM AXES, compiled_tools COMPILER
set -u
result=$(mktemp); trap 'rm -f "$result" "$result.jobs"' EXIT
rule() {        # rule NAME: standard input lists the offending places; none is good
    places=$(cat)
    if [ -z "$places" ]; then echo "ok   lint $1"
    else echo "FAIL lint $1"; echo "$places" | sed 's/^/     /' | head -20; fi | tee -a "$result"
}

warnings="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wundef -Werror"
compiled() {            # compiled COMPILER NUM AXES: does lib/ compile without a warning, and all of its headers together?
    { $1 $warnings -ffreestanding -Ilib -DLOFT_NUM=LOFT_$2 -DLOFT_AXES=$3 -fsyntax-only lib/*/*.c
      echo '#include "loft.h"' | $1 $warnings -ffreestanding -Ilib -DLOFT_NUM=LOFT_$2 -DLOFT_AXES=$3 -fsyntax-only -x c -; } 2>&1 | rule "$1 $2 x$3"
}
compiled_tools() {      # compiled_tools COMPILER
    $1 -std=c99 -D_GNU_SOURCE ${warnings#-std=c99} -Ilib -Iports -Ihost-tools -I. $(pkg-config --cflags libxml-2.0 cairo libserialport) \
        -DLOFT_NUM=LOFT_Q16 -fsyntax-only host-tools/*.c ports/host/*.c ports/linux-gpio/[!g]*.c ports/template/*.c ports/firmware.c 2>&1 |
        rule "$1 host tools and ports"
}
if [ $# -gt 0 ]; then "$@"; exit; fi

# 1. arrows: a file includes its own room and rooms before it
rooms="num geom basis curve surface polygon toolpath motion wire machine"
wrong_arrows() {
    rank=0
    for room in $rooms; do
        rank=$((rank + 1)) later=0
        [ -d "lib/$room" ] || continue
        for other in $rooms; do
            later=$((later + 1))
            [ $later -le $rank ] || grep -nE "#[[:space:]]*include[[:space:]]*\"$other/" "lib/$room"/*.[ch]
        done
    done
    grep -nE '#[[:space:]]*include.*(ports|host-tools|loft\.h|port\.h)' lib/*/*.[ch]
}
wrong_arrows | rule "arrows point one way"

# 2. freestanding
grep -nE '#[[:space:]]*include[[:space:]]*<' lib/*.h lib/*/*.[ch] |
    grep -vE '<(stdint|stddef|stdbool|limits|float|stdarg|iso646)\.h>' | rule "lib/ includes freestanding headers only"
grep -nwE 'malloc|calloc|realloc|free|alloca|printf|setjmp|longjmp' lib/*/*.[ch] |
    grep -vE ':[0-9]+:[[:space:]]*(/?\*|//)' | rule "no heap and no libc in lib/"

# 3. names.h is what the headers say
sh tests/names.sh | diff - lib/names.h | rule "names.h is fresh"

for header in lib/*/*.h; do
    sed -n '/^static\|^typedef/d; s/^[a-z][A-Za-z0-9_ ]*[ *]\(loft_[a-z0-9_]*\)(.*/\1/p' "$header" | sort -u
done | sort | uniq -d | rule "no public name stands for two functions"

# 4. only num/ tests the number type
grep -nE '^[[:space:]]*#.*LOFT_(NUM|Q16|F32|F64)\b' lib/*/*.[ch] | grep -v '^lib/num/' | rule "only num/ tests LOFT_NUM"

# 5. every public function of lib/ is documented: a comment stands above it, or above the group it opens
for header in lib/*/*.h; do
    awk -v file="$header" '
        /^(static|typedef|#|}|extern|struct|enum loft_[a-z]+ *\{|\/)/ { if ($0 !~ /^\//) grouped = 0 }
        /\*\/[ \t]*$/               { grouped = 1 }
        /^$/                        { grouped = 0 }
        /^[a-z][A-Za-z0-9_ ]*[ *]loft_[a-z0-9_]*\(/ && !/^(static|typedef)/ {
            if (!grouped) print file ":" FNR ": " $0
            grouped = 1
        }' "$header"
done | rule "public functions are documented"

# ... and those that compute curves, surfaces and patches over polygons say how much they err and what they cost: in the comment
# above them, above the first of their group (no empty line between), or at the head of the section (a comment with a line of dashes)
for header in lib/basis/*.h lib/curve/*.h lib/surface/*.h lib/polygon/*.h; do
    awk -v file="$header" '
        /^\/\*/                      { said = ""; inside = 1 }
        inside                      { said = said "\n" $0 }
        /\*\/[ \t]*$/               { if (inside && said ~ /\n \* ---/) { section = said; said = "" } inside = 0; next }
        /^\/\/ ---/                 { section = "" }
        /^$/ && !inside             { said = "" }
        /^[a-z][A-Za-z0-9_ ]*[ *]loft_[a-z0-9_]*\(/ && !inside && !/^(static|typedef)/ {
            for (i = split("error cost", label, " "); i > 0; i--)
                if (said section !~ "\n \\* +" label[i] " +[^ ]")
                    print file ":" FNR ": no " label[i] ": " $0
        }' "$header"
done | rule "curves and surfaces say their error and their cost"

# 6. every source says its licence and what it is
for file in lib/*.h lib/*/*.[ch] ports/*.h ports/*/*.[ch] host-tools/*.[ch] tests/*.[ch] tests/*.sh; do
    [ -f "$file" ] || continue
    head -4 "$file" | grep -q 'SPDX-License-Identifier: MIT' || echo "$file: no SPDX line"
    head -3 "$file" | grep -qF "$file" || echo "$file: the first lines do not name the file"
done | rule "files name themselves and their licence"

# 7. gcc and clang, warnings as errors, all number types, one, three and six axes: side by side
for compiler in gcc clang; do
    for num in Q16 F32 F64; do
        for axes in 1 3 6; do echo "sh tests/lint.sh compiled $compiler $num $axes"; done
    done
done >"$result.jobs"
for compiler in gcc clang; do echo "sh tests/lint.sh compiled_tools $compiler"; done >>"$result.jobs"
bash tests/beside.sh <"$result.jobs" | tee -a "$result"

passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
