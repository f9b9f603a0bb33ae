/* tests/lib/surface/tensor/test_grid.c -- properties of lib/surface/tensor/grid.h and
 * lib/num/walk2.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "curve/forward.h"      /* the walks of the edges */
#include "surface/tensor/grid.h"
#include "support/tensors.h"    /* tensor_fill, tensor_exact */

__extension__ typedef __int128 wide;

#define DEGREE LOFT_WALK_DEGREE_MAX
#define MEMORY LOFT_GRID_STATES(DEGREE, DEGREE)
#define CORNERS ((DEGREE + 1) * (DEGREE + 2) / 2)

static loft_state memory[MEMORY];

/* A patch or a triangle, and its grid. */
typedef struct {
    tensor x;                   /* of the triangle: its net, row by row */
    loft_triangle t;
    bool triangle, exact;       /* exact: the law of ranges says that nothing is rounded */
    unsigned p, q;
    uint32_t rows, columns;
    long double s;              /* the S of the law */
} patch;

static long double choices(unsigned degree, long double n)
{
    long double c = 1, sum = 0;
    for (unsigned k = 1; k <= degree && k <= n; k++)
        sum += c *= (n - k + 1) / k;
    return sum;
}

static unsigned log2_of(uint32_t n)
{
    unsigned m = 0;
    while (n >> m > 1)
        m++;
    return n == (uint32_t)1 << m ? m : 99;
}

static void judge(patch *x)
{
    x->s = x->triangle ? choices(x->p, 2.0L * x->rows)
                       : (1 + choices(x->p, x->rows)) * (1 + choices(x->q, x->columns)) - 1;
    x->exact = (x->triangle ? x->p * log2_of(x->rows)
                            : x->p * log2_of(x->rows) + x->q * log2_of(x->columns)) <= 32;
}

static bool admitted(const patch *x) { return x->exact || x->s <= 4294967296.0L - 4194304; }

static uint32_t arb_steps(arb *a)
{
    return arb_below(a, 2) ? (uint32_t)1 << arb_below(a, 6) : 1 + arb_below(a, 40);
}

/* Control points of one half of the coordinates in the floats; any in q16. */
static patch *arb_patch(arb *a, bool triangle)
{
    static patch x;

    do {
        x.triangle = triangle;
        x.p = arb_below(a, DEGREE + 1);
        x.q = triangle ? x.p : arb_below(a, DEGREE + 1);
        x.rows = arb_steps(a);
        x.columns = triangle ? x.rows : arb_steps(a);
        judge(&x);
    } while (!admitted(&x));
    tensor_fill(&x.x, a, x.p, x.q);         /* more points than a triangle needs */
    if (triangle)
        CHECK(loft_triangle_init(&x.t, x.x.p, x.p) == LOFT_OK);
    return &x;
}

static enum loft_status start(loft_grid *g, const patch *x)
{
    return x->triangle
               ? loft_grid_triangle_init(g, &x->t, x->rows, memory, LOFT_GRID_TRIANGLE_STATES(x->p))
               : loft_grid_init(g, &x->x.s, x->rows, x->columns, memory,
                                LOFT_GRID_STATES(x->p, x->q));
}

static uint32_t points_in(const patch *x, uint32_t row)
{
    return x->triangle ? row + 1 : x->columns + 1;
}

#if LOFT_NUM == LOFT_Q16

/* n times a step of de Casteljau's scheme at i / n, in whole numbers. */
static wide whole_curve(const wide c[], unsigned degree, wide i, wide n)
{
    wide w[DEGREE + 1];
    for (unsigned k = 0; k <= degree; k++)
        w[k] = c[k];
    for (unsigned j = degree; j > 0; j--)
        for (unsigned k = 0; k < j; k++)
            w[k] = (n - i) * w[k] + i * w[k + 1];
    return w[0];
}

static wide power_of(wide n, unsigned k) { return k ? n * power_of(n, k - 1) : 1; }

