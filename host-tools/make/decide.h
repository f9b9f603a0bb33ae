/* host-tools/make/decide.h -- questions of the texts, answered by the library: exactly where it
 * decides
 * SPDX-License-Identifier: MIT
 *
 *     engine_decide.c     the answers; engine_make.c, engine_weave.c, engine_fill.c: curves and
 *                         surfaces made of others; compiled once per number type
 *     engine_parts.c      pieces of curves, frames, polynomials
 *     engine_simplex.c    lines, planes, triangles and tetrahedra
 *     engine_net.c        places, areas and volumes of surfaces with nets
 *     engine_thin.c       B-splines with fewer knots, or more
 *     engine_loops.c      where curves cross themselves
 *     engine_meet.c       where surfaces meet each other and curves
 *     engine_pieces.h     what all use
 *     decide.c            what the commands decide and make share
 */
#ifndef LOFT_HOST_DECIDE_H
#define LOFT_HOST_DECIDE_H

#include "base/tool.h"          /* option_list */
#include "engine/engine.h"      /* engine */

struct host;                /* base/host.h */

struct curves;
struct surfaces;

enum decide_takes {
    DECIDE_NUMBERS,
    DECIDE_CURVES,
    DECIDE_CONICS,              /* curves, also with weights of 0 and below */
    DECIDE_SURFACES,
    DECIDE_EITHER,
    DECIDE_SOLIDS,              /* curves, or surfaces with tetrahedra as what they are */
    DECIDE_BOTH
};

/* What a question is asked of: numbers, the curves or surfaces of a file, or those of two files. */
typedef struct {
    const engine *e;
    const option_list *of;
    const struct curves *curves;
    const struct surfaces *surfaces;
    char *why;                  /* room for DECIDE_WHY: what is wrong, and the remedy */
} decide_input;

typedef struct {
    const char *name;
    enum decide_takes takes;
    unsigned least, most;       /* numbers of --of */
    const char *numbers;        /* what they are */
    /* Prints the answer; enum loft_status. */
    int (*answer)(const decide_input *in);
} decide_question;

#define DECIDE_ANY       1024
#define DECIDE_WHY       160
#define DECIDE_QUESTIONS 31

extern const decide_question decide_q16[DECIDE_QUESTIONS], decide_f32[DECIDE_QUESTIONS],
    decide_f64[DECIDE_QUESTIONS];

#define MAKE_VERBS 26

extern const decide_question make_q16[MAKE_VERBS], make_f32[MAKE_VERBS], make_f64[MAKE_VERBS];

/* Print the answer of `loft decide` to a question about surfaces, or why there is none. Returns an
 * exit code. */
int decide_surfaces(struct host *h, const char *question, const engine *e, const option_list *of,
                    const struct surfaces *all, const char *file);

/* Run a command whose first word is a question of a table, one table per number type. */
typedef struct {
    option_list of;
    const engine *e;
    const char *question;
    option_words files;
} decide_options;
extern const option decide_rows[];
int decide_run(struct host *h, const char *name, const decide_question *const table[3],
               unsigned count, const decide_options *o);

#endif
