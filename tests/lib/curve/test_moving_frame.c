/* tests/lib/curve/test_moving_frame.c -- properties of lib/curve/moving_frame.h
 * SPDX-License-Identifier: MIT
 *
 * References: the two reflections in 113 bits; in a plane the frame does not leave it; along a
 * helix the integral of the torsion.
 */
#include "support/exact_spline.h"       /* quad, check_result; CHECK, PROPERTY, BY_NUM */
#include "curve/moving_frame.h"

typedef struct {
    quad at[3], along[3], across[3];
} reference;

static quad dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* One Newton step doubles the bits of sqrtl, whatever the size. */
static void make_unit(quad x[3])
{
    const quad length = quad_sqrt(dot(x, x));
    for (int i = 0; i < 3; i++)
        x[i] /= length;
}

static void reflect(quad x[3], const quad n[3])
{
    const quad part = 2 * dot(n, x) / dot(n, n);
    for (int i = 0; i < 3; i++)
        x[i] -= part * n[i];
}

static void quads_of(loft_vec v, quad out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = quad_of(loft_vec_axis(&v, i));
}

static void reference_start(reference *r, loft_vec at, loft_vec tangent, loft_vec up)
{
    quads_of(at, r->at);
    quads_of(tangent, r->along);
    quads_of(up, r->across);
    make_unit(r->along);
    const quad part = dot(r->across, r->along);
    for (int i = 0; i < 3; i++)
        r->across[i] -= part * r->along[i];
    make_unit(r->across);
}

static void reference_move(reference *r, loft_vec at, loft_vec tangent)
{
    quad to[3], direction[3], chord[3], turn[3];

    quads_of(at, to);
    quads_of(tangent, direction);
    make_unit(direction);
    for (int i = 0; i < 3; i++)
        chord[i] = to[i] - r->at[i];
    reflect(r->across, chord);
    reflect(r->along, chord);
    for (int i = 0; i < 3; i++)
        turn[i] = direction[i] - r->along[i];
    reflect(r->across, turn);
    for (int i = 0; i < 3; i++) {
        r->at[i] = to[i];
        r->along[i] = direction[i];
    }
}

static void check_directions(const loft_moving_frame *f, const reference *r, long double bound)
{
    for (int i = 0; i < 3; i++) {
        CHECK_EXACT((long double)(quad_sci(f->along[i]) - r->along[i]), 0, bound);
        CHECK_EXACT((long double)(quad_sci(f->across[i]) - r->across[i]), 0, bound);
    }
}

/* A vector within about 25 degrees of x. */
static loft_vec arb_forward(arb *a, int32_t size)
{
    loft_vec v = { { 0 } };

    v.axis[0] = loft_real_from_raw(size * 64 + (int32_t)arb_below(a, 4096));
    for (int i = 1; i < 3; i++)
        v.axis[i < LOFT_AXES ? i : 0] += loft_real_from_raw(
            (int32_t)arb_below(a, 40u * (uint32_t)size) - 20 * size);
    return v;
}

static void it_is_two_reflections(arb *a)
{
    const loft_vec up = { { 0, LOFT_REAL(0.25), LOFT_REAL(1) } };
    loft_vec at = arb_vec(a, 100), tangent = arb_forward(a, 1 << arb_below(a, 12));
    loft_moving_frame f;
    reference r;

    CHECK(loft_moving_frame_start(&f, at, tangent, up) == LOFT_OK);
    reference_start(&r, at, tangent, up);
    check_directions(&f, &r, BY_NUM(0x1p-54L, 0x1p-46L, 0x1p-46L));
    for (int k = 1; k <= 32; k++) {
        at = loft_vec_add(at, arb_forward(a, 1 << arb_below(a, 12)));
        tangent = arb_forward(a, 1 << arb_below(a, 12));
        CHECK(loft_moving_frame_move(&f, at, tangent) == LOFT_OK);
        reference_move(&r, at, tangent);
        check_directions(&f, &r, (k + 1) * BY_NUM(0x1p-54L, 0x1p-46L, 0x1p-46L));
    }
}

