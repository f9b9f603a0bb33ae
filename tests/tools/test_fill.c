/* tests/tools/test_fill.c -- lines that fill shapes: where they are, and where they are not
 * SPDX-License-Identifier: MIT
 *
 * cairo judges: a point is inside a shape or not by its own rule of winding.
 */
#include <cairo.h>

#include "arrange/fill.h"
#include "tools/drawn.h"

/* Read --fill. Returns the fault, "" if there is none. */
static const char *read_fill(const char *how, fill_options *f)
{
    static option_fault fault;
    char word[100], *line[] = { "plot", word, NULL };

    snprintf(word, sizeof word, "--fill=%s", how);
    *f = (fill_options){ .distance = 0 };
    (void)options_read(fill_rows, 2, line, f, &fault);
    return fault.text;
}

static bool fill_svg(const char *inner, const char *how, const char *outline, drawing *d)
{
    char text[4000];
    fill_options f;

    snprintf(text, sizeof text, PAGE("%s"), inner);
    if (*read_fill(how, &f) || read_svg(d, text) != 0)
        return false;
    f.outline = outline;
    return fill_apply(&heard, &f, d, "test.svg") == 0;
}

static void check_filled(const char *inner, const char *how, const char *outline,
                         const char *wanted, int line)
{
    char got[4000];
    drawing d;

    if (!fill_svg(inner, how, outline, &d)) {
        printf("%s:%d: %s\n", __FILE__, line, caught);
        check_bad = true;
        return;
    }
    put_drawing(got, sizeof got, &d, 100);
    if (strcmp(got, wanted) != 0) {
        printf("%s:%d: %s\n  %s\n", __FILE__, line, got, wanted);
        check_bad = true;
    }
    drawing_free(&d);
}
#define FILLS(inner, how, wanted) check_filled(inner, how, "none", wanted, __LINE__)

/* Page heights are 100 - y, so the grid of lines 2 apart lies at odd y. */
static void lines_fill_shapes(arb *a)
{
    (void)a;
    FILLS("<rect x='10' y='10' width='20' height='4'/>", "hatch:0,2",
          "M 30 13 L 10 13 M 10 11 L 30 11");
    FILLS("<rect x='10' y='10' width='4' height='20'/>", "hatch:90,2",
          "M 13 10 L 13 30 M 11 30 L 11 10");
    FILLS("<rect x='10' y='10' width='2' height='2'/>", "cross:0,2",
          "M 10 11 L 12 11 M 11 12 L 11 10");
    FILLS("<path d='M10 10h20v2h-20'/>", "hatch:0,2", "M 10 11 L 30 11");
    FILLS("<path d='M10 10h20v2h-20zm5 -1h10v4h-10z'/>", "hatch:0,2",
          "M 25 13 L 15 13 M 10 11 L 30 11");
    FILLS("<path fill-rule='evenodd' d='M10 10h20v2h-20zm5 -1h10v4h-10z'/>", "hatch:0,2",
          "M 25 13 L 15 13 M 10 11 L 15 11 M 25 11 L 30 11");
    FILLS("<path d='M10 10h20v2h-20zm5 -1v4h10v-4z'/>", "hatch:0,2",
          "M 25 13 L 15 13 M 10 11 L 15 11 M 25 11 L 30 11");
    check_filled("<path d='M10 10h2v2h-2z'/><path d='M20 10h2v2h-2z' fill='none' stroke='red'/>",
                 "hatch:0,2", NULL,
                 "M 10 10 L 12 10 L 12 12 L 10 12 L 10 10 M 10 11 L 12 11"
                 " M 20 10 L 22 10 L 22 12 L 20 12 L 20 10",
                 __LINE__);
    check_filled("<g stroke='red'><path d='M10 10h2v2h-2z'/></g><path d='M20 10h2v2h-2z'/>",
                 "hatch:0,2", "stroke",
                 "M 10 10 L 12 10 L 12 12 L 10 12 L 10 10 M 10 11 L 12 11 M 20 11 L 22 11",
                 __LINE__);
}

static void add_curves(cairo_t *cairo, const drawing *d)
{
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        if (i == 0 || c->path != c[-1].path)
            cairo_move_to(cairo, c->p[0][0], c->p[0][1]);
        cairo_curve_to(cairo, c->p[1][0], c->p[1][1], c->p[2][0], c->p[2][1], c->p[3][0],
                       c->p[3][1]);
    }
}

/* At a point of the grid: is it on a line, or near the end of one? */
static int on_lines(const drawing *d, double x, double y)
{
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->curve[i].p[0], *b = d->curve[i].p[3];
        if (fabs(a[1] - y) > 1e-6)
            continue;
        const double low = fmin(a[0], b[0]), high = fmax(a[0], b[0]);
        if (fabs(x - low) < 0.2 || fabs(x - high) < 0.2)
            return -1;
        if (x > low && x < high)
            return 1;
    }
    return 0;
}

