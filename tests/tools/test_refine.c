/* tests/tools/test_refine.c -- triangles within a tolerance by brute force; closed bodies
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "tools/drawn.h"          /* CHECK, tool_error */
#include "base/space.h"
#include "draw/refine.h"
#include "geometry/surface_text.h"

static double between(arb *a, double low, double high)
{
    return low + (high - low) * (arb_below(a, 1u << 30) / 1073741824.0);
}

static void refine_text(refined *r, surfaces *all, const char *text, const engine *e, double tol)
{
    *all = (surfaces){ 0 };
    *r = (refined){ 0 };
    CHECK(surfaces_read_text(&heard, all, "test", text) == 0);
    CHECK(refine_surfaces(&heard, r, all, "test", e, tol) == 0);
}

/* The distance of p from a triangle: from its plane if the foot is inside, or from a side. */
static double distance_to_triangle(const double p[3], const double *t[3])
{
    double n[3], up = 0, length = 0, least = INFINITY;
    bool inside = true;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (t[1][j] - t[0][j]) * (t[2][k] - t[0][k]) -
               (t[1][k] - t[0][k]) * (t[2][j] - t[0][j]);
        up += n[i] * (p[i] - t[0][i]);
        length += n[i] * n[i];
    }
    for (int c = 0; c < 3; c++) {
        const double *a = t[c], *b = t[(c + 1) % 3];
        double turn = 0, along = 0, side = 0, foot[3];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            turn += n[i] * ((b[j] - a[j]) * (p[k] - a[k]) - (b[k] - a[k]) * (p[j] - a[j]));
            along += (p[i] - a[i]) * (b[i] - a[i]);
            side += (b[i] - a[i]) * (b[i] - a[i]);
        }
        inside = inside && turn >= 0;
        for (int i = 0; i < 3; i++)
            foot[i] = a[i] + fmin(fmax(along / side, 0), 1) * (b[i] - a[i]);
        least = fmin(least, space_distance(p, foot));
    }
    return inside && length > 0 ? fabs(up) / sqrt(length) : least;
}

#define SHARES 6

/* The farthest of some places of a triangle from it, in tolerances. */
static double farthest_of(const refined *r, const engine *e, const engine_surface *held,
                          const refined_triangle *t)
{
    const double *corner[3];
    double most = 0;

    for (int c = 0; c < 3; c++)
        corner[c] = r->node[t->at[c].node];
    for (int i = 0; i <= SHARES; i++)
        for (int j = 0; i + j <= SHARES; j++) {
            const double share[3] = { i, j, SHARES - i - j };
            double sum[2] = { 0 }, of[2] = { 0 }, p[3];
            for (int c = 0; c < 3; c++) {
                const double w[2] = { t->at[c].open & 1 ? 0 : share[c],
                                      t->at[c].open & 2 ? 0 : share[c] };
                of[0] += w[0];
                of[1] += w[1];
                sum[0] += w[0] * t->at[c].u;
                sum[1] += w[1] * t->at[c].v;
            }
            CHECK(e->surface->kite(held, t->kite, of[0] > 0 ? sum[0] / of[0] : 0,
                                   of[1] > 0 ? sum[1] / of[1] : 0, p) == 0);
            most = fmax(most, distance_to_triangle(p, corner));
        }
    return most;
}

static double farthest(const refined *r, const surfaces *all, const engine *e)
{
    double most = 0;

    for (size_t s = 0; s < all->count; s++) {
        engine_surface *held = NULL;
        CHECK(e->surface->open(&all->surface[s], &held) == 0);
        for (size_t k = 0; k < r->triangles; k++)
            if (r->triangle[k].surface == s)
                most = fmax(most, farthest_of(r, e, held, &r->triangle[k]));
        e->surface->close(held);
    }
    return most;
}

/* Every kind and each variety of it. */
static void surfaces_are_within_the_tolerance(arb *a)
{
    static const char *const file[3] = { "patch", "surfaces", "sided" };
    char name[64];

    (void)a;
    for (int k = 0; k < 3; k++) {
        surfaces all = { 0 };
        refined r = { 0 };
        snprintf(name, sizeof name, "tests/drawings/%s.loft", file[k]);
        CHECK(surfaces_read(&heard, &all, name) == 0);
        CHECK(refine_surfaces(&heard, &r, &all, name, &engine_f64, 0.05) == 0);
        CHECK(farthest(&r, &all, &engine_f64) <= 0.05);
        refined_free(&r);
        surfaces_free(&all);
    }
}

