#!/usr/bin/env python3
# tests/house/arrows.py -- the arrows between the files of host-tools/: upward ones and circles; and
# what only cmd/ may do
# SPDX-License-Identifier: MIT
# usage: tests/house/arrows.py ROOM.. ; in their order. Prints what is wrong, one line each
#
# An arrow goes from a file to each header that it includes, and to the file that defines what it
# uses, as the objects in build/tools say: a function that one room declares and another defines
# counts where it is defined, and is refused. It points to its own room or to one before it. Arrows
# of files go in no circle; a header and the source of its name are one file here.
#
# The rooms before cmd/ leave the terminal, the environment, signals and the end of the program to
# their caller, and keep nothing in variables of the file: two jobs in a program do not meet. They
# tell what is wrong to a host (base/host.h); tool_error and tool_host are for those that do not.
#
# What is not mended yet is in tests/house/arrows.txt, which only shrinks: `up FROM TO`, `circle
# FIRST FILE` for each file of the circle of FIRST, `call FILE FUNCTION`, `variable FILE NAME`,
# `declared FILE NAME`: by another room.
import re
import subprocess
import sys
from pathlib import Path

TOP = Path("host-tools")
LIST = Path("tests/house/arrows.txt")
BUILT = "build/tools/"
FOR_COMMANDS = set("exit _exit abort atexit stdout stderr printf vprintf puts putchar perror "
                   "getenv secure_getenv signal sigaction isatty sleep usleep nanosleep "
                   "tool_error tool_host".split())


def unit(path):
    return str(path.relative_to(TOP).with_suffix(""))


def symbols():
    """The source, the section and the name of each symbol. One number type stands for all three."""
    objects = [str(p) for top in ("", "q16/")
               for p in sorted(Path(BUILT + top + "host-tools").rglob("*.o"))
               if (p.relative_to(BUILT + top).with_suffix(".c")).is_file()]
    dump = subprocess.run(["objdump", "-t", *objects], capture_output=True, text=True, check=True)
    for line in dump.stdout.splitlines():
        if ": " in line and not line[0].isdigit():
            built = line.split(":")[0][len(BUILT):].removeprefix("q16/")
            source = Path(built).with_suffix(".c")
        elif re.match(r"[0-9a-f]{16} ", line) and line[23] in "O F" and "\t" in line:
            yield source, line[16:23], line[25:].split("\t")[0], line.split()[-1]


def read_files():
    """For each file its arrows, by includes and by definitions; and what it may not have."""
    arrows, home, used, kept = {}, {}, [], set()
    for p in sorted(TOP.rglob("*.[ch]")):
        includes = re.findall(r'^#\s*include "([^"]+)"', p.read_text(encoding="utf-8"), re.M)
        arrows[p] = {TOP / i for i in includes if (TOP / i).is_file()}
    for p, flags, section, symbol in symbols():
        if section == "*UND*":
            used.append((p, symbol))
        elif "g" in flags:
            home[symbol] = p
        if re.fullmatch(r"\.t?(data|bss)(\.local)?", section) and symbol[0] != ".":
            kept.add("variable %s %s" % (unit(p), symbol.split(".")[0]))
    for p, symbol in used:
        if symbol in home:
            arrows[p].add(home[symbol])
        if symbol in FOR_COMMANDS:
            kept.add("call %s %s" % (unit(p), re.sub("puts|putchar|vprintf", "printf", symbol)))
    of = declared()
    kept |= {"declared %s %s" % (unit(p), symbol) for symbol, p in home.items()
             if symbol in of and unit(p).split("/")[0] not in of[symbol]}
    return {p: {t for t in to if unit(t) != unit(p)} for p, to in arrows.items()}, kept


def declared():
    """For each external name, the rooms of the headers that declare it."""
    rooms = {}
    for p in sorted(TOP.rglob("*.h")):
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", p.read_text(encoding="utf-8"), flags=re.S)
        for m in re.finditer(r"^(?!static\b|typedef\b)[A-Za-z_][^;{}#]*;", text, re.M):
            head, call, _ = m.group().partition("(")
            for name in re.findall(r"(\w+)\s*[,;[(]", head + call):
                rooms.setdefault(name, set()).add(unit(p).split("/")[0])
    return rooms


def circles(graph):
    """The strongly connected parts of more than one file (Tarjan 1972), without recursion."""
    number, low, stack, on, found = {}, {}, [], set(), []
    for root in sorted(graph):
        work = [(root, iter(sorted(graph[root])))] if root not in number else []
        if work:
            number[root] = low[root] = len(number)
            stack.append(root), on.add(root)
        while work:
            node, rest = work[-1]
            step = next(rest, None)
            if step is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == number[node]:
                    part = []
                    while not part or part[-1] != node:
                        part.append(stack.pop())
                        on.discard(part[-1])
                    if len(part) > 1:
                        found.append(sorted(part))
            elif step not in number:
                number[step] = low[step] = len(number)
                stack.append(step), on.add(step)
                work.append((step, iter(sorted(graph[step]))))
            elif step in on:
                low[node] = min(low[node], number[step])
    return sorted(found)


def main(rooms):
    arrows, kept = read_files()
    rank = {room: i for i, room in enumerate(rooms)}
    wrong, graph = set(), {}
    for p, to in arrows.items():
        mine = graph.setdefault(unit(p), set())
        mine |= {unit(t) for t in to}
        here = rank.get(unit(p).split("/")[0])
        if here is None:
            print("%s: a room without a rank" % p)
            continue
        for t in to:
            if rank.get(unit(t).split("/")[0], here) > here:
                wrong.add("up %s %s" % (unit(p), unit(t)))
    wrong |= {k for k in kept
              if k.startswith("declared") or rank.get(k.split()[1].split("/")[0], 99) < rank["cmd"]}
    wrong |= {"circle %s %s" % (c[0], f) for c in circles(graph) for f in c}
    listed = {line for line in LIST.read_text().split("\n") if line and line[0] != "#"}
    for line in sorted(wrong - listed):
        print("%s: not here, see tests/house/arrows.py" % line)
    for line in sorted(listed - wrong):
        print("%s: %s: is mended: take it off the list" % (LIST, line))


main(sys.argv[1:])
