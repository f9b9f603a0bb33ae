/* lib/curve/to_cubics.c
 * SPDX-License-Identifier: MIT
 *
 * A piece of the curve has the numerator N = sum B_i x_i, x_i = w_i p_i, and the denominator W =
 * sum B_i w_i, both of degree n. A cubic C has the control points c_0..c_3, *rounded* as they are
 * returned. Then
 *
 *     P - C = (N - W C) / W      N - W C = sum_k B_k^(n+3) e_k / C(n+3,k)
 *     e_k = sum_i C(n,i) C(3,k-i) (x_i - w_i c_(k-i))
 *
 * The B_k are nonnegative and sum to 1, also for W. Everywhere on the piece therefore
 *
 *     |P - C| <= max_k |e_k| / C(n+3,k) / min_i w_i                       (1)
 *
 * A piece is accepted if (1) is within tol minus the error of its computation, otherwise halved.
 * Rounding of the control points is included in (1), so no margin is needed for it.
 *
 * C has the end points of the piece and its derivatives there: P' = n (x_1 - x_0 w_1 / w_0) / w_0
 * at the start.
 *
 * Termination. Let S be half the diagonal of the box of the control points, R = max w / min w, g =
 * 2 n, and N relative to the middle of the box. Over the whole curve |W^(j)| / W <= R/2 g^j and
 * |N^(j)| / W <= S R g^j. From P^(m) W = N^(m) - sum C(m,j) W^(j) P^(m-j), starting with |P| <= S,
 * it follows that
 *
 *     |P'| <= 3/2 S R g    ..    |P''''| <= S g^4 (3/2 R + 21/2 R^2 + 27/2 R^3 + 9/2 R^4)
 *                                        <= 30 S (g R)^4
 *
 * and 4.51 S (g R)^4 for R = 2^16. The piece of length h and its C differ by D, with D = D' = 0 at
 * both ends. With d = h^4 max |P''''| therefore |D''| <= d/12, |D'''| <= d/2, |D''''| = d. The
 * control values of W D / W(0) are below the sum of its Taylor coefficients: d (1/24 + 1/12 + 1/24)
 * plus terms smaller by a factor h g R. For n = 9, R = 2^16 and h = 2^-31 that is below 2^-43.4 S:
 * less than 2^-11 LSB in q16, and less than 2^-42 of the largest coordinate with six axes, an
 * eighth of the smallest tolerance of f64. The rest of (1) is rounding, which the smallest
 * tolerances cover:
 *
 * Rounding. The scale: 2^13 <= s max w < 2^14, x has the size of s w p, and w the factor
 * LOFT_PROJECT, as in num/acc128.h: |x|, w' < 2^29, exact in q16. Each halving rounds n times by
 * 2^-33, which is 1/2 of the ulp u (in floats u is 2^-52 of the largest possible |x|, s w reach).
 * After m halvings x and w' c are together off by n m u. (1) is computed in units of 2^11: |x - w'
 * c| < 2^30 is truncated to 2^19, and times the sum 924 of the binomials it is below 2^29, the
 * range of loft_acc_hypot. So the error of e_k / C is 1/2 unit + (n m + 16) / 2^11 units of u per
 * axis, sqrt(axes) times that for the vector, and that of the limit is 1/2. In LSB, with min s w >=
 * 2^13 / R, a unit is R 2^-18: 1/4 for R = 2^16. For that R the ends and arms are rounded by 1/2
 * LSB and 0.2 LSB (2 n^2 m u R / 3 2^-13), sqrt(6) times that is 1.7. With a margin of 6 + 1.1
 * units and an error of 1.6 the sum is below 4 LSB, the smallest tolerance. For R = 1 it is sqrt(6)
 * / 2 LSB and hardly more, of 2. In f64 the margin in ulp is 2^-40.8 of the largest coordinate and
 * the arms are off by 2^-41.2 of it: with the above less than 2^-39. */
#include "curve/to_cubics.h"
#include "num/acc128.h"   /* LOFT_PROJECT, loft_acc_project, loft_acc_weigh */
#include "num/muldiv.h"   /* loft_acc_muldiv, loft_acc_down */

