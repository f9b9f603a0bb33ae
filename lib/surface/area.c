/* lib/surface/area.c
 * SPDX-License-Identifier: MIT
 *
 * The point is P = X / w, A = (X, w). With D(a, b, c) = w_a X_b x X_c + w_b X_c x X_a + w_c X_a x
 * X_b, the vector part of the plane through three points, the normal is
 *
 *     P_u x P_v = M / w^3,   M = D(A, A_u, A_v)
 *
 * De Casteljau's last step gives four points of degrees m - 1, n - 1: A_00, A_10, A_01, A_11. D
 * alternates, so
 *
 *     M = m n ( (1-u) (1-v) D(A_00, A_10, A_01) + u (1-v) D(A_00, A_10, A_11)
 *             + (1-u) v D(A_00, A_11, A_01) + u v D(A_10, A_11, A_01) )
 *
 * of the degrees p = 3 m - 2, q = 3 n - 2. Without weights w = 1 and M = X_u x X_v has the degrees
 * 2 m - 1, 2 n - 1. In the same way det(X, X_u, X_v) = X . M / w is a sum of determinants of three
 * points, and the cone over the patch has the volume 1/3 int det / w^3.
 *
 * Weights. Factors w_ij c^i d^j with c, d > 0 change the parameters and not the surface, and M_kl
 * becomes M_kl c^(k+1) d^(l+1). So on each piece the sums of the weights at opposite edges are made
 * nearly equal: then w = w0 + e, |e| <= d, with d of the second order of the width. Taylor's
 * polynomial of w^-3,
 *
 *     h = w0^-3 - 3 w0^-4 e,   |w^-3 - h| <= 6 d^2 / min w^5
 *
 * is a polynomial of u and v, so int M h is a sum of integrals of products: for Bernstein
 * polynomials B_k^p B_i^r = C(p,k) C(r,i) / C(p+r,k+i) B_(k+i)^(p+r), and the integral of that one
 * is 1 / (p + r + 1).
 *
 * Directions. S = int M h, n = S / |S|, a = M . n, b the part of M across n. Where all coefficients
 * of a are above 0,
 *
 *     a + b^2 / 2a - b^4 / 8a^3  <=  |M| = sqrt(a^2 + b^2)  <=  a + b^2 / 2a
 *
 * so with Q = int b^2, the extremes of the coefficients of a and w, and B the largest |b|,
 *
 *     area <= |S| + R + Q / (2 min a min w^3),   R = 6 d^2 / min w^5 int a
 *     area >= |S| - R + Q / (2 max a max w^3) (1 - B^2 / (4 min a^2))
 *
 * The two differ by the third power of the width. Elsewhere, at poles and folds, |S| - R <= area <=
 * mean |M_kl| / min w^3, with R from |M|. The mean of the two bounds is taken where they differ by
 * at most 2 tol times the piece's share of the parameter domain. So all pieces together err by at
 * most tol. Elsewhere the piece is halved, along the parameter by which M and w change more. The
 * pieces are the leaves of a binary tree (basis/dyadic.h).
 */
#include "surface/area.h"
#include "basis/dyadic.h"       /* loft_dyad_box */
#include "basis/integral.h"     /* loft_binomial_sci */
#include "geom/vec_exact.h"     /* loft_vec_exact_valid */
#include "num/sci.h"            /* loft_sci: areas of any size */

#define WIDE (3 * LOFT_DEGREE_MAX - 1)
#define SIDE (LOFT_DEGREE_MAX + 1)

/* A polynomial of the degrees p, q with 1 or 3 components, and the weight: of the whole patch, and
 * of a piece. */
typedef struct {
    unsigned p, q, each, m, n;
    bool weighted;
    loft_sci *whole, *c, *w_whole, *w;
    loft_sci *same[2];          /* integrals of products of B_k, along u and v */
    loft_sci *with[2];          /* of B_k and those of the weight              */
} field;

typedef struct {
    loft_sci lower, upper;
} bounds;

