/* host-tools/engine/engine_sector.c -- patches with n sides as sheets; compiled once per number
 * type
 * SPDX-License-Identifier: MIT
 */
#include "base/tool.h"              /* tool_grow */
#include "engine/engine_sheet.h"

loft_sheet *ENGINE_OF(engine_sheet_add)(engine_sheet_list *l)
{
    if (l->count == l->room) {
        l->room = l->room ? 2 * l->room : 64;
        l->sheet = tool_grow(l->sheet, l->room * sizeof *l->sheet);
    }
    return &l->sheet[l->count++];
}

/* A part that has no bound is divided, and so is one that is too large. */
static int add_part(const loft_sector *c, unsigned level, engine_sheet_list *out)
{
    const bool triangle = loft_surface_from_sector(c).over == LOFT_SURFACE_TRIANGLE;
    loft_sheet_piece stack[3 * LOFT_DROP_LEVELS + 1] = { { 0, 0, 0, false } };
    unsigned count = 1;

    while (count > 0) {
        const loft_sheet_piece p = stack[--count];
        loft_sheet s;
        int status = LOFT_SINGULAR;
        if (p.level >= level)
            status = loft_sheet_from_sector(&s, c, p);
        if (status == LOFT_OK)
            *ENGINE_OF(engine_sheet_add)(out) = s;
        else if (status != LOFT_SINGULAR || p.level == LOFT_DROP_LEVELS)
            return status;
        for (unsigned k = 0; k < 4 && status != LOFT_OK; k++)
            stack[count++] = loft_sheet_piece_quarter(&p, triangle, k);
    }
    return LOFT_OK;
}

int ENGINE_OF(engine_sectors)(const loft_disk *disk, loft_sector sector[], unsigned level,
                              engine_sheet_list *out)
{
    const unsigned count = loft_sector_count(disk);
    int status = count > 0 ? LOFT_OK : LOFT_ERR_ARG;

    for (unsigned k = 0; k < count && status == LOFT_OK; k++) {
        sector[k] = (loft_sector){ disk, (uint8_t)k };
        status = add_part(&sector[k], level, out);
    }
    return status;
}
