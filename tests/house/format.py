#!/usr/bin/env python3
"""tests/house/format.py -- break and indent the lines of C files as .clang-format says
SPDX-License-Identifier: MIT

usage: format.py [--check] FILE..
Lines that differ from clang-format's in spaces alone stay as they are written: tables and columns
of comments are aligned by hand. So do definitions of macros: clang-format takes a list in braces
for a block. With --check nothing is written, and what differs is named.
"""
import difflib
import subprocess
import sys


def key(line):
    """What a line is without its spaces and its last backslash."""
    return "".join(line.split()).rstrip("\\")


def of_macro(lines, at):
    """Does lines[at] belong to a #define?"""
    while at > 0 and lines[at - 1].endswith("\\"):
        at -= 1
    return at < len(lines) and lines[at].lstrip().startswith("#") and "define" in lines[at]


def formatted(path):
    old = open(path, encoding="utf-8").read().split("\n")
    new = subprocess.run(["clang-format", "--style=file", path], check=True,
                         capture_output=True, text=True).stdout.split("\n")
    out = []
    match = difflib.SequenceMatcher(None, [key(l) for l in old], [key(l) for l in new], False)
    for tag, a, b, c, d in match.get_opcodes():
        blank = not any(key(l) for l in old[a:b] + new[c:d])
        stays = tag == "equal" or blank or (of_macro(old, a) if a < b else of_macro(new, c))
        out += old[a:b] if stays else new[c:d]
    return old, out


def main(arguments):
    check = arguments[:1] == ["--check"]
    failed = 0
    for path in arguments[1 if check else 0:]:
        old, new = formatted(path)
        if old == new:
            continue
        failed = 1
        if check:
            at = next((k for k, (a, b) in enumerate(zip(old, new)) if a != b), len(new)) + 1
            print("%s:%d: is not broken as .clang-format says: run make format" % (path, at))
        else:
            with open(path, "w", encoding="utf-8") as out:
                out.write("\n".join(new))
    return failed if check else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
