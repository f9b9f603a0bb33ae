/* lib/polygon/meanvalue.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/meanvalue.h"

static unsigned next(unsigned i, unsigned sides) { return i + 1 < sides ? i + 1 : 0; }

/* The tangent of half the signed angle from d_i to d_(i+1), seen from p:
 *
 *     cross / (r_i r_(i+1) + dot)    or    (r_i r_(i+1) - dot) / cross
 *
 * whichever adds two numbers of one sign. The cross product is 0 only where the angle is: p is not on the edge. */
static loft_sci half_tangent(const loft_sci d[2][2], loft_sci r0, loft_sci r1, loft_sci cross)
{
    const loft_sci dot = loft_sci_add(loft_sci_mul(d[0][0], d[1][0]), loft_sci_mul(d[0][1], d[1][1]));
    const loft_sci rr = loft_sci_mul(r0, r1);

    if (loft_sci_sign(dot) < 0)
        return loft_sci_div(loft_sci_sub(rr, dot), cross);
    return loft_sci_div(cross, loft_sci_add(rr, dot));
}

/* w_i = (t_(i-1) + t_i) / r_i, phi_i = w_i / sum w. The sum of a simple polygon is never 0 (Hormann, Floater: it is positive
 * inside and negative outside).
 *
 * A tangent errs by eight roundings of itself, in floats by what the cross product does, and by what the dot product
 * loses: at most 2 roundings of r r', which is no more than the sum it goes into. The two tangents may cancel, and so may the
 * w_i outside: errors count by K = sum (|t_(i-1)| + |t_i|) / r_i over |sum w_i|, and in phi_i = w_i / sum w by (1 + |phi_i|) K. */
enum loft_status loft_meanvalue_eval(const loft_domain *d, loft_spot p, loft_sci phi[])
{
    loft_sci area[LOFT_SIDES_MAX], r[LOFT_SIDES_MAX], to[LOFT_SIDES_MAX][2], sum = loft_sci_zero();
    const unsigned n = d->sides;
    unsigned index = 0;

    if (!loft_spot_admits(p))
        return LOFT_ERR_RANGE;
    const enum loft_place place = loft_domain_place(d, p, area, &index);
    if (place == LOFT_AT_VERTEX)
        loft_domain_vertex(d, index, phi);
    if (place == LOFT_ON_EDGE)
        loft_domain_edge(d, p, index, phi);
    if (place == LOFT_AT_VERTEX || place == LOFT_ON_EDGE)
        return LOFT_OK;

    for (unsigned i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++)
            to[i][k] = loft_sci_sub(loft_sci_from_real(d->v[i].at[k]), loft_sci_from_real(p.at[k]));
        r[i] = loft_sci_sqrt(loft_sci_add(loft_sci_mul(to[i][0], to[i][0]), loft_sci_mul(to[i][1], to[i][1])));
    }
    for (unsigned i = 0; i < n; i++) {
        const unsigned j = next(i, n);
        const loft_sci both[2][2] = { { to[i][0], to[i][1] }, { to[j][0], to[j][1] } };
        area[i] = half_tangent(both, r[i], r[j], area[i]);
    }
    for (unsigned i = 0; i < n; i++) {
        phi[i] = loft_sci_div(loft_sci_add(area[i ? i - 1 : n - 1], area[i]), r[i]);
        sum = loft_sci_add(sum, phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_div(phi[i], sum);
    return LOFT_OK;
}
