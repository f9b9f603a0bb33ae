/* host-tools/svg/svg_selector.c -- selectors of style sheets, and which elements they match
 * SPDX-License-Identifier: MIT
 *
 * A selector is a row of compounds with combinators between them, `g.a > path:not([id]) + *`. An
 * element is compared with the last compound; then its parents and its elder siblings with those
 * before. Browsers that show a file as a picture know no pointer and no focus: :hover and the like
 * match nothing.
 *   see  Selectors Level 4; Level 3 for the grammar
 */
#include <libxml/parserInternals.h>     /* xmlCopyChar */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "svg/svg.h"

#define DEPTH_MAX 4             /* of :not() and :is() in each other */

static const char blank[] = " \t\r\n\f";

enum kind {
    TYPE,                       /* name; NULL: any */
    CLASS,
    ID,
    ATTRIBUTE,
    ROOT,
    EMPTY,
    LINK,
    PLACE,                      /* step a + b of its siblings */
    ALONE,
    NOT,                        /* none of a list, one of a list */
    IS,
    NEVER
};

typedef struct test {
    struct test *next;
    enum kind kind;
    char *name, *value;
    char op;                    /* of an attribute: = ~ | ^ $ *, 0: it exists */
    bool fold, any_space;       /* in any case; in any namespace */
    bool back, typed;           /* of a place: from the end; among those of its name */
    int step, first;
    bool free;                  /* of a list: it has no rank */
    struct svg_selector **list;
    size_t count;
} test;

typedef struct compound {
    test *tests;
    char before;                /* the combinator before it: blank, > + ~, or 0 */
    struct compound *left;
} compound;

struct svg_selector {
    compound *last;
};

typedef struct {
    const char *at, *end;
    int depth;
} cursor;


// Parsing
// -------

static char peek(const cursor *c) { return c->at < c->end ? *c->at : '\0'; }

static void skip_blank(cursor *c)
{
    while (c->at < c->end && strchr(blank, *c->at) != NULL)
        c->at++;
}

static bool take(cursor *c, char which)
{
    const bool is = peek(c) == which && which != '\0';

    c->at += is;
    return is;
}

static bool is_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '\\' || (unsigned char)c >= 0x80;
}

/* What is behind a backslash: a letter, or its number. */
static size_t unescape(cursor *c, char out[4])
{
    unsigned code = 0;
    int digits    = 0;

    for (; digits < 6 && c->at < c->end && strchr("0123456789abcdefABCDEF", *c->at); digits++) {
        const char d = (char)(*c->at++ | 0x20);
        code         = code * 16 + (unsigned)(d >= 'a' ? d - 'a' + 10 : d & 15);
    }
    if (digits == 0) {
        out[0] = c->at < c->end ? *c->at++ : '\\';
        return 1;
    }
    if (c->at < c->end && strchr(blank, *c->at) != NULL)
        c->at++;
    return (size_t)xmlCopyChar(4, (xmlChar *)out, code > 0 && code < 0x110000 ? (int)code : 0xfffd);
}

/* A name, or the text of a string up to its quote; NULL if there is none. */
static char *read_text(cursor *c, char quote)
{
    xmlBufferPtr out = xmlBufferCreate();
    const char *from = c->at;
    char one[4];

    while (c->at < c->end && (quote ? *c->at != quote : is_name(*c->at))) {
        size_t length = 1;
        one[0]        = *c->at++;
        if (one[0] == '\\')
            length = unescape(c, one);
        xmlBufferAdd(out, (const xmlChar *)one, (int)length);
    }
    const bool good = quote ? take(c, quote) : c->at > from;
    char *text      = good ? (char *)xmlStrdup(xmlBufferContent(out)) : NULL;
    xmlBufferFree(out);
    return text;
}

static test *add_test(compound *to, enum kind kind)
{
    test *t = memory_grow(NULL, sizeof *t);

    *t = (test){ .next = to->tests, .kind = kind };
    to->tests = t;
    return t;
}

