/* lib/surface/net_field.c
 * SPDX-License-Identifier: MIT
 *
 * The point is P = X / w, A = (X, w). With D(a, b, c) = w_a X_b x X_c + w_b X_c x X_a + w_c X_a x
 * X_b, the vector part of the plane through three points, the normal is
 *
 *     P_u x P_v = M / w^3,   M = D(A, A_u, A_v)
 *
 * De Casteljau's last step gives four points of degrees m - 1, n - 1: A_00, A_10, A_01, A_11. D
 * alternates, so with S_j = A_1j - A_0j and T_i = A_i1 - A_i0
 *
 *     M = m n ( (1-u) (1-v) D(A_00, S_0, T_0) + u (1-v) D(A_00, S_0, T_1)
 *             + (1-u) v D(A_00, S_1, T_0) + u v D(A_10, S_1, T_1) )
 *
 * of the degrees p = 3 m - 2, q = 3 n - 2. Without weights w = 1 and M = X_u x X_v has the degrees
 * 2 m - 1, 2 n - 1. In the same way det(X, X_u, X_v) = X . M / w is a sum of determinants of three
 * points, and the cone over the patch has the volume 1/3 int det / w^3.
 *
 * Far from the apex these determinants of long vectors would cancel. So the points are seen from
 * the first one, X = Y + w o, with o that point seen from the apex: det X = det Y + o . M, as M
 * is the same of both. Without weights S and T are steps of the net and M = S x T, so each term is
 * at most the product of two steps and of the distance from the apex, L: with 2^-53 for each of the
 * roundings (q16: 2^-61), of about m n terms, the whole is within 2^-40 A L (q16: 2^-48 A L).
 *
 * Moments. A point of the cone is r P, its element of volume r^2 dr det / w^3, so the first moments
 * about the apex are 1/4 int X det / w^4: one polynomial more, of the degrees 4 m - 2, 4 n - 2.
 *
 * For Bernstein polynomials B_k^p B_i^r = C(p,k) C(r,i) / C(p+r,k+i) B_(k+i)^(p+r), and the
 * integral of that one is 1 / (p + r + 1).
 */
#include "surface/net_field.h"
#include "basis/integral.h"     /* loft_binomial_sci */

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

static spot step_of(const loft_net_form *f, unsigned i, unsigned j, unsigned du, unsigned dv)
{
    const spot a = spot_of(f, i, j), b = spot_of(f, i + du, j + dv);
    spot r;

    for (int axis = 0; axis < 3; axis++)
        r.x[axis] = loft_sci_sub(b.x[axis], a.x[axis]);
    r.w = loft_sci_sub(b.w, a.w);
    return r;
}

/* The net seen from its first point, and that seen from the apex. */
typedef struct {
    loft_net_form form;
    loft_sci offset[3];
} view;

/* D(a, b, c) or the determinant, seen from the apex, times the factor. */
static void add_plane(const line *bc, const spot *a, const view *f, loft_sci factor, unsigned each,
                      loft_sci out[])
{
    loft_sci plane[3];

    loft_sci_cross3(bc->turn, a->x, plane);
    for (int i = 0; i < 3; i++)
        loft_sci_add_product(&plane[i], a->w, bc->cross[i]);
    if (each == 1) {
        loft_sci_add_product(
            out, factor,
            loft_sci_add(loft_sci_dot3(bc->cross, a->x), loft_sci_dot3(plane, f->offset)));
        return;
    }
    for (int i = 0; i < 3; i++)
        loft_sci_add_product(&out[i], factor, plane[i]);
}

/* The term of B_a(u) B_b(v): of its point, its step along u, its step along v. */
static void add_term(const view *f, loft_net_field *x, unsigned u, unsigned v)
{
    const unsigned m = x->m, n = x->n, wide = x->q + 1;

    for (unsigned ab = 0; ab < m * n * m * n; ab++) {
        const unsigned i = ab % m, j = ab / m % n, k = ab / (m * n) % m, l = ab / (m * n * m);
        const spot along = step_of(&f->form, i, j + v, 1, 0),
                   across = step_of(&f->form, k + u, l, 0, 1);
        const line both = line_of(&along, &across);
        const loft_sci two = loft_sci_from_int(loft_binomial(m - 1, i) * loft_binomial(n - 1, j) *
                                               (loft_binomial(m - 1, k) * loft_binomial(n - 1, l)));
        for (unsigned g = 0; g < m; g++)
            for (unsigned h = 0; h < n; h++) {
                const spot a = spot_of(&f->form, g + (u & v), h);
                const unsigned at = (i + k + g + u) * wide + j + l + h + v;
                const loft_sci one = loft_sci_from_int(loft_binomial(m - 1, g) *
                                                       loft_binomial(n - 1, h));
                add_plane(&both, &a, f, loft_sci_mul(two, one), x->each, x->whole + at * x->each);
            }
    }
}

