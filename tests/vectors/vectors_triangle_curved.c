/* tests/vectors/vectors_triangle_curved.c -- readers of rational triangles, the octant of the
 * sphere, triangles from normals, and curvature
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"              /* growth3, reach3, whole_of */
#include "vectors/vectors_bary.h"           /* row_bary, and row, answer, law */
#include "surface/octant.h"
#include "surface/pn.h"
#include "surface/triangle/triangle_curvature.h"
#include "surface/triangle/triangle_rational.h"

#define MOST LOFT_TRIANGLE_MAX

/* Weights are exact in every number type, so of `inexact` and `largest` only the coordinates
 * count. */
static void tri_rational(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), count = LOFT_TRIANGLE_POINTS(n);
    const loft_bary u = row_bary(r, "u_q16", false), z = row_bary(r, "z_q16", true);
    long double least = 256, most = 0;
    loft_triangle_rational t;
    loft_weighted p[MOST];
    loft_vec points[MOST], v = { { 0 } };
    loft_real w[MOST];
    answer *at = answer_new(), *slope = answer_new();

    row_points(r, "net_q16", count, 3, points);
    const long double largest = r->largest, inexact = r->inexact;
    row_reals(r, "w_q16", count, w);
    r->largest = largest;
    r->inexact = inexact;
    for (unsigned k = 0; k < count; k++) {
        p[k] = (loft_weighted) { points[k], w[k] };
        least = fminl(least, exact_of(w[k]));
        most = fmaxl(most, exact_of(w[k]));
    }
    if (loft_triangle_rational_init(&t, p, n) != LOFT_OK) {
        row_complain(r, "the triangle was refused");
        return;
    }
    const long double ratio = most / least;
    answer_vec(at, loft_triangle_rational_eval(&t, u), 3);
    row_expect(r, "p", at,
               (law){ .lsb = 0.5L + n * ratio / 1073741824, .gain = 1, .roundings = 6 * n + 4 });
    const long double steep = reach3(z) * ratio * n;
    answer_status(r, slope, loft_triangle_rational_deriv(&t, z, u, &v));
    answer_vec(slope, v, 3);
    row_expect(r, "Dp", slope,
               (law){ .lsb = 0.5L + (n + 1) * steep / 67108864,
                      .gain = 2 * steep,
                      .roundings = 8 * (n + 1) });
}

static void octant(row *r)
{
    answer *a = answer_new();

    answer_vec(a, loft_octant_eval(row_bary(r, "u_q16", false)), 3);
    r->largest = 1;
    row_expect(r, "p", a, (law) { .lsb = 0.5L + 1 / 65536.0L, .gain = 1, .roundings = 32 });
}

/* A normal's length does not count: what reading rounded it by is a share of itself. */
static void pn_triangle(row *r)
{
    static const unsigned inner[7] = { 1, 2, 3, 4, 5, 7, 8 };
    const loft_bary u = row_bary(r, "u_q16", false);
    const long double l = growth3(u);
    loft_vec corner[3], normal[3], net[10], at = { { 0 } };
    answer *b = answer_new(), *p = answer_new();
    loft_pn t;

    row_points(r, "P_q16", 3, 3, corner);
    const long double largest = r->largest, inexact = r->inexact;
    row_points(r, "N_q16", 3, 3, normal);
    const long double share = r->inexact > inexact ? 16 * 0x1p29L : 0;
    r->largest = largest;
    r->inexact = fmaxl(inexact, share > 0 ? 1e-30L : 0);
    const enum loft_status status = loft_pn_init(&t, corner, normal);
    answer_status(r, b, status);
    answer_status(r, p, status);
    if (status == LOFT_OK) {
        loft_pn_net(&t, net);
        for (unsigned k = 0; k < 7; k++)
            answer_vec(b, net[inner[k]], 3);
        answer_status(r, p, loft_pn_extrapolate(&t, u, &at));
        answer_vec(p, at, 3);
        if (loft_bary_inside(u) && !loft_vec_equal(at, loft_pn_eval(&t, u)))
            row_complain(r, "inside the triangle eval and extrapolate differ");
    }
    row_expect(r, "b", b, (law) { .lsb = 0.5L + 1 / 32768.0L, .gain = 4, .roundings = 16 + share });
    row_expect(r, "p", p,
               (law){ .lsb = 0.5L + fmaxl(8, 2 * l * l * l + l * l + l + 1) / 131072.0L,
                      .gain = 4 * l * l * l,
                      .roundings = (16 + share) * l * l * l });
}

