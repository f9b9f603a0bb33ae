# tests/house/mutants.py -- small changes of a C file, each of which a test should see
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/mutants.py FILE.c ; prints them, `line: function: before -> after`

They are found on the syntax tree that clang prints as JSON: it says which operator, constant,
condition and statement a place is, and clang is there for lint anyway. libclang's Python bindings
and pycparser are packages more, and neither says the place of an operator. The text is changed, so
that the compiler which builds the library compiles them.
"""
import hashlib
import json
import re
import subprocess
import sys

SWAPS = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"],
         "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"],
         "*": ["/"], "/": ["*"], "%": ["*"], "<<": [">>"], ">>": ["<<"], "&": ["|"], "|": ["&"],
         "^": ["&"], "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="], "<<=": [">>="],
         ">>=": ["<<="], "&=": ["|="], "|=": ["&="]}
OTHER = {"least": "most", "most": "least", "min": "max", "max": "min"}
STATEMENTS = ("CallExpr", "CompoundAssignOperator", "BinaryOperator", "UnaryOperator")
BODIES = ("CompoundStmt", "IfStmt", "ForStmt", "WhileStmt", "DoStmt")
TABLE = 16                      # constants of a table: not of larger ones
BESIDE = 22                     # characters of context on each side


class Mutant:
    def __init__(self, text, path, function, at, end, new, kind):
        self.path, self.function, self.kind = path, function[0], kind
        self.at, self.end, self.new = at, end, new
        self.line = text.count("\n", 0, at) + 1
        old = text[at:end]
        start, stop = text.rfind("\n", 0, at) + 1, (text + "\n").find("\n", end)
        before, behind = text[max(start, at - BESIDE):at], text[end:min(stop, end + BESIDE)]
        if at - BESIDE > start:
            before = re.sub(r"^\w+", "", before)
        if end + BESIDE < stop:
            behind = re.sub(r"\w+$", "", behind)
        whole = kind == "deleted" or len(old) > 40
        shown = [squeeze(old)[:60], squeeze(new)[:60]] if whole else \
                [squeeze(before + part + behind) for part in (old, new)]
        self.name = "%s %s: %s -> %s" % (path[4:], self.function, shown[0],
                                         "nothing" if kind == "deleted" else shown[1])
        body = text[function[1]:function[2]]
        self.key = hashlib.sha1("\0".join([path, self.function, body, str(at - function[1]),
                                           str(end - at), new]).encode()).hexdigest()

    def apply(self, text):
        lines = text.count("\n", self.at, self.end) - self.new.count("\n")
        return text[:self.at] + self.new + "\n" * lines + text[self.end:]


def squeeze(text):
    return re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", "", text, flags=re.S)).strip()


def blanked(text):
    """The text, with blanks for its comments and strings."""
    return re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\n])*\"",
                  lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


class Finder:
    def __init__(self, path, tree):
        self.path = path
        self.bytes = open(path, "rb").read()
        self.text = self.bytes.decode("utf-8")
        self.ascii = len(self.text) == len(self.bytes)
        self.code = blanked(self.text)
        self.found, self.seen, self.function = [], set(), None
        for node in tree["inner"]:
            self.top(node)

    def offset(self, at):
        at = at.get("expansionLoc", at)
        where = at["offset"]
        return where if self.ascii else len(self.bytes[:where].decode("utf-8")), at["tokLen"]

    def span(self, node):
        """Where it begins and ends; None: it is inside of a macro."""
        begin, end = node["range"]["begin"], node["range"]["end"]
        if "offset" not in begin.get("expansionLoc", begin) or \
                "offset" not in end.get("expansionLoc", end):
            return None
        (at, long), (last, size) = self.offset(begin), self.offset(end)
        if "expansionLoc" in begin and "expansionLoc" in end and at == last and \
                node["kind"] != "DeclRefExpr":
            return None
        last += size
        if "expansionLoc" in end:
            rest = re.match(r"\s*\(", self.code[last:])
            if rest and node["kind"] != "DeclRefExpr":
                last = self.closed(last + rest.end())
        return at, last

    def closed(self, at):
        depth = 1
        while depth > 0 and at < len(self.code):
            depth += {"(": 1, ")": -1}.get(self.code[at], 0)
            at += 1
        return at

    def top(self, node):
        if "includedFrom" in json.dumps(node.get("loc", {})) or "inner" not in node:
            return
        body = [n for n in node["inner"] if n.get("kind") in ("CompoundStmt", "InitListExpr")]
        if node["kind"] not in ("FunctionDecl", "VarDecl") or not body:
            return
        at, size = self.offset(node["loc"])
        end = self.span(node)[1]
        self.function = (self.text[at:at + size], at, end)
        if node["kind"] == "FunctionDecl":
            self.visit(body[-1])
        elif len(re.findall(r"[\w.]+", self.code[at:end].split("=", 1)[-1])) <= TABLE:
            self.visit(body[-1])

    def add(self, at, end, new, kind):
        if (at, end, new) not in self.seen and self.text[at:end] != new:
            self.seen.add((at, end, new))
            self.found.append(Mutant(self.text, self.path, self.function, at, end, new, kind))

    def visit(self, node):
        kind, inner = node.get("kind"), node.get("inner", [])
        if kind in (None, "UnaryExprOrTypeTraitExpr", "StaticAssertDecl"):
            return
        if kind == "DeclStmt":
            for declared in inner:
                for part in declared.get("inner", []):
                    self.visit(part)
            return
        if not kind.endswith(("Attr", "Comment")) and "range" in node:
            self.change(node, kind, inner)
        for part in inner:
            self.visit(part)

    def change(self, node, kind, inner):
        span = self.span(node)
        if span is None:
            return
        if kind in BODIES:
            self.statements(kind, inner)
        if kind in ("IfStmt", "ConditionalOperator", "WhileStmt"):
            self.negate(inner[0])
        if kind in ("BinaryOperator", "CompoundAssignOperator"):
            self.operator(node["opcode"], inner)
        if kind == "IntegerLiteral":
            self.constant(*span)
        if kind == "UnaryOperator" and node["opcode"] in ("-", "!", "~"):
            if self.code[span[0]] == node["opcode"]:
                self.add(span[0], span[0] + 1, "", "sign")
        if kind == "CallExpr":
            self.extreme(inner[0])
        if kind == "ReturnStmt" and inner:
            self.returned(inner[0])

    def statements(self, kind, inner):
        parts = inner if kind == "CompoundStmt" else inner[:1] if kind == "DoStmt" else \
            inner[-1:] if kind in ("ForStmt", "WhileStmt") else inner[1:]
        for part in parts:
            call = part
            while call.get("kind") in ("CStyleCastExpr", "ParenExpr") and call.get("inner"):
                call = call["inner"][0]
            what = call.get("kind")
            written = what not in ("BinaryOperator", "UnaryOperator") or \
                call["opcode"] in ("=", "++", "--")
            jump = what in ("ContinueStmt", "BreakStmt") or \
                what == "ReturnStmt" and not call.get("inner")
            span = self.span(part) if "range" in part else None
            if span and (jump or what in STATEMENTS and written):
                self.add(*span, "(void)0", "deleted")

    def negate(self, condition):
        span = self.span(condition) if "range" in condition else None
        if span:
            self.add(*span, "!(%s)" % self.text[slice(*span)], "condition")

    def operator(self, opcode, inner):
        left, right = self.span(inner[0]), self.span(inner[1])
        if opcode not in SWAPS or not left or not right:
            return
        gap = self.code[left[1]:right[0]]
        at = left[1] + gap.find(opcode)
        if gap.replace("(", "").replace(")", "").strip() == opcode:
            for new in SWAPS[opcode]:
                self.add(at, at + len(opcode), new, "operator")

    def constant(self, at, end):
        found = re.fullmatch(r"(0[xX][0-9a-fA-F]+|0|[1-9]\d*)([uUlL]*)", self.text[at:end])
        if found:
            value = int(found.group(1), 0)
            for n in (value + 1, value - 1):
                self.add(at, end, "%d%s" % (n, found.group(2)), "constant")

    def extreme(self, called):
        span = self.span(called)
        name = self.text[slice(*span)] if span else ""
        found = re.fullmatch(r"(.*_)(least|most|min|max)", name)
        if found:
            self.add(*span, found.group(1) + OTHER[found.group(2)], "extreme")

    def returned(self, value):
        span = self.span(value)
        kind = value.get("type", {})
        kind = kind.get("desugaredQualType", kind.get("qualType", ""))
        if not span or "*" in kind or "struct" in kind or "loft_" in kind and "enum" not in kind:
            return
        old = self.text[slice(*span)]
        new = "!(%s)" % old if kind in ("bool", "_Bool") else "01"[old in ("0", "LOFT_OK")]
        self.add(*span, new, "return")


def find(path, flags):
    """The text of a file, and its mutants."""
    said = subprocess.run(["clang", "-std=c99", "-w", "-fsyntax-only", "-Xclang", "-ast-dump=json",
                           *flags, path], capture_output=True, check=True)
    finder = Finder(path, json.loads(said.stdout))
    return finder.text, finder.found


if __name__ == "__main__":
    for mutant in find(sys.argv[1], ["-Ilib", "-DLOFT_NUM=LOFT_Q16", "-DLOFT_AXES=3"])[1]:
        print("%d: %s" % (mutant.line, mutant.name))
