/* tests/lib/curve/test_curve_loops.c -- the loops that headers of lib/curve print, word for word,
 * over arbitrary curves
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include <math.h>

#include "support/cubics.h"         /* arb_shape, point_of, distance; CHECK */
#include "curve/bspline.h"
#include "curve/cardinal.h"
#include "curve/catmull.h"
#include "curve/circle.h"
#include "curve/clip.h"
#include "curve/crossings.h"
#include "curve/drawing.h"
#include "curve/forward.h"
#include "curve/inflections.h"
#include "curve/intersect.h"
#include "curve/measure.h"
#include "curve/moving_frame.h"
#include "curve/natural.h"
#include "curve/offset.h"
#include "curve/rational_walk.h"
#include "curve/self_crossings.h"
#include "curve/spline.h"
#include "curve/tcb.h"
#include "curve/to_cubics.h"

enum { MOST = 40, ROOM = LOFT_DEGREE_MAX + 1 };     /* points of a spline, of a curve */

static bool is_one(loft_vec a, loft_vec b) { return loft_vec_equal(a, b); }

static bool is_near(loft_vec a, loft_vec b, long double within)
{
    return distance(point_of(a), point_of(b)) <= within;
}

/* Places of any size up to 4,000 in all, neighbours apart. */
static unsigned arb_places(arb *a, loft_vec p[], unsigned most)
{
    const unsigned count = 4 + arb_below(a, most - 3);
    const int32_t limit = 1 << arb_below(a, 13);

    for (unsigned k = 0; k < count; k++)
        do
            p[k] = arb_vec(a, limit);
        while (k > 0 && is_one(p[k - 1], p[k]));
    return count;
}


// Splines, segment by segment
// ---------------------------

static void spans_of_a_b_spline_join(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5), count = degree + 1 + arb_below(a, 12);
    const int32_t step = (int32_t)1 << arb_below(a, 18);
    int32_t at = -(int32_t)arb_below(a, 100) * 65536;
    loft_real knots[MOST];
    loft_vec p[MOST];
    loft_bspline b;
    unsigned spans = 0, all = 0;

    for (unsigned k = 0; k < count; k++)
        p[k] = arb_vec(a, 1 << arb_below(a, 15));
    for (unsigned k = 0; k <= count + degree; k++) {
        at += arb_below(a, 3) ? 1 + (int32_t)arb_below(a, (uint32_t)step) : 0;
        knots[k] = loft_real_from_raw(at);
    }
    if (loft_bspline_init(&b, p, count, knots, degree) != LOFT_OK)
        return;                         /* a knot that is too frequent */
    for (unsigned k = degree; k < count; k++)
        all += knots[k] < knots[k + 1];
    loft_vec out[ROOM];
    for (unsigned span = 0; loft_bspline_next(&b, &span, out); ) {
        CHECK(knots[span] < knots[span + 1] && spans < all);
        CHECK(is_near(out[0], loft_bspline_eval(&b, knots[span]), 0.02L));
        spans++;
    }
    CHECK(spans == all);
}

static void segments_of_cardinal_splines_pass_their_points(arb *a)
{
    const loft_unit tension = arb_unit(a);
    loft_vec points[MOST];
    const size_t count = arb_places(a, points, MOST);
    size_t made = 0;
    loft_cubic c;

    for (size_t i = 0; i + 3 < count; i++)
        if (loft_cubic_from_cardinal(&points[i], tension, &c) == LOFT_OK) {
            CHECK(is_one(c.p[0], points[i + 1]) && is_one(c.p[3], points[i + 2]));
            made++;
        }
    CHECK(made == count - 3);
}

static void segments_of_catmull_rom_splines_pass_their_points(arb *a)
{
    const loft_unit alpha = arb_unit(a);
    loft_vec points[MOST];
    const size_t count = arb_places(a, points, MOST);
    size_t made = 0;
    loft_cubic c;

    for (size_t i = 0; i + 3 < count; i++)
        if (loft_cubic_from_catmull(&points[i], alpha, &c) == LOFT_OK) {
            CHECK(is_one(c.p[0], points[i + 1]) && is_one(c.p[3], points[i + 2]));
            made++;
        }
    CHECK(made == count - 3);
}