/* Random curves, also ones that cross themselves: cairo says which points are inside. */
static void what_is_inside_is_what_is_painted(arb *a)
{
    const bool evenodd = arb_below(a, 2);
    char inner[2000]   = "";
    drawing outline, lines;

    snprintf(inner, sizeof inner, "<path fill-rule='%s' d='", evenodd ? "evenodd" : "nonzero");
    for (int path = 0; path < 2; path++) {
        sprintf(inner + strlen(inner), "M%u %u", 5 + arb_below(a, 90), 5 + arb_below(a, 90));
        for (int k = 0; k < 4; k++)
            sprintf(inner + strlen(inner), "C%u %u %u %u %u %u", arb_below(a, 100),
                    arb_below(a, 100), arb_below(a, 100), arb_below(a, 100), arb_below(a, 100),
                    arb_below(a, 100));
    }
    strcat(inner, "'/>");
    CHECK(fill_svg(inner, "none", NULL, &outline) && fill_svg(inner, "hatch:0,2", "none", &lines));
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cairo           = cairo_create(surface);
    cairo_set_tolerance(cairo, 0.01);
    cairo_set_fill_rule(cairo, evenodd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    add_curves(cairo, &outline);
    unsigned judged = 0;
    for (int k = 0; k < 300; k++) {
        const double x = arb_below(a, 100000) / 1000.0, y = 1 + 2 * (double)arb_below(a, 50);
        const int on   = on_lines(&lines, x, y);
        /* near an edge, cairo's tolerance decides; on an edge, the point is inside for cairo */
        const bool near = cairo_in_fill(cairo, x - 0.1, y) != cairo_in_fill(cairo, x + 0.1, y) ||
                          cairo_in_fill(cairo, x, y - 0.1) != cairo_in_fill(cairo, x, y + 0.1);
        if (on < 0 || near)
            continue;
        judged++;
        CHECK(cairo_in_fill(cairo, x, y) == (on > 0));
    }
    CHECK(judged > 100);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    drawing_free(&outline);
    drawing_free(&lines);
}

/* Turned by any angle, the lines have the length that the area wants. */
static void lines_cover_the_area(arb *a)
{
    const double angle = arb_below(a, 36000) / 100.0, apart = 0.1 + arb_below(a, 100) / 500.0;
    const double r     = 5 + (double)arb_below(a, 30);
    char inner[200], how[60];
    drawing d;

    snprintf(inner, sizeof inner, "<circle cx='50' cy='50' r='%.3f'/>", r);
    snprintf(how, sizeof how, "hatch:%.2f,%.3f", angle, apart);
    CHECK(fill_svg(inner, how, "none", &d));
    CHECK(fabs(drawing_length(&d) * apart - M_PI * r * r) < 0.002 * M_PI * r * r + 0.02);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k < 4; k += 3)
            CHECK(fabs(hypot(d.curve[i].p[k][0] - 50, d.curve[i].p[k][1] - 50) - r) < 6e-4);
    drawing_free(&d);
}

static void bad_fills_are_refused(arb *a)
{
    static const char *const bad[] = {
        "",     "hatch:",       "hatch:45", "hatch:45,0",  "hatch:x,1",
        "wave", "hatch:45,1,2", "hatching", "cross:400,1", "hatch:0,nan",
        "contour:", "contour:0", "contour:1,round", "contour:1 spiral"
    };
    fill_options f;
    drawing d;

    (void)a;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        CHECK(strstr(read_fill(bad[i], &f), "give hatch:ANGLE,MM"));
    CHECK(!fill_svg("<path fill='none' stroke='red' d='M0 0h1v1'/>", "hatch", NULL, &d) &&
          strstr(caught, "nothing in it is filled"));
    drawing_free(&d);
}

/* The distance of a point from the outlines of a drawing. */
static double edge_distance(const drawing *d, const double at[2])
{
    double least = HUGE_VAL;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 400; k++) {
            double p[2];
            drawing_eval(&d->curve[i], k / 400.0, p);
            least = fmin(least, hypot(p[0] - at[0], p[1] - at[1]));
        }
    return least;
}

static double path_length(const drawing *d, unsigned path)
{
    double sum = 0;

    for (size_t i = 0; i < d->count; i++)
        if (d->curve[i].path == path)
            sum += hypot(d->curve[i].p[3][0] - d->curve[i].p[0][0],
                         d->curve[i].p[3][1] - d->curve[i].p[0][1]);
    return sum;
}

