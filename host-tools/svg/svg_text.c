/* host-tools/svg/svg_text.c -- text: its letters, their places, and their outlines or lines
 * SPDX-License-Identifier: MIT
 *
 * All letters of a <text> are collected first, each with the x, y, dx, dy and rotate that lists of
 * its elements give it: those of inner elements win. A letter with an x or a y of its own begins a
 * chunk, which text-anchor moves as a whole. Letters without a place of their own between them make
 * a run, which is shaped as one.
 *   see  SVG 2, 11.5: Text layout algorithm; the white space is that of CSS Text 3, 4.1
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"       /* tool_grow */
#include "svg/svg.h"

#define LETTERS_MAX 200000u     /* drawn ones, counting those of each <use>: a few seconds */
#define RUN_COST    8           /* letters: what it takes to begin a run */
#define DEGREE 0.017453292519943295769

enum { HAS_X = 1, HAS_Y = 2, HAS_PLACE = HAS_X | HAS_Y, HAS_DX = 4, HAS_DY = 8 };

/* The letters of one element that follow each other. */
typedef struct {
    svg_space space;
    const xmlNode *node, *path;     /* path: what they follow, or NULL */
    double offset;                  /* where on it they begin; */
    bool part;                      /* as a part of its length */
} stretch;

typedef struct {
    unsigned at;                    /* its first byte */
    unsigned stretch;
    unsigned char has;
    double x, y, dx, dy, rotate;
} letter;

/* An element with textLength. */
typedef struct {
    size_t first, last;             /* its letters */
    double length;
    bool widens;                    /* lengthAdjust: the letters too */
} fitting;

typedef struct {
    svg_reader *r;
    char *text;
    size_t size, text_room;
    letter *letter;                 /* and one more, at the end of the text */
    size_t count, room;
    stretch *stretch;
    size_t stretches, stretch_room;
    fitting *fit;
    size_t fits;
    bool blank;                     /* the last letter is a space that no other one may follow */
} collection;

void svg_shaped_add(svg_shaped *s, size_t from, double advance)
{
    if (s->clusters == s->cluster_room) {
        s->cluster_room = s->cluster_room ? 2 * s->cluster_room : 32;
        s->cluster      = tool_grow(s->cluster, s->cluster_room * sizeof *s->cluster);
    }
    s->cluster[s->clusters++] = (svg_cluster){ from, advance, s->parts, 0, false };
}

void svg_shaped_part(svg_shaped *s, char kind, const double p[], int points)
{
    if (s->parts == s->part_room) {
        s->part_room = s->part_room ? 2 * s->part_room : 128;
        s->part      = tool_grow(s->part, s->part_room * sizeof *s->part);
    }
    s->part[s->parts] = (svg_part){ .kind = kind };
    for (int k = 0; k < 2 * points; k++)
        s->part[s->parts].p[k / 2][k % 2] = p[k];
    s->parts++;
    s->cluster[s->clusters - 1].count++;
}

void svg_shaped_free(svg_shaped *s)
{
    free(s->cluster);
    free(s->part);
    *s = (svg_shaped){ .cluster = NULL };
}


// Letters
// -------

static void add_letter(collection *c, const char *bytes, size_t length)
{
    if (c->count + 1 >= c->room) {
        c->room   = c->room ? 2 * c->room : 64;
        c->letter = tool_grow(c->letter, c->room * sizeof *c->letter);
    }
    if (c->size + length >= c->text_room) {
        c->text_room = 2 * c->text_room + 64;
        c->text      = tool_grow(c->text, c->text_room);
    }
    memcpy(c->text + c->size, bytes, length);
    c->letter[c->count++] =
        (letter){ .at = (unsigned)c->size, .stretch = (unsigned)c->stretches - 1, .rotate = NAN };
    c->size += length;
    c->text[c->size]       = '\0';
    c->letter[c->count].at = (unsigned)c->size;
}