/* The point times *scale, in LSB. */
static wide whole_at(const patch *x, int axis, uint32_t i, uint32_t j, wide *scale)
{
    wide w[CORNERS + DEGREE * DEGREE];

    if (x->triangle) {
        for (unsigned k = 0; k < (x->p + 1) * (x->p + 2) / 2; k++)
            w[k] = x->x.p[k].axis[axis];
        for (unsigned d = x->p; d > 0; d--)
            for (unsigned r = 0, k = 0; r < d; r++)
                for (unsigned c = 0; c <= r; c++, k++)  /* the triple (r, c), (r + 1, c), (r + 1, c
                                                         * + 1) */
                    w[k] = (wide)(x->rows - i) * w[k] + (wide)(i - j) * w[k + r + 1] +
                           (wide)j * w[k + r + 2];
        *scale = power_of(x->rows, x->p);
        return w[0];
    }
    for (unsigned k = 0; k <= x->p; k++) {
        wide line[DEGREE + 1];
        for (unsigned l = 0; l <= x->q; l++)
            line[l] = x->x.p[k * (x->q + 1) + l].axis[axis];
        w[k] = whole_curve(line, x->q, j, x->columns);
    }
    *scale = power_of(x->rows, x->p) * power_of(x->columns, x->q);
    return whole_curve(w, x->p, i, x->rows);
}

static wide rounded(wide n, wide d)
{
    const wide top = 2 * n + d, bottom = 2 * d;
    return top / bottom - (top % bottom < 0);
}

static void check_point(const patch *x, loft_vec p, uint32_t i, uint32_t j)
{
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        wide scale;
        const wide want = whole_at(x, axis, i, j, &scale);
        if (x->exact)
            CHECK(p.axis[axis] == rounded(want, scale));
        else
            CHECK_EXACT((long double)(p.axis[axis] * scale - want) / (long double)scale, 0,
                        0.5L + x->s * (0x1p-33L + 0x1p-44L) + 1e-12L);
    }
}

#else

static long double triangle_at(const patch *x, int axis, long double i, long double j)
{
    long double w[CORNERS + DEGREE * DEGREE];

    for (unsigned k = 0; k < (x->p + 1) * (x->p + 2) / 2; k++)
        w[k] = exact_of(x->x.p[k].axis[axis]);
    for (unsigned d = x->p; d > 0; d--)
        for (unsigned r = 0, k = 0; r < d; r++)
            for (unsigned c = 0; c <= r; c++, k++)
                w[k] = (1 - i) * w[k] + (i - j) * w[k + r + 1] + j * w[k + r + 2];
    return w[0];
}

static void check_point(const patch *x, loft_vec p, uint32_t i, uint32_t j)
{
    const long double u = (long double)i / x->rows, v = (long double)j / x->columns;
    const long double bound = ((long double)x->p * x->rows + (long double)x->q * x->columns + 8) *
                              powl(2, x->p + x->q) * 0x1p-53L * x->x.largest;

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const long double want = x->triangle ? triangle_at(x, axis, u, v)
                                             : tensor_exact(&x->x.s, axis, 0, 0, u, v);
        CHECK_EXACT(exact_of(p.axis[axis]), want, bound + ulp(want) / 2);
    }
}

#endif

static void check_grid(const patch *x)
{
    loft_grid g;
    loft_vec p;

    CHECK(start(&g, x) == LOFT_OK);
    for (uint32_t i = 0; i <= x->rows; i++)
        for (uint32_t j = 0; j < points_in(x, i); j++) {
            const bool more = loft_grid_next(&g, &p);
            CHECK(more);
            if (!more)
                return;
            check_point(x, p, i, j);
        }
    CHECK(!loft_grid_next(&g, &p));
    CHECK(!loft_grid_next(&g, &p));
}

static void every_point_of_a_patch_is_within_its_bound(arb *a) { check_grid(arb_patch(a, false)); }
static void every_point_of_a_triangle_is_within_its_bound(arb *a)
{
    check_grid(arb_patch(a, true));
}

/* The largest numbers of steps that the law admits, where every possible value wraps; along the
 * edges of the grid. */
static void the_longest_walks_are_within_their_bound(arb *a)
{
    static const uint32_t most[][4] = { { 3, 3, 32, 32 },   { 3, 3, 16, 64 },  { 3, 3, 73, 73 },
                                        { 2, 2, 256, 256 }, { 1, 3, 4, 1024 }, { 5, 5, 8, 8 },
                                        { 5, 5, 11, 11 },   { 4, 4, 16, 16 },  { 3, 3, 1000, 3 } };
    static patch x;
    const uint32_t *c = most[arb_below(a, sizeof most / sizeof *most)];
    loft_grid g;
    loft_vec p;

    x.triangle = false;
    x.p = c[0];
    x.q = c[1];
    x.rows = c[2];
    x.columns = c[3];
    judge(&x);
    CHECK(admitted(&x));
    tensor_fill(&x.x, a, x.p, x.q);
    CHECK(start(&g, &x) == LOFT_OK);
    for (uint32_t i = 0; i <= x.rows; i++)
        for (uint32_t j = 0; j <= x.columns; j++)
            if (loft_grid_next(&g, &p) &&
                (i + 2 > x.rows || j + 2 > x.columns || (i * 7 + j) % 61 == 0))
                check_point(&x, p, i, j);
}

