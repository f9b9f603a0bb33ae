/* host-tools/cmd/measure_surface.h -- part of loft measure: files of surfaces
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_MEASURE_SURFACE_H
#define LOFT_HOST_MEASURE_SURFACE_H

#include <stdbool.h>

#include "base/option.h"        /* option_list */
#include "engine/engine.h"

/* If the file holds surfaces: print their areas, or their points nearest to `at`, unless what was
 * asked for is of `path`s. Returns an exit code; *done: it holds surfaces. */
int measure_surfaces(const char *file, const engine *e, const option_list *at, double tol,
                     bool path, bool *done);

#endif
