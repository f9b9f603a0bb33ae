# tests/house/stack.py -- measure the stack of every public function, per chip: lib/STACK.md
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/stack.py [write | names]

Without a word it compares with the page. write: puts what was measured into the page, and into the
`stack` lines of headers. names: only compares the names, without a cross compiler.

The frame of a function is what -fstack-usage says, that of the compiler's helpers what they push.
Its stack is its frame and the deepest of what it calls, by the relocations of the objects; lib/ has
no recursion, so this is a longest path. A pointer to a function that lib/ itself hands in is
followed; one that comes from outside adds "+ callback".
"""
import collections
import glob
import re
import subprocess
import sys

from headers import ROOMS, headers

PAGE, TAG = "lib/STACK.md", "_q16x3"
CHIPS = {"m4": "Cortex-M4", "m0plus": "Cortex-M0+", "atmega328p": "ATmega328P"}
CALLS = r"R_ARM_THM_(?:CALL|JUMP24|JUMP11|PC22)|R_AVR_CALL|R_AVR_13_PCREL"
TAKES = r"R_ARM_ABS32|R_AVR_(?:LO8|HI8)_LDI(?:_GS|_PM)?|R_AVR_16(?:_PM)?"
BOARDS = [("-nostdlib -T tests/target/netduino.ld -ffreestanding tests/target/microbit.c"
           " tests/target/semihost.S", "qemu-system-arm -M netduinoplus2 -nographic -monitor none"
           " -serial none -icount shift=0 -semihosting-config enable=on,target=native -kernel"),
          ("", "simavr -m atmega328p -f 16000000")]
NEAR, SHARE = 8, 2              # bytes, and of 100, by which a stack may differ from the page


def run(command):
    return subprocess.run(["sh", "-c", ". tests/target/targets.sh; " + command], check=True,
                          stdout=subprocess.PIPE, universal_newlines=True).stdout


def pushed(code, family):
    """Bytes that an instruction of a helper takes off the stack pointer."""
    found = re.search(r"\t(?:push|stmdb\tsp!,|vpush)[^{]*\{(.*)\}", code)
    if family == "arm" and found:
        size = 8 if "\td" in code or "{d" in code else 4
        ends = [[int(end.strip(" rd")) for end in part.split("-")] if "-" in part else [0, 0]
                for part in found[1].split(",")]
        return size * sum(last - first + 1 for first, last in ends)
    found = re.search(r"\tsub\tsp, (?:sp, )?#(\d+)|\[sp, #-(\d+)\]!", code)
    if family == "arm" and found:
        return int(found[1] or found[2])
    return 1 if family == "avr" and re.search(r"\tpush\t", code) else 0


class Chip:
    """frame, calls, tails, takes: of nodes, which are (object, function); indirect: those that call
    through a pointer"""

    def __init__(self, name):
        self.name, self.family = name, "avr" if name.startswith("at") else "arm"
        self.frame, self.places = {}, {}
        self.calls, self.tails, self.takes = (collections.defaultdict(set) for _ in range(3))
        self.indirect, self.written = set(), set()      # written: in assembly
        wrong = run("compile_lib %s q16 3" % name)
        if wrong:
            sys.exit(wrong + "0 passed, 1 failed")
        for path in sorted(glob.glob("build/cross/%s-%s/*.o" % (name, TAG[1:]))):
            if "/ports-" not in path or path.endswith("memory.o"):
                self.read(path, self.usage(path[:-1] + "su"))
        self.read(run("$(compiler %s) -print-libgcc-file-name" % name).strip(), None)
        self.resolve()

    @staticmethod
    def usage(path):
        """Of a .su file: {function: bytes}."""
        out = {}
        for line in open(path):
            place, size, _ = line.split("\t")
            function = place.split(":")[-1]
            out[function] = max(int(size), out.get(function, 0))
        return out

    def read(self, path, usage):
        """One object, or the members of an archive, of which each section is one function."""
        self.member, self.popped, node = path, [], None
        listing = run("$(binutil %s objdump) -tdr %s" % (self.name, path))
        for line in listing.split("\n"):
            found = re.match(r"(\S+\.o):\s+file format", line)
            if found:
                self.member = path if usage is not None else path + ":" + found[1]
            elif usage is None and re.match(r"[0-9a-f]{8} .{7} \.text", line):    # second names too
                section, function = line[17:].split()[0], line.split()[-1]
                self.places.setdefault(function, (self.member, section))
                self.places[self.member, function] = self.member, section
            elif line.startswith("Disassembly of section"):
                whole = (self.member, line.split()[-1].rstrip(":"))
            elif re.match(r"[0-9a-f]+ <.*>:$", line):
                function = line.split("<")[1][:-2]
                node = (self.member, function) if usage is not None else whole
                self.places.setdefault(function, node)
                self.places[self.member, function] = node
                self.popped = []
                if node not in self.frame:
                    self.frame[node] = self.start_of(function, usage)
                self.counted = usage is None or self.stem(function) not in usage
                self.written |= {node} if self.counted else set()
            elif node:
                self.read_code(line, node)

    @staticmethod
    def stem(function):
        return re.sub(r"(\.\d+)+$", "", function)

    def start_of(self, function, usage):
        """An AVR has pushed the address to return to."""
        return (usage or {}).get(self.stem(function), 2 if self.family == "avr" else 0)

    def read_code(self, line, node):
        found = re.search(r": (R_\w+)\s+(\S+)", line)
        if not found:
            self.code = line
            if self.counted:
                self.frame[node] += pushed(line, self.family)
            if not self.counted and self.is_indirect(line):
                self.indirect.add(node)
            return
        kind, behind = found[1], re.match(r" *([0-9a-f]+):.*\trcall", self.code)
        if behind and found[2].endswith("+0x%x" % (int(behind[1], 16) + 2)):
            self.frame[node] += 2 if self.counted else 0        # to the next line: takes two bytes
            return
        target = re.sub(r"[-+]0x.*", "", found[2])
        target = re.sub(r"^\.text\.(unlikely\.)?", "", target)
        if re.fullmatch(CALLS, kind):
            tail = kind.startswith("R_ARM_THM_JUMP") or re.search(r"\tr?jmp\t", self.code)
            (self.tails if tail else self.calls)[node].add(target)
        elif re.fullmatch(TAKES, kind):
            self.takes[node].add(target)

    def is_indirect(self, line):
        """A call through a register. What has popped it returns: a Cortex-M0 does so."""
        found = re.search(r"\tpop\t\{(.*)\}", line)
        if found:
            self.popped = found[1].split(", ")
        found = re.search(r"\t(?:blx\t(?:r\d+|ip|fp)|bx\t(r\d+|ip)|e?icall|e?ijmp)$", line.rstrip())
        return found and found[1] not in self.popped

    def resolve(self):
        """Names become nodes: of the same object first."""
        for edges in (self.calls, self.tails, self.takes):
            for node in list(edges):
                found = {self.places.get((node[0], name), self.places.get(name))
                         for name in edges[node]}
                if None in found and edges is not self.takes and node[0].startswith("build/"):
                    sys.exit("%s calls what is nowhere: %s" % (node, edges[node]))
                if edges is self.calls and node in found:
                    self.calls_itself(node)
                edges[node] = found - {None, node}

    def calls_itself(self, node):
        """A helper calls a part of itself, which calls no more; a function of lib/ may not."""
        if node not in self.written:
            sys.exit("%s: recursion" % (node,))
        self.frame[node] += 2 if self.family == "avr" else 0

    def reached(self, node):
        seen, left = {node}, [node]
        while left:
            here = left.pop()
            for to in self.calls[here] | self.tails[here]:
                if to not in seen:
                    seen.add(to)
                    left.append(to)
        return seen

    def stack(self, function):
        """Bytes, and whether a callback comes on top."""
        root = self.places[function + TAG]
        handed, within = collections.defaultdict(set), self.reached(root)
        while True:                 # what is handed in may itself reach and hand in more
            before = len(within)
            for taker in [n for n in within if self.takes[n]]:
                sites = self.reached(taker) & self.indirect
                for site in sites:      # there is no recursion: it is not handed to itself
                    handed[site] |= {f for f in self.takes[taker] if site not in self.reached(f)}
                for taken in self.takes[taker] if sites else ():
                    within |= self.reached(taken)
            if len(within) == before:
                break
        depth, on = {}, set()

        def deepest(node):
            if node in on:
                sys.exit("%s: recursion through %s" % (function, node))
            if node not in depth:
                on.add(node)
                inner = max(map(deepest, self.calls[node] | handed[node]), default=0)
                outer = max(map(deepest, self.tails[node]), default=0)
                depth[node] = max(self.frame[node] + inner, outer)
                on.discard(node)
            return depth[node]
        out = self.takes[root] - set().union(*handed.values())
        return Stack(deepest(root), any(n in self.indirect and not handed[n] for n in within),
                     max(map(deepest, out), default=0))


# bytes; whether a callback comes on top; bytes of a function that it hands out, for others to call
Stack = collections.namedtuple("Stack", "bytes callback handed")

HEAD = """# The stack of each function

