/* tests/lib/surface/test_sphere.c -- properties of lib/surface/sphere.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"
#include "surface/sphere.h"

#define DEGREE 0.017453292519943295769L

static loft_sphere arb_sphere(arb *a, int32_t limit)
{
    loft_sphere s = { arb_vec(a, limit), arb_real(a, limit) };

    if (s.radius < 0)
        s.radius = -s.radius;
    return s;
}

static long double arm(const loft_sphere *s, loft_vec x, int i)
{
    return i < LOFT_AXES ? exact_of(x.axis[i < LOFT_AXES ? i : 0]) -
                               exact_of(s->centre.axis[i < LOFT_AXES ? i : 0])
                         : 0;
}

/* The rest of an angle after whole turns, in radians, from the unrounded angle. */
static long double radians(loft_real degrees) { return fmodl(exact_of(degrees), 360) * DEGREE; }

static void points_are_on_the_sphere(arb *a)
{
    const loft_sphere s = arb_sphere(a, arb_below(a, 2) ? 15000 : 32767);
    const loft_real theta = arb_real(a, arb_below(a, 2) ? 400 : 32767), phi = arb_real(a, 180);
    const long double t = radians(theta), f = radians(phi),
                      n[3] = { cosl(t) * sinl(f), sinl(t) * sinl(f), cosl(f) };
    const long double reach = 2 * exact_of(s.radius) + 32767;
    loft_vec p = { { 0 } }, normal = { { 0 } };
    bool fits = true;

    const enum loft_status status = loft_sphere_eval(&s, theta, phi, &p);
    CHECK(loft_sphere_normal(&s, theta, phi, &normal) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_of(s.centre.axis[i]) +
                                 (i < 3 ? exact_of(s.radius) * n[i] : 0);
        fits = fits && want < BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX) &&
               want >= BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
        if (status == LOFT_OK)
            CHECK_EXACT(exact_of(p.axis[i]), want,
                        BY_NUM(LSB / 2 + LSB / 16384, 0.51L * ulp(want), 0) +
                            BY_NUM(0, 16, 16) * ulp_double(reach));
        CHECK_EXACT(exact_of(normal.axis[i]), i < 3 ? n[i] : 0,
                    BY_NUM(LSB / 2 + LSB / 16384, 0.51L * ulp(1), 16 * ulp(1)));
    }
    CHECK(status == (fits ? LOFT_OK : LOFT_ERR_RANGE));
}

/* The first derivatives by colatitude and longitude, and their cross product outward. */
static void derivatives_are_those_of_angles(arb *a)
{
    loft_sphere s = arb_sphere(a, 32767);
    const loft_real theta = arb_real(a, 400), phi = arb_real(a, 180);
    const long double t = radians(theta), f = radians(phi), r = exact_of(s.radius),
                      u[3] = { r * cosl(t) * cosl(f), r * sinl(t) * cosl(f), -r * sinl(f) },
                      v[3] = { -r * sinl(t) * sinl(f), r * cosl(t) * sinl(f), 0 },
                      uv[3] = { -r * sinl(t) * cosl(f), r * cosl(t) * cosl(f), 0 };
    loft_differential d;

    CHECK(loft_sphere_differential(&s, theta, phi, &d) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES && i < 3; i++) {
        const loft_sci *const of[3] = { d.u, d.v, d.uv };
        const long double want[3] = { u[i], v[i], uv[i] };
        for (int k = 0; k < 3; k++) {
            loft_acc x = 0;
            CHECK(loft_sci_to_acc(of[k][i], &x));
            CHECK_EXACT(exact_acc(x), want[k], BY_NUM(0x1p-32L, 0, 0) + r * 0x1p-50L);
        }
    }
    s.radius = LOFT_REAL(-1);
    CHECK(loft_sphere_differential(&s, theta, phi, &d) == LOFT_ERR_ARG);
}

/* Poles and the four points of the equator, in every turn. */
static void quarters_are_exact(arb *a)
{
    static const int cosine[4] = { 1, 0, -1, 0 };
    const loft_sphere s = arb_sphere(a, 16000);
    const int32_t t = (int32_t)arb_below(a, 601) - 300, f = (int32_t)arb_below(a, 601) - 300;
    const int n[3] = { cosine[t & 3] * cosine[(f + 3) & 3],
                       cosine[(t + 3) & 3] * cosine[(f + 3) & 3], cosine[f & 3] };
    loft_vec p = { { 0 } }, normal = { { 0 } };

    CHECK(loft_sphere_eval(&s, loft_real_from_int(90 * t), loft_real_from_int(90 * f), &p) ==
          LOFT_OK);
    CHECK(loft_sphere_normal(&s, loft_real_from_int(90 * t), loft_real_from_int(90 * f), &normal) ==
          LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_of(s.centre.axis[i]) +
                                 (i < 3 ? n[i] * exact_of(s.radius) : 0);
        CHECK_EXACT(exact_of(p.axis[i]), want, BY_NUM(0, ulp(want) / 2, ulp(want) / 2));
        CHECK_EXACT(exact_of(normal.axis[i]), i < 3 ? n[i] : 0, 0);
    }
}

