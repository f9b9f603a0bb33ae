/* tests/tools/test_selector.c -- which elements the selectors of style sheets match
 * SPDX-License-Identifier: MIT
 *
 * libxml2 judges: each selector is made together with an XPath expression that says the same.
 */
#include <libxml/parser.h>
#include <libxml/xpath.h>

#include "svg/svg.h"
#include "tools/drawn.h"

#define ROOM 4000

/* A tree of g, path and rect, with classes, ids and attributes. */
static void add_elements(arb *a, char *text, int depth, int *count)
{
    static const char *const names[]   = { "g", "path", "rect" };
    static const char *const classes[] = { "", " class='x'", " class='y x'", " class=' xy\ty'" };
    static const char *const kinds[] = { "", " k=''", " k='one'", " k='one two'", " k='one-two'" };

    for (unsigned n = 1 + arb_below(a, 4); n > 0 && *count < 30; n--) {
        const char *name = names[depth > 0 ? arb_below(a, 3) : 1];
        sprintf(text + strlen(text), "<%s id='i%d'%s%s>", name, (*count)++,
                classes[arb_below(a, 4)], kinds[arb_below(a, 5)]);
        if (depth > 0 && arb_below(a, 2))
            add_elements(a, text, depth - 1, count);
        sprintf(text + strlen(text), "%s</%s>", arb_below(a, 2) ? "" : "\n", name);
    }
}

/* One test, as CSS and as XPath. */
static void add_test(arb *a, const char *type, char *css, char *path)
{
    static const char *const both[][2] = {
        { ".x", "contains(concat(' ', translate(@class, '\t', ' '), ' '), ' x ')" },
        { ".y", "contains(concat(' ', translate(@class, '\t', ' '), ' '), ' y ')" },
        { "#i3", "@id = 'i3'" },
        { "[k]", "@k" },
        { "[ k = \"one\" ]", "@k = 'one'" },
        { "[k~='two']", "contains(concat(' ', @k, ' '), ' two ')" },
        { "[k|=one]", "(@k = 'one' or starts-with(@k, 'one-'))" },
        { "[k^=one]", "starts-with(@k, 'one')" },
        { "[k$='TWO' i]", "substring(@k, string-length(@k) - 2) = 'two'" },
        { "[k*='e t']", "contains(@k, 'e t')" },
        { ":first-child", "not(preceding-sibling::*)" },
        { ":last-child", "not(following-sibling::*)" },
        { ":only-child", "not(preceding-sibling::* or following-sibling::*)" },
        { ":nth-child(2n + 1)", "count(preceding-sibling::*) mod 2 = 0" },
        { ":nth-child(even)", "count(preceding-sibling::*) mod 2 = 1" },
        { ":nth-child(-n+2)", "count(preceding-sibling::*) < 2" },
        { ":nth-last-child(2)", "count(following-sibling::*) = 1" },
        { ":root", "not(parent::*)" },
        { ":empty", "not(node())" },
        { ":hover", "false()" },
        { ":not(.x, [k])",
          "not(@k or contains(concat(' ', translate(@class, '\t', ' '), ' '), ' x '))" },
        { ":is(g, #i3)", "(self::g or @id = 'i3')" },
        { ":not(g > path)", "not(self::path and parent::g)" }
    };
    static const char *const typed[][3] = {
        { ":first-of-type", "not(preceding-sibling::", ")" },
        { ":last-of-type", "not(following-sibling::", ")" },
        { ":nth-of-type(2)", "count(preceding-sibling::", ") = 1" },
        { ":nth-last-of-type(odd)", "count(following-sibling::", ") mod 2 = 0" }
    };

    if (*type != '\0' && arb_below(a, 4) == 0) {
        const char *const *one = typed[arb_below(a, 4)];
        strcat(css, one[0]);
        sprintf(path + strlen(path), " and %s%s%s", one[1], type, one[2]);
        return;
    }
    const unsigned which = arb_below(a, sizeof both / sizeof both[0]);
    strcat(css, both[which][0]);
    sprintf(path + strlen(path), " and %s", both[which][1]);
}

