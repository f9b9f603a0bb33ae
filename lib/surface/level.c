/* lib/surface/level.c
 * SPDX-License-Identifier: MIT
 *
 * A distance is d p / |d| - h, a cosine N d / (|N| |d|) - c with N = P_u x P_v. The sign of N d is
 * that of the silhouette, whatever the length of N.
 *
 * An edge that is one point, as at a pole, has P_v = 0 or P_u = 0 and no N. Near the edge u = 0 P_v
 * is u P_uv, so N has the direction of P_u x P_uv, near u = 1 the opposite one; likewise P_uv x P_v
 * near v = 0 and v = 1.
 */
#include "surface/level.h"

static loft_sci dot_of(const loft_sci a[3], const loft_vec *d)
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < 3 && i < LOFT_AXES; i++)
        sum = loft_sci_add(sum, loft_sci_mul(a[i], loft_sci_from_real(d->axis[i])));
    return sum;
}

static enum loft_status aim(loft_level *l, enum loft_level_kind kind, loft_vec direction,
                            loft_real height)
{
    const loft_level made = { kind, 0, direction, loft_sci_zero(), height };
    loft_sci sum = loft_sci_zero();

    if (!loft_vec_valid(direction) || !loft_real_valid(height))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < 3 && i < LOFT_AXES; i++) {
        const loft_sci x = loft_sci_from_real(direction.axis[i]);
        sum = loft_sci_add(sum, loft_sci_mul(x, x));
    }
    if (loft_sci_sign(sum) == 0)
        return LOFT_ERR_ARG;
    *l = made;
    l->length = loft_sci_sqrt(sum);
    return LOFT_OK;
}

enum loft_status loft_level_axis(loft_level *l, unsigned axis, loft_real height)
{
    const loft_vec none = { { 0 } };
    const loft_level made = { LOFT_LEVEL_AXIS, axis, none, loft_sci_zero(), height };

    if (axis >= LOFT_AXES)
        return LOFT_ERR_ARG;
    if (!loft_real_valid(height))
        return LOFT_ERR_RANGE;
    *l = made;
    return LOFT_OK;
}

enum loft_status loft_level_plane(loft_level *l, loft_vec direction, loft_real distance)
{
    return aim(l, LOFT_LEVEL_PLANE, direction, distance);
}

enum loft_status loft_level_light(loft_level *l, loft_vec direction, loft_real cosine)
{
    if (LOFT_AXES < 3 || !(cosine >= LOFT_REAL(-1) && cosine <= LOFT_REAL(1)))
        return LOFT_ERR_ARG;
    return aim(l, LOFT_LEVEL_LIGHT, direction, cosine);
}

static loft_sci axis_of(const loft_sci x[LOFT_AXES], int i)
{
    return i < LOFT_AXES ? x[i] : loft_sci_zero();
}

/* The length of n = a x b. */
static loft_sci cross_of(const loft_sci a[LOFT_AXES], const loft_sci b[LOFT_AXES], loft_sci n[3])
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = loft_sci_sub(loft_sci_mul(axis_of(a, j), axis_of(b, k)),
                            loft_sci_mul(axis_of(a, k), axis_of(b, j)));
        sum = loft_sci_add(sum, loft_sci_mul(n[i], n[i]));
    }
    return loft_sci_sqrt(sum);
}

static bool is_zero(const loft_sci x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (loft_sci_sign(x[i]) != 0)
            return false;
    return true;
}

/* The direction of the normal, and its length. */
static loft_sci normal_of(const loft_differential *d, loft_unit u, loft_unit v, loft_sci n[3])
{
    const loft_sci length = cross_of(d->u, d->v, n);

    if (loft_sci_sign(length) > 0)
        return length;
    if (is_zero(d->v) && !(u > 0))
        return cross_of(d->u, d->uv, n);
    if (is_zero(d->v) && !(u < LOFT_UNIT(1)))
        return cross_of(d->uv, d->u, n);
    if (is_zero(d->u) && !(v > 0))
        return cross_of(d->uv, d->v, n);
    if (is_zero(d->u) && !(v < LOFT_UNIT(1)))
        return cross_of(d->v, d->uv, n);
    return length;
}

static enum loft_status cosine_at(const loft_level *l, const loft_surface *s, loft_unit u,
                                  loft_unit v, loft_sci *out)
{
    loft_differential d;
    loft_sci n[3];

    if (s->differential == NULL)
        return LOFT_ERR_ARG;
    const enum loft_status status = s->differential(s->surface, u, v, &d);
    if (status != LOFT_OK)
        return status;
    const loft_sci length = normal_of(&d, u, v, n);
    *out = loft_sci_sign(length) > 0
               ? loft_sci_div(dot_of(n, &l->direction), loft_sci_mul(length, l->length))
               : loft_sci_from_real(l->height);
    return LOFT_OK;
}

enum loft_status loft_level_at(const loft_level *l, const loft_surface *s, loft_unit u, loft_unit v,
                               loft_vec *point, loft_acc *off)
{
    enum loft_status status = s->eval(s->surface, u, v, point);
    loft_sci x[3] = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero() }, value = x[0];

    if (status == LOFT_OK && l->kind == LOFT_LEVEL_AXIS)
        *off = loft_to_acc(point->axis[l->axis]) - loft_to_acc(l->height);
    if (status != LOFT_OK || l->kind == LOFT_LEVEL_AXIS)
        return status;
    for (int i = 0; i < 3 && i < LOFT_AXES; i++)
        x[i] = loft_sci_from_real(point->axis[i]);
    if (l->kind == LOFT_LEVEL_PLANE)
        value = loft_sci_div(dot_of(x, &l->direction), l->length);
    else
        status = cosine_at(l, s, u, v, &value);
    if (status == LOFT_OK &&
        !loft_sci_to_acc(loft_sci_sub(value, loft_sci_from_real(l->height)), off))
        status = LOFT_ERR_RANGE;
    return status;
}