/* Distance, value and direction of any point, in long double. */
static void distances_keep_their_bound(arb *a)
{
    const loft_sphere s = arb_sphere(a, arb_below(a, 3) ? 100 : 32767);
    const loft_vec x = arb_below(a, 12) ? arb_vec(a, arb_below(a, 3) ? 100 : 32767) : s.centre;
    const long double square = arm(&s, x, 0) * arm(&s, x, 0) + arm(&s, x, 1) * arm(&s, x, 1) +
                               arm(&s, x, 2) * arm(&s, x, 2);
    const long double r = exact_of(s.radius), distance = sqrtl(square) - r, value = square - r * r;
    loft_real d = 0, v = 0;
    loft_vec n = { { 0 } };

    const enum loft_status far = loft_sphere_distance(&s, x, &d),
                           over = loft_sphere_value(&s, x, &v),
                           way = loft_sphere_direction(&s, x, &n);
    CHECK(far ==
          (distance < BY_NUM(32768 - LSB / 2, INFINITY, INFINITY) ? LOFT_OK : LOFT_ERR_RANGE));
    CHECK(over ==
              (fabsl(value) < BY_NUM(32768 - LSB, INFINITY, INFINITY) ? LOFT_OK : LOFT_ERR_RANGE) ||
          fabsl(fabsl(value) - 32768) < 1);
    CHECK(way == (square > 0 ? LOFT_OK : LOFT_SINGULAR));
    if (far == LOFT_OK)
        CHECK_EXACT(exact_of(d), distance,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(distance) + 0x1p-46L, ulp(r + 65536)));
    if (over == LOFT_OK)
        CHECK_EXACT(exact_of(v), value,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(value) + 0x1p-30L, ulp(value) + 0x1p-30L));
    for (int i = 0; i < LOFT_AXES && way == LOFT_OK; i++)
        CHECK_EXACT(exact_of(n.axis[i]), i < 3 ? arm(&s, x, i) / sqrtl(square) : 0,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(1), ulp(1)));
}

/* A point by angles is at the radius from the centre, in the direction of their normal. */
static void both_forms_agree(arb *a)
{
    loft_sphere s = arb_sphere(a, 9000);
    const loft_real theta = arb_real(a, 360), phi = arb_real(a, 180);
    loft_vec p = { { 0 } }, n = { { 0 } }, way = { { 0 } };
    loft_real d = 0;

    s.radius += LOFT_REAL(100);
    CHECK(loft_sphere_eval(&s, theta, phi, &p) == LOFT_OK &&
          loft_sphere_normal(&s, theta, phi, &n) == LOFT_OK);
    if (LOFT_AXES < 3)
        return;
    CHECK(loft_sphere_distance(&s, p, &d) == LOFT_OK &&
          loft_sphere_direction(&s, p, &way) == LOFT_OK);
    CHECK_EXACT(exact_of(d), 0, BY_NUM(1.5L * LSB, 2 * ulp(20000), 80 * ulp(20000)));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(way.axis[i]), exact_of(n.axis[i]),
                    BY_NUM(1.1L * LSB, ulp(1) + ulp(20000) / 50, ulp(20000)));
}

static void refuses_what_is_no_sphere(arb *a)
{
    const loft_sphere s = { arb_vec(a, 100), LOFT_REAL(-1) }, good = { s.centre, LOFT_REAL(1) };
    loft_vec p = { { 0 } };
    loft_real d = 0;

    CHECK(loft_sphere_eval(&s, 0, 0, &p) == LOFT_ERR_ARG &&
          loft_sphere_normal(&s, 0, 0, &p) == LOFT_ERR_ARG);
    CHECK(loft_sphere_distance(&s, p, &d) == LOFT_ERR_ARG &&
          loft_sphere_value(&s, p, &d) == LOFT_ERR_ARG);
    CHECK(loft_sphere_direction(&s, p, &p) == LOFT_ERR_ARG);
    CHECK(loft_sphere_eval(&good, LOFT_REAL(32767.5), 0, &p) == LOFT_ERR_ARG &&
          loft_sphere_eval(&good, 0, LOFT_REAL(-32767.5), &p) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(derivatives_are_those_of_angles, 2000);
    PROPERTY(points_are_on_the_sphere, 3000);
    PROPERTY(quarters_are_exact, 300);
    PROPERTY(distances_keep_their_bound, 1500);
    PROPERTY(both_forms_agree, 500);
    PROPERTY(refuses_what_is_no_sphere, 3);
    return check_failures();
}
