/* lib/polygon/spatch.c
 * SPDX-License-Identifier: MIT
 *
 * Error. A term depth!/l! prod phi_i^l_i V_l is a product of at most 2 depth + sides + 3 factors
 * and partial products: less than 32 roundings of 2^-61 (floats 2^-53) of its absolute value. The
 * absolute terms sum to M |V|. The sum of N terms adds, for each, one rounding of the largest
 * partial sum; N <= 11440 < 2^13.5. In q16 |V| = 2^31 LSB:
 *
 *     (32 + 2^13.5) 2^-61 2^31 M LSB < 2^-16 M LSB
 *
 * In floats most terms are far below the sum. The tests hold 64 ulp of M |V|.
 */
#include "polygon/spatch.h"
#include "curve/rational.h"         /* LOFT_WEIGHT_MIN, loft_weight_clamp */
#include "polygon/weighted_sum.h"   /* loft_weighted_sum */

enum loft_status loft_spatch_init(loft_spatch *s, const loft_vec p[], const loft_real w[],
                                  unsigned sides, unsigned depth)
{
    if (sides < 3 || sides > LOFT_SIDES_MAX || depth < 1 || depth > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    const unsigned count = loft_multiindex_count(sides, depth);
    for (unsigned k = 0; k < count; k++) {
        if (w && !(w[k] >= LOFT_WEIGHT_MIN && w[k] <= LOFT_WEIGHT_MAX))
            return LOFT_ERR_RANGE;
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    }
    s->p = p;
    s->w = w;
    s->sides = (uint8_t)sides;
    s->depth = (uint8_t)depth;
    return LOFT_OK;
}

static loft_sci point_weight(const loft_spatch *s, unsigned rank)
{
    return s->w ? loft_sci_from_real(s->w[rank]) : loft_sci_one();
}

static unsigned next_vertex(unsigned i, unsigned sides) { return i + 1 < sides ? i + 1 : 0; }


/* Points */

/* True if the coordinates are 0 except for those of one edge; *edge is the first of them. */
static bool find_edge(const loft_spatch *s, const loft_sci phi[], unsigned *edge)
{
    const unsigned n = s->sides;
    unsigned others = 0;

    *edge = 0;
    while (*edge < n && !(loft_sci_sign(phi[*edge]) && loft_sci_sign(phi[next_vertex(*edge, n)])))
        ++*edge;
    if (*edge == n)
        for (*edge = 0; *edge < n - 1u && !loft_sci_sign(phi[*edge]); )
            ++*edge;
    for (unsigned i = 0; i < n; i++)
        others += loft_sci_sign(phi[i]) && i != *edge && i != next_vertex(*edge, n);
    return others == 0;
}

static enum loft_status edge_point(const loft_spatch *s, const loft_sci phi[], unsigned edge,
                                   loft_vec *out)
{
    const loft_sci share[2] = { phi[edge], phi[next_vertex(edge, s->sides)] };
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_real w[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= s->depth; k++) {
        uint8_t l[LOFT_SIDES_MAX] = { 0 };
        l[edge] = (uint8_t)(s->depth - k);
        l[next_vertex(edge, s->sides)] = (uint8_t)k;
        const unsigned rank = loft_multiindex_rank(l, s->sides);
        p[k] = s->p[rank];
        w[k] = s->w ? s->w[rank] : LOFT_REAL(1);
    }
    return loft_weighted_sum_curve(p, s->w ? w : NULL, s->depth, share, out);
}

/* part[i] is the product of C(left, l_j) phi_j^l_j for j < i, where `left` is the depth minus the
 * numbers before j. From one index to the next, only the factors after the first changed number are
 * new. */
static void sum_terms(const loft_spatch *s, const loft_sci phi[], loft_weighted_sum *sum)
{
    loft_sci power[LOFT_SIDES_MAX][LOFT_DEGREE_MAX + 1], part[LOFT_SIDES_MAX + 1];
    uint8_t l[LOFT_SIDES_MAX], last[LOFT_SIDES_MAX] = { 0 };
    const unsigned n = s->sides, d = s->depth;
    unsigned rank = 0;

    for (unsigned i = 0; i < n; i++) {
        power[i][0] = loft_sci_one();
        for (unsigned k = 1; k <= d; k++)
            power[i][k] = loft_sci_mul(power[i][k - 1], phi[i]);
    }
    part[0] = loft_sci_one();
    loft_multiindex_first(l, n, d);
    do {
        unsigned left = d, i = 0;
        for (; rank > 0 && l[i] == last[i]; i++)
            left -= l[i];
        for (; i < n; left -= l[i], i++) {
            part[i + 1] = loft_sci_mul(part[i], power[i][l[i]]);
            if (l[i] && l[i] < left)
                part[i + 1] = loft_sci_mul(part[i + 1],
                                           loft_sci_from_int(loft_binomial(left, l[i])));
            last[i] = l[i];
        }
        if (loft_sci_sign(part[n]))
            loft_weighted_sum_add(sum, &s->p[rank],
                                  s->w ? loft_sci_mul(part[n], point_weight(s, rank)) : part[n]);
        rank++;
    } while (loft_multiindex_next(l, n));
}

enum loft_status loft_spatch_eval(const loft_spatch *s, const loft_sci phi[], loft_vec *out)
{
    loft_weighted_sum sum;
    unsigned edge;

    if (find_edge(s, phi, &edge))
        return edge_point(s, phi, edge, out);
    loft_weighted_sum_start(&sum);
    sum_terms(s, phi, &sum);
    return s->w ? loft_weighted_sum_project(&sum, out) : loft_weighted_sum_point(&sum, out);
}

/* Reduce the depth by one, in place: l + e_0 has the same rank as l, l + e_i a higher one. */
static void reduce_depth(loft_sci c[], const loft_sci phi[], unsigned sides, unsigned depth)
{
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;

    loft_multiindex_first(l, sides, depth);
    do {
        loft_sci value = loft_sci_mul(phi[0], c[rank]);
        for (unsigned i = 1; i < sides; i++) {
            l[i]++;
            value = loft_sci_add(value, loft_sci_mul(phi[i], c[loft_multiindex_rank(l, sides)]));
            l[i]--;
        }
        c[rank++] = value;
    } while (loft_multiindex_next(l, sides));
}

/* A coordinate times its weight, or (axis LOFT_AXES) the weight. */
static loft_sci homogeneous_axis(const loft_spatch *s, unsigned rank, int axis)
{
    const loft_sci w = point_weight(s, rank);
    return axis < LOFT_AXES ? loft_sci_mul(w, loft_sci_from_real(s->p[rank].axis[axis])) : w;
}

static loft_sci casteljau_axis(const loft_spatch *s, const loft_sci phi[], int axis,
                               loft_sci work[])
{
    const unsigned n = s->sides;
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;

    loft_multiindex_first(l, n, s->depth - 1u);
    do {
        work[rank] = loft_sci_zero();
        for (unsigned i = 0; i < n; i++) {
            l[i]++;
            work[rank] = loft_sci_add(
                work[rank],
                loft_sci_mul(phi[i], homogeneous_axis(s, loft_multiindex_rank(l, n), axis)));
            l[i]--;
        }
        rank++;
    } while (loft_multiindex_next(l, n));
    for (unsigned depth = s->depth - 1u; depth > 0; depth--)
        reduce_depth(work, phi, n, depth - 1);
    return work[0];
}

enum loft_status loft_spatch_casteljau(const loft_spatch *s, const loft_sci phi[], loft_sci work[],
                                       loft_vec *out)
{
    loft_weighted_sum sum;

    for (int axis = 0; axis < LOFT_AXES; axis++)
        sum.x[axis] = casteljau_axis(s, phi, axis, work);
    if (!s->w)
        return loft_weighted_sum_point(&sum, out);
    sum.w = casteljau_axis(s, phi, LOFT_AXES, work);
    return loft_weighted_sum_project(&sum, out);
}


/* Other forms: sums of points with integer factors, divided once */

static enum loft_status store_mean(const loft_spatch *s, const loft_weighted_sum *sum,
                                   loft_sci factors, loft_vec *out, loft_real *w)
{
    loft_acc mean = 0;

    if (s->w) {
        if (!loft_sci_to_acc(loft_sci_div(sum->w, factors), &mean))
            return LOFT_ERR_RANGE;
        *w = loft_weight_clamp(loft_acc_round(mean));
    }
    return loft_weighted_sum_project(sum, out);
}

static void add_weighted(const loft_spatch *s, loft_weighted_sum *sum, const uint8_t l[],
                         int32_t factor)
{
    const unsigned rank = loft_multiindex_rank(l, s->sides);
    loft_weighted_sum_add(sum, &s->p[rank],
                          loft_sci_mul(loft_sci_from_int(factor), point_weight(s, rank)));
}

/* V_l = sum l_i / (depth + 1) V_(l - e_i) */
enum loft_status loft_spatch_elevate(const loft_spatch *s, loft_vec out[], loft_real w[])
{
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;
    enum loft_status status = LOFT_OK;

    if (s->depth >= LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    loft_multiindex_first(l, s->sides, s->depth + 1u);
    do {
        loft_weighted_sum sum;
        loft_weighted_sum_start(&sum);
        for (unsigned i = 0; i < s->sides; i++)
            if (l[i]) {
                l[i]--;
                add_weighted(s, &sum, l, l[i] + 1);
                l[i]++;
            }
        status = store_mean(s, &sum, loft_sci_from_int(s->depth + 1), &out[rank],
                            s->w ? &w[rank] : NULL);
        rank++;
    } while (status == LOFT_OK && loft_multiindex_next(l, s->sides));
    return status;
}

/* With phi = ((1-u)(1-v), u(1-v), uv, (1-u)v) the power of u is l_1 + l_2, and that of v is l_2 +
 * l_3. */
enum loft_status loft_spatch_tensor(const loft_spatch *s, loft_vec out[], loft_real w[])
{
    const unsigned d = s->depth;

    if (s->sides != 4)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= d; i++)
        for (unsigned j = 0; j <= d; j++) {
            const unsigned at = i * (d + 1) + j;
            loft_weighted_sum sum;
            loft_weighted_sum_start(&sum);
            for (unsigned both = i + j > d ? i + j - d : 0; both <= i && both <= j; both++) {
                const uint8_t l[4] = { (uint8_t)(d + both - i - j), (uint8_t)(i - both),
                                       (uint8_t)both, (uint8_t)(j - both) };
                add_weighted(s, &sum, l, loft_multiindex_multinomial(l, 4));
            }
            const int32_t ways = loft_binomial(d, i) * loft_binomial(d, j);
            const enum loft_status status = store_mean(s, &sum, loft_sci_from_int(ways), &out[at],
                                                       s->w ? &w[at] : NULL);
            if (status != LOFT_OK)
                return status;
        }
    return LOFT_OK;
}


/* The control net */

void loft_links_start(loft_links *w, unsigned sides, unsigned depth)
{
    loft_multiindex_first(w->rest, sides, depth - 1);
    w->sides = (uint8_t)sides;
    w->r = 0;
    w->more = true;
}

static unsigned rank_beyond(loft_links *w, unsigned i)
{
    w->rest[i]++;
    const unsigned rank = loft_multiindex_rank(w->rest, w->sides);
    w->rest[i]--;
    return rank;
}

bool loft_links_next(loft_links *w, unsigned *l, unsigned *m)
{
    if (!w->more)
        return false;
    *l = rank_beyond(w, w->r);
    *m = rank_beyond(w, next_vertex(w->r, w->sides));
    if (++w->r == w->sides) {
        w->r = 0;
        w->more = loft_multiindex_next(w->rest, w->sides);
    }
    return true;
}
