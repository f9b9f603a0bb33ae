/* lib/path/tube.c
 * SPDX-License-Identifier: MIT
 *
 * The spline with control points Q is at (Q[k-1] + 4 Q[k] + Q[k+1]) / 6 at knot k. So it meets the
 * places P to within D4 P / 36 if Q is at the centres C = P - D2 P / 6, and leaves them by at most
 * r more if each Q is within r of its centre.
 *
 * The sum of the squares of the third differences is least where
 *
 *     20 Q[k] - 15 (Q[k-1] + Q[k+1]) + 6 (Q[k-2] + Q[k+2]) - (Q[k-3] + Q[k+3]) = 0
 *
 * Each point in turn is moved 1.4 times as far as that asks for (over-relaxation), and back into
 * its ball.
 */
#include "path/tube.h"

#include "num/part.h"       /* loft_part, loft_part_root */

#define RELAX       4588            /* 1.4 / 20, 2^-16 */
#define STILL       12              /* knots beside one in which an axis may stand still */
#define MOVED       (64 * LOFT_COORD_GRAIN)
#define SIXTH       10923           /* 1 / 6, 2^-16    */

static loft_coord sixth(loft_coord x) { return loft_part(x + 3, SIXTH); }

static loft_coord second(loft_coord a, loft_coord b, loft_coord c)
{
    return loft_coord_sub(a, b) + loft_coord_sub(c, b);
}

static loft_coord centre(const loft_knot knot[], unsigned k, int i)
{
    const loft_coord at = knot[k].is.on.at.axis[i];
    return loft_coord_add(
        at, -sixth(second(knot[k - 1].is.on.at.axis[i], at, knot[k + 1].is.on.at.axis[i])));
}

void loft_tube_load(loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            knot[k].point.axis[i] = centre(knot, k, i);
}

void loft_tube_tie(loft_knot knot[], unsigned count, bool begins, bool ends)
{
    for (int k = 0; k < 3 && begins; k++)
        knot[k].point = knot[0].is.on.at;
    for (unsigned k = 1; k <= 3 && ends; k++)
        knot[count - k].point = knot[count - 1].is.on.at;
}

/* The centre of a knot; of the first one that is kept, its place. */
static void centre_of(const loft_knot knot[], unsigned k, loft_coord out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = k > 0 ? centre(knot, k, i) : knot[0].is.on.at.axis[i];
}

/* How far the spline through the centres is from the cubic through the places, in the middle
 * between knot k and the next: it is (C[k-1] + 23 C[k] + 23 C[k+1] + C[k+2]) / 48 there. */
static loft_coord off_between(const loft_knot knot[], unsigned k, const loft_path_place *const at[])
{
    loft_coord a[LOFT_AXES], b[LOFT_AXES], c[LOFT_AXES], d[LOFT_AXES];
    loft_position p;

    centre_of(knot, k - 1, a);
    centre_of(knot, k, b);
    centre_of(knot, k + 1, c);
    centre_of(knot, k + 2, d);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t sum = (int64_t)loft_coord_sub(a[i], b[i]) +
                            23 * (int64_t)loft_coord_sub(c[i], b[i]) + loft_coord_sub(d[i], b[i]);
        p.axis[i] = loft_coord_add(b[i], (loft_coord)(sum / 48));
    }
    return loft_path_off(at, INT32_C(1) << 23, &p);
}

/* The same at knot k, where it is D4 / 36 off. */
static loft_coord off_at(const loft_knot knot[], unsigned k)
{
    const loft_path_place *around[5];
    loft_coord a[LOFT_AXES], b[LOFT_AXES], c[LOFT_AXES];
    loft_position p;

    loft_tube_places(knot, k - 2, 5, around);
    centre_of(knot, k - 1, a);
    centre_of(knot, k, b);
    centre_of(knot, k + 1, c);
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = loft_coord_add(b[i], sixth(second(a[i], b[i], c[i])));
    return loft_path_miss(around, &p);
}

/* The part of the tolerance that is left between knot k and the next. `off`: how far it is off at
 * knot k, then at the next one. */