/* A compound, and the ones to its left. */
static void add_selector(arb *a, int left, char *css, char *path)
{
    static const char *const types[]   = { "", "g", "path", "rect" };
    static const char *const joins[][2] = { { " ", "ancestor::*" },
                                            { " > ", "parent::*" },
                                            { ">", "parent::*" },
                                            { "+", "preceding-sibling::*[1]" },
                                            { " ~ ", "preceding-sibling::*" } };
    const char *type                   = types[arb_below(a, 4)];
    char before[ROOM] = "", within[ROOM] = "", own[300] = "";

    strcat(path, *type != '\0' ? "self::" : "true()");
    strcat(path, type);
    strcat(own, *type == '\0' ? "*" : type);
    for (unsigned n = arb_below(a, 3); n > 0; n--)
        add_test(a, type, own, path);
    if (left > 0) {
        const char *const *join = joins[arb_below(a, 5)];
        add_selector(a, left - 1, before, within);
        sprintf(path + strlen(path), " and %s[%s]", join[1], within);
        strcat(css, before);
        strcat(css, join[0]);
    }
    strcat(css, own);
}

static bool is_in(const xmlNodeSet *set, const xmlNode *node)
{
    for (int i = 0; set != NULL && i < set->nodeNr; i++)
        if (set->nodeTab[i] == node)
            return true;
    return false;
}

static const xmlNode *following(const xmlNode *node)
{
    if (node->children != NULL)
        return node->children;
    while (node != NULL && node->next == NULL)
        node = node->parent;
    return node ? node->next : NULL;
}

static void selectors_match_as_xpath_says(arb *a)
{
    char text[ROOM] = "<svg id='i-1'>", css[ROOM] = "", path[ROOM] = "", all[ROOM + 10];
    svg_notes notes = { .warned = 0 };
    svg_reader r    = { .notes = &notes };
    int count       = 0;

    add_elements(a, text, 3, &count);
    strcat(text, "</svg>");
    add_selector(a, (int)arb_below(a, 4), css, path);
    snprintf(all, sizeof all, "//*[%s]", path);
    xmlDoc *doc              = xmlReadMemory(text, (int)strlen(text), NULL, NULL, 0);
    xmlXPathContext *context = xmlXPathNewContext(doc);
    xmlXPathObject *found    = xmlXPathEvalExpression((const xmlChar *)all, context);
    svg_selector *s          = svg_selector_read(css, strlen(css));
    CHECK(found != NULL && s != NULL);
    for (const xmlNode *node = xmlDocGetRootElement(doc);
         node != NULL && s != NULL && found != NULL; node = following(node)) {
        const bool asked = node->type == XML_ELEMENT_NODE && arb_below(a, 4);
        if (asked && svg_selector_matches(&r, s, node) != is_in(found->nodesetval, node)) {
            printf("%s\n%s\n%s\n", css, all, text);
            check_bad = true;
            break;
        }
    }
    if (s != NULL)
        svg_selector_free(s);
    xmlXPathFreeObject(found);
    xmlXPathFreeContext(context);
    xmlFreeDoc(doc);
}

static void ranks_are_those_of_css(arb *a)
{
    static const struct {
        const char *text;
        unsigned rank;
    } all[] = { { "*", 0 },
                { "g", 1 },
                { "g path", 2 },
                { "g > *.a", 0x101 },
                { "[k]", 0x100 },
                { "path:first-child", 0x101 },
                { "#i.a", 0x10100 },
                { ":not(#i, .a b)", 0x10000 },
                { ":where(#i) g", 1 },
                { ":is(g, .a)", 0x100 },
                { "svg|path", 1 },
                { ".a\\:b", 0x100 } };
    (void)a;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        svg_selector *s = svg_selector_read(all[i].text, strlen(all[i].text));
        CHECK(s != NULL);
        if (s == NULL)
            continue;
        if (svg_selector_rank(s) != all[i].rank)
            printf("%s: %x\n", all[i].text, svg_selector_rank(s));
        CHECK(svg_selector_rank(s) == all[i].rank);
        svg_selector_free(s);
    }
}

static void what_is_no_selector_is_not_understood(arb *a)
{
    static const char *const all[] = { "",
                                       ">",
                                       "g >",
                                       "> g",
                                       "g,",
                                       "[k",
                                       "[k=]",
                                       "[=k]",
                                       "g..a",
                                       "#",
                                       ":not(g",
                                       ":not()",
                                       ":huh",
                                       "g:nth-child(x)",
                                       ":nth-child()",
                                       "a b )",
                                       "[k='a]",
                                       ":lang(en)",
                                       "g::part(x)",
                                       "g $ a",
                                       "{" };
    (void)a;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        svg_selector *s = svg_selector_read(all[i], strlen(all[i]));
        if (s != NULL) {
            printf("understood: %s\n", all[i]);
            svg_selector_free(s);
        }
        CHECK(s == NULL);
    }
}

