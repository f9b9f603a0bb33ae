/* lib/curve/circle.c -- arcs from the data that G-code and SVG give
 * SPDX-License-Identifier: MIT
 *
 * An arc is stored as u and v: the vector from the centre to its start, and the derivative there
 * with respect to the angle. u is exact if the centre is given, and sines have 58 bits. The error
 * of a point is therefore a few roundings of loft_acc (2^-33) and that of the sweep: 2^-33 of it
 * times the radius. The end is off by as much, plus the error of the input. This difference is
 * stored as drift, which grows in proportion to the angle, so both ends are exact.
 */
#include "curve/circle.h"

#define SAME_DIRECTION (LOFT_FINE_1 / 281474976710656)      /* 2^-48 */

#define DEGREES_MAX LOFT_REAL(16384)

typedef struct {
    loft_acc x, y;
} pair;

/* `a` rotated by the angle with that sine and cosine. */
static pair rotated_pair(pair a, loft_fine cosine, loft_fine sine)
{
    const pair b = { loft_fine_scale(a.x, cosine) - loft_fine_scale(a.y, sine),
                     loft_fine_scale(a.x, sine) + loft_fine_scale(a.y, cosine) };
    return b;
}

/* The length of a vector of known angle: the 28 bits of loft_acc_hypot are too few. */
static loft_acc pair_length(pair a, loft_fine angle)
{
    return loft_fine_scale(a.x, loft_fine_cos(angle)) + loft_fine_scale(a.y, loft_fine_sin(angle));
}

static loft_fine pair_angle(pair a) { return loft_fine_atan2(a.y, a.x); }

static bool arc_arguments_valid(loft_plane plane, int32_t turns)
{
    return plane.first != plane.second && plane.first < LOFT_AXES && plane.second < LOFT_AXES &&
           turns != 0 && turns >= -LOFT_TURNS_MAX && turns <= LOFT_TURNS_MAX;
}

static bool point_valid(loft_vec a)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_fine_valid(a.axis[i]))
            return false;
    return true;
}

/* b - a in the plane */
static pair plane_vector(loft_vec a, loft_vec b, loft_plane plane)
{
    const pair d = { loft_to_acc(b.axis[plane.first]) - loft_to_acc(a.axis[plane.first]),
                     loft_to_acc(b.axis[plane.second]) - loft_to_acc(a.axis[plane.second]) };
    return d;
}

static bool is_zero_pair(pair a) { return !(a.x < 0) && !(a.x > 0) && !(a.y < 0) && !(a.y > 0); }

/* Points */

/* The point at an angle, without drift. */
static pair on_ellipse(const loft_circle *c, loft_acc angle)
{
    const loft_fine a = loft_fine_angle(angle), cosine = loft_fine_cos(a), sine = loft_fine_sin(a);
    const pair p = {
        c->centre[0] + loft_fine_scale(c->u[0], cosine) + loft_fine_scale(c->v[0], sine),
        c->centre[1] + loft_fine_scale(c->u[1], cosine) + loft_fine_scale(c->v[1], sine)
    };
    return p;
}

/* Complete the arc from its start, u, v, sweep and radius. */
static void finish_arc(loft_circle *c, loft_vec from, loft_vec to, loft_plane plane)
{
    c->from = from;
    c->to = to;
    c->plane = plane;
    c->centre[0] = loft_to_acc(from.axis[plane.first]) - c->u[0];
    c->centre[1] = loft_to_acc(from.axis[plane.second]) - c->u[1];
    for (int i = 0; i < LOFT_AXES; i++)
        c->drift[i] = loft_to_acc(to.axis[i]) - loft_to_acc(from.axis[i]);
    const pair end = on_ellipse(c, c->sweep);
    c->drift[plane.first]  = loft_to_acc(to.axis[plane.first]) - end.x;
    c->drift[plane.second] = loft_to_acc(to.axis[plane.second]) - end.y;
}

enum loft_status loft_circle_eval(const loft_circle *c, loft_unit t, loft_vec *out)
{
    loft_acc p[LOFT_AXES];

    t = loft_unit_clamp(t);
    const pair turn = on_ellipse(c, loft_acc_scale(c->sweep, t));
    for (int i = 0; i < LOFT_AXES; i++)
        p[i] = loft_to_acc(c->from.axis[i]) + loft_acc_scale(c->drift[i], t);
    p[c->plane.first]  = turn.x + loft_acc_scale(c->drift[c->plane.first], t);
    p[c->plane.second] = turn.y + loft_acc_scale(c->drift[c->plane.second], t);
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_acc_valid(p[i]))
            return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = t > 0 ? t < LOFT_UNIT(1) ? loft_acc_round(p[i]) : c->to.axis[i]
                             : c->from.axis[i];
    return LOFT_OK;
}


/* Centre */

/* The angle of all turns after the first. */
static loft_acc more_turns(int32_t turns)
{
    const int32_t whole = (turns > 0 ? turns : -turns) - 1;
    return loft_fine_scale(loft_to_acc(loft_real_from_int(2 * whole)), LOFT_FINE_PI);
}