#define LEVELS_MAX 31                   /* no piece is halved further: proof above   */
#define UNIT       11                   /* (1) in units of 2^11                      */
#define ONE        LOFT_REAL(8192)      /* the weight of a polynomial's points       */
#define ROOT       ((LOFT_AXES + 2) / 2)    /* an upper bound of sqrt(LOFT_AXES)     */


static loft_vec control_point(const loft_to_cubics *s, unsigned k)
{
    return s->weighted ? s->weighted[k].p : s->p[k];
}


/* Pieces */

static void load_curve(loft_to_cubics *s)
{
    for (unsigned k = 0; k <= s->degree; k++) {
        const loft_real w = s->weighted ? s->weighted[k].w * (loft_real)s->scale : ONE;
        for (int i = 0; i < LOFT_AXES; i++)
            s->x[i][k] = loft_prod(control_point(s, k).axis[i], w);
        s->x[LOFT_AXES][k] = loft_to_acc(w) * LOFT_PROJECT;
    }
}

/* de Casteljau at 1/2, in place. */
static void halve_axis(loft_acc c[], unsigned degree, bool right)
{
    for (unsigned row = degree; row > 0; row--)
        for (unsigned i = 0; i < row; i++)
            if (right)
                c[i] = loft_acc_mean(c[i], c[i + 1]);
            else
                c[degree - i] = loft_acc_mean(c[degree - i], c[degree - i - 1]);
}

static void halve_piece(loft_to_cubics *s, bool right)
{
    for (int i = 0; i < LOFT_AXES + (s->weighted != NULL); i++)
        halve_axis(s->x[i], s->degree, right);
}

static void find_piece(loft_to_cubics *s)
{
    load_curve(s);
    for (unsigned level = s->piece.level; level-- > 0; )
        halve_piece(s, s->piece.k >> level & 1);
}


/* A trial cubic */

/* One coordinate of the end of an arm: (x0 + n/3 (x1 - x0 w1 / w0)) / w0. It is clamped if it
 * leaves the range only by rounding; the result is false if it is farther outside. q16: |n third|
 * <= 2^30. */
static bool arm_end(const loft_to_cubics *s, loft_acc x0, loft_acc w0, loft_acc x1, loft_acc w1,
                    loft_real *out)
{
    const loft_acc high = loft_acc_weigh(w0, s->reach),
                   low = loft_acc_weigh(w0, -s->reach - LOFT_REAL_LSB);
    const loft_acc third = loft_acc_ratio(x1 - loft_acc_muldiv(x0, w1, w0), 3),
                   rounding = loft_acc_ratio(high, (int32_t)1 << 30);
    const int32_t n = s->degree;

    *out = 0;
    if (n && loft_acc_abs(third) > loft_acc_ratio(2 * high, n))
        return false;
    const loft_acc x = x0 + n * third;
    if (x - rounding > high || x + rounding < low)
        return false;
    *out = loft_acc_project(x > high ? high : x < low ? low : x, w0);
    return true;
}

static bool aim_arms(const loft_to_cubics *s, loft_cubic *c)
{
    const unsigned n = s->degree, near = n > 0;
    const loft_acc *w = s->x[LOFT_AXES];
    const bool last = s->piece.k + 1 == (uint32_t)1 << s->piece.level;
    bool near_enough = true;

    c->p[0] = s->last;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc *x = s->x[i];
        near_enough &= arm_end(s, x[0], w[0], x[near], w[near], &c->p[1].axis[i]);
        near_enough &= arm_end(s, x[n], w[n], x[n - near], w[n - near], &c->p[2].axis[i]);
        c->p[3].axis[i] = last ? control_point(s, n).axis[i] : loft_acc_project(x[n], w[n]);
    }
    return near_enough;
}

