/* lib/polygon/basepoint.c
 * SPDX-License-Identifier: MIT
 *
 * Weights and phi are not negative, so nothing cancels, not even near a base point. Numerator and
 * denominator have relative errors: a term errs by less than 2 degree + 6 roundings, the quotient
 * by twice that.
 */
#include "polygon/basepoint.h"
#include "curve/rational.h"         /* LOFT_WEIGHT_MIN */
#include "polygon/weighted_sum.h"   /* loft_weighted_sum */

static unsigned next_corner(unsigned corner) { return corner < 2 ? corner + 1 : 0; }

/* True if this control point is cut off. */
static bool point_is_cut(const uint8_t l[3], unsigned degree, const uint8_t cut[3])
{
    for (unsigned i = 0; i < 3; i++)
        if (l[i] + cut[i] > degree)
            return true;
    return false;
}

enum loft_status loft_basepoint_init(loft_basepoint *b, const loft_vec p[], const loft_real w[],
                                     unsigned degree, const uint8_t cut[3])
{
    uint8_t l[3];
    unsigned rank = 0;

    if (degree < 1 || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < 3; i++)
        if ((unsigned)cut[i] + cut[next_corner(i)] >= degree)
            return LOFT_ERR_ARG;
    loft_multiindex_first(l, 3, degree);
    do {
        const bool read = !point_is_cut(l, degree, cut);
        if (read && !(w[rank] >= LOFT_WEIGHT_MIN && w[rank] <= LOFT_WEIGHT_MAX))
            return LOFT_ERR_RANGE;
        for (int i = 0; i < LOFT_AXES && read; i++)
            if (!loft_real_valid(p[rank].axis[i]))
                return LOFT_ERR_RANGE;
        rank++;
    } while (loft_multiindex_next(l, 3));
    b->p = p;
    b->w = w;
    b->degree = (uint8_t)degree;
    for (unsigned i = 0; i < 3; i++)
        b->cut[i] = cut[i];
    return LOFT_OK;
}

/* The sum of all terms with factor[0]^i factor[1]^j factor[2]^k shared^(degree - index - cut),
 * index and cut being those of the corner. */
static enum loft_status sum_terms(const loft_basepoint *b, const loft_sci factor[3],
                                  loft_sci shared, unsigned corner, loft_vec *out)
{
    uint8_t l[3];
    unsigned rank = 0;
    loft_weighted_sum sum;

    loft_weighted_sum_start(&sum);
    loft_multiindex_first(l, 3, b->degree);
    do {
        if (!point_is_cut(l, b->degree, b->cut)) {
            loft_sci weight = loft_sci_mul(loft_sci_from_int(loft_multiindex_multinomial(l, 3)),
                                           loft_sci_from_real(b->w[rank]));
            weight = loft_sci_mul(
                weight, loft_sci_pow(shared, (unsigned)b->degree - l[corner] - b->cut[corner]));
            for (unsigned i = 0; i < 3; i++)
                weight = loft_sci_mul(weight, loft_sci_pow(factor[i], l[i]));
            if (loft_sci_sign(weight))
                loft_weighted_sum_add(&sum, &b->p[rank], weight);
        }
        rank++;
    } while (loft_multiindex_next(l, 3));
    return loft_weighted_sum_project(&sum, out);
}

/* True if exactly one phi is 0, and a loft_unit holds the quotient of the other two; *number is the
 * side there. */
static bool find_side(const loft_basepoint *b, const loft_sci phi[3], unsigned *number,
                      loft_unit *t)
{
    unsigned zeros = 0, corner = 0;

    for (unsigned i = 0; i < 3; i++)
        if (!loft_sci_sign(phi[i])) {
            zeros++;
            corner = next_corner(i);
        }
    *number = corner;
    for (unsigned i = 0; i <= corner; i++)
        *number += b->cut[i] != 0;
    return zeros == 1 && loft_sci_is_unit(phi[next_corner(corner)], t);
}

enum loft_status loft_basepoint_eval(const loft_basepoint *b, loft_unit phi1, loft_unit phi2,
                                     loft_vec *out)
{
    loft_sci phi[3] = { loft_sci_from_unit(phi1), loft_sci_from_unit(phi2), loft_sci_one() };
    loft_unit t;
    unsigned number;

    for (unsigned i = 0; i < 2; i++)
        phi[2] = loft_sci_sub(phi[2], phi[i]);
    if (!(phi1 >= 0 && phi2 >= 0 && loft_sci_sign(phi[2]) >= 0))
        return LOFT_ERR_ARG;
    if (find_side(b, phi, &number, &t))
        return loft_basepoint_boundary(b, number, t, out);
    return sum_terms(b, phi, loft_sci_one(), 2, out);
}

