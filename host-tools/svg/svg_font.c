/* host-tools/svg/svg_font.c -- the properties of fonts, as in CSS
 * SPDX-License-Identifier: MIT
 *
 * As CSS says, a value that cannot be read changes nothing.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/scan.h"       /* scan_number */
#include "svg/svg.h"

#define LARGER 1.2          /* CSS Fonts Level 4, 2.5.1 */
#define SUPER  0.33         /* em, as librsvg and browsers shift a baseline */
#define SUB    0.2
#define SIZE_MAX_EM 1e6     /* px: larger letters are beyond any page */

svg_font svg_font_usual(void) { return (svg_font){ .size = SVG_FONT_SIZE_USUAL, .weight = 400 }; }

typedef struct {
    const char *name;
    double value;
} word;

/* The value of a word, or false. */
static bool word_value(const word words[], size_t count, const char *text, double *out)
{
    for (size_t i = 0; i < count; i++)
        if (strcasecmp(words[i].name, text) == 0) {
            *out = words[i].value;
            return true;
        }
    return false;
}
#define WORD_VALUE(words, text, out) word_value(words, sizeof words / sizeof words[0], text, out)


// One property
// ------------

static bool set_size(svg_font *f, const svg_space *space, const char *text)
{
    static const word sizes[] = { { "xx-small", 9 }, { "x-small", 10 },  { "small", 13 },
                                  { "medium", 16 },  { "large", 18 },    { "x-large", 24 },
                                  { "xx-large", 32 }, { "xxx-large", 48 } };
    double size;

    if (strcasecmp(text, "larger") == 0)
        size = f->size * LARGER;
    else if (strcasecmp(text, "smaller") == 0)
        size = f->size / LARGER;
    else if (!WORD_VALUE(sizes, text, &size) && !svg_css_length(space, text, f->size, &size))
        return false;
    if (!(size >= 0))
        return false;
    f->size = fmin(size, SIZE_MAX_EM);
    return true;
}

static bool set_weight(svg_font *f, const char *text)
{
    static const word weights[] = { { "normal", 400 }, { "bold", 700 } };
    const char *at = text;
    double weight;

    if (strcasecmp(text, "bolder") == 0)
        weight = f->weight < 350 ? 400 : f->weight < 550 ? 700 : 900;
    else if (strcasecmp(text, "lighter") == 0)
        weight = f->weight < 550 ? 100 : f->weight < 750 ? 400 : 700;
    else if (!WORD_VALUE(weights, text, &weight) && !(scan_number(&at, &weight) && *at == '\0'))
        return false;
    if (!(weight >= 1 && weight <= 1000))
        return false;
    f->weight = (int)weight;
    return true;
}

static bool set_slant(svg_font *f, const char *text)
{
    static const word slants[] = { { "normal", 0 }, { "oblique", 1 }, { "italic", 2 } };
    double slant;

    if (strncasecmp(text, "oblique ", 8) == 0)      /* its angle is that of the font */
        text = "oblique";
    if (!WORD_VALUE(slants, text, &slant))
        return false;
    f->slant = (int)slant;
    return true;
}

static bool set_stretch(svg_font *f, const char *text)
{
    static const word stretches[] = { { "ultra-condensed", -4 }, { "extra-condensed", -3 },
                                      { "condensed", -2 },       { "semi-condensed", -1 },
                                      { "normal", 0 },           { "semi-expanded", 1 },
                                      { "expanded", 2 },         { "extra-expanded", 3 },
                                      { "ultra-expanded", 4 } };
    double stretch;

    if (!WORD_VALUE(stretches, text, &stretch))
        return false;
    f->stretch = (int)stretch;
    return true;
}

static bool set_caps(svg_font *f, const char *text)
{
    static const word caps[] = { { "normal", 0 }, { "small-caps", 1 } };
    double small;

    if (!WORD_VALUE(caps, text, &small))
        return false;
    f->small_caps = small > 0;
    return true;
}

/* A list of names, without quotes. */
static void set_family(svg_reader *r, svg_font *f, const char *text)
{
    char *plain = strdup(text), *to = plain;

    if (plain == NULL)
        return;
    for (const char *at = text; *at != '\0'; at++)
        if (*at != '"' && *at != '\'')
            *to++ = *at;
    *to = '\0';
    f->family = (const char *)xmlDictLookup(r->words, (const xmlChar *)plain, -1);
    free(plain);
}

