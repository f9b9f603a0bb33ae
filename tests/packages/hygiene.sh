#!/bin/bash
# tests/packages/hygiene.sh -- the same bytes from two folders, licences, parts, other systems
# SPDX-License-Identifier: MIT
# usage: tests/packages/hygiene.sh
row=hygiene
. tests/packages/row.sh
needs reuse clang musl-gcc sha256sum
copied() {      # the sources in two folders of another length
    for folder in one another/place; do
        mkdir -p "$work/$folder" && git ls-files -z --cached --others --exclude-standard |
            tar --null -T - -cf - | tar -xf - -C "$work/$folder" || return
    done
}
verdict "the sources in two folders" copied
licences() { reuse --root "$work/one" lint; }
verdict "reuse lint: every file has its licence" licences
# same TARGET FILE..: the same bytes in both; -O0, which changes no path in them
same() {
    local target=$1; shift
    for folder in one another/place; do
        make -s -C "$work/$folder" $target CFLAGS=-O0 CCACHE_DISABLE=1 >/dev/null &&
            (cd "$work/$folder" && sha256sum "$@") > "$work/$(basename $folder).sums" || return
    done
    cat "$work/one.sums"
    diff "$work/one.sums" "$work/place.sums"
}
verdict "make lib, with -g: the same bytes" same "lib NUM=q16" build/q16x3/libloft.a
verdict "libloft-f32.so: the same bytes" same build/f32x3/libloft-f32.so \
    build/f32x3/libloft-f32.so
verdict "make dist: the same bytes" same dist build/dist/SHA256SUMS
parts() {
    /usr/bin/python3 - build/dist <<'P'
import hashlib, json, os, sys, tarfile
name, = [f for f in os.listdir(sys.argv[1]) if f.endswith('.spdx.json')]
found = json.load(open(os.path.join(sys.argv[1], name)))
loft = found['packages'][0]
archive = os.path.join(sys.argv[1], loft['packageFileName'])
assert loft['checksums'][0]['checksumValue'] == \
    hashlib.sha256(open(archive, 'rb').read()).hexdigest()
with tarfile.open(archive) as tar:
    inside = {m.name.split('/', 1)[1]: m for m in tar if m.isfile()}
    listed = {f['fileName'][2:]: f['checksums'][1]['checksumValue'] for f in found['files']}
    assert set(inside) == set(listed), set(inside) ^ set(listed)
    for path, member in inside.items():
        assert hashlib.sha256(tar.extractfile(member).read()).hexdigest() == listed[path], path
ids = {'SPDXRef-DOCUMENT'} | {p['SPDXID'] for p in found['packages'] + found['files']}
for r in found['relationships']:
    assert r['spdxElementId'] in ids and r['relatedSpdxElement'] in ids, r
for key in ('spdxVersion', 'dataLicense', 'documentNamespace', 'creationInfo'):
    assert found[key]
P
}
made() { make -s dist && parts; }
verdict "SBOM (SPDX 2.3): lists each file of the archive with its checksum" made
versions() {    # nowhere else: the version stands in loft.h and in the change log
    ! git grep -nF "$(version)" -- . ':!CHANGELOG.md' ':!lib/loft.h' ':!*.csv' ':!*.svg' \
        ':!tests/drawings' | grep -E "version|VERSION|[^0-9.]$(version | sed 's/\./\\./g')[^0-9.]"
}
verdict "the version stands in lib/loft.h and CHANGELOG.md alone" versions
flags() {       # as distributions give them, on the command line
    make -s -n -B lib NUM=f64 CPPFLAGS=-DGIVEN CFLAGS=-O1 V=1 | grep ' -c ' |
        awk '!/-DGIVEN/ || !/-O1/ || !/-Ilib/ { exit 1 }'
}
verdict "CPPFLAGS and CFLAGS on the command line are heeded" flags
darwin() {      # objects of macOS: without its SDK, which Debian does not have
    python3 ports/packages/amalgam/amalgam.py --out "$work/c" &&
        for cpu in arm64 x86_64; do
            clang --target=$cpu-apple-macos11 -std=c99 -ffreestanding -Wall -Wextra -Werror -O0 \
                -c "$work/c/loft.c" -o "$work/c/$cpu.o" || return
        done
}
verdict "macOS, arm64 and x86_64: loft.c compiled by clang, not linked (no SDK here)" darwin
on_musl() {
    musl-gcc -std=c99 -O1 -c "$work/c/loft.c" -o "$work/c/loft.o" &&
        musl-gcc -std=c99 -O1 -static -I"$work/c" tests/packages/user.c "$work/c/loft.o" \
            -o "$work/c/user" && "$work/c/user"
}
verdict "musl: loft.c and a program, built statically and run" on_musl
tested() {
    for test in num bezier forward nurbs scurve drawing codec frame machine; do
        musl-gcc -std=c99 -O1 -static -Ilib -Itests "$(find tests/lib -name "test_$test.c")" \
            "$work/c/loft.o" -lm -o "$work/c/test" && LOFT_CASES=200 "$work/c/test" || return
    done
}
verdict "musl: nine tests of the library" tested
ended
