/* lib/curve/measure.c -- length, and the parameter at a length (curve/measure.h)
 * SPDX-License-Identifier: MIT
 *
 * Let w0 w1 w2 be the legs of the control polygon. The piece a..b of the curve, h = b - a, has the
 * legs
 *
 *     h v0,  h v1,  h v2           v0 = w[a,a],  v1 = w[a,b],  v2 = w[b,b]
 *
 * (blossoms of a quadratic), and its length lies between chord and polygon:
 *
 *     h |v0 + v1 + v2|  <=  length  <=  h (|v0| + |v1| + |v2|)
 *
 * The mean of the two is used if they differ by at most 2 h tol, so that the error of all pieces
 * together is at most tol. (For pieces without inflection the mean is far better: Gravesen.)
 * Otherwise the piece is halved. Let D be the larger of |w1 - w0|, |w2 - w1|; both are at most the
 * polygon's length P. Neighbours among v0 v1 v2 are at most h D apart, so the difference is at most
 * 4 h D. After 24 halvings it is below 2 tol for all tol >= 2^-23 P. Twice that is required,
 * because of the rounding of lengths, 2^-28 of each in q16.
 *
 * Lengths are those of v, at most 3 * 2^16 sqrt(6) < 2^19; their rounding is scaled down by h.
 *
 * The pieces are the leaves of a binary tree, piece k of 2^level, visited in order. The piece after
 * k is k + 1, or rather the largest ancestor that starts there: no stack is needed. */
#include "curve/measure.h"

#define LEVELS     24       /* all k / 2^24 are exact in every number type */
#define MARK_LEVEL 4
typedef char marks_are_a_level[LOFT_ARCLEN_MARKS == 1 << MARK_LEVEL ? 1 : -1];

typedef struct {
    loft_acc legs[3][LOFT_AXES];
    loft_acc polygon;
    loft_acc tol;
} hodograph;

typedef struct {
    uint32_t k;
    uint8_t  level;
} piece;

/* Lengths per unit of the parameter. */
typedef struct {
    loft_acc chord, polygon, slowest, fastest;
} pair;

static loft_unit piece_start(piece n)  { return loft_unit_of(n.k, (uint32_t)1 << n.level); }
static loft_unit piece_end(piece n)    { return loft_unit_of(n.k + 1, (uint32_t)1 << n.level); }
static piece     piece_half(piece n, uint32_t side)
{
    const piece half = { 2 * n.k + side, (uint8_t)(n.level + 1) };
    return half;
}

static void prepare_hodograph(hodograph *h, const loft_cubic *c, loft_acc tol)
{
    h->polygon = 0;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            h->legs[k][i] = loft_to_acc(c->p[k + 1].axis[i]) - loft_to_acc(c->p[k].axis[i]);
        h->polygon += loft_acc_hypot(h->legs[k], LOFT_AXES);
    }
    const loft_acc least = loft_acc_ratio(h->polygon, (int32_t)1 << 22);
    h->tol = tol > least ? tol : least;
}

static pair lengths_between(const hodograph *h, loft_unit from, loft_unit to)
{
    loft_acc v[3][LOFT_AXES], sum[LOFT_AXES], size[3];
    pair p;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc a = h->legs[0][i], b = h->legs[1][i], c = h->legs[2][i];
        const loft_acc a0 = loft_acc_lerp(a, b, from), a1 = loft_acc_lerp(b, c, from);
        const loft_acc b0 = loft_acc_lerp(a, b, to), b1 = loft_acc_lerp(b, c, to);

        v[0][i] = loft_acc_lerp(a0, a1, from);
        v[1][i] = loft_acc_lerp(a0, a1, to);
        v[2][i] = loft_acc_lerp(b0, b1, to);
        sum[i]  = v[0][i] + v[1][i] + v[2][i];
    }
    for (int k = 0; k < 3; k++)
        size[k] = loft_acc_hypot(v[k], LOFT_AXES);

    p.chord   = loft_acc_hypot(sum, LOFT_AXES);
    p.polygon = size[0] + size[1] + size[2];
    p.slowest = p.fastest = size[0];
    for (int k = 1; k < 3; k++) {
        if (size[k] < p.slowest)
            p.slowest = size[k];
        if (size[k] > p.fastest)
            p.fastest = size[k];
    }
    return p;
}

static pair lengths_over(const hodograph *h, piece n)
{
    return lengths_between(h, piece_start(n), piece_end(n));
}

static loft_acc mean_length(pair p, piece n)
{
    return loft_acc_ratio(p.chord + p.polygon, (int32_t)2 << n.level);
}

/* Add up the leaves below *n, in order, up to the one that passes `length` or t. *n becomes that
 * leaf, or the piece after the given one if there is none. */
