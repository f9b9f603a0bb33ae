/* host-tools/engine/engine_fit.h -- least squares through the library; part of engine.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_FIT_H
#define LOFT_HOST_ENGINE_FIT_H

#include "engine/engine_num.h"      /* ENGINE_OF */

int ENGINE_OF(engine_fit_spline)(const engine_fit *f, double out[][ENGINE_AXES]);
int ENGINE_OF(engine_fit_surface)(const engine_grid_fit *f, double out[][ENGINE_AXES], double *off);
int ENGINE_OF(engine_fit_basis)(const engine_net_fit *f, int axis, engine_basis out[]);
int ENGINE_OF(engine_fit_places)(const engine_net_fit *f, const double net[][ENGINE_AXES],
                                 double out[][ENGINE_AXES]);

#endif
