/* host-tools/engines.c -- finding an engine by name, and what a status means
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "num/status.h"     /* enum loft_status */

#include "engine.h"

const engine *engine_find(const char *name)
{
    static const engine *const all[] = { &engine_q16, &engine_f32, &engine_f64 };

    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i]->name, name) == 0)
            return all[i];
    return NULL;
}

const char *engine_status(int status)
{
    switch (status) {
    case LOFT_OK:        return "all is well";
    case LOFT_MORE:      return "not finished: give more input";
    case LOFT_ERR_ARG:   return "a count or a degree is out of bounds: give points of degree 1 to 9 and at least one step";
    case LOFT_ERR_RANGE: return "the numbers do not fit: make the part smaller, take fewer steps, or take --num f64";
    case LOFT_ERR_SPACE: return "the space is too small: give a smaller drawing";
    case LOFT_ERR_DATA:  return "the other side sent nonsense: look at cable and baud rate";
    default:             return "unknown status";
    }
}
