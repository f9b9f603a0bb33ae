/* lib/surface/area.c
 * SPDX-License-Identifier: MIT
 *
 * The area is the integral of |N|, N = P_u x P_v. N is a vector polynomial of degrees 2 m - 1 and
 * 2 n - 1 with the coefficients
 *
 *     N_kl = m n / (C(2m-1,k) C(2n-1,l))  sum over i + i' = k, j + j' = l
 *                 C(m-1,i) C(n,j) C(m,i') C(n-1,j')  (b_(i+1)j - b_ij) x (b_i'(j'+1) - b_i'j')
 *
 * Every Bernstein polynomial has the same integral, here 1 / (4 m n). Since |sum| <= integral |N|
 * <= sum of |..|,
 *
 *     |sum of N_kl| / (4 m n)  <=  area  <=  (sum of |N_kl|) / (4 m n)
 *
 * The mean of the two bounds is taken where they differ by at most 2 tol times the piece's share of
 * the parameter domain. So all pieces together err by at most tol. Elsewhere the piece is halved,
 * along u and v in turn. The difference falls with the square of the width, or with the area where
 * N is 0. The pieces are the leaves of a binary tree (basis/dyadic.h). Every other bit of k is the
 * side in u, the rest are the side in v.
 */
#include "surface/area.h"
#include "basis/dyadic.h"   /* loft_dyad */
#include "geom/vec_exact.h" /* loft_vec_exact_valid */
#include "num/sci.h"        /* loft_sci: areas of any size */

#define MOST ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))

typedef struct {
    loft_sci axis[3];
} spot;

/* A piece of the patch. Coordinates are relative to the first control point. */
typedef struct {
    spot c[MOST];
    unsigned m, n;
} patch;

typedef struct {
    loft_sci lower, upper;
} bounds;

static void load_patch(patch *x, const loft_net *s)
{
    loft_net_form form;

    loft_net_load(*s, s->p[0], &form);
    x->m = s->m;
    x->n = s->n;
    for (unsigned i = 0; i <= x->m; i++)
        for (unsigned j = 0; j <= x->n; j++)
            for (int axis = 0; axis < 3; axis++)
                x->c[i * (x->n + 1) + j].axis[axis] = axis < LOFT_AXES ? form.axis[axis].c[i][j]
                                                                       : loft_sci_zero();
}

/* One half of the curve c[0], c[stride] .. De Casteljau's algorithm leaves the left half at the
 * front and the right half at the back. */
static void halve_curve(spot c[], unsigned degree, unsigned stride, unsigned side)
{
    const loft_sci half = loft_sci_div(loft_sci_one(), loft_sci_from_int(2));

    for (unsigned row = 0; row < degree; row++)
        for (unsigned k = 0; k < degree - row; k++) {
            spot *to = &c[(side ? k : degree - k) * stride];
            const spot *other = side ? to + stride : to - stride;
            for (int i = 0; i < 3; i++)
                to->axis[i] = loft_sci_mul(half, loft_sci_add(to->axis[i], other->axis[i]));
        }
}

static void cut_patch(patch *x, loft_dyad piece)
{
    for (unsigned level = 0; level < piece.level; level++) {
        const unsigned side = piece.k >> (piece.level - 1u - level) & 1;
        if (level % 2 == 0)
            for (unsigned j = 0; j <= x->n; j++)
                halve_curve(x->c + j, x->m, x->n + 1, side);
        else
            for (unsigned i = 0; i <= x->m; i++)
                halve_curve(x->c + i * (x->n + 1), x->n, 1, side);
    }
}

static spot net_step(const spot *from, const spot *to)
{
    spot d;

    for (int i = 0; i < 3; i++)
        d.axis[i] = loft_sci_sub(to->axis[i], from->axis[i]);
    return d;
}

/* sum += weight a x b */
static void add_cross(spot *sum, int32_t weight, const spot *a, const spot *b)
{
    const loft_sci w = loft_sci_from_int(weight);

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const loft_sci d = loft_sci_sub(loft_sci_mul(a->axis[j], b->axis[k]),
                                        loft_sci_mul(a->axis[k], b->axis[j]));
        sum->axis[i] = loft_sci_add(sum->axis[i], loft_sci_mul(w, d));
    }
}

