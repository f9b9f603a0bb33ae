/* host-tools/study/figures.c -- the list of figures
 * SPDX-License-Identifier: MIT
 */
#include "study/figures.h"

const figure *figure_number(size_t i)
{
    if (i < figures_curves)
        return &figures_curve[i];
    i -= figures_curves;
    if (i < figures_surfaces)
        return &figures_surface[i];
    i -= figures_surfaces;
    return i < figures_sideds ? &figures_sided[i] : NULL;
}