static void add_text(collection *c, const char *text, bool keeps_space)
{
    for (const char *at = text; *at != '\0';) {
        size_t length    = 1;
        const bool space = strchr(" \t\r\n\f", *at) != NULL;
        while (((unsigned char)at[length] & 0xC0) == 0x80)
            length++;
        if (!space)
            add_letter(c, at, length);
        else if (keeps_space || !c->blank)
            add_letter(c, " ", 1);
        c->blank = space && !keeps_space;
        at += length;
    }
}

/* `like` says what they follow. */
static bool begin_stretch(collection *c, const svg_space *space, const xmlNode *node,
                          const stretch *like)
{
    if (c->stretches == c->stretch_room) {
        c->stretch_room = c->stretch_room ? 2 * c->stretch_room : 8;
        c->stretch      = tool_grow(c->stretch, c->stretch_room * sizeof *c->stretch);
    }
    c->stretch[c->stretches++] = (stretch){ *space, node, like->path, like->offset, like->part };
    c->stretch[c->stretches - 1].space.scope = NULL;
    return true;
}

/* What the lists of one element say. */
typedef struct {
    double *value[5];           /* x, y, dx, dy, rotate */
    size_t count[5];
} lists;

static void read_lists(svg_reader *r, const svg_space *space, lists *l)
{
    static const char *const names[]     = { "x", "y", "dx", "dy", "rotate" };
    static const enum svg_side sides[]   = { SVG_ACROSS, SVG_ALONG_Y, SVG_ACROSS, SVG_ALONG_Y,
                                             SVG_DIAGONAL };

    *l = (lists){ .count = { 0 } };
    for (int k = 0; k < 5; k++) {
        char *text        = svg_attribute(r->node, names[k]);
        const size_t room = text ? strlen(text) : 0;
        const bool plain  = room == 0 || strspn(text, "0123456789.+-eE, \t\r\n\f") == room;
        xmlFree(text);
        if (room == 0)
            continue;
        l->value[k] = tool_grow(NULL, room * sizeof *l->value[k]);
        l->count[k] = svg_lengths(r, space, names[k], sides[k], l->value[k], room);
        if (k == 4 && !plain) {         /* angles have no units */
            svg_warn(r, SVG_WARN_LENGTH, "rotate is not used: give a list of numbers");
            l->count[k] = 0;
        }
    }
}

static void free_lists(lists *l)
{
    for (int k = 0; k < 5; k++)
        free(l->value[k]);
}

/* Inner elements were applied before: what they said stays. */
static void apply_lists(collection *c, const lists *l, size_t first)
{
    static const unsigned char bits[4] = { HAS_X, HAS_Y, HAS_DX, HAS_DY };

    for (size_t i = first; i < c->count; i++) {
        letter *to         = &c->letter[i];
        const size_t n     = i - first;
        double *const at[] = { &to->x, &to->y, &to->dx, &to->dy };
        for (int k = 0; k < 4; k++)
            if (n < l->count[k] && !(to->has & bits[k])) {
                *at[k] = l->value[k][n];
                to->has |= bits[k];
            }
        if (l->count[4] > 0 && isnan(to->rotate))
            to->rotate = l->value[4][n < l->count[4] ? n : l->count[4] - 1];
    }
}

static void note_length(collection *c, const xmlNode *node, const svg_space *space, size_t first)
{
    c->r->node          = node;
    const double length = svg_size(c->r, space, "textLength", SVG_ACROSS, -1);
    char *adjust        = svg_attribute(node, "lengthAdjust");

    if (length >= 0 && c->count > first) {
        c->fit            = tool_grow(c->fit, (c->fits + 1) * sizeof *c->fit);
        c->fit[c->fits++] = (fitting){ first, c->count, length,
                                       adjust != NULL && strcmp(adjust, "spacingAndGlyphs") == 0 };
    }
    xmlFree(adjust);
}

static bool collect(collection *c, const xmlNode *node, const svg_space *space,
                    const stretch *like);

