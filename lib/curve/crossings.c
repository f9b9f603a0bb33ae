/* lib/curve/crossings.c
 * SPDX-License-Identifier: MIT
 *
 * For a fixed t the polynomials x_a(s) - x_b(t) and y_a(s) - y_b(t) have a root in common if and
 * only if their resultant is 0. It is a polynomial of the degree m n in t, with whole coefficients:
 * its roots, with multiplicities, are exact (basis/whole_roots.h). Modulo a prime it is
 * interpolated at 0, 1, .., m n. The degrees m and n are the exact ones, so that not both leading
 * coefficients vanish. It is 0 everywhere if the curves are pieces of one.
 *
 * The other resultant gives all s. A pair belongs together if the points are equal, to the accuracy
 * of the parameters. If branches cross at an angle there, the multiplicity is 1; otherwise it is
 * at most that of either root, and the same as one of them unless both have a second partner.
 *
 * Bits, with R those of a coordinate: sum of |coefficients| of x_a(s) is below 2^R 3^m, that of
 * x_b(t) below 2^R 3^n, so of both below 2^(R + 1.6 max + 1). An entry of Bezout's matrix has 2 m
 * products, the determinant m! products of m entries:
 *
 *     m (2 R + 3.2 max + 3 + log2 m) + log2 m!  <=  4 (2 R + 17.8) + 4.6  <  8 (R + 12)
 *
 * A point against a curve: (x(t) - x)^2 + (y(t) - y)^2 has the common roots of both, and twice the
 * degree. */
#include "curve/crossings.h"
#include "basis/whole_roots.h"  /* loft_whole_roots */
#include "curve/intersect.h"    /* loft_bezier_intersect */
#include "curve/reduce.h"       /* loft_bezier_axis_degree */
#include "geom/vec_exact.h"     /* loft_vec_exact_valid */

#define MOST LOFT_MEETINGS_DEGREE

/* The resultant as a polynomial in the parameter of `kept`. */
typedef struct {
    const loft_bezier *gone, *kept;
    unsigned m, n;                              /* their exact degrees */
} pair;

/* The power form of one axis, up to the exact degree. */
static void power_form(const loft_residue *r, const loft_bezier *b, unsigned degree, int axis,
                       uint32_t out[MOST + 1])
{
    uint32_t d[MOST + 1];

    for (unsigned k = 0; k <= b->degree; k++)
        d[k] = loft_residue_real(r, loft_vec_axis(&b->p[k], axis));
    for (unsigned k = 0; k <= degree; k++) {
        out[k] = loft_residue_mul(r, d[0], (uint32_t)loft_binomial(b->degree, k));
        for (unsigned j = 0; j + k < b->degree; j++)
            d[j] = loft_residue_sub(r, d[j + 1], d[j]);
    }
}

static uint32_t power_at(const loft_residue *r, const uint32_t c[], unsigned degree, uint32_t t)
{
    uint32_t sum = 0;

    for (unsigned k = degree + 1; k-- > 0; )
        sum = loft_residue_add(r, loft_residue_mul(r, sum, t), c[k]);
    return sum;
}

/* The coefficients of the polynomial with the values y[0..n] at 0, 1, .., n; in place. */
static void interpolate(const loft_residue *r, uint32_t y[], unsigned n)
{
    for (unsigned k = 1; k <= n; k++) {                         /* divided differences */
        const uint32_t by = loft_residue_inverse(r, k);
        for (unsigned j = n; j >= k; j--)
            y[j] = loft_residue_mul(r, loft_residue_sub(r, y[j], y[j - 1]), by);
    }
    for (unsigned k = n; k-- > 0; )                             /* y_k + (t - k) (..) */
        for (unsigned j = k; j < n; j++)
            y[j] = loft_residue_sub(r, y[j], loft_residue_mul(r, y[j + 1], k));
}

static void resultant(const loft_whole_poly *w, const loft_residue *r, uint32_t c[])
{
    const pair *x = (const pair *)w->data;
    uint32_t matrix[MOST * MOST], kept[2][MOST + 1], constant[2];
    loft_residue_poly gone[2];

    for (int axis = 0; axis < 2; axis++) {
        gone[axis].degree = x->m;
        power_form(r, x->gone, x->m, axis, gone[axis].c);
        power_form(r, x->kept, x->n, axis, kept[axis]);
        constant[axis] = gone[axis].c[0];
    }
    for (unsigned t = 0; t <= w->degree; t++) {
        for (int axis = 0; axis < 2; axis++)
            gone[axis].c[0] = loft_residue_sub(r, constant[axis], power_at(r, kept[axis], x->n, t));
        loft_residue_bezout(r, gone[0].c, gone[1].c, x->m, matrix);
        c[t] = loft_residue_determinant(r, matrix, x->m);
    }
    interpolate(r, c, w->degree);
}