static loft_sci sci_of(unsigned k) { return loft_sci_from_int((int32_t)k); }


// The polynomial
// --------------

/* A homogeneous point: three coordinates and the weight. */
typedef struct {
    loft_sci x[3], w;
} spot;

static spot spot_of(const loft_net_form *f, unsigned i, unsigned j)
{
    spot r;

    for (int axis = 0; axis < 3; axis++)
        r.x[axis] = axis < LOFT_AXES ? f->axis[axis].c[i][j] : loft_sci_zero();
    r.w = f->weighted ? f->w.c[i][j] : loft_sci_one();
    return r;
}

/* out += factor x */
static void add_to(loft_sci *out, loft_sci factor, loft_sci x)
{
    *out = loft_sci_add(*out, loft_sci_mul(factor, x));
}

/* A pair of points, for products with many third ones. */
typedef struct {
    loft_sci cross[3], turn[3];         /* X_a x X_b, w_a X_b - w_b X_a */
} line;

static line line_of(const spot *a, const spot *b)
{
    line r;

    loft_sci_cross3(a->x, b->x, r.cross);
    for (int i = 0; i < 3; i++)
        r.turn[i] = loft_sci_sub_product(loft_sci_mul(a->w, b->x[i]), b->w, a->x[i]);
    return r;
}

/* D(a, b, c) or the determinant, times the factor. */
static void add_plane(const line *ab, const spot *c, loft_sci factor, unsigned each, loft_sci out[])
{
    loft_sci turned[3];

    if (each == 1) {
        add_to(out, factor, loft_sci_dot3(ab->cross, c->x));
        return;
    }
    loft_sci_cross3(ab->turn, c->x, turned);
    for (int i = 0; i < 3; i++)
        add_to(&out[i], factor, loft_sci_add(turned[i], loft_sci_mul(c->w, ab->cross[i])));
}

/* One of the four terms: `shift` of its points along u and v, and of its result. */
static void add_term(const loft_net_form *f, field *x, const unsigned shift[4][2])
{
    const unsigned m = x->m, n = x->n, wide = x->q + 1;

    for (unsigned ab = 0; ab < m * n * m * n; ab++) {
        const unsigned i = ab % m, j = ab / m % n, k = ab / (m * n) % m, l = ab / (m * n * m);
        const spot a = spot_of(f, i + shift[0][0], j + shift[0][1]),
                   b = spot_of(f, k + shift[1][0], l + shift[1][1]);
        const line both = line_of(&a, &b);
        const loft_sci two = loft_sci_from_int(loft_binomial(m - 1, i) * loft_binomial(n - 1, j) *
                                               (loft_binomial(m - 1, k) * loft_binomial(n - 1, l)));
        for (unsigned g = 0; g < m; g++)
            for (unsigned h = 0; h < n; h++) {
                const spot c = spot_of(f, g + shift[2][0], h + shift[2][1]);
                const unsigned at = (i + k + g + shift[3][0]) * wide + j + l + h + shift[3][1];
                const loft_sci one = loft_sci_from_int(loft_binomial(m - 1, g) *
                                                       loft_binomial(n - 1, h));
                add_plane(&both, &c, loft_sci_mul(two, one), x->each, x->whole + at * x->each);
            }
    }
}

/* X_u x X_v. The product of four binomials is at most 70 * 126 * 126 * 70 < 2^27. */
static void add_cross(const loft_net_form *f, field *x)
{
    const unsigned m = x->m, n = x->n;

    for (unsigned ab = 0; ab < m * (n + 1) * (m + 1) * n; ab++) {
        const unsigned i = ab % m, j = ab / m % (n + 1), k = ab / (m * (n + 1)) % (m + 1),
                       l = ab / (m * (n + 1) * (m + 1));
        const spot a = spot_of(f, i, j), right = spot_of(f, i + 1, j), b = spot_of(f, k, l),
                   above = spot_of(f, k, l + 1);
        const loft_sci factor = loft_sci_from_int(loft_binomial(m - 1, i) * loft_binomial(n, j) *
                                                  loft_binomial(m, k) * loft_binomial(n - 1, l));
        loft_sci d[2][3], cross[3];
        for (int axis = 0; axis < 3; axis++) {
            d[0][axis] = loft_sci_sub(right.x[axis], a.x[axis]);
            d[1][axis] = loft_sci_sub(above.x[axis], b.x[axis]);
        }
        loft_sci_cross3(d[0], d[1], cross);
        for (int axis = 0; axis < 3; axis++)
            add_to(&x->whole[((i + k) * (x->q + 1) + j + l) * 3 + (unsigned)axis], factor,
                   cross[axis]);
    }
}

