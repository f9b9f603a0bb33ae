# tests/house/reference.py -- the reference of lib/ as HTML and man pages, from its headers
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/reference.py FOLDER ; writes FOLDER/*.html and FOLDER/man/man3

A page for each header, for each page in Markdown and each example; lists by room, verb and noun.
All addresses are in one folder, so that it can be opened and moved as it is.
"""
import collections
import glob
import html
import json
import os
import re
import shutil
import sys

from headers import LABELS, ROOMS, headers
from markdown import Page, anchor
from stack import CHIPS, rows_of_page

HERE = os.path.dirname(os.path.abspath(__file__)) + "/reference/"
PLACES = ["*.md", "lib/**/*.md", "ports/**/*.md", "host-tools/*.md", "tests/*.md",
          "lib/examples/*.c"]
SAID = {"shape": "Shape", "units": "Units", "range": "Range", "error": "Error", "cost": "Cost",
        "stack": "Stack", "see": "Source"}
ROOM_IS = dict(re.findall(r"^\| `lib/(\w+)` \| (.*) \|$",
                          open("README.md", encoding="utf-8").read(), flags=re.M))


def escape(text):
    return html.escape(text, quote=False)


def address(path):
    """Of what stands in the repository: a header, a page, an example; None for anything else."""
    if path.startswith("lib/") and path.endswith(".h") and path.count("/") > 1:
        return path[4:-2].replace("/", "-") + ".html"
    if path.startswith("lib/examples/") and path.endswith(".c"):
        return "example-" + os.path.basename(path)[:-2] + ".html"
    if path.endswith(".md"):
        name = path[:-3] if not path.startswith("lib/") else os.path.basename(path)[:-3]
        return name.lower().replace("/", "-") + ".html"
    return None


def name_parts(name):
    """Noun and verb: loft_cubic_eval, loft_cubic_from_spline, loft_mul."""
    words = name[len("loft_"):].split("_")
    for verb in ("from", "to"):
        if verb in words[1:-1]:
            return "_".join(words[:words.index(verb, 1)]), verb
    return "_".join(words[:-1]) or words[0], words[-1]


class Reference:
    def __init__(self, folder):
        self.folder, self.files = folder, {}
        self.headers = headers()
        self.stacks = rows_of_page()
        self.where, self.what = {}, {}
        for h in self.headers:
            for g in h.groups:
                for d in g.declarations:
                    self.where[d.name] = "%s#%s" % (address("lib/" + h.path), d.name)
                    self.what[d.name] = self.sentence(h, g)
                    for name in re.findall(r"\bLOFT_\w+", d.text if d.kind == "enum" else ""):
                        self.where.setdefault(name, self.where[d.name])
        self.paths = {h.path: address("lib/" + h.path) for h in self.headers}
        self.short = collections.Counter(os.path.basename(path) for path in self.paths)
        listed = sorted(p for where in PLACES for p in glob.glob(where, recursive=True))
        self.sources = {p: open(p, encoding="utf-8").read() for p in listed}
        self.pages = {}
        self.uses = collections.defaultdict(list)       # name or header: (address, title)
        self.find_uses()

    @staticmethod
    def sentence(header, group):
        text = " ".join(" ".join(group.text).split()) or (group.section or header.title)
        found = re.match(r".*?[.:;](?= |$)", text)
        return (found[0] if found else text)[:160].strip()

    # --- who uses what
    def find_uses(self):
        for path, text in self.sources.items():
            if path.endswith(("ERRORS.md", "STACK.md", "CHANGELOG.md")):
                continue
            place, title = address(path), os.path.basename(path)
            if path.endswith(".c"):
                title = re.match(r"/\* \S+ -- (.*?)(?:\n \* SPDX|$)", text, flags=re.S)[1]
                title = os.path.basename(path) + ": " + " ".join(title.replace(" * ", "").split())
                self.note(set(re.findall(r"\bloft_\w+", text)), place, title)
                continue
            for part in re.split(r"\n(?=#+ )", text):
                heading = re.match(r"#+ (.*)", part)
                named = set(re.findall(r"\bloft_\w+|\b[a-z]+/[a-z0-9_/]+\.h\b", part))
                if heading:
                    self.note(named, place + "#" + anchor(heading[1]),
                              "%s: %s" % (title, re.sub(r"[`*]", "", heading[1])))
                if path == "lib/TEXTS.md":
                    self.note_texts(part, heading)

    def note(self, names, place, title):
        for name in sorted(names):
            if name in self.where or name in self.paths:
                self.uses[name].append((place, title))

    def note_texts(self, part, heading):
        """Rows of TEXTS.md: section, headers, commands, figures."""
        for row in re.findall(r"^\|(.*)\|(.*)\|(.*)\|(.*)\|$", part, flags=re.M):
            section, named, commands, figures = (cell.strip() for cell in row)
            for header in re.findall(r"`([\w/]+\.h)`", named):
                more = [c.strip("` ") for c in commands.split("` `") if c != "–"]
                more += ["loft figures " + f for f in figures.split(", ") if f != "–"]
                self.uses["text " + header].append(
                    ("texts.html#" + anchor(heading[1]), "%s, %s" % (heading[1], section), more))

    # --- text
    def named(self, word):
        found = re.match(r"(loft_\w+|LOFT_\w+)", word)
        if found and found[1] in self.where:
            return self.where[found[1]]
        if "lib/examples/" + word in self.sources:
            return address("lib/examples/" + word)
        word = word.replace("lib/", "")
        if self.short[word] == 1:
            return next(where for path, where in self.paths.items() if path.endswith("/" + word))
        return self.paths.get(word)

    def linked(self, text, own=None):
        """Escaped text of a comment: names of functions, structures and headers are links."""
        def link(found):
            where = self.named(found[0])
            return '<a href="%s">%s</a>' % (where, found[0]) if where and found[0] != own \
                else found[0]
        return re.sub(r"\b[a-z0-9_/]+\.h\b|\b(?:loft|LOFT)_\w+", link, escape(text))

    def prose(self, lines):
        """Paragraphs; lines that are indented stand as they are."""
        out, paragraph, code = [], [], []

        def end():
            if paragraph:
                out.append("<p>%s</p>" % re.sub(r"`([^`]+)`", r"<code>\1</code>",
                                                self.linked(" ".join(paragraph))))
            if code:
                while code and not code[-1].strip():
                    code.pop()
                margin = min(len(c) - len(c.lstrip()) for c in code if c.strip())
                out.append("<pre>%s</pre>" % self.linked("\n".join(c[margin:] for c in code)))
            paragraph.clear()
            code.clear()
        for line in lines:
            if line.startswith("  ") or (code and not line.strip()):
                if not code:
                    end()
                code.append(line)
            elif line.strip():
                if code:
                    end()
                paragraph.append(line.strip())
            else:
                end()
        end()
        return "\n".join(out)

    def said(self, label, text):
        text = " ".join(text.split()) if label == "see" else re.sub(r"\s*\n\s*", "\n", text)
        out = re.sub(r"(?:^|\n|   *)((?:q16|f32|f64)(?:, f\d\d)?:)",
                     r'<br><span class="num">\1</span>', self.linked(text)).replace("\n", " ")
        return re.sub(r"`([^`]+)`", r"<code>\1</code>", out[4:] if out.startswith("<br>") else out)

    # --- a header
    def stack_of(self, group):
        rows = [(f.name, self.stacks[f.name].split(" | ")) for f in group.functions
                if f.name in self.stacks]
        lines = ["%s%s" % (f"<code>{name}</code>: " if len(rows) > 1 else "", ", ".join(
            "%s %s" % (chip, size) for chip, size in zip(CHIPS.values(), sizes) if size != "-"))
                 for name, sizes in rows]
        return "<br>".join(lines)

    def labels(self, header, group):
        all_ = header.labels_of(group)
        rows = []
        for k in LABELS:
            if k == "stack" and group.functions:
                stack = self.stack_of(group)
                rows.append(("Stack", stack + " bytes" if stack else "inline: that of its caller"))
            elif k in all_:
                rows.append((SAID[k], self.said(k, all_[k])))
        shown = [line for line in header.intro if line.startswith("   ")]
        uses = sorted({u for f in group.declarations for u in self.uses[f.name]})
        links = ['<a href="%s">%s</a>' % (where, escape(title)) for where, title in uses
                 if where.split("#")[0] != address("lib/" + header.path)]
        examples = [l for l in links if 'href="example-' in l]
        rest = [l for l in links if l not in examples]
        if any(re.search(r"\b%s\b" % f.name, line) for f in group.functions for line in shown):
            examples.append('<a href="#use">above</a>')
        rows += [("Example", "<br>".join(examples))] if examples else []
        rows += [("Used in", "<br>".join(rest))] if rest else []
        return "<dl>%s</dl>" % "".join("<dt>%s</dt><dd>%s</dd>" % row for row in rows)

    def group(self, header, group):
        new = dict.fromkeys(d.name for d in group.declarations if d.name not in self.placed)
        names = "".join('<span id="%s"></span>' % name for name in new)
        self.placed |= set(new)
        code = "\n".join(d.text for d in group.declarations)
        shown = re.sub(r'<a href="[^"]*">(%s)</a>' % "|".join(
            re.escape(d.name) for d in group.declarations), r"<strong>\1</strong>",
                       self.linked(code))
        return '<section class="item">%s<pre>%s</pre>%s%s</section>' % (
            names, shown, self.prose(group.text), self.labels(header, group))

    def texts_of(self, header):
        rows = self.uses["text " + header.path]
        if not rows:
            return ""
        items = ['<li><a href="%s">%s</a>%s</li>' % (
            where, escape(title), "".join("; <code>%s</code>" % escape(m) for m in more))
                 for where, title, more in rows]
        return "<h2>In the texts</h2><ul>%s</ul>" % "".join(items)

    def header_page(self, header):
        self.placed = set()         # names that have their place: of two branches of #if, the first
        out = ["<h1>%s</h1>" % self.linked(header.title[:1].upper() + header.title[1:] + "."),
               '<pre>#include "%s"</pre>' % ("loft/surfaces.h" if header.room in (
                   "surface", "polygon", "toolpath") else "loft.h"),
               '<p class="faint">%s, of <a href="index.html#%s">lib/%s</a></p>' % (
                   header.path, header.room, header.room),
               self.names_of(f.name for f in header.functions),
               '<div id="use">%s</div>' % self.prose(header.intro)]
        whole = header.labels_of(header.groups[0])
        own = {k: v for k, v in header.groups[0].labels.items() if k in whole}
        if own:
            out.append("<dl>%s</dl>" % "".join("<dt>%s</dt><dd>%s</dd>" % (
                SAID[k], self.said(k, own[k])) for k in LABELS if k in own))
        section = None
        for group in header.groups[1:]:
            if group.section != section:
                section = group.section
                out.append('<h2 id="%s">%s</h2>' % (anchor("of " + section), escape(section)))
            if group.declarations:
                out.append(self.group(header, group))
            else:
                out.append(self.prose(group.text))
        out.append(self.texts_of(header))
        uses = ['<li><a href="%s">%s</a></li>' % (w, escape(t)) for w, t in self.uses[header.path]]
        if uses:
            out.append("<h2>Named in</h2><ul>%s</ul>" % "".join(uses))
        return "\n".join(out)

    def names_of(self, names):
        return '<ul class="names">%s</ul>' % "".join(
            '<li><a href="%s"><code>%s</code></a></li>' % (self.where[n], n) for n in names)

    # --- pages
    def add(self, name, title, body):
        self.files[name] = PAGE % {"title": escape(title), "body": body}

    def markdown_page(self, path, text):
        def resolve(target):
            if re.match(r"[a-z]+:", target):
                return target
            file, _, mark = target.partition("#")
            full = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if full == "lib/examples":
                return "index.html#examples"
            where = address(full) if full in self.sources or full[4:] in self.paths else None
            return where and where + ("#" + mark if mark else "")
        page = Page(text, resolve, self.named)
        self.add(address(path), path, page.html())
        self.pages[path] = page

    def lists(self):
        functions = [(f, h) for h in self.headers for f in h.functions]
        verbs, nouns = collections.defaultdict(list), collections.defaultdict(list)
        for f, _ in functions:
            noun, verb = name_parts(f.name)
            nouns[noun].append(f.name)
            verbs[verb].append(f.name)
        rare = sorted(n for v, names in verbs.items() if len(names) < 2 for n in names)
        self.list_page("verbs.html", "Functions by verb", dict(
            {v: n for v, n in verbs.items() if len(n) > 1}, **{"other verbs": rare}))
        self.list_page("nouns.html", "Functions by noun", nouns)
        self.list_page("interrupt.html", "Functions that are safe in an interrupt",
                       self.in_interrupt())
        types = collections.defaultdict(list)
        for h in self.headers:
            for g in h.groups:
                for d in g.declarations:
                    if not d.is_function:
                        types[{"enum": "Enumerations", "macro": "Constants and macros"}.get(
                            d.kind, "Structures and types")].append(d.name)
        self.list_page("types.html", "Structures, types and constants", types)

    def in_interrupt(self):
        out = collections.defaultdict(list)
        for h in self.headers:
            for g in h.groups:
                said = " ".join(" ".join([*h.labels_of(g).values(), *g.text]).split())
                if re.search(r"(safe|meant) (in|for) (an|the) (\w+ )?(ISR|interrupt)"
                             r"|in any context", said):
                    out["lib/" + h.room] += [f.name for f in g.functions]
        return {room: names for room, names in out.items() if names}

    def list_page(self, name, title, groups):
        jumps = " · ".join('<a href="#%s">%s</a>' % (anchor("of " + k), escape(k))
                           for k in sorted(groups))
        self.add(name, title, "<h1>%s</h1><p>%s</p>" % (title, jumps) + "".join(
            '<h2 id="%s">%s</h2>%s' % (anchor("of " + k), escape(k),
                                       self.names_of(sorted(set(groups[k]))))
            for k in sorted(groups)))

    def first_page(self):
        count = sum(len(h.functions) for h in self.headers)
        rooms = "".join(
            '<h2 id="%s">lib/%s</h2><p>%s</p><ul>%s</ul>' % (room, room, self.plain(
                ROOM_IS.get(room, "")), "".join(
                    '<li><a href="%s">%s</a>: %s</li>' % (self.paths[h.path], h.path,
                                                         escape(h.title))
                    for h in self.headers if h.room == room)) for room in ROOMS)
        pages = "".join('<li><a href="%s">%s</a></li>' % (address(p), escape(self.title_of(p)))
                        for p in sorted(self.sources) if p.endswith(".md"))
        examples = "".join('<li><a href="%s">%s</a></li>' % (address(p), os.path.basename(p))
                           for p in sorted(self.sources) if p.endswith(".c"))
        self.add("index.html", "Reference", FIRST % {
            "count": "{:,}".format(count), "rooms": rooms, "pages": pages, "examples": examples,
            "jumps": " · ".join('<a href="#%s">%s</a>' % (r, r) for r in ROOMS)})

    def plain(self, text):
        return Page("", lambda target: None, self.named).linked(text)

    def title_of(self, path):
        found = re.search(r"^# (.*)", self.sources[path], flags=re.M)
        return "%s: %s" % (path, found[1]) if found else path

    def index(self):
        rows = [[name, where, self.what.get(name, "")] for name, where in self.where.items()]
        rows += [[h.path, self.paths[h.path], h.title] for h in self.headers]
        for path, page in self.pages.items():
            if path in ("lib/RECIPES.md", "lib/GLOSSARY.md"):
                rows += [[re.sub("[`*]", "", title), address(path) + "#" + name,
                          os.path.basename(path)] for level, name, title in page.headings]
        self.files["index.js"] = '"use strict";\nconst names = [\n%s\n];\n' % ",\n".join(
            json.dumps(row, ensure_ascii=False) for row in rows)

    # --- man pages
    def man_page(self, header, group):
        first = group.functions[0].name
        names = ", ".join(f.name for f in group.functions)
        out = ['.TH %s 3 "" loft "loft"' % first.upper(), ".SH NAME",
               roff("%s - %s" % (names, self.sentence(header, group))), ".SH SYNOPSIS", ".nf",
               '#include "%s"' % ("loft/surfaces.h" if header.room in (
                   "surface", "polygon", "toolpath") else "loft.h"), ".PP"]
        out += [roff(f.text) for f in group.functions] + [".fi", ".SH DESCRIPTION"]
        for line in group.text:
            out.append(".PP" if not line.strip() else
                       ".nf\n%s\n.fi" % roff(line) if line.startswith("  ") else roff(line.strip()))
        labels = header.labels_of(group)
        for label in LABELS:
            if label in labels and label != "stack":
                out += [".SH " + SAID[label].upper(),
                        roff(" ".join(labels[label].split()))]
        rows = [f.name for f in group.functions if f.name in self.stacks]
        if rows:
            out += [".SH STACK", "Bytes at the worst, -Os, q16, three axes:", ".nf"] + [
                roff("%s: %s" % (n, ", ".join("%s %s" % pair for pair in zip(
                    CHIPS.values(), self.stacks[n].split(" | "))))) for n in rows] + [".fi"]
        out += [".SH HEADER", "lib/" + header.path]
        self.files["man/man3/%s.3" % first] = "\n".join(out) + "\n"
        for other in group.functions[1:]:
            self.files["man/man3/%s.3" % other.name] = ".so man3/%s.3\n" % first

    def write(self):
        for header in self.headers:
            self.add(self.paths[header.path], header.path, self.header_page(header))
            for group in header.groups:
                if group.functions:
                    self.man_page(header, group)
        for path, text in self.sources.items():
            if path.endswith(".md"):
                self.markdown_page(path, text)
            else:
                self.add(address(path), path, "<h1>%s</h1><pre>%s</pre>" % (
                    os.path.basename(path), self.linked(text)))
        self.lists()
        self.first_page()
        self.index()
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder + "/man/man3")
        for name, text in self.files.items():
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        for name in ("style.css", "search.js"):
            shutil.copy(HERE + name, self.folder)


def roff(text):
    return re.sub(r"(?m)^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>%(title)s - loft</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="style.css">
</head>
<body>
<header><b><a href="index.html">loft</a></b>
<form role="search" onsubmit="return false"><input type="search" placeholder="search: eval, nearest,
 cubic .." aria-label="search" autocomplete="off"><ul id="found"></ul></form>
<nav><a href="verbs.html">verbs</a> · <a href="nouns.html">nouns</a> ·
<a href="types.html">structures</a> · <a href="recipes.html">recipes</a> ·
<a href="errors.html">errors</a></nav></header>
<main>
%(body)s
</main>
<script src="index.js"></script>
<script src="search.js"></script>
</body>
</html>
"""

FIRST = """<h1>loft: reference</h1>
<p>Curves and surfaces for microcontrollers, from the drawing to the step pulse: %(count)s
functions, each with its shape, units, range, error, cost and stack, as the headers of
<code>lib/</code> state them. Press <code>/</code> to search.</p>
<ul><li><a href="recipes.html">I want to ..</a>: which functions for which task</li>
<li>functions by <a href="verbs.html">verb</a>, by <a href="nouns.html">noun</a>, by room below;
<a href="types.html">structures, types and constants</a></li>
<li><a href="contexts.html">threads and interrupts</a>:
<a href="interrupt.html">what an interrupt may call</a></li>
<li><a href="catalogue.html">what exists for which curve and patch</a>;
<a href="texts.html">the five texts, section by section</a></li>
<li><a href="errors.html">errors</a>, <a href="costs.html">cycles and bytes</a>,
<a href="stack.html">stack</a></li></ul>
<p>%(jumps)s</p>
%(rooms)s
<h2 id="examples">Examples</h2><ul class="names">%(examples)s</ul>
<h2 id="pages">Pages</h2><ul>%(pages)s</ul>
"""

if __name__ == "__main__":
    Reference(sys.argv[1]).write()
