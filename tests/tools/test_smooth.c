/* tests/tools/test_smooth.c -- chains of short lines are replaced by curves: within tolerance,
 * smooth, and corners stay
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "tools/drawn.h"
#include "fit/smooth.h"

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

static void line_to(drawing *d, double at[2], double x, double y, bool fresh)
{
    double p[4][2];
    const double to[2] = { x, y };

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            p[k][i] = k == 3 ? to[i] : at[i] + k * (to[i] - at[i]) / 3;
    drawing_add(d, p, fresh, 7);
    at[0] = x;
    at[1] = y;
}

/* A smooth curve, of waves of random length and height, as `count` chords, rounded to `grid`. */
static void make_chain(drawing *d, arb *a, int count, double grid)
{
    const double size = 5 + 50 * random_unit(a), wave = (1 + 3 * random_unit(a)) * 3.14159 / size,
                 high = (0.1 + random_unit(a)) / wave, phase = 6 * random_unit(a);
    double at[2] = { 0, 0 };

    for (int i = 0; i <= count; i++) {
        double x = size * i / count, y = high * sin(wave * x + phase);
        if (grid > 0) {
            x = round(x / grid) * grid;
            y = round(y / grid) * grid;
        }
        if (i == 0) {
            at[0] = x;
            at[1] = y;
        } else if (x != at[0] || y != at[1]) {
            line_to(d, at, x, y, d->count == 0);
        }
    }
}

static double to_line(const double p[2], const drawing_curve *c)
{
    const double vx = c->p[3][0] - c->p[0][0], vy = c->p[3][1] - c->p[0][1], q = vx * vx + vy * vy;
    const double t = fmin(fmax(((p[0] - c->p[0][0]) * vx + (p[1] - c->p[0][1]) * vy) / q, 0), 1);

    return hypot(p[0] - c->p[0][0] - t * vx, p[1] - c->p[0][1] - t * vy);
}

static double to_curve(const double p[2], const drawing_curve *c, double t)
{
    double at[2];

    drawing_eval(c, t, at);
    return hypot(p[0] - at[0], p[1] - at[1]);
}

/* Ternary search; the distance has one minimum on such a short piece. */
static double nearest_distance(const double p[2], const drawing_curve *c, double lo, double hi)
{
    for (int i = 0; i < 30; i++) {
        const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (to_curve(p, c, a) < to_curve(p, c, b))
            hi = b;
        else
            lo = a;
    }
    return to_curve(p, c, lo);
}

/* The largest distance of the curves of `d` from the lines of `lines`, and of the ends of the lines
 * from the curves. */
static double largest_distance(const drawing *d, const drawing *lines)
{
    double worst = 0;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 16; k++) {
            double p[2], least = 1e9;
            drawing_eval(&d->curve[i], k / 16.0, p);
            for (size_t j = 0; j < lines->count; j++)
                least = fmin(least, to_line(p, &lines->curve[j]));
            worst = fmax(worst, least);
        }
    for (size_t j = 0; j < lines->count; j++) {
        double least = 1e9;
        for (size_t i = 0; i < d->count; i++)
            for (int k = 0; k < 32; k++)
                if (to_curve(lines->curve[j].p[3], &d->curve[i], (k + 0.5) / 32) < least + 2)
                    least = fmin(least, nearest_distance(lines->curve[j].p[3], &d->curve[i],
                                                         k / 32.0, (k + 1) / 32.0));
        worst = fmax(worst, least);
    }
    return worst;
}

static void curves_stay_within(arb *a)
{
    drawing lines = { .count = 0 }, d = { .count = 0 };
    const double within = 0.0005 + 0.003 * random_unit(a);

    make_chain(&lines, a, 40 + (int)arb_below(a, 200), arb_below(a, 2) ? 0.0001 : 0);
    const size_t replaced = drawing_smooth(&d, &lines, within);
    CHECK(replaced <= lines.count && d.count > 0);
    CHECK_NEAR(largest_distance(&d, &lines), 0, within);
    for (int i = 0; i < 2; i++) {
        CHECK(d.curve[0].p[0][i] == lines.curve[0].p[0][i]);
        CHECK(d.curve[d.count - 1].p[3][i] == lines.curve[lines.count - 1].p[3][i]);
    }
    drawing_free(&d);
    drawing_free(&lines);
}

