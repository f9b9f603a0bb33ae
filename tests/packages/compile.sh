#!/bin/bash
# tests/packages/compile.sh -- each form of the packages compiles, with what `make deps` installs
# SPDX-License-Identifier: MIT
# usage: tests/packages/compile.sh ; the rows of `make check-packages` build and run them all
row=compile
. tests/packages/row.sh
needs gcc g++ clang clang++ python3
amalgam() { python3 ports/packages/amalgam/amalgam.py "$@"; }
amalgam --out "$work/all" && amalgam --rooms curve --out "$work/curve" || exit
one=$work/all/loft.c two=$work/all/loft_surfaces.c

read_by() { "$@" -Wall -Wextra -Werror -fsyntax-only; }     # read_by COMPILER..: not a warning
for num in q16 f32 f64; do
    is="-DLOFT_NUM=$(macro $num)"
    verdict "loft.c as C99 by gcc, $num" read_by gcc -std=c99 -Wpedantic $is "$one"
    verdict "loft_surfaces.c as C99 by gcc, $num" read_by gcc -std=c99 -Wpedantic $is "$two"
    # designated initializers are an extension of C++ before C++20
    cplusplus="-std=gnu++11 -Wno-missing-field-initializers $is -x c++"
    verdict "loft.c as C++11 by g++, $num" read_by g++ $cplusplus "$one"
    verdict "loft_surfaces.c as C++11 by g++, $num" read_by g++ $cplusplus "$two"
    verdict "loft.c as C++11 by clang++, $num" \
        read_by clang++ -Wno-c99-designator $cplusplus "$one"
done
verdict "loft.c, loft_surfaces.c as C99 by clang" read_by clang -std=c99 -Wpedantic "$one" "$two"
verdict "loft.c, loft_surfaces.c as C++17 by g++" read_by g++ -std=gnu++17 \
    -Wno-missing-field-initializers -x c++ "$one" "$two"
verdict "loft.c, loft_surfaces.c for wasm32, without a libc" \
    read_by clang --target=wasm32 -std=c99 -ffreestanding "$one" "$two"
for compiler in g++ clang++; do
    verdict "loft.hpp as C++17 by $compiler" read_by $compiler -std=c++17 -Wpedantic -Ilib \
        -x c++ -include ports/packages/cpp/loft.hpp /dev/null
done
for sketch in ports/packages/arduino/examples/*/*.ino \
        ports/packages/arduino/surfaces/examples/*/*.ino; do
    verdict "$(basename "$sketch") as C++11" read_by g++ -std=gnu++11 -I"$work/all" \
        -Itests/packages/arduino/bare/arm/cores/bare -x c++ -include Arduino.h "$sketch"
done

# libloft alone, and libloft-surfaces above it: as archives, and as single files
patch_free() {  # neither names the other's functions: what libloft needs, it has
    ! nm -u build/q16x3/libloft.a | grep -wFf <(nm build/q16x3/libloft-surfaces.a 2>/dev/null |
        sed -n 's/^.* T //p') &&
        ! echo '#include "loft.h"' | gcc -Ilib -M -x c - | grep -E 'lib/(surface|polygon|toolpath)/'
}
verdict "libloft needs nothing of libloft-surfaces, loft.h no header of it" patch_free
says() {        # says LINE COMPILER ARGUMENT..: the program's last line
    local line=$1; shift
    "$@" -Wall -Wextra -Werror -o "$work/program" && [ "$("$work/program" | tail -1)" = "$line" ]
}
motion="1505 ticks, 10000 10000 steps"
awk '/^```c$/ { on = 1; next } /^```$/ { if (on) exit } on' README.md > "$work/motion.c"
hill='  0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00  0.00'
for compiler in "gcc -std=c99 -Wpedantic" "g++ -std=gnu++11 -Wno-missing-field-initializers -x c++"
do
    short=${compiler%% *}
    verdict "$short: a program of curves, from loft.h and libloft.a alone" \
        says "64 points, 262144 -65536, loft $(version)" $compiler -Ilib tests/packages/user.c \
            -x none build/q16x3/libloft.a
    verdict "$short: a program of patches, from loft/surfaces.h and both archives" \
        says "$hill" $compiler -Ilib lib/examples/grid.c -x none build/q16x3/libloft-surfaces.a \
            build/q16x3/libloft.a
done
for name in loft loft_surfaces; do gcc -std=c99 -c "$work/all/$name.c" -o "$work/$name.o"; done
verdict "a program of motion, from loft.h and libloft.a alone" \
    says "$motion" gcc -std=c99 -Ilib "$work/motion.c" build/q16x3/libloft.a
verdict "a program of motion, from loft.h and loft.c alone" \
    says "$motion" gcc -std=c99 -I"$work/all" "$work/motion.c" "$work/loft.o"
verdict "a program of patches, from both single files" \
    says "$hill" gcc -std=c99 -I"$work/all" lib/examples/grid.c "$work/loft_surfaces.o" \
        "$work/loft.o"
# programs of other frameworks, with the curves alone
gcc -std=c99 -c "$work/curve/loft.c" -o "$work/loft.o"
echo 'void app_main(void); int main(void) { app_main(); return 0; }' > "$work/main.c"
ends() {        # ends LINE FILE..: the program's last line
    local line=$1; shift
    gcc -std=c99 -Wall -Wextra -Werror -I"$work/curve" -Itests/packages/zephyr/include "$@" \
        "$work/loft.o" -o "$work/program" && [ "$("$work/program" | tail -1)" = "$line" ]
}
verdict "a program of somebody else" ends "64 points, 262144 -65536, loft $(version)" \
    tests/packages/user.c
verdict "ESP-IDF's example" ends "2621440 0" ports/packages/esp-idf/examples/walk/main/walk.c \
    "$work/main.c"
verdict "CMSIS's example" ends "2621440 0" ports/packages/cmsis/examples/walk/walk.c
verdict "Zephyr's sample" ends "2621440 0" ports/packages/zephyr/samples/walk/src/main.c

# the module of Python: its C code, and that each function it names is there
cat > "$work/cffi.py" <<'P'
import re
class FFI:
    def cdef(self, text):
        self.names = re.findall(r'\b(loft_\w+)\(', text)
    def set_source(self, name, source, **given):
        print(source, 'void asked(void);\nvoid asked(void)\n{')
        print(''.join(f'    (void){n};\n' for n in self.names) + '}')
P
python() {
    PYTHONPATH=$work python3 ports/packages/python/build_loft.py > "$work/python.c" &&
        read_by gcc -std=gnu99 -DLOFT_NUM=LOFT_F64 -I"$work/all" -Wno-unused-function \
            "$work/python.c"
}
verdict "Python's module, its C code" python
ended