static void segments_of_tcb_splines_pass_their_points(arb *a)
{
    loft_vec points[MOST];
    const size_t count = arb_places(a, points, MOST);
    const loft_unit t = arb_unit(a);
    size_t made = 0;
    loft_cubic c;

    const loft_tcb smooth = { 0, 0, 0 }, tight = { t, 0, 0 };
    for (size_t i = 0; i + 3 < count; i++)
        if (loft_cubic_from_tcb(&points[i], &smooth, &tight, &c) == LOFT_OK) {
            CHECK(is_one(c.p[0], points[i + 1]) && is_one(c.p[3], points[i + 2]));
            made++;
        }
    CHECK(made == count - 3);
}

static void segments_of_a_natural_spline_pass_their_points(arb *a)
{
    loft_vec points[MOST];
    const uint32_t count = arb_places(a, points, MOST);
    uint32_t made = 0;
    loft_cubic c;

    static loft_natural_knot knots[MOST];
    loft_natural s;
    if (loft_natural_init(&s, points, count, LOFT_CHORD, knots) == LOFT_OK)
        for (uint32_t i = 0; i + 1 < count; i++)
            if (loft_cubic_from_natural(&s, i, &c) == LOFT_OK) {
                CHECK(is_one(c.p[0], points[i]) && is_one(c.p[3], points[i + 1]));
                made++;
            }
    CHECK(made == count - 1);
}

static void segments_of_a_closed_spline_pass_their_points(arb *a)
{
    loft_vec points[MOST];
    uint32_t count = arb_places(a, points, MOST), made = 0;
    loft_cubic c;

    while (is_one(points[0], points[count - 1]))
        count--;
    static loft_spline_knot knots[MOST];
    loft_spline s;
    if (loft_spline_init(&s, points, count, LOFT_ENDS_CLOSED, LOFT_CHORD, knots) == LOFT_OK)
        for (uint32_t i = 0; i < loft_spline_segments(&s); i++)
            if (loft_cubic_from_spline(&s, i, &c) == LOFT_OK) {
                CHECK(is_one(c.p[0], points[i]) && is_one(c.p[3], points[(i + 1) % count]));
                made++;
            }
    CHECK(made == count);
}


// Curves, piece by piece
// ----------------------

static unsigned drawn;
static loft_cubic drawn_first, drawn_last;

static void draw(const loft_cubic *c)
{
    CHECK(drawn == 0 || is_one(c->p[0], drawn_last.p[3]));
    if (drawn++ == 0)
        drawn_first = *c;
    drawn_last = *c;
}

static void follow(const loft_cubic *c) { draw(c); }
static void cut_along(const loft_cubic *c)
{
    drawn_last = *c;
    drawn++;
}

/* The ends are to 2 LSB on a circle of 0.1 to 100, a quarter of them the same. */
static void spans_of_an_arc_run_from_end_to_end(arb *a)
{
    const double radius = exp2(arb_below(a, 1000) / 100.0 - 3.4), tau = 8 * atan(1),
                 start = tau * arb_below(a, 1000) / 1000,
                 end = arb_below(a, 4) ? tau * arb_below(a, 1000) / 1000 : start;
    const loft_vec centre = arb_vec(a, 1000);
    const loft_real tolerance = LOFT_REAL(0.001 + arb_below(a, 100) / 1e4);
    const int32_t turns = arb_below(a, 2) ? -1 : 1 + (int32_t)arb_below(a, 3);
    loft_vec from = arb_vec(a, 1000), to = arb_vec(a, 1000);

    from.axis[0] = centre.axis[0] + LOFT_REAL(radius * cos(start));
    from.axis[1] = centre.axis[1] + LOFT_REAL(radius * sin(start));
    to.axis[0] = centre.axis[0] + LOFT_REAL(radius * cos(end));
    to.axis[1] = centre.axis[1] + LOFT_REAL(radius * sin(end));
    drawn = 0;
    loft_circle c;
    loft_circle_spans s;
    loft_cubic span;
    if (loft_circle_from_centre(&c, from, to, LOFT_PLANE_XY, centre, turns) == LOFT_OK &&
        loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, tolerance) == LOFT_OK)
        while (loft_circle_spans_next(&s, &span))
            draw(&span);
    CHECK(drawn > 0 && drawn <= 4u * 4 * 16);
    CHECK(is_one(drawn_first.p[0], from) && is_one(drawn_last.p[3], to));
}

