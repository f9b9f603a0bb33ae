/* tests/lib/surface/test_contour.c -- properties of lib/surface/contour.h and of the traces of
 * lib/surface/surface.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "surface/contour.h"
#include "support/tensors.h"    /* exact_of, ulp */

#define MOST   24
#define POINTS (4 * MOST * MOST)

static uint8_t memory[LOFT_CONTOUR_BYTES(MOST, MOST)];

typedef struct {
    loft_unit u, v;
    loft_vec p;
    bool start;
} found;

static found list[POINTS];

/* Collect all points. Returns their number. */
static unsigned gather(loft_contour *c)
{
    enum loft_contour_step step;
    unsigned count = 0;
    loft_vec p;

    while ((step = loft_contour_next(c, &p)) != LOFT_CONTOUR_OVER) {
        CHECK(count < POINTS);
        list[count].u = c->u;
        list[count].v = c->v;
        list[count].p = p;
        list[count++].start = step == LOFT_CONTOUR_START;
    }
    CHECK(loft_contour_next(c, &p) == LOFT_CONTOUR_OVER);
    return count;
}

static bool same(const loft_vec *a, const loft_vec *b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (a->axis[i] < b->axis[i] || a->axis[i] > b->axis[i])
            return false;
    return true;
}

/* A surface of any kind with control points to 100, and its grid. */
typedef struct {
    loft_vec p[TENSOR_POINTS];
    loft_tensor tensor;
    loft_triangle triangle;
    loft_surface sheet;
    unsigned rows, columns, axis;
    loft_real height, tol;
} scene;

