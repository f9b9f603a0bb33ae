/* tests/lib/surface/test_volume.c -- properties of lib/surface/volume.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "surface/triangle/triangle_pieces.h"
#include "surface/volume.h"

#if LOFT_AXES < 3
#  error "volumes need space"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_vec p[6][MOST * MOST];
    loft_tensor s[6];
} box;

static enum loft_status volume_of(const box *b, unsigned count, loft_acc *out)
{
    loft_net net[6];

    for (unsigned k = 0; k < 6; k++)
        net[k] = loft_net_from_tensor(&b->s[k]);
    return loft_net_volume(net, count, out);
}

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
    CHECK(volume_of(b, 6, &got) == LOFT_OK);
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
    CHECK(volume_of(b, 6, &got) == LOFT_OK);
    CHECK_EXACT(exact_acc(got), 512 + 64 * height / 9.0L, bound_by_num(0x1p-31L, 1e-3L, 1e-9L));
}

static void inside_out_it_is_negative(arb *a)
{
    const int32_t from[3] = { 3, -5, 7 }, size[3] = { 4, 2, 6 };
    box *b = arb_box(a, from, size);
    static loft_vec turned[6][MOST * MOST];
    loft_acc got[2] = { 0, 0 };

    CHECK(volume_of(b, 6, &got[0]) == LOFT_OK);
    for (int f = 0; f < 6; f++) {
        const unsigned m = b->s[f].m, n = b->s[f].n;
        loft_tensor_transpose(&b->s[f], turned[f]);
        CHECK(loft_tensor_init(&b->s[f], turned[f], n, m) == LOFT_OK);
    }
    CHECK(volume_of(b, 6, &got[1]) == LOFT_OK);
    CHECK_EXACT(exact_acc(got[0]), -exact_acc(got[1]), bound_by_num(0x1p-31L, 1e-9L, 1e-9L));
    CHECK(volume_of(b, 0, &got[0]) == LOFT_ERR_ARG);
}

/* Four plane triangles, raised: a sixth of the determinant of the sides. */
static void a_tetrahedron_of_triangles_is_exact(arb *a)
{
    static const unsigned face[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
    const unsigned degree = 1 + arb_below(a, 5);
    loft_vec corner[4], p[4][LOFT_TRIANGLE_POINTS(6)];
    loft_triangle t[4];
    loft_net net[4];
    loft_acc got;
    long double leg[3][3], most = 1;

    for (int k = 0; k < 4; k++) {
        corner[k] = (loft_vec) { { 0 } };
        for (int axis = 0; axis < 3; axis++)
            corner[k].axis[axis] = loft_real_from_int(60 * ((int32_t)arb_below(a, 9) - 4));
    }
    for (int k = 0; k < 4; k++) {
        const loft_vec ends[3] = { corner[face[k][0]], corner[face[k][1]], corner[face[k][2]] };
        loft_triangle flat;
        CHECK(loft_triangle_init(&flat, ends, 1) == LOFT_OK);
        CHECK(loft_triangle_elevate(&flat, degree - 1, p[k]) == LOFT_OK);  /* multiples of 60 */
        CHECK(loft_triangle_init(&t[k], p[k], degree) == LOFT_OK);
        net[k] = loft_net_from_triangle(&t[k]);
    }
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 3; axis++) {
            leg[k][axis] = exact_of(corner[k + 1].axis[axis]) - exact_of(corner[0].axis[axis]);
            most = fmaxl(most, fabsl(leg[k][axis]));
        }
    long double want = 0;
    for (int i = 0; i < 3; i++)
        want += leg[0][i] *
                (leg[1][(i + 1) % 3] * leg[2][(i + 2) % 3] -
                 leg[1][(i + 2) % 3] * leg[2][(i + 1) % 3]) /
                6;
    CHECK(loft_net_volume(net, 4, &got) == LOFT_OK);
    CHECK_NEAR(exact_acc(got), want,
               4 * most * most * most * BY_NUM(0x1p-50L, 0x1p-42L, 0x1p-42L) + 0x1p-32L);
}

int main(void)
{
    PROPERTY(boxes_have_their_volume,   50);
    PROPERTY(a_bulge_adds_its_integral, 30);
    PROPERTY(inside_out_it_is_negative, 30);
    PROPERTY(a_tetrahedron_of_triangles_is_exact, 20);
    return check_failures();
}
