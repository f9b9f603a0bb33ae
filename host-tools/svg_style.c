/* host-tools/svg_style.c -- properties: from attributes, style="" and the style sheets of the file
 * SPDX-License-Identifier: MIT
 *
 * What a plotter needs of CSS: which elements are hidden or not painted, dashes, and transforms. Selectors are lists of simple ones, such as
 * `g`, `.st0`, `#title`, `path.a.b`, `*`; others are passed over, with a warning if they would hide or move something.
 */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "svg.h"
#include "tool.h"       /* tool_grow */

typedef struct {
    char *selector, *declarations;
    unsigned weight;                    /* ids * 10000 + classes * 100 + types; of equals, the later rule wins */
} rule;

struct svg_sheet {
    rule *rules;
    size_t count;
};

static const char blank[] = " \t\r\n\f";

char *svg_attribute(const xmlNode *node, const char *name)
{
    return (char *)xmlGetNoNsProp(node, (const xmlChar *)name);
}

/* The value of `name` in `a: b; c: d`: the last one, or a !important one. NULL if there is none. */
static char *declared(const char *text, const char *name, bool *important)
{
    const size_t length = strlen(name);
    char *found = NULL;

    *important = false;
    while (*text != '\0') {
        text += strspn(text, " \t\r\n\f;");
        const size_t all = strcspn(text, ";"), colon = strcspn(text, ":;");
        const size_t word = strcspn(text, " \t\r\n\f:;");
        if (word == length && strncasecmp(text, name, length) == 0 && text[colon] == ':') {
            const char *value = text + colon + 1;
            value += strspn(value, blank);
            size_t size = value < text + all ? (size_t)(text + all - value) : 0;
            const char *bang = memchr(value, '!', size);
            if (bang != NULL || !*important) {
                size = bang ? (size_t)(bang - value) : size;
                while (size > 0 && strchr(blank, value[size - 1]))
                    size--;
                xmlFree(found);
                found = (char *)xmlStrndup((const xmlChar *)value, (int)size);
                *important = bang != NULL;
            }
        }
        text += all;
    }
    return found;
}


// Selectors
// ---------

static bool in_list(const char *list, const char *word, size_t length)
{
    while (list != NULL && *list != '\0') {
        list += strspn(list, blank);
        const size_t size = strcspn(list, blank);
        if (size == length && size > 0 && strncmp(list, word, size) == 0)
            return true;
        list += size;
    }
    return false;
}

/* Does the compound selector fit the element? */
static bool fits(const char *s, const xmlNode *node)
{
    bool good = true;
    char *class = svg_attribute(node, "class"), *id = svg_attribute(node, "id");

    while (good && *s != '\0') {
        const char kind = *s;
        s += kind == '.' || kind == '#';
        const size_t length = strcspn(s, ".#");
        if (kind == '.')
            good = in_list(class, s, length);
        else if (kind == '#')
            good = id != NULL && strlen(id) == length && strncmp(id, s, length) == 0;
        else
            good = (length == 1 && *s == '*') || (strlen((const char *)node->name) == length && strncmp((const char *)node->name, s, length) == 0);
        s += length;
    }
    xmlFree(class);
    xmlFree(id);
    return good;
}

char *svg_property(const svg_reader *r, const char *name)
{
    const svg_sheet *sheet = r->sheet;
    bool important = false, strong = false;
    char *style = svg_attribute(r->node, "style"), *own = style ? declared(style, name, &important) : NULL, *best = NULL;
    unsigned weight = 0;

    xmlFree(style);
    for (size_t i = 0; sheet != NULL && i < sheet->count; i++) {
        const rule *u = &sheet->rules[i];
        if (!fits(u->selector, r->node))
            continue;
        bool loud;
        char *value = declared(u->declarations, name, &loud);
        if (value != NULL && (best == NULL || loud > strong || (loud == strong && u->weight >= weight))) {
            xmlFree(best);
            best = value;
            strong = loud;
            weight = u->weight;
        } else {
            xmlFree(value);
        }
    }
    if (own != NULL && (best == NULL || important || !strong)) {
        xmlFree(best);
        return own;
    }
    xmlFree(own);
    return best ? best : svg_attribute(r->node, name);
}


// Style sheets
// ------------

