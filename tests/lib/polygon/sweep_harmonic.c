/* tests/lib/polygon/sweep_harmonic.c -- harmonic coordinates of LOFT_CASES random polygons that
 * loft_domain_init takes, with corners of 1 degree and more: each is solved within 1e-6; and of a
 * 25th as many fat ones, within 1e-12 in f64
 * SPDX-License-Identifier: MIT
 *
 *     sweep_harmonic [FIRST]    prints a line for each polygon that misses, then one for each kind
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/harmonic_solver.h" /* harmonic_solve */
#include "polygon/domain.h"  /* loft_domain_init */

#define LEAST_CORNER 1 /* degrees */
#define TURN         6.283185307179586

typedef struct {
    double v[LOFT_SIDES_MAX][2];
    unsigned n;
} outline;

static uint64_t state;

static double any(void)
{
    uint64_t z = state += 0x9E3779B97F4A7C15u;

    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* As likely in each octave. */
static double scale(double least, double most) { return least * pow(most / least, any()); }

static unsigned below(unsigned count) { return (unsigned)(any() * count); }

static void put(outline *p, double x, double y)
{
    p->v[p->n][0] = x;
    p->v[p->n++][1] = y;
}

static double side(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Turn the part between two edges that cross round, until none do. */
static void uncross(outline *p)
{
    for (unsigned left = 100, i = 0; left > 0 && i + 2 < p->n; i++)
        for (unsigned k = i + 2; left > 0 && k < p->n; k++) {
            double *a = p->v[i], *b = p->v[i + 1], *c = p->v[k], *d = p->v[(k + 1) % p->n];
            if (side(a, b, c) * side(a, b, d) >= 0 || side(c, d, a) * side(c, d, b) >= 0)
                continue;
            for (unsigned from = i + 1, to = k; from < to; from++, to--)
                for (int m = 0; m < 2; m++) {
                    const double kept = p->v[from][m];
                    p->v[from][m] = p->v[to][m];
                    p->v[to][m] = kept;
                }
            left--;
            i = 0;
            k = 1;
        }
}


// Kinds
// -----

static void star(outline *p, double least)
{
    const unsigned n = 3 + below(6);
    double angle[LOFT_SIDES_MAX];

    for (unsigned i = 0; i < n; i++) {
        const double next = TURN * any();
        unsigned k = i;
        for (; k > 0 && angle[k - 1] > next; k--)
            angle[k] = angle[k - 1];
        angle[k] = next;
    }
    for (unsigned i = 0; i < n; i++) {
        const double r = scale(least, 1);
        put(p, r * cos(angle[i]), r * sin(angle[i]));
    }
}

/* On even spokes, the shortest half as long as the longest. */
static void rounded(outline *p)
{
    const unsigned n = 3 + below(6);

    for (unsigned i = 0; i < n; i++) {
        const double r = 0.5 + 0.5 * any(), angle = TURN * i / n;
        put(p, r * cos(angle), r * sin(angle));
    }
}

static void fat(outline *p) { star(p, 0.3); }
static void spiky(outline *p) { star(p, 1e-3); }

static void tangle(outline *p)
{
    for (unsigned n = 3 + below(6); n > 0; n--)
        put(p, 2 * any() - 1, 2 * any() - 1);
    uncross(p);
}

static void strip(outline *p)
{
    const double narrow = scale(1e-3, 1);

    tangle(p);
    for (unsigned i = 0; i < p->n; i++)
        p->v[i][1] *= narrow;
}

static void blades(outline *p)
{
    for (unsigned n = 4 + below(5); n > 0; n--) {
        const double high = scale(0.003, 0.03);
        put(p, any(), high * (2 * any() - 1));
    }
    uncross(p);
}

static void spiral(outline *p)
{
    const double wide = scale(1e-3, 0.3), gap = scale(1e-3, 0.3);
    const outline corners = { { { 0, 0 },
                                { 4, 0 },
                                { 4, 4 },
                                { gap, 4 },
                                { gap, 2 },
                                { gap + 3 - wide, 2 + wide },
                                { gap + 3 - wide, wide },
                                { 0, wide } },
                              8 };

    *p = corners;
}

static void slit(outline *p)
{
    const double wide = scale(1e-3, 0.3);

    put(p, 0, 0);
    put(p, 1, 0);
    put(p, 1, 1);
    put(p, 0.5 + wide, 1);
    put(p, 0.5 + wide * any(), scale(1e-3, 0.5));
    put(p, 0.5 - wide * any(), scale(1e-3, 0.5));
    put(p, 0.5 - wide, 1);
    put(p, 0, 1);
}

static void comb(outline *p)
{
    const double wide = scale(1e-3, 0.3);

    put(p, 0, -scale(2e-3, 0.2));
    put(p, 1, -scale(2e-3, 0.2));
    put(p, 1, 1);
    put(p, 1 - wide, scale(1e-3, 0.9));
    put(p, 0.5 + scale(5e-4, 0.15), scale(1e-3, 0.9));
    put(p, 0.5, 1);
    put(p, wide, scale(1e-3, 0.9));
    put(p, 0, 1);
}

static void scales(outline *p)
{
    for (unsigned n = 3 + below(6); n > 0; n--) {
        const double r = scale(1e-4, 1), angle = TURN * any();
        put(p, r * cos(angle), r * sin(angle));
    }
    uncross(p);
}

static void zigzag(outline *p)
{
    const double wide = scale(1e-3, 0.3), back = 1.2 * any();

    put(p, 0, -wide / 2);
    put(p, 1, -wide / 2);
    put(p, 1 - back * any(), 0.5);
    put(p, 1 + any(), 0.5);
    put(p, 1 + 2 * any(), 0.5 + wide);
    put(p, 1 - 0.98 * back, 0.5 + wide);
    put(p, 1 - wide, wide / 2);
    put(p, 0, wide / 2);
}

/* A vertex next to an edge. */
static void near_touch(outline *p)
{
    tangle(p);
    const unsigned i = below(p->n), k = (i + 1 + below(p->n - 2)) % p->n;
    const double share = any(), left = scale(1e-4, 0.1);

    for (int m = 0; m < 2; m++) {
        const double foot = p->v[k][m] + share * (p->v[(k + 1) % p->n][m] - p->v[k][m]);
        p->v[i][m] = foot + left * (p->v[i][m] - foot);
    }
}

static const struct {
    const char *name;
    void (*make)(outline *p);
} kinds[] = { { "fat", fat },
              { "spiky", spiky },
              { "tangle", tangle },
              { "strip", strip },
              { "blades", blades },
              { "spiral", spiral },
              { "slit", slit },
              { "comb", comb },
              { "scales", scales },
              { "zigzag", zigzag },
              { "near touch", near_touch } };

#define KINDS (sizeof kinds / sizeof kinds[0])


// The sweep
// ---------

static double corner(const outline *p, unsigned i)
{
    const double *before = p->v[(i + p->n - 1) % p->n], *at = p->v[i],
                 *after = p->v[(i + 1) % p->n];
    const double angle = atan2(before[1] - at[1], before[0] - at[0]) -
                         atan2(after[1] - at[1], after[0] - at[0]);

    return (angle < 0 ? angle + TURN : angle) * 360 / TURN;
}

/* Turned and in millimetres, rounded to 2^-16; false when the library or a corner refuses it. */
static bool is_taken(outline *p)
{
    const double size = scale(3, 1000), angle = TURN * any();
    loft_spot v[LOFT_SIDES_MAX];
    loft_domain d;

    for (unsigned i = 0; i < p->n; i++) {
        const double x = size * p->v[i][0], y = size * p->v[i][1],
                     turned[2] = { x * cos(angle) - y * sin(angle),
                                   x * sin(angle) + y * cos(angle) };
        for (int m = 0; m < 2; m++) {
            v[i].at[m] = loft_real_from_raw((int32_t)lround(turned[m] * 65536));
            p->v[i][m] = (double)lround(turned[m] * 65536) / 65536;
        }
    }
    if (loft_domain_init(&d, v, p->n) != LOFT_OK)
        return false;
    for (unsigned i = 0; i < p->n; i++)
        if (corner(p, i) < LEAST_CORNER)
            return false;
    return true;
}

static void print_miss(const outline *p, unsigned long at, const char *kind, double error)
{
    printf("MISS %lu %s: error %.2g of", at, kind, error);
    for (unsigned i = 0; i < p->n; i++)
        printf(" %.9g,%.9g", p->v[i][0], p->v[i][1]);
    printf("\n");
    fflush(stdout);
}

typedef struct {
    double worst;
    unsigned long solved, terms, missed;
} tally;

/* Solve the polygon that a number makes; it may err by `most`. */
static void solve(const char *kind, void (*make)(outline *), unsigned long at,
                  harmonic_target target, double most, tally *t)
{
    harmonic_series s;
    outline p;

    state = at * 1000003u;
    do {
        memset(&p, 0, sizeof p);
        make(&p);
    } while (!is_taken(&p));
    harmonic_solve(p.v, p.n, target, &s);
    const double error = (double)(s.bound + s.weight * HARMONIC_ROUNDING);
    t->worst = fmax(t->worst, error);
    t->terms += s.terms;
    t->solved++;
    if (!(error <= most)) {
        print_miss(&p, at, kind, error);
        t->missed++;
    }
    harmonic_free(&s);
}

static void print_tally(const char *kind, const tally *t)
{
    if (t->solved > 0)
        printf("%-10s  %4lu polygons, %4lu terms in the mean, error at most %.2g\n", kind,
               t->solved, t->terms / t->solved, t->worst);
}

int main(int argc, char **argv)
{
    const unsigned long first = argc > 1 ? strtoul(argv[1], NULL, 10) : 0,
                        cases = getenv("LOFT_CASES") ? strtoul(getenv("LOFT_CASES"), NULL, 10)
                                                     : 1000;
    tally any_kind[KINDS] = { { 0 } }, in_f64 = { 0 };
    unsigned long missed = 0;

    for (unsigned long at = first; at < first + cases; at++)
        solve(kinds[at % KINDS].name, kinds[at % KINDS].make, at, HARMONIC_TARGET_Q16, 1e-6,
              &any_kind[at % KINDS]);
    for (unsigned long at = first; at < first + cases; at += 25)
        solve("round, f64", rounded, at, HARMONIC_TARGET_F64, 1e-12, &in_f64);
    for (size_t k = 0; k < KINDS; k++) {
        print_tally(kinds[k].name, &any_kind[k]);
        missed += any_kind[k].missed;
    }
    print_tally("round, f64", &in_f64);
    missed += in_f64.missed;
    printf("%lu of %lu miss\n", missed, cases + (cases + 24) / 25);
    return missed > 0;
}