/* Points with i + j < c are cut off, so the factor v^c is common to all that remain. */
enum loft_status loft_basepoint_corner(const loft_basepoint *b, unsigned corner, loft_unit u,
                                       loft_unit v, loft_vec *out)
{
    loft_sci factor[3];

    if (corner > 2 || !(u >= 0 && u <= LOFT_UNIT(1) && v >= 0 && v <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    const loft_sci x = loft_sci_from_unit(u), y = loft_sci_from_unit(v), one = loft_sci_one();

    factor[corner] = loft_sci_sub(one, y);
    factor[next_corner(corner)] = loft_sci_sub(one, x);
    factor[next_corner(next_corner(corner))] = x;
    return sum_terms(b, factor, y, corner, out);
}

enum loft_status loft_basepoint_uv(const loft_basepoint *b, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_basepoint_corner(b, 2, u, v, out);
}


/* The boundary */

unsigned loft_basepoint_sides(const loft_basepoint *b)
{
    unsigned sides = 3;

    for (unsigned i = 0; i < 3; i++)
        sides += b->cut[i] != 0;
    return sides;
}

loft_basepoint_side loft_basepoint_side_of(const loft_basepoint *b, unsigned number)
{
    loft_basepoint_side s = { 0, 0, false };

    for (;; s.corner++) {
        s.cut = b->cut[s.corner] != 0;
        if (s.cut && number-- == 0)
            break;
        s.cut = false;
        if (number-- == 0 || s.corner == 2)
            break;
    }
    const unsigned cut = b->cut[s.corner];
    s.degree = (uint8_t)(s.cut ? cut : b->degree - cut - b->cut[next_corner(s.corner)]);
    return s;
}

/* The rank of control point t of a side. At a cut corner the side has the points next to the cut.
 * Between corners it has the points on the edge of the triangle without those that are cut off. */
static unsigned side_rank(const loft_basepoint *b, loft_basepoint_side s, unsigned t)
{
    const unsigned cut = b->cut[s.corner], one = next_corner(s.corner), two = next_corner(one);
    uint8_t l[3];

    l[s.corner] = (uint8_t)(s.cut ? b->degree - cut : b->degree - cut - t);
    l[one]      = (uint8_t)(s.cut ? t : cut + t);
    l[two]      = (uint8_t)(s.cut ? cut - t : 0);
    return loft_multiindex_rank(l, 3);
}

/* A side of degree m between cut corners is a piece of a curve of the triangle's degree. Its
 * weights have the factor C(degree, cut + t) / C(m, t). */
static enum loft_status cut_side(const loft_basepoint *b, loft_basepoint_side s, loft_unit at,
                                 loft_vec *out)
{
    const loft_sci x = loft_sci_from_unit(at), y = loft_sci_sub(loft_sci_one(), x);
    loft_weighted_sum sum;

    loft_weighted_sum_start(&sum);
    for (unsigned t = 0; t <= s.degree; t++) {
        const unsigned rank = side_rank(b, s, t);
        loft_sci weight = loft_sci_mul(loft_sci_pow(y, s.degree - t), loft_sci_pow(x, t));
        weight = loft_sci_mul(weight,
                              loft_sci_from_int(loft_binomial(b->degree, b->cut[s.corner] + t)));
        loft_weighted_sum_add(&sum, &b->p[rank],
                              loft_sci_mul(weight, loft_sci_from_real(b->w[rank])));
    }
    return loft_weighted_sum_project(&sum, out);
}

enum loft_status loft_basepoint_boundary(const loft_basepoint *b, unsigned number, loft_unit t,
                                         loft_vec *out)
{
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_real w[LOFT_DEGREE_MAX + 1];

    if (number >= loft_basepoint_sides(b) || !(t >= 0 && t <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    const loft_basepoint_side s = loft_basepoint_side_of(b, number);
    if (!s.cut && s.degree < b->degree)
        return cut_side(b, s, t, out);
    for (unsigned k = 0; k <= s.degree; k++) {
        p[k] = b->p[side_rank(b, s, k)];
        w[k] = b->w[side_rank(b, s, k)];
    }
    const loft_sci share[2] = { loft_sci_sub(loft_sci_one(), loft_sci_from_unit(t)),
                                loft_sci_from_unit(t) };
    return loft_weighted_sum_curve(p, w, s.degree, share, out);
}
