/* lib/surface/tensor/tensor_join.c
 * SPDX-License-Identifier: MIT
 *
 * Along the edge, in whole numbers,
 *
 *     A = P_u / m   of degree n      B = Q_u / m'   of degree n      T = P_v / n   of degree n - 1
 *
 * The normals A x T and B x T are parallel where (A x T) x (B x T) = det(A, B, T) T is 0. Where T
 * is not 0, that means det(A, B, T) = 0, a polynomial of degree 3 n - 1 whose coefficients are sums
 * of whole numbers.
 *
 * Parallel normals have the same direction where corresponding components have the same sign and
 * not all are 0. This is proven on a piece of the edge when, in one component, all Bernstein
 * coefficients of A x T and of B x T have one common sign, not 0. It is disproven where it fails at
 * the end of a piece. Otherwise the piece is halved. Near a point where the normals are not 0, some
 * component is not 0 either, so short pieces are proven.
 *
 * Range. A difference is below 2^e, e = 33 in q16 and 129 in floats. A coefficient of det is below
 * 6 * 2^(3e) times the sum of the products of binomials, 2^(3n - 1): q16 2^128, floats 2^416.
 * Halving takes sums instead of means, which multiplies A and B by 2^n and T by 2^(n-1) each time.
 * After L halvings a coefficient of A x T is below 2^(2e + 1 + (2n - 1)(L + 1)).
 */
#include "surface/tensor/tensor_join.h"
#include "basis/dyadic.h"       /* loft_dyad: the pieces of the edge */
#include "geom/vec_exact.h"     /* loft_exact: no decision depends on rounding */

#define POINTS (LOFT_DEGREE_MAX + 1)
#define EDGE_BITS (LOFT_EXACT_REAL + 21)

/* A, B and T along a piece of the edge, in the first three axes. */
typedef struct {
    loft_exact a[POINTS][3], b[POINTS][3], t[POINTS][3];
    unsigned n;
} edge;

static void load_edge(edge *e, const loft_tensor *p, const loft_tensor *q)
{
    const loft_vec *last = p->p + p->m * (p->n + 1u);

    e->n = p->n;
    for (unsigned j = 0; j <= e->n; j++)
        for (int i = 0; i < 3; i++) {
            e->a[j][i] = loft_vec_exact_sub_axis(last + j, last - (p->n + 1u) + j, i);
            e->b[j][i] = loft_vec_exact_sub_axis(q->p + (q->n + 1u) + j, q->p + j, i);
            if (j < e->n)
                e->t[j][i] = loft_vec_exact_sub_axis(last + j + 1, last + j, i);
        }
}

/* sum over i + k = s of C(n,i) C(n-1,k) (x_i t_k' - x_i' t_k) with axes c + 1, c + 2: the s-th
 * coefficient of component c of the product, times C(2n-1,s). */
static loft_exact cross_coefficient(const edge *e, loft_exact x[][3], unsigned s, unsigned c)
{
    const unsigned one = (c + 1) % 3, two = (c + 2) % 3;
    loft_exact sum = loft_exact_from_int(0);

    for (unsigned i = s >= e->n ? s - e->n + 1 : 0; i <= e->n && i <= s; i++) {
        const loft_exact d = loft_exact_det(x[i][one], x[i][two], e->t[s - i][one],
                                            e->t[s - i][two]);
        const int32_t weight = loft_binomial(e->n, i) * loft_binomial(e->n - 1, s - i);
        sum = loft_exact_add(sum, loft_exact_mul(loft_exact_from_int(weight), d));
    }
    return sum;
}

/* One coefficient of det(A, T, B) = (A x T) B, times C(3n-1,s). */
static bool det_vanishes(const edge *e, loft_exact a[][3], loft_exact b[][3], unsigned s)
{
    loft_exact sum = loft_exact_from_int(0);

    for (unsigned j = 0; j <= e->n && j <= s; j++) {
        if (s - j > 2 * e->n - 1)
            continue;
        for (unsigned c = 0; c < 3; c++) {
            const loft_exact term = loft_exact_mul(b[j][c], cross_coefficient(e, a, s - j, c));
            sum = loft_exact_add(sum,
                                 loft_exact_mul(loft_exact_from_int(loft_binomial(e->n, j)), term));
        }
    }
    return loft_exact_sign(sum) == 0;
}

static bool normals_parallel(edge *e)
{
    for (unsigned s = 0; s < 3 * e->n; s++)
        if (!det_vanishes(e, e->a, e->b, s))
            return false;
    return true;
}

/* One half of a polynomial. Sums replace means, so all coefficients are multiplied by 2^degree. The
 * left half takes the first value of each row, the right half the last one. */