/* X_u x X_v. The product of four binomials is at most 70 * 126 * 126 * 70 < 2^27. */
static void add_cross(const loft_net_form *f, loft_net_field *x)
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
            loft_sci_add_product(&x->whole[((i + k) * (x->q + 1) + j + l) * 3 + (unsigned)axis],
                                 factor, cross[axis]);
    }
}

/* From coefficients times binomials to coefficients, times m n. */
static void scale_field(loft_net_field *x)
{
    const loft_sci both = sci_of(x->m * x->n);

    for (unsigned k = 0; k <= x->p; k++)
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned i = 0; i < x->each; i++) {
                loft_sci *at = &x->whole[(k * (x->q + 1) + l) * x->each + i];
                *at = loft_sci_div(
                    loft_sci_mul(both, *at),
                    loft_sci_mul(loft_binomial_sci(x->p, k), loft_binomial_sci(x->q, l)));
            }
}

static loft_sci product_integral(unsigned p, unsigned k, unsigned r, unsigned i)
{
    return loft_sci_div(loft_sci_mul(loft_binomial_sci(p, k), loft_binomial_sci(r, i)),
                        loft_sci_mul(loft_binomial_sci(p + r, k + i), sci_of(p + r + 1)));
}

static void load_integrals(loft_net_field *x, int along, unsigned p, unsigned r)
{
    for (unsigned k = 0; k <= p && x->weighted; k++)
        for (unsigned i = 0; i <= r; i++)
            x->with[along][k * (r + 1) + i] = product_integral(p, k, r, i);
}

/* B_k of the degree at t and at 1 - t: nodes g and 3 - g. */
static void load_node(loft_sci of[], unsigned degree, unsigned g, loft_sci t)
{
    const loft_sci s = loft_sci_sub(loft_sci_one(), t);
    loft_sci *other  = of + (LOFT_NET_NODES - 1 - g) * (degree + 1);

    of += g * (degree + 1);
    for (unsigned k = 0; k <= degree; k++) {
        of[k] = loft_sci_mul(loft_binomial_sci(degree, k),
                             loft_sci_mul(loft_sci_pow(t, k), loft_sci_pow(s, degree - k)));
        other[degree - k] = of[k];
    }
}

/* Gauss's formula with 4 nodes: t = 1/2 -+ sqrt(3/7 +- 2/7 sqrt(6/5)) / 2, with the shares
 * (18 -+ sqrt 30) / 72. */
static void load_nodes(loft_net_field *x)
{
    const loft_sci half = loft_sci_power2(-1),
                   root = loft_sci_mul(loft_sci_div(sci_of(2), sci_of(35)),
                                       loft_sci_sqrt(sci_of(30))),
                   less = loft_sci_div(loft_sci_sqrt(sci_of(30)), sci_of(72));

    for (unsigned g = 0; g < LOFT_NET_NODES / 2; g++) {
        const loft_sci square = loft_sci_add(loft_sci_div(sci_of(3), sci_of(7)),
                                             g ? loft_sci_neg(root) : root),
                       t = loft_sci_sub(half, loft_sci_mul(half, loft_sci_sqrt(square)));
        x->share[g] = loft_sci_add(loft_sci_power2(-2), g ? less : loft_sci_neg(less));
        load_node(x->node[0], x->p, g, t);
        load_node(x->node[1], x->q, g, t);
        load_node(x->w_node[0], x->m, g, t);
        load_node(x->w_node[1], x->n, g, t);
    }
}

