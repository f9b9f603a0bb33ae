# tests/target/cycles.awk -- cycles of a function on a Cortex-M0 or M4, by the manuals' tables
# SPDX-License-Identifier: MIT
# usage: awk -v core=cortex-m0 -v entry=SYMBOL -v first=ITS-ADDRESS -f cycles.awk DISASSEMBLY TRACE
# DISASSEMBLY is by objdump -d, TRACE by QEMU: a line for each instruction, in the function and in
# those that it calls. Prints those of the dearest call, with the branch to it. ARM DDI 0432C and
# DDI 0439B, tables 3-1, without wait states: a load or store 2, of two words 3, of a list 1 and one
# for each register, a taken branch 3 (M0: with link 4), a load of the program counter 2 more (M0:
# 3); all else 1. No real chip was measured.
BEGIN { m0 = core == "cortex-m0" }

FNR == NR {
    if (match($0, /^ *[0-9a-f]+:\t/)) {
        n = split($0, part, "\t")
        address = part[1]; gsub(/[ :]/, "", address)
        bytes[address] = length(part[2]) - gsub(/ /, "", part[2]) > 4 ? 4 : 2
        kind[address] = part[3]; sub(/\.[nw]$/, "", kind[address])
        list[address] = n > 3 ? part[4] : ""
    }
    next
}

# by the address after it, which says whether a branch was taken
function cost(at, after,    name, pc, words) {
    name = kind[at]; pc = list[at] ~ /pc/
    if (name ~ /^(push|pop|ldm|stm)/) {
        words = list[at]; sub(/.*{/, "", words)
        return 1 + gsub(/,/, "", words) + 1 + (pc ? (m0 ? 3 : 2) : 0)
    }
    if (name ~ /^(ldrd|strd)/) return 3
    if (name ~ /^(ldr|str)/) return 2 + (pc && name == "ldr" && list[at] ~ /^pc/ ? 2 : 0)
    if (name ~ /^(bl|blx)$/) return m0 ? 4 : 3
    if (name ~ /^(b[a-z][a-z]|b|bx|cbn?z)$/ && name !~ /^(bic|bfi|bfc)/)
        return hex(after) == hex(at) + bytes[at] ? 1 : 3
    return 1
}

function hex(s,    n, k) {
    for (k = 1; k <= length(s); k++) n = 16 * n + index("0123456789abcdef", substr(s, k, 1)) - 1
    return n
}

function enter(after) {
    if (inside) call += cost(last, after)
    if (inside && name == entry && (kind[last] == "bx" || list[last] ~ /pc}/)) {
        worst = call > worst ? call : worst
        inside = 0
    }
}

/^Trace/ {
    split($0, part, "/")
    here = part[2]; sub(/^0+/, "", here)
    enter(here)
    if (here == first) { inside = 1; call = m0 ? 4 : 3 }
    last = here; name = $NF
}

END { enter(""); print worst }