/* The bound for (1): the tolerance minus the computation's own error, in units. */
static loft_acc error_limit(const loft_to_cubics *s)
{
    const loft_acc *w = s->x[LOFT_AXES];
    loft_acc least = w[0], most = w[0];

    for (unsigned k = 1; k <= s->degree; k++) {
        least = w[k] < least ? w[k] : least;
        most  = w[k] > most ? w[k] : most;
    }
    const loft_acc size = loft_acc_weigh(most, s->reach);
    const int32_t ulps = ROOT * ((int32_t)s->degree * s->piece.level + 16);
    return loft_acc_down(loft_acc_weigh(least, s->tol), UNIT) -
           loft_acc_down(ulps * loft_acc_ulp(size), UNIT) -
           (ROOT + 2) * loft_acc_ulp(loft_acc_down(size, UNIT));
}

static bool is_cubic_close(const loft_to_cubics *s, const loft_cubic *c)
{
    const unsigned n = s->degree;
    const loft_acc limit = error_limit(s);

    for (unsigned k = 0; k <= n + 3; k++) {
        loft_acc e[LOFT_AXES] = { 0 };
        for (unsigned i = k > 3 ? k - 3 : 0; i <= n && i <= k; i++) {
            const int32_t share = loft_binomial(n, i) * loft_binomial(3, k - i);
            for (int a = 0; a < LOFT_AXES; a++)
                e[a] += share * loft_acc_down(s->x[a][i] - loft_acc_weigh(s->x[LOFT_AXES][i],
                                                                          c->p[k - i].axis[a]),
                                              UNIT);
        }
        const loft_acc off = loft_acc_hypot(e, LOFT_AXES);
        if (off + loft_hypot_ulp(off) > loft_binomial(n + 3, k) * limit)
            return false;
    }
    return true;
}

static bool is_cubic(const loft_to_cubics *s) { return s->degree == 3 && !s->weighted; }

bool loft_to_cubics_next(loft_to_cubics *s, loft_cubic *out)
{
    loft_cubic c;

    if (!s->more)
        return false;
    if (is_cubic(s)) {
        for (unsigned k = 0; k < 4; k++)
            out->p[k] = s->p[k];
        s->more = false;
        return true;
    }
    find_piece(s);
    while (!(aim_arms(s, &c) && is_cubic_close(s, &c)) && s->piece.level < LEVELS_MAX) {
        s->piece = loft_dyad_half(s->piece, 0);
        halve_piece(s, false);
    }
    s->last = c.p[3];
    s->more = loft_dyad_next(&s->piece);
    *out = c;
    return true;
}

loft_unit loft_to_cubics_at(const loft_to_cubics *s)
{
    return s->more ? loft_dyad_from(s->piece) : LOFT_UNIT(1);
}


/* Initialisation */

static enum loft_status begin_chain(loft_to_cubics *s, int32_t ulps)
{
    loft_real size = 0;

    if (!(s->tol > 0))
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= s->degree; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_real x = control_point(s, k).axis[i];
            if (!loft_real_valid(x))
                return LOFT_ERR_RANGE;
            if (x > size || x < -size)
                size = x > 0 ? x : x < -LOFT_REAL_MAX ? LOFT_REAL_MAX : -x;
        }
    const loft_acc tol = loft_to_acc(s->tol), wide = loft_to_acc(size);
    if (!loft_real_valid(s->tol) || tol < ulps * loft_real_ulp(wide) ||
        tol < 8192 * loft_acc_ulp(wide))
        return LOFT_ERR_RANGE;
    s->reach = size > LOFT_REAL_MAX / 2 ? LOFT_REAL_MAX : 2 * size;
    s->last  = control_point(s, 0);
    s->more  = true;
    s->piece.k = 0;
    s->piece.level = 0;
    return LOFT_OK;
}

enum loft_status loft_to_cubics_init(loft_to_cubics *s, const loft_bezier *b, loft_real tol)
{
    s->p        = b->p;
    s->weighted = NULL;
    s->degree   = b->degree;
    s->tol      = tol;
    s->scale    = 1;
    return begin_chain(s, 2);
}

/* The scale of a rational curve brings its largest weight to 2^14 .. 2^15. */
enum loft_status loft_rational_to_cubics_init(loft_to_cubics *s, const loft_rational *r,
                                              loft_real tol)
{
    s->p        = NULL;
    s->weighted = r->p;
    s->degree   = r->degree;
    s->tol      = tol;
    s->scale    = r->scale / 2;
    return begin_chain(s, 4);
}
