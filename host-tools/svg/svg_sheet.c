/* host-tools/svg/svg_sheet.c -- the style sheets of an SVG file: rules, and which of them match an
 * element
 * SPDX-License-Identifier: MIT
 *
 * A rule is in the list of one of the names that its selector asks an element for, the one with the
 * shortest list. So an element checks only the lists of its own names.
 */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "svg/svg.h"

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
    svg_selector *selector;
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

#define AT_DEPTH 8      /* nested @media */

static const char blank[] = " \t\r\n\f";


// Rules
// -----

/* The list of one name; NULL if there is none and none shall be created. */
static list *list_of(const svg_sheet *sheet, const char *word, size_t length, const char *kind,
                     bool make)
{
    xmlChar *name = xmlStrndup((const xmlChar *)word, (int)length);
    list *found = xmlHashLookup2(sheet->lists, name, (const xmlChar *)kind);

    if (found == NULL && make) {
        found = memory_grow(NULL, sizeof *found);
        *found = (list){ NULL, 0 };
        xmlHashAddEntry2(sheet->lists, name, (const xmlChar *)kind, found);
    }
    xmlFree(name);
    return found;
}

static void enlist_rule(svg_sheet *sheet, rule *u)
{
    const char *best = "*", *best_kind = "", *kind = "", *name;
    size_t least = SIZE_MAX;

    for (unsigned i = 0; (name = svg_selector_name(u->selector, i, &kind)) != NULL; i++) {
        const list *l = list_of(sheet, name, strlen(name), kind, false);
        const size_t count = l ? l->count : 0;
        if (count < least) {
            least     = count;
            best      = name;
            best_kind = kind;
        }
    }
    list *l = list_of(sheet, best, strlen(best), best_kind, true);
    u->next = l->first;
    l->first = u;
    l->count++;
}

