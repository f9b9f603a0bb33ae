/* host-tools/figures/figures.c -- the list of figures
 * SPDX-License-Identifier: MIT
 */
#include "figures/figures.h"

const figure *figure_number(size_t i)
{
    const struct {
        const figure *first;
        size_t count;
    } part[] = { { figures_curve, figures_curves },
                 { figures_spline, figures_splines },
                 { figures_surface, figures_surfaces },
                 { figures_sided, figures_sideds },
                 { figures_gb, figures_gbs } };

    for (size_t k = 0; k < sizeof part / sizeof part[0]; i -= part[k++].count)
        if (i < part[k].count)
            return &part[k].first[i];
    return NULL;
}
