/* host-tools/plan/certify_compare.h -- how far a curve is from a path
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CERTIFY_COMPARE_H
#define LOFT_CERTIFY_COMPARE_H

#include "plan/certify_chords.h" /* certify_chords, certify_cubic */

typedef struct {
    const certify_chords *to;
    double tol, fine;
    double reach;               /* mm along the other path, in which the first search looks */
    double step;                /* by which the worst rises: `fine`, as it counts at corners */
    double share;               /* of what is compared */
    size_t near;                /* the chord that was the nearest */
    double worst, worst_share;  /* the worst so far, and the share that it has */
} certify_search;

/* Compare a curve. Returns whether some of it is farther by `step` than the worst so far; *t is its
 * parameter. */
bool certify_compare(certify_search *s, const certify_cubic *c, double *t);

/* Compare two points of a curve: if they are far, few parts set a new worst distance afterwards.
 * Then all of it is compared again. */
void certify_points(certify_search *s, const certify_cubic *c);
void certify_again(certify_search *s);

/* Chord k of the drawing, which counts as what is left of its curve. */
void certify_cubic_of_chord(certify_search *s, const certify_chords *c, size_t k,
                            certify_cubic *out);

/* The worst distance of a search. */
void certify_take(certify_worst *w, const certify_search *s);

#endif
