/* host-tools/make/engine_parts.h -- verbs of `loft make` and questions of `loft decide` about the
 * pieces of curves and about polynomials
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_PARTS_H
#define LOFT_HOST_ENGINE_PARTS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "make/engine_pieces.h"    /* arc_piece */

/* engine_make.c */
void ENGINE_OF(write_piece)(const decide_input *in, const arc_piece *a);
int ENGINE_OF(write_part)(const decide_input *in, const arc_piece *a, loft_unit from, loft_unit to);

/* engine_parts.c */
int ENGINE_OF(make_pieces)(const decide_input *in);
int ENGINE_OF(make_cut)(const decide_input *in);
int ENGINE_OF(make_join)(const decide_input *in);
int ENGINE_OF(make_lowest)(const decide_input *in);
int ENGINE_OF(answer_inflections)(const decide_input *in);
int ENGINE_OF(answer_loops)(const decide_input *in);
int ENGINE_OF(make_thin)(const decide_input *in);         /* engine_thin.c */
int ENGINE_OF(make_insert)(const decide_input *in);
int ENGINE_OF(answer_frame)(const decide_input *in);
int ENGINE_OF(answer_power)(const decide_input *in);
int ENGINE_OF(answer_integral)(const decide_input *in);
int ENGINE_OF(answer_smooth)(const decide_input *in);

#endif
