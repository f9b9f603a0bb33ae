#!/bin/bash
# tests/packages/wasm.sh -- the library for wasm32 without a libc, run by node
# SPDX-License-Identifier: MIT
# usage: tests/packages/wasm.sh
row=wasm
. tests/packages/row.sh
needs clang wasm-ld node
built() { make -s wasm; }
verdict "make wasm: clang --target=wasm32, no libc" built
cat > "$work/run.mjs" <<'J'
import { readFile } from 'node:fs/promises'
import { load } from '../../wasm/loft.mjs'
const bytes = await readFile(process.argv[2])
const module = new WebAssembly.Module(bytes)
const missing = WebAssembly.Module.imports(module)
if (missing.length)
    throw new Error(`asks for ${missing[0].name}`)
const functions = WebAssembly.Module.exports(module).filter(e => e.name.startsWith('loft_'))
if (functions.length < 500)
    throw new Error(`exports ${functions.length} functions`)
const loft = await load(bytes, process.argv[3])
const all = loft.bezier([[0, 0], [1, 2], [3, 2], [4, -1]]).walk(64)
let refused = false
try { loft.bezier([[0, 0], [1, 1]]).walk(0) } catch { refused = true }
const half = all[31], end = all[63]
if (!refused || all.length !== 64 || Math.abs(half[0] - 2) > 2 ** -16 ||
    Math.abs(half[1] - 1.375) > 2 ** -16 || end[0] !== 4 || end[1] !== -1)
    throw new Error(`${all.length} ${half} ${end} ${refused}`)
J
for num in q16 f32 f64; do
    verdict "$num: no imports, every function exported, a curve walked by node" \
        node "$work/run.mjs" "build/wasm/loft-$num.wasm" $num
done
# what a few functions take, beside the table of the page
selection() {   # selection BYTES FUNCTION..: within 1 %
    local said=$1 exports='' bytes
    shift
    for name in "$@"; do exports="$exports -Wl,--export=loft_${name}_q16x3"; done
    clang --target=wasm32 -std=c99 -Oz -ffreestanding -nostdlib -ffunction-sections \
        -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all $exports -Ilib \
        $(ls lib/num/*.c lib/geom/*.c lib/basis/*.c lib/curve/*.c lib/motion/scurve.c) \
        ports/bare/memory.c -o "$work/part.wasm" || return
    bytes=$(wc -c < "$work/part.wasm")
    echo "$bytes bytes, the page says $said"
    [ $((100 * (bytes > said ? bytes - said : said - bytes))) -le "$said" ]
}
while IFS='|' read -r _ functions said _; do
    verdict "$(echo $functions: $said) bytes" selection "$(echo "$said" | tr -d ' ,')" $functions
done < <(grep -E '^\| [a-z_ ]+ \| [0-9,]+ \|$' ports/wasm/README.md)
counted() { [ "$passed" -ge 7 ]; }
verdict "the page has three selections" counted
ls -l build/wasm/*.wasm | awk '{ print "     " $5 " bytes in " $9 }'
ended
