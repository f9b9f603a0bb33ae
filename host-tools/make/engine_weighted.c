/* host-tools/make/engine_weighted.c -- patches with weights raised and split; any surface with
 * nets as tensor patches and triangles; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "surface/tensor/tensor_rational.h"         /* loft_tensor_rational_split_u */
#include "surface/triangle/triangle_rational.h"     /* loft_triangle_rational_split */

#include "engine/engine_sheet.h"                    /* engine_nets */
#include "engine/surface.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"                    /* print_number */

#define HIGH (LOFT_ELEVATE_MAX + 1)

/* One surface of the file, and its number there. */
typedef struct {
    const decide_input *in;
    size_t number;
    loft_unit at[2];
} visit_of;

static void write_weighted(const decide_input *in, bool triangle, unsigned m, unsigned n,
                           const loft_weighted p[])
{
    const unsigned count = triangle ? LOFT_TRIANGLE_POINTS(m) : (m + 1) * (n + 1);

    if (triangle)
        printf("triangle %u\n", m);
    else
        printf("tensor %u %u\n", m, n);
    for (unsigned k = 0; k < count; k++) {
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            print_number(in->e, double_of(p[k].p.axis[axis]));
            putchar(' ');
        }
        fputs(": ", stdout);
        print_number(in->e, double_of(p[k].w));
        putchar('\n');
    }
}

static int visit_nets(visit_of *v, engine_net_visit *visit)
{
    const surface *s = &v->in->surfaces->surface[v->number];
    engine_surface *held;
    int status = ENGINE_OF(engine_surfaces).open(s, &held);

    if (status != LOFT_OK)
        return status;
    status = ENGINE_OF(engine_nets)(held, visit, v);
    ENGINE_OF(engine_surfaces).close(held);
    return status;
}


// Patches
// -------

static int write_net(void *context, loft_net net, const engine_net_part *part)
{
    const visit_of *v = context;
    const unsigned count = net.triangle ? LOFT_TRIANGLE_POINTS(net.m) : (net.m + 1u) * (net.n + 1u);

    (void)part;
    if (net.weighted) {
        write_weighted(v->in, net.triangle, net.m, net.n, net.weighted);
        return LOFT_OK;
    }
    if (!net.triangle)
        write_tensor(v->in, net.m, net.n, net.p);
    else {
        printf("triangle %u\n", (unsigned)net.m);
        write_solid(v->in, net.p, count);
    }
    return LOFT_OK;
}

int ENGINE_OF(make_patches)(const decide_input *in)
{
    visit_of v = { .in = in };
    int status = LOFT_OK;

    for (; v.number < in->surfaces->count && status == LOFT_OK; v.number++) {
        status = visit_nets(&v, write_net);
        if (status == LOFT_ERR_ARG)
            decide_refuse_kind(in, v.number, &in->surfaces->surface[v.number]);
    }
    return status;
}


// With weights
// ------------

/* As raise_sheet of engine_patch.c */
static int raise_square(loft_net net, unsigned by, loft_weighted out[])
{
    static loft_weighted one[HIGH * MOST];
    loft_tensor_rational r;
    int status = loft_tensor_rational_init(&r, net.weighted, net.m, net.n);

    if (status == LOFT_OK)
        status = loft_tensor_rational_elevate_u(&r, by, one);
    for (unsigned i = 0; i <= net.m + by && status == LOFT_OK; i += MOST) {
        const unsigned left = net.m + by - i;
        loft_tensor_rational band;
        status = loft_tensor_rational_init(&band, one + i * (net.n + 1),
                                           left < MOST ? left : MOST - 1, net.n);
        if (status == LOFT_OK)
            status = loft_tensor_rational_elevate_v(&band, by, out + i * (net.n + by + 1));
    }
    return status;
}

static int raise_net(void *context, loft_net net, const engine_net_part *part)
{
    static loft_weighted out[HIGH * HIGH];
    const visit_of *v = context;
    loft_triangle_rational t;
    unsigned by;
    int status;

    (void)part;
    if (!raise_by(v->in, "surface", v->number, net.m > net.n ? net.m : net.n, true, &by))
        return LOFT_ERR_ARG;
    if (net.triangle) {
        status = loft_triangle_rational_init(&t, net.weighted, net.m);
        if (status == LOFT_OK)
            status = loft_triangle_rational_elevate(&t, by, out);
    } else
        status = raise_square(net, by, out);
    if (status == LOFT_OK)
        write_weighted(v->in, net.triangle, net.m + by, net.n + by, out);
    return status;
}

static int split_square(const visit_of *v, loft_net net)
{
    static loft_weighted half[2][MOST * MOST], part[2][MOST * MOST];
    loft_tensor_rational r;
    int status = loft_tensor_rational_init(&r, net.weighted, net.m, net.n);

    if (status == LOFT_OK)
        status = loft_tensor_rational_split_u(&r, v->at[0], half[0], half[1]);
    for (unsigned i = 0; i < 2 && status == LOFT_OK; i++) {
        loft_tensor_rational h;
        status = loft_tensor_rational_init(&h, half[i], net.m, net.n);
        if (status == LOFT_OK)
            status = loft_tensor_rational_split_v(&h, v->at[1], part[0], part[1]);
        for (unsigned j = 0; j < 2 && status == LOFT_OK; j++)
            write_weighted(v->in, false, net.m, net.n, part[j]);
    }
    return status;
}

static int split_net(void *context, loft_net net, const engine_net_part *of)
{
    static loft_weighted part[3][LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    const visit_of *v = context;
    const loft_bary at = { v->at[0], v->at[1] };
    loft_triangle_rational t;

    (void)of;
    if (!net.triangle)
        return split_square(v, net);
    int status = loft_triangle_rational_init(&t, net.weighted, net.m);
    if (status == LOFT_OK)
        status = loft_triangle_rational_split(&t, at, part[0], part[1], part[2]);
    for (unsigned k = 0; k < 3 && status == LOFT_OK; k++)
        write_weighted(v->in, true, net.m, net.n, part[k]);
    return status;
}

int ENGINE_OF(raise_weighted)(const decide_input *in, size_t number)
{
    visit_of v = { .in = in, .number = number };
    return visit_nets(&v, raise_net);
}

int ENGINE_OF(split_weighted)(const decide_input *in, size_t number, loft_unit u, loft_unit w)
{
    visit_of v = { .in = in, .number = number, .at = { u, w } };
    return visit_nets(&v, split_net);
}