static unsigned sub_clamped(unsigned x, unsigned y)   { return x > y ? x - y : 0; }

/* N_kl C(2m-1,k) C(2n-1,l) / (m n). The product of the four binomials is at most 70 * 126 * 126 *
 * 70 < 2^27. */
static spot normal_coefficient(const patch *x, unsigned k, unsigned l)
{
    const unsigned m = x->m, n = x->n, w = n + 1;
    spot sum = { { loft_sci_zero(), loft_sci_zero(), loft_sci_zero() } };

    for (unsigned i = sub_clamped(k, m); i <= k && i < m; i++)
        for (unsigned j = sub_clamped(l, n - 1); j <= l && j <= n; j++) {
            const spot *a = &x->c[i * w + j], *b = &x->c[(k - i) * w + l - j];
            const spot along_u = net_step(a, a + w), along_v = net_step(b, b + 1);
            const int32_t weight = loft_binomial(m - 1, i) * loft_binomial(n, j) *
                                   loft_binomial(m, k - i) * loft_binomial(n - 1, l - j);
            add_cross(&sum, weight, &along_u, &along_v);
        }
    return sum;
}

static loft_sci spot_length(const spot *x)
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < 3; i++)
        sum = loft_sci_add(sum, loft_sci_mul(x->axis[i], x->axis[i]));
    return loft_sci_sqrt(sum);
}

/* The bounds are m n / (4 m n) = 1/4 of the sums. */
static bounds bounds_of(const patch *x)
{
    const loft_sci four = loft_sci_from_int(4);
    spot total = { { loft_sci_zero(), loft_sci_zero(), loft_sci_zero() } };
    bounds r = { loft_sci_zero(), loft_sci_zero() };

    for (unsigned k = 0; k < 2 * x->m; k++)
        for (unsigned l = 0; l < 2 * x->n; l++) {
            const loft_sci scale = loft_sci_from_int(loft_binomial(2 * x->m - 1, k) *
                                                     loft_binomial(2 * x->n - 1, l));
            spot one = normal_coefficient(x, k, l);
            for (int i = 0; i < 3; i++) {
                one.axis[i] = loft_sci_div(one.axis[i], scale);
                total.axis[i] = loft_sci_add(total.axis[i], one.axis[i]);
            }
            r.upper = loft_sci_add(r.upper, spot_length(&one));
        }
    r.lower = loft_sci_div(spot_length(&total), four);
    r.upper = loft_sci_div(r.upper, four);
    return r;
}

static bool points_valid(const loft_net *s)
{
    const unsigned count = s->triangle ? LOFT_TRIANGLE_POINTS(s->m) : (s->m + 1u) * (s->n + 1u);
    return loft_vec_exact_valid(s->p, count, LOFT_AXES);
}

enum loft_status loft_net_area(loft_net s, loft_real tol, loft_acc *out)
{
    const loft_sci two = loft_sci_from_int(2);
    loft_dyad piece = { 0, 0 };
    loft_sci twice = loft_sci_zero();       /* the area, times 2 */
    patch whole, x;

    if (!(tol > 0) || s.weighted)
        return LOFT_ERR_ARG;
    if (!points_valid(&s))
        return LOFT_ERR_RANGE;
    load_patch(&whole, &s);
    do {
        for (;;) {
            x = whole;
            cut_patch(&x, piece);
            const bounds b = bounds_of(&x);
            const loft_sci share = loft_sci_div(loft_sci_mul(two, loft_sci_from_real(tol)),
                                                loft_sci_from_int((int32_t)1 << piece.level));
            if (!loft_sci_less(share, loft_sci_sub(b.upper, b.lower))) {
                twice = loft_sci_add(twice, loft_sci_add(b.lower, b.upper));
                break;
            }
            if (piece.level == LOFT_DYAD_LEVELS)
                return LOFT_ERR_RANGE;
            piece = loft_dyad_half(piece, 0);
        }
    } while (loft_dyad_next(&piece));
    return loft_sci_to_acc(loft_sci_div(twice, two), out) ? LOFT_OK : LOFT_ERR_RANGE;
}
