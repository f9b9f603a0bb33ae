/* tests/lib/curve/test_cubics_use.c -- chords, lengths and plans of curves of any degree, through
 * lib/curve/to_cubics.h
 * SPDX-License-Identifier: MIT
 */
#include "support/rationals.h"  /* sample, measure, exact_deriv */
#include "curve/to_cubics.h"
#include "curve/measure.h"      /* loft_flatten, loft_cubic_arclen */
#include "motion/plan.h"        /* loft_plan */

#define MOVES 4000
#define LOOKS 3000

typedef struct {
    long double x[LOFT_AXES];
} place;

static sample curved;
static loft_move moves[MOVES];
static loft_move ring[8];
static loft_knot knots[160];
static unsigned count;

static place point_at(long double t)
{
    place p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.x[i] = rational_at(&curved, i, t, 1);
    return p;
}

static place place_of(loft_vec v)
{
    place p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.x[i] = exact_of(v.axis[i]);
    return p;
}

/* The distance of w from the segment a..b. */
static long double from_segment(place w, place a, place b)
{
    long double dot = 0, square = 0, sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        dot    += (w.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
        square += (b.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
    }
    const long double t = square > 0 ? fmaxl(0, fminl(1, dot / square)) : 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += powl(w.x[i] - a.x[i] - t * (b.x[i] - a.x[i]), 2);
    return sqrtl(sum);
}

/* Of degree 9 without weights, or of 2 to 9 with weights 1/16..16. */
static void arb_smooth(arb *a)
{
    const bool rational = arb_below(a, 2);

    curved.n = rational ? 2 + arb_below(a, 8) : 9;
    for (unsigned k = 0; k <= curved.n; k++) {
        const double w = rational ? (1 + arb_below(a, 256)) / 16.0 : 1;
        curved.p[k].w = LOFT_REAL(w);
        for (int i = 0; i < LOFT_AXES; i++)
            curved.p[k].p.axis[i] = arb_real(a, 40);
    }
    CHECK(loft_rational_init(&curved.r, curved.p, curved.n) == LOFT_OK);
    measure(&curved);
}

/* The chain within tol; a polynomial is cut as a polynomial. `ends` gets the ends of its cubics. */
static void cut(loft_real tol, long double ends[])
{
    loft_vec p[POINTS];
    loft_bezier b;
    loft_to_cubics s;

    count = 0;
    if (curved.n == 9 && !(curved.ratio > 1)) {
        for (unsigned k = 0; k <= 9; k++)
            p[k] = curved.p[k].p;
        CHECK(loft_bezier_init(&b, p, 9) == LOFT_OK && loft_to_cubics_init(&s, &b, tol) == LOFT_OK);
    } else {
        CHECK(loft_rational_to_cubics_init(&s, &curved.r, tol) == LOFT_OK);
    }
    while (count < MOVES && loft_to_cubics_next(&s, &moves[count].curve)) {
        moves[count].feed = LOFT_REAL(50);
        ends[count++] = s.more ? ldexpl((long double)s.piece.k, -s.piece.level) : 1;
    }
    CHECK(count < MOVES);
}

static void chords_are_within_the_sum_of_both_tolerances(arb *a)
{
    static long double ends[MOVES];
    const loft_real half = loft_real_from_raw(8 + (int32_t)arb_below(a, 3000));

    arb_smooth(a);
    cut(half, ends);
    for (unsigned c = 0; c < count && !check_bad; c++) {
        static loft_vec at[2000];
        const long double start = c ? ends[c - 1] : 0;
        loft_flatten f;
        unsigned chords = 0;
        at[0] = moves[c].curve.p[0];
        CHECK(loft_flatten_init(&f, &moves[c].curve, half) == LOFT_OK);
        while (chords < 1999 && loft_flatten_next(&f, &at[chords + 1]))
            chords++;
        for (int j = 0; j <= 12; j++) {
            const place w = point_at(start + (ends[c] - start) * j / 12);
            long double best = HUGE_VALL;
            for (unsigned k = 0; k < chords; k++)
                best = fminl(best, from_segment(w, place_of(at[k]), place_of(at[k + 1])));
            CHECK_EXACT(best, 0, 2 * exact_of(half));
        }
    }
}

/* Length and turning angle by 24000 steps: off by about 2^-29 of themselves. */
static void measured(long double *length, long double *turning)
{
    place before = point_at(0);
    long double last[LOFT_AXES] = { 0 }, last_size = 0;

    *length = *turning = 0;
    for (int j = 1; j <= 8 * LOOKS; j++) {
        const place p = point_at(j / (8.0L * LOOKS));
        long double d[LOFT_AXES], size = 0, dot = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            d[i] = p.x[i] - before.x[i];
            size += d[i] * d[i];
            dot += d[i] * last[i];
        }
        size = sqrtl(size);
        *length += size;
        if (last_size > 0 && size > 0)
            *turning += acosl(fmaxl(-1, fminl(1, dot / (size * last_size))));
        for (int i = 0; i < LOFT_AXES; i++)
            last[i] = d[i];
        last_size = size;
        before = p;
    }
}