static void halve_net(loft_exact x[][3], unsigned degree, unsigned side)
{
    for (int i = 0; i < 3; i++)
        for (unsigned row = 0; row < degree; row++)
            for (unsigned k = 0; k < degree - row; k++) {
                const unsigned at = side ? k : degree - k;      /* the coefficient to replace */
                x[at][i] = loft_exact_add(x[at][i], x[side ? at + 1 : at - 1][i]);
            }
    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < 3; i++)
            x[k][i] = loft_exact_shift(x[k][i], (int)(side ? k : degree - k));
}

static void cut_edge(edge *e, loft_dyad piece)
{
    for (unsigned bit = piece.level; bit-- > 0; ) {
        const unsigned side = piece.k >> bit & 1;
        halve_net(e->a, e->n, side);
        halve_net(e->b, e->n, side);
        halve_net(e->t, e->n - 1, side);
    }
}

/* True if both normals have one direction at the first (s = 0) or last coefficient, which are
 * values. */
static bool signs_agree(edge *e, unsigned s)
{
    bool some = false;

    for (unsigned c = 0; c < 3; c++) {
        const int sign = loft_exact_sign(cross_coefficient(e, e->a, s, c));
        if (sign != loft_exact_sign(cross_coefficient(e, e->b, s, c)))
            return false;
        some = some || sign;
    }
    return some;
}

static bool direction_proven(edge *e)
{
    for (unsigned c = 0; c < 3; c++) {
        const int sign = loft_exact_sign(cross_coefficient(e, e->a, 0, c));
        bool all = sign != 0;
        for (unsigned s = 0; s < 2 * e->n && all; s++)
            all = loft_exact_sign(cross_coefficient(e, e->a, s, c)) == sign &&
                  loft_exact_sign(cross_coefficient(e, e->b, s, c)) == sign;
        if (all)
            return true;
    }
    return false;
}

static bool same_direction(edge *e, const loft_tensor *p, const loft_tensor *q)
{
    const unsigned levels = (LOFT_EXACT_BITS - 1 - 2 * EDGE_BITS - 1) / (2 * e->n - 1) - 1;
    loft_dyad piece = { 0, 0 };

    do {
        for (;;) {
            load_edge(e, p, q);
            cut_edge(e, piece);
            if (!signs_agree(e, 0) || !signs_agree(e, 2 * e->n - 1))
                return false;
            if (direction_proven(e))
                break;
            if (piece.level >= levels || piece.level >= LOFT_DYAD_LEVELS)
                return false;
            piece = loft_dyad_half(piece, 0);
        }
    } while (loft_dyad_next(&piece));
    return true;
}

static bool points_valid(const loft_tensor *s)
{
    return loft_vec_exact_valid(s->p, (s->m + 1u) * (s->n + 1u), LOFT_AXES);
}

static bool edges_meet(const loft_tensor *p, const loft_tensor *q)
{
    for (unsigned j = 0; j <= p->n; j++)
        if (!loft_vec_equal(p->p[p->m * (p->n + 1u) + j], q->p[j]))
            return false;
    return true;
}

/* m (P_m - P_(m-1)) = m' (Q_1 - Q_0) in all axes */
static bool same_derivatives(const loft_tensor *p, const loft_tensor *q)
{
    const loft_exact m = loft_exact_from_int(p->m), other = loft_exact_from_int(q->m);
    const loft_vec *last = p->p + p->m * (p->n + 1u);

    for (unsigned j = 0; j <= p->n; j++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_exact a = loft_vec_exact_sub_axis(last + j, last - (p->n + 1u) + j, i);
            const loft_exact b = loft_vec_exact_sub_axis(q->p + (q->n + 1u) + j, q->p + j, i);
            if (loft_exact_compare(loft_exact_mul(m, a), loft_exact_mul(other, b)))
                return false;
        }
    return true;
}

enum loft_status loft_tensor_join_init(loft_tensor_join *j, const loft_tensor *p,
                                       const loft_tensor *q)
{
    edge e;

    j->c0 = j->c1 = j->g1 = false;
    if (p->n != q->n || p->m == 0 || q->m == 0)
        return LOFT_ERR_ARG;
    if (!points_valid(p) || !points_valid(q))
        return LOFT_ERR_RANGE;
    j->c0 = edges_meet(p, q);
    j->c1 = j->c0 && same_derivatives(p, q);
    if (!j->c0 || p->n == 0)
        return LOFT_OK;
    load_edge(&e, p, q);
    j->g1 = normals_parallel(&e) && same_direction(&e, p, q);
    return LOFT_OK;
}