/* The angle from one direction to another in the direction of `turns`, including whole turns. */
static loft_acc sweep_between(loft_fine from, loft_fine to, int32_t turns)
{
    loft_fine a = turns > 0 ? to - from : from - to;

    if (a < SAME_DIRECTION)
        a += 2 * LOFT_FINE_PI;
    if (a < SAME_DIRECTION)
        a += 2 * LOFT_FINE_PI;
    return loft_fine_to_acc(a) + more_turns(turns);
}

static bool radii_alike(loft_acc a, loft_acc b)
{
    const loft_acc off = a > b ? a - b : b - a;
    return off <= loft_acc_ratio(a, 256) + 16 * loft_real_ulp(a);
}

enum loft_status loft_circle_from_centre(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_vec centre, int32_t turns)
{
    if (!arc_arguments_valid(plane, turns))
        return LOFT_ERR_ARG;
    if (!point_valid(from) || !point_valid(to) || !point_valid(centre))
        return LOFT_ERR_RANGE;

    const pair start = plane_vector(centre, from, plane), end = plane_vector(centre, to, plane);
    const loft_fine first = pair_angle(start), last = pair_angle(end);
    const loft_acc radius = pair_length(start, first);
    if (is_zero_pair(start) || !radii_alike(radius, pair_length(end, last)))
        return LOFT_ERR_ARG;

    const int side = turns > 0 ? 1 : -1;
    c->u[0] = start.x;
    c->u[1] = start.y;
    c->v[0] = -side * start.y;
    c->v[1] = side * start.x;
    c->radius = radius;
    c->sweep = sweep_between(first, last, turns);
    finish_arc(c, from, to, plane);
    return LOFT_OK;
}


/* Radius and ellipse
 *
 * In the ellipse's own axes, each divided by its radius, the arc is one of the unit circle. There
 * the vector from the start to the middle of the chord is (hx / rx, hy / ry) = q (cos p, sin p).
 * The centre is at the distance s = sqrt(1 - q^2) to the side of the chord, and the arc is 2 asin q
 * or the rest of the turn. */

typedef struct {
    pair      half;             /* in the ellipse's axes, not divided */
    loft_acc  radius[2];
    loft_fine p, q;
    loft_acc  stretch;          /* of the radii, 1 if they suffice  */
} chord;

/* The direction of (hx / rx, hy / ry) is that of (hx ry, hy rx). */
static loft_fine half_chord_angle(const chord *d, const loft_real radii[2])
{
    if (!(radii[0] < radii[1]) && !(radii[0] > radii[1]))
        return pair_angle(d->half);
    const pair a = { loft_acc_mul(loft_acc_ratio(d->half.x, 4), radii[1]),
                     loft_acc_mul(loft_acc_ratio(d->half.y, 4), radii[0]) };
    return pair_angle(a);
}

/* Compute p, and q or the stretch; false if the stretched radii do not fit. q is computed in the
 * axis of the larger component, as a loft_fine: close to 1 its error determines the centre. */
static bool measure_chord(chord *d, const loft_real radii[2])
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1)),
                   larger = loft_to_acc(radii[0] > radii[1] ? radii[0] : radii[1]);

    d->p = half_chord_angle(d, radii);
    const loft_fine cosine = loft_fine_cos(d->p), sine = loft_fine_sin(d->p);
    const bool up = loft_fine_mul(sine, sine) > LOFT_FINE_1 / 2;
    const loft_fine part = up ? (sine < 0 ? -sine : sine) : cosine < 0 ? -cosine : cosine;
    const loft_acc way = up ? d->half.y : d->half.x, far = way < 0 ? -way : way,
                   radius = loft_to_acc(radii[up]);

    d->stretch = one;
    d->q = LOFT_FINE_1;
    if (far < 2 * radius)
        d->q = loft_fine_ratio((loft_acc)loft_fine_ratio(far, radius), (loft_acc)part);
    if (far >= 2 * radius || d->q > LOFT_FINE_1) {
        const loft_acc reach = loft_fine_scale(radius, part);
        if (!(reach > loft_acc_ratio(far, 536870912)))
            return false;
        d->q = LOFT_FINE_1;
        d->stretch = loft_fine_quot(far, reach);
        if (d->stretch > loft_fine_quot(loft_to_acc(LOFT_REAL_MAX), larger > one ? larger : one))
            return false;
    }
    for (int i = 0; i < 2; i++)
        d->radius[i] = loft_acc_mul(d->stretch, radii[i]);
    return true;
}

/* A straight line is an arc of radius 0 that consists of drift only. */
static void set_straight(loft_circle *c, loft_vec from, loft_vec to, loft_plane plane)
{
    c->u[0] = c->u[1] = c->v[0] = c->v[1] = c->radius = 0;
    c->sweep = loft_to_acc(LOFT_REAL(1));
    finish_arc(c, from, to, plane);
}

/* u and v in the ellipse's axes, rotated by its angle. The centre is to the left of the chord for a
 * small arc to the left. */
