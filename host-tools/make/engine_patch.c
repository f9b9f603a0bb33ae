/* host-tools/make/engine_patch.c -- patches raised, split, continued; how they join; compiled once
 * per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "surface/tensor/tensor_join.h"         /* loft_tensor_join */
#include "surface/triangle/triangle_join.h"     /* loft_triangle_join_order */
#include "surface/triangle/triangle_pieces.h"   /* loft_triangle_split */

#include "engine/engine_solid.h"                /* engine_solid_open */
#include "engine/surface.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"                /* write_tensor */

#define HIGH (LOFT_BEZIER_ELEVATE_MAX + 1)

typedef struct {
    loft_vec net[MOST * MOST];
    loft_tensor s;
    loft_triangle t;
    bool triangle;
    unsigned m, n;
} sheet;

static int sheet_of(const decide_input *in, size_t k, sheet *out)
{
    const surface *s = &in->surfaces->surface[k];

    if (s->rational || (s->kind != SURFACE_TENSOR && s->kind != SURFACE_TRIANGLE)) {
        snprintf(in->why, DECIDE_WHY,
                 "surface %zu is none: give tensor patches and triangles "
                 "without weights",
                 k);
        return LOFT_ERR_ARG;
    }
    out->triangle = s->kind == SURFACE_TRIANGLE;
    out->m        = s->m;
    out->n        = s->n;
    for (unsigned i = 0; i < s->count; i++)
        if (!vec_of(s->point[i].p, &out->net[i]))
            return LOFT_ERR_RANGE;
    return out->triangle ? loft_triangle_init(&out->t, out->net, s->m)
                         : loft_tensor_init(&out->s, out->net, s->m, s->n);
}

static void write_triangle(const decide_input *in, unsigned degree, const loft_vec net[])
{
    printf("triangle %u\n", degree);
    write_solid(in, net, LOFT_TRIANGLE_POINTS(degree));
}

typedef int sheet_visit(const decide_input *in, const sheet *s, size_t number);

/* Tetrahedra come here as such when they are raised alone. */
static bool is_weighted(const surface *s)
{
    return s->kind == SURFACE_OCTANT || s->kind == SURFACE_TETRA ||
           (s->rational && (s->kind == SURFACE_TENSOR || s->kind == SURFACE_TRIANGLE));
}

static int visit_sheets(const decide_input *in, sheet_visit *visit,
                        int (*weighted)(const decide_input *in, size_t number))
{
    static sheet held;
    int status = LOFT_OK;

    for (size_t k = 0; k < in->surfaces->count && status == LOFT_OK; k++) {
        if (weighted && is_weighted(&in->surfaces->surface[k])) {
            status = weighted(in, k);
            continue;
        }
        status = sheet_of(in, k, &held);
        if (status == LOFT_OK)
            status = visit(in, &held, k);
    }
    return status;
}

/* Along u first. That degree may be above those of a patch: the rows are then taken in bands. */
static int raise_sheet(const decide_input *in, const sheet *s, size_t number)
{
    static loft_vec one[HIGH * MOST], both[HIGH * HIGH];
    unsigned by;

    if (!raise_by(in, "surface", number, s->triangle || s->m > s->n ? s->m : s->n, false, &by))
        return LOFT_ERR_ARG;
    if (s->triangle) {
        const int status = loft_triangle_elevate(&s->t, by, both);
        if (status == LOFT_OK)
            write_triangle(in, s->m + by, both);
        return status;
    }
    int status = loft_tensor_elevate_u(&s->s, by, one);
    for (unsigned i = 0; i <= s->m + by && status == LOFT_OK; i += MOST) {
        const unsigned left = s->m + by - i;
        loft_tensor band;
        status = loft_tensor_init(&band, one + i * (s->n + 1), left < MOST ? left : MOST - 1, s->n);
        if (status == LOFT_OK)
            status = loft_tensor_elevate_v(&band, by, both + i * (s->n + by + 1));
    }
    if (status == LOFT_OK)
        write_tensor(in, s->m + by, s->n + by, both);
    return status;
}

/* Four parts of a tensor patch: u below, v below and above; u above. */
static int split_tensor(const decide_input *in, const sheet *s, loft_unit u, loft_unit v)
{
    static loft_vec half[2][MOST * MOST], part[2][MOST * MOST];
    int status = loft_tensor_split_u(&s->s, u, half[0], half[1]);

    for (unsigned i = 0; i < 2 && status == LOFT_OK; i++) {
        loft_tensor h;
        status = loft_tensor_init(&h, half[i], s->m, s->n);
        if (status == LOFT_OK)
            status = loft_tensor_split_v(&h, v, part[0], part[1]);
        for (unsigned j = 0; j < 2 && status == LOFT_OK; j++)
            write_tensor(in, s->m, s->n, part[j]);
    }
    return status;
}

