/* host-tools/engine/engines.c -- finds an engine by name; the resolution of an engine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/tool.h"
#include "engine/engine.h"
#include "engine/piece.h"

const engine *engine_find(const char *name)
{
    static const engine *const all[] = { &engine_q16, &engine_f32, &engine_f64 };

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i]->name, name) == 0)
            return all[i];
    return NULL;
}

bool engine_parse(const char *text, void *out)
{
    const engine *e = engine_find(text);

    if (e != NULL)
        *(const engine **)out = e;
    return e != NULL;
}

/* lib/curve/to_cubics.h: 4 LSB, 2^-21 or 2^-39 of the largest coordinate. */
double engine_finest(const engine *e, const piece *p)
{
    double largest = 0;

    for (unsigned k = 0; k <= p->degree; k++)
        for (int i = 0; i < CURVE_AXES; i++)
            largest = fmax(largest, fabs(p->p[k][i]));
    return e->fixed ? 4 * e->lsb : fmax(4 * e->lsb, 0x1p-39) * largest;
}
