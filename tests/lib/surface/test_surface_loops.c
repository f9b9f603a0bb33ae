/* tests/lib/surface/test_surface_loops.c -- the loops that headers of lib/surface print, word for
 * word, over arbitrary patches
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include "support/tensors.h"            /* exact_of; CHECK */
#include "surface/contour.h"
#include "surface/net_branch.h"
#include "surface/net_meet.h"
#include "surface/tensor/ferguson.h"
#include "surface/tensor/grid.h"
#include "surface/tensor/revolve.h"
#include "surface/tensor/skin.h"
#include "surface/tensor/tensor_part.h"

#define MOST 8                          /* rows, columns, sections */

/* Over a square of 12 mm, or anywhere within 100. */
static loft_tensor arb_sheet(arb *a, loft_vec p[16], int32_t high)
{
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);
    loft_tensor s;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            loft_vec *const q = &p[i * (n + 1) + j];
            *q = (loft_vec){ { 0 } };
            q->axis[0] = LOFT_REAL(12.0 * i / m);
            q->axis[1] = LOFT_REAL(12.0 * j / n);
            q->axis[2] = arb_real(a, high);
        }
    CHECK(loft_tensor_init(&s, p, m, n) == LOFT_OK);
    return s;
}

static bool is_near(loft_real x, loft_real y)
{
    return fabsl(exact_of(x) - exact_of(y)) <= BY_NUM(0x1p-16L, 0x1p-15L, 1e-10L);
}


// Walks
// -----

static void contours_end_and_keep_their_height(arb *a)
{
    loft_vec net[16], p;
    const loft_tensor patch = arb_sheet(a, net, 10);
    const loft_real height = arb_real(a, 5), tol = LOFT_REAL(0.001);
    const unsigned axis = 2, rows = 1 + arb_below(a, MOST), columns = 1 + arb_below(a, MOST);
    unsigned starts = 0, points = 0;
    enum loft_contour_step step;

    static uint8_t memory[LOFT_CONTOUR_BYTES(MOST, MOST)];
    loft_contour c;
    if (loft_contour_init(&c, loft_surface_from_tensor(&patch), axis, height, tol, rows, columns,
                          memory, sizeof memory) == LOFT_OK)
        while ((step = loft_contour_next(&c, &p)) != LOFT_CONTOUR_OVER) {
            starts += step == LOFT_CONTOUR_START;
            points++;
            CHECK(starts > 0 && fabsl(exact_of(p.axis[2]) - exact_of(height)) <= 0.0011L);
        }
    CHECK(points <= 4 * (rows + 1) * (columns + 1) && starts <= points);
}

static void a_trace_runs_from_end_to_end(arb *a)
{
    loft_vec net[16], p, first = { { 0 } }, last = { { 0 } };
    const loft_tensor patch = arb_sheet(a, net, 10);
    const loft_unit at = arb_unit(a), from = arb_unit(a), to = arb_unit(a);
    const uint32_t n = 1 + arb_below(a, 100);
    uint32_t points = 0;

    const loft_surface s = loft_surface_from_tensor(&patch);
    loft_trace w;
    if (loft_trace_init(&w, s, at, from, at, to, n) == LOFT_OK)
        while (loft_trace_next(&w, &p)) {
            if (points++ == 0)
                first = p;
            last = p;
        }
    CHECK(points == n + 1);
    CHECK(s.eval(s.surface, at, from, &p) == LOFT_OK && loft_vec_equal(p, first));
    CHECK(s.eval(s.surface, at, to, &p) == LOFT_OK && loft_vec_equal(p, last));
}

static unsigned seen;
static loft_vec seen_last;

static void vertex(loft_vec p)
{
    seen++;
    seen_last = p;
}

