/* host-tools/geometry/print.c -- points as text
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "geometry/print.h"
#include "base/host.h"

#define EACH_LINE 8     /* knots */
#define SAME 1e-6       /* mm; closer ends count as one point */

void print_number(const engine *e, double x)
{
    const double near = (e->fixed ? e->lsb : e->lsb * fabs(x)) / 4;
    char text[32];

    for (int digits = 5; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (fabs(strtod(text, NULL) - x) <= near)
            break;
    }
    fputs(text, stdout);
}

#define TEXT 32

static char *next_text(void)
{
    static char text[8][TEXT];
    static unsigned next;

    return text[next++ % 8];
}

static const char *text_within(double x, double near)
{
    char *const out = next_text();

    for (int digits = 9; digits <= 17; digits++) {
        snprintf(out, TEXT, "%.*g", digits, x);
        if (!(fabs(strtod(out, NULL) - x) > near))
            break;
    }
    return out;
}

const char *bound_text(double x)
{
    char *const out = next_text();

    snprintf(out, TEXT, "%.3g", x);
    if (strtod(out, NULL) < x)
        snprintf(out, TEXT, "%.3g", x + pow(10, floor(log10(x)) - 2) / 2);
    return out;
}

const char *number_text(const engine *e, double x)
{
    return text_within(x, (e->fixed ? e->lsb : e->lsb * fabs(x)) / 4);
}

const char *parameter_text(const engine *e, double x)
{
    return text_within(x, (e->fixed ? 0x1p-24 : e->lsb * fabs(x)) / 4);
}

void print_words(const print_options *p, const double point[ENGINE_AXES])
{
    for (int i = 0; i < (p->solid ? ENGINE_AXES : 2); i++) {
        if (i > 0)
            putchar(' ');
        print_number(p->e, point[i]);
    }
}

void print_point(void *context, const double point[ENGINE_AXES])
{
    print_words(context, point);
    putchar('\n');
}

void print_knot(const engine *e, const char *head, double knot, size_t k, size_t count)
{
    if (k % EACH_LINE == 0)
        fputs(head, stdout);
    putchar(' ');
    print_number(e, knot);
    if (k % EACH_LINE == EACH_LINE - 1 || k + 1 == count)
        putchar('\n');
}

static bool same(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    return fabs(a[0] - b[0]) <= SAME && fabs(a[1] - b[1]) <= SAME && fabs(a[2] - b[2]) <= SAME;
}

/* `end` is the end of the curve before, and becomes the end of this one; NULL: there was none. */
static int chain_one(const print_options *p, const curve *c, double end[ENGINE_AXES], bool first,
                     print_curve *one, void *context)
{
    const engine_curves *make = p->e->curve;
    double start[ENGINE_AXES];
    engine_curve *held;
    int status = make->open(c, &held);

    if (status != 0)
        return status;
    status = make->eval(held, curve_from(c), start);
    if (status == 0 && (first || !same(start, end))) {
        if (!first)
            putchar('\n');
        print_options how = *p;
        print_point(&how, start);
    }
    if (status == 0)
        status = one(context, c, held);
    if (status == 0)
        status = make->eval(held, curve_to(c), end);
    make->close(held);
    return status;
}

int print_chain(host *h, const print_options *p, const curves *all, const char *file,
                const char *words, print_curve *one, void *context)
{
    double end[ENGINE_AXES];

    for (size_t i = 0; i < all->count; i++) {
        const int status = chain_one(p, &all->curve[i], end, i == 0, one, context);
        if (status != 0)
            return host_error(h, EX_DATAERR, "curve.not-printed",
                              (host_place){ file, all->curve[i].line }, NULL,
                              "%s of degree %u%s: %s", curve_name(all->curve[i].kind),
                              all->curve[i].degree, words, curve_status(&all->curve[i], status));
    }
    return EX_OK;
}