/* What a <textPath> follows, and where it begins there. */
static void read_path(collection *c, const svg_space *space, stretch *out)
{
    char *href = svg_reference(c->r->node);

    *out = (stretch){ .path = href && href[0] == '#' ? svg_find(c->r, href + 1) : NULL };
    if (out->path == NULL)
        svg_warn(c->r, SVG_WARN_TEXT,
                 "<textPath> of \"%.60s\" is not drawn, no element has this id", href ? href : "");
    xmlFree(href);
    char *text = svg_attribute(c->r->node, "startOffset");
    out->part  = text != NULL && strchr(text, '%') != NULL;
    if (out->part)
        out->offset = strtod(text, NULL) / 100;
    xmlFree(text);
    if (!out->part)
        out->offset = svg_length(c->r, space, "startOffset", SVG_DIAGONAL, 0);
}

static bool collect_child(collection *c, const xmlNode *node, svg_space space, const stretch *like)
{
    const svg_matrix to_mm = space.to_mm;
    stretch own            = *like;
    svg_scope scope;
    bool shown;

    c->r->node  = node;
    bool good   = svg_enter(c->r, &space, &scope, &shown);
    space.to_mm = to_mm;        /* parts of a text have no transform */
    if (good && shown && svg_is(node, "textPath"))
        read_path(c, &space, &own);
    if (good && shown && !(svg_is(node, "textPath") && own.path == NULL))
        good = collect(c, node, &space, &own);
    svg_scope_close(&scope);
    return good;
}

/* The letters of an element and of those in it. */
static bool collect(collection *c, const xmlNode *node, const svg_space *space, const stretch *like)
{
    const size_t first = c->count;
    lists l;

    c->r->node = node;
    bool good  = true;
    read_lists(c->r, space, &l);
    if (++c->r->depth > SVG_DEPTH_MAX)
        good = good &&
               svg_fail(c->r, "more than %d nested elements: draw with fewer", SVG_DEPTH_MAX);
    bool begun = false;
    for (const xmlNode *child = node->children; child != NULL && good; child = child->next) {
        if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE) {
            begun = begun || begin_stretch(c, space, node, like);
            add_text(c, (const char *)child->content, space->font.keeps_space);
        } else if (svg_is(child, "tspan") || svg_is(child, "a") || svg_is(child, "textPath")) {
            good  = collect_child(c, child, *space, like);
            begun = false;
        } else if (svg_is(child, "tref")) {
            c->r->node = child;
            svg_warn(c->r, SVG_WARN_TEXT, "<tref> is not drawn: write its text");
        }
    }
    c->r->depth--;
    if (good)
        apply_lists(c, &l, first);
    if (good)
        note_length(c, node, space, first);
    free_lists(&l);
    return good;
}


// Runs
// ----

typedef struct {
    size_t first, last;         /* letters */
    svg_shaped shaped;
    double wider, gap;          /* by textLength: the factor of its letters, and what is added
                                 * behind each; */
    size_t gaps;                /* behind so many */
    double advance;             /* user units, with dx */
} run;

typedef struct {
    collection *c;
    run *all;
    size_t count, room;
    double at[2];               /* where the next letter goes */
} layout;

static const svg_font *font_of(const layout *l, const run *u)
{
    return &l->c->stretch[l->c->letter[u->first].stretch].space.font;
}

/* The spacing behind a cluster. */
static double gap_after(const layout *l, const run *u, size_t cluster)
{
    const svg_font *f = font_of(l, u);
    const char *text  = l->c->text + l->c->letter[u->first].at + u->shaped.cluster[cluster].from;

    return f->letter + (*text == ' ' ? f->word : 0);
}

