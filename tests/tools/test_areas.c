/* tests/tools/test_areas.c -- strokes as areas, and painted areas cut at clip paths
 * SPDX-License-Identifier: MIT
 *
 * cairo judges: a point is in a stroke, or in what is painted inside of a clip path, or not.
 */
#include <cairo.h>

#include "arrange/areas.h"
#include "tools/drawn.h"
#include "svg/svg_file.h"

static bool areas_of(const char *inner, bool strokes, bool fills, drawing *d)
{
    static char text[160000];

    snprintf(text, sizeof text, PAGE("%s"), inner);
    hear();
    *d           = (drawing){ .areas = fills };
    return drawing_read_svg(&heard, d, "test.svg", text, strlen(text)) == 0 &&
           areas_apply(&heard, strokes, fills, d, "test.svg") == 0;
}

static void add_curves(cairo_t *cairo, const drawing *d, unsigned without)
{
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        if (c->fill & without)
            continue;
        if (i == 0 || c->path != c[-1].path || c[-1].fill & without)
            cairo_move_to(cairo, c->p[0][0], c->p[0][1]);
        cairo_curve_to(cairo, c->p[1][0], c->p[1][1], c->p[2][0], c->p[2][1], c->p[3][0],
                       c->p[3][1]);
    }
}

static cairo_t *judge_of(const drawing *d, unsigned without)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cairo           = cairo_create(surface);

    cairo_surface_destroy(surface);
    cairo_set_tolerance(cairo, 0.001);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    add_curves(cairo, d, without);
    return cairo;
}

/* Do both say the same of a point, unless it is near an edge? */
static bool agree(cairo_t *one, cairo_bool_t (*is_in)(cairo_t *, double, double), cairo_t *area,
                  double x, double y, unsigned *inside)
{
    const double near = 0.03;
    const bool in     = is_in(one, x, y);

    for (int k = 0; k < 8; k++)
        if (is_in(one, x + near * ((k % 3) - 1), y + near * ((k / 3) - 1)) != in)
            return true;
    *inside += in;
    return cairo_in_fill(area, x, y) == in;
}

/* The transform of a stroke, without its shift: cairo makes an ellipse of a pen by it. */
static cairo_matrix_t bent;

static cairo_bool_t in_bent_stroke(cairo_t *cairo, double x, double y)
{
    cairo_save(cairo);
    cairo_transform(cairo, &bent);
    cairo_device_to_user(cairo, &x, &y);
    const cairo_bool_t in = cairo_in_stroke(cairo, x, y);
    cairo_restore(cairo);
    return in;
}

static double part(arb *a, double least, double most)
{
    return least + (most - least) * arb_below(a, 1001) / 1000;
}

