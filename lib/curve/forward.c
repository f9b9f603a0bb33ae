/* lib/curve/forward.c -- exact walking; the arithmetic of one axis is num/walk.c
 * SPDX-License-Identifier: MIT
 */
#include "curve/forward.h"

#if defined(__AVR__) || defined(__thumb__)
#  define APART       __attribute__((noinline, cold))
#  define APART_ALONE __attribute__((noinline))
#else
#  define APART
#  define APART_ALONE
#endif

static void control_values(loft_real p[], const loft_bezier *b, int axis)
{
    for (unsigned k = 0; k <= b->degree; k++)
        p[k] = b->p[k].axis[axis];
}

static bool points_valid(const loft_bezier *b)
{
    loft_real p[LOFT_FORWARD_DEGREE_MAX + 1];

    for (int i = 0; i < LOFT_AXES; i++) {
        control_values(p, b, i);
        if (!loft_walk_valid(p, b->degree))
            return false;
    }
    return true;
}

/* One halving of the step adds `degree` bits to the fractions of the differences, which have 32
 * bits. If n is not a power of two, the fractions are rounded and no bits are free. */
static int8_t halvings(unsigned degree, uint32_t n)
{
    uint8_t used = 0;

    if (n & (n - 1))
        return 0;
    for (; n > 1; n >>= 1)
        used++;
    if (degree == 0)
        return 32;
    return (int8_t)(32 / degree > used ? 32 / degree - used : 0);
}

/* How often n can be halved and stay at least `coarsest`; -1 if it is already below. */
static int8_t doublings(uint32_t n, uint32_t coarsest)
{
    int8_t times = -1;

    for (; n >= coarsest; n >>= 1)
        times++;
    return times;
}

enum loft_status loft_forward_init(loft_forward *w, const loft_bezier *b, uint32_t n)
{
    loft_powers powers;
    uint32_t coarsest = 1;

    if (b->degree > LOFT_FORWARD_DEGREE_MAX || n == 0)
        return LOFT_ERR_ARG;
    if (!loft_walk_steps_valid(b->degree, n) || !points_valid(b))
        return LOFT_ERR_RANGE;

    loft_powers_init(&powers, b->degree, n);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_real p[LOFT_FORWARD_DEGREE_MAX + 1];

        control_values(p, b, i);
        loft_walk_init(&w->axis[i], p, b->degree, &powers);
        const uint32_t least = loft_walk_coarsest(p, b->degree);
        if (coarsest < least)
            coarsest = least;
    }
    w->left = n;
    w->degree = b->degree;
    w->halvings = halvings(b->degree, n);
    w->doublings = doublings(n, coarsest);
    return LOFT_OK;
}

/* The largest coordinate, and the largest second difference. */
static void sizes_of(const loft_bezier *b, loft_acc *size, loft_acc *bend)
{
    *size = *bend = 0;
    for (unsigned k = 0; k <= b->degree; k++) {
        loft_acc d[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_acc x = loft_to_acc(b->p[k].axis[i]);
            *size = loft_acc_max(*size, loft_acc_abs(x));
            if (k >= 2)
                d[i] = x - 2 * loft_to_acc(b->p[k - 1].axis[i]) + loft_to_acc(b->p[k - 2].axis[i]);
        }
        if (k >= 2)
            *bend = loft_acc_max(*bend, loft_acc_hypot(d, LOFT_AXES));
    }
}

/* The second derivative of a Bezier curve is at most degree (degree - 1) times the largest second
 * difference D. A chord of a step h = 1/n is within h^2 / 8 of that, point by point, so
 *
 *     degree (degree - 1) D / (8 n^2) <= tol - e
 *
 * suffices, where e is what the points err by: for n within the law of ranges 1 LSB in each of at
 * most 6 axes in q16, below 3; in f32 1/2 ulp and in f64 2^-37 of the largest coordinate. Roots err
 * by 1/2 LSB of at least 511, or n is 1; so 1/512 is added to n. */
enum loft_status loft_forward_flatten(loft_forward *w, const loft_bezier *b, loft_real tol)
{
    loft_acc size, bend;

