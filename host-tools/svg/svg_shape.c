/* host-tools/svg/svg_shape.c -- path data and the basic shapes
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/scan.h"       /* scan_number, scan_comma, scan_space */
#include "svg/svg.h"


// Path data
// ---------

/* Path data while it is read. The last control point is kept for S and T to reflect. */
typedef struct {
    svg_reader *r;
    const char *data, *at;
    bool bad;               /* what follows cannot be read */
    svg_pen *pen;
    double last[2];
    char last_kind;         /* C or Q: the kind of curve that `last` belongs to; 0: none */
} path;

/* As in browsers, what is before an error is drawn. */
static void end_data(path *p, const char *wanted)
{
    const int before = p->at - p->data > 20 ? 20 : (int)(p->at - p->data);

    p->bad = true;
    if (*p->at == '\0')
        svg_warn(p->r, SVG_WARN_DATA, "path data ends after \"%.*s\": %s is missing", before,
                 p->at - before, wanted);
    else
        svg_warn(p->r, SVG_WARN_DATA,
                 "path data: \"%.12s\" behind \"%.*s\": %s is expected, what follows is not drawn",
                 p->at, before, p->at - before, wanted);
}

/* The numbers of one segment: `x` and `y` pairs; for A two radii, an angle, two flags, x and y.
 * Without them p->bad. */
static void read_numbers(path *p, char kind, double v[7])
{
    static const char kinds[] = "MLTHVSQCA", counts[] = "222114467";
    const int count = counts[strchr(kinds, kind) - kinds] - '0';

    for (int i = 0; i < count; i++) {
        if (i > 0)
            scan_comma(&p->at);
        else
            scan_space(&p->at);
        if (kind == 'A' && (i == 3 || i == 4)) {
            if (*p->at != '0' && *p->at != '1') {
                end_data(p, "a flag, 0 or 1,");
                return;
            }
            v[i] = *p->at++ - '0';
        } else if (!scan_number(&p->at, &v[i])) {
            end_data(p, "a number");
            return;
        }
    }
}

/* Relative numbers become absolute ones. */
static void make_absolute(const path *p, char kind, double v[7])
{
    static const char kinds[] = "MLTHVSQCA", counts[] = "222114467";
    const int count = counts[strchr(kinds, kind) - kinds] - '0';

    for (int i = kind == 'A' ? 5 : 0, axis = kind == 'V'; i < count; i++, axis = !axis)
        v[i] += p->pen->at[axis];
}

/* The first control point of S or T: the mirror image of the last one if the last curve was of the
 * same kind. */
static void reflect_control(const path *p, char kind, double out[2])
{
    for (int i = 0; i < 2; i++)
        out[i] = p->last_kind == kind ? 2 * p->pen->at[i] - p->last[i] : p->pen->at[i];
}

static void keep_control(path *p, char kind, const double control[2])
{
    memcpy(p->last, control, sizeof p->last);
    p->last_kind = kind;
}

static bool draw_segment(path *p, char kind, const double v[7])
{
    svg_pen *pen = p->pen;
    double c[2];

    switch (kind) {
    case 'L': p->last_kind = 0; return svg_line(pen, v[0], v[1]);
    case 'H': p->last_kind = 0; return svg_line(pen, v[0], pen->at[1]);
    case 'V': p->last_kind = 0; return svg_line(pen, pen->at[0], v[0]);
    case 'A':
        p->last_kind = 0;
        return svg_arc(pen, v[0], v[1], v[2], v[3] > 0, v[4] > 0, v[5], v[6]);
    case 'C':
        keep_control(p, 'C', v + 2);
        return svg_cubic(pen, v[0], v[1], v[2], v[3], v[4], v[5]);
    case 'Q': keep_control(p, 'Q', v);     return svg_quad(pen, v[0], v[1], v[2], v[3]);
    case 'S':
        reflect_control(p, 'C', c);
        keep_control(p, 'C', v);
        return svg_cubic(pen, c[0], c[1], v[0], v[1], v[2], v[3]);
    case 'T':
        reflect_control(p, 'Q', c);
        keep_control(p, 'Q', c);
        return svg_quad(pen, c[0], c[1], v[0], v[1]);
    default:
        p->last_kind = 0;
        svg_move(pen, v[0], v[1]);
        return true;
    }
}