/* In any direction; the second reflection may be nearly undefined. */
static void it_stays_at_right_angles(arb *a)
{
    loft_moving_frame f;

    if (loft_moving_frame_start(&f, arb_vec(a, 100), arb_vec(a, 3), arb_vec(a, 3)) != LOFT_OK)
        return;
    for (int k = 0; k < 20; k++) {
        const loft_vec step = arb_vec(a, 10), tangent = arb_vec(a, 1 << arb_below(a, 10));
        const loft_moving_frame before = f;
        const enum loft_status status = loft_moving_frame_move(&f, loft_vec_add(f.at, step),
                                                               tangent);
        quad x[3], t[3];
        reference r;
        for (int i = 0; i < 3; i++) {
            x[i] = quad_sci(f.across[i]);
            t[i] = quad_sci(f.along[i]);
            CHECK(status == LOFT_OK ||
                  loft_sci_sign(loft_sci_sub(f.across[i], before.across[i])) == 0);
        }
        if (status != LOFT_OK)
            continue;
        quads_of(before.at, r.at);
        for (int i = 0; i < 3; i++) {
            r.along[i] = quad_sci(before.along[i]);
            r.across[i] = quad_sci(before.across[i]);
        }
        reference_move(&r, f.at, tangent);
        check_directions(&f, &r, BY_NUM(0x1p-38L, 0x1p-30L, 0x1p-30L));
        CHECK_EXACT((long double)dot(x, t), 0, BY_NUM(0x1p-57L, 0x1p-49L, 0x1p-49L));
        CHECK_EXACT((long double)dot(x, x), 1, BY_NUM(0x1p-57L, 0x1p-49L, 0x1p-49L));
    }
}

/* The normal of the plane stays where it is, around bends and the other way too. */
static void in_a_plane_it_turns_about_its_normal(arb *a)
{
    const loft_vec up = { { 0, 0, LOFT_REAL(3) } };
    loft_vec at = { { 0 } }, tangent = { { LOFT_REAL(1) } };
    loft_moving_frame f;

    CHECK(loft_moving_frame_start(&f, at, tangent, up) == LOFT_OK);
    for (int k = 0; k < 50; k++) {
        const double angle = arb_below(a, 1000) / 100.0;
        for (int i = 0; i < 2; i++) {
            tangent.axis[i] = LOFT_REAL(i ? sin(angle) : cos(angle));
            at.axis[i] += loft_real_from_raw((int32_t)arb_below(a, 131072) - 65536);
        }
        if (loft_moving_frame_move(&f, at, tangent) != LOFT_OK)
            continue;
        CHECK(loft_sci_sign(f.across[0]) == 0 && loft_sci_sign(f.across[1]) == 0);
        CHECK_EXACT((long double)quad_sci(f.across[2]), 1, BY_NUM(0x1p-57L, 0x1p-48L, 0x1p-48L));
    }
}

/* Along the helix (r cos x, r sin x, h x) the frame turns back by h / sqrt(r^2 + h^2) per radian
 * against the helix's own. Halving the step divides the error by 16. */
static long double helix_error(unsigned steps)
{
    const long double r = 20, h = 5, end = 6, c = sqrtl(r * r + h * h);
    loft_moving_frame f;
    long double off = 0;

    for (unsigned k = 0; k <= steps; k++) {
        const long double x = end * k / steps;
        const loft_vec at = { { LOFT_REAL(r * cosl(x)), LOFT_REAL(r * sinl(x)),
                                LOFT_REAL(h * x) } };
        const loft_vec tangent = { { LOFT_REAL(-r * sinl(x) * 100), LOFT_REAL(r * cosl(x) * 100),
                                     LOFT_REAL(h * 100) } };
        const loft_vec up = { { LOFT_REAL(-1) } };
        CHECK((k ? loft_moving_frame_move(&f, at, tangent)
                 : loft_moving_frame_start(&f, at, tangent, up)) == LOFT_OK);
    }
    const long double turn = -end * h / c;
    const long double n[3] = { -cosl(end), -sinl(end), 0 },
                      b[3] = { h * sinl(end) / c, -h * cosl(end) / c, r / c };
    for (int i = 0; i < 3; i++)
        off = fmaxl(
            off, fabsl((long double)quad_sci(f.across[i]) - cosl(turn) * n[i] - sinl(turn) * b[i]));
    return off;
}

