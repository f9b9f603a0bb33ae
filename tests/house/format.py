#!/usr/bin/env python3
"""tests/house/format.py -- break and indent the lines of C files as .clang-format says
SPDX-License-Identifier: MIT

usage: format.py [--check] FILE..
Within a line spaces stay as they are written, and so does the indentation of comments and of lists
in braces: tables and columns of comments are aligned by hand. Definitions of macros stay as well:
clang-format takes a list in braces for a block. With --check nothing is written, and what differs
is named.
"""
import difflib
import re
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


def listed(lines):
    """For each line: does it begin between the braces of a list, not of a block?"""
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'",
                  lambda m: re.sub(r"[^\n]", " ", m.group()), "\n".join(lines), flags=re.S)
    inside, before, found = [], "", []
    for line in text.split("\n"):
        found.append(bool(inside) and inside[-1] == "list")
        for c in line:
            if c in "([{":
                inside.append("list" if c == "{" and before in ("=", ",", "(", "{") or
                              c == "{" and before == ")" and "list" in inside else c)
            elif c in ")]}" and inside:
                inside.pop()
            before = c if c.strip() else before
    return found


def indented(line, like):
    """`line` with the indentation of `like`."""
    if not line.strip() or line.lstrip().startswith("*"):
        return line
    return like[:len(like) - len(like.lstrip())] + line.lstrip()


def formatted(path):
    old = open(path, encoding="utf-8").read().split("\n")
    new = subprocess.run(["clang-format", "--style=file", path], check=True,
                         capture_output=True, text=True).stdout.split("\n")
    out = []
    lists = listed(old)
    match = difflib.SequenceMatcher(None, [key(l) for l in old], [key(l) for l in new], False)
    for tag, a, b, c, d in match.get_opcodes():
        blank = not any(key(l) for l in old[a:b] + new[c:d])
        if tag == "equal":
            out += [old[k] if lists[k] or of_macro(old, k) else indented(old[k], new[c + k - a])
                    for k in range(a, b)]
            continue
        stays = blank or (of_macro(old, a) if a < b else of_macro(new, c))
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
