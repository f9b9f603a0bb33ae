/* tests/lib/curve/test_offset.c -- properties of lib/curve/offset.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/offset.h"
#include "support/exact.h"          /* exact_eval, exact_deriv, CHECK_EXACT */

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

/* All spans. The finest tolerances are not possible everywhere: then ten times that. */
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

static long double slope(const scene *s, int i, unsigned k, long double t)
{
    return exact_deriv(s->c[i], 3, k, t);
}

/* The offset at t; false if there is no direction, or if long double does not give it
 * accurately. */
static bool offset_at(const scene *s, long double t, long double out[LOFT_AXES])
{
    long double x = slope(s, 0, 1, t), y = slope(s, 1, 1, t);
    long double size = 0;

    for (int k = 0; k < 4; k++)
        size = fmaxl(size, fmaxl(fabsl(s->c[0][k] - s->c[0][0]), fabsl(s->c[1][k] - s->c[1][0])));
    for (unsigned k = 2; k <= 3 && hypotl(x, y) < size * 1e-10L; k++) {
        /* at a coincident control point: the limit */
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

/* Is it the span of a stretch at an end that cannot be resolved? It keeps the distance and does not
 * move. */
static bool is_held(const scene *s, unsigned k)
{
    const loft_offset_span *f = &s->span[k];
    const long double from = exact_unit(f->from), to = exact_unit(f->to);
    long double far[2], most = 0;

    if (to - from > 0x1p-18L || (k > 0 && k + 1 < s->count))
        return false;
    for (int end = 0; end < 4; end += 3) {
        for (int i = 0; i < 2; i++)
            far[i] = exact_of(f->curve.p[end].axis[i]) - exact_eval(s->c[i], 3, end ? to : from);
        most = fmaxl(most, fabsl(hypotl(far[0], far[1]) - fabsl(s->d)));
    }
    return most <= s->t;
}

/* H, the derivative without its zeros at 0 and 1: its direction is always that of the curve.
 * Returns its length over the largest of its coefficients, which tells how accurate that direction
 * is in long double. */
static long double direction(const scene *s, long double t, long double at[2])
{
    long double most = 0, h[2][3];
    unsigned m = 2;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            h[i][k] = s->c[i][k + 1] - s->c[i][k];
    for (; m > 0 && hypotl(h[0][0], h[1][0]) <= 0; m--)
        for (unsigned j = 0; j < m; j++)
            for (int i = 0; i < 2; i++)
                h[i][j] = m * h[i][j + 1] / (j + 1);
    for (; m > 0 && hypotl(h[0][m], h[1][m]) <= 0; m--)
        for (unsigned j = 0; j < m; j++)
            for (int i = 0; i < 2; i++)
                h[i][j] = m * h[i][j] / (m - j);
    for (unsigned j = 0; j <= m; j++)
        most = fmaxl(most, hypotl(h[0][j], h[1][j]));
    for (int i = 0; i < 2; i++)
        at[i] = exact_eval(h[i], m, t);
    return hypotl(at[0], at[1]) / most;
}

/* Is the span wrong at its parameter u? Not tested where long double does not give the direction
 * accurately. */
static bool is_off(const scene *s, const loft_offset_span *f, long double u)
{
    const long double from = exact_unit(f->from), to = exact_unit(f->to),
                      t = from + (to - from) * u;
    long double h[2], piece[4], off = 0;

    if (direction(s, t, h) * s->t < 64 * 0x1p-63L * fabsl(s->d))
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double aside = i == 0 ? -h[1] : i == 1 ? h[0] : 0;
        for (int j = 0; j < 4; j++)
            piece[j] = exact_of(f->curve.p[j].axis[i]);
        off += powl(exact_eval(piece, 3, u) - exact_eval(s->c[i], 3, t) -
                        s->d * aside / hypotl(h[0], h[1]),
                    2);
    }
    return !(sqrtl(off) <= s->t * 1.02L);
}

/* From 0 to 1, end to end in parameters and bit for bit in points. Little is left out, and all else
 * is near. */
static void check_path(const scene *s)
{
    long double left_out = 0;

    CHECK(s->count && !(exact_unit(s->span[0].from) > 0) &&
          !(exact_unit(s->span[s->count - 1].to) < 1));
    for (unsigned k = 0; k < s->count; k++) {
        const loft_offset_span *f = &s->span[k];
        const long double from = exact_unit(f->from),
                          gap = from - (k ? exact_unit(s->span[k - 1].to) : 0);
        bool off = false;
        CHECK(exact_unit(f->to) > from);
        CHECK(f->apart ? gap > 0 : !(fabsl(gap) > 0));
        if (k && !f->apart)
            CHECK(loft_vec_equal(f->curve.p[0], s->span[k - 1].curve.p[3]));
        for (int j = 0; j < 2; j++)
            off = off || is_off(s, f, (j + 0.4L) / 2);
        CHECK(!off || is_held(s, k));
        left_out += gap + (off ? exact_unit(f->to) - from : 0);
    }
    CHECK(left_out <= 0x1p-18L);
}

static void spans_follow_each_other(arb *a)
{
    static scene s;

    arb_scene(a, &s, 100);
    if (run(&s))
        check_path(&s);
}

/* Cubics that stop or turn back: back and forth on a line, with a zero of the speed of either kind;
 * off the line by some of the last bits; and with control points that nearly coincide. */
static void arb_folded(arb *a, scene *s)
{
    const int32_t unit = (int32_t)1 << arb_below(a, 24), along = (int32_t)arb_below(a, 5) - 2,
                  up = (int32_t)arb_below(a, 5) - 2;
    const uint32_t kind = arb_below(a, 4);
    int32_t at[4];

    for (int k = 0; k < 4; k++)
        at[k] = (int32_t)arb_below(a, 17) - 8;
    if (kind == 1) {                    /* the speed is -(p t - q (1 - t))^2 */
        const int32_t p = 1 + (int32_t)arb_below(a, 3), q = 1 + (int32_t)arb_below(a, 3);
        at[0] = 1;
        at[1] = at[0] - q * q;
        at[2] = at[1] + p * q;
        at[3] = at[2] - p * p;
    }
    for (int k = 0; k < 4; k++) {
        const int32_t size = kind == 2 && arb_below(a, 2) ? 1 : unit,
                      off = kind == 0 ? 0 : (int32_t)arb_below(a, 3) - 1;
        const bool bent = arb_below(a, 3) == 0;
        s->curve.p[k] = arb_vec(a, 1);
        s->curve.p[k].axis[0] = loft_real_from_raw(at[k] * along * size + (bent ? off : 0));
        s->curve.p[k].axis[LOFT_AXES > 1] = loft_real_from_raw(at[k] * up * size -
                                                               (bent ? 0 : off));
        if (kind == 3 && arb_below(a, 3) == 0)
            s->curve.p[k] = arb_vec(a, 16000);
    }
    s->distance = arb_real(a, 1 + (int32_t)arb_below(a, 70));
    s->tol = loft_real_from_raw(4096 << arb_below(a, 5));
    if (arb_below(a, 8) == 0)           /* about the smallest tolerance that init accepts */
        s->tol = loft_real_from_raw(4 + loft_raw_from_real(loft_real_abs(s->distance)) / 131072 +
                                    1);
}

static int folded, left_apart, held;

static void folded_paths_leave_out_little(arb *a)
{
    static scene s;

    arb_folded(a, &s);
    if (!run(&s))
        return;
    check_path(&s);
    folded++;
    for (unsigned k = 0; k < s.count; k++) {
        left_apart += s.span[k].apart;
        held += !s.span[k].apart &&
                exact_unit(s.span[k].to) - exact_unit(s.span[k].from) < 0x1p-18L &&
                is_held(&s, k) && is_off(&s, &s.span[k], 0.4L);
    }
}

/* At the quarters of each span the offset runs in the reported direction. */
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
            const long double way = g * hypotl(slope(&s, 0, 1, t), slope(&s, 1, 1, t)) *
                                    (to - from);
            CHECK(fabsl(g) < 0.01L || fabsl(way) <= 3 * s.t || (g < 0) == s.span[k].behind);
        }
        backwards += s.span[k].behind;
        if (k && s.span[k].behind != s.span[k - 1].behind && !s.span[k].apart) {
            /* a cusp is between them */
            const long double pace = hypotl(slope(&s, 0, 1, from), slope(&s, 1, 1, from)) *
                                     fmaxl(to - from, from - exact_unit(s.span[k - 1].from));
            const long double before = progress(&s, from - 0x1p-23L),
                              after = progress(&s, from + 0x1p-23L);
            CHECK((before < 0) != (after < 0) ||
                  fminl(fabsl(before), fabsl(after)) * pace <= 3 * s.t);
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
        const long double t = exact_unit(s.span[k].from), x = slope(&s, 0, 1, t),
                          y = slope(&s, 1, 1, t);
        const long double u = exact_of(s.span[k].curve.p[1].axis[0]) -
                              exact_of(s.span[k].curve.p[0].axis[0]);
        const long double v = exact_of(s.span[k].curve.p[1].axis[1]) -
                              exact_of(s.span[k].curve.p[0].axis[1]);
        if (hypotl(x, y) > 0.01L)
            CHECK(fabsl(x * v - y * u) / hypotl(x, y) <=
                  1.5L * ulp(s.t + 256) + fabsl(s.d) * 0x1p-22L);
    }
}

