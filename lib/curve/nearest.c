/* lib/curve/nearest.c
 * SPDX-License-Identifier: MIT
 *
 * Branch and bound over the dyadic pieces of the curve, with all coordinates relative to p. F is
 * the point of a piece's chord that is nearest to p, m = |F|, and u = F / m. No point of the piece
 * is nearer than the plane perpendicular to u that has all control points b_i behind it:
 *
 *     |P(t)| >= <P(t), u> >= min <b_i, u> = m + min <b_i - F, u>          (1)
 *
 * for any point F. A piece is dropped if (1) is not tol below the smallest distance found;
 * otherwise it is halved. On each piece the point with the parameter of F on the chord is tried.
 *
 * Both are within O(h^2) of m for a piece of width h. b_i is within n^2 / 8 times the largest
 * second difference, 4 h^2 |P|, of the chord, and the point tried is within twice that of F. At h =
 * 2^-24 this is 2^-42 |P| (in q16 at most 2^-26 units, less than 2^-9 LSB). At that level each
 * piece may be dropped: the tree is finite.
 *
 * Rounding in q16: u is off by 2^-24, which changes (1) by 2^-22 |b_i - F|, subtracted below. m is
 * off by the error of loft_acc_hypot, 2^-28 of it + 2^-32. Four times that is added to the
 * tolerance, so that noise is not subdivided. */
#include "curve/nearest.h"
#include "basis/dyadic.h"   /* loft_dyad, loft_bernstein_sub */
#include "geom/chord.h"     /* loft_chord_foot */

/* The curve relative to p, and one piece of it. */
typedef struct {
    loft_acc whole[LOFT_AXES][LOFT_DEGREE_MAX + 1];
    loft_acc piece[LOFT_AXES][LOFT_DEGREE_MAX + 1];
    unsigned degree;
} scene;

/* Store the point at t of the current piece n if it is nearer than the best one found. */
static void try_at(scene *s, loft_dyad n, loft_unit t, loft_vec p, loft_nearest *out)
{
    loft_acc x[LOFT_AXES], c[LOFT_DEGREE_MAX + 1];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= s->degree; k++)
            c[k] = s->piece[i][k];
        x[i] = loft_bernstein_eval(c, s->degree, t);
    }
    const loft_acc distance = loft_acc_hypot(x, LOFT_AXES);
    if (distance >= out->distance)
        return;
    out->distance = distance;
    out->t = loft_dyad_at(n, t);
    for (int i = 0; i < LOFT_AXES; i++)
        out->point.axis[i] = loft_acc_round(loft_to_acc(p.axis[i]) + x[i]);
}

/* The bound (1), and the parameter on the chord of its nearest point. */
static loft_acc bound_of(const scene *s, loft_unit *t)
{
    loft_acc w[LOFT_AXES], foot[LOFT_AXES], behind = 0;
    loft_unit u[LOFT_AXES];
    loft_chord c;

    for (int i = 0; i < LOFT_AXES; i++) {
        c.u[i] = s->piece[i][s->degree] - s->piece[i][0];
        w[i]   = -s->piece[i][0];
    }
    loft_chord_aim(&c);
    const loft_acc along = loft_chord_foot(&c, w, foot);
    *t = along <= 0 ? 0 : along < c.length ? loft_unit_ratio(along, c.length) : LOFT_UNIT(1);

    const loft_acc m = loft_acc_hypot(foot, LOFT_AXES);
    if (!(m > 0))
        return 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        foot[i] = -foot[i];
        u[i] = loft_unit_ratio(foot[i], m);
    }
    for (unsigned k = 0; k <= s->degree; k++) {
        loft_acc forward = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            forward += loft_acc_scale(s->piece[i][k] - foot[i], u[i]);
        if (forward < behind)
            behind = forward;
    }
    return m + behind + loft_acc_scale(behind, LOFT_UNIT(1.0 / 4194304));
}

static void cut_scene(scene *s, loft_dyad n)
{
    for (int i = 0; i < LOFT_AXES; i++)
        loft_bernstein_sub(s->whole[i], s->degree, loft_dyad_from(n), loft_dyad_to(n), s->piece[i]);
}

/* Both ends are tried first, then the pieces. */
static void search(scene *s, loft_vec p, loft_acc tol, loft_nearest *out)
{
    loft_dyad n = { 0, 0 };
    loft_unit t;

    cut_scene(s, n);
    try_at(s, n, 0, p, out);
    try_at(s, n, LOFT_UNIT(1), p, out);
    do {
        for (;;) {
            cut_scene(s, n);
            const loft_acc bound = bound_of(s, &t);
            try_at(s, n, t, p, out);
            if (bound >= out->distance - tol - 4 * loft_hypot_ulp(out->distance) ||
                n.level == LOFT_DYAD_LEVELS)
                break;
            n = loft_dyad_half(n, 0);
        }
    } while (loft_dyad_next(&n));
}

enum loft_status loft_bezier_nearest(const loft_bezier *b, loft_vec p, loft_real tol,
                                     loft_nearest *out)
{
    loft_nearest found;
    scene s;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    if (!loft_vec_valid(p))
        return LOFT_ERR_RANGE;

    s.degree = b->degree;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= s.degree; k++)
            s.whole[i][k] = loft_to_acc(b->p[k].axis[i]) - loft_to_acc(p.axis[i]);

    found.t = 0;
    found.point = b->p[0];
    found.distance = loft_vec_distance(p, b->p[0]);
    search(&s, p, loft_to_acc(tol), &found);
    *out = found;
    return LOFT_OK;
}