static bool shape_run(layout *l, run *u)
{
    svg_reader *r       = l->c->r;
    const letter *first = &l->c->letter[u->first];
    const char *text    = l->c->text + first->at;
    const size_t length = l->c->letter[u->last].at - first->at;
    const svg_font *f   = font_of(l, u);
    const bool lines    = r->d->text != NULL && strncmp(r->d->text, "line", 4) == 0;

    r->node = l->c->stretch[first->stretch].node;
    r->letters += (unsigned)(u->last - u->first) + RUN_COST;
    if (r->letters > LETTERS_MAX)
        return svg_fail(r, "more than %u letters, counting each use: split the drawing",
                        LETTERS_MAX);
    if (lines) {
        if (!svg_lines_shape(r, f, text, length, &u->shaped))
            return false;
        if (u->shaped.outlined)
            svg_warn(r, SVG_WARN_LINE,
                     "\"%.40s\" has letters without single lines, which are drawn as outlines: use "
                     "letters of Latin 1",
                     text);
    } else if (!svg_glyphs_shape(r, f, text, length, &u->shaped)) {
        return svg_warn(r, SVG_WARN_TEXT, "<text> is not drawn: convert text to paths"), true;
    }
    if (u->shaped.missing)
        svg_warn(r, SVG_WARN_LETTER,
                 "a letter of \"%.40s\" is in no font and not drawn: install a font with it", text);
    u->advance = first->dx;
    for (size_t k = 0; k < u->shaped.clusters; k++)
        u->advance += u->shaped.cluster[k].advance * f->size + gap_after(l, u, k);
    return true;
}

/* Does a run begin at letter i? */
static bool begins_run(const collection *c, size_t i)
{
    const letter *a = &c->letter[i];

    if (i == 0 || a->stretch != a[-1].stretch || a->has & HAS_PLACE)
        return true;
    return fabs(a->dx) > 0 || fabs(a->dy) > 0 ||
           (isnan(a->rotate) ? !isnan(a[-1].rotate) : !(fabs(a->rotate - a[-1].rotate) <= 0));
}

/* Make the letters of an element as long as its textLength: by gaps between them, or by their
 * width. Inner elements come first. */
static void fit_runs(layout *l, const fitting *f)
{
    double natural = 0;
    size_t letters = 0;

    for (size_t k = 0; k < l->count; k++)
        if (l->all[k].first >= f->first && l->all[k].first < f->last) {
            natural += l->all[k].advance;
            letters += l->all[k].shaped.clusters;
        }
    if (!(natural > 0))
        return;
    for (size_t k = 0; k < l->count; k++) {
        run *u = &l->all[k];
        if (u->first < f->first || u->first >= f->last)
            continue;
        if (f->widens) {
            u->wider *= f->length / natural;
            u->advance *= f->length / natural;
            continue;
        }
        const bool ends = k + 1 == l->count || l->all[k + 1].first >= f->last;
        if (letters < 2)
            return;
        const double gap = (f->length - natural) / (double)(letters - 1);
        u->gaps          = u->shaped.clusters - (ends && u->shaped.clusters > 0);
        u->gap += gap;
        u->advance += gap * (double)u->gaps;
    }
}

static bool make_runs(layout *l)
{
    for (size_t i = 0; i < l->c->count; i++) {
        if (!begins_run(l->c, i)) {
            l->all[l->count - 1].last = i + 1;
            continue;
        }
        if (l->count == l->room) {
            l->room = l->room ? 2 * l->room : 16;
            l->all  = tool_grow(l->all, l->room * sizeof *l->all);
        }
        l->all[l->count++] = (run){ .first = i, .last = i + 1, .wider = 1 };
    }
    for (size_t k = 0; k < l->count; k++)
        if (!shape_run(l, &l->all[k]))
            return false;
    for (size_t k = 0; k < l->c->fits; k++)
        fit_runs(l, &l->c->fit[k]);
    return true;
}


// Drawing
// -------

static bool draw_cluster(svg_reader *r, const svg_shaped *s, size_t which, svg_matrix m)
{
    const svg_cluster *c = &s->cluster[which];
    svg_pen pen          = svg_pen_at(r, m);
    bool good            = true;

    for (size_t i = c->first; i < c->first + c->count && good; i++) {
        const svg_part *p = &s->part[i];
        switch (p->kind) {
        case 'M': svg_move(&pen, p->p[0][0], p->p[0][1]);                           break;
        case 'L': good = svg_line(&pen, p->p[0][0], p->p[0][1]);                    break;
        case 'C':
            good = svg_cubic(&pen, p->p[0][0], p->p[0][1], p->p[1][0], p->p[1][1], p->p[2][0],
                             p->p[2][1]);
            break;
        default:  good = svg_close(&pen);                                           break;
        }
    }
    return good;
}

