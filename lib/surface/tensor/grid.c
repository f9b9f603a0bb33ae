/* lib/surface/tensor/grid.c -- the arithmetic of one axis: num/walk2.c, along a row num/walk.c
 * SPDX-License-Identifier: MIT
 */
#include "surface/tensor/grid.h"

/* The indices of the first and the last control point of row k in the net. */
static size_t first_in_row(const loft_walk2 *s, unsigned k)
{
    return s->triangle ? k * (k + 1u) / 2 : k * (s->q + 1u);
}

static size_t last_in_row(const loft_walk2 *s, unsigned k)
{
    return first_in_row(s, k) + (s->triangle ? k : s->q);
}

static bool net_valid(const loft_vec net[], size_t points)
{
    for (size_t k = 0; k < points; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_walk2_valid(net[k].axis[i]))
                return false;
    return true;
}

/* The edges along which rows begin and end. The former replaces column 0, which differs from it
 * only by rounding. */
static void start_edges(loft_grid *g, const loft_vec net[], int axis, const loft_powers *powers)
{
    loft_state *column = g->memory + (size_t)axis * g->states;
    const unsigned p = g->shape.p;
    loft_real line[LOFT_WALK_DEGREE_MAX + 1];
    loft_walk begin;

    for (unsigned k = 0; k <= p; k++)
        line[k] = net[first_in_row(&g->shape, k)].axis[axis];
    loft_walk_init(&begin, line, p, powers);
    for (unsigned k = 0; k <= p; k++)
        column[k] = begin.d[k];
    for (unsigned k = 0; k <= p; k++)
        line[k] = net[last_in_row(&g->shape, k)].axis[axis];
    loft_walk_init(&g->edge[axis], line, p, powers);
    g->end[axis] = line[0];
}

/* The first row and the last row walk along the curve of their control points. */
static void start_row(loft_grid *g, const loft_vec control[], unsigned degree)
{
    loft_powers powers;

    loft_powers_init(&powers, degree, g->shape.columns);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_real line[LOFT_WALK_DEGREE_MAX + 1];
        for (unsigned l = 0; l <= degree; l++)
            line[l] = control[l].axis[i];
        loft_walk_init(&g->row[i], line, degree, &powers);
    }
}

static enum loft_status start_grid(loft_grid *g, const loft_vec net[], const loft_walk2 *shape,
                                   loft_state memory[], size_t count)
{
    const size_t states = loft_walk2_column(shape, shape->q) + loft_walk2_degree(shape, shape->q) +
                          1;
    const size_t points = last_in_row(shape, shape->p) + 1;
    loft_powers powers;

    if (!loft_walk2_steps_valid(shape) || !net_valid(net, points))
        return LOFT_ERR_RANGE;
    if (count < states * LOFT_AXES)
        return LOFT_ERR_SPACE;
    g->shape  = *shape;
    g->memory = memory;
    g->states = states;
    g->last   = net + first_in_row(shape, shape->p);
    loft_powers_init(&powers, shape->p, shape->rows);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_walk2_init(memory + (size_t)i * states, shape, &net[0].axis[i], LOFT_AXES);
        start_edges(g, net, i, &powers);
    }
    start_row(g, net, shape->triangle ? 0 : shape->q);
    g->at   = 0;
    g->left = shape->triangle ? 1 : shape->columns + 1;
    return LOFT_OK;
}

enum loft_status loft_grid_init(loft_grid *g, const loft_tensor *s, uint32_t rows, uint32_t columns,
                                loft_state memory[], size_t count)
{
    const loft_walk2 shape = { rows, columns, s->m, s->n, false, false };

    if (s->m > LOFT_WALK_DEGREE_MAX || s->n > LOFT_WALK_DEGREE_MAX || rows == 0 || columns == 0)
        return LOFT_ERR_ARG;
    return start_grid(g, s->p, &shape, memory, count);
}

