/* host-tools/study/figures_surface.c -- figures of surfaces
 * SPDX-License-Identifier: MIT
 */
#include "study/figures.h"

const figure figures_surface[] = {
    { .name = NULL },
};

const size_t figures_surfaces = 0;
