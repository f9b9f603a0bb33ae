/* host-tools/make/engine_pieces.h -- the pieces of a file's curves in the number type, and numbers
 * SPDX-License-Identifier: MIT
 *
 * For the files that are compiled once per number type and answer decide.h.
 */
#ifndef LOFT_HOST_ENGINE_PIECES_H
#define LOFT_HOST_ENGINE_PIECES_H

#include <stdio.h>

#include "curve/bezier.h"           /* loft_bezier */
#include "curve/rational.h"         /* loft_weighted */

#include "engine/curve.h"
#include "engine/engine_num.h"      /* real_of, vec_of */
#include "engine/piece.h"
#include "geometry/print.h"           /* print_point */
#include "make/decide.h"

#define MOST (LOFT_DEGREE_MAX + 1)

static inline double double_of_unit(loft_unit t) { return (double)t / (double)LOFT_UNIT(1); }

/* With all digits of the number type. */
static inline const char *text_of(double x) { return number_text(&ENGINE_OF(engine), x); }

/* What is wrong, and the remedy. */
static inline int decide_refuse(const decide_input *in, const char *why)
{
    snprintf(in->why, DECIDE_WHY, "%s", why);
    return LOFT_ERR_ARG;
}

static inline int numbers_of(const decide_input *in, loft_real out[], size_t most)
{
    if (in->of->count == 0 || in->of->count > most)
        return LOFT_ERR_ARG;
    for (size_t k = 0; k < in->of->count; k++)
        if (!real_of(in->of->value[k], &out[k]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* The one number of --of, a whole one from 1 to `most`. */
static inline bool times_of(const decide_input *in, unsigned most, unsigned *out)
{
    const double x = in->of->count == 1 ? in->of->value[0] : 0;

    *out = x >= 1 && x <= most ? (unsigned)x : 0;
    return *out > 0 && !(x > *out) && !(x < *out);
}

/* By how much a degree is raised, or why it cannot be. */
static inline bool raise_by(const decide_input *in, const char *what, size_t number,
                            unsigned degree, bool weighted, unsigned *times)
{
    const unsigned most = weighted ? LOFT_ELEVATE_MAX : LOFT_BEZIER_ELEVATE_MAX;
    const bool fits = times_of(in, most - degree, times);

    if (!fits)
        snprintf(in->why, DECIDE_WHY,
                 "%s %zu, of degree %u%s, goes to degree %u: give --of 1 to %u", what, number,
                 degree, weighted ? " with weights" : "", most, most - degree);
    return fits;
}

static inline void print_vec(const decide_input *in, loft_vec v)
{
    const print_options p = { in->e, in->curves == NULL || in->curves->solid };
    double point[ENGINE_AXES];

    point_of(v, point);
    print_point((void *)&p, point);
}

typedef struct {
    loft_vec p[MOST];
    loft_weighted w[MOST];
    loft_bezier b;
    bool rational;
} arc_piece;

typedef int arc_visit(void *context, const arc_piece *a, size_t number);

/* All pieces of one curve, in order. */
static inline int visit_curve(const decide_input *in, size_t c, arc_visit *visit, void *context,
                              size_t *number)
{
    const engine_curves *make = in->e->curve;
    engine_curve *held;
    int status = make->open(&in->curves->curve[c], &held);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < make->pieces(held) && status == LOFT_OK; i++) {
        arc_piece a;
        piece p;
        status = make->piece(held, i, &p);
        a.rational = status == LOFT_OK && piece_is_rational(&p);
        for (unsigned k = 0; status == LOFT_OK && k <= p.degree; k++) {
            if (!vec_of(p.p[k], &a.p[k]) || !real_of(p.w[k], &a.w[k].w))
                status = LOFT_ERR_RANGE;
            a.w[k].p = a.p[k];
        }
        if (status == LOFT_OK)
            status = loft_bezier_init(&a.b, a.p, p.degree);
        if (status == LOFT_OK)
            status = visit(context, &a, (*number)++);
    }
    make->close(held);
    return status;
}

/* All pieces of all curves, in order. */
static inline int visit_pieces(const decide_input *in, arc_visit *visit, void *context)
{
    int status = LOFT_OK;
    size_t number = 0;

    for (size_t c = 0; c < in->curves->count && status == LOFT_OK; c++)
        status = visit_curve(in, c, visit, context, &number);
    return status;
}

static inline void write_points(const decide_input *in, const loft_vec p[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        print_vec(in, p[k]);
}

/* Points of a surface: with z. */
static inline void write_solid(const decide_input *in, const loft_vec p[], unsigned count)
{
    decide_input solid = *in;

    solid.curves = NULL;
    write_points(&solid, p, count);
}

static inline void write_tensor(const decide_input *in, unsigned m, unsigned n,
                                const loft_vec net[])
{
    printf("tensor %u %u\n", m, n);
    write_solid(in, net, (m + 1) * (n + 1));
}

#define HELD 64

typedef struct {
    arc_piece piece[HELD];
    size_t count;
} piece_list;

static inline int hold_piece(void *context, const arc_piece *a, size_t number)
{
    piece_list *all = context;

    (void)number;
    if (all->count == HELD)
        return LOFT_ERR_SPACE;
    all->piece[all->count] = *a;
    all->piece[all->count].b.p = all->piece[all->count].p;
    all->count++;
    return LOFT_OK;
}

#endif
