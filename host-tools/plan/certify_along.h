/* host-tools/plan/certify_along.h -- judges a plan while it is made, span after span
 * SPDX-License-Identifier: MIT
 *
 * The motion is compared with the path that is planned, both ways, as certify.h does. Only the
 * parts of both are kept that are still needed, so memory does not grow with the path.
 *
 *   for (each span, with the moves that are passed at its end)
 *       if (!certify_along_span(&w, &span, passed)) ... it may not be sent
 *   certify_along_end(&w)
 */
#ifndef LOFT_CERTIFY_ALONG_H
#define LOFT_CERTIFY_ALONG_H

#include "plan/bends.h"             /* bends */
#include "plan/certify.h"           /* certify */
#include "plan/certify_compare.h"   /* certify_search */

typedef struct {
    certify judged;             /* so far; times are from the begin */
    size_t sure;                /* spans beside which all of the path is met */
    /* ---- */
    engine_limits limits;
    engine_move_source *source;
    void *context;
    size_t count, next;         /* moves, and the one that is not among the chords yet */
    certify_chords drawn, moved;
    certify_search off, missed;
    bends bends;
    double near_corner;         /* the path is near a corner up to this length */
    size_t compared;            /* chords of the path before it are compared with the motion */
    struct certify_mark {       /* places on the motion, one behind the other */
        double s;
        size_t passed;          /* moves, there */
    } mark[2];
    size_t spans, passed;
    uint64_t ticks;
    int32_t last[ENGINE_AXES];  /* the end of the last span */
} certify_along;

/* Begin with a path of `count` moves. Limits, tolerance and corner are those of the plan.
 *
 *   error   distances are at most tol / 100 above the exact ones, and not below them */
void certify_along_begin(certify_along *w, const engine_limits *limits, engine_move_source *source,
                         void *context, size_t count);

/* Judge the next span, at whose end so many moves are passed; then the rest of the path. They
 * return false if something is beyond its bounds for certain. */
bool certify_along_span(certify_along *w, const engine_span *span, size_t passed);
bool certify_along_end(certify_along *w);
void certify_along_free(certify_along *w);

#endif
