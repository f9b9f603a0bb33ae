/* host-tools/base/clock.c -- a clock that is never set; apart from tool.c, which tests replace
 * SPDX-License-Identifier: MIT
 */
#include <time.h>

#include "base/tool.h"      /* tool_clock */

double tool_clock(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
