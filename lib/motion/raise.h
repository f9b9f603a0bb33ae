/* lib/motion/raise.h -- raise: the speed of a row of cells grows, bump by bump, as far as all
 * limits allow
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_RAISE_H
#define LOFT_MOTION_RAISE_H

#include "motion/course.h"  /* loft_course */

LOFT_BEGIN_C

/* the square of the speed from which it is raised: 1/64 mm/s */
#define LOFT_RAISE_CREEP (loft_to_acc(LOFT_REAL(1)) / 4096)

/* Pieces first..end - 1 of a course from one rest to the next, or to the end of what is known. */
typedef struct {
    unsigned first, end;
    unsigned from, to;          /* those that may change: from..to - 1 */
    bool     starts, rests;     /* at rest where it begins, ends       */
} loft_row;

/* Set what is known at the start of the last piece of a row, with the control value of creeping. */
void loft_raise_append(const loft_course *c, const loft_row *row);

/* A row that has at least three pieces comes to rest at its end. */
void loft_raise_close(const loft_course *c, const loft_row *row);

/* Raise the speed.
 *
 *   cost    some 20 loft_cell_limit per piece and sweep
 */
void loft_raise(const loft_course *c, const loft_row *row, int sweeps);

LOFT_END_C

#endif
