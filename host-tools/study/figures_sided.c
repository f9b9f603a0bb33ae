/* host-tools/study/figures_sided.c -- figures of surfaces
 * SPDX-License-Identifier: MIT
 */
#include "study/figures.h"

const figure figures_sided[] = {
    { .name = NULL },
};

const size_t figures_sideds = 0;
