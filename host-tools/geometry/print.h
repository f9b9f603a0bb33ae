/* host-tools/geometry/print.h -- prints points, and loops over the curves of a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PRINT_H
#define LOFT_PRINT_H

#include "engine/curve.h"
#include "engine/engine.h"         /* engine, ENGINE_AXES */

struct host;                /* base/host.h */

/* Print a point with as many digits as tell it from its neighbours in the number type of `e`, and
 * without z if not solid. `context` is a print_options, so this serves as an engine_point_sink. */
typedef struct {
    const engine *e;
    bool solid;
} print_options;

void print_number(const engine *e, double x);

/* A computed number as text, for up to 8 in one printf: 9 digits, and as many more as tell it from
 * its neighbours in the number type of `e`; a parameter has 24 bits behind its point. */
const char *number_text(const engine *e, double x);
const char *parameter_text(const engine *e, double x);

/* What a number is at most: 3 digits, rounded up. */
const char *bound_text(double x);
void print_point(void *context, const double point[ENGINE_AXES]);

/* Print knot k of `count`, in lines that begin with `head`. */
void print_knot(const engine *e, const char *head, double knot, size_t k, size_t count);

/* The same as print_point without a newline. */
void print_words(const print_options *p, const double point[ENGINE_AXES]);

/* Open each curve in the number type of `e` and pass it to `one`, which returns a status. Prints
 * the start of each curve, and an empty line before it unless it begins where the curve before
 * ends. Returns an exit code after printing one line, in which `words` follow the curve. */
typedef int print_curve(void *context, const curve *c, engine_curve *held);
int print_chain(struct host *h, const print_options *p, const curves *all, const char *file,
                const char *words, print_curve *one, void *context);

#endif
