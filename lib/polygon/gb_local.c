/* lib/polygon/gb_local.c -- derivatives of generalized Bezier patches
 * SPDX-License-Identifier: MIT
 *
 * The formulas of gb.c, in functions of the point. All weights, B0 too, sum to 1, so the derivatives of the weights sum to 0:
 *
 *     S - V0 = sum mu^i_jk B_j(s_i) B_k(h_i) (V^i_jk - V0)
 *
 * On a far side s_i is 0/0. Its weights have the factor (1 - h_i)^(degree - k), whose second derivatives are 0 there unless
 * degree = 3, k = 1; then what counts is the limit of s_i, the quotient of derivatives in any direction that leaves the side.
 */
#include "polygon/gb.h"

#define LAYERS ((LOFT_DEGREE_MAX + 1) / 2)

static unsigned layers_of(unsigned degree) { return (degree + 1) / 2; }

static unsigned before(unsigned i, unsigned sides) { return i ? i - 1 : sides - 1; }
static unsigned after(unsigned i, unsigned sides)  { return i + 1 < sides ? i + 1 : 0; }

static bool none(loft_sci x)            { return loft_sci_sign(x) == 0; }
static loft_sci size_of(loft_sci x)     { return loft_sci_sign(x) < 0 ? loft_sci_neg(x) : x; }
static loft_sci half_of(void)           { return loft_sci_from_real(LOFT_REAL(0.5)); }

/* What the weights of one ribbon are made of: B_j(s_i), times mu as well, B_k(h_i). */
typedef struct {
    loft_jet along[LOFT_DEGREE_MAX + 1], turned[4], across[LAYERS];
} ribbon;

/* C(degree, k) x^k y^(degree - k) for k = 0 .. count - 1. */
static void bernstein(loft_jet out[], unsigned degree, unsigned count, const loft_jet *x, const loft_jet *y)
{
    loft_jet power = loft_jet_of(loft_sci_one());

    for (unsigned k = 0; k < count; k++) {
        out[k] = loft_jet_scale(&power, loft_sci_from_int(loft_binomial(degree, k)));
        power = loft_jet_mul(&power, x);
    }
    power = loft_jet_of(loft_sci_one());
    for (unsigned k = count; k <= degree; k++)
        power = loft_jet_mul(&power, y);
    for (unsigned k = count; k-- > 0; ) {
        out[k] = loft_jet_mul(&out[k], &power);
        power = loft_jet_mul(&power, y);
    }
}

/* h of side i. */
static loft_jet rest_of(const loft_jet phi[], unsigned sides, unsigned i)
{
    loft_jet sum = loft_jet_of(loft_sci_zero());

    for (unsigned k = after(after(i, sides), sides); k != i; k = after(k, sides))
        sum = loft_jet_add(&sum, &phi[k]);
    return sum;
}

/* The limit of f / whole where both are 0. */
static loft_jet limit_of(const loft_jet *f, const loft_jet *whole)
{
    const bool tall = loft_sci_less(size_of(whole->x), size_of(whole->y));

    if (none(whole->x) && none(whole->y))
        return loft_jet_of(half_of());
    return loft_jet_of(tall ? loft_sci_div(f->y, whole->y) : loft_sci_div(f->x, whole->x));
}

static bool ribbon_start(ribbon *r, const loft_jet phi[], unsigned sides, unsigned degree, unsigned i)
{
    const loft_jet *a = &phi[i], *b = &phi[after(i, sides)];
    const loft_jet below = loft_jet_add(a, b), h = rest_of(phi, sides, i);
    const bool far = none(a->f) && none(b->f);
    loft_jet turn[2], s, t;

    turn[0] = rest_of(phi, sides, before(i, sides));
    turn[1] = rest_of(phi, sides, after(i, sides));
    for (int k = 0; k < 2; k++) {
        const loft_jet sum = loft_jet_add(&turn[k], &h);
        if (none(sum.f))
            return false;
        turn[k] = loft_jet_div(&turn[k], &sum);
    }
    if (none(below.f) && !far)
        return false;
    s = far ? limit_of(b, &below) : loft_jet_div(b, &below);
    t = far ? limit_of(a, &below) : loft_jet_div(a, &below);
    bernstein(r->along, degree, degree + 1, &s, &t);
    bernstein(r->across, degree, layers_of(degree), &h, &below);
    for (unsigned j = 0; j < 2; j++) {
        r->turned[j] = loft_jet_mul(&turn[0], &r->along[j]);
        r->turned[3 - j] = loft_jet_mul(&turn[1], &r->along[degree - j]);
    }
    return true;
}