/* From coefficients times binomials to coefficients, times m n. */
static void scale_field(field *x)
{
    const loft_sci both = sci_of(x->m * x->n);

    for (unsigned k = 0; k <= x->p; k++)
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned i = 0; i < x->each; i++) {
                loft_sci *at = &x->whole[(k * (x->q + 1) + l) * x->each + i];
                *at = loft_sci_div(loft_sci_mul(both, *at),
                                   loft_sci_mul(loft_sci_from_int(loft_binomial(x->p, k)),
                                                loft_sci_from_int(loft_binomial(x->q, l))));
            }
}

static loft_sci product_integral(unsigned p, unsigned k, unsigned r, unsigned i)
{
    return loft_sci_div(loft_sci_mul(loft_binomial_sci(p, k), loft_binomial_sci(r, i)),
                        loft_sci_mul(loft_binomial_sci(p + r, k + i), sci_of(p + r + 1)));
}

static void load_integrals(field *x, int along, unsigned p, unsigned r)
{
    for (unsigned k = 0; k <= p; k++) {
        for (unsigned i = 0; i <= p && x->each == 3; i++)
            x->same[along][k * (p + 1) + i] = product_integral(p, k, p, i);
        for (unsigned i = 0; i <= r && x->weighted; i++)
            x->with[along][k * (r + 1) + i] = product_integral(p, k, r, i);
    }
}

static void load_field(loft_net s, loft_vec origin, unsigned each, loft_sci memory[], field *x)
{
    static const unsigned shift[4][4][2] = { { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } },
                                             { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 0 } },
                                             { { 0, 0 }, { 1, 1 }, { 0, 1 }, { 0, 1 } },
                                             { { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1, 1 } } };
    loft_net_form f;

    loft_net_load(s, origin, &f);
    x->m = s.m;
    x->n = s.n;
    x->each = each;
    x->weighted = f.weighted;
    const bool flat = !f.weighted && each == 3;
    x->p = flat ? 2u * s.m - 1 : 3u * s.m - 2;
    x->q = flat ? 2u * s.n - 1 : 3u * s.n - 2;

    const unsigned all = (x->p + 1) * (x->q + 1) * each, weights = (s.m + 1u) * (s.n + 1u);
    x->whole = memory;
    x->c = x->whole + all;
    x->w_whole = x->c + all;
    x->w = x->w_whole + weights;
    x->same[0] = x->w + weights;
    x->same[1] = x->same[0] + (x->p + 1) * (x->p + 1);
    x->with[0] = x->same[1] + (x->q + 1) * (x->q + 1);
    x->with[1] = x->with[0] + (x->p + 1) * (s.m + 1u);
    for (unsigned k = 0; k < all; k++)
        x->whole[k] = loft_sci_zero();
    for (unsigned i = 0; i <= s.m && f.weighted; i++)
        for (unsigned j = 0; j <= s.n; j++)
            x->w_whole[i * (s.n + 1u) + j] = f.w.c[i][j];
    if (flat)
        add_cross(&f, x);
    for (int term = 0; term < 4 && !flat; term++)
        add_term(&f, x, shift[term]);
    scale_field(x);
    load_integrals(x, 0, x->p, s.m);
    load_integrals(x, 1, x->q, s.n);
}


// Pieces
// ------