static void strokes_become_areas(arb *a)
{
    static const char *const caps[] = { "butt", "round", "square" }, *const joins[] = { "miter",
                                                                                        "round",
                                                                                        "bevel" };
    const unsigned cap = arb_below(a, 3), join = arb_below(a, 3), width = 2 + arb_below(a, 6);
    const bool closed = join > 0 && arb_below(a, 2), even = arb_below(a, 2);
    char inner[1000], shape[300] = "";
    unsigned inside = 0;
    drawing line, area;

    /* mitres are within their limit: beyond it browsers cut a corner shorter than GEOS does */
    snprintf(shape, sizeof shape, "M%u %uC%u %u 60 20 %u %uL%u %uL%u %u%s", 10 + arb_below(a, 10),
             10 + arb_below(a, 10), 30 + arb_below(a, 10), 40 + arb_below(a, 30),
             80 + arb_below(a, 9), 20 + arb_below(a, 10), 80 + arb_below(a, 10),
             80 + arb_below(a, 10), 20 + arb_below(a, 10), 80 + arb_below(a, 10),
             closed ? "z" : "");
    cairo_matrix_init_scale(&bent, 0.9, -0.9);
    if (!even)
        cairo_matrix_init(&bent, part(a, 0.5, 1), part(a, -0.2, 0.2), part(a, -0.4, 0.4),
                          part(a, 0.25, 0.6), 0, 0);
    snprintf(inner, sizeof inner,
             "<path transform='matrix(%.9g %.9g %.9g %.9g %d %d)' fill='none' stroke='red' "
             "stroke-width='%u' stroke-linecap='%s' style='stroke-linejoin:%s' d='%s'/>",
             bent.xx, -bent.yx, bent.xy, -bent.yy, even ? 5 : 15, even ? 0 : 30, width, caps[cap],
             joins[join], shape);
    CHECK(areas_of(inner, false, false, &line) && areas_of(inner, true, false, &area));
    CHECK(area.count > line.count && area.curve[0].fill & DRAWING_FILLED);
    cairo_t *one = judge_of(&line, 0), *other = judge_of(&area, 0);
    if (closed)
        cairo_close_path(one);
    cairo_set_line_width(one, width);
    cairo_set_line_cap(one, cap == 0   ? CAIRO_LINE_CAP_BUTT
                            : cap == 1 ? CAIRO_LINE_CAP_ROUND
                                       : CAIRO_LINE_CAP_SQUARE);
    cairo_set_line_join(one, join == 0   ? CAIRO_LINE_JOIN_MITER
                             : join == 1 ? CAIRO_LINE_JOIN_ROUND
                                         : CAIRO_LINE_JOIN_BEVEL);
    cairo_set_miter_limit(one, 4);
    for (int k = 0; k < 3000; k++)
        CHECK(agree(one, in_bent_stroke, other, arb_below(a, 100000) / 1000.0,
                    arb_below(a, 100000) / 1000.0, &inside));
    CHECK(inside > 10);
    cairo_destroy(one);
    cairo_destroy(other);
    drawing_free(&line);
    drawing_free(&area);
}

/* A disk or a square, along the axes of the user, which may be an ellipse or a rectangle, within a
 * few micrometres. */
static void dots_have_the_width_of_their_stroke(arb *a)
{
    const double width = 0.3 + arb_below(a, 50) / 10.0, turn = arb_below(a, 90) * acos(-1) / 180;
    const double along = part(a, 0.5, 3), across = arb_below(a, 2) ? along : part(a, 0.05, 3),
                 most = fmax(along, across);
    const bool square = arb_below(a, 2);
    char inner[400];
    double area = 0;
    drawing d;

    snprintf(inner, sizeof inner,
             "<path transform='translate(40 60) rotate(%.9g) scale(%.9g %.9g)' fill='none' "
             "stroke='red' stroke-width='%g' stroke-linecap='%s' d='M0 0h0'/>",
             turn * 180 / acos(-1), along, across, width, square ? "square" : "round");
    CHECK(areas_of(inner, true, true, &d) && d.count >= 4);
    for (size_t i = 0; i < d.count; i++) {
        const double *p = d.curve[i].p[0], *q = d.curve[i].p[3];
        const double x = p[0] - 40, y = 40 - p[1], u = (x * cos(turn) + y * sin(turn)) / along,
                     v = (y * cos(turn) - x * sin(turn)) / across;
        const double far = square ? fmax(fabs(u), fabs(v)) : hypot(u, v);
        CHECK(fabs(far - width / 2) * most < 0.0035 && d.curve[i].path == d.curve[0].path);
        area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
    const double whole = along * across * width * width * (square ? 1 : acos(-1) / 4);
    CHECK(fabs(fabs(area) - whole) < 4 * width * most * 0.0035);
    drawing_free(&d);
}

/* The least distance of a place from a chain of points. */
static double far_from(const double (*chain)[2], size_t count, const double at[2])
{
    double least = HUGE_VAL;

    for (size_t i = 0; i + 1 < count; i++) {
        const double x = chain[i + 1][0] - chain[i][0], y = chain[i + 1][1] - chain[i][1],
                     u = at[0] - chain[i][0], v = at[1] - chain[i][1],
                     t = fmin(fmax((u * x + v * y) / (x * x + y * y), 0), 1);
        least = fmin(least, hypot(u - t * x, v - t * y));
    }
    return least;
}

/* GEOS leaves out vertices where a line bends in by less than 1 % of the distance: here by up to
 * 0.4 mm. The outline keeps its distance all the same. */
static void wide_strokes_keep_their_distance(arb *a)
{
    const double width = 20 + arb_below(a, 60), bend = width / 2 * arb_below(a, 100) / 10000;
    const unsigned waves = 4 + arb_below(a, 60);
    char inner[3500];
    int used = snprintf(inner, sizeof inner,
                        "<path fill='none' stroke='red' stroke-width='%g' "
                        "stroke-linejoin='round' stroke-linecap='round' d='M",
                        width);
    double chain[64][2];
    drawing d;

    for (unsigned k = 0; k < waves; k++) {
        chain[k][0] = 10 + 80.0 * k / (waves - 1);
        chain[k][1] = 60 - 0.01 * k * k / 8 + (k % 2 ? bend : 0);
        used += snprintf(inner + used, sizeof inner - (size_t)used, " %.9g %.9g", chain[k][0],
                         100 - chain[k][1]);
    }
    snprintf(inner + used, sizeof inner - (size_t)used, "'/>");
    CHECK(areas_of(inner, true, true, &d) && d.count >= 20);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 4; k++) {
            double at[2];
            drawing_eval(&d.curve[i], k / 4.0, at);
            CHECK(fabs(far_from((const double (*)[2])chain, waves, at) - width / 2) < 0.0025);
        }
    drawing_free(&d);
}

