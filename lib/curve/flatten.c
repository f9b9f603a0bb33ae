/* lib/curve/flatten.c -- chords within a tolerance (curve/measure.h)
 * SPDX-License-Identifier: MIT
 *
 * A piece of the curve with the control points b0..b3 and a chord, the closed segment between the *rounded*
 * ends A and B. The distance to a segment is a convex function, so along the piece
 *
 *     distance(P(t)) <= B0(t) d0 + B1(t) d1 + B2(t) d2 + B3(t) d3         d_i = distance of b_i
 *
 * With m = max(d0, d3) (the rounding of the ends, or the middle of a halved piece), a >= b the excesses of
 * d1 and d2 over m or 0, and B1 + B2 <= 3/4, max B1 = max B2 = 4/9, this is at most
 *
 *     m + 3/4 b + 4/9 (a - b)                                                                      (1)
 *
 * A piece that misses (1) is halved, its halves are held against the same chord; twice at most. Exact for
 * equal d1, d2 and for d2 = 0; the halves take care of an inflection, where d1 and d2 are on opposite sides.
 *
 * The other direction: the nearest point on the chord moves continuously with t and comes within the
 * rounding of both ends, so every point of the chord is the nearest one of some P(t), or lies within the
 * rounding of an end.
 *
 * The search. From the parameter s of the last point the ends of the dyadic intervals that hold s are tried,
 * from the largest down to the first that succeeds; between that end and the one before it is halved.
 * Halving the curve at the middle until both inner points are within tol gives dyadic pieces for which (1)
 * is at most 3/4 tol. By induction the chords here are never behind: at s in such a piece its end is tried. */
#include "curve/measure.h"

#define STEPS ((uint32_t)1 << 24)   /* of the parameter: all are exact in every number type */
#define FINE  256                   /* ends are found to 1 / FINE of the chord             */
#define HALF  LOFT_UNIT(0.5)

/* A piece relative to A, and the distances of its control points. */
typedef struct {
    loft_acc p[4][LOFT_AXES];
    loft_acc d[4];
    uint8_t  level;
} piece;

/* The chord from 0 to u, its length, and its direction to 24 bits. */
typedef struct {
    loft_acc  u[LOFT_AXES];
    loft_acc  length;
    loft_unit toward[LOFT_AXES];
} chord;


/* The distance of w from the chord: that of w from a point of the chord which is nearest but for rounding, so
 * never too small.
 *
 * The first foot, t u, is off along the chord by up to 2^-23 |u|, which is too much at a right angle to
 * nothing, but r = w - t u shows by how much: the part of r along the chord. Taking that off again needs
 * the direction to few digits only. The foot must not leave the chord; `most` leaves 2^-20 of the way to
 * each end, more than the lengths are wrong by. */
static loft_acc distance(const loft_acc w[LOFT_AXES], const chord *c)
{
    loft_acc r[LOFT_AXES], along = 0, rest = 0;
    loft_unit t = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        along += loft_acc_scale(w[i], c->toward[i]);
    if (along > 0)
        t = along < c->length ? loft_unit_ratio(along, c->length) : LOFT_UNIT(1);

    for (int i = 0; i < LOFT_AXES; i++) {
        r[i] = w[i] - loft_acc_scale(c->u[i], t);
        rest += loft_acc_scale(r[i], c->toward[i]);
    }
    const loft_acc back = loft_acc_scale(c->length, t), most = loft_acc_scale(back, LOFT_UNIT(1 - 1.0 / 1048576));
    const loft_acc ahead = loft_acc_scale(c->length - back, LOFT_UNIT(1 - 1.0 / 1048576));
    if (rest < -most)
        rest = -most;
    if (rest > ahead)
        rest = ahead;
    for (int i = 0; i < LOFT_AXES; i++)
        r[i] -= loft_acc_scale(rest, c->toward[i]);
    return loft_acc_hypot(r, LOFT_AXES);
}

static void aim(chord *c)
{
    c->length = loft_acc_hypot(c->u, LOFT_AXES);
    for (int i = 0; i < LOFT_AXES; i++)
        c->toward[i] = c->length > 0 ? loft_unit_ratio(c->u[i], c->length) : 0;
}

/* The bound (1) times 36. */
static bool is_within(const loft_acc d[4], loft_acc limit)
{
    const loft_acc m = d[0] > d[3] ? d[0] : d[3];
    loft_acc a = d[1] > d[2] ? d[1] : d[2], b = d[1] > d[2] ? d[2] : d[1];

    a = a > m ? a - m : 0;
    b = b > m ? b - m : 0;
    return 36 * m + 16 * a + 11 * b <= 36 * limit;
}