    if (b->degree > LOFT_FORWARD_DEGREE_MAX || !(tol > 0))
        return LOFT_ERR_ARG;
    if (!points_valid(b))
        return LOFT_ERR_RANGE;
    sizes_of(b, &size, &bend);
    const loft_acc off = 3 * loft_real_ulp(size) + 65536 * loft_acc_ulp(size),
                   room = loft_to_acc(tol) - off;
    if (!loft_real_valid(tol) || room < off)
        return LOFT_ERR_RANGE;
    if (b->degree < 2)
        return loft_forward_init(w, b, 1);

    const loft_acc wide = loft_to_acc(
        loft_acc_sqrt(loft_acc_ratio((int32_t)(b->degree * (b->degree - 1u)) * bend, 8)));
    const loft_acc narrow = loft_to_acc(loft_acc_sqrt(room));
    if (wide > 32000 * narrow)
        return LOFT_ERR_RANGE;
    const loft_real n = loft_acc_quot(wide + loft_acc_ratio(wide, 512), narrow);
    return loft_forward_init(w, b, 1 + (uint32_t)loft_real_floor(n));
}

/* A cubic need not save the registers of this. */
static APART bool step_any(loft_forward *w, loft_vec *out)
{
    const unsigned degree = w->degree;

    if (w->left == 0)
        return false;
    w->left--;
    for (int i = 0; i < LOFT_AXES; i++) {
        out->axis[i] = loft_walk_step(&w->axis[i], degree);
        if (w->left == 0)
            out->axis[i] = loft_walk_end(&w->axis[i], out->axis[i]);
    }
    return true;
}

/* Branches of loft_walk_next3 reach 256 bytes on a Cortex-M0. */
APART_ALONE bool loft_forward_next(loft_forward *w, loft_vec *out)
{
    const int8_t given = loft_walk_next3(w, out->axis);
    return given < 0 ? step_any(w, out) : given;
}

uint32_t loft_forward_run(loft_forward *w, loft_vec out[], uint32_t count)
{
    if (count > w->left)
        count = w->left;
    if (count == 0)
        return 0;
    w->left -= count;

    for (int i = 0; i < LOFT_AXES;) {
        loft_walk *axis = &w->axis[i];
        loft_real *to = &out[0].axis[i];

        if (i + 1 < LOFT_AXES && loft_walk_run2(axis, w->degree, to, LOFT_AXES, count)) {
            i += 2;
        } else {
            loft_walk_run(axis, w->degree, to, LOFT_AXES, count);
            i++;
        }
    }
    for (int i = 0; i < LOFT_AXES && w->left == 0; i++)
        out[count - 1].axis[i] = loft_walk_end(&w->axis[i], out[count - 1].axis[i]);
    return count;
}

enum loft_status loft_forward_halve(loft_forward *w)
{
    if (w->halvings == 0 || w->doublings < 0 || w->left > UINT32_MAX / 2)
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        loft_walk_halve(&w->axis[i], w->degree);
    w->left *= 2;
    w->halvings--;
    w->doublings++;
    return LOFT_OK;
}

enum loft_status loft_forward_double(loft_forward *w)
{
    if (w->left & 1)
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        loft_walk_double(&w->axis[i], w->degree);
    w->left /= 2;
    w->halvings++;
    w->doublings--;
    return LOFT_OK;
}

enum loft_status loft_forward_exact_init(loft_forward_exact *w, const loft_bezier *b, uint32_t n)
{
    if (b->degree > LOFT_FORWARD_DEGREE_MAX || n == 0)
        return LOFT_ERR_ARG;
    if (!loft_walk_exact_steps_valid(b->degree, n) || !points_valid(b))
        return LOFT_ERR_RANGE;

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_real p[LOFT_FORWARD_DEGREE_MAX + 1];

        control_values(p, b, i);
        loft_walk_exact_init(&w->axis[i], p, b->degree, n);
    }
    w->power = loft_walk_exact_power(b->degree, n);
    w->left = n;
    w->degree = b->degree;
    return LOFT_OK;
}

bool loft_forward_exact_next(loft_forward_exact *w, loft_vec *out)
{
    if (w->left == 0)
        return false;
    w->left--;

    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_walk_exact_step(&w->axis[i], w->degree, w->power, w->left == 0);
    return true;
}
