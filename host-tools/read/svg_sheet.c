/* host-tools/read/svg_sheet.c -- the style sheets of an SVG file: rules, and which of them match an
 * element
 * SPDX-License-Identifier: MIT
 *
 * Selectors are lists of simple ones, such as `g`, `.st0`, `#title`, `path.a.b`, `*`, `:root`.
 * Others are skipped, with a warning if they would hide or move something. A rule is in the list of
 * one of the names in its selector, the one with the shortest list. So an element checks only the
 * lists of its own names.
 */
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"       /* scan_number */
#include "read/svg.h"
#include "base/tool.h"       /* tool_grow */

/* A property that a rule sets; also custom ones, whose names belong to the sheet. */
typedef struct {
    enum svg_property property;
    svg_value value;
} setting;

typedef struct {
    xmlHashTablePtr names;
    unsigned long long rank;
} naming;

/* The declarations for one selector. */
typedef struct rule {
    struct rule *next;              /* in the same list */
    char *selector;
    setting *settings;
    naming *namings;
    size_t setting_count, naming_count;
} rule;

typedef struct {
    rule *first;
    size_t count;
} list;

struct svg_sheet {
    xmlHashTablePtr rules;          /* by selector */
    xmlHashTablePtr lists;          /* by name and kind of name: "." "#" ":" "" */
    xmlBufferPtr *texts;
    xmlHashTablePtr *names;         /* of all blocks that set custom properties */
    size_t text_count, names_count;
    unsigned order;                 /* of the blocks */
};

static const char blank[] = " \t\r\n\f";


// Selectors
// ---------

/* One part of a selector: `.a` is the class "a". */
typedef struct {
    char kind[2];
    const char *word;
    size_t length;
} part;

static bool next_part(const char **at, part *out)
{
    const char *s = *at;
    const bool marked = *s == '.' || *s == '#' || *s == ':';

    if (*s == '\0')
        return false;
    *out = (part){ { marked ? *s : '\0', '\0' }, s + marked, strcspn(s + marked, ".#:") };
    *at = out->word + out->length;
    return true;
}

static bool is_universal(const part *p)
{
    return p->kind[0] == '\0' && p->length == 1 && *p->word == '*';
}

/* Is `word` one of `words`? */
static bool has_word(const char *words, size_t size, const char *word, size_t length)
{
    if (size == 0 || length == 0)
        return false;
    const char *end = words + size;
    for (const char *at = words; at < end; at += length) {
        at = memmem(at, (size_t)(end - at), word, length);
        if (at == NULL)
            return false;
        if ((at == words || strchr(blank, at[-1])) &&
            (at + length == end || strchr(blank, at[length])))
            return true;
    }
    return false;
}

/* The names of an element that selectors can match. */
typedef struct {
    const xmlNode *node;
    char *class, *id;
    size_t class_length;
    unsigned effort;            /* for one selector: all words of a long list are compared */
} asked;

static bool is_word(const char *text, const part *p)
{
    return text != NULL && strlen(text) == p->length && strncmp(text, p->word, p->length) == 0;
}

static bool is_root(const xmlNode *node)
{
    return node->parent == NULL || node->parent->type != XML_ELEMENT_NODE;
}

static bool selector_matches(const char *selector, const asked *a)
{
    bool good = true;
    part p;

    while (good && next_part(&selector, &p))
        switch (p.kind[0]) {
        case '.': good = has_word(a->class, a->class_length, p.word, p.length);     break;
        case '#': good = is_word(a->id, &p);                                        break;
        case ':': good = is_root(a->node);                                          break;
        default:  good = is_universal(&p) || is_word((const char *)a->node->name, &p);    break;
        }
    return good;
}

/* Ids rank above classes, classes above types. */
static unsigned long long specificity(const char *selector)
{
    unsigned count[3] = { 0 };
    part p;

    while (next_part(&selector, &p)) {
        const int i = p.kind[0] == '#' ? 0 : p.kind[0] != '\0' ? 1 : 2;
        count[i] += !is_universal(&p) && count[i] < 255;
    }
    return (unsigned long long)(count[0] << 16 | count[1] << 8 | count[2]) << 32;
}


// Rules
// -----

/* The list of one name; NULL if there is none and none shall be created. */
static list *list_of(const svg_sheet *sheet, const char *word, size_t length, const char *kind,
                     bool make)
{
    xmlChar *name = xmlStrndup((const xmlChar *)word, (int)length);
    list *found = xmlHashLookup2(sheet->lists, name, (const xmlChar *)kind);

    if (found == NULL && make) {
        found = tool_grow(NULL, sizeof *found);
        *found = (list){ NULL, 0 };
        xmlHashAddEntry2(sheet->lists, name, (const xmlChar *)kind, found);
    }
    xmlFree(name);
    return found;
}

