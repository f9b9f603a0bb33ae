# tests/house/loops.py -- each loop that a header prints stands in a test, word for word
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/loops.py ; prints a line for each loop that no test of lib/ runs

A loop is an indented example of a comment with for, while or do. The test says the same, but
  ..      may be any statements, or nothing
  64      may be another number or a name, and so may LOFT_REAL(0.01), LOFT_UNIT(0.5) and COUNT
"""
import glob
import re

TOKEN = re.compile(r"\.\.+|[A-Za-z_]\w*|\d[\w.]*|->|\+\+|--|<<|>>|[-+*/%&|=!<>]=|&&|\|\||\S")
LOOP = re.compile(r"\b(for|while)\s*\(|\bdo\s*\{")
NAME = r"(?:LOFT_(?:REAL|UNIT) \( -? ?[\d.]+ \)|\d[\w.]*|[A-Za-z_]\w*(?: (?:\.|->) [A-Za-z_]\w*)*)"


def words(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return TOKEN.findall(text)


def examples(path):
    """(line, text) of each indented part of a comment with a loop."""
    lines = open(path, encoding="utf-8").read().split("\n") + [""]
    part, first = [], 0
    for number, line in enumerate(lines, 1):
        if re.match(r" \*     +\S", line):
            first = first if part else number
            part.append(line[2:])
            continue
        text = "\n".join(part)
        if LOOP.search(re.sub(r"//[^\n]*", "", text)):
            yield first, text
        part = []


def pattern(text):
    """What a test may say: one expression over its words, with a blank behind each."""
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"((?<=, )-\d+|\bLOFT_(?:REAL|UNIT)\(-?[\d.]+\))", r" `\1` ", text)
    out = ""
    for number, part in enumerate(text.split("`")):
        if number % 2:
            out += "(?:%s |%s )" % (" ".join(map(re.escape, words(part))), NAME)
            continue
        for word in words(part):
            if word[:2] == "..":
                out += "(?:[^ ]+ ){0,200}?"
            elif word[0].isdigit() or re.fullmatch(r"(?!LOFT_)[A-Z][A-Z0-9_]+", word):
                out += "(?:%s|%s) " % (re.escape(word), NAME)
            else:
                out += re.escape(word) + " "
    return re.compile("(?<![^ ])" + out)


def main():
    tests = [" ".join(words(open(path, encoding="utf-8").read())) + " "
             for path in sorted(glob.glob("tests/lib/**/test_*.c", recursive=True))]
    for path in sorted(glob.glob("lib/**/*.h", recursive=True)):
        for line, text in examples(path):
            wanted = pattern(text)
            if not any(wanted.search(test) for test in tests):
                print("%s:%d: no test under tests/lib says this loop: %s"
                      % (path, line, " ".join(LOOP.search(text).string.split())[:40]))


if __name__ == "__main__":
    main()
