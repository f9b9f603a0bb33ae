/* tests/vectors/vectors_measure.c -- readers of the systems that measure a curve
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors.h"    /* row, row_within */
#include "curve/measure.h"      /* loft_flatten */

#define SAMPLES 1024                /* of the curve, and PARTS of each chord */
#define PARTS   8

typedef struct {
    long double axis[LOFT_AXES];
} place;

typedef struct {
    long double c[LOFT_AXES][4];
    place sample[SAMPLES + 1];
} dense;

static place at(const dense *f, long double t)
{
    place p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = exact_eval(f->c[i], 3, t);
    return p;
}

static long double squared(place a, place b)
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (a.axis[i] - b.axis[i]) * (a.axis[i] - b.axis[i]);
    return sum;
}

static place between(place a, place b, long double t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.axis[i] += t * (b.axis[i] - a.axis[i]);
    return a;
}

static long double squared_to_chord(place p, place a, place b)
{
    long double along = 0, length = squared(a, b);
    for (int i = 0; i < LOFT_AXES; i++)
        along += (p.axis[i] - a.axis[i]) * (b.axis[i] - a.axis[i]);
    return squared(p, between(a, b, length > 0 ? fminl(fmaxl(along / length, 0), 1) : 0));
}

/* The least squared distance between two samples of the curve, by thirds. */
static long double refined(place p, const dense *f, unsigned from, unsigned to)
{
    long double low = (long double)from / SAMPLES, high = (long double)to / SAMPLES;
    for (int round = 0; round < 40; round++) {
        const long double third = (high - low) / 3;
        if (squared(p, at(f, low + third)) < squared(p, at(f, high - third)))
            high -= third;
        else
            low += third;
    }
    return squared(p, at(f, low));
}

/* Around every sample that is nearer than its neighbours. */
static long double squared_to_curve(place p, const dense *f)
{
    long double d[SAMPLES + 1], least = INFINITY;

    for (unsigned k = 0; k <= SAMPLES; k++)
        d[k] = squared(p, f->sample[k]);
    for (unsigned k = 0; k <= SAMPLES; k++) {
        const unsigned before = k ? k - 1 : 0, after = k < SAMPLES ? k + 1 : k;
        if (d[k] <= d[before] && d[k] <= d[after])
            least = fminl(least, fminl(d[k], refined(p, f, before, after)));
    }
    return least;
}

/* The farthest that a sample of the curve is from all chords, and a sample of a chord from the
 * curve. */
static long double apart(const dense *f, const place v[], unsigned chords)
{
    long double worst = 0;

    for (unsigned k = 0; k <= SAMPLES; k++) {
        long double least = INFINITY;
        for (unsigned j = 0; j < chords; j++)
            least = fminl(least, squared_to_chord(f->sample[k], v[j], v[j+1]));
        worst = fmaxl(worst, least);
    }
    for (unsigned j = 0; j < chords; j++)
        for (int k = 0; k <= PARTS; k++)
            worst = fmaxl(worst,
                          squared_to_curve(between(v[j], v[j + 1], (long double)k / PARTS), f));
    return sqrtl(worst);
}

static dense *dense_of(const loft_cubic *c)
{
    static dense f;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 4; k++)
            f.c[i][k] = exact_of(c->p[k].axis[i]);
    for (unsigned k = 0; k <= SAMPLES; k++)
        f.sample[k] = at(&f, (long double)k / SAMPLES);
    return &f;
}

static place place_of(loft_vec v)
{
    place p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = exact_of(v.axis[i]);
    return p;
}

/* Error: the distance between chords and curve. The vertices need not be those of halving, but
 * there must not be more of them. A tolerance finer than coordinates of the type can keep is to be
 * refused. */
static void flatten(row *r)
{
    static place v[LIST_MAX];
    loft_cubic c;
    loft_flatten f;
    loft_vec p;
    unsigned chords = 0;

    row_points(r, "P_q16", 4, row_count(r, "d", LOFT_AXES), c.p);
    const long double least = BY_NUM(2 * LSB, powl(2, -22) * r->largest, powl(2, -43) * r->largest);
    const loft_real tol = row_real(r, "tol_q16");
    const unsigned most = row_count(r, "nseg", LIST_MAX - 2);
    if (row_count(r, "depth", 64) > most)
        row_complain(r, "column depth: more than nseg");

    const enum loft_status status = loft_flatten_init(&f, &c, tol);
    r->beyond = exact_of(tol) < least;
    r->refused = status == LOFT_ERR_RANGE;
    if (r->refused)
        return;
    if (status != LOFT_OK) {
        row_complain(r, "refused with status %d", status);
        return;
    }
    for (v[0] = place_of(c.p[0]); chords <= most && loft_flatten_next(&f, &p); )
        v[++chords] = place_of(p);
    if (chords > most)
        row_complain(r, "more chords than %u", most);
    if (!loft_vec_equal(p, c.p[3]))
        row_complain(r, "the last point is not the last control point");
    row_within(r, "a chord", apart(dense_of(&c), v, chords) * 65536, exact_of(tol) * 65536);
}

const vector_system vectors_measure[] = {
    { "flatten", "d,P_q16,tol_q16,nseg,depth", flatten,
      "every chord within tol of the curve and the curve within tol of a chord, with rounding; no "
      "more chords than nseg" },
    { 0 }
};
