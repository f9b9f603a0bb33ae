/* lib/curve/drawing.h -- a drawing as a constant table in flash, read curve by curve
 * SPDX-License-Identifier: MIT
 *
 * `loft export icon.svg -o icon.h` writes the table; a curve takes 12 bytes, a line 4.
 *
 *     loft_drawing_walk walk;                         // and include icon.h
 *     loft_cubic curve;
 *     bool lifted;
 *     if (loft_drawing_begin(&walk, &icon) == LOFT_OK)
 *         while (loft_drawing_next(&walk, &curve, &lifted))
 *             ..                  // lifted: the pen goes up before this curve
 *
 * The words are, for each path: 0 and its first point, x and y; then runs: k > 0 and the three
 * further points of each of k cubics, or -k and the ends of k lines. A coordinate is a word divided
 * by 2^bits.
 */
#ifndef LOFT_CURVE_DRAWING_H
#define LOFT_CURVE_DRAWING_H

#include "curve/bezier.h"   /* loft_cubic */
#include "num/flash.h"      /* LOFT_FLASH */

LOFT_BEGIN_C

/* A table. */
typedef struct {
    const int16_t *words;       /* LOFT_FLASH */
    uint32_t count;             /* of words   */
    uint8_t bits;               /* behind the binary point, 0..16 */
} loft_drawing;

/* Where a reader is. Do not fill it yourself: call begin. */
typedef struct {
    loft_drawing of;
    uint32_t next;              /* word                            */
    uint16_t left;              /* pieces of this run              */
    bool lines;
    loft_vec at;
} loft_drawing_walk;

/* Stand before the first curve. The table must outlive the walk; nothing of it is copied.
 *
 *   range   LOFT_ERR_DATA for a table that is not as described above
 *   error   none
 *   cost    reads one word of each path and run
 */
enum loft_status loft_drawing_begin(loft_drawing_walk *w, const loft_drawing *d) LOFT_CHECKED;

/* The next curve, in x and y, further axes 0; a line is a cubic with even speed. *lifted says
 * whether it begins a path. Returns false, and leaves both alone, behind the last.
 *
 *   error   none; of the inner points of a line as loft_cubic_line
 *   cost    6 words; safe in an interrupt
 */
bool loft_drawing_next(loft_drawing_walk *w, loft_cubic *c, bool *lifted);

LOFT_END_C

#endif