static void along_a_helix_it_undoes_the_torsion(arb *a)
{
    (void)a;
    const long double coarse = helix_error(12), fine = helix_error(24);

    CHECK_NEAR(coarse, 0, 0.01);
    CHECK_NEAR(fine, 0, BY_NUM(coarse / 14 + 2e-5L, coarse / 14, coarse / 14));
    CHECK_NEAR(helix_error(48), 0, BY_NUM(coarse / 200 + 2e-5L, coarse / 200, coarse / 200));
}

static void points_are_within_their_bound(arb *a)
{
    const loft_vec at = arb_vec(a, 1000), p = arb_vec(a, 1000);
    loft_moving_frame f;
    loft_vec got = { { 0 } };
    quad x[3], t[3], r[3], want[LOFT_AXES];

    if (loft_moving_frame_start(&f, at, arb_vec(a, 30), arb_vec(a, 30)) != LOFT_OK)
        return;
    quads_of(p, x);
    for (int i = 0; i < 3; i++) {
        t[i] = quad_sci(f.along[i]);
        r[i] = quad_sci(f.across[i]);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        want[i < LOFT_AXES ? i : 0] = quad_of(at.axis[i < LOFT_AXES ? i : 0]) + x[0] * r[i] +
                                      x[1] * (t[j] * r[k] - t[k] * r[j]) + x[2] * t[i];
    }
    check_result(loft_moving_frame_point(&f, p, &got), &got, want, 0.5L + 0x1p-16L,
                 bound_by_num(0, 0x1p-20L * ulp(1024), 8 * ulp(1024)));
}

static void mistakes_are_refused(arb *a)
{
    const loft_vec zero = { { 0 } }, x = { { LOFT_REAL(2) } }, back = { { LOFT_REAL(-1) } };
    const loft_vec up = { { LOFT_REAL(1), LOFT_REAL(1) } }, far = { { LOFT_REAL_MAX } };
    loft_vec p, ahead = zero;
    loft_moving_frame f;

    (void)a;
    ahead.axis[LOFT_AXES > 2 ? 2 : 0] = LOFT_REAL_MAX;
    CHECK(loft_moving_frame_start(&f, zero, zero, up) == LOFT_SINGULAR &&
          loft_moving_frame_start(&f, zero, x, back) == LOFT_SINGULAR &&
          loft_moving_frame_start(&f, zero, x, zero) == LOFT_SINGULAR);
    CHECK(loft_moving_frame_start(&f, far, x, up) == LOFT_OK);
    CHECK(loft_moving_frame_point(&f, ahead, &p) == LOFT_ERR_RANGE);
    CHECK(loft_moving_frame_move(&f, far, zero) == LOFT_SINGULAR &&
          loft_moving_frame_move(&f, far, back) == LOFT_SINGULAR &&
          loft_moving_frame_move(&f, far, up) == LOFT_OK);
}

int main(void)
{
    PROPERTY(it_is_two_reflections,                500);
    PROPERTY(it_stays_at_right_angles,             500);
    PROPERTY(in_a_plane_it_turns_about_its_normal, 200);
    PROPERTY(along_a_helix_it_undoes_the_torsion,    1);
    PROPERTY(points_are_within_their_bound,        500);
    PROPERTY(mistakes_are_refused,                   1);
    return check_failures();
}