static void a_cubic_triangle_of_1024_rows_is_exact(arb *a)
{
    static patch x;
    loft_grid g;
    loft_vec p;

    x.triangle = true;
    x.p = x.q = 3;
    x.rows = x.columns = 1024;
    judge(&x);
    tensor_fill(&x.x, a, 3, 3);
    CHECK(loft_triangle_init(&x.t, x.x.p, 3) == LOFT_OK);
    CHECK(x.exact && start(&g, &x) == LOFT_OK);
    for (uint32_t i = 0; i <= x.rows; i++)
        for (uint32_t j = 0; j <= i; j++)
            if (loft_grid_next(&g, &p) && (i == 1024 || j == i || (i * 1021 + j) % 499 == 0))
                check_point(&x, p, i, j);
}

/* The edges of a tensor are walked as curves, bit for bit, and every corner is its control
 * point. */
static void edges_are_those_of_walked_curves(arb *a)
{
    const patch *x = arb_patch(a, false);
    loft_vec control[2][DEGREE + 1], across[2][DEGREE + 1], p;
    loft_forward row[2], column[2];
    loft_bezier b;
    loft_grid g;

    for (unsigned side = 0; side < 2; side++) {
        const loft_unit at = side ? LOFT_UNIT(1) : 0;
        loft_tensor_at_u(&x->x.s, at, control[side]);
        loft_tensor_at_v(&x->x.s, at, across[side]);
        CHECK(loft_bezier_init(&b, control[side], x->q) == LOFT_OK &&
              loft_forward_init(&row[side], &b, x->columns) == LOFT_OK);
        CHECK(loft_bezier_init(&b, across[side], x->p) == LOFT_OK &&
              loft_forward_init(&column[side], &b, x->rows) == LOFT_OK);
    }
    CHECK(start(&g, x) == LOFT_OK);
    for (uint32_t i = 0; i <= x->rows; i++)
        for (uint32_t j = 0; j <= x->columns && loft_grid_next(&g, &p); j++)
            for (unsigned side = 0; side < 2; side++) {
                loft_vec want;
                if (i == side * x->rows) {
                    if (j)
                        CHECK(loft_forward_next(&row[side], &want));
                    else
                        want = control[side][0];
                    CHECK(loft_vec_equal(p, want));
                }
                if (j == side * x->columns) {
                    if (i)
                        CHECK(loft_forward_next(&column[side], &want));
                    else
                        want = across[side][0];
                    CHECK(loft_vec_equal(p, want));
                }
            }
}

static void the_grid_is_the_patch_evaluated(arb *a)
{
    const patch *x = arb_patch(a, false);
    loft_grid g;
    loft_vec p;

    if (!x->exact)
        return;
    CHECK(start(&g, x) == LOFT_OK);
    for (uint32_t i = 0; i <= x->rows; i++)
        for (uint32_t j = 0; j <= x->columns && loft_grid_next(&g, &p); j++) {
            const loft_vec want = loft_tensor_eval(&x->x.s, loft_unit_of(i, x->rows),
                                                   loft_unit_of(j, x->columns));
            const long double bound = ((long double)x->p * x->rows +
                                       (long double)x->q * x->columns + 16) *
                                      powl(2, x->p + x->q) * 0x1p-53L * x->x.largest;
            for (int axis = 0; axis < LOFT_AXES; axis++)
                CHECK_EXACT(exact_of(p.axis[axis]), exact_of(want.axis[axis]),
                            BY_NUM(LSB + 0 * bound, bound + ulp(x->x.largest), bound));
        }
}

static void runs_give_the_same_points(arb *a)
{
    const patch *x = arb_patch(a, arb_below(a, 2));
    static loft_state other[MEMORY];
    loft_grid g, h;
    loft_vec p, out[64];
    uint32_t total = 0;

    CHECK(start(&g, x) == LOFT_OK);
    h = g;
    for (unsigned k = 0; k < MEMORY; k++)
        other[k] = memory[k];
    h.memory = other;
    for (;;) {
        const uint32_t want = 1 + arb_below(a, 64), given = loft_grid_run(&h, out, want);
        CHECK(given <= want);
        if (given == 0)
            break;
        for (uint32_t k = 0; k < given; k++, total++)
            CHECK(loft_grid_next(&g, &p) && loft_vec_equal(p, out[k]));
    }
    CHECK(!loft_grid_next(&g, &p) && !loft_grid_next(&h, &p));
    CHECK(total ==
          (x->triangle ? (x->rows + 1) * (x->rows + 2) / 2 : (x->rows + 1) * (x->columns + 1)));
}