/* The rule of a selector; NULL if it is not understood. */
static rule *rule_of(svg_sheet *sheet, const char *selector)
{
    rule *u = xmlHashLookup(sheet->rules, (const xmlChar *)selector);
    svg_selector *parsed = u ? NULL : svg_selector_read(selector, strlen(selector));

    if (u == NULL && parsed != NULL) {
        u = memory_grow(NULL, sizeof *u);
        *u = (rule){ .selector = parsed };
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
    u->settings = memory_grow(u->settings, (u->setting_count + 1) * sizeof *u->settings);
    u->settings[u->setting_count++] = (setting){ property, value };
}

/* Make room for one more item after `count`; the room doubles when it is full. */
static void *room_for_one(void *old, size_t count, size_t size)
{
    return (count & (count - 1)) == 0 ? memory_grow(old, (count ? 2 * count : 1) * size) : old;
}

/* Does it set anything that is read? */
static bool sets_something(const svg_block *b)
{
    bool some = b->names != NULL;

    for (int i = 0; i < SVG_PROPERTIES; i++)
        some = some || b->value[i].text != NULL;
    return some;
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
    rule *u = sets_something(block) ? rule_of(sheet, selector) : NULL;
    if (u != NULL) {
        const unsigned long long rank = ((unsigned long long)svg_selector_rank(u->selector) << 32) +
                                        sheet->order;
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
    } else if (sets_something(block)) {
        svg_warn(r, SVG_WARN_SELECTOR,
                 "the style sheet's selector \"%.40s\" is not understood, its rule is not used: "
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
        const size_t length = svg_css_span(text, ",{");
        add_rule(r, text, length, &block);
        text += length;
    }
}


// Style sheets
// ------------

/* Does a query of media apply to a drawing that is shown? `known`: it is understood. */
static bool query_applies(const char *text, size_t length, bool *known)
{
    static const char *const yes[] = { "all", "screen", "(prefers-color-scheme: light)" },
                      *const no[]  = { "print", "speech", "(prefers-color-scheme: dark)" };
    char query[60];
    size_t n = 0;

    if (length > 5 && strncasecmp(text, "only ", 5) == 0) {
        text += 5;
        length -= 5;
    }
    for (size_t i = 0; i < length && n + 2 < sizeof query; i++)
        if (strchr(blank, text[i]) == NULL) {
            query[n++] = text[i];
            if (text[i] == ':')
                query[n++] = ' ';
        }
    query[n] = '\0';
    for (size_t i = 0; i < 3; i++)
        if (strcasecmp(query, yes[i]) == 0)
            return true;
    bool refused = false;
    for (size_t i = 0; i < 3; i++)
        refused = refused || strcasecmp(query, no[i]) == 0;
    *known = *known && refused;
    return false;
}

/* Does one of the queries apply? One that is not understood is told, and does not. */
static bool media_apply(svg_reader *r, const char *text, size_t size)
{
    bool applies = size == 0, known = true;

    for (size_t i = 0; i < size && !applies;) {
        while (i < size && strchr(" \t\r\n\f,", text[i]))
            i++;
        size_t length = 0;
        while (i + length < size && text[i + length] != ',')
            length++;
        applies = length == 0 || query_applies(text + i, length, &known);
        i += length + 1;
    }
    if (!applies && !known)
        svg_warn(r, SVG_WARN_MEDIA,
                 "the style sheet's rules for \"%.40s\" are not used: write them for all media",
                 text);
    return applies;
}

static void read_rules(svg_reader *r, char *s, int depth);

/* A rule that begins with @. Returns what is behind it. */
static char *read_at_rule(svg_reader *r, char *s, int depth)
{
    static const char *const passed[] = { "charset", "namespace", "font-face",
                                          "page",    "keyframes", "-webkit-keyframes" };
    const size_t name = strcspn(s + 1, " \t\r\n\f;{\"'(");
    char *open        = s + svg_css_span(s, ";{");
    bool quiet        = false;

    for (size_t i = 0; i < sizeof passed / sizeof passed[0]; i++)
        quiet = quiet || (strlen(passed[i]) == name && strncasecmp(passed[i], s + 1, name) == 0);
    const bool media = name == 5 && strncasecmp(s + 1, "media", 5) == 0;
    if (!media && !quiet)
        svg_warn(r, SVG_WARN_MEDIA,
                 "the style sheet's \"%.*s\" is not used: write its rules without",
                 (int)(name < 40 ? name + 1 : 40), s);
    if (*open != '{')
        return open + (*open != '\0');
    char *end = open + 1;
    for (int inner = 1; *(end += svg_css_span(end, "{}")) != '\0'; end++) {
        inner += *end == '{' ? 1 : -1;
        if (inner == 0)
            break;
    }
    const bool last = *end == '\0';
    *open = *end = '\0';
    s += 6;
    s += strspn(s, blank);
    if (media && depth < AT_DEPTH && media_apply(r, s, strlen(s)))
        read_rules(r, open + 1, depth + 1);
    return last ? end : end + 1;
}

static void read_rules(svg_reader *r, char *s, int depth)
{
    while (*(s += strspn(s, blank)) != '\0') {
        if (*s == '@') {
            s = read_at_rule(r, s, depth);
            continue;
        }
        char *open = s + svg_css_span(s, "{"), *end = open + svg_css_span(open, "}");
        const bool last = *end == '\0';
        if (*open == '\0')
            break;
        add_rules(r, s, open, end);
        s = last ? end : end + 1;
    }
}

/* A sheet of another language, or of other media, is not read. */
static bool sheet_applies(svg_reader *r, const xmlNode *style)
{
    char *type = svg_attribute(style, "type"), *media = svg_attribute(style, "media");
    const bool css = type == NULL || *type == '\0' || strcasecmp(type, "text/css") == 0;
    const bool good = css && (media == NULL || media_apply(r, media, strlen(media)));

    xmlFree(type);
    xmlFree(media);
    return good;
}

/* Values point into the text, which the sheet keeps. */
void svg_sheet_read(svg_reader *r, const xmlNode *style)
{
    if (!sheet_applies(r, style))
        return;
    xmlBufferPtr text = xmlBufferCreate();
    xmlBufferSetAllocationScheme(text, XML_BUFFER_ALLOC_DOUBLEIT);
    for (const xmlNode *child = style->children; child != NULL; child = child->next)
        if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE)
            xmlBufferCat(text, child->content);
    if (r->sheet == NULL) {
        r->sheet = memory_grow(NULL, sizeof *r->sheet);
        *r->sheet = (svg_sheet){ .rules = xmlHashCreate(0), .lists = xmlHashCreate(0) };
    }
    svg_sheet *sheet = r->sheet;
    sheet->texts = room_for_one(sheet->texts, sheet->text_count, sizeof *sheet->texts);
    sheet->texts[sheet->text_count++] = text;
    if (xmlBufferLength(text) == 0)
        return;
    svg_blank_comments((char *)(size_t)xmlBufferContent(text));
    read_rules(r, (char *)(size_t)xmlBufferContent(text), 0);
}

static void free_rule(void *payload, const xmlChar *name)
{
    rule *u = payload;

    (void)name;
    svg_selector_free(u->selector);
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

static void apply_list(svg_reader *r, const char *word, size_t length, const char *kind,
                       svg_style *style, svg_scope *scope)
{
    const list *l = list_of(r->sheet, word, length, kind, false);

    for (const rule *u = l ? l->first : NULL; u != NULL && r->effort <= SVG_EFFORT_MAX;
         u = u->next) {
        if (!svg_selector_matches(r, u->selector, r->node))
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
    const char *name = (const char *)r->node->name;

    if (r->sheet == NULL)
        return;
    char *class = svg_attribute(r->node, "class"), *id = svg_attribute(r->node, "id");
    for (const char *at = class; at != NULL && *(at += strspn(at, blank)) != '\0';
         at += strcspn(at, blank))
        apply_list(r, at, strcspn(at, blank), ".", style, scope);
    if (id != NULL)
        apply_list(r, id, strlen(id), "#", style, scope);
    if (r->node->parent == NULL || r->node->parent->type != XML_ELEMENT_NODE)
        apply_list(r, "root", 4, ":", style, scope);
    apply_list(r, name, strlen(name), "", style, scope);
    apply_list(r, "*", 1, "", style, scope);
    xmlFree(class);
    xmlFree(id);
}
