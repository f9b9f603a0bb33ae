/* tests/tools/test_arc.c -- arcs against the ellipse of the SVG specification
 * SPDX-License-Identifier: MIT
 *
 * The reference is the conversion to a centre of SVG 2, appendix B.2.4 and B.2.5, in long double,
 * following its text; the reader finds the centre in another way.
 */
#include "tools/drawn.h"

#define PROMISED 0.001L     /* mm */

typedef struct {
    long double rx, ry, cos, sin, cx, cy, from, sweep;      /* user units */
} reference;

static long double angle_between(long double ux, long double uy, long double vx, long double vy)
{
    return atan2l(ux * vy - uy * vx, ux * vx + uy * vy);
}

static reference reference_of(const double v[9])
{
    const long double x1 = v[0], y1 = v[1], x2 = v[7], y2 = v[8], pi = acosl(-1),
                      phi = v[4] * pi / 180;
    const bool large = v[5] > 0, sweep = v[6] > 0;
    reference e = { .rx = fabsl(v[2]), .ry = fabsl(v[3]), .cos = cosl(phi), .sin = sinl(phi) };

    const long double px = e.cos * (x1 - x2) / 2 + e.sin * (y1 - y2) / 2,
                      py = -e.sin * (x1 - x2) / 2 + e.cos * (y1 - y2) / 2;
    const long double lambda = px * px / (e.rx * e.rx) + py * py / (e.ry * e.ry);
    if (lambda > 1) {
        e.rx *= sqrtl(lambda);
        e.ry *= sqrtl(lambda);
    }
    const long double a = e.rx * e.rx, b = e.ry * e.ry, c = a * py * py + b * px * px;
    const long double root = lambda > 1
                                 ? 0
                                 : sqrtl(fmaxl((a * b - c) / c, 0)) * (large == sweep ? -1 : 1);
    const long double qx = root * e.rx * py / e.ry, qy = -root * e.ry * px / e.rx;

    e.cx = e.cos * qx - e.sin * qy + (x1 + x2) / 2;
    e.cy = e.sin * qx + e.cos * qy + (y1 + y2) / 2;
    const long double ux = (px - qx) / e.rx, uy = (py - qy) / e.ry, wx = (-px - qx) / e.rx,
                      wy = (-py - qy) / e.ry;
    e.from  = angle_between(1, 0, ux, uy);
    e.sweep = angle_between(ux, uy, wx, wy);
    if (!sweep && e.sweep > 0)
        e.sweep -= 2 * pi;
    if (sweep && e.sweep < 0)
        e.sweep += 2 * pi;
    return e;
}

/* The arc's point at the fraction s of its angle, in mm, on a page of 100 mm transformed by `m`. */
static void point_at(const reference *e, long double s, const double m[6], long double out[2])
{
    const long double t = e->from + s * e->sweep, u = e->rx * cosl(t), w = e->ry * sinl(t);
    const long double x = e->cx + e->cos * u - e->sin * w, y = e->cy + e->sin * u + e->cos * w;

    out[0] = m[0] * x + m[2] * y + m[4];
    out[1] = 100 - (m[1] * x + m[3] * y + m[5]);
}

/* The distance of p from the arc between the fractions lo and hi: golden section around the best of
 * some samples, since near a narrow tip both sides are near. */
static long double distance_to(const reference *e, const double m[6], long double lo,
                               long double hi, const double p[2])
{
    long double qa[2], qb[2], best = HUGE_VALL, at = lo;
    const long double step = (hi - lo) / 64;

    for (int i = 0; i <= 64; i++) {
        point_at(e, lo + i * step, m, qa);
        if (hypotl(qa[0] - p[0], qa[1] - p[1]) < best) {
            best = hypotl(qa[0] - p[0], qa[1] - p[1]);
            at   = lo + i * step;
        }
    }
    lo = fmaxl(at - step, lo);
    hi = fminl(at + step, hi);
    for (int i = 0; i < 80; i++) {
        const long double a = lo + 0.381966L * (hi - lo), b = hi - 0.381966L * (hi - lo);
        point_at(e, a, m, qa);
        point_at(e, b, m, qb);
        if (hypotl(qa[0] - p[0], qa[1] - p[1]) < hypotl(qb[0] - p[0], qb[1] - p[1]))
            hi = b;
        else
            lo = a;
    }
    return fminl(best, hypotl(qa[0] - p[0], qa[1] - p[1]));
}

