/* host-tools/engine/harmonic_solver.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/harmonic_poles.h"
#include "base/least.h"         /* least_squares */
#include "base/memory.h"        /* memory_grow */

#define PLACES 5000 /* of a boundary sample, at most     */
#define TERMS  1900 /* of a series                       */

#define WIDE 1e-10L    /* what errs less is fitted in long double */
#define WIDE_TERMS 500 /* .. unless it has more terms             */

/* What kind of series to try: powers at each corner (twice as many where it is more than half a
 * turn), the polynomial's
 * degree, and poles at distances that grow by `ratio`; 0: no poles. */
typedef struct {
    unsigned powers, degree;
    long double ratio;
} recipe;

typedef struct {
    harmonic_shape shape;
    harmonic_target target;
    harmonic_place *place; /* to fit */
    size_t places;
    harmonic_planes planes; /* once a recipe has poles */
} problem;

/* A corner of a turn over a whole number has no singularity: the polynomial does it, unless the
 * corner is straight. */
static bool is_regular(long double power)
{
    return power > 1.5L && fabsl(power - roundl(power)) < 1e-13L;
}

static void round_poles(harmonic_series *s, long double grain)
{
    for (unsigned i = 0; i < s->pole_count && grain > 0; i++)
        for (int k = 0; k < 3; k++)
            s->pole[i][k] = roundl(s->pole[i][k] / grain) * grain;
}

/* The places to fit at: those near poles belong to a series. There are more than twice as many as
 * terms, if there is room, so that nothing grows between them. */
static void find_places(problem *p, const harmonic_series *s)
{
    const size_t wanted = s != NULL && s->pole_count > 0 ? 2 * s->terms + s->terms / 2 : 0;
    long double step = 0.12L;

    while (harmonic_walk(&p->shape, s, step, 30, NULL, 0) < wanted)
        step /= 1.2L;
    while (harmonic_walk(&p->shape, s, step, 30, NULL, 0) > PLACES)
        step *= 1.1L;
    p->places = harmonic_walk(&p->shape, s, step, 30, p->place, PLACES);
}

static void place_poles(problem *p, long double ratio, harmonic_series *s)
{
    if (p->planes.cut == NULL) {
        find_places(p, NULL);
        harmonic_planes_of(&p->shape, p->place, p->places, &p->planes);
    }
    harmonic_put_poles(&p->planes, ratio, s);
}

static void lay_out(problem *p, recipe r, harmonic_series *s)
{
    const harmonic_shape *h = &p->shape;

    s->sides = h->sides;
    s->degree = r.degree;
    s->poles = s->pole_count = s->straight = 0;
    memset(s->corner_poles, 0, sizeof s->corner_poles);
    s->terms = 1 + 2 * r.degree;
    for (unsigned i = 0; i < h->sides; i++) {
        const long double power = HARMONIC_PI / h->angle[i];
        s->straight |= (unsigned)(fabsl(power - 1) < 0.25L) << i;
        s->powers[i] = is_regular(power) ? 0 : power < 1 ? 2 * r.powers : r.powers;
        s->terms += s->powers[i];
    }
    if (r.ratio > 0)
        place_poles(p, r.ratio, s);
    round_poles(s, p->target.grain);
    s->terms += 2 * s->pole_count;
    find_places(p, s);
}

/* Coordinate i on an edge. */
static long double on_edge(const harmonic_shape *h, const harmonic_place *b, unsigned i)
{
    const long double t = b->along / cabsl(h->v[(b->edge + 1) % h->sides] - h->v[b->edge]);

    return i == b->edge ? 1 - t : i == (b->edge + 1) % h->sides ? t : 0;
}

/* The sizes of what is fitted. */
typedef struct {
    size_t rows, columns, all, height;
} extent;