static loft_acc walk_leaves(const hodograph *h, piece *n, loft_acc length, loft_unit t)
{
    const uint8_t top = n->level;
    loft_acc sum = 0;

    do {
        const pair p = lengths_over(h, *n);
        if (p.polygon - p.chord > 2 * h->tol && n->level < LEVELS) {
            *n = piece_half(*n, 0);
            continue;
        }
        if (sum + mean_length(p, *n) > length || piece_end(*n) > t)
            break;
        sum += mean_length(p, *n);
        n->k++;
        while (n->level > top && n->k % 2 == 0) {
            n->k /= 2;
            n->level--;
        }
    } while (n->level > top);
    return sum;
}

/* The parameter at the distance `rest` into the leaf n. Leaves are halved until time and length are
 * proportional within tol. The speed is between 3 (slowest - 2 tol) and 3 fastest, so the length
 * differs from the straight line by at most h / 4 times the difference. Every choice depends on the
 * piece alone, so the result increases with `rest`. */
static loft_unit invert_leaf(const hodograph *h, piece n, loft_acc rest)
{
    pair p = lengths_over(h, n);

    while (n.level < LEVELS &&
           (n.level < 3 || loft_acc_ratio(p.fastest - p.slowest, (int32_t)1 << n.level) >
                               loft_acc_ratio(h->tol, 4))) {
        const piece first = piece_half(n, 0);
        const pair q = lengths_over(h, first);
        const loft_acc length = mean_length(q, first);
        if (rest < length) {
            n = first;
            p = q;
        } else {
            rest -= length;
            n = piece_half(n, 1);
            p = lengths_over(h, n);
        }
    }
    const loft_acc length = mean_length(p, n);
    if (rest >= length)
        return piece_end(n);
    const loft_unit t = loft_unit_ratio(length * (int32_t)n.k + rest,
                                        length * (int32_t)((uint32_t)1 << n.level));
    return t < piece_start(n) ? piece_start(n) : t < piece_end(n) ? t : piece_end(n);
}

/* The parameter where the curve is `length` beyond the start of n. */
static loft_unit locate_length(const hodograph *h, piece n, loft_acc length)
{
    const piece top = n;

    if (!(length > 0))
        return piece_start(n);
    length -= walk_leaves(h, &n, length, LOFT_UNIT(1));
    if (n.level == top.level && n.k != top.k)
        return piece_start(n);
    return invert_leaf(h, n, length);
}

loft_acc loft_cubic_arclen(const loft_cubic *c, loft_real tol)
{
    hodograph h;
    piece whole = { 0, 0 };

    prepare_hodograph(&h, c, loft_to_acc(tol));
    return walk_leaves(&h, &whole, 2 * h.polygon, LOFT_UNIT(1));
}

/* Half of tol is for the lengths, the other half for the inversion. */
loft_unit loft_cubic_inv_arclen(const loft_cubic *c, loft_acc length, loft_real tol)
{
    const piece whole = { 0, 0 };
    hodograph h;

    prepare_hodograph(&h, c, loft_acc_ratio(loft_to_acc(tol), 2));
    return locate_length(&h, whole, length);
}


enum loft_status loft_arclen_init(loft_arclen *r, const loft_cubic *c, loft_real tol)
{
    hodograph h;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++)
        if (!loft_vec_valid(c->p[k]))
            return LOFT_ERR_RANGE;

    r->curve   = *c;
    r->tol     = loft_acc_ratio(loft_to_acc(tol), 2);
    r->mark[0] = 0;
    prepare_hodograph(&h, c, r->tol);
    for (uint32_t k = 0; k < LOFT_ARCLEN_MARKS; k++) {
        piece sixteenth = { k, MARK_LEVEL };
        r->mark[k + 1] = r->mark[k] + walk_leaves(&h, &sixteenth, 2 * h.polygon, LOFT_UNIT(1));
    }
    return LOFT_OK;
}

loft_acc loft_arclen_total(const loft_arclen *r)     { return r->mark[LOFT_ARCLEN_MARKS]; }

loft_acc loft_arclen_eval(const loft_arclen *r, loft_unit t)
{
    piece n = { 0, MARK_LEVEL };
    hodograph h;
    loft_acc sum;

    t = loft_unit_clamp(t);
    while (n.k < LOFT_ARCLEN_MARKS && piece_end(n) <= t)
        n.k++;
    sum = r->mark[n.k];
    if (n.k == LOFT_ARCLEN_MARKS)
        return sum;
    prepare_hodograph(&h, &r->curve, r->tol);
    sum += walk_leaves(&h, &n, 2 * h.polygon, t);

    const pair p = lengths_between(&h, piece_start(n), t);
    return sum + loft_acc_scale(loft_acc_ratio(p.chord + p.polygon, 2), t - piece_start(n));
}

loft_unit loft_arclen_inverse(const loft_arclen *r, loft_acc length)
{
    piece n = { 0, MARK_LEVEL };
    hodograph h;

    while (n.k < LOFT_ARCLEN_MARKS && r->mark[n.k + 1] < length)
        n.k++;
    if (n.k == LOFT_ARCLEN_MARKS)
        return LOFT_UNIT(1);
    prepare_hodograph(&h, &r->curve, r->tol);
    return locate_length(&h, n, length - r->mark[n.k]);
}
