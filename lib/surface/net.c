/* lib/surface/net.c
 * SPDX-License-Identifier: MIT
 *
 * With the shares x (1 - y) of T2 and x y of T3 a triangular polynomial of degree n is
 *
 *     sum over i of B_i^n(x)  sum over k of B_k^i(y) b_(n-i)(i-k)k
 *
 * as the multinomial n! / (n-i)! (i-k)! k! is C(n, i) C(i, k). The inner sum is raised from degree
 * i to n:  c_k <- (k c_(k-1) + (d + 1 - k) c_k) / (d + 1).
 *
 * P = N / W gives  P_x = (N_x - P W_x) / W,  P_xx = (N_xx - 2 P_x W_x - P W_xx) / W,
 * P_xy = (N_xy - P_x W_y - P_y W_x - P W_xy) / W.
 */
#include "surface/net.h"

#define SIDE (LOFT_DEGREE_MAX + 1)

static loft_net net_of(const loft_vec p[], const loft_weighted weighted[], uint8_t m, uint8_t n,
                       bool triangle)
{
    const loft_net s = { p, weighted, m, n, triangle };
    return s;
}

loft_net loft_net_from_tensor(const loft_tensor *s)
{
    return net_of(s->p, NULL, s->m, s->n, false);
}
loft_net loft_net_from_tensor_rational(const loft_tensor_rational *s)
{
    return net_of(NULL, s->p, s->m, s->n, false);
}
loft_net loft_net_from_triangle(const loft_triangle *s)
{
    return net_of(s->p, NULL, s->degree, s->degree, true);
}
loft_net loft_net_from_triangle_rational(const loft_triangle_rational *s)
{
    return net_of(NULL, s->p, s->degree, s->degree, true);
}


// Equal nets
// ----------

static unsigned in_row(unsigned i, unsigned j, unsigned columns) { return i * columns + j; }

/* Of a triangle, by the multiplicities of T2 and T3. */
static unsigned in_triangle(unsigned j, unsigned k) { return (j + k) * (j + k + 1) / 2 + k; }

static bool are_equal(loft_net a, unsigned i, loft_net b, unsigned j)
{
    if (!a.weighted)
        return loft_vec_equal(a.p[i], b.p[j]);
    return !(a.weighted[i].w < b.weighted[j].w) && !(b.weighted[j].w < a.weighted[i].w) &&
           loft_vec_equal(a.weighted[i].p, b.weighted[j].p);
}

/* The place in b of the point (i, j) of a. */
static unsigned place_of(loft_net b, unsigned order, unsigned i, unsigned j)
{
    static const uint8_t corner[6][2] = {
        { 1, 2 }, { 2, 1 }, { 0, 2 }, { 2, 0 }, { 0, 1 }, { 1, 0 }
    };
    if (b.triangle) {
        const unsigned times[3] = { b.m - i - j, i, j };
        return in_triangle(times[corner[order][0]], times[corner[order][1]]);
    }
    const unsigned row = order & 4 ? j : i, column = order & 4 ? i : j;
    return in_row(order & 1 ? b.m - row : row, order & 2 ? b.n - column : column, b.n + 1u);
}

static bool are_same_in(loft_net a, loft_net b, unsigned order)
{
    const bool crossed = !a.triangle && (order & 4);

    if (crossed ? a.m != b.n || a.n != b.m : a.m != b.m || a.n != b.n)
        return false;
    for (unsigned i = 0; i <= a.m; i++)
        for (unsigned j = 0; j <= (a.triangle ? a.m - i : a.n); j++)
            if (!are_equal(a, a.triangle ? in_triangle(i, j) : in_row(i, j, a.n + 1u), b,
                           place_of(b, order, i, j)))
                return false;
    return true;
}

bool loft_net_same(loft_net a, loft_net b)
{
    if (a.triangle != b.triangle || !a.weighted != !b.weighted)
        return false;
    for (unsigned order = 0; order < (a.triangle ? 6u : 8u); order++)
        if (are_same_in(a, b, order))
            return true;
    return false;
}

/* A coordinate seen from the origin, times the weight; axis LOFT_AXES: the weight. */
static loft_sci coefficient_of(const loft_net *s, unsigned k, const loft_vec *origin, int axis)
{
    const loft_sci w = s->weighted ? loft_sci_from_real(s->weighted[k].w) : loft_sci_one();

    if (axis == LOFT_AXES)
        return w;
    const loft_vec *p = s->weighted ? &s->weighted[k].p : &s->p[k];
    const loft_sci x = loft_sci_of(loft_to_acc(p->axis[axis]) - loft_to_acc(origin->axis[axis]));
    return s->weighted ? loft_sci_mul(x, w) : x;
}

