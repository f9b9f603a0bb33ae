/* tests/lib/polygon/test_gb.c -- properties of lib/polygon/gb.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_quad.h"             /* quad_point */
#include "support/arb_patch.h"              /* arb_net */
#include "curve/bezier.h"
#include "polygon/meanvalue.h"
#include "polygon/wachspress.h"
#include "surface/tensor/tensor.h"

static net points, other, halves;

static loft_gb arb_plain_gb(arb *a, unsigned sides, unsigned degree)
{
    loft_gb g = { 0 };

    arb_net(a, &points, loft_gb_count(sides, degree));
    CHECK(loft_gb_init(&g, points.p, sides, degree) == LOFT_OK);
    return g;
}

/* With split corners or without. */
static loft_gb arb_gb(arb *a, unsigned sides, unsigned degree)
{
    loft_gb g = arb_plain_gb(a, sides, degree);

    if (arb_below(a, 2))
        return g;
    arb_net(a, &halves, sides);
    points.largest = fmaxl(points.largest, halves.largest);
    CHECK(loft_gb_init_split(&g, points.p, halves.p, sides, degree) == LOFT_OK);
    return g;
}

static unsigned arb_degree(arb *a) { return 3 + arb_below(a, LOFT_DEGREE_MAX - 2); }

/* Coordinates >= 0 that sum to 1, not of a particular polygon, some of them small and neighbours
 * 0. */
static void arb_phi(arb *a, unsigned n, loft_sci phi[])
{
    const unsigned start = arb_below(a, n);
    int32_t left = 1 << 20;

    for (unsigned i = 0; i < n; i++) {
        const int32_t part = i + 1 < n ? (int32_t)arb_below(a, (uint32_t)left + 1) >>
                                             arb_below(a, 3) * arb_below(a, 12)
                                       : left;
        left -= part;
        phi[(start + i) % n] = loft_sci_div(loft_sci_from_int(part), loft_sci_from_int(1 << 20));
    }
}

static void quad_phi(const loft_sci phi[], unsigned n, quad out[])
{
    for (unsigned i = 0; i < n; i++)
        out[i] = exact_sci(phi[i]);
}

static bool on_side(unsigned n, const loft_sci phi[])
{
    unsigned some = 0;

    for (unsigned i = 0; i < n; i++)
        some += loft_sci_sign(phi[i]) != 0;
    for (unsigned i = 0; i < n; i++)
        if (some <= 2 && loft_sci_sign(phi[i]) && (some == 1 || loft_sci_sign(phi[(i + 1) % n])))
            return true;
    return false;
}

static loft_spot arb_inner(arb *a, const arb_domain *p)
{
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index;

    for (int k = 0; k < 50; k++) {
        const loft_spot q = arb_near(a, p);
        if (loft_domain_place(&p->d, q, area, &index) != LOFT_OUTSIDE)
            return q;
    }
    return p->v[0];
}


/* Nets */

static void every_point_of_the_ribbons_has_one_place(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), layers = (d + 1) / 2,
                   count = loft_gb_count(n, d);
    unsigned used[201] = { 0 }, held = 0;

    for (unsigned i = 0; i < n; i++)
        for (unsigned k = 0; k < layers; k++)
            for (unsigned j = 0; j <= d; j++) {
                const unsigned place = loft_gb_place(n, d, i, j, k);
                CHECK(place + 1 < count);
                held += used[place]++ == 0;
                if (j < layers)
                    CHECK(place == loft_gb_place(n, d, (i + n - 1) % n, d - k, j));
            }
    CHECK(held + 1 == count && count <= 201);
    if (n == 5 && d == 5)
        CHECK(count == 46);
}