static void put_row(const problem *p, const harmonic_series *s, const extent *e, size_t r,
                    long double row[])
{
    harmonic_terms(&p->shape, s, p->place[r].at, (int)p->place[r].edge, row);
    for (unsigned i = 0; i < s->sides; i++)
        row[e->columns + i] = on_edge(&p->shape, &p->place[r], i);
}

static void fit_wide(const problem *p, const harmonic_series *s, const extent *e, long double x[])
{
    long double *a = memory_grow(NULL, e->height * e->all * sizeof *a), row[TERMS + HARMONIC_SIDES];

    memset(a, 0, e->height * e->all * sizeof *a);
    for (size_t k = 0; k < e->columns; k++)
        a[k * e->height + e->rows + k] = p->target.damping;
    for (size_t r = 0; r < e->rows; r++) {
        put_row(p, s, e, r, row);
        for (size_t k = 0; k < e->all; k++)
            a[k * e->height + r] = row[k];
    }
    least_squares(a, e->height, e->columns, s->sides, 1e-18L, x);
    free(a);
}

static void fit_double(const problem *p, const harmonic_series *s, const extent *e, long double x[])
{
    const size_t found = e->columns * s->sides;
    double *a = memory_grow(NULL, e->height * e->all * sizeof *a),
           *y = memory_grow(NULL, found * sizeof *y);
    long double row[TERMS + HARMONIC_SIDES];

    memset(a, 0, e->height * e->all * sizeof *a);
    for (size_t r = 0; r < e->rows; r++) {
        put_row(p, s, e, r, row);
        for (size_t k = 0; k < e->all; k++)
            a[k * e->height + r] = (double)row[k];
    }
    least_damped(a, e->rows, e->columns, s->sides, (double)p->target.damping, y);
    for (size_t k = 0; k < found; k++)
        x[k] = y[k];
    free(a);
    free(y);
}

static void fit(const problem *p, harmonic_series *s)
{
    const extent e = { p->places, s->terms, s->terms + s->sides, p->places + s->terms };
    long double *x = memory_grow(NULL, e.columns * s->sides * sizeof *x);

    if (p->target.error > WIDE || e.columns > WIDE_TERMS)
        fit_double(p, s, &e, x);
    else
        fit_wide(p, s, &e, x);

    s->coefficient = memory_grow(NULL, e.columns * s->sides * sizeof *s->coefficient);
    s->largest = s->weight = 0;
    for (unsigned i = 0; i < s->sides; i++) {
        long double sum = 0;
        for (size_t k = 0; k < e.columns; k++) {
            const long double c = x[i * e.columns + k], grain = p->target.grain;
            s->coefficient[k * s->sides + i] = grain > 0 ? roundl(c / grain) * grain
                                                         : (long double)(double)c;
            s->largest = fmaxl(s->largest, fabsl(c));
            sum += fabsl(c);
        }
        s->weight = fmaxl(s->weight, sum);
    }
    free(x);
}

/* What the coordinates err by in all, on the boundary and by rounding in the library. */
static long double total_error(const harmonic_series *s)
{
    return s->bound + s->weight * HARMONIC_ROUNDING;
}

/* The largest error on the places of the fit, as the bound for now. */
static void sample_error(const problem *p, harmonic_series *s)
{
    long double most = 0, term[TERMS];

    for (size_t r = 0; r < p->places; r++) {
        harmonic_terms(&p->shape, s, p->place[r].at, (int)p->place[r].edge, term);
        for (unsigned i = 0; i < s->sides; i++) {
            long double sum = -on_edge(&p->shape, &p->place[r], i);
            for (unsigned k = 0; k < s->terms; k++)
                sum += term[k] * s->coefficient[k * s->sides + i];
            most = isnan(sum) ? INFINITY : fmaxl(most, fabsl(sum));
        }
    }
    s->bound = most;
}

#define FINE 20 /* powers: poles with so many are tried after all others */

