/* host-tools/engine/harmonic.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/harmonic_basis.h"
#include "base/least.h"          /* least_squares, least_room */

#define PLACES 6000         /* of a boundary sample, at most     */
#define TERMS  600          /* of a series                       */

/* What kind of series to try: powers at each corner (twice as many where it is more than half a
 * turn), the polynomial's
 * degree, and poles at steps of `step` times the narrowness; 0: no poles. */
typedef struct {
    unsigned powers, degree;
    long double step;
} recipe;

typedef struct {
    harmonic_shape shape;
    harmonic_target target;
    harmonic_place *place, *check;      /* to fit, to judge */
    size_t places, checks;
} problem;

/* A corner of a turn over a whole number has no singularity: the polynomial does it, unless the
 * corner is straight. */
static bool is_regular(long double power)
{
    return power > 1.5L && fabsl(power - roundl(power)) < 1e-13L;
}

static void place_poles(const harmonic_shape *h, long double step, harmonic_series *s)
{
    harmonic_place *place = least_room(PLACES * sizeof *place);
    const size_t count = harmonic_walk(h, step, 1, 3, place, PLACES);

    for (size_t k = 0; k < count && k < PLACES && s->poles < HARMONIC_POLES; k++) {
        const long double off = fminl(place[k].narrow,
                                      harmonic_clearance(h, &place[k], 4 * h->reach) / 2);
        const harmonic_point d = h->v[(place[k].edge + 1) % h->sides] - h->v[place[k].edge],
                             at = place[k].at - I * d / cabsl(d) * off;
        const long double size = harmonic_distance(h, at);
        bool apart = harmonic_outside(h, at) && size > 0.3L * place[k].narrow;
        for (unsigned i = 0; i < s->poles && apart; i++)
            apart = cabsl(at - (s->pole[i][0] + I * s->pole[i][1])) > 0.3L * size;
        if (!apart)
            continue;
        s->pole[s->poles][0] = (double)creall(
            at); /* in every number type the table holds what is solved with here */
        s->pole[s->poles][1] = (double)cimagl(at);
        s->pole[s->poles++][2] = (double)size;
    }
    free(place);
}

static void round_poles(harmonic_series *s, long double grain)
{
    for (unsigned i = 0; i < s->poles && grain > 0; i++)
        for (int k = 0; k < 3; k++)
            s->pole[i][k] = roundl(s->pole[i][k] / grain) * grain;
}

static void lay_out(const problem *p, recipe r, harmonic_series *s)
{
    const harmonic_shape *h = &p->shape;

    s->sides = h->sides;
    s->degree = r.degree;
    s->poles = s->straight = 0;
    s->terms = 1 + 2 * r.degree;
    for (unsigned i = 0; i < h->sides; i++) {
        const long double power = HARMONIC_PI / h->angle[i];
        s->straight |= (unsigned)(fabsl(power - 1) < 0.25L) << i;
        s->powers[i] = is_regular(power) ? 0 : power < 1 ? 2 * r.powers : r.powers;
        s->terms += s->powers[i];
    }
    if (r.step > 0)
        place_poles(h, r.step, s);
    round_poles(s, p->target.grain);
    s->terms += 2 * s->poles;
}

/* Coordinate i on an edge. */
static long double on_edge(const harmonic_shape *h, const harmonic_place *b, unsigned i)
{
    const long double t = b->along / cabsl(h->v[(b->edge + 1) % h->sides] - h->v[b->edge]);

    return i == b->edge ? 1 - t : i == (b->edge + 1) % h->sides ? t : 0;
}

static void fit(const problem *p, harmonic_series *s)
{
    const size_t rows = p->places, columns = s->terms, all = columns + s->sides;
    long double *a = least_room(rows * all * sizeof *a),
                *x = least_room(columns * s->sides * sizeof *x), term[TERMS];

    for (size_t r = 0; r < rows; r++) {
        harmonic_terms(&p->shape, s, p->place[r].at, (int)p->place[r].edge, term);
        for (size_t k = 0; k < columns; k++)
            a[k * rows + r] = term[k];
        for (unsigned i = 0; i < s->sides; i++)
            a[(columns + i) * rows + r] = on_edge(&p->shape, &p->place[r], i);
    }
    least_squares(a, rows, columns, s->sides, fmaxl(p->target.error / 1000, 1e-18L), x);

    s->coefficient = least_room(columns * s->sides * sizeof *s->coefficient);
    s->largest = s->weight = 0;
    for (unsigned i = 0; i < s->sides; i++) {
        long double sum = 0;
        for (size_t k = 0; k < columns; k++) {
            const long double c = x[i * columns + k], grain = p->target.grain;
            s->coefficient[k * s->sides + i] = grain > 0 ? roundl(c / grain) * grain
                                                         : (long double)(double)c;
            s->largest = fmaxl(s->largest, fabsl(c));
            sum += fabsl(c);
        }
        s->weight = fmaxl(s->weight, sum);
    }
    free(a);
    free(x);
}