static void a_grid_gives_every_row(arb *a)
{
    enum { DEGREE = 3 };
    loft_vec net[16];
    const loft_tensor patch = arb_sheet(a, net, 1000);
    const uint32_t rows = 1 + arb_below(a, 40), columns = 1 + arb_below(a, 40);

    seen = 0;
    static loft_state memory[LOFT_GRID_STATES(DEGREE, DEGREE)];
    loft_grid g;
    loft_vec  p;
    if (loft_grid_init(&g, &patch, rows, columns, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
        while (loft_grid_next(&g, &p))
            vertex(p);
    CHECK(seen == (rows + 1) * (columns + 1));
    CHECK(loft_vec_equal(seen_last, net[(patch.m + 1u) * (patch.n + 1u) - 1]));
}


// Meetings
// --------

static unsigned drawn, lifted;

static void line_to(loft_vec p)
{
    drawn++;
    for (int k = 0; k < 2; k++)
        CHECK(exact_of(p.axis[k]) > -0.01L && exact_of(p.axis[k]) < 12.01L);
}

static void move_to(loft_vec p)
{
    lifted++;
    line_to(p);
}

/* A sheet and a triangle through its middle; `out` holds all, or says why not. */
static void branches_of_two_surfaces_are_drawn(arb *a)
{
    loft_vec net[16], corner[3] = { { { 0 } } };
    const loft_tensor s = arb_sheet(a, net, 4);
    loft_triangle t;

    for (int k = 0; k < 3; k++) {
        corner[k].axis[0] = LOFT_REAL(k == 1 ? 12 : 0);
        corner[k].axis[1] = LOFT_REAL(k == 2 ? 12 : 0);
        corner[k].axis[2] = arb_real(a, 4);
    }
    CHECK(loft_triangle_init(&t, corner, 1) == LOFT_OK);
    drawn = lifted = 0;
    static loft_net_meeting out[4096];
    unsigned                count;
    if (loft_net_meet(loft_net_from_tensor(&s), loft_net_from_triangle(&t), LOFT_REAL(0.02), out,
                      4096, &count) == LOFT_OK)
        for (unsigned k = 0; k < count; k++)
            out[k].start ? move_to(out[k].point) : line_to(out[k].point);
    CHECK(drawn <= count && (drawn == 0 || lifted > 0));
}

static void follow(const loft_sci p[3])
{
    loft_acc z = 0;

    CHECK(loft_sci_to_acc(p[2], &z) && fabsl(exact_acc(z)) < 1e-3L);
    drawn++;
}

/* Of the plane z = 0 and a sheet with 4 corners that is 0 in its middle. */
static void a_branch_is_followed_to_a_border(arb *a)
{
    loft_vec flat[4], bent[4];
    loft_tensor s, t;
    loft_net_both both = { .curve = false };
    loft_net_place place;
    loft_net_branch branch;
    enum loft_net_went went = LOFT_NET_ON;
    const unsigned held = arb_below(a, 2);

    for (int k = 0; k < 4; k++) {
        flat[k] = (loft_vec){ { 0 } };
        flat[k].axis[0] = LOFT_REAL(k / 2 ? 12 : 0);
        flat[k].axis[1] = LOFT_REAL(k % 2 ? 12 : 0);
        bent[k] = flat[k];
        bent[k].axis[2] = k < 3 ? arb_real(a, 4)
                                : -(bent[0].axis[2] + bent[1].axis[2] + bent[2].axis[2]);
        place.x[k] = loft_sci_power2(-1);
    }
    CHECK(loft_tensor_init(&s, flat, 1, 1) == LOFT_OK);
    CHECK(loft_tensor_init(&t, bent, 1, 1) == LOFT_OK);
    both.origin = flat[0];
    both.tol = loft_to_acc(LOFT_REAL(0.01));
    both.wide = loft_sci_from_real(LOFT_REAL(0.01));
    loft_net_load(loft_net_from_tensor(&s), both.origin, &both.form[0]);
    loft_net_load(loft_net_from_tensor(&t), both.origin, &both.form[1]);
    drawn = 0;
#define use follow
    if (loft_net_settle(&both, held, &place) && loft_net_branch_init(&branch, &place))
        while ((went = loft_net_branch_next(&branch, &both)) == LOFT_NET_ON)
            use(branch.at.p);
#undef use
    CHECK(drawn < 1000 && (drawn == 0 || went != LOFT_NET_ON));
}


// Nets, piece by piece
// --------------------

static void cells_of_a_grid_pass_its_points(arb *a)
{
    const uint32_t rows = 2 + arb_below(a, MOST - 1), columns = 2 + arb_below(a, MOST - 1);
    loft_vec p[MOST * MOST];
    uint32_t i, j, made = 0;

    for (i = 0; i < rows * columns; i++)
        p[i] = arb_vec(a, 1000);
    loft_bicubic b;
    for (i = 0; i + 1 < rows; i++)
        for (j = 0; j + 1 < columns; j++)
            if (loft_bicubic_from_grid(p, rows, columns, i, j, LOFT_TWIST_ADINI, &b) == LOFT_OK)
                made++;
    CHECK(made == (rows - 1) * (columns - 1));
}

/* Each point keeps its distance from the axis; the last quarter ends where the first begins. */
static void quarters_of_a_turn_close(arb *a)
{
    enum { POINTS = 5 };
    const unsigned degree = 1 + arb_below(a, POINTS - 1);
    loft_weighted p[POINTS], net[4][3 * POINTS];
    loft_tensor_rational quarter[4];
    loft_rational profile;
    unsigned made = 0;

    for (unsigned k = 0; k <= degree; k++) {
        p[k].p = arb_vec(a, 1000);
        p[k].w = loft_real_from_raw(32768 + (int32_t)arb_below(a, 98304));
    }
    CHECK(loft_rational_init(&profile, p, degree) == LOFT_OK);
    for (unsigned k = 0; k < 4; k++)
        if (loft_tensor_rational_from_revolve(&profile, k, net[k]) == LOFT_OK &&
            loft_tensor_rational_init(&quarter[k], net[k], profile.degree, 2) == LOFT_OK)
            made++;
    CHECK(made == 4);
    for (unsigned k = 0; k < 4 * (degree + 1); k++) {
        const unsigned row = k % (degree + 1), turn = k / (degree + 1);
        CHECK(loft_vec_equal(net[turn][3 * row + 2].p, net[(turn + 1) % 4][3 * row].p));
        CHECK(loft_vec_equal(net[0][3 * row].p, p[row].p));
    }
}

static void pieces_of_a_skin_meet_its_sections(arb *a)
{
    enum { DEGREE = 3, SECTIONS = 6 };
    loft_vec points[SECTIONS * (DEGREE + 1)], net[4 * (DEGREE + 1)];
    loft_real v[SECTIONS];
    loft_tensor patch;
    unsigned made = 0;

    for (unsigned k = 0; k < SECTIONS * (DEGREE + 1); k++)
        points[k] = arb_vec(a, 100);
    for (unsigned k = 0; k < SECTIONS; k++)
        v[k] = (k ? v[k - 1] : 0) + LOFT_REAL(1) + arb_real(a, 1) / 2;
    static loft_spline_knot memory[SECTIONS * (DEGREE + 1)];
    loft_skin s;
    if (loft_skin_init(&s, points, DEGREE, SECTIONS, v, LOFT_ENDS_NATURAL, memory) == LOFT_OK)
        for (uint32_t j = 0; j + 1 < SECTIONS; j++)
            if (loft_tensor_from_skin(&s, j, net) == LOFT_OK &&
                loft_tensor_init(&patch, net, DEGREE, 3) == LOFT_OK) {
                for (unsigned k = 0; k <= DEGREE; k++)
                    for (int i = 0; i < LOFT_AXES; i++) {
                        CHECK(is_near(net[4 * k].axis[i], points[j * (DEGREE + 1) + k].axis[i]));
                        CHECK(is_near(net[4 * k + 3].axis[i],
                                      points[(j + 1) * (DEGREE + 1) + k].axis[i]));
                    }
                made++;
            }
    CHECK(made == SECTIONS - 1);
}

static uint32_t part_seed;
static long double covered;
static unsigned parts;

static bool is_done(const loft_dyad n[])
{
    const uint32_t mix = (n[0].k * 2654435761u) ^ (n[1].k * 40503u) ^ part_seed;
    const bool done = n[0].level + n[1].level >= 9 || (mix >> 8) % 7 < 2;

    covered += done ? ldexpl(1, -n[0].level - n[1].level) : 0;
    parts += done;
    return done;
}

static bool longer_along_u(const loft_dyad_box *part)
{
    return part->n[0].level <= part->n[1].level;
}

static void parts_cover_the_square(arb *a)
{
    part_seed = (uint32_t)arb_next(a);
    covered = parts = 0;
    loft_dyad_box part;
    loft_dyad_box_start(&part);
    do {
        while (!is_done(part.n))
            loft_dyad_box_halve(&part, longer_along_u(&part) ? 0 : 1);
    } while (loft_dyad_box_next(&part));
    CHECK(covered >= 1 && covered <= 1 && parts <= 512);
}

int main(void)
{
    PROPERTY(contours_end_and_keep_their_height,  100);
    PROPERTY(a_trace_runs_from_end_to_end,        100);
    PROPERTY(a_grid_gives_every_row,               50);
    PROPERTY(branches_of_two_surfaces_are_drawn,    3);
    PROPERTY(a_branch_is_followed_to_a_border,     50);
    PROPERTY(cells_of_a_grid_pass_its_points,      50);
    PROPERTY(quarters_of_a_turn_close,            100);
    PROPERTY(pieces_of_a_skin_meet_its_sections,   50);
    PROPERTY(parts_cover_the_square,              100);
    return check_failures();
}