/* Both start in one point, which is never cut off. */
static void clipping_ends_and_keeps_a_meeting(arb *r)
{
    const loft_cubic one = arb_shape(r);
    loft_cubic two = arb_shape(r);
    loft_bezier p, q;
    loft_acc gap = (loft_acc)((uint32_t)1 << arb_below(r, 20));

    two.p[0] = one.p[0];
    gap = BY_NUM(gap << 17, gap * 0x1p-10, gap * 0x1p-10);
    CHECK(loft_bezier_init(&p, one.p, 3) == LOFT_OK && loft_bezier_init(&q, two.p, 3) == LOFT_OK);
    loft_piece a, b;
    bool       less;
    loft_piece_start(&a, &p);
    loft_piece_start(&b, &q);
    while (loft_piece_clip(&a, &b, gap, &less) && less)
        ;
    CHECK(a.from == 0 && b.from == 0);
}

/* Of whole numbers up to 20, so that some cross more than once, touch or end in each other. */
static loft_bezier arb_few(arb *a, loft_vec p[], unsigned least)
{
    const unsigned degree = least + arb_below(a, 4 - least);
    loft_bezier b;

    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = i < 2 ? loft_real_from_int((int32_t)arb_below(a, 41) - 20) : 0;
    CHECK(loft_bezier_init(&b, p, degree) == LOFT_OK);
    return b;
}

static void crossings_are_on_both_curves(arb *a)
{
    loft_vec one[4], two[4];
    const loft_bezier p = arb_few(a, one, 1), q = arb_few(a, two, 1);
    unsigned used = 0, sum = 0;

#define use(s, t, multiple)                                                                        \
    do {                                                                                           \
        CHECK(is_near(loft_bezier_eval(&p, s), loft_bezier_eval(&q, t), 0.001L));                  \
        used++;                                                                                    \
        sum += (multiple);                                                                         \
    } while (0)
    loft_meeting m[LOFT_MEETINGS_MAX];
    unsigned     count;
    if (loft_bezier_crossings(&p, &q, m, &count) == LOFT_OK)
        for (unsigned k = 0; k < count; k++)
            use(m[k].s, m[k].t, m[k].multiplicity);
#undef use
    CHECK(used == count && sum <= p.degree * q.degree);
}

static void inflections_change_the_sign_of_curvature(arb *a)
{
    loft_vec p[4];
    const loft_bezier b = arb_few(a, p, 3);
    unsigned changes = 0;

#define use(t) changes += (t) >= 0 && (t) <= LOFT_UNIT(1)
    loft_flat f[LOFT_FLATS_MAX];
    unsigned  count;
    if (loft_bezier_inflections(&b, f, &count) == LOFT_OK)
        for (unsigned k = 0; k < count; k++)
            if (f[k].multiplicity % 2 == 1)
                use(f[k].t);
#undef use
    CHECK(changes <= 2 && changes <= count);
}

static void intersections_are_near_both_curves(arb *a)
{
    loft_vec one[4], two[4];
    const loft_bezier p = arb_few(a, one, 1), q = arb_few(a, two, 1);
    const loft_real tol = LOFT_REAL(exp2(-(double)arb_below(a, 10)) / 10);
    const long double near = arb_value(tol) + 1e-4L;
    size_t used = 0;

#define use(s, t, point)                                                                           \
    do {                                                                                           \
        CHECK(is_near(loft_bezier_eval(&p, s), point, near));                                      \
        CHECK(is_near(loft_bezier_eval(&q, t), point, near));                                      \
        used++;                                                                                    \
    } while (0)
    loft_crossing c[9];
    size_t        count;
    if (loft_bezier_intersect(&p, &q, tol, c, 9, &count) == LOFT_OK)
        for (size_t k = 0; k < count; k++)
            use(c[k].s, c[k].t, c[k].point);
#undef use
    CHECK(used <= (size_t)p.degree * q.degree);
}

static void self_crossings_are_two_places_of_one_curve(arb *a)
{
    loft_vec p[4];
    const loft_bezier b = arb_few(a, p, 3);
    const loft_real tol = LOFT_REAL(exp2(-(double)arb_below(a, 10)) / 10);
    const long double near = arb_value(tol) + 1e-4L;
    size_t used = 0;

#define use(s, t, point)                                                                           \
    do {                                                                                           \
        CHECK((s) < (t) && is_near(loft_bezier_eval(&b, s), point, near));                         \
        CHECK(is_near(loft_bezier_eval(&b, t), point, near));                                      \
        used++;                                                                                    \
    } while (0)
    loft_crossing c[8];
    size_t        count;
    if (loft_bezier_self_crossings(&b, tol, c, 8, &count) == LOFT_OK)
        for (size_t k = 0; k < count; k++)
            use(c[k].s, c[k].t, c[k].point);
#undef use
    CHECK(used <= 1);
}

