/* tests/lib/surface/test_net_ray.c -- properties of lib/surface/net_ray.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of, exact_acc, exact_eval; CHECK, PROPERTY */
#include "surface/net_ray.h"

#if LOFT_AXES < 3
#  error "patches need space"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)
#define ROOM 40

static loft_vec net[MOST * MOST];

static void place_at(const loft_tensor *s, long double u, long double v, long double out[3])
{
    long double row[MOST], column[MOST];

    for (int axis = 0; axis < 3; axis++) {
        for (unsigned i = 0; i <= s->m; i++) {
            for (unsigned j = 0; j <= s->n; j++)
                row[j] = exact_of(s->p[i * (s->n + 1u) + j].axis[axis]);
            column[i] = exact_eval(row, s->n, v);
        }
        out[axis] = exact_eval(column, s->m, u);
    }
}

/* A patch over a grid of x and y, which moves by a part of its step, and any height. */
static loft_tensor arb_patch(arb *a, unsigned most, int32_t sway)
{
    const unsigned m = 1 + arb_below(a, most), n = 1 + arb_below(a, most);
    loft_tensor s = { net, 0, 0 };

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            loft_vec *p = &net[i * (n + 1) + j];
            *p = (loft_vec) { { 0 } };
            p->axis[0] = loft_real_from_int(8 * (int32_t)i) + (sway ? arb_real(a, sway) : 0);
            p->axis[1] = loft_real_from_int(8 * (int32_t)j) + (sway ? arb_real(a, sway) : 0);
            p->axis[2] = arb_real(a, 10);
        }
    CHECK(loft_tensor_init(&s, net, m, n) == LOFT_OK);
    return s;
}

static void hits_lie_on_the_ray_and_a_known_one_is_found(arb *a)
{
    const loft_tensor s = arb_patch(a, 3, 3);
    const loft_unit u = loft_unit_of(1 + arb_below(a, 255), 256),
                    v = loft_unit_of(1 + arb_below(a, 255), 256);
    const loft_vec at = loft_tensor_eval(&s, u, v);
    loft_vec from = { { 0 } };
    loft_ray_hit hit[ROOM];
    unsigned count;
    bool found = false;

    for (int axis = 0; axis < 3; axis++)
        from.axis[axis] = arb_real(a, 30);
    const loft_vec d = loft_vec_sub(at, from);
    const enum loft_status status = loft_net_ray(loft_net_from_tensor(&s), from, d, hit, ROOM,
                                                 &count);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (unsigned k = 0; k < count; k++) {
        long double p[3];
        place_at(&s, exact_unit(hit[k].u), exact_unit(hit[k].v), p);
        for (int axis = 0; axis < 3; axis++)
            CHECK_NEAR(p[axis],
                       exact_of(from.axis[axis]) + exact_acc(hit[k].t) * exact_of(d.axis[axis]),
                       hit[k].touch ? 0x1p-10L : BY_NUM(0x1p-16L, 0x1p-14L, 1e-9L));
        CHECK(k == 0 || hit[k - 1].t <= hit[k].t);
        place_at(&s, exact_unit(u), exact_unit(v), p);
        found = found || fabsl(exact_acc(hit[k].t) - 1) < 0x1p-6L;
    }
    CHECK(found);
}

/* Over an even grid the height is a function of x and y: an upright ray meets it once. */
static void an_upright_ray_meets_a_height_once(arb *a)
{
    const loft_tensor s = arb_patch(a, 4, 0);
    loft_vec from = { { 0 } }, up = { { 0 } };
    loft_ray_hit hit[ROOM];
    unsigned count;
    const uint32_t x = 1 + arb_below(a, 255), y = 1 + arb_below(a, 255);

    from.axis[0] = loft_real_from_raw((int32_t)(x * 8 * s.m * 256));
    from.axis[1] = loft_real_from_raw((int32_t)(y * 8 * s.n * 256));
    from.axis[2] = LOFT_REAL(-40);
    up.axis[2] = LOFT_REAL(2);
    CHECK(loft_net_ray(loft_net_from_tensor(&s), from, up, hit, ROOM, &count) == LOFT_OK &&
          count == 1);
    CHECK_NEAR(exact_unit(hit[0].u), x / 256.0L, 0x1p-23L);
    CHECK_NEAR(exact_unit(hit[0].v), y / 256.0L, 0x1p-23L);
    CHECK(!hit[0].edge && !hit[0].touch);
    from.axis[2] = LOFT_REAL(40);
    CHECK(loft_net_ray(loft_net_from_tensor(&s), from, up, hit, ROOM, &count) == LOFT_OK &&
          count == 0);
    from.axis[0] = LOFT_REAL(-1);
    from.axis[2] = LOFT_REAL(-40);
    CHECK(loft_net_ray(loft_net_from_tensor(&s), from, up, hit, ROOM, &count) == LOFT_OK &&
          count == 0);
}