static void set_ellipse(loft_circle *c, const chord *d, loft_fine cosine, loft_fine sine,
                        bool large, bool left)
{
    const loft_fine side = loft_fine_sqrt(loft_fine_mul(LOFT_FINE_1 - d->q, LOFT_FINE_1 + d->q));
    const loft_fine s = large == left ? -side : side;
    const loft_fine along = loft_fine_cos(d->p), across = loft_fine_sin(d->p);
    const loft_fine x = loft_fine_mul(s, across) - loft_fine_mul(d->q, along);
    const loft_fine y = -loft_fine_mul(s, along) - loft_fine_mul(d->q, across);
    const int way_round = left ? 1 : -1;
    const pair u = { loft_fine_scale(d->radius[0], x), loft_fine_scale(d->radius[1], y) };
    const pair v = { -way_round * loft_fine_scale(d->radius[0], y),
                     way_round * loft_fine_scale(d->radius[1], x) };
    const pair start = rotated_pair(u, cosine, sine), slope = rotated_pair(v, cosine, sine);

    c->u[0] = start.x;
    c->u[1] = start.y;
    c->v[0] = slope.x;
    c->v[1] = slope.y;
    c->radius = d->radius[0] > d->radius[1] ? d->radius[0] : d->radius[1];
    c->sweep = loft_fine_to_acc(2 *
                                loft_fine_atan2((loft_acc)d->q, (loft_acc)(large ? -side : side)));
}

static bool radius_magnitude(loft_real radius, loft_real *size)
{
    const loft_acc x = radius < 0 ? -loft_to_acc(radius) : loft_to_acc(radius);

    if (!loft_fine_valid(radius) || !loft_acc_valid(x))
        return false;
    *size = loft_acc_round(x);
    return true;
}

enum loft_status loft_circle_from_radius(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_real radius, int32_t turns)
{
    const bool large = radius < 0;
    loft_real radii[2];
    chord d;

    if (!arc_arguments_valid(plane, turns))
        return LOFT_ERR_ARG;
    if (!point_valid(from) || !point_valid(to) || !radius_magnitude(radius, &radii[0]))
        return LOFT_ERR_RANGE;
    radii[1] = radii[0];
    const pair whole = plane_vector(from, to, plane);
    d.half.x = whole.x / 2;
    d.half.y = whole.y / 2;
    if (is_zero_pair(whole) || !(radii[0] > 0) || !measure_chord(&d, radii) ||
        d.stretch > loft_to_acc(LOFT_REAL(1.00390625)))
        return LOFT_ERR_ARG;
    set_ellipse(c, &d, LOFT_FINE_1, 0, large, turns > 0);
    c->sweep += more_turns(turns);
    finish_arc(c, from, to, plane);
    return LOFT_OK;
}

/* Subtracts the nearest number of quarter turns, exactly. */
static void rotation_of(loft_real degrees, loft_fine *cosine, loft_fine *sine)
{
    const loft_acc quarter = loft_to_acc(LOFT_REAL(90));
    const int32_t quarters = loft_acc_int(loft_acc_ratio(loft_to_acc(degrees), 90));
    const loft_fine a = loft_fine_mul(
        loft_fine_ratio(loft_to_acc(degrees) - quarters * quarter, quarter), LOFT_FINE_PI / 2);
    const loft_fine c = loft_fine_cos(a), s = loft_fine_sin(a);

    *cosine = quarters & 1 ? (quarters & 2 ? s : -s) : quarters & 2 ? -c : c;
    *sine   = quarters & 1 ? (quarters & 2 ? -c : c) : quarters & 2 ? -s : s;
}

enum loft_status loft_circle_from_ellipse(loft_circle *c, loft_vec from, loft_vec to,
                                          loft_plane plane, const loft_real radii[2],
                                          loft_real degrees, bool large, int32_t turns)
{
    loft_fine cosine = LOFT_FINE_1, sine = 0;
    loft_real size[2];
    chord d;

    if (!arc_arguments_valid(plane, turns) || turns > 1 || turns < -1)
        return LOFT_ERR_ARG;
    if (!point_valid(from) || !point_valid(to) || !radius_magnitude(radii[0], &size[0]) ||
        !radius_magnitude(radii[1], &size[1]) ||
        !(degrees >= -DEGREES_MAX && degrees <= DEGREES_MAX))
        return LOFT_ERR_RANGE;
    const pair whole = plane_vector(from, to, plane);
    if (is_zero_pair(whole) || !(size[0] > 0) || !(size[1] > 0)) {
        set_straight(c, from, to, plane);
        return LOFT_OK;
    }
    if (size[0] < size[1] || size[0] > size[1])
        rotation_of(degrees, &cosine, &sine);
    d.half.x = whole.x / 2;
    d.half.y = whole.y / 2;
    d.half = rotated_pair(d.half, cosine, -sine);
    if (!measure_chord(&d, size))
        return LOFT_ERR_RANGE;
    set_ellipse(c, &d, cosine, sine, large, turns > 0);
    finish_arc(c, from, to, plane);
    return LOFT_OK;
}
