/* tests/vectors/vectors_across.c -- readers of what is asked of surfaces: where they meet, the
 * light on them, their area, the nearest one to a grid of points
 * SPDX-License-Identifier: MIT
 *
 * own/surfaces.py makes the rows. Where f32 cannot hold a row's numbers, nothing is compared.
 */
#include <string.h>

#include "vectors/vectors_lines.h"          /* expect_lines */
#include "vectors/vectors_points.h"         /* as_given; row, answer, law */
#include "surface/area.h"
#include "support/exact_sci.h"           /* exact_sci */
#include "support/meetings.h"            /* distance_from_meetings */
#include "surface/tensor/surface_fit.h"
#include "surface/triangle/triangle_pieces.h"

#define MOST   (LOFT_DEGREE_MAX + 1)
#define HIGH   (LOFT_BEZIER_ELEVATE_MAX + 1)
#define ROOM   4096
#define POINTS 100
#define DATA   400

/* A net, with weights or without, and the same as a loft_surface. */
typedef struct {
    loft_vec p[MOST * MOST];
    loft_weighted w[MOST * MOST];
    loft_tensor tensor;
    loft_tensor_rational rational;
    loft_triangle triangle;
    loft_net net;
    loft_surface surface;
} sheet_of_row;

/* The columns kind, m, n, net_q16 and w_q16 with A or B behind the word. */
static void read_sheet(row *r, char which, sheet_of_row *s)
{
    static loft_real w[MOST * MOST];
    char kind[8] = "kind", m[8] = "m", n[8] = "n", net[12] = "net", weights[8] = "w";
    enum loft_status status;

    kind[4] = m[1] = n[1] = net[3] = weights[1] = which;
    strcpy(net + 4, "_q16");
    strcpy(weights + 2, "_q16");
    const unsigned rows = row_count(r, m, LOFT_DEGREE_MAX),
                   columns = row_count(r, n, LOFT_DEGREE_MAX);
    const bool triangle = row_is(r, kind, "triangle"), weighted = row_text(r, weights)[0] != '-';
    const unsigned count = triangle ? (rows + 1) * (rows + 2) / 2 : (rows + 1) * (columns + 1);

    row_points(r, net, count, 3, s->p);
    const long double largest = r->largest;
    if (weighted)
        row_reals(r, weights, count, w);
    r->largest = largest;
    for (unsigned k = 0; k < count && weighted; k++)
        s->w[k] = (loft_weighted) { s->p[k], w[k] };
    if (triangle) {
        status = loft_triangle_init(&s->triangle, s->p, rows);
        s->net = loft_net_from_triangle(&s->triangle);
        s->surface = loft_surface_from_triangle(&s->triangle);
    } else if (weighted) {
        status = loft_tensor_rational_init(&s->rational, s->w, rows, columns);
        s->net = loft_net_from_tensor_rational(&s->rational);
        s->surface = loft_surface_from_tensor_rational(&s->rational);
    } else {
        status = loft_tensor_init(&s->tensor, s->p, rows, columns);
        s->net = loft_net_from_tensor(&s->tensor);
        s->surface = loft_surface_from_tensor(&s->tensor);
    }
    if (status != LOFT_OK)
        row_complain(r, "surface %c was refused", which);
}


/* Where they meet */

static loft_net_meeting out[ROOM];
static unsigned count;

static void expect_places(row *r, long double tol)
{
    const char *text = row_text(r, "points");

    while (*text && !row_is(r, "points", "-")) {
        long double p[3];
        for (int axis = 0; axis < 3; axis++)
            p[axis] = row_next(&text);
        row_within(r, "points", distance_from_meetings(out, count, p) * 65536, 2 * tol * 65536);
        if (r->complaint[0])
            return;
    }
}

static bool is_last(unsigned k) { return k + 1 == count || out[k + 1].start; }