/* Is anything of this set? */
static bool declares(const char *declarations, const char *const names[])
{
    bool loud, found = false;

    for (; *names != NULL; names++) {
        char *value = declared(declarations, *names, &loud);
        found = found || value != NULL;
        xmlFree(value);
    }
    return found;
}

static const char *const places[] = { "display", "visibility", "transform", NULL }, *const paints[] = { "fill", "stroke", "stroke-dasharray", NULL };

/* Keep the rule for one selector, if it is a simple one. Takes no ownership. */
static void add_rule(svg_reader *r, const char *selector, size_t length, const char *declarations)
{
    while (length > 0 && strchr(blank, selector[length - 1]))
        length--;
    if (length == 0)
        return;

    char *copy = tool_grow(NULL, length + 1);
    memcpy(copy, selector, length);
    copy[length] = '\0';
    if (strpbrk(copy, " \t\r\n\f>+~:[|") != NULL) {
        if (declares(declarations, places))
            svg_warn(r, 0, "the style sheet's selector \"%.40s\" is not understood: use a class, an id or style=\"\"", copy);
        free(copy);
        return;
    }
    unsigned weight = copy[0] != '.' && copy[0] != '#' && copy[0] != '*';
    for (const char *s = copy; *s != '\0'; s++)
        weight += *s == '#' ? 10000 : *s == '.' ? 100 : 0;

    svg_sheet *sheet = r->sheet;
    sheet->rules = tool_grow(sheet->rules, (sheet->count + 1) * sizeof *sheet->rules);
    char *text = tool_grow(NULL, strlen(declarations) + 1);
    strcpy(text, declarations);
    sheet->rules[sheet->count++] = (rule){ copy, text, weight };
}

/* `a, b { c }` starts at `text`, the brace is at `open`; declarations end at `end`, which is overwritten. */
static void add_rules(svg_reader *r, const char *text, const char *open, char *end)
{
    *end = '\0';
    if (!declares(open + 1, places) && !declares(open + 1, paints))
        return;
    while (text < open) {
        text += strspn(text, " \t\r\n\f,");
        if (text >= open)
            break;
        const size_t length = strcspn(text, ",{");
        add_rule(r, text, length, open + 1);
        text += length;
    }
}

static void blank_comments(char *text)
{
    for (char *start = strstr(text, "/*"); start != NULL; start = strstr(start, "/*")) {
        const char *end = strstr(start + 2, "*/");
        const size_t size = end ? (size_t)(end + 2 - start) : strlen(start);
        memset(start, ' ', size);
    }
}

/* Where the block or statement that starts at `s` ends: behind its matching brace or its semicolon. */
static char *behind_at_rule(char *s)
{
    int depth = 0;

    for (; *s != '\0'; s++) {
        depth += (*s == '{') - (*s == '}');
        if (depth == 0 && (*s == '}' || *s == ';'))
            return s + 1;
    }
    return s;
}

void svg_sheet_read(svg_reader *r, const xmlNode *style)
{
    char *text = NULL;

    for (const xmlNode *part = style->children; part != NULL; part = part->next)
        if (part->type == XML_TEXT_NODE || part->type == XML_CDATA_SECTION_NODE)
            text = (char *)xmlStrcat((xmlChar *)text, part->content);
    if (text == NULL)
        return;
    if (r->sheet == NULL) {
        r->sheet = tool_grow(NULL, sizeof *r->sheet);
        *r->sheet = (svg_sheet){ NULL, 0 };
    }
    blank_comments(text);

    char *s = text;
    while (*(s += strspn(s, blank)) != '\0') {
        if (*s == '@') {
            s = behind_at_rule(s);
            continue;
        }
        char *open = s + strcspn(s, "{"), *end = open + strcspn(open, "}");
        const bool last = *end == '\0';
        if (*open == '\0')
            break;
        add_rules(r, s, open, end);
        s = last ? end : end + 1;
    }
    xmlFree(text);
}

void svg_sheet_free(svg_sheet *sheet)
{
    for (size_t i = 0; sheet != NULL && i < sheet->count; i++) {
        free(sheet->rules[i].selector);
        free(sheet->rules[i].declarations);
    }
    if (sheet != NULL)
        free(sheet->rules);
    free(sheet);
}
