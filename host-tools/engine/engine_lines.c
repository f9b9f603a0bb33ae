/* host-tools/engine/engine_lines.c -- the curves of a ball over a patch, as a machine makes them;
 * compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "toolpath/patches.h"   /* loft_patches_way, loft_lines */

#include "base/tool.h"          /* tool_grow */
#include "engine/engine_num.h"
#include "engine/patch_lines.h"

typedef char engine_lines_degree[LOFT_PATCH_DEGREE == LOFT_LINES_DEGREE ? 1 : -1];

static loft_vec vec_from(const int32_t raw[ENGINE_AXES])
{
    loft_vec v;

    for (int i = 0; i < ENGINE_AXES; i++)
        v.axis[i] = loft_real_from_raw(raw[i]);
    return v;
}

static int give_lines(const lines_patch *p, const loft_tensor *s, const loft_lines_way *way,
                      lines_sink *sink, void *context)
{
    const size_t places  = way->columns + (size_t)1;
    const loft_vec start = vec_from(p->place);
    loft_tip *row        = tool_grow(NULL, places * sizeof *row);
    loft_lines *l        = tool_grow(NULL, sizeof *l);
    const bool begun     = loft_lines_init(l, s, way, &start, row, places) == LOFT_OK;
    loft_cubic c;
    engine_move m;
    bool cuts;

    while (begun && loft_lines_next(l, &c, &cuts)) {
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                m.p[k][i] = double_of(c.p[k].axis[i]);
        m.feed = (cuts ? p->head.feed : p->head.rapid) / 60.0;
        sink(context, &m, cuts);
    }
    free(l);
    free(row);
    return begun ? LOFT_LINES_FINE : LOFT_LINES_COARSE;
}

int ENGINE_OF(engine_lines)(const lines_patch *p, lines_sink *sink, void *context)
{
    const loft_patch_head *h = &p->head;
    const loft_lines_way way = loft_patches_way(h);
    loft_vec net[LINES_POINTS];
    loft_tensor s;
    bool near;

    for (unsigned k = 0; k < LINES_POINTS; k++)
        net[k] = vec_from(p->net[k]);
    if (loft_tensor_init(&s, net, h->m, h->n) != LOFT_OK)
        return LOFT_LINES_COARSE;
    const int fault = (int)loft_lines_check(&s, &way, &near);
    return fault != LOFT_LINES_FINE || !sink ? fault : give_lines(p, &s, &way, sink, context);
}