static void other_sizes_and_numbers_are_refused(arb *a)
{
    loft_gb g;
    loft_vec v;

    arb_net(a, &points, 201);
    CHECK(loft_gb_init(&g, points.p, 2, 5) == LOFT_ERR_ARG &&
          loft_gb_init(&g, points.p, 9, 5) == LOFT_ERR_ARG);
    CHECK(loft_gb_init(&g, points.p, 5, 2) == LOFT_ERR_ARG &&
          loft_gb_init(&g, points.p, 5, 10) == LOFT_ERR_ARG);
    CHECK(loft_gb_middle(points.p, 5, 2, &v) == LOFT_ERR_ARG &&
          loft_gb_middle(points.p, 2, 5, &v) == LOFT_ERR_ARG &&
          loft_gb_middle(points.p, 9, 5, &v) == LOFT_ERR_ARG &&
          loft_gb_middle(points.p, 5, 10, &v) == LOFT_ERR_ARG);
    CHECK(loft_gb_from_boundary(points.p, 9, 3, other.p) == LOFT_ERR_ARG &&
          loft_gb_from_boundary(points.p, 2, 3, other.p) == LOFT_ERR_ARG &&
          loft_gb_from_boundary(points.p, 3, 2, other.p) == LOFT_ERR_ARG &&
          loft_gb_from_boundary(points.p, 3, 10, other.p) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    points.p[arb_below(a, 46)].axis[0] = (loft_real)NAN;
    CHECK(loft_gb_init(&g, points.p, 5, 5) == LOFT_ERR_RANGE);
#endif
}

/* The boundary is kept, and the middle agrees with its definition. */
static void a_net_from_curves_keeps_the_curves(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), layers = (d + 1) / 2;

    arb_net(a, &points, n * d);
    const enum loft_status status = loft_gb_from_boundary(points.p, n, d, other.p);
    CHECK(status == LOFT_OK ||
          (status == LOFT_ERR_RANGE && BY_NUM(points.largest > 4000, false, false)));
    for (unsigned i = 0; i < n && status == LOFT_OK; i++)
        for (unsigned j = 0; j <= d; j++)
            check_same(other.p[loft_gb_place(n, d, i, j, 0)], points.p[(i * d + j) % (n * d)]);
    for (int x = 0; x < LOFT_AXES && status == LOFT_OK; x++) {
        long double sum = 0;
        for (unsigned i = 0; i < n; i++)
            sum += exact_of(other.p[loft_gb_place(n, d, i, layers, layers - 1)].axis[x]);
        check_axis(other.p[loft_gb_count(n, d) - 1].axis[x], sum / n, points.largest * 8, 0x1p-17L,
                   16);
    }
}

/* d^2 V = d (..) of the four curves, minus the bilinear surface of the corners. */
static void four_curves_make_the_net_of_their_coons_patch(arb *a)
{
    const unsigned d = arb_degree(a);
    const long double m = d;

    arb_net(a, &points, 4 * d);
    if (loft_gb_from_boundary(points.p, 4, d, other.p) != LOFT_OK)
        return;
    for (unsigned k = 0; k < (d + 1) / 2; k++)
        for (unsigned j = 0; j <= d; j++)
            for (int x = 0; x < LOFT_AXES; x++) {
                const long double u = j / m, v = k / m;
                #define SIDE(i, at) exact_of(points.p[((i) * d + (at)) % (4 * d)].axis[x])
                const long double ruled = (1 - v) * SIDE(0, j) + v * SIDE(2, d - j) +
                                          (1 - u) * SIDE(3, d - k) + u * SIDE(1, k);
                const long double flat = (1 - u) * ((1 - v) * SIDE(0, 0) + v * SIDE(3, 0)) +
                                         u * ((1 - v) * SIDE(1, 0) + v * SIDE(2, 0));
#undef SIDE
                check_axis(other.p[loft_gb_place(4, d, 0, j, k)].axis[x], ruled - flat,
                           points.largest, 0x1p-17L, 64);
            }
}


/* Weights and points */

static void parameters_are_those_of_the_definition(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6);
    loft_gb_side side[LOFT_SIDES_MAX];
    loft_sci phi[LOFT_SIDES_MAX];
    const long double off = BY_NUM(0x1p-58L, 0x1p-50L, 0x1p-50L);

    arb_phi(a, n, phi);
    CHECK(loft_gb_params(n, phi, side) == LOFT_OK);
    for (unsigned i = 0; i < n; i++) {
        const long double p = exact_sci(phi[i]), q = exact_sci(phi[(i + 1) % n]);
        long double rest = 0;
        for (unsigned k = 2; k < n; k++)
            rest += exact_sci(phi[(i + k) % n]);
        CHECK(side[i].any == (p + q == 0));     /* NOLINT: exact */
        if (side[i].any)
            continue;
        CHECK_EXACT(exact_sci(side[i].s), q / (p + q), off * q / (p + q));
        CHECK_EXACT(exact_sci(side[i].before_s), p / (p + q), off * p / (p + q));
        CHECK_EXACT(exact_sci(side[i].h), rest, off * rest);
        CHECK_EXACT(exact_sci(side[i].below_h), p + q, off * (p + q));
    }
}