static void enlist_rule(svg_sheet *sheet, rule *u)
{
    const char *at = u->selector;
    part p, best = { "", "*", 1 };
    size_t least = SIZE_MAX;

    while (next_part(&at, &p)) {
        const list *l = list_of(sheet, p.word, p.length, p.kind, false);
        const size_t count = is_universal(&p) ? SIZE_MAX : l ? l->count : 0;
        if (count < least) {
            least = count;
            best = p;
        }
    }
    list *l = list_of(sheet, best.word, best.length, best.kind, true);
    u->next = l->first;
    l->first = u;
    l->count++;
}

static rule *rule_of(svg_sheet *sheet, const char *selector)
{
    rule *u = xmlHashLookup(sheet->rules, (const xmlChar *)selector);

    if (u == NULL) {
        u = tool_grow(NULL, sizeof *u);
        *u = (rule){ .selector = (char *)xmlStrdup((const xmlChar *)selector) };
        xmlHashAddEntry(sheet->rules, (const xmlChar *)selector, u);
        enlist_rule(sheet, u);
    }
    return u;
}

static void set_property(rule *u, enum svg_property property, svg_value value)
{
    for (size_t i = 0; i < u->setting_count; i++)
        if (u->settings[i].property == property) {
            svg_value_put(&u->settings[i].value, value);
            return;
        }
    u->settings = tool_grow(u->settings, (u->setting_count + 1) * sizeof *u->settings);
    u->settings[u->setting_count++] = (setting){ property, value };
}

/* Make room for one more item after `count`; the room doubles when it is full. */
static void *room_for_one(void *old, size_t count, size_t size)
{
    return (count & (count - 1)) == 0 ? tool_grow(old, (count ? 2 * count : 1) * size) : old;
}

static bool is_zero(const svg_value *value)
{
    const char *at = value->text;
    double x;

    return at != NULL && scan_number(&at, &x) && x <= 0;
}

static bool hides_or_moves(const svg_block *b)
{
    return b->value[SVG_DISPLAY].text || b->value[SVG_VISIBILITY].text ||
           b->value[SVG_TRANSFORM].text || is_zero(&b->value[SVG_OPACITY]) ||
           is_zero(&b->value[SVG_FILL_OPACITY]) || is_zero(&b->value[SVG_STROKE_OPACITY]) ||
           is_zero(&b->value[SVG_STROKE_WIDTH]);
}

static bool is_understood(const char *selector)
{
    const char *colon = strchr(selector, ':');

    return strpbrk(selector, " \t\r\n\f>+~[|") == NULL &&
           (colon == NULL || strcmp(colon, ":root") == 0);
}

/* Store the declarations of `block` for one selector. */
static void add_rule(svg_reader *r, const char *text, size_t length, const svg_block *block)
{
    svg_sheet *sheet = r->sheet;

    while (length > 0 && strchr(blank, text[length - 1]))
        length--;
    if (length == 0)
        return;
    char *selector = (char *)xmlStrndup((const xmlChar *)text, (int)length);
    if (is_understood(selector)) {
        rule *u = rule_of(sheet, selector);
        const unsigned long long rank = specificity(selector) + sheet->order;
        for (int i = 0; i < SVG_PROPERTIES; i++) {
            svg_value value = block->value[i];
            value.rank += rank;
            if (value.text != NULL)
                set_property(u, (enum svg_property)i, value);
        }
        if (block->names != NULL) {
            u->namings = room_for_one(u->namings, u->naming_count, sizeof *u->namings);
            u->namings[u->naming_count++] = (naming){ block->names, rank };
        }
    } else if (hides_or_moves(block)) {
        svg_warn(r, SVG_WARN_SELECTOR,
                 "the style sheet's selector \"%.40s\" is not understood: "
                 "use a class, an id or style=\"\"",
                 selector);
    }
    xmlFree(selector);
}

/* `a, b { c }` starts at `text`, and its brace is at `open`. The declarations end at `end`, which
 * is overwritten. */
static void add_rules(svg_reader *r, const char *text, const char *open, char *end)
{
    svg_sheet *sheet = r->sheet;
    svg_block block;

    *end = '\0';
    svg_block_read(&block, open + 1, 0);
    if (block.names != NULL) {
        sheet->names = room_for_one(sheet->names, sheet->names_count, sizeof *sheet->names);
        sheet->names[sheet->names_count++] = block.names;
    }
    sheet->order++;
    while (text < open) {
        text += strspn(text, " \t\r\n\f,");
        if (text >= open)
            break;
        const size_t length = strcspn(text, ",{");
        add_rule(r, text, length, &block);
        text += length;
    }
}


