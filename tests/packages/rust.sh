#!/bin/bash
# tests/packages/rust.sh -- the -sys crate with Debian's bindgen, cargo and rustc
# SPDX-License-Identifier: MIT
# usage: tests/packages/rust.sh
row=rust
. tests/packages/row.sh
PATH=/usr/bin:$PATH
needs bindgen cargo rustc pkg-config
installed() { make -s install-lib PREFIX="$work/root"; }
verdict "make install-lib" installed
cp -r ports/packages/rust/loft-sys "$work"
export PKG_CONFIG_PATH=$work/root/lib/pkgconfig LD_LIBRARY_PATH=$work/root/lib CARGO_HOME=$work/home
export RUSTC=/usr/bin/rustc
cd "$work/loft-sys" || exit
tested() {      # those of bindgen look at sizes and places of every field
    /usr/bin/cargo test --offline --target-dir "$work/target" > "$work/said" 2>&1 ||
        { cat "$work/said"; return 1; }
    awk '/^test result: ok/ { n += $4 } END { exit n < 100 }' "$work/said"
}
verdict "loft-sys: bindgen $(/usr/bin/bindgen --version | cut -d' ' -f2), rustc \
$(/usr/bin/rustc --version | cut -d' ' -f2): layouts of all structures, a walk: tested" tested
ended