static void lengths_differ_by_the_tolerance_times_the_turning(arb *a)
{
    static long double ends[MOVES];
    const loft_real tol = loft_real_from_raw(64 << arb_below(a, 10));
    long double want, turning, got = 0;

    arb_smooth(a);
    cut(tol, ends);
    for (unsigned c = 0; c < count; c++)
        got += exact_acc(loft_cubic_arclen(&moves[c].curve, LOFT_REAL(0.0001)));
    measured(&want, &turning);
    CHECK_EXACT(got, want, exact_of(tol) * turning + count * (0.0001L + 2 * LSB) + want * 1e-6L);
}

/* The next span of the plan of `moves`, of which *pushed have been pushed; false at the end. */
static bool next_span(loft_plan *plan, unsigned *pushed, loft_span *out)
{
    enum loft_plan_state state;

    do {
        while (*pushed < count && loft_plan_push(plan, &moves[*pushed]) == LOFT_OK)
            (*pushed)++;
        if (*pushed == count)
            loft_plan_end(plan);
        state = loft_plan_next(plan, out);
    } while (state == LOFT_PLAN_WAIT);
    return state == LOFT_PLAN_SPAN;
}

static void plans_stay_within_the_sum_of_both_tolerances(arb *a)
{
    static long double ends[MOVES];
    static place looks[LOOKS + 1];
    static loft_plan plan;
    const loft_real half = LOFT_REAL(0.01);
    loft_limits limits = { .corner = LOFT_REAL(0.01), .tol = half, .tick_hz = 1000 };
    loft_span span;
    place last = { { 0 } };
    unsigned pushed = 0;

    arb_smooth(a);
    cut(half, ends);
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = LOFT_REAL(200);
        limits.max_accel[i] = LOFT_REAL(2000);
    }
    for (int j = 0; j <= LOOKS; j++)
        looks[j] = point_at(j / (long double)LOOKS);
    CHECK(loft_plan_init(&plan, &limits, ring, 8, knots, 160) == LOFT_OK);
    for (int j = 0; !check_bad && next_span(&plan, &pushed, &span); ) {
        place w;
        long double best = HUGE_VALL;
        for (int i = 0; i < LOFT_AXES; i++)
            w.x[i] = (exact_of(span.p[0].axis[i]) + 3 * exact_of(span.p[1].axis[i]) +
                      3 * exact_of(span.p[2].axis[i]) + exact_of(span.p[3].axis[i])) /
                     8;
        for (int i = j > 300 ? j - 300 : 0; i < LOOKS && i < j + 600; i++) {
            const long double d = from_segment(w, looks[i], looks[i + 1]);
            if (d < best) {
                best = d;
                j = i;
            }
        }
        /* chords of the samples: 0.002 of 40 */
        CHECK_EXACT(best, 0, 2 * exact_of(half) + 0.002L);
        last = place_of(span.p[3]);
    }
    CHECK_EXACT(from_segment(last, looks[LOOKS], looks[LOOKS]), 0, 2 * ulp(40));
}

int main(void)
{
    PROPERTY(chords_are_within_the_sum_of_both_tolerances, 60);
    PROPERTY_LONG(lengths_differ_by_the_tolerance_times_the_turning, 40);
    PROPERTY_LONG(plans_stay_within_the_sum_of_both_tolerances, 20);
    return check_failures();
}