static bool close_part(svg_pen *pen)
{
    const size_t before = pen->r->d->count;
    const bool good     = svg_close(pen);

    if (good)
        svg_vertex(pen, before, true);
    return good;
}

/* Read a command letter and all segments that follow it. */
static bool draw_command(path *p)
{
    const char letter = *p->at;
    char kind = letter >= 'a' ? (char)(letter - 'a' + 'A') : letter;

    if (letter == '\0' || strchr("MLTHVSQCAZ", kind) == NULL)
        return end_data(p, "one of MLHVCSQTAZ"), true;
    p->at++;
    if (kind == 'Z') {
        p->last_kind = 0;
        return close_part(p->pen);
    }
    for (;;) {
        double v[7];
        read_numbers(p, kind, v);
        if (p->bad)
            return true;
        if (letter >= 'a')
            make_absolute(p, kind, v);
        const size_t before = p->pen->r->d->count;
        if (!draw_segment(p, kind, v))
            return false;
        if (kind == 'M')
            svg_vertex_move(p->pen);
        else
            svg_vertex(p->pen, before, false);
        kind = kind == 'M' ? 'L' : kind;

        const bool comma = scan_comma(&p->at);
        if (!comma && (*p->at == '\0' || strchr("+-.0123456789", *p->at) == NULL))
            return true;
    }
}

bool svg_path(svg_reader *r, const char *data, svg_pen *pen)
{
    path p = { .r = r, .data = data, .at = data, .pen = pen };

    scan_space(&p.at);
    if (strcmp(p.at, "none") == 0)
        return true;
    if (*p.at != '\0' && *p.at != 'M' && *p.at != 'm')
        return end_data(&p, "M"), true;
    while (*p.at != '\0' && !p.bad) {
        if (!draw_command(&p))
            return false;
        scan_space(&p.at);
    }
    return true;
}


// Basic shapes
// ------------

/* The pen of a shape whose parts may have no length. */
static svg_pen dotting_pen(const svg_reader *r, const svg_space *s)
{
    svg_pen pen = svg_pen_at(r, s->to_mm);

    pen.dots = r->fill & DRAWING_STROKED && r->cap > 0;
    return pen;
}

static bool draw_path(svg_reader *r, const svg_space *s)
{
    char *data = svg_attribute(r->node, "d");
    svg_pen pen = dotting_pen(r, s);
    const bool good = data == NULL || svg_path(r, data, &pen);

    svg_end(&pen);
    xmlFree(data);
    return good;
}

static bool draw_line(svg_reader *r, const svg_space *s)
{
    svg_pen pen     = dotting_pen(r, s);
    const double x1 = svg_length(r, s, "x1", SVG_ACROSS, 0),
                 y1 = svg_length(r, s, "y1", SVG_ALONG_Y, 0),
                 x2 = svg_length(r, s, "x2", SVG_ACROSS, 0),
                 y2 = svg_length(r, s, "y2", SVG_ALONG_Y, 0);

    svg_move(&pen, x1, y1);
    svg_vertex_move(&pen);
    const size_t before = r->d->count;
    const bool good     = svg_line(&pen, x2, y2);
    svg_vertex(&pen, before, false);
    svg_end(&pen);
    return good;
}

static bool draw_points(svg_reader *r, const svg_space *s, bool closed)
{
    char *text = svg_attribute(r->node, "points");
    const char *at = text;
    svg_pen pen = dotting_pen(r, s);
    bool good = true;
    double v[2];
    int count = 0;

    if (text == NULL)
        return true;
    scan_space(&at);
    while (good && scan_number(&at, &v[count % 2])) {
        const size_t before = r->d->count;
        if (count == 1) {
            svg_move(&pen, v[0], v[1]);
            svg_vertex_move(&pen);
        } else if (count % 2 == 1) {
            good = svg_line(&pen, v[0], v[1]);
            svg_vertex(&pen, before, false);
        }
        count++;
        scan_comma(&at);
    }
    if (good && *at != '\0')
        svg_warn(r, SVG_WARN_DATA,
                 "points: \"%.12s\" behind %d numbers: a number is expected, what follows is not "
                 "drawn",
                 at, count);
    else if (good && count % 2 == 1)
        svg_warn(r, SVG_WARN_DATA, "points: %d numbers: give x and y of each point", count);
    if (good && closed && count > 0)
        good = close_part(&pen);
    svg_end(&pen);
    xmlFree(text);
    return good;
}

