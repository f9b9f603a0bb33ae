/* tests/bench/bench_order.c -- the travel of drawings beside that of the best known order
 * SPDX-License-Identifier: MIT
 *
 *     bench_order SECONDS KNOWN FILE..
 *
 * The order of SECONDS of work is compared with a lower bound. Where it is longer than 1.05 times
 * that, it is compared with the best known order: the shorter one of it and of the order of KNOWN
 * seconds of work.
 * A bound is that of the strokes as they are entered: closed ones begin where the order has them
 * begin. The exit code is 1 if a way is longer than 1.05 times the best known one.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"
#include "cmd/terminal.h"
#include "arrange/order.h"
#include "tools/tour_bound.h"
#include "readers.h"

#define MOST   1.05
#define JOIN   0.005            /* mm: the default of --join */
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

typedef struct {
    size_t count;
    double file, travel, bound;     /* mm */
} row;

/* Order a drawing by so many seconds of work. Returns false if it cannot be read. */
static bool order_drawing(const char *name, double seconds, row *out)
{
    const order_options best = { .how = "best", .effort = seconds, .join = JOIN };
    const double zero[2]     = { 0, 0 };
    drawing d                = { .count = 0 };
    double(*end)[2];

    bool good = drawing_read(tool_host(), &d, name) == 0;
    if (good) {
        (void)ends_of(&d, &end, &out->file);
        free(end);
        good = order_apply(tool_host(), &best, &d, zero, false, name) == 0;
    }
    if (good) {
        out->count = ends_of(&d, &end, &out->travel);
        out->bound = tour_bound((const double (*)[2])end, out->count, zero, out->travel, ROUNDS);
        free(end);
    }
    drawing_free(&d);
    return good;
}

int main(int argc, char **argv)
{
    double worst    = 1;
    terminal screen = { .doing = NULL };
    host h          = terminal_host(&screen);

    tool_use(&h);
    if (argc < 4) {
        fprintf(stderr, "usage: %s SECONDS KNOWN FILE..\n", argv[0]);
        return 64;
    }
    printf("%-36s %8s %9s %9s %9s %8s %9s %8s\n", "drawing", "strokes", "file mm", "found", "bound",
           "ratio", "known", "ratio");
    for (int i = 3; i < argc; i++) {
        const char *name = strrchr(argv[i], '/') ? strrchr(argv[i], '/') + 1 : argv[i];
        row found, known;
        if (!order_drawing(argv[i], atof(argv[1]), &found))
            continue;
        double ratio = found.travel / found.bound;
        printf("%-36.36s %8zu %9.1f %9.1f %9.1f %8.3f", name, found.count, found.file, found.travel,
               found.bound, ratio);
        fflush(stdout);
        if (ratio > MOST && order_drawing(argv[i], atof(argv[2]), &known)) {
            known.travel = fmin(known.travel, found.travel);
            ratio        = found.travel / known.travel;
            printf(" %9.1f %8.3f", known.travel, ratio);
        }
        puts("");
        fflush(stdout);
        worst = fmax(worst, ratio);
    }
    printf("at most %.3f times the bound or the best known way\n", worst);
    return worst > MOST;
}