/* Second derivatives by length agree on both sides of a knot. */
static void dense_chains_become_smooth_curves(arb *a)
{
    drawing lines = { .count = 0 }, d = { .count = 0 };

    make_chain(&lines, a, 3000, 0);
    const size_t replaced = drawing_smooth(&d, &lines, 0.001);
    CHECK(replaced == lines.count);
    CHECK(d.count * 5 < lines.count);
    for (size_t k = 1; k < d.count; k++) {
        double (*p)[2] = d.curve[k - 1].p, (*q)[2] = d.curve[k].p;
        double b = hypot(p[3][0] - p[2][0], p[3][1] - p[2][1]),
               c = hypot(q[1][0] - q[0][0], q[1][1] - q[0][1]), scale = b + c;
        for (int i = 0; i < 2; i++) {
            const double before = (p[3][i] - p[2][i]) / b, after = (q[1][i] - q[0][i]) / c;
            const double bend = (p[3][i] - 2 * p[2][i] + p[1][i]) / (b * b),
                         bent = (q[2][i] - 2 * q[1][i] + q[0][i]) / (c * c);
            CHECK(p[3][i] == q[0][i]);
            CHECK_NEAR(before, after, 1e-6);
            CHECK_NEAR(bend, bent, 0.05 * (1 + hypot(bend, bent)) + 1e-4 / scale);
        }
    }
    drawing_free(&d);
    drawing_free(&lines);
}

static void corners_stay(arb *a)
{
    drawing lines = { .count = 0 }, d = { .count = 0 };
    double at[2] = { 0, 0 }, way = 6 * random_unit(a), corner[2];
    bool found = false;

    for (int i = 0; i < 100; i++) {
        line_to(&lines, at, at[0] + 0.05 * cos(way), at[1] + 0.05 * sin(way), i == 0);
        way += 0.004;
    }
    memcpy(corner, at, sizeof corner);
    way += 0.6 + 2 * random_unit(a);
    for (int i = 0; i < 100; i++) {
        line_to(&lines, at, at[0] + 0.05 * cos(way), at[1] + 0.05 * sin(way), false);
        way -= 0.004;
    }
    CHECK(drawing_smooth(&d, &lines, 0.001) == 200);
    for (size_t k = 0; k < d.count; k++)
        found |= d.curve[k].p[3][0] == corner[0] && d.curve[k].p[3][1] == corner[1];
    CHECK(found);
    CHECK(d.count < 40);
    drawing_free(&d);
    drawing_free(&lines);
}

/* A polygon of 36 sides stays; curves are copied bit for bit; a tolerance of 0 changes nothing. */
static void what_is_no_chain_is_copied(arb *a)
{
    drawing lines = { .count = 0 }, d = { .count = 0 };
    double at[2] = { 50, 0 }, p[4][2];

    for (int i = 1; i <= 36; i++)
        line_to(&lines, at, 50 * cos(i * 3.14159265358979 / 18),
                50 * sin(i * 3.14159265358979 / 18), i == 1);
    for (int n = 0; n < 5; n++) {
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < 2; i++)
                p[k][i] = 20 * random_unit(a);
        drawing_add(&lines, p, true, 9);
    }
    CHECK(drawing_smooth(&d, &lines, 0.001) == 0);
    CHECK(d.count == lines.count);
    for (size_t k = 0; k < d.count && k < lines.count; k++)
        CHECK(memcmp(d.curve[k].p, lines.curve[k].p, sizeof d.curve[k].p) == 0 &&
              d.curve[k].path == lines.curve[k].path && d.curve[k].line == lines.curve[k].line);
    drawing_free(&d);
    drawing_free(&lines);
    make_chain(&lines, a, 300, 0);
    CHECK(drawing_smooth(&d, &lines, 0) == 0 && d.count == lines.count);
    drawing_free(&d);
    drawing_free(&lines);
}

