/* host-tools/make/engine_weave.h -- verbs of `loft make` that take a whole file: networks, grids,
 * neighbours
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_WEAVE_H
#define LOFT_HOST_ENGINE_WEAVE_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "make/decide.h"

/* engine_weave.c: of curves */
int ENGINE_OF(make_sweep)(const decide_input *in);
int ENGINE_OF(make_coons)(const decide_input *in);
int ENGINE_OF(make_gordon)(const decide_input *in);
int ENGINE_OF(make_ferguson)(const decide_input *in);
int ENGINE_OF(make_adini)(const decide_input *in);
int ENGINE_OF(make_bessel)(const decide_input *in);

/* engine_fill.c: of surfaces */
int ENGINE_OF(make_gregory)(const decide_input *in);
int ENGINE_OF(make_fill)(const decide_input *in);

#endif