/* `[name op "value" i]`, behind the bracket. */
static bool read_attribute(cursor *c, compound *to)
{
    test *t = add_test(to, ATTRIBUTE);

    skip_blank(c);
    if (take(c, '*') || peek(c) == '|')
        t->any_space = true;
    else
        t->name = read_text(c, 0);
    if (peek(c) == '|' && c->at + 1 < c->end && c->at[1] != '=') {
        c->at++;
        t->any_space = t->any_space || t->name != NULL;
        xmlFree(t->name);
        t->name = read_text(c, 0);
    }
    skip_blank(c);
    if (t->name == NULL)
        return false;
    if (take(c, ']'))
        return true;
    t->op = peek(c) == '=' ? '=' : '\0';
    if (t->op == '\0' && peek(c) != '\0' && strchr("~|^$*", peek(c)) != NULL)
        t->op = *c->at++;
    if (!take(c, '='))
        return false;
    skip_blank(c);
    t->value = take(c, '"')    ? read_text(c, '"')
               : take(c, '\'') ? read_text(c, '\'')
                               : read_text(c, 0);
    skip_blank(c);
    t->fold = take(c, 'i') || take(c, 'I');
    if (!t->fold)
        (void)(take(c, 's') || take(c, 'S'));
    skip_blank(c);
    return t->value != NULL && take(c, ']');
}

/* `(2n+1)`, odd, even, `(3)`. */
static bool read_place(cursor *c, test *t)
{
    char text[40];
    size_t n = 0;
    int used = 0;

    if (!take(c, '('))
        return false;
    while (c->at < c->end && *c->at != ')' && n + 1 < sizeof text) {
        if (strchr(blank, *c->at) == NULL)
            text[n++] = (char)(*c->at >= 'A' && *c->at <= 'Z' ? *c->at | 0x20 : *c->at);
        c->at++;
    }
    text[n] = '\0';
    if (!take(c, ')') || n == 0 || n > 12)
        return false;
    if (strcmp(text, "odd") == 0 || strcmp(text, "even") == 0) {
        t->step  = 2;
        t->first = text[0] == 'o';
        return true;
    }
    const char *at = text, *x = strchr(text, 'n');
    if (x != NULL) {
        const int sign = *at == '-' ? -1 : 1;
        at += *at == '-' || *at == '+';
        t->step = sign * (at == x ? 1 : (int)strtol(at, NULL, 10));
        if (strspn(at, "0123456789") != (size_t)(x - at))
            return false;
        at = x + 1;
    }
    if (*at == '\0')
        return x != NULL;
    char *end;
    t->first = (int)strtol(at, &end, 10);
    used     = (int)(end - at);
    return used > 0 && *end == '\0';
}

static svg_selector *read_selector(cursor *c);

/* The list of :not() and :is(). */
static bool read_list(cursor *c, test *t)
{
    if (!take(c, '(') || c->depth >= DEPTH_MAX)
        return false;
    c->depth++;
    do {
        svg_selector *one = read_selector(c);
        if (one == NULL)
            return false;
        t->list = memory_grow(t->list, (t->count + 1) * sizeof *t->list);
        t->list[t->count++] = one;
    } while (take(c, ','));
    c->depth--;
    return take(c, ')');
}

