/* host-tools/study/engine_patch.h -- verbs of `loft make` and questions of `loft decide` about
 * patches
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_PATCH_H
#define LOFT_HOST_ENGINE_PATCH_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "study/decide.h"

/* engine_patch.c: of tensor patches and triangles without weights */
int ENGINE_OF(make_raise_patch)(const decide_input *in);
int ENGINE_OF(make_split_patch)(const decide_input *in);
int ENGINE_OF(make_quarter)(const decide_input *in);
int ENGINE_OF(make_continue)(const decide_input *in);
int ENGINE_OF(answer_join)(const decide_input *in);

#endif
