/* lib/polygon/disk_kite.c
 * SPDX-License-Identifier: MIT
 *
 * Patches with base points and Zheng-Ball patches are divided into kites, one for each corner k. s
 * runs along side k and t along side k - 1, each from 0 to 1 at the middle of the side. s = t = 1
 * is the middle of the patch. In a kite the path is straight. Kites meet where two parameters are
 * equal.
 */
#include "polygon/disk.h"
#include "polygon/disk_part.h"

static loft_unit unit_product(loft_unit a, loft_unit b)
{
    return loft_unit_round(loft_acc_scale(loft_unit_to_acc(a), b));
}

typedef struct {
    unsigned corner;
    loft_unit s, t;
} kite;

/* The place at u on the path from the middle to `share` of a side. */
static kite kite_of(const loft_disk *r, unsigned side, loft_unit share, loft_unit u)
{
    const bool first = share <= LOFT_UNIT(0.5);
    /* 1 - s or 1 - t on the side */
    const loft_unit far = loft_disk_rest(2 * (first ? share : loft_disk_rest(share)));
    const loft_unit on = loft_disk_rest(unit_product(u, far)), off = loft_disk_rest(u);
    const kite k = { first ? side : loft_disk_next(side, r->sides), first ? on : off,
                     first ? off : on };

    return k;
}

static void swap_vectors(loft_sci a[LOFT_AXES], loft_sci b[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci x = a[i];
        a[i] = b[i];
        b[i] = x;
    }
}

/* The parameters of a corner turn the other way round. At a corner that is not cut v = 0 is one
 * point: there the shares of the triangle's corners are taken. */
static enum loft_status basepoint_slopes(const loft_basepoint *b, unsigned corner, loft_unit u,
                                         loft_unit v, loft_differential *out)
{
    const loft_unit next = unit_product(loft_disk_rest(u), v);
    loft_unit phi[3], last = unit_product(u, v);
    enum loft_status status;

    if (b->cut[corner]) {
        status = loft_basepoint_corner_differential(b, corner, u, v, out);
        if (status == LOFT_OK) {
            swap_vectors(out->u, out->v);
            swap_vectors(out->uu, out->vv);
        }
        return status;
    }
    if (next + last > LOFT_UNIT(1))
        last = loft_disk_rest(next);
    phi[corner] = loft_disk_rest(next + last);
    phi[(corner + 1) % 3] = next;
    phi[(corner + 2) % 3] = last;
    return loft_basepoint_differential(b, phi[0], phi[1], out);
}

/* Three kinds of corners: a side of a cut corner of the triangle begins or ends there, or the
 * corner is not cut. v is 1 minus the share of the corner itself. w and 1 - w are the parts of v
 * that belong to the next and the last corner of the triangle. The kite ends at the lines where two
 * of the three shares are equal,
 *
 *     begins: w = s/2, v = t / (2 - w)      ends: w = 1 - t/2, v = s / (1 + w)
 *     not cut: shares s/2 (1 - t/2) and t/2 (1 - s/2), over 1 - s t / 4 */
static enum loft_status basepoint_at(const loft_disk *r, unsigned side, loft_unit share,
                                     loft_unit u, loft_vec *out, loft_differential *slopes)
{
    const kite k = kite_of(r, side, share, u);
    const loft_basepoint *b = (const loft_basepoint *)r->patch;
    const loft_basepoint_side here = loft_basepoint_side_of(b, k.corner);
    const loft_acc one = loft_unit_to_acc(LOFT_UNIT(1)), s = loft_unit_to_acc(k.s),
                   t = loft_unit_to_acc(k.t);
    loft_unit w = 0, v = 0;

    if (here.cut) {
        w = loft_unit_ratio(s, 2 * one);
        v = loft_unit_ratio(t, 2 * one - loft_unit_to_acc(w));
    } else if (b->cut[here.corner]) {
        w = loft_disk_rest(loft_unit_ratio(t, 2 * one));
        v = loft_unit_ratio(s, one + loft_unit_to_acc(w));
    } else {
        const loft_acc both = loft_unit_to_acc(unit_product(k.s, k.t)), next = 2 * s - both,
                       last = 2 * t - both;
        v = loft_unit_ratio(next + last, 4 * one - both);
        w = next + last > 0 ? loft_unit_ratio(next, next + last) : 0;
    }
    return slopes ? basepoint_slopes(b, here.corner, loft_disk_rest(w), v, slopes)
                  : loft_basepoint_corner(b, here.corner, loft_disk_rest(w), v, out);
}

void loft_disk_from_basepoint(loft_disk *r, const loft_basepoint *b)
{
    loft_disk_begin(r, loft_basepoint_sides(b), basepoint_at, LOFT_DISK_OF_BASEPOINT, b);
}

/* The parameter a that sides i - 1 and i + 1 have in common when side i has b:
 *
 *     5 sides   b a^2 - 2 a + 1 = 0,  a = 1 / (1 + sqrt(1 - b))
 *     6 sides   2 b a^3 - 4 a^2 + b a + 1 = 0, by Newton's method from 1/2 + 0.29 b, which
 *               is within 0.02 */
