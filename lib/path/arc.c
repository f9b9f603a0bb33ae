/* lib/path/arc.c
 * SPDX-License-Identifier: MIT
 *
 * An arc is kept as the polynomial C(t) = c0 + c1 t + c2 t^2 + c3 t^3 of its own parameter, t =
 * 0..1. With b = 1, b = 2 steps of a half, the derivative at its start, middle and end is
 *
 *     D = c1 + c2 k + c3 3/4 k^2      k = 0, 1, 2
 *
 * and its control points, three times the legs between those of the curve, are c1, c1 + c2, c1 + 2
 * c2 + 3 c3: off their mean, the chord, by c2 + c3, c3 and c2 + 2 c3.
 *
 * q16: control points are below 2^14, the sums of four with weights 1, 3, 3, 1 below 2^17. A
 * product with t rounds by u = 2^-33, and multiplies what was rounded before by t <= 1: where an
 * arc begins c0, c1, c2 err by at most 3, 5, 3 u and, for the half of a curve or less of it, the
 * sum of all at its end by 11 u.
 */
#include "path/arc.h"

#include "num/accs.h"       /* loft_accs_add, .. */

#define SPECK        loft_to_acc(LOFT_REAL(0.0000457763671875))    /* 3 / 2^16 */
#define DUST         loft_acc_scale(SPECK, LOFT_UNIT(0.25))
#define BLUR         16384                          /* grains: what is longer has a direction */
#define LENGTH_MAX   loft_to_acc(LOFT_REAL(64))       /* a loft_unit holds it */


static loft_acc dot(const loft_vec *a, const loft_vec *b)
{
    loft_acc sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        sum += loft_prod(a->axis[i], b->axis[i]);
    return sum;
}

/* Is p on the segment a..b, to within 2^-16 mm per plane? The distance of p from the line is |q x
 * c| / |c| with q = p - a, c = b - a, and |c| at least the largest of its coordinates. Products of
 * coordinates are exact in q16; they sum to less than 6 * 2^28. */
static bool on_chord(const loft_vec *p, const loft_vec *a, const loft_vec *b)
{
    loft_vec q, c;
    loft_acc most = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        q.axis[i] = p->axis[i] - a->axis[i];
        c.axis[i] = b->axis[i] - a->axis[i];
        most = loft_acc_max(most,
                            loft_acc_abs(loft_prod(c.axis[i], LOFT_REAL(0.0000152587890625))));
    }
    for (int i = 0; i < LOFT_AXES; i++)
        for (int j = 0; j < i; j++)
            if (loft_acc_abs(loft_prod(q.axis[i], c.axis[j]) - loft_prod(q.axis[j], c.axis[i])) >
                most)
                return false;
    return dot(&q, &c) >= 0 && dot(&q, &q) <= dot(&c, &c);
}

/* The chord, walked evenly. */
static void straighten(loft_arc *a)
{
    loft_accs_add(a->c[2], a->c[3]);
    loft_accs_add(a->c[1], a->c[2]);
    for (int i = 0; i < LOFT_AXES; i++)
        a->c[2][i] = a->c[3][i] = 0;
}

/* The whole curve from parameter `from` on, as a polynomial of t - from: control points, their
 * differences, the powers' coefficients, and three rounds of Horner's scheme. */
static void begin(loft_arc *a, const loft_cubic *curve, uint32_t from)
{
    const loft_vec *p = curve->p;
    const loft_unit t = loft_unit_of(from, LOFT_ARC_WHOLE);

    for (int k = 0; k < 4; k++)
        loft_accs_from(a->c[k], p[k].axis);
    for (int n = 0; n < 3; n++)
        for (int k = 3; k > n; k--)
            loft_accs_sub(a->c[k], a->c[k - 1]);
    for (int k = 1; k < 3; k++)
        loft_accs_triple(a->c[k]);
    if (on_chord(&p[1], &p[0], &p[3]) && on_chord(&p[2], &p[0], &p[3]))
        straighten(a);
    for (int n = 0; n < 3 && from > 0; n++)
        for (int k = 2; k >= n; k--)
            loft_accs_grow(a->c[k], a->c[k + 1], t);
}

/* Keep the first part. */
static void shorten(loft_arc *a, loft_unit part)
{
    for (int k = 1; k < 4; k++)
        for (int n = 0; n < k; n++)
            loft_accs_scale(a->c[k], part);
}

/* Keep the first half. */
static void halve(loft_arc *a)
{
    loft_accs_scale(a->c[1], LOFT_UNIT(0.5));
    loft_accs_scale(a->c[2], LOFT_UNIT(0.25));
    loft_accs_scale(a->c[3], LOFT_UNIT(0.125));
}

/* The derivative's control points, three times the legs, their mean and its length; per axis: how
 * far they are off it at most, and the sum of their sizes. The one in the middle counts
 * double, as no parabola through three rates follows it. */
typedef struct {
    loft_acc length, off, size;
    loft_acc chord[LOFT_AXES], leg[3][LOFT_AXES];
} legs;