static double arb_between(arb *a, double lo, double hi)
{
    return lo + (hi - lo) * (double)(arb_next(a) >> 11) / 9007199254740992.0;
}

/* Start, radii, angle, flags, end of an arc; and the transform of the page. */
static void arb_arc(arb *a, double v[9], double m[6])
{
    for (int i = 0; i < 9; i++)
        v[i] = arb_between(a, -100, 100);
    v[2] = arb_between(a, 1, arb_below(a, 4) ? 60 : 3000);
    v[3] = arb_below(a, 3) ? arb_between(a, 1, 60) : v[2];
    v[4] = arb_below(a, 3) ? arb_between(a, -400, 400) : 90.0 * arb_below(a, 4);
    v[5] = arb_below(a, 2);
    v[6] = arb_below(a, 2);
    if (arb_below(a, 4) == 0)
        for (int i = 0; i < 2; i++)             /* short ones as well */
            v[7 + i] = v[i] + arb_between(a, -1, 1);
    for (int i = 0; i < 6; i++)
        m[i] = arb_between(a, -2, 2);
}

/* The curves lie on the ellipse within a micrometre, run along it from its start to its end, and
 * reach both exactly. */
static void arcs_are_within_a_micrometre(arb *a)
{
    char text[600];
    double v[9], m[6];
    drawing d;

    arb_arc(a, v, m);
    snprintf(text, sizeof text,
             PAGE("<path transform='matrix(%.17g %.17g %.17g %.17g %.17g %.17g)' d='M%.17g "
                  "%.17gA%.17g %.17g %.17g %g %g %.17g %.17g'/>"),
             m[0], m[1], m[2], m[3], m[4], m[5], v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7],
             v[8]);
    const reference e = reference_of(v);
    if (read_svg(&d, text) != 0 || d.count == 0) {      /* what is too large is left out */
        CHECK(strstr(caught, "beyond +-16000 mm") != NULL &&
              fmaxl(e.rx, e.ry) * 4 + 500 > DRAWING_LIMIT / 2);
        drawing_free(&d);
        return;
    }
    const double *first = d.curve[0].p[0], *last = d.curve[d.count - 1].p[3];
    CHECK_NEAR(first[0], m[0] * v[0] + m[2] * v[1] + m[4], 1e-9);
    CHECK_NEAR(last[0],  m[0] * v[7] + m[2] * v[8] + m[4], 1e-9);
    CHECK_NEAR(last[1],  100 - (m[1] * v[7] + m[3] * v[8] + m[5]), 1e-9);
    for (size_t i = 0; i < d.count; i++)
        for (int k = 0; k <= 8; k++) {
            double p[2];
            drawing_eval(&d.curve[i], k / 8.0, p);
            /* nearly */
            const long double n = (long double)d.count, share = ((long double)i + k / 8.0L) / n;
            CHECK(distance_to(&e, m, fmaxl(share - 0.05L / n, 0), fminl(share + 0.05L / n, 1), p) <=
                  PROMISED);
        }

    /* the pieces divide the angle equally: piece i starts at fraction i / count of the true arc */
    for (size_t i = 0; i < d.count; i++) {
        long double q[2];
        point_at(&e, (long double)i / (long double)d.count, m, q);
        CHECK_NEAR(d.curve[i].p[0][0], q[0], 1e-6);
        CHECK_NEAR(d.curve[i].p[0][1], q[1], 1e-6);
    }
    drawing_free(&d);
}

/* The number of pieces is minimal: with one less, a circle would deviate by more than a
 * micrometre. */
static void circles_have_few_pieces(arb *a)
{
    const double radius = arb_between(a, 0.5, 49);
    char text[300];
    drawing d;

    snprintf(text, sizeof text, PAGE("<path d='M50 50m%.17g 0a%.17g %.17g 0 1 1 0 1e-9'/>"), radius,
             radius, radius);
    CHECK(read_svg(&d, text) == 0);
    const double quarter = acos(-1) / 2 / ((double)(d.count - 1) / 4) / 4;
    CHECK(d.count == 4 || 2.0 / 27 * pow(sin(quarter), 6) / pow(cos(quarter), 2) * radius > 0.0005);
    /* outwards by half a micrometre */
    CHECK_NEAR(drawing_length(&d), 4 * acos(0) * radius, 4 * acos(0) * 0.0005);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(arcs_are_within_a_micrometre, 400);
    PROPERTY(circles_have_few_pieces, 200);
    return check_failures();
}