/* The square of the distance of `kept` from the point that `gone` is. */
static void distance_square(const loft_whole_poly *w, const loft_residue *r, uint32_t c[])
{
    const pair *x = (const pair *)w->data;
    uint32_t kept[MOST + 1];

    for (unsigned j = 0; j <= w->degree; j++)
        c[j] = 0;
    for (int axis = 0; axis < 2; axis++) {
        power_form(r, x->kept, x->n, axis, kept);
        kept[0] = loft_residue_sub(r, kept[0],
                                   loft_residue_real(r, loft_vec_axis(&x->gone->p[0], axis)));
        for (unsigned i = 0; i <= x->n; i++)
            for (unsigned j = 0; j <= x->n; j++)
                c[i + j] = loft_residue_add(r, c[i + j], loft_residue_mul(r, kept[i], kept[j]));
    }
}

static unsigned bits_of(const pair *x)
{
    const unsigned most = x->m > x->n ? x->m : x->n;
    return x->m * (2 * LOFT_RESIDUE_REAL + 4 * most + 5) + 5;
}

static enum loft_status roots_of(const pair *x, loft_whole_root out[], unsigned *count)
{
    const loft_whole_poly w = { x->m * x->n, bits_of(x), resultant, x };
    return loft_whole_roots(&w, out, count);
}

/* True if the point that one of them is lies on the other. */
static enum loft_status meet_at_point(const pair *x)
{
    const loft_whole_poly w = { 2 * x->n, 2 * (LOFT_RESIDUE_REAL + 2 * x->n + 3), distance_square,
                                x };
    loft_whole_root root[LOFT_RESIDUE_DEGREE];
    unsigned count;

    if (x->n == 0)
        return loft_vec_axis(&x->gone->p[0], 0) < loft_vec_axis(&x->kept->p[0], 0) ||
                       loft_vec_axis(&x->gone->p[0], 0) > loft_vec_axis(&x->kept->p[0], 0) ||
                       loft_vec_axis(&x->gone->p[0], 1) < loft_vec_axis(&x->kept->p[0], 1) ||
                       loft_vec_axis(&x->gone->p[0], 1) > loft_vec_axis(&x->kept->p[0], 1)
                   ? LOFT_OK
                   : LOFT_SINGULAR;
    const enum loft_status status = loft_whole_roots(&w, root, &count);
    return status == LOFT_OK && count > 0 ? LOFT_SINGULAR : status;
}


/* Pairs */

/* A point and its derivative, over the degree. */
typedef struct {
    loft_sci at[2], along[2];
} place;

static place place_at(const loft_bezier *b, loft_sci t)
{
    loft_sci c[MOST + 1];
    place x;

    for (int axis = 0; axis < 2; axis++) {
        for (unsigned k = 0; k <= b->degree; k++)
            c[k] = loft_sci_from_real(loft_vec_axis(&b->p[k], axis));
        for (unsigned left = b->degree; left > 1; left--)
            for (unsigned k = 0; k < left; k++)
                c[k] = loft_sci_lerp(c[k], c[k + 1], t);
        x.along[axis] = loft_sci_sub(c[1], c[0]);
        x.at[axis] = loft_sci_lerp(c[0], c[1], t);
    }
    return x;
}

/* The largest coordinate, or leg of a control polygon. */
static loft_sci size_of(const loft_bezier *b, loft_sci most)
{
    for (int axis = 0; axis < 2; axis++)
        for (unsigned k = 0; k <= b->degree; k++) {
            const loft_sci x = loft_sci_from_real(loft_vec_axis(&b->p[k], axis));
            const loft_sci before = k ? loft_sci_from_real(loft_vec_axis(&b->p[k - 1], axis)) : x;
            const loft_sci leg = loft_sci_abs(loft_sci_sub(x, before));
            if (loft_sci_less(most, loft_sci_abs(x)))
                most = loft_sci_abs(x);
            if (loft_sci_less(most, leg))
                most = leg;
        }
    return most;
}

static bool is_same_place(const place *x, const place *y, loft_sci gap)
{
    for (int axis = 0; axis < 2; axis++)
        if (loft_sci_less(gap, loft_sci_abs(loft_sci_sub(x->at[axis], y->at[axis]))))
            return false;
    return true;
}

/* True if the sine of the angle is above 2^-30. */
static bool is_at_angle(const place *x, const place *y)
{
    const loft_sci one = loft_sci_mul(x->along[0], y->along[1]),
                   two = loft_sci_mul(x->along[1], y->along[0]);
    loft_sci square[2];

    for (int k = 0; k < 2; k++) {
        const loft_sci *u = k ? y->along : x->along;
        square[k] = loft_sci_add(loft_sci_mul(u[0], u[0]), loft_sci_mul(u[1], u[1]));
    }
    const loft_sci cross = loft_sci_sub(one, two);
    return loft_sci_less(loft_sci_mul(loft_sci_mul(square[0], square[1]), loft_sci_power2(-60)),
                         loft_sci_mul(cross, cross));
}

