/* tests/bench/bench_order.c -- the travel of drawings: as in the file, in the best order, and a
 * lower bound
 * SPDX-License-Identifier: MIT
 *
 * The bound is that of the strokes as they are entered: closed ones begin where the best order has
 * them begin.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/order.h"
#include "tools/tour_bound.h"

#define ROUNDS 100              /* of the bound; each takes the square of the strokes */

/* Ends of paths; returns how many paths. */
static size_t ends_of(const drawing *d, double (**end)[2], double *travel)
{
    const double zero[2] = { 0, 0 };
    const double *at     = zero;
    size_t count         = 0;

    *end    = malloc((2 * d->count + 1) * sizeof **end);
    *travel = 0;
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        if (i == 0 || c->path != c[-1].path) {
            *travel += bound_apart(at, c->p[0]);
            memcpy((*end)[2 * count++], c->p[0], sizeof **end);
        }
        memcpy((*end)[2 * count - 1], c->p[3], sizeof **end);
        at = c->p[3];
    }
    return count;
}

int main(int argc, char **argv)
{
    const order_options best = { .how = "best",
                                 .effort = argc > 1 ? atof(argv[1]) : 2,
                                 .join = ORDER_JOIN };
    const double zero[2]     = { 0, 0 };

    printf("%-44s %8s %10s %10s %10s %7s\n", "drawing", "strokes", "file mm", "best mm", "bound mm",
           "ratio");
    for (int i = 2; i < argc; i++) {
        drawing d = { .count = 0 };
        double(*end)[2], file, found;
        if (drawing_read(&d, argv[i]) != 0)
            continue;
        (void)ends_of(&d, &end, &file);
        free(end);
        if (order_apply(&best, &d, zero, false, argv[i]) != 0)
            return 1;
        const size_t count = ends_of(&d, &end, &found);
        const double bound = tour_bound((const double (*)[2])end, count, zero, found, ROUNDS);
        const char *name   = strrchr(argv[i], '/') ? strrchr(argv[i], '/') + 1 : argv[i];
        printf("%-44.44s %8zu %10.1f %10.1f %10.1f %7.3f\n", name, count, file, found, bound,
               found / bound);
        fflush(stdout);
        free(end);
        drawing_free(&d);
    }
    return 0;
}