static loft_coord left_between(const loft_period *p, const loft_knot knot[], unsigned k,
                               loft_coord *off)
{
    const loft_path_place *here[4];

    loft_tube_places(knot, k - 1, 4, here);
    const loft_coord x = *off, y = off_at(knot, k + 1), z = off_between(knot, k, here);
    *off = y;
    return p->tube + (knot[k].is.on.loose ? p->more : 0) - loft_path_skip(&knot[k].is.on) -
           loft_coord_most(loft_coord_most(x, y), z);
}

/* 6/7 of the least tolerance on the ways that the point matters for. */
static loft_coord most_room(const loft_period *p, const loft_knot knot[], unsigned k)
{
    loft_coord tol = p->tol + p->more;

    for (unsigned i = k - 2; i <= k + 1; i++) {
        const loft_coord x = loft_path_tol(p, &knot[i].is.on);
        tol = x < tol ? x : tol;
    }
    return tol - tol / 7;
}

void loft_tube_measure(const loft_period *p, loft_knot knot[], unsigned from, unsigned to)
{
    loft_coord off = from > 3 ? off_at(knot, from - 2) : 0;

    for (unsigned k = from; k < to; k++)
        knot[k].is.on.room = loft_coord_grains(most_room(p, knot, k));
    for (unsigned k = from - 2; k < to; k++) {
        const loft_coord most = left_between(p, knot, k, &off);
        const uint16_t left = loft_coord_grains(most > 0 ? most : 0);
        for (unsigned i = k - 1; i <= k + 2; i++)
            if (i >= from && i < to && knot[i].is.on.room > left)
                knot[i].is.on.room = left;
    }
}

/* What the condition is off by, the sixth difference of the points. Only the sum fits 32 bits. */
static int32_t sixth_difference(const loft_knot *k, int i)
{
    const uint32_t q = (uint32_t)k->point.axis[i],
                   a = (uint32_t)k[-1].point.axis[i] + (uint32_t)k[1].point.axis[i],
                   b = (uint32_t)k[-2].point.axis[i] + (uint32_t)k[2].point.axis[i],
                   c = (uint32_t)k[-3].point.axis[i] + (uint32_t)k[3].point.axis[i];
    return (int32_t)(15 * a - 6 * b + c - 20 * q);
}

/* Back into a ball: the size of e is not more than r then. */
static void pull(loft_coord e[], loft_coord r)
{
    uint32_t most = 0, square = 0;
    int down = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        most |= (uint32_t)loft_coord_abs(e[i]);
    while (most >> down >= 8192)
        down++;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t x = (loft_coord_abs(e[i]) >> down) + 1;
        square += (uint32_t)(x * x);
    }
    const int half = loft_doublings(square) / 2;
    /* r / (2^down sqrt square), 2^-15 */
    const int32_t to = loft_part(r, loft_part_root(square << (2 * half))), shift = down - half - 2;
    const int32_t part = shift >= 0 ? to >> (shift < 31 ? shift : 31)
                         : to < LOFT_PART_ONE >> -shift ? to << -shift
                                                        : LOFT_PART_ONE;
    for (int i = 0; i < LOFT_AXES && part < LOFT_PART_ONE; i++)
        e[i] = 2 * loft_part(e[i], part);
}

/* Knots that are smoothed, and the axes that do not pass their end values. */
typedef struct {
    loft_knot *knot;
    unsigned from, to, one_sided;
} tube_part;

/* Does an axis stand still between knot k and the next, while none moves but those that may not
 * pass their ends, or is it one of these? */
static bool is_held(const tube_part *t, unsigned k, int i)
{
    const loft_position *a = &t->knot[k].is.on.at, *b = &t->knot[k + 1].is.on.at;
    bool one = t->one_sided >> i & 1, moves = false;

    if (a->axis[i] != b->axis[i])
        return false;
    for (int j = 0; j < LOFT_AXES && !one; j++)
        if (a->axis[j] != b->axis[j]) {
            if (!(t->one_sided >> j & 1))
                return false;
            moves = true;
        }
    return one || moves;
}

static int sign_of(loft_coord off) { return off > MOVED ? 1 : off < -MOVED ? -1 : 0; }