static void set_legs(const loft_arc *a, legs *l)
{
    loft_accs_copy(l->leg[0], a->c[1]);
    loft_accs_copy(l->leg[1], a->c[1]);
    loft_accs_add(l->leg[1], a->c[2]);
    loft_accs_copy(l->chord, l->leg[1]);
    loft_accs_add(l->chord, a->c[3]);
    loft_accs_copy(l->leg[2], a->c[3]);
    loft_accs_triple(l->leg[2]);
    loft_accs_add(l->leg[2], a->c[2]);
    loft_accs_add(l->leg[2], l->leg[1]);
    l->length = loft_acc_hypot(l->chord, LOFT_AXES);
    l->off = l->size = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++) {
            const loft_acc x = l->leg[k][i], off = loft_acc_abs(x - l->chord[i]);
            l->off  = loft_acc_max(l->off, k == 1 ? 2 * off : off);
            l->size += loft_acc_abs(x);
        }
}

/* When all legs are within |chord| / 8 of it (per axis), direction and rate change by at most 1/4
 * over the arc, so no feature hides between the places looked at. */
static bool nearly_straight(const legs *l)
{
    return l->length > 0 && l->length <= LENGTH_MAX && l->off * 8 <= l->length;
}

static void set_direction(const loft_acc v[LOFT_AXES], loft_acc length, loft_vec *u)
{
    for (int i = 0; i < LOFT_AXES; i++)
        u->axis[i] = loft_acc_quot(v[i], length);
}

/* Split v into its part along u, which it gives, and what is left of it in v. */
static loft_acc take_along(loft_acc v[LOFT_AXES], const loft_vec *u)
{
    loft_acc along = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        along += loft_acc_mul(v[i], u->axis[i]);
    for (int i = 0; i < LOFT_AXES; i++)
        v[i] -= loft_acc_mul(along, u->axis[i]);
    return along;
}

/* Where a control point falls onto the end, rates grow from 0 and no part that begins there is
 * nearly straight in the sense above. A speck is, when all legs lead along its chord and no further
 * than |chord| / 512 off it. */
static bool straight_speck(legs *l)
{
    loft_vec u;

    if (!(l->length > 0))
        return false;
    set_direction(l->chord, l->length, &u);
    for (int k = 0; k < 3; k++) {
        if (take_along(l->leg[k], &u) < 0)
            return false;
        for (int i = 0; i < LOFT_AXES; i++)
            if (171 * loft_acc_abs(l->leg[k][i]) > l->length)      /* a leg is a third of that */
                return false;
    }
    return true;
}

/* The derivative at t = k / 4, and its size, the rate there. */
static loft_acc set_rate(const loft_arc *a, int k, loft_acc d[LOFT_AXES])
{
    const loft_unit half = LOFT_UNIT(0.5) * (loft_unit)k,
                    square = LOFT_UNIT(0.1875) * (loft_unit)(k * k);

    loft_accs_copy(d, a->c[1]);
    if (k > 0) {
        loft_accs_grow(d, a->c[2], half);
        loft_accs_grow(d, a->c[3], square);
    }
    return loft_acc_hypot(d, LOFT_AXES);
}

/* The length by Boole's rule; only dust rounds to nothing. */
static void set_length(loft_arc *a, loft_acc rate[5])
{
    loft_acc d[LOFT_AXES], sum = 0;

    for (int k = 0; k < 5; k++) {
        rate[k] = set_rate(a, k, d);
        sum += rate[k] * (k == 2 ? 12 : k % 2 ? 32 : 7);
    }
    a->length = rate[0] > 0 && rate[4] > 0 ? loft_acc_ratio(sum, 90) : 0;
    if (a->length > 0) {
        a->ends[0] = loft_unit_ratio(a->length, rate[0]) - LOFT_UNIT(1);
        a->ends[1] = LOFT_UNIT(1) - loft_unit_ratio(a->length, rate[4]);
    }
}

static loft_unit times(loft_unit a, loft_unit b)
{
    return loft_unit_round(loft_acc_scale(loft_unit_to_acc(a), b));
}

static loft_unit between_ends(const loft_arc *a, loft_unit w)
{
    return a->ends[0] + times(a->ends[1] - a->ends[0], w);
}

/* What s has to be for t to be right at w. */
static loft_unit off_pace(const loft_arc *a, loft_unit w, loft_unit t)
{
    const loft_acc  v   = loft_unit_to_acc(times(w, LOFT_UNIT(1) - w));
    const loft_unit off = loft_unit_ratio(loft_unit_to_acc(t - w), v) - between_ends(a, w);
    return loft_unit_ratio(loft_unit_to_acc(off), v);
}

static loft_unit parameter_at(const loft_arc *a, loft_unit w)
{
    const loft_unit v = times(w, LOFT_UNIT(1) - w), x = w - LOFT_UNIT(0.5);
    const loft_unit s = a->inner[0] + times(a->inner[1] + times(a->inner[2], x), x);

    return w + times(between_ends(a, w) + times(s, v), v);
}