/* For any bytes, reading ends. */
static void damaged_selectors_do_no_harm(arb *a)
{
    static const char whole[] =
        "g.a > path:not([k='x y'], #i):nth-child(2n+1) + *:is(a|b, c) ~ \\61 b";
    static const char bits[]  = ".#:[]()'\"\\>+~,|=^$* ng1-\x80";
    char text[sizeof whole];

    memcpy(text, whole, sizeof whole);
    for (unsigned n = 1 + arb_below(a, 5); n > 0; n--)
        text[arb_below(a, sizeof whole - 1)] = bits[arb_below(a, sizeof bits - 1)];
    svg_selector *s = svg_selector_read(text, arb_below(a, sizeof whole));
    if (s != NULL)
        svg_selector_free(s);
    CHECK(true);
}

#define P(k) "<path id='p" #k "' d='M" #k " 1h1'/>"

/* The rule with the highest rank wins; what is not understood is told once, and only if it would
 * set something. */
static void sheets_are_cascades(arb *a)
{
    drawing d;
    (void)a;
    DRAWS("<style>g > path{display:none} svg #p2{display:inline}</style><g>" P(1) P(2) "</g>",
          "M 2 1 L 3 1");
    DRAWS("<style>path:first-of-type{display:none} path{display:inline}</style><g>" P(1)
              P(2) "</g>",
          "M 2 1 L 3 1");
    DRAWS("<style>[id='p1'],[d^=\"M2, {;\"]{display:none}</style>" P(1) P(2), "M 2 1 L 3 1");
    DRAWS("<style>@media print{path{display:none}} @media screen,print{#p1{display:none}}"
          "@font-face{src:url(x;y)} @media screen{@media print{#p2{display:none}}}</style>" P(1)
              P(2),
          "M 2 1 L 3 1");
    DRAWS("<style media='print'>path{display:none}</style><style type='text/x'>#p2{display:none}"
          "</style><style>#p1{fill:url(data:a;b);display:none}</style>" P(1) P(2),
          "M 2 1 L 3 1");
    DRAWS("<style>#p1{fill:none}</style><path id='p1' style='/* fill:red; */ stroke:none' d='M1 "
          "1h1'/>" P(2),
          "M 2 1 L 3 1");
    CHECK(caught_lines == 1);           /* of the first, invisible */
    DRAWS("<style>path:lang(en){cursor:move} path:hover{display:none}</style>" P(2), "M 2 1 L 3 1");
    CHECK(caught_lines == 0);
    DRAWS("<style>path:lang(en){stroke:red} path:has(a){fill:none}</style>" P(2), "M 2 1 L 3 1");
    CHECK(caught_lines == 1 && strstr(caught, "\"path:lang(en)\" is not understood") != NULL);
    CHECK(read_svg(&d, PAGE("<style>@import 'a.css'; @media (width > 9px) {path{fill:none}}"
                            "</style>" P(2))) == 0 &&
          caught_lines == 1 && strstr(caught, "@import") != NULL);
    drawing_free(&d);
}

/* Places among siblings are found in passing: no rule makes many elements slow. */
static void places_among_many_cost_little(arb *a)
{
    enum { MANY = 20000 };
    static char text[MANY * 30 + 400];
    char *end = text + sprintf(text,
                               "<svg xmlns='http://www.w3.org/2000/svg'><style>"
                               "path:nth-child(2n){fill:none} path:nth-last-child(3){fill:red}"
                               " path:nth-of-type(2){fill:none} path:last-of-type{fill:none}"
                               "</style>");
    drawing d;
    (void)a;
    for (int i = 0; i < MANY; i++)
        end += sprintf(end, "<path d='M0 0H1'/>");
    strcpy(end, "</svg>");
    CHECK(read_svg(&d, text) == 0 && d.count == MANY / 2 - 2);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(selectors_match_as_xpath_says, 4000);
    PROPERTY(ranks_are_those_of_css, 1);
    PROPERTY(what_is_no_selector_is_not_understood, 1);
    PROPERTY(damaged_selectors_do_no_harm, 3000);
    PROPERTY(sheets_are_cascades, 1);
    PROPERTY(places_among_many_cost_little, 1);
    return check_failures();
}
