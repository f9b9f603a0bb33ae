#!/bin/sh
# tests/house/lint.sh -- check the rules of the house: one line each, `ok` or `FAIL` with the places
# SPDX-License-Identifier: MIT
# usage: tests/house/lint.sh
# It calls itself for parallel work: compiled, compiled_tools, broken.
set -u
result=$(mktemp); trap 'rm -f "$result" "$result.jobs"' EXIT
rule() {        # rule NAME: standard input lists the offending places; empty means ok
    places=$(cat)
    if [ -z "$places" ]; then echo "ok   lint $1"
    else echo "FAIL lint $1"; echo "$places" | sed 's/^/     /' | head -20; fi | tee -a "$result"
}

sources=$(find lib -mindepth 2 -name '*.[ch]' ! -path 'lib/examples/*' | LC_ALL=C sort)
headers=$(printf '%s\n' $sources | grep '\.h$')

warnings="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow"
warnings="$warnings -Wstrict-prototypes -Wmissing-prototypes -Wundef -Werror"
# compiled COMPILER NUM AXES: does lib/ compile without a warning, and all of its headers together?
compiled() {
    given="$warnings -ffreestanding -Ilib -DLOFT_NUM=LOFT_$2 -DLOFT_AXES=$3 -fsyntax-only"
    {   $1 $given $(printf '%s\n' $sources | grep '\.c$')
        echo '#include "loft/surfaces.h"' | $1 $given -x c -
    } 2>&1 | rule "$1 $2 x$3"
}
compiled_tools() {      # compiled_tools COMPILER
    $1 -std=c99 -D_GNU_SOURCE ${warnings#-std=c99} -Ilib -Iports -Ihost-tools -I. \
        $(pkg-config --cflags libxml-2.0 zlib pangocairo libserialport) \
        -DLOFT_NUM=LOFT_Q16 -fsyntax-only host-tools/*.c host-tools/*/*.c ports/host/*.c \
        ports/linux-gpio/[!g]*.c ports/template/*.c ports/firmware.c 2>&1 |
        rule "$1 host tools and ports"
}
broken() {              # broken FOLDER: are its lines broken as .clang-format says?
    find "$1" -name '*.[ch]' ! -path lib/names.h -exec python3 tests/house/format.py --check {} + |
        rule "$1/ is broken and indented as .clang-format says: make format"
}
if [ $# -gt 0 ]; then "$@"; exit; fi

# 1. arrows: a file includes its own room and rooms before it
wrong_arrows() {        # wrong_arrows TOP ROOM..: includes of a later room
    top=$1 rank=0; shift
    for room in "$@"; do
        rank=$((rank + 1)) later=0
        [ -d "$top/$room" ] || { echo "$top/$room: no such room"; continue; }
        for other in "$@"; do
            later=$((later + 1))
            [ $later -le $rank ] ||
                grep -rnE "#[[:space:]]*include[[:space:]]*\"$other/" "$top/$room" \
                    --include='*.[ch]'
        done
    done
    ls -d "$top"/*/ | while read -r found; do
        found=${found%/}
        case " $* examples loft page pictures " in
        *" ${found##*/} "*) ;;
        *) echo "$found: a room without a rank" ;;
        esac
    done
}
{ wrong_arrows lib num geom basis curve kinematics path motion wire machine surface polygon toolpath
  grep -nE '#[[:space:]]*include.*(ports|host-tools|loft\.h|port\.h)' $sources |
      grep -v '^lib/loft/surfaces\.h:'
} | rule "arrows of lib/ point one way"
{ python3 tests/house/arrows.py base engine geometry read svg gcode readers fit arrange plan send \
      draw mill make library serve cmd command_list loft figures
  grep -nE '#[[:space:]]*include[[:space:]]*"[^/]*"' host-tools/*/*.[ch] |
      grep -vE '"(loft|readers)\.h"'
} | rule "arrows of host-tools/ point one way, in no circle; only cmd/ has the terminal"

# 2. freestanding
grep -nE '#[[:space:]]*include[[:space:]]*<' lib/*.h $sources |
    grep -vE '<(stdint|stddef|stdbool|limits|float|stdarg|iso646)\.h>' |
        rule "lib/ includes freestanding headers only"
grep -nwE 'malloc|calloc|realloc|free|alloca|printf|setjmp|longjmp' $sources |
    grep -vE ':[0-9]+:[[:space:]]*(/?\*|//)' | rule "no heap and no libc in lib/"

sh tests/house/reach.sh --check |
    rule "a command reaches each function of geometry, or the list says so"

# 3. names.h agrees with the headers
sh tests/house/names.sh | diff - lib/names.h | rule "names.h is fresh: make lib/names.h"
python3 tests/house/errors.py | diff - lib/ERRORS.md | rule "ERRORS.md is fresh: make lib/ERRORS.md"
python3 tests/house/stack.py names | rule "STACK.md has a row for each function: make stack"
python3 tests/house/messages.py | diff - host-tools/MESSAGES.md |
    rule "MESSAGES.md is fresh: make host-tools/MESSAGES.md"

for header in $headers; do
    sed -n '/^static\|^typedef/d; s/^[a-z][A-Za-z0-9_ ]*[ *]\(loft_[a-z0-9_]*\)(.*/\1/p' "$header" |
        sort -u
done | sort | uniq -d | rule "no public name stands for two functions"

# ... loft.h and loft/surfaces.h include every header of their library, and loft.h no other.
# Excepted are internal ones of motion/ and of the packer
not_for_users='lib/path/|lib/motion/|lib/num/(q16|f32|f64|floats|avr).h'
not_for_users="$not_for_users|lib/wire/(curve_code|varint).h"
of_surfaces='^lib/(loft|surface|polygon|toolpath)/'
included() { echo "#include \"$1\"" | cc -Ilib -M -x c - | tr -d '\\' | tr -s ' ' '\n' | sort -u; }
missing() {     # missing HEADER: lines of standard input that it does not include
    included "$1" | { cat; printf '%s\n' $headers | grep -E "$not_for_users"; } >"$result.included"
    grep -vxF -f "$result.included"
}
{ printf '%s\n' $headers | grep -vE "$of_surfaces" | missing loft.h
  included loft.h | grep -E "$of_surfaces" | sed 's/$/: loft.h includes it/'
} | rule "loft.h includes every header of libloft, and none of surfaces"
printf '%s\n' $headers | missing loft/surfaces.h | rule "loft/surfaces.h includes every header"
rm "$result.included"

# 4. only num/ tests the number type
grep -nE '^[[:space:]]*#.*LOFT_(NUM|Q16|F32|F64)\b' $sources | grep -v '^lib/num/' |
    rule "only num/ tests LOFT_NUM"

# ... and lines for people pass one place, where words of others are made visible
grep -nE 'printf\(stderr|perror\(' host-tools/*.c host-tools/*/*.c |
    grep -vE '^host-tools/base/progress\.c:' |
    rule "host-tools/ say what people read by base/say.h"

# 5. every public function of lib/ is documented:
# a comment stands above it, or above the group it opens
for header in $headers; do
    awk -v file="$header" '
        /^(static|typedef|#|}|extern|struct|enum loft_[a-z]+ *\{)/ { grouped = 0 }
        /\*\/[ \t]*$/               { grouped = 1 }
        /^$/                        { grouped = 0 }
        /^[a-z][A-Za-z0-9_ ]*[ *]loft_[a-z0-9_]*\(/ && !/^(static|typedef)/ {
            if (!grouped) print file ":" FNR ": " $0
            grouped = 1
        }' "$header"
done | rule "public functions are documented"

# ... and those that compute curves, surfaces and patches over polygons state their error and their
# cost: in the comment above them, above the first of their group (no empty line between), or at the
# head of the section (a comment with a line of dashes)
for header in $(printf '%s\n' $headers | grep -E '^lib/(basis|curve|surface|polygon)/'); do
    awk -v file="$header" '
        /^\/\*/                      { said = ""; inside = 1 }
        inside                      { said = said "\n" $0 }
        /\*\/[ \t]*$/               {
            if (inside && said ~ /\n \* ---/) { section = said; said = "" }
            inside = 0
            next
        }
        /^\/\/ ---/                 { section = "" }
        /^$/ && !inside             { said = "" }
        /^[a-z][A-Za-z0-9_ ]*[ *]loft_[a-z0-9_]*\(/ && !inside && !/^(static|typedef)/ {
            for (i = split("error cost", label, " "); i > 0; i--)
                if (said section !~ "\n \\* +" label[i] " +[^ ]")
                    print file ":" FNR ": no " label[i] ": " $0
        }' "$header"
done | rule "curves and surfaces say their error and their cost"

# 6. every source names its licence and itself
named=$(find ports host-tools tests -name '*.[ch]' -o -name '*.sh' -o -name '*.mk')
for file in lib/*.h $sources lib/examples/*.c $named; do
    head -4 "$file" | grep -q 'SPDX-License-Identifier: MIT' || echo "$file: no SPDX line"
    head -3 "$file" | grep -qF "$file" || echo "$file: the first lines do not name the file"
done | rule "files name themselves and their licence"

# ... and a header with functions has a test of its name, or tests/README.md says which holds it
test_of() { dir=$(dirname "${1#lib/}"); echo "tests/lib/$dir/test_$(basename "$1" .h).c"; }
includes() {    # includes TEST HEADER: in some number type, or on an AVR?
    for flags in -DLOFT_NUM=LOFT_Q16 -DLOFT_NUM=LOFT_F64 '-DLOFT_NUM=LOFT_Q16 -D__AVR__'; do
        cc -Ilib -Itests -Ihost-tools $flags -MM "$1" 2>/dev/null | tr -s ' \\' '\n' |
            grep -qxF "$2" && return
    done
}
reaches() {     # reaches TEST HEADER: does it include that, or the header of a source that does?
    includes "$1" "$2" && return
    for source in $(grep -lF "\"${2#lib/}\"" $(printf '%s\n' $sources | grep '\.c$')); do
        includes "$1" "${source%.c}.h" && return
    done
    return 1
}
held() {
    sed -n 's,^| `\([a-z0-9_/]*\.h\)` | `\([a-z0-9_/]*\.c\)` |.*,lib/\1 tests/\2,p' tests/README.md
}
without_test() {
    for header in $headers; do
        grep -qE '^[a-z][A-Za-z0-9_ ]*[ *]loft_[a-z0-9_]*\(' "$header" || continue
        [ -f "$(test_of "$header")" ] || held | grep -q "^$header " ||
            echo "$header: has no $(test_of "$header"):" \
                "write it, or name another in tests/README.md"
    done
    held | while read -r header test; do
        [ -f "$header" ] || echo "tests/README.md: $header: no such header"
        [ ! -f "$(test_of "$header")" ] || echo "tests/README.md: $header: has a test of its name"
        reaches "$test" "$header" || echo "tests/README.md: $test does not reach $header"
    done
}
without_test | rule "each header has a test of its name, or tests/README.md names another"

# ... and each loop that a header prints stands in a test, word for word
python3 tests/house/loops.py 2>&1 | rule "loops of headers are run by tests"
python3 tests/house/extremes.py 2>&1 | rule "what takes any number is tested with extremes"
python3 tests/house/tour.py 2>&1 | rule "host-tools/README.md makes each file first"

# ... and no line has more than 100 columns (characters). Excepted: tables of pages, a line with a
# word (a link) of more than 80 characters, generated files, drawings, data and pictures.
too_wide() {
    find . \( -name .git -o -name __pycache__ -o -path ./build -o -path ./tests/drawings \) -prune \
        -o -type f ! -name '*.csv' ! -name '*.svg' ! -name '*.png' ! -name '*.gz' \
        ! -path ./lib/names.h ! -path ./lib/ERRORS.md -print0 | xargs -0 python3 -c '
import sys
for name in sys.argv[1:]:
    for number, line in enumerate(open(name, encoding="utf-8"), 1):
        line = line.rstrip("\n")
        table = name.endswith(".md") and line.startswith("|")
        if len(line) > 100 and not table and max(map(len, line.split())) <= 80:
            print("%s:%d: %d columns" % (name, number, len(line)))
' 2>&1 || echo "the columns cannot be counted"
}
too_wide | rule "no line has more than 100 columns"

# ... and lib/TEXTS.md names what exists, and every figure.
{   for header in $(grep -o '`[a-z_0-9/]*\.h`' lib/TEXTS.md | tr -d '`' | sort -u); do
        [ -f "lib/$header" ] || echo "lib/TEXTS.md: $header: no such header"
    done
    grep -o '`loft [a-z ]*`' lib/TEXTS.md | tr -d '`' | sort -u | while read -r _ command verb; do
        ls host-tools/*/"cmd_$command.c" >/dev/null 2>&1 ||
            echo "lib/TEXTS.md: loft $command: no command"
        [ -z "$verb" ] || grep -q "{ \"$verb\", DECIDE" host-tools/make/engine_*.c ||
            echo "lib/TEXTS.md: loft $command $verb: no such verb"
    done
    awk -F '|' 'NF == 6 && $5 !~ /figures|---/ { gsub(/,/, " ", $5); print $5 }' lib/TEXTS.md |
        tr -s ' ' '\n' | grep -v '^–*$' | LC_ALL=C sort -u >"$result.texts"
    sed -n 's/^    { "\([a-z0-9-]*\)".*/\1/p' host-tools/figures/figures_*.c | LC_ALL=C sort -u |
        LC_ALL=C comm -3 "$result.texts" - | sed 's/^/lib\/TEXTS.md and loft figures differ: /'
    rm -f "$result.texts"
} | rule "lib/TEXTS.md names what exists, and every figure"

# 7. every call of the compiler has the user's CPPFLAGS and CFLAGS, and, if it links, LDFLAGS
links_and_objects="lib libraries tools test-tools test-axes test-effort test-e2e
    build/test/q16/forward build/test/f64/harmonic build/vectors/f32
    build/bench/bench3 build/bench/motion/time-q16 build/bench/motion/moves build/loft-gpio
    build/target/gpio/guest build/target/gpio/loft-gpio-memory
    build/target/stores.so build/target/bad_line build/target/chip build/target/trials
    build/target/rate build/target/bench_line"
flags_that_are_missing() {
    make -n -B V=1 CC=given-cc CXX=given-cc CPPFLAGS=-DGIVEN CFLAGS=-fgiven CXXFLAGS=-fgiven \
        LDFLAGS=-Lgiven $links_and_objects 2>&1 |
        sed -e ':join' -e '/\\$/{N;s/\\\n//;bjoin' -e '}' |
        awk '/\*\*\*/ { print }
             /given-cc/ {
                 calls++
                 if (!/ -DGIVEN / || !/ -fgiven / || (!/ -c / && !/ -Lgiven /)) print
             }
             END { if (calls < 500) print "only " calls + 0 " calls of the compiler were seen" }'
}
flags_that_are_missing | rule "every rule heeds CPPFLAGS, CFLAGS and LDFLAGS"

# 8. a whole job never waits for a time: it waits for what a machine or a command says
timed() {               # timed FILE..: lines that sleep, or type a key at a time
    grep -nwE 'sleep|usleep|time\.sleep' "$@" |
        grep -vE '^tests/e2e/(e2e_pty\.c|grbl_peer\.py|pauses\.py):|: *#'
    grep -nE "[\"' ][0-9]*\\.?[0-9]+:(\\^.|[^0-9 /\"'])([\"' ]|\$)" "$@"
}
timed tests/e2e/* | rule "no whole job waits for a time"
printf '%s\n' '    sleep 1' 'type "1.2:h 2.2:r"' "type '0.8:^C'" >"$result.timed"
{ [ "$(timed "$result.timed" | wc -l)" = 3 ] || echo "a planted line is not seen"; } |
    rule "waits for a time are seen"
rm "$result.timed"
# they are read into one shell: of two functions of a name the first is lost
defined() { sed -n 's/^\([a-z][a-z0-9_]*\)() .*/\1/p' "$@"; }
defined $(grep -l '^case_' tests/e2e/*.sh) tests/e2e/e2e.sh | sort | uniq -d |
    rule "no two files of whole jobs define one function"

# 9. a command: a table of options, a struct that it fills, one call, a print
long_functions() {      # long_functions FILE..: those of more than 40 lines
    awk '/^\{/ { begin = FNR }
         /^\}/ && begin {
             if (FNR - begin > 41) print FILENAME ":" begin ": " FNR - begin - 1 " lines"
             begin = 0
         }' "$@"
}
long_functions host-tools/cmd/*.c | rule "no function of cmd/ has more than 40 lines"
{ echo '{'; seq 41; echo '}'; echo '{'; seq 40; echo '}'; } >"$result.long"
{ [ "$(long_functions "$result.long" | wc -l)" = 1 ] || echo "a planted one is not seen"; } |
    rule "long functions are seen"
rm "$result.long"

# ... and a conversation with a machine is stepped: it gets the time, and waits for nothing
waiting() {             # waiting FILE..: lines that read a clock, sleep or poll for a time
    grep -nE '\b(tool_clock|clock_gettime|time|u?sleep|nanosleep|select)\(' "$@"
    grep -nE '\bpoll\(' "$@" | grep -vE 'sender_poll\(|, 0\)'
}
waiting host-tools/send/*.c | rule "send/ neither waits nor reads a clock"
printf '%s\n' 'usleep(5);' 'poll(&p, 1, 20);' 'x = tool_clock();' >"$result.waits"
{ [ "$(waiting "$result.waits" | wc -l)" = 3 ] || echo "a planted line is not seen"; } |
    rule "waits of send/ are seen"
rm "$result.waits"

# 10. gcc and clang, warnings as errors, all number types, one, three and six axes: in parallel
for compiler in gcc clang; do
    for num in Q16 F32 F64; do
        for axes in 1 3 6; do echo "sh tests/house/lint.sh compiled $compiler $num $axes"; done
    done
done >"$result.jobs"
for compiler in gcc clang; do
    echo "sh tests/house/lint.sh compiled_tools $compiler"
done >>"$result.jobs"
for folder in lib host-tools ports tests; do
    echo "sh tests/house/lint.sh broken $folder"
done >>"$result.jobs"
bash tests/house/beside.sh <"$result.jobs" | tee -a "$result"

passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
