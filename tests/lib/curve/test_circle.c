/* tests/lib/curve/test_circle.c -- properties of lib/curve/circle.h: arcs
 * SPDX-License-Identifier: MIT
 */
#include "support/arcs.h"               /* arb_centred, true_point */

/* e of the header */
static long double arc_error(const truth *t)
{
    const long double floats = 0x1p-48L * t->largest + 0x1p-51L * t->radius * t->sweep;
    const long double by_num[2] = { t->radius * 0x1p-32L + 0x1p-30L, floats };
    return by_num[BY_NUM(0, 1, 1)];
}

static void check_eval(const loft_circle *c, const truth *t, loft_unit part, long double more)
{
    long double want[LOFT_AXES];
    loft_vec v;

    true_point(t, exact_unit(part), want);
    if (loft_circle_eval(c, part, &v) != LOFT_OK) {
        bool near_edge = false;
        for (int i = 0; i < LOFT_AXES; i++)
            near_edge = near_edge || fabsl(want[i]) > 32767;
        CHECK(BY_NUM(near_edge, false, false));
        return;
    }
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), want[i], ulp(want[i]) / 2 + arc_error(t) + more);
}


/* Centre */

static void an_arc_around_a_centre_is_within_its_bound(arb *a)
{
    arc s;

    if (!arb_centred(a, &s))
        return;
    centred_truth(&s);
    const enum loft_status status = loft_circle_from_centre(&s.c, s.from, s.to, s.plane, s.centre,
                                                            s.turns);
    const pair e = minus(in_plane(s.to, s.plane), s.t.centre);
    const long double allowed = s.t.radius / 256 +
                                16 * BY_NUM(LSB, ulp(s.t.radius), ulp(s.t.radius)),
                      off = fabsl(size(e) - s.t.radius);
    if (off < 0.999L * allowed && s.t.radius > 0)
        CHECK(status == LOFT_OK);
    if (off > 1.001L * allowed || !(s.t.radius > 0))
        CHECK(status == LOFT_ERR_ARG || BY_NUM(false, off < 2.1L * allowed, off < 2.1L * allowed));
    if (status != LOFT_OK)
        return;
    if (fabsl(remainderl(s.t.sweep, 2 * pi)) > 1e-12L)
        CHECK_EXACT(exact_acc(s.c.sweep), s.t.sweep, BY_NUM(0x1p-31L, 1e-13L, 1e-13L));
    for (int k = 0; k < 4; k++)
        check_eval(&s.c, &s.t, arb_unit(a), 1e-14L);
    loft_vec v;
    CHECK(loft_circle_eval(&s.c, 0, &v) == LOFT_OK && loft_vec_equal(v, s.from));
    CHECK(loft_circle_eval(&s.c, LOFT_UNIT(1), &v) == LOFT_OK && loft_vec_equal(v, s.to));
}


/* Radius */

static void an_arc_of_a_radius_has_that_radius_and_side(arb *a)
{
    const loft_plane plane = arb_plane(a);
    const int32_t limit = 1 << arb_below(a, 13), turns = arb_below(a, 2) ? 1 : -1;
    const loft_vec from = arb_vec(a, limit), to = arb_vec(a, limit);
    const pair chord = minus(in_plane(to, plane), in_plane(from, plane));
    const long double stretch = 0.9L + arb_below(a, 4000) / 1000.0L,
                      want = size(chord) / 2 * stretch;
    const bool large = arb_below(a, 2);
    const loft_real r = coordinate(large ? -want : want);
    const long double radius = fabsl(exact_of(r));
    loft_circle c;

    const enum loft_status status = loft_circle_from_radius(&c, from, to, plane, r, turns);
    if (!(size(chord) > 0) || !(radius > 0) || size(chord) / 2 > radius * (1.00390625L + 1e-9L)) {
        CHECK(status == LOFT_ERR_ARG);
        return;
    }
    CHECK(status == LOFT_OK);
    const pair centre = { exact_acc(c.centre[0]), exact_acc(c.centre[1]) },
               start = minus(in_plane(from, plane), centre),
               end = minus(in_plane(to, plane), centre);
    const long double reach = fmaxl(radius, size(chord) / 2),
                      side = sqrtl(fmaxl(0, reach * reach - size(chord) * size(chord) / 4));
    const long double flat = BY_NUM(0x1p-28L, 0x1p-25L, 0x1p-25L) * reach;
    const long double well = BY_NUM(0x1p-57L, 0x1p-50L, 0x1p-50L) * reach * reach /
                             fmaxl(side, 1e-30L);
    const long double ill = fminl(flat, well) + BY_NUM(0x1p-29L, 0x1p-48L * (reach + limit),
                                                       0x1p-48L * (reach + limit));
    CHECK_EXACT(size(start), reach, ill);
    CHECK_EXACT(size(end), reach, ill);
    const long double half = asinl(fminl(1, size(chord) / 2 / reach));
    CHECK_EXACT(exact_acc(c.sweep), large ? 2 * pi - 2 * half : 2 * half,
                4 * ill / reach + BY_NUM(0x1p-31L, 1e-14L, 1e-14L));
    /* the middle of the arc lies to the right of the chord when turning left */
    const long double middle[2] = {
        exact_acc(c.centre[0] +
                  loft_fine_scale(c.u[0], loft_fine_cos(loft_fine_angle(c.sweep / 2))) +
                  loft_fine_scale(c.v[0], loft_fine_sin(loft_fine_angle(c.sweep / 2)))),
        exact_acc(c.centre[1] +
                  loft_fine_scale(c.u[1], loft_fine_cos(loft_fine_angle(c.sweep / 2))) +
                  loft_fine_scale(c.v[1], loft_fine_sin(loft_fine_angle(c.sweep / 2))))
    };
    const pair from_start = { middle[0] - in_plane(from, plane).x,
                              middle[1] - in_plane(from, plane).y };
    const long double cross = chord.x * from_start.y - chord.y * from_start.x,
                      bow = reach - side * (large ? -1 : 1);
    CHECK_EXACT(-turns * cross / size(chord), bow, 4 * ill + BY_NUM(0x1p-28L, 0, 0));
}

