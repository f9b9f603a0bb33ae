/* host-tools/geometry/element.c
 * SPDX-License-Identifier: MIT
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"     /* LOFT_ERR_RANGE */

#include "geometry/element.h"
#include "base/host.h"
#include "base/memory.h"

#define FINE 0.01       /* of the tolerance, for cubics that replace a piece with weights */

int element_error(host *h, const element *x, const char *words)
{
    return host_error(h, EX_DATAERR, "curve.not-computed", (host_place){ x->file, x->of->line },
                      NULL, "%s of degree %u: %s", curve_name(x->of->kind), x->of->degree, words);
}


// The list
// --------

static void append_element(elements *list, const element *x)
{
    if ((list->count & (list->count - 1)) == 0)         /* room for a power of two */
        list->element = memory_grow(list->element,
                                    (list->count ? 2 * list->count : 1) * sizeof *list->element);
    element *at = &list->element[list->count++];
    *at = *x;
    for (int i = 0; i < CURVE_AXES; i++) {
        at->box[0][i] = at->box[1][i] = x->p.p[0][i];
        for (unsigned k = 1; k <= x->p.degree; k++) {
            at->box[0][i] = fmin(at->box[0][i], x->p.p[k][i]);
            at->box[1][i] = fmax(at->box[1][i], x->p.p[k][i]);
        }
    }
}

typedef struct {
    elements *list;
    element x;
} cutting;

static void add_cubic(void *context, double p[4][CURVE_AXES])
{
    cutting *c = context;

    c->x.p = (piece){ .w = { 1, 1, 1, 1 }, .degree = 3 };
    memcpy(c->x.p.p, p, 4 * sizeof p[0]);
    append_element(c->list, &c->x);
}

/* The spans of an arc have equal ranges. The pieces of other curves lie between two breaks. */
static void set_range(element *x, unsigned i, unsigned pieces)
{
    const bool arc = x->of->kind == CURVE_ARC;

    x->from = arc ? (double)i / pieces : curve_break(x->of, i);
    x->to   = arc ? (double)(i + 1) / pieces : curve_break(x->of, i + 1);
}

static int add_curve(host *h, elements *list, const engine *e, const curve *c, const char *file,
                     double tol)
{
    cutting cut = { list, { .file = file, .of = c, .number = list->curves++ } };
    engine_curve *held;
    int status = e->curve->open(c, &held);

    if (status != 0)
        return element_error(h, &cut.x, curve_status(c, status));
    const unsigned pieces = e->curve->pieces(held);
    for (unsigned i = 0; i < pieces && status == 0; i++) {
        piece *whole = &cut.x.whole;
        status = e->curve->piece(held, i, whole);
        if (status != 0)
            break;
        set_range(&cut.x, i, pieces);
        cut.x.exact = !piece_is_rational(whole);
        cut.x.p = *whole;
        const double share = fmax(FINE * tol, engine_finest(e, whole));
        if (cut.x.exact)
            append_element(list, &cut.x);
        else
            status = share <= tol / 2 ? e->piece->cubics(whole, share, add_cubic, &cut)
                                      : LOFT_ERR_RANGE;
    }
    e->curve->close(held);
    return status == 0 ? 0 : element_error(h, &cut.x, curve_status(c, status));
}

int elements_add(host *h, elements *list, const engine *e, const curves *all, const char *file,
                 double tol)
{
    int code = 0;

    list->solid |= all->solid;
    for (size_t i = 0; i < all->count && code == 0; i++)
        code = add_curve(h, list, e, &all->curve[i], file, tol);
    return code;
}

void elements_free(elements *list)
{
    free(list->element);
    *list = (elements){ 0 };
}


// Parameters
// ----------

static double distance_to(const piece *p, double t, const double point[CURVE_AXES])
{
    double at[3][CURVE_AXES];

    piece_eval(p, t, at);
    return hypot(hypot(at[0][0] - point[0], at[0][1] - point[1]), at[0][2] - point[2]);
}

/* For a piece with weights: take the best of 64 places, then search 60 times around it in a range
 * that shrinks by a third. */
double element_parameter(const element *x, double t, const double point[CURVE_AXES])
{
    double best = 0, least = DBL_MAX;

    if (x->exact)
        return x->from + (x->to - x->from) * t;
    for (int j = 0; j <= 64; j++) {
        const double d = distance_to(&x->whole, j / 64.0, point);
        if (d < least) {
            least = d;
            best = j / 64.0;
        }
    }
    double low = fmax(best - 1 / 64.0, 0), high = fmin(best + 1 / 64.0, 1);
    for (int j = 0; j < 60; j++) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (distance_to(&x->whole, a, point) < distance_to(&x->whole, b, point))
            high = b;
        else
            low = a;
    }
    best = (low + high) / 2;
    for (int end = 0; end < 2; end++)
        if (distance_to(&x->whole, end, point) <= distance_to(&x->whole, best, point))
            best = end;
    return x->from + (x->to - x->from) * best;
}


// The foot of a perpendicular
// ---------------------------

/* The search for a foot: on the curve by its definition, between two parameters. */
typedef struct {
    const reference *r;
    const double *from;
    long double low, high, width;
} footing;

static long double squared_distance(const footing *f, long double t)
{
    long double at[CURVE_AXES], sum = 0;

    reference_eval(f->r, t, at);
    for (int i = 0; i < CURVE_AXES; i++)
        sum += (at[i] - f->from[i]) * (at[i] - f->from[i]);
    return sum;
}

/* The slope of the squared distance at t. */
static long double distance_slope(const footing *f, long double t)
{
    const long double h = f->width * 0x1p-26L;

    return squared_distance(f, fminl(t + h, f->high)) - squared_distance(f, fmaxl(t - h, f->low));
}

/* Go downhill by steps that double until the slope turns, then halve. The foot is where it turns,
 * or an end. */
static long double foot_of(const footing *f, long double t)
{
    const int way = distance_slope(f, t) < 0 ? 1 : -1;
    long double behind = t, ahead = t;

    for (long double step = f->width * 0x1p-30L; step < 2 * (f->high - f->low); step *= 2) {
        ahead = fminl(fmaxl(t + way * step, f->low), f->high);
        if (way * distance_slope(f, ahead) >= 0)
            break;
        behind = ahead;
    }
    for (int j = 0; j < 64; j++) {
        const long double middle = (behind + ahead) / 2;
        if (way * distance_slope(f, middle) >= 0)
            ahead = middle;
        else
            behind = middle;
    }
    return ahead;
}

void element_settle(const element *x, const reference *r, const double range[2],
                    const double from[CURVE_AXES], engine_near *n)
{
    const footing f = { r, from, range[0], range[1], x->to - x->from };
    const long double start = fminl(fmaxl(element_parameter(x, n->t, n->point), f.low), f.high),
                      foot = foot_of(&f, start);
    long double at[CURVE_AXES];

    n->t = (double)(squared_distance(&f, foot) <= squared_distance(&f, start) ? foot : start);
    reference_eval(r, n->t, at);
    for (int i = 0; i < CURVE_AXES; i++)
        n->point[i] = (double)at[i];
    n->distance = (double)sqrtl(squared_distance(&f, n->t));
}
