/* host-tools/geometry/surface_ends.c -- knots and polygons of a surface that was read
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "num/status.h"             /* enum loft_status */

#include "engine/engine_sided.h"    /* engine_sides_f64 */
#include "engine/sided.h"           /* sided_regular, sided_is_lattice */
#include "geometry/surface_ends.h"

// Knots
// -----

int surface_end_knots(const lines *at, surface *s)
{
    char words[96];

    for (unsigned along = 0; along < 2; along++) {
        const unsigned degree = along ? s->n : s->m, points = along ? s->columns : s->rows,
                       pieces = points - degree, count = points + degree + 1;
        for (unsigned i = 0; i < count && s->knots[along] == i; i++)
            surface_add_knot(s, along, i <= degree ? 0 : i - degree < pieces ? i - degree : pieces);
        if (s->knots[along] != count) {
            snprintf(words, sizeof words, "%u knots %c for %u points of degree %u", s->knots[along],
                     along ? 'v' : 'u', points, degree);
            return lines_wrong(at, "surface.knots-count", words,
                               "give as many as points + degree + 1, or none");
        }
        const double *k = s->knot[along];
        for (unsigned i = 0; i < points; i++)
            if (!(k[i] < k[i + degree + 1]))
                return lines_wrong(at, "surface.knots-equal", "too many equal knots",
                                   "give each at most degree + 1 times");
        if (!(k[degree] < k[points]))
            return lines_wrong(at, "surface.knots-none", "knots that leave no surface",
                               "let those behind the first `degree` ascend");
    }
    return 0;
}


// Polygons
// --------

/* Sides are counted from 1: side k goes from vertex k to the next one. */
static int broken_domain(const lines *at, const surface *s, const unsigned side[2])
{
    const unsigned i = side[0], j = side[1], k = (j + 1) % s->n, n = (i + 1) % s->n;
    const double *a = s->domain[i], *b = s->domain[n], *c = s->domain[j], *d = s->domain[k];
    const double over = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
    const double share = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / over;
    unsigned one = 0;
    char words[160];

    while (one < s->n &&
           memcmp(s->domain[one], s->domain[(one + 1) % s->n], sizeof *s->domain) != 0)
        one++;
    if (one < s->n)
        snprintf(words, sizeof words, "vertices %u and %u of the domain are one point, (%g, %g)",
                 one + 1, (one + 1) % s->n + 1, s->domain[one][0], s->domain[one][1]);
    else if (j == n)
        snprintf(words, sizeof words, "the domain folds back onto itself at vertex %u, (%g, %g)",
                 j + 1, c[0], c[1]);
    else if (over != 0)
        snprintf(words, sizeof words, "sides %u and %u of the domain meet at (%g, %g)", i + 1,
                 j + 1, a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]));
    else
        snprintf(words, sizeof words, "sides %u and %u of the domain lie on each other", i + 1,
                 j + 1);
    return lines_wrong(at, "surface.domain-crosses", words,
                       "list its vertices once around, so that no two sides touch");
}

/* Refuse a polygon that is invalid, in itself or for these coordinates. */
static int judge_domain(const lines *at, surface *s)
{
    unsigned where[2];
    char words[160];
    const int status = engine_sides_f64.cut(s, where);

    if (status == LOFT_SINGULAR)
        return broken_domain(at, s, where);
    if (status == LOFT_ERR_ARG)
        return lines_wrong(at, "surface.domain-clockwise",
                           "the vertices of the domain run clockwise",
                           "list them counterclockwise, and the points of the net with them");
    const double *v = s->domain[where[0] % SURFACE_SIDES_MAX];
    if (status != LOFT_OK) {
        snprintf(words, sizeof words, "vertex %u of the domain, (%g, %g)", where[0] + 1, v[0],
                 v[1]);
        return lines_wrong(
            at, "surface.domain-vertex-far", words,
            "give coordinates below 32768, of not more than 15 digits behind the point");
    }
    if (where[0] < s->n && s->coordinates == COORDINATES_WACHSPRESS) {
        snprintf(
            words, sizeof words,
            "the domain is not convex at vertex %u, (%g, %g), which Wachspress coordinates ask for",
            where[0] + 1, v[0], v[1]);
        return lines_wrong(at, "surface.domain-not-convex", words,
                           "write meanvalue or harmonic behind the numbers");
    }
    return 0;
}

int surface_end_domain(const lines *at, surface *s)
{
    char words[64];

    if (s->kind == SURFACE_TORIC && !sided_is_lattice(s))
        return lines_wrong(at, "surface.polygon-missing", "toric without a polygon",
                           "give `domain x y x y ..` below it: whole numbers of -32 to 32, convex, "
                           "counterclockwise");
    if (s->kind != SURFACE_TORIC && s->corners != 0 && s->corners != s->n) {
        snprintf(words, sizeof words, "%u sides over a domain of %u vertices", s->n, s->corners);
        return lines_wrong(at, "surface.domain-count", words,
                           "give as many, or none for a regular polygon");
    }
    if (s->corners == 0 && s->kind != SURFACE_BASEPOINT)
        sided_regular(s);
    return judge_domain(at, s);
}