/* The shorthand: `italic bold 12px/1.2 "Times New Roman", serif`. */
static void set_shorthand(svg_reader *r, const svg_space *space, svg_font *f, const char *text)
{
    svg_font made = svg_font_usual();
    char one[40];

    made.size = f->size;
    for (const char *at = text; scan_space(&at), *at != '\0';) {
        const size_t length = strcspn(at, " \t\r\n\f/");
        if (length >= sizeof one)
            return;
        memcpy(one, at, length);
        one[length] = '\0';
        at += length;
        if (set_slant(&made, one) || set_caps(&made, one) || set_stretch(&made, one) ||
            (strspn(one, "0123456789") == length ? set_weight(&made, one) : false) ||
            strcasecmp(one, "bold") == 0 || strcasecmp(one, "bolder") == 0 ||
            strcasecmp(one, "lighter") == 0) {
            (void)set_weight(&made, one);
            continue;
        }
        if (!set_size(&made, space, one))
            return;
        scan_space(&at);
        if (*at == '/')
            at += strcspn(at, " \t\r\n\f");
        scan_space(&at);
        f->size       = made.size;
        f->weight     = made.weight;
        f->slant      = made.slant;
        f->stretch    = made.stretch;
        f->small_caps = made.small_caps;
        f->plain      = false;
        set_family(r, f, at);
        return;
    }
}

static void set_anchor(svg_font *f, const char *text)
{
    static const word anchors[] = { { "start", SVG_ANCHOR_START },
                                    { "middle", SVG_ANCHOR_MIDDLE },
                                    { "end", SVG_ANCHOR_END } };
    double anchor;

    if (WORD_VALUE(anchors, text, &anchor))
        f->anchor = (enum svg_anchor)(int)anchor;
}

static void set_baseline(enum svg_baseline *to, const char *text)
{
    static const word baselines[] = { { "auto", SVG_USUAL },
                                      { "baseline", SVG_USUAL },
                                      { "alphabetic", SVG_ALPHABETIC },
                                      { "middle", SVG_MIDDLE },
                                      { "central", SVG_CENTRAL },
                                      { "center", SVG_CENTRAL },
                                      { "hanging", SVG_HANGING },
                                      { "mathematical", SVG_MATHEMATICAL },
                                      { "text-before-edge", SVG_TOP },
                                      { "before-edge", SVG_TOP },
                                      { "text-top", SVG_TOP },
                                      { "top", SVG_TOP },
                                      { "ideographic", SVG_BOTTOM },
                                      { "text-after-edge", SVG_BOTTOM },
                                      { "after-edge", SVG_BOTTOM },
                                      { "text-bottom", SVG_BOTTOM },
                                      { "bottom", SVG_BOTTOM } };
    double baseline;

    if (WORD_VALUE(baselines, text, &baseline))
        *to = (enum svg_baseline)(int)baseline;
}

/* Shifts of nested elements add up. */
static void add_shift(svg_font *f, const svg_space *space, const char *text)
{
    double by;

    if (strcasecmp(text, "super") == 0)
        f->shift += SUPER * f->size;
    else if (strcasecmp(text, "sub") == 0)
        f->shift -= SUB * f->size;
    else if (svg_css_length(space, text, f->size, &by))
        f->shift += by;
}

static void set_spacing(const svg_space *space, const char *text, double *out)
{
    if (strcasecmp(text, "normal") == 0)
        *out = 0;
    else
        (void)svg_css_length(space, text, space->font.size, out);
}

/* A list of words: lines, and how they look. With any other word it means nothing. */
static void add_decoration(svg_reader *r, svg_font *f, const char *text)
{
    static const char *const words[] = {
        "underline", "overline", "line-through", "none",   "blink",
        "solid",     "double",   "dotted",       "dashed", "wavy"
    };
    bool has[10]                     = { false };

    for (const char *at = text; scan_space(&at), *at != '\0';) {
        const size_t length = strcspn(at, " \t\r\n\f");
        size_t i            = 0;
        while (i < 10 && !(strlen(words[i]) == length && strncasecmp(words[i], at, length) == 0))
            i++;
        if (i == 10 && *at >= 'a' && memchr(at, ',', length) && !memchr(at, '(', length))
            return;
        if (i < 10)
            has[i] = true;
        at += length;
    }
    f->underlined = f->underlined || has[0];
    f->overlined  = f->overlined || has[1];
    f->struck     = f->struck || has[2];
    for (size_t i = 6; i < 10; i++)
        if (has[i])
            svg_warn(r, SVG_WARN_TEXT_STYLE,
                     "text-decoration: %s is drawn solid: convert text to paths", words[i]);
}

