/* tests/vectors/vectors_meet.c -- readers of crossings, rays and closest points
 * SPDX-License-Identifier: MIT
 *
 * Numbers of answers are exact for the numbers as read: where f32 cannot hold a row's numbers,
 * nothing is compared.
 */
#include <stdlib.h>

#include "vectors/vectors_points.h"         /* as_given; row, answer, law */
#include "curve/crossings.h"
#include "surface/net_nearest.h"
#include "surface/net_ray.h"

#define MOST (LOFT_DEGREE_MAX + 1)

static void read_curve(row *r, const char *points, const char *degree, loft_vec p[], loft_bezier *b)
{
    const unsigned n = row_count(r, degree, LOFT_DEGREE_MAX);

    row_points(r, points, n + 1, 2, p);
    if (loft_bezier_init(b, p, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
}

static void curve_cross(row *r)
{
    loft_vec p[MOST] = { { { 0 } } }, q[MOST] = { { { 0 } } };
    loft_bezier a = { p, 0 }, b = { q, 0 };
    loft_meeting m[LOFT_MEETINGS_MAX];
    unsigned count = 0;
    char text[24];

    read_curve(r, "P_q16", "m", p, &a);
    read_curve(r, "Q_q16", "n", q, &b);
    const enum loft_status status = loft_bezier_crossings(&a, &b, m, &count);
    if (status < 0)
        row_complain(r, "the curves were refused");
    if (!as_given(r))
        return;
    row_expect_word(r, "status", status == LOFT_SINGULAR ? "overlap" : "ok");
    if (status != LOFT_OK)
        return;
    snprintf(text, sizeof text, "%u", count);
    row_expect_word(r, "count", text);
    if (count == 0)
        return;

    answer *at = answer_new(), *times = answer_new();
    for (unsigned k = 0; k < count; k++) {
        answer_unit(at, m[k].s);
        answer_unit(at, m[k].t);
        answer_real(times, LOFT_REAL(1) * m[k].multiplicity);
    }
    const long double largest = r->largest;
    r->largest = 1;
    row_expect(r, "st", at, (law) { .lsb = 0x1p-9L + 0x1p-16L, .roundings = 32 });
    row_expect(r, "mult", times, (law) { .lsb = 0 });
    r->largest = largest;
}

static void read_patch(row *r, loft_vec net[], loft_tensor *s)
{
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);

    row_points(r, "net_q16", (m + 1) * (n + 1), 3, net);
    if (loft_tensor_init(s, net, m, n) != LOFT_OK)
        row_complain(r, "the patch was refused");
}

/* Expect parameters to be those of a place on the patch within 2 LSB: their error is that over the
 * length of the shorter tangent. */
static long double steepness(const loft_tensor *s, loft_unit u, loft_unit v)
{
    long double least = INFINITY;

    for (unsigned k = 0; k < 2; k++) {
        loft_vec d = { { 0 } };
        long double sum = 0;
        if (loft_tensor_deriv(s, 1 - k, k, u, v, &d) == LOFT_OK)
            for (int axis = 0; axis < 3; axis++)
                sum += powl(exact_of(d.axis[axis]), 2);
        least = fminl(least, sqrtl(sum));
    }
    return least;
}

static void expect_number(row *r, const char *column, long double got, long double lsb)
{
    const long double want = strtold(row_text(r, column), NULL);
    row_within(r, column, fabsl(got - want) * 65536, lsb);
}

static void patch_ray(row *r)
{
    static loft_vec net[MOST * MOST];
    loft_tensor s = { net, 0, 0 };
    loft_vec from = { { 0 } }, direction = { { 0 } };
    loft_ray_hit hit[32];
    unsigned count = 0;
    char text[24];

    read_patch(r, net, &s);
    row_points(r, "O_q16", 1, 3, &from);
    row_points(r, "D_q16", 1, 3, &direction);
    const enum loft_status status = loft_net_ray(loft_net_from_tensor(&s), from, direction, hit, 32,
                                                 &count);
    if (!as_given(r))
        return;
    if (status != LOFT_OK)
        row_complain(r, "the ray was refused, or not decided: %d", (int)status);
    snprintf(text, sizeof text, "%u", count);
    row_expect_word(r, "count", text);
    const char *hits = row_text(r, "hits");
    for (unsigned k = 0; k < count && *hits && *hits != '-'; k++) {
        const long double got[3] = { exact_acc(hit[k].t), exact_unit(hit[k].u),
                                     exact_unit(hit[k].v) };
        for (unsigned j = 0; j < 3; j++) {
            char *end;
            const long double want = strtold(hits, &end), scale = fmaxl(fabsl(want), 1);
            row_within(r, "hits", fabsl(got[j] - want) * 65536, scale * 0x1p-8L);
            for (hits = end; *hits == ' ' || *hits == ';'; )
                hits++;
        }
    }
}

static void patch_closest(row *r)
{
    static loft_vec net[MOST * MOST];
    loft_tensor s = { net, 0, 0 };
    loft_net_near near = { 0 };
    loft_vec x = { { 0 } };

    read_patch(r, net, &s);
    row_points(r, "X_q16", 1, 3, &x);
    const enum loft_status status = loft_net_nearest(loft_net_from_tensor(&s), x,
                                                     LOFT_REAL(1.0 / 65536), &near);
    if (!as_given(r))
        return;
    if (status != LOFT_OK)
        row_complain(r, "the point was refused, or not proved: %d", (int)status);
    const long double steep = fmaxl(steepness(&s, near.u, near.v), 0x1p-8L);
    expect_number(r, "dist", exact_acc(near.distance), 0.01L);
    expect_number(r, "u", exact_unit(near.u), fmaxl(0x1p-8L, 0.1L / steep));
    expect_number(r, "v", exact_unit(near.v), fmaxl(0x1p-8L, 0.1L / steep));
}

const vector_system vectors_meet[] = {
    { "curve_cross", "m,n,P_q16,Q_q16,status,count,st,mult", curve_cross,
      "status, count, mult exact, s, t 2^-25 + 2^-32" },
    { "patch_ray", "m,n,net_q16,O_q16,D_q16,count,hits", patch_ray,
      "count exact, t, u, v 2^-8 LSB of the larger of 1 and it" },
    { "patch_closest", "m,n,net_q16,X_q16,u,v,dist", patch_closest,
      "dist 0.01 LSB, u, v 2^-8 LSB, or so much that the point is off by 0.1 LSB" },
    { NULL, NULL, NULL, NULL }
};
