/* host-tools/plan/certify_chords.h -- the paths of a plan as chords
 * SPDX-License-Identifier: MIT
 */
#ifndef CERTIFY_CHORDS_H
#define CERTIFY_CHORDS_H

#include "base/space.h"         /* space_eval */
#include "plan/certify_plan.h"  /* certify_plan */

typedef struct {
    double p[4][ENGINE_AXES];
} certify_cubic;

static inline void certify_eval(const certify_cubic *c, double t, double out[ENGINE_AXES])
{
    space_eval(c->p, t, out);
}

/* A path as short chords; chord k leads from end[k] to end[k + 1]. */
typedef struct {
    double (*end)[ENGINE_AXES];
    double *s;                  /* length up to each end */
    double *share;              /* of the tolerance, of each chord */
    size_t *of;                 /* the curve that each chord belongs to */
    size_t chords, room;
} certify_chords;

/* Curve n of a path: a span of the motion, where the tool is, or a curve of the drawing. */
typedef void certify_source(const certify_plan *plan, size_t n, certify_cubic *out);
certify_source certify_cubic_of_span, certify_cubic_of_move;

/* How far a curve may be from its chord; of a part of it: times the square of its length. */
double certify_bulge(const certify_cubic *c);

/* The length of its control polygon: it is no longer. */
double certify_length(const certify_cubic *c);

/* Make chords of `count` curves, each within `fine` of its part; certify_chords_free releases them.
 */
void certify_chords_make(certify_chords *out, const certify_plan *plan, certify_source *source,
                         size_t count, double fine);
void certify_chords_free(certify_chords *c);

/* Add those of one curve, none of them longer than `longest`. Forget the first ones. */
void certify_chords_add(certify_chords *out, size_t of, const certify_cubic *c, double fine,
                        double longest);
void certify_chords_forget(certify_chords *c, size_t count);

/* Cut chord k at the length s. Returns false if that is not in it. */
bool certify_chords_cut(certify_chords *c, size_t k, double s);

/* Give each chord of the drawing its share: it ends where the tolerance of corners does. */
void certify_mark_corners(certify_chords *drawn, const certify_plan *plan);

#endif