/* Half turns with integer data have their centre exactly in the middle of the chord. */
static void a_half_turn_of_a_radius_is_one(arb *a)
{
    static const int triple[4][3] = { { 3, 4, 5 }, { 5, 12, 13 }, { 8, 15, 17 }, { 0, 1, 1 } };
    const int *k = triple[arb_below(a, 4)], scale = 1 + (int)arb_below(a, 400);
    const loft_plane plane = { 0, 1 };
    loft_vec from = arb_vec(a, 1000), to;
    loft_circle c;

    to = from;
    for (int i = 0; i < 2; i++) {
        from.axis[i] = coordinate(arb_below(a, 32000) / 16.0L - 1000);
        to.axis[i] = from.axis[i] + coordinate(2 * k[i] * scale);
    }
    CHECK(loft_circle_from_radius(&c, from, to, plane, coordinate(k[2] * scale), 1) == LOFT_OK);
    for (int i = 0; i < 2; i++)
        CHECK_EXACT(exact_acc(c.centre[i]), exact_of(from.axis[i]) + k[i] * scale,
                    BY_NUM(0x1p-28L, 0x1p-25L, 0x1p-25L) * k[2] * scale);
    CHECK_EXACT(exact_acc(c.sweep), pi, BY_NUM(0x1p-27L, 0x1p-23L, 0x1p-23L));
}


/* Ellipses */

static pair turned(pair p, long double angle)
{
    const pair q = { p.x * cosl(angle) - p.y * sinl(angle), p.x * sinl(angle) + p.y * cosl(angle) };
    return q;
}

/* The formulas of appendix F.6.5 of SVG. */
static truth ellipse_truth(loft_vec from, loft_vec to, loft_plane plane, long double rx,
                           long double ry, long double degrees, bool large, bool left,
                           long double *root)
{
    const long double phi = degrees * pi / 180;
    const pair p0 = in_plane(from, plane), p1 = in_plane(to, plane),
               half = { (p0.x - p1.x) / 2, (p0.y - p1.y) / 2 }, h = turned(half, -phi);
    const long double lambda = h.x * h.x / (rx * rx) + h.y * h.y / (ry * ry);
    truth t;

    if (lambda > 1) {
        rx *= sqrtl(lambda);
        ry *= sqrtl(lambda);
    }
    *root = sqrtl(fmaxl(0, 1 / fmaxl(lambda, 1e-30L) - 1));
    if (lambda >= 1)
        *root = 0;
    const long double k = large != left ? *root : -*root;
    const pair c = { k * rx * h.y / ry, -k * ry * h.x / rx },
               middle = { (p0.x + p1.x) / 2, (p0.y + p1.y) / 2 }, offset = turned(c, phi);
    const pair s = { (h.x - c.x) / rx, (h.y - c.y) / ry },
               e = { (-h.x - c.x) / rx, (-h.y - c.y) / ry };
    const int side = left ? 1 : -1;
    const pair u = { rx * s.x, ry * s.y }, v = { -side * rx * s.y, side * ry * s.x };
    t.centre.x = middle.x + offset.x;
    t.centre.y = middle.y + offset.y;
    t.u = turned(u, phi);
    t.v = turned(v, phi);
    t.radius = fmaxl(rx, ry);
    t.sweep = side * (atan2l(e.y, e.x) - atan2l(s.y, s.x));
    if (t.sweep < 0)
        t.sweep += 2 * pi;
    *root *= sqrtl(fminl(lambda, 1));                   /* sqrt(1 - q^2) */
    complete(&t, from, to, plane);
    return t;
}

