/* tests/bench/bench_rsvg.c -- the curves of a drawing beside its picture by librsvg, at 300 dpi
 * SPDX-License-Identifier: MIT
 *
 *     bench_rsvg FOLDER FILE.svg         pictures of the differences: FOLDER/lines.png, paint.png
 *
 * Two copies of the drawing are read by loft and drawn by rsvg-convert. In `lines`, every shape has
 * a thin stroke and no fill: it shows each curve, also those that others cover. `paint` has its own
 * paint: it shows what is seen at all. Pictures and filters are taken out of both. The page is made
 * a multiple of 25 pixels, so that librsvg does not round its scale.
 *
 * Counted are, in each copy, places of our curves without ink within a pixel (in steps of half a
 * pixel), and pixels with ink where our strokes, as wide as they are, and filled shapes are more
 * than a pixel away. A place counts only where our own painting has ink of 1/15 pixel: thinner
 * shapes and strokes show by chance. The line printed is: verdict, these four counts.
 */
#include <cairo.h>
#include <libxml/parser.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"       /* tool_grow */
#include "cmd/terminal.h"
#include "read/drawing.h"
#include "readers.h"

#define DPI       300.0
#define PAGE_MAX  6000.0        /* pixels; larger pages are not compared */
#define PAGE_PX   800.0         /* of a drawing without a page */
#define STEP      0.5           /* pixels along a curve */
#define CHORD     0.2           /* pixels: cairo rounds places to 1/256, which turns shorter ones */
#define FAINT     18u           /* of 255: cairo has 15 rows of samples in a pixel, thinner lines
                                 * show by chance */

static const char paint_style[] = "*{filter:none!important}stop{stop-opacity:1!important}";
static const char line_style[] =
    "*{fill:none!important;stroke:#000!important;stroke-width:%.6fpx!important;"
    "stroke-opacity:1!important;opacity:1!important;stroke-linejoin:bevel!important;"
    "stroke-linecap:butt!important;filter:none!important;mask:none!important}";

typedef struct {
    char file[600], picture[600];
    int width, height;          /* pixels */
    drawing d;
    cairo_surface_t *theirs, *ours, *near, *off;   /* near: ours, wider by a pixel */
    size_t without_ink, beyond;
} copy;


// The copies
// ----------

/* Take out what loft does not draw. */
static void prune(xmlNode *node)
{
    static const char *const names[] = { "image", "foreignObject", "flowRoot", "script" };
    xmlNode *next;

    for (; node != NULL; node = next) {
        bool drop = false;
        next      = node->next;
        for (size_t i = 0; node->type == XML_ELEMENT_NODE && i < 4; i++)
            drop = drop || strcmp((const char *)node->name, names[i]) == 0;
        if (drop) {
            xmlUnlinkNode(node);
            xmlFreeNode(node);
        } else {
            prune(node->children);
        }
    }
}

static void set_number(xmlNode *root, const char *name, double x)
{
    char text[40];

    snprintf(text, sizeof text, "%.0f", x);
    xmlSetProp(root, (const xmlChar *)name, (const xmlChar *)text);
}

/* loft's reader lets libxml2 open no files. */
static xmlDoc *parse(const char *from)
{
    FILE *f    = fopen(from, "rb");
    char *text = NULL;
    size_t size = 0, got = 0;

    do {
        text = tool_grow(text, size + 65536);
        got  = f ? fread(text + size, 1, 65536, f) : 0;
        size += got;
    } while (got > 0);
    if (f != NULL)
        fclose(f);
    xmlDoc *doc = xmlReadMemory(text, (int)size, from, NULL,
                                XML_PARSE_NOENT | XML_PARSE_NONET | XML_PARSE_NOERROR |
                                    XML_PARSE_NOWARNING | XML_PARSE_HUGE);
    free(text);
    return doc;
}

static bool save(const char *to, xmlDoc *doc)
{
    FILE *f = fopen(to, "wb");
    const bool good = f != NULL && xmlDocDump(f, doc) >= 0;

    return f != NULL && fclose(f) == 0 && good;
}