/* On which side of a place the path is on an axis, +-1; 0: on both, or on neither. Before `from`
 * places may be gone: there the points say it. */
static int side_of(const tube_part *t, unsigned k, int i)
{
    const loft_knot *knot = t->knot;
    const loft_coord at = knot[k].is.on.at.axis[i];
    int before = 0, after = 0;

    for (unsigned n = 1; n <= STILL && n <= k && before == 0; n++) {
        const bool known = t->from == 3 || k - n + 1 >= t->from;
        before = sign_of(
            loft_coord_sub(known ? knot[k - n].is.on.at.axis[i] : knot[k - n].point.axis[i], at));
    }
    for (unsigned n = 1; n <= STILL && k + n < t->to + 3 && after == 0; n++)
        after = sign_of(loft_coord_sub(knot[k + n].is.on.at.axis[i], at));
    return before == 0 || before == after ? after : after == 0 ? before : 0;
}

/* An axis that stands still does not pass the place where it stops, or from where it starts, as far
 * as the ball allows: e is from its centre c, of which the other axes have the rest. */
static void hold_sides(const tube_part *t, unsigned k, const loft_coord c[], loft_coord e[],
                       loft_coord r)
{
    loft_coord left = r;
    unsigned held = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        if (!is_held(t, k - 1, i) && !is_held(t, k, i))
            continue;
        const loft_coord to = loft_coord_sub(t->knot[k].is.on.at.axis[i], c[i]);
        if (side_of(t, k, i) * (e[i] - to) >= 0 || loft_coord_abs(to) > left)
            continue;
        left -= loft_coord_abs(to);
        held |= 1u << i;
        e[i] = to;
    }
    for (int i = 0; i < LOFT_AXES && held != 0; i++)
        if (!(held >> i & 1))
            e[i] = (loft_coord)((int64_t)e[i] * left / r);
}

static void relax(const tube_part *t, unsigned k)
{
    loft_knot *knot = t->knot;
    loft_coord e[LOFT_AXES], c[LOFT_AXES];
    const loft_coord r = knot[k].is.on.room * LOFT_COORD_GRAIN;
    bool far = false;

    for (int i = 0; i < LOFT_AXES; i++) {
        c[i] = centre(knot, k, i);
        e[i] = loft_coord_sub(knot[k].point.axis[i], c[i]) +
               loft_part(sixth_difference(&knot[k], i), RELAX);
        far = far || LOFT_AXES * loft_coord_abs(e[i]) > r;
    }
    if (far)
        pull(e, r);
    if (t->one_sided != 0 && r > 0)
        hold_sides(t, k, c, e, r);
    for (int i = 0; i < LOFT_AXES; i++)
        knot[k].point.axis[i] = loft_coord_add(c[i], e[i]);
}

void loft_tube_smooth(const loft_period *period, loft_knot knot[], unsigned from, unsigned to,
                      int sweeps)
{
    const tube_part part = { knot, from, to, period->one_sided };

    for (int n = 0; n < sweeps; n++)
        for (unsigned k = from; k < to; k++)
            relax(&part, n % 2 ? from + to - 1 - k : k);
}

/* 6 S = 6 Q + D2 + z (6 D1 + z (3 D2 + z D3)) */
void loft_tube_place(const loft_knot knot[], unsigned k, int32_t z, loft_position *out)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q = knot[k].point.axis[i];
        const int64_t a = loft_coord_sub(q, knot[k - 1].point.axis[i]),
                      b = loft_coord_sub(knot[k + 1].point.axis[i], q),
                      c = z > 0
                              ? loft_coord_sub(knot[k + 2].point.axis[i], knot[k + 1].point.axis[i])
                              : b;
        int64_t sum = c - 2 * b + a;
        sum = 3 * (b - a) + (sum * z >> 30);
        sum = 3 * (a + b) + (sum * z >> 30);
        sum = (b - a) + (sum * z >> 30);
        out->axis[i] = loft_coord_add(q, (loft_coord)((sum + (sum < 0 ? -3 : 3)) / 6));
    }
}