static bool draw_polyline(svg_reader *r, const svg_space *s) { return draw_points(r, s, false); }
static bool draw_polygon(svg_reader *r, const svg_space *s) { return draw_points(r, s, true); }

/* Four quarters, starting at three o'clock, in the direction of increasing angles. */
static bool draw_quarters(svg_reader *r, const svg_space *s, double cx, double cy, double rx,
                          double ry)
{
    svg_pen pen = svg_pen_at(r, s->to_mm);

    if (!(rx > 0 && ry > 0))
        return true;
    svg_move(&pen, cx + rx, cy);
    return svg_arc(&pen, rx, ry, 0, false, true, cx, cy + ry) &&
           svg_arc(&pen, rx, ry, 0, false, true, cx - rx, cy) &&
           svg_arc(&pen, rx, ry, 0, false, true, cx, cy - ry) &&
           svg_arc(&pen, rx, ry, 0, false, true, cx + rx, cy) && svg_close(&pen);
}

static bool draw_circle(svg_reader *r, const svg_space *s)
{
    const double cx = svg_length(r, s, "cx", SVG_ACROSS, 0),
                 cy = svg_length(r, s, "cy", SVG_ALONG_Y, 0),
                 radius = svg_size(r, s, "r", SVG_DIAGONAL, 0);

    return draw_quarters(r, s, cx, cy, radius, radius);
}

/* Radii: if one is missing, it equals the other. */
static void read_radii(const svg_reader *r, const svg_space *s, double *rx, double *ry)
{
    *rx = svg_size(r, s, "rx", SVG_ACROSS, -1);
    *ry = svg_size(r, s, "ry", SVG_ALONG_Y, -1);
    if (*rx < 0)
        *rx = fmax(*ry, 0);
    if (*ry < 0)
        *ry = *rx;
}

static bool draw_ellipse(svg_reader *r, const svg_space *s)
{
    const double cx = svg_length(r, s, "cx", SVG_ACROSS, 0),
                 cy = svg_length(r, s, "cy", SVG_ALONG_Y, 0);
    double rx, ry;

    read_radii(r, s, &rx, &ry);
    return draw_quarters(r, s, cx, cy, rx, ry);
}

static bool draw_rect(svg_reader *r, const svg_space *s)
{
    svg_pen pen    = svg_pen_at(r, s->to_mm);
    const double x = svg_length(r, s, "x", SVG_ACROSS, 0),
                 y = svg_length(r, s, "y", SVG_ALONG_Y, 0),
                 w = svg_size(r, s, "width", SVG_ACROSS, 0),
                 h = svg_size(r, s, "height", SVG_ALONG_Y, 0);
    double rx, ry;

    read_radii(r, s, &rx, &ry);
    if (w == 0 || h == 0)
        return true;
    rx = fmin(rx, w / 2);
    ry = fmin(ry, h / 2);
    svg_move(&pen, x + rx, y);
    return svg_line(&pen, x + w - rx, y) && svg_arc(&pen, rx, ry, 0, false, true, x + w, y + ry) &&
           svg_line(&pen, x + w, y + h - ry) &&
           svg_arc(&pen, rx, ry, 0, false, true, x + w - rx, y + h) &&
           svg_line(&pen, x + rx, y + h) && svg_arc(&pen, rx, ry, 0, false, true, x, y + h - ry) &&
           svg_line(&pen, x, y + ry) && svg_arc(&pen, rx, ry, 0, false, true, x + rx, y) &&
           svg_close(&pen);
}

bool svg_shape(svg_reader *r, const svg_space *space, bool *known)
{
    static const struct {
        const char *name;
        bool (*draw)(svg_reader *r, const svg_space *s);
    } shapes[] = { { "path", draw_path },      { "rect", draw_rect },
                   { "circle", draw_circle },  { "ellipse", draw_ellipse },
                   { "line", draw_line },      { "polyline", draw_polyline },
                   { "polygon", draw_polygon } };

    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        if (strcmp((const char *)r->node->name, shapes[i].name) == 0) {
            *known = true;
            return shapes[i].draw(r, space);
        }
    *known = false;
    return true;
}
