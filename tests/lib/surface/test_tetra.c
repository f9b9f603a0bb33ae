/* tests/lib/surface/test_tetra.c -- properties of lib/surface/tetra.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* exact_whole.h, factorial, by_kind */
#include "surface/tetra.h"
#include "surface/triangle/triangle.h"

static loft_volume arb_volume(arb *a)
{
    const uint32_t n = (uint32_t)1 << arb_below(a, 24), j = arb_below(a, n + 1),
                   k = arb_below(a, n - j + 1), l = arb_below(a, n - j - k + 1);
    return (loft_volume) { loft_unit_of(j, n), loft_unit_of(k, n), loft_unit_of(l, n) };
}

static void exact_volume(loft_volume u, long double x[4])
{
    x[1] = exact_unit(u.v);
    x[2] = exact_unit(u.w);
    x[3] = exact_unit(u.x);
    x[0] = 1 - x[1] - x[2] - x[3];
}

static long double weight(const unsigned index[4], const long double x[4])
{
    long double w = factorial(index[0] + index[1] + index[2] + index[3]);
    for (int e = 0; e < 4; e++)
        w *= powl(x[e], index[e]) / factorial(index[e]);
    return w;
}

/* The value of the k-th axis of a net of degree n: the sum of all points times weights. */
static long double value(const loft_vec p[], unsigned n, int axis, const long double x[4])
{
    long double sum = 0;

    for (unsigned m = 0, q = 0; m <= n; m++)
        for (unsigned r = 0; r <= m; r++)
            for (unsigned l = 0; l <= r; l++, q++)
                sum += exact_of(p[q].axis[axis]) *
                       weight((unsigned[4]){ n - m, m - r, r - l, l }, x);
    return sum;
}

typedef struct {
    loft_vec p[LOFT_TETRA_MAX];
    unsigned n;
    loft_tetra t;
    long double largest;
} block;

static block *arb_block(arb *a, unsigned most)
{
    static block b;
    const loft_real high = BY_NUM(INT32_MAX, 32767, 32767), low = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8);
    const int32_t limit = 32767 >> arb_below(a, 15);

    b.n = arb_below(a, most + 1);
    b.largest = 0;
    for (unsigned k = 0; k < LOFT_TETRA_POINTS(b.n); k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            b.p[k].axis[i] = kind == 0   ? (k & 1 ? high : low)
                             : kind == 1 ? (arb_below(a, 2) ? high : low)
                                         : arb_real(a, limit > 0 ? limit : 1);
            b.largest = fmaxl(b.largest, fabsl(exact_of(b.p[k].axis[i])));
        }
    CHECK(loft_tetra_init(&b.t, b.p, b.n) == LOFT_OK);
    return &b;
}

static void weights_are_within_their_bound_and_sum_to_one(arb *a)
{
    const unsigned n = arb_below(a, LOFT_DEGREE_MAX + 1);
    const loft_volume u = arb_volume(a);
    loft_acc w[LOFT_TETRA_MAX];
    long double x[4], sum = 0;

    exact_volume(u, x);
    loft_volume_weights(n, u, w);
    for (unsigned m = 0, q = 0; m <= n; m++)
        for (unsigned r = 0; r <= m; r++)
            for (unsigned l = 0; l <= r; l++, q++) {
                CHECK(loft_tetra_place(m - r, r - l, l) == q);
                CHECK_EXACT(exact_acc(w[q]), weight((unsigned[4]){ n - m, m - r, r - l, l }, x),
                            by_kind(3 * n * 0x1p-32L, 8 * n * 0x1p-52L) + 0x1p-60L);
                sum += exact_acc(w[q]);
            }
    CHECK_EXACT(sum, 1, by_kind(0, n * 0x1p-49L));
}

static void a_point_is_within_its_bound(arb *a)
{
    const block *b = arb_block(a, LOFT_DEGREE_MAX);
    const loft_volume u = arb_volume(a);
    const loft_vec v = loft_tetra_eval(&b->t, u);
    long double x[4];

    exact_volume(u, x);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = value(b->p, b->n, i, x);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    by_kind(LSB / 2 + b->n * LSB / 65536 + 0x1p-40L,
                            ulp(want) / 2 + (6 * b->n + 1) * ulp_double(b->largest)));
    }
}

/* The face opposite T1 is a triangle: the last layer of the net. */
static void faces_are_triangles(arb *a)
{
    const block *b = arb_block(a, LOFT_DEGREE_MAX);
    const loft_bary u = arb_bary(a);
    const loft_volume x = { LOFT_UNIT(1) - u.v - u.w, u.v, u.w };
    loft_triangle t;

    CHECK(loft_triangle_init(&t, b->p + loft_tetra_place(b->n, 0, 0), b->n) == LOFT_OK);
    const loft_vec v = loft_tetra_eval(&b->t, x), w = loft_triangle_eval(&t, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(w.axis[i]),
                    BY_NUM(LSB, 2 * ulp(b->largest), 12 * (b->n + 1) * ulp(b->largest)));
}

static void beyond_is_clamped_and_corners_are_exact(arb *a)
{
    const block *b = arb_block(a, 5);
    const loft_volume corner[4] = {
        { 0, 0, 0 }, { LOFT_UNIT(1), 0, 0 }, { 0, LOFT_UNIT(1), 0 }, { 0, 0, LOFT_UNIT(1) }
    };
    const unsigned at[4] = { 0, loft_tetra_place(b->n, 0, 0), loft_tetra_place(0, b->n, 0),
                             loft_tetra_place(0, 0, b->n) };
    const loft_volume far = { LOFT_UNIT(0.5), LOFT_UNIT(7), LOFT_UNIT(-3) },
                      edge = { LOFT_UNIT(0.5), LOFT_UNIT(0.5), 0 };

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(loft_tetra_eval(&b->t, corner[k]).axis[i]),
                        exact_of(b->p[at[k]].axis[i]), BY_NUM(0, 0, 3 * b->n * ulp(b->largest)));
    CHECK(loft_vec_equal(loft_tetra_eval(&b->t, far), loft_tetra_eval(&b->t, edge)));
}