/* From the coordinates as they were read. */
static long double bend_of(const loft_vec p[], unsigned n, loft_bary z)
{
    const quad v = (quad)exact_unit(z.v), w = (quad)exact_unit(z.w);
    quad b[6][3], s[3], q[3], m[3], speed = 0, size = 0, top = 0;

    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 6; k++)
            b[k][i] = n > 1 || k < 3 ? (quad)exact_of(p[k].axis[i]) : 0;
        s[i] = v * (b[1][i] - b[0][i]) + w * (b[2][i] - b[0][i]);
        q[i] = v * v * (b[3][i] - 2 * b[1][i] + b[0][i]) +
               2 * v * w * (b[4][i] - b[1][i] - b[2][i] + b[0][i]) +
               w * w * (b[5][i] - 2 * b[2][i] + b[0][i]);
        speed += s[i] * s[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[i] = (b[1][j] - b[0][j]) * (b[2][k] - b[0][k]) -
               (b[1][k] - b[0][k]) * (b[2][j] - b[0][j]);
        size += m[i] * m[i];
        top += q[i] * m[i];
    }
    return (n - 1) / (long double)n * (long double)(top / speed) / sqrtl((long double)size);
}

static void tri_normal_curvature(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    const loft_bary z = row_bary(r, "z_q16", true);
    loft_vec p[MOST];
    loft_triangle t;
    loft_real bend = 0;
    answer *a = answer_new();

    row_points(r, "net_q16", LOFT_TRIANGLE_POINTS(n), 3, p);
    if (loft_triangle_init(&t, p, n) != LOFT_OK)
        row_complain(r, "the net was refused");
    const enum loft_status status = loft_triangle_corner_curvature_vec(&t, z, &bend);
    if (r->inexact > 0) {
        const long double want = status == LOFT_OK ? bend_of(p, n, z) : 0;
        row_within(r, "kn", fabsl(exact_of(bend) - want) * 65536, ulp(want) * 65536);
        return;
    }
    row_expect_word(r, "status", status == LOFT_SINGULAR ? "singular" : "ok");
    if (status == LOFT_SINGULAR)
        return;
    answer_status(r, a, status);
    answer_real(a, bend);
    r->largest = fabsl(exact_of(bend));
    row_expect(r, "kn", a, (law) { .lsb = 0.5L + LSB, .roundings = 0.5L });
}

const vector_system vectors_triangle_curved[] = {
    { "tri_rational", "n,net_q16,w_q16,u_q16,z_q16,p,Dp", tri_rational,
      "q16 1/2 + n R 2^-30 LSB, Dp 1/2 + n (n + 1) Z R 2^-26 LSB; floats 1/2 ulp + (6 n + 4), Dp "
      "16 n (n + 1) Z R ulp of double" },
    { "octant", "u_q16,p", octant, "q16 1/2 LSB + 2^-16 LSB; floats 1/2 ulp + 2^-47" },
    { "pn_triangle", "P_q16,N_q16,u_q16,b,p", pn_triangle,
      "q16 1/2 LSB + 2^-14 LSB; floats 1/2 ulp + 64 ulp of double and what reading rounded" },
    { "tri_normal_curvature", "n,net_q16,z_q16,status,kn", tri_normal_curvature,
      "status exact; q16 1/2 LSB + 2^-16 LSB; floats 1 ulp" },
    { 0 }
};