/* A quarter of a circle: few spans, on the circle of the offset radius. */
static void an_arc_takes_few_spans(arb *a)
{
    static scene s;
    const double radius = 10 + arb_below(a, 90), inner = 0.5522847498307936 * radius,
                 x[4] = { radius, radius, inner, 0 };

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
        CHECK_NEAR(hypotl(exact_of(p.axis[0]), exact_of(p.axis[1])), (double)(radius - s.d),
                   radius * 0.0004 + (double)s.t);
    }
}

/* Straight lines, also with coincident control points, are one span. */
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

/* If the curve has a cusp, its offset has two parts. */
static void a_cusp_sets_spans_apart(arb *a)
{
    static scene s;
    const loft_real w = loft_real_from_int(1 + (int32_t)arb_below(a, 50)),
                    h = loft_real_from_int(1 + (int32_t)arb_below(a, 50));
    unsigned apart = 0;

    s.curve = (loft_cubic) { { { { 0 } } } };
    s.curve.p[0].axis[0] = s.curve.p[2].axis[0] = -w;       /* -w w -w w, 0 h h 0: a cusp at 1/2 */
    s.curve.p[1].axis[0] = s.curve.p[3].axis[0] = w;
    s.curve.p[1].axis[1] = s.curve.p[2].axis[1] = h;
    s.curve.p[0].axis[0] = -w;
    s.curve.p[1].axis[0] = w;
    s.curve.p[2].axis[0] = -w;
    s.curve.p[3].axis[0] = w;
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

/* A curve far smaller than the distance: its legs are short compared with their rounding errors,
 * which must not cause cusps. */
static void a_small_curve_takes_few_spans(arb *a)
{
    static scene s;
    const int32_t x[4] = { -16, -128, -1, 16 }, y[4] = { -8, -65, 0, 9 };

    s.curve = (loft_cubic) { { { { 0 } } } };
    for (int k = 0; k < 4; k++) {
        s.curve.p[k].axis[0] = loft_real_from_raw(x[k]);
        s.curve.p[k].axis[1] = loft_real_from_raw(y[k]);
    }
    s.distance = loft_real_from_int(60 + (int32_t)arb_below(a, 10));
    s.tol = loft_real_from_raw(4 + (int32_t)arb_below(a, 100));
    CHECK(run(&s) && s.count < 300);
}

static void refuses_what_has_no_offset(arb *a)
{
    static scene s;
    loft_offset o;

    arb_scene(a, &s, 100);
    CHECK(loft_offset_init(&o, &s.curve, s.distance, 0) == LOFT_ERR_ARG);
    CHECK(loft_offset_init(&o, &s.curve, loft_real_from_int(50), loft_real_from_raw(2)) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    for (int k = 1; k < 4; k++)
        s.curve.p[k] = s.curve.p[0];
    CHECK(loft_offset_init(&o, &s.curve, s.distance, loft_real_from_int(1)) == LOFT_SINGULAR);
    s.curve.p[3].axis[0] = loft_real_from_int(32000);
    CHECK(loft_offset_init(&o, &s.curve, loft_real_from_int(400), loft_real_from_int(1)) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
#if LOFT_NUM != LOFT_Q16
    s.curve.p[3].axis[0] = (loft_real)NAN;
    CHECK(loft_offset_init(&o, &s.curve, 1, 1) == LOFT_ERR_RANGE);
#endif
}

/* The properties above covered spans that run backwards, cusps, and ends that cannot be
 * resolved. */
static void met_enough(arb *a)
{
    (void)a;
    CHECK(check_sampled() ||
          (spans > 1000 && backwards > 100 && cusps > 100 && left_apart > 100 && held > 10));
}

/* With one axis there is no offset. */
static void one_axis_is_refused(arb *a)
{
    const loft_cubic c = arb_cubic(a, 100);
    loft_offset o;

    CHECK(loft_offset_init(&o, &c, LOFT_REAL(1), LOFT_REAL(0.5)) ==
          (LOFT_AXES < 2 ? LOFT_ERR_ARG : LOFT_OK));
}

/* LOFT_CASES=1000000 in the environment: that many folded ones, and nothing else (make
 * sweep-offset). */
int main(void)
{
    const char *cases = getenv("LOFT_CASES");

    if (cases) {
        PROPERTY(folded_paths_leave_out_little, (unsigned)strtoul(cases, NULL, 10));
        printf("%d folded cubics, %d spans apart, %d held at an end\n", folded, left_apart, held);
        return check_failures();
    }
    PROPERTY(one_axis_is_refused,                    20);
    if (LOFT_AXES < 2)
        return check_failures();
    PROPERTY(spans_are_within_the_tolerance,        400);
    PROPERTY(spans_follow_each_other,               400);
    PROPERTY(folded_paths_leave_out_little,        2000);
    PROPERTY(behind_is_where_the_radius_is_smaller, 400);
    PROPERTY(ends_are_parallel,                     200);
    PROPERTY(an_arc_takes_few_spans,                100);
    PROPERTY(a_line_is_one_span,                    200);
    PROPERTY(a_cusp_sets_spans_apart,               100);
    PROPERTY(a_small_curve_takes_few_spans,         100);
    PROPERTY(refuses_what_has_no_offset,             20);
    PROPERTY(met_enough,                              1);
    return check_failures();
}
