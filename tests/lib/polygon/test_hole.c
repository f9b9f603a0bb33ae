/* tests/lib/polygon/test_hole.c -- properties of lib/polygon/hole.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_quad.h"             /* arb_domain, exact_sci */
#include "polygon/hole.h"
#include "polygon/meanvalue.h"
#include "polygon/wachspress.h"

#if LOFT_AXES >= 3

typedef struct {
    unsigned sides, degree, m;
    loft_vec edge[LOFT_SIDES_MAX][5], across[LOFT_SIDES_MAX][5];
    loft_vec net[201], split[LOFT_SIDES_MAX];
    loft_hole_side side[LOFT_SIDES_MAX];
    loft_acc gap;
    loft_gb g;
} sample;

/* A point of the regular polygon of radius 50, a little off and up. */
static loft_vec arb_corner(arb *a, unsigned sides, unsigned i, long double share)
{
    const long double turn = 2 * acosl(-1) / sides;
    loft_vec p = { { 0 } };

    for (int k = 0; k < 3; k++) {
        const long double from = k == 2 ? 0
                                 : k    ? sinl(turn * i)
                                        : cosl(turn * i),
                          to = k == 2 ? 0
                               : k    ? sinl(turn * (i + 1))
                                      : cosl(turn * (i + 1));
        p.axis[k] = LOFT_REAL(
            (double)(50 * (from + (to - from) * share) + (arb_below(a, 2001) - 1000.0L) / 200));
    }
    return p;
}

/* a x + b y of two differences, in 1/64: exact in f64 and almost in the others. */
static loft_vec blend(loft_vec x, loft_vec y, int a, int b)
{
    loft_vec p = { { 0 } };

    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = LOFT_REAL((double)((exact_of(x.axis[i]) * a + exact_of(y.axis[i]) * b) / 64));
    return p;
}

/* Edges of degree 3 or 4 around; across them neighbours whose tangent planes hold both edges at
 * each corner, and which have any twist. */
static sample *arb_hole(arb *a)
{
    static sample s;

    s.sides = 3 + arb_below(a, 6);
    s.m = 3 + arb_below(a, 2);
    s.degree = s.m + 1 + arb_below(a, LOFT_DEGREE_MAX - s.m);
    for (unsigned i = 0; i < s.sides; i++)
        for (unsigned k = 0; k < s.m; k++)
            s.edge[i][k] = arb_corner(a, s.sides, i, (long double)k / s.m);
    for (unsigned i = 0; i < s.sides; i++)
        s.edge[i][s.m] = s.edge[(i + 1) % s.sides][0];
    for (unsigned i = 0; i < s.sides; i++) {
        const unsigned next = (i + 1) % s.sides, last = (i + s.sides - 1) % s.sides;
        const loft_vec *e = s.edge[i];
        const int a0 = 32 + (int)arb_below(a, 64), b0 = (int)arb_below(a, 64) - 32,
                  a1 = 32 + (int)arb_below(a, 64), b1 = (int)arb_below(a, 64) - 32;
        for (unsigned k = 1; k < s.m; k++)
            s.across[i][k] = loft_vec_sub(arb_corner(a, s.sides, (i + s.sides / 2) % s.sides, 0.5L),
                                          e[k]);
        s.across[i][0] = blend(loft_vec_sub(s.edge[last][s.m - 1], s.edge[last][s.m]),
                               loft_vec_sub(e[1], e[0]), a0, b0);
        s.across[i][s.m] = blend(loft_vec_sub(s.edge[next][1], s.edge[next][0]),
                                 loft_vec_sub(e[s.m], e[s.m - 1]), a1, b1);
        CHECK(loft_bezier_init(&s.side[i].edge, e, s.m) == LOFT_OK &&
              loft_bezier_init(&s.side[i].across, s.across[i], s.m) == LOFT_OK);
    }
    CHECK(loft_gb_from_hole(s.side, s.sides, s.degree, s.net, s.split, &s.gap) == LOFT_OK &&
          loft_gb_init_split(&s.g, s.net, s.split, s.sides, s.degree) == LOFT_OK);
    return &s;
}