Generated by `make stack`: change tests/house/stack.py, not this page. `make check-stack` measures
again, and fails where a number has changed by more than %d bytes and %d in a hundred.

Bytes below the stack pointer at the call, at the worst, with all that the function calls: q16,
three axes, -Os, gcc of Debian 12. On an AVR the address to return to is among them. `lib/` has no
recursion, no alloca and no arrays of variable length, so this is a bound, not a sample: `make
check-stack` also runs some of them on an emulated Cortex-M4 and compares. Interrupts come on top.

* *+ callback*: and that of the function that you gave (a surface, a memory, a line).
* *gives N*: it gives a structure with functions, of which the deepest takes N.
* -: there is no such function on that chip. Inline functions are a part of their caller.
* Another compiler, -O2 or another number of axes gives other numbers. Six axes need more of what
  keeps points; leave a quarter, or run `make stack` with your flags.

[COSTS.md](COSTS.md) has the flash, the RAM and the cycles.
"""


def measured():
    """{function: [Stack or None per chip]}, in the order of the headers."""
    chips = [Chip(name) for name in CHIPS]
    return {f.name: [c.stack(f.name) if f.name + TAG in c.places else None for c in chips]
            for h in headers() for f in h.functions if f.kind == "function"}


def cell(stack):
    if not stack:
        return "-"
    return ("{:,}".format(stack.bytes) + (" + callback" if stack.callback else "") +
            ("; gives {:,}".format(stack.handed) if stack.handed else ""))


def page(rows):
    out = [HEAD % (NEAR, SHARE)]
    for room in ROOMS:
        out.append("\n## " + room + "\n")
        for header in headers():
            functions = [f.name for f in header.functions if f.kind == "function"]
            if header.room == room and functions:
                out.append("\n### [%s](%s)\n\n| function | %s |\n|---|%s\n" % (
                    header.path, header.path, " | ".join(CHIPS.values()), "---|" * len(CHIPS)))
                out += ["| `%s` | %s |\n" % (name, " | ".join(map(cell, rows[name])))
                        for name in functions]
    return "".join(out)


def lines_of_headers(rows):
    """(path, number, line as it should be) of each `stack` line; by the deepest of its group."""
    for header in headers():
        for group in header.groups:
            if "stack" not in group.labels:
                continue
            found = [rows[f.name] for f in group.functions if f.kind == "function"]
            deepest = [max((r[k] for r in found if r[k]), default=None) for k in range(len(CHIPS))]
            parts = ["%s %s" % (name, cell(Stack(d.bytes, False, 0)))
                     for name, d in zip(CHIPS.values(), deepest) if d]
            parts += ["+ callback"] if any(d and d.callback for d in deepest) else []
            number = next(n for n in range(group.line - 1, len(header.lines))
                          if re.match(r" \*   stack ", header.lines[n]))
            end = " */" if header.lines[number].endswith("*/") else ""
            yield "lib/" + header.path, number, " *   stack   " + "   ".join(parts) + end


def numbers(text):
    return [int(n.replace(",", "")) for n in re.findall(r"(?<![\w+])\d[\d,]*(?!\w)", text)]


def near(said, now):
    """The same words, and numbers that are near."""
    old, new = numbers(said), numbers(now)
    words = re.sub(r"\d[\d,]*", "", said) == re.sub(r"\d[\d,]*", "", now)
    return (words and len(old) == len(new) and
            all(abs(a - b) <= max(NEAR, b * SHARE // 100) for a, b in zip(old, new)))


def seen():
    """(chip, function, bytes) of what runs on an emulated chip: see tests/target/stack.c"""
    for number, chip in enumerate(CHIPS):
        base = "build/stack/" + chip
        run("mkdir -p build/stack; $(compiler {0}) -std=c99 -Os -fno-common -Ilib -Itests/target"
            " -fstack-usage -c tests/target/stack.c -o {1}.o".format(chip, base))
        board, emulator = BOARDS[chip.startswith("at")]
        run("$(compiler {0}) -Os -Wl,--gc-sections {1}.o {2} $(ls build/cross/{0}{3}/*.o |"
            " grep -v /ports-) -lgcc -o {1}.elf".format(chip, base, board, TAG.replace("_", "-")))
        said = run("timeout 300 %s %s.elf 2>&1" % (emulator, base))
        frames = Chip.usage(base + ".su")
        for function, total in re.findall(r"^(?:\x1b\[\d+m)*(loft_\w+) (\d+)", said, flags=re.M):
            yield number, function, int(total) - frames["run_" + function]


def overrun(rows):
    """Functions that took more than their bound, and how many were seen."""
    wrong, count = [], 0
    for chip, function, bytes_ in seen():
        bound = rows[function][chip].bytes
        count += 1
        if not 0 < bytes_ <= bound:
            wrong.append("%s took %d bytes on a chip, its bound is %d" % (function, bytes_, bound))
    return wrong if count >= 31 else wrong + ["only %d functions ran on a chip" % count], count


def rows_of_page():
    text = open(PAGE, encoding="utf-8").read()
    return dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", text, flags=re.M))


def names():
    wanted = {f.name for h in headers() for f in h.functions if f.kind == "function"}
    for name in sorted(wanted ^ set(rows_of_page())):
        print("%s: %s" % (PAGE, name))


def check(rows):
    said, wrong = rows_of_page(), []
    for name, row in rows.items():
        now = " | ".join(map(cell, row))
        if not near(said.pop(name, "nothing"), now):
            wrong.append("%s: %s: look why, then make stack" % (name, now))
    wrong += ["%s: %s names it, and it is no function: make stack" % (name, PAGE) for name in said]
    for path, number, line in lines_of_headers(rows):
        was = open(path, encoding="utf-8").read().split("\n")[number]
        if not near(was, line):
            wrong.append("%s:%d: now %s: look why, then make stack" % (path, number + 1, line[13:]))
    more, count = overrun(rows)
    wrong += more
    print("".join("FAIL %s\n" % w for w in wrong) +
          "%d passed, %d failed" % (len(rows) + count - len(wrong), len(wrong)))
    return bool(wrong)


def write(rows):
    open(PAGE, "w", encoding="utf-8").write(page(rows))
    for path, number, line in lines_of_headers(rows):
        lines = open(path, encoding="utf-8").read().split("\n")
        if lines[number] != line:
            lines[number] = line
            open(path, "w", encoding="utf-8").write("\n".join(lines))


if __name__ == "__main__":
    if sys.argv[1:] == ["names"]:
        sys.exit(names())
    missing = run("missing_tools")
    if missing:
        sys.exit(missing + "0 passed, 1 failed")
    sys.exit(check(measured()) if sys.argv[1:] != ["write"] else write(measured()))
