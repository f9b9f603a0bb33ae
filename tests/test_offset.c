/* tests/test_offset.c -- properties of lib/curve/offset.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/offset.h"
#include "exact.h"          /* exact_eval, exact_deriv, CHECK_EXACT */

#define SPANS 5000

typedef struct {
    loft_cubic curve;
    loft_real distance, tol;
    long double c[LOFT_AXES < 2 ? 2 : LOFT_AXES][4], d, t;
    loft_offset_span span[SPANS];
    unsigned count;
} scene;

static void arb_scene(arb *a, scene *s, int32_t limit)
{
    const int32_t tols[4] = { 6, 66, 655, 6554 };

    s->curve = arb_cubic(a, limit);
    s->distance = arb_real(a, 1 + (int32_t)arb_below(a, (uint32_t)limit));
    s->tol = loft_real_from_raw(tols[arb_below(a, 4)]);
    if (arb_below(a, 6) == 0)
        s->curve.p[1] = s->curve.p[0];
    if (arb_below(a, 6) == 0)
        s->curve.p[2] = s->curve.p[3];
}

/* All spans. The finest tolerances cannot be kept everywhere: then ten times that. */
static bool run(scene *s)
{
    loft_offset o;
    enum loft_status status;

    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 4; k++)
            s->c[i][k] = exact_of(s->curve.p[k].axis[i]);
    while ((status = loft_offset_init(&o, &s->curve, s->distance, s->tol)) == LOFT_ERR_RANGE)
        s->tol = 10 * s->tol;
    s->d = exact_of(s->distance);
    s->t = exact_of(s->tol);
    s->count = 0;
    if (status != LOFT_OK)
        return false;
    while (s->count < SPANS && loft_offset_next(&o, &s->span[s->count]))
        s->count++;
    CHECK(s->count < SPANS);
    return true;
}

static long double slope(const scene *s, int i, unsigned k, long double t) { return exact_deriv(s->c[i], 3, k, t); }

/* The offset at t; false where there is no direction, or one that long double does not know well. */
static bool offset_at(const scene *s, long double t, long double out[LOFT_AXES])
{
    long double x = slope(s, 0, 1, t), y = slope(s, 1, 1, t);
    long double size = 0;

    for (int k = 0; k < 4; k++)
        size = fmaxl(size, fmaxl(fabsl(s->c[0][k] - s->c[0][0]), fabsl(s->c[1][k] - s->c[1][0])));
    for (unsigned k = 2; k <= 3 && hypotl(x, y) < size * 1e-10L; k++) {      /* at a coincident control point: the limit */
        const long double sign = t > 0.5L && k == 2 ? -1 : 1;
        x = sign * slope(s, 0, k, t);
        y = sign * slope(s, 1, k, t);
    }
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = exact_eval(s->c[i], 3, t);
    out[0] -= s->d * y / hypotl(x, y);
    out[1] += s->d * x / hypotl(x, y);
    return hypotl(x, y) > 0;
}

/* 1 - curvature * distance: negative where the offset runs backwards */
static long double progress(const scene *s, long double t)
{
    const long double x = slope(s, 0, 1, t), y = slope(s, 1, 1, t);
    return 1 - s->d * (x * slope(s, 1, 2, t) - y * slope(s, 0, 2, t)) / powl(hypotl(x, y), 3);
}

static void check_span(const scene *s, const loft_offset_span *f)
{
    const long double from = exact_unit(f->from), to = exact_unit(f->to);

    for (int k = 0; k <= 16; k++) {
        long double want[LOFT_AXES], off = 0, piece[4];
        const long double t = from + (to - from) * k / 16;
        if (!offset_at(s, t, want))
            continue;
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int j = 0; j < 4; j++)
                piece[j] = exact_of(f->curve.p[j].axis[i]);
            off += powl(exact_eval(piece, 3, k / 16.0L) - want[i], 2);
        }
        CHECK(sqrtl(off) <= s->t);
    }
}

static int spans, backwards, cusps;

static void spans_are_within_the_tolerance(arb *a)
{
    static scene s;
    const int32_t limits[3] = { 3, 100, 9000 };

    arb_scene(a, &s, limits[arb_below(a, 3)]);
    if (!run(&s))
        return;
    for (unsigned k = 0; k < s.count; k++)
        check_span(&s, &s.span[k]);
    spans += (int)s.count;
}

