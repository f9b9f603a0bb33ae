/* lib/surface/net_nearest.c
 * SPDX-License-Identifier: MIT
 *
 * Branch and bound over dyadic parts, with all coordinates relative to p. Control points divided by
 * their weights hold a part in their hull, as weights are positive. For any direction e, no
 * point of a part is nearer than min <b_ij, e> over its net. e points to the middle of the part: if
 * the foot is in it, e is off the normal by the width h of the part over the distance, so the bound
 * is short by about h^2 (|P'|^2 / distance + |P''|). The distance from the box of the net bounds
 * parts near p. A part is dropped if its bound is not tol below the smallest distance found.
 *
 * Where the middle of a part is nearer than anything before, a local minimum is found from there.
 * With D = P - p the gradient of |D|^2 / 2 is (D P_u, D P_v), its second derivatives are P_u P_u +
 * D P_uu and so on. A parameter at an end whose gradient points outward is kept there. Steps of
 * Newton's method, or of Gauss and Newton's where the second derivatives are not positive, are
 * halved until the distance shrinks. At last the distance is flat to its rounding while the step
 * still improves: steps that shrink are then taken as well. */
#include "surface/net_nearest.h"

#define ROUNDS 60

/* The surface relative to p, the control points of a part of it, and the best place found. */
typedef struct {
    loft_net_form whole, piece;
    loft_sci u, v, best, tol;
} search;

static loft_sci length_of(const loft_sci d[LOFT_AXES])
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < LOFT_AXES; i++)
        sum = loft_sci_add(sum, loft_sci_mul(d[i], d[i]));
    return loft_sci_sqrt(sum);
}

static loft_sci dot_of(const loft_sci a[LOFT_AXES], const loft_sci b[LOFT_AXES])
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < LOFT_AXES; i++)
        sum = loft_sci_add(sum, loft_sci_mul(a[i], b[i]));
    return sum;
}

static loft_sci distance_at(const search *z, loft_sci u, loft_sci v)
{
    loft_sci d[LOFT_NET_JET][LOFT_AXES];

    loft_net_form_jet(&z->whole, 0, u, v, d);
    return length_of(d[LOFT_NET_POINT]);
}

/* Keep a parameter that is at an end and wants to leave. */
static bool is_held(loft_sci t, loft_sci slope)
{
    const loft_sci one = loft_sci_one();
    return (loft_sci_sign(t) <= 0 && loft_sci_sign(slope) >= 0) ||
           (!loft_sci_less(t, one) && loft_sci_sign(slope) <= 0);
}

static loft_sci clamped(loft_sci t)
{
    const loft_sci one = loft_sci_one();
    return loft_sci_sign(t) < 0 ? loft_sci_zero() : loft_sci_less(one, t) ? one : t;
}

/* Solve h x = -g for the free parameters; false if h is not positive. h = { uu, uv, vv } */
static bool solve_step(const loft_sci h[3], const loft_sci g[2], const bool held[2], loft_sci x[2])
{
    x[0] = x[1] = loft_sci_zero();
    if (held[0] || held[1]) {
        const int k = held[0];
        const loft_sci second = h[2 * k];
        if (loft_sci_sign(second) <= 0)
            return false;
        x[k] = loft_sci_neg(loft_sci_div(g[k], second));
        return true;
    }
    const loft_sci product = loft_sci_mul(h[0], h[2]);
    const loft_sci det = loft_sci_sub(product, loft_sci_mul(h[1], h[1]));
    if (loft_sci_sign(h[0]) <= 0 ||
        !loft_sci_less(loft_sci_mul(product, loft_sci_power2(-48)), det))
        return false;
    x[0] = loft_sci_div(loft_sci_sub(loft_sci_mul(h[1], g[1]), loft_sci_mul(h[2], g[0])), det);
    x[1] = loft_sci_div(loft_sci_sub(loft_sci_mul(h[1], g[0]), loft_sci_mul(h[0], g[1])), det);
    return true;
}