/* Write a copy; `style` may have one number, the width of a stroke of a third of a CSS pixel. */
static bool write_copy(copy *c, const char *from, const char *style, const drawing *page)
{
    xmlDoc *doc   = parse(from);
    xmlNode *root = doc ? xmlDocGetRootElement(doc) : NULL;
    double size[2] = { page->width * 96 / 25.4, page->height * 96 / 25.4 }, box[4], scale = 1;
    char text[600];

    if (root == NULL)
        return false;
    for (int i = 0; i < 2; i++)
        size[i] = size[i] > 0 ? 8 * ceil(size[i] / 8 - 1e-6) : PAGE_PX;
    c->width  = (int)lround(size[0] * DPI / 96);
    c->height = (int)lround(size[1] * DPI / 96);
    char *view = (char *)xmlGetProp(root, (const xmlChar *)"viewBox");
    if (view != NULL &&
        sscanf(view, "%lf%*[ ,]%lf%*[ ,]%lf%*[ ,]%lf", &box[0], &box[1], &box[2], &box[3]) == 4 &&
        box[2] > 0)
        scale = size[0] / box[2];
    xmlFree(view);
    prune(root->children);
    snprintf(text, sizeof text, style, 0.32 / scale);
    xmlNewTextChild(root, root->ns, (const xmlChar *)"style", (const xmlChar *)text);
    set_number(root, "width", size[0]);
    set_number(root, "height", size[1]);
    const bool good = c->width <= PAGE_MAX && c->height <= PAGE_MAX && save(c->file, doc);
    xmlFreeDoc(doc);
    return good;
}

/* Have librsvg draw it. */
static bool render(copy *c)
{
    char command[1400];

    snprintf(command, sizeof command, "rsvg-convert -u -d 96 -p 96 -z 3.125 -l en -o '%s' '%s'",
             c->picture, c->file);
    if (system(command) != 0)
        return false;
    c->theirs = cairo_image_surface_create_from_png(c->picture);
    return cairo_image_surface_get_width(c->theirs) == c->width &&
           cairo_image_surface_get_height(c->theirs) == c->height;
}


// Our strokes and areas
// ---------------------

static void to_pixels(const copy *c, const double mm[2], double out[2])
{
    out[0] = mm[0] * DPI / 25.4;
    out[1] = c->height - mm[1] * DPI / 25.4;
}

/* Join the end of a path to its start, if it is there. */
static void close_part(const copy *c, cairo_t *cr, const drawing_curve *last, const double end[2])
{
    const drawing_curve *first = last;
    double start[2];

    while (first > c->d.curve && first[-1].path == last->path)
        first--;
    to_pixels(c, first->p[0], start);
    if (hypot(start[0] - end[0], start[1] - end[1]) < 1e-3)
        cairo_close_path(cr);
}

/* How many pieces of a curve are at most so many pixels long; 8 or more show its bends. */
static int steps_of(const drawing_curve *v, double pixels)
{
    double length = 0;

    for (int k = 0; k < 3; k++)
        length += hypot(v->p[k + 1][0] - v->p[k][0], v->p[k + 1][1] - v->p[k][1]);
    return 8 + (int)fmin(length * DPI / 25.4 / pixels, 1e5);
}

/* Add the curves of a drawing from `first` on that are of one shape: to be filled, with those that
 * are hidden, and each part closed. Returns the end of them. */