// Style sheets
// ------------

static void blank_comments(char *text)
{
    for (char *start = strstr(text, "/*"); start != NULL; start = strstr(start, "/*")) {
        const char *end = strstr(start + 2, "*/");
        const size_t size = end ? (size_t)(end + 2 - start) : strlen(start);
        memset(start, ' ', size);
    }
}

/* The end of the block or statement that starts at `s`: after its matching brace or its
 * semicolon. */
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

static void read_rules(svg_reader *r, char *s)
{
    blank_comments(s);
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
}

/* Values point into the text, which the sheet keeps. */
void svg_sheet_read(svg_reader *r, const xmlNode *style)
{
    xmlBufferPtr text = xmlBufferCreate();

    xmlBufferSetAllocationScheme(text, XML_BUFFER_ALLOC_DOUBLEIT);
    for (const xmlNode *child = style->children; child != NULL; child = child->next)
        if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE)
            xmlBufferCat(text, child->content);
    if (r->sheet == NULL) {
        r->sheet = tool_grow(NULL, sizeof *r->sheet);
        *r->sheet = (svg_sheet){ .rules = xmlHashCreate(0), .lists = xmlHashCreate(0) };
    }
    svg_sheet *sheet = r->sheet;
    sheet->texts = room_for_one(sheet->texts, sheet->text_count, sizeof *sheet->texts);
    sheet->texts[sheet->text_count++] = text;
    if (xmlBufferLength(text) > 0)
        read_rules(r, (char *)(size_t)xmlBufferContent(text));
}

static void free_rule(void *payload, const xmlChar *name)
{
    rule *u = payload;

    (void)name;
    xmlFree(u->selector);
    free(u->settings);
    free(u->namings);
    free(u);
}

static void free_list(void *payload, const xmlChar *name)
{
    (void)name;
    free(payload);
}

void svg_sheet_free(svg_sheet *sheet)
{
    if (sheet == NULL)
        return;
    xmlHashFree(sheet->rules, free_rule);
    xmlHashFree(sheet->lists, free_list);
    for (size_t i = 0; i < sheet->names_count; i++)
        svg_names_free(sheet->names[i]);
    for (size_t i = 0; i < sheet->text_count; i++)
        xmlBufferFree(sheet->texts[i]);
    free(sheet->names);
    free(sheet->texts);
    free(sheet);
}


// The element
// -----------

void svg_scope_add(svg_scope *scope, xmlHashTablePtr names, unsigned long long rank)
{
    scope->list = room_for_one(scope->list, scope->count, sizeof *scope->list);
    scope->list[scope->count].names = names;
    scope->list[scope->count++].rank = rank;
}

static void apply_list(svg_reader *r, const asked *a, const char *word, size_t length,
                       const char *kind, svg_style *style, svg_scope *scope)
{
    const list *l = list_of(r->sheet, word, length, kind, false);

    for (const rule *u = l ? l->first : NULL; u != NULL && r->effort <= SVG_EFFORT_MAX;
         u = u->next) {
        r->effort += a->effort;
        if (!selector_matches(u->selector, a))
            continue;
        for (size_t i = 0; i < u->setting_count; i++)
            svg_value_put(&style->value[u->settings[i].property], u->settings[i].value);
        for (size_t i = 0; i < u->naming_count; i++)
            svg_scope_add(scope, u->namings[i].names, u->namings[i].rank);
        r->effort += u->naming_count;
    }
}

void svg_sheet_apply(svg_reader *r, svg_style *style, svg_scope *scope)
{
    if (r->sheet == NULL)
        return;
    asked a = { .node = r->node,
                .class = svg_attribute(r->node, "class"),
                .id = svg_attribute(r->node, "id") };

    a.class_length = a.class ? strlen(a.class) : 0;
    a.effort = 1 + (unsigned)(a.class_length / 8);
    for (const char *at = a.class; at != NULL && *(at += strspn(at, blank)) != '\0';
         at += strcspn(at, blank))
        apply_list(r, &a, at, strcspn(at, blank), ".", style, scope);
    if (a.id != NULL)
        apply_list(r, &a, a.id, strlen(a.id), "#", style, scope);
    if (is_root(r->node))
        apply_list(r, &a, "root", 4, ":", style, scope);
    apply_list(r, &a, (const char *)r->node->name, strlen((const char *)r->node->name), "", style,
               scope);
    apply_list(r, &a, "*", 1, "", style, scope);
    xmlFree(a.class);
    xmlFree(a.id);
}