/* A scribble of so many lines that are shorter than it is wide. */
static void long_wide_strokes_have_no_false_holes(arb *a)
{
    enum { PLACES = 6001 };
    static double chain[PLACES][2];
    static char inner[PLACES * 24];
    const double width = 3;
    double way = 0;
    drawing d;
    int used = snprintf(inner, sizeof inner,
                        "<path fill='none' stroke='red' stroke-width='%g' stroke-linejoin='round' "
                        "stroke-linecap='round' d='M",
                        width);

    for (int n = 0; n < PLACES; n++) {
        const double *last = chain[n > 0 ? n - 1 : 0];
        way += arb_below(a, 2401) / 1000.0 - 1.2;
        for (int i = 0; i < 2; i++) {
            const double to = n == 0 ? 50 : last[i] + 0.5 * (i ? sin(way) : cos(way));
            chain[n][i]     = floor(1000 * fmin(fmax(to, 10), 90)) / 1000;
        }
        used += snprintf(inner + used, sizeof inner - (size_t)used, " %.3f %.3f", chain[n][0],
                         100 - chain[n][1]);
    }
    snprintf(inner + used, sizeof inner - (size_t)used, "'/>");
    CHECK(areas_of(inner, true, true, &d) && d.count > 100);
    for (size_t i = 0; i < d.count; i++)
        CHECK(fabs(far_from((const double (*)[2])chain, PLACES, d.curve[i].p[0]) - width / 2) <
              0.0025);
    drawing_free(&d);
}

/* Bends that are tighter than the stroke is wide: no false holes, each place of the outline is at
 * half of the width. */
static void wide_strokes_fill_tight_bends(arb *a)
{
    enum { PLACES = 3001 };
    static double chain[PLACES][2];
    const double width = 10 + arb_below(a, 90);
    const bool ring    = arb_below(a, 4) == 0;
    double p[4][2];
    char inner[400];
    drawing line, area;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            p[k][i] = 40 + arb_below(a, 2001) / 100.0;
    const int used = snprintf(inner, sizeof inner,
                              "<path fill='none' stroke='red' stroke-width='%g' stroke-linejoin="
                              "'round' stroke-linecap='round' d='",
                              width);
    snprintf(inner + used, sizeof inner - (size_t)used,
             ring ? "M%g %ga%g %g 0 1 0 9 0a%g %g 0 1 0 -9 0z'/>" : "M%g %gC%g %g %g %g %g %g'/>",
             p[0][0], p[0][1], ring ? 4.5 : p[1][0], ring ? 4.5 : p[1][1], ring ? 4.5 : p[2][0],
             ring ? 4.5 : p[2][1], p[3][0], p[3][1]);
    CHECK(areas_of(inner, false, false, &line) && areas_of(inner, true, true, &area));
    for (int n = 0; n < PLACES; n++) {
        const double t = (double)n / (PLACES - 1) * (double)line.count;
        const size_t i = t < (double)line.count ? (size_t)t : line.count - 1;
        drawing_eval(&line.curve[i], t - (double)i, chain[n]);
    }
    for (size_t i = 0; i < area.count; i++)
        CHECK(fabs(far_from((const double (*)[2])chain, PLACES, area.curve[i].p[0]) - width / 2) <
              0.005);
    CHECK(area.count > 20);
    drawing_free(&line);
    drawing_free(&area);
}