/* Behind the colon. */
static bool read_pseudo(cursor *c, compound *to)
{
    static const struct {
        const char *name;
        enum kind kind;
        bool back, typed;
        int first;              /* 0: its places are in parentheses */
    } known[] = { { "root", ROOT, false, false, 0 },
                  { "scope", ROOT, false, false, 0 },
                  { "empty", EMPTY, false, false, 0 },
                  { "link", LINK, false, false, 0 },
                  { "any-link", LINK, false, false, 0 },
                  { "first-child", PLACE, false, false, 1 },
                  { "last-child", PLACE, true, false, 1 },
                  { "first-of-type", PLACE, false, true, 1 },
                  { "last-of-type", PLACE, true, true, 1 },
                  { "nth-child", PLACE, false, false, 0 },
                  { "nth-last-child", PLACE, true, false, 0 },
                  { "nth-of-type", PLACE, false, true, 0 },
                  { "nth-last-of-type", PLACE, true, true, 0 },
                  { "only-child", ALONE, false, false, 0 },
                  { "only-of-type", ALONE, false, true, 0 },
                  { "not", NOT, false, false, 0 },
                  { "is", IS, false, false, 0 },
                  { "where", IS, false, false, 1 },
                  { "hover", NEVER, false, false, 0 },
                  { "active", NEVER, false, false, 0 },
                  { "focus", NEVER, false, false, 0 },
                  { "focus-visible", NEVER, false, false, 0 },
                  { "focus-within", NEVER, false, false, 0 },
                  { "visited", NEVER, false, false, 0 },
                  { "target", NEVER, false, false, 0 },
                  { "before", NEVER, false, false, 0 },
                  { "after", NEVER, false, false, 0 },
                  { "first-line", NEVER, false, false, 0 },
                  { "first-letter", NEVER, false, false, 0 } };
    const bool part = take(c, ':');
    char *name      = read_text(c, 0);
    size_t i        = 0;

    while (name != NULL && i < sizeof known / sizeof known[0] &&
           strcasecmp(known[i].name, name) != 0)
        i++;
    const bool named = name != NULL, found = named && i < sizeof known / sizeof known[0];
    xmlFree(name);
    if (part && named && peek(c) != '(')    /* ::selection and the like are no elements */
        return add_test(to, NEVER), true;
    if (!found || part)
        return false;
    test *t  = add_test(to, known[i].kind);
    t->back  = known[i].back;
    t->typed = known[i].typed;
    t->first = known[i].first;
    if (t->kind == NOT || t->kind == IS) {
        t->free = known[i].first > 0;
        return read_list(c, t);
    }
    return t->kind != PLACE || t->first > 0 || read_place(c, t);
}

/* `path`, `*`, `svg|path`: the namespace does not count. */
static bool read_type(cursor *c, compound *to)
{
    test *t = add_test(to, TYPE);

    if (!take(c, '*') && peek(c) != '|')
        t->name = read_text(c, 0);
    if (!take(c, '|'))
        return true;
    xmlFree(t->name);
    t->name = NULL;
    return take(c, '*') || (t->name = read_text(c, 0)) != NULL;
}

static bool read_compound(cursor *c, compound *to)
{
    const char *from = c->at;

    if (peek(c) == '*' || peek(c) == '|' || is_name(peek(c)))
        if (!read_type(c, to))
            return false;
    for (;;) {
        if (take(c, '[')) {
            if (!read_attribute(c, to))
                return false;
        } else if (take(c, ':')) {
            if (!read_pseudo(c, to))
                return false;
        } else if (peek(c) == '.' || peek(c) == '#') {
            test *t = add_test(to, *c->at++ == '.' ? CLASS : ID);
            t->name = read_text(c, 0);
            if (t->name == NULL)
                return false;
        } else {
            return c->at > from;
        }
    }
}

/* Up to the end, a comma or a parenthesis; NULL if it is not understood. */
static svg_selector *read_selector(cursor *c)
{
    svg_selector *s = memory_grow(NULL, sizeof *s);
    char before     = '\0';

    *s = (svg_selector){ .last = NULL };
    skip_blank(c);
    for (;;) {
        compound *one = memory_grow(NULL, sizeof *one);
        *one          = (compound){ .before = before, .left = s->last };
        s->last       = one;
        if (!read_compound(c, one)) {
            svg_selector_free(s);
            return NULL;
        }
        const char *from = c->at;
        skip_blank(c);
        if (c->at == c->end || *c->at == ',' || *c->at == ')')
            return s;
        before = c->at > from ? ' ' : '\0';
        if (strchr(">+~", *c->at) != NULL)
            before = *c->at++;
        skip_blank(c);
        if (before == '\0') {
            svg_selector_free(s);
            return NULL;
        }
    }
}

svg_selector *svg_selector_read(const char *text, size_t length)
{
    cursor c        = { text, text + length, 0 };
    svg_selector *s = read_selector(&c);

    if (s != NULL && c.at < c.end) {
        svg_selector_free(s);
        return NULL;
    }
    return s;
}

static void free_tests(test *t)
{
    while (t != NULL) {
        test *next = t->next;
        xmlFree(t->name);
        xmlFree(t->value);
        for (size_t i = 0; i < t->count; i++)
            svg_selector_free(t->list[i]);
        free(t->list);
        free(t);
        t = next;
    }
}

void svg_selector_free(svg_selector *s)
{
    while (s->last != NULL) {
        compound *left = s->last->left;
        free_tests(s->last->tests);
        free(s->last);
        s->last = left;
    }
    free(s);
}


// Ranks and names
// ---------------

