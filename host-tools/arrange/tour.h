/* host-tools/arrange/tour.h -- the shortest way that visits strokes: which first, from which end
 * SPDX-License-Identifier: MIT
 *
 * A stroke is drawn from one end to the other, or, if it is closed, from any of its points around
 * to the same point. What counts is the distance between the end of one and the beginning of the
 * next.
 */
#ifndef LOFT_TOUR_H
#define LOFT_TOUR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct host;                /* base/host.h */

typedef struct {
    size_t first, count;        /* its points; an open stroke has two */
    bool closed;
} tour_stroke;

typedef struct {
    struct host *host;          /* is told how far it is: base/host.h */
    const double (*point)[2];   /* mm */
    const tour_stroke *stroke;
    size_t count;
    double from[2];             /* the way begins here */
    bool returns;               /* and ends here; otherwise at the last stroke */
    double effort;              /* seconds of an idle computer of 2022. Work is counted, not time:
                                 * the result is the same on every computer */
} tour_problem;

typedef struct {
    size_t stroke, point;       /* where it is entered: 0 .. count - 1 */
} tour_visit;

/* Fill out[count]. Returns the length of the way, without the strokes; it is at most that of the
 * given order, entered at points 0. The host can stop it: then the way is longer than it need
 * be, and the result below 0.
 *
 *   error   not the shortest way: tests/tools/test_tour.c has a lower bound
 *   see     Bentley, Fast algorithms for geometric traveling salesman problems, ORSA J. Comput. 4
 *           (1992): 2-opt and Or-opt with lists of neighbours and a queue; Johnson & McGeoch, in
 *           Aarts & Lenstra, Local Search in Combinatorial Optimization (1997): iterated, with the
 *           double bridge of short segments */
double tour_find(const tour_problem *t, tour_visit out[]);

/* The length of a way. */
double tour_length(const tour_problem *t, const tour_visit way[]);

#endif