/* One half of the polynomial c[0], c[stride] .. De Casteljau's algorithm leaves the left half at
 * the front and the right half at the back. */
static void halve_line(loft_sci c[], unsigned degree, unsigned stride, unsigned side)
{
    const loft_sci half = loft_sci_power2(-1);

    for (unsigned row = 0; row < degree; row++)
        for (unsigned k = 0; k < degree - row; k++) {
            loft_sci *to = &c[(side ? k : degree - k) * stride];
            const loft_sci *other = side ? to + stride : to - stride;
            *to = loft_sci_mul(half, loft_sci_add(*to, *other));
        }
}

static void halve_net(loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along,
                      unsigned side)
{
    const unsigned row = (n + 1) * each;

    for (unsigned k = 0; k < row && along == 0; k++)
        halve_line(c + k, m, row, side);
    for (unsigned i = 0; i <= m && along == 1; i++)
        for (unsigned k = 0; k < each; k++)
            halve_line(c + i * row + k, n, each, side);
}

/* About r^(1/m), by Pade's quotient: any number above 0 does. */
static loft_sci root_near(loft_sci r, unsigned m)
{
    const loft_sci x = loft_sci_sub(r, loft_sci_one()), two = sci_of(2 * m);

    return loft_sci_div(loft_sci_add(two, loft_sci_mul(x, sci_of(m + 1))),
                        loft_sci_add(two, loft_sci_mul(x, sci_of(m - 1))));
}

/* Multiply row (along u) or column i by factor^(i + above). */
static void scale_net(loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along,
                      loft_sci factor, unsigned above)
{
    const unsigned row = (n + 1) * each;
    loft_sci power     = loft_sci_pow(factor, above);

    for (unsigned i = 0; i <= (along == 0 ? m : n); i++) {
        for (unsigned k = 0; k < (along == 0 ? row : (m + 1) * each); k++) {
            loft_sci *at = along == 0 ? &c[i * row + k] : &c[k / each * row + i * each + k % each];
            *at = loft_sci_mul(*at, power);
        }
        power = loft_sci_mul(power, factor);
    }
}

static void balance_weights(field *x)
{
    for (unsigned along = 0; along < 2; along++) {
        const unsigned last = along == 0 ? x->m * (x->n + 1) : x->n,
                       step = along == 0 ? 1 : x->n + 1, count = along == 0 ? x->n : x->m;
        loft_sci sum[2] = { loft_sci_zero(), loft_sci_zero() };
        for (unsigned k = 0; k <= count; k++) {
            sum[0] = loft_sci_add(sum[0], x->w[k * step]);
            sum[1] = loft_sci_add(sum[1], x->w[last + k * step]);
        }
        const loft_sci factor = root_near(loft_sci_div(sum[0], sum[1]), along == 0 ? x->m : x->n);
        scale_net(x->w, x->m, x->n, 1, along, factor, 0);
        scale_net(x->c, x->p, x->q, x->each, along, factor, 1);
    }
}

static void cut_field(field *x, const loft_dyad_box *part)
{
    unsigned level[2] = { 0, 0 };

    for (unsigned k = 0; k < (x->p + 1) * (x->q + 1) * x->each; k++)
        x->c[k] = x->whole[k];
    for (unsigned k = 0; k < (x->m + 1) * (x->n + 1) && x->weighted; k++)
        x->w[k] = x->w_whole[k];
    for (unsigned d = 0; d < part->depth; d++) {
        const unsigned along = part->by[d];
        const loft_dyad at   = part->n[along];
        const unsigned side  = at.k >> (at.level - 1u - level[along]++) & 1;
        halve_net(x->c, x->p, x->q, x->each, along, side);
        if (x->weighted)
            halve_net(x->w, x->m, x->n, 1, along, side);
    }
    if (x->weighted)
        balance_weights(x);
}

static loft_sci square_of(const loft_sci x[], unsigned each)
{
    return each == 1 ? loft_sci_mul(x[0], x[0]) : loft_sci_dot3(x, x);
}

