/* host-tools/engine/engine_sheet.h -- surfaces as the sheets of lib/toolpath; part of
 * engine_surface.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SHEET_H
#define LOFT_HOST_ENGINE_SHEET_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "toolpath/sheet.h"         /* loft_sheet */

/* Make 4^level sheets of a tensor patch, or one of another surface, which is kept open. Returns
 * their number, or a negative enum loft_status: LOFT_ERR_ARG for kinds that have none. */
int ENGINE_OF(engine_sheets)(engine_surface *e, unsigned level, loft_sheet out[]);

#endif