/* Lengths of rectangles are known exactly. */
static void contours_of_rectangles(arb *a)
{
    drawing d;

    (void)a;
    CHECK(fill_svg("<rect x='10' y='10' width='20' height='6'/>", "contour:2", "none", &d));
    CHECK(d.count == 4 && fabs(path_length(&d, 0) - 44) < 1e-6);
    drawing_free(&d);
    /* a hole; both, and the corner of the hole is round */
    CHECK(fill_svg("<path fill-rule='evenodd' d='M10 10h20v20h-20zM15 15h10v10h-10z'/>",
                   "contour:2", "none", &d));
    double sum = 0;
    for (unsigned k = 0; k <= d.curve[d.count - 1].path; k++)
        sum += path_length(&d, k);
    CHECK(fabs(sum - (72 + 40 + 2 * 3.14159265358979)) < 0.05);
    drawing_free(&d);
    CHECK(fill_svg("<path d='M10 10h20v20h-20zM15 15h10v10h-10z'/>", "contour:8", "none", &d));
    CHECK(fabs(path_length(&d, 0) - 48) < 1e-6 && d.curve[d.count - 1].path == 0);
    drawing_free(&d);
    CHECK(fill_svg("<rect x='10' y='10' width='2' height='1'/><rect x='20' y='10' width='9' "
                   "height='9'/>",
                   "contour:4", "none", &d));
    CHECK(d.count > 0 && d.curve[0].p[0][0] > 20);
    drawing_free(&d);
}

/* A line is at half a distance from the edge, or at one and a half .. */
static void contours_keep_their_distance(arb *a)
{
    const double distance = 1 + (arb_below(a, 100000) / 1e5);
    char inner[1000], how[40], text[1200];
    double p[7][2];
    drawing d, outline;

    for (int k = 0; k < 7; k++)
        for (int i = 0; i < 2; i++)
            p[k][i] = 5 + 30 * (arb_below(a, 100000) / 1e5);
    snprintf(inner, sizeof inner,
             "<path fill-rule='evenodd' d='M%g %gC%g %g %g %g %g %gS%g %g %g %gL%g %gz'/>", p[0][0],
             p[0][1], p[1][0], p[1][1], p[2][0], p[2][1], p[3][0], p[3][1], p[4][0], p[4][1],
             p[5][0], p[5][1], p[6][0], p[6][1]);
    snprintf(how, sizeof how, "contour:%g", distance);
    snprintf(text, sizeof text, PAGE("%s"), inner);
    CHECK(read_svg(&outline, text) == 0 && fill_svg(inner, how, "none", &d));
    for (size_t i = 0; i < d.count; i += 1 + d.count / 40) {
        const double from = edge_distance(&outline, d.curve[i].p[3]) / distance - 0.5;
        CHECK(fabs(from - round(from)) < 0.01 + 0.02 * (1 + from));
    }
    drawing_free(&d);
    drawing_free(&outline);
}

static void spirals_need_no_lift(arb *a)
{
    drawing d;
    double before = 0;

    (void)a;
    CHECK(fill_svg("<circle cx='50' cy='50' r='10'/>", "contour:1,spiral", "none", &d));
    CHECK(d.count > 100 && d.curve[d.count - 1].path == 0);
    for (size_t i = 0; i < d.count; i++) {          /* it never goes outwards */
        const double r = hypot(d.curve[i].p[3][0] - 50, d.curve[i].p[3][1] - 50);
        CHECK(i == 0 || r < before + 0.004);
        CHECK(r < 9.502);
        before = r;
    }
    CHECK(before < 1.01);
    /* turns are 1 mm apart, so that their length is the area; both ends are drawn whole */
    CHECK(fabs(path_length(&d, 0) - (9.5 * 9.5 - 0.25 + 2 * 10) * 3.14159265) < 1);
    drawing_free(&d);
    CHECK(fill_svg("<circle cx='50' cy='50' r='10'/>", "contour:1", "none", &d));
    CHECK(d.curve[d.count - 1].path == 9);
    drawing_free(&d);
}

typedef struct {
    double clock, done;
    unsigned calls, most;       /* of progress; that many, then it ends */
} told;

static double later(void *context) { return ((told *)context)->clock += 1; }
static bool follow(void *context, const host_progress *p)
{
    told *t = context;

    if (p->doing == NULL)
        return true;
    CHECK(p->done <= p->total);
    t->done = p->done;
    return ++t->calls < t->most;
}

/* One shape of many sizes says how far it is, and ends when it is told to. */
static void one_large_shape_tells_how_far_it_is(arb *a)
{
    told t = { .most = 3 + arb_below(a, 4) };
    host h = { .progress = follow, .now = later, .context = &t };
    fill_options f;
    drawing d;

    CHECK(!*read_fill("contour:0.2", &f) &&
          read_svg(&d, PAGE("<rect x='10' y='10' width='60' height='50'/>")) == 0);
    CHECK(fill_apply(&h, &f, &d, "test.svg") == EX_TEMPFAIL);
    CHECK(t.calls == t.most && t.done > 0);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(one_large_shape_tells_how_far_it_is, 4);
    PROPERTY(lines_fill_shapes, 1);
    PROPERTY(what_is_inside_is_what_is_painted, 200);
    PROPERTY(lines_cover_the_area, 100);
    PROPERTY(contours_of_rectangles, 1);
    PROPERTY(contours_keep_their_distance, 60);
    PROPERTY(spirals_need_no_lift, 1);
    PROPERTY(bad_fills_are_refused, 1);
    return check_failures();
}