/* The mean square of the derivative along u or v, of the control net. */
static loft_sci change_of(const loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along)
{
    const unsigned step = along == 0 ? (n + 1) * each : each, rows = along == 0 ? m : m + 1,
                   columns = along == 0 ? n + 1 : n;
    loft_sci sum = loft_sci_zero(), d[3];

    for (unsigned i = 0; i < rows; i++)
        for (unsigned j = 0; j < columns; j++) {
            const loft_sci *at = c + (i * (n + 1) + j) * each;
            for (unsigned k = 0; k < each; k++)
                d[k] = loft_sci_sub(at[step + k], at[k]);
            sum = loft_sci_add(sum, square_of(d, each));
        }
    return rows * columns == 0 ? sum
                               : loft_sci_div(loft_sci_mul(sum, sci_of(along == 0 ? m * m : n * n)),
                                              sci_of(rows * columns));
}

/* Along u: 0, or v: 1? The weight counts as what it changes M / w^3 by. */
static unsigned longer_of(const field *x)
{
    loft_sci change[2];

    for (unsigned along = 0; along < 2; along++) {
        change[along] = change_of(x->c, x->p, x->q, x->each, along);
        if (x->weighted)
            change[along] = loft_sci_add(
                loft_sci_mul(change[along], loft_sci_mul(x->w[0], x->w[0])),
                loft_sci_mul(sci_of(9), loft_sci_mul(square_of(x->c, x->each),
                                                     change_of(x->w, x->m, x->n, 1, along))));
    }
    return loft_sci_less(change[0], change[1]);
}


// Weights
// -------

typedef struct {
    loft_sci first, slope;      /* h = first + slope w     */
    loft_sci most, least;       /* of w^-3                 */
    loft_sci rest;              /* the largest |w^-3 - h|  */
} weighing;

static weighing weighing_of(field *x)
{
    weighing r = { loft_sci_one(), loft_sci_zero(), loft_sci_one(), loft_sci_one(),
                   loft_sci_zero() };
    const loft_sci half = loft_sci_power2(-1);

    if (!x->weighted)
        return r;
    loft_sci low = x->w[0], high = x->w[0];
    for (unsigned k = 1; k < (x->m + 1) * (x->n + 1); k++) {
        low  = loft_sci_smaller(low, x->w[k]);
        high = loft_sci_larger(high, x->w[k]);
    }
    const loft_sci w0 = loft_sci_mul(half, loft_sci_add(low, high)),
                   d  = loft_sci_mul(half, loft_sci_sub(high, low));
    const loft_sci third = loft_sci_pow(loft_sci_div(loft_sci_one(), w0), 3),
                   one   = loft_sci_div(loft_sci_one(), low);
    r.first = loft_sci_mul(sci_of(4), third);
    r.slope = loft_sci_div(loft_sci_mul(loft_sci_from_int(-3), third), w0);
    r.most  = loft_sci_pow(one, 3);
    r.least = loft_sci_pow(loft_sci_div(loft_sci_one(), high), 3);
    r.rest  = loft_sci_mul(loft_sci_mul(sci_of(6), loft_sci_mul(d, d)), loft_sci_pow(one, 5));
    return r;
}

/* int M h, by components. */
static void integrate_field(const field *x, const weighing *by, loft_sci out[3])
{
    const unsigned p = x->p, q = x->q, m = x->m, n = x->n;
    const loft_sci mean = loft_sci_div(by->first, sci_of((p + 1) * (q + 1)));
    loft_sci row[SIDE];

    for (unsigned i = 0; i < 3; i++)
        out[i] = loft_sci_zero();
    for (unsigned k = 0; k <= p; k++) {
        for (unsigned j = 0; j <= n && x->weighted; j++) {
            row[j] = loft_sci_zero();
            for (unsigned i = 0; i <= m; i++)
                add_to(&row[j], x->with[0][k * (m + 1) + i], x->w[i * (n + 1) + j]);
        }
        for (unsigned l = 0; l <= q; l++) {
            loft_sci sum = loft_sci_zero(), share = mean;
            for (unsigned j = 0; j <= n && x->weighted; j++)
                add_to(&sum, x->with[1][l * (n + 1) + j], row[j]);
            add_to(&share, by->slope, sum);
            for (unsigned i = 0; i < x->each; i++)
                add_to(&out[i], share, x->c[(k * (q + 1) + l) * x->each + i]);
        }
    }
}

