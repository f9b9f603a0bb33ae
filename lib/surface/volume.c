/* lib/surface/volume.c
 * SPDX-License-Identifier: MIT
 *
 * Coordinates are relative to the first point of the first patch, which changes the integral by a
 * flow through a closed surface: 0. With the volume as the sum over the three axes of int x_i n_i /
 * 3, n = P_u x P_v, any one of them times 3 would do; the mean of the three is taken.
 *
 * B_i^p B_j^q = C(p, i) C(q, j) / C(p + q, i + j) B_(i+j)^(p+q), so in each direction a product of
 * coefficients goes to one coefficient, and a last product is integrated: the mean over the degree
 * + 1. n has the degrees 2 m - 1 and 2 n - 1. Coefficients multiplied by their binomials make all
 * of this plain products.
 */
#include "surface/volume.h"
#include "basis/integral.h"     /* loft_binomial_sci */

#if LOFT_AXES >= 3

#define SIDE (LOFT_DEGREE_MAX + 1)
#define WIDE (2 * LOFT_DEGREE_MAX)

/* A polynomial of the degrees m, n: coefficients times their two binomials. */
typedef struct {
    unsigned m, n;
    loft_sci c[SIDE][SIDE];
} scaled;

typedef struct {
    unsigned m, n;
    loft_sci c[WIDE][WIDE];
} scaled_wide;

static loft_sci binomials(unsigned m, unsigned i, unsigned n, unsigned j)
{
    return loft_sci_mul(loft_binomial_sci(m, i), loft_binomial_sci(n, j));
}

/* The coordinate, or its derivative by u (du = 1) or v (dv = 1), degrees permitting. */
static void load_scaled(const loft_sci_net *x, unsigned du, unsigned dv, scaled *out)
{
    const int32_t factor = (int32_t)(du ? x->m : dv ? x->n : 1);

    out->m = x->m - du;
    out->n = x->n - dv;
    for (unsigned i = 0; i <= out->m; i++)
        for (unsigned j = 0; j <= out->n; j++) {
            loft_sci at = x->c[i + du][j + dv];
            if (du || dv)
                at = loft_sci_sub(at, x->c[i][j]);
            out->c[i][j] = loft_sci_mul(loft_sci_mul(loft_sci_from_int(factor), at),
                                        binomials(out->m, i, out->n, j));
        }
}

/* Add or subtract a product of polynomials. */
static void add_product(const scaled *a, const scaled *b, bool minus, scaled_wide *sum)
{
    for (unsigned i = 0; i <= a->m; i++)
        for (unsigned j = 0; j <= a->n; j++)
            for (unsigned k = 0; k <= b->m; k++)
                for (unsigned l = 0; l <= b->n; l++) {
                    const loft_sci x = loft_sci_mul(a->c[i][j], b->c[k][l]);
                    loft_sci *at = &sum->c[i + k][j + l];
                    *at = minus ? loft_sci_sub(*at, x) : loft_sci_add(*at, x);
                }
}

/* The component `axis` of P_u x P_v. */
static void load_normal(const loft_net_form *s, int axis, scaled_wide *out)
{
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    scaled a, b;

    out->m = 2u * s->axis[y].m - 1;
    out->n = 2u * s->axis[y].n - 1;
    for (unsigned i = 0; i <= out->m; i++)
        for (unsigned j = 0; j <= out->n; j++)
            out->c[i][j] = loft_sci_zero();
    load_scaled(&s->axis[y], 1, 0, &a);
    load_scaled(&s->axis[z], 0, 1, &b);
    add_product(&a, &b, false, out);
    load_scaled(&s->axis[z], 1, 0, &a);
    load_scaled(&s->axis[y], 0, 1, &b);
    add_product(&a, &b, true, out);
}

/* int x n over the patch */
static loft_sci integral_of(const scaled *x, const scaled_wide *n)
{
    const unsigned p = x->m + n->m, q = x->n + n->n;
    loft_sci sum = loft_sci_zero();

    for (unsigned i = 0; i <= x->m; i++)
        for (unsigned j = 0; j <= x->n; j++)
            for (unsigned k = 0; k <= n->m; k++)
                for (unsigned l = 0; l <= n->n; l++)
                    sum = loft_sci_add(sum, loft_sci_div(loft_sci_mul(x->c[i][j], n->c[k][l]),
                                                         binomials(p, i + k, q, j + l)));
    return loft_sci_div(sum, loft_sci_from_int((int32_t)((p + 1) * (q + 1))));
}

static loft_sci flow_through(loft_net s, loft_vec origin)
{
    loft_sci sum = loft_sci_zero();
    loft_net_form form;
    scaled x;
    scaled_wide normal;

    loft_net_load(s, origin, &form);
    for (int axis = 0; axis < 3 && s.m > 0 && s.n > 0; axis++) {
        load_scaled(&form.axis[axis], 0, 0, &x);
        load_normal(&form, axis, &normal);
        sum = loft_sci_add(sum, integral_of(&x, &normal));
    }
    return sum;
}

enum loft_status loft_net_volume(const loft_net s[], unsigned count, loft_acc *out)
{
    loft_sci sum = loft_sci_zero();

    if (count < 1)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < count; k++) {
        if (s[k].weighted)
            return LOFT_ERR_ARG;
        sum = loft_sci_add(sum, flow_through(s[k], s[0].p[0]));
    }
    return loft_sci_to_acc(loft_sci_div(sum, loft_sci_from_int(3)), out) ? LOFT_OK : LOFT_ERR_RANGE;
}

#else

enum loft_status loft_net_volume(const loft_net s[], unsigned count, loft_acc *out)
{
    (void)s;
    (void)count;
    (void)out;
    return LOFT_ERR_ARG;
}

#endif