/* z = (x^2 + y^2) / 8 over -8..8, and a ray at a height of some LSB. */
static void a_bowl_is_crossed_touched_or_missed(arb *a)
{
    loft_tensor s = { net, 0, 0 };
    loft_vec from = { { 0 } }, d = { { 0 } };
    loft_ray_hit hit[ROOM];
    unsigned count;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            loft_vec *p = &net[3 * i + j];
            *p = (loft_vec) { { 0 } };
            p->axis[0] = loft_real_from_int(8 * (i - 1));
            p->axis[1] = loft_real_from_int(8 * (j - 1));
            p->axis[2] = loft_real_from_int((i == 1 ? -8 : 8) + (j == 1 ? -8 : 8));
        }
    CHECK(loft_tensor_init(&s, net, 2, 2) == LOFT_OK);
    from.axis[0] = LOFT_REAL(-20);
    d.axis[0] = LOFT_REAL(1) + arb_real(a, 1) / 2;
    for (int32_t height = -1; height <= 1; height++) {
        from.axis[2] = loft_real_from_raw(height);
        const enum loft_status status = loft_net_ray(loft_net_from_tensor(&s), from, d, hit, ROOM,
                                                     &count);
        if (height < 0)
            CHECK(status == LOFT_OK && count == 0);
        else if (height > 0)
            CHECK(status == LOFT_OK && count == 2 && !hit[0].touch && !hit[1].touch);
        else
            CHECK(status == LOFT_SINGULAR && count == 1 && hit[0].touch);
    }
}

static void a_ray_within_the_patch_is_told(arb *a)
{
    const loft_tensor s = arb_patch(a, 2, 0);
    loft_ray_hit hit[ROOM];
    unsigned count;

    for (unsigned k = 0; k < (s.m + 1u) * (s.n + 1u); k++)
        net[k].axis[2] = 0;
    const loft_vec from = loft_tensor_eval(&s, LOFT_UNIT(0.5), LOFT_UNIT(0.25));
    loft_vec d = { { 0 } };
    d.axis[0] = LOFT_REAL(1);
    const enum loft_status status = loft_net_ray(loft_net_from_tensor(&s), from, d, hit, 3, &count);
    CHECK(status == LOFT_MORE);
    d.axis[0] = 0;
    CHECK(loft_net_ray(loft_net_from_tensor(&s), from, d, hit, 3, &count) == LOFT_ERR_ARG &&
          count == 0);
}

static void a_ray_through_a_corner_says_so(arb *a)
{
    const loft_tensor s = arb_patch(a, 3, 2);
    loft_vec from = { { 0 } };
    loft_ray_hit hit[ROOM];
    unsigned count;

    from.axis[2] = LOFT_REAL(-40);
    const loft_vec d = loft_vec_sub(net[0], from);      /* a corner is exact */
    CHECK(loft_net_ray(loft_net_from_tensor(&s), from, d, hit, ROOM, &count) >= 0 && count > 0);
    bool edge = false;
    for (unsigned k = 0; k < count; k++)
        edge = edge ||
               (hit[k].edge && hit[k].u < LOFT_UNIT(0x1p-20) && hit[k].v < LOFT_UNIT(0x1p-20));
    CHECK(edge);
}

int main(void)
{
    PROPERTY(hits_lie_on_the_ray_and_a_known_one_is_found, 150);
    PROPERTY(an_upright_ray_meets_a_height_once, 60);
    PROPERTY(a_bowl_is_crossed_touched_or_missed, 10);
    PROPERTY(a_ray_within_the_patch_is_told, 5);
    PROPERTY(a_ray_through_a_corner_says_so, 40);
    return check_failures();
}