static cairo_t *clip, *painted;
static cairo_bool_t in_both(cairo_t *cairo, double x, double y)
{
    (void)cairo;
    return cairo_in_fill(clip, x, y) && cairo_in_fill(painted, x, y);
}

static void painted_areas_are_clipped(arb *a)
{
    char star[400] = "M50 5", circle[200], inner[1500];
    unsigned inside = 0;
    drawing area, plain;

    for (int k = 0; k < 5; k++)
        snprintf(star + strlen(star), sizeof star - strlen(star), "L%u %u", arb_below(a, 100),
                 arb_below(a, 100));
    snprintf(circle, sizeof circle, "<circle cx='%u' cy='%u' r='%u'/>", 30 + arb_below(a, 40),
             30 + arb_below(a, 40), 10 + arb_below(a, 30));
    snprintf(inner, sizeof inner,
             "<clipPath id='c'>%s</clipPath><g clip-path='url(#c)'><path fill-rule='evenodd' "
             "d='%s'/></g>",
             circle, star);
    CHECK(areas_of(inner, false, true, &area));
    cairo_t *of = judge_of(&area, 0);       /* what is drawn of the outline is no area */
    cairo_new_path(of);
    for (size_t i = 0; i < area.count; i++) {
        const drawing_curve *c = &area.curve[i];
        if (!(c->fill & DRAWING_HIDDEN))
            continue;
        if (i == 0 || c->path != c[-1].path)
            cairo_move_to(of, c->p[0][0], c->p[0][1]);
        cairo_line_to(of, c->p[3][0], c->p[3][1]);
    }
    CHECK(areas_of(circle, false, false, &plain));
    clip = judge_of(&plain, 0);
    drawing_free(&plain);
    snprintf(inner, sizeof inner, "<path d='%sz'/>", star);
    CHECK(areas_of(inner, false, false, &plain));
    painted = judge_of(&plain, 0);
    drawing_free(&plain);
    for (int k = 0; k < 1000; k++)
        CHECK(agree(of, in_both, of, arb_below(a, 100000) / 1000.0, arb_below(a, 100000) / 1000.0,
                    &inside));
    cairo_destroy(of);
    cairo_destroy(clip);
    cairo_destroy(painted);
    drawing_free(&area);
}

/* Two clip paths, one around the other; and one that leaves nothing. */
static void clip_paths_add_up(arb *a)
{
    unsigned hidden = 0;
    drawing d;

    (void)a;
    CHECK(areas_of("<clipPath id='c'><path d='M10 10h20v20h-20z'/></clipPath>"
                   "<clipPath id='d'><path d='M20 20h20v20h-20z'/></clipPath>"
                   "<clipPath id='e'/>"
                   "<g clip-path='url(#c)'><g clip-path='url(#d)'><path d='M0 0h99v99h-99z'/></g>"
                   "<path clip-path='url(#e)' d='M0 0h99v99h-99z'/></g>",
                   false, true, &d));
    for (size_t i = 0; i < d.count; i++)
        hidden += (d.curve[i].fill & DRAWING_HIDDEN) != 0;
    CHECK(hidden == 4);         /* the second shape has no area, and none of its outline is seen */
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(strokes_become_areas, 60);
    PROPERTY(dots_have_the_width_of_their_stroke, 100);
    PROPERTY(wide_strokes_fill_tight_bends, 15);
    PROPERTY(long_wide_strokes_have_no_false_holes, 1);
    PROPERTY(wide_strokes_keep_their_distance, 100);
    PROPERTY(painted_areas_are_clipped, 60);
    PROPERTY(clip_paths_add_up, 1);
    return check_failures();
}