static double shift_of(const svg_font *f, const svg_shaped *s)
{
    double up = 0;

    switch (f->baseline) {
    case SVG_ALPHABETIC: up = 0;                              break;
    case SVG_MIDDLE:     up = -0.25;                          break;
    case SVG_CENTRAL:    up = (s->descent - s->ascent) / 2;   break;
    case SVG_HANGING:    up = -0.8 * s->ascent;               break;
    case SVG_TOP:        up = -s->ascent;                     break;
    case SVG_BOTTOM:     up = s->descent;                     break;
    }
    return up * f->size + f->shift;
}

/* Lines below, above and through a run, as wide as it is. */
static bool draw_decoration(svg_reader *r, const svg_space *space, const run *u, const double at[2])
{
    const svg_font *f = &space->font;
    const double places[3] = { u->shaped.underline, -u->shaped.ascent, -0.3 };
    const bool asked[3]    = { f->underlined, f->overlined, f->struck };
    const double half      = u->shaped.thickness / 2;
    bool good              = true;

    for (int k = 0; k < 3 && good; k++) {
        svg_pen pen = svg_pen_at(r, space->to_mm);
        const double y = at[1] + places[k] * f->size, thick = half * f->size;
        if (!asked[k] || !(u->advance > 0))
            continue;
        svg_move(&pen, at[0], y - thick);
        good = svg_line(&pen, at[0] + u->advance, y - thick);
        if (half > 0)
            good = good && svg_line(&pen, at[0] + u->advance, y + thick) &&
                   svg_line(&pen, at[0], y + thick) && svg_close(&pen);
    }
    return good;
}

/* One run from l->at on, which moves to its end; along a rail, l->at[0] is the distance. */
static bool draw_run(layout *l, const run *u, const svg_rail *along)
{
    const letter *first   = &l->c->letter[u->first];
    const stretch *of     = &l->c->stretch[first->stretch];
    const svg_font *f     = &of->space.font;
    const double turn     = isnan(first->rotate) ? 0 : first->rotate * DEGREE;
    const double size     = f->size;
    bool good             = true;

    const bool seen       = svg_begin(l->c->r, &of->space) &&
                      svg_ink_chosen(l->c->r, &of->space, l->c->r->fill & DRAWING_STROKED);

    l->c->r->node = of->node;
    l->c->r->fill &= ~(unsigned)DRAWING_EVENODD;     /* it is not for text */
    l->at[0] += first->dx;
    l->at[1] += first->dy;
    const double y = l->at[1] - shift_of(f, &u->shaped), from[2] = { l->at[0], y };
    for (size_t k = 0; k < u->shaped.clusters && good; k++) {
        const double wide = u->shaped.cluster[k].advance * size * u->wider;
        double at[2] = { l->at[0], y }, way[2] = { 1, 0 };
        bool shown   = seen;
        if (along != NULL) {
            shown = svg_rail_at(along, l->at[0] + wide / 2, at, way) && shown;
            for (int i = 0; i < 2; i++)
                at[i] += -way[i] * wide / 2 + (i == 0 ? -way[1] : way[0]) * y;
        }
        const svg_matrix place = { way[0], way[1], -way[1], way[0], at[0], at[1] };
        const svg_matrix own = { size * u->wider * cos(turn),
                                 size * u->wider * sin(turn),
                                 -size * sin(turn),
                                 size * cos(turn),
                                 0,
                                 0 };
        if (k > 0 && u->shaped.cluster[k].lines != u->shaped.cluster[k - 1].lines) {
            (void)svg_begin(l->c->r, &of->space);
            l->c->r->fill &= ~(unsigned)DRAWING_EVENODD;
        }
        if (u->shaped.cluster[k].lines)
            l->c->r->fill &= ~(unsigned)DRAWING_FILLED;
        if (shown)
            good = draw_cluster(l->c->r, &u->shaped, k,
                                svg_multiply(of->space.to_mm, svg_multiply(place, own)));
        l->at[0] += wide + gap_after(l, u, k) * u->wider + (k < u->gaps ? u->gap : 0);
    }
    if (good && along == NULL && seen && (f->underlined || f->overlined || f->struck)) {
        run plain = *u;
        plain.advance -= first->dx;
        good = draw_decoration(l->c->r, &of->space, &plain, from);
    }
    return good;
}