static size_t add_shape(const copy *c, cairo_t *cr, const drawing *d, size_t first, bool filled)
{
    const unsigned shape = d->curve[first].fill / DRAWING_SHAPE;
    size_t i             = first;
    double last[2] = { NAN, NAN }, drawn[2], at[2];

    for (; i < d->count && d->curve[i].fill / DRAWING_SHAPE == shape; i++) {
        const drawing_curve *v = &d->curve[i];
        const int n            = steps_of(v, 1);
        if (!filled && (v->fill & DRAWING_HIDDEN))
            continue;
        for (int k = 0; k <= n; k++) {
            double mm[2];
            drawing_eval(v, (double)k / n, mm);
            to_pixels(c, mm, at);
            const bool begins = k == 0 && (i == first || v->path != v[-1].path ||
                                           at[0] != last[0] || at[1] != last[1]);
            if (begins && i > first && filled)
                cairo_close_path(cr);
            if (begins)
                cairo_move_to(cr, at[0], at[1]);
            else if (k == n || (k > 0 && hypot(at[0] - drawn[0], at[1] - drawn[1]) > CHORD))
                cairo_line_to(cr, at[0], at[1]);
            else
                continue;
            memcpy(drawn, at, sizeof drawn);
        }
        memcpy(last, at, sizeof last);
        if (!filled && (i + 1 == d->count || d->curve[i + 1].path != v->path))
            close_part(c, cr, v, at);
    }
    if (filled)
        cairo_close_path(cr);
    return i;
}

static void set_rule(cairo_t *cr, unsigned fill)
{
    cairo_set_fill_rule(cr, fill & DRAWING_EVENODD ? CAIRO_FILL_RULE_EVEN_ODD
                                                   : CAIRO_FILL_RULE_WINDING);
}

/* Stroke the path with its pen, which may be an ellipse, `by` wider. An ellipse is shifted all
 * around for that. */
static void paint_stroke(cairo_t *cr, const drawing_curve *v, double by)
{
    const double wide = v->fill & DRAWING_STROKED ? v->width * DPI / 25.4 : 0;
    const bool round  = !(v->pen[0] > 0);
    cairo_matrix_t pen;

    cairo_path_t *path = cairo_copy_path(cr);
    cairo_matrix_init(&pen, v->pen[0], -v->pen[1], -v->pen[1], v->pen[2], 0, 0);
    for (int k = 0; k < (round || !(by > 0) ? 1 : 16); k++) {
        cairo_save(cr);
        if (!round)
            cairo_translate(cr, by * cos(k * 0.39269908169872414),
                            by * sin(k * 0.39269908169872414));
        cairo_new_path(cr);
        cairo_append_path(cr, path);
        if (!round)
            cairo_transform(cr, &pen);
        cairo_set_line_width(cr, round ? 2 * by + wide : wide);
        cairo_stroke(cr);
        cairo_restore(cr);
    }
    cairo_path_destroy(path);
}

/* Paint one shape, everything wider by this on each side, in pixels. */
static size_t paint_shape(const copy *c, cairo_t *cr, size_t first, double by)
{
    const drawing_curve *v = &c->d.curve[first];
    size_t end             = first + 1;
    bool filled            = v->fill & DRAWING_FILLED;

    cairo_new_path(cr);
    if (filled) {
        (void)add_shape(c, cr, &c->d, first, true);
        set_rule(cr, v->fill);
        cairo_fill_preserve(cr);
        cairo_set_line_width(cr, 2 * by);
        cairo_stroke(cr);
    }
    end = add_shape(c, cr, &c->d, first, false);
    cairo_set_line_cap(cr, v->cap == 1 ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_SQUARE);
    cairo_set_line_join(cr, by > 0 && v->join == CAIRO_LINE_JOIN_BEVEL
                                ? CAIRO_LINE_JOIN_ROUND
                                : (cairo_line_join_t)v->join);
    cairo_set_miter_limit(cr, v->mitre);
    paint_stroke(cr, v, by);
    return end;
}

static cairo_surface_t *paint(const copy *c, double by)
{
    cairo_surface_t *out = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, c->width, c->height);
    cairo_t *cr          = cairo_create(out);

    for (size_t i = 0; i < c->d.count;)
        i = paint_shape(c, cr, i, by);
    cairo_destroy(cr);
    return out;
}


// Comparison
// ----------

static unsigned *pixel(cairo_surface_t *s, int x, int y)
{
    return (unsigned *)(void *)(cairo_image_surface_get_data(s) +
                                (ptrdiff_t)y * cairo_image_surface_get_stride(s)) +
           x;
}

