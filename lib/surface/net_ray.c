/* lib/surface/net_ray.c
 * SPDX-License-Identifier: MIT
 *
 * Let k be the axis of the longest component of the direction d, and i one of the others. P is on
 * the line if d_k (P_i - o_i) = d_i (P_k - o_k) for both i: two polynomials f, g in u, v. A part of
 * the patch where the coefficients of f or of g are all of one sign has no root.
 *
 * With J the derivatives of (f, g) in the middle of a part, in its own parameters x, y in 0..1, h =
 * J^-1 (f, g) has the same roots, and derivatives near 1 0 / 0 1. Its coefficients exclude a part
 * sharply. Let a_ij bound the derivatives' differences from those, by the legs of the nets. If a_i1
 * + a_i2 < 1 in both rows, no two points of the part have the same h: there is at most one root.
 * Newton's method finds it, or leaves the part; then the part is halved.
 *
 * At the level LAST nothing is left but parts where J has no inverse that bounds them: touches.
 * Neighbouring ones are one. Roots on an edge between parts are found from both: hits within 2^-24
 * are one, since unique roots of neighbours can only be closer than the parts if J is nearly
 * singular.
 *
 * Rounding: f and g are within 2^-46 of the largest product, for double as well as for the 62 bits
 * of q16: 3 (m + n) + 4 roundings and a guard. A coefficient is of one sign if it is larger. */
#include "surface/net_ray.h"

#if LOFT_AXES >= 3

#define LAST 22

typedef struct {
    loft_sci_net whole[2], piece[2];
    loft_sci noise[2];              /* of f and g, then of h in this part */
    loft_sci jacobian[4];           /* f_u, f_v, g_u, g_v in the middle of the part */
    loft_net s;
    loft_vec from, direction;
    loft_ray_hit *out;
    unsigned room, *count;
    bool fits, full;
} search;

static void load_nets(search *z)
{
    loft_net_form form;
    int k = 0;

    loft_net_load(z->s, z->from, &form);
    for (int i = 1; i < 3; i++)
        if (loft_acc_abs(loft_to_acc(z->direction.axis[i])) >
            loft_acc_abs(loft_to_acc(z->direction.axis[k])))
            k = i;
    const loft_sci dk = loft_sci_from_real(z->direction.axis[k]);
    for (int f = 0; f < 2; f++) {
        const int axis = (k + 1 + f) % 3;
        const loft_sci di = loft_sci_from_real(z->direction.axis[axis]);
        loft_sci_net *x = &z->whole[f];
        loft_sci most = loft_sci_zero();
        x->m = form.axis[0].m;
        x->n = form.axis[0].n;
        for (unsigned i = 0; i <= x->m; i++)
            for (unsigned j = 0; j <= x->n; j++) {
                const loft_sci one = loft_sci_mul(dk, form.axis[axis].c[i][j]),
                               two = loft_sci_mul(di, form.axis[k].c[i][j]);
                x->c[i][j] = loft_sci_sub(one, two);
                if (loft_sci_less(most, loft_sci_abs(one)))
                    most = loft_sci_abs(one);
                if (loft_sci_less(most, loft_sci_abs(two)))
                    most = loft_sci_abs(two);
            }
        z->noise[f] = loft_sci_mul(most, loft_sci_power2(-46));
    }
}

/* True if all coefficients are of one sign. */
static bool has_no_root(const loft_sci_net *x, loft_sci noise)
{
    bool above = false, below = false;

    for (unsigned i = 0; i <= x->m; i++)
        for (unsigned j = 0; j <= x->n; j++) {
            above = above || !loft_sci_less(x->c[i][j], noise);
            below = below || !loft_sci_less(loft_sci_neg(x->c[i][j]), noise);
            if (loft_sci_less(loft_sci_abs(x->c[i][j]), noise) || (above && below))
                return false;
        }
    return true;
}