/* What text is drawn without, unless it is as usual. */
static void tell_undone(svg_reader *r, enum svg_property which, const char *text)
{
    static const char *const usual[] = { "none", "normal", "auto", "solid", "initial", "revert" };

    for (size_t i = which == SVG_FONT_LIGATURES; i < sizeof usual / sizeof *usual; i++)
        if (strcasecmp(text, usual[i]) == 0)
            return;
    svg_warn(r, SVG_WARN_TEXT_STYLE, "%s: %.20s is not applied: convert text to paths",
             svg_property_name(which), text);
}


// All of them
// -----------

static void set_property(svg_reader *r, svg_space *space, enum svg_property which, const char *text)
{
    svg_font *f = &space->font;

    switch (which) {
    case SVG_FONT:             set_shorthand(r, space, f, text);             break;
    case SVG_FONT_SIZE:        (void)set_size(f, space, text);               break;
    case SVG_FONT_FAMILY:      set_family(r, f, text);                       break;
    case SVG_FONT_STYLE:       (void)set_slant(f, text);                     break;
    case SVG_FONT_WEIGHT:      (void)set_weight(f, text);                    break;
    case SVG_FONT_STRETCH:     (void)set_stretch(f, text);                   break;
    case SVG_FONT_CAPS:
    case SVG_FONT_VARIANT:     (void)set_caps(f, text);                      break;
    case SVG_FONT_KERNING:     f->plain = strcasecmp(text, "none") == 0;     break;
    case SVG_LETTER_SPACING:   set_spacing(space, text, &f->letter);         break;
    case SVG_WORD_SPACING:     set_spacing(space, text, &f->word);           break;
    case SVG_TEXT_ANCHOR:      set_anchor(f, text);                          break;
    case SVG_DECORATION_LINE:
    case SVG_TEXT_DECORATION:  add_decoration(r, f, text);                   break;
    case SVG_BASELINE:         set_baseline(&f->baseline, text);             break;
    case SVG_BASELINE_OWN:     set_baseline(&f->own_baseline, text);         break;
    case SVG_BASELINE_SHIFT:   add_shift(f, space, text);                    break;
    case SVG_DIRECTION:        f->leftwards = strcasecmp(text, "rtl") == 0;  break;
    case SVG_WHITE_SPACE:
        f->keeps_space = strncasecmp(text, "pre", 3) == 0 || strcasecmp(text, "break-spaces") == 0;
        break;
    case SVG_WRITING_MODE:
        if (strncasecmp(text, "tb", 2) == 0 || strncasecmp(text, "vertical", 8) == 0)
            svg_warn(r, SVG_WARN_UPRIGHT,
                     "writing-mode: %.20s is read as horizontal: convert text to paths", text);
        break;
    default:
        if (which >= SVG_DECORATION_STYLE)
            tell_undone(r, which, text);
        break;
    }
}

void svg_font_enter(svg_reader *r, const svg_style *style, svg_space *space)
{
    const enum svg_baseline around = space->font.own_baseline;

    space->font.own_baseline = SVG_USUAL;       /* it is not inherited, */
    if (svg_is(r->node, "text"))
        space->font.shift = 0;                  /* nor is what shifts what is around a text */
    for (int which = SVG_FONT; which < SVG_PROPERTIES; which++) {
        const bool attribute = style->attributes & 1ull << which && which != SVG_FONT_KERNING;
        if (style->value[which].text == NULL && !attribute)
            continue;
        char *text = svg_property(r, style, (enum svg_property)which, NULL);
        if (text != NULL && strcmp(text, "inherit") != 0 && strcmp(text, "unset") != 0) {
            svg_font usual = svg_font_usual();
            if (strcmp(text, "initial") == 0 && which == SVG_FONT_SIZE)
                space->font.size = usual.size;
            else
                set_property(r, space, (enum svg_property)which, text);
        }
        if (text != NULL && strcmp(text, "inherit") == 0 && which == SVG_BASELINE_OWN)
            space->font.own_baseline = around;
        xmlFree(text);
    }
    xmlChar *kept = xmlGetNsProp(r->node, (const xmlChar *)"space", XML_XML_NAMESPACE);
    if (kept != NULL)
        space->font.keeps_space = strcmp((const char *)kept, "preserve") == 0;
    xmlFree(kept);
}