/* Chords of a helix become curves of the helix; a chord of another feed stays out of them. */
static void chains_in_space_become_curves(arb *a)
{
    drawing lines = { .program = true }, d = { .count = 0 };
    const double r = 5 + 20 * random_unit(a), pitch = 10 * random_unit(a);
    double p[4][3], worst = 0;

    for (int i = 0; i < 400; i++) {
        for (int k = 0; k < 4; k++)
            for (int e = 0; e < 2; e++) {
                const double u = 0.01 * (i + e), part = e ? k / 3.0 : 1 - k / 3.0,
                             at[3] = { r * cos(u), r * sin(u), pitch * u };
                for (int x = 0; x < 3; x++)
                    p[k][x] = (e ? p[k][x] : 0) + part * at[x];
            }
        drawing_add_space(&lines, p, i < 200 ? 10 : 20, i == 0, (unsigned)i);
    }
    const size_t replaced = drawing_smooth(&d, &lines, 0.001);
    CHECK(replaced == 400 && d.count < 100 && d.program);
    for (size_t i = 0; i < d.count; i++) {
        CHECK(d.curve[i].feed == (d.curve[i].line < 200 ? 10 : 20));
        for (int k = 0; k <= 16; k++) {
            double at[2];
            const double t = k / 16.0, s = 1 - t, *z = d.curve[i].z;
            drawing_eval(&d.curve[i], t, at);
            const double u = (s * s * s * z[0] + 3 * s * s * t * z[1] + 3 * s * t * t * z[2] +
                              t * t * t * z[3]) /
                             pitch;
            worst = fmax(worst, hypot(at[0] - r * cos(u), at[1] - r * sin(u)));
        }
    }
    /* the chords leave the helix by r u^2 / 8, and z stands for the place along it */
    if (pitch > 1)
        CHECK_NEAR(worst, 0, 0.001 + r * 1e-4 / 8 + 0.001 * r / pitch);
    drawing_free(&d);
    drawing_free(&lines);
}

/* A drawing that comes in parts becomes the same curves as in one piece. */
static void parts_become_the_same_curves(arb *a)
{
    drawing lines = { .count = 0 }, whole = { .count = 0 }, parts = { .count = 0 },
            some = { .count = 0 };
    smoothing s  = { .within = 0.001 };
    double at[2] = { 0, 0 };

    for (int n = 0; n < 40; n++) {
        const double r = 1 + 20 * random_unit(a);
        const int count = 1 + (int)(200 * random_unit(a));
        if (n % 3 == 0)
            drawing_add_event(&lines, &(drawing_event){ .line = (unsigned)n });
        for (int i = 0; i < count; i++)
            line_to(&lines, at, at[0] + 0.05 * cos(i * 0.05 / r), at[1] + 0.05 * sin(i * 0.05 / r),
                    i == 0 && n % 3 == 0);
    }
    const size_t replaced = drawing_smooth(&whole, &lines, 0.001);
    for (size_t i = 0; i < lines.count; i++) {
        if (some.events < lines.events && lines.event[some.events].before == i)
            drawing_add_event(&some, &lines.event[some.events]);
        drawing_add_like(&some, &lines.curve[i],
                         i > 0 && lines.curve[i].path != lines.curve[i - 1].path);
        if (random_unit(a) < 0.02 || i + 1 == lines.count) {
            smooth_more(&s, &parts, &some, i + 1 == lines.count);
            if (s.given > 1) {
                drawing_forget(&some, s.given - 1);
                s.given = 1;
            }
        }
    }
    smooth_end(&s);
    CHECK(replaced > 0 && s.replaced == replaced && parts.count == whole.count);
    for (size_t k = 0; k < whole.count && k < parts.count; k++)
        CHECK(memcmp(parts.curve[k].p, whole.curve[k].p, sizeof whole.curve[k].p) == 0 &&
              parts.curve[k].path == whole.curve[k].path);
    CHECK(whole.events == lines.events && parts.events == lines.events && lines.events == 14);
    for (size_t k = 0; k < whole.events && k < parts.events; k++) {
        const drawing_event *e = &whole.event[k];
        CHECK(parts.event[k].before == e->before && parts.event[k].line == 3 * k);
        CHECK(memcmp(whole.curve[e->before].p[0], lines.curve[lines.event[k].before].p[0],
                     sizeof whole.curve->p[0]) == 0);
    }
    drawing_free(&lines);
    drawing_free(&whole);
    drawing_free(&parts);
    drawing_free(&some);
}

/* A line of pixels from `at` in a direction, each with an event; vertices are `off` the line. */
static void add_pixels(drawing *d, arb *a, double at[2], double way, int count, double off)
{
    const double from[2] = { at[0], at[1] };
    double along = 0;

    for (int i = 0; i < count; i++) {
        const double by = i + 1 == count ? 0 : off * (2 * random_unit(a) - 1);
        drawing_add_event(
            d, &(drawing_event){
                   .doing = DRAWING_SPINS, .way = 4, .amount = (double)i, .line = (unsigned)i });
        along += 0.05 + 0.1 * random_unit(a);
        line_to(d, at, from[0] + along * cos(way) - by * sin(way),
                from[1] + along * sin(way) + by * cos(way), i == 0 || arb_below(a, 2));
    }
}