enum loft_status loft_grid_triangle_init(loft_grid *g, const loft_triangle *t, uint32_t rows,
                                         loft_state memory[], size_t count)
{
    const loft_walk2 shape = { rows, rows, t->degree, t->degree, true, false };

    if (t->degree > LOFT_WALK_DEGREE_MAX || rows == 0)
        return LOFT_ERR_ARG;
    return start_grid(g, t->p, &shape, memory, count);
}

/* The net as a tensor. Its edges are those of `c`; its inside shows whether all points fit. */
enum loft_status loft_grid_coons_init(loft_grid *g, const loft_coons_bezier *c, uint32_t rows,
                                      uint32_t columns, loft_state memory[], size_t count)
{
    const loft_bezier *last = &c->v[0][1];
    const loft_walk2 shape = { rows, columns, c->u[0][0].degree, last->degree, false, true };
    loft_vec net[(LOFT_WALK_DEGREE_MAX + 1) * (LOFT_WALK_DEGREE_MAX + 1)];

    if (shape.p > LOFT_WALK_DEGREE_MAX || shape.q > LOFT_WALK_DEGREE_MAX || rows == 0 ||
        columns == 0)
        return LOFT_ERR_ARG;
    if (c->u[0][1].degree != shape.p || c->v[0][0].degree != shape.q)
        return LOFT_ERR_ARG;
    enum loft_status status = loft_tensor_from_coons(c, net);
    for (unsigned l = 0; l <= shape.q && status == LOFT_OK; l++)
        if (!loft_vec_equal(net[first_in_row(&shape, shape.p) + l], last->p[l]))
            status = LOFT_ERR_ARG;
    if (status == LOFT_OK)
        status = start_grid(g, net, &shape, memory, count);
    if (status == LOFT_OK)
        g->last = last->p;
    return status;
}

static void next_row(loft_grid *g)
{
    const unsigned p = g->shape.p, q = g->shape.q;

    g->at++;
    g->left = g->shape.triangle ? g->at + 1 : g->shape.columns + 1;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_state *d = g->memory + (size_t)i * g->states;
        loft_walk2_step(d, &g->shape);
        for (unsigned l = 0; l <= q; l++)
            g->row[i].d[l] = d[loft_walk2_column(&g->shape, l)];
        g->end[i] = loft_walk_step(&g->edge[i], p);
        if (g->at == g->shape.rows)
            g->end[i] = loft_walk_end(&g->edge[i], g->end[i]);
    }
    if (g->at == g->shape.rows)
        start_row(g, g->last, q);
}

/* At the start of a row the first point is d[0] of each walk. */
static bool at_row_begin(const loft_grid *g)
{
    return g->left == (g->shape.triangle ? g->at + 1 : g->shape.columns + 1);
}

bool loft_grid_next(loft_grid *g, loft_vec *out)
{
    if (g->left == 0) {
        if (g->at == g->shape.rows)
            return false;
        next_row(g);
    }
    const bool first = at_row_begin(g);
    g->left--;
    for (int i = 0; i < LOFT_AXES; i++) {
        out->axis[i] = first ? loft_state_real(g->row[i].d)
                             : loft_walk_step(&g->row[i], g->shape.q);
        if (g->left == 0)
            out->axis[i] = g->end[i];
    }
    return true;
}

uint32_t loft_grid_run(loft_grid *g, loft_vec out[], uint32_t count)
{
    uint32_t given = 0;

    if (count == 0)
        return 0;
    if (g->left == 0 || at_row_begin(g)) {
        if (!loft_grid_next(g, &out[0]))
            return 0;
        given = 1;
    }
    if (count - given > g->left)
        count = given + g->left;
    if (count == given)
        return count;
    g->left -= count - given;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_walk_run(&g->row[i], g->shape.q, &out[given].axis[i], LOFT_AXES, count - given);
        if (g->left == 0)
            out[count - 1].axis[i] = g->end[i];
    }
    return count;
}