/* Repeated elevation by one gives the same control points; the value stays. */
static void a_raised_tetrahedron_is_within_its_bound(arb *a)
{
    static loft_vec out[LOFT_TETRA_POINTS(LOFT_ELEVATE_MAX)];
    static long double c[LOFT_TETRA_POINTS(LOFT_ELEVATE_MAX)],
        next[LOFT_TETRA_POINTS(LOFT_ELEVATE_MAX)];
    const block *b = arb_block(a, LOFT_DEGREE_MAX);
    const unsigned times = arb_below(a, 5);

    CHECK(loft_tetra_elevate(&b->t, times, out) == LOFT_OK &&
          loft_tetra_elevate(&b->t, LOFT_ELEVATE_MAX - b->n + 1, out) == LOFT_ERR_ARG);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k < LOFT_TETRA_POINTS(b->n); k++)
            c[k] = exact_of(b->p[k].axis[i]);
        for (unsigned n = b->n + 1; n <= b->n + times; n++) {
            for (unsigned m = 0, q = 0; m <= n; m++)
                for (unsigned r = 0; r <= m; r++)
                    for (unsigned l = 0; l <= r; l++, q++) {
                        const unsigned j = m - r, k = r - l;
                        next[q] = ((m < n ? (n - m) * c[q] : 0) +
                                   (j ? j * c[loft_tetra_place(j - 1, k, l)] : 0) +
                                   (k ? k * c[loft_tetra_place(j, k - 1, l)] : 0) +
                                   (l ? l * c[loft_tetra_place(j, k, l - 1)] : 0)) /
                                  n;
                    }
            for (unsigned q = 0; q < LOFT_TETRA_POINTS(n); q++)
                c[q] = next[q];
        }
        for (unsigned q = 0; q < LOFT_TETRA_POINTS(b->n + times); q++)
            CHECK_EXACT(exact_of(out[q].axis[i]), c[q],
                        by_kind(LSB / 2 + LSB / 131072 + 0x1p-40L,
                                ulp(c[q]) / 2 + (b->n * b->n + 3) * ulp_double(b->largest)));
    }
}

/* A point made of whole parts of the corners has these coordinates, where they are exact. */
static void coordinates_of_a_point_are_found_again(arb *a)
{
    loft_vec t[4] = { arb_vec(a, 1 << arb_below(a, 13)), arb_vec(a, 1 << arb_below(a, 13)),
                      arb_vec(a, 8000), arb_vec(a, 8000) },
             p;
    const int32_t part[4] = { 1 - 2, (int32_t)arb_below(a, 3) - 1, (int32_t)arb_below(a, 3) - 1,
                              0 };
    const int32_t last = 1 - part[0] - part[1] - part[2];
    loft_acc u[4];

    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = (loft_real)part[0] * t[0].axis[i] + (loft_real)part[1] * t[1].axis[i] +
                    (loft_real)part[2] * t[2].axis[i] + (loft_real)last * (t[3].axis[i] /= 4);
    if (BY_NUM(false, true, false))             /* a float may round the point to another one */
        for (int i = 0; i < LOFT_AXES; i++)
            if (fabsl(exact_of(p.axis[i]) - part[0] * exact_of(t[0].axis[i]) -
                      part[1] * exact_of(t[1].axis[i]) - part[2] * exact_of(t[2].axis[i]) -
                      last * exact_of(t[3].axis[i])) > 0)
                return;
    const enum loft_status status = loft_volume_from_point(t, p, u);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (int k = 0; k < 4 && status == LOFT_OK; k++)
        CHECK_EXACT(exact_acc(u[k]), k < 3 ? part[k] : last, 0);
    for (int k = 0; k < 4; k++)                 /* all in a plane */
        t[k].axis[2] = t[k].axis[0];
    CHECK(loft_volume_from_point(t, p, u) == LOFT_SINGULAR);
}

static void nonsense_is_refused(arb *a)
{
    block *b = arb_block(a, LOFT_DEGREE_MAX);
    loft_tetra t = { 0, 77 };

    CHECK(loft_tetra_init(&t, b->p, LOFT_DEGREE_MAX + 1) == LOFT_ERR_ARG);
    b->p[arb_below(a, LOFT_TETRA_POINTS(b->n))].axis[0] = (loft_real)BY_NUM(0, NAN, NAN);
    CHECK(BY_NUM(true, false, false) || loft_tetra_init(&t, b->p, b->n) == LOFT_ERR_RANGE);
    CHECK(t.degree == 77);
}

int main(void)
{
    PROPERTY(weights_are_within_their_bound_and_sum_to_one, 400);
    PROPERTY(a_point_is_within_its_bound,                   600);
    PROPERTY(faces_are_triangles,                           400);
    PROPERTY(beyond_is_clamped_and_corners_are_exact,       200);
    PROPERTY(a_raised_tetrahedron_is_within_its_bound,       60);
    PROPERTY(coordinates_of_a_point_are_found_again,        600);
    PROPERTY(nonsense_is_refused,                            50);
    return check_failures();
}