static scene *arb_scene(arb *a)
{
    static scene x;
    const unsigned m = 1 + arb_below(a, 5), n = 1 + arb_below(a, 5);
    const bool triangle = arb_below(a, 3) == 0;

    for (unsigned k = 0; k < TENSOR_POINTS; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            x.p[k].axis[i] = arb_real(a, 100);
    CHECK(loft_tensor_init(&x.tensor, x.p, m, n) == LOFT_OK);
    CHECK(loft_triangle_init(&x.triangle, x.p, m) == LOFT_OK);
    x.sheet = triangle ? loft_surface_from_triangle(&x.triangle)
                       : loft_surface_from_tensor(&x.tensor);
    x.rows    = 1 + arb_below(a, MOST);
    x.columns = triangle ? x.rows : 1 + arb_below(a, MOST);
    x.axis    = arb_below(a, LOFT_AXES);
    x.height  = arb_below(a, 4) ? arb_real(a, 60) : x.p[arb_below(a, 3)].axis[x.axis];
    x.tol = BY_NUM((loft_real)arb_below(a, 40), (loft_real)(arb_below(a, 40) / 65536.0),
                   (loft_real)(arb_below(a, 40) * 1e-12));
    return &x;
}

static loft_vec point_at(const loft_surface *s, loft_unit u, loft_unit v)
{
    loft_vec p;
    CHECK(s->eval(s->surface, u, v, &p) == LOFT_OK);
    return p;
}

static bool is_high(const scene *x, unsigned i, unsigned j)
{
    const loft_vec p = point_at(&x->sheet, loft_unit_of(i, x->rows), loft_unit_of(j, x->columns));
    return p.axis[x->axis] >= x->height;
}

#define STEEPNESS (2 * 5 * 200.0L)      /* a bound of |S_u| + |S_v| */

static void points_have_the_height_and_lie_on_the_surface(arb *a)
{
    const scene *x = arb_scene(a);
    const long double step = BY_NUM(0x1p-24L, 0x1p-24L, 0x1p-53L),
                      eval = BY_NUM(0x1p-16L, 4 * 0x1p-17L, 0x1p-44L);
    loft_contour c;

    CHECK(loft_contour_init(&c, x->sheet, x->axis, x->height, x->tol, x->rows, x->columns, memory,
                            sizeof memory) == LOFT_OK);
    const unsigned count = gather(&c);
    for (unsigned k = 0; k < count; k++) {
        const loft_vec p = point_at(&x->sheet, list[k].u, list[k].v);
        CHECK(same(&p, &list[k].p));
        CHECK(fabsl(exact_of(p.axis[x->axis]) - exact_of(x->height)) <=
              exact_of(x->tol) + step * STEEPNESS + eval);
    }
}

/* Every triangle with corners on both sides is crossed once, from edge to edge, with its higher
 * corners to the left. Every curve is closed, or begins and ends on the border. */
typedef struct {
    long double u, v;
    bool high;
} cornered;

static bool on_border(const scene *x, const found *f)
{
    const long double u = exact_unit(f->u), v = exact_unit(f->v), less = 1e-6L;
    return u < less || v < less ||
           (x->sheet.over == LOFT_SURFACE_TRIANGLE ? u + v > 1 - less
                                                   : u > 1 - less || v > 1 - less);
}

static cornered corner_of(const scene *x, unsigned i, unsigned j)
{
    const cornered c = { (long double)i / x->rows, (long double)j / x->columns, is_high(x, i, j) };
    return c;
}

/* The triangle that contains the midpoint of two points. */
static void triangle_of(const scene *x, long double u, long double v, cornered out[3])
{
    unsigned i = (unsigned)(u * x->rows), j = (unsigned)(v * x->columns);

    i = i < x->rows ? i : x->rows - 1;
    j = j < x->columns ? j : x->columns - 1;
    const bool upper = u * x->rows - i + v * x->columns - j > 1;
    out[0] = upper ? corner_of(x, i + 1, j + 1) : corner_of(x, i, j);
    out[1] = corner_of(x, i, j + 1);
    out[2] = corner_of(x, i + 1, j);
}

static unsigned crossed(const scene *x)
{
    unsigned sum = 0;

    for (unsigned i = 0; i < x->rows; i++)
        for (unsigned j = 0; j < x->columns; j++) {
            const bool triangle = x->sheet.over == LOFT_SURFACE_TRIANGLE;
            if (triangle && i + j >= x->rows)
                continue;
            const bool one = is_high(x, i, j + 1), two = is_high(x, i + 1, j);
            sum += one != two || one != is_high(x, i, j);
            if (!triangle || i + j + 1 < x->rows)
                sum += one != two || one != is_high(x, i + 1, j + 1);
        }
    return sum;
}

static void curves_are_complete(arb *a)
{
    const scene *x = arb_scene(a);
    const long double less = 1e-5L / MOST;
    unsigned starts = 0, first = 0;
    loft_contour c;

    CHECK(loft_contour_init(&c, x->sheet, x->axis, x->height, x->tol, x->rows, x->columns, memory,
                            sizeof memory) == LOFT_OK);
    const unsigned count = gather(&c);
    for (unsigned k = 0; k < count; k++) {
        const bool last = k + 1 == count || list[k + 1].start;
        if (list[k].start) {
            starts++;
            first = k;
            CHECK(!last);
            continue;
        }
        const long double u0 = exact_unit(list[k - 1].u), v0 = exact_unit(list[k - 1].v);
        const long double u1 = exact_unit(list[k].u), v1 = exact_unit(list[k].v);
        cornered t[3];
        triangle_of(x, (u0 + u1) / 2, (v0 + v1) / 2, t);
        if (hypotl(u1 - u0, v1 - v0) > 16 * less)       /* shorter ones may fall into a neighbour */
            for (int i = 0; i < 3; i++) {
                const long double left = (u1 - u0) * (t[i].v - v0) - (v1 - v0) * (t[i].u - u0);
                CHECK(t[i].high ? left > -less : left < less);
            }
        if (last)
            CHECK((same(&list[k].p, &list[first].p) && list[k].u == list[first].u &&
                   list[k].v == list[first].v) ||
                  (on_border(x, &list[k]) && on_border(x, &list[first])));
    }
    CHECK(count - starts == crossed(x));
}

/* A sphere about the origin: every height has one closed curve, once around, whose points have the
 * same distance from the axis. */
static void a_sphere_has_rings(arb *a)
{
    const loft_sphere s = { { { 0 } }, LOFT_REAL(50) };
    const loft_real height = LOFT_REAL(arb_below(a, 90) - 45.0 + 0.3);
    const long double z = exact_of(height), radius = sqrtl(2500 - z * z), tol = 0.01L;
    const unsigned rows = 5 + arb_below(a, MOST - 4), columns = 3 + arb_below(a, MOST - 2);
    long double around = 0;
    loft_contour c;

    if (LOFT_AXES < 3)
        return;
    CHECK(loft_contour_init(&c, loft_surface_from_sphere(&s), 2, height, LOFT_REAL(0.01), rows,
                            columns, memory, sizeof memory) == LOFT_OK);
    const unsigned count = gather(&c);
    CHECK(count >= 2 * columns + 1 && list[0].start);
    CHECK(same(&list[0].p, &list[count - 1].p));
    for (unsigned k = 0; k < count; k++) {
        const long double p[2] = { exact_of(list[k].p.axis[0]), exact_of(list[k].p.axis[1]) };
        CHECK(k == 0 || !list[k].start);
        CHECK(fabsl(hypotl(p[0], p[1]) - radius) <= tol * fabsl(z) / radius * 1.2L + 1e-3L);
        if (k > 0) {
            const long double q[2] = { exact_of(list[k - 1].p.axis[0]),
                                       exact_of(list[k - 1].p.axis[1]) };
            around += atan2l(q[0] * p[1] - q[1] * p[0], q[0] * p[0] + q[1] * p[1]);
        }
    }
    CHECK(fabsl(around - 2 * acosl(-1)) < 1e-3L || fabsl(around + 2 * acosl(-1)) < 1e-3L);
}

/* A plane patch: one straight line, whose ends are where the border has the height. */
static void a_plane_has_a_line(arb *a)
{
    loft_vec p[4];
    loft_tensor s;
    loft_contour c;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = LOFT_REAL(10.0 * (i == 0   ? k / 2
                                             : i == 1 ? k % 2
                                                      : k / 2 + 2 * (k % 2)));
    CHECK(loft_tensor_init(&s, p, 1, 1) == LOFT_OK);
    const unsigned rows = 1 + arb_below(a, MOST), columns = 1 + arb_below(a, MOST);
    const long double level = 1 + arb_below(a, 8);      /* x + 2 y = level, 0 < x < 10 */
    if (LOFT_AXES < 3)
        return;
    CHECK(loft_contour_init(&c, loft_surface_from_tensor(&s), 2, LOFT_REAL(level), 0, rows, columns,
                            memory, sizeof memory) == LOFT_OK);
    const unsigned count = gather(&c);
    for (unsigned k = 0; k < count; k++) {
        CHECK(list[k].start == (k == 0));
        CHECK(fabsl(exact_of(list[k].p.axis[0]) + 2 * exact_of(list[k].p.axis[1]) - level) < 1e-4L);
    }
    const long double x0 = exact_of(list[0].p.axis[0]), x1 = exact_of(list[count - 1].p.axis[0]);
    CHECK(fabsl(fminl(x0, x1)) < 1e-4L && fabsl(fmaxl(x0, x1) - level) < 1e-4L);
}

/* Sections by planes at any angle: the exact distance of each point is the wanted one. */
static void sections_lie_in_their_plane(arb *a)
{
    const scene *x = arb_scene(a);
    const long double step = BY_NUM(0x1p-24L, 0x1p-24L, 0x1p-53L),
                      eval = BY_NUM(0x1p-15L, 8 * 0x1p-17L, 0x1p-43L);
    loft_vec direction = { { 0 } };
    loft_level level;
    loft_contour c;
    long double length = 0;

    for (int i = 0; i < 3 && i < LOFT_AXES; i++) {
        direction.axis[i] = arb_real(a, 100);
        length += powl(exact_of(direction.axis[i]), 2);
    }
    if (length == 0) {
        CHECK(loft_level_plane(&level, direction, 0) == LOFT_ERR_ARG);
        return;
    }
    CHECK(loft_level_plane(&level, direction, x->height) == LOFT_OK);
    CHECK(loft_contour_init_level(&c, x->sheet, &level, x->tol, x->rows, x->columns, memory,
                                  sizeof memory) == LOFT_OK);
    const unsigned count = gather(&c);
    for (unsigned k = 0; k < count; k++) {
        long double along = 0;
        for (int i = 0; i < 3 && i < LOFT_AXES; i++)
            along += exact_of(list[k].p.axis[i]) * exact_of(direction.axis[i]);
        CHECK(fabsl(along / sqrtl(length) - exact_of(x->height)) <=
              exact_of(x->tol) + 2 * step * STEEPNESS + eval);
    }
}

/* The number itself, at any place: that of the point, and the point is that of the surface. */
static void a_level_is_the_distance_of_its_point(arb *a)
{
    const scene *x = arb_scene(a);
    const loft_unit u = arb_unit(a), v = (loft_unit)(LOFT_UNIT(1) - u) / 2;
    const loft_vec want = point_at(&x->sheet, u, v);
    const unsigned axis = arb_below(a, LOFT_AXES);
    loft_vec direction = { { 0 } }, at;
    long double along = 0, length = 0, most = 0;
    loft_level level;
    loft_acc off;

    for (int i = 0; i < 3 && i < LOFT_AXES; i++) {
        direction.axis[i] = arb_real(a, 100);
        length += powl(exact_of(direction.axis[i]), 2);
        along  += exact_of(direction.axis[i]) * exact_of(want.axis[i]);
        most    = fmaxl(most, fabsl(exact_of(want.axis[i])));
    }
    CHECK(loft_level_axis(&level, axis, x->height) == LOFT_OK &&
          loft_level_at(&level, &x->sheet, u, v, &at, &off) == LOFT_OK && same(&at, &want));
    CHECK_EXACT(exact_acc(off), exact_of(want.axis[axis]) - exact_of(x->height),
                BY_NUM(0, 0x1p-50L, 0x1p-50L) * (most + 1));
    if (length == 0)
        return;
    CHECK(loft_level_plane(&level, direction, x->height) == LOFT_OK &&
          loft_level_at(&level, &x->sheet, u, v, &at, &off) == LOFT_OK && same(&at, &want));
    CHECK_EXACT(exact_acc(off), along / sqrtl(length) - exact_of(x->height),
                BY_NUM(0x1p-32L, 0, 0) + 0x1p-48L * (most + fabsl(exact_of(x->height))));
}

/* z = (x^2 + y^2) / 8 over -8..8: its normal is (-x, -y, 4) / sqrt(x^2 + y^2 + 16). Its silhouette
 * in a direction (a, b, 0) is the line a x + b y = 0; isophotes from above are circles. */
static void a_bowl_has_its_silhouettes_and_isophotes(arb *a)
{
    loft_vec p[9], from = { { 0 } };
    loft_tensor s;
    loft_level level;
    loft_contour c;

    if (LOFT_AXES < 3)
        return;
    for (int k = 0; k < 9; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = loft_real_from_int(i == 0   ? 8 * (k / 3 - 1)
                                              : i == 1 ? 8 * (k % 3 - 1)
                                              : i == 2
                                                  ? (k / 3 == 1 ? -8 : 8) + (k % 3 == 1 ? -8 : 8)
                                                  : 0);
    CHECK(loft_tensor_init(&s, p, 2, 2) == LOFT_OK);
    const long double b[2] = { 1 + arb_below(a, 5), (long double)arb_below(a, 7) - 3 };
    for (int i = 0; i < 2; i++)
        from.axis[i] = LOFT_REAL(b[i]);
    CHECK(loft_level_light(&level, from, 0) == LOFT_OK);
    CHECK(loft_contour_init_level(&c, loft_surface_from_tensor(&s), &level, 0, 13, 17, memory,
                                  sizeof memory) == LOFT_OK);
    unsigned count = gather(&c);
    CHECK(count > 5);
    for (unsigned k = 0; k < count; k++) {
        CHECK(list[k].start == (k == 0));
        CHECK_NEAR(b[0] * exact_of(list[k].p.axis[0]) + b[1] * exact_of(list[k].p.axis[1]), 0,
                   BY_NUM(1e-3L, 1e-3L, 1e-9L));
    }
    from.axis[0] = from.axis[1] = 0;
    from.axis[2] = LOFT_REAL(3);
    const long double cosine = BY_NUM(49152, 0.75, 0.75) / BY_NUM(65536.0L, 1.0L, 1.0L);
    CHECK(loft_level_light(&level, from, LOFT_REAL(0.75)) == LOFT_OK);
    CHECK(loft_contour_init_level(&c, loft_surface_from_tensor(&s), &level, 0, 16, 16, memory,
                                  sizeof memory) == LOFT_OK);
    count = gather(&c);
    CHECK(count > 20 && same(&list[0].p, &list[count - 1].p));
    for (unsigned k = 0; k < count; k++)
        CHECK_NEAR(powl(exact_of(list[k].p.axis[0]), 2) + powl(exact_of(list[k].p.axis[1]), 2),
                   16 / (cosine * cosine) - 16, BY_NUM(1e-2L, 1e-2L, 1e-8L));
    CHECK(loft_level_light(&level, from, LOFT_REAL(1.5)) == LOFT_ERR_ARG);
    CHECK(loft_level_axis(&level, LOFT_AXES, 0) == LOFT_ERR_ARG);
}

static void what_is_wrong_is_refused(arb *a)
{
    const scene *x = arb_scene(a);
    const loft_sphere s = { { { 0 } }, LOFT_REAL(5) };
    loft_contour c;

    CHECK(loft_contour_init(&c, x->sheet, x->axis, x->height, x->tol, x->rows, x->columns, memory,
                            LOFT_CONTOUR_BYTES(x->rows, x->columns) - 1) == LOFT_ERR_SPACE);
    CHECK(loft_contour_init(&c, x->sheet, LOFT_AXES, x->height, x->tol, x->rows, x->columns, memory,
                            sizeof memory) == LOFT_ERR_ARG);
    CHECK(loft_contour_init(&c, x->sheet, 0, x->height, -1, x->rows, x->columns, memory,
                            sizeof memory) == LOFT_ERR_ARG);
    CHECK(loft_contour_init(&c, x->sheet, 0, x->height, x->tol, 0, x->columns, memory,
                            sizeof memory) == LOFT_ERR_ARG);
    CHECK(loft_contour_init(&c, x->sheet, 0, x->height, x->tol, x->rows, LOFT_CONTOUR_MAX + 1,
                            memory, sizeof memory) == LOFT_ERR_ARG);
    CHECK(loft_contour_init(&c, loft_surface_from_triangle(&x->triangle), 0, x->height, x->tol, 3,
                            4, memory, sizeof memory) == LOFT_ERR_ARG);
    CHECK(loft_contour_init(&c, loft_surface_from_sphere(&s), 0, x->height, x->tol, 3, 2, memory,
                            sizeof memory) == LOFT_ERR_ARG);
}

/* Lines in the parameter domain: n + 1 points of the surface at equal steps. Along an edge they are
 * those of the edge. */
static void traces_are_lines_of_the_parameters(arb *a)
{
    const scene *x = arb_scene(a);
    const unsigned n = 1 + arb_below(a, 200);
    loft_bezier edge;
    loft_trace w;
    loft_vec p;

    const loft_unit v = arb_unit(a);
    const loft_surface s = loft_surface_from_tensor(&x->tensor);
    CHECK(loft_trace_init(&w, s, 0, v, LOFT_UNIT(1), v, n) == LOFT_OK);
    for (unsigned k = 0; k <= n; k++) {
        CHECK(loft_trace_next(&w, &p));
        const loft_vec exact = point_at(&s, loft_unit_of(k, n), v);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(fabsl(exact_of(p.axis[i]) - exact_of(exact.axis[i])) <=
                  BY_NUM(0, 0x1p-16L, 0x1p-42L));
    }
    CHECK(!loft_trace_next(&w, &p));
    CHECK(loft_bezier_init(&edge, x->p, x->tensor.n) == LOFT_OK);
    CHECK(loft_trace_init(&w, s, 0, 0, 0, LOFT_UNIT(1), n) == LOFT_OK);
    for (unsigned k = 0; k <= n; k++) {
        CHECK(loft_trace_next(&w, &p));
        const loft_vec on = loft_bezier_eval(&edge, loft_unit_of(k, n));
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(fabsl(exact_of(p.axis[i]) - exact_of(on.axis[i])) <=
                  BY_NUM(0x1p-16L, 0x1p-16L, 0x1p-42L));
    }
    CHECK(loft_trace_init(&w, s, 0, 0, 0, LOFT_UNIT(1), 0) == LOFT_ERR_ARG);
    CHECK(loft_trace_init(&w, s, 0, 0, 0, LOFT_UNIT(1.5), 3) == LOFT_ERR_ARG);
    CHECK(loft_trace_init(&w, loft_surface_from_triangle(&x->triangle), LOFT_UNIT(0.6),
                          LOFT_UNIT(0.6), 0, 0, 3) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(points_have_the_height_and_lie_on_the_surface, 150);
    PROPERTY(curves_are_complete, 300);
    PROPERTY(a_sphere_has_rings, 60);
    PROPERTY(a_plane_has_a_line, 60);
    PROPERTY(sections_lie_in_their_plane, 100);
    PROPERTY(a_level_is_the_distance_of_its_point, 300);
    PROPERTY(a_bowl_has_its_silhouettes_and_isophotes, 20);
    PROPERTY(what_is_wrong_is_refused, 20);
    PROPERTY(traces_are_lines_of_the_parameters, 60);
    return check_failures();
}
