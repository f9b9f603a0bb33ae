/* host-tools/engines.c -- finding an engine by name
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "engine.h"

const engine *engine_find(const char *name)
{
    static const engine *const all[] = { &engine_q16, &engine_f32, &engine_f64 };

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i]->name, name) == 0)
            return all[i];
    return NULL;
}