/* Ids rank above classes, classes above types. */
static void count_ranks(const svg_selector *s, unsigned count[3])
{
    for (const compound *c = s->last; c != NULL; c = c->left)
        for (const test *t = c->tests; t != NULL; t = t->next) {
            if (t->kind == NOT || t->kind == IS) {
                unsigned most = 0;
                for (size_t i = 0; i < t->count && !t->free; i++) {
                    const unsigned one = svg_selector_rank(t->list[i]);
                    most               = one > most ? one : most;
                }
                for (int k = 0; k < 3; k++)
                    count[k] += most >> (16 - 8 * k) & 255;
            } else {
                count[t->kind == ID     ? 0
                      : t->kind == TYPE ? 2
                                        : 1] += t->kind != TYPE || t->name != NULL;
            }
        }
}

unsigned svg_selector_rank(const svg_selector *s)
{
    unsigned count[3] = { 0 };

    count_ranks(s, count);
    for (int k = 0; k < 3; k++)
        count[k] = count[k] < 255 ? count[k] : 255;
    return count[0] << 16 | count[1] << 8 | count[2];
}

const char *svg_selector_name(const svg_selector *s, unsigned which, const char **kind)
{
    for (const test *t = s->last->tests; t != NULL; t = t->next) {
        const bool named = t->kind == CLASS || t->kind == ID || t->kind == ROOT ||
                           (t->kind == TYPE && t->name != NULL);
        if (!named || which-- > 0)
            continue;
        *kind = t->kind == CLASS ? "." : t->kind == ID ? "#" : t->kind == ROOT ? ":" : "";
        return t->kind == ROOT ? "root" : t->name;
    }
    return NULL;
}


// Matching
// --------

/* An attribute is one text, as its entities are expanded; NULL: there is none. */
static const char *text_of(const xmlAttr *a)
{
    return a->children == NULL ? "" : (const char *)a->children->content;
}

static bool is_attribute(const xmlAttr *a, const char *name, bool any_space)
{
    const char *own = (const char *)a->name, *colon = strchr(name, ':');

    if (a->ns == NULL || any_space)
        return strcmp(own, name) == 0;
    return colon != NULL && a->ns->prefix != NULL && strcmp(colon + 1, own) == 0 &&
           strlen((const char *)a->ns->prefix) == (size_t)(colon - name) &&
           strncmp((const char *)a->ns->prefix, name, (size_t)(colon - name)) == 0;
}

static const char *attribute_of(const xmlNode *node, const char *name, bool any_space)
{
    for (const xmlAttr *a = node->properties; a != NULL; a = a->next)
        if (is_attribute(a, name, any_space))
            return text_of(a);
    return NULL;
}

static bool is_same(const char *a, const char *b, size_t length, bool fold)
{
    return (fold ? strncasecmp(a, b, length) : strncmp(a, b, length)) == 0;
}

/* Is `word` one of `words`? */
static bool has_word(const char *words, const char *word, bool fold)
{
    const size_t length = strlen(word);

    for (const char *at = words; length > 0 && *(at += strspn(at, blank)) != '\0';) {
        const size_t size = strcspn(at, blank);
        if (size == length && is_same(at, word, length, fold))
            return true;
        at += size;
    }
    return false;
}

static bool attribute_matches(const test *t, const xmlNode *node)
{
    const char *text = attribute_of(node, t->name, t->any_space);

    if (text == NULL || t->op == '\0')
        return text != NULL;
    const size_t length = strlen(t->value), size = strlen(text);
    switch (t->op) {
    case '=': return size == length && is_same(text, t->value, size, t->fold);
    case '~': return has_word(text, t->value, t->fold);
    case '|':
        return size >= length && is_same(text, t->value, length, t->fold) &&
               (size == length || text[length] == '-');
    case '^': return length > 0 && size >= length && is_same(text, t->value, length, t->fold);
    case '$':
        return length > 0 && size >= length &&
               is_same(text + size - length, t->value, length, t->fold);
    default:
        for (size_t i = 0; length > 0 && i + length <= size; i++)
            if (is_same(text + i, t->value, length, t->fold))
                return true;
        return false;
    }
}

static const xmlNode *next_element(const xmlNode *node, bool back)
{
    do
        node = back ? node->next : node->prev;
    while (node != NULL && node->type != XML_ELEMENT_NODE);
    return node;
}