static void cross_of(const long double a[3], const long double b[3], long double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static long double sine_of(const long double a[3], const long double b[3])
{
    long double c[3], aa = 0, bb = 0, cc = 0;

    cross_of(a, b, c);
    for (int i = 0; i < 3; i++) {
        aa += a[i] * a[i];
        bb += b[i] * b[i];
        cc += c[i] * c[i];
    }
    return sqrtl(cc / (aa * bb));
}

static long double curve_at(const loft_vec p[], unsigned n, unsigned order, long double t, int axis)
{
    long double c[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= n; k++)
        c[k] = exact_of(p[k].axis[axis]);
    return exact_deriv(c, n, order, t);
}

/* Along each side the normal of the patch is that of the neighbour. */
static void it_has_the_tangent_planes_of_its_neighbours(arb *a)
{
    const sample *s = arb_hole(a);
    arb_domain p = { .n = s->sides };

    for (unsigned i = 0; i < s->sides; i++)
        p.v[i] = spot_raw(lround(65536 * cos(6.2831853 * i / s->sides)),
                          lround(65536 * sin(6.2831853 * i / s->sides)));
    CHECK(loft_domain_init(&p.d, p.v, p.n) == LOFT_OK);
    for (unsigned i = 0; i < s->sides; i++) {
        loft_sci share = loft_sci_div(loft_sci_from_int(1 + (int32_t)arb_below(a, 1023)),
                                      loft_sci_from_int(1024));
        loft_jet phi[LOFT_SIDES_MAX];
        loft_differential d;
        long double u[3], v[3], mine[3], e[3], n[3], theirs[3], t;
        loft_spot q;
        const loft_spot *from = &p.v[i], *to = &p.v[(i + 1) % s->sides];
        t = exact_sci(share);
        for (int k = 0; k < 2; k++)
            q.at[k] = LOFT_REAL(
                (double)(exact_of(from->at[k]) * (1 - t) + exact_of(to->at[k]) * t));
        for (int k = 0; k < 2; k++)     /* a little inside, for rounding */
            q.at[k] = LOFT_REAL(
                (double)(exact_of(q.at[k]) * (1 - BY_NUM(0x1p-15, 0x1p-20, 0x1p-40))));
        CHECK(loft_wachspress_jet(&p.d, q, phi) == LOFT_OK);
        CHECK(loft_gb_differential(&s->g, phi, &d) == LOFT_OK);
        t = exact_sci(phi[(i + 1) % s->sides].f) /
            (exact_sci(phi[i].f) + exact_sci(phi[(i + 1) % s->sides].f));
        for (int k = 0; k < 3; k++) {
            u[k] = exact_sci(d.u[k]);
            v[k] = exact_sci(d.v[k]);
            e[k] = curve_at(s->edge[i], s->m, 1, t, k);
            n[k] = curve_at(s->across[i], s->m, 0, t, k);
        }
        cross_of(u, v, mine);
        cross_of(e, n, theirs);
        if (sine_of(e, n) > 0.1L && sine_of(u, v) > 0.02L)
            CHECK_NEAR(sine_of(mine, theirs), 0, BY_NUM(0.02, 1e-3, 1e-9));
    }
}

static void it_has_the_edges(arb *a)
{
    const sample *s = arb_hole(a);

    for (unsigned i = 0; i < s->sides; i++) {
        const uint32_t j = arb_below(a, 1025);
        loft_sci phi[LOFT_SIDES_MAX];
        loft_vec got = { { 0 } };
        for (unsigned k = 0; k < s->sides; k++)
            phi[k] = loft_sci_zero();
        phi[(i + 1) % s->sides] = loft_sci_div(loft_sci_from_int((int32_t)j),
                                               loft_sci_from_int(1024));
        phi[i] = loft_sci_sub(loft_sci_one(), phi[(i + 1) % s->sides]);
        CHECK(loft_gb_eval(&s->g, phi, &got) == LOFT_OK);
        for (int k = 0; k < 3; k++)
            CHECK_EXACT(exact_of(got.axis[k]), curve_at(s->edge[i], s->m, 0, j / 1024.0L, k),
                        BY_NUM(1.1L * LSB, 2 * ulp(128), 64 * ulp(128)));
    }
    CHECK_EXACT(exact_acc(s->gap), 0, BY_NUM(1e-3L, 1e-4L, 1e-12L));
}

/* With both points of a corner in one it is the patch of the net alone. */
static void a_split_in_one_point_is_none(arb *a)
{
    sample *s = arb_hole(a);
    loft_gb plain;
    loft_sci phi[LOFT_SIDES_MAX], left = loft_sci_one();

    for (unsigned i = 0; i < s->sides; i++)
        s->split[i] = s->net[loft_gb_place(s->sides, s->degree, i, 1, 1)];
    CHECK(loft_gb_init(&plain, s->net, s->sides, s->degree) == LOFT_OK);
    for (unsigned i = 0; i < s->sides; i++) {
        phi[i] = i + 1 < s->sides
                     ? loft_sci_mul(left,
                                    loft_sci_div(loft_sci_from_int(1 + (int32_t)arb_below(a, 1000)),
                                                 loft_sci_from_int(1024)))
                     : left;
        left = loft_sci_sub(left, phi[i]);
    }
    loft_vec x = { { 0 } }, y = { { 0 } };
    CHECK(loft_gb_eval(&s->g, phi, &x) == LOFT_OK && loft_gb_eval(&plain, phi, &y) == LOFT_OK);
    for (int k = 0; k < 3; k++)
        CHECK_EXACT(exact_of(x.axis[k]), exact_of(y.axis[k]), 16 * ulp(128));
}

static void mistakes_are_refused(arb *a)
{
    sample *s = arb_hole(a);
    loft_vec kept = s->edge[0][0];
    const unsigned n = s->sides, d = s->degree;

    CHECK(loft_gb_from_hole(s->side, 2, d, s->net, s->split, &s->gap) == LOFT_ERR_ARG &&
          loft_gb_from_hole(s->side, 9, d, s->net, s->split, &s->gap) == LOFT_ERR_ARG &&
          loft_gb_from_hole(s->side, n, s->m, s->net, s->split, &s->gap) == LOFT_ERR_ARG &&
          loft_gb_from_hole(s->side, n, 10, s->net, s->split, &s->gap) == LOFT_ERR_ARG);
    s->edge[0][0].axis[1] += LOFT_REAL(1);
    CHECK(loft_gb_from_hole(s->side, n, d, s->net, s->split, &s->gap) == LOFT_ERR_ARG);
    s->edge[0][0] = kept;
    s->across[1][0] = loft_vec_sub(s->edge[1][1], s->edge[1][0]);      /* along the edge */
    CHECK(loft_gb_from_hole(s->side, n, d, s->net, s->split, &s->gap) == LOFT_SINGULAR);
    s->across[1][0] = loft_vec_sub(s->edge[0][s->m], s->edge[0][s->m - 1]);    /* out of the hole */
    CHECK(loft_gb_from_hole(s->side, n, d, s->net, s->split, &s->gap) == LOFT_SINGULAR);
}

int main(void)
{
    PROPERTY(it_has_the_tangent_planes_of_its_neighbours, 500);
    PROPERTY(it_has_the_edges,                            500);
    PROPERTY(a_split_in_one_point_is_none,                300);
    PROPERTY(mistakes_are_refused,                         50);
    return check_failures();
}

#else
int main(void) { return 0; }
#endif