/* Four curves with shared corners, within a third of the coordinates so that their blend fits. */
typedef struct {
    loft_vec u[2][DEGREE + 1], v[2][DEGREE + 1];
    loft_coons_bezier c;
    unsigned p, q;
} frame;

static frame *arb_frame(arb *a, unsigned p, unsigned q)
{
    static frame x;
    loft_bezier u[1][2], v[1][2];

    x.p = p;
    x.q = q;
    for (unsigned side = 0; side < 2; side++) {
        for (unsigned k = 0; k <= p; k++)
            x.u[side][k] = arb_vec(a, 10000);
        for (unsigned k = 0; k <= q; k++)
            x.v[side][k] = arb_vec(a, 10000);
    }
    for (unsigned side = 0; side < 2; side++) {
        x.v[side][0] = x.u[0][side ? p : 0];
        x.v[side][q] = x.u[1][side ? p : 0];
        CHECK(loft_bezier_init(&u[0][side], x.u[side], p) == LOFT_OK &&
              loft_bezier_init(&v[0][side], x.v[side], q) == LOFT_OK);
    }
    CHECK(loft_coons_bezier_init(&x.c, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 1,
                                 0) == LOFT_OK);
    return &x;
}

#if LOFT_NUM == LOFT_Q16

static wide edge_at(const loft_vec p[], unsigned degree, int axis, uint32_t i, uint32_t n)
{
    wide c[DEGREE + 1];
    for (unsigned k = 0; k <= degree; k++)
        c[k] = p[k].axis[axis];
    return whole_curve(c, degree, i, n);
}

/* All terms times rows^p columns^q. */
static void check_blend(const frame *x, loft_vec p, uint32_t i, uint32_t j, uint32_t rows,
                        uint32_t columns)
{
    const wide up = power_of(rows, x->p - 1), vp = power_of(columns, x->q - 1), m = rows,
               n = columns;

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const wide ruled_v = ((n - j) * edge_at(x->u[0], x->p, axis, i, rows) +
                              j * edge_at(x->u[1], x->p, axis, i, rows)) *
                             vp;
        const wide ruled_u = ((m - i) * edge_at(x->v[0], x->q, axis, j, columns) +
                              i * edge_at(x->v[1], x->q, axis, j, columns)) *
                             up;
        const wide corners =
            (m - i) * ((n - j) * x->u[0][0].axis[axis] + j * (wide)x->u[1][0].axis[axis]) +
            i * ((n - j) * x->u[0][x->p].axis[axis] + j * (wide)x->u[1][x->p].axis[axis]);
        CHECK(p.axis[axis] == rounded(ruled_v + ruled_u - corners * up * vp, up * vp * m * n));
    }
}

#else

static void check_blend(const frame *x, loft_vec p, uint32_t i, uint32_t j, uint32_t rows,
                        uint32_t columns)
{
    const long double s = (long double)i / rows, t = (long double)j / columns;

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        long double u[2], v[2], c[DEGREE + 1];
        for (unsigned side = 0; side < 2; side++) {
            for (unsigned k = 0; k <= x->p; k++)
                c[k] = exact_of(x->u[side][k].axis[axis]);
            u[side] = exact_eval(c, x->p, s);
            for (unsigned k = 0; k <= x->q; k++)
                c[k] = exact_of(x->v[side][k].axis[axis]);
            v[side] = exact_eval(c, x->q, t);
        }
        const long double corners = (1 - s) * ((1 - t) * exact_of(x->u[0][0].axis[axis]) +
                                               t * exact_of(x->u[1][0].axis[axis])) +
                                    s * ((1 - t) * exact_of(x->u[0][x->p].axis[axis]) +
                                         t * exact_of(x->u[1][x->p].axis[axis]));
        const long double want = (1 - t) * u[0] + t * u[1] + (1 - s) * v[0] + s * v[1] - corners;
        CHECK_EXACT(exact_of(p.axis[axis]), want,
                    ((long double)x->p * rows + (long double)x->q * columns + 8) *
                            powl(2, x->p + x->q) * 0x1p-53L * 30000 +
                        ulp(want) / 2);
    }
}

#endif