/* mu B_j(s_i), where mu is not 0. */
static loft_jet share_of(const ribbon *r, unsigned degree, unsigned j, unsigned k)
{
    switch (loft_gb_mu_of(degree, j, k)) {
    case LOFT_GB_BEFORE:    return r->turned[j];
    case LOFT_GB_AFTER:     return r->turned[j + 3 - degree];
    case LOFT_GB_HALF:      return loft_jet_scale(&r->along[j], half_of());
    case LOFT_GB_WHOLE:     return r->along[j];
    case LOFT_GB_NONE:      break;
    }
    return loft_jet_of(loft_sci_zero());
}

static void add_to(loft_sci *sum, loft_sci x) { *sum = loft_sci_add(*sum, x); }

/* The sums so far, and those of the sizes of the first derivatives. */
typedef struct {
    loft_local at;
    loft_sci wide_u[LOFT_AXES], wide_v[LOFT_AXES];
} sums;

static void sums_start(sums *s)
{
    for (int i = 0; i < LOFT_AXES; i++)
        s->at.u[i] = s->at.v[i] = s->at.uu[i] = s->at.uv[i] = s->at.vv[i] = s->wide_u[i] = s->wide_v[i] = loft_sci_zero();
}

static void sums_add(sums *s, const loft_vec *p, const loft_vec *origin, const loft_jet *weight)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci d = loft_sci_of(loft_wide(p->axis[i]) - loft_wide(origin->axis[i]));
        const loft_sci by_x = loft_sci_mul(d, weight->x), by_y = loft_sci_mul(d, weight->y);
        add_to(&s->at.u[i], by_x);
        add_to(&s->at.v[i], by_y);
        add_to(&s->wide_u[i], size_of(by_x));
        add_to(&s->wide_v[i], size_of(by_y));
        add_to(&s->at.uu[i], loft_sci_mul(d, weight->xx));
        add_to(&s->at.uv[i], loft_sci_mul(d, weight->xy));
        add_to(&s->at.vv[i], loft_sci_mul(d, weight->yy));
    }
}

static void sums_end(const sums *s, loft_local *out)
{
    *out = s->at;
    out->width_u = s->wide_u[0];
    out->width_v = s->wide_v[0];
    for (int i = 1; i < LOFT_AXES; i++) {
        if (loft_sci_less(out->width_u, s->wide_u[i])) out->width_u = s->wide_u[i];
        if (loft_sci_less(out->width_v, s->wide_v[i])) out->width_v = s->wide_v[i];
    }
}

enum loft_status loft_gb_local(const loft_gb *g, const loft_jet phi[], loft_local *out)
{
    const unsigned d = g->degree;
    const loft_vec *middle = &g->p[loft_gb_count(g->sides, d) - 1];
    sums sum;
    ribbon r;

    sums_start(&sum);
    for (unsigned i = 0; i < g->sides; i++) {
        if (!ribbon_start(&r, phi, g->sides, d, i))
            return LOFT_SINGULAR;
        for (unsigned k = 0; k < layers_of(d); k++)
            for (unsigned j = k < 2 ? 0 : k; j <= (k < 2 ? d : d - k); j++) {
                const loft_jet share = share_of(&r, d, j, k), weight = loft_jet_mul(&share, &r.across[k]);
                sums_add(&sum, &g->p[loft_gb_place(g->sides, d, i, j, k)], middle, &weight);
            }
    }
    sums_end(&sum, out);
    return LOFT_OK;
}
