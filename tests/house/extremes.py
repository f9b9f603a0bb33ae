# tests/house/extremes.py -- what takes any number is tested with the extremes of its types
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/extremes.py ; prints a line for each function without such a test

A function whose `range` says "any" stands in a row EXTREMES(function, property, times) of a test
under tests/lib, of its own or together with those of its comment. A range of a whole header is not
one of a function.
"""
import glob
import re

COMMENT = re.compile(r"^/\*.*?\*/", re.S | re.M)
RANGE = re.compile(r"^(?:/\*| \*)  +range +(.*?)(?=^ \*  +[a-z]+   |^ \*$|\*/)", re.S | re.M)
FUNCTION = re.compile(r"^[a-z][\w ]*[ *](loft_\w+)\(", re.M)
TESTED = re.compile(r"^    EXTREMES\((loft_\w+),", re.M)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def main():
    tested = set()
    for path in glob.glob("tests/lib/**/test_*.c", recursive=True):
        tested.update(TESTED.findall(read(path)))
    known = set()
    for path in sorted(glob.glob("lib/**/*.h", recursive=True)):
        text = read(path)
        for comment in COMMENT.finditer(text):
            names = FUNCTION.findall(text[comment.end():].split("\n\n")[0])
            known.update(FUNCTION.findall(text))
            said = RANGE.search(comment.group())
            if said and re.search(r"\bany\b", said.group(1)) and not tested.intersection(names):
                for name in names[:1]:
                    print("%s:%d: %s takes any number: add a row EXTREMES(%s, ..) to its test"
                          % (path, text.count("\n", 0, comment.start()) + 1, name, name))
    for name in sorted(tested - known):
        print("tests/lib: EXTREMES(%s, ..): no header declares it: remove the row" % name)


if __name__ == "__main__":
    main()
