# tests/house/check_reference.py -- check the pages of `make docs`: links, names, what headers say
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/check_reference.py FOLDER ; the last line is `N passed, N failed`"""
import glob
import html.parser
import json
import os
import re
import shutil
import subprocess
import sys

from headers import LABELS, headers

VOID = {"meta", "link", "input", "br", "img", "hr"}


class Reader(html.parser.HTMLParser):
    """The names, links and text of a page; wrong: tags that do not match."""

    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.open, self.wrong, self.text = set(), [], [], [], []
        self.feed(open(path, encoding="utf-8").read())
        self.wrong += ["<%s> is not closed" % tag for tag in self.open]
        self.text = " ".join("".join(self.text).split())

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if "id" in attrs and attrs["id"] in self.ids:
            self.wrong.append("two places are named " + attrs["id"])
        self.ids.add(attrs.get("id"))
        self.links += [attrs[k] for k in ("href", "src") if k in attrs]
        if tag == "a" and "a" in self.open:
            self.wrong.append("a link in a link: %s" % attrs.get("href"))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.wrong.append("</%s> closes %s" % (tag, self.open[-1:]))
        else:
            self.open.pop()

    def handle_data(self, data):
        self.text.append(data)


def dead(name, link, pages, folder):
    if re.match(r"(https?|mailto|data):", link):
        return False
    file, _, mark = link.partition("#")
    file = file or name
    if not mark:
        return not os.path.exists(os.path.join(folder, file))
    return file not in pages or mark not in pages[file].ids


def of_headers(pages, folder):
    """What a header says stands on its page, in the index, and as a page of man."""
    index = open(folder + "/index.js", encoding="utf-8").read()
    known = {row[0]: row[1] for row in json.loads(index[index.index("["):].rstrip(";\n"))}
    for header in headers():
        name = header.path[:-2].replace("/", "-") + ".html"
        for group in header.groups:
            for d in group.declarations:
                if name not in pages or d.name not in pages[name].ids:
                    yield "%s: %s has no place in %s" % (header.path, d.name, name)
                if dead(name, known.get(d.name, "nowhere"), pages, folder):
                    yield "%s: %s cannot be searched for" % (header.path, d.name)
                if d.is_function and not os.path.exists("%s/man/man3/%s.3" % (folder, d.name)):
                    yield "%s: %s has no page of man" % (header.path, d.name)
            for label in LABELS:
                said = re.sub(r"\s", "", group.labels.get(label, "")).replace("`", "")
                if label != "stack" and said not in re.sub(r"\s", "", pages[name].text):
                    yield "%s:%d: its %s is not on the page" % (header.path, group.line, label)


def of_man(folder):
    """What the formatter of man pages warns of."""
    if not shutil.which("groff"):
        return []
    files = [f for f in glob.glob(folder + "/man/man3/*.3")
             if not open(f, encoding="utf-8").read().startswith(".so")]
    said = subprocess.run(["groff", "-Kutf8", "-man", "-ww", "-z"] + files, check=False,
                          stderr=subprocess.PIPE, universal_newlines=True).stderr
    return said.split("\n")[:-1]


def main(folder):
    pages = {os.path.basename(f): Reader(f) for f in glob.glob(folder + "/*.html")}
    wrong, links = [], 0
    for name, page in sorted(pages.items()):
        wrong += ["%s: %s" % (name, w) for w in page.wrong]
        links += len(page.links)
        wrong += ["%s: leads nowhere: %s" % (name, link) for link in sorted(set(page.links))
                  if dead(name, link, pages, folder)]
    wrong += list(of_headers(pages, folder)) + of_man(folder)
    if len(pages) < 200 or links < 10000:
        wrong.append("only %d pages with %d links" % (len(pages), links))
    print("".join("FAIL %s\n" % w for w in wrong) +
          "%d passed, %d failed" % (links - len(wrong), len(wrong)))
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
