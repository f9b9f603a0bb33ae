/* host-tools/svg/svg_text.c -- text: its letters, their places, and their outlines or lines
 * SPDX-License-Identifier: MIT
 *
 * All letters of a <text> are collected first, each with the x, y, dx, dy and rotate that lists of
 * its elements give it: those of inner elements win. A letter with an x or a y of its own begins a
 * chunk, which is shaped as a whole, so that letters join and kern across elements and across dx,
 * dy and rotate, and which text-anchor moves as a whole.
 *   see  SVG 2, 11.5: Text layout algorithm; the white space is that of CSS Text 3, 4.1
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "svg/svg.h"

#define LETTERS_MAX 200000u     /* drawn ones, counting those of each <use>: a few seconds */
#define CHUNK_COST  8           /* letters: what it takes to begin a chunk */
#define DEGREE 0.017453292519943295769

enum { HAS_X = 1, HAS_Y = 2, HAS_PLACE = HAS_X | HAS_Y, HAS_DX = 4, HAS_DY = 8 };

/* The letters of one element that follow each other. */
typedef struct {
    svg_space space;
    const xmlNode *node, *path;     /* path: what they follow, or NULL */
    double offset;                  /* where on it they begin; */
    bool part;                      /* as a part of its length */
    svg_metrics metrics;            /* of its font; once it is shaped */
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
        s->cluster      = memory_grow(s->cluster, s->cluster_room * sizeof *s->cluster);
    }
    s->cluster[s->clusters++] =
        (svg_cluster){ .from = from, .advance = advance, .first = s->parts };
}