/* Rows of a raster are a line each; their events are where the vertices are. Without a laser, with
 * another event or at a corner they are not joined. */
static void rows_become_lines(arb *a)
{
    drawing lines = { .program = true }, d = { .count = 0 };
    smoothing s   = { .within = 0.001, .laser = true };
    double at[2] = { 0, 0 }, way = 6 * random_unit(a);
    const int rows = 4, count = 3 + (int)arb_below(a, 400);

    for (int n = 0; n < rows; n++, way += 0.3 + 2 * random_unit(a))
        add_pixels(&lines, a, at, way, count, 0.00045);
    drawing_add_event(&lines, &(drawing_event){ .doing = DRAWING_WAITS, .amount = 1 });
    add_pixels(&lines, a, at, way, count, 0.00045);
    smooth_more(&s, &d, &lines, true);
    smooth_end(&s);
    CHECK(d.count == (size_t)rows + 1 && d.events == lines.events);
    CHECK(s.replaced == lines.count);
    for (size_t k = 0; k < d.events && d.count == (size_t)rows + 1; k++) {
        const drawing_event *e = &d.event[k], *from = &lines.event[k];
        const drawing_curve *c = &d.curve[e->before], *is = &lines.curve[from->before];
        const double length    = hypot(c->p[3][0] - c->p[0][0], c->p[3][1] - c->p[0][1]);
        CHECK(e->line == from->line && e->doing == from->doing);
        CHECK((e->along > 0) == (from->before % (size_t)count != 0));
        for (int i = 0; i < 2; i++)
            CHECK_NEAR(c->p[0][i] + e->along / length * (c->p[3][i] - c->p[0][i]), is->p[0][i],
                       0.001);
    }
    drawing_free(&d);
    s = (smoothing){ .within = 0.001 };
    smooth_more(&s, &d, &lines, true);
    smooth_end(&s);
    CHECK(d.count > lines.count / 4 && d.events == lines.events);
    for (size_t k = 0; k < d.events; k++)
        CHECK(!(d.event[k].along > 0));
    drawing_free(&d);
    drawing_free(&lines);
}

/* The same when it is read in parts. */
static void rows_in_parts_are_the_same(arb *a)
{
    drawing lines = { .program = true }, some = { .program = true }, whole = { .count = 0 },
            parts = { .count = 0 };
    smoothing s = { .within = 0.001, .laser = true }, t = s;
    double at[2] = { 0, 0 }, way = 0;

    for (int n = 0; n < 12; n++, way += 1 + random_unit(a))
        add_pixels(&lines, a, at, way, 1 + (int)arb_below(a, 200), arb_below(a, 3) ? 0.0004 : 0.1);
    smooth_more(&s, &whole, &lines, true);
    smooth_end(&s);
    for (size_t i = 0; i < lines.count; i++) {
        while (some.events < lines.events && lines.event[some.events].before == i)
            drawing_add_event(&some, &lines.event[some.events]);
        drawing_add_like(&some, &lines.curve[i],
                         i > 0 && lines.curve[i].path != lines.curve[i - 1].path);
        if (arb_below(a, 30) && i + 1 < lines.count)
            continue;
        smooth_more(&t, &parts, &some, i + 1 == lines.count);
        if (t.given > 1) {
            drawing_forget(&some, t.given - 1);
            t.given = 1;
        }
    }
    smooth_end(&t);
    CHECK(s.replaced == t.replaced && parts.count == whole.count && parts.events == whole.events);
    for (size_t k = 0; k < whole.count && k < parts.count; k++)
        CHECK(memcmp(parts.curve[k].p, whole.curve[k].p, sizeof whole.curve[k].p) == 0);
    for (size_t k = 0; k < whole.events && k < parts.events; k++)
        CHECK(parts.event[k].before == whole.event[k].before &&
              !(parts.event[k].along < whole.event[k].along) &&
              !(parts.event[k].along > whole.event[k].along));
    drawing_free(&lines);
    drawing_free(&some);
    drawing_free(&whole);
    drawing_free(&parts);
}

int main(void)
{
    PROPERTY(curves_stay_within, 20);
    PROPERTY(dense_chains_become_smooth_curves, 40);
    PROPERTY(chains_in_space_become_curves, 20);
    PROPERTY(corners_stay, 100);
    PROPERTY(what_is_no_chain_is_copied, 20);
    PROPERTY(parts_become_the_same_curves, 10);
    PROPERTY(rows_become_lines, 40);
    PROPERTY(rows_in_parts_are_the_same, 20);
    return check_failures();
}