/* The longest leg along u or v, less `by`, times the degree. */
static loft_sci leg_bound(const loft_sci_net *x, bool along_u, loft_sci by)
{
    const loft_sci degree = loft_sci_from_int((int32_t)(along_u ? x->m : x->n));
    loft_sci most = loft_sci_zero();

    if ((along_u ? x->m : x->n) == 0)
        return loft_sci_abs(by);
    for (unsigned i = along_u; i <= x->m; i++)
        for (unsigned j = !along_u; j <= x->n; j++) {
            const loft_sci leg = loft_sci_sub(x->c[i][j],
                                              along_u ? x->c[i - 1][j] : x->c[i][j - 1]);
            const loft_sci off = loft_sci_abs(loft_sci_sub(loft_sci_mul(degree, leg), by));
            if (loft_sci_less(most, off))
                most = off;
        }
    return most;
}

/* From (f, g) to h, with its noise; false if J has no inverse. */
static bool precondition(search *z, loft_sci noise[2])
{
    const loft_sci *j = z->jacobian;
    const loft_sci one = loft_sci_mul(j[0], j[3]), two = loft_sci_mul(j[1], j[2]);
    const loft_sci det = loft_sci_sub(one, two);
    const loft_sci size = loft_sci_add(loft_sci_abs(one), loft_sci_abs(two));

    if (!loft_sci_less(loft_sci_mul(size, loft_sci_power2(-30)), loft_sci_abs(det)))
        return false;
    const loft_sci a = loft_sci_div(j[3], det), b = loft_sci_div(j[1], det),
                   c = loft_sci_div(j[2], det), d = loft_sci_div(j[0], det);
    loft_sci_net *f = &z->piece[0], *g = &z->piece[1];
    for (unsigned i = 0; i <= f->m; i++)
        for (unsigned k = 0; k <= f->n; k++) {
            const loft_sci x = f->c[i][k], y = g->c[i][k];
            f->c[i][k] = loft_sci_sub(loft_sci_mul(a, x), loft_sci_mul(b, y));
            g->c[i][k] = loft_sci_sub(loft_sci_mul(d, y), loft_sci_mul(c, x));
        }
    noise[0] = loft_sci_add(loft_sci_mul(loft_sci_abs(a), z->noise[0]),
                            loft_sci_mul(loft_sci_abs(b), z->noise[1]));
    noise[1] = loft_sci_add(loft_sci_mul(loft_sci_abs(d), z->noise[1]),
                            loft_sci_mul(loft_sci_abs(c), z->noise[0]));
    return true;
}

/* True if h has at most one root in the part. */
static bool is_root_unique(const search *z)
{
    const loft_sci one = loft_sci_one(), zero = loft_sci_zero();
    const loft_sci limit = loft_sci_sub(one, loft_sci_power2(-10));

    for (int f = 0; f < 2; f++) {
        const loft_sci_net *x = &z->piece[f];
        const loft_sci along = leg_bound(x, true, f == 0 ? one : zero),
                       across = leg_bound(x, false, f == 0 ? zero : one);
        if (!loft_sci_less(loft_sci_add(along, across), limit))
            return false;
    }
    return true;
}

/* Newton's method on h; false if it leaves the part. */
static bool find_root(const search *z, loft_sci x[2])
{
    const loft_sci_net *f = &z->piece[0], *g = &z->piece[1];
    const loft_sci far = loft_sci_power2(1), least = loft_sci_power2(-44);
    const loft_sci low = loft_sci_neg(loft_sci_power2(-30)),
                   high = loft_sci_add(loft_sci_one(), loft_sci_power2(-30));

    x[0] = x[1] = loft_sci_power2(-1);
    for (int round = 0; round < 50; round++) {
        const loft_sci p = loft_sci_net_deriv(f, 0, 0, x[0], x[1]),
                       q = loft_sci_net_deriv(g, 0, 0, x[0], x[1]);
        const loft_sci a = loft_sci_net_deriv(f, 1, 0, x[0], x[1]),
                       b = loft_sci_net_deriv(f, 0, 1, x[0], x[1]),
                       c = loft_sci_net_deriv(g, 1, 0, x[0], x[1]),
                       d = loft_sci_net_deriv(g, 0, 1, x[0], x[1]);
        const loft_sci det = loft_sci_sub(loft_sci_mul(a, d), loft_sci_mul(b, c));
        if (loft_sci_sign(det) <= 0)
            return false;
        const loft_sci up = loft_sci_div(loft_sci_sub(loft_sci_mul(b, q), loft_sci_mul(d, p)), det),
                       on = loft_sci_div(loft_sci_sub(loft_sci_mul(c, p), loft_sci_mul(a, q)), det);
        x[0] = loft_sci_add(x[0], up);
        x[1] = loft_sci_add(x[1], on);
        if (loft_sci_less(far, loft_sci_abs(x[0])) || loft_sci_less(far, loft_sci_abs(x[1])))
            return false;
        if (loft_sci_less(loft_sci_abs(up), least) && loft_sci_less(loft_sci_abs(on), least))
            return !loft_sci_less(x[0], low) && !loft_sci_less(high, x[0]) &&
                   !loft_sci_less(x[1], low) && !loft_sci_less(high, x[1]);
    }
    return false;
}

