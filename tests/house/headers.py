# tests/house/headers.py -- read the headers of lib/: functions, structures, what is said of them
# SPDX-License-Identifier: MIT
"""What errors.py, stack.py and reference.py share.

A header begins with a comment: its title and its introduction. Then come sections, each a line of
text over a line of dashes, and groups: a comment and the declarations below it, up to an empty
line. A comment is text, then labelled lines: shape, units, range, error, cost, stack, see.
"""
import glob
import os
import re

ROOMS = "num geom basis curve kinematics path motion wire machine surface polygon toolpath".split()
LABELS = "shape units range error cost stack see".split()
LABELLED = re.compile(r"^ {2,4}(%s) +(.*)" % "|".join(LABELS))
FUNCTION = re.compile(r"^(?!typedef)[a-z][A-Za-z0-9_ ]*[ *](loft_[a-z0-9_]*)\(")


class Declaration:
    """kind: function, inline, type, enum, macro, object; text as it stands, without its body"""

    def __init__(self, kind, name, text, line):
        self.kind, self.name, self.text, self.line = kind, name, text, line

    @property
    def is_function(self):
        return self.kind in ("function", "inline")


class Group:
    """text: lines above the labels; labels: {label: text of lines}; declarations"""

    def __init__(self, section, lines, line):
        self.section, self.line, self.declarations = section, line, []
        self.text, self.labels = [], {}
        label = None
        for number, said in enumerate(lines):
            found = LABELLED.match(said)
            if found:
                label = found[1]
                before = self.labels.get(label)
                self.labels[label] = (before + "\n" if before else "") + found[2]
            elif label and said.startswith("    "):
                self.labels[label] += "\n" + said
            else:
                label = None
                self.text.append(said)
        while self.text and not self.text[-1].strip():
            self.text.pop()

    @property
    def functions(self):
        return [d for d in self.declarations if d.is_function]


class Header:
    def __init__(self, path):
        self.path = path[len("lib/"):]              # as it is included
        self.room = self.path.split("/")[0]
        self.title, self.intro, self.groups = "", [], []
        self.lines = open(path, encoding="utf-8").read().split("\n")
        self.read()

    @property
    def functions(self):
        return [f for g in self.groups for f in g.functions]

    def labels_of(self, group):
        """Those of the group; else those of its section, or of the whole header."""
        whole = {}
        for wide in self.groups:
            if not wide.functions and wide.section in (None, group.section):
                whole.update(wide.labels)
        return {**whole, **group.labels}

    def read(self):
        number = self.read_first(0)
        section, group = None, None
        while number < len(self.lines):
            line = self.lines[number]
            if line.startswith("/*"):
                said, first, number = self.read_comment(number)
                at = next((k for k, l in enumerate(said) if re.fullmatch(r" *-+ *", l)), None)
                if at:
                    section, said = said[at - 1].strip(), said[at + 1:]
                group = Group(section, said, first)
                self.groups.append(group)
                continue
            if line.startswith("// ") and re.match(r"// -+$", self.lines[number + 1]):
                section, number = line[3:].strip(), number + 1
                group = Group(section, [], number)
                self.groups.append(group)
            elif not line.strip():
                group = None
            else:
                declared, number = self.read_declaration(number)
                if declared:
                    if group is None:
                        group = Group(section, [], declared.line)
                        self.groups.append(group)
                    group.declarations.append(declared)
                continue
            number += 1

    def read_comment(self, number):
        first, said = number + 1, []
        while True:
            line = self.lines[number]
            said.append(re.sub(r"[ \t]*\*/[ \t]*$", "", line)[2:].rstrip())
            number += 1
            if "*/" in line:
                return said, first, number

    def read_first(self, number):
        said, _, number = self.read_comment(number)
        at = next(k for k, line in enumerate(said) if "SPDX" in line)
        self.title = " ".join(line.strip() for line in said[:at]).partition(" -- ")[2]
        self.groups.append(Group(None, said[at + 1:], 1))
        self.intro = self.groups[0].text
        return number

    def read_declaration(self, number):
        """The declaration that begins at this line, or None; and the line behind it."""
        first, line = number, self.lines[number]
        if line.startswith("#"):
            text = line
            while text.endswith("\\") or text.count("/*") > text.count("*/"):
                number += 1
                text += "\n" + self.lines[number]
            found = re.match(r"# *define (LOFT_\w+)", text)
            guard = found and found[1].endswith("_H") and found[1] == text.split()[-1]
            return (Declaration("macro", found[1], text, first + 1)
                    if found and not guard else None), number + 1
        if not re.match(r"[a-z]", line):
            return None, number + 1
        text, depth = [], 0
        while number < len(self.lines):
            line = self.lines[number]
            text.append(line)
            code = re.sub(r"/\*.*?\*/|//.*|'.'", "", line)
            depth += code.count("{") - code.count("}")
            number += 1
            if depth == 0 and re.search(r"[;}]\s*(/\*.*)?$", line.rstrip()):
                break
        # a comment that a last line has begun
        while text[-1].count("/*") > text[-1].count("*/") and number < len(self.lines):
            text.append(self.lines[number])
            number += 1
        return self.named("\n".join(text), first + 1), number

    @staticmethod
    def named(text, line):
        found = FUNCTION.match(text)
        if found:
            kind = "inline" if text.startswith("static") else "function"
            return Declaration(kind, found[1], re.sub(r"\s*\{.*", "", text, flags=re.S), line)
        found = (re.match(r"typedef\b.*\b(loft_\w+)(\[[^;]*\])?;[^;]*$", text, flags=re.S) or
                 re.match(r"typedef\b[^;]*\(\*(loft_\w+)\)", text))
        if found:
            return Declaration("type", found[1], text, line)
        found = re.match(r"(struct|enum) (loft_\w+)", text)
        if found:
            return Declaration("enum" if found[1] == "enum" else "type", found[2], text, line)
        found = re.match(r"extern [^;]*\b(loft_\w+)", text)
        return Declaration("object", found[1], text, line) if found else None


def headers():
    """All of lib/, room by room."""
    out = []
    for room in ROOMS:
        out += [Header(path) for path in sorted(
            glob.glob("lib/%s/**/*.h" % room, recursive=True),
            key=lambda path: os.fsencode(path))]
    return out
