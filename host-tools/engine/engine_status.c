/* host-tools/engine/engine_status.c -- explains a status of the library to a user
 * SPDX-License-Identifier: MIT
 */
#include "num/status.h"     /* enum loft_status */

#include "engine/curve.h"
#include "engine/engine.h"

const char *engine_status(int status, const char *wrong)
{
    switch (status) {
    case LOFT_OK:        return "all is well";
    case LOFT_SINGULAR:  return "two points in one, or parameters alike: take one of them away";
    case LOFT_MORE:      return "not finished: give more input";
    case LOFT_ERR_ARG:
        return wrong ? wrong : "the library refuses an argument: please report this input";
    case LOFT_ERR_RANGE:
        return "the numbers do not fit: make the part smaller, take fewer steps, or take --num f64";
    case LOFT_ERR_SPACE: return "the space is too small: give a smaller drawing";
    case LOFT_ERR_DATA:  return "the other side sent nonsense: look at cable and baud rate";
    default:             return "unknown status";
    }
}

const char *curve_status(const curve *c, int status)
{
    const char *remedy = curve_kinds[c->kind].remedy;

    return engine_status(status,
                         remedy ? remedy : "give points of degree 1 to 9 and at least one step");
}