/* Its number among its siblings, or among those of its name. Elements are asked in their order, so
 * the one that was asked last is near. */
static unsigned place_of(svg_reader *r, const xmlNode *node, bool back, bool typed)
{
    svg_place *kept = &r->place[2 * back + typed];
    unsigned n      = 1, before = 0;

    for (const xmlNode *at = node; back && at != NULL && before < 8;
         at = next_element(at, false), before += !typed || xmlStrEqual(at->name, node->name)) {
        if (at == kept->node && xmlStrEqual(at->name, node->name)) {
            *kept = (svg_place){ node, kept->place - before };
            return kept->place;
        }
        if (at->prev == NULL)
            break;
    }
    for (const xmlNode *at = next_element(node, back); at != NULL; at = next_element(at, back)) {
        const bool counts = !typed || xmlStrEqual(at->name, node->name);
        r->effort++;
        if (!back && counts && at == kept->node) {
            n += kept->place;
            break;
        }
        n += counts;
    }
    *kept = (svg_place){ node, n };
    return n;
}

static bool is_at_place(svg_reader *r, const test *t, const xmlNode *node)
{
    const int beyond = (int)place_of(r, node, t->back, t->typed) - t->first;

    return t->step == 0 ? beyond == 0 : beyond % t->step == 0 && beyond / t->step >= 0;
}

static bool is_root(const xmlNode *node)
{
    return node->parent == NULL || node->parent->type != XML_ELEMENT_NODE;
}

static bool is_empty(const xmlNode *node)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (child->type == XML_ELEMENT_NODE || child->type == XML_TEXT_NODE ||
            child->type == XML_CDATA_SECTION_NODE)
            return false;
    return true;
}

static bool test_matches(svg_reader *r, const test *t, const xmlNode *node)
{
    const char *text;

    switch (t->kind) {
    case TYPE:  return t->name == NULL || strcmp((const char *)node->name, t->name) == 0;
    case CLASS:
        text = attribute_of(node, "class", false);
        r->effort += text ? strlen(text) / 8 : 0;
        return text != NULL && has_word(text, t->name, false);
    case ID:
        text = attribute_of(node, "id", false);
        return text != NULL && strcmp(text, t->name) == 0;
    case ATTRIBUTE: return attribute_matches(t, node);
    case ROOT:      return is_root(node);
    case EMPTY:     return is_empty(node);
    case LINK:
        return strcmp((const char *)node->name, "a") == 0 &&
               attribute_of(node, "href", true) != NULL;
    case PLACE: return is_at_place(r, t, node);
    case ALONE:
        return place_of(r, node, false, t->typed) == 1 && place_of(r, node, true, t->typed) == 1;
    case NOT:
    case IS:
        for (size_t i = 0; i < t->count; i++)
            if (svg_selector_matches(r, t->list[i], node))
                return t->kind == IS;
        return t->kind == NOT;
    default: return false;
    }
}

static bool compound_matches(svg_reader *r, const compound *c, const xmlNode *node)
{
    r->effort++;
    for (const test *t = c->tests; t != NULL; t = t->next)
        if (!test_matches(r, t, node))
            return false;
    return true;
}

/* The element that a combinator leads to, or NULL. */
static const xmlNode *led_to(const xmlNode *node, char combinator)
{
    if (combinator == '+' || combinator == '~')
        return next_element(node, false);
    return is_root(node) ? NULL : node->parent;
}

/* Of the elements that a combinator with many of them leads to, the nearest is tried first. If the
 * rest does not match there, the next one is tried. */
static bool left_matches(svg_reader *r, const compound *c, const xmlNode *node)
{
    if (c->left == NULL)
        return true;
    const bool many = c->before == ' ' || c->before == '~';
    for (node = led_to(node, c->before); node != NULL && r->effort <= SVG_EFFORT_MAX;
         node = many ? led_to(node, c->before) : NULL)
        if (compound_matches(r, c->left, node) && left_matches(r, c->left, node))
            return true;
    return false;
}

bool svg_selector_matches(svg_reader *r, const svg_selector *s, const xmlNode *node)
{
    return compound_matches(r, s->last, node) && left_matches(r, s->last, node);
}
