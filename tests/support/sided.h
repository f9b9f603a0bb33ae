/* tests/support/sided.h -- arbitrary patches with n sides of every kind, as surfaces around their
 * middle
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_SIDED_H
#define LOFT_TESTS_SIDED_H

#include <string.h>

#include "check.h"                  /* CHECK, BY_NUM */
#include "support/exact.h"          /* exact_of */
#include "polygon/meanvalue.h"      /* loft_meanvalue_eval */
#include "polygon/disk.h"
#include "polygon/wachspress.h"     /* loft_wachspress_eval */

#define KINDS  7
#define POINTS 500

/* A patch of any kind. Its control points lie over the regular polygon of radius 50, like those of
 * a flat patch that equals the polygon; some are moved. All are higher the closer they are to the
 * middle. */
typedef struct {
    loft_vec p[POINTS];
    loft_real w[POINTS];
    loft_spot v[LOFT_SIDES_MAX];
    loft_domain domain;
    loft_lattice_polygon lattice;
    loft_spatch spatch;
    loft_toric toric;
    loft_basepoint basepoint;
    loft_zheng_ball ring;
    loft_gb gb;
    loft_disk round;
    unsigned kind, sides, degree, count;
} scene;

static inline void vertex_of(unsigned sides, unsigned i, long double radius, long double out[2])
{
    out[0] = radius * cosl(2 * acosl(-1) * (long double)(i % sides) / sides);
    out[1] = radius * sinl(2 * acosl(-1) * (long double)(i % sides) / sides);
}

static inline void put(scene *x, arb *a, unsigned k, const long double at[2], long double wild)
{
    const long double r2 = (at[0] * at[0] + at[1] * at[1]) / 2500;
    const long double p[3] = { at[0], at[1], 30 * (1 - r2) };

    for (int i = 0; i < LOFT_AXES; i++)
        x->p[k].axis[i] = LOFT_REAL(
            (double)(i < 3 ? p[i] + wild * (arb_below(a, 2001) / 1000.0L - 1) : 0));
    x->w[k] = LOFT_REAL(1);
}

static inline void over_multi(scene *x, arb *a, unsigned sides, long double wild)
{
    uint8_t l[LOFT_SIDES_MAX];
    unsigned k = 0;

    loft_multiindex_first(l, sides, x->degree);
    do {
        long double at[2] = { 0, 0 }, v[2];
        for (unsigned i = 0; i < sides; i++) {
            vertex_of(sides, i, 50, v);
            at[0] += v[0] * l[i] / x->degree;
            at[1] += v[1] * l[i] / x->degree;
        }
        put(x, a, k++, at, wild);
    } while (loft_multiindex_next(l, sides));
}

/* Corner by corner in the order of zheng_ball.h and gb.h, then the middle. */
static inline void over_kites(scene *x, arb *a, long double wild)
{
    const unsigned d = x->degree;
    const long double middle[2] = { 0, 0 };
    unsigned k = 0;

    for (unsigned c = 0; c < x->sides; c++)
        for (unsigned i = 0; i < d / 2 + 1; i++)
            for (unsigned j = 0; j < (d + 1) / 2; j++) {
                const long double s = 2.0L * i / d, t = 2.0L * j / d;
                long double v[2], next[2], last[2];
                vertex_of(x->sides, c, 50, v);
                vertex_of(x->sides, c + 1, 50, next);
                vertex_of(x->sides, c + x->sides - 1, 50, last);
                for (int n = 0; n < 2; n++)
                    v[n] = (1 - s) * (1 - t) * v[n] + s * (1 - t) * (v[n] + next[n]) / 2 +
                           (1 - s) * t * (v[n] + last[n]) / 2;
                put(x, a, k++, v, wild);
            }
    put(x, a, k, middle, wild);
}