static void a_blend_of_four_curves_is_exact(arb *a)
{
    const unsigned p = 1 + arb_below(a, DEGREE), q = 1 + arb_below(a, DEGREE);
    const frame *x = arb_frame(a, p, q);
    uint32_t rows, columns;
    loft_grid g;
    loft_vec v;

    do {
        rows = (uint32_t)1 << arb_below(a, 6);
        columns = (uint32_t)1 << arb_below(a, 6);
    } while (p * log2_of(rows) + log2_of(columns) > 32 ||
             log2_of(rows) + q * log2_of(columns) > 32);
    CHECK(loft_grid_coons_init(&g, &x->c, rows, columns, memory, LOFT_GRID_STATES(p, q)) ==
          LOFT_OK);
    for (uint32_t i = 0; i <= rows; i++)
        for (uint32_t j = 0; j <= columns; j++) {
            CHECK(loft_grid_next(&g, &v));
            check_blend(x, v, i, j, rows, columns);
        }
    CHECK(!loft_grid_next(&g, &v));
}

static void a_blend_of_cubics_is_exact_to_256_by_256(arb *a)
{
    const frame *x = arb_frame(a, 3, 3);
    loft_grid g;
    loft_vec v;

    CHECK(loft_grid_coons_init(&g, &x->c, 256, 256, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK);
    for (uint32_t i = 0; i <= 256; i++)
        for (uint32_t j = 0; j <= 256; j++)
            if (loft_grid_next(&g, &v) && (i > 254 || j > 254 || (i * 31 + j) % 17 == 0))
                check_blend(x, v, i, j, 256, 256);
    CHECK(loft_grid_coons_init(&g, &x->c, 512, 256, memory, LOFT_GRID_STATES(3, 3)) ==
          LOFT_ERR_RANGE);
    CHECK(loft_grid_coons_init(&g, &x->c, 256, 256, memory, LOFT_GRID_STATES(3, 3) - 1) ==
          LOFT_ERR_SPACE);
}

static void what_does_not_fit_is_refused(arb *a)
{
    patch *x = arb_patch(a, false);
    loft_grid g = { .at = 12345 };
    tensor high;

    CHECK(loft_grid_init(&g, &x->x.s, 0, 1, memory, MEMORY) == LOFT_ERR_ARG);
    CHECK(loft_grid_init(&g, &x->x.s, 1, 0, memory, MEMORY) == LOFT_ERR_ARG);
    CHECK(loft_grid_init(&g, &x->x.s, x->rows, x->columns, memory,
                         LOFT_GRID_STATES(x->p, x->q) - 1) == LOFT_ERR_SPACE);
    tensor_fill(&high, a, 6, 1);
    CHECK(loft_grid_init(&g, &high.s, 1, 1, memory, MEMORY) == LOFT_ERR_ARG);
    tensor_fill(&high, a, 3, 3);
    CHECK(loft_grid_init(&g, &high.s, 128, 128, memory, MEMORY) == LOFT_ERR_RANGE);
    CHECK(loft_grid_init(&g, &high.s, 74, 74, memory, MEMORY) == LOFT_ERR_RANGE);
    CHECK(loft_grid_init(&g, &high.s, 1000000, 1, memory, MEMORY) == LOFT_ERR_RANGE);
    CHECK(loft_grid_init(&g, &high.s, 4294967295u, 4294967295u, memory, MEMORY) == LOFT_ERR_RANGE);
    CHECK(g.at == 12345);
#if LOFT_NUM != LOFT_Q16
    high.p[5].axis[0] = LOFT_REAL_MAX;
    CHECK(loft_grid_init(&g, &high.s, 4, 4, memory, MEMORY) == LOFT_ERR_RANGE);
#endif
}

int main(void)
{
    PROPERTY(every_point_of_a_patch_is_within_its_bound, 500);
    PROPERTY(every_point_of_a_triangle_is_within_its_bound, 300);
    PROPERTY(the_longest_walks_are_within_their_bound, 30);
    PROPERTY(a_cubic_triangle_of_1024_rows_is_exact, 2);
    PROPERTY(edges_are_those_of_walked_curves, 300);
    PROPERTY(the_grid_is_the_patch_evaluated, 60);
    PROPERTY(runs_give_the_same_points, 200);
    PROPERTY(a_blend_of_four_curves_is_exact, 200);
    PROPERTY(a_blend_of_cubics_is_exact_to_256_by_256, 4);
    PROPERTY(what_does_not_fit_is_refused, 20);
    return check_failures();
}
