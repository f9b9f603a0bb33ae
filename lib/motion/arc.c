/* lib/motion/arc.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/arc.h"

#define SPECK        loft_acc_ratio(loft_wide(LOFT_REAL(1)), 65536)
#define DUST         loft_acc_ratio(loft_wide(LOFT_REAL(1)), 262144)
#define LENGTH_MAX   loft_wide(LOFT_REAL(64))       /* a loft_unit holds it */
#define BEND_MAX     LOFT_REAL(16383)

static loft_acc size_of(loft_acc x)            { return x < 0 ? -x : x; }
static loft_acc larger(loft_acc x, loft_acc y) { return x > y ? x : y; }

/* Is p on the segment a..b, to within 2^-16 mm per plane? The distance of p from the line is |q x c| / |c| with
 * q = p - a, c = b - a. Products of coordinates are exact in q16; they sum to less than 6 * 2^28. */
static bool on_chord(loft_vec p, loft_vec a, loft_vec b)
{
    const loft_vec q = loft_vec_sub(p, a), c = loft_vec_sub(b, a);
    const loft_acc most = loft_acc_mul(loft_vec_distance(a, b), LOFT_REAL(0.0000152587890625));
    const loft_acc along = loft_vec_dot(q, c);

    for (int i = 0; i < LOFT_AXES; i++)
        for (int j = 0; j < i; j++)
            if (size_of(loft_prod(q.axis[i], c.axis[j]) - loft_prod(q.axis[j], c.axis[i])) > most)
                return false;
    return along >= 0 && loft_vec_dot(q, q) <= loft_vec_dot(c, c);
}

static void straighten(loft_arc *a)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc third = loft_acc_ratio(a->p[3][i] - a->p[0][i], 3);
        a->p[1][i] = a->p[0][i] + third;
        a->p[2][i] = a->p[3][i] - third;
    }
}

void loft_arc_from(loft_arc *whole, const loft_cubic *c)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            whole->p[k][i] = loft_wide(c->p[k].axis[i]);
    if (on_chord(c->p[1], c->p[0], c->p[3]) && on_chord(c->p[2], c->p[0], c->p[3]))
        straighten(whole);
}

/* The control points of the part a..b are the blossom at (a,a,a) (a,a,b) (a,b,b) (b,b,b). */
static void set_part(loft_arc *out, const loft_arc *whole, loft_unit a, loft_unit b)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc qa[3], qb[3], aa[2], ab[2], bb[2];
        for (int k = 0; k < 3; k++) {
            qa[k] = loft_acc_lerp(whole->p[k][i], whole->p[k + 1][i], a);
            qb[k] = loft_acc_lerp(whole->p[k][i], whole->p[k + 1][i], b);
        }
        for (int k = 0; k < 2; k++) {
            aa[k] = loft_acc_lerp(qa[k], qa[k + 1], a);
            ab[k] = loft_acc_lerp(qa[k], qa[k + 1], b);
            bb[k] = loft_acc_lerp(qb[k], qb[k + 1], b);
        }
        out->p[0][i] = loft_acc_lerp(aa[0], aa[1], a);
        out->p[1][i] = loft_acc_lerp(aa[0], aa[1], b);
        out->p[2][i] = loft_acc_lerp(ab[0], ab[1], b);
        out->p[3][i] = loft_acc_lerp(bb[0], bb[1], b);
    }
}

/* Legs d_k = p_(k+1) - p_k are the derivative's control points over 3. When all are within |c| / 16 of their mean c (per
 * axis), direction and rate change by at most 1/8 over the arc, so no feature hides between the places looked at. */
static bool nearly_straight(const loft_arc *a)
{
    loft_acc chord[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        chord[i] = a->p[3][i] - a->p[0][i];

    const loft_acc length = loft_acc_hypot(chord, LOFT_AXES), most = length / 48;
    if (length > LENGTH_MAX)
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc c = loft_acc_ratio(chord[i], 3);
        for (int k = 0; k < 3; k++)
            if (size_of(a->p[k + 1][i] - a->p[k][i] - c) > most)
                return false;
    }
    return length > 0;
}

static loft_acc legs_of(const loft_arc *a)
{
    loft_acc sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++)
            sum += size_of(a->p[k + 1][i] - a->p[k][i]);
    return sum;
}

/* Where a control point falls onto the end, rates grow from 0 and no part that begins there is nearly straight in the
 * sense above. A speck is, when all legs lead along its chord and no further than |chord| / 512 off it. */