static int split_sheet(const decide_input *in, const sheet *s, size_t number)
{
    static loft_vec part[3][LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    const double *x = in->of->value;

    (void)number;
    if (in->of->count != 2 || !(x[0] > 0 && x[0] < 1 && x[1] > 0 && x[1] < 1) ||
        (s->triangle && !(x[0] + x[1] < 1)))
        return LOFT_ERR_ARG;
    const loft_unit u = (loft_unit)(x[0] * (double)LOFT_UNIT(1)),
                    v = (loft_unit)(x[1] * (double)LOFT_UNIT(1));
    if (!s->triangle)
        return split_tensor(in, s, u, v);
    const loft_bary at = { u, v };
    int status = loft_triangle_split(&s->t, at, part[0], part[1], part[2]);
    for (unsigned k = 0; k < 3 && status == LOFT_OK; k++)
        write_triangle(in, s->m, part[k]);
    return status;
}

static int quarter_sheet(const decide_input *in, const sheet *s, size_t number)
{
    static loft_vec part[LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    int status = LOFT_OK;

    (void)number;
    if (!s->triangle)
        return split_tensor(in, s, LOFT_UNIT(0.5), LOFT_UNIT(0.5));
    for (unsigned k = 0; k < 4 && status == LOFT_OK; k++) {
        status = loft_triangle_quarter(&s->t, k, part);
        if (status == LOFT_OK)
            write_triangle(in, s->m, part);
    }
    return status;
}

/* The corner beyond the edge T2 T3, by its shares of T2 and T3. */
static int star_of(const decide_input *in, loft_bary *out)
{
    const double *x = in->of->value;

    if (in->of->count != 2 || !(fabs(x[0]) <= 2 && fabs(x[1]) <= 2))
        return LOFT_ERR_ARG;
    out->v = (loft_unit)(x[0] * (double)LOFT_UNIT(1));
    out->w = (loft_unit)(x[1] * (double)LOFT_UNIT(1));
    return LOFT_OK;
}

static int continue_sheet(const decide_input *in, const sheet *s, size_t number)
{
    static loft_vec rows[LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)],
        net[LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    loft_bary star;
    int status = s->triangle ? star_of(in, &star) : LOFT_ERR_ARG;
    const loft_vec *from = rows;

    (void)number;
    if (status == LOFT_OK)
        status = loft_triangle_join_continue(&s->t, star, s->m, rows);
    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i <= s->m; i++)            /* row i is row degree - i of a net */
        for (unsigned j = 0; j <= s->m - i; j++)
            net[LOFT_TRIANGLE_POINTS(s->m - i) - (s->m - i + 1u) + j] = *from++;
    write_triangle(in, s->m, net);
    return status;
}

static int raise_solid(const decide_input *in, size_t number)
{
    static loft_vec p[LOFT_TETRA_MAX], out[LOFT_TETRA_MAX];
    const surface *s = &in->surfaces->surface[number];
    unsigned by;
    loft_tetra t;

    if (!times_of(in, LOFT_DEGREE_MAX - s->m, &by)) {
        snprintf(in->why, DECIDE_WHY, "surface %zu, a tetra of degree %u, goes to degree %d",
                 number, s->m, LOFT_DEGREE_MAX);
        return LOFT_ERR_ARG;
    }
    int status = ENGINE_OF(engine_solid_open)(s, p, &t);
    if (status == LOFT_OK)
        status = loft_tetra_elevate(&t, by, out);
    if (status == LOFT_OK) {
        printf("tetra %u\n", s->m + by);
        write_solid(in, out, LOFT_TETRA_POINTS(s->m + by));
    }
    return status;
}

static int raise_with_weights(const decide_input *in, size_t number)
{
    return in->surfaces->surface[number].kind == SURFACE_TETRA
               ? raise_solid(in, number)
               : ENGINE_OF(raise_weighted)(in, number);
}

static int split_with_weights(const decide_input *in, size_t number)
{
    const double *x = in->of->value;

    if (in->of->count != 2 || !(x[0] > 0 && x[0] < 1 && x[1] > 0 && x[1] < 1) ||
        (surface_is_triangle(&in->surfaces->surface[number]) && !(x[0] + x[1] < 1)))
        return LOFT_ERR_ARG;
    return ENGINE_OF(split_weighted)(in, number, (loft_unit)(x[0] * (double)LOFT_UNIT(1)),
                                     (loft_unit)(x[1] * (double)LOFT_UNIT(1)));
}

int ENGINE_OF(make_raise_patch)(const decide_input *in)
{
    return visit_sheets(in, raise_sheet, raise_with_weights);
}

int ENGINE_OF(make_split_patch)(const decide_input *in)
{
    return visit_sheets(in, split_sheet, split_with_weights);
}

int ENGINE_OF(make_quarter)(const decide_input *in)
{
    return visit_sheets(in, quarter_sheet, NULL);
}

int ENGINE_OF(make_continue)(const decide_input *in)
{
    return visit_sheets(in, continue_sheet, NULL);
}

static int join_of(const decide_input *in, const sheet *a, const sheet *b, size_t k)
{
    loft_tensor_join j;
    loft_bary star;
    int order = -1, status;

    if (a->triangle != b->triangle)
        return LOFT_ERR_ARG;
    if (a->triangle) {
        status = star_of(in, &star);
        if (status == LOFT_OK)
            status = loft_triangle_join_order(&a->t, &b->t, star, &order);
        if (status == LOFT_OK)
            printf("%zu %zu derivatives to order %d\n", k, k + 1, order);
        return status;
    }
    status = loft_tensor_join_init(&j, &a->s, &b->s);
    if (status == LOFT_OK)
        printf("%zu %zu C0 %s C1 %s G1 %s\n", k, k + 1, j.c0 ? "yes" : "no", j.c1 ? "yes" : "no",
               j.g1 ? "yes" : "no");
    return status;
}

int ENGINE_OF(answer_join)(const decide_input *in)
{
    static sheet held[2];
    int status = LOFT_OK;

    for (size_t k = 0; k + 1 < in->surfaces->count && status == LOFT_OK; k++) {
        status = sheet_of(in, k, &held[0]);
        if (status == LOFT_OK)
            status = sheet_of(in, k + 1, &held[1]);
        if (status == LOFT_OK)
            status = join_of(in, &held[0], &held[1], k);
    }
    return status;
}