/* The step downhill; false at a minimum, or where there is none to take. */
static bool step_from(const search *z, loft_sci u, loft_sci v, loft_sci x[2])
{
    loft_sci d[LOFT_NET_JET][LOFT_AXES], h[3], gauss[3];

    loft_net_form_jet(&z->whole, 2, u, v, d);
    const loft_sci g[2] = { dot_of(d[LOFT_NET_POINT], d[LOFT_NET_BY_X]),
                            dot_of(d[LOFT_NET_POINT], d[LOFT_NET_BY_Y]) };
    const bool held[2] = { is_held(u, g[0]), is_held(v, g[1]) };
    if (held[0] && held[1])
        return false;
    gauss[0] = dot_of(d[LOFT_NET_BY_X], d[LOFT_NET_BY_X]);
    gauss[1] = dot_of(d[LOFT_NET_BY_X], d[LOFT_NET_BY_Y]);
    gauss[2] = dot_of(d[LOFT_NET_BY_Y], d[LOFT_NET_BY_Y]);
    for (unsigned k = 0; k < 3; k++)
        h[k] = loft_sci_add(gauss[k], dot_of(d[LOFT_NET_POINT], d[LOFT_NET_BY_XX + k]));
    return solve_step(h, g, held, x) || solve_step(gauss, g, held, x);
}

/* From (u, v) to a local minimum, and keep it if it is the nearest yet. */
static void descend(search *z, loft_sci u, loft_sci v)
{
    const loft_sci half = loft_sci_power2(-1), least = loft_sci_power2(-56);
    const loft_sci slack = loft_sci_add(loft_sci_one(), loft_sci_power2(-46));
    loft_sci now = distance_at(z, u, v), before = loft_sci_from_int(2), x[2];

    for (int round = 0; round < ROUNDS && step_from(z, u, v, x); round++) {
        bool moved = false;
        for (int tries = 0; tries < 24 && !moved; tries++) {
            const loft_sci to_u = clamped(loft_sci_add(u, x[0])),
                           to_v = clamped(loft_sci_add(v, x[1]));
            const loft_sci there = distance_at(z, to_u, to_v);
            const loft_sci way = loft_sci_add(loft_sci_abs(loft_sci_sub(to_u, u)),
                                              loft_sci_abs(loft_sci_sub(to_v, v)));
            moved = loft_sci_less(there, now) ||
                    (tries == 0 && loft_sci_less(way, loft_sci_mul(before, half)) &&
                     loft_sci_less(there, loft_sci_mul(now, slack)));
            if (moved) {
                u = to_u;
                v = to_v;
                now = there;
                before = way;
            }
            x[0] = loft_sci_mul(x[0], half);
            x[1] = loft_sci_mul(x[1], half);
        }
        if (!moved || loft_sci_less(before, least))
            break;
    }
    if (loft_sci_less(now, z->best)) {
        z->u = u;
        z->v = v;
        z->best = now;
    }
}

/* The distance of p from the box of the part's net. */
static loft_sci box_bound(const search *z)
{
    loft_sci d[LOFT_AXES];

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci_net *x = &z->piece.axis[axis];
        loft_sci low = x->c[0][0], high = low;
        for (unsigned i = 0; i <= x->m; i++)
            for (unsigned j = 0; j <= x->n; j++) {
                if (loft_sci_less(x->c[i][j], low))
                    low = x->c[i][j];
                if (loft_sci_less(high, x->c[i][j]))
                    high = x->c[i][j];
            }
        d[axis] = loft_sci_sign(low) > 0 ? low : loft_sci_sign(high) < 0 ? high : loft_sci_zero();
    }
    return length_of(d);
}

/* The distance of p from the plane in front of the net, seen from the middle of the part. */
static loft_sci plane_bound(const search *z, const loft_sci middle[LOFT_AXES], loft_sci far)
{
    const loft_sci_net *x = &z->piece.axis[0];
    loft_sci least = far;

    for (unsigned i = 0; i <= x->m; i++)
        for (unsigned j = 0; j <= x->n; j++) {
            loft_sci along = loft_sci_zero();
            for (int axis = 0; axis < LOFT_AXES; axis++)
                along = loft_sci_add(along,
                                     loft_sci_mul(z->piece.axis[axis].c[i][j], middle[axis]));
            along = loft_sci_div(along, far);
            if (loft_sci_less(along, least))
                least = along;
        }
    return least;
}