static void weights_are_those_of_the_definition(arb *a)
{
    static loft_sci w[201];
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), count = loft_gb_count(n, d);
    loft_sci phi[LOFT_SIDES_MAX];
    quad exact[LOFT_SIDES_MAX], want[201];
    long double sum = 0;

    arb_phi(a, n, phi);
    quad_phi(phi, n, exact);
    quad_weights(n, d, exact, want, NULL);
    CHECK(loft_gb_weights(n, d, phi, w) == LOFT_OK);
    for (unsigned k = 0; k < count; k++) {
        CHECK_EXACT(exact_sci(w[k]), (long double)want[k], BY_NUM(0x1p-52L, 0x1p-44L, 0x1p-44L));
        CHECK(k + 1 == count || loft_sci_sign(w[k]) >= 0);
        sum += exact_sci(w[k]);
    }
    CHECK_EXACT(sum, 1, BY_NUM(0x1p-55L, 0x1p-47L, 0x1p-47L));
}

/* -1/9, -2/9, -.432, -.478 for degrees 3 to 6; five sides .12, .384, .2864, .4396. */
static void the_middle_is_negative_with_three_sides_only(arb *a)
{
    static const long double three[4] = { -1 / 9.0L, -2 / 9.0L, -0.432L, -0.478L },
                             five[4] = { 0.12L, 0.384L, 0.2864L, 0.4396L };
    static loft_sci w[201];
    loft_sci phi[LOFT_SIDES_MAX];

    for (unsigned n = 3; n <= 5; n++)
        for (unsigned d = 3; d <= 6; d++) {
            for (unsigned i = 0; i < n; i++)
                phi[i] = loft_sci_div(loft_sci_one(), loft_sci_from_int((int32_t)n));
            CHECK(loft_gb_weights(n, d, phi, w) == LOFT_OK);
            const long double middle = exact_sci(w[loft_gb_count(n, d) - 1]);
            if (n == 3)
                CHECK_EXACT(middle, three[d - 3], 0.0005L);
            else if (n == 5)
                CHECK_EXACT(middle, five[d - 3], 0.0005L);
            else
                CHECK_EXACT(middle, d % 2 ? 0 : d == 4 ? 36 / 256.0L : 400 / 4096.0L, 1e-14L);
        }
    (void)a;
}

static void points_are_within_the_bound(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6);
    const loft_gb g = arb_gb(a, n, arb_degree(a));
    loft_sci phi[LOFT_SIDES_MAX];
    quad exact[LOFT_SIDES_MAX], want[LOFT_AXES];
    loft_vec v = { { 0 } };
    bool fits = true, near = false;

    arb_phi(a, n, phi);
    quad_phi(phi, n, exact);
    quad_point(&g, exact, want);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double size = fabsl((long double)want[i]);
        fits = fits && BY_NUM(size < 32768 - 0x1p-17L, true, true);
        near = near || fabsl(size - 32768) < 0x1p-15L;
    }
    const enum loft_status status = loft_gb_eval(&g, phi, &v);
    CHECK(near || status == (fits ? LOFT_OK : LOFT_ERR_RANGE));
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++)
        check_axis(v.axis[i], (long double)want[i], points.largest,
                   on_side(n, phi) ? 0x1p-9L : 0x1p-12L, 512);
}

/* Bit for bit where a parameter holds the place on the edge; within 1 ulp elsewhere. */
static void sides_are_bezier_curves(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), i = arb_below(a, n);
    const loft_gb g = arb_gb(a, n, d);
    const uint32_t j = arb_below(a, 4) ? arb_below(a, (1u << 20) + 1) : arb_below(a, 2) << 20;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec curve[LOFT_DEGREE_MAX + 1], v = { { 0 } };
    loft_bezier b;

    for (unsigned k = 0; k < n; k++)
        phi[k] = loft_sci_zero();
    phi[i] = loft_sci_div(loft_sci_from_int((1 << 20) - (int32_t)j), loft_sci_from_int(1 << 20));
    phi[(i + 1) % n] = loft_sci_div(loft_sci_from_int((int32_t)j), loft_sci_from_int(1 << 20));
    for (unsigned k = 0; k <= d; k++)
        curve[k] = points.p[loft_gb_place(n, d, i, k, 0)];
    CHECK(loft_bezier_init(&b, curve, d) == LOFT_OK && loft_gb_eval(&g, phi, &v) == LOFT_OK);
    check_same(v, loft_bezier_eval(&b, loft_unit_of(j, 1u << 20)));
}

