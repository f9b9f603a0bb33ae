/* host-tools/engine/print.h -- points on their way out, and a loop over the curves of a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PRINT_H
#define LOFT_PRINT_H

#include "engine/curve.h"
#include "engine/engine.h"         /* engine, ENGINE_AXES */

/* Print a point with just the digits that tell it from its neighbours in the number type of `e`;
 * without z if not solid. `context` is a print_options: it serves as engine_point_sink. */
typedef struct {
    const engine *e;
    bool solid;
} print_options;

void print_number(const engine *e, double x);
void print_point(void *context, const double point[ENGINE_AXES]);

/* The same without the end of the line. */
void print_words(const print_options *p, const double point[ENGINE_AXES]);

/* Open each curve in the number type of `e` and hand it to `one`, which gives a status. Prints the
 * start of each curve and an empty line before it, unless it begins where the curve before ended.
 * Gives an exit code after printing one line, in which the curve is followed by `words`. */
typedef int print_curve(void *context, const curve *c, engine_curve *held);
int print_chain(const print_options *p, const curves *all, const char *file, const char *words,
                print_curve *one, void *context);

#endif
