#!/bin/bash
# tests/packages/cross.sh -- the command, built here for another architecture (arm64)
# SPDX-License-Identifier: MIT
row=cross
. tests/packages/row.sh
needs aarch64-linux-gnu-gcc qemu-aarch64

root=$top/build/sysroot/arm64
verdict "packages of arm64 are there: make deps-packages" [ -f "$root/complete" ]
tree=$work/loft-$(version)
unpacked() { make -s dist && tar -xzf "build/dist/loft-$(version).tar.gz" -C "$work"; }
verdict "sources unpacked as make dist packs them" unpacked
# pkg-config of a cross compiler looks at the packages of its architecture only
cat >"$work/pkg-config" <<END
#!/bin/sh
PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$root/usr/lib/aarch64-linux-gnu/pkgconfig:\
$root/usr/share/pkgconfig exec pkg-config "\$@"
END
chmod +x "$work/pkg-config"
built() {
    make -s -C "$tree" tools CC=aarch64-linux-gnu-gcc PKG_CONFIG="$work/pkg-config" \
        CFLAGS="--sysroot=$root"
}
verdict "make tools CC=aarch64-linux-gnu-gcc PKG_CONFIG=.. CFLAGS=--sysroot=.." built
foreign() { aarch64-linux-gnu-readelf -hd "$tree/build/loft" | grep -A99 AArch64 | grep cairo; }
verdict "it is a program for arm64, linked with libraries of arm64" foreign
there() { qemu-aarch64 -L "$root" "$tree/build/loft" "$@"; }
verdict "it says its version" there --version

# the same plan as the command of this machine
plans() {
    local n
    make -s tools || return 1
    for n in q16 f64; do
        build/loft plan tests/drawings/demo.svg --num "$n" --spans -o "$work/here" || return 1
        there plan tests/drawings/demo.svg --num "$n" --spans -o "$work/there" || return 1
        cmp "$work/here" "$work/there" || return 1
    done
}
verdict "demo.svg is planned to the same bytes in q16 and f64" plans
streams() {     # a whole job, both ends emulated
    there simulate --once --quiet --link "$work/machine" & local machine=$!
    appears "$work/machine"
    if echo 0,0,1,2,3,2,4,0 | timeout 900 qemu-aarch64 -L "$root" "$tree/build/loft" stream - \
        --port "$work/machine"; then
        wait $machine
    else                            # nothing is left running
        kill $machine
        wait $machine
        false
    fi
}
verdict "it streams to its own simulated machine" streams
ended