static void corners_are_control_points(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), i = arb_below(a, n);
    const loft_gb g = arb_gb(a, n, d);
    arb_domain p = arb_simple(a);
    loft_sci phi[LOFT_SIDES_MAX] = { 0 };
    loft_vec v = { { 0 } };

    settle(&p);
    if (p.n != n)
        return;
    CHECK(loft_meanvalue_eval(&p.d, p.v[i], phi) == LOFT_OK &&
          loft_gb_eval(&g, phi, &v) == LOFT_OK);
    check_same(v, points.p[loft_gb_place(n, d, i, 0, 0)]);
}

/* x' = 2 x + y + 1 and so on: the mapped net has the mapped point. */
static void affine_maps_of_the_net_map_the_patch(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_degree(a), count = loft_gb_count(n, d);
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec u = { { 0 } }, v = { { 0 } };
    loft_gb g, mapped;

    arb_net(a, &points, count);
    for (unsigned k = 0; k < count; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            points.p[k].axis[i] = loft_real_from_raw((int32_t)arb_below(a, 1u << 22));
        for (int i = 0; i < LOFT_AXES; i++)
            if (i > 0)
                other.p[k].axis[i] = points.p[k].axis[i - 1] - 2 * points.p[k].axis[i];
            else
                other.p[k].axis[0] = 2 * points.p[k].axis[0] + points.p[k].axis[LOFT_AXES - 1] +
                                     LOFT_REAL(1);
    }
    arb_phi(a, n, phi);
    CHECK(loft_gb_init(&g, points.p, n, d) == LOFT_OK &&
          loft_gb_init(&mapped, other.p, n, d) == LOFT_OK);
    CHECK(loft_gb_eval(&g, phi, &u) == LOFT_OK && loft_gb_eval(&mapped, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double x = exact_of(u.axis[i]), last = exact_of(u.axis[LOFT_AXES - 1]);
        const long double there = i > 0 ? exact_of(u.axis[i - 1]) - 2 * x : 2 * x + last + 1;
        CHECK_EXACT(exact_of(v.axis[i]), there, BY_NUM(2.02L * LSB, 0x1p-15L, 0x1p-36L));
    }
}

/* The unit square, u along its first edge: the points of the net are those of a tensor product. */
static void over_a_square_it_is_the_tensor_product(arb *a)
{
    static loft_vec p[(LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1)];
    const unsigned d = arb_degree(a), layers = (d + 1) / 2, x = arb_below(a, 257),
                   y = arb_below(a, 257);
    const loft_gb g = arb_plain_gb(a, 4, d);
    arb_domain s = { .n = 4,
                     .v = { spot_raw(0, 0), spot_raw(65536, 0), spot_raw(65536, 65536),
                            spot_raw(0, 65536) } };
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } };
    loft_tensor t;

    for (unsigned j = 0; j <= d; j++)
        for (unsigned k = 0; k <= d; k++)
            p[j * (d + 1) + k] = points.p[k < layers       ? loft_gb_place(4, d, 0, j, k)
                                          : d - k < layers ? loft_gb_place(4, d, 2, d - j, d - k)
                                          : j < layers     ? loft_gb_place(4, d, 3, d - k, j)
                                          : d - j < layers ? loft_gb_place(4, d, 1, k, d - j)
                                                           : loft_gb_count(4, d) - 1];
    CHECK(loft_domain_init(&s.d, s.v, 4) == LOFT_OK && loft_tensor_init(&t, p, d, d) == LOFT_OK);
    CHECK(loft_wachspress_eval(&s.d, spot_raw(256 * x, 256 * y), phi) == LOFT_OK &&
          loft_gb_eval(&g, phi, &v) == LOFT_OK);
    const loft_vec want = loft_tensor_eval(&t, loft_unit_of(x, 256), loft_unit_of(y, 256));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(want.axis[i]),
                    BY_NUM(1.25L * LSB, points.largest * 0x1p-23L, points.largest * 0x1p-43L));
}


/* Derivatives */