/* True if the part can hold a point that is tol nearer than the best one. */
static bool is_part_open(search *z, const loft_dyad part[2])
{
    const loft_sci half = loft_sci_power2(-1);
    const loft_sci limit = loft_sci_sub(z->best, z->tol);
    loft_sci middle[LOFT_NET_JET][LOFT_AXES];

    loft_net_form_sub(&z->whole, part, &z->piece);
    loft_net_form_jet(&z->piece, 0, half, half, middle);
    loft_net_form_points(&z->piece);
    if (!loft_sci_less(box_bound(z), limit))
        return false;
    const loft_sci far = length_of(middle[LOFT_NET_POINT]);
    if (loft_sci_less(far, z->best))
        descend(z, loft_dyad_place(part[0], half), loft_dyad_place(part[1], half));
    return loft_sci_sign(far) <= 0 ||
           loft_sci_less(plane_bound(z, middle[LOFT_NET_POINT], far), limit);
}

/* True if the net is longer along u, by its longest leg. */
static bool is_longer_along_u(const search *z)
{
    loft_sci most[2] = { loft_sci_zero(), loft_sci_zero() };

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci_net *x = &z->piece.axis[axis];
        for (unsigned i = 0; i <= x->m; i++)
            for (unsigned j = 0; j <= x->n; j++) {
                if (i > 0) {
                    const loft_sci leg = loft_sci_abs(loft_sci_sub(x->c[i][j], x->c[i - 1][j]));
                    const loft_sci by = loft_sci_mul(leg, loft_sci_from_int((int32_t)x->m));
                    most[0] = loft_sci_less(most[0], by) ? by : most[0];
                }
                if (j > 0) {
                    const loft_sci leg = loft_sci_abs(loft_sci_sub(x->c[i][j], x->c[i][j - 1]));
                    const loft_sci by = loft_sci_mul(leg, loft_sci_from_int((int32_t)x->n));
                    most[1] = loft_sci_less(most[1], by) ? by : most[1];
                }
            }
    }
    return !loft_sci_less(most[0], most[1]);
}

/* The nearest of 5 x 5 points and its minimum: a good start makes the bound sharp. */
static void start_search(search *z)
{
    loft_sci u = loft_sci_zero(), v = u, best = distance_at(z, u, v);

    z->u = u;
    z->v = v;
    z->best = best;
    for (int32_t k = 1; k < 25; k++) {
        const loft_sci quarter = loft_sci_power2(-2);
        const loft_sci to_u = loft_sci_mul(loft_sci_from_int(k / 5), quarter),
                       to_v = loft_sci_mul(loft_sci_from_int(k % 5), quarter);
        const loft_sci there = distance_at(z, to_u, to_v);
        if (loft_sci_less(there, best)) {
            best = there;
            u = to_u;
            v = to_v;
        }
    }
    descend(z, u, v);
}

/* False if there are too many parts. */
static bool walk_parts(search *z)
{
    loft_dyad_box part;
    uint32_t left = LOFT_NET_NEAREST_PARTS;

    loft_dyad_box_start(&part);
    do {
        for (;;) {
            if (left-- == 0)
                return false;
            const bool last_u = part.n[0].level == LOFT_DYAD_LEVELS,
                       last_v = part.n[1].level == LOFT_DYAD_LEVELS;
            if (!is_part_open(z, part.n) || (last_u && last_v))
                break;
            loft_dyad_box_halve(&part, !last_u && (last_v || is_longer_along_u(z)) ? 0 : 1);
        }
    } while (loft_dyad_box_next(&part));
    return true;
}

enum loft_status loft_net_nearest(loft_net s, loft_vec p, loft_real tol, loft_net_near *out)
{
    loft_sci d[LOFT_NET_JET][LOFT_AXES];
    loft_unit at[2];
    loft_net_near near;
    search z;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    if (!loft_vec_valid(p))
        return LOFT_ERR_RANGE;
    loft_net_load(s, p, &z.whole);
    z.tol = loft_sci_from_real(tol);
    start_search(&z);
    const bool proved = walk_parts(&z);

    loft_net_form_jet(&z.whole, 0, z.u, z.v, d);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        loft_acc x;
        if (!loft_sci_to_acc(d[LOFT_NET_POINT][axis], &x))
            return LOFT_ERR_RANGE;
        near.point.axis[axis] = loft_acc_round(loft_to_acc(p.axis[axis]) + x);
    }
    if (!loft_sci_to_acc(z.best, &near.distance))
        return LOFT_ERR_RANGE;
    loft_net_form_place(&z.whole, z.u, z.v, at);
    near.u = at[0];
    near.v = at[1];
    *out = near;
    return proved ? LOFT_OK : LOFT_MORE;
}
