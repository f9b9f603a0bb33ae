/* host-tools/engine/engine_measure.c -- lengths, nearest points, crossings, joins and offsets
 * through the library; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include "curve/intersect.h"    /* loft_bezier_intersect */
#include "curve/join.h"         /* loft_join */
#include "curve/measure.h"      /* loft_cubic_arclen */
#include "curve/nearest.h"      /* loft_bezier_nearest */
#include "curve/offset.h"       /* loft_offset */

#include "engine/engine_num.h"     /* real_of, vec_of, point_of */
#include "engine/piece.h"

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_bezier b;
} part;

typedef struct {
    part a, b;
    loft_real within;
} two;

static double double_of_unit(loft_unit t) { return (double)t / (double)LOFT_UNIT(1.0); }

static int piece_in_type(const piece *p, part *out)
{
    for (unsigned k = 0; k <= p->degree; k++)
        if (!vec_of(p->p[k], &out->p[k]))
            return LOFT_ERR_RANGE;
    return loft_bezier_init(&out->b, out->p, p->degree);
}

static int pair_in_type(const piece *a, const piece *b, double tol, two *out)
{
    const int status = piece_in_type(a, &out->a);

    if (status != LOFT_OK)
        return status;
    return real_of(tol, &out->within) ? piece_in_type(b, &out->b) : LOFT_ERR_RANGE;
}

static bool cubic_of(const double p[4][ENGINE_AXES], loft_cubic *out)
{
    for (int k = 0; k < 4; k++)
        if (!vec_of(p[k], &out->p[k]))
            return false;
    return true;
}

static int measure_length(const double p[4][ENGINE_AXES], double tol, double *out)
{
    loft_cubic c;
    loft_real within;

    if (!cubic_of(p, &c) || !real_of(tol, &within))
        return LOFT_ERR_RANGE;
    *out = double_of_acc(loft_cubic_arclen(&c, within));
    return LOFT_OK;
}

static int measure_nearest(const piece *p, const double point[ENGINE_AXES], double tol,
                           engine_near *out)
{
    loft_nearest n;
    loft_real within;
    loft_vec at;
    part s;
    int status = piece_in_type(p, &s);

    if (status == LOFT_OK && (!vec_of(point, &at) || !real_of(tol, &within)))
        status = LOFT_ERR_RANGE;
    if (status == LOFT_OK)
        status = loft_bezier_nearest(&s.b, at, within, &n);
    if (status != LOFT_OK)
        return status;
    out->t = double_of_unit(n.t);
    out->distance = double_of_acc(n.distance);
    point_of(n.point, out->point);
    return LOFT_OK;
}

static void take_crossing(const loft_crossing *c, engine_meeting *out)
{
    const loft_unit s[3] = { c->s_from, c->s, c->s_to }, t[3] = { c->t_from, c->t, c->t_to };

    for (int i = 0; i < 3; i++) {
        out->s[i] = double_of_unit(s[i]);
        out->t[i] = double_of_unit(t[i]);
    }
    out->distance = double_of_acc(c->distance);
    out->overlap = c->overlap;
    point_of(c->point, out->point);
}

static int measure_meet(const piece *a, const piece *b, double tol,
                        engine_meeting out[ENGINE_MEETINGS], size_t *count)
{
    loft_crossing c[ENGINE_MEETINGS];
    two pair;
    int status = pair_in_type(a, b, tol, &pair);

    *count = 0;
    if (status == LOFT_OK)
        status = loft_bezier_intersect(&pair.a.b, &pair.b.b, pair.within, c, ENGINE_MEETINGS,
                                       count);
    for (size_t k = 0; status >= LOFT_OK && k < *count; k++)
        take_crossing(&c[k], &out[k]);
    return status == LOFT_SINGULAR ? LOFT_OK : status;
}

static int measure_join(const piece *a, const piece *b, double tol, engine_joint *out)
{
    loft_join j;
    two pair;
    int status = pair_in_type(a, b, tol, &pair);

    if (status == LOFT_OK)
        status = loft_join_init(&j, &pair.a.b, &pair.b.b, pair.within);
    if (status != LOFT_OK)
        return status;
    *out = (engine_joint){
        { j.c0, j.c1, j.c2 }, { j.g0, j.g1, j.g2 }, double_of(j.alpha), double_of(j.eta)
    };
    return LOFT_OK;
}

static int measure_offset(const double p[4][ENGINE_AXES], double distance, double tol,
                          engine_offset_sink *sink, void *context)
{
    loft_offset_span span;
    loft_real by, within;
    loft_offset o;
    loft_cubic c;

    if (!cubic_of(p, &c) || !real_of(tol, &within) || !real_of(distance, &by))
        return LOFT_ERR_RANGE;
    const int status = loft_offset_init(&o, &c, by, within);
    while (status == LOFT_OK && loft_offset_next(&o, &span)) {
        double points[4][ENGINE_AXES];
        for (int k = 0; k < 4; k++)
            point_of(span.curve.p[k], points[k]);
        sink(context, points, span.behind);
    }
    return status;
}

const engine_measures ENGINE_OF(engine_measures) = { .length = measure_length,
    .nearest = measure_nearest,
    .meet    = measure_meet,
    .join    = measure_join,
                                                     .offset = measure_offset };