/* Runs first .. last - 1, from the place of the first one. */
static bool draw_chunk(layout *l, size_t first, size_t last)
{
    const letter *begins = &l->c->letter[l->all[first].first];
    const stretch *of    = &l->c->stretch[begins->stretch];
    const svg_font *f    = &of->space.font;
    double wide          = 0;
    svg_rail along           = { .scale = 1 };
    bool good            = true;

    for (size_t k = first; k < last; k++)
        wide += l->all[k].advance;
    wide -= font_of(l, &l->all[last - 1])->letter * l->all[last - 1].wider;  /* behind the last */
    if (begins->has & HAS_X)
        l->at[0] = begins->x;
    if (begins->has & HAS_Y)
        l->at[1] = begins->y;
    if (of->path != NULL) {
        l->c->r->node = of->node;
        good     = svg_lay_rail(l->c->r, of->path, &of->space, &along);
        l->at[0] = of->offset * (of->part ? along.length : 1);
        l->at[1] = 0;
    }
    if (f->anchor != SVG_ANCHOR_START)
        l->at[0] -= f->anchor == SVG_ANCHOR_MIDDLE ? wide / 2 : wide;
    if (f->leftwards && f->anchor != SVG_ANCHOR_MIDDLE)     /* the start is at the right */
        l->at[0] += f->anchor == SVG_ANCHOR_START ? -wide : wide;
    for (size_t k = first; k < last && good; k++)
        good = draw_run(l, &l->all[k], of->path ? &along : NULL);
    if (of->path != NULL)
        svg_free_rail(&along);
    return good;
}

static bool begins_chunk(const layout *l, size_t k)
{
    const letter *a = &l->c->letter[l->all[k].first];

    return a->has & HAS_PLACE ||
           l->c->stretch[a->stretch].path != l->c->stretch[a[-1].stretch].path;
}

static bool draw_chunks(layout *l)
{
    bool good = true;

    for (size_t first = 0, last; first < l->count && good; first = last) {
        for (last = first + 1; last < l->count && !begins_chunk(l, last);)
            last++;
        good = draw_chunk(l, first, last);
    }
    return good;
}

static void trim_end(collection *c)
{
    if (c->blank && c->count > 0 && c->text[c->letter[c->count - 1].at] == ' ')
        c->count--;
    if (c->count > 0)
        c->text[c->letter[c->count].at] = '\0';
}

bool svg_text(svg_reader *r, const svg_space *space)
{
    const xmlNode *node = r->node;
    collection c        = { .r = r, .blank = true };
    layout l            = { .c = &c };
    const stretch plain = { .path = NULL };
    const size_t before = r->d->count;
    bool good           = true;

    if (r->d->text != NULL && strcmp(r->d->text, "none") == 0)
        return true;
    r->notes->lost     = false;
    good = collect(&c, node, space, &plain);
    if (good)
        trim_end(&c);
    good = good && make_runs(&l) && draw_chunks(&l);
    if (r->notes->lost)
        r->d->count = before;
    for (size_t k = 0; k < l.count; k++)
        svg_shaped_free(&l.all[k].shaped);
    free(l.all);
    free(c.letter);
    free(c.fit);
    free(c.stretch);
    free(c.text);
    r->node = node;
    return good;
}