/* The largest first and second derivative of a coordinate. */
static void slopes_of(const loft_jet phi[], unsigned n, long double *first, long double *second)
{
    *first = *second = 0;
    for (unsigned k = 0; k < n; k++) {
        *first = fmaxl(*first, fmaxl(fabsl(exact_sci(phi[k].x)), fabsl(exact_sci(phi[k].y))));
        *second = fmaxl(*second,
                        fmaxl(fabsl(exact_sci(phi[k].xx)),
                              fmaxl(fabsl(exact_sci(phi[k].xy)), fabsl(exact_sci(phi[k].yy)))));
    }
}

/* `rough`, over a longer step, gives the error of the differences. */
static void derivatives_are_limits_of_differences(arb *a)
{
    const bool mean = arb_below(a, 2);
    arb_domain p = arb_convex(a);
    const loft_spot q = (settle(&p), arb_inner(a, &p));
    const loft_gb g = arb_gb(a, p.n, arb_degree(a));
    const quad_surface s = { &g, &p, mean };
    const quad near = quad_scale(&p, quad_of(q), true);
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here;
    quad want[LOFT_AXES][5], rough[LOFT_AXES][5];
    long double first, second;

    CHECK((mean ? loft_meanvalue_jet(&p.d, q, phi) : loft_wachspress_jet(&p.d, q, phi)) ==
          (mean && !(near > 0) ? LOFT_SINGULAR : LOFT_OK));
    if (mean && !(near > 0))
        return;
    CHECK(loft_gb_differential(&g, phi, &here) == (near > 0 ? LOFT_OK : LOFT_SINGULAR));
    if (!(near > 0))
        return;
    slopes_of(phi, p.n, &first, &second);
    const quad step = quad_less(near, 1 / first) * 1e-7L;
    quad_differences(quad_surface_at, &s, LOFT_AXES, quad_of(q), 4 * step, rough);
    quad_differences(quad_surface_at, &s, LOFT_AXES, quad_of(q), step, want);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci got[5] = { here.u[i], here.v[i], here.uu[i], here.uv[i], here.vv[i] };
        for (int k = 0; k < 5; k++) {
            const long double d = g.degree,
                              size = points.largest *
                                     (k < 2 ? d * first : d * d * first * first + d * second);
            const long double own = 16 * (long double)quad_size(want[i][k] - rough[i][k]);
            CHECK_EXACT(exact_sci(got[k]), (long double)want[i][k],
                        own + size * BY_NUM(0x1p-44L, 0x1p-36L, 0x1p-36L));
        }
    }
}

/* The point of ribbon i, of a split corner its own. */
static const loft_vec *row_point(const loft_gb *g, unsigned i, unsigned j, unsigned k)
{
    return g->split && k == 1 && j == g->degree - 1u
               ? &g->split[(i + 1) % g->sides]
               : &g->p[loft_gb_place(g->sides, g->degree, i, j, k)];
}

/* On side i, at h_i = 0: S_s is that of the curve, and S_h = d sum B_j(s) (V_j1 - V_j0). */
static void across_a_side_two_rows_count(arb *a)
{
    const bool mean = arb_below(a, 2);
    arb_domain p = arb_convex(a);
    const unsigned d = (settle(&p), arb_degree(a)), i = arb_below(a, p.n);
    const loft_spot q = arb_on_edge(a, &p, i);
    const loft_gb g = arb_gb(a, p.n, d);
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here;
    long double first, second;

    if (!(quad_scale(&p, quad_of(q), true) > 0))
        return;
    CHECK((mean ? loft_meanvalue_jet(&p.d, q, phi) : loft_wachspress_jet(&p.d, q, phi)) ==
              LOFT_OK &&
          loft_gb_differential(&g, phi, &here) == LOFT_OK);
    slopes_of(phi, p.n, &first, &second);
    const loft_jet *one = &phi[i], *two = &phi[(i + 1) % p.n];
    for (int along = 0; along < 2; along++) {
        const quad b = exact_sci(two->f), f = exact_sci(one->f),
                   b_x = exact_sci(along ? two->y : two->x),
                   f_x = exact_sci(along ? one->y : one->x);
        const quad s_x = (b_x * f - b * f_x) / ((f + b) * (f + b)), h_x = -(b_x + f_x);
        quad w[LOFT_DEGREE_MAX + 1], lower[LOFT_DEGREE_MAX + 1];
        quad_bernstein(w, d, b, f);
        quad_bernstein(lower, d - 1, b, f);
        for (int x = 0; x < LOFT_AXES; x++) {
            #define V(j, k) (quad)exact_of(row_point(&g, i, j, k)->axis[x])
            quad sum = 0;
            for (unsigned j = 0; j <= d; j++)
                sum += d * w[j] * (V(j, 1) - V(j, 0)) * h_x +
                       (j < d ? d * lower[j] * (V(j + 1, 0) - V(j, 0)) * s_x : 0);
#undef V
            CHECK_EXACT(exact_sci(along ? here.v[x] : here.u[x]), (long double)sum,
                        points.largest * d * first * BY_NUM(0x1p-44L, 0x1p-36L, 0x1p-36L));
        }
    }
}