static bool straight_speck(const loft_arc *a)
{
    loft_acc chord[LOFT_AXES];
    loft_real u[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        chord[i] = a->p[3][i] - a->p[0][i];
    const loft_acc length = loft_acc_hypot(chord, LOFT_AXES);
    for (int i = 0; i < LOFT_AXES && length > 0; i++)
        u[i] = loft_acc_quot(chord[i], length);

    for (int k = 0; k < 3 && length > 0; k++) {
        loft_acc along = 0, off = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            along += loft_acc_mul(a->p[k + 1][i] - a->p[k][i], u[i]);
        for (int i = 0; i < LOFT_AXES; i++)
            off = larger(off, size_of(a->p[k + 1][i] - a->p[k][i] - loft_acc_mul(along, u[i])));
        if (along < 0 || 512 * off > length)
            return false;
    }
    return length > 0;
}

/* The derivative over 3 at the start, the middle (times 4) and the end. */
static void set_legs(const loft_arc *a, int i, loft_acc e[3])
{
    e[0] = a->p[1][i] - a->p[0][i];
    e[2] = a->p[3][i] - a->p[2][i];
    e[1] = loft_acc_ratio(e[0] + e[2] + 2 * (a->p[2][i] - a->p[1][i]), 4);
}

/* Simpson's rule with |derivative| = 3 rate gives the length (r0 + 4 rm + r1) / 2. Only dust rounds to nothing. */
static void set_length(loft_arc *a)
{
    loft_acc e[LOFT_AXES][3], part[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        set_legs(a, i, e[i]);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            part[i] = e[i][k];
        a->rate[k] = loft_acc_hypot(part, LOFT_AXES);
    }
    a->length = a->rate[0] > 0 && a->rate[2] > 0 ? (a->rate[0] + 4 * a->rate[1] + a->rate[2]) / 2 : 0;
}

static bool cut(loft_arc *arc, const loft_arc *whole, uint32_t from, uint32_t to)
{
    set_part(arc, whole, loft_unit_of(from, LOFT_ARC_WHOLE), loft_unit_of(to, LOFT_ARC_WHOLE));
    const loft_acc legs = legs_of(arc);
    const bool straight = nearly_straight(arc);

    arc->speck = !straight && legs <= SPECK && straight_speck(arc);
    arc->dust  = !straight && !arc->speck && (legs <= DUST || to - from == 1);
    if (arc->speck || arc->dust)
        straighten(arc);
    if (straight || arc->speck || arc->dust)
        set_length(arc);
    return straight || arc->speck || arc->dust;
}

void loft_arc_cut(loft_arc *arc, const loft_arc *whole, uint32_t from, uint32_t to)
{
    (void)cut(arc, whole, from, to);
}

/* The largest binary interval that begins at `from`, halved until it is nearly straight. */
uint32_t loft_arc_next(loft_arc *arc, const loft_arc *whole, uint32_t from)
{
    uint32_t size = LOFT_ARC_WHOLE;

    while (from % size != 0)
        size /= 2;
    while (!cut(arc, whole, from, from + size))
        size /= 2;
    return from + size;
}

/* With e = derivative / 3, f = second derivative / 6, u = e / |e| the curvature vector is
 *
 *     K = (C'' - u (u . C'')) / |C'|^2 = (2/3) (b - u (u . b)) / |e|,   b = f / |e|
 *
 * b is less than 1/2 because the legs differ by at most |c| / 4. Arcs below 2^-15 mm may bend more than a real can
 * say: twice BEND_MAX stands for all of that. */
static loft_real curvature(loft_acc across, loft_acc rate)
{
    const loft_acc x = loft_acc_ratio(2 * across, 3);
    if (size_of(x) > loft_acc_mul(rate, BEND_MAX))
        return x < 0 ? -2 * BEND_MAX : 2 * BEND_MAX;
    return loft_acc_quot(x, rate);
}

static void set_station(const loft_arc *a, int k, loft_vec *u, loft_vec *bend)
{
    loft_acc along = 0;
    loft_vec b;

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc e[3];
        set_legs(a, i, e);
        const loft_acc d = a->p[2][i] - a->p[1][i];
        const loft_acc f = k == 0 ? d - e[0] : k == 2 ? e[2] - d : (e[2] - e[0]) / 2;
        u->axis[i] = loft_acc_quot(e[k], a->rate[k]);
        b.axis[i]  = loft_acc_quot(f, a->rate[k]);
        along += loft_prod(u->axis[i], b.axis[i]);
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        bend->axis[i] = curvature(loft_wide(b.axis[i]) - loft_acc_mul(along, u->axis[i]), a->rate[k]);
    }
}

void loft_arc_measure(const loft_arc *arc, loft_arc_shape *shape)
{
    shape->tight = arc->dust;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            shape->along[k].axis[i] = LOFT_REAL(1);
            shape->bend[k].axis[i]  = 0;
        }
        if (!arc->dust)
            set_station(arc, k, &shape->along[k], &shape->bend[k]);
        if (!loft_vec_within(shape->bend[k], BEND_MAX))
            shape->tight = true;
    }
}

static loft_acc bernstein(const loft_acc b[], int degree, loft_unit t)
{
    loft_acc q[4];

    for (int k = 0; k <= degree; k++)
        q[k] = b[k];
    for (int n = degree; n > 0; n--)
        for (int k = 0; k < n; k++)
            q[k] = loft_acc_lerp(q[k], q[k + 1], t);
    return q[0];
}

/* The rate is close to the parabola through its three values, in Bernstein's form r0, m = 2 rm - (r0 + r1) / 2, r1,
 * the length therefore to the cubic s(u) with 0, r0, r0 + m, r0 + m + r1, whose derivative is 3 times the parabola.
 * s(u) = s is solved by Newton's iteration from u = s / length: rates differ by an eighth at most, so u errs by at most
 * 2^-5, then by the square of that times rate' / (2 rate) <= 2^-4, that is 2^-14, then by rounding only. */
static loft_unit parameter_at(const loft_arc *arc, loft_acc s)
{
    const loft_acc r0 = arc->rate[0], r1 = arc->rate[2], m = 2 * arc->rate[1] - (r0 + r1) / 2;
    const loft_acc rate[3] = { r0, m, r1 }, length[4] = { 0, r0, r0 + m, arc->length };
    loft_unit u = loft_unit_ratio(s, arc->length);

    for (int n = 0; n < 2; n++) {
        u += loft_unit_ratio(s - bernstein(length, 3, u), 3 * bernstein(rate, 2, u));
        u = u < 0 ? 0 : u > LOFT_UNIT(1) ? LOFT_UNIT(1) : u;
    }
    return u;
}

void loft_arc_eval(const loft_arc *arc, loft_acc s, loft_acc out[LOFT_AXES])
{
    const loft_unit u = parameter_at(arc, s);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc p[4] = { arc->p[0][i], arc->p[1][i], arc->p[2][i], arc->p[3][i] };
        out[i] = bernstein(p, 3, u);
    }
}