static inline void over_lattice(scene *x, arb *a, long double wild)
{
    static const loft_whole v[6] = { { { 0, 0 } }, { { 2, 0 } }, { { 4, 2 } },
                                     { { 4, 4 } }, { { 2, 4 } }, { { 0, 2 } } };
    unsigned k = 0;
    loft_whole l;

    CHECK(loft_lattice_polygon_init(&x->lattice, v, 6) == LOFT_OK);
    loft_lattice_polygon_first(&x->lattice, &l);
    do {
        const long double at[2] = { 20.0L * (l.at[0] - 2), 20.0L * (l.at[1] - 2) };
        put(x, a, k++, at, wild);
    } while (loft_lattice_polygon_next(&x->lattice, &l));
}

/* Polygons of radius 10000 in q16, of radius 1 in floats. */
static inline void make_domain(scene *x)
{
    for (unsigned i = 0; i < x->sides; i++) {
        long double v[2];
        vertex_of(x->sides, i, BY_NUM(10000.0L, 1.0L, 1.0L), v);
        for (int k = 0; k < 2; k++)
            x->v[i].at[k] = LOFT_REAL((double)(roundl(v[k] * 1048576) / 1048576));
    }
    CHECK(loft_domain_init(&x->domain, x->v, x->sides) == LOFT_OK);
}

static inline void make_basepoint(scene *x, arb *a, long double wild)
{
    static const uint8_t cuts[4][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 2 }, { 2, 2, 1 } };
    x->degree = 5;
    over_multi(x, a, 3, wild);
    CHECK(loft_basepoint_init(&x->basepoint, x->p, x->w, 5, cuts[arb_below(a, 4)]) == LOFT_OK);
    loft_disk_from_basepoint(&x->round, &x->basepoint);
}

static inline scene *arb_kind(arb *a, unsigned kind, long double wild)
{
    static scene x;

    memset(x.p, 0, sizeof x.p);
    x.kind = kind;
    x.sides = 3 + arb_below(a, 6);
    x.degree = 3 + arb_below(a, 3);
    switch (kind) {
    case 0:
    case 1: /* spatch, Wachspress or mean value */
        x.degree = 1 + arb_below(a, 3);
        over_multi(&x, a, x.sides, wild);
        make_domain(&x);
        CHECK(loft_spatch_init(&x.spatch, x.p, NULL, x.sides, x.degree) == LOFT_OK);
        CHECK(loft_disk_from_spatch(&x.round, &x.spatch, &x.domain,
                                    kind ? loft_meanvalue_eval : loft_wachspress_eval) == LOFT_OK);
        break;
    case 2:
    case 3: /* gb */
        over_kites(&x, a, wild);
        make_domain(&x);
        CHECK(loft_gb_init(&x.gb, x.p, x.sides, x.degree) == LOFT_OK);
        CHECK(loft_disk_from_gb(&x.round, &x.gb, &x.domain,
                                kind == 3 ? loft_meanvalue_eval : loft_wachspress_eval) == LOFT_OK);
        break;
    case 4:
        over_lattice(&x, a, wild);
        CHECK(loft_toric_init(&x.toric, &x.lattice, x.p, NULL, NULL) == LOFT_OK);
        loft_disk_from_toric(&x.round, &x.toric);
        break;
    case 5: make_basepoint(&x, a, wild); break;
    default:
        x.sides = arb_below(a, 3);
        x.sides = x.sides == 0 ? 3 : 4 + x.sides;
        over_kites(&x, a, wild);
        CHECK(loft_zheng_ball_init(&x.ring, x.p, x.sides, x.degree) == LOFT_OK);
        loft_disk_from_zheng_ball(&x.round, &x.ring);
        break;
    }
    x.sides = x.round.sides;
    return &x;
}

static inline loft_vec point_at(const scene *x, loft_unit u, loft_unit v)
{
    const loft_surface s = loft_surface_from_disk(&x->round);
    loft_vec p;

    CHECK(s.over == LOFT_SURFACE_DISK);
    CHECK(s.eval(s.surface, u, v, &p) == LOFT_OK);
    return p;
}

static inline long double apart(const loft_vec *a, const loft_vec *b)
{
    long double most = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        most = fmaxl(most, fabsl(exact_of(a->axis[i]) - exact_of(b->axis[i])));
    return most;
}

#endif