static void judge(const problem *p, harmonic_series *s)
{
    long double most = 0, term[TERMS];

    for (size_t r = 0; r < p->checks; r++) {
        harmonic_terms(&p->shape, s, p->check[r].at, (int)p->check[r].edge, term);
        for (unsigned i = 0; i < s->sides; i++) {
            long double sum = -on_edge(&p->shape, &p->check[r], i);
            for (unsigned k = 0; k < s->terms; k++)
                sum += term[k] * s->coefficient[k * s->sides + i];
            most = fmaxl(most, fabsl(sum));
        }
    }
    s->bound = isnan(most) ? INFINITY : 2 * most;
    s->points = (unsigned)p->checks;
}

static const recipe recipes[] = {
    { 2, 2, 0 },    { 3, 3, 0 },    { 3, 9, 0 },     { 4, 4, 0 },      { 4, 12, 0 },
    { 6, 6, 0 },    { 6, 18, 0 },   { 8, 8, 0 },     { 8, 24, 0 },     { 11, 11, 0 },
    { 11, 33, 0 },  { 15, 15, 0 },  { 15, 45, 0 },   { 20, 20, 0 },    { 20, 60, 0 },
    { 20, 100, 0 }, { 6, 8, 1 },    { 8, 10, 0.7L }, { 10, 10, 0.5L }, { 10, 10, 0.35L },
    { 28, 28, 0 },  { 28, 120, 0 }, { 40, 40, 0 },   { 40, 80, 0 }
};

static void start(double v[][2], unsigned sides, harmonic_target target, problem *p)
{
    long double step = 0.2L;

    p->target = target;
    harmonic_shape_of(v, sides, &p->shape);
    while (harmonic_walk(&p->shape, step, 90, 18, NULL, 0) > PLACES / 3)
        step *= 1.2L;
    p->place = least_room(PLACES * sizeof *p->place);
    p->check = least_room(PLACES * sizeof *p->check);
    p->places = harmonic_walk(&p->shape, step, 90, 18, p->place, PLACES);
    p->checks = harmonic_walk(&p->shape, step / 2.7L, 241, 26, p->check, PLACES);
    p->checks = p->checks < PLACES ? p->checks : PLACES;
}

/* The series of a recipe, if it is better than what there is. Gives its bound. */
static long double attempt(const problem *p, recipe r, harmonic_series *best)
{
    const unsigned tried = best->tried + 1;
    harmonic_series s = *best;

    s.coefficient = NULL;
    lay_out(p, r, &s);
    if (s.terms > TERMS || s.terms * 2 > p->places)
        return 0;
    fit(p, &s);
    judge(p, &s);
    const long double bound = s.bound;
    if (bound < best->bound) {
        harmonic_free(best);
        *best = s;
    } else {
        harmonic_free(&s);
    }
    best->tried = tried;
    return bound;
}

/* A series that errs 1000 times as much as wanted is not about to become the one: the next one is
 * left out. */
bool harmonic_solve(double v[][2], unsigned sides, harmonic_target target, harmonic_series *out)
{
    problem p;

    memset(out, 0, sizeof *out);
    memcpy(out->v, v, sides * sizeof out->v[0]);
    out->bound = INFINITY;
    start(v, sides, target, &p);
    for (size_t i = 0; i < sizeof recipes / sizeof recipes[0] && out->bound > target.error; i++)
        if (attempt(&p, recipes[i], out) > 1e3L * target.error && !(recipes[i].step > 0))
            i++;
    free(p.place);
    free(p.check);
    return out->bound <= target.error;
}

void harmonic_at(const harmonic_series *s, const double at[2], long double phi[])
{
    harmonic_series copy = *s;
    harmonic_shape h;
    long double term[TERMS];

    harmonic_shape_of(copy.v, s->sides, &h);
    harmonic_terms(&h, s, (long double)at[0] + I * (long double)at[1], -1, term);
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