static void surface_meet(row *r)
{
    static sheet_of_row a, b;
    unsigned branches = 0, closed = 0, start = 0;

    read_sheet(r, 'A', &a);
    read_sheet(r, 'B', &b);
    const loft_real tol = row_real(r, "tol_q16");
    if (!as_given(r) || r->complaint[0])
        return;
    const enum loft_status status = loft_net_meet(a.net, b.net, tol, out, ROOM, &count);
    /* along a line where they touch there may be more parts than are examined */
    if (status == LOFT_MORE && row_is(r, "branches", "-"))
        return;
    if (status < 0 || status == LOFT_MORE)
        row_complain(r, "the surfaces were refused, or not decided: %d", (int)status);
    for (unsigned k = 0; k < count; k++) {
        branches += out[k].start && !out[k].touch;
        start = out[k].start ? k : start;
        closed += is_last(k) && start < k && loft_vec_equal(out[start].point, out[k].point);
    }
    expect_number(r, "branches", branches);
    expect_number(r, "closed", closed);
    expect_places(r, exact_of(tol));
}

static void curve_pierce(row *r)
{
    static sheet_of_row b;
    static loft_real w[MOST];
    loft_vec p[MOST];
    loft_weighted both[MOST];
    loft_bezier curve;
    loft_rational rational;
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    const bool weighted = row_text(r, "w_q16")[0] != '-';
    unsigned places = 0, simple = 0;

    row_points(r, "P_q16", n + 1, 3, p);
    const long double largest = r->largest;
    if (weighted)
        row_reals(r, "w_q16", n + 1, w);
    r->largest = largest;
    for (unsigned k = 0; k <= n; k++)
        both[k] = (loft_weighted) { p[k], weighted ? w[k] : LOFT_REAL(1) };
    read_sheet(r, 'B', &b);
    const loft_real tol = row_real(r, "tol_q16");
    if (loft_bezier_init(&curve, p, n) != LOFT_OK ||
        loft_rational_init(&rational, both, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
    if (!as_given(r) || r->complaint[0])
        return;
    const loft_net net = weighted ? loft_net_from_rational(&rational)
                                  : loft_net_from_bezier(&curve);
    const enum loft_status status = loft_net_meet(net, b.net, tol, out, ROOM, &count);
    if (status < 0 || status == LOFT_MORE)
        row_complain(r, "the surfaces were refused, or not decided: %d", (int)status);
    const char *t = row_text(r, "t"), *times = row_text(r, "mult");
    while (*t && *t != '-') {
        const long double want = row_next(&t);
        long double best = INFINITY;
        if (row_next(&times) != 1)
            continue;
        simple++;
        for (unsigned k = 0; k < count; k++)
            if (!out[k].touch)
                best = fminl(best, fabsl(exact_unit(out[k].at[0]) - want));
        row_within(r, "t", best * 65536, 0x1p-6L);
    }
    for (unsigned k = 0; k < count; k++)
        places += !out[k].touch;
    if (simple == 0 ? 0 : places < simple)
        row_complain(r, "%u places, %u are known", places, simple);
    expect_places(r, exact_of(tol));
}


/* Light */

static void surface_light(row *r)
{
    static sheet_of_row s;
    loft_real uv[2];
    loft_vec d, p;
    loft_level level;
    loft_acc off = 0;

    read_sheet(r, 'A', &s);
    const long double largest = r->largest;
    row_reals(r, "uv_q16", 2, uv);
    row_points(r, "D_q16", 1, 3, &d);
    r->largest = largest;
    if (!as_given(r) || r->complaint[0])
        return;
    const loft_unit u = loft_unit_of((uint32_t)(exact_of(uv[0]) * 65536), 65536),
                    v = loft_unit_of((uint32_t)(exact_of(uv[1]) * 65536), 65536);
    if (loft_level_light(&level, d, 0) != LOFT_OK ||
        loft_level_at(&level, &s.surface, u, v, &p, &off) != LOFT_OK) {
        row_complain(r, "the direction was refused");
        return;
    }
    const char *text = row_text(r, "cos");
    const long double want = row_is(r, "cos", "-") ? 0 : row_next(&text);
    /* 2^-46 over W, and the nets of this file have W above 2^-8 */
    row_within(r, "cos", fabsl(exact_acc(off) - want) * 65536,
               65536 * (0x1p-38L + BY_NUM(0x1p-32L, 0, 0)));
}

static void isophote(row *r)
{
    static sheet_of_row s;
    loft_level level;
    loft_vec d;

    read_sheet(r, 'A', &s);
    row_points(r, "D_q16", 1, 3, &d);
    const loft_real cosine = row_real(r, "cos_q16");
    if (!as_given(r) || r->complaint[0])
        return;
    if (loft_level_light(&level, d, cosine) == LOFT_OK)
        expect_lines(r, s.surface, &level, 0);
    else
        row_complain(r, "the direction was refused");
}

static void surface_section(row *r)
{
    static sheet_of_row s;
    loft_level level;
    loft_vec d = { { 0 } };

    read_sheet(r, 'A', &s);
    row_points(r, "D_q16", 1, 3, &d);
    const loft_real distance = row_real(r, "distance_q16");
    if (!as_given(r) || r->complaint[0])
        return;
    if (loft_level_plane(&level, d, distance) == LOFT_OK)
        expect_lines(r, s.surface, &level, 0);
    else
        row_complain(r, "the direction was refused");
}


/* Fits and areas */

static void surface_fit(row *r)
{
    static loft_real ku[40], kv[40], u[40], v[40];
    static loft_vec p[DATA], q[POINTS], middle[LOFT_SURFACE_FIT_POINTS(40, 40, 40)];
    static loft_sci memory[LOFT_FIT_MEMORY(40, LOFT_DEGREE_MAX)];
    const unsigned degree_u = row_count(r, "p", LOFT_DEGREE_MAX),
                   degree_v = row_count(r, "q", LOFT_DEGREE_MAX), m = row_count(r, "m", 20),
                   n = row_count(r, "n", 20), rows = row_count(r, "r", 20),
                   columns = row_count(r, "c", 20);
    const char *text = row_text(r, "gain");
    const long double gain = row_next(&text);

    row_reals(r, "U_q16", m + degree_u + 1, ku);
    row_reals(r, "V_q16", n + degree_v + 1, kv);
    row_reals(r, "u_q16", rows, u);
    row_reals(r, "v_q16", columns, v);
    r->largest = 0;
    row_points(r, "P_q16", rows * columns, 3, p);
    if (!as_given(r) || r->complaint[0])
        return;
    const loft_fit_grid data = { p, u, v, (uint16_t)rows, (uint16_t)columns };
    const loft_fit_net net = {
        ku, kv, (uint16_t)m, (uint16_t)n, (uint8_t)degree_u, (uint8_t)degree_v
    };
    const enum loft_status status = loft_surface_fit(&data, &net, q, middle, memory);
    /* what the first way rounds goes through the second one */
    expect_vecs(r, "Q", status, q, m * n, 3,
                (law){ .lsb = 0.501L + 0.501L * gain,
                       .gain = 1,
                       .roundings = BY_NUM(0, 0x1p28L, 64) * (1 + gain) * (1 + gain) * 16 });
}

static loft_sci area_memory[LOFT_NET_MOMENT_MEMORY(LOFT_DEGREE_MAX, LOFT_DEGREE_MAX)];

/* The integral in a column, which is asked for within 2^-7. */
static void expect_integral(row *r, const char *column, enum loft_status status, loft_acc got)
{
    const char *text = row_text(r, column);

    if (status != LOFT_OK)
        row_complain(r, "its %s was refused", column);
    row_within(r, column, fabsl(exact_acc(got) - row_next(&text)) * 65536,
               (0x1p-7L + 1e-9L) * 65536);
}

static void net_area(row *r)
{
    static sheet_of_row s;
    loft_acc area = 0;
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);

    row_points(r, "net_q16", (m + 1) * (n + 1), 3, s.p);
    if (loft_tensor_init(&s.tensor, s.p, m, n) != LOFT_OK)
        row_complain(r, "the patch was refused");
    if (!as_given(r) || r->complaint[0])
        return;
    const loft_net net = loft_net_from_tensor(&s.tensor);
    const enum loft_status status = loft_net_area(net, LOFT_REAL(0.0078125), area_memory, &area);
    expect_integral(r, "area", status, area);
}

static void net_cone(row *r)
{
    static sheet_of_row a;
    const loft_real tol = LOFT_REAL(0.0078125);
    loft_acc area = 0, volume = 0;
    loft_sci moment[3];
    loft_vec apex;

    read_sheet(r, 'A', &a);
    row_points(r, "apex_q16", 1, 3, &apex);
    if (!as_given(r) || r->complaint[0])
        return;
    enum loft_status status = loft_net_area(a.net, tol, area_memory, &area);
    expect_integral(r, "area", status, area);
    status = loft_net_cone_volume(a.net, apex, tol, area_memory, &volume);
    expect_integral(r, "volume", status, volume);
    if (loft_net_cone_moment(a.net, apex, tol, area_memory, moment) != LOFT_OK)
        row_complain(r, "its moment was refused");
    const char *text = row_text(r, "moment");
    for (int axis = 0; axis < 3 && !r->complaint[0]; axis++)
        row_within(r, "moment", fabsl(exact_sci(moment[axis]) - row_next(&text)) * 65536,
                   (0x1p-7L + 1e-8L) * 65536);
}

static void net_high(row *r)
{
    static sheet_of_row a;
    static loft_vec high[HIGH * HIGH];
    const unsigned times = row_count(r, "times", LOFT_BEZIER_ELEVATE_MAX);
    const bool along_v = row_is(r, "along", "v");
    unsigned points = 0;
    enum loft_status status = LOFT_ERR_ARG;

    read_sheet(r, 'A', &a);
    if (!as_given(r) || r->complaint[0])
        return;
    if (a.net.triangle) {
        points = LOFT_TRIANGLE_POINTS(a.net.m + times);
        status = loft_triangle_elevate(&a.triangle, times, high);
    } else {
        points = (a.net.m + 1u + (along_v ? 0 : times)) * (a.net.n + 1u + (along_v ? times : 0));
        status = along_v ? loft_tensor_elevate_v(&a.tensor, times, high)
                         : loft_tensor_elevate_u(&a.tensor, times, high);
    }
    expect_vecs(r, "Q", status, high, points, 3,
                (law){ .lsb = 0.5L + 15 / 131072.0L, .roundings = 64 });
}

#define SHEET(x) "kind" x ",m" x ",n" x ",net" x "_q16,w" x "_q16"

const vector_system vectors_across[] = {
    { "surface_meet", SHEET("A") "," SHEET("B") ",tol_q16,branches,closed,points", surface_meet,
      "branches, closed exact, points 2 tol" },
    { "curve_pierce", "n,P_q16,w_q16," SHEET("B") ",tol_q16,t,mult,points", curve_pierce,
      "simple t 2^-22, all points 2 tol" },
    { "surface_light", SHEET("A") ",uv_q16,D_q16,cos", surface_light, "2^-38 + 2^-32" },
    { "isophote", SHEET("A") ",D_q16,cos_q16,size,count,slope,uv", isophote,
      "count exact, uv 2 LSB over the slope + 2^-23" },
    { "surface_section", SHEET("A") ",D_q16,distance_q16,size,count,slope,uv", surface_section,
      "count exact, uv 2 LSB over the slope + 2^-23" },
    { "surface_fit", "p,q,m,n,U_q16,V_q16,r,c,u_q16,v_q16,P_q16,gain,Q", surface_fit,
      "q16: 0.501 LSB (1 + gain)" },
    { "net_cone", SHEET("A") ",apex_q16,area,volume,moment", net_cone, "2^-7, as asked" },
    { "net_area", "m,n,net_q16,area", net_area, "2^-7, as asked" },
    { "net_high", SHEET("A") ",along,times,Q", net_high, "1/2 LSB + 15 * 2^-17 LSB" },
    { 0 }
};