static void match_roots(const loft_bezier *a, const loft_bezier *b, const loft_whole_root s[],
                        unsigned s_count, const loft_whole_root t[], unsigned t_count,
                        loft_meeting out[], unsigned *count)
{
    const loft_sci gap = loft_sci_mul(size_of(b, size_of(a, loft_sci_zero())),
                                      loft_sci_power2(-44));

    for (unsigned i = 0; i < s_count; i++) {
        const loft_sci at = loft_whole_root_at(&s[i]);
        const place x = place_at(a, at);
        for (unsigned j = 0; j < t_count && *count < LOFT_MEETINGS_MAX; j++) {
            const loft_sci to = loft_whole_root_at(&t[j]);
            const place y = place_at(b, to);
            if (!is_same_place(&x, &y, gap))
                continue;
            loft_meeting *m = &out[(*count)++];
            m->s = loft_sci_to_unit(at);
            m->t = loft_sci_to_unit(to);
            m->multiplicity = is_at_angle(&x, &y) ? 1
                              : s[i].multiplicity < t[j].multiplicity ? s[i].multiplicity
                                                                      : t[j].multiplicity;
        }
    }
}


/* Pieces of one curve */

/* The same curve in the first two coordinates. */
static loft_bezier flat_curve(const loft_bezier *b, loft_vec p[MOST + 1])
{
    loft_bezier flat = *b;

    for (unsigned k = 0; k <= b->degree; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            p[k].axis[axis] = axis < 2 ? b->p[k].axis[axis] : 0;
    flat.p = p;
    return flat;
}

/* Where ends are equal the parameters are exact. */
static void settle_ends(const loft_bezier *a, const loft_bezier *b, const loft_crossing *c,
                        loft_meeting *m)
{
    for (int from = 0; from < 2; from++)
        for (int to = 0; to < 2; to++) {
            const loft_unit s = from ? LOFT_UNIT(1) : 0, t = to ? LOFT_UNIT(1) : 0;
            if (!(c->s_from > s) && !(c->s_to < s) && !(c->t_from > t) && !(c->t_to < t) &&
                loft_vec_equal(a->p[from ? a->degree : 0], b->p[to ? b->degree : 0])) {
                m->s = s;
                m->t = t;
            }
        }
}

static enum loft_status meet_on_one_curve(const loft_bezier *a, const loft_bezier *b,
                                          loft_meeting out[], unsigned *count)
{
    loft_vec p[MOST + 1], q[MOST + 1];
    const loft_bezier x = flat_curve(a, p), y = flat_curve(b, q);
    loft_crossing c[LOFT_MEETINGS_MAX];
    size_t found = 0;
    loft_acc size = 0;

    if (!loft_sci_to_acc(size_of(&y, size_of(&x, loft_sci_zero())), &size))
        return LOFT_ERR_RANGE;
    const loft_acc last = 4 * loft_real_ulp(size), guard = 32768 * loft_acc_ulp(size);
    const loft_real tol = loft_acc_round(last > guard ? last : guard);
    const enum loft_status status = loft_bezier_intersect(&x, &y, tol, c, LOFT_MEETINGS_MAX,
                                                          &found);
    if (status != LOFT_OK)
        return status == LOFT_SINGULAR ? status : LOFT_ERR_RANGE;
    for (size_t k = 0; k < found; k++) {
        out[k] = (loft_meeting) { c[k].s, c[k].t, 0 };
        settle_ends(&x, &y, &c[k], &out[k]);
    }
    *count = (unsigned)found;
    return LOFT_OK;
}


static unsigned plane_degree(const loft_bezier *b)
{
    const unsigned x = loft_bezier_axis_degree(b, 0), y = loft_bezier_axis_degree(b, 1);
    return x > y ? x : y;
}

static bool is_valid(const loft_bezier *b) { return b->degree >= 1 && b->degree <= MOST; }

enum loft_status loft_bezier_crossings(const loft_bezier *a, const loft_bezier *b,
                                       loft_meeting out[], unsigned *count)
{
    loft_whole_root s[LOFT_RESIDUE_DEGREE], t[LOFT_RESIDUE_DEGREE];
    unsigned s_count, t_count;

    *count = 0;
    if (LOFT_AXES < 2 || !is_valid(a) || !is_valid(b))
        return LOFT_ERR_ARG;
    if (!loft_vec_exact_valid(a->p, a->degree + 1u, 2) ||
        !loft_vec_exact_valid(b->p, b->degree + 1u, 2))
        return LOFT_ERR_RANGE;
    const pair for_t = { a, b, plane_degree(a), plane_degree(b) };
    const pair for_s = { b, a, for_t.n, for_t.m };
    if (for_t.m == 0 || for_t.n == 0)
        return meet_at_point(for_t.m == 0 ? &for_t : &for_s);

    const enum loft_status status = roots_of(&for_t, t, &t_count);
    if (status == LOFT_SINGULAR)
        return meet_on_one_curve(a, b, out, count);
    const enum loft_status other = status == LOFT_OK ? roots_of(&for_s, s, &s_count) : status;
    if (other != LOFT_OK)
        return other == LOFT_SINGULAR ? LOFT_ERR_RANGE : other;
    match_roots(a, b, s, s_count, t, t_count, out, count);
    return LOFT_OK;
}
