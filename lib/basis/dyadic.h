/* lib/basis/dyadic.h -- the dyadic pieces of 0..1, visited in order without a stack
 * SPDX-License-Identifier: MIT
 *
 * Piece k of level m is k / 2^m .. (k + 1) / 2^m. Halving every piece that is not good enough gives
 * a binary tree, whose leaves are visited from left to right. The leaf after piece k is k + 1, or
 * rather the largest ancestor that starts there.
 *
 *     loft_dyad n = { 0, 0 };
 *     do {
 *         while (!is_good(n))
 *             n = loft_dyad_half(n, 0);
 *         use(n);
 *     } while (loft_dyad_next(&n));
 *
 * The state is the piece itself, so no stack is needed whose size would need a proof. The loop
 * above needs a proof that is_good holds at some level <= LOFT_DYAD_LEVELS.
 */
#ifndef LOFT_BASIS_DYADIC_H
#define LOFT_BASIS_DYADIC_H

#include "num/num.h"    /* loft_unit, loft_acc */

LOFT_BEGIN_C

#define LOFT_DYAD_LEVELS 24    /* all k / 2^24 are exact in every number type */

typedef struct {
    uint32_t k;
    uint8_t  level;
} loft_dyad;

static inline loft_unit loft_dyad_from(loft_dyad n)
{
    return loft_unit_of(n.k, (uint32_t)1 << n.level);
}
static inline loft_unit loft_dyad_to(loft_dyad n)
{
    return loft_unit_of(n.k + 1, (uint32_t)1 << n.level);
}

/* The left half (side 0) or the right one (side 1). */
static inline loft_dyad loft_dyad_half(loft_dyad n, uint32_t side)
{
    const loft_dyad half = { 2 * n.k + side, (uint8_t)(n.level + 1) };
    return half;
}

/* Step to the largest piece that starts where this one ends; false at the end of 0..1. */
static inline bool loft_dyad_next(loft_dyad *n)
{
    for (n->k++; n->level && n->k % 2 == 0; n->k /= 2)
        n->level--;
    return n->level > 0;
}

/* A box of up to LOFT_DYAD_PARAMETERS of them, halved along one at a time. */
#define LOFT_DYAD_PARAMETERS 4

typedef struct {
    loft_dyad n[LOFT_DYAD_PARAMETERS];
    uint8_t   by[LOFT_DYAD_PARAMETERS * LOFT_DYAD_LEVELS];      /* in this order */
    unsigned  depth;
} loft_dyad_box;

/* All parameters whole; to the first half along one; to the box after this one and its halves,
 * false if there is none.
 *
 *   range   halve: below LOFT_DYAD_LEVELS halvings along that parameter
 *   error   none
 *   cost    next: one step per level
 */
void loft_dyad_box_start(loft_dyad_box *box);
void loft_dyad_box_halve(loft_dyad_box *box, unsigned along);
bool loft_dyad_box_next(loft_dyad_box *box);

/* The parameter at t (0..1) of the piece.
 *
 *   error   q16: 2^-25   f32: 1/2 ulp   f64: 2 ulp of 1
 *   cost    three wide products and a quotient
 */
loft_unit loft_dyad_at(loft_dyad n, loft_unit t);

/* The Bernstein coefficients of the piece from..to of a polynomial; `out` must not be `c`.
 *
 *   range   as basis/bernstein.h
 *   error   as loft_bernstein_eval; exact at 0 and 1
 *   cost    degree * (degree + 1) * (degree + 5) / 6 wide lerps at most
 *   see     Ramshaw, blossoming: out[k] = c[from^(degree-k), to^k]
 */
void loft_bernstein_sub(const loft_acc c[], unsigned degree, loft_unit from, loft_unit to,
                        loft_acc out[]);

LOFT_END_C

#endif
