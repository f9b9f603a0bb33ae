#!/bin/bash
# tests/packages/meson.sh -- loft as a subproject of meson, from what make dist gives
# SPDX-License-Identifier: MIT
# usage: tests/packages/meson.sh
row=meson
. tests/packages/row.sh
needs meson ninja
given() { make -s dist; }
verdict "make dist: loft.wrap with the hash of the sources" given
mkdir -p "$work/user/subprojects"
cp -r build/dist/meson/. "$work/user/subprojects"
cp "build/dist/loft-$(version).tar.gz" "$work/user/subprojects/packagefiles"
cp tests/packages/user.c lib/examples/grid.c "$work/user"
said="64 points, 262144 -65536, loft $(version)"
cat > "$work/user/meson.build" <<'M'
project('user', 'c')
foreach num : ['q16', 'f32', 'f64']
    executable('user-' + num, 'user.c', dependencies: dependency('loft-' + num))
endforeach
executable('hill', 'grid.c', dependencies: dependency('loft-surfaces-q16'))
M
runs() {
    cd "$work/user" && meson setup build && ninja -C build || return
    for num in q16 f32 f64; do [ "$("build/user-$num")" = "$said" ] || return; done
    build/hill | grep -q '^  0.00  6.06  9.69'
}
verdict "dependency('loft-q16') .. by loft.wrap: built and run" runs
ended
