/* tests/lib/surface/tensor/test_volume.c -- properties of lib/surface/tensor/volume.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/volume.h"

#if LOFT_AXES < 3
#  error "volumes need space"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_vec p[6][MOST * MOST];
    loft_tensor s[6];
} box;

/* Which coordinate is fixed, at which side, and which two run along u and v: outward. */
static const int side[6][4] = { { 0, 1, 1, 2 }, { 0, 0, 2, 1 }, { 1, 1, 2, 0 },
                                { 1, 0, 0, 2 }, { 2, 1, 0, 1 }, { 2, 0, 1, 0 } };

/* size k / n */
static loft_real part_of(int32_t size, unsigned k, unsigned n)
{
    return loft_acc_round(
        loft_acc_ratio(loft_to_acc(loft_real_from_int(size * (int32_t)k)), (int32_t)n));
}

/* The six sides of a box whose inside nets of degrees m, n are moved within their plane. */
static box *arb_box(arb *a, const int32_t from[3], const int32_t size[3])
{
    static box b;

    for (int f = 0; f < 6; f++) {
        const unsigned m = 1 + arb_below(a, 4), n = 1 + arb_below(a, 4);
        for (unsigned i = 0; i <= m; i++)
            for (unsigned j = 0; j <= n; j++) {
                loft_vec *p = &b.p[f][i * (n + 1) + j];
                const int fixed = side[f][0], u = side[f][2], v = side[f][3];
                *p = (loft_vec) { { 0 } };
                p->axis[fixed] = loft_real_from_int(from[fixed] + (side[f][1] ? size[fixed] : 0));
                p->axis[u] = loft_real_from_int(from[u]) + part_of(size[u], i, m);
                p->axis[v] = loft_real_from_int(from[v]) + part_of(size[v], j, n);
                if (i > 0 && i < m && j > 0 && j < n) {
                    p->axis[u] += arb_real(a, 1);
                    p->axis[v] += arb_real(a, 1);
                }
            }
        CHECK(loft_tensor_init(&b.s[f], b.p[f], m, n) == LOFT_OK);
    }
    return &b;
}

static void boxes_have_their_volume(arb *a)
{
    int32_t from[3], size[3];
    long double volume = 1, most = 0;
    loft_acc got = 0;

    for (int i = 0; i < 3; i++) {
        from[i] = (int32_t)arb_below(a, 200) - 100;
        size[i] = 1 + (int32_t)arb_below(a, 40);
        volume *= size[i];
        most = fmaxl(most, size[i] + 2);
    }
    box *b = arb_box(a, from, size);
    CHECK(loft_tensor_volume(b->s, 6, &got) == LOFT_OK);
    /* thirds of a side are rounded alike on both faces that meet there: nothing is lost */
    CHECK_EXACT(exact_acc(got), volume,
                bound_by_num(0x1p-32L + 6 * most * most * most * 0x1p-52L, most * most * 0x1p-16L,
                             6 * most * most * most * 0x1p-44L));
}

/* One side bulges: a bubble of the integral of a product of Bernstein polynomials. */
static void a_bulge_adds_its_integral(arb *a)
{
    const int32_t from[3] = { 0, 0, 0 }, size[3] = { 8, 8, 8 };
    box *b = arb_box(a, from, size);
    loft_vec p[9];
    loft_acc got = 0;
    const int32_t height = (int32_t)arb_below(a, 13) - 6;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            loft_vec *at = &p[3 * i + j];
            *at = (loft_vec) { { loft_real_from_int(4 * i), loft_real_from_int(4 * j) } };
            at->axis[2] = loft_real_from_int(8 + (i == 1 && j == 1 ? height : 0));
        }
    CHECK(loft_tensor_init(&b->s[4], p, 2, 2) == LOFT_OK);
    CHECK(loft_tensor_volume(b->s, 6, &got) == LOFT_OK);
    CHECK_EXACT(exact_acc(got), 512 + 64 * height / 9.0L, bound_by_num(0x1p-31L, 1e-3L, 1e-9L));
}

static void inside_out_it_is_negative(arb *a)
{
    const int32_t from[3] = { 3, -5, 7 }, size[3] = { 4, 2, 6 };
    box *b = arb_box(a, from, size);
    static loft_vec turned[6][MOST * MOST];
    loft_acc got[2] = { 0, 0 };

    CHECK(loft_tensor_volume(b->s, 6, &got[0]) == LOFT_OK);
    for (int f = 0; f < 6; f++) {
        const unsigned m = b->s[f].m, n = b->s[f].n;
        loft_tensor_transpose(&b->s[f], turned[f]);
        CHECK(loft_tensor_init(&b->s[f], turned[f], n, m) == LOFT_OK);
    }
    CHECK(loft_tensor_volume(b->s, 6, &got[1]) == LOFT_OK);
    CHECK_EXACT(exact_acc(got[0]), -exact_acc(got[1]), bound_by_num(0x1p-31L, 1e-9L, 1e-9L));
    CHECK(loft_tensor_volume(b->s, 0, &got[0]) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(boxes_have_their_volume,   50);
    PROPERTY(a_bulge_adds_its_integral, 30);
    PROPERTY(inside_out_it_is_negative, 30);
    return check_failures();
}