#if LOFT_AXES >= 3

/* A polygon near the regular one, and a curved net near that polygon. */
static loft_gb arb_bent(arb *a, arb_domain *p)
{
    const unsigned n = p->n = 3 + arb_below(a, 6), d = arb_degree(a);
    loft_gb g = { 0 };

    for (unsigned i = 0; i < n; i++)
        p->v[i] = spot_raw(lround(60000 * cos(6.2831853 * i / n)) + (int)arb_below(a, 2000),
                           lround(60000 * sin(6.2831853 * i / n)) + (int)arb_below(a, 2000));
    CHECK(loft_domain_init(&p->d, p->v, n) == LOFT_OK && p->d.convex);
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < d; j++)
            for (int x = 0; x < LOFT_AXES; x++) {
                const long double from = x < 2 ? exact_of(p->v[i].at[x]) : 0,
                                  to = x < 2 ? exact_of(p->v[(i + 1) % n].at[x]) : 0;
                const long double at = from + (to - from) * j / d +
                                       (arb_below(a, 1001) - 500.0L) / 10000;
                other.p[i * d + j].axis[x] = loft_real_from_raw((int32_t)lroundl(65536 * at));
            }
    CHECK(loft_gb_from_boundary(other.p, n, d, points.p) == LOFT_OK &&
          loft_gb_init(&g, points.p, n, d) == LOFT_OK);
    return g;
}

static void curvature_is_right_to_nine_digits(arb *a)
{
    arb_domain p;
    const loft_gb g = arb_bent(a, &p);
    const loft_spot q = (settle(&p), spot_raw((int)arb_below(a, 40000) - 20000,
                                              (int)arb_below(a, 40000) - 20000));
    const quad_surface s = { &g, &p, arb_below(a, 2) };
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here;
    loft_curvatures k;
    quad want[LOFT_AXES][5];

    if ((s.mean ? loft_meanvalue_jet(&p.d, q, phi) : loft_wachspress_jet(&p.d, q, phi)) != LOFT_OK)
        return;
    CHECK(loft_gb_differential(&g, phi, &here) == LOFT_OK &&
          loft_differential_curvatures(&here, &k) == LOFT_OK);
    quad_differences(quad_surface_at, &s, LOFT_AXES, quad_of(q), 1e-7L, want);
    const long double gauss = (long double)quad_gauss(want);
    CHECK_EXACT(exact_acc(k.gauss), gauss,
                fmaxl(1, fabsl(gauss)) * BY_NUM(0x1p-31L, 1e-10L, 1e-10L));
}

#else
static void curvature_is_right_to_nine_digits(arb *a) { (void)a; }
#endif

int main(void)
{
    PROPERTY(every_point_of_the_ribbons_has_one_place, 200);
    PROPERTY(other_sizes_and_numbers_are_refused, 5);
    PROPERTY(a_net_from_curves_keeps_the_curves, 300);
    PROPERTY(four_curves_make_the_net_of_their_coons_patch, 100);
    PROPERTY(parameters_are_those_of_the_definition, 2000);
    PROPERTY(weights_are_those_of_the_definition, 200);
    PROPERTY(the_middle_is_negative_with_three_sides_only, 1);
    PROPERTY(points_are_within_the_bound, 300);
    PROPERTY(sides_are_bezier_curves, 500);
    PROPERTY(corners_are_control_points, 300);
    PROPERTY(affine_maps_of_the_net_map_the_patch, 200);
    PROPERTY(over_a_square_it_is_the_tensor_product, 300);
    PROPERTY(derivatives_are_limits_of_differences, 200);
    PROPERTY(across_a_side_two_rows_count, 200);
    PROPERTY(curvature_is_right_to_nine_digits, 100);
    return check_failures();
}