static void raise_row(loft_sci c[], unsigned degree, unsigned to)
{
    for (unsigned d = degree; d < to; d++) {
        const loft_sci all = loft_sci_from_int((int32_t)d + 1);
        c[d + 1] = c[d];
        for (unsigned k = d; k > 0; k--)
            c[k] = loft_sci_lerp(c[k], c[k - 1], loft_sci_div(loft_sci_from_int((int32_t)k), all));
    }
}

static void load_axis(const loft_net *s, const loft_vec *origin, int axis, loft_sci_net *out)
{
    out->m = s->m;
    out->n = s->n;
    for (unsigned i = 0; i <= s->m; i++) {
        const unsigned last = s->triangle ? i : s->n;
        for (unsigned j = 0; j <= last; j++)
            out->c[i][j] = coefficient_of(
                s, s->triangle ? loft_triangle_place(i - j, j) : i * (s->n + 1u) + j, origin, axis);
        raise_row(out->c[i], last, s->n);
    }
}

void loft_net_load(loft_net s, loft_vec origin, loft_net_form *out)
{
    out->weighted = s.weighted != NULL;
    out->triangle = s.triangle;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        load_axis(&s, &origin, axis, &out->axis[axis]);
    if (out->weighted)
        load_axis(&s, &origin, LOFT_AXES, &out->w);
}

void loft_net_form_sub(const loft_net_form *x, const loft_dyad part[2], loft_net_form *out)
{
    out->weighted = x->weighted;
    out->triangle = x->triangle;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        loft_sci_net_sub(&x->axis[axis], part, &out->axis[axis]);
    if (x->weighted)
        loft_sci_net_sub(&x->w, part, &out->w);
}

/* The orders by x and y. */
static const unsigned char by[LOFT_NET_JET][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 },
                                                   { 2, 0 }, { 1, 1 }, { 0, 2 } };

/* From N to P, in place. */
static void divide_jet(loft_sci n[LOFT_NET_JET], const loft_sci w[LOFT_NET_JET], unsigned count)
{
    const loft_sci two = loft_sci_from_int(2);

    n[0] = loft_sci_div(n[0], w[0]);
    for (unsigned k = 1; k < count; k++) {
        n[k] = loft_sci_sub_product(n[k], n[0], w[k]);
        if (k == LOFT_NET_BY_XX || k == LOFT_NET_BY_YY) {
            const unsigned one = k == LOFT_NET_BY_XX ? LOFT_NET_BY_X : LOFT_NET_BY_Y;
            n[k] = loft_sci_sub_product(n[k], loft_sci_mul(two, n[one]), w[one]);
        }
        if (k == LOFT_NET_BY_XY) {
            n[k] = loft_sci_sub_product(n[k], n[LOFT_NET_BY_X], w[LOFT_NET_BY_Y]);
            n[k] = loft_sci_sub_product(n[k], n[LOFT_NET_BY_Y], w[LOFT_NET_BY_X]);
        }
        n[k] = loft_sci_div(n[k], w[0]);
    }
}

void loft_net_form_jet(const loft_net_form *f, unsigned order, loft_sci x, loft_sci y,
                       loft_sci out[LOFT_NET_JET][LOFT_AXES])
{
    const unsigned count = order == 0 ? 1 : order == 1 ? 3 : LOFT_NET_JET;
    loft_sci n[LOFT_NET_JET], w[LOFT_NET_JET];

    for (unsigned k = 0; k < count && f->weighted; k++)
        w[k] = loft_sci_net_deriv(&f->w, by[k][0], by[k][1], x, y);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned k = 0; k < count; k++)
            n[k] = loft_sci_net_deriv(&f->axis[axis], by[k][0], by[k][1], x, y);
        if (f->weighted)
            divide_jet(n, w, count);
        for (unsigned k = 0; k < count; k++)
            out[k][axis] = n[k];
    }
}

void loft_net_form_points(loft_net_form *f)
{
    for (int axis = 0; axis < LOFT_AXES && f->weighted; axis++)
        for (unsigned i = 0; i <= f->w.m; i++)
            for (unsigned j = 0; j <= f->w.n; j++)
                f->axis[axis].c[i][j] = loft_sci_div(f->axis[axis].c[i][j], f->w.c[i][j]);
}

void loft_net_form_place(const loft_net_form *f, loft_sci x, loft_sci y, loft_unit out[2])
{
    const loft_sci share = loft_sci_mul(x, y);

    out[0] = loft_sci_to_unit(f->triangle ? loft_sci_sub(x, share) : x);
    out[1] = loft_sci_to_unit(f->triangle ? share : y);
    if (f->triangle && out[1] > LOFT_UNIT(1) - out[0])
        out[1] = LOFT_UNIT(1) - out[0];
}
