/* host-tools/arrange/without_region.c -- refuses areas in a program without GEOS
 * SPDX-License-Identifier: MIT
 */
#include "base/tool.h"
#include "arrange/region.h"

static region *refused(void)
{
    (void)tool_error(EX_UNAVAILABLE,
                     "--fill contour, --stroke outline and fills of clipped shapes: this loft was "
                     "built without geos: build it with libgeos-dev, or give --fill hatch");
    return NULL;
}

int region_error(void) { return EX_UNAVAILABLE; }

region *region_inside(const drawing *d, size_t first, size_t last, bool evenodd, const char *file)
{
    (void)d, (void)first, (void)last, (void)evenodd, (void)file;
    return refused();
}

region *region_of_stroke(const drawing *d, size_t first, size_t last, const region_stroke *s,
                         const char *file)
{
    (void)d, (void)first, (void)last, (void)s, (void)file;
    return refused();
}

bool region_cut(region *r, const drawing *outline, const char *file)
{
    (void)r, (void)outline, (void)file;
    return false;
}

bool region_shrink(region *r, double by, const char *file)
{
    (void)r, (void)by, (void)file;
    return false;
}

void region_outlines(const region *r, region_rings *out)
{
    (void)r;
    *out = (region_rings){ .count = 0 };
}

void region_rings_free(region_rings *rings) { (void)rings; }

void region_free(region *r) { (void)r; }