/* End to end, in parameters and bit for bit in points. */
static void spans_follow_each_other(arb *a)
{
    static scene s;
    long double left_out = 0;

    arb_scene(a, &s, 100);
    if (!run(&s))
        return;
    for (unsigned k = 0; k < s.count; k++) {
        const long double gap = exact_unit(s.span[k].from) - (k ? exact_unit(s.span[k - 1].to) : 0);
        CHECK(exact_unit(s.span[k].to) > exact_unit(s.span[k].from));
        CHECK(s.span[k].apart ? gap > 0 : !(fabsl(gap) > 0));
        if (k && !s.span[k].apart)
            CHECK(loft_vec_equal(s.span[k].curve.p[0], s.span[k - 1].curve.p[3]));
        left_out += gap;
    }
    CHECK(s.count && left_out <= 0x1p-18L);
    CHECK(left_out > 0 || exact_unit(s.span[s.count - 1].to) >= 1);
}

/* At the quarters of each span the offset runs as the span says. */
static void behind_is_where_the_radius_is_smaller(arb *a)
{
    static scene s;

    arb_scene(a, &s, 100);
    if (!run(&s))
        return;
    for (unsigned k = 0; k < s.count; k++) {
        const long double from = exact_unit(s.span[k].from), to = exact_unit(s.span[k].to);
        for (int j = 1; j <= 3; j++) {
            const long double t = from + (to - from) * j / 4, g = progress(&s, t);
            const long double way = g * hypotl(slope(&s, 0, 1, t), slope(&s, 1, 1, t)) * (to - from);
            CHECK(fabsl(g) < 0.01L || fabsl(way) <= 3 * s.t || (g < 0) == s.span[k].behind);
        }
        backwards += s.span[k].behind;
        if (k && s.span[k].behind != s.span[k - 1].behind && !s.span[k].apart) {    /* between them is a cusp */
            const long double pace = hypotl(slope(&s, 0, 1, from), slope(&s, 1, 1, from)) * fmaxl(to - from, from - exact_unit(s.span[k-1].from));
            const long double before = progress(&s, from - 0x1p-23L), after = progress(&s, from + 0x1p-23L);
            CHECK((before < 0) != (after < 0) || fminl(fabsl(before), fabsl(after)) * pace <= 3 * s.t);
            cusps++;
        }
    }
}

/* The ends of a span have the direction of the given curve there. */
static void ends_are_parallel(arb *a)
{
    static scene s;

    arb_scene(a, &s, 100);
    if (!run(&s))
        return;
    for (unsigned k = 0; k < s.count; k++) {
        const long double t = exact_unit(s.span[k].from), x = slope(&s, 0, 1, t), y = slope(&s, 1, 1, t);
        const long double u = exact_of(s.span[k].curve.p[1].axis[0]) - exact_of(s.span[k].curve.p[0].axis[0]);
        const long double v = exact_of(s.span[k].curve.p[1].axis[1]) - exact_of(s.span[k].curve.p[0].axis[1]);
        if (hypotl(x, y) > 0.01L)
            CHECK(fabsl(x * v - y * u) / hypotl(x, y) <= 1.5L * ulp(s.t + 256) + fabsl(s.d) * 0x1p-22L);
    }
}

/* A quarter of a circle: few spans, and one more radius. */
static void an_arc_takes_few_spans(arb *a)
{
    static scene s;
    const double radius = 10 + arb_below(a, 90), inner = 0.5522847498307936 * radius, x[4] = { radius, radius, inner, 0 };

    s.curve = (loft_cubic) { { { { 0 } } } };
    for (int k = 0; k < 4; k++) {
        s.curve.p[k].axis[0] = loft_real_from_raw((int32_t)(65536 * x[k]));
        s.curve.p[k].axis[1] = loft_real_from_raw((int32_t)(65536 * x[3 - k]));
    }
    s.distance = -loft_real_from_int(1 + (int32_t)arb_below(a, 50));
    s.tol = (loft_real)(-s.distance / 10000);
    CHECK(run(&s));
    CHECK(s.count <= 8);
    for (unsigned k = 0; k < s.count; k++) {
        const loft_vec p = s.span[k].curve.p[3];
        check_span(&s, &s.span[k]);
        CHECK(!s.span[k].behind && !s.span[k].apart);
        CHECK_NEAR(hypotl(exact_of(p.axis[0]), exact_of(p.axis[1])), (double)(radius - s.d), radius * 0.0004 + (double)s.t);
    }
}