void svg_shaped_part(svg_shaped *s, char kind, const double p[], int points)
{
    if (s->parts == s->part_room) {
        s->part_room = s->part_room ? 2 * s->part_room : 128;
        s->part      = memory_grow(s->part, s->part_room * sizeof *s->part);
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
        c->letter = memory_grow(c->letter, c->room * sizeof *c->letter);
    }
    if (c->size + length >= c->text_room) {
        c->text_room = 2 * c->text_room + 64;
        c->text      = memory_grow(c->text, c->text_room);
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
        c->stretch      = memory_grow(c->stretch, c->stretch_room * sizeof *c->stretch);
    }
    c->stretch[c->stretches++] = (stretch){ .space = *space,
                                            .node = node,
                                            .path = like->path,
                                            .offset = like->offset,
                                            .part = like->part };
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
        l->value[k] = memory_grow(NULL, room * sizeof *l->value[k]);
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
        c->fit            = memory_grow(c->fit, (c->fits + 1) * sizeof *c->fit);
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
    if (svg_is(node, "textPath"))       /* it has no places */
        l = (lists){ .count = { 0 } };
    else
        read_lists(c->r, space, &l);
    if (++c->r->depth > SVG_DEPTH_MAX)
        good = good && svg_fail(c->r, "svg.nested-too-deep",
                                "more than %d nested elements: draw with fewer", SVG_DEPTH_MAX);
    bool begun = false;
    for (const xmlNode *child = node->children; child != NULL && good; child = child->next) {
        if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE) {
            begun = begun || begin_stretch(c, space, node, like);
            add_text(c, (const char *)child->content, space->font.keeps_space);
        } else if (svg_is(child, "tspan") || svg_is(child, "a") ||
                   (svg_is(child, "textPath") && like->path == NULL)) {
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


// Chunks
// ------

/* A cluster of a chunk. */
typedef struct {
    size_t letter;              /* its first one */
    double advance;             /* user units, without dx */
    double wider, gap;          /* by textLength: the factor of its width; what is added to it */
} place;

typedef struct {
    size_t first, last;         /* letters */
    svg_shaped shaped;
    place *placed;              /* its clusters, from left to right */
} chunk;

typedef struct {
    collection *c;
    chunk *all;
    size_t count, room;
    double at[2];               /* where the next letter goes */
} layout;

static stretch *stretch_of(const layout *l, size_t which)
{
    return &l->c->stretch[l->c->letter[which].stretch];
}

static bool draws_lines(const svg_reader *r)
{
    return r->d->text != NULL && strncmp(r->d->text, "line", 4) == 0;
}

/* The fonts of a chunk. Returns how many. */
static size_t list_spans(layout *l, const chunk *u, svg_span spans[])
{
    const letter *all   = l->c->letter;
    const unsigned from = all[u->first].at;
    size_t count        = 0;

    for (size_t i = u->first; i < u->last; i++) {
        stretch *of = stretch_of(l, i);
        if (i > u->first && all[i].stretch == all[i - 1].stretch) {
            spans[count - 1].end = all[i + 1].at - from;
            continue;
        }
        of->metrics    = draws_lines(l->c->r) ? svg_lines_metrics()
                                           : svg_glyphs_metrics(l->c->r, &of->space.font);
        spans[count++] = (svg_span){ &of->space.font, all[i + 1].at - from };
    }
    return count;
}

/* Shape the text of a chunk. Returns false if the reading ends; *shaped: it has glyphs. */
static bool shape_text(layout *l, chunk *u, bool *shaped)
{
    svg_reader *r    = l->c->r;
    const char *text = l->c->text + l->c->letter[u->first].at;
    svg_span *spans  = memory_grow(NULL, (u->last - u->first) * sizeof *spans);
    const size_t n   = list_spans(l, u, spans);
    bool good        = true;

    *shaped = true;
    if (!draws_lines(r))
        *shaped = svg_glyphs_shape(r, spans, n, text, spans[0].font->leftwards, &u->shaped);
    for (size_t k = 0; k < n && draws_lines(r) && good; k++)
        good = svg_lines_shape(r, &spans[k], k > 0 ? spans[k - 1].end : 0, text, &u->shaped);
    free(spans);
    return good;
}

static void warn_of(const svg_reader *r, const svg_shaped *s, const char *text)
{
    if (s->outlined)
        svg_warn(r, SVG_WARN_LINE,
                 "\"%.40s\" has letters without single lines, which are drawn as outlines: use "
                 "letters of Latin 1",
                 text);
    if (s->missing)
        svg_warn(r, SVG_WARN_LETTER,
                 "a letter of \"%.40s\" is in no font and not drawn: install a font with it", text);
    if (s->pictured)
        svg_warn(r, SVG_WARN_LETTER,
                 "a letter of \"%.40s\" is a picture in its font and not drawn: convert it to "
                 "paths",
                 text);
}

/* The letter that begins at this byte of the text, or has it. */
static size_t letter_at(const layout *l, const chunk *u, size_t byte)
{
    size_t low = u->first, high = u->last;

    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        *(l->c->letter[middle].at <= byte ? &low : &high) = middle;
    }
    return low;
}

/* Nothing is put between letters that join. */
static double gap_after(const layout *l, const chunk *u, size_t cluster)
{
    const size_t which = u->placed[cluster].letter;
    const svg_font *f  = &stretch_of(l, which)->space.font;

    return (u->shaped.cluster[cluster].cursive ? 0 : f->letter) +
           (l->c->text[l->c->letter[which].at] == ' ' ? f->word : 0);
}

static bool shape_chunk(layout *l, chunk *u)
{
    svg_reader *r    = l->c->r;
    const char *text = l->c->text + l->c->letter[u->first].at;
    bool shaped;

    r->node = stretch_of(l, u->first)->node;
    r->letters += (unsigned)(u->last - u->first) + CHUNK_COST;
    if (r->letters > LETTERS_MAX)
        return svg_fail(r, "svg.too-many-letters",
                        "more than %u letters, counting each use: split the drawing", LETTERS_MAX);
    if (!shape_text(l, u, &shaped))
        return false;
    if (!shaped)
        return svg_warn(r, SVG_WARN_TEXT, "<text> is not drawn: convert text to paths"), true;
    warn_of(r, &u->shaped, text);
    u->placed = memory_grow(NULL, (u->shaped.clusters + 1) * sizeof *u->placed);
    for (size_t k = 0; k < u->shaped.clusters; k++) {
        const svg_cluster *c = &u->shaped.cluster[k];
        place *to            = &u->placed[k];
        *to = (place){ .letter = letter_at(l, u, l->c->letter[u->first].at + c->from), .wider = 1 };
        to->advance = c->advance * stretch_of(l, to->letter)->space.font.size + gap_after(l, u, k);
    }
    return true;
}

/* Does a chunk begin at letter i? */
static bool begins_chunk(const collection *c, size_t i)
{
    const letter *a = &c->letter[i];

    return i == 0 || a->has & HAS_PLACE ||
           c->stretch[a->stretch].path != c->stretch[a[-1].stretch].path;
}

/* The clusters of an element, one after the other, from those of chunk *k, *i on. Returns NULL
 * behind the last one. */
static place *next_of(const layout *l, const fitting *f, size_t *k, size_t *i)
{
    for (; *k < l->count; ++*k, *i = 0)
        while (*i < l->all[*k].shaped.clusters) {
            place *p = &l->all[*k].placed[(*i)++];
            if (p->letter >= f->first && p->letter < f->last)
                return p;
        }
    return NULL;
}

/* Make the letters of an element as long as its textLength: by gaps between them, or by their
 * width. Inner elements come first. */
static void fit_letters(layout *l, const fitting *f)
{
    double natural = 0;
    size_t count = 0, k = 0, i = 0;

    for (const place *p; (p = next_of(l, f, &k, &i)) != NULL; count++)
        natural += p->advance + l->c->letter[p->letter].dx;
    if (!(natural > 0) || (!f->widens && count < 2))
        return;
    const double factor = f->length / natural, gap = (f->length - natural) / ((double)count - 1);
    k = i = 0;
    for (place *p; (p = next_of(l, f, &k, &i)) != NULL;) {
        if (f->widens) {
            p->wider *= factor;
            p->advance *= factor;
        } else {
            p->gap += gap;
            p->advance += gap;
        }
    }
}

static bool make_chunks(layout *l)
{
    for (size_t i = 0; i < l->c->count; i++) {
        if (!begins_chunk(l->c, i)) {
            l->all[l->count - 1].last = i + 1;
            continue;
        }
        if (l->count == l->room) {
            l->room = l->room ? 2 * l->room : 16;
            l->all  = memory_grow(l->all, l->room * sizeof *l->all);
        }
        l->all[l->count++] = (chunk){ .first = i, .last = i + 1 };
    }
    for (size_t k = 0; k < l->count; k++)
        if (!shape_chunk(l, &l->all[k]))
            return false;
    for (size_t k = 0; k < l->c->fits; k++)
        fit_letters(l, &l->c->fit[k]);
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

static double shift_of(const stretch *of)
{
    const svg_metrics *s = &of->metrics;
    const svg_font *f    = &of->space.font;
    double up            = 0;

    switch (f->own_baseline != SVG_USUAL ? f->own_baseline : f->baseline) {
    case SVG_USUAL:
    case SVG_ALPHABETIC:   up = 0;                              break;
    case SVG_MIDDLE:       up = -s->x_height / 2;               break;
    case SVG_MATHEMATICAL: up = -s->ascent / 2;                 break;
    case SVG_CENTRAL:      up = (s->descent - s->ascent) / 2;   break;
    case SVG_HANGING:      up = -0.8 * s->ascent;               break;
    case SVG_TOP:          up = -s->ascent;                     break;
    case SVG_BOTTOM:       up = s->descent;                     break;
    }
    return up * f->size + f->shift;
}

/* Letters with one decoration, in the space of the first one. */
typedef struct {
    const stretch *of;              /* NULL: none */
    svg_matrix at;
    double wide;
} decorated;

/* Draw lines below, above and through the letters, as long as they are, and forget them. */
static bool draw_decoration(svg_reader *r, decorated *d)
{
    const stretch *of = d->of;
    bool good         = true;

    d->of = NULL;
    if (of == NULL)
        return true;
    const svg_font *f      = &of->space.font;
    const double places[3] = { of->metrics.underline, -of->metrics.ascent, -0.3 };
    const bool asked[3]    = { f->underlined, f->overlined, f->struck };
    const double half      = of->metrics.thickness / 2 * f->size;
    for (int k = 0; k < 3 && good; k++) {
        svg_pen pen    = svg_pen_at(r, svg_multiply(of->space.to_mm, d->at));
        const double y = places[k] * f->size;
        if (!asked[k] || !(d->wide > 0))
            continue;
        svg_move(&pen, 0, y - half);
        good = svg_line(&pen, d->wide, y - half);
        if (half > 0)
            good = good && svg_line(&pen, d->wide, y + half) && svg_line(&pen, 0, y + half) &&
                   svg_close(&pen);
    }
    return good;
}

/* Begin what is painted together. Returns whether it is seen. */
static bool begin_letters(svg_reader *r, const stretch *of)
{
    const bool seen = svg_begin(r, &of->space) &&
                      svg_ink_chosen(r, &of->space, r->fill & DRAWING_STROKED);

    r->node = of->node;
    r->fill &= ~(unsigned)DRAWING_EVENODD;     /* it is not for text */
    return seen;
}

/* The space of cluster k at l->at, baseline at y = 0. Along a rail, l->at[0] is the distance, and
 * *shown is false beyond its ends. */
static svg_matrix space_of(const layout *l, const chunk *u, size_t k, const svg_rail *along,
                           bool *shown)
{
    const letter *a  = &l->c->letter[u->placed[k].letter];
    const stretch *of = stretch_of(l, u->placed[k].letter);
    const double turn = isnan(a->rotate) ? 0 : a->rotate * DEGREE, y = l->at[1] - shift_of(of);
    double at[2] = { l->at[0], y }, way[2] = { 1, 0 };

    *shown = true;
    if (along != NULL) {
        const double wide = u->shaped.cluster[k].advance * of->space.font.size * u->placed[k].wider;
        *shown = svg_rail_at(along, l->at[0] + wide / 2, at, way);
        for (int i = 0; i < 2; i++)
            at[i] += -way[i] * wide / 2 + (i == 0 ? -way[1] : way[0]) * y;
    }
    return svg_multiply((svg_matrix){ way[0], way[1], -way[1], way[0], at[0], at[1] },
                        (svg_matrix){ cos(turn), sin(turn), -sin(turn), cos(turn), 0, 0 });
}

/* Does a cluster stand where lists or a path say, so that lines of others do not go on there? */
static bool stands_alone(const letter *a, const svg_rail *along)
{
    return along != NULL || fabs(a->dx) > 0 || fabs(a->dy) > 0 || fabs(a->rotate) > 0;
}

/* The clusters from l->at on, which moves to their end. */
static bool draw_clusters(layout *l, const chunk *u, const svg_rail *along)
{
    svg_reader *r     = l->c->r;
    const stretch *of = NULL;
    decorated line    = { .of = NULL };
    bool good = true, seen = false, lines = false, shown;

    for (size_t k = 0; k < u->shaped.clusters && good; k++) {
        const place *p       = &u->placed[k];
        const letter *a      = &l->c->letter[p->letter];
        const svg_cluster *c = &u->shaped.cluster[k];
        const stretch *its   = stretch_of(l, p->letter);
        if (its != of || stands_alone(a, along))
            good = draw_decoration(r, &line);
        if (its != of || c->lines != lines)
            seen = begin_letters(r, its);
        of    = its;
        lines = c->lines;
        const svg_font *f = &of->space.font;
        l->at[0] += a->dx;
        l->at[1] += a->dy;
        const svg_matrix at  = space_of(l, u, k, along, &shown);
        const double size    = f->size;
        const svg_matrix own = { size * p->wider, 0, 0, size, 0, 0 };
        if (c->lines)
            r->fill &= ~(unsigned)DRAWING_FILLED;
        if (shown && seen && good)
            good = draw_cluster(r, &u->shaped, k,
                                svg_multiply(of->space.to_mm, svg_multiply(at, own)));
        if (line.of == NULL && shown && seen && (f->underlined || f->overlined || f->struck))
            line = (decorated){ of, at, 0 };
        line.wide += p->advance;
        l->at[0] += p->advance;
    }
    return good && draw_decoration(r, &line);
}

/* How wide a chunk is, without what is added behind its last letter. */
static double width_of(const layout *l, const chunk *u)
{
    const size_t n = u->shaped.clusters;
    double wide    = 0;

    for (size_t k = 0; k < n; k++)
        wide += u->placed[k].advance + l->c->letter[u->placed[k].letter].dx;
    if (n > 0 && !u->shaped.cluster[n - 1].cursive)
        wide -= stretch_of(l, u->placed[n - 1].letter)->space.font.letter * u->placed[n - 1].wider;
    if (n > 0)
        wide -= u->placed[n - 1].gap;
    return wide;
}

/* A chunk, from the place of its first letter. */
static bool draw_chunk(layout *l, const chunk *u)
{
    const letter *begins = &l->c->letter[u->first];
    const stretch *of    = stretch_of(l, u->first);
    const svg_font *f    = &of->space.font;
    const double wide    = width_of(l, u);
    svg_rail along       = { .scale = 1 };
    bool good            = true;

    if (begins->has & HAS_X)
        l->at[0] = begins->x;
    if (begins->has & HAS_Y)
        l->at[1] = begins->y;
    if (of->path != NULL) {
        l->c->r->node = of->node;
        good     = svg_lay_rail(l->c->r, of->path, &of->space, &along);
        l->at[0] = of->offset * (of->part ? along.length : 1) +
                   (begins->has & HAS_X ? begins->x : 0);
        l->at[1] = 0;
    }
    if (f->anchor != SVG_ANCHOR_START)
        l->at[0] -= f->anchor == SVG_ANCHOR_MIDDLE ? wide / 2 : wide;
    if (f->leftwards && f->anchor != SVG_ANCHOR_MIDDLE)     /* the start is at the right */
        l->at[0] += f->anchor == SVG_ANCHOR_START ? -wide : wide;
    good = good && draw_clusters(l, u, of->path ? &along : NULL);
    if (of->path != NULL)
        svg_free_rail(&along);
    return good;
}

static bool draw_chunks(layout *l)
{
    bool good = true;

    for (size_t k = 0; k < l->count && good; k++)
        good = draw_chunk(l, &l->all[k]);
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
    good = good && make_chunks(&l) && draw_chunks(&l);
    if (r->notes->lost)
        r->d->count = before;
    for (size_t k = 0; k < l.count; k++) {
        svg_shaped_free(&l.all[k].shaped);
        free(l.all[k].placed);
    }
    free(l.all);
    free(c.letter);
    free(c.fit);
    free(c.stretch);
    free(c.text);
    r->node = node;
    return good;
}