static loft_sci balanced_param(unsigned sides, loft_sci b)
{
    const loft_sci one = loft_sci_one(), two = loft_sci_from_int(2), four = loft_sci_from_int(4);
    loft_sci a;

    if (sides == 5)
        return loft_sci_div(one, loft_sci_add(one, loft_sci_sqrt(loft_sci_sub(one, b))));
    a = loft_sci_add(loft_sci_from_unit(LOFT_UNIT(0.5)),
                     loft_sci_mul(b, loft_sci_from_unit(LOFT_UNIT(0.29))));
    for (int step = 0; step < 4; step++) {
        const loft_sci ab = loft_sci_mul(a, b), aab = loft_sci_mul(a, ab), aa = loft_sci_mul(a, a);
        const loft_sci f = loft_sci_add(
            loft_sci_sub(loft_sci_mul(two, loft_sci_mul(a, aab)), loft_sci_mul(four, aa)),
            loft_sci_add(ab, one));
        const loft_sci d = loft_sci_add(loft_sci_sub(loft_sci_mul(loft_sci_from_int(6), aab),
                                                     loft_sci_mul(loft_sci_from_int(8), a)),
                                        b);
        a = loft_sci_sub(a, loft_sci_div(f, d));
    }
    return a;
}

/* s balanced_param(c t). c is the value of all parameters in the middle: (sqrt 5 - 1) / 2 or
 * sqrt(1/2). */
static loft_unit zheng_ball_param(unsigned sides, loft_unit s, loft_unit t)
{
    const loft_sci middle = loft_sci_from_unit(sides == 5 ? LOFT_UNIT(0.6180339887498949)
                                                          : LOFT_UNIT(0.7071067811865476));
    const loft_sci a = loft_sci_mul(
        loft_sci_from_unit(s), balanced_param(sides, loft_sci_mul(middle, loft_sci_from_unit(t))));
    loft_acc wide = 0;

    return loft_sci_to_acc(a, &wide) ? loft_unit_round(wide) : 0;
}

/* Three sides: u_i belongs to corner i + 2, opposite side i. */
static enum loft_status triple_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                  loft_vec *out, loft_differential *slopes)
{
    const loft_zheng_ball *g = (const loft_zheng_ball *)r->patch;
    loft_jet jet[3];
    loft_unit of[3] = { 0, 0, 0 };
    loft_sci parameter[3];

    of[loft_disk_next(side, 3)] = share;
    of[side] = loft_disk_rest(share);
    for (int i = 0; i < 3; i++)
        of[i] = loft_unit_round(
            loft_acc_lerp(loft_unit_to_acc(loft_unit_of(1, 3)), loft_unit_to_acc(of[i]), u));
    if (of[0] + of[2] > LOFT_UNIT(1))
        of[0] = loft_disk_rest(of[2]);
    const enum loft_status status = slopes ? loft_zheng_ball_lift_jet(of[2], of[0], jet)
                                           : loft_zheng_ball_lift(of[2], of[0], parameter);
    if (status != LOFT_OK)
        return status;
    if (!slopes)
        return loft_zheng_ball_eval(g, parameter, out);
    loft_zheng_ball_differential(g, jet, slopes);
    return LOFT_OK;
}

static enum loft_status zheng_ball_at(const loft_disk *r, unsigned side, loft_unit share,
                                      loft_unit u, loft_vec *out, loft_differential *slopes)
{
    const loft_zheng_ball *g = (const loft_zheng_ball *)r->patch;
    const unsigned n = r->sides;
    const kite k = kite_of(r, side, share, u);
    const loft_unit a = zheng_ball_param(n, k.s, k.t), b = zheng_ball_param(n, k.t, k.s);
    loft_sci turned[LOFT_ZHENG_BALL_SIDES], parameter[LOFT_ZHENG_BALL_SIDES];
    loft_jet turned_jet[LOFT_ZHENG_BALL_SIDES], jet[LOFT_ZHENG_BALL_SIDES];
    const enum loft_status status = slopes ? loft_zheng_ball_params_jet(n, a, b, turned_jet)
                                           : loft_zheng_ball_params(n, a, b, turned);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < n; i++) {
        const unsigned to = (k.corner + n - 1 + i) % n;
        if (slopes)
            jet[to] = turned_jet[i];
        else
            parameter[to] = turned[i];
    }
    if (!slopes)
        return loft_zheng_ball_eval(g, parameter, out);
    loft_zheng_ball_differential(g, jet, slopes);
    return LOFT_OK;
}

void loft_disk_from_zheng_ball(loft_disk *r, const loft_zheng_ball *g)
{
    loft_disk_begin(r, g->sides, g->sides == 3 ? triple_at : zheng_ball_at, LOFT_DISK_OF_ZHENG_BALL,
                    g);
}
