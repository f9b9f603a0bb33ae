/* host-tools/arrange/without_region.c -- refuses areas in a program without GEOS
 * SPDX-License-Identifier: MIT
 */
#include "base/host.h"
#include "arrange/region.h"

static region *refused(host *h)
{
    (void)host_error(h, EX_UNAVAILABLE, "region.no-geos", (host_place){ NULL, 0 },
                     "build it with libgeos-dev, or give --fill hatch",
                     "--fill contour, --stroke outline and fills of clipped shapes: this loft was "
                     "built without geos");
    return NULL;
}

int region_error(void) { return EX_UNAVAILABLE; }

region *region_inside(host *h, const drawing *d, size_t first, size_t last, bool evenodd,
                      const char *file)
{
    (void)d, (void)first, (void)last, (void)evenodd, (void)file;
    return refused(h);
}

region *region_of_stroke(host *h, const drawing *d, size_t first, size_t last,
                         const region_stroke *s, const char *file)
{
    (void)d, (void)first, (void)last, (void)s, (void)file;
    return refused(h);
}

bool region_cut(host *h, region *r, const drawing *outline, const char *file)
{
    (void)h, (void)r, (void)outline, (void)file;
    return false;
}

bool region_shrink(host *h, region *r, double by, const char *file)
{
    (void)h, (void)r, (void)by, (void)file;
    return false;
}

void region_outlines(const region *r, region_rings *out)
{
    (void)r;
    *out = (region_rings){ .count = 0 };
}

void region_rings_free(region_rings *rings) { (void)rings; }

void region_free(region *r) { (void)r; }