/* The parameter where the part w of the length ends is
 *
 *     t = w + v (g0 (1 - w) + g1 w + v s(w - 1/2))    v = w (1 - w)   g0 = length / r0 - 1   g1 = 1
 *         - length / r4
 *
 * with its slopes at the ends, and s the parabola that is right near w = 1/4, 1/2, 3/4: at the
 * parts of the length up to t = 1/4, 1/2, 3/4, integrals of the polynomial of degree 4 through the
 * rates, in units of the length
 *
 *     1/4 + S - T, 1/2 - M, 3/4 - S - T       S = (r0 + r4 + 2 (r1 + r3) - 6 r2) / 48
 *     T = 3 (r4 - r0 + 2 (r3 - r1)) / 64      M = (r4 - r0 + 4 (r3 - r1)) / 24
 *
 * The speed errs by what is left out, by less than 1/2500. */
static void set_pace(loft_arc *a)
{
    loft_acc rate[5];
    loft_unit r[5];

    set_length(a, rate);
    if (!(a->length > 0))
        return;
    for (int k = 0; k < 5; k++)
        r[k] = loft_unit_ratio(rate[k], a->length);
    const loft_unit rise = r[4] - r[0], inner = r[3] - r[1];
    const loft_unit even = (r[0] + r[4] + 2 * (r[1] + r[3]) - 6 * r[2]) / 48,
                    odd = 3 * (rise + 2 * inner) / 64;
    const loft_unit x = off_pace(a, LOFT_UNIT(0.25) + even - odd, LOFT_UNIT(0.25)),
                    z = off_pace(a, LOFT_UNIT(0.75) - even - odd, LOFT_UNIT(0.75));
    const loft_unit y = off_pace(a, LOFT_UNIT(0.5) - (rise + 4 * inner) / 24, LOFT_UNIT(0.5));

    a->inner[0] = y;
    a->inner[1] = 2 * (z - x);
    a->inner[2] = 8 * (x + z - 2 * y);
}

/* Is the chord so long that rounding leaves its direction? Of q16's dust none is. */
static bool leads(const loft_arc *a, loft_acc length)
{
    loft_acc size = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        size = loft_acc_max(size, loft_acc_abs(a->c[0][i]));
    return length > BLUR * loft_acc_ulp(size);
}

/* Is it one that may be walked? `size` is that of its interval of parameters. What is too small for
 * its bend to matter is a crumb if it has a direction: the path may turn around where it begins and
 * where it ends. */
static bool fits(loft_arc *a, uint32_t size)
{
    legs l;

    set_legs(a, &l);
    a->dust = false;
    if (nearly_straight(&l))
        return true;

    const bool speck = l.size <= SPECK && straight_speck(&l),
               dust = !speck && (l.size <= DUST || size == 1);
    if (!speck && !dust)
        return false;
    a->dust = dust && !leads(a, l.length);
    straighten(a);
    return true;
}

/* The largest binary interval that begins at `from`, halved until it is nearly straight. */
uint32_t loft_arc_next(loft_arc *arc, const loft_cubic *curve, uint32_t from)
{
    uint32_t size = LOFT_ARC_WHOLE;

    while (from % size != 0)
        size /= 2;
    begin(arc, curve, from);
    if (size < LOFT_ARC_WHOLE)
        shorten(arc, loft_unit_of(size, LOFT_ARC_WHOLE));
    while (!fits(arc, size)) {
        size /= 2;
        halve(arc);
    }
    set_pace(arc);
    return from + size;
}

/* It leaves its chord by at most a quarter of c2 and of c3. */
bool loft_arc_is_straight(const loft_arc *arc, loft_acc within)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (loft_acc_abs(arc->c[2][i]) + loft_acc_abs(arc->c[3][i]) > within)
            return false;
    return true;
}

void loft_arc_fold(loft_arc *arc, const loft_acc by[LOFT_AXES])
{
    straighten(arc);
    loft_accs_sub(arc->c[1], by);
    set_pace(arc);
}

void loft_arc_direction(const loft_arc *arc, unsigned n, loft_vec *out)
{
    loft_acc v[LOFT_AXES];

    const loft_acc rate = set_rate(arc, 2 * (int)n, v);
    set_direction(v, rate, out);
}

void loft_arc_eval(const loft_arc *arc, loft_acc s, loft_acc out[LOFT_AXES])
{
    const loft_unit t = parameter_at(arc, loft_unit_ratio(s, arc->length));

    loft_accs_copy(out, arc->c[3]);
    for (int k = 3; k > 0; k--) {
        loft_accs_scale(out, t);
        loft_accs_add(out, arc->c[k - 1]);
    }
}

/* c1 + t (2 c2 + t 3 c3) */
void loft_arc_heading(const loft_arc *arc, loft_acc s, loft_vec *out)
{
    const loft_unit t = parameter_at(arc, loft_unit_ratio(s, arc->length));
    loft_acc v[LOFT_AXES];

    loft_accs_copy(v, arc->c[3]);
    loft_accs_triple(v);
    loft_accs_scale(v, t);
    loft_accs_add(v, arc->c[2]);
    loft_accs_add(v, arc->c[2]);
    loft_accs_scale(v, t);
    loft_accs_add(v, arc->c[1]);
    set_direction(v, loft_acc_hypot(v, LOFT_AXES), out);
}