/* The mean of |M_kl|. */
static loft_sci mean_size(const field *x)
{
    const unsigned count = (x->p + 1) * (x->q + 1);
    loft_sci sum = loft_sci_zero();

    for (unsigned k = 0; k < count; k++)
        sum = loft_sci_add(sum, x->each == 1
                                    ? loft_sci_abs(x->c[k])
                                    : loft_sci_sqrt(loft_sci_dot3(&x->c[3 * k], &x->c[3 * k])));
    return loft_sci_div(sum, sci_of(count));
}

/* The integral of the square of the vectors. */
static loft_sci square_integral(const field *x)
{
    loft_sci row[WIDE][3], sum = loft_sci_zero();

    for (unsigned k = 0; k <= x->p; k++) {
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned i = 0; i < 3; i++) {
                row[l][i] = loft_sci_zero();
                for (unsigned g = 0; g <= x->p; g++)
                    add_to(&row[l][i], x->same[0][k * (x->p + 1) + g],
                           x->c[(g * (x->q + 1) + l) * 3 + i]);
            }
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned h = 0; h <= x->q; h++)
                add_to(&sum, x->same[1][l * (x->q + 1) + h],
                       loft_sci_dot3(row[l], &x->c[(k * (x->q + 1) + h) * 3]));
    }
    return loft_sci_abs(sum);
}


// Bounds
// ------

/* Each coefficient of M as its part along n, in sum and extremes, and the part across n, in place.
 * The largest square of the latter is `across`. */
typedef struct {
    loft_sci mean, least, most, across;
} parted;

static parted part_along(field *x, const loft_sci n[3])
{
    const unsigned count = (x->p + 1) * (x->q + 1);
    parted r = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero(), loft_sci_zero() };

    for (unsigned k = 0; k < count; k++) {
        loft_sci *at = &x->c[3 * k];
        const loft_sci a = loft_sci_dot3(at, n);
        r.mean  = loft_sci_add(r.mean, a);
        r.least = k ? loft_sci_smaller(r.least, a) : a;
        r.most  = k ? loft_sci_larger(r.most, a) : a;
        for (unsigned i = 0; i < 3; i++)
            at[i] = loft_sci_sub_product(at[i], a, n[i]);
        r.across = loft_sci_larger(r.across, loft_sci_dot3(at, at));
    }
    r.mean = loft_sci_div(r.mean, sci_of(count));
    return r;
}

static bounds bounds_around(loft_sci middle, loft_sci rest)
{
    const bounds r = { loft_sci_sub(middle, rest), loft_sci_add(middle, rest) };
    return r;
}

static bounds area_bounds(field *x)
{
    const weighing by = weighing_of(x);
    const loft_sci size = mean_size(x);
    loft_sci sum[3], n[3];

    integrate_field(x, &by, sum);
    const loft_sci middle = loft_sci_sqrt(loft_sci_dot3(sum, sum));
    bounds r = bounds_around(middle, loft_sci_mul(by.rest, size));
    r.lower = loft_sci_larger(r.lower, loft_sci_zero());
    r.upper = loft_sci_mul(size, by.most);
    if (loft_sci_sign(middle) == 0)
        return r;
    for (unsigned i = 0; i < 3; i++)
        n[i] = loft_sci_div(sum[i], middle);
    const parted a = part_along(x, n);
    if (loft_sci_sign(a.least) <= 0)
        return r;
    const loft_sci q = loft_sci_mul(square_integral(x), loft_sci_power2(-1)),
                   slack = loft_sci_sub(
                       loft_sci_one(),
                       loft_sci_div(a.across,
                                    loft_sci_mul(sci_of(4), loft_sci_mul(a.least, a.least))));
    r = bounds_around(middle, loft_sci_mul(by.rest, a.mean));
    r.upper = loft_sci_add(r.upper, loft_sci_div(loft_sci_mul(q, by.most), a.least));
    if (loft_sci_sign(slack) > 0)
        r.lower = loft_sci_add(
            r.lower, loft_sci_mul(loft_sci_div(loft_sci_mul(q, by.least), a.most), slack));
    return r;
}

