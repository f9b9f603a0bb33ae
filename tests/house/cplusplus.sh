#!/bin/sh
# tests/house/cplusplus.sh -- loft.h in C++11 to C++20: no warning, each header alone as well;
# every function links with the C library
# SPDX-License-Identifier: MIT
# usage: tests/house/cplusplus.sh BUILD ; libloft.a and libloft-surfaces.a of BUILD/{q16,f32,f64}x3
# must exist
set -u
build=$1 work=$1/cplusplus
result=$work/result
given="${CPPFLAGS:-} ${CXXFLAGS:-}"
mkdir -p "$work"
: > "$result"
verdict() {     # verdict NAME COMMAND..: is the command true?
    name=$1; shift
    if "$@" 2> "$work/log"; then echo "ok   c++ $name"
    else echo "FAIL c++ $name"; head -5 "$work/log" | sed 's/^/     /'; fi | tee -a "$result"
}

# num.h takes one of these
headers=$(find lib -name '*.h' | LC_ALL=C sort |
    grep -v -e num/q16.h -e num/f32.h -e num/f64.h -e num/floats.h -e num/avr.h)

# program NUM (q16): asks for every function of lib/ by its C++ declaration, and evaluates a cubic
program() {
    for header in $headers; do echo "#include \"${header#lib/}\""; done > "$work/headers.h"
    cat "$work/headers.h"
    echo 'typedef void (*any)();'
    echo 'extern const any all[];'
    echo 'const any all[] = {'
    g++ -E -P -Ilib $given -DLOFT_NUM="$(macro $1)" -x c++ "$work/headers.h" |
        sed -n "/^static\|^typedef/d
                s/^[a-z][A-Za-z0-9_ ]*[ *]\(loft_[a-z0-9_]*\)_$1x3(.*/reinterpret_cast<any>(\1),/p"
    cat <<'MAIN'
};
int main()
{
    static const loft_vec p[4] = { { { LOFT_REAL(0) } }, { { LOFT_REAL(1) } },
                                   { { LOFT_REAL(2) } }, { { LOFT_REAL(3) } } };
    loft_bezier s;
    unsigned missing = 0, given = 0;
    for (const any *f = all; f < all + sizeof all / sizeof *all; f++, given++)
        missing += *f == nullptr;
    return given > 500 && missing == 0 && loft_bezier_init(&s, p, 3) == LOFT_OK &&
           loft_bezier_eval(&s, LOFT_UNIT(0.5)).axis[0] == LOFT_REAL(1.5) ? 0 : 1;
}
MAIN
}
macro() { echo "LOFT_$(echo "$1" | tr a-z A-Z)"; }
compiles() {    # compiles COMPILER STANDARD NUM FILE..
    compiler=$1 standard=$2 num=$3; shift 3
    $compiler -std=c++$standard -Wall -Wextra -Wpedantic -Werror -Ilib $given \
        -DLOFT_NUM="$(macro $num)" -fsyntax-only -x c++ "$@"
}
runs() {        # runs COMPILER NUM FOLDER
    $1 -std=c++11 -Wall -Wextra -Wpedantic -Werror -Ilib $given ${LDFLAGS:-} \
        -DLOFT_NUM="$(macro $2)" \
        "$work/$2.cpp" "$3/libloft-surfaces.a" "$3/libloft.a" -o "$work/$2" && "$work/$2"
}

echo '#include "loft/surfaces.h"' > "$work/loft.cpp"
for num in q16 f32 f64; do program $num > "$work/$num.cpp"; done
for compiler in g++ clang++; do
    for num in q16 f32 f64; do
        for standard in 11 14 17 20; do
            verdict "$compiler c++$standard $num: loft.h without a warning" \
                compiles $compiler $standard $num "$work/loft.cpp"
        done
        verdict "$compiler $num: every function links, and a cubic is evaluated" \
            runs $compiler $num "$build/${num}x3"
    done
done
mkdir -p "$work/alone"
for header in $headers; do
    printf '#include "%s"\n' "${header#lib/}" > "$work/alone/$(echo "${header#lib/}" | tr / -).cpp"
done
verdict "each header alone" compiles clang++ 11 f64 "$work/alone"/*.cpp

passed=$(grep -c '^ok' "$result")
failed=$(grep -c '^FAIL' "$result")
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