static const recipe recipes[] = {
    { 2, 2, 0 },     { 3, 3, 0 },       { 3, 9, 0 },       { 4, 4, 0 },   { 4, 12, 0 },
    { 6, 6, 0 },     { 6, 18, 0 },      { 8, 8, 0 },       { 8, 24, 0 },  { 11, 11, 0 },
    { 11, 33, 0 }, { 15, 15, 0 },   { 15, 45, 0 },     { 6, 10, 3 },      { 6, 12, 2.4L },
    { 8, 14, 2 },  { 9, 14, 1.6L }, { 10, 16, 1.35L }, { 10, 16, 1.25L }, { 20, 20, 0 },
    { 20, 60, 0 }, { 15, 80, 0 },   { 20, 100, 0 },    { FINE, 40, 2.4L }
};

static void start(double v[][2], unsigned sides, harmonic_target target, problem *p)
{
    p->target = target;
    p->planes.cut = NULL;
    harmonic_shape_of(v, sides, &p->shape);
    p->place = memory_grow(NULL, PLACES * sizeof *p->place);
    find_places(p, NULL);
}

/* The series of a recipe, if it is better than what there is. Gives its bound. */
static long double attempt(problem *p, recipe r, harmonic_series *best)
{
    const unsigned tried = best->tried + 1;
    harmonic_series s = *best;

    s.coefficient = NULL;
    lay_out(p, r, &s);
    if (s.terms > TERMS || s.terms > p->places)
        return 0;
    fit(p, &s);
    sample_error(p, &s);
    if (total_error(&s) < total_error(best))
        s.bound = harmonic_bound(&p->shape, &s, s.bound);
    const long double bound = s.bound;
    if (total_error(&s) < total_error(best)) {
        harmonic_free(best);
        *best = s;
    } else {
        harmonic_free(&s);
    }
    best->tried = tried;
    return bound;
}

static bool is_reached(const harmonic_series *s, harmonic_target target)
{
    return s->bound <= target.error && s->weight * HARMONIC_ROUNDING <= target.rounding;
}

/* Powers alone that err less than this converge quickly: poles are tried at last only. */
#define NO_POLES 1e-9L

/* Whether the kind of series, with poles or without, is not the one for this polygon. Once poles
 * are best, it is too narrow for powers alone. */
static bool is_wrong_kind(const harmonic_series *best, recipe r)
{
    return r.ratio > 0 ? best->pole_count == 0 && best->bound < NO_POLES && r.powers < FINE
                       : best->pole_count > 0;
}

/* A series that errs 1000 times as much as wanted is far from the goal: the next one is left
 * out. */
bool harmonic_solve(double v[][2], unsigned sides, harmonic_target target, harmonic_series *out)
{
    problem p;

    memset(out, 0, sizeof *out);
    memcpy(out->v, v, sides * sizeof out->v[0]);
    out->bound = INFINITY;
    start(v, sides, target, &p);
    for (size_t i = 0; i < sizeof recipes / sizeof recipes[0] && !is_reached(out, target); i++)
        if (!is_wrong_kind(out, recipes[i]) && attempt(&p, recipes[i], out) > 1e3L * target.error &&
            !(recipes[i].ratio > 0))
            i++;
    free(p.place);
    harmonic_planes_free(&p.planes);
    return is_reached(out, target);
}

void harmonic_at(const harmonic_series *s, const double at[2], long double phi[])
{
    harmonic_series copy = *s;
    harmonic_shape h;
    long double term[TERMS];

    harmonic_shape_of(copy.v, s->sides, &h);
    const harmonic_point z = (long double)at[0] + I * (long double)at[1];
    harmonic_terms(&h, s, z, harmonic_edge_at(&h, z), term);
    for (unsigned i = 0; i < s->sides; i++) {
        phi[i] = 0;
        for (unsigned k = 0; k < s->terms; k++)
            phi[i] += term[k] * s->coefficient[k * s->sides + i];
    }
}

void harmonic_free(harmonic_series *s)
{
    free(s->coefficient);
    s->coefficient = NULL;
}
