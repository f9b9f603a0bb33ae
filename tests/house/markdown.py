# tests/house/markdown.py -- the Markdown of this house as HTML, for `make docs`
# SPDX-License-Identifier: MIT
"""Headings, paragraphs, lists, tables, fences, quotes, code, links, emphasis: no more is used."""
import html
import re


def anchor(title):
    """As GitHub names a heading."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title).replace("`", "").lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


class Page:
    """resolve(target) gives the address of a link, or None: then its text stands alone; named(text)
    gives that of a word in code"""

    def __init__(self, text, resolve, named):
        self.lines = text.split("\n")
        self.resolve, self.named = resolve, named
        self.headings, self.out = [], []

    def inline(self, text):
        parts = re.split(r"(`+)(.+?)\1", text)
        out = []
        for k in range(0, len(parts), 3):
            out.append(self.words(parts[k], parts, k))
        return re.sub("\x00(\\d+)\x00", lambda m: self.code(parts[int(m[1])]), "".join(out))

    def words(self, text, parts, k):
        """Text outside of code; what follows it in code is marked, so that links may enclose it."""
        out = html.escape(text, quote=False)
        return out + ("\x00%d\x00" % (k + 2) if k + 2 < len(parts) else "")

    def code(self, text):
        shown = html.escape(text, quote=False)
        where = self.named(text)
        return '<code><a href="%s">%s</a></code>' % (where, shown) if where \
            else "<code>%s</code>" % shown

    def linked(self, text):
        out = self.inline(text)

        def link(found):
            where = self.resolve(html.unescape(found[2]))
            inner = re.sub(r"</?a\b[^>]*>", "", found[1])
            return '<a href="%s">%s</a>' % (html.escape(where), inner) if where else inner
        out = re.sub(r"!?\[((?:[^][]|\[[^]]*\])*)\]\(([^)\s]+)\)", link, out)
        out = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", out)
        out = re.sub(r"(?<![\w\\*])\*([^*\s][^*]*?)\*(?![\w*])", r"<em>\1</em>", out)
        return re.sub(r"&lt;br&gt;", "<br>", re.sub(r"\\([*|<_\\])", r"\1", out)) \
            .replace("&amp;lt;", "&lt;").replace("&amp;amp;", "&amp;")

    def html(self):
        at = 0
        while at < len(self.lines):
            at = self.block(at)
        return "\n".join(self.out)

    def block(self, at):
        line = self.lines[at]
        heading = re.match(r"(#+) (.*)", line)
        if line.startswith("```"):
            end = next(n for n in range(at + 1, len(self.lines)) if self.lines[n].startswith("```"))
            self.out.append("<pre>%s</pre>" % html.escape("\n".join(self.lines[at + 1:end]), False))
            return end + 1
        if heading:
            name, level = anchor(heading[2]), len(heading[1])
            again = sum(re.sub(r"-\d+$", "", n) == name for _, n, _ in self.headings)
            name += "-%d" % again if again else ""
            self.headings.append((level, name, heading[2]))
            self.out.append('<h%d id="%s">%s</h%d>' % (level, name, self.linked(heading[2]), level))
            return at + 1
        if line.startswith("|"):
            return self.table(at)
        if re.match(r"( *)([*-]|\d+\.) ", line):
            return self.items(at, len(line) - len(line.lstrip()))
        if not line.strip():
            return at + 1
        end = at
        while end < len(self.lines) and self.lines[end].strip() and (end == at or not re.match(
                r"```|#+ |\||[*-] |\d+\. ", self.lines[end])):
            end += 1
        tag, text = "p", " ".join(self.lines[at:end])
        if line.startswith(">"):
            tag, text = "blockquote", re.sub(r"(^| )> ?", r"\1", text)
        self.out.append("<%s>%s</%s>" % (tag, self.linked(text), tag))
        return end

    def table(self, at):
        rows = []
        while at < len(self.lines) and self.lines[at].startswith("|"):
            cells = re.split(r"(?<!\\)\|", self.lines[at].strip().strip("|"))
            if not re.fullmatch(r"[\s|:-]+", self.lines[at]):
                rows.append([self.linked(c.strip()) for c in cells])
            at += 1
        tag = "th"
        self.out.append('<div class="wide"><table>')
        for row in rows:
            self.out.append("<tr>" + "".join("<%s>%s</%s>" % (tag, c, tag) for c in row) + "</tr>")
            tag = "td"
        self.out.append("</table></div>")
        return at

    def items(self, at, indent):
        ordered = re.match(r" *\d", self.lines[at])
        self.out.append("<ol>" if ordered else "<ul>")
        marker = re.compile(r" {%d}([*-]|\d+\.) +(.*)" % indent)
        while at < len(self.lines):
            found = marker.match(self.lines[at])
            if not found:
                break
            text, at, inner = found[2], at + 1, []
            while at < len(self.lines) and (self.lines[at].startswith(" " * (indent + 2)) or (
                    not self.lines[at].strip() and at + 1 < len(self.lines) and
                    self.lines[at + 1].startswith(" " * (indent + 2)))):
                inner.append(self.lines[at][indent + 2:])
                at += 1
            while inner and inner[0].strip() and not re.match(r" *([*-]|\d+\.) |```", inner[0]):
                text += " " + inner.pop(0).strip()
            self.out.append("<li>" + self.linked(text))
            if any(line.strip() for line in inner):
                page = Page("\n".join(inner), self.resolve, self.named)
                self.out.append(page.html())
            self.out.append("</li>")
            if at + 1 < len(self.lines) and not self.lines[at].strip() and marker.match(
                    self.lines[at + 1]):
                at += 1
        self.out.append("</ol>" if ordered else "</ul>")
        return at