/* Straight lines, also those drawn with coincident control points, are one span. */
static void a_line_is_one_span(arb *a)
{
    static scene s;
    const loft_vec from = arb_vec(a, 100), to = arb_vec(a, 100);
    const uint32_t kind = arb_below(a, 3);

    s.curve.p[0] = from;
    s.curve.p[1] = kind ? from : loft_vec_lerp(from, to, LOFT_UNIT(1.0 / 3));
    s.curve.p[2] = kind == 1 ? to : loft_vec_lerp(from, to, LOFT_UNIT(2.0 / 3));
    s.curve.p[3] = to;
    s.distance = arb_real(a, 20);
    s.tol = loft_real_from_raw(655);
    if (!run(&s) || fabsl(s.c[0][3] - s.c[0][0]) + fabsl(s.c[1][3] - s.c[1][0]) < 1)
        return;
    CHECK(s.count == 1 && !s.span[0].behind && !s.span[0].apart);
    check_span(&s, &s.span[0]);
}

/* Where the curve has a cusp its offset is in two parts. */
static void a_cusp_sets_spans_apart(arb *a)
{
    static scene s;
    const loft_real w = loft_real_from_int(1 + (int32_t)arb_below(a, 50)), h = loft_real_from_int(1 + (int32_t)arb_below(a, 50));
    unsigned apart = 0;

    s.curve = (loft_cubic) { { { { 0 } } } };
    s.curve.p[0].axis[0] = s.curve.p[2].axis[0] = -w;       /* -w w -w w, 0 h h 0: a cusp at 1/2 */
    s.curve.p[1].axis[0] = s.curve.p[3].axis[0] = w;
    s.curve.p[1].axis[1] = s.curve.p[2].axis[1] = h;
    s.curve.p[0].axis[0] = -w; s.curve.p[1].axis[0] = w; s.curve.p[2].axis[0] = -w; s.curve.p[3].axis[0] = w;
    s.distance = loft_real_from_int(5);
    s.tol = loft_real_from_raw(655);
    CHECK(run(&s));
    for (unsigned k = 0; k < s.count; k++) {
        check_span(&s, &s.span[k]);
        apart += s.span[k].apart;
        if (s.span[k].apart)
            CHECK_EXACT(exact_unit(s.span[k].from), 0.5L, 0x1p-18L);
    }
    CHECK(apart == 1);
}

static void refuses_what_has_no_offset(arb *a)
{
    static scene s;
    loft_offset o;

    arb_scene(a, &s, 100);
    CHECK(loft_offset_init(&o, &s.curve, s.distance, 0) == LOFT_ERR_ARG);
    CHECK(loft_offset_init(&o, &s.curve, loft_real_from_int(50), loft_real_from_raw(2)) == BY_NUM(LOFT_ERR_RANGE, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    for (int k = 1; k < 4; k++)
        s.curve.p[k] = s.curve.p[0];
    CHECK(loft_offset_init(&o, &s.curve, s.distance, loft_real_from_int(1)) == LOFT_SINGULAR);
    s.curve.p[3].axis[0] = loft_real_from_int(32000);
    CHECK(loft_offset_init(&o, &s.curve, loft_real_from_int(400), loft_real_from_int(1)) == BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
#if LOFT_NUM != LOFT_Q16
    s.curve.p[3].axis[0] = (loft_real)NAN;
    CHECK(loft_offset_init(&o, &s.curve, 1, 1) == LOFT_ERR_RANGE);
#endif
}

/* The properties above met spans that run backwards, and cusps. */
static void met_enough(arb *a)
{
    (void)a;
    CHECK(check_sampled() || (spans > 1000 && backwards > 100 && cusps > 100));
}

/* Beside a line there is nothing. */
static void one_axis_is_refused(arb *a)
{
    const loft_cubic c = arb_cubic(a, 100);
    loft_offset o;

    CHECK(loft_offset_init(&o, &c, LOFT_REAL(1), LOFT_REAL(0.5)) == (LOFT_AXES < 2 ? LOFT_ERR_ARG : LOFT_OK));
}

int main(void)
{
    PROPERTY(one_axis_is_refused,                    20);
    if (LOFT_AXES < 2)
        return check_failures();
    PROPERTY(spans_are_within_the_tolerance,        400);
    PROPERTY(spans_follow_each_other,               400);
    PROPERTY(behind_is_where_the_radius_is_smaller, 400);
    PROPERTY(ends_are_parallel,                     200);
    PROPERTY(an_arc_takes_few_spans,                100);
    PROPERTY(a_line_is_one_span,                    200);
    PROPERTY(a_cusp_sets_spans_apart,               100);
    PROPERTY(refuses_what_has_no_offset,             20);
    PROPERTY(met_enough,                              1);
    return check_failures();
}