static void an_arc_of_an_ellipse_is_that_of_svg(arb *a)
{
    const loft_plane plane = arb_plane(a);
    const int32_t limit = 1 << arb_below(a, 12);
    const loft_vec from = arb_vec(a, limit), to = arb_vec(a, limit);
    const long double way = size(minus(in_plane(to, plane), in_plane(from, plane)));
    const loft_real radii[2] = { coordinate(way * (0.3L + arb_below(a, 2000) / 1000.0L)),
                                 coordinate(way * (0.3L + arb_below(a, 2000) / 1000.0L)) };
    const loft_real degrees = arb_below(a, 3) ? coordinate(of_raw(arb_raw(a, 65536 * 720)))
                                              : LOFT_REAL(90) * (loft_real)arb_below(a, 4);
    const bool large = arb_below(a, 2), left = arb_below(a, 2);
    long double root;
    loft_circle c;

    if (!(radii[0] > LOFT_REAL(0.001)) || !(radii[1] > LOFT_REAL(0.001)) || !(way > 0.001L))
        return;
    const truth t = ellipse_truth(from, to, plane, exact_of(radii[0]), exact_of(radii[1]),
                                  exact_of(degrees), large, left, &root);
    CHECK(loft_circle_from_ellipse(&c, from, to, plane, radii, degrees, large, left ? 1 : -1) ==
          LOFT_OK);
    const long double ratio = fmaxl(exact_of(radii[0]) / exact_of(radii[1]),
                                    exact_of(radii[1]) / exact_of(radii[0]));
    /* of q, from the rotation */
    const long double q_ulp = BY_NUM(0x1p-33L / t.radius * ratio, 0x1p-50L, 0x1p-50L);
    const long double ill = 8 * ratio * t.radius * fminl(q_ulp / fmaxl(root, 1e-30L), sqrtl(q_ulp));
    for (int k = 0; k < 4; k++)
        check_eval(&c, &t, arb_unit(a),
                   ill + 8 * ratio * BY_NUM(0x1p-31L, 0x1p-50L * t.largest, 0x1p-50L * t.largest));
}

static void degenerate_ellipses_are_straight(arb *a)
{
    const loft_plane plane = arb_plane(a);
    const loft_vec from = arb_vec(a, 16000), to = arb_below(a, 2) ? arb_vec(a, 16000) : from;
    const bool one = arb_below(a, 2);
    loft_real radii[2] = { arb_real(a, 1000), arb_real(a, 1000) };
    const loft_unit t = arb_unit(a);
    loft_circle c;
    loft_vec v;

    if (!loft_vec_equal(from, to))
        radii[one] = 0;
    CHECK(loft_circle_from_ellipse(&c, from, to, plane, radii, LOFT_REAL(30), false, 1) == LOFT_OK);
    CHECK(loft_circle_eval(&c, t, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]),
                    exact_of(from.axis[i]) +
                        exact_unit(t) * (exact_of(to.axis[i]) - exact_of(from.axis[i])),
                    2 * ulp(16000));
}


/* What is refused */

static void nonsense_is_refused(arb *a)
{
    const loft_plane xy = { 0, 1 }, same = { 1, 1 }, none = { 0, LOFT_AXES };
    const loft_vec from = arb_vec(a, 1000);
    loft_vec to = from, centre = from;
    const loft_real radii[2] = { LOFT_REAL(5), LOFT_REAL(5) };
    loft_circle c = { .radius = 0 };

    to.axis[0] += LOFT_REAL(10);
    centre.axis[0] += LOFT_REAL(5);
    CHECK(loft_circle_from_centre(&c, from, to, same, centre, 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_centre(&c, from, to, none, centre, 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_centre(&c, from, to, xy, centre, 0) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_centre(&c, from, to, xy, centre, LOFT_TURNS_MAX + 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_centre(&c, from, to, xy, from, 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_radius(&c, from, to, xy, 0, 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_radius(&c, from, from, xy, LOFT_REAL(5), 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_radius(&c, from, to, xy, LOFT_REAL(4.9), 1) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_ellipse(&c, from, to, xy, radii, 0, false, 2) == LOFT_ERR_ARG);
    CHECK(loft_circle_from_ellipse(&c, from, to, xy, radii, LOFT_REAL(17000), false, 1) ==
          LOFT_ERR_RANGE);
    CHECK(!(c.radius > 0));
    CHECK(loft_circle_from_centre(&c, from, to, xy, centre, 1) == LOFT_OK);
    if (BY_NUM(false, true, true)) {
        to.axis[0] = (loft_real)BY_NUM(0, NAN, NAN);
        CHECK(loft_circle_from_centre(&c, from, to, xy, centre, 1) == LOFT_ERR_RANGE);
    }
}

int main(void)
{
    PROPERTY(an_arc_around_a_centre_is_within_its_bound,     4000);
    PROPERTY(an_arc_of_a_radius_has_that_radius_and_side,    4000);
    PROPERTY(a_half_turn_of_a_radius_is_one,                 1000);
    PROPERTY(an_arc_of_an_ellipse_is_that_of_svg,            4000);
    PROPERTY(degenerate_ellipses_are_straight,               1000);
    PROPERTY(nonsense_is_refused,                              50);
    return check_failures();
}