static void random_patches_are_within_the_tolerance(arb *a)
{
    const double tol = pow(10, between(a, -2, 0));
    const int m = 1 + (int)arb_below(a, 5), n = 1 + (int)arb_below(a, 5);
    char text[4096];
    surfaces all;
    refined r;
    int used = snprintf(text, sizeof text, "tensor %d %d\n", m, n);

    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            used += snprintf(text + used, sizeof text - (size_t)used, "%.6f %.6f %.6f\n",
                             i * 40.0 / m + between(a, -5, 5), j * 40.0 / n + between(a, -5, 5),
                             between(a, -10, 10));
    refine_text(&r, &all, text, &engine_f64, tol);
    CHECK(farthest(&r, &all, &engine_f64) <= tol);
    refined_free(&r);
    surfaces_free(&all);
}

/* The poles and the seam of a sphere close; its volume and centroid are exact within the
 * tolerance. */
static void a_sphere_is_a_body(arb *a)
{
    static const double pi = 3.14159265358979323846;
    const double radius = between(a, 1, 100), tol = radius * pow(10, between(a, -3.5, -1));
    char text[64];
    surfaces all;
    refined r;
    refined_sum b;

    snprintf(text, sizeof text, "sphere %.6f\n1 2 3\n", radius);
    refine_text(&r, &all, text, &engine_f64, tol);
    refined_body(&r, &b);
    CHECK(b.open == 0 && b.turned == 0 && b.many == 0 && b.triangles == r.triangles);
    CHECK(b.corners + b.triangles - b.edges == 2);
    CHECK_NEAR(b.volume, 4 / 3.0 * pi * radius * radius * radius, tol * b.area);
    CHECK_NEAR(b.area, 4 * pi * radius * radius, 3 * tol / radius * b.area);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(b.centroid[i], i + 1, tol);
    refined_free(&r);
    surfaces_free(&all);
}

/* A cubic edge between a patch, and a triangle of degree 4 that has it raised. One of the patches
 * alone would need few triangles. */
static void neighbours_share_their_corners(arb *a)
{
    const double h = between(a, 2, 10), z = between(a, -20, 20);
    /* the edge: 0 0 0, 0 h z, 0 2h z, 0 3h 0; raised: 0 0 0, 0 3h/4 3z/4, 0 3h/2 z, .. */
    char text[1024];
    surfaces all;
    refined r;
    refined_sum b;

    snprintf(text, sizeof text,
             "tensor 1 3\n0 0 0\n0 %f %f\n0 %f %f\n0 %f 0\n9 0 0\n9 %f 0\n9 %f 0\n9 %f 0\n"
             "triangle 4\n-8 0 9\n-6 0 0\n-6 3 0\n-4 0 0\n-4 3 9\n-4 6 0\n-2 0 0\n-2 2 0\n-2 4 5\n"
             "-2 6 0\n0 0 0\n0 %f %f\n0 %f %f\n0 %f %f\n0 %f 0\n",
             h, z, 2 * h, z, 3 * h, h, 2 * h, 3 * h, 0.75 * h, 0.75 * z, 1.5 * h, z, 2.25 * h,
             0.75 * z, 3 * h);
    refine_text(&r, &all, text, &engine_f64, 0.01);
    refined_body(&r, &b);
    CHECK(b.turned == 0 && b.many == 0);
    CHECK(b.corners + b.triangles == b.edges + 1);      /* a disk */
    refined_free(&r);
    surfaces_free(&all);
}

/* A patch that reaches only half way along the edge of another leaves it open, and says so. */
static void an_open_edge_is_told(arb *a)
{
    surfaces all;
    refined r;
    refined_sum b;

    (void)a;
    refine_text(
        &r, &all,
        "tensor 1 1\n0 0 0\n0 9 0\n9 0 0\n9 9 0\ntensor 1 1\n9 0 0\n9 6 0\n20 0 0\n20 9 0\n",
        &engine_f64, 0.01);
    refined_body(&r, &b);
    CHECK(b.open > 0 && b.triangles > 0);
    CHECK_NEAR(b.area, 81 + 11 * 7.5, 1e-3);
    refined_free(&r);
    surfaces_free(&all);
}

int main(void)
{
    PROPERTY(surfaces_are_within_the_tolerance, 1);
    PROPERTY(random_patches_are_within_the_tolerance, 10);
    PROPERTY(a_sphere_is_a_body, 5);
    PROPERTY(neighbours_share_their_corners, 10);
    PROPERTY(an_open_edge_is_told, 1);
    return check_failures();
}