/* The first half stays in *a, the second goes to *b. False when the middle is too far. */
static bool halve(piece *a, piece *b, const chord *c, loft_acc limit)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc q = loft_acc_lerp(a->p[1][i], a->p[2][i], HALF);
        b->p[3][i] = a->p[3][i];
        b->p[2][i] = loft_acc_lerp(a->p[2][i], a->p[3][i], HALF);
        a->p[1][i] = loft_acc_lerp(a->p[0][i], a->p[1][i], HALF);
        b->p[1][i] = loft_acc_lerp(q, b->p[2][i], HALF);
        a->p[2][i] = loft_acc_lerp(a->p[1][i], q, HALF);
        b->p[0][i] = a->p[3][i] = loft_acc_lerp(a->p[2][i], b->p[1][i], HALF);
    }
    b->d[3] = a->d[3];
    b->d[0] = a->d[3] = distance(b->p[0], c);
    b->level = ++a->level;
    return b->d[0] <= limit;
}

static void measure(piece *a, const chord *c, int from, int to)
{
    for (int k = from; k <= to; k++)
        a->d[k] = distance(a->p[k], c);
}

/* The piece from..to of one axis: the blossoms b[from,from,from] b[from,from,to] b[from,to,to] b[to,to,to]. */
static void cut(const loft_cubic *curve, int axis, loft_unit from, loft_unit to, loft_acc out[4])
{
    loft_acc a[4], b[4];

    for (int k = 0; k < 4; k++)
        a[k] = b[k] = loft_wide(curve->p[k].axis[axis]);
    for (unsigned degree = 3; degree > 1; degree--) {
        loft_bernstein_step(a, degree, from);
        loft_bernstein_step(b, degree, to);
    }
    out[0] = loft_acc_lerp(a[0], a[1], from);
    out[1] = loft_acc_lerp(a[0], a[1], to);
    out[2] = loft_acc_lerp(b[0], b[1], from);
    out[3] = loft_acc_lerp(b[0], b[1], to);
}

/* May a chord lead from the last point to the one at `to`? */
static bool is_flat(const loft_flatten *f, uint32_t to, loft_vec *end)
{
    piece part[3];
    chord c;
    int   n = 1;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc from = loft_wide(f->last.axis[i]);
        loft_acc p[4];

        cut(&f->curve, i, loft_unit_of(f->at, STEPS), loft_unit_of(to, STEPS), p);
        end->axis[i] = loft_acc_round(p[3]);
        c.u[i] = loft_wide(end->axis[i]) - from;
        for (int k = 0; k < 4; k++)
            part[0].p[k][i] = p[k] - from;
    }
    aim(&c);
    part[0].level = 0;
    measure(&part[0], &c, 0, 3);

    while (n) {
        piece *last = &part[n - 1];
        if (is_within(last->d, f->limit)) {
            n--;
            continue;
        }
        if (last->level == 2 || !halve(last, last + 1, &c, f->limit))
            return false;
        measure(last, &c, 1, 2);
        measure(last + 1, &c, 1, 2);
        n++;
    }
    return true;
}

/* One step of the parameter is always flat: its inner points are within 2^-44 of the largest coordinate of the
 * exact chord, below 1/4 of the smallest tolerance. */
enum loft_status loft_flatten_init(loft_flatten *f, const loft_cubic *c, loft_real tol)
{
    const loft_acc wide = loft_wide(tol);
    loft_acc size = 0;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_acc x = loft_wide(c->p[k].axis[i]);
            if (!loft_real_valid(c->p[k].axis[i]))
                return LOFT_ERR_RANGE;
            if (size < (x < 0 ? -x : x))
                size = x < 0 ? -x : x;
        }
    }
    if (!loft_real_valid(tol) || wide < 2 * loft_real_grain(size) || wide < 512 * loft_acc_grain(size))
        return LOFT_ERR_RANGE;

    f->curve = *c;
    f->last  = c->p[0];
    f->at    = 0;
    f->limit = wide - loft_acc_scale(wide, LOFT_UNIT(1.0 / 1048576)) - 64 * loft_acc_grain(size);
    return LOFT_OK;
}

/* The end of the longest chord found, and the parameter there. */
static uint32_t reach(const loft_flatten *f, loft_vec *end)
{
    uint32_t low = f->at, high = low;
    loft_vec trial;

    for (uint32_t width = STEPS; width && low == f->at; width /= 2) {
        const uint32_t to = (f->at | (width - 1)) + 1;
        if (to == high)
            continue;
        if (is_flat(f, to, end) || width == 1)
            low = to;
        else
            high = to;
    }
    while (high > low + 1 + (low - f->at) / FINE) {
        const uint32_t to = low + (high - low) / 2;
        if (is_flat(f, to, &trial)) {
            low  = to;
            *end = trial;
        } else {
            high = to;
        }
    }
    return low;
}

bool loft_flatten_next(loft_flatten *f, loft_vec *out)
{
    loft_vec end;

    if (f->at == STEPS)
        return false;
    f->at   = reach(f, &end);
    f->last = *out = end;
    return true;
}