/* Is there ink of at least so much within a pixel of a place? */
static bool has_ink(const copy *c, cairo_surface_t *s, const double at[2], unsigned least)
{
    for (int y = (int)floor(at[1] - 1); y <= (int)floor(at[1] + 1); y++)
        for (int x = (int)floor(at[0] - 1); x <= (int)floor(at[0] + 1); x++) {
            const double right = fmax(fmax(x - at[0], at[0] - x - 1), 0),
                         down  = fmax(fmax(y - at[1], at[1] - y - 1), 0);
            if (x >= 0 && y >= 0 && x < c->width && y < c->height && hypot(right, down) <= 1 &&
                *pixel(s, x, y) >> 24 >= least)
                return true;
        }
    return false;
}

static void follow_curve(copy *c, const drawing_curve *v)
{
    const int n = steps_of(v, STEP);
    double at[2];

    for (int i = 0; i <= n; i++) {
        double mm[2];
        drawing_eval(v, (double)i / n, mm);
        to_pixels(c, mm, at);
        const bool known = at[0] > 1 && at[1] > 1 && at[0] < c->width - 1 && at[1] < c->height - 1;
        if (!known || has_ink(c, c->theirs, at, 1) || !has_ink(c, c->ours, at, FAINT))
            continue;
        c->without_ink++;
        *pixel(c->off, (int)at[0], (int)at[1]) = 0xffff0000;
    }
}

static void compare(copy *c)
{
    c->off = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, c->width, c->height);
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++) {
            const bool ink = *pixel(c->theirs, x, y) >> 24, near = *pixel(c->near, x, y) >> 24;
            *pixel(c->off, x, y) = ink ? near ? 0xffc0c0c0 : 0xff0000ff
                                   : near ? 0xffe8f0e8
                                          : 0xffffffff;
            c->beyond += ink && !near;
        }
    for (size_t i = 0; i < c->d.count; i++)
        if (!(c->d.curve[i].fill & DRAWING_HIDDEN))
            follow_curve(c, &c->d.curve[i]);
    cairo_surface_mark_dirty(c->off);
    cairo_surface_write_to_png(c->off, c->picture);
}

/* Returns what hinders the comparison, or NULL. */
static const char *compare_copy(copy *c, const char *folder, const char *name, const char *from,
                                const char *style, const drawing *page)
{
    snprintf(c->file, sizeof c->file, "%s/%s.svg", folder, name);
    snprintf(c->picture, sizeof c->picture, "%s/%s.png", folder, name);
    if (!write_copy(c, from, style, page))
        return "too large";
    if (!render(c))
        return "refused by librsvg";
    c->d = (drawing){ .areas = true, .white = true };
    if (drawing_read(tool_host(), &c->d, c->file) != 0 && c->d.count == 0) {
        drawing_free(&c->d);
        c->d = (drawing){ .count = 0 };
    }
    c->ours = paint(c, 0);
    c->near = paint(c, 1);
    compare(c);
    cairo_surface_destroy(c->theirs);
    cairo_surface_destroy(c->ours);
    cairo_surface_destroy(c->near);
    cairo_surface_destroy(c->off);
    drawing_free(&c->d);
    return NULL;
}

int main(int argc, char **argv)
{
    drawing page = { .count = 0 };
    copy lines   = { .width = 0 }, painted = { .width = 0 };

    if (argc != 3) {
        fprintf(stderr, "usage: %s FOLDER FILE.svg\n", argv[0]);
        return 64;
    }
    terminal screen = { .doing = NULL };
    host h          = terminal_host(&screen);
    tool_use(&h);
    (void)drawing_read(&h, &page, argv[2]);
    const char *hinders = compare_copy(&lines, argv[1], "lines", argv[2], line_style, &page);
    if (hinders == NULL)
        hinders = compare_copy(&painted, argv[1], "paint", argv[2], paint_style, &page);
    const bool agrees = lines.without_ink + lines.beyond + painted.without_ink + painted.beyond ==
                        0;
    printf("%s\t%zu\t%zu\t%zu\t%zu\n",
           hinders  ? hinders
           : agrees ? "agrees"
                    : "differs",
           lines.without_ink, lines.beyond, painted.without_ink, painted.beyond);
    drawing_free(&page);
    return 0;
}