/* t of the place; false if it is behind the start. */
static bool ray_place(search *z, loft_sci u, loft_sci v, loft_acc *t, loft_unit at[2])
{
    loft_sci above = loft_sci_zero(), below = loft_sci_zero(), size = loft_sci_zero();
    loft_sci p[LOFT_NET_JET][LOFT_AXES];
    loft_net_form form;

    *t = 0;
    loft_net_load(z->s, z->from, &form);
    loft_net_form_place(&form, u, v, at);
    loft_net_form_jet(&form, 0, u, v, p);
    loft_net_form_points(&form);
    for (int axis = 0; axis < 3; axis++) {
        const loft_sci d = loft_sci_from_real(z->direction.axis[axis]);
        for (unsigned i = 0; i <= form.axis[axis].m; i++)
            for (unsigned j = 0; j <= form.axis[axis].n; j++) {
                const loft_sci product = loft_sci_abs(loft_sci_mul(form.axis[axis].c[i][j], d));
                if (loft_sci_less(size, product))
                    size = product;
            }
        above = loft_sci_add(above, loft_sci_mul(d, p[LOFT_NET_POINT][axis]));
        below = loft_sci_add(below, loft_sci_mul(d, d));
    }
    if (loft_sci_less(above, loft_sci_mul(size, loft_sci_power2(-40))))
        return !loft_sci_less(above, loft_sci_neg(loft_sci_mul(size, loft_sci_power2(-40))));
    z->fits = loft_sci_to_acc(loft_sci_div(above, below), t) && z->fits;
    return true;
}

static bool is_close(loft_unit a, loft_unit b, loft_unit gap)
{
    return a - b <= gap && b - a <= gap;
}

/* Insert, sorted by t; a place that is known is not inserted again. */
static void add_hit(search *z, const loft_ray_hit *hit)
{
    unsigned k = 0;
    const loft_unit gap = hit->touch ? LOFT_UNIT(1.0 / 65536) : LOFT_UNIT(1.0 / 4194304);

    for (k = 0; k < *z->count; k++)
        if (z->out[k].touch == hit->touch && is_close(z->out[k].u, hit->u, gap) &&
            is_close(z->out[k].v, hit->v, gap))
            return;
    if (*z->count == z->room) {
        z->full = true;
        return;
    }
    for (k = (*z->count)++; k > 0 && z->out[k - 1].t > hit->t; k--)
        z->out[k] = z->out[k - 1];
    z->out[k] = *hit;
}

static bool is_on_edge(loft_sci x)
{
    const loft_sci one = loft_sci_one(), slack = loft_sci_power2(-30);
    return loft_sci_less(x, slack) || loft_sci_less(loft_sci_sub(one, slack), x);
}

static void add_place(search *z, const loft_dyad part[2], const loft_sci x[2], bool touch)
{
    const loft_sci zero = loft_sci_zero(), one = loft_sci_one();
    loft_sci at[2] = { loft_dyad_place(part[0], x[0]), loft_dyad_place(part[1], x[1]) };
    loft_unit place[2];
    loft_ray_hit hit;

    hit.touch = touch;
    hit.edge = is_on_edge(at[0]) || is_on_edge(at[1]);
    for (int k = 0; k < 2; k++)
        at[k] = loft_sci_less(at[k], zero) ? zero : loft_sci_less(one, at[k]) ? one : at[k];
    if (ray_place(z, at[0], at[1], &hit.t, place)) {
        hit.u = place[0];
        hit.v = place[1];
        add_hit(z, &hit);
    }
}