static void a_table_is_drawn_to_its_end(arb *a)
{
    const unsigned runs = 1 + arb_below(a, 8);
    int16_t words[200];
    uint32_t n = 0, curves = 0, paths = 0;

    for (unsigned k = 0; k < runs; k++) {
        const bool begins = k == 0 || arb_below(a, 3) == 0;
        const int pieces = 1 + (int)arb_below(a, 3);
        const bool line = arb_below(a, 2);
        const int more = 2 * (begins + pieces * (line ? 1 : 3));
        if (begins)
            words[n++] = 0;
        const uint32_t at = begins ? n + 2 : n;
        for (int i = 0; i <= more; i++)
            words[n++] = (int16_t)(int)(arb_below(a, 65536) - 32768);
        words[at] = (int16_t)(line ? -pieces : pieces);
        paths += begins;
        curves += (uint32_t)pieces;
    }
    const loft_drawing icon = { words, n, (uint8_t)arb_below(a, 17) };
    uint32_t seen = 0, lifts = 0;
    loft_vec at = { { 0 } };
    loft_drawing_walk walk;
    loft_cubic curve;
    bool lifted;
    if (loft_drawing_begin(&walk, &icon) == LOFT_OK)
        while (loft_drawing_next(&walk, &curve, &lifted)) {
            CHECK(lifted || is_one(curve.p[0], at));
            at = curve.p[3];
            lifts += lifted;
            seen++;
        }
    CHECK(seen == curves && lifts == paths);
}


// Walks
// -----

static unsigned moved;
static loft_vec moved_to;

static void move_to(loft_vec p)
{
    moved_to = p;
    moved++;
}

static void line_to(loft_vec p) { move_to(p); }

static void a_walk_takes_its_steps_and_ends_on_the_end(arb *a)
{
    static const uint32_t most[6] = { 100, 3000, 3000, 2953, 567, 220 };
    const unsigned degree = 1 + arb_below(a, 5);
    const uint32_t n = 1 + arb_below(a, arb_below(a, 2) ? 100 : most[degree]);
    loft_vec p_[6];
    loft_bezier curve;

    for (unsigned k = 0; k <= degree; k++)
        p_[k] = arb_vec(a, 32767);
    CHECK(loft_bezier_init(&curve, p_, degree) == LOFT_OK);
    moved = 0;
    loft_forward w;
    loft_vec     p;
    if (loft_forward_init(&w, &curve, n) == LOFT_OK)
        while (loft_forward_next(&w, &p))
            move_to(p);
    CHECK(moved == n && is_one(moved_to, p_[degree]));
}

static void a_rational_walk_takes_its_steps_and_ends_on_the_end(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5);
    const uint32_t n = 1 + arb_below(a, arb_below(a, 2) ? 100 : 6208);
    loft_weighted p_[6];
    loft_rational curve;

    for (unsigned k = 0; k <= degree; k++) {
        p_[k].p = arb_vec(a, 32767);
        p_[k].w = loft_real_from_raw(256 + (int32_t)arb_below(a, 1u << (8 + arb_below(a, 16))));
    }
    CHECK(loft_rational_init(&curve, p_, degree) == LOFT_OK);
    moved = 0;
    loft_rational_walk w;
    loft_vec           p;
    if (loft_rational_walk_init(&w, &curve, n) == LOFT_OK)
        while (loft_rational_walk_next(&w, &p))
            move_to(p);
    CHECK(moved == n && is_one(moved_to, p_[degree].p));
}

static void chords_end_on_the_end(arb *a)
{
    const loft_cubic curve = arb_shape(a);
    const loft_real tol = LOFT_REAL(exp2((double)arb_below(a, 12) - 7));

    moved = 0;
    loft_flatten f;
    loft_vec     p;
    if (loft_flatten_init(&f, &curve, tol) == LOFT_OK)
        while (loft_flatten_next(&f, &p))
            line_to(p);
    CHECK(moved > 0 && is_one(moved_to, curve.p[3]));
}

