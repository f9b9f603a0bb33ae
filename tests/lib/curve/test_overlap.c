/* tests/lib/curve/test_overlap.c -- properties of lib/curve/overlap.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/overlap.h"
#include "support/exact.h"          /* exact_eval, CHECK_EXACT */

#define POINTS (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_vec p[POINTS];
    loft_bezier b;
} curve;

static void init(curve *c, unsigned degree)
{
    CHECK(loft_bezier_init(&c->b, c->p, degree) == LOFT_OK);
}

static void arb_curve(arb *a, curve *c, unsigned degree)
{
    for (unsigned k = 0; k <= degree; k++)
        c->p[k] = arb_vec(a, 500);
    init(c, degree);
}

static long double apart(const curve *p, long double s, const curve *q, long double t)
{
    long double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        long double x[POINTS], y[POINTS];
        for (unsigned k = 0; k <= p->b.degree; k++)
            x[k] = exact_of(p->p[k].axis[i]);
        for (unsigned k = 0; k <= q->b.degree; k++)
            y[k] = exact_of(q->p[k].axis[i]);
        sum += powl(exact_eval(x, p->b.degree, s) - exact_eval(y, q->b.degree, t), 2);
    }
    return sqrtl(sum);
}

static long double size_of(const curve *c)
{
    const loft_box box = loft_bezier_box(&c->b);
    long double most = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        most = fmaxl(most, exact_of(box.max.axis[i]) - exact_of(box.min.axis[i]));
    return most;
}

static void check_overlap(const curve *p, const curve *q, const loft_overlap *o, long double tol)
{
    CHECK(o->s_from < o->s_to && o->s_from >= 0 && exact_unit(o->s_to) <= 1);
    CHECK_EXACT(exact_acc(o->distance), apart(p, exact_unit(o->s_from), q, exact_unit(o->t_from)),
                tol / 64);
    for (int j = 0; j <= 16; j++) {
        const long double x = j / 16.0L, s = exact_unit(o->s_from) +
                                             x * (exact_unit(o->s_to) - exact_unit(o->s_from));
        CHECK(apart(p, s, q,
                    exact_unit(o->t_from) + x * (exact_unit(o->t_to) - exact_unit(o->t_from))) <=
              tol * 0.9L);
    }
}

/* Of any degree, elevated or not, forwards and backwards; in q16 a piece is rounded to half an
 * LSB. */
static void a_piece_of_a_curve_is_found(arb *a)
{
    const uint32_t first = arb_below(a, 700), last = first + 100 + arb_below(a, 900 - first);
    const loft_unit from = loft_unit_of(first, 1000), to = loft_unit_of(last, 1000);
    const unsigned degree = 1 + arb_below(a, 5), times = arb_below(a, 3);
    const bool along = arb_below(a, 2), second = arb_below(a, 2);
    const loft_real tol = loft_real_from_raw(655);
    loft_overlap o;
    curve p, q;

    arb_curve(a, &p, degree);
    CHECK(loft_bezier_sub(&p.b, along ? from : to, along ? to : from, q.p) == LOFT_OK);
    init(&q, degree);
    if (size_of(&q) < 1)
        return;
    CHECK(loft_bezier_elevate(&q.b, times, q.p) == LOFT_OK);
    init(&q, degree + times);
    const bool found = second ? loft_bezier_overlap(&q.b, &p.b, tol, &o)
                              : loft_bezier_overlap(&p.b, &q.b, tol, &o);
    CHECK(found);
    if (found) {
        check_overlap(second ? &q : &p, second ? &p : &q, &o, exact_of(tol));
        CHECK((o.t_from < o.t_to) == along);
    }
}

static void curves_that_go_on_from_each_other_overlap(arb *a)
{
    const loft_unit third = loft_unit_of(1 + arb_below(a, 300), 1000),
                    half = loft_unit_of(500 + arb_below(a, 300), 1000);
    const loft_real tol = loft_real_from_raw(655);
    loft_overlap o;
    curve p, q, whole;

    arb_curve(a, &whole, 3);
    CHECK(loft_bezier_sub(&whole.b, 0, half, p.p) == LOFT_OK &&
          loft_bezier_sub(&whole.b, third, LOFT_UNIT(1), q.p) == LOFT_OK);
    init(&p, 3);
    init(&q, 3);
    if (size_of(&p) < 100 || size_of(&q) < 100)
        return;
    const bool found = loft_bezier_overlap(&p.b, &q.b, tol, &o);
    CHECK(found);
    if (found) {
        check_overlap(&p, &q, &o, exact_of(tol));
        /* more than the stretch */
        CHECK(!loft_overlap_covers(&o, &p.b, 0, LOFT_UNIT(1), 0, LOFT_UNIT(1)));
    }
}

static int covered, asked;

/* If a pair of pieces is covered, points of it that meet are a few tol apart on the curve: none is
 * a separate crossing. */
static void what_is_covered_has_no_crossing_of_its_own(arb *a)
{
    const loft_real tol = loft_real_from_raw(65);
    const uint32_t n = 16u << arb_below(a, 4), i = arb_below(a, n),
                   j = arb_below(a, 4) ? i : arb_below(a, n);
    loft_overlap o;
    curve p;

    arb_curve(a, &p, 1 + arb_below(a, 4));
    if (size_of(&p) < 10 || !loft_bezier_overlap(&p.b, &p.b, tol, &o))
        return;
    const bool back = o.t_to < o.t_from;                /* a closed curve has more than one way */
    asked++;
    if (back || !loft_overlap_covers(&o, &p.b, loft_unit_of(i, n), loft_unit_of(i + 1, n),
                                     loft_unit_of(j, n), loft_unit_of(j + 1, n)))
        return;
    covered++;
    for (int k = 0; k <= 8; k++)
        for (int m = 0; m <= 8; m++) {
            const long double s = (i + k / 8.0L) / n, t = (j + m / 8.0L) / n, middle = (s + t) / 2;
            const long double chord = apart(&p, s, &p, t);
            CHECK(apart(&p, s, &p, middle) <= 2 * chord + 1e-3L &&
                  apart(&p, middle, &p, t) <= 2 * chord + 1e-3L);
        }
}

static void other_curves_share_nothing(arb *a)
{
    loft_overlap o = { .distance = BY_NUM(77, 77, 77) };
    curve p, q;

    arb_curve(a, &p, 1 + arb_below(a, 5));
    arb_curve(a, &q, 1 + arb_below(a, 5));
    if (arb_below(a, 2)) {
        q.p[0] = p.p[p.b.degree];
        q.p[q.b.degree] = p.p[0];
    }
    if (size_of(&p) < 10 || size_of(&q) < 10 || (p.b.degree == 1 && q.b.degree == 1))
        return;
    if (loft_bezier_overlap(&p.b, &q.b, loft_real_from_raw(65), &o))
        check_overlap(&p, &q, &o, 65 * LSB);
    else
        CHECK(!(o.distance > 77) && !(o.distance < 77));
}

static void enough_was_covered(arb *a)
{
    (void)a;
    CHECK(check_sampled() || (covered > asked / 3 && asked > 100));
}

int main(void)
{
    PROPERTY(other_curves_share_nothing,                    200);
    if (LOFT_AXES < 2)                  /* where any two curves overlap           */
        return check_failures();
    PROPERTY(a_piece_of_a_curve_is_found,                   400);
    PROPERTY(curves_that_go_on_from_each_other_overlap,     200);
    PROPERTY(what_is_covered_has_no_crossing_of_its_own,    300);
    PROPERTY(enough_was_covered,                              1);
    return check_failures();
}