/* From D in c[] to D X, both times binomials. */
static void add_moments(const view *f, loft_net_field *x)
{
    const unsigned p = x->p, q = x->q;

    x->p += x->m;
    x->q += x->n;
    x->each = 3;
    for (unsigned at = 0; at < (p + 1) * (q + 1); at++)
        for (unsigned i = 0; i <= x->m; i++)
            for (unsigned j = 0; j <= x->n; j++) {
                const spot s = spot_of(&f->form, i, j);
                const loft_sci ways = loft_sci_from_int(loft_binomial(x->m, i) *
                                                        loft_binomial(x->n, j)),
                               d = loft_sci_mul(ways, x->c[at]);
                const unsigned to = (at / (q + 1) + i) * (x->q + 1) + at % (q + 1) + j;
                for (unsigned axis = 0; axis < 3; axis++)
                    loft_sci_add_product(
                        &x->whole[to * 3 + axis], d,
                        loft_sci_add(s.x[axis], loft_sci_mul(s.w, f->offset[axis])));
            }
}

/* Divide the memory. */
static void hold_field(loft_sci memory[], unsigned all, loft_net_field *x)
{
    const unsigned weights = (x->m + 1) * (x->n + 1), p = x->p + 1, q = x->q + 1;

    x->whole = memory;
    x->c = x->whole + all;
    x->w_whole = x->c + all;
    x->w = x->w_whole + weights;
    x->with[0] = x->w + weights;
    x->with[1] = x->with[0] + p * (x->m + 1);
    x->node[0] = x->with[1] + q * (x->n + 1);
    x->node[1] = x->node[0] + LOFT_NET_NODES * p;
    x->w_node[0] = x->node[1] + LOFT_NET_NODES * q;
    x->w_node[1] = x->w_node[0] + LOFT_NET_NODES * (x->m + 1);
}

static void load_polynomial(const view *f, enum loft_net_field_of of, loft_net_field *x)
{
    if (of == LOFT_NET_NORMAL && !f->form.weighted) {
        add_cross(&f->form, x);
        return;
    }
    for (unsigned term = 0; term < 4; term++)
        add_term(f, x, term & 1, term >> 1);
}

static void load_view(const loft_net *s, const loft_vec *apex, view *out)
{
    const loft_vec first = s->weighted ? s->weighted[0].p : s->p[0];

    loft_net_load(*s, first, &out->form);
    for (int axis = 0; axis < 3; axis++)
        out->offset[axis] = axis < LOFT_AXES
                                ? loft_sci_sub(loft_sci_from_real(loft_vec_axis(&first, axis)),
                                               loft_sci_from_real(loft_vec_axis(apex, axis)))
                                : loft_sci_zero();
}

void loft_net_field_load(loft_net s, loft_vec apex, enum loft_net_field_of of, loft_sci memory[],
                         loft_net_field *x)
{
    const bool flat = s.weighted == NULL && of == LOFT_NET_NORMAL, moment = of == LOFT_NET_MOMENT;
    const unsigned least = flat ? 1 : 2, degree = moment ? 4 : flat ? 2 : 3;
    view f;

    load_view(&s, &apex, &f);
    x->m = s.m;
    x->n = s.n;
    x->weighted = f.form.weighted;
    x->power = moment ? 4 : 3;
    x->each  = of == LOFT_NET_CONE ? 1 : 3;
    x->p = degree * s.m - least;
    x->q = degree * s.n - least;
    const unsigned all = (x->p + 1) * (x->q + 1) * x->each;
    hold_field(memory, all, x);
    for (unsigned k = 0; k < 2 * all; k++)
        memory[k] = loft_sci_zero();
    for (unsigned i = 0; i <= s.m && f.form.weighted; i++)
        for (unsigned j = 0; j <= s.n; j++)
            x->w_whole[i * (s.n + 1u) + j] = f.form.w.c[i][j];
    if (moment) {               /* D first, in the room of a part */
        x->p -= s.m;
        x->q -= s.n;
        x->each  = 1;
        x->whole = x->c;
    }
    load_polynomial(&f, of, x);
    if (moment) {
        x->whole = memory;
        add_moments(&f, x);
    }
    scale_field(x);
    load_integrals(x, 0, x->p, s.m);
    load_integrals(x, 1, x->q, s.n);
    load_nodes(x);
}