/* True if nothing is left to do in this part. */
static bool is_part_done(search *z, const loft_dyad part[2])
{
    const loft_sci half = loft_sci_power2(-1);
    const loft_sci rough = loft_sci_power2(-10);
    loft_sci noise[2], x[2];

    for (int f = 0; f < 2; f++) {
        loft_sci_net_sub(&z->whole[f], part, &z->piece[f]);
        if (has_no_root(&z->piece[f], z->noise[f]))
            return true;
        z->jacobian[2 * f] = loft_sci_net_deriv(&z->piece[f], 1, 0, half, half);
        z->jacobian[2 * f + 1] = loft_sci_net_deriv(&z->piece[f], 0, 1, half, half);
    }
    if (!precondition(z, noise))
        return false;
    if (has_no_root(&z->piece[0], noise[0]) || has_no_root(&z->piece[1], noise[1]))
        return true;
    if (loft_sci_less(rough, noise[0]) || loft_sci_less(rough, noise[1]) || !is_root_unique(z) ||
        !find_root(z, x))
        return false;
    add_place(z, part, x, false);
    return true;
}

/* The parameter that f and g change more with. */
static bool is_longer_along_u(const search *z)
{
    const loft_sci zero = loft_sci_zero();
    loft_sci along = zero, across = zero;

    for (int f = 0; f < 2; f++) {
        along = loft_sci_add(along, leg_bound(&z->piece[f], true, zero));
        across = loft_sci_add(across, leg_bound(&z->piece[f], false, zero));
    }
    return !loft_sci_less(along, across);
}

/* False if there are too many parts. */
static bool walk_parts(search *z)
{
    const loft_sci middle[2] = { loft_sci_power2(-1), loft_sci_power2(-1) };
    loft_dyad_box part;
    uint32_t left = LOFT_NET_RAY_PARTS;

    loft_dyad_box_start(&part);
    do {
        while (!is_part_done(z, part.n)) {
            const bool last_u = part.n[0].level == LAST, last_v = part.n[1].level == LAST;
            if (left-- == 0)
                return false;
            const bool corner = z->s.triangle && last_u && part.n[0].k == 0;
            if (corner || (last_u && last_v)) {
                add_place(z, part.n, middle, true);
                break;
            }
            loft_dyad_box_halve(&part, !last_u && (last_v || is_longer_along_u(z)) ? 0 : 1);
        }
    } while (!z->full && loft_dyad_box_next(&part));
    return !z->full;
}

#endif

enum loft_status loft_net_ray(loft_net s, loft_vec from, loft_vec direction, loft_ray_hit out[],
                              unsigned room, unsigned *count)
{
    *count = 0;
#if LOFT_AXES < 3
    (void)s;
    (void)from;
    (void)direction;
    (void)out;
    (void)room;
    return LOFT_ERR_ARG;
#else
    search z = { .s = s,
                 .from = from,
                 .direction = direction,
                 .out = out,
                 .room = room,
                 .count = count,
                 .fits = true,
                 .full = false };
    bool aims = false, touches = false;

    if (!loft_vec_valid(from) || !loft_vec_valid(direction))
        return LOFT_ERR_RANGE;
    for (int axis = 0; axis < 3; axis++)
        aims = aims || direction.axis[axis] > 0 || direction.axis[axis] < 0;
    if (!aims)
        return LOFT_ERR_ARG;
    load_nets(&z);
    const bool complete = walk_parts(&z);
    if (!z.fits) {
        *count = 0;
        return LOFT_ERR_RANGE;
    }
    for (unsigned k = 0; k < *count; k++)
        touches = touches || out[k].touch;
    return !complete ? LOFT_MORE : touches ? LOFT_SINGULAR : LOFT_OK;
#endif
}