static bounds volume_bounds(field *x)
{
    const weighing by = weighing_of(x);
    loft_sci sum[3];

    integrate_field(x, &by, sum);
    return bounds_around(sum[0], loft_sci_mul(by.rest, mean_size(x)));
}

/* The integral over the patch within tol. */
static enum loft_status integrate_pieces(field *x, loft_sci tol, loft_sci *out)
{
    const loft_sci twice = loft_sci_add(tol, tol);
    loft_sci sum = loft_sci_zero();
    loft_dyad_box part;

    loft_dyad_box_start(&part);
    do {
        for (;;) {
            cut_field(x, &part);
            const unsigned along = longer_of(x);
            const bounds b = x->each == 1 ? volume_bounds(x) : area_bounds(x);
            if (!loft_sci_less(twice, loft_sci_sub(b.upper, b.lower))) {
                const loft_sci share = loft_sci_power2(-(int)part.depth - 1);
                add_to(&sum, share, loft_sci_add(b.lower, b.upper));
                break;
            }
            if (part.depth == LOFT_DYAD_LEVELS)
                return LOFT_ERR_RANGE;
            loft_dyad_box_halve(&part, along);
        }
    } while (loft_dyad_box_next(&part));
    *out = sum;
    return LOFT_OK;
}

static bool points_valid(const loft_net *s)
{
    const unsigned count = s->triangle ? LOFT_TRIANGLE_POINTS(s->m) : (s->m + 1u) * (s->n + 1u);
    bool valid = s->weighted || loft_vec_exact_valid(s->p, count, LOFT_AXES);

    for (unsigned k = 0; k < count && s->weighted; k++)
        valid = valid && loft_vec_exact_valid(&s->weighted[k].p, 1, LOFT_AXES);
    return valid;
}

/* The integral of |M| / w^3, or of det / w^3: `each` is 3 or 1. */
static enum loft_status integral_of(loft_net s, loft_vec origin, unsigned each, loft_sci tol,
                                    loft_sci memory[], loft_sci *out)
{
    field x;

    if (!points_valid(&s))
        return LOFT_ERR_RANGE;
    *out = loft_sci_zero();
    if (s.m == 0 || s.n == 0)
        return LOFT_OK;
    load_field(s, origin, each, memory, &x);
    return integrate_pieces(&x, tol, out);
}

enum loft_status loft_net_area(loft_net s, loft_real tol, loft_sci memory[], loft_acc *out)
{
    loft_sci area;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    const enum loft_status status = integral_of(s, s.weighted ? s.weighted[0].p : s.p[0], 3,
                                                loft_sci_from_real(tol), memory, &area);
    if (status != LOFT_OK)
        return status;
    return loft_sci_to_acc(area, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_net_cone_volume(loft_net s, loft_vec apex, loft_real tol, loft_sci memory[],
                                      loft_acc *out)
{
    const loft_sci three = loft_sci_from_int(3);
    loft_sci volume;

    if (!(tol > 0) || LOFT_AXES < 3)
        return LOFT_ERR_ARG;
    const enum loft_status status = integral_of(
        s, apex, 1, loft_sci_mul(three, loft_sci_from_real(tol)), memory, &volume);
    if (status != LOFT_OK)
        return status;
    return loft_sci_to_acc(loft_sci_div(volume, three), out) ? LOFT_OK : LOFT_ERR_RANGE;
}