static void cubics_of_a_rational_curve_run_from_end_to_end(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 4);
    loft_weighted p[6];
    loft_rational curve;

    for (unsigned k = 0; k <= degree; k++) {
        p[k].p = arb_vec(a, 100);
        p[k].w = loft_real_from_raw(16384 + (int32_t)arb_below(a, 4 * 65536));
    }
    CHECK(loft_rational_init(&curve, p, degree) == LOFT_OK);
    const loft_real tol = LOFT_REAL(exp2(-(double)arb_below(a, 10)));
    drawn = 0;
    loft_to_cubics s;
    loft_cubic  c;
    if (loft_rational_to_cubics_init(&s, &curve, tol) == LOFT_OK)
        while (loft_to_cubics_next(&s, &c))
            follow(&c);
    CHECK(drawn > 0 && is_one(drawn_first.p[0], p[0].p) && is_one(drawn_last.p[3], p[degree].p));
}

/* What is not behind and not apart joins what comes before it. */
static void an_offset_runs_to_its_end(arb *a)
{
    loft_cubic curve = arb_cubic(a, 1 << arb_below(a, 9));
    const loft_real aside = loft_real_from_raw((int32_t)arb_below(a, 40 * 65536) - 20 * 65536),
                    tol = LOFT_REAL(0.01 + arb_below(a, 100) / 1000.0);

    if (arb_below(a, 4) == 0)
        curve.p[1 + arb_below(a, 2)] = curve.p[3 * arb_below(a, 2)];
    curve.p[3].axis[0] = curve.p[0].axis[0] + LOFT_REAL(1);
    drawn = 0;
    loft_offset      o;
    loft_offset_span s;
    if (loft_offset_init(&o, &curve, aside, tol) == LOFT_OK)
        while (loft_offset_next(&o, &s))
            if (!s.behind)
                cut_along(&s.curve);
    CHECK(o.at == (uint32_t)1 << 24 && drawn < 5000);
}

/* Each place lies ahead, each tangent within a right angle of the one before. */
static void a_section_is_carried_along_a_path(arb *a)
{
#if LOFT_AXES >= 3
    const unsigned n = 2 + arb_below(a, MOST - 1);
    loft_vec place[MOST + 2], tangent[MOST + 2], up = { { 0 } }, section = { { 0 } }, p;
    unsigned k = 0, made = 0;

    place[0] = arb_vec(a, 100);
    for (unsigned i = 0; i < n; i++) {
        tangent[i] = arb_vec(a, 1);
        tangent[i].axis[0] = LOFT_REAL(3);
        if (i > 0)
            place[i] = loft_vec_add(place[i - 1], tangent[i]);
    }
    up.axis[1] = LOFT_REAL(1);
    for (int i = 0; i < 3; i++)
        section.axis[i] = arb_real(a, 10);
    loft_moving_frame f;
    if (loft_moving_frame_start(&f, place[0], tangent[0], up) == LOFT_OK)
        for (k = 1; k < n && loft_moving_frame_move(&f, place[k], tangent[k]) == LOFT_OK; k++)
            if (loft_moving_frame_point(&f, section, &p) == LOFT_OK) {
                const point zero = { { 0 } };
                CHECK_NEAR(distance(point_of(p), point_of(place[k])),
                           distance(point_of(section), zero), 1e-3);
                made++;
            }
    CHECK(k == n && made == n - 1);
#else
    (void)a;
#endif
}

int main(void)
{
    PROPERTY(spans_of_a_b_spline_join,                                200);
    PROPERTY(segments_of_cardinal_splines_pass_their_points,          100);
    PROPERTY(segments_of_catmull_rom_splines_pass_their_points,       100);
    PROPERTY(segments_of_tcb_splines_pass_their_points,               100);
    PROPERTY(segments_of_a_natural_spline_pass_their_points,          100);
    PROPERTY(segments_of_a_closed_spline_pass_their_points,           100);
    PROPERTY(spans_of_an_arc_run_from_end_to_end,                     200);
    PROPERTY(clipping_ends_and_keeps_a_meeting,                       300);
    PROPERTY(crossings_are_on_both_curves,                             20);
    PROPERTY(inflections_change_the_sign_of_curvature,                 50);
    PROPERTY(intersections_are_near_both_curves,                      100);
    PROPERTY(self_crossings_are_two_places_of_one_curve,              100);
    PROPERTY(a_table_is_drawn_to_its_end,                             300);
    PROPERTY(a_walk_takes_its_steps_and_ends_on_the_end,              100);
    PROPERTY(a_rational_walk_takes_its_steps_and_ends_on_the_end,      50);
    PROPERTY(chords_end_on_the_end,                                   200);
    PROPERTY(cubics_of_a_rational_curve_run_from_end_to_end,          100);
    PROPERTY(an_offset_runs_to_its_end,                               100);
    PROPERTY(a_section_is_carried_along_a_path,                       100);
    return check_failures();
}
